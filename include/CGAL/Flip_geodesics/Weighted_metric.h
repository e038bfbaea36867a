// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_WEIGHTED_METRIC_H
#define CGAL_FLIP_GEODESICS_WEIGHTED_METRIC_H

#include <CGAL/Flip_geodesics/Mollified_metric.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/surface/least_stretch.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * Another metric with every edge longer or shorter by a weight of the places that it passes: paths keep away from where
 * the weight is large.
 *
 * Weights are given at vertices, and are linear along edges. The length of an edge is its weighted length: the other
 * metric's, times the mean of the weights of its two ends. Faces are flat again, with these lengths: where the weight
 * changes little over a face, that is the conformal change of the metric by the weight, up to terms of second order.
 *
 * A weight that is constant on each face, and jumps between them, is no metric of edge lengths: shortest paths are
 * refracted where it jumps, as light is. Weights given for faces are made ones of vertices, each the mean of the faces
 * about it.
 *
 * Where weights change by so much over one face that its lengths violate the triangle inequality, the face has no shape.
 * Whatever needs it throws `Degenerate_face_error`; smaller faces or smoother weights help, or a `Mollified_metric` of
 * lengths.
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
  using Mesh = typename Base::Mesh;                            ///< the mesh, numbered
  using Kernel = typename Base::Kernel;                        ///< that of the other metric
  using Point_3 = typename internal::Metric_point<Base>::type; ///< that of the other metric, `void` if it has no points

  /*!
   * Reads all weights. Linear in the mesh, if that is a `Surface_mesh`.
   *
   * \param mesh the triangle mesh of the metric
   * \param metric the other metric
   * \param weights a model of `ReadablePropertyMap` with the mesh's vertices, or else its faces, as keys, and positive
   *        numbers as values
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

  /// The weight at vertex `v`.
  double vertex_weight(Vertex_index v) const { return (*m_weights)[static_cast<std::size_t>(v.idx())]; }

  /// The weighted length of halfedge `h`. \throws Invalid_coordinate_error, Degenerate_face_error
  double length(const Mesh& mesh, Input_halfedge_index h) const { return internal::usable_length(*this, mesh, h); }

  /// The length of halfedge `h` whatever it is, for a search that only passes by.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return Base::weight(mesh, h) * factor(mesh, h); }

  /// What a lower bound needs of a vertex: what the other metric's does. It is no point that faces are laid out from.
  using Place = std::conditional_t<std::is_empty<typename Base::Place>::value, typename Base::Place, Base_place>;

  /// The same, where the places of the two ends are at hand.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place&, const Place&) const { return weight(mesh, h); }

  /// What the other metric says of vertex `v`.
  Place place(const Mesh& mesh, Vertex_index v) const { return {Base::place(mesh, v)}; }

  /// The other metric's lower bound, times the factor by which faces stretch segments at least. It can be less than the
  /// least weight: a face whose height is stretched less than its sides is laid flat again.
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    if constexpr(std::is_empty<Place>::value)
      return 0;
    else
      return (1 - internal::distance_bound_rounding) * m_least_stretch * Base::distance_lower_bound(p.place, q.place);
  }

  /// The point of vertex `v`. Only over `Embedded_metric`.
  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return Base::point(mesh, v); }

  /// The vectors of the halfedges `h`, `next(h)`, `previous(h)` of an input face.
  /// \throws Degenerate_face_error if the lengths violate the triangle inequality; equality is allowed
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return internal::face_from_lengths(*this, mesh, h, traits);
  }

  /// The same face in exact numbers; the lengths are taken as the doubles they are.
  internal::Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return internal::exact_face_from_lengths(internal::face_lengths(*this, mesh, h));
  }

  /// False: lengths do not say what lies in one plane.
  bool sine_in_plane(const Mesh&, const Crossing_word&, const Crossing_word&, Index, internal::Flat_edges&, Sign&) const
  {
    return false;
  }

  /// Returns whether the other metric rounds numbers of the mesh to doubles. Then nothing is certified.
  bool is_rounded(const Mesh& mesh) const { return Base::is_rounded(mesh); }

private:
  // The same from both ends, since sums do not depend on the order.
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_WEIGHTED_METRIC_H
