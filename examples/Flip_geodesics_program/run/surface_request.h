// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_REQUEST_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_REQUEST_H

#include "input/requests.h"
#include "run/curve_engine.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Requests on a mesh, on the surface that is left when its degenerate edges are contracted.
namespace program {

/// A request on the surface, and which of its curves are left; the others have shrunk to a point.
struct Surface_request
{
  Network_request request;
  /// Of each requested curve: the point that it has become, if that is all that is left of it.
  std::vector<std::optional<CGAL::Flip_geodesics::Surface_point>> places;
};

/// A curve of which nothing is known but the request.
inline Curve_result make_result(const Curve_request& request)
{
  Curve_result result;
  result.name = request.name;
  result.is_closed = request.is_closed;
  if(!request.is_closed && !request.vertices.empty()) {
    result.source = request.vertices.front();
    result.target = request.vertices.back();
  }
  return result;
}

/// The same for a tree or a cut graph.
inline Curve_result whole_result(const Network_request& request)
{
  Curve_result result;
  result.name = request.tree_source ? "the tree" : "the cut graph";
  return result;
}

/// Where a curve lies. Curves along edges keep the mesh's vertices, since these determine which edges are meant.
/// \return the point, if that is all that is left of it
template <class Triangulation>
std::optional<CGAL::Flip_geodesics::Surface_point> put_on_surface(const Triangulation& triangulation,
                                                                  Curve_request& curve)
{
  namespace FG = CGAL::Flip_geodesics;
  if(!curve.points.empty()) {
    curve.points = FG::internal::points_on_surface(triangulation, curve.points);
    const bool is_one = std::all_of(curve.points.begin(), curve.points.end(), [&](const FG::Surface_location& at) {
      return are_in_one_place(triangulation.input(), at, curve.points.front());
    });
    return is_one && curve.points.size() > 1
               ? std::make_optional(FG::surface_point(triangulation, curve.points.front()))
               : std::nullopt;
  }
  bool is_point = false;
  const Vertex_index v = FG::internal::vertex_on_surface(triangulation, curve.vertices.front());
  if(curve.is_pair) {
    curve.vertices = {v, FG::internal::vertex_on_surface(triangulation, curve.vertices.back())};
    is_point = v == curve.vertices.back();
  } else if(triangulation.input().is_contracted()) {
    is_point = FG::internal::halfedges_on_surface(triangulation, curve.vertices, curve.is_closed).empty();
  }
  return is_point ? std::make_optional(FG::Surface_point{v, v, 0, FG::null_index, FG::null_index, 0, v}) : std::nullopt;
}

/// The request on the surface of a triangulation over it.
template <class Triangulation>
Surface_request surface_request(const Triangulation& triangulation, const Network_request& request)
{
  namespace FG = CGAL::Flip_geodesics;
  Surface_request result;
  result.request.is_cut_graph = request.is_cut_graph;
  for(Curve_request curve : request.curves) {
    result.places.push_back(put_on_surface(triangulation, curve));
    if(!result.places.back())
      result.request.curves.push_back(curve);
  }
  for(Vertex_index v : request.fixed_vertices)
    result.request.fixed_vertices.push_back(FG::internal::vertex_on_surface(triangulation, v));
  if(request.tree_source)
    result.request.tree_source = FG::internal::points_on_surface(triangulation, {*request.tree_source}).front();
  return result;
}

/// A curve that has shrunk to a point.
template <class Triangulation>
void make_point(const Triangulation& triangulation, const CGAL::Flip_geodesics::Surface_point& p, Curve_result& result)
{
  namespace FG = CGAL::Flip_geodesics;
  result.status = to_string(FG::Shortening_status::CONTRACTED);
  result.initial_length = result.length = 0;
  result.smallest_angle = std::numeric_limits<double>::infinity();
  if(!Triangulation::Traits::Has_drift::value)
    result.certificate = to_string(FG::Verdict::PROVEN);
  if(!result.is_closed)
    result.points.assign(2, {p, FG::point_in_space(triangulation, p), true});
}

/// What is known of a vertex in a tree holds for all vertices of the mesh that lie in its place.
template <class Triangulation>
void put_on_mesh(const Triangulation& triangulation, std::vector<Curve_result>& tree,
                 std::optional<CGAL::Flip_geodesics::Vertex_logarithmic_map>& map)
{
  for(Curve_result& result : tree)
    result.are_zero_edges_contracted = true;
  for(Vertex_index v(0); map && v.idx() < triangulation.input().number_of_vertices(); ++v)
    (*map)[v] = (*map)[CGAL::Flip_geodesics::internal::vertex_on_surface(triangulation, v)];
}

/// Lets a curve that ends at vertices start and end at the requested ones, which lie in the same places.
inline void put_on_mesh(const Curve_request& request, Curve_result& result)
{
  result.are_zero_edges_contracted = true;
  if(request.is_closed || request.vertices.empty() || result.points.empty())
    return;
  result.source = request.vertices.front();
  result.target = request.vertices.back();
  const auto put = [](Curve_point& point, Vertex_index v) { point.on_surface.a = point.on_surface.b = v; };
  put(result.points.front(), result.source);
  put(result.points.back(), result.target);
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_REQUEST_H
