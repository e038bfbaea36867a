// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NEAREST_LOCATION_H
#define CGAL_FLIP_GEODESICS_NEAREST_LOCATION_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/triangulation/nearest_weights.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* Half the coordinates of a point: differences of such numbers are finite. */
template <class Point>
Place_in_space half_of(const Point& p)
{
  return {{CGAL::to_double(p.x()) / 2, CGAL::to_double(p.y()) / 2, CGAL::to_double(p.z()) / 2}};
}

/* The corner of a face of the mesh at the tail of a halfedge, as seen from a place. */
template <class Triangulation>
Place_in_space corner_seen_from(const Triangulation& triangulation, Input_halfedge_index h, const Place_in_space& from)
{
  const auto& input = triangulation.input().uncontracted();
  const Vertex_index v = input.tail(h);
  const Place_in_space p = half_of(triangulation.metric().point(input, v));
  if(!are_finite(p))
    throw Invalid_coordinate_error("vertex " + std::to_string(v.idx()) + " has a coordinate that is no finite number",
                                   {static_cast<std::size_t>(v.idx())});
  return {{p[0] - from[0], p[1] - from[1], p[2] - from[2]}};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The location of the point of the mesh that is nearest to a point in space, up to rounding. Where several are as near,
 * it is one of them. It is put on an edge or a vertex where barycentric coordinates are at most 1e-9.
 *
 * All faces are looked at. For many points, `CGAL::Polygon_mesh_processing::locate_with_AABB_tree()` saves time; it
 * gives `Face_location`s.
 *
 * \throws Invalid_location_error if the mesh has no face, or a coordinate of the point is no finite number
 * \throws Invalid_coordinate_error if one of the mesh is not
 * \throws Invalid_mesh_error if a face is not a triangle
 *
 * Complexity: linear in the faces of the mesh.
 */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const typename Triangulation::Metric::Point_3& point)
{
  using Face = typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor;
  const internal::Place_in_space from = internal::half_of(point);
  if(!internal::are_finite(from))
    throw Invalid_location_error("a point in space has a coordinate that is no finite number");
  const auto& input = triangulation.input().uncontracted();
  internal::Nearest_weights nearest;
  Face found{};
  for(const Face f : CGAL::make_range(faces(mesh))) {
    const Input_halfedge_index h = input.index(internal::graph_halfedge(f, mesh));
    internal::check_triangle(input, h);
    const internal::Nearest_weights here =
        internal::nearest_weights({{internal::corner_seen_from(triangulation, h, from),
                                    internal::corner_seen_from(triangulation, input.next(h), from),
                                    internal::corner_seen_from(triangulation, input.next(input.next(h)), from)}});
    if(here.distance < nearest.distance) {
      nearest = here;
      found = f;
    }
  }
  if(nearest.distance == std::numeric_limits<double>::infinity())
    throw Invalid_location_error("a mesh without faces has no point nearest to one in space");
  return surface_location(triangulation, mesh, std::make_pair(found, nearest.weights), internal::nearest_point_snap);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_NEAREST_LOCATION_H
