// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Delaunay refinement: bounds are reached, curves keep their place and length, the surface keeps its area and its
// topology, no two vertices are in one place, and the process ends where it cannot reach a bound.

#define BOOST_TEST_MODULE refine

#include "test_refine/checked_refinement.h"

#include <CGAL/Flip_geodesics/certify.h>

#include <boost/math/constants/constants.hpp>

using namespace Flip_geodesics_test;

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
  const FG::Refinement_report report = FG::refine(s.triangulation, {}, CGAL::parameters::visitor(std::ref(visitor)));
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
  for(double shorter_than_any : {1e-71, 1e-300, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.longest_edge = shorter_than_any;
    BOOST_CHECK_THROW(FG::refine(s.triangulation, options), FG::Invalid_parameter_error);
  }
  options.longest_edge = 0;
  BOOST_CHECK_THROW(FG::refine(s.triangulation, options), FG::Invalid_parameter_error);
}

// The exact certificate may find bends where curves are split, but they are rounding errors.
BOOST_AUTO_TEST_CASE(split_curves_bend_by_rounding_errors)
{
  Curve_setting s(torus(24, 12, 3, 1));
  s.add_path(0_v, 150_v);
  s.pull();
  BOOST_CHECK(FG::certify(s.network).curves[0].verdict() == FG::Verdict::PROVEN);
  FG::Refinement_options options;
  options.smallest_angle = 20;
  BOOST_CHECK_GT(FG::refine(s.network, options).splits, 0u);
  BOOST_CHECK(FG::certify(s.network).curves[0].verdict() != FG::Verdict::BENT_SEGMENT);
  const FG::Straightness straightness = FG::Straightness_meter<Curve_setting::Network>(s.network)(0_c);
  BOOST_CHECK_GT(straightness.smallest_angle, boost::math::constants::pi<double>() - 1e-13);
  BOOST_CHECK_LT(straightness.largest_bend, 1e-13);
}

// Edges that are too long are not given up: the vertices that are allowed are spread over the surface.
BOOST_AUTO_TEST_CASE(a_length_that_no_edge_has_spreads_the_vertices)
{
  for(double length : {1e-60, 1e-6}) {
    Curve_setting s(cube(2));
    FG::Refinement_options options;
    options.longest_edge = length;
    options.maximum_insertions = 1000;
    const double mean = std::sqrt(area(s.triangulation) / 1000);
    const FG::Refinement_report report = FG::refine(s.network, options);
    BOOST_CHECK(report.status == FG::Refinement_status::VERTEX_LIMIT);
    BOOST_CHECK_EQUAL(report.insertions + report.splits, 1000u);
    BOOST_CHECK_EQUAL(report.given_up, 0u);
    for(FG::Edge_index e : descriptors<FG::Edge_index>(s.triangulation.number_of_edges())) {
      BOOST_CHECK_LE(s.triangulation.length(FG::internal::first_side(e)), 3 * mean);
      BOOST_CHECK_GE(s.triangulation.length(FG::internal::first_side(e)), mean / 5);
    }
  }
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
    BOOST_CHECK_LE(s.triangulation.length(FG::internal::first_side(e)), 0.4);
  check_refined(s, before, lengths);
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
    const FG::Refinement_report report =
        FG::refine(s.network, FG::Refinement_options(), CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_CHECK_EQUAL(visitor.insertions, report.insertions + report.splits);
    BOOST_CHECK(report.status ==
                (patience > 1000 ? FG::Refinement_status::BOUNDS_REACHED : FG::Refinement_status::STOPPED_BY_VISITOR));
  }
}

BOOST_AUTO_TEST_CASE(a_time_limit_ends_the_refinement)
{
  Curve_setting s(jittered_grid(10, 10, Diagonal_rule::RANDOM, 0.2, 3));
  const FG::Refinement_report report =
      FG::refine(s.triangulation, {}, CGAL::parameters::visitor(FG::Time_stop_predicate(std::chrono::seconds(0))));
  BOOST_CHECK(report.status == FG::Refinement_status::STOPPED_BY_VISITOR);
  BOOST_CHECK_EQUAL(report.insertions + report.splits, 0);
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
      BOOST_CHECK_EQUAL(s.triangulation.edge_sequence(FG::internal::first_side(f)).crossed.size(),
                        static_cast<std::size_t>((std::max)(s.triangulation.crossings(f), 0)));
  };
  const std::size_t before = s.triangulation.log_position();
  // From the first to the third point on the left of the second, and from that to the last on the right of the third.
  s.triangulation.flip(s.triangulation.next(halfedge(points[0], points[1])));
  s.triangulation.flip(s.triangulation.next(halfedge(points[3], points[2])));
  check_words();
  s.triangulation.flip(middle); // from the first to the last, across the edge between the others
  BOOST_CHECK_EQUAL(s.triangulation.crossings(s.triangulation.edge(middle)), 1);
  BOOST_CHECK_THROW(s.triangulation.edge_sequence(middle), FG::Insertion_error);
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
        BOOST_CHECK_THROW(
            FG::refine(s.network, FG::Refinement_options(), CGAL::parameters::visitor(std::ref(impatient))), int);
      } else {
        const FG::Refinement_report report =
            FG::refine(s.network, FG::Refinement_options(), CGAL::parameters::visitor(std::ref(impatient)));
        BOOST_CHECK(report.status == FG::Refinement_status::STOPPED_BY_VISITOR);
        BOOST_CHECK(!report.is_complete());
      }
      BOOST_CHECK_EQUAL(impatient.patience, -1);
      BOOST_CHECK(s.network.is_valid());
      BOOST_CHECK(
          FG::refine(s.network, FG::Refinement_options(), CGAL::parameters::visitor(std::ref(patient))).is_complete());
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
