// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes exact distances: those of all vertices from the nearest of three sources, and those between five vertices.
//
//   distance_table_example MESH
//
// Writes distance_table.vtp, the mesh with the distances and the nearest sources of its vertices, and
// distance_table.csv, the matrix of distances between five vertices.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Source = std::variant<Vertex, Face_location, std::vector<Vertex>>; // the last one is a curve

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  const auto halfedge = mesh.halfedge(Mesh::Face_index(mesh.number_of_faces() / 4));
  const std::vector<Source> sources = {Vertex(0),
                                       Face_location(Mesh::Face_index(mesh.number_of_faces() / 2), {{0.2, 0.3, 0.5}}),
                                       std::vector<Vertex>{mesh.source(halfedge), mesh.target(halfedge)}};
  auto distances = mesh.add_property_map<Vertex, double>("v:distance").first;
  auto nearest = mesh.add_property_map<Vertex, int>("v:nearest_source").first;
  FG::geodesic_distances(mesh, sources, distances, CGAL::parameters::nearest_source_map(nearest));
  FG::IO::write_VTP("distance_table.vtp", mesh, FG::IO::Vertex_values("distance", distances),
                    FG::IO::Vertex_values("nearest_source", nearest));

  std::vector<Vertex> points;
  for(Mesh::size_type i = 0; i < 5; ++i)
    points.emplace_back(i * mesh.number_of_vertices() / 5);
  std::vector<std::vector<double>> rows;
  const auto report = FG::geodesic_distance_matrix(mesh, points, std::back_inserter(rows));
  std::ofstream table("distance_table.csv");
  for(const std::vector<double>& row : rows)
    for(std::size_t i = 0; i < row.size(); ++i)
      table << row[i] << (i + 1 < row.size() ? ',' : '\n');
  std::cout << report.vertices << " distances between " << points.size() << " vertices\n";
  return table.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
