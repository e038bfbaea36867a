// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the mean of vertices of a mesh, the midpoint between each vertex and the mean, and equally spaced points on
// the shortest paths from the vertices to the mean.
//
//   means_example MESH VERTEX...
//
// Writes mean.vtp: the shortest paths from the vertices to their mean, with the mesh.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_mean.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

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

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>; // as in Polygon Mesh Processing

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
  if(argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh, and at least one vertex");
  std::vector<Mesh::Vertex_index> vertices;
  for(int i = 2; i < argc; ++i)
    vertices.emplace_back(number(argv[i]));

  //! [Mean]
  const auto mean = FG::geodesic_mean(mesh, vertices);
  //! [Mean]
  std::cout << "The mean is in face " << mean.location.first << ", after " << mean.report.iterations
            << " steps: " << to_string(mean.report.status) << ", with a variance of " << mean.report.variance << '\n';

  std::vector<std::vector<Point_3>> paths;
  for(const Mesh::Vertex_index v : vertices) {
    //! [Path to a location]
    std::vector<Face_location> path;
    FG::geodesic_path(mesh, v, mean.location, std::back_inserter(path));
    std::vector<FG::Curve_sample<Mesh, Point_3>> samples;
    FG::sample_curve(mesh, path, 11, std::back_inserter(samples));
    //! [Path to a location]
    std::cout << "From " << v << ", the distance is " << samples.back().length << "; the midpoint is in face "
              << FG::geodesic_midpoint(mesh, v, mean.location).first << '\n';
    paths.emplace_back();
    for(const auto& sample : samples)
      paths.back().push_back(sample.point);
  }
  FG::IO::write_VTP("mean.vtp", mesh, paths);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
