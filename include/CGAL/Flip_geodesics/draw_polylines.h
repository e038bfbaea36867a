// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DRAW_POLYLINES_H
#define CGAL_FLIP_GEODESICS_DRAW_POLYLINES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Completes a polyline of which points in a row need not lie in a common face, such as positions of a pen: where they
 * do not, a geodesic between them is put in, as the points where it crosses edges.
 *
 * \return the polyline, for `draw_polyline()` and `snap_polyline()`
 * \pre no edge of the triangulation has been flipped; it is the same afterwards
 * \throws Occupied_triangulation_error if there are curves in it, and a geodesic is needed
 * \throws Invalid_curve_error if there are fewer than two points, or three of a closed polyline
 * \throws Disconnected_endpoints_error, and as `draw_polyline()`, `shorten()`
 */
template <class Triangulation>
std::vector<Surface_location> complete_polyline(Triangulation& triangulation,
                                                const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  const auto& input = triangulation.input();
  if(polyline.size() < (is_closed ? 3u : 2u))
    throw Invalid_curve_error("a polyline needs two points, a closed one three");
  std::vector<Surface_location> result;
  for(std::size_t i = 0; i < polyline.size(); ++i) {
    const Surface_location p = internal::canonical_location(input, polyline[i]);
    result.push_back(p);
    if(i + 1 == polyline.size() && !is_closed)
      break;
    const Surface_location q = internal::canonical_location(input, polyline[(i + 1) % polyline.size()]);
    if(internal::common_face(input, p, q) != null_index)
      continue;
    auto between = internal::Path_straightener<Triangulation>(triangulation).shortest(p, q);
    for(Surface_location& crossing : between)
      for(double& weight : crossing.weights)
        weight = weight < internal::zero_weight ? 0 : weight; // as close to a vertex as that, it is inserted there
    result.insert(result.end(), between.begin() + 1, between.end() - 1);
  }
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Draws a polyline that runs anywhere on the mesh into a network, by making its points vertices [SC20, Figure 9]: a
 * curve whose nodes are fixed at all its points. Its segments become edges of the triangulation, for which edges in
 * their input faces are flipped; a segment that passes a vertex consists of several edges. So the curve is the polyline
 * itself. `Edge_path_network::free_nodes()` allows it to be shortened.
 *
 * Which edges a segment crosses is decided exactly, by the weights of the points. Polylines may be drawn one after
 * another. They may meet at vertices and overlap; `order_overlapping_curves()` then detects whether they cross there.
 * Segments that cross elsewhere cannot be edges of one triangulation, and are refused.
 *
 * \param polyline the points; each two in a row lie in a common face or on a common edge of the input. A closed polyline
 *        does not repeat the first. Points that repeat the one before are skipped.
 * \return the curve's index
 * \pre no edge of the triangulation in these faces crosses an input edge
 * \throws Invalid_curve_error if two points in a row are in no common face, or there are too few
 * \throws Crossing_curves_error if a segment crosses another one, or a curve of the network, between vertices;
 *         `elements()` are the ends of the edge that is crossed. No curve is added then, but points of the polyline may
 *         have become vertices
 * \throws Invalid_location_error, and as `Edge_path_network::insert()`
 */
template <class Network>
Curve_index draw_polyline(Network& network, const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  const auto points = internal::canonical_polyline(network.triangulation().input(), polyline, is_closed);
  return internal::add_chain(network, internal::Polyline_drawer<Network>(network)(points), is_closed);
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The vertices of a path of input edges in the isotopy class of a polyline: each point on an edge moves to its nearer
 * end, and so do the ends of an open polyline. No vertex is added, and the path ends at vertices of the mesh.
 *
 * \param polyline as for `draw_polyline()`
 * \return the vertices of the path, for `halfedges_through()`; fewer than two if the polyline shrinks to a vertex. A
 *         closed path does not repeat the first.
 * \throws Invalid_curve_error, Invalid_location_error as `draw_polyline()`
 */
template <class Triangulation>
std::vector<Vertex_index> snap_polyline(const Triangulation& triangulation,
                                        const std::vector<Surface_location>& polyline, bool is_closed = false)
{
  const auto& input = triangulation.input();
  const auto points = internal::canonical_polyline(input, polyline, is_closed);
  std::vector<Vertex_index> path;
  for(std::size_t i = 0; i + (is_closed ? 1 : 0) < points.size(); ++i) {
    const Surface_location& p = points[i];
    const bool is_end = !is_closed && (i == 0 || i + 1 == points.size());
    if(kind(p) == Location_kind::FACE && !is_end)
      continue; // the path crosses the face from one of its vertices to another
    const Vertex_index v = internal::nearest_vertex(input, p);
    if(!path.empty() && path.back() == v)
      continue;
    if(path.size() > 1 && path[path.size() - 2] == v)
      path.pop_back(); // to and fro
    else
      path.push_back(v);
  }
  while(is_closed && path.size() > 1 && path.front() == path.back())
    path.pop_back();
  return path;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_DRAW_POLYLINES_H
