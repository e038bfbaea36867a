// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXTRACT_H
#define CGAL_FLIP_GEODESICS_EXTRACT_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/Strip.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

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
  Index a, b; ///< input vertices
  double t;
  Index halfedge; ///< on an edge: the input halfedge that is crossed, as a side of the face that is left, or that an
                  ///< inserted point lies on; inside a face: one of its halfedges; else null
  Index c = null_index;
  double u = 0;
  Index vertex = null_index; ///< the triangulation's vertex in this place; null where an edge is crossed

  bool is_vertex() const { return a == b; }
  bool is_inside_face() const { return c != null_index; }
};

namespace internal {

inline Surface_point surface_point(const std::array<Index, 3>& corners, const std::array<double, 3>& weights,
                                   Index halfedge)
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
  const Index h = at.halfedge, hn = input.next(h), v = input.tail(h);
  if(kind(at) == Location_kind::VERTEX)
    return {v, v, 0, null_index, null_index, 0, v};
  return internal::surface_point(
      {{input.uncontracted_tail(h), input.uncontracted_tail(hn), input.uncontracted_tail(input.next(hn))}}, at.weights,
      h);
}

namespace internal {

/* The place of a vertex of the triangulation. */
template <class Triangulation>
Surface_point surface_point_at_vertex(const Triangulation& triangulation, Index v)
{
  if(!triangulation.is_inserted(v))
    return {v, v, 0, null_index, null_index, 0, v};
  Surface_point result = Flip_geodesics::surface_point(triangulation, triangulation.location(v));
  result.vertex = v;
  return result;
}

/* The point where a curve crosses an input edge, `from_right` of the edge's length away from its right end. That it is
 * crossed is exact, where is not: an end by rounding, 0, -0 or 1, stands for a point next to it. */
template <class Triangulation>
Surface_point surface_point_on_edge(const Triangulation& triangulation, Index crossed, double from_right)
{
  const Index right = triangulation.input().uncontracted_tail(crossed);
  const Index left = triangulation.input().uncontracted_head(crossed);
  if(from_right <= 0.5)
    return {right, left, (std::max)(least_weight, from_right), crossed};
  return {left, right, (std::max)(least_weight, 1 - from_right), crossed};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Writes the `Surface_point`s of an edge of a triangulation, from the tail of halfedge `h` to its head, both included:
 * where the edge runs on the input mesh. Linear in the crossed edges.
 */
template <class Triangulation, class OutputIterator>
OutputIterator edge_surface_points(const Triangulation& triangulation, Index h, OutputIterator out)
{
  *out++ = internal::surface_point_at_vertex(triangulation, triangulation.tail(h));
  const internal::Strip<Triangulation> strip(triangulation, triangulation.crossing_word(h));
  for(std::size_t i = 0; i < strip.gates().size(); ++i)
    *out++ = internal::surface_point_on_edge(triangulation, strip.gates()[i].crossed, strip.crossing(i));
  *out++ = internal::surface_point_at_vertex(triangulation, triangulation.head(h));
  return out;
}

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

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Reads curves of a network off on the input mesh, by unfolding the words of their segments: which edges are crossed,
 * and in which order, is exact; where they are crossed is rounded to double.
 *
 * Where a curve passes a vertex within rounding, consecutive points on the vertex's edges may coincide there in space;
 * the edges then tell on which side the curve passes, and `Surface_point::t` is not zero.
 *
 * \tparam Network an `Edge_path_network`
 */
template <class Network>
class Curve_extractor
{
  using Triangulation = typename Network::Triangulation;
  using Triangle_mesh = typename Triangulation::Triangle_mesh;

public:
  using face_descriptor = typename boost::graph_traits<Triangle_mesh>::face_descriptor;

  explicit Curve_extractor(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  /*!
   * Writes the `Surface_point`s of a curve, from its start to its end; a closed curve repeats its first point. Nothing
   * is written for a curve that has contracted. Linear in the crossed edges.
   */
  template <class OutputIterator>
  OutputIterator surface_points(Index curve, OutputIterator out)
  {
    std::vector<Surface_point> segment;
    bool is_first = true;
    m_network.for_each_segment(curve, [&](Index s) {
      segment.clear();
      edge_surface_points(m_triangulation, m_network.halfedge(s), std::back_inserter(segment));
      out = std::copy(segment.begin() + (is_first ? 0 : 1), segment.end(), out); // its start is the end before
      is_first = false;
    });
    return out;
  }

  /// The surface points of a curve as a vector.
  std::vector<Surface_point> surface_points(Index curve)
  {
    std::vector<Surface_point> result;
    surface_points(curve, std::back_inserter(result));
    return result;
  }

  /// Writes the points of a curve in space, one per surface point. Only with `Embedded_metric`.
  template <class OutputIterator>
  OutputIterator points(Index curve, OutputIterator out)
  {
    for(const Surface_point& p : surface_points(curve))
      *out++ = point(p);
    return out;
  }

  /// Writes the input halfedges that a curve crosses, each as a side of the face that is left.
  template <class OutputIterator>
  OutputIterator crossed_halfedges(Index curve, OutputIterator out)
  {
    m_network.for_each_segment(curve, [&](Index s) {
      for(Index h : m_triangulation.crossing_word(m_network.halfedge(s)).crossed)
        *out++ = m_triangulation.input_halfedge(h);
    });
    return out;
  }

  /*!
   * Writes a curve as face locations, pairs of a face and barycentric coordinates as in
   * `CGAL::Polygon_mesh_processing::Face_location`: the coordinates belong to the source, target and third vertex of
   * `halfedge(face, mesh)`.
   */
  template <class OutputIterator>
  OutputIterator face_locations(Index curve, const Triangle_mesh& mesh, OutputIterator out)
  {
    for(const Surface_point& p : surface_points(curve))
      *out++ = face_location(p, mesh);
    return out;
  }

  /// The point in space. Only with `Embedded_metric`.
  auto point(const Surface_point& p) const { return point_in_space(m_triangulation, p); }

  /// The word of a segment of the network.
  Crossing_word word(Index segment) { return m_triangulation.crossing_word(m_network.halfedge(segment)); }

private:
  std::pair<face_descriptor, std::array<double, 3>> face_location(const Surface_point& p,
                                                                  const Triangle_mesh& mesh) const
  {
    const auto& input = m_triangulation.input();
    Index h = p.is_vertex() ? input.outgoing(p.a) : p.halfedge;
    if(input.is_border(h)) // at most one of two consecutive spokes is on the border
      h = p.is_vertex() ? input.next(Triangulation::twin(h)) : Triangulation::twin(h);
    const face_descriptor f = internal::graph_face(m_triangulation.input_halfedge(h), mesh);
    Index corner = input.index(internal::graph_halfedge(f, mesh));
    std::array<double, 3> weights = {0, 0, 0};
    for(double& weight : weights) {
      const Index v = p.is_vertex() ? input.tail(corner) : input.uncontracted_tail(corner);
      weight = v == p.a ? 1 - p.t - p.u : (v == p.b ? p.t : (v == p.c ? p.u : 0));
      corner = input.next(corner);
    }
    return {f, weights};
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
};

/// \ingroup PkgFlipGeodesicsExtraction
/// A face of the intrinsic triangulation; side `i` leads from vertex `i` to vertex `(i + 1) % 3`.
struct Intrinsic_face
{
  std::array<Index, 3> vertices;
  std::array<Index, 3> halfedges;
  std::array<double, 3> lengths;
};

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Writes all faces of a triangulation, which contains the curves of its network as edges, ordered by their smallest
 * halfedge, which comes first. Copies what was not touched yet: linear in the mesh.
 */
template <class Triangulation, class OutputIterator>
OutputIterator intrinsic_faces(const Triangulation& triangulation, OutputIterator out)
{
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    if(triangulation.is_border(h))
      continue;
    const Index hn = triangulation.next(h), hp = triangulation.next(hn);
    if(hn < h || hp < h)
      continue;
    *out++ = Intrinsic_face{{triangulation.tail(h), triangulation.tail(hn), triangulation.tail(hp)},
                            {h, hn, hp},
                            {triangulation.length(h), triangulation.length(hn), triangulation.length(hp)}};
  }
  return out;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_EXTRACT_H
