// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LOCATED_POLYLINE_H
#define CGAL_FLIP_GEODESICS_LOCATED_POLYLINE_H

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsIsolines
/// The type of points that a mesh has of its own.
template <class TriangleMesh>
using Mesh_point =
    typename boost::property_traits<typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type;

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * A polyline on a surface: each two points in a row are in one face, or on its border. A closed one repeats its first
 * point at the end.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Located_polyline
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< of the mesh
  /// A `CGAL::Polygon_mesh_processing::Face_location`: a face and barycentric coordinates, which belong to the source,
  /// target and third vertex of `halfedge(face, mesh)`.
  using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

  bool is_closed = false;               ///< does it end where it began?
  std::vector<Face_location> locations; ///< of the points; one on an edge of the mesh in one of the two faces, always
                                        ///< the same one
  std::vector<Point> points;            ///< in space
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_LOCATED_POLYLINE_H
