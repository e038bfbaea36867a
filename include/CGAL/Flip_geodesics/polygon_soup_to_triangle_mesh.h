// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_POLYGON_SOUP_TO_TRIANGLE_MESH_H
#define CGAL_FLIP_GEODESICS_POLYGON_SOUP_TO_TRIANGLE_MESH_H

/*!
 * \file polygon_soup_to_triangle_mesh.h
 * \ingroup PkgFlipGeodesicsRepair
 * Repairs polygon soups. `Flip_geodesics.h` does not include this header, because this header includes headers of the
 * \cgal packages Polygon Mesh Processing, Surface Mesh and 2D Triangulations, which are licensed under the GPL. A
 * program that includes this header is bound by the GPL.
 */

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/Soup_repair.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

/* The kernel of the predicates of a repair, which must be exact. */
template <class Point_3>
using Repair_kernel =
    std::conditional_t<std::is_same<typename Kernel_traits<Point_3>::Kernel::FT, double>::value,
                       CGAL::Exact_predicates_inexact_constructions_kernel, typename Kernel_traits<Point_3>::Kernel>;

/*
 * Numbers the vertices of a repaired soup as in the mesh, and completes the record. The triangles of the soup are in
 * the order of their polygons.
 */
template <class Kernel>
class Repaired_elements
{
  using Soup = Triangle_soup<Kernel>;

public:
  Repaired_elements(const Soup& soup, const std::vector<char>& had_polygon, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
    , m_numbers(soup.origins.size(), Soup::none)
  {
    number_vertices();
    list_faces();
    list_vertices_of_points(had_polygon);
  }

  std::vector<std::array<std::size_t, 3>> triangles() const
  {
    std::vector<std::array<std::size_t, 3>> result;
    for(const auto& corners : m_soup.triangles)
      result.push_back({m_numbers[corners[0]], m_numbers[corners[1]], m_numbers[corners[2]]});
    return result;
  }

private:
  // Points keep their numbers. A copy takes the number of its point if this number is free, and the next new number
  // otherwise.
  void number_vertices()
  {
    std::vector<char> is_used(m_soup.origins.size(), 0);
    for(const auto& triangle : m_soup.triangles)
      for(std::size_t v : triangle)
        is_used[v] = 1;
    m_record.point_of_vertex.resize(m_soup.points.size());
    std::iota(m_record.point_of_vertex.begin(), m_record.point_of_vertex.end(), std::size_t(0));
    for(std::size_t v = 0; v < is_used.size(); ++v) {
      if(is_used[v] == 0)
        continue;
      const std::size_t origin = m_soup.origins[v];
      const bool is_free = v == origin || is_used[origin] == 0;
      m_numbers[v] = is_free ? origin : m_record.point_of_vertex.size();
      if(is_free)
        is_used[origin] = 1;
      else
        m_record.point_of_vertex.push_back(origin);
    }
    m_record.add(Repair::VERTICES_SPLIT, m_record.point_of_vertex.size() - m_soup.points.size());
  }

  void list_faces()
  {
    for(const Soup_triangle& triangle : m_soup.triangles) {
      m_record.faces_of_polygons.emplace_back(triangle.polygon, m_record.polygon_of_face.size());
      m_record.polygon_of_face.push_back(triangle.polygon);
    }
  }

  void list_vertices_of_points(const std::vector<char>& had_polygon)
  {
    auto& pairs = m_record.vertices_of_points;
    std::vector<std::size_t> vertex_at(m_soup.points.size(), Soup::none); // a position
    std::vector<char> has_vertex(m_soup.points.size(), 0), is_kept(m_soup.points.size(), 0);
    for(std::size_t v = 0; v < m_soup.origins.size(); ++v) {
      const std::size_t number = m_numbers[m_soup.resolve(v)];
      if(number == Soup::none)
        continue;
      pairs.emplace_back(m_soup.origins[v], number);
      has_vertex[m_soup.origins[v]] = 1;
      is_kept[m_record.point_of_vertex[number]] = 1;
      vertex_at[m_soup.place(v)] = (std::min)(vertex_at[m_soup.place(v)], number);
    }
    for(std::size_t i = 0; i < m_soup.points.size(); ++i) {
      if(had_polygon[i] == 0 || m_soup.places[i] == Soup::none)
        continue;
      const std::size_t vertex = vertex_at[m_soup.places[i]];
      if(has_vertex[i] == 0 && vertex != Soup::none)
        pairs.emplace_back(i, vertex);
      if(is_kept[i] == 0)
        m_record.add(vertex == Soup::none ? Repair::POINTS_LEFT : Repair::POINTS_MERGED);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }

  const Soup& m_soup;
  Repair_record& m_record;
  std::vector<std::size_t> m_numbers;
};

template <class Kernel>
void check_repaired(const Triangle_soup<Kernel>& soup, const Repair_record& record)
{
  if(record.number_of_polygons == 0)
    throw Invalid_mesh_error("the polygon soup has no polygons");
  if(soup.triangles.empty()) {
    std::string reasons;
    for(const std::string& line : Internals<Repair_report>::make(record).lines())
      reasons += (reasons.empty() ? "" : "; ") + line;
    throw Invalid_mesh_error("no triangle remains after the repair: " + reasons);
  }
  if(!Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.triangles))
    throw Invalid_mesh_error("the repair failed: the triangles do not form an oriented manifold");
}

template <class Kernel, class PointRange>
std::vector<typename Kernel::Point_3> repair_points(const PointRange& points)
{
  std::vector<typename Kernel::Point_3> result;
  for(const auto& p : points)
    result.emplace_back(p.x(), p.y(), p.z());
  return result;
}

/* Cuts the polygons into the triangles of the soup. Marks the points that are corners. */
template <class Kernel, class PolygonRange>
std::vector<char> add_polygons(const PolygonRange& polygons, Triangle_soup<Kernel>& soup, Repair_record& record)
{
  Soup_polygons<Kernel> add(soup, record);
  std::vector<char> had_polygon(soup.points.size(), 0);
  for(const auto& polygon : polygons) {
    const std::vector<std::size_t> corners(std::begin(polygon), std::end(polygon));
    for(std::size_t v : corners)
      if(v < had_polygon.size())
        had_polygon[v] = 1;
    add(corners, record.number_of_polygons++);
  }
  return had_polygon;
}

/* Adds vertices and triangles to an empty mesh; `place(v)` is the point of a vertex. */
template <class TriangleMesh, class PointMap, class Place>
void build_mesh(TriangleMesh& mesh, PointMap map, std::size_t number_of_vertices, const Place& place,
                const std::vector<std::array<std::size_t, 3>>& triangles)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  vertices.reserve(number_of_vertices);
  for(std::size_t v = 0; v < number_of_vertices; ++v) {
    vertices.push_back(add_vertex(mesh));
    put(map, vertices.back(), place(v));
  }
  for(const auto& t : triangles)
    Euler::add_face(std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 3>{vertices[t[0]],
                                                                                                 vertices[t[1]],
                                                                                                 vertices[t[2]]},
                    mesh);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsRepair
 *
 * Converts a polygon soup to a triangle mesh that the functions of this package accept: an oriented manifold without
 * degenerate faces.
 *
 * The following repairs are made if they are necessary, and are counted in the report; see `Repair`:
 * - Polygons are removed if they contain a point with a coordinate that is not finite, or an invalid index. Corners
 *   that coincide with the previous corner are removed, and polygons that pass through a point twice are split.
 * - Polygons with more than three corners are triangulated.
 * - Triangles with the same corners as another triangle are removed. Two such triangles with opposite orientations are
 *   kept, however, if each of them is the only neighbor of the other, because they form a closed surface.
 * - Triangles are oriented consistently by means of `CGAL::Polygon_mesh_processing::orient_polygon_soup()`. Each
 *   component receives the orientation that the majority of its triangles have in the soup. Faces are cut apart at
 *   edges with more than two faces, at vertices at which several umbrellas meet, and at edges across which the
 *   orientations cannot be made consistent.
 * - Points are welded if a tolerance is given: a point is moved to the nearest preceding unmoved point whose
 *   coordinates all differ from its own by at most the tolerance. Short edges can collapse in this way.
 * - Border edges whose end points have equal coordinates are stitched with
 *   `CGAL::Polygon_mesh_processing::stitch_borders()`. If more than two border edges coincide, they are stitched in
 *   pairs: first the two edges of each component that has exactly two of them, then the remaining edges if exactly two
 *   remain. Borders remain open if stitching would create two edges with the same two vertices.
 * - Triangles whose corners are collinear according to exact predicates are removed. The longest edge of such a
 *   triangle is flipped, which does not change the surface. If the flip is impossible, the triangle is deleted; unless
 *   its longest edge is on the border, this leaves a slit in the surface.
 *
 * The steps are repeated until none of them changes the triangles, so repairing the result again has no effect. The
 * report also contains the number of border edges that nearly coincide with others, and the tolerance above which they
 * would be stitched.
 *
 * No point is moved unless a tolerance is given, and no new points are created. The vertex at position `i` of
 * `vertices(mesh)` comes from point `i`, regardless of the repairs. The vertices of points that were merged into other
 * points or lost their faces are isolated; `CGAL::Polygon_mesh_processing::remove_isolated_vertices()` removes them.
 * Copies of split vertices follow the vertices of all points. Faces are in the order of the polygons from which they
 * come. A soup of triangles without defects therefore yields a mesh with the same elements in the same order, and an
 * empty report.
 *
 * \tparam PointRange a range of points of a \cgal kernel. If the number type of the kernel is `double`, the predicates
 *         of `CGAL::Exact_predicates_inexact_constructions_kernel` are used. Otherwise, the predicates of the kernel
 *         itself are used and must be exact
 * \tparam PolygonRange a range of ranges of positions in `points`, of any integer type
 * \tparam TriangleMesh a model of `MutableFaceGraph` that lists vertices and faces in the order in which they are added
 * \param points the points
 * \param polygons the corners of each polygon
 * \param mesh the resulting mesh. The isolated vertex of a point that is not finite receives the position of another
 *        point
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
 *     \cgalParamType{a model of `WritablePropertyMap` with the vertices of the mesh as keys and points as values}
 *     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{snapping_tolerance}
 *     \cgalParamDescription{the weld tolerance, relative to the longest side of the bounding box of the points}
 *     \cgalParamType{a number in [0, 1)}
 *     \cgalParamDefault{0, for which only points with equal coordinates coincide}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor. If it has a member `on_progress()`, this member is called between the steps with
 *       an estimate of the completed fraction of the work, a `double` from 0 to 1}
 *     \cgalParamType{any class}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the repairs and on the correspondence of elements
 * \pre `mesh` is empty, and the tolerance is in [0, 1)
 * \throws Invalid_mesh_error if the soup has no polygons, or if no triangle remains; the message states the reason, and
 *         `mesh` stays empty
 *
 * Complexity: about the time of sorting the corners of all polygons a few times, plus the time of a constrained
 * Delaunay triangulation of each polygon with more than four corners. In addition,
 * `CGAL::Polygon_mesh_processing::orient_polygon_soup()` can take time quadratic in the degree of a vertex.
 */
template <class PointRange, class PolygonRange, class TriangleMesh, class... NamedParameters>
Repair_report polygon_soup_to_triangle_mesh(const PointRange& points, const PolygonRange& polygons, TriangleMesh& mesh,
                                            const NamedParameters&... np)
{
  const auto& options =
      internal::options_of<internal_np::vertex_point_t, internal_np::snapping_tolerance_t, internal_np::visitor_t>(
          np...);
  CGAL_precondition_msg(num_vertices(mesh) == 0, "the output mesh must be empty");
  const double tolerance = CGAL::to_double(
      parameters::choose_parameter(parameters::get_parameter(options, internal_np::snapping_tolerance), 0.0));
  CGAL_precondition_msg(0 <= tolerance && tolerance < 1, "the weld tolerance must be at least 0 and less than 1");
  using Point_3 = typename std::iterator_traits<decltype(std::begin(points))>::value_type;
  static_assert(internal::is_point_in_space<Point_3>, "the points of a polygon soup must be points of a kernel");
  using Kernel = internal::Repair_kernel<Point_3>;
  auto visitor = internal::make_visitor(options);
  const auto report = [&](std::size_t percentage) { internal::report_progress(visitor.get(), percentage, 100); };
  internal::Repair_record record;
  auto places = internal::repair_points<Kernel>(points);
  record.add(Repair::POINTS_WELDED, internal::weld_points(places, tolerance));
  internal::Triangle_soup<Kernel> soup(std::move(places));
  record.number_of_points = soup.points.size();
  record.add(Repair::POINTS_NOT_FINITE,
             static_cast<std::size_t>(std::count(soup.places.begin(), soup.places.end(), soup.none)));
  report(5);
  const std::vector<char> had_polygon = internal::add_polygons(polygons, soup, record);
  report(15);
  internal::Soup_repair<Kernel>(soup, record)();
  report(50);
  const internal::Repaired_elements<Kernel> elements(soup, had_polygon, record);
  internal::check_repaired(soup, record);
  report(80);
  const internal::Near_borders<Kernel> find_near_borders(soup);
  find_near_borders(record);
  report(95);

  const auto map = parameters::choose_parameter(parameters::get_parameter(options, internal_np::vertex_point),
                                                get_property_map(CGAL::vertex_point, mesh));
  using Mesh_point = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
  const auto place = [&](std::size_t v) {
    const std::size_t i = record.point_of_vertex[v];
    const auto& p = soup.points[soup.places[i] == soup.none ? soup.origins[soup.triangles[0][0]] : i];
    return Mesh_point(p.x(), p.y(), p.z());
  };
  internal::build_mesh(mesh, map, record.point_of_vertex.size(), place, elements.triangles());
  return internal::Internals<Repair_report>::make(std::move(record));
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_POLYGON_SOUP_TO_TRIANGLE_MESH_H
