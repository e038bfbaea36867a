// SPDX-License-Identifier: LGPL-3.0-or-later

/*
 * Includes and instantiates the parts of the package that most tests and examples use, for a `Surface_mesh` with
 * certified predicates. For tests, whose points are those of Simple_cartesian<double>, the parts are instantiated with
 * predicates in double as well. clang++ precompiles this header, and generates the code of the instances once for all
 * programs (see Flip_geodesics_shared_instances.cmake). No program depends on this header: a template that is missing
 * here is instantiated where it is used.
 */

#ifndef FLIP_GEODESICS_SHARED_INSTANCES_H
#define FLIP_GEODESICS_SHARED_INSTANCES_H

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost_mp.h>

#include <iterator>
#include <string>
#include <vector>

namespace Flip_geodesics_shared {

#ifdef FLIP_GEODESICS_SHARED_FOR_EXAMPLES
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
#else
using Kernel = CGAL::Simple_cartesian<double>;
#endif
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// Instantiates the most frequently used functions of a network and its triangulation. This function is never called.
template <class Network>
void use_network(Network& network, const Surface& mesh)
{
  namespace FG = CGAL::Flip_geodesics;
  using Triangulation = typename Network::Triangulation;
  FG::Shortest_edge_path<Triangulation> search(network.triangulation());
  const std::vector<FG::Vertex_index> ends(2);
  const std::vector<FG::Halfedge_index> path = FG::shortest_halfedges_through(search, ends);
  const FG::Curve_index curve = network.add_curve(path);
  FG::add_straightened_path(network, path);
  FG::add_shortest_path(network, search, ends[0], ends[1]);
  FG::order_overlapping_curves(network);
  FG::shorten(network);
  FG::certify(network);
  network.is_valid();
  std::vector<Surface::Point> points;
  FG::Curve_extractor<Network>(network).points(curve, std::back_inserter(points));
  FG::refine(network);
  FG::insert_curves(network, mesh);
  FG::cut_along_curves(network, mesh);
}

/// Instantiates the most frequently used functions of a triangulation. This function is never called.
template <class Triangulation>
void use_triangulation(const Surface& mesh)
{
  namespace FG = CGAL::Flip_geodesics;
  Triangulation triangulation(mesh);
  FG::Edge_path_network<Triangulation> network(triangulation);
  use_network(network, mesh);
  FG::flip_to_delaunay(triangulation);
  FG::common_subdivision(triangulation, mesh);
  triangulation.is_valid();
  FG::Geodesic_tree<Triangulation> tree(triangulation);
  tree.grow(FG::Vertex_index(0));
  FG::make_shortest(tree);
  FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  field.add_source(FG::Vertex_index(0));
  field.compute();
}

inline void use_package(const std::string& file_name)
{
  namespace FG = CGAL::Flip_geodesics;
  Surface mesh;
  CGAL::IO::read_polygon_mesh(file_name, mesh);
  use_triangulation<FG::Intrinsic_triangulation<Surface>>(mesh);
#ifndef FLIP_GEODESICS_SHARED_FOR_EXAMPLES
  use_triangulation<FG::Intrinsic_triangulation<Surface, FG::Intrinsic_triangulation_traits<Kernel>>>(mesh);
#endif
  const auto v = *mesh.vertices().begin();
  std::vector<Surface::Point> points;
  FG::geodesic_path(mesh, v, v, std::back_inserter(points));
  FG::shortest_path(mesh, v, v, std::back_inserter(points));
  std::vector<double> distances(mesh.number_of_vertices());
  FG::geodesic_distances(mesh, v, CGAL::make_property_map(distances));
}

} // namespace Flip_geodesics_shared

#endif // FLIP_GEODESICS_SHARED_INSTANCES_H
