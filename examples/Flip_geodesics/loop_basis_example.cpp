// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes closed geodesics that form a basis of the homology of a surface, and the homology class of a closed curve in
// this basis.
//
//   loop_basis_example MESH [VERTEX VERTEX VERTEX...]
//
// The vertices are waypoints of a closed curve, whose class is printed. Writes loop_basis.vtp, the geodesics.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdint>
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

namespace {

FG::Index number(const std::string& text)
{
  std::istringstream in(text);
  FG::Index result = 0;
  if(!(in >> result && in.eof()))
    throw std::invalid_argument(text + " is not a number");
  return result;
}

void tell_class(Triangulation& triangulation, const FG::Loop_basis<Triangulation>& basis,
                const std::vector<FG::Vertex_index>& way_points)
{
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  FG::Edge_path_network<Triangulation> network(triangulation);
  const FG::Curve_index curve =
      network.add_curve(FG::shortest_halfedges_through(search, way_points, CGAL::parameters::is_closed(true)),
                        CGAL::parameters::is_closed(true));
  std::cout << "The curve has the class";
  for(std::int64_t i : basis.homology_class(network, curve))
    std::cout << ' ' << i;
  std::cout << (basis.is_contractible(network, curve) ? " and can be contracted.\n" : " and cannot be contracted.\n");
}

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  std::vector<FG::Vertex_index> way_points;
  for(int i = 2; i < argc; ++i)
    way_points.emplace_back(number(argv[i]));

  Triangulation triangulation(mesh);
  const FG::Loop_basis<Triangulation> basis(triangulation);
  for(const auto& component : basis.components())
    std::cout << "A component of genus " << component.genus << " with " << component.number_of_borders
              << " borders: " << component.number_of_loops << " loops.\n";
  if(!way_points.empty())
    tell_class(triangulation, basis, way_points);

  std::vector<std::vector<Kernel::Point_3>> loops;
  //! [Basis]
  const auto result = FG::geodesic_loop_basis(mesh, std::back_inserter(loops));
  //! [Basis]
  for(const FG::Curve_report& loop : result.report.curves)
    std::cout << "A loop of length " << loop.initial_length << " has become a closed geodesic of length " << loop.length
              << ".\n";
  if(!loops.empty())
    FG::IO::write_VTP("loop_basis.vtp", loops);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
