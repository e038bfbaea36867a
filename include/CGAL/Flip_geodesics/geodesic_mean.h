// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_MEAN_H
#define CGAL_FLIP_GEODESICS_GEODESIC_MEAN_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/surface_points.h>
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

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTangents
/// States why the search for a mean ended.
enum class Mean_status {
  CONVERGED, ///< the weighted vectors to the points cancel out, up to the tolerance
  /// no step in the direction of the weighted mean of the vectors to the points decreases the weighted sum of squared
  /// distances. This can happen at a vertex at which shortest paths bend, on the border, or at a point that shortest
  /// paths from one of the given points reach from two sides
  STUCK,
  ITERATION_LIMIT ///< the maximal number of steps has been tried
};

/// \ingroup PkgFlipGeodesicsTangents
/// Returns the name of a status, spelled like the enumerator.
inline const char* to_string(Mean_status status)
{
  return internal::name_of(status, {"CONVERGED", "STUCK", "ITERATION_LIMIT"});
}

/// \ingroup PkgFlipGeodesicsTangents
/// Reports on the search for a mean.
struct Mean_report
{
  Mean_status status = Mean_status::ITERATION_LIMIT; ///< why the search ended
  std::size_t iterations = 0;                        ///< the number of steps tried
  double variance = 0;                               ///< the weighted mean of the squared distances from the points
  /// the length of the weighted mean of the vectors to the points, which is nearly 0 if the search has converged
  double residual = 0;
};

/// \ingroup PkgFlipGeodesicsTangents
/// Limits the search for a mean.
struct Mean_limits
{
  double tolerance = default_tolerance(); ///< the residual at which the search converges, relative to the square root
                                          ///< of the variance
  std::size_t most_iterations = 100;      ///< the maximal number of steps

  /// Returns the default tolerance, 1e-11.
  static constexpr double default_tolerance() { return internal::default_mean_tolerance; }
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Finds Karcher (Riemannian) means \cgalCite{K77}: points at which the weighted sum of squared distances from given
 * points has a local minimum.
 *
 * The logarithmic map provides the vectors from the current point to the given points. Each step follows a straightest
 * geodesic from the current point in the direction of the weighted mean of these vectors, and is at most as long as
 * that mean vector. If a step does not decrease the weighted sum of squared distances, up to rounding errors, a step of
 * half its length is tried. In the plane, one step suffices.
 *
 * Several means can exist; the result then depends on the point at which the search starts. On a mesh of needles, the
 * vectors can be less precise than the tolerance requires. The status can then depend on the numbering of the vertices
 * and faces.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; flips made in it do not affect the result
 */
template <class Triangulation>
class Geodesic_mean
{
public:
  using Triangle_mesh = typename Triangulation::Triangle_mesh; ///< the type of the mesh

  /*!
   * Locates the points; `operator()` computes the mean.
   *
   * \param triangulation a triangulation of the mesh; both must outlive the object
   * \param mesh the mesh
   * \param points a range of points of the surface, of any type that `surface_location()` accepts
   * \param weights a range of numbers, one for each point
   * \throws Invalid_parameter_error if no points are given, the numbers of points and weights differ, a weight is
   *         negative or not finite, or all weights are zero
   * \throws Invalid_location_error if a point does not lie on the surface
   */
  template <class PointRange = std::vector<Surface_location>>
  Geodesic_mean(const Triangulation& triangulation, const Triangle_mesh& mesh, const PointRange& points,
                std::vector<double> weights)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_tracer(triangulation)
    , m_points(internal::located_places(triangulation, points))
    , m_weights(std::move(weights))
  {
    if(m_points.empty())
      throw Invalid_parameter_error("the mean of an empty range is undefined; pass at least one point");
    if(m_points.size() != m_weights.size())
      throw Invalid_parameter_error(std::to_string(m_points.size()) + " points but " +
                                    std::to_string(m_weights.size()) +
                                    " weights were given; pass one weight per point");
    double largest = 0;
    for(std::size_t i = 0; i < m_weights.size(); ++i) {
      if(!(m_weights[i] >= 0 && std::isfinite(m_weights[i])))
        internal::throw_naming<Invalid_parameter_error>("the weight of point ", internal::Element{i},
                                                        " of a mean must be finite and not negative");
      largest = (std::max)(largest, m_weights[i]);
    }
    if(!(largest > 0))
      throw Invalid_parameter_error("the weights of the points of a mean are all zero; at least one must be positive");
    double sum = 0;
    for(double& weight : m_weights)
      sum += weight /= largest;
    for(double& weight : m_weights)
      weight /= sum;
  }

  /// Returns the point with the largest weight, or the first of several such points. `geodesic_mean()` starts the
  /// search at this point.
  const Surface_location& heaviest() const
  {
    const auto i = (std::max_element)(m_weights.begin(), m_weights.end()) - m_weights.begin();
    return m_points[static_cast<std::size_t>(i)];
  }

  /*!
   * Searches for a mean.
   *
   * \param start the point at which the search starts; after the call, the point at which the search ended
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{search_limit}
   *     \cgalParamDescription{the limits at which the search ends}
   *     \cgalParamType{`Mean_limits`}
   *     \cgalParamDefault{`Mean_limits()`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \return a report on the search
   * \throws Disconnected_endpoints_error if no path connects a point with positive weight and the start; `elements()`
   *        returns the index of the point in the range
   * \throws Invalid_location_error if the start is not a point of the surface
   * \throws Invalid_parameter_error if the tolerance is negative or NaN
   * \throws Degenerate_face_error as `Geodesic_distance_field::compute()` does, or if the search reaches a vertex at
   *         which all angles are 0, so that no directions exist
   * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
   * \throws Invalid_mesh_error as `Geodesic_distance_field::compute()` does
   *
   * Complexity: for each step that is tried, the time of computing a `Geodesic_distance_field` from the current point
   * up to the farthest of the given points.
   */
  template <class... NamedParameters>
  Mean_report operator()(Surface_location& start, const NamedParameters&... np) const
  {
    const auto limits = internal::search_limit_of<Mean_limits>(internal::options_of<internal::Limit_parameter>(np...));
    if(!(limits.tolerance >= 0))
      throw Invalid_parameter_error("the tolerance of a mean must not be negative or NaN");
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
      // Along a part of the vector, up to the border; the length is 0 if it leads out of the surface.
      const Trace_report step = m_tracer.trace(here.place, here.direction, part * here.residual, Emptyset_iterator());
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
    const Logarithmic_map<Triangulation> logarithm(m_triangulation, m_mesh, place, parameters::search_limit(limits));
    State result = {place, {}, 0, 0};
    std::array<double, 2> sum = {0, 0};
    for(std::size_t i = 0; i < m_points.size(); ++i) {
      if(m_weights[i] == 0)
        continue;
      const Polar_coordinates p = logarithm(m_points[i]);
      if(!(p.radius < std::numeric_limits<double>::infinity()))
        internal::throw_naming<Disconnected_endpoints_error>("no path connects point ", internal::Element{i},
                                                             " of a mean with the start of the search");
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
    internal::throw_naming<Degenerate_face_error>("all faces of vertex ", v,
                                                  " have an angle of 0 there, so the direction to a mean is undefined");
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
 * Computes the midpoint of a shortest path. If several shortest paths exist, one of them is chosen.
 *
 * \param mesh a triangle mesh
 * \param source, target each a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space
 * \param np the named parameters `vertex_point_map` or `metric`, as for `geodesic_path()`, and `geom_traits`, of which
 *        only the work limit is used
 * \return a `Face_location`: a pair of a face and an array of barycentric coordinates
 * \throws Disconnected_endpoints_error if no path exists
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Degenerate_face_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_mesh_error as `Geodesic_distance_field::compute()` does
 *
 * Complexity: the time of computing a `Geodesic_distance_field` up to the target.
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
  const Logarithmic_map<Surface> logarithm(surface, mesh, source, parameters::search_limit(limits));
  return internal::face_location_of(surface, mesh, logarithm.between(end, 0.5));
}

/// \ingroup PkgFlipGeodesicsTangents
/// Contains the result of `geodesic_mean()`.
template <class TriangleMesh>
struct Geodesic_mean_result
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< the face type of the mesh

  std::pair<face_descriptor, std::array<double, 3>> location; ///< the end of the search, a `Face_location`
  Mean_report report;                                         ///< the report on the search

  Mean_status status() const { return report.status; } ///< returns how the search ended
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes a Karcher (Riemannian) mean \cgalCite{K77} of weighted points: a point at which the weighted sum of squared
 * distances from the given points has a local minimum. The search starts at the point with the largest weight; see
 * `Geodesic_mean`.
 *
 * \param mesh a triangle mesh
 * \param points a range of vertices, `CGAL::Polygon_mesh_processing::Face_location`s or points in space
 * \param weights a range of numbers, one for each point
 * \param np an optional sequence of named parameters among those listed below, `vertex_point_map` or `metric` as for
 *        `geodesic_path()`, and `geom_traits`, of which only the work limit is used
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the maximal number of steps}
 *     \cgalParamType{an integer}
 *     \cgalParamDefault{100}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the point at which the search ended, and a report that states whether this point is a mean
 * \throws Invalid_parameter_error if no points are given, the numbers of points and weights differ, a weight is
 *         negative or not finite, all weights are zero, or the number of iterations is negative
 * \throws Disconnected_endpoints_error as `Geodesic_mean` does
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Degenerate_face_error as `Geodesic_mean` does
 * \throws Invalid_coordinate_error as `Geodesic_mean` does
 * \throws Invalid_mesh_error as `Geodesic_mean` does
 *
 * Complexity: for each step that is tried, the time of computing a `Geodesic_distance_field` from the current point up
 * to the farthest of the given points.
 */
template <class TriangleMesh, class PlaceRange, class WeightRange, class... NamedParameters,
          std::enable_if_t<!internal::is_named_parameters<WeightRange>, int> = 0>
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
  const Mean_report report = mean(place, parameters::search_limit(limits));
  return {internal::face_location_of(surface, mesh, place), report};
}

/// \ingroup PkgFlipGeodesicsTangents
/// Computes a Karcher (Riemannian) mean \cgalCite{K77} of points with equal weights: a point at which the sum of
/// squared distances from the given points has a local minimum. The parameters and exceptions are those of
/// `geodesic_mean()` with weights.
template <class TriangleMesh, class PlaceRange, class... NamedParameters,
          std::enable_if_t<(internal::is_named_parameters<NamedParameters> && ...), int> = 0>
Geodesic_mean_result<TriangleMesh> geodesic_mean(const TriangleMesh& mesh, const PlaceRange& points,
                                                 const NamedParameters&... np)
{
  const std::vector<double> weights(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))), 1);
  return Flip_geodesics::geodesic_mean(mesh, points, weights, np...);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_GEODESIC_MEAN_H
