// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_INPUT_EDGES_ALONG_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_INPUT_EDGES_ALONG_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The side of a face from its corner at a vertex on: of an inserted vertex, a corner that it is next to, the same in all
 * faces. `anchor` tells the vertex in the face. */
template <class Triangulation>
Input_halfedge_index corner_next_to(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index anchor)
{
  const bool is_at_other_end =
      vertex_kind(triangulation, v) == Location_kind::EDGE && triangulation.location(v).halfedge != anchor;
  return is_at_other_end ? triangulation.input().next(anchor) : anchor;
}

/* Does a vertex on an input halfedge, or at an end of it, count as its start? */
template <class Triangulation>
bool is_next_to_start(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index along, bool is_tail)
{
  return triangulation.is_inserted(v) ? triangulation.location(v).halfedge == along : is_tail;
}

/*
 * Writes input halfedges along which an edge of the triangulation can be moved, by its word, with its ends held.
 * Inserted vertices are moved to the corners that they are next to, so that edges put together remain so.
 *
 *      u ---- r        crossed: c from p to q. From u to p, and on along the tails of what is crossed.
 *       \    /.
 *     c  q--p
 */
template <class Triangulation>
void append_input_edges(const Triangulation& triangulation, const Crossing_word& word,
                        std::vector<Input_halfedge_index>& result)
{
  const auto& input = triangulation.input();
  if(word.along != null_index) {
    const bool from_start = is_next_to_start(triangulation, word.tail, word.along, true);
    const bool to_start = is_next_to_start(triangulation, word.head, word.along, false);
    if(from_start != to_start)
      result.push_back(from_start ? word.along : twin_index(word.along));
    return;
  }
  // Around the left face of `from`, to where `to` starts.
  const auto turn = [&](Input_halfedge_index from, Input_halfedge_index to) {
    if(input.next(from) == to)
      result.push_back(from);
    else if(input.next(to) == from)
      result.push_back(twin_index(to));
  };
  Input_halfedge_index corner = corner_next_to(triangulation, word.tail, tail_anchor(triangulation, word));
  for(Input_halfedge_index c : word.crossed) {
    turn(corner, c);
    corner = input.next(twin_index(c)); // starts where c does
  }
  turn(corner, corner_next_to(triangulation, word.head, head_anchor(triangulation, word)));
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_INPUT_EDGES_ALONG_H
