// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances that are known at vertices only, and meshes of other types.

#include "test_isolines/closed_field.h"

using namespace Flip_geodesics_test;

// With points of its own for a mesh that has none, and a field that is linear in faces.
BOOST_AUTO_TEST_CASE(interpolated_distances)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(5, 5, Diagonal_rule::ALTERNATING));
  using Map = std::map<Mesh::Vertex_index, double>;
  std::vector<Map> distances(2);
  for(const auto v : mesh.vertices()) {
    distances[0][v] = mesh.point(v).x();
    distances[1][v] = 5.5 - mesh.point(v).x();
  }
  using Pmap = boost::const_associative_property_map<Map>;
  const FG::Interpolated_distances<Mesh, Pmap> field(mesh, {Pmap(distances[0]), Pmap(distances[1])});
  const auto curves = isolines(mesh, field, std::vector<double>{1, 2.25}, 0.2);
  BOOST_TEST_REQUIRE(curves.size() == 4u);
  for(const Isoline& isoline : curves) {
    check_polyline(mesh, isoline);
    BOOST_TEST(std::abs(length(isoline) - 5) < 1e-12);
  }
  const auto middle = boundaries(mesh, field, 0.2);
  BOOST_TEST_REQUIRE(middle.size() == 1u);
  BOOST_TEST(std::abs(length(middle[0]) - 5) < 1e-11);
  BOOST_TEST(std::abs(middle[0].points.front().x() - 2.75) < 1e-12);
}

BOOST_AUTO_TEST_CASE(interpolated_infinities_and_ties)
{
  const Mesh mesh = to_mesh<Mesh>(single_triangle());
  using Map = std::map<Mesh::Vertex_index, double>;
  using Pmap = boost::const_associative_property_map<Map>;
  const Mesh::Vertex_index a(0), b(1), c(2);
  const Map first = {{a, 1}, {b, infinity}, {c, 3}}, second = {{a, 1}, {b, 5}, {c, 2}},
            broken = {{a, std::numeric_limits<double>::quiet_NaN()}, {b, 5}, {c, 2}};
  const FG::Interpolated_distances<Mesh, Pmap> field(mesh, {Pmap(first), Pmap(second)}), alone(mesh, {Pmap(first)});
  const Mesh::Face_index f(0);
  std::array<double, 3> at_a = {0, 0, 0}, at_b = {0, 0, 0}, between_a_and_c = {0.5, 0.5, 0.5};
  Mesh::Halfedge_index h = mesh.halfedge(f);
  for(int i = 0; i < 3; ++i, h = mesh.next(h)) {
    at_a[i] = mesh.source(h) == a ? 1 : 0;
    at_b[i] = mesh.source(h) == b ? 1 : 0;
    between_a_and_c[i] = mesh.source(h) == b ? 0 : 0.5;
  }
  BOOST_TEST(field(f, at_a).distance == 1);
  BOOST_TEST(field(f, at_a).source == 0u);
  BOOST_TEST(field(f, at_b).distance == 5);
  BOOST_TEST(field(f, at_b).source == 1u);
  BOOST_TEST(field(f, between_a_and_c).distance == 1.5);
  BOOST_TEST(alone(f, at_b).distance == infinity);
  BOOST_TEST(alone(f, between_a_and_c).distance == 2);
  for(const std::vector<Pmap>& maps :
      {std::vector<Pmap>{Pmap(broken)}, {Pmap(broken), Pmap(second)}, {Pmap(second), Pmap(broken)}})
  {
    const FG::Interpolated_distances<Mesh, Pmap> damaged(mesh, maps);
    BOOST_TEST(std::isnan(damaged(f, at_a).distance));
    BOOST_CHECK_THROW(isolines(mesh, damaged, std::vector<double>{1}, 0.1), FG::Invalid_parameter_error);
  }
}

BOOST_AUTO_TEST_CASE(any_mesh_with_points_of_its_own)
{
  const Mesh_archetype mesh(flat_grid(3, 3, Diagonal_rule::RISING));
  const Archetype_point_map points = {&mesh};
  const auto field = [&](Mesh_archetype::Face f, const std::array<double, 3>& w) {
    Coordinates p = {0, 0, 0};
    auto h = halfedge(f, mesh);
    for(int i = 0; i < 3; ++i, h = next(h, mesh))
      for(int d = 0; d < 3; ++d)
        p[d] += w[i] * get(points, source(h, mesh))[d];
    return Answer{std::hypot(p[0] - 1.4, p[1] - 1.7), 0};
  };
  std::vector<FG::Isoline<Mesh_archetype, Mesh_archetype::Point>> curves;
  FG::isolines(mesh, field, std::vector<double>{1}, std::back_inserter(curves), 0.05,
               CGAL::parameters::vertex_point_map(points));
  BOOST_TEST_REQUIRE(curves.size() == 1u);
  BOOST_TEST(curves[0].is_closed);
  std::vector<FG::Voronoi_boundary<Mesh_archetype, Mesh_archetype::Point>> none;
  FG::voronoi_boundaries(mesh, field, std::back_inserter(none), 0.05, CGAL::parameters::vertex_point_map(points));
  BOOST_TEST(none.empty());
}
