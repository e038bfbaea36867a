// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A polyline that is drawn on a mesh, across its faces: kept as it is, pulled tight, and snapped to a path of edges.
// Here it is a level line of a function that is given at the vertices.
//
//   drawn_polyline_example [MESH]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/draw_polylines.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

// Negative below a wavy sheet through the middle of the mesh.
std::vector<double> heights(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span()), middle = (box.zmin() + box.zmax()) / 2;
  std::vector<double> result;
  for(const auto v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    result.push_back(p.z() - middle - size / 40 * std::sin(20 * p.x() / size) * std::cos(20 * p.y() / size));
  }
  return result;
}

// The first line on which the function is zero, as points of edges. It is closed unless it ends at the border.
std::vector<FG::Surface_location> level_line(const Triangulation& triangulation, const Mesh& mesh,
                                             const std::vector<double>& f, bool& is_closed)
{
  std::vector<FG::Surface_location> line;
  const auto enters = [&](Mesh::Halfedge_index h) { return f[mesh.source(h)] < 0 && f[mesh.target(h)] >= 0; };
  for(const auto start : mesh.halfedges()) {
    if(!enters(start) || mesh.is_border(start))
      continue;
    Mesh::Halfedge_index h = start;
    do {
      const double t = f[mesh.source(h)] / (f[mesh.source(h)] - f[mesh.target(h)]);
      line.push_back({triangulation.input().index(h), {{1 - t, t, 0}}});
      if(mesh.is_border(h))
        break;
      const auto next = mesh.opposite(mesh.next(h));
      h = enters(next) ? next : mesh.opposite(mesh.prev(h));
    } while(h != start);
    is_closed = h == start;
    break;
  }
  return line;
}

std::vector<Point_3> points_of(const Network& network, FG::Curve_index curve)
{
  std::vector<Point_3> points;
  FG::Curve_extractor<Network>(network).points(curve, std::back_inserter(points));
  return points;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh, 48, 24) > 0;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty()) {
    std::cerr << "This is not a triangle mesh.\n";
    return EXIT_FAILURE;
  }
  std::vector<std::vector<Point_3>> curves;
  try {
    Triangulation triangulation(mesh);
    bool is_closed = false;
    const std::vector<FG::Surface_location> line = level_line(triangulation, mesh, heights(mesh), is_closed);
    Network network(triangulation);
    const FG::Curve_index drawn = FG::draw_polyline(network, line, is_closed);
    FG::order_overlapping_curves(network);
    FG::shorten(network); // to the polyline itself, since its points are fixed
    curves.push_back(points_of(network, drawn));
    std::cout << "drawn: " << network.length(drawn);
    network.free_nodes(drawn);
    FG::shorten(network);
    curves.push_back(points_of(network, drawn));
    std::cout << ", pulled tight: " << network.length(drawn);
    network.clear();
    triangulation.rollback(); // the inserted points are gone, too

    const std::vector<FG::Vertex_index> path = FG::snap_polyline(triangulation, line, is_closed);
    const FG::Curve_index snapped = network.add_curve(FG::halfedges_through(triangulation, path, is_closed), is_closed);
    curves.push_back(points_of(network, snapped));
    std::cout << ", snapped to edges: " << network.length(snapped) << '\n';
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return write_polylines("drawn_polyline.polylines.txt", curves) && std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
