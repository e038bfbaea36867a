// SPDX-License-Identifier: LGPL-3.0-or-later

#include "messages.h"
#include "program_options.h"
#include "run/computations.h"

#ifdef CGAL_EIGEN3_ENABLED
#include "run/limited_subdivision.h"

#include <CGAL/Flip_geodesics/Conformal_flattening.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <boost/property_map/property_map.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace program {

#ifdef CGAL_EIGEN3_ENABLED

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;

// Adds a path from a vertex to the border or a curve of a network, whose edges are still those of the mesh.
void join(Network& network, const Mesh& mesh, Vertex_index from)
{
  const Triangulation& triangulation = network.triangulation();
  std::vector<char> is_cut(mesh.number_of_vertices(), 0);
  Vertex_index to = from;
  const auto add = [&](Vertex_index v) {
    is_cut[static_cast<std::size_t>(v.idx())] = 1;
    to = v;
  };
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h))
      add(index_of(mesh.target(h)));
  for(const FG::Curve_index c : network.curves())
    for(const FG::Halfedge_index h : network.halfedges(c))
      for(const Vertex_index v : {triangulation.tail(h), triangulation.head(h)})
        add(v);
  std::vector<FG::Halfedge_index> path = FG::Shortest_edge_path<Triangulation>(triangulation)(from, to);
  const auto last = std::find_if(path.begin(), path.end(), [&](FG::Halfedge_index h) {
    return is_cut[static_cast<std::size_t>(triangulation.head(h).idx())] != 0;
  });
  if(last == path.end())
    return;
  path.erase(last + 1, path.end());
  network.add_curve(path);
  network.fix_nodes_at(triangulation.head(path.back()));
}

// Cuts along given curves, or a cut graph that is extended to some vertices.
void cut_open(Network& network, const Mesh& mesh, const Network_request& cut, const std::vector<Vertex_index>& tips,
              Progress_visitor& visitor)
{
  if(cut.is_cut_graph) {
    FG::add_cut_graph(network, CGAL::parameters::visitor(std::ref(visitor)));
    for(const Vertex_index v : tips)
      join(network, mesh, v);
    FG::shorten_cut_graph(network, CGAL::parameters::visitor(std::ref(visitor)));
    return;
  }
  for(const Curve_request& curve : cut.curves)
    network.add_curve(
        FG::halfedges_through(network.triangulation(), curve.vertices, CGAL::parameters::is_closed(curve.is_closed)),
        CGAL::parameters::is_closed(curve.is_closed));
  for(const Vertex_index v : cut.fixed_vertices)
    network.fix_nodes_at(v);
  FG::order_overlapping_curves(network);
  FG::shorten(network, CGAL::parameters::visitor(std::ref(visitor)));
}

// The corners at a vertex inside an uncut edge are one point of the plane. The positions in the two faces of the edge,
// which differ by rounding errors, are replaced by one of them; they differ at no other vertex.
void unite_corners(const FG::Surface_subdivision<Triangulation, Mesh>& subdivision, const Network& network,
                   Texture_map texture)
{
  const Mesh& mesh = subdivision.mesh();
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const auto origin = subdivision.vertex_origin(v);
    if(origin.intrinsic_vertex != FG::null_index || network.is_occupied(origin.intrinsic_halfedge))
      continue;
    const Mesh::Halfedge_index first =
        mesh.is_border(mesh.halfedge(v)) ? mesh.prev_around_target(mesh.halfedge(v)) : mesh.halfedge(v);
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_target(first))
      if(!mesh.is_border(h))
        texture[h] = texture[first];
  }
}

// The triangles that are not counterclockwise in the plane, other than those that are so thin, on the surface or in the
// plane, that this is a rounding error.
std::size_t number_of_turned_faces(const Mesh& mesh, Texture_map texture)
{
  constexpr double least_height = 1e-9, rounding = 1e-12; // of the size of the surface, and of that in the plane
  CGAL::Bbox_2 box;
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      box += texture[h].bbox();
  const double size = size_of(mesh), size_in_plane = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  return static_cast<std::size_t>(std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const std::array<Mesh::Halfedge_index, 3> h = {mesh.halfedge(f), mesh.next(mesh.halfedge(f)),
                                                   mesh.prev(mesh.halfedge(f))};
    double longest = 0, longest_in_plane = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, CGAL::squared_distance(mesh.point(mesh.source(h[i])), mesh.point(mesh.target(h[i]))));
      longest_in_plane = std::max(longest_in_plane, CGAL::squared_distance(texture[h[i]], texture[h[(i + 1) % 3]]));
    }
    const double area = std::sqrt(CGAL::squared_area(mesh.point(mesh.target(h[0])), mesh.point(mesh.target(h[1])),
                                                     mesh.point(mesh.target(h[2]))));
    const double in_plane = CGAL::area(texture[h[0]], texture[h[1]], texture[h[2]]);
    return 2 * in_plane < -rounding * size_in_plane * std::sqrt(longest_in_plane) ||
           (!(in_plane > 0) && 2 * area > least_height * size * std::sqrt(longest));
  }));
}

std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  return CGAL::Polygon_mesh_processing::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh)));
}

Flattened_mesh flattened_along(const Mesh& mesh, const Network_request& cut, const std::vector<Vertex_index>& tips,
                               const Mesh_result_options& options, Progress& progress)
{
  Triangulation triangulation(mesh);
  Network network(triangulation);
  Progress_visitor visitor(progress);
  progress.enter("cutting", "steps");
  cut_open(network, mesh, cut, tips, visitor);
  progress.enter("refining and flattening", "steps");
  const auto number_of_cuts = static_cast<std::size_t>(network.number_of_curves());
  const auto flattening = FG::refine_and_flatten(network, CGAL::parameters::visitor(std::ref(visitor)));
  auto subdivision = limited_subdivision(triangulation, mesh, options);
  const Texture_map texture = texture_of(subdivision.mesh());
  flattening.carry_to(subdivision, texture);
  unite_corners(subdivision, network, texture);
  const std::size_t turned = number_of_turned_faces(subdivision.mesh(), texture);
  std::ostringstream report;
  report << counted(number_of_cuts, "cut", "cuts") << "; " << readable(subdivision.mesh().number_of_vertices())
         << " vertices, flattened in " << counted(static_cast<std::size_t>(flattening.iterations()), "step", "steps")
         << "; angle sums are off by at most " << flattening.angle_error() << " radians, positions by at most "
         << flattening.layout_error() << " of the size of the layout\n";
  std::string defect;
  if(turned > 0)
    defect = "the texture is not injective: in the plane, " + counted(turned, "triangle is", "triangles are") +
             " degenerate or inverted; remesh the surface, or cut it along other curves with --network";
  return {std::move(subdivision.mesh()), report.str(), defect};
}

} // namespace

Flattened_mesh flattened_mesh(const Mesh& mesh, const std::string& name, const Network_request& cut,
                              const Mesh_result_options& options, Progress& progress)
try {
  constexpr std::size_t most_tips = 64;
  std::vector<Vertex_index> tips;
  for(;;)
    try {
      return flattened_along(mesh, cut, tips, options, progress);
    } catch(const FG::Flattening_error& error) {
      // The cut graph is extended to the vertex to which the surface should be cut.
      if(!cut.is_cut_graph || error.elements().empty() || tips.size() == most_tips)
        throw;
      tips.emplace_back(static_cast<Index>(error.elements().front()));
      if(std::find(tips.begin(), tips.end() - 1, tips.back()) != tips.end() - 1)
        throw;
    }
} catch(const FG::Error& error) {
  const bool is_degenerate = dynamic_cast<const FG::Degenerate_face_error*>(&error) != nullptr;
  const std::size_t components = is_degenerate ? 1 : number_of_components(mesh);
  throw Bad_input(name + ": the mesh cannot be flattened because " +
                  (components > 1 ? "it has " + readable(components) + " components; flatten them separately"
                                  : with_advice_to_repair(error)));
}

#else

Flattened_mesh flattened_mesh(const Mesh&, const std::string&, const Network_request&, const Mesh_result_options&,
                              Progress&)
{
  throw Bad_input(
      "the program was compiled without Eigen, which flattening requires; install Eigen and recompile the program");
}

#endif

} // namespace program
