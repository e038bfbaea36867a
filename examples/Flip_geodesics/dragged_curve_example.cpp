// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Moves the end of a geodesic along edges from one vertex to another, and undoes half of the moves.
//
//   dragged_curve_example MESH SOURCE TARGET NEW_TARGET
//
// Writes drag.vtp, with the geodesic after each move.

#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 5 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::invalid_argument("specify the file of a triangle mesh, and three vertices");
  Triangulation triangulation(mesh);
  const auto vertex = [&](const std::string& text) {
    std::istringstream in(text);
    Mesh::size_type v = 0;
    if(!(in >> v && in.eof()) || v >= mesh.number_of_vertices() || mesh.is_isolated(Mesh::Vertex_index(v)))
      throw std::invalid_argument("the mesh has no vertex " + text);
    return FG::Vertex_index(static_cast<FG::Index>(v));
  };
  const FG::Vertex_index target = vertex(argv[3]), new_target = vertex(argv[4]);
  //! [Editor]
  FG::Curve_editor<Triangulation> editor(triangulation,
                                         {triangulation.location(vertex(argv[2])), triangulation.location(target)});
  //! [Editor]

  // The end of the curve moves to each vertex of an edge path in turn.
  std::vector<std::vector<Point_3>> curves;
  for(FG::Halfedge_index h : FG::Shortest_edge_path<Triangulation>(triangulation)(target, new_target)) {
    //! [Move]
    editor.move(1, triangulation.location(triangulation.head(h)));
    //! [Move]
    curves.emplace_back();
    for(const FG::Surface_location& p : editor.leg(0))
      curves.back().push_back(FG::point_in_space(triangulation, FG::surface_point(triangulation, p)));
    std::cout << editor.length() << ", " << to_string(editor.verdict(0)) << '\n';
  }
  for(std::size_t i = 0; i < curves.size() / 2; ++i)
    editor.undo();
  std::cout << "After undoing, " << editor.number_of_moves() << " moves remain, and the length is " << editor.length()
            << '\n';
  FG::IO::write_VTP("drag.vtp", mesh, curves);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
