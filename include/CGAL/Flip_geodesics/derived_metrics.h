// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DERIVED_METRICS_H
#define CGAL_FLIP_GEODESICS_DERIVED_METRICS_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Plane_triangle.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/edge_lengths.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/surface/metric_faces.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Scales lengths by a power of two, so that the largest is at least 1 and less than 2. \return its exponent */
inline int scale_to_one(std::array<double, 3>& lengths)
{
  const int exponent = std::ilogb((std::max)({lengths[0], lengths[1], lengths[2]}));
  for(double& length : lengths)
    length = std::scalbn(length, -exponent);
  return exponent;
}

/*
 * Returns a lower bound of the factor by which segments in a triangle are longer than in another one whose points
 * correspond linearly. Rounding errors are subtracted. The sides of the other triangle, `before`, may be wrong by some
 * units in the last place, or zero; those of the first, `after`, are taken as given. Zero if one of these is invalid,
 * or they form a degenerate triangle.
 *
 * The stretch of the sides alone is not sufficient: if two of them are stretched less than the third, heights can
 * become shorter by any factor.
 *
 * The linear map back, from `after` to `before`, stretches by at most its larger singular value. The sum of the squares
 * of both singular values follows from the cotangents of `after` [Pinkall, Polthier, Computing discrete minimal
 * surfaces and their conjugates], and their product is that of the areas.
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
  return most > 0 ? (1 - stretch_rounding) * std::scalbn(1 / std::sqrt(most), exponent) : 0; // NaN without an area
}

/*
 * Returns the least stretch of all faces of a mesh between two metrics, or infinity if it has no faces. Linear in the
 * mesh.
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

/* The point type of a metric, `void` if it has no points. */
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

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents another metric with a small length added to every edge [Sharp, Crane, A Laplacian for Nonmanifold Triangle
 * Meshes, section 4.5], chosen such that each face satisfies the triangle inequality with a margin. Meshes with
 * degenerate edges and faces can be used with this metric, at the price of a slightly different surface.
 *
 * Curves are geodesics of the modified surface, but their points are still those of the mesh, if it has any.
 *
 * \tparam Metric `Embedded_metric` or `Edge_length_metric`
 *
 * \cgalModels{IntrinsicMetric}
 */
template <class Metric>
class Mollified_metric : private Metric
{
  using Base = Metric;

public:
  using Mesh = typename Base::Mesh;       ///< the mesh, numbered
  using Kernel = typename Base::Kernel;   ///< that of the other metric
  using Point_3 = typename Base::Point_3; ///< that of the other metric, `void` if it has no points

  /// Adds nothing, so that lengths and faces are those of the other metric.
  explicit Mollified_metric(const Metric& metric)
    : Base(metric)
  {
  }

  /// Computes the length to be added for a factor of 1e-5. Linear in the mesh. The exceptions are those of the other
  /// constructor.
  template <class TriangleMesh>
  Mollified_metric(const TriangleMesh& mesh, const Metric& metric)
    : Mollified_metric(mesh, metric, internal::default_mollification)
  {
  }

  /*!
   * Computes the length to be added. Linear in the mesh.
   *
   * \param mesh the triangle mesh of the metric
   * \param metric the other metric
   * \param factor the margin of the triangle inequality, relative to the mean edge length
   * \pre 0 < factor < 1
   * \throws Invalid_coordinate_error if the length of an edge is negative or not finite
   * \throws Invalid_mesh_error if a face is not a triangle
   */
  template <class TriangleMesh>
  Mollified_metric(const TriangleMesh& mesh, const Metric& metric, double factor)
    : Base(metric)
  {
    CGAL_precondition(0 < factor && factor < 1);
    const Mesh indexed(mesh);
    m_added = needed_length(indexed, factor * mean_length(indexed));
    if constexpr(!std::is_empty<Place>::value)
      m_least_stretch = (std::min)(1., internal::least_stretch_of_faces(base(), *this, indexed));
  }

  /// Returns the length added to every edge, which is zero if none was needed. The metric is then the other one.
  double added_length() const { return m_added; }

  /// Returns the length of halfedge `h`, rounded to double. \throws Invalid_coordinate_error if the length is not
  /// finite or out of range \throws Degenerate_face_error if the length is zero
  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_added == 0 ? Base::length(mesh, h) : internal::length_by_weight(*this, mesh, h);
  }

  /// Returns the length of halfedge `h` without any check, for searches that only pass by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return Base::weight(mesh, h) + m_added; }

  using typename Base::Place;

  /// Returns the length of halfedge `h`, given the positions of its two ends.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return Base::weight(mesh, h, tail, head) + m_added;
  }

  using Base::place;

  /// Returns the lower bound of the other metric, reduced if lengths are rounded in almost degenerate faces. Adding
  /// lengths does not shorten any path: the terms added to the squares of the sides are the squares of the sides of a
  /// triangle.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    return m_least_stretch * Base::distance_lower_bound(p, q);
  }

  /// Returns the point of vertex `v`. Only available over `Embedded_metric`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return Base::point(mesh, v); }

  /// Returns the geometry of an input face by its lengths, from `h` on, with the exceptions of `length()`.
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    if(m_added == 0)
      return internal::face_geometry(base(), mesh, h, traits);
    const auto [a, b, c] = internal::face_lengths(*this, mesh, h);
    return traits.construct_face_from_lengths_object()(a, b, c);
  }

  using Base::is_rounded; ///< returns whether the other metric rounds numbers of the mesh, so that nothing is certified

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

  double m_added = 0;
  double m_least_stretch = 1;
};

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Represents another metric with each edge scaled by a weight, so that paths avoid regions in which the weight is
 * large.
 *
 * Weights are given at vertices, and are linear along edges. The length of an edge is that of the other metric, times
 * the mean of the weights of its two ends. Faces with these lengths are flat again. If the weight changes little over a
 * face, this is the conformal change of the metric by the weight, up to terms of second order.
 *
 * A weight that is constant on each face, and jumps between faces, does not define edge lengths, since shortest paths
 * are refracted at the jumps, as light is. Weights given for faces are therefore converted to weights of vertices, each
 * the mean of those of the incident faces.
 *
 * If weights change so much over one face that its lengths violate the triangle inequality, `Degenerate_face_error` is
 * thrown when the shape of the face is needed. Smaller faces, smoother weights, or a `Mollified_metric` of lengths
 * avoid this.
 *
 * \tparam Metric `Embedded_metric` or `Edge_length_metric`
 *
 * \cgalModels{IntrinsicMetric}
 */
template <class Metric>
class Weighted_metric : private Metric
{
  using Base = Metric;

  struct Base_place
  {
    typename Base::Place place;
  };

public:
  using Mesh = typename Base::Mesh;       ///< the mesh, numbered
  using Kernel = typename Base::Kernel;   ///< that of the other metric
  using Point_3 = typename Base::Point_3; ///< that of the other metric, `void` if it has no points

  /*!
   * Reads all weights. Linear in the mesh if it is a `Surface_mesh`.
   *
   * \param mesh the triangle mesh of the metric
   * \param metric the other metric
   * \param weights a model of `ReadablePropertyMap` with the vertices of the mesh, or else its faces, as keys, and
   *        positive numbers as values
   * \throws Invalid_parameter_error if a weight is not positive and finite
   */
  template <class TriangleMesh, class WeightMap>
  Weighted_metric(const TriangleMesh& mesh, const Metric& metric, const WeightMap& weights)
    : Base(metric)
    , m_weights(std::make_shared<std::vector<double>>(vertex_weights(mesh, weights)))
  {
    if constexpr(!std::is_empty<Place>::value) {
      const double least = internal::least_stretch_of_faces(static_cast<const Base&>(*this), *this, Mesh(mesh));
      m_least_stretch = std::isfinite(least) ? least : 0;
    }
  }

  /// Returns the weight at vertex `v`.
  double vertex_weight(Vertex_index v) const { return (*m_weights)[static_cast<std::size_t>(v.idx())]; }

  /// Returns the length of halfedge `h`, rounded to double. \throws Invalid_coordinate_error if the length is not
  /// finite or out of range \throws Degenerate_face_error if the length is zero
  double length(const Mesh& mesh, Input_halfedge_index h) const { return internal::length_by_weight(*this, mesh, h); }

  /// Returns the length of halfedge `h` without any check, for searches that only pass by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return Base::weight(mesh, h) * factor(mesh, h); }

  /// The data that a lower bound requires of a vertex, which are those of the other metric. They are not a point from
  /// which faces are laid out.
  using Place = std::conditional_t<std::is_empty<typename Base::Place>::value, typename Base::Place, Base_place>;

  /// Returns the length of halfedge `h`, given the positions of its two ends.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place&, const Place&) const { return weight(mesh, h); }

  /// Returns the data of the other metric for vertex `v`.
  Place place(const Mesh& mesh, Vertex_index v) const { return {Base::place(mesh, v)}; }

  /// Returns the lower bound of the other metric, times the least factor by which faces stretch segments. This factor
  /// can be smaller than the smallest weight, because a face whose height is stretched less than its sides becomes flat
  /// again.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    if constexpr(std::is_empty<Place>::value)
      return 0;
    else
      return (1 - internal::distance_bound_rounding) * m_least_stretch * Base::distance_lower_bound(p.place, q.place);
  }

  /// Returns the point of vertex `v`. Only available over `Embedded_metric`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return Base::point(mesh, v); }

  using Base::is_rounded; ///< returns whether the other metric rounds numbers of the mesh, so that nothing is certified

  /// Returns the geometry of an input face by its lengths, from `h` on, with the exceptions of `length()`.
  /// \throws Degenerate_face_error if the lengths violate the triangle inequality
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_geometry_by_lengths(*this, mesh, h, traits);
  }

private:
  // Equal from both ends, since sums do not depend on the order.
  double factor(const Mesh& mesh, Input_halfedge_index h) const
  {
    return 0.5 * (vertex_weight(mesh.tail(h)) + vertex_weight(mesh.tail(internal::twin_index(h))));
  }

  static double checked(double weight, Index element, const char* name)
  {
    if(!(weight > 0 && weight <= (std::numeric_limits<double>::max)()))
      throw Invalid_parameter_error("the weight of " + std::string(name) + " " + std::to_string(element) +
                                        " is no positive number",
                                    {static_cast<std::size_t>(element)});
    return weight;
  }

  template <class TriangleMesh, class WeightMap>
  static std::vector<double> vertex_weights(const TriangleMesh& mesh, const WeightMap& weights)
  {
    using Key = typename boost::property_traits<WeightMap>::key_type;
    const Mesh numbered(mesh);
    std::vector<double> result(static_cast<std::size_t>(numbered.number_of_vertices()), 1);
    if constexpr(std::is_same<Key, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>::value) {
      for(Vertex_index v : internal::descriptors<Vertex_index>(numbered.number_of_vertices()))
        result[static_cast<std::size_t>(v.idx())] =
            checked(CGAL::to_double(get(weights, numbered.vertex(v))), v.idx(), "vertex");
    } else {
      static_assert(std::is_same<Key, typename boost::graph_traits<TriangleMesh>::face_descriptor>::value,
                    "the weights are those of the mesh's vertices, or of its faces");
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

  std::shared_ptr<const std::vector<double>> m_weights; // by vertex
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_DERIVED_METRICS_H
