// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Geodesics from one vertex to all others, as a tree in one triangulation, and the logarithmic map that comes of it:
// polar coordinates about the source, written as the texture coordinates of a mesh.
//
//   geodesic_tree_example [MESH [SOURCE]]

#include "kept_input.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/logarithmic_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>

namespace FG = CGAL::Flip_geodesics;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

// Faces with a vertex that has no path are left out.
bool write_textured_obj(const char* file, const Mesh& mesh, const Triangulation& triangulation,
                        const FG::Logarithmic_map& map)
{
  std::ofstream out(file);
  for(const auto v : mesh.vertices()) {
    const auto [x, y] = map.in_plane(triangulation.index(v));
    out << "v " << mesh.point(v) << "\nvt " << x << ' ' << y << '\n';
  }
  for(const auto f : mesh.faces()) {
    bool is_mapped = true;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const double radius = map.vertices[triangulation.index(v)].radius;
      is_mapped = is_mapped && radius < std::numeric_limits<double>::infinity();
    }
    if(!is_mapped)
      continue;
    out << 'f';
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << ' ' << v + 1 << '/' << v + 1;
    out << '\n';
  }
  return static_cast<bool>(out.flush());
}

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  const FG::Vertex_index source(argc > 2 ? std::atoi(argv[2]) : 0);
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  if(!is_input_kept(argc, argv, {"logarithmic_map.obj"}))
    return EXIT_FAILURE;
  try {
    Triangulation triangulation(mesh);
    FG::Geodesic_tree<Triangulation> tree(triangulation);
    const FG::Geodesic_tree_report report = tree.grow(source);
    std::cout << report.flips << " flips; the paths are " << FG::to_string(report.status) << '\n';
    const FG::Logarithmic_map map = FG::logarithmic_map(tree);
    const bool is_written = write_textured_obj("logarithmic_map.obj", mesh, triangulation, map);
    return is_written && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
