// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A metric of lengths on the edges instead of points: here steps in direction z cost more, so that geodesics avoid
// them.
//
//   edge_length_metric_example [MESH [COST]]

#include "polylines_io.h"
#include "torus.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace FG = CGAL::Flip_geodesics;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Length_map = Mesh::Property_map<Mesh::Edge_index, double>;
using Metric = FG::Edge_length_metric<Mesh, Length_map>;
using Traits = FG::Intrinsic_triangulation_traits<Kernel>;
using Triangulation = FG::Intrinsic_triangulation<Mesh, Traits, Metric>;
using Network = FG::Edge_path_network<Triangulation>;

int main(int argc, char** argv)
{
  Mesh mesh;
  const bool has_mesh = argc > 1 ? CGAL::IO::read_polygon_mesh(argv[1], mesh) : make_torus(mesh) > 0;
  const double cost = argc > 2 ? std::strtod(argv[2], nullptr) : 3;
  if(!has_mesh || !CGAL::is_triangle_mesh(mesh) || mesh.is_empty() || !(cost > 0)) {
    std::cerr << "This is not a triangle mesh, or not a positive cost.\n";
    return EXIT_FAILURE;
  }
  Length_map lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  for(const auto e : mesh.edges()) {
    const Kernel::Vector_3 d = mesh.point(mesh.vertex(e, 1)) - mesh.point(mesh.vertex(e, 0));
    lengths[e] = std::hypot(d.x(), d.y(), cost * d.z());
  }

  std::vector<Kernel::Point_3> points;
  try {
    Triangulation triangulation(mesh, Metric(mesh, lengths));
    FG::Shortest_edge_path<Triangulation> search(triangulation);
    Network network(triangulation);
    const FG::Vertex_index source(0), target(triangulation.number_of_vertices() / 2);
    const FG::Curve_index curve = network.add_curve(search(source, target), false);
    const FG::Shortening_report report = FG::shorten(network);
    std::cout << "In this metric the geodesic is " << report.curves.front().length << " long.\n";
    for(const FG::Surface_point& p : FG::Curve_extractor<Network>(network).surface_points(curve)) {
      const Kernel::Point_3 &a = mesh.point(triangulation.vertex(p.a)), &b = mesh.point(triangulation.vertex(p.b));
      points.push_back(a + p.t * (b - a));
    }
  } catch(const FG::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return write_polylines<Kernel::Point_3>("edge_length_metric.polylines.txt", {points}) && std::cout.flush()
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
