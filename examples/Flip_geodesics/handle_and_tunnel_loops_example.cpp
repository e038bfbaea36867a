// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes closed geodesics around the handles and the tunnels of a solid.
//
//   handle_and_tunnel_loops_example MESH
//
// Writes handles.vtp and tunnels.vtp, the geodesics, if there are any.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

void shorten_and_write(const Triangulation& triangulation, const Mesh& mesh, const std::string& kind,
                const std::vector<std::vector<FG::Halfedge_index>>& loops)
{
  std::vector<std::vector<Kernel::Point_3>> geodesics;
  for(const std::vector<FG::Halfedge_index>& loop : loops) {
    std::vector<Mesh::Vertex_index> vertices;
    for(FG::Halfedge_index h : loop)
      vertices.push_back(source(triangulation.input_halfedge(h), mesh));
    geodesics.emplace_back();
    const auto result = FG::geodesic_loop(mesh, vertices, std::back_inserter(geodesics.back()));
    std::cout << "A " << kind << " loop of " << loop.size() << " edges has become a geodesic of length "
              << result.length() << ".\n";
  }
  if(!geodesics.empty())
    FG::IO::write_VTP(kind + "s.vtp", geodesics);
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");

  const Triangulation triangulation(mesh);
  //! [Loops]
  const FG::Handle_and_tunnel_loops loops = FG::handle_and_tunnel_loops(triangulation);
  //! [Loops]
  shorten_and_write(triangulation, mesh, "handle", loops.handles);
  shorten_and_write(triangulation, mesh, "tunnel", loops.tunnels);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
