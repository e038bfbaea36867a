// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_FLIPPED_START_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_FLIPPED_START_H

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A path of edges, and the flips of the input that create these edges. */
struct Flipped_start
{
  std::vector<Halfedge_index> flips, path;
};

template <class Triangulation>
Flipped_start flipped_start(const Triangulation& triangulation, const std::vector<Halfedge_index>& path)
{
  Flipped_start result = {{}, path};
  for(std::size_t i = 0; i < triangulation.log_position(); ++i)
    if(triangulation.flip_record(i).is_flip())
      result.flips.push_back(triangulation.flip_record(i).h);
  return result;
}

/* Returns the current path of the only curve of a network. */
template <class Network>
Flipped_start flipped_start_of(const Network& network)
{
  std::vector<Halfedge_index> path;
  network.for_each_segment(Curve_index(0), [&](Segment_index s) { path.push_back(network.halfedge(s)); });
  return flipped_start(network.triangulation(), path);
}

/* Shortens the path to a geodesic, as the only curve of a network. */
template <class Network, class Visitor>
Shortening_report pull_tight(Network& network, const Flipped_start& start, Visitor& visitor)
{
  network.clear();
  network.triangulation().rollback(0);
  for(Halfedge_index h : start.flips)
    network.triangulation().flip(h);
  network.add_curve(start.path, false);
  return shorten(network, Never_stop_predicate(), visitor);
}

/* Adds the steps of a path that was replaced, and the flips that led to the new path. */
inline void count_before(Shortening_report& shortening, const Shortening_report& before, std::size_t flips)
{
  shortening.curves[0].initial_length = before.curves[0].initial_length;
  shortening.flips += before.flips + flips;
  shortening.flip_outs += before.flip_outs;
}

/* Returns whether a face has one side as long as the two others together, up to rounding errors, while the metric
 * represents all faces by vectors. Trees of geodesics can then be grown in an intrinsic Delaunay triangulation. Linear
 * in the mesh. */
template <class Triangulation>
bool has_flat_face(const Triangulation& triangulation)
{
  const auto& input = triangulation.input();
  const auto length = [&](Input_halfedge_index h) { return triangulation.metric().weight(input, h); };
  bool result = false;
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(input.is_border(h))
      continue;
    if(!is_usable_face(triangulation.metric(), input, h))
      return false;
    const Input_halfedge_index hn = input.next(h);
    result = result || length(h) >= (length(hn) + length(input.next(hn))) * (1 - length_sum_rounding);
  }
  return result;
}

/* Returns the path of a geodesic tree grown in an intrinsic Delaunay triangulation of the input. */
template <class Network>
std::vector<Halfedge_index> path_in_tree(Network& network, Vertex_index from, Vertex_index to)
{
  using Triangulation = typename Network::Triangulation;
  network.clear();
  network.triangulation().rollback(0);
  flip_to_delaunay(network.triangulation());
  Geodesic_tree<Triangulation> tree(network.triangulation());
  tree.grow(from);
  return tree.path(to);
}

/*
 * Initial paths that window propagation misses beside degenerate faces, where straight rays cannot be followed. An
 * intrinsic Delaunay triangulation has no such faces except at coincident vertices, so that the path of a tree grown
 * there is usually a shortest one. One tree is grown from either end.
 */
template <class Network>
std::vector<Flipped_start> starts_in_trees(Network& network, Vertex_index source, Vertex_index target)
{
  using Triangulation = typename Network::Triangulation;
  std::vector<Flipped_start> result;
  std::vector<Halfedge_index> path = path_in_tree(network, source, target);
  if(!path.empty())
    result.push_back(flipped_start(network.triangulation(), path));
  path = path_in_tree(network, target, source);
  std::reverse(path.begin(), path.end());
  std::transform(path.begin(), path.end(), path.begin(), [](Halfedge_index h) { return Triangulation::twin(h); });
  if(!path.empty())
    result.push_back(flipped_start(network.triangulation(), path));
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_FLIPPED_START_H
