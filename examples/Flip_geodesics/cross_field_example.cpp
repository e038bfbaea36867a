// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the smoothest cross field that is aligned with a geodesic, for example for quad meshing or hatching.
//
//   cross_field_example MESH SOURCE TARGET
//
// Writes cross_field.vtp, with two lines that form a cross at every vertex, and singular_faces.vtp, the corners of the
// singular faces of the triangulation.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Direction_field.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
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
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Field = FG::Direction_field<Triangulation>;

// Returns a direction of the field at a vertex, in space. Its angle is measured around the vertex normal, from the
// direction in which the reference edge leaves the vertex.
Kernel::Vector_3 direction(const Mesh& mesh, const Triangulation& triangulation, const Field& field,
                           Mesh::Vertex_index v, const Kernel::Vector_3& normal)
{
  const FG::Vertex_index i = triangulation.index(v);
  std::vector<FG::Surface_point> points;
  FG::edge_surface_points(triangulation, field.tangent_spaces().reference(i), std::back_inserter(points));
  const Kernel::Vector_3 reference = FG::point_in_space(triangulation, points[1]) - mesh.point(v);
  const Kernel::Vector_3 y = CGAL::cross_product(normal, reference), x = CGAL::cross_product(y, normal);
  return (std::cos(field.angle(i)) * x + std::sin(field.angle(i)) * y) / std::sqrt(x.squared_length());
}

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
  if(argc != 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh, and two vertices");
  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  FG::Edge_path_network<Triangulation> network(triangulation);
  network.add_curve(search(FG::Vertex_index(number(argv[2])), FG::Vertex_index(number(argv[3]))));
  FG::shorten(network);
  FG::flip_to_delaunay(triangulation); // flips no edge of the path
  Field field(triangulation);
  field.align(network);
  field.compute();
  const auto singularities = field.singularities();
  std::cout << singularities.size() << " singular faces.\n";

  std::vector<std::vector<Kernel::Point_3>> arms;
  for(Mesh::Vertex_index v : mesh.vertices()) {
    if(mesh.is_isolated(v))
      continue;
    const double size = 0.3 * CGAL::Polygon_mesh_processing::edge_length(mesh.halfedge(v), mesh);
    const Kernel::Vector_3 normal = CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh);
    const Kernel::Vector_3 u = size * direction(mesh, triangulation, field, v, normal);
    for(const Kernel::Vector_3& arm : {u, CGAL::cross_product(normal, u)})
      arms.push_back({mesh.point(v) - arm, mesh.point(v) + arm});
  }
  FG::IO::write_VTP("cross_field.vtp", arms);
  std::vector<std::vector<Kernel::Point_3>> corners;
  for(const Field::Singularity& s : singularities) {
    corners.emplace_back();
    for(FG::Vertex_index v : field.operators().faces()[s.face].vertices)
      corners.back().push_back(mesh.point(triangulation.vertex(v)));
  }
  if(!corners.empty())
    FG::IO::write_VTP("singular_faces.vtp", corners);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
