// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/flattened_mesh.h"

#include "advice.h"
#include "bad_input.h"
#include "readable.h"

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Flip_geodesics/Conformal_flattening.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/cut_graph.h>
#include <CGAL/Flip_geodesics/geodesic_loops.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <boost/property_map/property_map.hpp>
#endif

#include <algorithm>
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

void cut_open(Network& network, const Network_request& cut, Progress_visitor& visitor)
{
  if(cut.is_cut_graph) {
    FG::add_cut_graph(network, CGAL::parameters::visitor(std::ref(visitor)));
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

// Scale factors that vary much, as on a cube, exist in small faces only, so that these are made smaller until they do.
FG::Conformal_flattening<Triangulation> refined_and_flattened(const Mesh& mesh, const std::string& name,
                                                              Network& network, Progress_visitor& visitor,
                                                              Progress& progress)
{
  FG::Refinement_options bounds;
  for(const double part : {1. / 8, 1. / 16, 0.}) { // of the size of the mesh, for the next time
    progress.enter("refining", "steps");
    FG::refine(network, bounds, CGAL::parameters::visitor(std::ref(visitor)));
    progress.enter("flattening");
    try {
      return FG::Conformal_flattening<Triangulation>(network);
    } catch(const FG::Flattening_error& error) {
      if(error.elements().empty()) // the cut is wrong, whatever the faces
        throw;
    }
    bounds.longest_edge = part * size_of(mesh);
  }
  throw Bad_input(
      name +
      ": the mesh cannot be flattened: it would be stretched too much at interior vertices; cut through its "
      "sharpest corners: pass a --network whose curves reach them, with a line `! v ...` that fixes these vertices");
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

std::size_t number_of_faces_not_counterclockwise(const Mesh& mesh, Texture_map texture)
{
  return static_cast<std::size_t>(std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    return !CGAL::left_turn(texture[h], texture[mesh.next(h)], texture[mesh.prev(h)]);
  }));
}

std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  return CGAL::Polygon_mesh_processing::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh)));
}

} // namespace

Flattened_mesh flattened_mesh(const Mesh& mesh, const std::string& name, const Network_request& cut, Progress& progress)
try {
  Triangulation triangulation(mesh);
  Network network(triangulation);
  Progress_visitor visitor(progress);
  progress.enter("cutting", "steps");
  cut_open(network, cut, visitor);
  const auto flattening = refined_and_flattened(mesh, name, network, visitor, progress);
  auto subdivision = FG::common_subdivision(triangulation, mesh);
  const Texture_map texture = texture_of(subdivision.mesh());
  flattening.carry_to(subdivision, texture);
  unite_corners(subdivision, network, texture);
  const std::size_t turned = number_of_faces_not_counterclockwise(subdivision.mesh(), texture);
  std::ostringstream report;
  report << counted(static_cast<std::size_t>(network.number_of_curves()), "cut", "cuts") << "; "
         << readable(subdivision.mesh().number_of_vertices()) << " vertices, flattened in "
         << counted(static_cast<std::size_t>(flattening.iterations()), "step", "steps") << "; angle sums within "
         << flattening.angle_error() << " radians, positions within " << flattening.layout_error() << " of the size\n";
  std::string defect;
  if(turned > 0)
    defect = "the texture is not injective: in the plane, " + counted(turned, "triangle is", "triangles are") +
             " degenerate or turned over; remesh the surface, or cut it differently by --network";
  return {std::move(subdivision.mesh()), report.str(), defect};
} catch(const FG::Error& error) {
  const bool is_degenerate = dynamic_cast<const FG::Degenerate_face_error*>(&error) != nullptr;
  const std::size_t components = is_degenerate ? 1 : number_of_components(mesh);
  throw Bad_input(name + ": the mesh cannot be flattened: " +
                  (components > 1 ? "it has " + readable(components) + " components; flatten them separately"
                                  : with_advice_to_repair(error)));
}

#else

Flattened_mesh flattened_mesh(const Mesh&, const std::string&, const Network_request&, Progress&)
{
  throw Bad_input(
      "the program was compiled without Eigen, which flattening requires; install Eigen and compile it again");
}

#endif

} // namespace program
