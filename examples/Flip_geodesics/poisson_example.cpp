// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Solves a partial differential equation with boundary values on a curve: computes the temperature of a surface that is
// heated evenly and kept at zero along a geodesic between two vertices. Since the curve consists of edges of the
// triangulation, the solution is zero along the whole curve. The unknowns are the values at the vertices of the mesh.
//
//   poisson_example MESH SOURCE TARGET
//
// Writes poisson.ply, the mesh with the property `u` at its vertices.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/Operators.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <Eigen/Core>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Operators = FG::Operators<Triangulation>;

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
  if(std::error_code absent; std::filesystem::equivalent(argv[1], "poisson.ply", absent))
    throw std::invalid_argument("the result would replace the mesh; rename the file of the mesh");

  //! [Steps]
  Triangulation triangulation(mesh);
  const FG::Vertex_index source(number(argv[2])), target(number(argv[3]));
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  const FG::Curve_index curve = network.add_curve(search(source, target));
  FG::shorten(network);
  //! [Steps]
  //! [Solve]
  FG::flip_to_delaunay(triangulation); // flips no edge of the curve

  std::vector<FG::Vertex_index> cold = {source};
  for(FG::Halfedge_index h : network.halfedges(curve))
    cold.push_back(triangulation.head(h));
  const FG::Dirichlet_problem<Operators> problem(Operators(triangulation), cold);
  const Eigen::VectorXd heat = Eigen::VectorXd::Ones(triangulation.number_of_vertices());
  const Eigen::VectorXd u = problem.solve(heat, Eigen::VectorXd::Zero(triangulation.number_of_vertices()));
  //! [Solve]
  std::cout << "The solution is zero at " << cold.size() << " vertices on the curve, and at most " << u.maxCoeff()
            << ".\n";

  auto temperature = mesh.add_property_map<Mesh::Vertex_index, double>("v:u", 0).first;
  for(Mesh::Vertex_index v : mesh.vertices())
    temperature[v] = u[triangulation.index(v).idx()];
  std::ofstream out("poisson.ply");
  out.precision(17);
  return CGAL::IO::write_PLY(out, mesh) && out.flush() && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
