// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the one-call functions take and give: ends of each kind, outputs of each form in step with one another, metrics,
// visitors, meshes without points of their own, and results in property maps.

#define BOOST_TEST_MODULE one_call

#include "Curve_setting.h"
#include "Mesh_archetype.h"
#include "Policy_archetypes.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Face = Surface::Face_index;
using Point = Surface::Point;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Face_location = std::pair<Face, std::array<double, 3>>;
using Curve_point = FG::Curve_point<Surface, Point>;

namespace {

Surface bumpy_sphere_mesh() { return to_mesh<Surface>(bumpy_sphere(6, 0.3, 7)); }
Surface torus_mesh() { return to_mesh<Surface>(torus(24, 14, 2, 1)); }

std::vector<std::pair<Vertex, Vertex>> random_pairs(const Surface& mesh, int count)
{
  std::mt19937 random(5);
  std::vector<std::pair<Vertex, Vertex>> result;
  while(result.size() < static_cast<std::size_t>(count)) {
    const Vertex v(random() % mesh.number_of_vertices()), w(random() % mesh.number_of_vertices());
    if(v != w)
      result.emplace_back(v, w);
  }
  return result;
}

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }
double distance(const Vector& u, const Vector& v) { return std::sqrt((u - v).squared_length()); }

// The point of a face location, from the convention of Polygon Mesh Processing.
Point point_at(const Surface& mesh, const Face_location& location)
{
  const Halfedge h = mesh.halfedge(location.first);
  const std::array<Vertex, 3> corners = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
  Vector result(0, 0, 0);
  for(std::size_t i = 0; i < 3; ++i)
    result = result + location.second[i] * (mesh.point(corners[i]) - CGAL::ORIGIN);
  return CGAL::ORIGIN + result;
}

// Is a location's point one of a face, whichever face it is given in?
bool is_on_face(const Surface& mesh, const Face_location& location, Face f)
{
  const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
  Halfedge h = mesh.halfedge(location.first);
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    if(location.second[i] != 0 && std::find(corners.begin(), corners.end(), mesh.source(h)) == corners.end())
      return false;
  return true;
}

// Places, halfedges and tangents of a curve belong to its points.
void check_curve_points(const Surface& mesh, const std::vector<Curve_point>& curve)
{
  BOOST_REQUIRE_GE(curve.size(), 2u);
  for(std::size_t i = 0; i < curve.size(); ++i) {
    const Curve_point& p = curve[i];
    BOOST_CHECK_SMALL(distance(point_at(mesh, p.location), p.point), 1e-12);
    BOOST_CHECK_CLOSE(p.tangent.squared_length(), 1., 1e-9);
    const Curve_point& from = curve[i + 1 < curve.size() ? i : i - 1];
    const Point& to = curve[i + 1 < curve.size() ? i + 1 : i].point;
    if(distance(from.point, to) > 1e-6)
      BOOST_CHECK_SMALL(distance((to - from.point) / distance(from.point, to), p.tangent), 1e-8);
    if(i > 0 && i + 1 < curve.size() && p.halfedge != Surface::null_halfedge()) { // it leaves the halfedge's face
      BOOST_CHECK(is_on_face(mesh, curve[i - 1].location, mesh.face(p.halfedge)));
      BOOST_CHECK(is_on_face(mesh, curve[i + 1].location, mesh.face(mesh.opposite(p.halfedge))));
      const double side = distance(mesh.point(mesh.source(p.halfedge)), mesh.point(mesh.target(p.halfedge)));
      BOOST_CHECK_SMALL(distance(mesh.point(mesh.source(p.halfedge)), p.point) +
                            distance(p.point, mesh.point(mesh.target(p.halfedge))) - side,
                        1e-12);
    }
  }
}

void check_same_points(const std::vector<Point>& points, const std::vector<Curve_point>& curve)
{
  BOOST_REQUIRE_EQUAL(points.size(), curve.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_CHECK_EQUAL(points[i], curve[i].point);
}

void check_same_places(const std::vector<Face_location>& places, const std::vector<Curve_point>& curve)
{
  BOOST_REQUIRE_EQUAL(places.size(), curve.size());
  for(std::size_t i = 0; i < places.size(); ++i)
    BOOST_CHECK(places[i] == curve[i].location);
}

// Counts what it sees. It can be copied, so that a count stays zero unless it is passed by reference.
struct Counting_visitor : FG::Default_shortening_visitor
{
  std::size_t flips = 0;
  std::size_t* shared = nullptr;

  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index)
  {
    ++flips;
    if(shared)
      ++*shared;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(all_forms_of_a_path_are_in_step)
{
  for(const Surface& mesh : {bumpy_sphere_mesh(), torus_mesh()})
    for(const auto& [v, w] : random_pairs(mesh, 20)) {
      std::vector<Point> points;
      std::vector<Face_location> places;
      std::vector<Curve_point> curve;
      const auto in_space = FG::geodesic_path(mesh, v, w, std::back_inserter(points));
      const auto in_faces = FG::geodesic_path(mesh, v, w, std::back_inserter(places));
      const auto with_all = FG::geodesic_path(mesh, v, w, std::back_inserter(curve));
      check_same_points(points, curve);
      check_same_places(places, curve);
      check_curve_points(mesh, curve);
      BOOST_CHECK_EQUAL(points.front(), mesh.point(v));
      BOOST_CHECK_EQUAL(points.back(), mesh.point(w));
      double length = 0;
      for(std::size_t i = 0; i + 1 < points.size(); ++i)
        length += distance(points[i], points[i + 1]);
      BOOST_CHECK_CLOSE(in_space.length(), length, 1e-9);
      BOOST_CHECK_EQUAL(in_space.length(), in_space.report.curves.at(0).length);
      BOOST_CHECK_EQUAL(in_faces.length(), in_space.length());
      BOOST_CHECK_EQUAL(with_all.length(), in_space.length());
      BOOST_CHECK(with_all.status() == FG::Shortening_status::LOCALLY_SHORTEST);
    }
}

BOOST_AUTO_TEST_CASE(a_loop_and_curves_come_in_each_form)
{
  const Surface mesh = torus_mesh();
  std::vector<Vertex> ring;
  for(std::size_t i = 0; i < 24; ++i)
    ring.emplace_back(i);
  bool is_ring = true;
  for(std::size_t i = 0; i < ring.size(); ++i)
    is_ring = is_ring && mesh.halfedge(ring[i], ring[(i + 1) % ring.size()]) != Surface::null_halfedge();
  BOOST_REQUIRE(is_ring);
  std::vector<Curve_point> loop;
  std::vector<Point> points;
  FG::geodesic_loop(mesh, ring, std::back_inserter(loop), FG::Iteration_stop_predicate(3));
  FG::geodesic_loop(mesh, ring, std::back_inserter(points), FG::Iteration_stop_predicate(3));
  check_same_points(points, loop);
  check_curve_points(mesh, loop);
  BOOST_CHECK_EQUAL(loop.front().point, loop.back().point);

  std::vector<std::vector<Curve_point>> curves;
  std::vector<std::vector<Face_location>> places;
  std::vector<Vertex> closed = ring;
  closed.push_back(ring.front());
  const auto result = FG::straighten(mesh, std::vector<std::vector<Vertex>>{closed, {ring[0], ring[1], ring[2]}},
                                     std::back_inserter(curves));
  FG::straighten(mesh, std::vector<std::vector<Vertex>>{closed, {ring[0], ring[1], ring[2]}},
                 std::back_inserter(places));
  BOOST_REQUIRE_EQUAL(curves.size(), 2u);
  BOOST_REQUIRE_EQUAL(result.report.curves.size(), 2u);
  for(std::size_t i = 0; i < 2; ++i) {
    check_same_places(places[i], curves[i]);
    if(!curves[i].empty())
      check_curve_points(mesh, curves[i]);
  }
}

BOOST_AUTO_TEST_CASE(ends_of_all_kinds_can_be_mixed)
{
  const Surface mesh = bumpy_sphere_mesh();
  const Vertex v(3);
  const Face f(40);
  const Face_location inside(f, {{0.25, 0.5, 0.25}});
  const Point above = point_at(mesh, inside) + Vector(CGAL::ORIGIN, point_at(mesh, inside)) * 1e-9;
  Curve_setting::Triangulation triangulation(mesh);
  const FG::Surface_location location = FG::surface_location(triangulation, mesh, inside);
  std::vector<Curve_point> to_face, to_location, to_space, back;
  const auto reference = FG::geodesic_path(mesh, v, inside, std::back_inserter(to_face));
  FG::geodesic_path(mesh, v, location, std::back_inserter(to_location));
  FG::geodesic_path(mesh, v, above, std::back_inserter(to_space), CGAL::parameters::default_values());
  FG::geodesic_path(mesh, above, v, std::back_inserter(back), FG::Never_stop_predicate());
  check_curve_points(mesh, to_face);
  check_curve_points(mesh, back);
  BOOST_CHECK_SMALL(distance(to_face.back().point, point_at(mesh, inside)), 1e-12);
  BOOST_REQUIRE_EQUAL(to_face.size(), to_location.size());
  BOOST_REQUIRE_EQUAL(to_face.size(), to_space.size());
  BOOST_REQUIRE_EQUAL(to_face.size(), back.size());
  for(std::size_t i = 0; i < to_face.size(); ++i) {
    BOOST_CHECK_EQUAL(to_face[i].point, to_location[i].point);
    BOOST_CHECK_SMALL(distance(to_face[i].point, to_space[i].point), 1e-7);
    BOOST_CHECK_SMALL(distance(to_face[i].point, back[back.size() - 1 - i].point), 1e-7);
  }
  double length = 0;
  for(std::size_t i = 0; i + 1 < to_face.size(); ++i)
    length += distance(to_face[i].point, to_face[i + 1].point);
  BOOST_CHECK_CLOSE(reference.length(), length, 1e-9);
}

BOOST_AUTO_TEST_CASE(ways_through_points_have_tangents_on_each_leg)
{
  const Surface mesh = torus_mesh();
  const std::vector<Face_location> stations = {
      {Face(3), {{0.2, 0.3, 0.5}}}, {Face(200), {{0.4, 0.3, 0.3}}}, {Face(400), {{0.1, 0.1, 0.8}}}};
  std::vector<Curve_point> curve;
  std::vector<Point> points;
  FG::geodesic_path_through(mesh, stations, std::back_inserter(curve));
  FG::geodesic_path_through(mesh, stations, std::back_inserter(points));
  check_same_points(points, curve);
  check_curve_points(mesh, curve);
  std::size_t met = 0;
  for(const Curve_point& p : curve)
    for(const Face_location& station : stations)
      if(distance(p.point, point_at(mesh, station)) < 1e-12)
        ++met;
  BOOST_CHECK_EQUAL(met, stations.size());
  std::vector<Curve_point> spline;
  FG::geodesic_spline(mesh, stations, FG::Spline_kind::BEZIER, std::back_inserter(spline));
  check_curve_points(mesh, spline);
}

BOOST_AUTO_TEST_CASE(points_in_space_meet_the_nearest_point)
{
  const Surface mesh = torus_mesh();
  Curve_setting::Triangulation triangulation(mesh);
  for(Vertex v : mesh.vertices())
    BOOST_CHECK_EQUAL(triangulation.insert(FG::surface_location(triangulation, mesh, mesh.point(v))),
                      triangulation.index(v));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(FG::surface_location(triangulation, mesh, Point(0, nan, 0)), FG::Invalid_location_error);
  Surface empty;
  empty.add_vertex(Point(0, 0, 0));
  Curve_setting::Triangulation nothing(empty);
  BOOST_CHECK_THROW(FG::surface_location(nothing, empty, Point(0, 0, 0)), FG::Invalid_location_error);
  Surface broken = mesh;
  broken.point(Vertex(5)) = Point(nan, 0, 0);
  Curve_setting::Triangulation over_broken(broken);
  BOOST_CHECK_THROW(FG::surface_location(over_broken, broken, Point(0, 0, 0)), FG::Invalid_coordinate_error);
  std::vector<Point> points;
  BOOST_CHECK_THROW(FG::geodesic_path(mesh, Vertex(0), Point(nan, 0, 0), std::back_inserter(points)),
                    FG::Invalid_location_error);
  BOOST_CHECK(points.empty());
}

BOOST_AUTO_TEST_CASE(the_nearest_point_is_nearest)
{
  const Surface mesh = bumpy_sphere_mesh();
  Curve_setting::Triangulation triangulation(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-2, 2), weight(0, 1);
  for(int i = 0; i < 100; ++i) {
    const Point p(coordinate(random), coordinate(random), coordinate(random));
    const FG::Surface_location location = FG::surface_location(triangulation, mesh, p);
    const double least = distance(p, FG::point_in_space(triangulation, FG::surface_point(triangulation, location)));
    for(Face f : mesh.faces()) { // random points of all faces, and the corners
      const Halfedge h = mesh.halfedge(f);
      const double a = weight(random), b = (1 - a) * weight(random);
      BOOST_CHECK_GE(distance(p, point_at(mesh, {f, {{a, b, 1 - a - b}}})), least * (1 - 1e-12));
      BOOST_CHECK_GE(distance(p, mesh.point(mesh.source(h))), least * (1 - 1e-12));
    }
  }
  for(Face f : mesh.faces()) { // a point above the middle of a face
    const Point middle = point_at(mesh, {f, {{1. / 3, 1. / 3, 1. / 3}}});
    const Halfedge h = mesh.halfedge(f);
    Vector normal = CGAL::cross_product(mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)),
                                        mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.source(h)));
    normal = normal / std::sqrt(normal.squared_length());
    const FG::Surface_location location = FG::surface_location(triangulation, mesh, middle + 1e-3 * normal);
    BOOST_CHECK(FG::kind(location) == FG::Location_kind::FACE);
    BOOST_CHECK_SMALL(distance(middle, FG::point_in_space(triangulation, FG::surface_point(triangulation, location))),
                      1e-12);
  }
}

BOOST_AUTO_TEST_CASE(points_near_faces_without_area_lie_on_others)
{
  Surface mesh; // a cap 0 1 2 of no area between faces
  for(const Coordinates& p : {Coordinates{{0, 0, 0}}, Coordinates{{2, 0, 0}}, Coordinates{{1, 0, 0}},
                              Coordinates{{1, 1, 0}}, Coordinates{{1, -1, 0}}})
    mesh.add_vertex(Point(p[0], p[1], p[2]));
  for(const std::array<unsigned, 3>& f : {std::array<unsigned, 3>{{0, 1, 2}}, std::array<unsigned, 3>{{0, 2, 3}},
                                          std::array<unsigned, 3>{{2, 1, 3}}, std::array<unsigned, 3>{{1, 0, 4}}})
    BOOST_REQUIRE(mesh.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2])) != Surface::null_face());
  std::vector<Point> points;
  const auto result = FG::geodesic_path(mesh, Point(0.5, 0, 0), Vertex(4), std::back_inserter(points));
  BOOST_CHECK_CLOSE(result.length(), std::sqrt(1.25), 1e-9);
  const auto inside = FG::geodesic_path(mesh, Point(1, 0.5, 0), Vertex(4), std::back_inserter(points));
  BOOST_CHECK_CLOSE(inside.length(), 1.5, 1e-9);
}

BOOST_AUTO_TEST_CASE(what_has_no_nearest_point_is_told)
{
  const auto says = [](const char* words) {
    return [words](const FG::Error& error) { return std::string(error.what()).find(words) != std::string::npos; };
  };
  const Surface mesh = torus_mesh();
  Curve_setting::Triangulation triangulation(mesh);
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_CHECK_EXCEPTION(FG::surface_location(triangulation, mesh, Point(infinity, 0, 0)), FG::Invalid_location_error,
                        says("no finite number"));
  Surface empty;
  empty.add_vertex(Point(0, 0, 0));
  Curve_setting::Triangulation nothing(empty);
  BOOST_CHECK_EXCEPTION(FG::surface_location(nothing, empty, Point(0, 0, 0)), FG::Invalid_location_error,
                        says("without faces"));
  Surface quad;
  const Vertex a = quad.add_vertex(Point(0, 0, 0)), b = quad.add_vertex(Point(1, 0, 0)),
               c = quad.add_vertex(Point(1, 1, 0)), d = quad.add_vertex(Point(0, 1, 0));
  quad.add_face(a, b, c, d);
  quad.add_face(quad.add_vertex(Point(5, 5, 0)), quad.add_vertex(Point(6, 5, 0)), quad.add_vertex(Point(5, 6, 0)));
  Curve_setting::Triangulation over_quad(quad);
  BOOST_CHECK_THROW(FG::surface_location(over_quad, quad, Point(5.1, 5.2, 0)), FG::Invalid_mesh_error);
  Surface collapsed;
  collapsed.add_face(collapsed.add_vertex(Point(1, 1, 1)), collapsed.add_vertex(Point(1, 1, 1)),
                     collapsed.add_vertex(Point(1, 1, 1)));
  Curve_setting::Triangulation point(collapsed);
  BOOST_CHECK(FG::kind(FG::surface_location(point, collapsed, Point(1, 1, 1))) == FG::Location_kind::VERTEX);
}

BOOST_AUTO_TEST_CASE(a_curve_that_is_a_point_has_no_tangent)
{
  Mesh_soup soup = flat_grid(3, 3, Diagonal_rule::RISING);
  soup.points[6] = soup.points[5]; // two ends of an edge in one place
  const Surface mesh = to_mesh<Surface>(soup);
  const Halfedge h = mesh.halfedge(Vertex(5), Vertex(6));
  BOOST_REQUIRE(h != Surface::null_halfedge());
  const FG::Surface_location location = [&] {
    Curve_setting::Triangulation triangulation(mesh);
    return FG::surface_location(triangulation, mesh, Vertex(5));
  }();
  std::vector<Curve_point> curve;
  const auto result = FG::geodesic_path(mesh, location, Vertex(6), std::back_inserter(curve));
  BOOST_CHECK_EQUAL(result.length(), 0);
  BOOST_REQUIRE_EQUAL(curve.size(), 2u);
  for(const Curve_point& p : curve)
    BOOST_CHECK_EQUAL(p.tangent, Vector(0, 0, 0));
}

BOOST_AUTO_TEST_CASE(points_in_space_have_no_scale)
{
  for(double scale : {1e-150, 1e-100, 1e-30, 1., 1e30, 1e100, 1e150, 1e300}) {
    const Surface mesh = to_mesh<Surface>(scaled(torus(8, 6, 2, 1), scale));
    Curve_setting::Triangulation triangulation(mesh);
    const Point p = mesh.point(Vertex(11));
    BOOST_CHECK_EQUAL(triangulation.index(Vertex(11)),
                      triangulation.input().tail(FG::surface_location(triangulation, mesh, p).halfedge));
  }
}

BOOST_AUTO_TEST_CASE(ends_in_different_components_are_named_by_vertices_of_the_mesh)
{
  const Surface mesh = to_mesh<Surface>(disjoint_union(tetrahedron(), tetrahedron()));
  std::vector<Point> points;
  try {
    FG::geodesic_path(mesh, Vertex(0), Face_location(Face(6), {{0.2, 0.3, 0.5}}), std::back_inserter(points));
    BOOST_ERROR("no path joins them");
  } catch(const FG::Disconnected_endpoints_error& error) {
    BOOST_REQUIRE_EQUAL(error.elements().size(), 2u);
    BOOST_CHECK_EQUAL(error.elements()[0], 0u);
    BOOST_CHECK_LT(error.elements()[1], mesh.number_of_vertices());
    BOOST_CHECK_GE(error.elements()[1], mesh.number_of_vertices() / 2);
  }
}

BOOST_AUTO_TEST_CASE(splines_are_halved_a_number_of_times_that_makes_sense)
{
  const Surface mesh = torus_mesh();
  const std::vector<Vertex> controls = {Vertex(0), Vertex(30), Vertex(60)};
  std::vector<Point> points;
  for(int rounds : {-1, 31, std::numeric_limits<int>::max()})
    BOOST_CHECK_THROW(FG::geodesic_spline(mesh, controls, FG::Spline_kind::BEZIER, std::back_inserter(points),
                                          CGAL::parameters::number_of_iterations(rounds)),
                      FG::Invalid_curve_error);
  BOOST_CHECK(points.empty());
  FG::geodesic_spline(mesh, controls, FG::Spline_kind::BEZIER, std::back_inserter(points),
                      CGAL::parameters::number_of_iterations(0));
  BOOST_CHECK_GE(points.size(), 2u);
}

BOOST_AUTO_TEST_CASE(outputs_need_not_be_assigned)
{
  const Surface mesh = torus_mesh();
  std::size_t count = 0;
  const auto counting = boost::make_function_output_iterator([&count](const Point&) { ++count; });
  std::vector<Point> points;
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), counting);
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points));
  BOOST_CHECK_EQUAL(count, points.size());
}

BOOST_AUTO_TEST_CASE(the_first_vertex_of_a_loop_may_be_repeated)
{
  const Surface mesh = torus_mesh();
  std::vector<Vertex> ring;
  for(std::size_t i = 0; i < 24; ++i)
    ring.emplace_back(i);
  std::vector<Point> points, of_repeated;
  FG::geodesic_loop(mesh, ring, std::back_inserter(points));
  ring.push_back(ring.front());
  FG::geodesic_loop(mesh, ring, std::back_inserter(of_repeated));
  BOOST_CHECK(!points.empty());
  BOOST_CHECK(points == of_repeated);
}

BOOST_AUTO_TEST_CASE(another_metric_decides_what_is_short)
{
  Surface mesh = torus_mesh();
  auto lengths = mesh.add_property_map<Surface::Edge_index, double>("e:length", 0).first;
  for(Surface::Edge_index e : mesh.edges())
    lengths[e] = 3 * distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  const FG::Edge_length_metric<Surface, Surface::Property_map<Surface::Edge_index, double>> tripled(mesh, lengths);
  for(const auto& [v, w] : random_pairs(mesh, 10)) {
    std::vector<Face_location> places, places_of_points;
    std::vector<FG::Curve_place<Surface>> curve;
    const auto result = FG::geodesic_path(mesh, v, w, std::back_inserter(places), FG::with_metric(tripled));
    FG::geodesic_path(mesh, v, w, std::back_inserter(curve), FG::with_metric(tripled));
    const auto of_points = FG::geodesic_path(mesh, v, w, std::back_inserter(places_of_points));
    BOOST_REQUIRE_EQUAL(places.size(), curve.size());
    for(std::size_t i = 0; i < places.size(); ++i)
      BOOST_CHECK(places[i] == curve[i].location);
    if(places.size() == places_of_points.size()) // else another of several geodesics was found
      BOOST_CHECK_CLOSE(result.length(), 3 * of_points.length(), 1e-9);
    else
      BOOST_CHECK_LT(std::abs(result.length() - 3 * of_points.length()), 0.3 * result.length());
  }
}

BOOST_AUTO_TEST_CASE(points_of_a_map_and_a_mesh_without_any)
{
  const Mesh_soup soup = bumpy_sphere(4, 0.3, 7);
  const Surface mesh = to_mesh<Surface>(soup);
  const Mesh_archetype plain(soup);
  const Archetype_point_map map = {&plain};
  const std::vector<Mesh_archetype::Vertex> all(vertices(plain).begin(), vertices(plain).end());
  std::vector<Point> points, of_map;
  std::vector<FG::Curve_point<Mesh_archetype, Point>> curve;
  const auto np = CGAL::parameters::vertex_point_map(map);
  const auto direct = FG::geodesic_path(mesh, Vertex(1), Vertex(30), std::back_inserter(points));
  const auto result = FG::geodesic_path(plain, all[1], all[30], std::back_inserter(of_map), np);
  FG::geodesic_path(plain, all[1], all[30], std::back_inserter(curve), FG::Never_stop_predicate(), np);
  BOOST_CHECK_CLOSE(result.length(), direct.length(), 1e-9);
  BOOST_CHECK_EQUAL(of_map.size(), points.size());
  BOOST_CHECK_EQUAL(curve.size(), points.size());
}

BOOST_AUTO_TEST_CASE(visitors_are_copied_unless_they_are_referred_to)
{
  const Surface mesh = torus_mesh();
  std::vector<Point> points;
  Counting_visitor visitor;
  std::size_t shared = 0;
  visitor.shared = &shared;
  const auto copied =
      FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points), CGAL::parameters::visitor(visitor));
  BOOST_CHECK_GT(copied.report.flips, 0u);
  BOOST_CHECK_EQUAL(visitor.flips, 0u);
  BOOST_CHECK_EQUAL(shared, copied.report.flips);
  const auto referred = FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points),
                                          CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_CHECK_EQUAL(visitor.flips, referred.report.flips);
  BOOST_CHECK_EQUAL(referred.report.flips, copied.report.flips);
}

// A visitor that is counted each time it is copied.
struct Copied_visitor : FG::Default_shortening_visitor
{
  explicit Copied_visitor(int& copies)
    : copies(&copies)
  {
  }
  Copied_visitor(const Copied_visitor& other)
    : FG::Default_shortening_visitor(other)
    , copies(other.copies)
  {
    ++*copies;
  }
  Copied_visitor& operator=(const Copied_visitor&) = delete;

  int* copies;
};

BOOST_AUTO_TEST_CASE(a_visitor_is_copied_once)
{
  const Surface mesh = torus_mesh();
  std::vector<Point> points;
  int copies = 0;
  const auto np = CGAL::parameters::visitor(Copied_visitor(copies));
  copies = 0;
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(points), np);
  BOOST_CHECK_EQUAL(copies, 1);
}

// What has nothing but what the pages of stop predicates and visitors ask for, not even a copy, is enough.
BOOST_AUTO_TEST_CASE(least_policies_are_enough)
{
  const Surface mesh = torus_mesh();
  const Stop_predicate_archetype few(2), many(1000000);
  const std::vector<std::vector<Vertex>> curves = {{Vertex(0), Vertex(1), Vertex(25), Vertex(49), Vertex(50)},
                                                   {Vertex(80), Vertex(81), Vertex(105), Vertex(106), Vertex(130)}};
  const std::vector<Face_location> stations = {
      {Face(3), {{0.2, 0.3, 0.5}}}, {Face(200), {{0.4, 0.3, 0.3}}}, {Face(400), {{0.1, 0.1, 0.8}}}};
  std::vector<Vertex> ring;
  for(std::size_t i = 72; i < 96; ++i)
    ring.emplace_back(i); // beside the shortest ring

  // Calls `compute(output, stop, np)`, which shortens `runs` times, with both predicates, and compares with `expected`.
  const auto check = [&](const auto& expected, long runs, const auto& compute) {
    for(const Stop_predicate_archetype* stop : {&few, &many}) {
      auto result = expected;
      result.clear();
      Visitor_archetype visitor;
      const FG::Shortening_report report =
          compute(std::back_inserter(result), *stop, CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_CHECK_GT(visitor.questions(), 0);
      BOOST_CHECK_LE(report.flips, static_cast<std::size_t>(visitor.flips()));
      BOOST_CHECK_EQUAL(report.is_complete(), stop == &many);
      if(stop == &many)
        BOOST_CHECK(result == expected);
      else
        BOOST_CHECK_LE(visitor.steps(), 2 * runs);
    }
  };

  Counting_visitor counting; // so that nothing is straightened first
  std::vector<Point> path, loop, way;
  std::vector<std::vector<Point>> tight;
  FG::geodesic_path(mesh, Vertex(0), Vertex(150), std::back_inserter(path),
                    CGAL::parameters::visitor(std::ref(counting)));
  check(path, 1, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_path(mesh, Vertex(0), Vertex(150), out, stop, np).report;
  });
  FG::geodesic_loop(mesh, ring, std::back_inserter(loop));
  check(loop, 1, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_loop(mesh, ring, out, stop, np).report;
  });
  FG::straighten(mesh, curves, std::back_inserter(tight));
  check(tight, 1,
        [&](auto out, const auto& stop, const auto& np) { return FG::straighten(mesh, curves, out, stop, np).report; });
  FG::geodesic_path_through(mesh, stations, std::back_inserter(way));
  check(way, 2, [&](auto out, const auto& stop, const auto& np) {
    return FG::geodesic_path_through(mesh, stations, out, stop, np).report;
  });

  const std::vector<std::pair<Vertex, Vertex>> pairs = {{Vertex(0), Vertex(150)}, {Vertex(7), Vertex(200)}};
  for(const Stop_predicate_archetype* stop : {&few, &many}) {
    std::vector<FG::Geodesic_path<Point>> paths;
    Visitor_archetype visitor;
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), *stop, CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_REQUIRE_EQUAL(paths.size(), 2u);
    BOOST_CHECK_GT(visitor.questions(), 0);
    BOOST_CHECK_EQUAL(paths[0].points == path, stop == &many);
    BOOST_CHECK(!paths[1].points.empty());
  }

  Visitor_archetype visitor;
  const auto shortest = FG::shortest_path(mesh, Vertex(0), Vertex(150), CGAL::Emptyset_iterator(),
                                          CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_CHECK(shortest.report.is_confirmed());
  BOOST_CHECK_GT(visitor.questions(), 0);

  Curve_setting setting(torus(24, 14, 2, 1));
  setting.add_path(setting.triangulation.index(Vertex(0)), setting.triangulation.index(Vertex(150)));
  Visitor_archetype of_network;
  const FG::Shortening_report begun = FG::shorten(setting.network, few, of_network);
  BOOST_CHECK(begun.curves.front().status == FG::Shortening_status::ITERATION_LIMIT);
  BOOST_CHECK_EQUAL(of_network.steps(), 2);
  const FG::Shortening_report finished = FG::shorten(setting.network, many, of_network);
  BOOST_CHECK(finished.is_complete());
}

BOOST_AUTO_TEST_CASE(distances_come_in_maps_of_the_user)
{
  const Mesh_soup soup = with_isolated_vertices(torus(16, 10, 2, 1), 0, 1);
  Surface mesh = to_mesh<Surface>(soup);
  const Vertex source(7);
  auto distances = mesh.add_property_map<Vertex, double>("v:distance", -1).first;
  const auto report = FG::geodesic_distances(mesh, source, distances);
  BOOST_CHECK(report.is_confirmed);
  BOOST_CHECK_EQUAL(distances[source], 0);
  const Vertex isolated(mesh.number_of_vertices() - 1);
  for(Vertex v : mesh.vertices()) {
    if(v == isolated) {
      BOOST_CHECK_EQUAL(distances[v], std::numeric_limits<double>::infinity());
    } else if(v != source && v.idx() % 5 == 0) {
      const auto path = FG::shortest_path(mesh, source, v, CGAL::Emptyset_iterator());
      BOOST_CHECK_CLOSE(distances[v], path.length(), 1e-8);
    }
  }
  std::map<Vertex, FG::Polar_coordinates> polar;
  FG::polar_coordinates(mesh, source, boost::make_assoc_property_map(polar));
  for(Vertex v : mesh.vertices())
    if(v != isolated && v != source) {
      BOOST_CHECK_CLOSE(polar.at(v).radius, distances[v], 1e-8);
      BOOST_CHECK(polar.at(v).angle >= 0 && polar.at(v).angle <= 2 * CGAL_PI);
    }
}

BOOST_AUTO_TEST_CASE(distances_from_several_vertices_are_the_least)
{
  Surface mesh = bumpy_sphere_mesh();
  const std::vector<Vertex> sources = {Vertex(0), Vertex(9), Vertex(25), Vertex(9)};
  auto all = mesh.add_property_map<Vertex, double>("v:all", -1).first;
  const auto report = FG::geodesic_distances(mesh, sources, all);
  BOOST_CHECK(report.is_confirmed);
  BOOST_CHECK_EQUAL(report.vertices, mesh.number_of_vertices() - 3);
  std::vector<double> least(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(Vertex source : sources) {
    auto one = mesh.add_property_map<Vertex, double>("v:one", -1).first;
    FG::geodesic_distances(mesh, source, one);
    for(Vertex v : mesh.vertices())
      least[v] = (std::min)(least[v], one[v]);
  }
  for(Vertex v : mesh.vertices())
    BOOST_CHECK_SMALL(all[v] - least[v], 1e-12);
  BOOST_CHECK(!FG::geodesic_distances(mesh, sources, all, FG::Window_limit(1)).is_confirmed);
  FG::geodesic_distances(mesh, std::vector<Vertex>(), all);
  BOOST_CHECK_EQUAL(all[Vertex(0)], std::numeric_limits<double>::infinity());
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, {Vertex(0), Surface::null_vertex()}, all),
                    FG::Vertex_out_of_range_error);
}

BOOST_AUTO_TEST_CASE(distances_on_another_mesh_type_are_the_same)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>, CGAL::Polyhedron_items_with_id_3>;
  const Mesh_soup soup = bumpy_sphere(3, 0.3, 7);
  Surface mesh = to_mesh<Surface>(soup);
  const Polyhedron polyhedron = to_mesh<Polyhedron>(soup);
  auto expected = mesh.add_property_map<Vertex, double>("v:distance", -1).first;
  FG::geodesic_distances(mesh, Vertex(0), expected);
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, double> distances;
  FG::geodesic_distances(polyhedron, *vertices(polyhedron).first, boost::make_assoc_property_map(distances));
  BOOST_CHECK_EQUAL(distances.size(), mesh.number_of_vertices());
  std::size_t i = 0;
  for(auto v : CGAL::make_range(vertices(polyhedron)))
    BOOST_CHECK_CLOSE(distances.at(v) + 1, expected[Vertex(i++)] + 1, 1e-9);
}

BOOST_AUTO_TEST_CASE(limits_and_wrong_sources_of_distances)
{
  Surface mesh = bumpy_sphere_mesh();
  auto distances = mesh.add_property_map<Vertex, double>("v:distance", -1).first;
  auto limited = mesh.add_property_map<Vertex, double>("v:limited", -1).first;
  FG::geodesic_distances(mesh, Vertex(0), distances);
  const auto report = FG::geodesic_distances(mesh, Vertex(0), limited, FG::Window_limit(1));
  BOOST_CHECK(!report.is_confirmed);
  for(Vertex v : mesh.vertices()) // those of geodesics that need not be shortest
    BOOST_CHECK_GE(limited[v], distances[v] * (1 - 1e-10));
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, Vertex(mesh.number_of_vertices()), distances),
                    FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(FG::polar_coordinates(mesh, Surface::null_vertex(), boost::dummy_property_map()),
                    FG::Vertex_out_of_range_error);
}
