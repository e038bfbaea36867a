// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_METRICS_H
#define CGAL_FLIP_GEODESICS_METRICS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/metric_places.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

// Callers include the definition, since most users of a metric do not need it.
template <class Mesh, class PlaceOf>
class Planar_sine;

inline void check_halfedges(std::size_t of_metric, std::size_t of_mesh)
{
  if(of_metric != of_mesh)
    throw Input_mismatch_error("the metric was constructed for a mesh of " + std::to_string(of_metric / 2) +
                               " edges, but is used for a mesh of " + std::to_string(of_mesh / 2) + " edges");
}

/* Throws Input_mismatch_error if a metric detects that it was made for another mesh. */
template <class Metric, class Mesh>
void check_input(const Metric& metric, const Mesh& mesh)
{
  if constexpr(checks_input<Metric, Mesh>)
    metric.check_input(mesh);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * Represents a mesh whose vertices and halfedges are numbered consecutively. An object of this type is the input of a
 * triangulation, and is passed to the member functions of metrics.
 *
 * Vertices are numbered in the order of `vertices(mesh)`. The two halfedges of the edge at position `e` in
 * `edges(mesh)` have the numbers `2e` and `2e+1`, unless degenerate edges were contracted. The numbers in a result can
 * be converted back to elements of the mesh. For example, if `h` is the `Input_halfedge_index` of a surface point,
 * `triangulation.input().halfedge(h)` is the halfedge of the mesh.
 *
 * Complexity: constant for all member functions other than the constructor and `index()`. If the mesh is a
 * `Surface_mesh`, `index()` also takes constant time. For other meshes, it takes time logarithmic in the size of the
 * mesh.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 */
#ifdef DOXYGEN_RUNNING
template <class TriangleMesh>
class Numbered_mesh
{
public:
  /// Numbers a mesh, which must outlive the object. Complexity: constant for a `Surface_mesh`, whose own numbers are
  /// used, and \cgalBigO{n \log n} for other meshes, where \f$n\f$ is the size of the mesh.
  explicit Numbered_mesh(const TriangleMesh& mesh);

  Index number_of_vertices() const;  ///< returns the number of vertices
  Index number_of_halfedges() const; ///< returns the number of halfedges
  /// Returns the number of a vertex, or `null_index` if the vertex does not belong to the mesh.
  Vertex_index index(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v) const;
  /// Returns the number of a halfedge, or `null_index` if the halfedge does not belong to the mesh, or was removed when
  /// degenerate edges were contracted.
  Input_halfedge_index index(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h) const;
  /// Returns the vertex of the mesh with a given number.
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex(Vertex_index v) const;
  /// Returns the halfedge of the mesh with a given number.
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge(Input_halfedge_index h) const;

  static Input_halfedge_index twin(Input_halfedge_index h); ///< returns the opposite halfedge
  Input_halfedge_index next(Input_halfedge_index h) const;  ///< returns the next halfedge around the face or border
  Input_halfedge_index previous(
      Input_halfedge_index h) const;               ///< returns the previous halfedge around the face or border
  Vertex_index tail(Input_halfedge_index h) const; ///< returns the vertex at which `h` starts
  bool is_border(Input_halfedge_index h) const;    ///< returns whether `h` has no face on its left
  bool is_triangle(Input_halfedge_index h) const;  ///< returns whether the face of `h` has three sides
  /// Returns a halfedge that starts at `v`, or `null_index` for an isolated vertex.
  Input_halfedge_index outgoing(Vertex_index v) const;

  /// Returns whether degenerate edges were contracted; see `Zero_length_edges`.
  bool is_contracted() const;
  /// Returns the mesh as it was before degenerate edges were contracted, or this mesh if none were contracted.
  const Numbered_mesh& uncontracted() const;
};
#else
template <class TriangleMesh>
using Numbered_mesh = internal::Indexed_mesh<TriangleMesh>;
#endif

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents the metric of a mesh embedded in space: the length of an edge is the distance between its end points.
 *
 * \cgalModels{IntrinsicMetric}
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam VertexPointMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys and points as values
 */
template <class TriangleMesh, class VertexPointMap>
class Embedded_metric
{
  static_assert(internal::is_readable<VertexPointMap, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>,
                "an Embedded_metric requires a property map of points for the vertices of the mesh");

public:
  using Mesh = Numbered_mesh<TriangleMesh>;                                    ///< the mesh, numbered
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type; ///< the point type of the vertices
  using Kernel = typename Kernel_traits<Point_3>::Kernel;                      ///< the kernel of the points

private:
  static constexpr bool is_rational = internal::has_rational_coordinates<Point_3>;

public:
  /// Constructs the metric of given points.
  /// \param points the points of the vertices of the mesh; the points must not change while the metric is used
  explicit Embedded_metric(VertexPointMap points)
    : m_points(points)
  {
  }

  /// Returns the point of vertex `v`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return get(m_points, mesh.vertex(v)); }

  /// Returns the length of halfedge `h`, rounded to double.
  /// \throws Degenerate_face_error if the length is zero
  /// \throws Invalid_coordinate_error if the length is neither zero nor a number between 1e-70 and 1e70
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

  /// The coordinates of a point. If their number type is exact and has rational values, approximations by doubles with
  /// error bounds are stored; otherwise, doubles are stored.
#ifdef DOXYGEN_RUNNING
  using Place = unspecified_type;
#else
  using Place = std::conditional_t<is_rational, internal::Approximate_place, std::array<double, 3>>;
#endif

  /// Returns the length of halfedge `h` without checking it, for use in searches. The result is zero if the two points
  /// are equal. Unless the number type of the coordinates is exact and has rational values, the result is also zero if
  /// the square of the length underflows.
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double length = std::sqrt(squared_norm(vector(mesh, h)));
    if constexpr(is_rational)
      if(length == 0 && !is_zero(mesh, h))
        return (std::numeric_limits<double>::min)();
    return length;
  }

  /// Returns the length of halfedge `h`, given the coordinates of its two ends. If the coordinates are approximations,
  /// the result differs from `weight(mesh, h)` by at most about \f$2^{-40}\f$ of the length.
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

  /// Returns the coordinates of vertex `v`.
  Place place(const Mesh& mesh, Vertex_index v) const
  {
    if constexpr(is_rational) {
      if constexpr(internal::is_lazy_point<Point_3>)
        return internal::approximate_place(point(mesh, v));
      else
        return internal::approximate_place(precise_place(mesh, v));
    } else {
      decltype(auto) p = point(mesh, v);
      return {internal::imported_number(p.x()), internal::imported_number(p.y()), internal::imported_number(p.z())};
    }
  }

  /// Returns a lower bound on the lengths of all paths on the surface between two points: their distance in space, or,
  /// if the coordinates are approximations, a lower bound on this distance.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    if constexpr(is_rational)
      return std::sqrt(squared_norm(internal::least_vector(p, q)));
    else
      return std::sqrt(squared_norm(difference(p, q)));
  }

  /// Returns the geometry of the face on the left of `h`, with `h` as the first halfedge. The geometry is constructed
  /// from the points of the vertices of the face. Throws the exceptions that `length()` throws.
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    using Sides = std::array<std::array<double, 3>, 3>;
    const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
    const Vertex_index u = mesh.tail(h), v = mesh.tail(hn), w = mesh.tail(hp);
    const Sides sides = {{vector(mesh, u, v), vector(mesh, v, w), vector(mesh, w, u)}};
    check_length(mesh, h, sides[0]);
    check_length(mesh, hn, sides[1]);
    check_length(mesh, hp, sides[2]);
    const auto construct = traits.construct_face_3_object();
    if constexpr(std::is_invocable<decltype(construct), const Sides&>::value)
      return construct(sides);
    else
      return construct(point(mesh, u), point(mesh, v), point(mesh, w));
  }

  /// Returns whether a coordinate of the mesh must be rounded. A coordinate must be rounded if its value is not that of
  /// a double and its number type does not provide the value as a fraction. If the function returns `true`, nothing is
  /// certified, since predicates refer to the rounded coordinates. Complexity: constant, except that the first call
  /// takes time linear in the size of the mesh if the number type of the kernel allows such coordinates.
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
                                      [&] { return internal::precise_vector(point(mesh, v), point(mesh, w)); });
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
  internal::Cached_decision m_is_rounded;
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
    return exact_face_from_points(to_integers(places));
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
 * \cgalModels{IntrinsicMetric}
 *
 * \tparam TriangleMesh a model of `FaceListGraph`
 * \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edges of the mesh as keys and numbers as values
 */
template <class TriangleMesh, class EdgeLengthMap>
class Edge_length_metric
{
  static_assert(internal::has_faces<TriangleMesh>,
                "an Edge_length_metric takes a mesh and a property map of the lengths of its edges");
  static_assert(internal::is_number_map<EdgeLengthMap, typename boost::graph_traits<TriangleMesh>::edge_descriptor>());

  using Length = typename internal::Map_traits<EdgeLengthMap>::value_type;
  static constexpr bool is_rational = internal::is_rational_number<Length>;

public:
  using Mesh = Numbered_mesh<TriangleMesh>; ///< the mesh, numbered
  using Kernel = Simple_cartesian<double>;  ///< the kernel in which finished curves are measured
  using Point_3 = void;                     ///< `void`, since lengths do not determine points

  /// Constructs the metric of given lengths.
  /// \param mesh the mesh, which must outlive the metric
  /// \param lengths the lengths of the edges in any unit, each between 1e-70 and 1e70. They must not change while the
  ///        metric is used
  Edge_length_metric(const TriangleMesh& mesh, EdgeLengthMap lengths)
    : m_mesh(&mesh)
    , m_lengths(lengths)
  {
  }

  /// An empty class, since lengths do not determine the positions of vertices.
  struct Place
  {
  };

  /// Returns the length of halfedge `h`, rounded to double.
  /// \throws Degenerate_face_error if the length is zero
  /// \throws Invalid_coordinate_error if the length is neither zero nor a number between 1e-70 and 1e70
  double length(const Mesh& mesh, Input_halfedge_index h) const { return internal::length_by_weight(*this, mesh, h); }

  /// Returns the length of halfedge `h` without checking it, for use in searches.
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::imported_number(get(m_lengths, edge(mesh.halfedge(h), *m_mesh)));
  }

  /// Returns the length of halfedge `h`.
  double weight(const Mesh& mesh, Input_halfedge_index h, Place, Place) const { return weight(mesh, h); }

  /// Returns an empty object.
  Place place(const Mesh&, Vertex_index) const { return Place(); }

  /// Returns zero, since lengths do not determine distances in space.
  double distance_lower_bound(Place, Place) const { return 0; }

  /// Returns the exact squared length of halfedge `h`. Available only if the number type of the lengths is exact, and
  /// has rational values that need not be doubles.
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

  /// Returns the geometry of the face on the left of `h`, with `h` as the first halfedge. The geometry is constructed
  /// from the lengths of the edges of the face. Throws the exceptions that `length()` throws.
  /// \throws Degenerate_face_error if the lengths violate the triangle inequality
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_geometry_by_lengths(*this, mesh, h, traits);
  }

  /// Returns whether a length must be rounded. A length must be rounded if its value is not that of a double and its
  /// number type does not provide the value as a fraction. If the function returns `true`, nothing is certified, since
  /// predicates refer to the rounded lengths. Complexity: constant, except that the first call takes time linear in the
  /// size of the mesh if the number type of the lengths allows such values.
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

  /// Checks that the metric was made for a mesh with the same number of edges as `mesh`.
  /// \throws Input_mismatch_error if the numbers differ
  void check_input(const Mesh& mesh) const
  {
    internal::check_halfedges(num_halfedges(*m_mesh), num_halfedges(mesh.mesh()));
  }

private:
  const TriangleMesh* m_mesh;
  EdgeLengthMap m_lengths;
  internal::Cached_decision m_is_rounded;
};

namespace internal {

/* Constructs the exact faces of metrics whose faces are defined by lengths in double. Lengths do not determine which
 * faces lie in one plane. */
struct Internals_of_lengths
{
  static constexpr bool has_exact_faces = true;
  static constexpr bool has_usable_faces = false;

  template <class Metric, class Mesh>
  static Exact_face exact_face(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
  {
    return exact_face_from_lengths(face_lengths(metric, mesh, h));
  }

  template <class... Arguments>
  static bool sine_in_plane(Arguments&&...)
  {
    return false;
  }
};

template <class TriangleMesh, class EdgeLengthMap>
struct Internals<Edge_length_metric<TriangleMesh, EdgeLengthMap>> : Internals_of_lengths
{
};

/* Divides lengths by a power of two, so that the largest is at least 1 and less than 2. Returns the exponent of the
 * power. */
inline int scale_to_one(std::array<double, 3>& lengths)
{
  const int exponent = std::ilogb((std::max)({lengths[0], lengths[1], lengths[2]}));
  for(double& length : lengths)
    length = std::scalbn(length, -exponent);
  return exponent;
}

/*
 * Returns a lower bound on the factor by which the linear map from the triangle with the sides `before` to the triangle
 * with the sides `after` stretches segments. Rounding errors are subtracted. The sides `before` may be wrong by some
 * units in the last place, or zero; the sides `after` are taken as given. The result is zero if one of the sides is
 * invalid, or if the sides `after` form a degenerate triangle.
 *
 * The stretch of the sides alone is not sufficient: if two of them are stretched less than the third, heights can
 * become shorter by any factor.
 *
 * The linear map back, from `after` to `before`, stretches by at most its larger singular value. The sum of the squares
 * of both singular values follows from the cotangents of `after` [PP93], and their product is the ratio of the areas.
 */
inline double least_stretch(std::array<double, 3> before, std::array<double, 3> after)
{
  if(!std::all_of(after.begin(), after.end(), is_usable_length) ||
     !std::all_of(before.begin(), before.end(), is_zero_or_usable_length))
    return 0;
  if(before == std::array<double, 3>{{0, 0, 0}})
    return std::numeric_limits<double>::infinity();
  const int exponent = scale_to_one(after) - scale_to_one(before);
  const Plane_triangle shape(after);
  double sum = 0; // of squares of singular values, times twice the area
  for(int i = 0; i < 3; ++i)
    sum += shape.cotangents[i] * before[(i + 1) % 3] * before[(i + 1) % 3]; // of the side opposite to the corner
  const double area_before = Plane_triangle(before).area;
  const double most_squares = sum / (2 * shape.area) + area_product_error / (shape.area * shape.area);
  const double least_square_of_product = (area_before * area_before - area_product_error) / (shape.area * shape.area);
  const double difference = most_squares * most_squares - 4 * (std::max)(least_square_of_product, 0.0);
  const double most = 0.5 * (most_squares + std::sqrt((std::max)(difference, 0.0)));
  // `most` is NaN if the face is degenerate.
  return most > 0 ? (1 - stretch_rounding) * std::scalbn(1 / std::sqrt(most), exponent) : 0;
}

/*
 * Returns the least stretch of all faces of a mesh between two metrics, or infinity if the mesh has no faces.
 * Complexity: linear in the size of the mesh.
 */
template <class Before, class After, class Input_mesh>
double least_stretch_of_faces(const Before& before, const After& after, const Input_mesh& mesh)
{
  const auto lengths = [&mesh](const auto& metric, Input_halfedge_index h) {
    const Input_halfedge_index hn = mesh.next(h);
    return std::array<double, 3>{{metric.weight(mesh, h), metric.weight(mesh, hn), metric.weight(mesh, mesh.next(hn))}};
  };
  double least = std::numeric_limits<double>::infinity();
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(mesh.number_of_halfedges()))
    if(!mesh.is_border(h) && h < mesh.next(h) && h < mesh.next(mesh.next(h)))
      least = (std::min)(least, least_stretch(lengths(before, h), lengths(after, h)));
  return least;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents a metric that is obtained from a given metric by adding the same small number to the length of every edge
 * \cgalCite{SC20b,section 4.5}. This number is chosen such that each face satisfies the triangle inequality with a
 * margin. Meshes with degenerate edges and faces can be used with this metric, at the cost of a slightly different
 * surface.
 *
 * Curves are geodesics of the modified surface. If the given metric has points, however, the points of the curves lie
 * on the original mesh.
 *
 * \tparam Metric `Embedded_metric`, `Edge_length_metric`, or a `Weighted_metric` of one of these two
 *
 * \cgalModels{IntrinsicMetric}
 */
template <class Metric>
class Mollified_metric : private Metric
{
  static_assert(internal::is_metric<Metric>, "a Mollified_metric takes a mesh and another metric");
  using Base = Metric;

public:
  using Mesh = typename Base::Mesh;       ///< the mesh, numbered
  using Kernel = typename Base::Kernel;   ///< the kernel of the given metric
  using Point_3 = typename Base::Point_3; ///< the point type of the given metric, `void` if it has none

  /// Constructs a metric that equals the given metric: nothing is added to the lengths.
  explicit Mollified_metric(const Metric& metric)
    : Base(metric)
  {
  }

  /*!
   * Constructs the metric, and computes the length that is added to every edge. The margin of the triangle inequality
   * is 1e-5 times the mean edge length.
   *
   * \param mesh the triangle mesh of the metric
   * \param metric the given metric
   * \throws Invalid_coordinate_error if the length of an edge is negative or not finite
   * \throws Invalid_mesh_error if a face is not a triangle
   * \throws Input_mismatch_error if the given metric detects that it was made for another mesh
   *
   * Complexity: linear in the size of the mesh for a `Surface_mesh`, and \cgalBigO{n \log n} for other meshes, where
   * \f$n\f$ is the size of the mesh.
   */
  template <class TriangleMesh>
  Mollified_metric(const TriangleMesh& mesh, const Metric& metric)
    : Mollified_metric(mesh, metric, internal::default_mollification)
  {
  }

  /*!
   * Constructs the metric with a given margin, and computes the length that is added to every edge.
   *
   * \param mesh the triangle mesh of the metric
   * \param metric the given metric
   * \param factor the margin of the triangle inequality, relative to the mean edge length
   * \pre 0 < factor < 1
   * \throws Invalid_coordinate_error if the length of an edge is negative or not finite
   * \throws Invalid_mesh_error if a face is not a triangle
   * \throws Input_mismatch_error if the given metric detects that it was made for another mesh
   *
   * Complexity: linear in the size of the mesh for a `Surface_mesh`, and \cgalBigO{n \log n} for other meshes, where
   * \f$n\f$ is the size of the mesh.
   */
  template <class TriangleMesh>
  Mollified_metric(const TriangleMesh& mesh, const Metric& metric, double factor)
    : Base(metric)
  {
    CGAL_precondition(0 < factor && factor < 1);
    const Mesh indexed(mesh);
    internal::check_input(metric, indexed);
    m_halfedges = static_cast<std::size_t>(indexed.number_of_halfedges());
    m_added = needed_length(indexed, factor * mean_length(indexed));
    if constexpr(!std::is_empty<Place>::value)
      m_least_stretch = (std::min)(1., internal::least_stretch_of_faces(base(), *this, indexed));
  }

  /// Returns the length that is added to every edge. If no addition is needed, this length is zero, and the metric
  /// equals the given metric.
  double added_length() const { return m_added; }

  /// Returns the length of halfedge `h`, rounded to double.
  /// \throws Degenerate_face_error if the length is zero
  /// \throws Invalid_coordinate_error if the length is neither zero nor a number between 1e-70 and 1e70
  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_added == 0 ? Base::length(mesh, h) : internal::length_by_weight(*this, mesh, h);
  }

  /// Returns the length of halfedge `h` without checking it, for use in searches.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return Base::weight(mesh, h) + m_added; }

  using typename Base::Place;

  /// Returns the length of halfedge `h`, given the positions of its two ends.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return Base::weight(mesh, h, tail, head) + m_added;
  }

  using Base::place;

  /// Returns the lower bound that the given metric returns, multiplied by a factor of at most 1: in this metric, the
  /// length of each line segment in a face is at least this factor times its length in the given metric.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    return m_least_stretch * Base::distance_lower_bound(p, q);
  }

  /// Returns the point of vertex `v`. Available only if the given metric has points.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return Base::point(mesh, v); }

  /// Returns the geometry of the face on the left of `h`, with `h` as the first halfedge. Throws the exceptions that
  /// this member of the given metric throws.
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    if(m_added == 0)
      return internal::face_geometry(base(), mesh, h, traits);
    const auto [a, b, c] = internal::face_lengths(*this, mesh, h);
    return traits.construct_face_from_lengths_object()(a, b, c);
  }

  /// Returns whether the given metric rounds numbers of the mesh. If it does, nothing is certified.
  using Base::is_rounded;

  /// Checks that this metric and the given metric were made for meshes with the same number of edges as `mesh`.
  /// \throws Input_mismatch_error if the numbers differ
  void check_input(const Mesh& mesh) const
  {
    const std::size_t halfedges = static_cast<std::size_t>(mesh.number_of_halfedges());
    internal::check_halfedges(m_halfedges.value_or(halfedges), halfedges);
    internal::check_input(base(), mesh);
  }

private:
  friend struct internal::Internals<Mollified_metric>;

  const Base& base() const { return *this; }

  double checked_weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    const double weight = Base::weight(mesh, h);
    if(!(weight >= 0) || std::isinf(weight))
      internal::throw_unusable_length(weight, mesh.tail(h), mesh.tail(internal::twin_index(h)));
    return weight;
  }

  double mean_length(const Mesh& mesh) const
  {
    double sum = 0;
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(mesh.number_of_halfedges()))
      sum += internal::is_first_side(h) ? checked_weight(mesh, h) : 0;
    return mesh.number_of_halfedges() == 0 ? 0 : sum / (mesh.number_of_halfedges() / 2);
  }

  // Adding e to three sides adds e to the margin of each triangle inequality.
  double needed_length(const Mesh& mesh, double margin) const
  {
    double needed = 0;
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(mesh.number_of_halfedges())) {
      if(mesh.is_border(h))
        continue;
      internal::check_triangle(mesh, h);
      const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
      needed = (std::max)(needed, margin + Base::weight(mesh, h) - Base::weight(mesh, hn) - Base::weight(mesh, hp));
    }
    return needed;
  }

  std::optional<std::size_t> m_halfedges; // the number for which a length was computed
  double m_added = 0;
  double m_least_stretch = 1;
};

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents a metric that is obtained from a given metric by multiplying each edge length by a factor. The factors are
 * derived from given weights, so that paths avoid regions in which the weights are large.
 *
 * Weights given for vertices are interpolated linearly along edges: the length of each edge in the given metric is
 * multiplied by the mean of the weights of its two ends. Each face remains a flat triangle, whose sides have the new
 * lengths. If the weight changes little within a face, the new metric is, up to terms of second order, the given metric
 * scaled conformally by the weight.
 *
 * A weight given for an edge is the factor by which the length of this edge is multiplied.
 *
 * Weights given for faces do not define the length of an edge between two faces with different weights. They are
 * therefore converted to weights of vertices: the weight of a vertex is the mean of the weights of its incident faces.
 *
 * If the weights change so much within a face that the new lengths violate the triangle inequality,
 * `Degenerate_face_error` is thrown when the shape of this face is needed. Smaller faces, smoother weights, or a
 * `Mollified_metric` of the weighted metric avoid this.
 *
 * \tparam Metric `Embedded_metric` or `Edge_length_metric`
 *
 * \cgalModels{IntrinsicMetric}
 */
template <class Metric>
class Weighted_metric : private Metric
{
  static_assert(internal::is_metric<Metric>,
                "a Weighted_metric takes a mesh, another metric and a property map of weights");
  using Base = Metric;

  struct Base_place
  {
    typename Base::Place place;
  };

public:
  using Mesh = typename Base::Mesh;       ///< the mesh, numbered
  using Kernel = typename Base::Kernel;   ///< the kernel of the given metric
  using Point_3 = typename Base::Point_3; ///< the point type of the given metric, `void` if it has none

  /*!
   * Constructs the metric and reads all weights.
   *
   * \param mesh the triangle mesh of the metric
   * \param metric the given metric
   * \param weights a model of `ReadablePropertyMap` with the vertices, the faces or the edges of the mesh as keys, and
   *        positive numbers as values
   * \throws Invalid_parameter_error if a weight is not positive and finite
   *
   * Complexity: linear in the size of the mesh for a `Surface_mesh`, and \cgalBigO{n \log n} for other meshes, where
   * \f$n\f$ is the size of the mesh.
   */
  template <class TriangleMesh, class WeightMap>
  Weighted_metric(const TriangleMesh& mesh, const Metric& metric, const WeightMap& weights)
    : Base(metric)
    , m_factors(std::make_shared<std::vector<double>>(edge_weights(mesh, weights)))
  {
    if constexpr(!std::is_empty<Place>::value) {
      const double least = internal::least_stretch_of_faces(static_cast<const Base&>(*this), *this, Mesh(mesh));
      m_least_stretch = std::isfinite(least) ? least : 0;
    }
  }

  /// Returns the factor by which the length of halfedge `h` is multiplied.
  double factor(Input_halfedge_index h) const { return (*m_factors)[static_cast<std::size_t>(h.idx() / 2)]; }

  /// Returns the length of halfedge `h`, rounded to double.
  /// \throws Degenerate_face_error if the length is zero
  /// \throws Invalid_coordinate_error if the length is neither zero nor a number between 1e-70 and 1e70
  double length(const Mesh& mesh, Input_halfedge_index h) const { return internal::length_by_weight(*this, mesh, h); }

  /// Returns the length of halfedge `h` without checking it, for use in searches.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return Base::weight(mesh, h) * factor(h); }

  /// The data of a vertex from which lower bounds are computed. These are the data of the given metric.
  using Place = std::conditional_t<std::is_empty<typename Base::Place>::value, typename Base::Place, Base_place>;

  /// Returns the length of halfedge `h`; the places of its ends are ignored.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place&, const Place&) const { return weight(mesh, h); }

  /// Returns the data of the given metric for vertex `v`.
  Place place(const Mesh& mesh, Vertex_index v) const { return {Base::place(mesh, v)}; }

  /// Returns the lower bound that the given metric returns, multiplied by the smallest factor by which the length of a
  /// line segment inside a face changes. This factor can be smaller than the smallest weight.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    if constexpr(std::is_empty<Place>::value)
      return 0;
    else
      return (1 - internal::distance_bound_rounding) * m_least_stretch * Base::distance_lower_bound(p.place, q.place);
  }

  /// Returns the point of vertex `v`. Available only if the given metric has points.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return Base::point(mesh, v); }

  /// Returns whether the given metric rounds numbers of the mesh. If it does, nothing is certified.
  using Base::is_rounded;

  /// Checks that the weights and the given metric were made for meshes with the same number of edges as `mesh`.
  /// \throws Input_mismatch_error if the numbers differ
  void check_input(const Mesh& mesh) const
  {
    internal::check_halfedges(2 * m_factors->size(), static_cast<std::size_t>(mesh.number_of_halfedges()));
    internal::check_input(static_cast<const Base&>(*this), mesh);
  }

  /// Returns the geometry of the face on the left of `h`, with `h` as the first halfedge. The geometry is constructed
  /// from the lengths of the edges of the face. Throws the exceptions that `length()` throws.
  /// \throws Degenerate_face_error if the lengths violate the triangle inequality
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_geometry_by_lengths(*this, mesh, h, traits);
  }

private:
  static double checked(double weight, Index element, const char* name)
  {
    if(!(weight > 0 && weight <= (std::numeric_limits<double>::max)()))
      throw Invalid_parameter_error("the weight of " + std::string(name) + " " + std::to_string(element) +
                                        " is not positive and finite",
                                    {static_cast<std::size_t>(element)});
    return weight;
  }

  template <class TriangleMesh, class WeightMap>
  static std::vector<double> edge_weights(const TriangleMesh& mesh, const WeightMap& weights)
  {
    static_assert(internal::is_number_map<WeightMap>());
    using Key = typename internal::Map_traits<WeightMap>::key_type;
    constexpr bool are_of_edges = std::is_same<Key, typename boost::graph_traits<TriangleMesh>::edge_descriptor>::value;
    const Mesh numbered(mesh);
    std::vector<double> result, of_vertices;
    if constexpr(!are_of_edges)
      of_vertices = vertex_weights(mesh, numbered, weights);
    const auto at = [&](Input_halfedge_index h) {
      return of_vertices[static_cast<std::size_t>(numbered.tail(h).idx())];
    };
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(numbered.number_of_halfedges())) {
      if(!internal::is_first_side(h))
        continue;
      if constexpr(are_of_edges)
        result.push_back(checked(CGAL::to_double(get(weights, edge(numbered.halfedge(h), mesh))), h.idx() / 2, "edge"));
      else
        result.push_back(0.5 * (at(h) + at(internal::twin_index(h))));
    }
    return result;
  }

  template <class TriangleMesh, class WeightMap>
  static std::vector<double> vertex_weights(const TriangleMesh& mesh, const Mesh& numbered, const WeightMap& weights)
  {
    using Key = typename internal::Map_traits<WeightMap>::key_type;
    constexpr bool are_of_faces = std::is_same<Key, typename boost::graph_traits<TriangleMesh>::face_descriptor>::value;
    std::vector<double> result(static_cast<std::size_t>(numbered.number_of_vertices()), 1);
    if constexpr(std::is_same<Key, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>::value) {
      for(Vertex_index v : internal::descriptors<Vertex_index>(numbered.number_of_vertices()))
        result[static_cast<std::size_t>(v.idx())] =
            checked(CGAL::to_double(get(weights, numbered.vertex(v))), v.idx(), "vertex");
    } else if constexpr(internal::Map_traits<WeightMap>::is_map) {
      static_assert(are_of_faces, "the keys of the weights must be the vertices, the faces or the edges of the mesh");
      if constexpr(are_of_faces)
        add_face_weights(mesh, numbered, weights, result);
    }
    return result;
  }

  template <class TriangleMesh, class WeightMap>
  static void add_face_weights(const TriangleMesh& mesh, const Mesh& numbered, const WeightMap& weights,
                               std::vector<double>& result)
  {
    std::vector<double> sum(result.size(), 0);
    std::vector<int> number(result.size(), 0);
    for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(numbered.number_of_halfedges())) {
      if(numbered.is_border(h))
        continue;
      const std::size_t v = static_cast<std::size_t>(numbered.tail(h).idx());
      const auto f = internal::graph_face(numbered.halfedge(h), mesh);
      sum[v] += checked(CGAL::to_double(get(weights, f)), numbered.tail(h).idx(), "a face at vertex");
      ++number[v];
    }
    for(std::size_t v = 0; v < result.size(); ++v)
      if(number[v] > 0)
        result[v] = sum[v] / number[v];
  }

  std::shared_ptr<const std::vector<double>> m_factors; // by edge
  double m_least_stretch = 0;
};

namespace internal {

template <class Base>
struct Internals<Mollified_metric<Base>>
{
  using Metric = Mollified_metric<Base>;
  using Mesh = typename Metric::Mesh;

  static constexpr bool has_exact_faces = true;
  static constexpr bool has_usable_faces = false;

  static Exact_face exact_face(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
  {
    return metric.added_length() == 0 ? internal::exact_face(metric.base(), mesh, h)
                                      : Internals_of_lengths::exact_face(metric, mesh, h);
  }

  template <class... Arguments>
  static bool sine_in_plane(const Metric& metric, Arguments&... arguments)
  {
    return metric.added_length() == 0 && internal::sine_in_plane(metric.base(), arguments...);
  }

  static std::array<double, 3> vector(const Metric& metric, const Mesh& mesh, Vertex_index v, Vertex_index w)
  {
    return Internals<Base>::vector(metric.base(), mesh, v, w);
  }
};

template <class Metric>
struct Internals<Weighted_metric<Metric>> : Internals_of_lengths
{
};

} // namespace internal

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_METRICS_H
