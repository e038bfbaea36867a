// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LOCATED_POINTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LOCATED_POINTS_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

// Points of the surface as given by users, and the output of curves between such points.

namespace CGAL::Flip_geodesics::internal {

/*
 * Returns the greatest distance of points from the surface, which is infinite unless given. \throws
 * Invalid_parameter_error
 */
template <class NamedParameters>
double greatest_point_distance_of(const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Point_distance_parameter>) {
    const double distance = parameters::get_parameter(np, point_distance_parameter);
    if(!(distance >= 0))
      throw Invalid_parameter_error("greatest_point_distance is " + written(distance) +
                                    ", but must be a number that is not negative");
    return distance;
  } else {
    return static_cast<void>(np), std::numeric_limits<double>::infinity();
  }
}

/* Given points as locations on the mesh, and the distances in space between the two. */
struct Located_points
{
  std::vector<Surface_location> locations;
  std::vector<double> distances; // 0 unless a point is given by coordinates
};

/* Locates points of all types that `surface_location()` accepts. */
template <class Triangulation>
class Point_collector
{
  using Point = typename Point_in_space<typename Triangulation::Metric>::type;

public:
  template <class NamedParameters>
  Point_collector(Place_finder<Triangulation>& find, const NamedParameters& np)
    : m_triangulation(find.triangulation())
    , m_find(find)
    , m_greatest_distance(greatest_point_distance_of(np))
  {
  }

  /* \throws Invalid_location_error, Distant_point_error, Vertex_out_of_range_error */
  template <class Place>
  void add(const Place& place)
  {
    if constexpr(Is_variant<Place>::value) {
      std::visit([this](const auto& p) { this->add(p); }, place);
    } else {
      m_points.locations.push_back(m_find.at(m_points.locations.size(), place));
      m_points.distances.push_back(0);
      if constexpr(Place_finder<Triangulation>::template is_in_space<Place>)
        note_distance(place);
    }
  }

  const Located_points& points() const { return m_points; }

private:
  void note_distance(const Point& given)
  {
    const std::size_t i = m_points.distances.size() - 1;
    const Point found =
        point_in_space(m_triangulation, Flip_geodesics::surface_point(m_triangulation, m_points.locations[i]));
    const Place_in_space p = half_of(given), q = half_of(found); // whose differences are finite
    const double distance = 2 * std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    m_points.distances[i] = distance;
    if(!(distance <= m_greatest_distance))
      throw_naming<Distant_point_error>("point ", Element{i}, " is at a distance of ", distance,
                                        " from the surface, but greatest_point_distance is ", m_greatest_distance);
  }

  const Triangulation& m_triangulation;
  Place_finder<Triangulation>& m_find;
  double m_greatest_distance;
  Located_points m_points;
};

template <class Triangulation, class TriangleMesh, class PlaceRange, class NamedParameters>
Located_points located(const Triangulation& triangulation, const TriangleMesh& mesh, const PlaceRange& places,
                       const NamedParameters& np)
{
  Place_finder<Triangulation> find(triangulation, mesh);
  Point_collector<Triangulation> collector(find, np);
  for(const auto& place : places)
    collector.add(place);
  return collector.points();
}

template <class Triangulation, class Source, class Target, class NamedParameters>
Located_points located_ends(Place_finder<Triangulation>& find, const Source& source, const Target& target,
                            const NamedParameters& np)
{
  Point_collector<Triangulation> collector(find, np);
  collector.add(source);
  collector.add(target);
  return collector.points();
}

template <class Triangulation, class TriangleMesh, class Source, class Target, class NamedParameters>
Located_points located_ends(const Triangulation& triangulation, const TriangleMesh& mesh, const Source& source,
                            const Target& target, const NamedParameters& np)
{
  Place_finder<Triangulation> find(triangulation, mesh);
  return located_ends(find, source, target, np);
}

/* A function that locates the given points on the surface of a triangulation. */
template <class TriangleMesh, class NamedParameters>
using Locate_points =
    std::function<Located_points(const typename Curve_types<TriangleMesh, NamedParameters>::Triangulation&)>;

/* Returns the locations of points on the surface of a triangulation. If it is not contracted, `locate(triangulation)`
 * computes them for the mesh itself and they are stored in `given`, from which later calls take them. */
template <class Triangulation, class Locate>
std::vector<Surface_location> points_on_surface(const Triangulation& triangulation, const Locate& locate,
                                                Located_points& given)
{
  if(!triangulation.input().is_contracted())
    given = locate(triangulation);
  return points_on_surface(triangulation, given.locations);
}

/* Returns these locations in canonical form. */
template <class Triangulation, class Locate>
std::vector<Surface_location> canonical_points(const Triangulation& triangulation, const Locate& locate,
                                               Located_points& given)
{
  std::vector<Surface_location> result = points_on_surface(triangulation, locate, given);
  for(Surface_location& point : result)
    point = canonical_location(triangulation.input(), point);
  return result;
}

/* Returns whether all locations are at vertices. */
inline bool are_vertices(const std::vector<Surface_location>& locations)
{
  return std::all_of(locations.begin(), locations.end(),
                     [](const Surface_location& at) { return kind(at) == Location_kind::VERTEX; });
}

/* Sets the tangents of the points of a polyline, and their halfedges as sides of the face that the curve leaves. */
template <class Triangulation, class Form>
void complete_curve_points(const Triangulation& triangulation, const Surface_polyline& polyline,
                           std::vector<Form>& points)
{
  const auto& input = triangulation.input();
  for(std::size_t i = 1; i < polyline.size(); ++i)
    if(kind(polyline[i]) == Location_kind::EDGE) {
      const Input_halfedge_index h = polyline[i].halfedge, face = common_face(input, polyline[i - 1], polyline[i]);
      points[i].halfedge = input.halfedge(is_side_of(input, h, face) ? h : twin_index(h));
    }
  if constexpr(Has_points<typename Triangulation::Metric>::value)
    for(std::size_t i = points.size() - 1, next = i; i-- > 0; next = i) {
      points[i].tangent = points[i + 1].tangent; // used if two points coincide in space
      set_tangent(points[i], points[i].point, points[next].point);
      if(next + 1 == points.size())
        points.back().tangent = points[i].tangent;
    }
}

/* Appends the points of a polyline that starts at the last of the given points. */
template <class Form, class Triangulation, class TriangleMesh>
void append_polyline(const Triangulation& triangulation, const TriangleMesh& mesh, const Surface_polyline& polyline,
                     std::vector<Form>& result)
{
  const Form_converter<Triangulation, Form> convert(triangulation, mesh);
  std::vector<Form> points;
  for(const Surface_location& location : polyline)
    points.push_back(convert(surface_point(triangulation, location)));
  if constexpr(std::is_same<Form, typename Curve_forms<Triangulation>::All>::value) {
    complete_curve_points(triangulation, polyline, points);
    if constexpr(Has_points<typename Triangulation::Metric>::value)
      if(!result.empty())
        result.back().tangent = points.front().tangent;
  }
  result.insert(result.end(), points.begin() + (result.empty() ? 0 : 1), points.end());
}

template <class Form, class Triangulation, class TriangleMesh>
std::vector<Form> polyline_forms(const Triangulation& triangulation, const TriangleMesh& mesh,
                                 const std::vector<Surface_polyline>& polylines)
{
  std::vector<Form> points;
  for(const Surface_polyline& polyline : polylines)
    if(!is_point(polyline))
      append_polyline(triangulation, mesh, polyline, points);
  if(points.empty()) // all are one point
    append_polyline(triangulation, mesh, polylines.front(), points);
  return points;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LOCATED_POINTS_H
