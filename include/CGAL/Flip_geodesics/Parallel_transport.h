// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PARALLEL_TRANSPORT_H
#define CGAL_FLIP_GEODESICS_PARALLEL_TRANSPORT_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/tangents/Transport_sleeve.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Stores a direction on the surface at a location: a reference halfedge, and an angle counterclockwise from it.
 *
 * All functions that take or return angles of directions obey one rule. An angle refers to a halfedge, which is a side
 * of a face that contains the location, or starts there. The free functions pass both as a `std::pair` of a halfedge of
 * the mesh and an angle. A function that chooses the halfedge takes that of the location, or its twin if that is a
 * border halfedge. It is `halfedge(face, mesh)` for a `Face_location` in the face, and starts at a location that was
 * made from a vertex. Only two functions choose otherwise: a `Trace_report` refers to the side over which the geodesic
 * has entered its last face, and `logarithmic_map()` of a tree, at the border and at inserted vertices, to a direction
 * that its page states.
 */
struct Surface_direction
{
  Input_halfedge_index halfedge = null_index; ///< a side of a face that contains the location, or a halfedge that
                                              ///< starts there
  double angle = 0; ///< measured from there, counterclockwise, in radians; at a vertex over all incident faces
};

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Transports tangent vectors along curves, parallel in the sense of the Levi-Civita connection.
 *
 * Within a face a vector does not change, and across an edge it does not change if both faces are unfolded into a
 * plane. At a vertex on the curve, the vector keeps its angle to the curve, where the angles around the vertex are
 * scaled to a sum of \f$2\pi\f$ [PS98], except on the border. The tangent of a straightest geodesic is therefore
 * transported to its tangent. Along a loop that does not contain a vertex, a vector is rotated by the holonomy of the
 * loop, the sum of the angle defects of the enclosed vertices.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; its flips have no effect
 */
template <class Triangulation>
class Parallel_transport
{
public:
  /// Constructs a transport, which refers to the triangulation.
  explicit Parallel_transport(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*!
   * Transports a direction along a curve that is straight between consecutive locations.
   *
   * \param locations a range of points of the surface, of any type that `surface_location()` takes, of which two
   *        consecutive ones lie in one face or on its boundary; consecutive equal points count once
   * \param direction the direction at the first location; its halfedge is a side of a face that contains the location,
   *        or starts there
   * \param halfedge the halfedge from which the result is measured, which satisfies the same condition at the last
   *        location; by default the one that `Surface_direction` states
   * \return the direction at the last location, with an angle in \f$[0, 2\pi)\f$, or at a vertex up to the sum of its
   *         angles; on the border, which has no full turn, the angle can have any value
   * \throws Invalid_curve_error if the range is empty, or no face contains two consecutive locations
   * \throws Invalid_location_error if a location is not a point of the surface
   * \throws Invalid_parameter_error if the angle is not finite, or a halfedge does not satisfy the condition
   * \throws Degenerate_face_error for a face along the curve
   * \throws Invalid_coordinate_error for a face along the curve
   * \throws Invalid_mesh_error for a face along the curve
   *
   * Complexity: linear in the number of locations and the degrees of the vertices among them.
   */
  template <class LocationRange>
  Surface_direction operator()(const LocationRange& locations, const Surface_direction& direction,
                               Input_halfedge_index halfedge = null_index) const
  {
    const std::vector<Surface_location> places =
        internal::locations_of_curve(m_triangulation, m_triangulation.input().uncontracted().mesh(), locations);
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_PARALLEL_TRANSPORT_H
