// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NEAREST_LOCATION_H
#define CGAL_FLIP_GEODESICS_NEAREST_LOCATION_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/input/check_triangle.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <string>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* The points of a triangulation's metric, by the vertices of its mesh. */
template <class Triangulation>
struct Metric_point_map
{
  using key_type = typename boost::graph_traits<typename Triangulation::Triangle_mesh>::vertex_descriptor;
  using value_type = typename Triangulation::Metric::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Triangulation* triangulation;

  friend reference get(const Metric_point_map& map, const key_type& v)
  {
    const auto& input = map.triangulation->input().uncontracted();
    return map.triangulation->metric().point(input, input.index(v));
  }
};

template <class Point>
bool is_finite_point(const Point& p)
{
  return std::isfinite(CGAL::to_double(p.x())) && std::isfinite(CGAL::to_double(p.y())) &&
         std::isfinite(CGAL::to_double(p.z()));
}

/* Has the mesh faces, all of them triangles with finite coordinates? A search tree takes that for granted. */
template <class Triangulation>
void check_searchable(const Triangulation& triangulation)
{
  const auto& input = triangulation.input();
  bool has_faces = false;
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(!input.is_border(h)) {
      check_triangle(input, h);
      has_faces = true;
    }
    if(!is_finite_point(triangulation.metric().point(input, input.tail(h))))
      throw Invalid_coordinate_error("vertex " + std::to_string(input.tail(h).idx()) +
                                         " has a coordinate that is no finite number",
                                     {static_cast<std::size_t>(input.tail(h).idx())});
  }
  if(!has_faces)
    throw Invalid_location_error("a mesh without faces has no point nearest to one in space");
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The location of the point of the mesh that is nearest to a point in space, and one of them if there are several;
 * found by `CGAL::Polygon_mesh_processing::locate()`, and put on an edge or a vertex where barycentric coordinates are
 * at most 1e-9. With this header, `geodesic_path()`, `geodesic_path_through()` and `geodesic_spline()` take points in
 * space. It is not part of `Flip_geodesics.h`, since it includes packages of CGAL under the GPL.
 *
 * For many points, a tree of one's own and `CGAL::Polygon_mesh_processing::locate_with_AABB_tree()` save time.
 *
 * \throws Invalid_location_error if the mesh has no face, or a coordinate of the point is no finite number
 * \throws Invalid_coordinate_error if one of the mesh is not
 * \throws Invalid_mesh_error if a face is not a triangle
 *
 * Complexity: \f$O(n \log n)\f$.
 */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const typename Triangulation::Metric::Point_3& point)
{
  if(!internal::is_finite_point(point))
    throw Invalid_location_error("a point in space has a coordinate that is no finite number");
  internal::check_searchable(triangulation);
  const internal::Metric_point_map<Triangulation> points = {&triangulation};
  return surface_location(triangulation, mesh,
                          Polygon_mesh_processing::locate(point, mesh, parameters::vertex_point_map(points)), 1e-9);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_NEAREST_LOCATION_H
