// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Edges of curves and borders, which are not flipped.

#include "test_refine/checked_refinement.h"

using namespace Flip_geodesics_test;

// Faces with a sharp corner that is wide enough count as all others.
BOOST_AUTO_TEST_CASE(only_small_angles_are_exempt)
{
  Curve_setting s(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}, {{0, 1, 2}}}); // about 53 degrees at the top
  const FG::Refinement_report report = FG::refine(s.triangulation);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_EQUAL(report.exempt, 0u);
  BOOST_CHECK_CLOSE_FRACTION(report.smallest_free_angle, 2 * std::atan(0.5) * 180 / std::acos(-1.0), 1e-12);
}

// The circumcenter lies in the middle of the longest side, which is on the border: the vertex there stays, though it
// sees another side under more than 120 degrees.
BOOST_AUTO_TEST_CASE(a_point_that_hits_a_constrained_edge_stays)
{
  Curve_setting s(Mesh_soup{{{0, 0, 0}, {12, 0, 0}, {0, 5, 0}}, {{0, 1, 2}}});
  FG::Refinement_options options;
  options.smallest_angle = 0;
  options.longest_edge = 12.5;
  const FG::Refinement_report report = FG::refine(s.triangulation, options);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_EQUAL(report.insertions, 1u);
  BOOST_CHECK_EQUAL(s.triangulation.number_of_vertices(), 4);
  const FG::Surface_location at = s.triangulation.location(3_v);
  BOOST_CHECK(kind(at) == FG::Location_kind::EDGE && at.weights[0] == at.weights[1]);
}

// The center of a square sees its sides under right angles: they are not split.
BOOST_AUTO_TEST_CASE(sides_seen_under_right_angles_are_not_split)
{
  Curve_setting s(flat_grid(1, 1, Diagonal_rule::RISING));
  FG::Refinement_options options;
  options.longest_edge = 1.2;
  const FG::Refinement_report report = FG::refine(s.triangulation, options);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_EQUAL(report.splits, 0u);
  BOOST_CHECK_EQUAL(report.insertions, 1u);
}

// Segments that start at one vertex are split at equal distances from it, powers of two.
BOOST_AUTO_TEST_CASE(segments_are_split_on_rings_about_their_ends)
{
  Curve_setting s(Mesh_soup{{{0, 0, 0}, {3, 0, 0}, {3, 0.7, 0}}, {{0, 1, 2}}});
  FG::Refinement_options options;
  options.smallest_angle = 0;
  options.longest_edge = 0.4;
  BOOST_CHECK(FG::refine(s.triangulation, options).is_complete());
  int segments = 0;
  for(Halfedge_index h = s.triangulation.outgoing(0_v); h != FG::null_index; h = s.triangulation.clockwise(h))
    if(s.triangulation.is_border(h) || s.triangulation.is_border(s.triangulation.twin(h))) {
      const double exponent = std::log2(s.triangulation.length(h));
      BOOST_CHECK_SMALL(exponent - std::round(exponent), 1e-9);
      ++segments;
    }
  BOOST_CHECK_GT(segments, 0);
}

// Short segments on one straight line are no small angle, however far they are from its ends.
BOOST_AUTO_TEST_CASE(a_line_beside_the_border_makes_no_small_angles)
{
  const Mesh_soup soup = mapped(flat_grid(1, 2, Diagonal_rule::RISING), [](const Coordinates& p) {
    return Coordinates{p[0], p[1] == 1 ? 0.03 : p[1] / 2, 0};
  });
  Curve_setting s(soup);
  s.add({Vertex_index(grid_vertex(1, 0, 1)), Vertex_index(grid_vertex(1, 1, 1))}, false);
  const FG::Refinement_report report = FG::refine(s.network);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_EQUAL(report.exempt, 0u);
  BOOST_CHECK_GT(report.splits, 10u);
  BOOST_CHECK_GE(report.smallest_angle, 25);
}
