// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SURFACE_POINT_H
#define CGAL_FLIP_GEODESICS_SURFACE_POINT_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_location.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * A point of the surface, by vertices of the input: \f$(1-t-u)\,a + t\,b + u\,c\f$. At a vertex `a == b`, and `t` is 0.
 * On an edge `a` is the nearer end, so that `t` lies in (0, 1/2] and keeps its relative accuracy close to vertices; `u`
 * is 0 there, and `c` null. Inside a face, where only inserted points are, `a` is the vertex of the largest weight.
 *
 * What it is a point of is exact: `t` inside an edge, and `t` and `u` inside a face, are at least 1e-100, also where
 * rounding says 0.
 *
 * Where edges of length zero were contracted, `a`, `b` and `c` are still the ends of an edge of the mesh, or the
 * corners of a face; at a vertex they are one of those in this place.
 */
struct Surface_point
{
  Vertex_index a; ///< the input vertex with the weight \f$1-t-u\f$
  Vertex_index b; ///< the input vertex with the weight \f$t\f$; at a vertex, `a`
  double t;       ///< the weight of `b`, without unit
  Input_halfedge_index
      halfedge; ///< on an edge: the input halfedge that is crossed, as a side of the face that is left, or that an
                ///< inserted point lies on; inside a face: one of its halfedges; else null
  Vertex_index c = null_index;      ///< inside a face: its third vertex; else null
  double u = 0;                     ///< the weight of `c`, 0 unless inside a face
  Vertex_index vertex = null_index; ///< the triangulation's vertex in this place; null where an edge is crossed

  /// Is it at a vertex of the input?
  bool is_vertex() const { return a == b; }
  /// Is it inside an input face, not on an edge?
  bool is_inside_face() const { return c != null_index; }
};

namespace internal {

inline Surface_point surface_point(const std::array<Vertex_index, 3>& corners, const std::array<double, 3>& weights,
                                   Input_halfedge_index halfedge)
{
  const auto largest = (std::max_element)(weights.begin(), weights.end()) - weights.begin();
  const auto second = weights[(largest + 1) % 3] == 0 ? (largest + 2) % 3 : (largest + 1) % 3,
             third = 3 - largest - second;
  const double sum = weights[0] + weights[1] + weights[2];
  Surface_point result = {corners[largest], corners[second], (std::max)(least_weight, weights[second] / sum), halfedge};
  if(weights[third] != 0) {
    result.c = corners[third];
    result.u = (std::max)(least_weight, weights[third] / sum);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsExtraction
/// A location by vertices of the input. `Surface_point::vertex` is null unless it is one of them.
template <class Triangulation>
Surface_point surface_point(const Triangulation& triangulation, const Surface_location& location)
{
  const auto& input = triangulation.input();
  const Surface_location at = internal::canonical_location(input, location);
  const Input_halfedge_index h = at.halfedge, hn = input.next(h);
  const Vertex_index v = input.tail(h);
  if(kind(at) == Location_kind::VERTEX)
    return {v, v, 0, null_index, null_index, 0, v};
  return internal::surface_point(
      {{input.uncontracted_tail(h), input.uncontracted_tail(hn), input.uncontracted_tail(input.next(hn))}}, at.weights,
      h);
}

namespace internal {

/* The place of a vertex of the triangulation. */
template <class Triangulation>
Surface_point surface_point_at_vertex(const Triangulation& triangulation, Vertex_index v)
{
  if(!triangulation.is_inserted(v))
    return {v, v, 0, null_index, null_index, 0, v};
  Surface_point result = Flip_geodesics::surface_point(triangulation, triangulation.location(v));
  result.vertex = v;
  return result;
}

/* Where a curve crosses an input edge, or the place of a vertex. */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const Surface_point& p)
{
  if(p.vertex != null_index)
    return triangulation.location(p.vertex);
  const bool is_forward = triangulation.input().uncontracted_tail(p.halfedge) == p.a;
  return {p.halfedge, {{is_forward ? 1 - p.t : p.t, is_forward ? p.t : 1 - p.t, 0}}};
}

/* The point where a curve crosses an input edge, `from_right` of the edge's length away from its right end. That it is
 * crossed is exact, where is not: an end by rounding, 0, -0 or 1, stands for a point next to it. */
template <class Triangulation>
Surface_point surface_point_on_edge(const Triangulation& triangulation, Input_halfedge_index crossed, double from_right)
{
  const Vertex_index right = triangulation.input().uncontracted_tail(crossed);
  const Vertex_index left = triangulation.input().uncontracted_head(crossed);
  if(from_right <= 0.5)
    return {right, left, (std::max)(least_weight, from_right), crossed};
  return {left, right, (std::max)(least_weight, 1 - from_right), crossed};
}

} // namespace internal

namespace internal {

/* Has a metric points in space? */
template <class Metric, class = void>
struct Has_points : std::false_type
{
};

template <class Metric>
struct Has_points<Metric, std::void_t<typename Metric::Point_3>>
  : std::bool_constant<!std::is_void<typename Metric::Point_3>::value>
{
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * The point of a surface point in space, in constant time. Only with a metric that has points.
 */
template <class Triangulation>
auto point_in_space(const Triangulation& triangulation, const Surface_point& p)
{
  using Point = typename Triangulation::Metric::Point_3;
  const auto& input = triangulation.input();
  const Point a = triangulation.metric().point(input, p.a);
  if(p.is_vertex())
    return a;
  const Point b = triangulation.metric().point(input, p.b);
  const Point q(a.x() + p.t * (b.x() - a.x()), a.y() + p.t * (b.y() - a.y()), a.z() + p.t * (b.z() - a.z()));
  if(!p.is_inside_face())
    return q;
  const Point c = triangulation.metric().point(input, p.c);
  return Point(q.x() + p.u * (c.x() - a.x()), q.y() + p.u * (c.y() - a.y()), q.z() + p.u * (c.z() - a.z()));
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SURFACE_POINT_H
