// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_METRICS_H
#define CGAL_FLIP_GEODESICS_METRICS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/edge_lengths.h>
#include <CGAL/Flip_geodesics/internal/surface/metric_faces.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

// Callers include the definition, since most users of a metric do not need it.
template <class Mesh, class PlaceOf>
class Planar_sine;

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Represents a mesh by consecutive numbers. It is the input type of triangulations and the argument of metrics. It is a
 * class rather than a concept, since a metric and all triangulations with it must identify elements by the same
 * numbers.
 *
 * Vertices are numbered in the order of `vertices(mesh)`. The two halfedges of the edge with number `e` in
 * `edges(mesh)` have the numbers `2e` and `2e+1`. The numbers in a result therefore lead back to the mesh: for the
 * `Input_halfedge_index h` of a surface point or a face, `triangulation.input().halfedge(h)` is the halfedge of the
 * mesh, and `face(triangulation.input().halfedge(h), mesh)` is its face.
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
  /// already numbered and not copied.
  explicit Numbered_mesh(const TriangleMesh& mesh);

  Index number_of_vertices() const;  ///< returns the number of vertices
  Index number_of_halfedges() const; ///< returns the number of halfedges
  /// Returns the number of a vertex of the mesh, or `null_index` if it does not belong to the mesh.
  Vertex_index index(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v) const;
  /// Returns the number of a halfedge of the mesh, or `null_index` if it does not belong to the mesh.
  Input_halfedge_index index(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h) const;
  /// Returns the vertex of the mesh with a given number.
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex(Vertex_index v) const;
  /// Returns the halfedge of the mesh with a given number.
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge(Input_halfedge_index h) const;

  static Input_halfedge_index twin(Input_halfedge_index h);    ///< returns the other side of the edge
  Input_halfedge_index next(Input_halfedge_index h) const;     ///< returns the next one around face or border
  Input_halfedge_index previous(Input_halfedge_index h) const; ///< returns the previous one around face or border
  Vertex_index tail(Input_halfedge_index h) const;             ///< returns the vertex at which `h` starts
  bool is_border(Input_halfedge_index h) const;                ///< returns whether `h` has no face on its left
  bool is_triangle(Input_halfedge_index h) const;              ///< returns whether the face of `h` has three sides
  /// Returns a halfedge that starts at `v`, or `null_index` for an isolated vertex.
  Input_halfedge_index outgoing(Vertex_index v) const;

  /// Returns whether degenerate edges were contracted, see `Zero_length_edges`.
  bool is_contracted() const;
  /// Returns the mesh before degenerate edges were contracted, or itself.
  const Numbered_mesh& uncontracted() const;
};
#else
template <class TriangleMesh>
using Numbered_mesh = internal::Indexed_mesh<TriangleMesh>;
#endif

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents the metric of a mesh embedded in space: the length of an edge is the distance of its end points.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys and points as values
 */
template <class TriangleMesh, class VertexPointMap>
class Embedded_metric
{
  static_assert(internal::is_property_map<VertexPointMap>());

public:
  using Mesh = Numbered_mesh<TriangleMesh>;                                    ///< the mesh, numbered
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type; ///< of the vertices
  using Kernel = typename Kernel_traits<Point_3>::Kernel;                      ///< of the points

private:
  static constexpr bool is_rational = internal::has_rational_coordinates<Point_3>;

public:
  /// Constructs the metric of given points.
  /// \param points the points of the vertices of the mesh, which must not change while the metric is used
  explicit Embedded_metric(VertexPointMap points)
    : m_points(points)
  {
  }

  /// Returns the point of vertex `v`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return get(m_points, mesh.vertex(v)); }

  /// Returns the length of halfedge `h`, rounded to double. \throws Invalid_coordinate_error if the length is not
  /// finite or out of range \throws Degenerate_face_error if the length is zero
  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double length = weight(mesh, h);
    if(!internal::is_usable_length(length)) {
      const std::array<double, 3> v = vector(mesh, h);
      const double by_hypot = std::hypot(v[0], v[1], v[2]); // its square can overflow or underflow
      internal::throw_unusable_length(by_hypot == 0 ? length : by_hypot, mesh.tail(h),
                                      mesh.tail(internal::twin_index(h)));
    }
    return length;
  }

  /// The coordinates of a point: doubles, or those near rational numbers with a bound of the error.
#ifdef DOXYGEN_RUNNING
  using Place = unspecified_type;
#else
  using Place = std::conditional_t<is_rational, internal::Approximate_place, std::array<double, 3>>;
#endif

  /// The length of halfedge `h` whatever it is, for a search that only passes by. Zero only if the points are equal.
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double length = std::sqrt(squared_norm(vector(mesh, h)));
    if constexpr(is_rational)
      if(length == 0 && !is_zero(mesh, h))
        return (std::numeric_limits<double>::min)();
    return length;
  }

  /// The same, where the places of the two ends are at hand. If these are near rational numbers, it errs by some units
  /// in the last place of the coordinates, or by \f$2^{-40}\f$ of the length if that is less.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    if constexpr(is_rational) {
      double error = 0;
      const double length = std::sqrt(squared_norm(internal::approximate_vector(tail, head, error)));
      return error == 0 || error <= internal::search_length_error * length ? length : weight(mesh, h);
    } else {
      return static_cast<void>(mesh), static_cast<void>(h), std::sqrt(squared_norm(difference(tail, head)));
    }
  }

  /// Where vertex `v` is.
  Place place(const Mesh& mesh, Vertex_index v) const
  {
    if constexpr(is_rational) {
      if constexpr(internal::Is_lazy_point<Point_3>::value)
        return internal::approximate_place(point(mesh, v));
      else
        return internal::approximate_place(precise_place(mesh, v));
    } else {
      decltype(auto) p = point(mesh, v);
      return {internal::imported_number(p.x()), internal::imported_number(p.y()), internal::imported_number(p.z())};
    }
  }

  /// A lower bound of the distance on the surface: the distance through space.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    if constexpr(is_rational)
      return std::sqrt(squared_norm(internal::least_vector(p, q)));
    else
      return std::sqrt(squared_norm(difference(p, q)));
  }

  /// Returns the vectors of the halfedges `h`, `next(h)`, `previous(h)` of an input face, with the exceptions of
  /// `length()`.
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    using Construct = typename Traits::Construct_face_3;
    const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
    if constexpr(is_rational && std::is_invocable<const Construct&, const internal::Rounded_sides&>::value) {
      const internal::Rounded_sides sides = {{vector(mesh, h), vector(mesh, hn), vector(mesh, hp)}};
      check_length(mesh, h, sides.vectors[0]);
      check_length(mesh, hn, sides.vectors[1]);
      check_length(mesh, hp, sides.vectors[2]);
      return traits.construct_face_3_object()(sides);
    }
    for(Input_halfedge_index side : {h, hn, hp})
      check_length(mesh, side, vector(mesh, side));
    return traits.construct_face_3_object()(point(mesh, mesh.tail(h)), point(mesh, mesh.tail(hn)),
                                            point(mesh, mesh.tail(hp)));
  }

  /// Returns whether a coordinate of the mesh is rounded: it is not a double, and its type does not give the exact
  /// value as a fraction. Then nothing is certified, since decisions refer to the rounded coordinates. Linear in the
  /// mesh when it is first called, if the number type of the kernel allows such coordinates.
  bool is_rounded(const Mesh& mesh) const
  {
    if constexpr(is_rational || internal::is_within_double<internal::Coordinate<Point_3>>)
      return static_cast<void>(mesh), false;
    else
      return m_is_rounded([&] {
        const auto vertices = internal::descriptors<Vertex_index>(mesh.number_of_vertices());
        return std::any_of(vertices.begin(), vertices.end(), [&](Vertex_index v) { return is_point_rounded(mesh, v); });
      });
  }

private:
  friend struct internal::Internals<Embedded_metric>;

  // The vector from one vertex to another; each coordinate is rounded once.
  std::array<double, 3> vector(const Mesh& mesh, Vertex_index v, Vertex_index w) const
  {
    if constexpr(is_rational)
      return internal::rounded_vector(precise_place(mesh, v), precise_place(mesh, w),
                                      [&](const auto& use) { return use(point(mesh, v), point(mesh, w)); });
    else
      return difference(place(mesh, v), place(mesh, w));
  }

  bool is_point_rounded(const Mesh& mesh, Vertex_index v) const
  {
    decltype(auto) p = point(mesh, v);
    return internal::is_rounded_number(p.x()) || internal::is_rounded_number(p.y()) ||
           internal::is_rounded_number(p.z());
  }

  using Exact_place = std::conditional_t<is_rational, internal::Rational_place, Place>;

  Exact_place exact_place(const Mesh& mesh, Vertex_index v) const
  {
    if constexpr(is_rational)
      return internal::rational_place(point(mesh, v));
    else
      return place(mesh, v);
  }

  bool is_zero(const Mesh& mesh, Input_halfedge_index h) const
  {
    return point(mesh, mesh.tail(h)) == point(mesh, mesh.tail(internal::twin_index(h)));
  }

  // Throws the exceptions of length(), but does not compute a root.
  void check_length(const Mesh& mesh, Input_halfedge_index h, const std::array<double, 3>& vector) const
  {
    const double square = squared_norm(vector);
    if(!(square > internal::least_safe_square && square < internal::greatest_safe_square))
      length(mesh, h);
  }

  std::array<double, 3> vector(const Mesh& mesh, Input_halfedge_index h) const
  {
    return vector(mesh, mesh.tail(h), mesh.tail(internal::twin_index(h)));
  }

  internal::Precise_place precise_place(const Mesh& mesh, Vertex_index v) const
  {
    return m_places(v, mesh.number_of_vertices(), [&] { return internal::precise_place(point(mesh, v)); });
  }

  static std::array<double, 3> difference(const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }

  static double squared_norm(const std::array<double, 3>& v)
  {
    return internal::unfused(v[0] * v[0]) + internal::unfused(v[1] * v[1]) + internal::unfused(v[2] * v[2]);
  }

  struct No_places
  {
  };

  VertexPointMap m_points;
  internal::Known_rounding m_is_rounded;
  std::conditional_t<is_rational, internal::Precise_places, No_places> m_places;
};

namespace internal {

template <class TriangleMesh, class VertexPointMap>
struct Internals<Embedded_metric<TriangleMesh, VertexPointMap>>
{
  using Metric = Embedded_metric<TriangleMesh, VertexPointMap>;
  using Mesh = typename Metric::Mesh;

  static constexpr bool has_exact_faces = true;
  static constexpr bool has_usable_faces = false;

  /* Coordinates are taken as they are, or as the doubles to which they round, see `Metric::is_rounded()`. */
  static Exact_face exact_face(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
  {
    const auto place = [&](Input_halfedge_index g) { return metric.exact_place(mesh, mesh.tail(g)); };
    const Input_halfedge_index hn = mesh.next(h);
    const std::array<typename Metric::Exact_place, 3> places = {place(h), place(hn), place(mesh.next(hn))};
    std::array<Integer, 9> coordinates;
    to_integers(places.data(), places.size(), coordinates.data());
    return exact_face_from_points(coordinates);
  }

  static bool sine_in_plane(const Metric& metric, const Mesh& mesh, const Edge_sequence& a, const Edge_sequence& b,
                            Index steps, Flat_edges& flat_edges, Sign& sine)
  {
    const auto place_of = [&](Vertex_index v) { return metric.exact_place(mesh, v); };
    return Planar_sine<Mesh, decltype(place_of)>(mesh, place_of, flat_edges)(a, b, steps, sine);
  }

  static std::array<double, 3> vector(const Metric& metric, const Mesh& mesh, Vertex_index v, Vertex_index w)
  {
    return metric.vector(mesh, v, w);
  }
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents a metric given by a length for each edge, without any embedding. Anisotropic metrics can be given in this
 * form.
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edges of the mesh as keys and numbers as values
 */
template <class TriangleMesh, class EdgeLengthMap>
class Edge_length_metric
{
  static_assert(internal::is_property_map<EdgeLengthMap>());

  using Length = typename boost::property_traits<EdgeLengthMap>::value_type;
  static constexpr bool is_rational = internal::is_rational_number<Length>;

public:
  using Mesh = Numbered_mesh<TriangleMesh>; ///< the mesh, numbered
  using Kernel = Simple_cartesian<double>;  ///< in which finished curves are measured
  using Point_3 = void;                     ///< `void`, since lengths do not determine points

  /// Constructs the metric of given lengths.
  /// \param mesh the mesh, which must outlive the metric
  /// \param lengths the lengths of its edges, which are read whenever they are needed; in any unit, each between 1e-70
  ///        and 1e70
  Edge_length_metric(const TriangleMesh& mesh, EdgeLengthMap lengths)
    : m_mesh(&mesh)
    , m_lengths(lengths)
  {
  }

  /// Is empty, since lengths do not determine the positions of vertices.
  struct Place
  {
  };

  /// Returns the length of halfedge `h`, rounded to double. \throws Invalid_coordinate_error if the length is not
  /// finite or out of range \throws Degenerate_face_error if the length is zero
  double length(const Mesh& mesh, Input_halfedge_index h) const { return internal::length_by_weight(*this, mesh, h); }

  /// Returns the length of halfedge `h` without any check, for searches that only pass by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::imported_number(get(m_lengths, edge(mesh.halfedge(h), *m_mesh)));
  }

  /// Returns the length of halfedge `h`; the positions contain no data.
  double weight(const Mesh& mesh, Input_halfedge_index h, Place, Place) const { return weight(mesh, h); }

  /// Returns an empty object.
  Place place(const Mesh&, Vertex_index) const { return Place(); }

  /// Returns zero.
  double distance_lower_bound(Place, Place) const { return 0; }

  /// The squared length of halfedge `h`, exactly. Only if the type of lengths is exact and rational.
#ifdef DOXYGEN_RUNNING
  unspecified_type squared_length(const Mesh& mesh, Input_halfedge_index h) const;
#else
  template <class Number = Length, std::enable_if_t<internal::is_rational_number<Number>, int> = 0>
  auto squared_length(const Mesh& mesh, Input_halfedge_index h) const
  {
    using Square = std::conditional_t<std::is_integral<Number>::value, internal::Integer, Number>; // may overflow
    const Square length(get(m_lengths, edge(mesh.halfedge(h), *m_mesh)));
    return Square(length * length);
  }
#endif

  /// Returns the geometry of an input face by its lengths, from `h` on, with the exceptions of `length()`.
  /// \throws Degenerate_face_error if the lengths violate the triangle inequality
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_geometry_by_lengths(*this, mesh, h, traits);
  }

  /// Returns whether a length is rounded: it is not a double, and its type does not give the exact value as a fraction.
  /// Then nothing is certified, since decisions refer to the rounded lengths. Linear in the mesh when it is first
  /// called, if the type allows such lengths.
  bool is_rounded(const Mesh&) const
  {
    if constexpr(is_rational || internal::is_within_double<Length>)
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

namespace internal {

template <class TriangleMesh, class EdgeLengthMap>
struct Internals<Edge_length_metric<TriangleMesh, EdgeLengthMap>> : Internals_of_lengths
{
};

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_METRICS_H
