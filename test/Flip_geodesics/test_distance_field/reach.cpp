// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How far a field goes.

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(limits_of_a_field)
{
  std::mt19937 random(2);
  const Asked_surface s(bumpy_sphere(12, 0.2, 9));
  Field whole(s.triangulation, s.mesh);
  whole.add_source(5_v);
  const auto all = whole.compute();
  Field field(s.triangulation, s.mesh);
  field.add_source(5_v);
  FG::Distance_field_limits limits;
  limits.radius = 0.7;
  const auto near = field.compute(CGAL::parameters::search_limit(limits));
  BOOST_TEST((near.status == FG::Distance_field_status::RADIUS_REACHED));
  BOOST_TEST(near.windows < all.windows / 2);
  for(int i = 0; i < 500; ++i) {
    const Location at = s.random_location(random);
    if(whole.distance(at) <= field.reach())
      BOOST_TEST(std::abs(whole.distance(at) - field.distance(at)) < 1e-12);
    else
      BOOST_TEST(field.distance(at) == infinity);
  }
  BOOST_TEST(field.reach() >= limits.radius);
  const Location in_face{s.triangulation.input().outgoing(20_v), {{1, 2, 3}}};
  for(const double radius : {10.0, infinity})
    for(const bool is_vertex_last : {false, true}) {
      Field some(s.triangulation, s.mesh);
      some.add_source(5_v);
      limits.radius = radius;
      limits.targets = {s.vertex(0), in_face};
      if(is_vertex_last)
        std::swap(limits.targets[0], limits.targets[1]);
      const auto targets = some.compute(CGAL::parameters::search_limit(limits));
      BOOST_TEST((targets.status == FG::Distance_field_status::TARGETS_REACHED));
      for(const Location& target : limits.targets)
        BOOST_TEST(std::abs(whole.distance(target) - some.distance(target)) < 1e-12);
    }
  limits.radius = infinity;
  field.compute(CGAL::parameters::search_limit(limits));
  limits.targets.clear();
  limits.windows = FG::Window_limit(10);
  Field small(s.triangulation, s.mesh);
  small.add_source(5_v);
  BOOST_TEST((small.compute(CGAL::parameters::search_limit(limits)).status ==
              FG::Distance_field_status::WINDOW_LIMIT_REACHED));
  limits.windows = FG::Window_limit();
  BOOST_TEST((small.compute(CGAL::parameters::search_limit(limits)).status == FG::Distance_field_status::COMPLETE));
  for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
    BOOST_TEST(small.distance(v) == whole.distance(v));
    BOOST_TEST((field.distance(v) == infinity || std::abs(field.distance(v) - whole.distance(v)) < 1e-12));
  }
}

// Each distance up to the reach is known, wherever the front stands.
BOOST_AUTO_TEST_CASE(growing_radii)
{
  std::mt19937 random(31);
  const Mesh_soup rough = mapped(flat_grid(8, 8, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    return Coordinates{p[0], p[1], static_cast<double>(random() % 1000) / 400};
  });
  for(const Mesh_soup& soup : {bumpy_sphere(6, 0.4, 9), flat_grid(8, 8, Diagonal_rule::RANDOM), cube(3), rough}) {
    const Asked_surface s(soup);
    const Location source = s.random_location(random), other = s.random_location(random);
    const std::vector<Location> curve = {{source.halfedge, {{5, 1, 1}}}, {source.halfedge, {{1, 2, 4}}}};
    Field whole(s.triangulation, s.mesh), field(s.triangulation, s.mesh);
    double largest = 0;
    for(Field* f : {&whole, &field}) {
      f->add_curve(curve, 0.1);
      f->add_source(other, 0.2);
    }
    whole.compute();
    for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices()))
      largest = (std::max)(largest, whole.distance(v));
    std::vector<Location> places;
    for(int k = 0; k < 1000; ++k)
      places.push_back(s.random_location(random));
    std::vector<double> distances;
    for(const Location& at : places)
      distances.push_back(whole.distance(at));
    for(int i = 1; i < 100; ++i) {
      FG::Distance_field_limits limits;
      limits.radius = largest * i / 100;
      field.compute(CGAL::parameters::search_limit(limits));
      for(std::size_t k = 0; k < places.size(); ++k)
        if(distances[k] <= field.reach() && distances[k] > field.reach() - 0.2 * largest)
          BOOST_TEST(std::abs(distances[k] - field.distance(places[k])) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reached_is_infinite)
{
  Mesh_soup soup = with_isolated_vertices(cube(2), 0, 1);
  const int n = static_cast<int>(soup.points.size());
  const Mesh_soup far = tetrahedron();
  for(const auto& p : far.points)
    soup.points.push_back({p[0] + 10, p[1], p[2]});
  for(const auto& t : far.triangles)
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const Asked_surface s(soup);
  Field field(s.triangulation, s.mesh);
  field.add_source(0_v);
  BOOST_TEST((field.compute().status == FG::Distance_field_status::COMPLETE));
  Field from_nowhere(s.triangulation, s.mesh);
  from_nowhere.add_source(Vertex_index(n - 1), 0.5);
  BOOST_TEST((from_nowhere.compute().status == FG::Distance_field_status::COMPLETE));
  BOOST_TEST(from_nowhere.distance(Vertex_index(n - 1)) == 0.5);
  BOOST_TEST(from_nowhere.distance(0_v) == infinity);
  BOOST_TEST(field.distance(Vertex_index(n)) == infinity);
  BOOST_TEST(field.distance(Vertex_index(n - 1)) == infinity);
  BOOST_TEST(field.surface_points(s.vertex(n)).empty());
  const Location in_face{s.triangulation.input().outgoing(Vertex_index(n)), {{1, 1, 1}}};
  BOOST_TEST(field.distance(in_face) == infinity);
  BOOST_TEST(field.gradient(in_face)[0] == 0);
}
