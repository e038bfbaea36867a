// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Writes geodesics, their mesh and their end points to files for viewers.
//
//   write_files_example MESH
//
// The files are geodesics.vtp, geodesics.glb and ends.ply.

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/IO/appearance.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  if(std::error_code absent; std::filesystem::equivalent(argv[1], "ends.ply", absent))
    throw std::invalid_argument("the result would replace the mesh; rename the file of the mesh");

  // Paths from the first vertex to some others.
  const Mesh::Vertex_index source(0);
  const unsigned int most = mesh.number_of_vertices() - 1, count = (std::min)(most, 6u);
  std::vector<std::vector<Point_3>> paths(count);
  std::vector<Point_3> ends = {mesh.point(source)};
  for(unsigned int i = 0; i < count; ++i) {
    const Mesh::Vertex_index target((i + 1) * (most / count));
    FG::geodesic_path(mesh, source, target, std::back_inserter(paths[i]));
    ends.push_back(mesh.point(target));
  }

  const CGAL::Bbox_3 box = CGAL::bbox_3(ends.begin(), ends.end());
  const double thickness = 0.005 * std::hypot(box.x_span(), box.y_span(), box.z_span());
  //! [Files]
  FG::IO::write_VTP("geodesics.vtp", mesh, paths, ends);                     // for ParaView
  FG::IO::write_GLB("geodesics.glb", mesh, paths, FG::IO::Tubes(thickness)); // for Blender and browsers
  FG::IO::write_PLY("ends.ply", ends, CGAL::parameters::use_binary_mode(false).stream_precision(6));
  //! [Files]

  std::cout << count << " geodesics have been written to geodesics.vtp and geodesics.glb.\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
