// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shortens a loop of edges through waypoints to a closed geodesic, or to a point if the loop can be contracted by
// shortening.
//
//   geodesic_loop_example MESH VERTEX VERTEX VERTEX...
//
// Writes the curve to geodesic_loop.vtp, unless it has been contracted to a point.

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

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
  std::vector<FG::Vertex_index> way_points;
  for(int i = 2; i < argc; ++i)
    way_points.emplace_back(number(argv[i]));

  //! [Waypoints]
  const Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  std::vector<Mesh::Vertex_index> loop;
  for(FG::Halfedge_index h : FG::shortest_halfedges_through(search, way_points, CGAL::parameters::is_closed(true)))
    loop.push_back(source(triangulation.input_halfedge(h), mesh));
  //! [Waypoints]

  std::vector<Kernel::Point_3> points;
  //! [Loop]
  const auto result = FG::geodesic_loop(mesh, loop, std::back_inserter(points));
  //! [Loop]
  std::cout << "A loop of " << loop.size() << " edges has become a closed curve of length " << result.length() << ": "
            << to_string(result.status()) << ".\n";
  if(!points.empty())
    FG::IO::write_VTP("geodesic_loop.vtp", std::vector<std::vector<Kernel::Point_3>>{points});
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
