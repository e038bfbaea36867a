// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Saves a partially shortened curve together with its triangulation, reads both again, and completes the shortening.
//
//   save_network_example MESH [SOURCE TARGET]
//
// Writes network.flips.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/IO/network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

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
  const FG::Vertex_index source(argc > 3 ? number(argv[2]) : 0);
  const FG::Vertex_index target(argc > 3 ? number(argv[3]) : static_cast<int>(mesh.number_of_vertices() / 2));

  Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  Network network(triangulation);
  const FG::Curve_index curve = network.add_curve(search(source, target));
  FG::shorten(network, CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(10)));
  const double saved_length = network.length(curve);
  std::ofstream out("network.flips");
  //! [Save]
  FG::write_network(out, network);
  //! [Save]
  out.close();
  network.clear();
  triangulation.rollback(); // restores the edges of the mesh

  std::ifstream in("network.flips");
  //! [Read]
  FG::read_network(in, network); // bitwise identical to the saved network
  //! [Read]
  const bool is_same = network.length(curve) == saved_length;
  FG::shorten(network);
  std::cout << "Saved with length " << saved_length << ", loaded " << (is_same ? "unchanged" : "changed")
            << ", shortened to length " << network.length(curve) << ".\n";
  return is_same && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
