// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances of vertices that are confirmed by a search which is rounded outward, where a field is not accurate.

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

namespace {

using Vertex = Mesh::Vertex_index;

template <class Sources>
FG::Distances_report compute_distances(const Mesh& mesh, const Sources& sources, std::vector<double>& distances)
{
  distances.assign(num_vertices(mesh), -1);
  const auto map = boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh));
  return FG::geodesic_distances(mesh, sources, map);
}

bool has_accurate_field(const Mesh_soup& soup, Vertex source)
{
  const Asked_surface s(soup);
  Field field(s.triangulation, s.mesh);
  field.add_source(Vertex_index(static_cast<FG::Index>(source)));
  const auto report = field.compute();
  const bool is_accurate = !report.has_flat_face && !report.has_inaccurate_distance;
  BOOST_TEST(FG::is_confirmed(report.verdict) == is_accurate);
  return is_accurate;
}

// The distances in a convex part of the plane, from each of some vertices and from the nearest of them.
void check_confirmed_in_the_plane(const Mesh_soup& soup, const std::vector<Vertex>& sources)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<double> least(soup.points.size(), infinity), distances;
  for(Vertex source : sources) {
    BOOST_TEST(!has_accurate_field(soup, source));
    BOOST_TEST(compute_distances(mesh, source, distances).is_confirmed(), source);
    for(Vertex v : mesh.vertices()) {
      const double expected = distance(soup.points[source], soup.points[v]);
      BOOST_TEST(std::abs(distances[v] - expected) <= 1e-14 * expected, source << " to " << v);
      least[v] = (std::min)(least[v], expected);
    }
  }
  const auto report = compute_distances(mesh, sources, distances);
  BOOST_TEST(report.is_confirmed());
  BOOST_TEST(report.vertices == soup.points.size() - sources.size());
  for(Vertex v : mesh.vertices())
    BOOST_TEST(std::abs(distances[v] - least[v]) <= 1e-14 * least[v], v);
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_among_needles_are_confirmed)
{
  for(const double aspect : {1e-4, 1e-6, 1e-9})
    check_confirmed_in_the_plane(needle_strip(12, 12, aspect), {Vertex(0), Vertex(84), Vertex(97)});
}

// A square, with a vertex so close to its diagonal that rays can be lost in the face between them.
BOOST_AUTO_TEST_CASE(distances_beside_flat_faces_are_confirmed)
{
  for(const double height : {0.0, 1e-12})
    check_confirmed_in_the_plane({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1 + height, 1 - height, 0}},
                                  {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}}},
                                 {Vertex(1), Vertex(3), Vertex(4)});
}

BOOST_AUTO_TEST_CASE(distances_from_several_sources_are_confirmed_beside_long_edges)
{
  const Mesh_soup soup = mapped(grid(2, 4, Diagonal_rule::RISING, [](int i, int j) { return (7 * i + 5 * j * j) % 4; }),
                                [](const Coordinates& p) {
                                  return Coordinates{1e7 * p[0], p[1], 1e4 * p[2]};
                                });
  const Mesh mesh = to_mesh<Mesh>(soup);
  const std::vector<Vertex> sources = {Vertex(0), Vertex(7), Vertex(0)};
  std::vector<double> distances;
  const auto report = compute_distances(mesh, sources, distances);
  BOOST_TEST(report.is_confirmed());
  BOOST_TEST(report.vertices == soup.points.size() - 2);
  for(Vertex v : mesh.vertices()) {
    double least = infinity;
    for(Vertex source : sources) {
      const auto path = FG::shortest_path(mesh, source, v, CGAL::Emptyset_iterator());
      BOOST_TEST(path.report.is_confirmed());
      least = (std::min)(least, path.length());
    }
    BOOST_TEST(std::abs(distances[v] - least) <= 1e-12 * least, v);
  }
}

// A source that is in no face, among others.
BOOST_AUTO_TEST_CASE(distances_from_an_isolated_source_are_confirmed)
{
  const Mesh_soup soup = needle_strip(4, 4, 1e-6);
  Mesh mesh = to_mesh<Mesh>(soup);
  const Vertex isolated = mesh.add_vertex(Point(0, 0, 1));
  std::vector<double> distances;
  BOOST_TEST(compute_distances(mesh, std::vector<Vertex>{isolated, Vertex(12)}, distances).is_confirmed());
  BOOST_TEST(distances[isolated] == 0);
  for(Vertex v : mesh.vertices())
    if(v != isolated) {
      const double expected = distance(soup.points[12], soup.points[v]);
      BOOST_TEST(std::abs(distances[v] - expected) <= 1e-14 * expected, v);
    }
}

// Vertices in one place: once the edges between them are contracted, sheets that met in a point have vertices of their
// own there, so that paths through the point are missing.
BOOST_AUTO_TEST_CASE(distances_are_not_confirmed_where_contracted_sheets_met_in_a_point)
{
  const std::vector<Coordinates> points = {{0, 0, 0}, {1, 0, 1}, {2, 1, 0}, {3, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                           {2, 1, 0}, {3, 1, 0}, {0, 2, 0}, {1, 2, 1}, {2, 2, 1}, {3, 2, 0},
                                           {0, 3, 1}, {1, 2, 1}, {2, 3, 1}, {3, 3, 0}};
  const std::vector<Corners> triangles = {{0, 1, 4},   {1, 5, 4},   {1, 2, 6},    {1, 6, 5},   {2, 3, 7},   {2, 7, 6},
                                          {4, 5, 9},   {4, 9, 8},   {5, 10, 9},   {6, 7, 10},  {7, 11, 10}, {8, 9, 12},
                                          {9, 13, 12}, {9, 10, 14}, {10, 11, 15}, {10, 15, 14}};
  const Mesh mesh = to_mesh<Mesh>({points, triangles});
  std::vector<double> distances;
  BOOST_TEST(!compute_distances(mesh, Vertex(11), distances).is_confirmed());
}
