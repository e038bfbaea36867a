// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVE_SAMPLES_H
#define CGAL_FLIP_GEODESICS_CURVE_SAMPLES_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/tangents/Transport_sleeve.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes the parallel transport of tangent vectors along curves, with respect to the Levi-Civita connection.
 *
 * A vector is constant within a face, and remains constant across an edge if the two faces at the edge are unfolded
 * into a plane. At a vertex on the curve, the vector keeps its angle to the direction in which the curve arrives, even
 * if the curve bends there. For this purpose, the angles around an interior vertex are scaled to a sum of \f$2\pi\f$
 * \cgalCite{PS98}; the angles at a border vertex are not scaled. The tangent of a straightest geodesic therefore
 * remains tangent when it is transported along the geodesic. Along a loop that passes through no vertex and bounds a
 * disk, a vector is rotated by the holonomy of the loop, which is the sum of the angle defects of the vertices in the
 * disk.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; flips do not affect the result
 */
template <class Triangulation>
class Parallel_transport
{
public:
  /// Constructs an object for a triangulation, which must outlive the object.
  explicit Parallel_transport(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*!
   * Transports a direction along a curve that is straight between consecutive locations.
   *
   * \param locations a range of points of the surface, of any type that `surface_location()` accepts. Any two
   *        consecutive points must lie in a common face; equal consecutive points count once
   * \param direction the direction at the first location. Its halfedge must either be a side of a face that contains
   *        the first location, or start at this location
   * \param halfedge the halfedge from which the resulting angle is measured. It must either be a side of a face that
   *        contains the last location, or start at this location. By default, it is the halfedge described at
   *        `Surface_direction`
   * \return the direction at the last location. At an interior vertex, its angle lies between 0 and the sum of the
   *         angles around the vertex. At a border vertex, where a full turn does not exist, the angle is not reduced to
   *         an interval and can have any value. At any other location, the angle lies in \f$[0, 2\pi)\f$
   * \throws Invalid_curve_error if the range is empty, or two consecutive locations do not lie in a common face
   * \throws Invalid_location_error if a location is not a point of the surface
   * \throws Invalid_parameter_error if the angle is not finite, or if one of the two halfedges does not satisfy its
   *         condition
   * \throws Degenerate_face_error if a face along the curve has a degenerate edge or violates the triangle inequality
   * \throws Invalid_coordinate_error if a face along the curve has an invalid coordinate
   * \throws Invalid_mesh_error if a face along the curve is invalid
   *
   * Complexity: linear in the number of locations plus the sum of the degrees of the vertices among them.
   */
  template <class LocationRange>
  Surface_direction operator()(const LocationRange& locations, const Surface_direction& direction,
                               Input_halfedge_index halfedge = null_index) const
  {
    const std::vector<Surface_location> places = internal::located_places(m_triangulation, locations, false);
    const internal::Transport_sleeve<Triangulation> sleeve(m_triangulation, places);
    if(!std::isfinite(direction.angle))
      throw Invalid_parameter_error("the angle of a direction is not a finite number");
    const double position = sleeve.frame(0).position(direction.halfedge) + direction.angle;
    const auto frame = sleeve.frame(sleeve.legs().size());
    const Input_halfedge_index reference = halfedge == null_index ? frame.reference(places.back()) : halfedge;
    return {reference, frame.angle(sleeve.transported(position), reference)};
  }

private:
  const Triangulation& m_triangulation;
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Represents a curve that is straight between consecutive locations. Member functions return the location and the
 * direction of the curve at a given length from the start, measured along the curve. A length that exceeds `length()`
 * only by rounding errors counts as `length()`.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; flips do not affect the result
 */
template <class Triangulation>
class Located_curve
{
public:
  /*!
   * Constructs the curve through the locations.
   *
   * \param triangulation the triangulation, which must outlive the curve
   * \param locations a range of points of the surface, of any type that `surface_location()` accepts. Any two
   *        consecutive points must lie in a common face; equal consecutive points count once
   * \throws Invalid_curve_error if the range is empty, or two consecutive locations do not lie in a common face
   * \throws Invalid_location_error if a location is not a point of the surface
   * \throws Degenerate_face_error if a face along the curve has a degenerate edge or violates the triangle inequality
   * \throws Invalid_coordinate_error if a face along the curve has an invalid coordinate
   * \throws Invalid_mesh_error if a face along the curve is invalid
   *
   * Complexity: linear in the number of locations plus the sum of the degrees of the vertices among them.
   */
  template <class LocationRange>
  Located_curve(const Triangulation& triangulation, const LocationRange& locations)
    : m_triangulation(triangulation)
    , m_sleeve(triangulation, internal::located_places(triangulation, locations, false))
    , m_lengths(1, 0.0)
  {
    for(std::size_t i = 0; i < m_sleeve.legs().size(); ++i) {
      m_starts.push_back(m_sleeve.start(i));
      m_lengths.push_back(m_lengths.back() + std::abs(m_starts.back().vector));
    }
  }

  /// Returns the length of the curve, which is 0 if all its locations coincide.
  double length() const { return m_lengths.back(); }

  /// Returns the locations of the curve. Of several consecutive equal locations, only the first is included.
  const std::vector<Surface_location>& locations() const { return m_sleeve.places(); }

  /*!
   * Returns the index of the piece that contains the point at a given length from the start. Piece `i` leads from
   * `locations()[i]` to `locations()[i + 1]`. For a common point of two pieces, the index of the second piece is
   * returned.
   *
   * \throws Invalid_parameter_error if the length is not between 0 and `length()`
   * \throws Invalid_curve_error if the curve is a point
   */
  std::size_t piece(double length) const
  {
    if(m_starts.empty())
      throw Invalid_curve_error("a curve of length zero has no pieces");
    return place(length).leg;
  }

  /*!
   * Returns the location at a given length from the start. The location refers to the face in which the curve
   * continues. The location of the end refers to the face in which the curve arrives. If the curve is a point, this
   * point is returned for every length.
   *
   * \throws Invalid_parameter_error if the curve is not a point and the length is not between 0 and `length()`
   *
   * Complexity: logarithmic in the number of locations.
   */
  Surface_location location(double length) const
  {
    if(m_starts.empty())
      return m_sleeve.places().front();
    const auto [leg, part] = place(length);
    const Input_halfedge_index h = m_sleeve.legs()[leg].face;
    const auto from = weights(leg, h), to = weights(leg + 1, h);
    Surface_location result = {h, {}};
    for(std::size_t i = 0; i < 3; ++i) {
      const double weight = (1 - part) * from[i] + part * to[i];
      result.weights[i] = weight < internal::least_weight ? 0 : weight;
    }
    return result;
  }

  /*!
   * Returns the direction in which the curve continues at a given length from the start, measured from the halfedge of
   * `location(length)`. At the end of the curve, the result is the direction in which the curve arrives.
   *
   * \throws Invalid_parameter_error if the length is not between 0 and `length()`
   * \throws Invalid_curve_error if the curve is a point
   */
  Surface_direction direction(double length) const
  {
    if(m_starts.empty())
      throw Invalid_curve_error("a curve of length zero has no direction");
    const auto [leg, part] = place(length);
    const Input_halfedge_index h = m_sleeve.legs()[leg].face;
    if(part == 0)
      return {h, m_sleeve.frame(leg, h).angle(m_starts[leg].position, h)};
    if(part < 1)
      return {h, std::arg(m_starts[leg].vector)};
    const auto end = m_sleeve.frame(leg + 1, m_sleeve.legs()[leg].last_face());
    const double on = m_sleeve.start_backward(leg).position + boost::math::constants::pi<double>() / end.stretch();
    return {h, end.angle(on, h)};
  }

private:
  struct Place_on_leg
  {
    std::size_t leg;
    double part; // of the leg
  };

  Place_on_leg place(double length) const
  {
    if(!(length >= 0 && length <= m_lengths.back() * (1 + internal::length_sum_rounding)))
      throw Invalid_parameter_error("a length along a curve is " + internal::written(length) +
                                    ", but must be between 0 and " + internal::written(m_lengths.back()));
    const auto next = std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, length);
    const auto leg = static_cast<std::size_t>(next - m_lengths.begin()) - 1;
    const double whole = m_lengths[leg + 1] - m_lengths[leg];
    return {leg, whole > 0 ? (std::min)((length - m_lengths[leg]) / whole, 1.0) : 0.0};
  }

  std::array<double, 3> weights(std::size_t place, Input_halfedge_index h) const
  {
    auto result = internal::weights_seen_from(m_triangulation.input(), m_sleeve.places()[place], h);
    const double sum = result[0] + result[1] + result[2];
    for(double& weight : result)
      weight /= sum;
    return result;
  }

  const Triangulation& m_triangulation;
  internal::Transport_sleeve<Triangulation> m_sleeve;
  std::vector<typename internal::Transport_sleeve<Triangulation>::Start> m_starts; // of the legs
  std::vector<double> m_lengths;                                                   // up to each location
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Returns the counterclockwise angle from one direction at a location to another direction at this location. If the
 * location is not a vertex, the result is at least 0 and less than \f$2\pi\f$. At an interior vertex, the result is at
 * least 0 and less than the sum of the angles around the vertex. At a border vertex, where a full turn does not exist,
 * the result is the angle of the second direction minus that of the first, both measured from the same halfedge, and
 * can be negative.
 *
 * \throws Invalid_location_error if `location` is not a point of the surface
 * \throws Degenerate_face_error if a face of the location has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if a face of the location has an invalid coordinate
 * \throws Invalid_mesh_error if a face of the location is invalid
 * \throws Invalid_parameter_error if an angle is not finite, or if a halfedge neither bounds a face that contains the
 *         location nor starts at the location
 *
 * Complexity: linear in the degree of the vertex if the location is a vertex, and constant otherwise.
 */
template <class Triangulation>
double angle_between(const Triangulation& triangulation, const Surface_location& location,
                     const Surface_direction& first, const Surface_direction& second)
{
  if(!std::isfinite(first.angle) || !std::isfinite(second.angle))
    throw Invalid_parameter_error("the angle of a direction is not a finite number");
  const internal::Place_frame<Triangulation> frame(triangulation,
                                                   internal::canonical_location(triangulation.input(), location));
  return frame.angle(frame.position(second.halfedge) + second.angle - first.angle, first.halfedge);
}

/// \ingroup PkgFlipGeodesicsTangents
/// Stores a point on a curve, with the tangent of the curve and the normal of the surface at this point.
template <class TriangleMesh, class Point>
struct Curve_sample : Curve_point<TriangleMesh, Point>
{
  using Vector_3 = typename Curve_point<TriangleMesh, Point>::Vector_3; ///< the vector type of the kernel of `Point`

  Vector_3 normal;   ///< the unit normal of the face of `location`; zero if the face is degenerate
  double length = 0; ///< the length of the curve up to this sample
};

namespace internal {

template <class Triangulation, class TriangleMesh>
class Curve_sampler
{
  using Point = typename Triangulation::Metric::Point_3;

public:
  using Sample = Curve_sample<TriangleMesh, Point>;

  Curve_sampler(const Triangulation& triangulation, const TriangleMesh& mesh, const Located_curve<Triangulation>& curve)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_curve(curve)
  {
  }

  Sample operator()(double length) const
  {
    const Surface_location at = m_curve.location(length);
    const Surface_point p = surface_point(m_triangulation, at);
    Sample result;
    result.location = face_location_of(m_triangulation, m_mesh, at);
    if(kind(at) == Location_kind::EDGE)
      result.halfedge = m_triangulation.input().halfedge(p.halfedge);
    result.point = point_in_space(m_triangulation, p);
    result.tangent = typename Sample::Vector_3(0, 0, 0);
    if(m_curve.length() > 0) {
      const std::size_t piece = m_curve.piece(length);
      set_tangent(result, place(piece), place(piece + 1));
    }
    const Place_in_space n = Face_plane<Triangulation>(m_triangulation, at.halfedge).normal();
    result.normal = typename Sample::Vector_3(n[0], n[1], n[2]);
    result.length = length;
    return result;
  }

private:
  Point place(std::size_t i) const
  {
    return point_in_space(m_triangulation, surface_point(m_triangulation, m_curve.locations()[i]));
  }

  const Triangulation& m_triangulation;
  const TriangleMesh& m_mesh;
  const Located_curve<Triangulation>& m_curve;
};

/* Returns whether two canonical locations are the same point, up to rounding errors of the weights. */
template <class Input_mesh>
bool is_one_place(const Input_mesh& input, const Surface_location& p, const Surface_location& q)
{
  if(kind(p) != kind(q))
    return false;
  if(kind(p) == Location_kind::VERTEX)
    return input.tail(p.halfedge) == input.tail(q.halfedge);
  const double p_sum = p.weights[0] + p.weights[1] + p.weights[2], q_sum = q.weights[0] + q.weights[1] + q.weights[2];
  for(std::size_t i = 0; i < 3; ++i)
    if(std::abs(p.weights[i] / p_sum - q.weights[i] / q_sum) > same_start)
      return false;
  return p.halfedge == q.halfedge;
}

template <class Triangulation, class TriangleMesh, class PlaceRange>
Located_curve<Triangulation> located_curve(const Triangulation& triangulation, const TriangleMesh&,
                                           const PlaceRange& curve)
{
  return {triangulation, located_places(triangulation, curve, false)};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes samples of a curve at equal distances along the curve, with tangents and normals. The samples include the
 * start and the end.
 *
 * \param mesh a triangle mesh
 * \param curve a range of vertices or of `CGAL::Polygon_mesh_processing::Face_location`s. Any two consecutive elements
 *        must lie in a common face. Such ranges are written, for example, by `geodesic_path()` and `trace_geodesic()`;
 *        the member `locations` of an `Isoline` is also such a range
 * \param number the number of samples, at least 2; on a closed curve, the first and the last sample lie at the same
 *        point
 * \param out an output iterator that receives `Curve_sample`s
 * \param np the named parameters `vertex_point_map` or `metric` as for `geodesic_path()`, where the metric must have
 *        points, and `geom_traits`, of which only the work limit is used
 * \return the past-the-end output iterator
 * \throws Invalid_parameter_error if `number` is less than 2
 * \throws Invalid_curve_error if the range is empty, or two consecutive locations do not lie in a common face
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Degenerate_face_error if a face along the curve has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if a face along the curve has an invalid coordinate
 * \throws Invalid_mesh_error if a face along the curve is invalid
 *
 * Complexity: that of the construction of a `Located_curve`, plus time logarithmic in the number of locations for each
 * sample. A mesh other than a `Surface_mesh` is indexed first, in \cgalBigO{n \log n} time for \f$n\f$ faces.
 */
template <class TriangleMesh, class LocationRange, class OutputIterator, class... NamedParameters>
OutputIterator sample_curve(const TriangleMesh& mesh, const LocationRange& curve, std::size_t number,
                            OutputIterator out, const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  static_assert(internal::Has_points<typename Surface::Metric>::value,
                "the metric has no points in space: use Located_curve to obtain the locations");
  if(number < 2)
    throw Invalid_parameter_error("fewer than two samples are requested, but the start and the end are always samples");
  const Surface surface = internal::make_surface(mesh, options);
  const Located_curve<Surface> located = internal::located_curve(surface, mesh, curve);
  const internal::Curve_sampler<Surface, TriangleMesh> sample(surface, mesh, located);
  std::vector<decltype(sample(0.0))> result;
  for(std::size_t i = 0; i < number; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(number - 1);
    result.push_back(sample(part * located.length()));
  }
  return std::move(result.begin(), result.end(), out);
}

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Computes the angle between two curves that start at the same point, counterclockwise from the first one to the
 * second.
 *
 * If the start is not a vertex, the angle is at least 0 and less than \f$2\pi\f$. At an interior vertex, it is at least
 * 0 and less than the sum of the angles around the vertex. At a border vertex, where a full turn does not exist, the
 * angle is negative if the second curve starts clockwise from the first.
 *
 * \param mesh a triangle mesh
 * \param first, second curves as for `sample_curve()`; for curves that meet elsewhere, pass the parts that start at
 *        their common point
 * \param np the named parameters `vertex_point_map` or `metric` as for `geodesic_path()`, and `geom_traits`, of which
 *        only the work limit is used
 * \return the angle in radians
 * \throws Invalid_curve_error if the curves do not start at the same point, up to differences of 1e-9 in the weights;
 *         if one of the curves is a point; or as `sample_curve()` does
 * \throws Vertex_out_of_range_error as `sample_curve()` does
 * \throws Invalid_location_error as `sample_curve()` does
 * \throws Degenerate_face_error as `sample_curve()` does
 * \throws Invalid_coordinate_error as `sample_curve()` does
 * \throws Invalid_mesh_error as `sample_curve()` does
 *
 * Complexity: that of the construction of a `Located_curve` for each curve. A mesh other than a `Surface_mesh` is
 * indexed first, in \cgalBigO{n \log n} time for \f$n\f$ faces.
 */
template <class TriangleMesh, class LocationRange, class OtherLocationRange, class... NamedParameters>
double angle_between_curves(const TriangleMesh& mesh, const LocationRange& first, const OtherLocationRange& second,
                            const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  const Surface surface = internal::make_surface(mesh, options);
  const Located_curve<Surface> a = internal::located_curve(surface, mesh, first),
                               b = internal::located_curve(surface, mesh, second);
  const Surface_location& p = a.locations().front();
  if(!internal::is_one_place(surface.input(), p, b.locations().front()))
    throw Invalid_curve_error("the angle between two curves that start at different points is undefined");
  return angle_between(surface, p, a.direction(0), b.direction(0));
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CURVE_SAMPLES_H
