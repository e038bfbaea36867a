// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WORD_TURNS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WORD_TURNS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A face that a word ends in, by one of its halfedges: of two beside an edge that it runs along, that on the left. */
template <class Input_mesh>
Input_halfedge_index face_along(const Input_mesh& input, Input_halfedge_index along)
{
  return input.is_border(along) ? twin_index(along) : along;
}

/* The halfedge of the first face of a word by which its tail is told there, as `anchor()`. */
template <class Triangulation>
Input_halfedge_index first_anchor(const Triangulation& triangulation, const Word_end& tail)
{
  return tail.along == null_index ? tail_anchor(triangulation, tail)
                                  : anchor(triangulation, tail.vertex, face_along(triangulation.input(), tail.along));
}

template <class Triangulation>
Input_halfedge_index first_anchor(const Triangulation& triangulation, const Crossing_word& word)
{
  return first_anchor(triangulation, tail_end(word));
}

/* The halfedge of its last face by which its head is told there. */
template <class Triangulation>
Input_halfedge_index last_anchor(const Triangulation& triangulation, const Word_end& head)
{
  return head.along == null_index
             ? tail_anchor(triangulation, head)
             : anchor(triangulation, head.vertex, face_along(triangulation.input(), twin_index(head.along)));
}

template <class Triangulation>
Input_halfedge_index last_anchor(const Triangulation& triangulation, const Crossing_word& word)
{
  return last_anchor(triangulation, head_end(word));
}

/*
 * Leads a path of words round a vertex of the input from one face to another, each told by the halfedge that starts at
 * the vertex there. Returns false at the border; the path is of no use then.
 */
template <class Input_mesh, class Path>
bool turn(const Input_mesh& input, Path& path, Input_halfedge_index from, Input_halfedge_index to, bool is_clockwise)
{
  while(from != to) {
    const Input_halfedge_index letter = is_clockwise ? from : input.previous(from), entered = twin_index(letter);
    if(input.is_border(entered))
      return false;
    path.cross(letter);
    from = is_clockwise ? input.next(entered) : entered;
  }
  return true;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WORD_TURNS_H
