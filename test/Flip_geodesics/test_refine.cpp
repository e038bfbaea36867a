// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Delaunay refinement: bounds are reached, curves keep their place and length, the surface keeps its area and its
// topology, no two vertices are in one place, and the process ends where it cannot reach a bound.

#include "Curve_setting.h"
#include "descriptors.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#define BOOST_TEST_MODULE refine
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Halfedge_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using FG::internal::first_side;
using namespace Flip_geodesics_test;

namespace {

using Certified_traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
using Certified_setting = Basic_curve_setting<FG::Intrinsic_triangulation<Surface, Certified_traits>>;

template <class Triangulation>
double area(const Triangulation& triangulation)
{
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  double sum = 0;
  for(const FG::Intrinsic_face& f : faces) {
    const double a = f.lengths[0], b = f.lengths[1], c = f.lengths[2];
    sum += std::sqrt((std::max)((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c), 0.0)) / 4;
  }
  return sum;
}

// By the cosine theorem, in degrees.
template <class Triangulation>
double smallest_angle(const Triangulation& triangulation)
{
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(triangulation, std::back_inserter(faces));
  double largest_cosine = -1;
  for(const FG::Intrinsic_face& f : faces)
    for(int i = 0; i < 3; ++i) {
      const double a = f.lengths[i], b = f.lengths[(i + 1) % 3], c = f.lengths[(i + 2) % 3];
      largest_cosine = (std::max)(largest_cosine, (b * b + c * c - a * a) / (2 * b * c));
    }
  return std::acos((std::min)(largest_cosine, 1.0)) * 180 / std::acos(-1.0);
}

template <class Setting>
void check_refined(Setting& s, double area_before, const std::vector<double>& lengths)
{
  BOOST_CHECK(s.triangulation.is_valid());
  BOOST_CHECK(s.network.is_valid());
  BOOST_CHECK(FG::is_delaunay(s.triangulation));
  BOOST_CHECK_CLOSE_FRACTION(area(s.triangulation), area_before, 1e-9);
  for(std::size_t c = 0; c < lengths.size(); ++c)
    BOOST_CHECK_CLOSE_FRACTION(s.network.length(FG::Curve_index(static_cast<FG::Index>(c))), lengths[c], 1e-11);
  const int characteristic = static_cast<int>(s.mesh.number_of_vertices()) -
                             static_cast<int>(s.mesh.number_of_edges()) + static_cast<int>(s.mesh.number_of_faces());
  std::vector<FG::Intrinsic_face> faces;
  FG::intrinsic_faces(s.triangulation, std::back_inserter(faces));
  BOOST_CHECK_EQUAL(s.triangulation.number_of_vertices() - s.triangulation.number_of_edges() +
                        static_cast<int>(faces.size()),
                    characteristic);
  std::set<std::tuple<FG::Input_halfedge_index, double, double, double>> places;
  for(int v = static_cast<int>(s.mesh.number_of_vertices()); v < s.triangulation.number_of_vertices(); ++v) {
    const FG::Surface_location at = s.triangulation.location(Vertex_index(v));
    BOOST_CHECK(places.emplace(at.halfedge, at.weights[0], at.weights[1], at.weights[2]).second);
  }
}

template <class Setting>
std::vector<double> lengths_of_curves(const Setting& s)
{
  std::vector<double> lengths;
  for(FG::Curve_index c : descriptors<FG::Curve_index>(s.network.number_of_curves()))
    lengths.push_back(s.network.length(c));
  return lengths;
}

} // namespace

BOOST_AUTO_TEST_CASE(surfaces_without_curves_reach_the_bound)
{
  for(const Mesh_soup& soup : {shaken(torus(14, 5, 3, 1), 0.1, 3), bumpy_sphere(8, 0.3, 4), needle_strip(6, 6, 20),
                               box(20, 3, 1, 1), genus_3_plate(1)})
    for(const double angle : {20.0, 25.0}) {
      Curve_setting s(soup);
      const double before = area(s.triangulation);
      FG::Refinement_options options;
      options.smallest_angle = angle;
      const FG::Refinement_report report = FG::refine(s.triangulation, options);
      BOOST_CHECK(report.is_complete());
      BOOST_CHECK_EQUAL(report.refused, 0u);
      BOOST_CHECK_GE(report.smallest_free_angle, angle);
      BOOST_CHECK_SMALL(report.smallest_angle - smallest_angle(s.triangulation), 1e-6);
      check_refined(s, before, {});
    }
}

BOOST_AUTO_TEST_CASE(curves_are_split_and_stay)
{
  const int n = 10;
  Curve_setting s(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 3));
  s.add_path(Vertex_index(grid_vertex(n, 0, 1)), Vertex_index(grid_vertex(n, n, 3)));
  s.add_path(Vertex_index(grid_vertex(n, 1, 9)), Vertex_index(grid_vertex(n, 9, 4)));
  s.add_path(Vertex_index(grid_vertex(n, 1, 9)), Vertex_index(grid_vertex(n, 9, 4)));
  FG::order_overlapping_curves(s.network);
  s.pull();
  const double before = area(s.triangulation);
  const std::vector<double> lengths = lengths_of_curves(s);
  const FG::Refinement_report report = FG::refine(s.network);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_GT(report.splits, 0u);
  BOOST_CHECK_GE(report.smallest_free_angle, 25);
  check_refined(s, before, lengths);

  // The curves are the same lines on the mesh: no point of them has left its line, and the mesh with them is sound.
  FG::Curve_extractor<Curve_setting::Network> extractor(s.network);
  std::vector<Surface::Point> points;
  extractor.points(0_c, std::back_inserter(points));
  const Surface::Point a = points.front(), b = points.back();
  for(const Surface::Point& p : points)
    BOOST_CHECK_SMALL((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()), 1e-10);
  const auto cut = FG::cut_along_curves(s.network, s.mesh);
  BOOST_CHECK(cut.mesh().is_valid(false));
  BOOST_CHECK_GT(FG::common_subdivision(s.triangulation, s.mesh).mesh().number_of_faces(), s.mesh.number_of_faces());

  // They can be taken back, with all vertices.
  s.network.clear();
  s.triangulation.rollback();
  BOOST_CHECK_EQUAL(s.triangulation.number_of_vertices(), static_cast<int>(s.mesh.number_of_vertices()));
  BOOST_CHECK_CLOSE_FRACTION(area(s.triangulation), before, 1e-9);
}

BOOST_AUTO_TEST_CASE(small_angles_between_curves_end)
{
  const int n = 16;
  Curve_setting s(flat_grid(n, n, Diagonal_rule::RISING));
  for(int j : {0, 1, 2, 5}) // angles of a few degrees at one vertex
    s.add_path(Vertex_index(grid_vertex(n, 0, 0)), Vertex_index(grid_vertex(n, n, j)));
  FG::order_overlapping_curves(s.network);
  s.pull();
  const double before = area(s.triangulation);
  const std::vector<double> lengths = lengths_of_curves(s);
  const FG::Refinement_report report = FG::refine(s.network);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_GT(report.exempt, 0u);
  BOOST_CHECK_LT(report.smallest_angle, 5);
  BOOST_CHECK_GE(report.smallest_free_angle, 25);
  check_refined(s, before, lengths);
}

BOOST_AUTO_TEST_CASE(sharp_cones_end)
{
  Curve_setting s(cone(5, 3, 0.2, 5)); // far less than 60 degrees about the apex
  const double before = area(s.triangulation);
  const FG::Refinement_report report = FG::refine(s.triangulation);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_GT(report.exempt, 0u);
  check_refined(s, before, {});
}

// Numbers are too coarse for the points that would be needed.
BOOST_AUTO_TEST_CASE(faces_at_the_end_of_numbers_are_left)
{
  Mesh_soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}, {0.5 + 1e-11, 0.5, 0}};
  soup.triangles = {{0, 1, 5}, {0, 5, 4}, {1, 2, 5}, {2, 3, 4}, {2, 4, 5}, {3, 0, 4}};
  Curve_setting s(soup);
  const double before = area(s.triangulation);
  const FG::Refinement_report report = FG::refine(s.triangulation);
  BOOST_CHECK(report.status == FG::Refinement_status::BOUNDS_NOT_REACHABLE);
  BOOST_CHECK_GT(report.refused, 0u);
  BOOST_CHECK_GT(report.missed, 0u);
  BOOST_CHECK_LT(report.insertions + report.splits, 1000u);
  BOOST_CHECK(s.triangulation.is_valid(1e-6));
  BOOST_CHECK_CLOSE_FRACTION(area(s.triangulation), before, 1e-9);
}

namespace {

struct Flip_counter : FG::Default_shortening_visitor
{
  std::size_t* flips;

  template <class Triangulation>
  void on_flip(const Triangulation&, Halfedge_index)
  {
    ++*flips;
  }
};

} // namespace

// All flips are counted: those to Delaunay, and those after insertions.
BOOST_AUTO_TEST_CASE(flips_are_counted)
{
  Curve_setting s(needle_strip(6, 6, 20));
  std::size_t flips = 0;
  Flip_counter visitor;
  visitor.flips = &flips;
  const FG::Refinement_report report = FG::refine(s.triangulation, {}, visitor);
  BOOST_CHECK_GT(report.insertions, 0u);
  BOOST_CHECK_EQUAL(report.flips, flips);
}

BOOST_AUTO_TEST_CASE(bounds_that_make_no_sense_are_refused)
{
  Curve_setting s(single_triangle());
  FG::Refinement_options options;
  for(double angle : {-1.0, 30.5, 90.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.smallest_angle = angle;
    BOOST_CHECK_THROW(FG::refine(s.triangulation, options), FG::Invalid_parameter_error);
  }
  options.smallest_angle = 20;
  options.longest_edge = 0;
  BOOST_CHECK_THROW(FG::refine(s.triangulation, options), FG::Invalid_parameter_error);
}

// Faces with a sharp corner that is wide enough count as all others.
BOOST_AUTO_TEST_CASE(only_small_angles_are_exempt)
{
  Curve_setting s(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}, {{0, 1, 2}}}); // about 53 degrees at the top
  const FG::Refinement_report report = FG::refine(s.triangulation);
  BOOST_CHECK(report.is_complete());
  BOOST_CHECK_EQUAL(report.exempt, 0u);
  BOOST_CHECK_CLOSE_FRACTION(report.smallest_free_angle, 2 * std::atan(0.5) * 180 / std::acos(-1.0), 1e-12);
}

// The circumcentre lies in the middle of the longest side, which is on the border: the vertex there stays, though it
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

// The centre of a square sees its sides under right angles: they are not split.
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

BOOST_AUTO_TEST_CASE(edges_have_the_wanted_length)
{
  Curve_setting s(cube(2));
  s.add_path(0_v, 5_v);
  s.pull();
  const double before = area(s.triangulation);
  const std::vector<double> lengths = lengths_of_curves(s);
  FG::Refinement_options options;
  options.longest_edge = 0.4;
  BOOST_CHECK(FG::refine(s.network, options).is_complete());
  for(FG::Edge_index e : descriptors<FG::Edge_index>(s.triangulation.number_of_edges()))
    BOOST_CHECK_LE(s.triangulation.length(first_side(e)), 0.4);
  check_refined(s, before, lengths);
}

BOOST_AUTO_TEST_CASE(a_limit_on_insertions_is_kept)
{
  Curve_setting s(needle_strip(6, 6, 100));
  FG::Refinement_options options;
  options.maximum_insertions = 10;
  const FG::Refinement_report report = FG::refine(s.triangulation, options);
  BOOST_CHECK(report.status == FG::Refinement_status::VERTEX_LIMIT);
  BOOST_CHECK_EQUAL(report.insertions + report.splits, 10u);
}

// One circumcentre may ask for two edges to be split.
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
  FG::Index label(FG::Edge_index e) const { return triangulation.label(e); }
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

namespace {

struct Counting_visitor : FG::Default_shortening_visitor
{
  explicit Counting_visitor(std::size_t patience_)
    : patience(patience_)
  {
  }

  template <class Triangulation>
  void on_insertion(const Triangulation& triangulation, Vertex_index v)
  {
    BOOST_CHECK(triangulation.is_inserted(v));
    ++insertions;
  }
  bool go_further() { return insertions < patience; }

  std::size_t patience, insertions = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_visitor_is_told_of_each_vertex)
{
  for(const std::size_t patience : {0u, 1u, 5u, 1000000u}) {
    const int n = 10;
    Curve_setting s(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 3));
    s.add_path(Vertex_index(grid_vertex(n, 0, 1)), Vertex_index(grid_vertex(n, n, 3)));
    s.pull();
    Counting_visitor visitor(patience);
    const FG::Refinement_report report = FG::refine(s.network, FG::Refinement_options(), visitor);
    BOOST_CHECK_EQUAL(visitor.insertions, report.insertions + report.splits);
    BOOST_CHECK(report.status ==
                (patience > 1000 ? FG::Refinement_status::BOUNDS_REACHED : FG::Refinement_status::STOPPED_BY_VISITOR));
  }
}

// Where points lie on one input edge, closer together than numbers can tell, rounded flips may lead an edge around them
// on either side. Here such flips are made on purpose.
BOOST_AUTO_TEST_CASE(wrong_flips_between_points_of_one_edge_are_told)
{
  Curve_setting s(flat_grid(2, 2, Diagonal_rule::RISING));
  FG::Input_halfedge_index inner = 0_input_h;
  while(s.triangulation.input().is_border(inner) || s.triangulation.input().is_border(FG::internal::twin_index(inner)))
    ++inner;
  std::vector<Vertex_index> points;
  for(const double t : {0.2, 0.4, 0.6, 0.8})
    points.push_back(s.triangulation.insert(FG::Surface_location{inner, {{1 - t, t, 0}}}));
  const auto halfedge = [&](Vertex_index v, Vertex_index w) {
    Halfedge_index h = s.triangulation.outgoing(v);
    for(int i = 0; i < 20 && s.triangulation.head(h) != w; ++i)
      h = s.triangulation.clockwise(h);
    BOOST_REQUIRE_EQUAL(s.triangulation.head(h), w);
    return h;
  };
  const Halfedge_index middle = halfedge(points[1], points[2]);
  const auto check_words = [&] {
    for(FG::Edge_index f : descriptors<FG::Edge_index>(s.triangulation.number_of_edges()))
      BOOST_CHECK_EQUAL(s.triangulation.crossing_word(first_side(f)).crossed.size(),
                        static_cast<std::size_t>((std::max)(s.triangulation.crossings(f), 0)));
  };
  const std::size_t before = s.triangulation.log_position();
  // From the first to the third point on the left of the second, and from that to the last on the right of the third.
  s.triangulation.flip(s.triangulation.next(halfedge(points[0], points[1])));
  s.triangulation.flip(s.triangulation.next(halfedge(points[3], points[2])));
  check_words();
  s.triangulation.flip(middle); // from the first to the last, across the edge between the others
  BOOST_CHECK_EQUAL(s.triangulation.crossings(s.triangulation.edge(middle)), 1);
  BOOST_CHECK_THROW(s.triangulation.crossing_word(middle), FG::Insertion_error);
  s.triangulation.rollback(before);
  check_words();
}

// Says no when it was asked so many times, or throws.
struct Impatient_visitor : FG::Default_shortening_visitor
{
  explicit Impatient_visitor(int patience_, bool throws_ = false)
    : patience(patience_)
    , throws(throws_)
  {
  }

  bool go_further()
  {
    if(patience-- > 0)
      return true;
    if(throws)
      throw 1;
    return false;
  }

  int patience;
  bool throws;
};

BOOST_AUTO_TEST_CASE(a_visitor_interrupts)
{
  for(const int patience : {0, 10, 200, 300}) // before the first flip, among the flips, among the insertions
    for(const bool throws : {false, true}) {
      Curve_setting s(needle_strip(6, 6, stride > 1 ? 20 : 100));
      s.add_path(0_v, 20_v);
      s.pull();
      const double before = area(s.triangulation);
      const std::vector<double> lengths = lengths_of_curves(s);
      Impatient_visitor impatient(patience, throws), patient(10000000);
      if(throws) {
        BOOST_CHECK_THROW(FG::refine(s.network, FG::Refinement_options(), impatient), int);
      } else {
        const FG::Refinement_report report = FG::refine(s.network, FG::Refinement_options(), impatient);
        BOOST_CHECK(report.status == FG::Refinement_status::STOPPED_BY_VISITOR);
        BOOST_CHECK(!report.is_complete());
      }
      BOOST_CHECK_EQUAL(impatient.patience, -1);
      BOOST_CHECK(s.network.is_valid());
      BOOST_CHECK(FG::refine(s.network, FG::Refinement_options(), patient).is_complete());
      check_refined(s, before, lengths);
    }
}

BOOST_AUTO_TEST_CASE(exact_decisions)
{
  Certified_setting s(shaken(torus(10, 4, 3, 1), 0.1, 3));
  s.add_path(0_v, 23_v);
  s.pull();
  const double before = area(s.triangulation);
  const std::vector<double> lengths = lengths_of_curves(s);
  const FG::Refinement_report report = FG::refine(s.network);
  BOOST_CHECK(report.is_complete());
  check_refined(s, before, lengths);
}
