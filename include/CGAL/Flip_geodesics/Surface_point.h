// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SURFACE_POINT_H
#define CGAL_FLIP_GEODESICS_SURFACE_POINT_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Represents a point of the input surface by a halfedge and barycentric weights. The point lies in the face on the left
 * of `halfedge`, or on the boundary of this face.
 *
 * The `weights` belong to the tail of `halfedge`, its head, and the third vertex of the face. Only the ratio of the
 * weights matters: the point is exactly \f$(w_0 p_0 + w_1 p_1 + w_2 p_2) / (w_0 + w_1 + w_2)\f$. If one weight is
 * exactly zero, the point lies on the opposite edge; if two weights are zero, the point is a vertex. If the third
 * weight is zero, `halfedge` can be a border halfedge, which has no face.
 */
struct Surface_location
{
  Input_halfedge_index halfedge = null_index; ///< a side of the face, or of the edge, on which the point lies
  /// The weights of the tail, the head and the third vertex. Each weight is 0 or in [1e-100, 1e100], and at least one
  /// is not 0.
  std::array<double, 3> weights = {{1, 0, 0}};
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Stores a direction on the surface at a location: a reference halfedge, and an angle counterclockwise from this
 * halfedge.
 *
 * The halfedge starts at the location or is a side of a face that contains the location. Free functions take and return
 * a direction as a `std::pair` of a halfedge of the mesh and an angle. If a function chooses the reference halfedge, it
 * uses the halfedge of the location; if this is a border halfedge, the function uses its twin. The halfedge of a
 * `Face_location` is `halfedge(face, mesh)`. The halfedge of a vertex starts at the vertex.
 *
 * There are two exceptions. The angle in a `Trace_report` refers to the side through which the geodesic entered its
 * last face. If the source of a tree lies on the border or was inserted, the angles that `logarithmic_map()` returns
 * refer to a direction that the documentation of this function specifies.
 */
struct Surface_direction
{
  Input_halfedge_index halfedge = null_index; ///< the reference halfedge
  double angle = 0; ///< counterclockwise from the halfedge, in radians; at a vertex, measured across the incident faces
};

/// \ingroup PkgFlipGeodesicsCurves
/// States whether a location is a vertex, on an edge or inside a face.
enum class Location_kind { VERTEX, EDGE, FACE };

/// \ingroup PkgFlipGeodesicsCurves
/// Returns the kind of a location, which depends only on the number of weights that are zero.
inline Location_kind kind(const Surface_location& location)
{
  const auto zeros = std::count(location.weights.begin(), location.weights.end(), 0.0);
  return zeros == 0 ? Location_kind::FACE : (zeros == 1 ? Location_kind::EDGE : Location_kind::VERTEX);
}

/// \ingroup PkgFlipGeodesicsTree
/// Stores the polar coordinates of a vertex or point with respect to a source.
struct Polar_coordinates
{
  /// The length of the path from the source; infinite if no path exists.
  double radius = std::numeric_limits<double>::infinity();
  /// The angle of the initial direction of the path, in radians; NaN at the source or if no path exists.
  double angle = std::numeric_limits<double>::quiet_NaN();
};

namespace internal {

/* Returns whether halfedge `h` is a side of the face on the left of `f`. */
template <class Input>
bool is_side_of(const Input& input, Input_halfedge_index h, Input_halfedge_index f)
{
  return f == h || input.next(f) == h || input.next(input.next(f)) == h;
}

/* Returns the smallest halfedge of the face on the left of `h`, which identifies the face. */
template <class Mesh, class Halfedge>
Halfedge least_in_face(const Mesh& mesh, Halfedge h)
{
  const Halfedge hn = mesh.next(h);
  return (std::min)({h, hn, mesh.next(hn)});
}

inline std::array<double, 3> divided_by_sum(const std::array<double, 3>& weights)
{
  const double sum = weights[0] + weights[1] + weights[2];
  return {{weights[0] / sum, weights[1] / sum, weights[2] / sum}};
}

template <class Input_mesh>
void check_location(const Input_mesh& input, const Surface_location& location)
{
  const Input_halfedge_index h = location.halfedge;
  if(!h.is_valid() || h.idx() >= input.number_of_halfedges())
    throw Invalid_location_error("a location has a face or halfedge that does not belong to the mesh");
  for(double weight : location.weights)
    if(!(weight == 0 || (weight >= least_weight && weight <= greatest_weight))) // sums and products would not be normal
      throw_naming<Invalid_location_error>("a weight of a location in the face of halfedge ", h,
                                           " is neither 0 nor between 1e-100 and 1e100");
  if(location.weights[0] == 0 && location.weights[1] == 0 && location.weights[2] == 0)
    throw_naming<Invalid_location_error>("the weights of a location in the face of halfedge ", h, " are all zero");
  if(!input.is_border(h) && (location.weights[1] != 0 || location.weights[2] != 0))
    check_triangle(input, h);
  if(input.is_border(h) && location.weights[2] != 0)
    throw_naming<Invalid_location_error>("a location refers to the face of halfedge ", h,
                                         ", but this border halfedge has no face");
}

/* Returns the location with its weights beginning at halfedge `next(halfedge)`. */
template <class Input_mesh>
Surface_location rotated(const Input_mesh& input, const Surface_location& location)
{
  return {input.next(location.halfedge), {{location.weights[1], location.weights[2], location.weights[0]}}};
}

/*
 * Returns the same point in a canonical form: a vertex is given by a halfedge that starts at it and the weights (1, 0,
 * 0), a point on an edge by the first halfedge of the edge that is not on the border, with third weight zero, and a
 * point inside a face by the smallest halfedge of the face. Weights are not rounded.
 */
template <class Input_mesh>
Surface_location canonical_location(const Input_mesh& input, Surface_location location)
{
  check_location(input, location);
  const Location_kind what = kind(location);
  if(input.is_border(location.halfedge))
    location = {twin_index(location.halfedge), {{location.weights[1], location.weights[0], 0}}};
  switch(what) {
  case Location_kind::VERTEX:
    while(location.weights[0] == 0)
      location = rotated(input, location);
    location.weights = {{1, 0, 0}};
    return location;
  case Location_kind::EDGE: {
    while(location.weights[2] != 0)
      location = rotated(input, location);
    const Input_halfedge_index t = twin_index(location.halfedge);
    if(!is_first_side(location.halfedge) && !input.is_border(t))
      location = {t, {{location.weights[1], location.weights[0], 0}}};
    return location;
  }
  case Location_kind::FACE:
    for(const Input_halfedge_index least = least_in_face(input, location.halfedge); location.halfedge != least;)
      location = rotated(input, location);
    return location;
  }
  return location;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Represents a point of the surface by vertices of the input: \f$(1-t-u)\,a + t\,b + u\,c\f$.
 *
 * At a vertex, `a == b`, and `t` is 0. On an edge, `a` is the nearer end, so `t` lies in (0, 1/2]; `u` is 0, and `c` is
 * null. Inside a face, `a` is the vertex with the largest weight.
 *
 * The members represent exactly whether the point is a vertex, on an edge or inside a face. On an edge, `t` is at least
 * 1e-100, even if it would be rounded to 0; inside a face, the same holds for `t` and `u`.
 *
 * Even if degenerate edges were contracted, `a`, `b` and `c` are the ends of an edge or the corners of a face of the
 * original mesh. At a merged vertex, `a` equals `b` and is one of the vertices that were merged.
 */
struct Surface_point
{
  Vertex_index a; ///< the input vertex with the weight \f$1-t-u\f$
  Vertex_index b; ///< the input vertex with the weight \f$t\f$; at a vertex, `a`
  double t;       ///< the weight of `b`
  /// On an edge: one of the two halfedges of the edge; if a curve crosses the edge at the point, the halfedge in the
  /// face that the curve leaves. Inside a face: one of the halfedges of the face. At a vertex: null.
  Input_halfedge_index halfedge;
  Vertex_index c = null_index;      ///< inside a face: the third vertex of the face; otherwise null
  double u = 0;                     ///< the weight of `c`; 0 unless the point is inside a face
  Vertex_index vertex = null_index; ///< the vertex of the triangulation at this point, or null

  /// Returns whether the point is at a vertex of the input.
  bool is_vertex() const { return a == b; }
  /// Returns whether the point is in the interior of an input face.
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
/// Converts a location to a surface point, which is given by vertices of the input. `Surface_point::vertex` is null
/// unless the location is a vertex of the input. \throws Invalid_location_error if the location is not a point of the
/// surface
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

template <class Triangulation>
Surface_point surface_point_at_vertex(const Triangulation& triangulation, Vertex_index v)
{
  if(!triangulation.is_inserted(v))
    return {v, v, 0, null_index, null_index, 0, v};
  Surface_point result = Flip_geodesics::surface_point(triangulation, triangulation.location(v));
  result.vertex = v;
  return result;
}

template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const Surface_point& p)
{
  if(is_vertex(p.vertex, triangulation.number_of_vertices())) // it may have been inserted into another triangulation
    return triangulation.location(p.vertex);
  if(p.is_inside_face()) {
    const auto& input = triangulation.input();
    Surface_location result = {p.halfedge, {{0, 0, 0}}};
    for(double& weight : result.weights) {
      const Vertex_index v = input.uncontracted_tail(result.halfedge);
      weight = v == p.a ? 1 - p.t - p.u : (v == p.b ? p.t : p.u);
      result.halfedge = input.next(result.halfedge);
    }
    return result;
  }
  const bool is_forward = triangulation.input().uncontracted_tail(p.halfedge) == p.a;
  return {p.halfedge, {{is_forward ? 1 - p.t : p.t, is_forward ? p.t : 1 - p.t, 0}}};
}

/*
 * Returns the point where a curve crosses an input edge, at `from_right` times the length of the edge from its right
 * end. The edge is known exactly, but the position is rounded: 0, -0 and 1 represent a point next to an end.
 */
template <class Triangulation>
Surface_point surface_point_on_edge(const Triangulation& triangulation, Input_halfedge_index crossed, double from_right)
{
  const Vertex_index right = triangulation.input().uncontracted_tail(crossed);
  const Vertex_index left = triangulation.input().uncontracted_head(crossed);
  if(from_right <= 0.5)
    return {right, left, (std::max)(least_weight, from_right), crossed};
  return {left, right, (std::max)(least_weight, 1 - from_right), crossed};
}

template <class Metric, class = void>
struct Metric_point
{
  using type = void;
};

template <class Metric>
struct Metric_point<Metric, std::void_t<typename Metric::Point_3>>
{
  using type = typename Metric::Point_3;
};

template <class Metric>
using Has_points = std::negation<std::is_void<typename Metric_point<Metric>::type>>;

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Returns the position in space of a surface point. The function is available only if the metric has points in space.
 * Complexity: constant.
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

namespace internal {

/* Returns the input faces that contain a canonical location, each by its smallest halfedge. */
template <class Input_mesh>
std::vector<Input_halfedge_index> faces_of_location(const Input_mesh& input, const Surface_location& location)
{
  std::vector<Input_halfedge_index> result;
  const auto add = [&](Input_halfedge_index h) {
    if(input.is_border(h))
      return;
    check_triangle(input, h);
    result.push_back(least_in_face(input, h));
  };
  if(kind(location) != Location_kind::VERTEX) {
    add(location.halfedge);
    if(kind(location) == Location_kind::EDGE)
      add(twin_index(location.halfedge));
    return result;
  }
  const Vertex_index v = input.tail(location.halfedge);
  Input_halfedge_index h = input.outgoing(v);
  const Input_halfedge_index first = h;
  do {
    add(h);
    h = input.next(twin_index(h)); // along the border, too
  } while(h != first);
  return result;
}

/*
 * Thrown if the edge sequence of an edge does not lead to its end. Refinement and the reader of networks catch this,
 * since they undo the flips and continue without the point.
 */
[[noreturn]] inline void throw_wrong_flips(Input_halfedge_index face)
{
  throw_naming<Insertion_error>("rounding errors have caused incorrect flips in the face of halfedge ", face);
}

/* Returns the side of an input face, given by any of its halfedges, on which a point of an edge lies; for an interior
 * point, its halfedge. */
template <class Input_mesh>
Input_halfedge_index location_anchor(const Input_mesh& input, const Surface_location& location,
                                     Input_halfedge_index face)
{
  if(kind(location) == Location_kind::FACE)
    return location.halfedge;
  for(Input_halfedge_index h : {face, input.next(face), input.next(input.next(face))})
    if(are_of_one_edge(h, location.halfedge))
      return h;
  throw_wrong_flips(location.halfedge);
}

template <class Input_mesh>
int side_number(const Input_mesh& input, Input_halfedge_index h, Input_halfedge_index side)
{
  return side == h ? 0 : (side == input.next(h) ? 1 : 2);
}

/* Returns the weights of a canonical surface point, on an edge or in the interior, in the face of h, relative to h. */
template <class Input_mesh>
std::array<double, 3> weights_in_face(const Input_mesh& input, const Surface_location& location, Input_halfedge_index h)
{
  const Input_halfedge_index side = location_anchor(input, location, h);
  const int i = side_number(input, h, side);
  const bool is_along = location.halfedge == side;
  std::array<double, 3> result;
  result[i] = location.weights[is_along ? 0 : 1];
  result[(i + 1) % 3] = location.weights[is_along ? 1 : 0];
  result[(i + 2) % 3] = location.weights[2];
  return result;
}

/* Returns an input face that contains two canonical locations, or null_index if they have no common face. */
template <class Input_mesh>
Input_halfedge_index common_face(const Input_mesh& input, const Surface_location& p, const Surface_location& q)
{
  const std::vector<Input_halfedge_index> faces = faces_of_location(input, p);
  for(Input_halfedge_index f : faces_of_location(input, q))
    if(std::find(faces.begin(), faces.end(), f) != faces.end())
      return f;
  return null_index;
}

/* Returns the input vertex with the largest weight. */
template <class Input_mesh>
Vertex_index nearest_vertex(const Input_mesh& input, const Surface_location& p)
{
  const auto nearest = (std::max_element)(p.weights.begin(), p.weights.end()) - p.weights.begin();
  const Input_halfedge_index h = p.halfedge, hn = input.next(h);
  return input.tail(nearest == 0 ? h : (nearest == 1 ? hn : input.next(hn)));
}

} // namespace internal

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_SURFACE_POINT_H
