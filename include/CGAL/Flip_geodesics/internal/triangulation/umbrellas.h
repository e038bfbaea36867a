// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_UMBRELLAS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_UMBRELLAS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The faces at a vertex form one umbrella, or several at a non-manifold vertex. Each of several umbrellas ends at the
 * border, and the border leads from one to the next. Since edges on the border are never flipped, the umbrellas of a
 * triangulation are those of its input.
 */

/* The border halfedge at the counterclockwise end of the umbrella that has a halfedge of its vertex; null_index if the
 * umbrella has no border. */
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

/* The border halfedge of the umbrella that follows clockwise; at a manifold vertex it is the same. */
template <class Input_mesh>
Input_halfedge_index next_umbrella(const Input_mesh& input, Input_halfedge_index border)
{
  Input_halfedge_index h = border;
  while(!input.is_border(twin_index(h)))
    h = clockwise_of(input, h);
  return clockwise_of(input, h);
}

/* The one before. */
template <class Input_mesh>
Input_halfedge_index previous_umbrella(const Input_mesh& input, Input_halfedge_index border)
{
  Input_halfedge_index result = border;
  for(Input_halfedge_index next = next_umbrella(input, result); next != border; next = next_umbrella(input, result))
    result = next;
  return result;
}

/* The halfedge of a triangulation that leads along a border halfedge of the input from its vertex. */
template <class Triangulation>
Halfedge_index first_spoke(const Triangulation& triangulation, Input_halfedge_index border)
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

/* A halfedge of a triangulation that starts at the vertex of an input halfedge, in the same umbrella. */
template <class Triangulation>
Halfedge_index outgoing_beside(const Triangulation& triangulation, Input_halfedge_index h)
{
  const auto& input = triangulation.input();
  const Input_halfedge_index border = border_of_umbrella(input, h);
  if(border == null_index || next_umbrella(input, border) == border)
    return triangulation.outgoing(input.tail(h));
  return first_spoke(triangulation, border);
}

/* Calls function(h) for the halfedges that start at a vertex, clockwise, in the umbrellas but that of `border`, a border
 * halfedge of the triangulation. */
template <class Triangulation, class Function>
void for_each_spoke_of_other_umbrellas(const Triangulation& triangulation, Halfedge_index border,
                                       const Function& function)
{
  if(triangulation.is_inserted(triangulation.tail(border)))
    return;
  const Input_halfedge_index first = triangulation.crossing_word(border).along;
  for(Input_halfedge_index next = next_umbrella(triangulation.input(), first); next != first;
      next = next_umbrella(triangulation.input(), next))
    for(Halfedge_index h = first_spoke(triangulation, next); h != null_index; h = triangulation.clockwise(h))
      function(h);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_UMBRELLAS_H
