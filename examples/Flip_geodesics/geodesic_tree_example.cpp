// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes geodesics from one vertex to all others, as a tree in one triangulation, and the logarithmic map that the
// tree defines. The map is written as texture coordinates.
//
//   geodesic_tree_example MESH [SOURCE]
//
// Writes logarithmic_map.obj, without the faces that have a vertex that no path reaches.

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

FG::Index number(const std::string& text)
{
  std::istringstream in(text);
  FG::Index result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  if(std::error_code absent; std::filesystem::equivalent(argv[1], "logarithmic_map.obj", absent))
    throw std::invalid_argument("the result would replace the mesh; rename the file of the mesh");

  Triangulation triangulation(mesh);
  //! [Tree]
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  const FG::Geodesic_tree_report report = tree.grow(FG::Vertex_index(argc > 2 ? number(argv[2]) : 0));
  //! [Tree]
  std::cout << report.flips << " flips; the paths are " << to_string(report.status) << '\n';
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(tree);

  std::ofstream out("logarithmic_map.obj");
  for(const auto v : mesh.vertices()) {
    const auto [x, y] = map.in_plane(triangulation.index(v));
    out << "v " << mesh.point(v) << "\nvt " << x << ' ' << y << '\n';
  }
  for(const auto f : mesh.faces()) {
    std::string line = "f";
    bool is_mapped = true;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      is_mapped = is_mapped && tree.distance(triangulation.index(v)) < std::numeric_limits<double>::infinity();
      line += ' ' + std::to_string(v + 1) + '/' + std::to_string(v + 1);
    }
    if(is_mapped)
      out << line << '\n';
  }
  return out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
