// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The smoothest field of crosses that runs along geodesics, as quad meshing and hatching want it.
//
//   cross_field_example [MESH SOURCE TARGET]
//
// Writes cross_field.obj: the mesh, and a cross at every vertex as two lines.

#include "kept_input.h"
#include "torus.h"

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Direction_field.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Field = FG::Direction_field<Triangulation>;

namespace {

// The directions of a field in space: the angle is laid off, about the vertex normal, from where the reference edge
// leaves the vertex on the mesh.
class Directions_in_space
{
public:
  Directions_in_space(const Mesh& mesh, const Triangulation& triangulation, const Field& field)
    : m_mesh(mesh)
    , m_triangulation(triangulation)
    , m_field(field)
  {
  }

  Kernel::Vector_3 operator()(Mesh::Vertex_index v, double turn) const
  {
    std::vector<FG::Surface_point> points;
    const FG::Vertex_index i = m_triangulation.index(v);
    FG::edge_surface_points(m_triangulation, m_field.tangent_spaces().reference(i), std::back_inserter(points));
    const Kernel::Vector_3 normal = PMP::compute_vertex_normal(v, m_mesh);
    const Kernel::Vector_3 reference = FG::point_in_space(m_triangulation, points[1]) - m_mesh.point(v);
    const Kernel::Vector_3 y = CGAL::cross_product(normal, reference);
    const Kernel::Vector_3 x = CGAL::cross_product(y, normal);
    const double angle = m_field.angle(i) + turn;
    return std::cos(angle) * x / std::sqrt(x.squared_length()) + std::sin(angle) * y / std::sqrt(y.squared_length());
  }

private:
  const Mesh& m_mesh;
  const Triangulation& m_triangulation;
  const Field& m_field;
};

void write(std::ostream& out, const Mesh& mesh, const Directions_in_space& direction)
{
  constexpr double quarter_turn = 1.5707963267948966;
  for(Mesh::Vertex_index v : mesh.vertices())
    out << "v " << mesh.point(v) << '\n';
  for(Mesh::Face_index f : mesh.faces()) {
    out << 'f';
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << ' ' << v.idx() + 1;
    out << '\n';
  }
  std::size_t count = mesh.number_of_vertices();
  for(Mesh::Vertex_index v : mesh.vertices()) {
    if(mesh.is_isolated(v))
      continue;
    double size = 0;
    for(Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
      size += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(v))) / mesh.degree(v);
    for(double turn : {0.0, quarter_turn}) {
      const Kernel::Vector_3 arm = 0.4 * size * direction(v, turn);
      out << "v " << mesh.point(v) - arm << "\nv " << mesh.point(v) + arm << "\nl " << count + 1 << ' ' << count + 2
          << '\n';
      count += 2;
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc == 4 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : argc == 1 && make_torus(mesh) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  if(!is_input_kept(argc, argv, {"cross_field.obj"}))
    return EXIT_FAILURE;

  std::ofstream out("cross_field.obj");
  try {
    Triangulation triangulation(mesh);
    const FG::Vertex_index source(argc == 4 ? std::stoi(argv[2]) : 0);
    const FG::Vertex_index target(argc == 4 ? std::stoi(argv[3]) : triangulation.number_of_vertices() / 2 + 10);
    FG::Shortest_edge_path<Triangulation> search(triangulation);
    Network network(triangulation);
    network.add_curve(search(source, target), false);
    FG::shorten(network);
    FG::flip_to_delaunay(triangulation); // all edges but those of the path

    Field field(triangulation);
    field.align(network);
    field.compute();
    int quarters = 0;
    for(const Field::Singularity& singularity : field.singularities())
      quarters += singularity.index;
    std::cout << field.singularities().size() << " faces about which the crosses turn, by " << quarters
              << " quarter turns in all.\n";
    write(out, mesh, Directions_in_space(mesh, triangulation, field));
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
