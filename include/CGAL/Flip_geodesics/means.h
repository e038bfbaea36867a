// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_MEANS_H
#define CGAL_FLIP_GEODESICS_MEANS_H

#include <CGAL/Flip_geodesics/Geodesic_logarithm.h>
#include <CGAL/Flip_geodesics/Geodesic_mean.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * The midpoint of a shortest path.
 *
 * \param mesh a triangle mesh
 * \param source, target each a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space
 * \param np named parameters: `vertex_point_map` or `metric` as for `geodesic_path()`
 * \return a `Face_location`: a pair of a face and an array of barycentric coordinates
 * \throws Disconnected_endpoints_error
 * \throws Vertex_out_of_range_error, Invalid_location_error for places that are not on the mesh
 * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: that of a `Geodesic_distance_field` as far as the target.
 */
template <class TriangleMesh, class Source, class Target, class... NamedParameters>
auto geodesic_midpoint(const TriangleMesh& mesh, const Source& source, const Target& target,
                       const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Triangulation =
      typename internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>::Triangulation;
  const Triangulation triangulation = internal::make_triangulation(mesh, options);
  const Surface_location end = internal::trace_start(triangulation, mesh, target);
  Distance_field_limits limits;
  limits.targets.push_back(end);
  const Geodesic_logarithm<Triangulation> logarithm(triangulation, mesh,
                                                    internal::trace_start(triangulation, mesh, source), limits);
  return internal::face_location_of(triangulation, mesh, logarithm.between(end, 0.5));
}

/// \ingroup PkgFlipGeodesicsTangents
/// What `geodesic_mean()` returns.
template <class TriangleMesh>
struct Geodesic_mean_result
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< of the mesh

  std::pair<face_descriptor, std::array<double, 3>> location; ///< the mean, a `Face_location`
  Mean_report report;                                         ///< whether it is one
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * A Karcher mean of points with weights: a place with the least weighted sum of squared distances from them. See
 * `Geodesic_mean`. The search starts at the point with the largest weight.
 *
 * \param mesh a triangle mesh
 * \param points a range of vertices, `CGAL::Polygon_mesh_processing::Face_location`s or points in space
 * \param weights a range of numbers, one for each point
 * \param np named parameters: `vertex_point_map` or `metric` as for `geodesic_path()`; `number_of_iterations`, how
 *        many steps may be tried, 100 by default
 * \throws Invalid_parameter_error if there is no point, the numbers of points and weights differ, a weight is negative
 *         or no finite number, or all are zero, or the number of iterations is negative
 * \throws Disconnected_endpoints_error, Vertex_out_of_range_error, Invalid_location_error
 * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: a `Geodesic_distance_field` as far as the farthest point for each step that is tried.
 */
template <class TriangleMesh, class PlaceRange, class WeightRange, class... NamedParameters,
          std::enable_if_t<!internal::Is_named_parameters<WeightRange>::value, int> = 0>
Geodesic_mean_result<TriangleMesh> geodesic_mean(const TriangleMesh& mesh, const PlaceRange& points,
                                                 const WeightRange& weights, const NamedParameters&... np)
{
  const auto& options = internal::surface_options<internal_np::number_of_iterations_t>(np...);
  using Triangulation =
      typename internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>::Triangulation;
  const Triangulation triangulation = internal::make_triangulation(mesh, options);
  std::vector<Surface_location> locations;
  for(const auto& place : points)
    locations.push_back(internal::trace_start(triangulation, mesh, place));
  const Geodesic_mean<Triangulation> mean(triangulation, mesh, std::move(locations),
                                          std::vector<double>(std::begin(weights), std::end(weights)));
  Mean_limits limits;
  limits.most_iterations = internal::number_of_iterations(options, limits.most_iterations);
  Surface_location place = mean.heaviest();
  const Mean_report report = mean(place, limits);
  return {internal::face_location_of(triangulation, mesh, place), report};
}

/// \ingroup PkgFlipGeodesicsTangents
/// The same where all weights are equal.
template <class TriangleMesh, class PlaceRange, class... NamedParameters,
          std::enable_if_t<(internal::Is_named_parameters<NamedParameters>::value && ...), int> = 0>
Geodesic_mean_result<TriangleMesh> geodesic_mean(const TriangleMesh& mesh, const PlaceRange& points,
                                                 const NamedParameters&... np)
{
  const std::vector<double> weights(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))), 1);
  return Flip_geodesics::geodesic_mean(mesh, points, weights, np...);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_MEANS_H
