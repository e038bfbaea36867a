// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_METRICS_H
#define CGAL_FLIP_GEODESICS_METRICS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/edge_lengths.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

// What `sine_in_plane()` computes with: whatever calls it includes the definition, since most users of a metric do not.
class Flat_edges;
template <class Mesh, class PlaceOf>
class Planar_sine;

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * A mesh seen by consecutive numbers: what a triangulation has as its input, and what metrics are asked about. It is a
 * class, and no concept, since a metric and all triangulations with it must mean the same elements by the same numbers.
 *
 * Vertices have the numbers of their order in `vertices(mesh)`. The two halfedges of the edge with number `e` in
 * `edges(mesh)` have `2e` and `2e+1`. So a number that a result holds leads back to the mesh: of the
 * `Input_halfedge_index h` of a surface point or a face, `triangulation.input().halfedge(h)` is the mesh's halfedge,
 * and `face(triangulation.input().halfedge(h), mesh)` its face.
 *
 * Member functions take constant time, except that `index()` takes logarithmic time unless the mesh is a
 * `Surface_mesh`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 */
#ifdef DOXYGEN_RUNNING
template <class TriangleMesh>
class Numbered_mesh
{
public:
  /// Numbers a mesh, which must outlive the object. \f$O(n \log n)\f$, but constant time for a `Surface_mesh`, which is
  /// numbered already and not copied.
  explicit Numbered_mesh(const TriangleMesh& mesh);

  Index number_of_vertices() const;  ///< returns the number of vertices
  Index number_of_halfedges() const; ///< returns the number of halfedges
  /// Returns the number of a vertex of the mesh, `null_index` if it does not belong to the mesh.
  Vertex_index index(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v) const;
  /// Returns the number of a halfedge of the mesh, `null_index` if it does not belong to the mesh.
  Input_halfedge_index index(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h) const;
  /// Returns the vertex of the mesh with a number.
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex(Vertex_index v) const;
  /// Returns the halfedge of the mesh with a number.
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge(Input_halfedge_index h) const;

  static Input_halfedge_index twin(Input_halfedge_index h);    ///< returns the other side of the edge
  Input_halfedge_index next(Input_halfedge_index h) const;     ///< returns the next one around face or border
  Input_halfedge_index previous(Input_halfedge_index h) const; ///< returns the previous one around face or border
  Vertex_index tail(Input_halfedge_index h) const;             ///< returns the vertex at which `h` starts
  bool is_border(Input_halfedge_index h) const;                ///< returns whether `h` has no face on its left
  bool is_triangle(Input_halfedge_index h) const;              ///< returns whether the face of `h` has three sides
  /// Returns a halfedge that starts at `v`, `null_index` at an isolated vertex.
  Input_halfedge_index outgoing(Vertex_index v) const;

  /// Returns whether edges of length zero were contracted, see `Zero_length_edges`.
  bool is_contracted() const;
  /// Returns the mesh before edges of length zero were contracted, or itself.
  const Numbered_mesh& uncontracted() const;
};
#else
template <class TriangleMesh>
using Numbered_mesh = internal::Indexed_mesh<TriangleMesh>;
#endif

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * The metric of a mesh embedded in space: edges have the length of the segment between their end points.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam VertexPointMap a model of `ReadablePropertyMap` with the mesh's vertices as keys and points as values
 */
template <class TriangleMesh, class VertexPointMap>
class Embedded_metric
{
  static_assert(internal::is_property_map<VertexPointMap>());

public:
  using Mesh = Numbered_mesh<TriangleMesh>;                                    ///< the mesh, numbered
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type; ///< of the vertices
  using Kernel = typename Kernel_traits<Point_3>::Kernel;                      ///< of the points

  /// Takes the lengths from points.
  /// \param points of the mesh's vertices, read whenever a length is asked for
  explicit Embedded_metric(VertexPointMap points)
    : m_points(points)
  {
  }

  /// The point of vertex `v`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return get(m_points, mesh.vertex(v)); }

  /// The length of halfedge `h`, rounded to double. \throws Invalid_coordinate_error, Degenerate_face_error
  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double length = weight(mesh, h);
    if(!internal::is_usable_length(length)) {
      const Vertex_index v = mesh.tail(h), w = mesh.tail(internal::twin_index(h));
      const Place p = place(mesh, v), q = place(mesh, w); // far or close, their distance is no longer its square's root
      internal::throw_unusable_length(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]), v, w);
    }
    return length;
  }

  /// The coordinates of a point, as the doubles they round to.
  using Place = std::array<double, 3>;

  /// The length of halfedge `h` whatever it is, for a search that only passes by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return distance_lower_bound(place(mesh, mesh.tail(h)), place(mesh, mesh.tail(internal::twin_index(h))));
  }

  /// The same, where the places of the two ends are at hand.
  double weight(const Mesh&, Input_halfedge_index, const Place& tail, const Place& head) const
  {
    return distance_lower_bound(tail, head);
  }

  /// Where vertex `v` is.
  Place place(const Mesh& mesh, Vertex_index v) const
  {
    decltype(auto) p = point(mesh, v);
    return {internal::imported_number(p.x()), internal::imported_number(p.y()), internal::imported_number(p.z())};
  }

  /// A lower bound of the distance on the surface: the distance through space.
  double distance_lower_bound(const Place& p, const Place& q) const { return std::sqrt(squared_distance(p, q)); }

  /// The vectors of the halfedges `h`, `next(h)`, `previous(h)` of an input face. \throws as `length()`
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
    for(Input_halfedge_index side : {h, hn, hp})
      check_length(mesh, side);
    return traits.construct_face_3_object()(point(mesh, mesh.tail(h)), point(mesh, mesh.tail(hn)),
                                            point(mesh, mesh.tail(hp)));
  }

  /// The same face in exact numbers; the coordinates are taken as the doubles they round to.
  internal::Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    std::array<double, 9> coordinates;
    for(std::size_t i = 0; i < 9; i += 3, h = mesh.next(h)) {
      const Place p = place(mesh, mesh.tail(h));
      std::copy(p.begin(), p.end(), coordinates.begin() + i);
    }
    return internal::exact_face_from_points(coordinates);
  }

  /*!
   * The sign of the sine of the wedge from the direction of one word clockwise over `steps` input corners to that of
   * another, exactly, if the faces lie unfolded in one plane of space, or bend along parallel edges only.
   * `flat_edges` keeps what is found out of edges.
   * \return do they?
   */
  bool sine_in_plane(const Mesh& mesh, const Crossing_word& a, const Crossing_word& b, Index steps,
                     internal::Flat_edges& flat_edges, Sign& sine) const
  {
    const auto place_of = [&](Vertex_index v) { return place(mesh, v); };
    return internal::Planar_sine<Mesh, decltype(place_of)>(mesh, place_of, flat_edges)(a, b, steps, sine);
  }

  /// Returns whether a coordinate of the mesh is not a double, so that it is rounded. Then nothing is certified, since
  /// decisions refer to the rounded coordinates. Linear in the mesh when it is first called, if not every number of the
  /// kernel is a double.
  bool is_rounded(const Mesh& mesh) const
  {
    using Coordinate = std::decay_t<decltype(std::declval<const Point_3&>().x())>;
    if constexpr(internal::is_within_double<Coordinate>)
      return static_cast<void>(mesh), false;
    else
      return m_is_rounded([&] {
        const auto vertices = internal::descriptors<Vertex_index>(mesh.number_of_vertices());
        return std::any_of(vertices.begin(), vertices.end(), [&](Vertex_index v) { return is_point_rounded(mesh, v); });
      });
  }

private:
  bool is_point_rounded(const Mesh& mesh, Vertex_index v) const
  {
    decltype(auto) p = point(mesh, v);
    return internal::is_rounded_number(p.x()) || internal::is_rounded_number(p.y()) ||
           internal::is_rounded_number(p.z());
  }

  // Throws what length() throws, but takes no root.
  void check_length(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double square = squared_distance(place(mesh, mesh.tail(h)), place(mesh, mesh.tail(internal::twin_index(h))));
    if(!(square > internal::least_safe_square && square < internal::greatest_safe_square))
      length(mesh, h);
  }

  static double squared_distance(const Place& p, const Place& q)
  {
    const double x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
    return internal::unfused(x * x) + internal::unfused(y * y) + internal::unfused(z * z);
  }

  VertexPointMap m_points;
  internal::Known_rounding m_is_rounded;
};

namespace internal {

/* What metrics of lengths have in common: faces are made of the three lengths, and nothing is known of points. */
template <class Metric>
class Metric_of_lengths
{
public:
  template <class Mesh>
  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double length = metric().weight(mesh, h);
    if(!is_usable_length(length))
      throw_unusable_length(length, mesh.tail(h), mesh.tail(twin_index(h)));
    return length;
  }

  template <class Mesh, class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    const auto [a, b, c] = face_lengths(mesh, h);
    check_triangle_inequality(mesh, h, a, b, c);
    return traits.construct_face_from_lengths_object()(a, b, c);
  }

  template <class Mesh>
  Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return exact_face_from_lengths(face_lengths(mesh, h));
  }

  template <class Mesh>
  bool sine_in_plane(const Mesh&, const Crossing_word&, const Crossing_word&, Index, Flat_edges&, Sign&) const
  {
    return false; // lengths do not determine which faces lie in one plane
  }

protected:
  template <class Mesh>
  std::array<double, 3> face_lengths(const Mesh& mesh, Input_halfedge_index h) const
  {
    const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
    return {length(mesh, h), length(mesh, hn), length(mesh, hp)};
  }

private:
  const Metric& metric() const { return static_cast<const Metric&>(*this); }
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * A metric given by a length for each edge, without any embedding; so are anisotropic metrics given.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the mesh's edges as keys and numbers as values
 */
template <class TriangleMesh, class EdgeLengthMap>
class Edge_length_metric : public internal::Metric_of_lengths<Edge_length_metric<TriangleMesh, EdgeLengthMap>>
{
  static_assert(internal::is_property_map<EdgeLengthMap>());

public:
  using Mesh = Numbered_mesh<TriangleMesh>; ///< the mesh, numbered
  using Kernel = Simple_cartesian<double>;  ///< in which finished curves are measured

  /// Takes the lengths from a property map.
  /// \param mesh must outlive the metric
  /// \param lengths of its edges, read whenever one is asked for; any unit, each between 1e-70 and 1e70
  Edge_length_metric(const TriangleMesh& mesh, EdgeLengthMap lengths)
    : m_mesh(&mesh)
    , m_lengths(lengths)
  {
  }

  /// Nothing: lengths alone do not say where a vertex is.
  struct Place
  {
  };

  /// The length of halfedge `h` whatever it is, for a search that only passes by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::imported_number(get(m_lengths, edge(mesh.halfedge(h), *m_mesh)));
  }

  /// The same: places say nothing.
  double weight(const Mesh& mesh, Input_halfedge_index h, Place, Place) const { return weight(mesh, h); }

  /// Nothing.
  Place place(const Mesh&, Vertex_index) const { return Place(); }

  /// Zero.
  double distance_lower_bound(Place, Place) const { return 0; }

  /// Returns whether a length is not a double, so that it is rounded. Then nothing is certified, since decisions refer
  /// to the rounded lengths. Linear in the mesh when it is first called, if not every value of the map is a double.
  bool is_rounded(const Mesh&) const
  {
    if constexpr(internal::is_within_double<typename boost::property_traits<EdgeLengthMap>::value_type>)
      return false;
    else
      return m_is_rounded([&] {
        const auto all = edges(*m_mesh);
        return std::any_of(all.begin(), all.end(),
                           [&](const auto& e) { return internal::is_rounded_number(get(m_lengths, e)); });
      });
  }

private:
  const TriangleMesh* m_mesh;
  EdgeLengthMap m_lengths;
  internal::Known_rounding m_is_rounded;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_METRICS_H
