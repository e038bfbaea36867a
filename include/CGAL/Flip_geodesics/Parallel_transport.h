// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PARALLEL_TRANSPORT_H
#define CGAL_FLIP_GEODESICS_PARALLEL_TRANSPORT_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/tangents/Corridor.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTangents
/// A direction in the surface at a location, as `Geodesic_tracer::trace()` takes it.
struct Surface_direction
{
  Input_halfedge_index halfedge = null_index; ///< a side of a face that has the location, or one that starts there
  double angle = 0; ///< from there on, counterclockwise, in radians; at a vertex over all faces about it
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Carries tangent vectors along curves, so that they do not turn in the surface. Within a face a vector stays as it is,
 * and over an edge as it is when both faces are laid into one plane. At a vertex on the curve the vector keeps its
 * angle to the curve. There the angles about the vertex are stretched evenly to \f$2\pi\f$ [PS98], but not on the
 * border. So the tangent of a straightest geodesic is carried to its tangent. Along a loop that meets no vertex a
 * vector turns by the sum of the angle defects of the vertices in the loop.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; its flips do not matter
 */
template <class Triangulation>
class Parallel_transport
{
public:
  /// It refers to the triangulation.
  explicit Parallel_transport(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*!
   * Carries a direction along a curve that runs straight from each location to the next.
   *
   * \param locations a range of `Surface_location`s, of which two in a row lie in one face or on its border; those in
   *        one place count once
   * \param direction at the first location; its halfedge is a side of a face that has the location, or starts there
   * \param halfedge what the result is told from, a halfedge of that kind at the last location; by default the
   *        location's own, or its twin if that is on the border
   * \return the direction at the last location, with an angle in \f$[0, 2\pi)\f$, at a vertex up to the sum of its
   *         angles; on the border, where there are no whole turns, it can be any
   * \throws Invalid_curve_error if there is no location, or no face has two in a row
   * \throws Invalid_location_error for a location that is none
   * \throws Invalid_parameter_error if the angle is no finite number, or a halfedge is another
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error for a face on the way
   *
   * Complexity: linear in the number of locations and the degrees of vertices among them.
   */
  template <class LocationRange>
  Surface_direction operator()(const LocationRange& locations, const Surface_direction& direction,
                               Input_halfedge_index halfedge = null_index) const
  {
    const internal::Corridor<Triangulation> corridor(m_triangulation, locations);
    if(!std::isfinite(direction.angle))
      throw Invalid_parameter_error("the angle of a direction is no finite number");
    Surface_location last;
    for(const Surface_location& location : locations)
      last = location;
    const double position = corridor.frame(0).position(direction.halfedge) + direction.angle;
    const auto frame = corridor.frame(corridor.legs().size());
    const Input_halfedge_index reference = halfedge == null_index ? frame.reference(last) : halfedge;
    return {reference, frame.angle(corridor.transported(position), reference)};
  }

private:
  const Triangulation& m_triangulation;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_PARALLEL_TRANSPORT_H
