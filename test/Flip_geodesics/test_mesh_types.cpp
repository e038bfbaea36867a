// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE mesh_types

#include "Mesh_archetype.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#ifdef CGAL_USE_OPENMESH
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#endif

#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/subdivide.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/mpl/list.hpp>
#include <boost/mpl/push_front.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Simple = CGAL::Simple_cartesian<double>;

namespace {

// How a soup becomes a mesh, and where its points are.
template <class Mesh_>
struct Mesh_type
{
  using Mesh = Mesh_;
  static Mesh make(const Mesh_soup& soup) { return to_mesh<Mesh>(soup); }
  static auto points(const Mesh& mesh) { return get(CGAL::vertex_point, mesh); }
};

struct Archetype_type
{
  using Mesh = Mesh_archetype;
  static Mesh make(const Mesh_soup& soup) { return Mesh(soup); }
  static auto points(const Mesh& mesh) { return Archetype_point_map{&mesh}; }
};

#ifdef CGAL_USE_OPENMESH
struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
#endif

using Meshes_with_points = boost::mpl::list<Mesh_type<CGAL::Surface_mesh<Epick::Point_3>>,
#ifdef CGAL_USE_OPENMESH
                                            Mesh_type<OpenMesh::TriMesh_ArrayKernelT<Double_traits>>,
#endif
                                            Mesh_type<CGAL::Polyhedron_3<Epick>>>;

using Mesh_types = boost::mpl::push_front<Meshes_with_points, Archetype_type>::type;

// What a curve is, whatever the mesh type: points in space, and figures.
struct Curve
{
  std::vector<Coordinates> points;
  FG::Curve_report report;
};

template <class Point>
Coordinates coordinates(const Point& p)
{
  return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
}

template <class Type>
class Curves_on
{
  using Mesh = typename Type::Mesh;
  using Point_map = decltype(Type::points(std::declval<const Mesh&>()));
  using Metric = FG::Embedded_metric<Mesh, Point_map>;
  using Traits = FG::Intrinsic_triangulation_traits<typename Metric::Kernel, double>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits, Metric>;
  using Network = FG::Edge_path_network<Triangulation>;

public:
  explicit Curves_on(const Mesh_soup& soup)
    : m_mesh(Type::make(soup))
    , m_triangulation(m_mesh, Metric(Type::points(m_mesh)))
  {
  }

  const Mesh& mesh() const { return m_mesh; }
  Triangulation& triangulation() { return m_triangulation; }

  Curve path(FG::Vertex_index u, FG::Vertex_index v)
  {
    FG::Shortest_edge_path<Triangulation> search(m_triangulation);
    return pulled(FG::shortest_halfedges_through(search, Vertex_sequence{u, v}), false);
  }

  Curve loop(const Vertex_sequence& sequence)
  {
    return pulled(FG::halfedges_through(m_triangulation, sequence, CGAL::parameters::is_closed(true)), true);
  }

private:
  Curve pulled(const std::vector<FG::Halfedge_index>& halfedges, bool is_closed)
  {
    Network network(m_triangulation);
    network.add_curve(halfedges, CGAL::parameters::is_closed(is_closed));
    Curve result;
    result.report = FG::shorten(network).curves.front();
    std::vector<typename Metric::Point_3> points;
    FG::Curve_extractor<Network>(network).points(0_c, std::back_inserter(points));
    for(const auto& p : points)
      result.points.push_back(coordinates(p));
    network.clear();
    m_triangulation.rollback();
    return result;
  }

  Mesh m_mesh;
  Triangulation m_triangulation;
};

void check_equal(const Curve& a, const Curve& b)
{
  BOOST_TEST(FG::to_string(a.report.status) == std::string(FG::to_string(b.report.status)));
  BOOST_TEST(std::abs(a.report.length - b.report.length) <= 1e-11 * b.report.length);
  BOOST_TEST(std::abs(a.report.initial_length - b.report.initial_length) <= 1e-11 * b.report.initial_length);
  BOOST_REQUIRE_EQUAL(a.points.size(), b.points.size());
  for(std::size_t i = 0; i < a.points.size(); ++i)
    BOOST_TEST(distance(a.points[i], b.points[i]) < 1e-9);
}

// Without ties, so that the order of edges has no influence. The point map of OpenMesh's meshes rounds what is put into
// it to float.
std::vector<Mesh_soup> soups()
{
  const auto bent = [](const Coordinates& p) {
    return Coordinates{p[0] + 0.11 * std::sin(3 * p[1] + p[2]), p[1] + 0.07 * std::sin(5 * p[2] + p[0]),
                       p[2] + 0.05 * std::sin(7 * p[0] + 2 * p[1])};
  };
  std::vector<Mesh_soup> result = {bumpy_sphere(4, 0.2, 1), jittered_grid(7, 6, Diagonal_rule::RANDOM, 0.2, 2),
                                   mapped(genus_3_plate(2), bent)};
  for(Mesh_soup& soup : result)
    soup = mapped(soup, [](const Coordinates& p) { return Coordinates{float(p[0]), float(p[1]), float(p[2])}; });
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(the_same_geodesics_come_out, Type, Mesh_types)
{
  using Reference = Mesh_type<CGAL::Surface_mesh<Simple::Point_3>>;
  std::size_t points = 0;
  for(const Mesh_soup& soup : soups()) {
    Curves_on<Type> curves(soup);
    Curves_on<Reference> expected(soup);
    Random_numbers random(1);
    for(int i = 0; i < 30; ++i) {
      const int n = static_cast<int>(soup.points.size());
      const FG::Vertex_index u(random.below(n)), v((u.idx() + 1 + random.below(n - 1)) % n);
      const Curve curve = curves.path(u, v);
      check_equal(curve, expected.path(u, v));
      points += curve.points.size();
    }
    const Corners& t = soup.triangles[random.below(static_cast<int>(soup.triangles.size()))];
    const Vertex_sequence face = {FG::Vertex_index(t[0]), FG::Vertex_index(t[1]), FG::Vertex_index(t[2])};
    check_equal(curves.loop(face), expected.loop(face)); // contracts
  }
  std::cout << points << " points compared\n";
  BOOST_TEST(points > 200u);
}

// Trees, distances by vertices of the mesh, subdivisions and files.
BOOST_AUTO_TEST_CASE_TEMPLATE(the_same_source_does_the_rest, Type, Mesh_types)
{
  using Mesh = typename Type::Mesh;
  Curves_on<Type> curves(soups().front());
  Curves_on<Mesh_type<CGAL::Surface_mesh<Simple::Point_3>>> expected(soups().front());
  auto& triangulation = curves.triangulation();
  using Triangulation = std::decay_t<decltype(triangulation)>;
  using Network = FG::Edge_path_network<Triangulation>;
  for(const auto h : halfedges(curves.mesh())) {
    const auto& input = triangulation.input();
    BOOST_TEST(input.twin(input.index(h)) == input.index(opposite(h, curves.mesh())));
  }
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  FG::Geodesic_tree<std::decay_t<decltype(expected.triangulation())>> expected_tree(expected.triangulation());
  tree.grow(0_v);
  expected_tree.grow(0_v);
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double> distances;
  FG::put_distances(tree, curves.mesh(), boost::make_assoc_property_map(distances));
  FG::Vertex_index i(0);
  for(const auto v : vertices(curves.mesh())) {
    BOOST_TEST(std::abs(distances[v] - expected_tree.distance(i)) < 1e-9);
    ++i;
  }
  triangulation.rollback();

  Network network(triangulation);
  network.add_curve(std::vector<FG::Halfedge_index>{triangulation.outgoing(0_v)});
  FG::shorten(network);
  const auto subdivision =
      FG::insert_curves<CGAL::Surface_mesh<typename Triangulation::Metric::Point_3>>(network, curves.mesh());
  BOOST_TEST(subdivision.mesh().number_of_vertices() == distances.size());
  std::stringstream file;
  FG::write_network(file, network);
  Triangulation other(curves.mesh(), triangulation.metric());
  Network restored(other);
  FG::read_network(file, restored);
  BOOST_TEST(restored.length(0_c) == network.length(0_c));
}

// The functions for one curve resolve the mesh's own point map.
BOOST_AUTO_TEST_CASE_TEMPLATE(one_call_does_the_same, Type, Meshes_with_points)
{
  using Mesh = typename Type::Mesh;
  const Mesh_soup soup = bumpy_sphere(4, 0.2, 3);
  Curves_on<Type> curves(soup);
  const Mesh& mesh = curves.mesh();
  const std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> v(vertices(mesh).begin(),
                                                                             vertices(mesh).end());
  std::vector<typename boost::property_traits<decltype(Type::points(mesh))>::value_type> points;
  const auto result = FG::geodesic_path(mesh, v[3], v[60], std::back_inserter(points));
  const Curve expected = curves.path(3_v, 60_v);
  BOOST_TEST(result.report.curves.front().length == expected.report.length);
  BOOST_REQUIRE_EQUAL(points.size(), expected.points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_TEST(distance(coordinates(points[i]), expected.points[i]) == 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(loops_around_handles, Type, Mesh_types)
{
  const Mesh_soup soup = genus_3_plate(2);
  Curves_on<Type> curves(soup);
  for(const Vertex_sequence& loop : genus_3_loops(2)) {
    const Curve curve = curves.loop(loop);
    BOOST_TEST(FG::to_string(curve.report.status) == "LOCALLY_SHORTEST");
    BOOST_TEST(curve.report.length == 8, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(errors_have_types, Type, Mesh_types)
{
  Curves_on<Type> two(with_isolated_vertices(disjoint_union(octahedron(1), octahedron(1)), 0, 1));
  BOOST_CHECK_THROW(two.path(0_v, 6_v), FG::Disconnected_endpoints_error);
  BOOST_CHECK_THROW(two.path(3_v, 3_v), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(two.loop({0_v, 2_v, 1_v, 6_v}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(two.path(0_v, 12_v), FG::Disconnected_endpoints_error);
}

// Whichever halfedge a mesh type keeps for a vertex, one on the border for instance: none of them loses it to a point.
BOOST_AUTO_TEST_CASE_TEMPLATE(border_edges_are_split, Type, Mesh_types)
{
  Curves_on<Type> curves(flat_grid(2, 2, Diagonal_rule::RISING));
  auto& triangulation = curves.triangulation();
  for(FG::Vertex_index v : descriptors<FG::Vertex_index>(triangulation.number_of_vertices()))
    BOOST_TEST(triangulation.tail(triangulation.outgoing(v)) == v);
  for(FG::Halfedge_index h : descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges()))
    if(triangulation.is_border(h))
      triangulation.insert({FG::internal::as_input(h), {{1, 1, 0}}});
  BOOST_TEST(triangulation.number_of_vertices() == 9 + 8);
  for(FG::Vertex_index v : descriptors<FG::Vertex_index>(triangulation.number_of_vertices()))
    BOOST_TEST(triangulation.tail(triangulation.outgoing(v)) == v);
  BOOST_TEST(triangulation.is_valid());
}

// Points on the border are told from a face, whichever halfedge stands for them.
BOOST_AUTO_TEST_CASE_TEMPLATE(points_on_the_border_lie_in_faces, Type, Mesh_types)
{
  Curves_on<Type> curves(flat_grid(2, 2, Diagonal_rule::RISING));
  auto& triangulation = curves.triangulation();
  using Network = FG::Edge_path_network<std::decay_t<decltype(triangulation)>>;
  Network network(triangulation);
  const Vertex_sequence around = {0_v, 1_v, 2_v, 5_v, 8_v, 7_v, 6_v, 3_v};
  network.add_curve(FG::halfedges_through(triangulation, around, CGAL::parameters::is_closed(true)),
                    CGAL::parameters::is_closed(true));
  FG::Curve_extractor<Network> extractor(network);
  std::vector<std::pair<typename boost::graph_traits<std::decay_t<decltype(curves.mesh())>>::face_descriptor,
                        std::array<double, 3>>>
      locations;
  extractor.face_locations(0_c, curves.mesh(), std::back_inserter(locations));
  BOOST_REQUIRE_EQUAL(locations.size(), around.size() + 1);
  for(std::size_t i = 0; i < locations.size(); ++i) {
    const FG::Surface_location at = FG::surface_location(triangulation, curves.mesh(), locations[i]);
    BOOST_TEST((kind(at) == FG::Location_kind::VERTEX));
    BOOST_TEST(triangulation.insert(at) == around[i % around.size()]);
  }
}

// A curve whose last vertex is its first is a loop: about the apex of a sharp cone it shrinks to a point, as no path
// with fixed ends would.
BOOST_AUTO_TEST_CASE(curves_that_return_are_closed)
{
  using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
  const Mesh mesh = to_mesh<Mesh>(cone_disk(6, 3, 2));
  std::vector<Mesh::Vertex_index> ring;
  for(FG::Vertex_index v : disk_ring(6, 2))
    ring.push_back(Mesh::Vertex_index(static_cast<unsigned>(v.idx())));
  ring.push_back(ring.front());
  std::vector<std::vector<Epick::Point_3>> points;
  const auto result =
      FG::geodesic_network(mesh, std::vector<std::vector<Mesh::Vertex_index>>{ring}, std::back_inserter(points));
  BOOST_TEST(FG::to_string(result.report.curves.front().status) == "CONTRACTED");
}

using Polygon_mesh_types = boost::mpl::list<CGAL::Surface_mesh<Epick::Point_3>, CGAL::Polyhedron_3<Epick>>;

BOOST_AUTO_TEST_CASE_TEMPLATE(polygons_are_refused, Mesh, Polygon_mesh_types)
{
  using Point = Epick::Point_3;
  Mesh cube;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(0, 1, 1), Point(0, 0, 1),
                        Point(1, 0, 1), Point(1, 1, 1), cube);
  const std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> v(vertices(cube).begin(),
                                                                             vertices(cube).end());
  std::vector<Point> points;
  for(std::size_t i = 1; i < v.size(); ++i)
    BOOST_CHECK_THROW(FG::geodesic_path(cube, v[0], v[i], std::back_inserter(points)), FG::Invalid_mesh_error);
  BOOST_TEST(points.empty());
}
