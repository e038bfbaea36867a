// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Draws a closed polyline across the faces of a mesh, shortens it, and snaps the drawn polyline to a path of edges.
// The polyline passes through the points of the mesh that are nearest to the points of a circle above the mesh.
//
//   drawn_polyline_example MESH
//
// Writes drawn_polyline.vtp, the three curves.

#include <CGAL/Flip_geodesics.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= 1060000000
using Tree_traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
using Tree_traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

// Returns the points of the mesh that are nearest to some points of a circle above it.
std::vector<FG::Surface_location> pen_positions(const Triangulation& triangulation, const Mesh& mesh)
{
  CGAL::AABB_tree<Tree_traits> tree;
  PMP::build_AABB_tree(mesh, tree);
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const Kernel::Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, box.zmax());
  std::vector<FG::Surface_location> result;
  for(double t = 0; t < 6.2; t += 0.3) {
    const Kernel::Point_3 pen = center + box.x_span() / 3 * Kernel::Vector_3(std::cos(t), std::sin(t), 0);
    result.push_back(FG::surface_location(triangulation, mesh, PMP::locate_with_AABB_tree(pen, tree, mesh)));
  }
  return result;
}

int main(int argc, char** argv)
try {
  Mesh mesh;
  if(argc < 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
    throw std::invalid_argument("specify the file of a triangle mesh");
  Triangulation triangulation(mesh);
  const auto line =
      FG::complete_polyline(triangulation, pen_positions(triangulation, mesh), CGAL::parameters::is_closed(true));
  std::vector<std::vector<Kernel::Point_3>> curves(3);
  Network network(triangulation);
  FG::Curve_extractor<Network> extractor(network);
  const FG::Curve_index drawn = FG::draw_polyline(network, line, CGAL::parameters::is_closed(true));
  FG::order_overlapping_curves(network);
  FG::shorten(network); // the result is the polyline itself, since its points are fixed
  extractor.points(drawn, std::back_inserter(curves[0]));
  const double drawn_length = network.length(drawn);
  network.free_nodes(drawn);
  FG::shorten(network);
  extractor.points(drawn, std::back_inserter(curves[1]));
  std::cout << "drawn: " << drawn_length << ", shortened: " << network.length(drawn);
  network.clear();
  triangulation.rollback(); // this also removes the inserted points
  const auto path =
      FG::halfedges_through(triangulation, FG::snap_polyline(triangulation, line, CGAL::parameters::is_closed(true)),
                            CGAL::parameters::is_closed(true));
  const FG::Curve_index snapped = network.add_curve(path, CGAL::parameters::is_closed(true));
  extractor.points(snapped, std::back_inserter(curves[2]));
  std::cout << ", snapped to edges: " << network.length(snapped) << '\n';
  FG::IO::write_VTP("drawn_polyline.vtp", curves);
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
} catch(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
