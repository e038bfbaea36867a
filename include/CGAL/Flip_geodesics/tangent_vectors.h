// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TANGENT_VECTORS_H
#define CGAL_FLIP_GEODESICS_TANGENT_VECTORS_H

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Source_directions.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/tangents/Place_frame.h>
#include <CGAL/Flip_geodesics/internal/tangents/Transport_sleeve.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/surface_points.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes the logarithmic map of a surface point, that is, the length and initial direction of a shortest path from
 * this point to any other point.
 *
 * The map is the inverse of the exponential map, which `Geodesic_tracer` evaluates:
 *
 * \code
 * const Logarithmic_map<Triangulation> logarithm(triangulation, mesh, source);
 * const Polar_coordinates p = logarithm(target);
 * Geodesic_tracer<Triangulation>(triangulation).trace(source, Surface_direction{logarithm.halfedge(), p.angle},
 *                                             p.radius, CGAL::Emptyset_iterator()); \endcode
 *
 * The geodesic traced by this code ends at the target up to rounding errors, unless the shortest path bends at a
 * vertex: a straightest geodesic never bends.
 *
 * A `Geodesic_distance_field` finds the edges that the shortest path crosses. The faces between these edges are
 * unfolded into a plane, and the unfolded target gives the result. The error of the result is therefore a few rounding
 * errors per edge, and does not include the error of the distances.
 *
 * The map is discontinuous across the cut locus, the set of points that several shortest paths reach. At such a point,
 * rounding errors determine which of these paths is chosen.
 *
 * A map must not be used by two threads at once, not even through its `const` members. The `const` members of its
 * triangulation and of its `distance_field()` are thread-safe.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; flips made in it do not affect the result
 */
template <class Triangulation>
class Logarithmic_map
{
  using Transport_sleeve = internal::Transport_sleeve<Triangulation>;

public:
  using Triangle_mesh = typename Triangulation::Triangle_mesh; ///< the type of the mesh

  /*!
   * Computes the distances from the source.
   *
   * \param triangulation a triangulation of the mesh; both must outlive the map
   * \param mesh the mesh
   * \param source a point of any type that `surface_location()` accepts
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{search_limit}
   *     \cgalParamDescription{the limits up to which the map is computed}
   *     \cgalParamType{`Distance_field_limits`}
   *     \cgalParamDefault{no limits}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{visitor}
   *     \cgalParamDescription{a visitor, as for `Geodesic_distance_field::compute()`. If the visitor stops the
   *       computation, `report()` has the status `Distance_field_status::STOPPED_BY_VISITOR`, and the map is known up
   *       to `distance_field().reach()`}
   *     \cgalParamType{a model of `FlipOutVisitor`, of which only `go_further()` is called}
   *     \cgalParamDefault{no visitor}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Vertex_out_of_range_error if `source` is a vertex that does not belong to the mesh or is isolated
   * \throws Invalid_location_error if `source` is not a point of the surface
   * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
   * \throws Degenerate_face_error as `Geodesic_distance_field::compute()` does
   * \throws Invalid_mesh_error as `Geodesic_distance_field::compute()` does
   * \throws Invalid_parameter_error as `Geodesic_distance_field::compute()` does
   *
   * Complexity: that of `Geodesic_distance_field::compute()`.
   */
  template <class Source = Surface_location, class... NamedParameters>
  Logarithmic_map(const Triangulation& triangulation, const Triangle_mesh& mesh, const Source& source,
                  const NamedParameters&... np)
    : Logarithmic_map(internal::trace_start(triangulation, mesh, source), triangulation, mesh)
  {
    m_report = m_field.compute(np...);
  }

  /// Returns the halfedge from which angles are measured, by the rule of `Surface_direction`.
  Input_halfedge_index halfedge() const { return m_halfedge; }

  /// Returns the sum of the angles around the source: \f$\pi\f$ on a border edge, and \f$2\pi\f$ elsewhere except at
  /// vertices.
  double total_angle() const { return m_frame.total(); }

  /// Returns whether the source is on the border. If it is, angles are not reduced to
  /// \f$[0, \mathtt{total\_angle()})\f$.
  bool is_on_border() const { return m_frame.has_border(); }

  /// Returns the distances from the source.
  const Geodesic_distance_field<Triangulation>& distance_field() const { return m_field; }

  /// Returns the report on the computation of the distances.
  const Distance_field_report& report() const { return m_report; }

  /*!
   * Returns the length of a shortest path to a point, and the angle of its direction at the source, counterclockwise
   * from `halfedge()`. The radius is infinite if no path exists within the limits. At the source itself, the radius is
   * 0 and the angle is NaN.
   *
   * If the path bends at vertices, the angle is that of the path to the first of these vertices. All points whose paths
   * first bend at the same vertex therefore have the same angle.
   *
   * \param point a vertex of the input, as a `Vertex_index`, or a point of any type that `surface_location()` accepts
   * \throws Vertex_out_of_range_error if `point` is a vertex that does not belong to the mesh, or an isolated vertex
   *         that is not given as a `Vertex_index`
   * \throws Invalid_location_error if `point` is not a point of the surface
   *
   * Complexity: linear in the number of edges that the path crosses and in the number of windows on the sides of the
   * faces through which the path leads.
   */
  template <class Point = Surface_location>
  Polar_coordinates operator()(const Point& point) const
  {
    if constexpr(std::is_convertible<const Point&, Vertex_index>::value) {
      const Vertex_index v = point;
      internal::check_vertex(v, m_triangulation.input().number_of_vertices());
      if(m_triangulation.input().outgoing(v) == null_index)
        return {};
      return (*this)(internal::canonical_location(m_triangulation.input(), m_triangulation.location(v)));
    } else {
      const auto& mesh = m_triangulation.input().uncontracted().mesh();
      const std::optional<Transport_sleeve> path = path_to(internal::trace_start(m_triangulation, mesh, point));
      if(!path)
        return {};
      if(path->legs().empty())
        return {0, std::numeric_limits<double>::quiet_NaN()};
      const double position = m_frame.position(path->legs().front().face, path->start(0).unit());
      return {path_length(*path), m_frame.angle(position, m_halfedge)};
    }
  }

  /// Converts polar coordinates to Cartesian coordinates in a plane in which `halfedge()` points in the direction of
  /// the positive first axis. The angles around an interior source are scaled to a sum of \f$2\pi\f$. The result is the
  /// origin for the source, and NaN if no path exists.
  std::array<double, 2> in_plane(const Polar_coordinates& p) const
  {
    if(p.radius == 0)
      return {0, 0};
    const double angle = m_frame.stretch() * p.angle;
    return {p.radius * std::cos(angle), p.radius * std::sin(angle)};
  }

  /// Converts Cartesian coordinates in the plane of `in_plane()` to polar coordinates. Unless the source is a border
  /// vertex whose angles sum to more than \f$2\pi\f$, this function is the inverse of `in_plane()`. At such a vertex,
  /// several angles can correspond to the same vector. The function then returns the angle that is nearest to the
  /// middle of the angular range of the surface.
  Polar_coordinates from_plane(const std::array<double, 2>& vector) const
  {
    const double angle = std::atan2(vector[1], vector[0]) / m_frame.stretch();
    return {std::hypot(vector[0], vector[1]), m_frame.same_direction(angle, m_halfedge)};
  }

  /*!
   * Returns the point at a given fraction of the length of a shortest path from the source to a location. For example,
   * the fraction 1/2 gives the midpoint of the path.
   *
   * \param location the end of the path
   * \param part the fraction, from 0 at the source to 1 at the location
   * \throws Invalid_location_error if `location` is not a point of the surface
   * \throws Invalid_parameter_error if the fraction is not between 0 and 1
   * \throws Disconnected_endpoints_error if no path exists within the limits
   */
  Surface_location between(const Surface_location& location, double part) const
  {
    if(!(part >= 0 && part <= 1))
      throw Invalid_parameter_error("the fraction of a path must be between 0 and 1");
    const std::optional<Transport_sleeve> path = path_to(location);
    if(!path)
      internal::throw_disconnected_points(m_triangulation.input().tail(m_place.halfedge),
                                          m_triangulation.input().tail(location.halfedge));
    double length = part * path_length(*path);
    for(std::size_t i = 0; i < path->legs().size(); ++i) {
      const auto start = path->start(i);
      if(length <= std::abs(start.vector))
        return traced(*path, i, start.position, length);
      length -= std::abs(start.vector);
    }
    return path->places().back();
  }

  /*!
   * Transports a direction at the source along a shortest path to a location, as `Parallel_transport` does.
   *
   * \param location the end of the path
   * \param angle the angle of the direction in radians, counterclockwise from `halfedge()`
   * \return the direction, measured by the rule of `Surface_direction`; the angle is NaN if no path exists
   * \throws Invalid_location_error if `location` is not a point of the surface
   * \throws Invalid_parameter_error if the angle is not finite
   */
  Surface_direction transported(const Surface_location& location, double angle) const
  {
    if(!std::isfinite(angle))
      throw Invalid_parameter_error("the angle of a direction is not a finite number");
    const internal::Place_frame<Triangulation> frame(m_triangulation,
                                                     internal::canonical_location(m_triangulation.input(), location));
    const Input_halfedge_index h = frame.reference(location);
    const std::optional<Transport_sleeve> path = path_to(location);
    if(!path)
      return {h, std::numeric_limits<double>::quiet_NaN()};
    return {h, frame.angle(path->transported(m_frame.position(m_halfedge) + angle), h)};
  }

private:
  Logarithmic_map(const Surface_location& source, const Triangulation& triangulation, const Triangle_mesh& mesh)
    : m_triangulation(triangulation)
    , m_place(internal::canonical_location(triangulation.input(), source))
    , m_frame(triangulation, m_place)
    , m_halfedge(m_frame.reference(source))
    , m_field(triangulation, mesh)
  {
    m_field.add_source(source);
  }

  static double path_length(const Transport_sleeve& path)
  {
    double length = 0;
    for(std::size_t i = path.legs().size(); i-- > 0;)
      length += std::abs(path.start(i).vector);
    return length;
  }

  // Traces on from the start of a leg along it.
  Surface_location traced(const Transport_sleeve& path, std::size_t leg, double position, double length) const
  {
    const Surface_location& place = path.places()[leg];
    const Input_halfedge_index face = path.legs()[leg].face;
    const auto frame = path.frame(leg, face);
    const Input_halfedge_index from = frame.has(place.halfedge) ? place.halfedge : face;
    return Geodesic_tracer<Triangulation>(m_triangulation)
        .trace(place, Surface_direction{from, frame.angle(position, from)}, length, Emptyset_iterator(),
               parameters::number_of_iterations((std::numeric_limits<std::size_t>::max)()))
        .location;
  }

  // Returns the shortest path as a sleeve, with the exact shortest path in it.
  std::optional<Transport_sleeve> path_to(const Surface_location& location) const
  {
    std::vector<Surface_location> locations;
    for(const Surface_point& p : m_field.surface_points(location))
      locations.push_back(internal::surface_location(m_triangulation, p));
    if(locations.empty())
      return std::nullopt;
    locations.front() = location; // unrounded
    locations.back() = m_place;
    Transport_sleeve path(m_triangulation, locations);
    path.reverse();
    path.straighten();
    return path;
  }

  const Triangulation& m_triangulation;
  Surface_location m_place;
  internal::Place_frame<Triangulation> m_frame;
  Input_halfedge_index m_halfedge;
  Geodesic_distance_field<Triangulation> m_field;
  Distance_field_report m_report;
};

/// \ingroup PkgFlipGeodesicsTangents
/// Contains the result of `logarithmic_map()`.
template <class OutputIterator, class TriangleMesh>
struct Logarithmic_map_result
{
  /// The halfedge type of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// Constructs a result from the end of the output, the report on the distances, and the values that the member
  /// functions return.
  Logarithmic_map_result(OutputIterator out, const Distance_field_report& report, halfedge_descriptor halfedge,
                         double total_angle, bool is_on_border)
    : out(out)
    , report(report)
    , m_halfedge(halfedge)
    , m_total_angle(total_angle)
    , m_is_on_border(is_on_border)
  {
  }

  OutputIterator out;           ///< the past-the-end iterator of the output
  Distance_field_report report; ///< the report on the distances

  /// Returns the halfedge from which the angles are measured counterclockwise.
  halfedge_descriptor halfedge() const { return m_halfedge; }
  /// Returns the sum of the angles around the source: \f$2\pi\f$ except at vertices and on the border.
  double total_angle() const { return m_total_angle; }
  /// Returns whether the source is on the border. Angles at a border vertex can be negative.
  bool is_on_border() const { return m_is_on_border; }
  Distance_field_status status() const { return report.status; } ///< returns how the computation of the distances ended
  Verdict verdict() const { return report.verdict; }             ///< returns the verdict on the distances

private:
  halfedge_descriptor m_halfedge;
  double m_total_angle;
  bool m_is_on_border;
};

namespace internal {

/*
 * Evaluates a `Logarithmic_map` for many targets. For a vertex, the known distance is used, and the initial direction
 * is found without following the path.
 */
template <class Triangulation>
class Logarithm_of_targets
{
public:
  Logarithm_of_targets(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                       const Logarithmic_map<Triangulation>& logarithm, const Surface_location& source)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_logarithm(logarithm)
    , m_frame(triangulation, canonical_location(triangulation.input(), source))
    , m_starts(query_of(logarithm.distance_field()))
  {
  }

  template <class Target>
  Polar_coordinates operator()(const Target& target)
  {
    if constexpr(is_mesh_vertex<typename Triangulation::Triangle_mesh, Target>)
      return at_vertex(m_triangulation.index(target));
    else
      return m_logarithm(trace_start(m_triangulation, m_mesh, target));
  }

private:
  // The vertex may be isolated.
  Polar_coordinates at_vertex(Vertex_index v)
  {
    const double radius = m_logarithm.distance_field().distance(v);
    const bool has_path = radius > 0 && radius < std::numeric_limits<double>::infinity();
    const std::optional<Start_direction> start = has_path ? m_starts(v) : std::nullopt;
    if(!start)
      return m_logarithm(v);
    return {radius, m_frame.angle(m_frame.position(start->first, start->direction), m_logarithm.halfedge())};
  }

  const Triangulation& m_triangulation;
  const typename Triangulation::Triangle_mesh& m_mesh;
  const Logarithmic_map<Triangulation>& m_logarithm;
  Place_frame<Triangulation> m_frame;
  Source_directions<Triangulation> m_starts;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes the logarithmic map of a surface point, that is, the length and initial direction of a shortest path from it
 * to each target.
 *
 * Let `p` be the coordinates of a target. The call
 * `trace_geodesic(mesh, source, std::pair(result.halfedge(), p.angle), p.radius, out)` traces a geodesic that ends at
 * this target up to rounding errors, unless the shortest path to the target bends at a vertex.
 *
 * \param mesh a triangle mesh
 * \param source a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space, as for
 *        `trace_geodesic()`
 * \param targets a range of points of these types, for example `vertices(mesh)` for all vertices
 * \param out an output iterator that receives `Polar_coordinates`, one for each target
 * \param np the named parameters `vertex_point_map` or `metric`, as for `geodesic_path()`, and `geom_traits`, of which
 *        only the work limit is used
 * \return a `Logarithmic_map_result`. The angles are measured from a halfedge by the rule of `Surface_direction`
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Degenerate_face_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_mesh_error as `Geodesic_distance_field::compute()` does
 *
 * Complexity: that of `Geodesic_distance_field::compute()`, plus that of `Logarithmic_map::operator()()` for each
 * target that is not given as a vertex. All targets given as vertices together take time linear in their number and in
 * the number of windows of the distance field.
 *
 * \sa `Logarithmic_map`
 */
template <class TriangleMesh, class Source, class TargetRange, class OutputIterator, class... NamedParameters,
          std::enable_if_t<!internal::is_named_parameters<OutputIterator>, int> = 0>
Logarithmic_map_result<OutputIterator, TriangleMesh> logarithmic_map(const TriangleMesh& mesh, const Source& source,
                                                                     const TargetRange& targets, OutputIterator out,
                                                                     const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  const Surface surface = internal::make_surface(mesh, options);
  const Surface_location from = internal::trace_start(surface, mesh, source);
  const Logarithmic_map<Surface> logarithm(surface, mesh, from);
  internal::Logarithm_of_targets<Surface> logarithm_of(surface, mesh, logarithm, from);
  std::vector<Polar_coordinates> result;
  for(const auto& target : targets)
    result.push_back(logarithm_of(target));
  return {std::copy(result.begin(), result.end(), out), logarithm.report(),
          surface.input().halfedge(logarithm.halfedge()), logarithm.total_angle(), logarithm.is_on_border()};
}

namespace internal {

/* Transports a vector in space from the plane of the face of the first location to that of the last one. */
template <class Triangulation>
Place_in_space transported_vector(const Triangulation& triangulation, const std::vector<Surface_location>& locations,
                                  const Place_in_space& vector)
{
  const Transport_sleeve<Triangulation> sleeve(triangulation, locations);
  if(!are_finite(vector))
    throw Invalid_parameter_error("a coordinate of a vector is not a finite number");
  const auto start = sleeve.frame(0), end = sleeve.frame(sleeve.legs().size());
  const Input_halfedge_index first = start.reference(locations.front()), last = end.reference(locations.back());
  const std::complex<double> v = Face_plane<Triangulation>(triangulation, first).in_plane(vector);
  const double position = sleeve.transported(start.position(first, v));
  return Face_plane<Triangulation>(triangulation, last).in_space(std::abs(v) * end.direction(position, last));
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes the parallel transport of a tangent vector along a curve, with respect to the Levi-Civita connection.
 *
 * \param mesh a triangle mesh
 * \param curve a range of vertices or of `CGAL::Polygon_mesh_processing::Face_location`s. Consecutive points must lie
 *        in a common face. `geodesic_path()` and `trace_geodesic()` write such ranges, and a `Located_polyline`
 *        contains such a range
 * \param direction the direction at the start of the curve: a halfedge and the angle from this halfedge, as for
 *        `trace_geodesic()`
 * \param np the named parameters `vertex_point_map` or `metric`, as for `geodesic_path()`, and `geom_traits`, of which
 *        only the work limit is used
 * \return the direction at the end of the curve in the same form, measured from the halfedge that is described at
 *         `Surface_direction`
 * \throws Invalid_curve_error if the range is empty, or two consecutive locations do not lie in a common face
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Invalid_parameter_error if the angle is not finite, or the halfedge is not one that `trace_geodesic()`
 *         accepts
 * \throws Degenerate_face_error if a face along the curve has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if a face along the curve has an invalid coordinate
 * \throws Invalid_mesh_error if a face along the curve is invalid
 *
 * Complexity: linear in the number of locations plus the sum of the degrees of the vertices among them. A mesh other
 * than a `Surface_mesh` is indexed first, in \cgalBigO{n \log n} time, where \f$n\f$ is the number of faces.
 *
 * \sa `Parallel_transport`
 */
template <class TriangleMesh, class LocationRange, class... NamedParameters>
std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double> parallel_transport(
    const TriangleMesh& mesh, const LocationRange& curve,
    const std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>& direction,
    const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Direction = std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>;
  const Surface surface = internal::make_surface(mesh, options);
  const std::vector<Surface_location> locations = internal::located_places(surface, curve, false);
  const Surface_direction end =
      Parallel_transport<Surface>(surface)(locations, {surface.input().index(direction.first), direction.second});
  return Direction(surface.input().halfedge(end.halfedge), end.angle);
}

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes the parallel transport of a tangent vector in space along a curve, with respect to the Levi-Civita
 * connection.
 *
 * The vector is projected onto the plane of the face of the first location. The result lies in the plane of the face of
 * the last location, and has the length of the projection.
 *
 * At a vertex, a vector can point out of the corner of the face. Such a vector represents the direction on the surface
 * that makes the same angle with a side of the corner. This direction is unambiguous if the angles at the vertex sum to
 * \f$2\pi\f$.
 *
 * \param mesh a triangle mesh
 * \param curve a range of `Face_location`s. Vertices must also be given as `Face_location`s, since vectors lie in the
 *        planes of faces. Consecutive locations must lie in a common face
 * \param vector a vector in space, of any kernel
 * \param np the named parameters `vertex_point_map` or `metric`, as for `geodesic_path()`, and `geom_traits`, of which
 *        only the work limit is used; the metric must have points
 * \return the vector at the end of the curve, of the kernel of the points of the mesh
 * \throws Invalid_curve_error if the range is empty, or two consecutive locations do not lie in a common face
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Invalid_parameter_error if a coordinate of the vector is not finite
 * \throws Degenerate_face_error if a face along the curve has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if a face along the curve has an invalid coordinate
 * \throws Invalid_mesh_error if a face along the curve is invalid
 *
 * Complexity: linear in the number of locations plus the sum of the degrees of the vertices among them. A mesh other
 * than a `Surface_mesh` is indexed first, in \cgalBigO{n \log n} time, where \f$n\f$ is the number of faces.
 */
template <class TriangleMesh, class LocationRange, class Vector_3, class... NamedParameters,
          std::enable_if_t<internal::is_vector_in_space<Vector_3>, int> = 0>
auto parallel_transport(const TriangleMesh& mesh, const LocationRange& curve, const Vector_3& vector,
                        const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  static_assert(internal::Has_points<typename Surface::Metric>::value,
                "the metric has no points in space: pass the direction as a halfedge and an angle");
  static_assert(!internal::is_mesh_vertex<TriangleMesh, internal::Range_value<LocationRange>>,
                "a vector in space requires a face: pass the curve as Face_locations, or give the direction as a "
                "halfedge and an angle");
  const Surface surface = internal::make_surface(mesh, options);
  const internal::Place_in_space v = internal::transported_vector(
      surface, internal::located_places(surface, curve, false),
      {{CGAL::to_double(vector.x()), CGAL::to_double(vector.y()), CGAL::to_double(vector.z())}});
  return typename Surface::Metric::Kernel::Vector_3(v[0], v[1], v[2]);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_TANGENT_VECTORS_H
