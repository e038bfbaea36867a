// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes a geodesic from one vertex to another by a single call.
//
//   geodesic_path_example MESH [SOURCE TARGET]
//
// Writes the curve to geodesic_path.vtp.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
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

  //! [One call]
  std::vector<Kernel::Point_3> points;
  const auto result = FG::geodesic_path(mesh, source, target, std::back_inserter(points));
  std::cout << "A curve of " << points.size() << " points, " << result.length() << " long, after "
            << result.report.flips << " flips: " << to_string(result.status()) << ", " << to_string(result.verdict())
            << ".\n";
  //! [One call]
  FG::IO::write_VTP("geodesic_path.vtp", std::vector<std::vector<Kernel::Point_3>>{points});
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
