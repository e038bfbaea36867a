// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Ends of curves that are points in space.

#include "test_one_call/checked_curves.h"

using namespace Flip_geodesics_test;

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
                        says("not a finite number"));
  Surface empty;
  empty.add_vertex(Point(0, 0, 0));
  Curve_setting::Triangulation nothing(empty);
  BOOST_CHECK_EXCEPTION(FG::surface_location(nothing, empty, Point(0, 0, 0)), FG::Invalid_location_error,
                        says("no faces"));
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
