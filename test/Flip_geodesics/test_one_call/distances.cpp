// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances.

#include "test_one_call/checked_curves.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(distances_come_in_maps_of_the_user)
{
  const Mesh_soup soup = with_isolated_vertices(torus(16, 10, 2, 1), 0, 1);
  Surface mesh = to_mesh<Surface>(soup);
  const Vertex source(7);
  auto distances = mesh.add_property_map<Vertex, double>("v:distance", -1).first;
  const auto report = FG::geodesic_distances(mesh, source, distances);
  BOOST_CHECK(report.verdict == FG::Verdict::WITHIN_TOLERANCE);
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
  FG::logarithmic_map(mesh, source, boost::make_assoc_property_map(polar));
  for(Vertex v : mesh.vertices())
    if(v != isolated && v != source) {
      BOOST_CHECK_CLOSE(polar.at(v).radius, distances[v], 1e-8);
      BOOST_CHECK(polar.at(v).angle >= 0 && polar.at(v).angle <= 2 * CGAL_PI);
    }
}

namespace {

// How many of the vertices have other polar coordinates than a tree of shortest paths gives them. On needles the errors
// of a field need not be small enough to be confirmed.
std::size_t number_of_other_coordinates(const Surface& mesh, Vertex source, bool has_needles = false)
{
  using Triangulation = FG::Intrinsic_triangulation<Surface>;
  std::map<Vertex, FG::Polar_coordinates> polar;
  const auto report = FG::logarithmic_map(mesh, source, boost::make_assoc_property_map(polar));
  BOOST_CHECK(report.is_confirmed() || has_needles);
  BOOST_CHECK_EQUAL(report.flips, 0u); // no tree has been grown, and none made shortest
  Triangulation triangulation(mesh);
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  tree.grow(triangulation.index(source));
  FG::make_shortest(tree);
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(tree);
  std::size_t result = 0;
  for(Vertex v : mesh.vertices()) {
    const FG::Polar_coordinates& p = map[triangulation.index(v)];
    BOOST_CHECK_SMALL(p.radius - polar.at(v).radius, 1e-9);
    const double difference = std::remainder(p.angle - polar.at(v).angle, map.total_angle());
    result += v != source && !(std::abs(difference) < 1e-8) ? 1 : 0;
  }
  return result;
}

} // namespace

// Only where two paths are as short, rounding errors choose: on a torus, on the two circles opposite to the source.
BOOST_AUTO_TEST_CASE(polar_coordinates_are_those_of_a_tree)
{
  for(int source : {0, 40, 77}) {
    const Vertex v(static_cast<unsigned>(source));
    BOOST_CHECK_EQUAL(
        number_of_other_coordinates(to_mesh<Surface>(jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.2, 3)), v), 0u);
    BOOST_CHECK_EQUAL(number_of_other_coordinates(to_mesh<Surface>(flat_grid(12, 12, Diagonal_rule::RISING)), v), 0u);
    BOOST_CHECK_EQUAL(number_of_other_coordinates(to_mesh<Surface>(needle_strip(12, 12, 1e-4)), v, true), 0u);
    BOOST_CHECK_EQUAL(number_of_other_coordinates(to_mesh<Surface>(bumpy_sphere(5, 0.3, 7)), v), 0u);
    BOOST_CHECK_LE(number_of_other_coordinates(to_mesh<Surface>(torus(16, 12, 3, 1)), v), 28u);
  }
}

BOOST_AUTO_TEST_CASE(distances_from_several_vertices_are_the_least)
{
  Surface mesh = bumpy_sphere_mesh();
  const std::vector<Vertex> sources = {Vertex(0), Vertex(9), Vertex(25), Vertex(9)};
  auto all = mesh.add_property_map<Vertex, double>("v:all", -1).first;
  const auto report = FG::geodesic_distances(mesh, sources, all);
  BOOST_CHECK(report.is_confirmed());
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
  BOOST_CHECK(
      !FG::geodesic_distances(mesh, sources, all, CGAL::parameters::search_limit(FG::Window_limit(1))).is_confirmed());
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
  const auto report =
      FG::geodesic_distances(mesh, Vertex(0), limited, CGAL::parameters::search_limit(FG::Window_limit(1)));
  BOOST_CHECK(!report.is_confirmed());
  for(Vertex v : mesh.vertices()) // those of geodesics that need not be shortest
    BOOST_CHECK_GE(limited[v], distances[v] * (1 - 1e-10));
  BOOST_CHECK_THROW(FG::geodesic_distances(mesh, Vertex(mesh.number_of_vertices()), distances),
                    FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(FG::logarithmic_map(mesh, Surface::null_vertex(), boost::dummy_property_map()),
                    FG::Vertex_out_of_range_error);
}
