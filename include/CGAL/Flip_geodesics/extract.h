// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXTRACT_H
#define CGAL_FLIP_GEODESICS_EXTRACT_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/strips/Strip.h>

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
 * Writes the `Surface_point`s of an edge of a triangulation, from the tail of halfedge `h` to its head, both included:
 * where the edge runs on the input mesh. Linear in the crossed edges.
 */
template <class Triangulation, class OutputIterator>
OutputIterator edge_surface_points(const Triangulation& triangulation, Halfedge_index h, OutputIterator out)
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
  OutputIterator surface_points(Curve_index curve, OutputIterator out)
  {
    std::vector<Surface_point> segment;
    bool is_first = true;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      segment.clear();
      edge_surface_points(m_triangulation, m_network.halfedge(s), std::back_inserter(segment));
      out = std::copy(segment.begin() + (is_first ? 0 : 1), segment.end(), out); // its start is the end before
      is_first = false;
    });
    return out;
  }

  /// The surface points of a curve as a vector.
  std::vector<Surface_point> surface_points(Curve_index curve)
  {
    std::vector<Surface_point> result;
    surface_points(curve, std::back_inserter(result));
    return result;
  }

  /// Writes the points of a curve in space, one per surface point. Only with `Embedded_metric`.
  template <class OutputIterator>
  OutputIterator points(Curve_index curve, OutputIterator out)
  {
    for(const Surface_point& p : surface_points(curve))
      *out++ = point(p);
    return out;
  }

  /// Writes the input halfedges that a curve crosses, each as a side of the face that is left.
  template <class OutputIterator>
  OutputIterator crossed_halfedges(Curve_index curve, OutputIterator out)
  {
    m_network.for_each_segment(curve, [&](Segment_index s) {
      for(Input_halfedge_index h : m_triangulation.crossing_word(m_network.halfedge(s)).crossed)
        *out++ = m_triangulation.input().halfedge(h);
    });
    return out;
  }

  /*!
   * Writes a curve as face locations, pairs of a face and barycentric coordinates as in
   * `CGAL::Polygon_mesh_processing::Face_location`: the coordinates belong to the source, target and third vertex of
   * `halfedge(face, mesh)`.
   */
  template <class OutputIterator>
  OutputIterator face_locations(Curve_index curve, const Triangle_mesh& mesh, OutputIterator out)
  {
    for(const Surface_point& p : surface_points(curve))
      *out++ = face_location(p, mesh);
    return out;
  }

  /// The point in space. Only with `Embedded_metric`.
  auto point(const Surface_point& p) const { return point_in_space(m_triangulation, p); }

  /// The word of a segment of the network.
  Crossing_word word(Segment_index segment) { return m_triangulation.crossing_word(m_network.halfedge(segment)); }

private:
  std::pair<face_descriptor, std::array<double, 3>> face_location(const Surface_point& p,
                                                                  const Triangle_mesh& mesh) const
  {
    const auto& input = m_triangulation.input();
    Input_halfedge_index h = p.is_vertex() ? input.outgoing(p.a) : p.halfedge;
    if(input.is_border(h)) // at most one of two consecutive spokes is on the border
      h = p.is_vertex() ? input.next(internal::twin_index(h)) : internal::twin_index(h);
    const face_descriptor f = internal::graph_face(input.halfedge(h), mesh);
    Input_halfedge_index corner = input.index(internal::graph_halfedge(f, mesh));
    std::array<double, 3> weights = {0, 0, 0};
    for(double& weight : weights) {
      const Vertex_index v = p.is_vertex() ? input.tail(corner) : input.uncontracted_tail(corner);
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
  std::array<Vertex_index, 3> vertices;
  std::array<Halfedge_index, 3> halfedges;
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
  for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges())) {
    if(triangulation.is_border(h))
      continue;
    const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
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
