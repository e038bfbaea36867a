// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes a globally shortest path between two vertices, also with landmarks, one between a vertex and a point in a
// face, and the distances of all vertices.
//
//   shortest_path_example MESH [SOURCE TARGET]
//
// Writes the first path to shortest_path.vtp.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh::size_type number(const std::string& text)
{
  std::istringstream in(text);
  Mesh::size_type result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  const Mesh::Vertex_index source(argc > 3 ? number(argv[2]) : 0);
  const Mesh::Vertex_index target(argc > 3 ? number(argv[3]) : mesh.number_of_vertices() / 2);

  const std::array<double, 3> center = {{1 / 3., 1 / 3., 1 / 3.}}; // in barycentric coordinates

  std::vector<std::vector<Kernel::Point_3>> paths(1);
  //! [Shortest]
  const auto found = FG::shortest_path(mesh, source, target, std::back_inserter(paths[0]));
  //! [Shortest]
  std::cout << "The initial geodesic: " << found.report.first_length << "\nThe result: " << found.length()
            << ", at most " << found.report.gap() << " longer than a shortest path, "
            << FG::to_string(found.report.verdict) << (found.report.has_tie ? ", one of several\n" : "\n");
  FG::IO::write_VTP("shortest_path.vtp", paths);

  //! [Points]
  const auto between_points = FG::shortest_path(mesh, mesh.point(source), std::make_pair(*faces(mesh).first, center),
                                                std::back_inserter(paths.emplace_back()));
  //! [Points]
  std::cout << "To the center of the first face: " << between_points.length() << ", "
            << FG::to_string(between_points.verdict()) << '\n';

  //! [Landmarks]
  const FG::Geodesic_landmarks landmarks = FG::geodesic_landmarks(mesh); // can be used for many pairs of vertices
  const auto again = FG::shortest_path(mesh, source, target, std::back_inserter(paths.emplace_back()),
                                       CGAL::parameters::landmarks(landmarks));
  //! [Landmarks]
  std::cout << "With landmarks: " << again.length() << ", " << FG::to_string(again.report.verdict) << '\n';

  //! [Distances]
  auto distances = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  const FG::Distances_report report = FG::geodesic_distances(mesh, source, distances);
  //! [Distances]
  std::cout << "The distances of " << report.vertices << " vertices are "
            << (report.is_confirmed() ? "those of shortest paths\n" : "not confirmed\n")
            << "The distance to the target: " << distances[target] << '\n';
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
