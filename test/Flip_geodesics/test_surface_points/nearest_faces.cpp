// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Nearest faces of many points in space: bitwise those of a linear search, with far fewer faces.

#include "test_surface_points/inserted_points.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/insert_curves.h>

#include <random>

using namespace Flip_geodesics_test;

namespace {

using Place = FG::internal::Place_in_space;
using Face = Mesh::Face_index;

struct Counted_corners
{
  const Mesh* mesh;
  std::size_t* calls;

  FG::internal::Triangle_places operator()(Face f) const
  {
    ++*calls;
    FG::internal::Triangle_places result;
    auto h = mesh->halfedge(f);
    for(Place& p : result) {
      p = FG::internal::half_of(mesh->point(mesh->source(h)));
      h = mesh->next(h);
    }
    return result;
  }
};

using Nearest_face = FG::internal::Nearest_face<Mesh, Counted_corners>;

Nearest_face::Result by_linear_search(const Mesh& mesh, const Counted_corners& corners, const Place& p)
{
  Nearest_face::Result result;
  for(Face f : mesh.faces()) {
    FG::internal::Triangle_places seen = corners(f);
    for(Place& corner : seen)
      corner = {{corner[0] - p[0], corner[1] - p[1], corner[2] - p[2]}};
    const FG::internal::Nearest_weights here = FG::internal::nearest_weights(seen);
    if(here.distance < result.nearest.distance)
      result = {f, here};
  }
  return result;
}

// Points on vertices, on middles of edges and of faces, where several faces are equally near; close to them, and far.
std::vector<Place> places_around(const Mesh& mesh, std::size_t number)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Place> result;
  for(std::size_t i = 0; i < number; ++i) {
    const auto h = mesh.halfedge(Face(static_cast<unsigned>(random() % mesh.number_of_faces())));
    const Place a = FG::internal::half_of(mesh.point(mesh.source(h))),
                b = FG::internal::half_of(mesh.point(mesh.target(h))),
                c = FG::internal::half_of(mesh.point(mesh.target(mesh.next(h))));
    const double scale = std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
    const double away = std::array<double, 6>{{0, 0, 0, 1e-9, 0.1, 1e3}}[random() % 6] * scale;
    const double at_b = (random() % 3) / 2., at_c = at_b < 1 ? (random() % 2) / 2. : 0;
    Place p;
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = a[k] + at_b * (b[k] - a[k]) + at_c * (c[k] - a[k]) + away * coordinate(random);
    result.push_back(p);
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(nearest_faces_of_many_points_are_those_of_a_linear_search)
{
  for(double size : {1e-200, 1., 1e150})
    for(const Mesh_soup& soup : {flat_grid(12, 12, Diagonal_rule::RISING), cube(4), torus(24, 12, 2, 1),
                                 needle_strip(20, 3, 1e6), bumpy_sphere(6, 0.3, 1), lantern(10, 10)})
    {
      const Mesh mesh = to_mesh<Mesh>(scaled(soup, size));
      std::size_t calls = 0, ties = 0;
      const Counted_corners corners{&mesh, &calls};
      Nearest_face nearest(mesh, corners);
      for(const Place& p : places_around(mesh, 700 * scale)) {
        const auto expected = by_linear_search(mesh, corners, p), found = nearest(p);
        BOOST_REQUIRE_EQUAL(found.face, expected.face);
        BOOST_REQUIRE(found.nearest.weights == expected.nearest.weights);
        BOOST_REQUIRE_EQUAL(found.distance(), expected.distance());
        ties += *std::max_element(found.nearest.weights.begin(), found.nearest.weights.end()) == 1;
      }
      BOOST_TEST(ties > 10u);
    }
}

BOOST_AUTO_TEST_CASE(faces_in_one_place_are_found_there)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Face first(static_cast<unsigned>(mesh.number_of_faces()));
  const Point place(7, 8, 9);
  for(int i = 0; i < 40; ++i)
    mesh.add_face(mesh.add_vertex(place), mesh.add_vertex(place), mesh.add_vertex(place));
  std::size_t calls = 0;
  Nearest_face nearest(mesh, {&mesh, &calls});
  for(int i = 0; i < 8; ++i) { // without a tree and with it
    const auto found = nearest(FG::internal::half_of(place)), near = nearest({{3, 4, 5}});
    BOOST_TEST(found.face == first);
    BOOST_TEST(found.distance() == 0.0);
    BOOST_TEST(near.face == first);
    BOOST_TEST(std::abs(near.distance() - std::sqrt(0.5)) < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(few_faces_are_compared_with_each_of_many_points)
{
  const Mesh mesh = to_mesh<Mesh>(torus(80, 40, 2, 1));
  std::size_t calls = 0;
  Nearest_face nearest(mesh, {&mesh, &calls});
  const std::vector<Place> places = places_around(mesh, 2000);
  for(const Place& p : places)
    if(FG::internal::dot(p, p) < 9)
      nearest(p);
  BOOST_TEST(calls < 5 * mesh.number_of_faces() + 200 * places.size()); // a thirtieth of a linear search
}

BOOST_AUTO_TEST_CASE(many_points_in_space_are_located_like_each_of_them)
{
  Mesh mesh = to_mesh<Mesh>(bumpy_sphere(5, 0.3, 2));
  const Plain triangulation(mesh);
  std::vector<Point> points;
  std::vector<FG::Surface_location> locations;
  for(const Place& p : places_around(mesh, 40)) {
    points.push_back(Point(2 * p[0], 2 * p[1], 2 * p[2]));
    locations.push_back(FG::surface_location(triangulation, mesh, points.back()));
  }
  std::vector<double> from_points(mesh.number_of_vertices()), from_locations(mesh.number_of_vertices());
  FG::geodesic_distances(mesh, points, CGAL::make_property_map(from_points));
  FG::geodesic_distances(mesh, locations, CGAL::make_property_map(from_locations));
  BOOST_TEST(from_points == from_locations);

  std::vector<std::vector<Point>> in_space;
  std::vector<std::vector<std::pair<Face, std::array<double, 3>>>> in_faces;
  for(const FG::Surface_location& at : locations) { // curves that are points
    const auto location = FG::face_location(triangulation, mesh, FG::surface_point(triangulation, at));
    in_faces.push_back({{location.first, location.second}});
    in_space.push_back({FG::point_in_space(triangulation, FG::surface_point(triangulation, at))});
  }
  Mesh other = mesh;
  const auto by_points = FG::insert_curves(mesh, in_space), by_faces = FG::insert_curves(other, in_faces);
  BOOST_TEST(by_points.new_vertices == by_faces.new_vertices);
  BOOST_TEST(by_points.new_vertices > 20u);
}

// Beside a side that is longer than others by more than the range of lengths, distances would underflow.
BOOST_AUTO_TEST_CASE(points_in_space_are_not_located_beside_sides_out_of_range)
{
  for(const double far : {1e145, 1e180, 1e300}) {
    Mesh mesh = to_mesh<Mesh>(cube(3));
    mesh.point(Mesh::Vertex_index(10)) = Point(far, 0.7, 0.7);
    const Plain triangulation(mesh);
    BOOST_CHECK_THROW(FG::surface_location(triangulation, mesh, Point(0.2, 0.3, 0)), FG::Invalid_coordinate_error);
  }
}
