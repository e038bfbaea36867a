// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Geodesics with their mesh and their ends in files for viewers.
//
//   write_files_example [MESH]

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/Tubes.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc > 1)
    CGAL::IO::read_polygon_mesh(argv[1], mesh);
  else // hills
    CGAL::make_grid(
        40, 40, mesh, [](double i, double j) { return Point_3(i, j, 3 * std::sin(0.4 * i) * std::cos(0.3 * j)); },
        true);
  if(mesh.number_of_faces() == 0 || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }

  // From the first vertex to some others.
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
  FG::IO::write_VTP("geodesics.vtp", mesh, paths, ends);                     // for ParaView
  FG::IO::write_GLB("geodesics.glb", mesh, paths, FG::IO::Tubes(thickness)); // for Blender and browsers
  FG::IO::write_OBJ("geodesics.obj", paths);                                 // lines alone
  FG::IO::write_PLY("ends.ply", ends, CGAL::parameters::use_binary_mode(false).stream_precision(6));

  std::cout << count << " geodesics are in geodesics.vtp, geodesics.glb and geodesics.obj.\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const FG::Error& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
