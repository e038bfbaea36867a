// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Writes the torus with bumps that the examples use, of any size: a mesh to try flip_geodesics on.
//
//   generate_torus FILE [VERTICES_AROUND [VERTICES_ALONG]]

#include "../Flip_geodesics/torus.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

int main(int argc, char** argv)
{
  if(argc < 2) {
    std::cerr << "generate_torus: say which file to write\n";
    return EXIT_FAILURE;
  }
  const std::size_t around = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 400;
  const std::size_t along = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 200;
  if(around < 3 || along < 3) {
    std::cerr << "generate_torus: 3 vertices are the least in each direction\n";
    return EXIT_FAILURE;
  }
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  make_torus(mesh, around, along);
  if(!CGAL::IO::write_polygon_mesh(argv[1], mesh, CGAL::parameters::stream_precision(17))) {
    std::cerr << "generate_torus: cannot write " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
