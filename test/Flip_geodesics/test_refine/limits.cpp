// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Limits, and the work that is done up to them.

#include "test_refine/checked_refinement.h"

#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>

#include <array>

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(a_limit_on_insertions_is_kept)
{
  Curve_setting s(needle_strip(6, 6, 100));
  FG::Refinement_options options;
  options.maximum_insertions = 10;
  const FG::Refinement_report report = FG::refine(s.triangulation, options);
  BOOST_CHECK(report.status == FG::Refinement_status::VERTEX_LIMIT);
  BOOST_CHECK_EQUAL(report.insertions + report.splits, 10u);
}

// One circumcenter may ask for two edges to be split.
BOOST_AUTO_TEST_CASE(no_limit_is_exceeded)
{
  for(std::size_t limit = 0; limit < 60; limit += stride) {
    Curve_setting s(needle_strip(3, 3, 20));
    FG::Refinement_options options;
    options.smallest_angle = 30;
    options.maximum_insertions = limit;
    const FG::Refinement_report report = FG::refine(s.triangulation, options);
    BOOST_CHECK_EQUAL(report.insertions + report.splits,
                      static_cast<std::size_t>(s.triangulation.number_of_vertices()) - s.mesh.number_of_vertices());
    BOOST_CHECK_LE(report.insertions + report.splits, limit);
  }
}

namespace {

// The signs by which points were placed.
std::size_t number_of_searches(const Curve_setting& s)
{
  const FG::Decision_statistics& statistics = s.triangulation.decision_statistics();
  return statistics.by_strip;
}

} // namespace

// On a thin cone all new points lie in a row, in each input face that they pass.
BOOST_AUTO_TEST_CASE(insertions_in_a_row_take_linear_work)
{
  std::vector<std::size_t> steps, flips;
  const std::vector<std::size_t> limits = stride > 1 ? std::vector<std::size_t>{100} // too few to be in proportion
                                                     : std::vector<std::size_t>{1000, 2000, 4000};
  for(const std::size_t limit : limits) {
    Curve_setting s(cone_disk(20, 3, 1e-4));
    FG::Refinement_options options;
    options.maximum_insertions = limit;
    const FG::Refinement_report report = FG::refine(s.triangulation, options);
    BOOST_CHECK(report.status == FG::Refinement_status::VERTEX_LIMIT);
    BOOST_CHECK_EQUAL(report.insertions, limit);
    steps.push_back(number_of_searches(s));
    flips.push_back(report.flips);
  }
  for(std::size_t i = 1; i < steps.size(); ++i) {
    BOOST_TEST_MESSAGE("steps " << steps[i - 1] << " " << steps[i] << ", flips " << flips[i]);
    BOOST_CHECK_LE(10 * steps[i], 22 * steps[i - 1]);
    BOOST_CHECK_LE(10 * flips[i], 22 * flips[i - 1]);
  }
}

namespace {

// Counts the steps about vertices.
struct Counting_triangulation
{
  using Triangulation = Curve_setting::Triangulation;

  static FG::Edge_index edge(Halfedge_index h) { return Triangulation::edge(h); }
  static Halfedge_index twin(Halfedge_index h) { return Triangulation::twin(h); }
  Halfedge_index next(Halfedge_index h) const { return triangulation.next(h); }
  FG::Index holds(FG::Edge_index e) const { return triangulation.holds(e); }
  FG::Index version(FG::Edge_index e) const { return triangulation.version(e); }
  bool is_border(Halfedge_index h) const { return triangulation.is_border(h); }
  double length(Halfedge_index h) const { return triangulation.length(h); }
  FG::Index number_of_halfedges() const { return triangulation.number_of_halfedges(); }
  Halfedge_index clockwise(Halfedge_index h) const
  {
    ++steps;
    return triangulation.clockwise(h);
  }
  Halfedge_index counterclockwise(Halfedge_index h) const
  {
    ++steps;
    return triangulation.counterclockwise(h);
  }

  const Triangulation& triangulation;
  mutable std::size_t steps = 0;
};

} // namespace

// A face is exempt by the angle of all faces about its apex, and there are as many of them as one likes.
BOOST_AUTO_TEST_CASE(sharp_vertices_of_high_degree_are_walked_around_once)
{
  const int n = 1000;
  for(const double angle : {0.5, 1.0, 1.1, 3.0}) { // below and above 60 degrees
    Curve_setting s(cone_disk(n, 1, angle));
    s.add_path(0_v, 1_v); // now the sector ends at an edge
    for(const bool has_curve : {true, false}) {
      if(!has_curve)
        s.network.clear();
      const Counting_triangulation counting = {s.triangulation};
      FG::internal::Sharp_sectors<Counting_triangulation> is_in_sharp_sector(counting);
      const Halfedge_index start = s.triangulation.outgoing(0_v);
      Halfedge_index h = start;
      do {
        BOOST_CHECK_EQUAL(is_in_sharp_sector(h), angle < std::acos(0.5));
        h = s.triangulation.clockwise(h);
      } while(h != start);
      if(angle < std::acos(0.5))
        BOOST_CHECK_LE(counting.steps, 4u * n);
    }
  }
}

namespace {

// Takes more vertices than are allowed: 800000, where nothing is checked.
Mesh_soup cone_out_of_reach() { return stride > 1 ? cone_disk(3, 3, 1e-5) : cone_disk(20, 3, 1e-6); }

} // namespace

BOOST_AUTO_TEST_CASE(bounds_out_of_reach_are_told_early)
{
  for(const double angle : {20.0, 25.0, 30.0})
    for(const std::size_t limit : {2000u / stride, 5000u / stride}) {
      if(stride > 1 && (angle < 30 || limit < 1000))
        continue;
      Curve_setting s(cone_out_of_reach());
      const double before = area(s.triangulation);
      FG::Refinement_options options;
      options.smallest_angle = angle;
      options.maximum_insertions = limit;
      const FG::Refinement_report report = FG::refine(s.triangulation, options);
      BOOST_CHECK(report.status == FG::Refinement_status::BOUNDS_NOT_REACHABLE);
      BOOST_CHECK_LT(report.insertions, 1500u);
      BOOST_CHECK_GT(report.given_up, 0u);
      BOOST_CHECK_LE(report.given_up, report.missed);
      BOOST_CHECK_EQUAL(report.refused, 0u);
      BOOST_CHECK(s.triangulation.is_valid(1e-7));
      BOOST_CHECK(FG::is_delaunay(s.triangulation));
      BOOST_CHECK_CLOSE_FRACTION(area(s.triangulation), before, 1e-6);
    }
  Curve_setting s(cone_disk(20, 3, stride > 1 ? 1e-2 : 1e-3));
  const FG::Refinement_report report = FG::refine(s.triangulation);
  BOOST_CHECK(report.status == FG::Refinement_status::BOUNDS_REACHED);
  BOOST_CHECK_EQUAL(report.given_up, 0u);
}

// What can be mended beside faces that cannot is mended.
BOOST_AUTO_TEST_CASE(faces_are_given_up_alone)
{
  const Mesh_soup thin = cone_out_of_reach(), fair = needle_strip(6, 6, 20);
  Mesh_soup both = fair;
  both.points.insert(both.points.end(), thin.points.begin(), thin.points.end());
  for(auto face : thin.triangles) {
    for(auto& v : face)
      v += static_cast<int>(fair.points.size());
    both.triangles.push_back(face);
  }
  Curve_setting s(both);
  FG::Refinement_options options;
  options.maximum_insertions = 5000 / stride;
  const FG::Refinement_report report = FG::refine(s.triangulation, options);
  BOOST_CHECK(report.status == FG::Refinement_status::BOUNDS_NOT_REACHABLE);
  BOOST_CHECK_LT(report.insertions + report.splits, options.maximum_insertions);
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(s.triangulation, std::back_inserter(faces));
  std::size_t bad = 0;
  for(const FG::Intrinsic_face& f : faces) {
    const FG::internal::Face_shape<Curve_setting::Triangulation> shape(s.triangulation, f.halfedges[0]);
    const FG::Surface_location at = s.triangulation.location(s.triangulation.tail(f.halfedges[0]));
    const Vertex_index corner = s.triangulation.input().tail(at.halfedge);
    const bool is_in_fair = corner.idx() < static_cast<FG::Index>(fair.points.size());
    bad += is_in_fair && shape.smallest_angle() < 24.9 * std::acos(-1.0) / 180 ? 1 : 0;
  }
  BOOST_CHECK_EQUAL(bad, 0u);
}

// Thin faces that are out of reach do not keep edges that are too long from being divided.
BOOST_AUTO_TEST_CASE(long_edges_are_divided_beside_faces_out_of_reach)
{
  Curve_setting s(disjoint_union(cone_disk(20, 3, 1e-6), scaled(flat_grid(1, 1, Diagonal_rule::RISING), 100)));
  FG::Refinement_options options;
  options.longest_edge = 10;
  options.maximum_insertions = 2000;
  FG::refine(s.triangulation, options);
  for(Halfedge_index h : descriptors<Halfedge_index>(s.triangulation.number_of_halfedges()))
    BOOST_TEST(s.triangulation.length(h) <= options.longest_edge);
}

// A / s^2, of the right triangle with sides 3, 4 and 5.
BOOST_AUTO_TEST_CASE(the_need_of_a_face_does_not_depend_on_its_first_side)
{
  std::array<double, 3> lengths = {{3, 4, 5}};
  do
    BOOST_TEST(FG::internal::Refinement_outlook::need(lengths, 0.6) == 6. / 9, boost::test_tools::tolerance(1e-15));
  while(std::next_permutation(lengths.begin(), lengths.end()));
}

// Of pieces of an edge the ends and distances are those of the whole edge.
BOOST_AUTO_TEST_CASE(points_of_a_segment_are_measured_from_its_ends)
{
  Curve_setting s(flat_grid(2, 2, Diagonal_rule::RISING));
  auto& t = s.triangulation;
  const FG::Halfedge_index h(0);
  const FG::Vertex_index tail = t.tail(h), head = t.head(h);
  const double length = t.length(h);
  FG::internal::Segment_points<Curve_setting::Triangulation> points(t);
  const auto half = points.point(h, length / 2);
  const FG::Vertex_index middle = t.split_edge(h, {FG::internal::as_input(h), {{0.5, 0.5, 0}}}, 0, [](const auto&) {});
  points.add(middle, half);
  for(const FG::Halfedge_index g : FG::internal::outgoing_halfedges(t, middle)) {
    if(t.head(g) != head && t.head(g) != tail)
      continue;
    const auto quarter = points.point(g, length / 8); // towards one of the ends
    BOOST_TEST(quarter.distances[0] == length * 5 / 8, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(quarter.distances[1] == length * 3 / 8, boost::test_tools::tolerance(1e-15));
    BOOST_TEST((quarter.ends[0] == (t.head(g) == head ? tail : head)));
    BOOST_TEST((quarter.ends[1] == t.head(g)));
  }
}
