// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LOCATED_CURVE_H
#define CGAL_FLIP_GEODESICS_LOCATED_CURVE_H

#include <CGAL/Flip_geodesics/Parallel_transport.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/tangents/Corridor.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * A curve that runs straight from location to location, by its length: which places it has at which lengths, and in
 * which direction it goes on there.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; its flips do not matter
 */
template <class Triangulation>
class Located_curve
{
public:
  /*!
   * Constructs the curve through the locations.
   *
   * \param triangulation must outlive the curve
   * \param locations a range of `Surface_location`s, of which two in a row lie in one face or on its border; those in
   *        one place count once
   * \throws Invalid_curve_error if there is no location, or no face has two in a row
   * \throws Invalid_location_error, Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
   *
   * Complexity: linear in the number of locations and the degrees of vertices among them.
   */
  template <class LocationRange>
  Located_curve(const Triangulation& triangulation, const LocationRange& locations)
    : m_triangulation(triangulation)
    , m_corridor(triangulation, locations)
    , m_lengths(1, 0.0)
  {
    for(std::size_t i = 0; i < m_corridor.legs().size(); ++i) {
      m_starts.push_back(m_corridor.start(i));
      m_lengths.push_back(m_lengths.back() + std::abs(m_starts.back().vector));
    }
  }

  /// The length of the curve; 0 if all its locations are in one place.
  double length() const { return m_lengths.back(); }

  /// The locations that it runs through, of those in one place in a row the first.
  const std::vector<Surface_location>& locations() const { return m_corridor.places(); }

  /*!
   * The number \f$i\f$ of the piece that has the place at a length from the start: from `locations()[i]` to
   * `locations()[i + 1]`. Of two pieces that meet there the second.
   *
   * \throws Invalid_parameter_error if the length is not between 0 and `length()`
   * \throws Invalid_curve_error if the curve is a point
   */
  std::size_t piece(double length) const
  {
    if(m_starts.empty())
      throw Invalid_curve_error("a curve that is a point has no pieces");
    return place(length).leg;
  }

  /*!
   * The place at a length from the start, in the face that the curve goes on through; at the end, that through which it
   * arrives. Logarithmic in the number of locations.
   *
   * \throws Invalid_parameter_error if the length is not between 0 and `length()`
   */
  Surface_location location(double length) const
  {
    if(m_starts.empty())
      return m_corridor.places().front();
    const auto [leg, part] = place(length);
    const Input_halfedge_index h = m_corridor.legs()[leg].face;
    const auto from = weights(leg, h), to = weights(leg + 1, h);
    Surface_location result = {h, {}};
    for(std::size_t i = 0; i < 3; ++i) {
      const double weight = (1 - part) * from[i] + part * to[i];
      result.weights[i] = weight < internal::least_weight ? 0 : weight;
    }
    return result;
  }

  /*!
   * The direction in which the curve goes on at a length from the start, told from the halfedge of `location(length)`.
   * At the end it is the direction in which it arrives, straight on.
   *
   * \throws Invalid_parameter_error if the length is not between 0 and `length()`
   * \throws Invalid_curve_error if the curve is a point
   */
  Surface_direction direction(double length) const
  {
    if(m_starts.empty())
      throw Invalid_curve_error("a curve that is a point has no direction");
    const auto [leg, part] = place(length);
    const Input_halfedge_index h = m_corridor.legs()[leg].face;
    if(part == 0)
      return {h, m_corridor.frame(leg, h).angle(m_starts[leg].position, h)};
    if(part < 1)
      return {h, std::arg(m_starts[leg].vector)};
    const auto end = m_corridor.frame(leg + 1, m_corridor.legs()[leg].last_face());
    const double on = m_corridor.start_backward(leg).position + boost::math::constants::pi<double>() / end.stretch();
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
    if(!(length >= 0 && length <= m_lengths.back() * (1 + internal::length_sum_rounding))) {
      std::ostringstream message;
      message << "a length along a curve is " << length << ", not between 0 and " << m_lengths.back();
      throw Invalid_parameter_error(message.str());
    }
    const auto next = std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, length);
    const auto leg = static_cast<std::size_t>(next - m_lengths.begin()) - 1;
    const double whole = m_lengths[leg + 1] - m_lengths[leg];
    return {leg, whole > 0 ? (std::min)((length - m_lengths[leg]) / whole, 1.0) : 0.0};
  }

  std::array<double, 3> weights(std::size_t place, Input_halfedge_index h) const
  {
    auto result = internal::weights_told_from(m_triangulation.input(), m_corridor.places()[place], h);
    const double sum = result[0] + result[1] + result[2];
    for(double& weight : result)
      weight /= sum;
    return result;
  }

  const Triangulation& m_triangulation;
  internal::Corridor<Triangulation> m_corridor;
  std::vector<typename internal::Corridor<Triangulation>::Start> m_starts; // of the legs
  std::vector<double> m_lengths;                                           // up to each place
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * The angle at a location counterclockwise from one direction to another: from 0 on, less than \f$2\pi\f$, at a vertex
 * less than the sum of its angles. At a vertex of the border, where no angle goes all round, it is the difference of the
 * directions.
 *
 * \throws Invalid_location_error, Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 * \throws Invalid_parameter_error if an angle is no finite number, or a halfedge is no side of a face of the location
 *         and does not start there
 *
 * Complexity: linear in the degree of a vertex, else constant.
 */
template <class Triangulation>
double angle_between(const Triangulation& triangulation, const Surface_location& location,
                     const Surface_direction& first, const Surface_direction& second)
{
  if(!std::isfinite(first.angle) || !std::isfinite(second.angle))
    throw Invalid_parameter_error("the angle of a direction is no finite number");
  const internal::Place_frame<Triangulation> frame(triangulation,
                                                   internal::canonical_location(triangulation.input(), location));
  return frame.angle(frame.position(second.halfedge) + second.angle - first.angle, first.halfedge);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_LOCATED_CURVE_H
