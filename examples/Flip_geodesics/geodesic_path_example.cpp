// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A geodesic from one vertex to another, by one call.
//
//   geodesic_path_example [MESH [SOURCE TARGET]]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/geodesic_curves.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  const std::size_t source = argc > 3 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const std::size_t target = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : mesh.number_of_vertices() / 2;

  std::vector<Kernel::Point_3> points;
  try {
    const auto result = CGAL::Flip_geodesics::geodesic_path(mesh, Mesh::Vertex_index(source),
                                                            Mesh::Vertex_index(target), std::back_inserter(points));
    const CGAL::Flip_geodesics::Curve_report& curve = result.report.curves.front();
    std::cout << "The edge path is " << curve.initial_length << " long, the geodesic " << curve.length << ", after "
              << result.report.flips << " flips: " << to_string(curve.status) << ".\n";
  } catch(const CGAL::Flip_geodesics::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }

  return write_polylines<Kernel::Point_3>("geodesic_path.polylines.txt", {points}) && std::cout.flush() ? EXIT_SUCCESS
                                                                                                        : EXIT_FAILURE;
}
