// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Traces straightest geodesics of equal length from a vertex in 24 directions. Their ends are images of points of a
// circle under the exponential map.
//
//   trace_geodesic_example MESH LENGTH [VERTEX]
//
// Writes rays.vtp, with the mesh.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/math/constants/constants.hpp>

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

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

template <class Number>
Number number(const std::string& text)
{
  std::istringstream in(text);
  Number result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh, and a length");
  const double length = number<double>(argv[2]);
  const Mesh::Vertex_index source(argc > 3 ? number<Mesh::size_type>(argv[3]) : 0);
  if(source >= mesh.number_of_vertices())
    throw std::invalid_argument("the mesh has no such vertex");

  // Angles are measured counterclockwise, across the faces around the vertex, from a halfedge that starts there.
  const Mesh::Halfedge_index zero = mesh.opposite(mesh.halfedge(source));
  std::vector<std::vector<Point_3>> rays;
  constexpr int count = 24;
  for(int i = 0; i < count; ++i) {
    const std::pair direction(zero, i * boost::math::constants::two_pi<double>() / count);
    rays.emplace_back();
    //! [Trace]
    const auto trace = FG::trace_geodesic(mesh, source, direction, length, std::back_inserter(rays.back()));
    //! [Trace]
    std::cout << trace.length() << ", " << to_string(trace.status()) << ", " << trace.report.edges << " edges\n";
  }
  FG::IO::write_VTP("rays.vtp", mesh, rays);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
