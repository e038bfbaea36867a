// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A geodesic between points inside of faces, and a Bezier curve and a B-spline whose control points are inside of
// faces.
//
//   geodesic_spline_example [MESH]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/curves_through_points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>; // as in Polygon Mesh Processing

int main(int argc, char** argv)
{
  namespace FG = CGAL::Flip_geodesics;
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() < 131) {
    std::cerr << "This is not a triangle mesh of 131 faces or more.\n";
    return EXIT_FAILURE;
  }
  std::vector<Face_location> points;
  for(unsigned i : {0u, 40u, 90u, 130u})
    points.push_back({Mesh::Face_index(i), {{0.5, 0.3, 0.2}}});

  std::vector<Kernel::Point_3> path, curve, spline;
  try {
    const auto geodesic = FG::geodesic_path(mesh, points.front(), points.back(), std::back_inserter(path));
    const auto bezier = FG::geodesic_spline(mesh, points, FG::Spline_kind::BEZIER, std::back_inserter(curve),
                                            CGAL::parameters::number_of_iterations(6));
    const auto b_spline =
        FG::geodesic_spline(mesh, points, FG::Spline_kind::CUBIC_B_SPLINE, std::back_inserter(spline));
    std::cout << "The geodesic is " << geodesic.report.curves.front().length << " long, the Bezier curve "
              << bezier.report.curves.front().length << ", the B-spline " << b_spline.report.curves.front().length
              << ".\n";
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return write_polylines<Kernel::Point_3>("geodesic_spline.polylines.txt", {path, curve, spline}) && std::cout.flush()
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
