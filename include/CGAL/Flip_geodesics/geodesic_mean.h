// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_MEAN_H
#define CGAL_FLIP_GEODESICS_GEODESIC_MEAN_H

#include <CGAL/Flip_geodesics/Parallel_transport.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTangents
/// Why the search for a mean ended.
enum class Mean_status {
  CONVERGED,      ///< the weighted vectors to the points cancel out there, up to the tolerance
  STUCK,          ///< no step along them makes the sum of squares smaller, as at a vertex at which shortest paths bend,
                  ///< on the border, or where they arrive from two sides
  ITERATION_LIMIT ///< it was given up
};

/// The name of a status, as the enumerator is spelled.
inline const char* to_string(Mean_status status)
{
  switch(status) {
  case Mean_status::CONVERGED:
    return "CONVERGED";
  case Mean_status::STUCK:
    return "STUCK";
  case Mean_status::ITERATION_LIMIT:
    return "ITERATION_LIMIT";
  }
  return "";
}

/// \ingroup PkgFlipGeodesicsTangents
/// What became of the search for a mean.
struct Mean_report
{
  Mean_status status = Mean_status::ITERATION_LIMIT; ///< why it ended
  std::size_t iterations = 0;                        ///< how many steps were tried
  double variance = 0; ///< the weighted mean of the squared distances from the points, which a mean makes smallest
  double residual = 0; ///< the length of the weighted mean of the vectors to the points; 0 at a mean
};

/// \ingroup PkgFlipGeodesicsTangents
/// When the search for a mean ends.
struct Mean_limits
{
  double tolerance = default_tolerance(); ///< the residual, as a part of the root of the variance, that counts as none
  std::size_t most_iterations = 100;      ///< how many steps may be tried

  /// The tolerance unless another is given: 1e-11.
  static constexpr double default_tolerance() { return internal::default_mean_tolerance; }
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Finds Karcher means: places with the least weighted sum of squared distances from points. The logarithmic map gives
 * the vectors from a place to the points. From the place it goes on by their weighted mean, along a straightest
 * geodesic. Where the sum gets larger, it goes on by half of it, and half again. In the plane one step is enough.
 *
 * What it finds is a local minimum. If the points lie close together, as compared with the curvature, there is one only.
 * On a mesh of needles vectors may be less precise than the tolerance. Then the status can differ between two numberings
 * of one mesh: one search ends as `CONVERGED`, the other as `ITERATION_LIMIT`.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; its flips do not matter
 */
template <class Triangulation>
class Geodesic_mean
{
public:
  using Triangle_mesh = typename Triangulation::Triangle_mesh; ///< the mesh

  /*!
   * Constructs the problem, and computes nothing yet.
   *
   * \param triangulation of the mesh; both must outlive the object
   * \param mesh the mesh
   * \param points any locations
   * \param weights one for each point
   * \throws Invalid_parameter_error if there is no point, the numbers of points and weights differ, a weight is negative
   *         or no finite number, or all are zero
   */
  Geodesic_mean(const Triangulation& triangulation, const Triangle_mesh& mesh, std::vector<Surface_location> points,
                std::vector<double> weights)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_tracer(triangulation)
    , m_points(std::move(points))
    , m_weights(std::move(weights))
  {
    if(m_points.empty())
      throw Invalid_parameter_error("there are no points to have a mean");
    if(m_points.size() != m_weights.size())
      throw Invalid_parameter_error("there are " + std::to_string(m_points.size()) + " points of a mean, and " +
                                    std::to_string(m_weights.size()) + " weights");
    double largest = 0;
    for(std::size_t i = 0; i < m_weights.size(); ++i) {
      if(!(m_weights[i] >= 0 && std::isfinite(m_weights[i])))
        throw Invalid_parameter_error(
            "the weight of point " + std::to_string(i) + " of a mean is negative or no finite number", {i});
      largest = (std::max)(largest, m_weights[i]);
    }
    if(!(largest > 0))
      throw Invalid_parameter_error("the weights of the points of a mean are all zero");
    double sum = 0;
    for(double& weight : m_weights)
      sum += weight /= largest;
    for(double& weight : m_weights)
      weight /= sum;
  }

  /// The point with the largest weight, the first of those, from which a mean is sought by default.
  const Surface_location& heaviest() const
  {
    const auto i = (std::max_element)(m_weights.begin(), m_weights.end()) - m_weights.begin();
    return m_points[static_cast<std::size_t>(i)];
  }

  /*!
   * Looks for a mean.
   *
   * \param start where the search begins, and then the place that it has found
   * \param limits when it ends
   * \throws Disconnected_endpoints_error if no path joins a point with weight and the start; `elements()` is the point's
   *         number
   * \throws Invalid_location_error for the start, or a point, that is none
   * \throws Invalid_parameter_error if the tolerance is not a number of at least 0
   * \throws Degenerate_face_error also at a vertex of which all faces have an angle of 0: it has no directions
   * \throws Invalid_coordinate_error, Invalid_mesh_error
   *
   * Complexity: a `Geodesic_distance_field` as far as the farthest point for each step that is tried.
   */
  Mean_report operator()(Surface_location& start, const Mean_limits& limits = Mean_limits()) const
  {
    if(!(limits.tolerance >= 0))
      throw Invalid_parameter_error("the tolerance of a mean is not a number of at least 0");
    Mean_report report;
    State here = look(start);
    double part = 1;
    for(;;) {
      report.variance = here.variance;
      report.residual = here.residual;
      if(report.residual <= limits.tolerance * std::sqrt(here.variance)) {
        report.status = Mean_status::CONVERGED;
        break;
      }
      if(part < internal::least_mean_step) {
        report.status = Mean_status::STUCK;
        break;
      }
      if(report.iterations == limits.most_iterations)
        break;
      ++report.iterations;
      const Trace_report step = step_from(here, part);
      const State next = step.length > 0 ? look(step.location) : here;
      const bool is_better = next.variance < here.variance || next.residual < here.residual;
      if(is_better && next.variance <= here.variance * (1 + internal::variance_rounding)) {
        part = (std::min)(1.0, 2 * part);
        here = next;
      } else
        part = step.length > 0 ? part / 2 : 0;
    }
    start = here.place;
    return report;
  }

private:
  struct State
  {
    Surface_location place;
    Surface_direction direction; // of the mean of the vectors to the points
    double residual = 0;         // the length of that
    double variance = 0;
  };

  State look(const Surface_location& place) const
  {
    Distance_field_limits limits;
    limits.targets = m_points;
    const Logarithmic_map<Triangulation> logarithm(m_triangulation, m_mesh, place, limits);
    State result = {place, {}, 0, 0};
    std::array<double, 2> sum = {0, 0};
    for(std::size_t i = 0; i < m_points.size(); ++i) {
      if(m_weights[i] == 0)
        continue;
      const Polar_coordinates p = logarithm(m_points[i]);
      if(!(p.radius < std::numeric_limits<double>::infinity()))
        throw Disconnected_endpoints_error("no path joins point " + std::to_string(i) + " of a mean and the others",
                                           {i});
      const auto [x, y] = logarithm.in_plane(p);
      sum[0] += m_weights[i] * x;
      sum[1] += m_weights[i] * y;
      result.variance += m_weights[i] * p.radius * p.radius;
    }
    if(!(logarithm.total_angle() > 0 || result.variance == 0))
      throw_no_directions(place);
    const Polar_coordinates mean = logarithm.from_plane(sum);
    result.direction = {logarithm.halfedge(), mean.angle};
    result.residual = mean.radius;
    return result;
  }

  [[noreturn]] void throw_no_directions(const Surface_location& place) const
  {
    const Vertex_index v =
        m_triangulation.input().tail(internal::canonical_location(m_triangulation.input(), place).halfedge);
    throw Degenerate_face_error("all faces of vertex " + std::to_string(v.idx()) +
                                    " have an angle of 0 there, so that the way to a mean has no direction",
                                {static_cast<std::size_t>(v.idx())});
  }

  // Along a part of the vector, up to the border; of length 0 if it leads out of the surface.
  Trace_report step_from(const State& here, double part) const
  {
    const Trace_limits<> limits = {part * here.residual};
    return m_tracer.trace(here.place, here.direction.halfedge, here.direction.angle, limits);
  }

  const Triangulation& m_triangulation;
  const Triangle_mesh& m_mesh;
  Geodesic_tracer<Triangulation> m_tracer;
  std::vector<Surface_location> m_points;
  std::vector<double> m_weights; // their sum is 1
};

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
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  const Surface surface = internal::make_surface(mesh, options);
  const Surface_location end = internal::trace_start(surface, mesh, target);
  Distance_field_limits limits;
  limits.targets.push_back(end);
  const Logarithmic_map<Surface> logarithm(surface, mesh, internal::trace_start(surface, mesh, source), limits);
  return internal::face_location_of(surface, mesh, logarithm.between(end, 0.5));
}

/// \ingroup PkgFlipGeodesicsTangents
/// What `geodesic_mean()` returns.
template <class TriangleMesh>
struct Geodesic_mean_result
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< of the mesh

  std::pair<face_descriptor, std::array<double, 3>> location; ///< the mean, a `Face_location`
  Mean_report report;                                         ///< whether it is one

  Mean_status status() const { return report.status; } ///< how the search for it ended
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
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  const Surface surface = internal::make_surface(mesh, options);
  std::vector<Surface_location> locations;
  for(const auto& place : points)
    locations.push_back(internal::trace_start(surface, mesh, place));
  const Geodesic_mean<Surface> mean(surface, mesh, std::move(locations),
                                    std::vector<double>(std::begin(weights), std::end(weights)));
  Mean_limits limits;
  limits.most_iterations = internal::number_of_iterations(options, limits.most_iterations);
  Surface_location place = mean.heaviest();
  const Mean_report report = mean(place, limits);
  return {internal::face_location_of(surface, mesh, place), report};
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

#endif // CGAL_FLIP_GEODESICS_GEODESIC_MEAN_H
