// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the positions of vertices in the tangent plane of a point inside a face, by the logarithmic map, and the
// parallel transport of a direction to these vertices.
//
//   parallel_transport_example MESH FACE RADIUS
//
// Prints the coordinates of the vertices whose distance from the middle of the face is less than RADIUS, and traces a
// short line from each of them in the transported direction. Writes the lines to arrows.vtp, with the mesh.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

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
  if(argc < 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh, a face, and a radius");
  const Mesh::Face_index face(number<Mesh::size_type>(argv[2]));
  if(face >= mesh.number_of_faces())
    throw std::invalid_argument("the mesh has no such face");
  FG::Distance_field_limits limits;
  limits.radius = number<double>(argv[3]);

  const Triangulation triangulation(mesh);
  const FG::Surface_location source = {triangulation.input().index(mesh.halfedge(face)), {{1, 1, 1}}};
  const FG::Logarithmic_map<Triangulation> logarithm(triangulation, mesh, source,
                                                     CGAL::parameters::search_limit(limits));
  const FG::Geodesic_tracer<Triangulation> tracer(triangulation);

  std::vector<std::vector<Point_3>> arrows;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const FG::Polar_coordinates p = logarithm(triangulation.index(v));
    if(!(p.radius < limits.radius) || mesh.is_border(v))
      continue;
    const auto [x, y] = logarithm.in_plane(p);
    std::cout << v << " lies at " << x << ", " << y << '\n';
    const FG::Surface_location here = triangulation.location(triangulation.index(v));
    const FG::Surface_direction carried = logarithm.transported(here, 0);
    arrows.emplace_back();
    std::vector<FG::Surface_point> points;
    tracer.trace(here, carried, 0.05 * limits.radius, std::back_inserter(points));
    for(const FG::Surface_point& q : points)
      arrows.back().push_back(point_in_space(triangulation, q));
  }
  FG::IO::write_VTP("arrows.vtp", mesh, arrows);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
