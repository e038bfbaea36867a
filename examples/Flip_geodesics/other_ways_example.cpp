// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the shortest paths of several homotopy classes between two vertices. Paths in different classes pass
// differently around handles, borders, and obstacle faces, which no path enters.
//
//   other_ways_example MESH [SOURCE TARGET NUMBER [OBSTACLE_FACE ...]]
//
// Writes other_ways.vtp, the paths.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Free_mesh = CGAL::Face_filtered_graph<Mesh>;

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
  const Mesh::Vertex_index source(argc > 4 ? number(argv[2]) : 0);
  const Mesh::Vertex_index target(argc > 4 ? number(argv[3]) : mesh.number_of_vertices() / 2);
  const Mesh::size_type most = argc > 4 ? number(argv[4]) : 5;
  std::set<Mesh::Face_index> obstacles;
  for(int i = 5; i < argc; ++i)
    obstacles.insert(Mesh::Face_index(number(argv[i])));

  // A view of the mesh without the obstacles, in which vertices, halfedges and faces have the same descriptors.
  std::vector<Mesh::Face_index> free_faces;
  std::copy_if(mesh.faces_begin(), mesh.faces_end(), std::back_inserter(free_faces),
               [&](Mesh::Face_index f) { return obstacles.count(f) == 0; });
  const Free_mesh free_mesh(mesh, free_faces);

  std::vector<std::vector<Kernel::Point_3>> paths;
  const auto found = FG::shortest_paths_by_class(free_mesh, source, target, (std::max)(most, Mesh::size_type(1)),
                                                 std::back_inserter(paths));
  for(const FG::Shortest_path_report& path : found.report.paths)
    std::cout << "length " << path.length << ", " << FG::to_string(path.verdict) << '\n';
  std::cout << FG::to_string(found.status()) << (found.report.is_confirmed() ? ", confirmed: " : ": ")
            << "all paths of other classes are at least " << found.report.lower_bound_of_others() << " long\n";
  FG::IO::write_VTP("other_ways.vtp", paths);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
