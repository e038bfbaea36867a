// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves through points anywhere, and splines of geodesics, against the plane's, on surfaces that roll out to it.

#define BOOST_TEST_MODULE geodesic_splines

#include "descriptors.h"
#include "rolled_out_surfaces.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Network = FG::Edge_path_network<Triangulation>;

namespace {

// Computes a spline and makes its pieces a curve of a network.
template <class Network>
FG::Curve_index add_spline(Network& network, const std::vector<FG::Surface_location>& points, FG::Spline_kind kind,
                           int rounds)
{
  FG::Geodesic_spline<typename Network::Triangulation> spline(network.triangulation(), points, kind);
  for(int round = 0; round < rounds; ++round)
    spline.refine();
  return FG::add_curve_along(network, spline.finish(),
                             CGAL::parameters::is_closed(kind == FG::Spline_kind::CLOSED_CUBIC_B_SPLINE));
}

// The vertices at which a curve is fixed, an open curve's ends included, in the plane.
std::vector<Flat_point> fixed_vertices(const Bent_surface& surface, const Network& network, FG::Curve_index curve)
{
  const Triangulation& t = network.triangulation();
  std::vector<Flat_point> result;
  if(!network.is_closed(curve))
    result.push_back(rolled_out(surface.flat, t, t.tail(network.halfedge(network.first_segment(curve)))));
  network.for_each_segment(curve, [&](FG::Segment_index s) {
    if(network.is_head_fixed(s) || network.next(s) == FG::null_index)
      result.push_back(rolled_out(surface.flat, t, t.head(network.halfedge(s))));
  });
  return result;
}

} // namespace

// The control polygons along edges have legs that are halved at vertices of the mesh.
BOOST_AUTO_TEST_CASE(bezier_curves_of_flat_surfaces_are_those_of_the_plane)
{
  std::vector<std::vector<Flat_point>> all = polygons;
  all.insert(all.end(), {{{1, 1}, {5, 1}},
                         {{1, 1}, {5, 5}},
                         {{1, 1}, {5, 1}, {5, 5}},
                         {{2, 1}, {2, 5}, {6, 5}, {6, 1}},
                         {{1, 1}, {6, 6}, {6, 2}, {1, 7}}}); // the polygon crosses itself, the curve does not
  for(const Bent_surface& surface : surfaces())
    for(const auto& polygon : all) {
      Triangulation t(surface.bent);
      Network network(t);
      const FG::Curve_index curve = add_spline(network, locations(t, surface, polygon), FG::Spline_kind::BEZIER, 4);
      FG::order_overlapping_curves(network);
      BOOST_TEST(FG::shorten(network).is_complete());
      BOOST_TEST(network.is_valid());
      BOOST_TEST(t.is_valid());
      BOOST_TEST(FG::certify(network).is_locally_shortest());
      const auto vertices = fixed_vertices(surface, network, curve);
      BOOST_REQUIRE_EQUAL(vertices.size(), 17u);
      double length = 0;
      for(int i = 0; i <= 16; ++i) {
        BOOST_TEST(distance(vertices[static_cast<std::size_t>(i)], de_casteljau(polygon, i / 16.0)) < 1e-11);
        length += i > 0 ? distance(de_casteljau(polygon, (i - 1) / 16.0), de_casteljau(polygon, i / 16.0)) : 0;
      }
      BOOST_TEST(std::abs(network.length(curve) - length) < 1e-11);
      network.clear();
      t.rollback();
      BOOST_TEST(t.number_of_vertices() == static_cast<int>(surface.bent.number_of_vertices()));
    }
}

BOOST_AUTO_TEST_CASE(cubic_b_splines_of_flat_surfaces_are_those_of_the_plane)
{
  for(const Bent_surface& surface : surfaces())
    for(bool is_closed : {false, true}) {
      const auto& polygon = polygons.back();
      const int n = static_cast<int>(polygon.size());
      Triangulation t(surface.bent);
      Network network(t);
      const FG::Curve_index curve =
          add_spline(network, locations(t, surface, polygon),
                     is_closed ? FG::Spline_kind::CLOSED_CUBIC_B_SPLINE : FG::Spline_kind::CUBIC_B_SPLINE, 2);
      FG::order_overlapping_curves(network);
      BOOST_TEST(network.is_closed(curve) == is_closed);
      const auto vertices = fixed_vertices(surface, network, curve);
      BOOST_REQUIRE_EQUAL(vertices.size(), static_cast<std::size_t>(is_closed ? 4 * n : 4 * n - 3));
      // A uniform cubic B-spline between four control points in a row: every fourth of a piece.
      int inner_pieces = 0;
      for(int i = is_closed ? 0 : 1; i < (is_closed ? n : n - 2); ++i, ++inner_pieces)
        for(int k = 0; k <= 4; ++k) {
          const double u = k / 4.0;
          const double b[4] = {(1 - u) * (1 - u) * (1 - u) / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
                               (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
          Flat_point expected = {0, 0};
          for(int j = 0; j < 4; ++j) {
            const Flat_point& p = polygon[static_cast<std::size_t>((i + j - 1 + n) % n)];
            expected = {expected[0] + b[j] * p[0], expected[1] + b[j] * p[1]};
          }
          double nearest = 1;
          for(const Flat_point& p : vertices)
            nearest = (std::min)(nearest, distance(p, expected));
          BOOST_TEST(nearest < 1e-11);
        }
      BOOST_TEST(inner_pieces > 3);
      BOOST_TEST(FG::shorten(network).is_complete());
      BOOST_TEST(FG::certify(network).is_locally_shortest());
      BOOST_TEST(network.is_valid());
    }
}

// Points that divide a leg are rounded, and pieces end there exactly.
BOOST_AUTO_TEST_CASE(splines_in_exact_decisions)
{
  using Traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
  using Certified = FG::Intrinsic_triangulation<Mesh, Traits>;
  const Mesh mesh = to_mesh<Mesh>(torus(24, 12, 1, 0.4));
  for(const FG::Spline_kind kind : {FG::Spline_kind::BEZIER, FG::Spline_kind::CUBIC_B_SPLINE}) {
    Certified t(mesh);
    FG::Edge_path_network<Certified> network(t);
    std::vector<FG::Surface_location> points;
    for(FG::Vertex_index v : {0_v, 15_v, 41_v, 65_v})
      points.push_back(t.location(v));
    add_spline(network, points, kind, 4);
    FG::order_overlapping_curves(network);
    BOOST_TEST(FG::shorten(network).is_complete());
    BOOST_TEST(network.is_valid());
    BOOST_TEST(t.is_valid());
    BOOST_TEST(FG::certify(network).is_locally_shortest());
  }
}

// The legs of an editor, and a polyline that is shortened before it is drawn.
BOOST_AUTO_TEST_CASE(geodesics_are_drawn_into_a_network)
{
  for(const Bent_surface& surface : surfaces()) {
    Triangulation t(surface.bent);
    Network network(t);
    const FG::Free_legs path = FG::geodesics_through(t, locations(t, surface, polygons[3]));
    const FG::Curve_index straight = FG::add_curve_along(network, path.legs);
    BOOST_TEST(network.is_valid());
    BOOST_TEST(std::abs(network.length(straight) - path.report.curves.front().length) < 1e-11);
    network.clear();
    t.rollback();
    std::vector<FG::Surface_location> bent;
    for(const auto& leg : path.legs)
      bent.insert(bent.end(), leg.begin(), leg.end());
    const FG::Curve_index shortened = FG::add_curve_along(network, {bent});
    BOOST_TEST(network.is_valid());
    BOOST_TEST(std::abs(network.length(shortened) - distance(polygons[3].front(), polygons[3].back())) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(geodesics_that_cannot_be_drawn_are_refused)
{
  const Bent_surface surface = surfaces().front();
  Triangulation t(surface.bent);
  const FG::Free_legs crossing =
      FG::geodesics_through(t, locations(t, surface, {{1, 4.5}, {7, 4.5}, {7, 7}, {3.25, 7}, {3.25, 1}}));
  Network network(t);
  BOOST_CHECK_THROW(FG::add_curve_along(network, crossing.legs), FG::Crossing_curves_error);
  BOOST_TEST(network.is_valid());
  t.rollback();
  const auto points = locations(t, surface, {{1, 1}, {2.5, 2.25}, {2.75, 2.375}, {7, 7}});
  BOOST_CHECK_THROW(FG::add_curve_along(network, {}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::add_curve_along(network, {{points[1]}}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::add_curve_along(network, {{points[1], points[1]}}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::add_curve_along(network, {{points[0], points[3]}}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::add_curve_along(network, {{points[1], points[2]}, {points[1], points[2]}}),
                    FG::Invalid_curve_error);
  BOOST_TEST(network.number_of_curves() == 0);
}

BOOST_AUTO_TEST_CASE(paths_between_points_and_through_way_points)
{
  for(const Bent_surface& surface : surfaces()) {
    std::vector<Face_location> way_points;
    double length = 0;
    const auto& polygon = polygons[3];
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      way_points.push_back(location_on_grid(surface.bent, surface.flat, polygon[i]));
      length += i > 0 ? distance(polygon[i - 1], polygon[i]) : 0;
    }
    std::vector<Point> points;
    const auto through = FG::geodesic_path_through(surface.bent, way_points, std::back_inserter(points));
    BOOST_TEST(through.report.is_complete());
    BOOST_TEST((std::adjacent_find(points.begin(), points.end()) == points.end())); // legs share their ends
    BOOST_TEST(std::abs(through.report.curves.front().length - length) < 1e-12 * length);
    points.clear();
    const auto direct =
        FG::geodesic_path(surface.bent, way_points.front(), way_points.back(), std::back_inserter(points));
    const double straight = distance(polygon.front(), polygon.back());
    BOOST_TEST(std::abs(direct.report.curves.front().length - straight) < 1e-12 * straight);
    double sum = 0;
    for(std::size_t i = 0; i + 1 < points.size(); ++i)
      sum += std::sqrt(CGAL::squared_distance(points[i], points[i + 1]));
    BOOST_TEST(std::abs(sum - straight) < 1e-12 * straight);
    const std::vector<Mesh::Vertex_index> vertices = {Mesh::Vertex_index(0), Mesh::Vertex_index(40)};
    BOOST_TEST(FG::geodesic_path_through(surface.bent, vertices, std::back_inserter(points)).report.is_complete());
  }
}

BOOST_AUTO_TEST_CASE(bad_points_are_refused)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  const Mesh::Face_index f(0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> points;
  const Face_location good = {f, {{0.5, 0.25, 0.25}}};
  for(const Face_location& bad : std::vector<Face_location>{{Mesh::null_face(), {{0.5, 0.25, 0.25}}},
                                                            {f, {{0.5, 0.25, 0.2}}},
                                                            {f, {{1.1, -0.05, -0.05}}},
                                                            {f, {{nan, 0.5, 0.5}}},
                                                            {f, {{0, 0, 0}}}})
    BOOST_CHECK_THROW(FG::geodesic_path(mesh, good, bad, std::back_inserter(points)), FG::Invalid_location_error);
  BOOST_CHECK(points.empty());
  // Located with rounding: at the vertex.
  Triangulation t(mesh);
  const auto snapped = FG::surface_location(t, mesh, Face_location{f, {{1 + 5.6e-17, -5.6e-17, 1e-16}}});
  BOOST_TEST((kind(snapped) == FG::Location_kind::VERTEX));
  BOOST_TEST(
      (kind(FG::surface_location(t, mesh, Face_location{f, {{0.5, 0.5, 1e-16}}}, 0)) == FG::Location_kind::FACE));
  // The message names what is wrong.
  const auto names = [](const std::string& words) {
    return
        [words](const FG::Invalid_location_error& e) { return std::string(e.what()).find(words) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(FG::surface_location(t, mesh, Face_location{f, {{2, 0, 0}}}), FG::Invalid_location_error,
                        names("must be between 0 and 1"));
  BOOST_CHECK_EXCEPTION(FG::surface_location(t, mesh, Face_location{f, {{0.5, 0.25, 0}}}), FG::Invalid_location_error,
                        names("sum to"));
  BOOST_CHECK_THROW(FG::geodesics_through(t, {snapped}), FG::Invalid_curve_error);
}

// Straight lines from corner to corner, with a point on each edge that they cross.
BOOST_AUTO_TEST_CASE(polylines_are_drawn_by_insertion_or_snapped_to_edges)
{
  for(const Bent_surface& surface : surfaces()) {
    const auto& polygon = polygons[3];
    double length = 0;
    for(std::size_t i = 0; i + 1 < polygon.size(); ++i)
      length += distance(polygon[i], polygon[i + 1]);
    const double straight = distance(polygon.front(), polygon.back());
    std::vector<FG::Surface_location> polyline;
    {
      Triangulation t(surface.bent);
      Network network(t);
      FG::add_curve_through(network, locations(t, surface, polygon));
      FG::order_overlapping_curves(network);
      FG::shorten(network);
      std::vector<Face_location> on_faces;
      FG::Curve_extractor<Network>(network).face_locations(0_c, surface.bent, std::back_inserter(on_faces));
      for(const Face_location& p : on_faces)
        polyline.push_back(FG::surface_location(t, surface.bent, p));
    }
    Triangulation t(surface.bent);
    Network network(t);
    const FG::Curve_index drawn = FG::draw_polyline(network, polyline);
    FG::order_overlapping_curves(network);
    FG::shorten(network);
    BOOST_TEST(network.is_valid());
    BOOST_TEST(t.is_valid());
    BOOST_TEST(std::abs(network.length(drawn) - length) < 1e-11);
    network.free_nodes(drawn);
    BOOST_TEST(network.is_valid());
    BOOST_TEST(FG::shorten(network).is_complete());
    BOOST_TEST(std::abs(network.length(drawn) - straight) < 1e-11);
    BOOST_TEST(FG::certify(network).is_locally_shortest());

    Triangulation input(surface.bent);
    const auto path = FG::snap_polyline(input, polyline);
    BOOST_TEST(path.size() > 8);
    Network snapped(input);
    snapped.add_curve(FG::halfedges_through(input, path));
    FG::order_overlapping_curves(snapped);
    BOOST_TEST(FG::shorten(snapped).is_complete());
    BOOST_TEST(std::abs(snapped.length(0_c) - distance(rolled_out(surface.flat, input, path.front()),
                                                       rolled_out(surface.flat, input, path.back()))) < 1e-11);
    BOOST_CHECK_THROW(FG::draw_polyline(snapped, {polyline.front(), polyline.back()}), FG::Invalid_curve_error);
    BOOST_CHECK_THROW(FG::snap_polyline(input, {polyline.front()}), FG::Invalid_curve_error);
  }
}

// Points that share no face are joined by geodesics: here by the straight lines between the corners.
BOOST_AUTO_TEST_CASE(polylines_are_completed)
{
  for(const Bent_surface& surface : surfaces()) {
    const auto& polygon = polygons[3];
    double length = 0;
    for(std::size_t i = 0; i + 1 < polygon.size(); ++i)
      length += distance(polygon[i], polygon[i + 1]);
    Triangulation t(surface.bent);
    const auto polyline = FG::complete_polyline(t, locations(t, surface, polygon));
    BOOST_TEST(t.log_position() == 0u);
    BOOST_TEST(polyline.size() > 2 * polygon.size());
    BOOST_TEST(FG::complete_polyline(t, polyline).size() == polyline.size()); // nothing is missing now
    Network network(t);
    const FG::Curve_index drawn = FG::draw_polyline(network, polyline);
    FG::order_overlapping_curves(network);
    FG::shorten(network);
    network.reset_initial_length(drawn);
    BOOST_TEST(std::abs(network.initial_length(drawn) - length) < 1e-11);
    BOOST_CHECK_THROW(FG::complete_polyline(t, {polyline.front()}), FG::Invalid_curve_error);
  }
}

// A polyline passes a point of its own twice, and crosses itself there: as long as it is fixed, and no longer.
BOOST_AUTO_TEST_CASE(a_polyline_that_crosses_itself_cannot_be_freed)
{
  const Bent_surface surface = surfaces().front();
  Triangulation t(surface.bent);
  const auto polyline =
      FG::complete_polyline(t, locations(t, surface, {{2, 4}, {4, 4}, {6, 4}, {6, 6}, {4, 4}, {2, 2.5}}));
  Network network(t);
  const FG::Curve_index drawn = FG::draw_polyline(network, polyline);
  FG::order_overlapping_curves(network);
  BOOST_TEST(FG::shorten(network).is_complete());
  BOOST_CHECK_THROW(network.free_nodes(drawn), FG::Crossing_curves_error);
  BOOST_TEST(network.is_valid());
}

// A closed polyline about a cylinder is pulled tight to a ring, drawn by insertion and snapped alike.
BOOST_AUTO_TEST_CASE(closed_polylines)
{
  const int n = 12, m = 4;
  const Mesh mesh = to_mesh<Mesh>(cylinder(n, m, 1, 2));
  Triangulation t(mesh);
  std::vector<FG::Surface_location> loop; // from middle to middle of the edges that ring 2 is the lower end of
  for(int i = 0; i < n; ++i) {
    const auto v = Mesh::Vertex_index(static_cast<unsigned>(i + 2 * n));
    const auto h = mesh.halfedge(v, Mesh::Vertex_index(static_cast<unsigned>(i + 3 * n)));
    const auto diagonal = mesh.halfedge(v, Mesh::Vertex_index(static_cast<unsigned>((i + 1) % n + 3 * n)));
    BOOST_REQUIRE((h != mesh.null_halfedge() && diagonal != mesh.null_halfedge()));
    loop.push_back({t.input().index(h), {{2, 1, 0}}});
    loop.push_back({t.input().index(diagonal), {{1, 3, 0}}});
  }
  const double ring = n * polygon_side(n, 1);
  Network network(t);
  const FG::Curve_index drawn = FG::draw_polyline(network, loop, CGAL::parameters::is_closed(true));
  FG::shorten(network);
  BOOST_TEST(network.length(drawn) > ring * 1.01);
  network.free_nodes(drawn);
  BOOST_TEST(FG::shorten(network).is_complete());
  BOOST_TEST(std::abs(network.length(drawn) - ring) < 1e-11);
  network.clear();
  t.rollback();
  network.add_curve(FG::halfedges_through(t, FG::snap_polyline(t, loop, CGAL::parameters::is_closed(true)),
                                          CGAL::parameters::is_closed(true)),
                    CGAL::parameters::is_closed(true));
  FG::order_overlapping_curves(network);
  BOOST_TEST(FG::shorten(network).is_complete());
  BOOST_TEST(std::abs(network.length(0_c) - ring) < 1e-11);
}

BOOST_AUTO_TEST_CASE(polylines_with_too_few_points_are_refused)
{
  const Bent_surface surface = surfaces().front();
  Triangulation t(surface.bent);
  Network network(t);
  const auto points = locations(t, surface, {{2.5, 2.25}, {2.75, 2.375}, {2.75, 2.5}});
  const std::vector<FG::Surface_location> two(points.begin(), points.begin() + 2);
  BOOST_CHECK_THROW(FG::draw_polyline(network, two, CGAL::parameters::is_closed(true)), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::snap_polyline(t, two, CGAL::parameters::is_closed(true)), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::complete_polyline(t, two, CGAL::parameters::is_closed(true)), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(FG::draw_polyline(network, {points.front()}), FG::Invalid_curve_error);
  BOOST_TEST(t.number_of_vertices() == static_cast<int>(surface.bent.number_of_vertices()));
}

// Points that repeat the one before are one vertex of the curve.
BOOST_AUTO_TEST_CASE(repeated_points_of_a_polyline_are_skipped)
{
  const Bent_surface surface = surfaces().front();
  Triangulation t(surface.bent);
  Network network(t);
  const auto points = FG::complete_polyline(t, locations(t, surface, {{1.3, 1.4}, {4.2, 1.7}, {6.1, 3.2}}));
  std::vector<FG::Surface_location> repeated;
  for(const FG::Surface_location& p : points)
    repeated.insert(repeated.end(), 2, p);
  const FG::Curve_index once = FG::draw_polyline(network, points), twice = FG::draw_polyline(network, repeated);
  BOOST_TEST(network.halfedges(once) == network.halfedges(twice), boost::test_tools::per_element());
}

// Points near one vertex, then near another, and back: the path turns there.
BOOST_AUTO_TEST_CASE(snapped_polylines_do_not_go_to_and_fro)
{
  const Bent_surface surface = surfaces().front(); // with a diagonal from (0, 0) to (1, 1)
  Triangulation t(surface.bent);
  const auto vertex = [](int i, int j) { return FG::Vertex_index(grid_vertex(size, i, j)); };
  using Path = std::vector<FG::Vertex_index>;
  const auto snapped = [&](const std::vector<Flat_point>& points, bool is_closed) {
    return FG::snap_polyline(t, locations(t, surface, points), CGAL::parameters::is_closed(is_closed));
  };
  BOOST_TEST(snapped({{2, 2}, {2.75, 2}, {2.25, 2}, {2.25, 2.25}, {2, 2.75}}, false) ==
                 (Path{vertex(2, 2), vertex(2, 3)}),
             boost::test_tools::per_element());
  // The last point of a closed one lies near the first.
  BOOST_TEST(snapped({{2, 2}, {3, 2}, {3, 3}, {2.25, 2.25}}, true) == (Path{vertex(2, 2), vertex(3, 2), vertex(3, 3)}),
             boost::test_tools::per_element());
  BOOST_TEST(snapped({{2.125, 2}, {2.25, 2}, {2.125, 2.125}}, true) == Path{vertex(2, 2)},
             boost::test_tools::per_element());
}

// A geodesic that crosses edges next to a vertex, closer than numbers tell there, passes the vertex.
BOOST_AUTO_TEST_CASE(completed_polylines_keep_away_from_vertices)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  Triangulation t(mesh);
  const auto vertex = [](int i, int j) { return Mesh::Vertex_index(static_cast<unsigned>(grid_vertex(2, i, j))); };
  const auto up = mesh.halfedge(vertex(1, 1), vertex(1, 2)), along = mesh.halfedge(vertex(0, 1), vertex(1, 1));
  const auto right = mesh.halfedge(vertex(1, 1), vertex(2, 1));
  int crossings = 0;
  for(double from : {1e-18, 1e-17, 1e-16, 3e-16})
    for(const auto to : {along, up, right}) {
      const FG::Surface_location start = {t.input().index(up), {{1, from, 0}}};
      const FG::Surface_location end = {t.input().index(mesh.next(mesh.opposite(to))), {{1, 1, 0}}};
      const auto polyline = FG::complete_polyline(t, {start, end});
      for(std::size_t i = 1; i + 1 < polyline.size(); ++i, ++crossings)
        for(double weight : polyline[i].weights)
          BOOST_TEST((weight == 0 || weight >= 1e-15));
    }
  BOOST_TEST(crossings > 0);
}

// Divides the segments on an edge, `t` of the way along h.
void divide(Network& network, FG::Halfedge_index h, double t)
{
  const auto point = FG::internal::point_on_edge(network.triangulation(), h, t);
  network.split_edge(h, point->location, point->gap);
}

BOOST_AUTO_TEST_CASE(segments_that_share_an_edge_are_divided)
{
  for(FG::Curve_index divided : {0_c, 1_c, 2_c}) {
    const Mesh mesh = to_mesh<Mesh>(flat_grid(3, 3, Diagonal_rule::RISING));
    Triangulation t(mesh);
    Network network(t);
    const auto there = FG::halfedges_through(t, std::vector<FG::Vertex_index>{5_v, 6_v});
    for(bool is_reversed : {false, true, false})
      network.add_curve(std::vector<FG::Halfedge_index>{is_reversed ? t.twin(there[0]) : there[0]});
    divide(network, network.halfedge(network.first_segment(divided)), 0.25);
    for(FG::Curve_index c : {0_c, 1_c, 2_c})
      BOOST_TEST(network.halfedges(c).size() == 2u);
    BOOST_TEST(std::abs(t.length(network.halfedge(network.first_segment(divided))) - 0.25) < 1e-15);
    BOOST_TEST(network.is_valid());
  }
}

BOOST_AUTO_TEST_CASE(a_loop_of_one_segment_is_divided)
{
  const Mesh mesh = to_mesh<Mesh>(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  Triangulation t(mesh);
  FG::Halfedge_index h = 0_h;
  while(!t.is_flippable(h))
    ++h;
  t.flip(h);
  BOOST_REQUIRE(t.tail(h) == t.head(h));
  Network network(t);
  const FG::Curve_index curve =
      network.add_curve(std::vector<FG::Halfedge_index>{h}, CGAL::parameters::is_closed(true));
  const double length = network.length(curve);
  divide(network, h, 0.3);
  const FG::Segment_index half = network.first_segment(curve);
  BOOST_TEST(network.halfedges(curve).size() == 2u);
  BOOST_TEST(network.next(network.next(half)) == half);
  BOOST_TEST(network.previous(half) == network.next(half));
  BOOST_TEST(std::abs(network.length(curve) - length) < 1e-12);
  BOOST_TEST(network.is_valid());
}

// The middle of an edge that crosses another one in its middle is a point beside that, inside a face.
BOOST_AUTO_TEST_CASE(a_division_on_a_crossed_edge_lies_inside_a_face)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(1, 1, Diagonal_rule::RISING));
  Triangulation t(mesh);
  FG::Halfedge_index h = 0_h;
  while(!t.is_flippable(h))
    ++h;
  t.flip(h);
  BOOST_TEST((kind(FG::location_on_edge(t, h, 0.5)) == FG::Location_kind::FACE));
  Network network(t);
  network.add_curve(std::vector<FG::Halfedge_index>{h});
  divide(network, h, 0.5);
  const FG::Surface_location middle = t.location(t.head(network.halfedge(network.first_segment(0_c))));
  BOOST_TEST((kind(middle) == FG::Location_kind::FACE));
  BOOST_TEST(network.is_valid());
}

// The second leg runs back over the first one, which it then leaves to its left or to its right.
BOOST_AUTO_TEST_CASE(legs_over_one_another_are_put_in_order)
{
  const Bent_surface surface = surfaces().front();
  int out_of_order = 0;
  for(double side : {1.0, 7.0}) {
    Triangulation t(surface.bent);
    Network network(t);
    FG::add_curve_through(network, locations(t, surface, {{1, 4}, {6, 4}, {3, 4}, {3, side}}));
    out_of_order += network.is_valid() ? 0 : 1;
    FG::order_overlapping_curves(network);
    BOOST_TEST(network.is_valid());
  }
  BOOST_TEST(out_of_order == 1);
}
