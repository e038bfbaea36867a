// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes a geodesic between points inside faces, and a Bezier curve and a B-spline with control points inside faces.
//
//   geodesic_spline_example MESH
//
// Writes geodesic_spline.vtp, the three curves.

#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>; // as in Polygon Mesh Processing

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  if(mesh.number_of_faces() < 131)
    throw std::invalid_argument("the control points lie in faces 0, 40, 90 and 130, but the mesh has fewer faces");
  std::vector<Face_location> points;
  for(unsigned i : {0u, 40u, 90u, 130u})
    points.push_back({Mesh::Face_index(i), {{0.5, 0.3, 0.2}}});

  std::vector<std::vector<Kernel::Point_3>> curves(3);
  const auto geodesic = FG::geodesic_path(mesh, points.front(), points.back(), std::back_inserter(curves[0]));
  //! [Bezier]
  const auto bezier = FG::geodesic_spline(mesh, points, FG::Spline_kind::BEZIER, std::back_inserter(curves[1]),
                                          CGAL::parameters::number_of_iterations(6));
  const auto b_spline =
      FG::geodesic_spline(mesh, points, FG::Spline_kind::CUBIC_B_SPLINE, std::back_inserter(curves[2]));
  //! [Bezier]
  std::cout << "The geodesic is " << geodesic.length() << " long, the Bezier curve " << bezier.length()
            << ", and the B-spline " << b_spline.length() << ".\n";
  FG::IO::write_VTP("geodesic_spline.vtp", curves);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
