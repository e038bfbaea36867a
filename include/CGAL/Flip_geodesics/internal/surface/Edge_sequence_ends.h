// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EDGE_SEQUENCE_ENDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EDGE_SEQUENCE_ENDS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>

#include <array>
#include <cstddef>

namespace CGAL::Flip_geodesics::internal {

/*
 * An approximate position for a point to be inserted: the piece of an input face at a gap of the edge sequence of a
 * halfedge, as seen from the face of that halfedge.
 */
struct Known_piece
{
  Halfedge_index halfedge; // an intrinsic halfedge
  std::size_t gap;         // an index in its edge sequence: the piece before crossing `gap`, or the last one
  std::size_t letters;     // the remaining budget of crossed edges for searches that start elsewhere
};

/* Returns the kind of an intrinsic vertex on the input. */
template <class Triangulation>
Location_kind vertex_kind(const Triangulation& triangulation, Vertex_index v)
{
  return triangulation.is_inserted(v) ? kind(triangulation.location(v)) : Location_kind::VERTEX;
}

/* Returns the halfedge to which the corners of the face of a gap refer: that between crossed edges gap - 1 and gap of
 * an edge sequence. */
inline Input_halfedge_index face_of_gap(const Edge_sequence& sequence, std::size_t gap)
{
  if(sequence.along != null_index)
    return sequence.along;
  return gap < sequence.crossed.size() ? sequence.crossed[gap] : sequence.last_face();
}

/*
 * Returns the reference halfedge of a vertex in an input face, given by any of its halfedges: for an input vertex the
 * halfedge that starts there, for a point of an edge the side of that edge, for an interior point the halfedge of its
 * surface point.
 */
template <class Triangulation>
Input_halfedge_index anchor(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index face)
{
  const auto& input = triangulation.input();
  if(triangulation.is_inserted(v))
    return location_anchor(input, triangulation.location(v), face);
  for(Input_halfedge_index h : {face, input.next(face), input.next(input.next(face))})
    if(input.tail(h) == v)
      return h;
  throw_wrong_flips(face);
}

/* Returns whether a vertex is the tail of input halfedge h, or a point inside its edge. */
template <class Triangulation>
bool is_on_halfedge(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index h)
{
  if(!triangulation.is_inserted(v))
    return triangulation.input().tail(h) == v;
  return vertex_kind(triangulation, v) == Location_kind::EDGE && are_of_one_edge(triangulation.location(v).halfedge, h);
}

/* Returns whether a vertex is inside the face of input halfedge h, or on its border. */
template <class Triangulation>
bool is_in_face(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index h)
{
  const bool is_inside = triangulation.is_inserted(v) && vertex_kind(triangulation, v) == Location_kind::FACE;
  for(int i = 0; i < 3; ++i, h = triangulation.input().next(h))
    if(is_inside ? triangulation.location(v).halfedge == h : is_on_halfedge(triangulation, v, h))
      return true;
  return false;
}

/* Returns whether a vertex is inside that face or on its border, but not on the edge of h. */
template <class Triangulation>
bool is_opposite_vertex(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index h)
{
  return is_in_face(triangulation, v, h) && !is_on_halfedge(triangulation, v, h) &&
         !is_on_halfedge(triangulation, v, twin_index(h));
}

/* An end of an edge sequence as seen from there: the input halfedge along which it leaves, the first one that it
 * crosses, a halfedge of its first face, each `null_index` if there is none; and the vertex. */
struct Edge_sequence_end
{
  Input_halfedge_index along, crossed, face;
  Vertex_index vertex;
};

inline Edge_sequence_end tail_end(const Edge_sequence& sequence)
{
  return {sequence.along, sequence.crossed.empty() ? null_index : sequence.crossed.front(), sequence.first_face(),
          sequence.tail};
}

inline Edge_sequence_end head_end(const Edge_sequence& sequence)
{
  return {sequence.along == null_index ? null_index : twin_index(sequence.along),
          sequence.crossed.empty() ? null_index : twin_index(sequence.crossed.back()), sequence.last_face(),
          sequence.head};
}

/*
 * Returns the anchor of the tail of an edge sequence in its first face. If the sequence runs along an input halfedge,
 * it is that halfedge, whose face is on the left. The directions of edges at a vertex refer to it.
 */
template <class Triangulation>
Input_halfedge_index tail_anchor(const Triangulation& triangulation, const Edge_sequence_end& tail)
{
  if(tail.along != null_index)
    return tail.along;
  if(tail.crossed != null_index && !triangulation.is_inserted(tail.vertex))
    return triangulation.input().next(triangulation.input().next(tail.crossed));
  return anchor(triangulation, tail.vertex, tail.face);
}

template <class Triangulation>
Input_halfedge_index tail_anchor(const Triangulation& triangulation, const Edge_sequence& sequence)
{
  return tail_anchor(triangulation, tail_end(sequence));
}

/*
 * Returns the anchor of the head of an edge sequence in its last face, which is on the left if the sequence runs along
 * an input halfedge. It is also the first direction of an input edge, strictly, that a clockwise turn around the head
 * meets.
 */
template <class Triangulation>
Input_halfedge_index head_anchor(const Triangulation& triangulation, const Edge_sequence_end& head)
{
  if(head.along == null_index)
    return tail_anchor(triangulation, head);
  const Input_halfedge_index along = twin_index(head.along);
  return triangulation.is_inserted(head.vertex) ? along : triangulation.input().next(along);
}

template <class Triangulation>
Input_halfedge_index head_anchor(const Triangulation& triangulation, const Edge_sequence& sequence)
{
  return head_anchor(triangulation, head_end(sequence));
}

/* Returns the weights of a vertex in the face of h, relative to h. */
template <class Triangulation>
std::array<double, 3> vertex_weights(const Triangulation& triangulation, Vertex_index v, Input_halfedge_index h)
{
  const auto& input = triangulation.input();
  if(triangulation.is_inserted(v))
    return weights_in_face(input, triangulation.location(v), h);
  const Input_halfedge_index corner = anchor(triangulation, v, h);
  return {{corner == h ? 1.0 : 0.0, corner == input.next(h) ? 1.0 : 0.0, input.next(corner) == h ? 1.0 : 0.0}};
}

/* Returns the weights of the point at `t` on a side of the face of h, from 0 at its tail to 1 at its head, relative to
 * h. */
template <class Input_mesh>
std::array<double, 3> weights_on_side(const Input_mesh& input, Input_halfedge_index h, Input_halfedge_index side,
                                      double t)
{
  std::array<double, 3> weights = {{0, 0, 0}};
  for(int i = 0; i < 3; ++i, h = input.next(h))
    if(h == side) {
      weights[i] = 1 - t;
      weights[(i + 1) % 3] = t;
    }
  return weights;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EDGE_SEQUENCE_ENDS_H
