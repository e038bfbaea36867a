// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXTRACT_H
#define CGAL_FLIP_GEODESICS_EXTRACT_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

/* Writes the surface points of the edge of `h` from its tail, if `has_tail`, to its head; `strip` is the strip of the
 * edge. */
template <class Triangulation, class OutputIterator>
OutputIterator write_surface_points(const Triangulation& triangulation, Halfedge_index h,
                                    const Strip<Triangulation>& strip, bool has_tail, OutputIterator out)
{
  if(has_tail)
    *out++ = surface_point_at_vertex(triangulation, triangulation.tail(h));
  for(std::size_t i = 0; i < strip.portals().size(); ++i)
    *out++ = surface_point_on_edge(triangulation, strip.portals()[i].crossed, strip.crossing(i));
  *out++ = surface_point_at_vertex(triangulation, triangulation.head(h));
  return out;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Writes the `Surface_point`s of the edge of halfedge `h` of a triangulation: the tail of `h`, the crossings of the
 * edge with input edges, and the head of `h`.
 *
 * Complexity: linear in the number of crossed edges.
 */
template <class Triangulation, class OutputIterator>
OutputIterator edge_surface_points(const Triangulation& triangulation, Halfedge_index h, OutputIterator out)
{
  const internal::Strip<Triangulation> strip(triangulation, triangulation.edge_sequence(h));
  return internal::write_surface_points(triangulation, h, strip, true, out);
}

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Extracts the curves of a network as curves on the input mesh, by unfolding the edge sequences of their segments. The
 * crossed edges and their order are exact; the positions of the crossings are rounded to double.
 *
 * If a curve passes beside a vertex at a distance of the order of rounding errors, consecutive surface points on the
 * edges at this vertex can have the same coordinates in space. The crossed edges still determine on which side of the
 * vertex the curve passes, and `Surface_point::t` of these points is not zero.
 *
 * \tparam Network a model of `CurveNetwork`, whose triangulation is a model of `IntrinsicTriangulationOfMesh`
 */
template <class Network>
class Curve_extractor
{
  using Triangulation = typename Network::Triangulation;
  using Triangle_mesh = typename Triangulation::Triangle_mesh;

public:
  using face_descriptor = typename boost::graph_traits<Triangle_mesh>::face_descriptor; ///< the face type of the mesh

  /// Constructs an extractor for the curves of a network; the network must outlive the extractor.
  explicit Curve_extractor(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  /*!
   * Writes the `Surface_point`s of a curve, from its start to its end; for a closed curve, the first point is repeated
   * at the end. Nothing is written for a curve that has contracted to a point.
   *
   * Complexity: linear in the number of segments plus the number of crossed edges.
   */
  template <class OutputIterator>
  OutputIterator surface_points(Curve_index curve, OutputIterator out)
  {
    const std::vector<Surface_point> points = surface_points(curve);
    return std::copy(points.begin(), points.end(), out);
  }

  /// Returns the surface points of a curve as a vector.
  std::vector<Surface_point> surface_points(Curve_index curve)
  {
    std::vector<Surface_point> result;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      const Halfedge_index h = m_network.halfedge(s);
      const Strip strip(m_triangulation, m_triangulation.edge_sequence(h));
      make_room(result, strip.portals().size() + 2);
      internal::write_surface_points(m_triangulation, h, strip, result.empty(), std::back_inserter(result));
    });
    return result;
  }

  /// Returns the locations of the surface points of a curve, for example for `Geodesic_distance_field::add_curve()`.
  std::vector<Surface_location> surface_locations(Curve_index curve)
  {
    std::vector<Surface_location> result;
    for(const Surface_point& p : surface_points(curve))
      result.push_back(internal::surface_location(m_triangulation, p));
    return result;
  }

  /// Writes the points of a curve in space, one per surface point. The function is available only if the metric has
  /// points in space, like `Embedded_metric`.
  template <class OutputIterator>
  OutputIterator points(Curve_index curve, OutputIterator out)
  {
    for(const Surface_point& p : surface_points(curve))
      *out++ = point(p);
    return out;
  }

  /// Writes the input halfedges that a curve crosses. Of the two halfedges of a crossed edge, the one in the face that
  /// the curve leaves is written.
  template <class OutputIterator>
  OutputIterator crossed_halfedges(Curve_index curve, OutputIterator out)
  {
    m_network.for_each_segment(curve, [&](Segment_index s) {
      for(Input_halfedge_index h : m_triangulation.edge_sequence(m_network.halfedge(s)).crossed)
        *out++ = m_triangulation.input().halfedge(h);
    });
    return out;
  }

  /*!
   * Writes a curve as face locations. A face location is a pair of a face and barycentric coordinates, as in
   * `CGAL::Polygon_mesh_processing::Face_location`. The coordinates belong, in this order, to the source of
   * `halfedge(face, mesh)`, to its target, and to the third vertex of the face.
   */
  template <class OutputIterator>
  OutputIterator face_locations(Curve_index curve, const Triangle_mesh& mesh, OutputIterator out)
  {
    for(const Surface_point& p : surface_points(curve))
      *out++ = face_location(m_triangulation, mesh, p);
    return out;
  }

  /*!
   * Writes a curve as `Curve_point`s, which contain points in space, face locations, crossed halfedges and tangents. If
   * the metric has no points in space, `Curve_place`s are written instead.
   *
   * The tangent at a point is the direction of the straight piece that starts at the point; at the last point, it is
   * the direction of the straight piece that ends there. This direction is accurate even if the two ends of the piece
   * nearly coincide.
   */
  template <class OutputIterator>
  OutputIterator curve_points(Curve_index curve, const Triangle_mesh& mesh, OutputIterator out)
  {
    using Form = typename internal::Curve_forms<Triangulation>::All;
    const internal::Form_converter<Triangulation, Form> convert(m_triangulation, mesh);
    std::vector<Form> points;
    m_network.for_each_segment(curve, [&](Segment_index s) { append_segment(convert, m_network.halfedge(s), points); });
    return std::move(points.begin(), points.end(), out);
  }

  /// Returns the position of a surface point in space. The function is available only if the metric has points in
  /// space.
  auto point(const Surface_point& p) const { return point_in_space(m_triangulation, p); }

  /// Returns the edge sequence of a segment of the network.
  Edge_sequence edge_sequence(Segment_index segment)
  {
    return m_triangulation.edge_sequence(m_network.halfedge(segment));
  }

private:
  using Strip = internal::Strip<Triangulation>;
  using Direction = std::array<double, 3>;

  // Reserves memory for `more` additional points, and for exactly this number if the vector is empty.
  static void make_room(std::vector<Surface_point>& points, std::size_t more)
  {
    const std::size_t size = points.size() + more;
    if(size > points.capacity())
      points.reserve((std::max)(size, 2 * points.capacity()));
  }

  Direction in_space(Vertex_index v) const
  {
    const auto point = m_triangulation.metric().point(m_triangulation.input(), v);
    return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
  }

  // The direction of a straight line in the face between portals i - 1 and i of its strip.
  Direction direction_in_face(const Strip& strip, std::size_t i) const
  {
    const auto& input = m_triangulation.input();
    const bool is_last = i == strip.portals().size();
    const Input_halfedge_index h =
        is_last ? internal::twin_index(strip.portals()[i - 1].crossed) : strip.portals()[i].crossed;
    const auto corners = strip.face(i);
    const auto u = corners[1].position - corners[0].position, v = corners[2].position - corners[0].position;
    const double area = internal::cross(u, v), to_u = internal::cross(strip.end(), v) / area,
                 to_v = internal::cross(u, strip.end()) / area;
    const Direction a = in_space(input.uncontracted_tail(h)), b = in_space(input.uncontracted_tail(input.next(h))),
                    c = in_space(input.uncontracted_tail(input.next(input.next(h))));
    Direction result;
    for(int j = 0; j < 3; ++j)
      result[j] = to_u * (b[j] - a[j]) + to_v * (c[j] - a[j]);
    return result;
  }

  // Appends the points of a curve along one segment and sets their tangents. The start of the segment is appended only
  // if it is the first point of the curve.
  template <class Form>
  void append_segment(const internal::Form_converter<Triangulation, Form>& convert, Halfedge_index h,
                      std::vector<Form>& result) const
  {
    const Strip strip(m_triangulation, m_triangulation.edge_sequence(h));
    std::vector<Surface_point> points;
    points.reserve(strip.portals().size() + 2);
    internal::write_surface_points(m_triangulation, h, strip, true, std::back_inserter(points));
    for(std::size_t i = result.empty() ? 0 : 1; i < points.size(); ++i)
      result.push_back(convert(points[i]));
    if constexpr(internal::Has_points<typename Triangulation::Metric>::value)
      for(std::size_t i = 0; i < points.size(); ++i) { // the end gets its own tangent if another segment follows
        Form& p = result[result.size() - points.size() + i];
        if(strip.portals().empty())
          internal::set_tangent(p, result[result.size() - 2].point, result.back().point);
        else
          internal::set_tangent(p, direction_in_face(strip, (std::min)(i, strip.portals().size())));
      }
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_EXTRACT_H
