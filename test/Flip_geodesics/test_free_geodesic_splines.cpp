// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Splines whose legs do not hold up one another, against the plane's, on surfaces that roll out to it: control polygons
// that cross themselves, or pass over their own points, are like all others.

#define BOOST_TEST_MODULE free_geodesic_splines

#include "descriptors.h"
#include "rolled_out_surfaces.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>

#include <cstddef>
#include <iterator>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Spline = FG::Geodesic_spline<Triangulation>;
using Pieces = std::vector<std::vector<FG::Surface_location>>;

std::vector<std::vector<Flat_point>> simple_and_crossing_polygons()
{
  std::vector<std::vector<Flat_point>> result = polygons;
  result.push_back({{1.2, 1.1}, {7.3, 6.8}, {6.9, 1.4}, {1.3, 7.1}}); // crosses itself
  result.push_back({{0.5, 0.5}, {1, 4}, {6, 4}, {4, 4}});             // the second leg passes over the last point
  result.push_back({{1, 1}, {6, 6}, {1, 1.5}, {6, 5.5}, {3, 7}});
  result.push_back({{1, 1}, {1, 1}, {6, 5}, {3, 7}}); // control points are repeated
  result.push_back({{1.5, 1}, {6, 5}, {6, 5}, {6, 5}, {3.25, 7}, {3.25, 7}});
  return result;
}

// Where the pieces start and end, in the plane.
std::vector<Flat_point> joints(const Mesh& flat, const Pieces& pieces)
{
  std::vector<Flat_point> result = {rolled_out(flat, pieces.front().front())};
  for(const auto& piece : pieces) {
    BOOST_TEST(distance(result.back(), rolled_out(flat, piece.front())) == 0);
    result.push_back(rolled_out(flat, piece.back()));
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(bezier_curves_are_those_of_the_plane)
{
  for(const Bent_surface& surface : surfaces())
    for(const auto& polygon : simple_and_crossing_polygons()) {
      Triangulation t(surface.bent);
      Spline spline(t, locations(t, surface, polygon), FG::Spline_kind::BEZIER);
      for(int round = 1; round <= 4; ++round)
        spline.refine();
      const auto curve = joints(surface.flat, spline.finish());
      BOOST_REQUIRE_EQUAL(curve.size(), 17u);
      double length = 0;
      for(std::size_t i = 0; i < curve.size(); ++i) {
        BOOST_TEST(distance(curve[i], de_casteljau(polygon, static_cast<double>(i) / 16)) < 1e-11);
        length += i > 0 ? distance(curve[i - 1], curve[i]) : 0;
      }
      BOOST_TEST(spline.report().is_complete());
      BOOST_TEST(std::abs(spline.length() - length) < 1e-11);
      BOOST_TEST(t.log_position() == 0u);
      BOOST_TEST(t.number_of_vertices() == static_cast<int>(surface.bent.number_of_vertices()));
    }
}

BOOST_AUTO_TEST_CASE(cubic_b_splines_are_those_of_the_plane)
{
  for(const Bent_surface& surface : surfaces())
    for(bool is_closed : {false, true}) {
      const std::vector<Flat_point> polygon = {{0.5, 2}, {6.4, 6.1}, {2.6, 7.3}, {5.2, 1.6}, {6.9, 4.7}};
      const int n = static_cast<int>(polygon.size());
      Triangulation t(surface.bent);
      Spline spline(t, locations(t, surface, polygon),
                    is_closed ? FG::Spline_kind::CLOSED_CUBIC_B_SPLINE : FG::Spline_kind::CUBIC_B_SPLINE);
      const Pieces coarse = spline.finish();
      const auto joint = joints(surface.flat, coarse);
      BOOST_REQUIRE_EQUAL(coarse.size(), is_closed ? 5u : 4u);
      for(int i = 0; i <= static_cast<int>(coarse.size()); ++i) {
        const auto& p = polygon[static_cast<std::size_t>((i - 1 + n) % n)];
        const auto& q = polygon[static_cast<std::size_t>(i % n)];
        const auto& r = polygon[static_cast<std::size_t>((i + 1) % n)];
        Flat_point expected = {(p[0] + 4 * q[0] + r[0]) / 6, (p[1] + 4 * q[1] + r[1]) / 6};
        if(!is_closed && (i == 0 || i == n - 1))
          expected = q;
        BOOST_TEST(distance(joint[static_cast<std::size_t>(i)], expected) < 1e-11);
      }
      // Between two joints in the middle of the curve: the control points of the piece are at the thirds of a leg.
      spline.refine();
      const auto finer = joints(surface.flat, spline.finish());
      const Flat_point &a = polygon[1], &b = polygon[2];
      const Flat_point expected = de_casteljau({joint[1], middle(a, b, 1.0 / 3), middle(a, b, 2.0 / 3), joint[2]}, 0.5);
      BOOST_TEST(distance(finer[3], expected) < 1e-11);
      BOOST_TEST(spline.report().is_complete());
    }
}

BOOST_AUTO_TEST_CASE(refinement_to_a_tolerance)
{
  const Bent_surface surface = surfaces()[2];
  Triangulation t(surface.bent);
  Spline spline(t, locations(t, surface, polygons[2]), FG::Spline_kind::BEZIER);
  const int rounds = spline.refine(1e-4, 20);
  BOOST_TEST(rounds > 3);
  BOOST_TEST(rounds < 8);
  double length = 0; // of the curve, by many chords
  for(int i = 0; i < 10000; ++i)
    length += distance(de_casteljau(polygons[2], i / 10000.0), de_casteljau(polygons[2], (i + 1) / 10000.0));
  BOOST_TEST(std::abs(spline.polygon_length() - length) < 1e-4 * length);
}

// Points that divide a leg are rounded, and legs end there exactly: so all is proven.
BOOST_AUTO_TEST_CASE(exact_decisions)
{
  using Traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
  using Certified = FG::Intrinsic_triangulation<Mesh, Traits>;
  const Mesh mesh = to_mesh<Mesh>(torus(24, 12, 1, 0.4));
  for(const FG::Spline_kind kind : {FG::Spline_kind::BEZIER, FG::Spline_kind::CUBIC_B_SPLINE}) {
    Certified t(mesh);
    std::vector<FG::Surface_location> points;
    for(FG::Vertex_index v : {0_v, 15_v, 40_v, 3_v, 65_v})
      points.push_back(t.location(v));
    FG::Geodesic_spline<Certified> spline(t, points, kind);
    for(int i = 0; i < 3; ++i)
      spline.refine();
    BOOST_TEST(spline.finish().size() == (kind == FG::Spline_kind::BEZIER ? 8u : 32u));
    BOOST_TEST(spline.report().is_complete());
    BOOST_TEST((spline.verdict() == FG::Verdict::PROVEN));
  }
}

BOOST_AUTO_TEST_CASE(one_call)
{
  const Bent_surface surface = surfaces().front();
  const auto polygon = simple_and_crossing_polygons()[5];
  std::vector<Face_location> points;
  for(const Flat_point& p : polygon)
    points.push_back(location_on_grid(surface.bent, surface.flat, p));
  std::vector<Point> curve;
  const auto result = FG::geodesic_spline(surface.bent, points, FG::Spline_kind::BEZIER, std::back_inserter(curve),
                                          CGAL::parameters::number_of_iterations(3));
  BOOST_TEST(result.report.is_complete());
  BOOST_TEST(distance({curve.front().x(), curve.front().y()}, polygon.front()) < 1e-11);
  BOOST_TEST(distance({curve.back().x(), curve.back().y()}, polygon.back()) < 1e-11);
  double nearest = 1;
  for(const Point& p : curve)
    nearest = (std::min)(nearest, distance({p.x(), p.y()}, de_casteljau(polygon, 0.625)));
  BOOST_TEST(nearest < 1e-11);
}

BOOST_AUTO_TEST_CASE(paths_through_points_may_cross_themselves)
{
  for(const Bent_surface& surface : surfaces())
    for(const auto& polygon : simple_and_crossing_polygons()) {
      Triangulation t(surface.bent);
      const FG::Free_legs path = FG::geodesics_through(t, locations(t, surface, polygon));
      BOOST_REQUIRE_EQUAL(path.legs.size() + 1, polygon.size());
      double length = 0;
      for(std::size_t i = 0; i < path.legs.size(); ++i) {
        BOOST_TEST(distance(rolled_out(surface.flat, path.legs[i].front()), polygon[i]) < 1e-11);
        BOOST_TEST(distance(rolled_out(surface.flat, path.legs[i].back()), polygon[i + 1]) < 1e-11);
        length += distance(polygon[i], polygon[i + 1]);
      }
      BOOST_TEST(path.report.is_complete());
      BOOST_TEST(std::abs(path.report.curves.front().length - length) < 1e-11);
      BOOST_TEST(path.report.curves.front().initial_length > length);
      BOOST_TEST(t.log_position() == 0u);
      const FG::Free_legs start = FG::geodesics_through(
          t, locations(t, surface, polygon), CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(0)));
      BOOST_TEST(start.report.curves.front().length == path.report.curves.front().initial_length);
      BOOST_TEST((start.report.curves.front().status == FG::Shortening_status::ITERATION_LIMIT));
    }
}

BOOST_AUTO_TEST_CASE(a_spline_of_one_point_is_that_point)
{
  const Bent_surface surface = surfaces().front();
  for(auto kind : {FG::Spline_kind::BEZIER, FG::Spline_kind::CUBIC_B_SPLINE, FG::Spline_kind::CLOSED_CUBIC_B_SPLINE}) {
    Triangulation t(surface.bent);
    Spline spline(t, locations(t, surface, {{2.3, 1.4}, {2.3, 1.4}, {2.3, 1.4}}), kind);
    spline.refine();
    for(const auto& piece : spline.finish())
      for(const FG::Surface_location& p : piece)
        BOOST_TEST(distance(rolled_out(surface.flat, p), {2.3, 1.4}) < 1e-12);
    BOOST_TEST(spline.length() == 0);
    BOOST_TEST((spline.status() == FG::Shortening_status::CONTRACTED));
  }
}

BOOST_AUTO_TEST_CASE(bad_control_points_are_refused)
{
  const Bent_surface surface = surfaces().front();
  Triangulation t(surface.bent);
  const auto points = locations(t, surface, {{1, 1}, {5, 5}});
  BOOST_CHECK_THROW(Spline(t, {points[0]}, FG::Spline_kind::BEZIER), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(Spline(t, points, FG::Spline_kind::CLOSED_CUBIC_B_SPLINE), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(Spline(t, {points[0], FG::Surface_location{100000_input_h, {{1, 1, 1}}}}, FG::Spline_kind::BEZIER),
                    FG::Invalid_location_error);
  BOOST_TEST(t.log_position() == 0u);
}

// A leg within a face keeps its ends as they were told, and one that comes back to where it starts is its two ends.
BOOST_AUTO_TEST_CASE(legs_within_a_face_and_legs_that_contract)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  Triangulation t(mesh);
  FG::internal::Path_straightener<Triangulation> straightener(t);
  const auto h = t.input().index(mesh.halfedge(Mesh::Face_index(9)));
  const FG::internal::Surface_polyline bent = {{h, {{1, 2, 3}}}, {h, {{5, 1, 1}}}, {h, {{3, 2, 2}}}};
  const auto straight = straightener.straightened(bent);
  BOOST_REQUIRE_EQUAL(straight.size(), 2u);
  for(int i : {0, 1}) {
    BOOST_TEST(straight[i].halfedge == bent[2 * i].halfedge);
    BOOST_TEST((straight[i].weights == bent[2 * i].weights));
  }

  FG::internal::Surface_polyline round; // about a vertex, from an edge to the same place
  const auto start = t.outgoing(FG::Vertex_index(grid_vertex(4, 2, 2)));
  auto outgoing_halfedge = start;
  do {
    round.push_back({FG::internal::as_input(outgoing_halfedge), {{1, 3, 0}}}); // nearer to the other end
    outgoing_halfedge = t.clockwise(outgoing_halfedge);
  } while(outgoing_halfedge != start);
  round.push_back(round.front());
  BOOST_TEST(straightener.straightened(round).size() == 2u);
  BOOST_TEST(t.log_position() == 0u);
}

BOOST_AUTO_TEST_CASE(no_point_is_written_twice)
{
  const Bent_surface surface = surfaces().back();
  Triangulation t(surface.bent);
  for(const auto& polygon : polygons) {
    std::vector<std::vector<Point>> curves(2);
    FG::geodesic_path_through(surface.bent, locations(t, surface, polygon), std::back_inserter(curves[0]));
    FG::geodesic_spline(surface.bent, locations(t, surface, polygon), FG::Spline_kind::BEZIER,
                        std::back_inserter(curves[1]));
    for(const std::vector<Point>& points : curves) {
      BOOST_TEST(points.size() > polygon.size());
      BOOST_TEST((std::adjacent_find(points.begin(), points.end()) == points.end()));
    }
  }
  BOOST_CHECK_THROW(FG::geodesics_through(t, locations(t, surface, {{1, 1}})), FG::Invalid_curve_error);
}
