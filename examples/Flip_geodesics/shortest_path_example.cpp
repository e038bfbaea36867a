// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Geodesics are locally shortest. This asks for the globally shortest: one path, with the confirmation that there is no
// shorter one, and the tree of the shortest paths to all vertices.
//
//   shortest_path_example [MESH [SOURCE TARGET]]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/make_shortest.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh, 48, 24) > 0;
  const Mesh::Vertex_index source(argc > 3 ? std::atoi(argv[2]) : 6), target(argc > 3 ? std::atoi(argv[3]) : 620);
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  std::vector<std::vector<Point_3>> paths(1);
  try {
    const auto found = FG::shortest_path(mesh, source, target, std::back_inserter(paths[0]));
    std::cout << "The shortest edge path pulled tight: " << found.report.first_length
              << "\nThe result: " << found.report.length << ", at most " << found.report.gap()
              << " longer than a shortest path, "
              << (found.report.is_confirmed ? "and confirmed\n" : "but not confirmed\n");

    Triangulation triangulation(mesh);
    FG::Geodesic_tree<Triangulation> tree(triangulation);
    tree.grow(triangulation.index(source));
    const FG::Shortest_tree_report report = FG::make_shortest(tree);
    std::cout << report.longer_before << " of " << report.vertices
              << " paths of the tree were longer than shortest, by " << 100 * report.largest_excess_before
              << " % at most; now " << report.longer << " are\n";
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return write_polylines("shortest_path.polylines.txt", paths) && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
