// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A closed geodesic: a loop of edges through way points, pulled tight. A loop that can contract to a point does.
//
//   geodesic_loop_example [MESH VERTEX VERTEX VERTEX ...]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  std::vector<FG::Vertex_index> way_points;
  for(int i = 2; i < argc; ++i)
    way_points.emplace_back(static_cast<FG::Index>(std::strtol(argv[i], nullptr, 10)));
  if(argc <= 1)
    for(FG::Index v : {0, 1440, 2900}) // around the hole of the torus
      way_points.emplace_back(v);

  try {
    const Triangulation triangulation(mesh);
    FG::Shortest_edge_path<Triangulation> search(triangulation);
    std::vector<Mesh::Vertex_index> loop;
    for(FG::Halfedge_index h : FG::shortest_halfedges_through(search, way_points, true))
      loop.push_back(triangulation.vertex(triangulation.tail(h)));

    std::vector<Kernel::Point_3> points;
    const auto result = FG::geodesic_loop(mesh, loop, std::back_inserter(points));
    const FG::Curve_report& curve = result.report.curves.front();
    std::cout << "The loop of " << loop.size() << " edges is " << curve.initial_length << " long, the geodesic "
              << curve.length << ": " << to_string(curve.status) << ".\n";
    return write_polylines<Kernel::Point_3>("geodesic_loop.polylines.txt", {points}) && std::cout.flush()
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
