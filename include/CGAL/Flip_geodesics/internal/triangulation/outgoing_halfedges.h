// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OUTGOING_HALFEDGES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OUTGOING_HALFEDGES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * The faces at a vertex form one umbrella, or several at a non-manifold vertex. Each of several umbrellas ends at the
 * border, and the border leads from one to the next. Since border edges are never flipped, the umbrellas of a
 * triangulation are those of its input.
 */

/* Returns the border halfedge at the counterclockwise end of the umbrella that contains a halfedge of its vertex, or
 * null_index if the umbrella has no border. */
template <class Input_mesh>
Input_halfedge_index border_of_umbrella(const Input_mesh& input, Input_halfedge_index h)
{
  Input_halfedge_index g = h;
  do {
    if(input.is_border(g))
      return g;
    g = counterclockwise_of(input, g);
  } while(g != h);
  return null_index;
}

/* Returns the border halfedge of the next umbrella clockwise, which is the same one at a manifold vertex. */
template <class Input_mesh>
Input_halfedge_index next_umbrella(const Input_mesh& input, Input_halfedge_index border)
{
  Input_halfedge_index h = border;
  while(!input.is_border(twin_index(h)))
    h = clockwise_of(input, h);
  return clockwise_of(input, h);
}

/* Returns the border halfedge of the previous umbrella. */
template <class Input_mesh>
Input_halfedge_index previous_umbrella(const Input_mesh& input, Input_halfedge_index border)
{
  Input_halfedge_index result = border;
  for(Input_halfedge_index next = next_umbrella(input, result); next != border; next = next_umbrella(input, result))
    result = next;
  return result;
}

/* Returns the halfedge of a triangulation that leads along a border halfedge of the input from its vertex. */
template <class Triangulation>
Halfedge_index first_outgoing_halfedge(const Triangulation& triangulation, Input_halfedge_index border)
{
  Halfedge_index h = as_intrinsic(border);
  while(triangulation.tail(h) != triangulation.input().tail(border)) { // the edge was split
    Halfedge_index last = h;
    for(Halfedge_index g = triangulation.clockwise(h); g != null_index; g = triangulation.clockwise(g))
      last = g;
    h = Triangulation::twin(last);
  }
  return h;
}

/* Returns a halfedge of a triangulation that starts at the vertex of an input halfedge, in the same umbrella. */
template <class Triangulation>
Halfedge_index outgoing_beside(const Triangulation& triangulation, Input_halfedge_index h)
{
  const auto& input = triangulation.input();
  const Input_halfedge_index border = border_of_umbrella(input, h);
  if(border == null_index || next_umbrella(input, border) == border)
    return triangulation.outgoing(input.tail(h));
  return first_outgoing_halfedge(triangulation, border);
}

/* Calls function(h) for the outgoing halfedges of a vertex, clockwise, in all umbrellas except that of `border`, a
 * border halfedge of the triangulation. */
template <class Triangulation, class Function>
void for_each_outgoing_halfedge_of_other_umbrellas(const Triangulation& triangulation, Halfedge_index border,
                                                   const Function& function)
{
  if(triangulation.is_inserted(triangulation.tail(border)))
    return;
  const Input_halfedge_index first = triangulation.edge_sequence(border).along;
  for(Input_halfedge_index next = next_umbrella(triangulation.input(), first); next != first;
      next = next_umbrella(triangulation.input(), next))
    for(Halfedge_index h = first_outgoing_halfedge(triangulation, next); h != null_index;
        h = triangulation.clockwise(h))
      function(h);
}

/* Replaces the contents of a range by the outgoing halfedges of v, clockwise, from the border if there is one, as
 * walkers or by their indices. At a non-manifold vertex they are grouped by umbrella, in the order in which the border
 * connects these. */
template <class Triangulation, class Outgoing_halfedge>
void collect_outgoing_halfedges(const Triangulation& triangulation, Vertex_index v,
                                std::vector<Outgoing_halfedge>& result)
{
  using Walker = typename Triangulation::Walker;
  constexpr bool are_walkers = std::is_same<Outgoing_halfedge, Walker>::value;
  const auto add = [&result](const Walker& h) {
    if constexpr(are_walkers)
      result.push_back(h);
    else
      result.push_back(h.index());
  };
  result.clear();
  const Halfedge_index start = triangulation.outgoing(v);
  if(start == null_index)
    return;
  const Walker first = triangulation.walker(start);
  Walker h = first;
  [[maybe_unused]] Walker last = first;
  do {
    add(h);
    last = h;
    h = h.counterclockwise();
  } while(!h.is_none() && h != first);
  std::reverse(h.is_none() ? result.begin() : result.begin() + 1, result.end());
  if(!h.is_none())
    return;
  for(h = first.clockwise(); !h.is_none(); h = h.clockwise())
    add(h);
  if constexpr(has_edge_sequences<Triangulation>) // the others are manifolds
    for_each_outgoing_halfedge_of_other_umbrellas(triangulation, last.index(),
                                                  [&](Halfedge_index g) { add(triangulation.walker(g)); });
}

/* Returns the outgoing halfedges of v, clockwise, from the border if there is one. */
template <class Triangulation>
std::vector<Halfedge_index> outgoing_halfedges(const Triangulation& triangulation, Vertex_index v)
{
  std::vector<Halfedge_index> result;
  collect_outgoing_halfedges(triangulation, v, result);
  return result;
}

/* Returns the outgoing halfedges of the vertex of an input halfedge that belong to the same umbrella. */
template <class Triangulation>
std::vector<Halfedge_index> outgoing_halfedges_beside(const Triangulation& triangulation, Input_halfedge_index h)
{
  const Input_halfedge_index border = border_of_umbrella(triangulation.input(), h);
  if(border == null_index)
    return outgoing_halfedges(triangulation, triangulation.input().tail(h));
  std::vector<Halfedge_index> result;
  for(Halfedge_index g = first_outgoing_halfedge(triangulation, border); g != null_index;
      g = triangulation.clockwise(g))
    result.push_back(g);
  return result;
}

/* Returns the shortest edge from v to w, the one with the smallest index among equally long ones; null_index if there
 * is none. */
template <class Triangulation>
Halfedge_index halfedge_between(const Triangulation& triangulation, Vertex_index v, Vertex_index w)
{
  Halfedge_index best = null_index;
  for(Halfedge_index h : outgoing_halfedges(triangulation, v)) {
    if(triangulation.head(h) != w)
      continue;
    const bool is_better = best == null_index || triangulation.length(h) < triangulation.length(best) ||
                           (triangulation.length(h) == triangulation.length(best) && h < best);
    if(is_better)
      best = h;
  }
  return best;
}

/* Returns the edges that a network holds, each once, in increasing order. */
template <class Network>
std::vector<Edge_index> edges_under_curves(const Network& network)
{
  std::vector<Edge_index> edges;
  for(Curve_index c : descriptors<Curve_index>(network.number_of_curves()))
    network.for_each_segment(
        c, [&](Segment_index s) { edges.push_back(Network::Triangulation::edge(network.halfedge(s))); });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/* For functions that may have to flip any edge. \throws Occupied_triangulation_error if a network has curves there */
template <class Triangulation>
void check_has_no_curves(const Triangulation& triangulation, const std::string& what_is_impossible)
{
  if(triangulation.number_of_holds() > 0)
    throw Occupied_triangulation_error(what_is_impossible +
                                       " in a triangulation in which a network has curves; use another triangulation");
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OUTGOING_HALFEDGES_H
