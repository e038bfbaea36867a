// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Writes a torus with bumps, of any size: a mesh to try flip_geodesics and the examples on.
//
//   generate_torus FILE [VERTICES_AROUND [VERTICES_ALONG]]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

/*!
 * Makes a torus with bumps of `around * along` vertices and twice as many triangles. Vertex `i * along + j`, counted
 * from 0, has angle i / around around the axis and angle j / along around the tube.
 *
 * \param bumps their height, as a part of the tube's radius
 * \return the number of faces
 */
template <class MutableFaceGraph>
std::size_t make_torus(MutableFaceGraph& mesh, std::size_t around = 96, std::size_t along = 48, double bumps = 0.25)
{
  using Vertex = typename boost::graph_traits<MutableFaceGraph>::vertex_descriptor;
  const auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<decltype(points)>::value_type;

  constexpr double two_pi = boost::math::constants::two_pi<double>();
  std::vector<Vertex> vertices;
  for(std::size_t k = 0; k < around * along; ++k) {
    const double u = two_pi * static_cast<double>(k / along) / static_cast<double>(around);
    const double v = two_pi * static_cast<double>(k % along) / static_cast<double>(along);
    const double tube = 0.4 * (1 + bumps * std::cos(5 * u) * std::sin(3 * v));
    const double radius = 1 + tube * std::cos(v);
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), Point(radius * std::cos(u), radius * std::sin(u), tube * std::sin(v)));
  }
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < along; ++j) {
      const std::size_t next_i = (i + 1) % around, next_j = (j + 1) % along;
      const Vertex a = vertices[i * along + j], b = vertices[next_i * along + j];
      const Vertex c = vertices[next_i * along + next_j], d = vertices[i * along + next_j];
      CGAL::Euler::add_face(std::array<Vertex, 3>{a, b, c}, mesh);
      CGAL::Euler::add_face(std::array<Vertex, 3>{a, c, d}, mesh);
    }
  return 2 * around * along;
}

int main(int argc, char** argv)
{
  if(argc < 2) {
    std::cerr << "generate_torus: say which file to write\n";
    return EXIT_FAILURE;
  }
  const std::size_t around = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 400;
  const std::size_t along = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 200;
  if(around < 3 || along < 3) {
    std::cerr << "generate_torus: 3 vertices are the least in each direction\n";
    return EXIT_FAILURE;
  }
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  make_torus(mesh, around, along);
  if(!CGAL::IO::write_polygon_mesh(argv[1], mesh, CGAL::parameters::stream_precision(17))) {
    std::cerr << "generate_torus: cannot write " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
