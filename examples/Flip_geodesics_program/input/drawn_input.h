// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_DRAWN_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_DRAWN_INPUT_H

#include "input/point_input.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Files of polylines that are drawn on the mesh: lines of points as for --points, after `o` closed; or, in a file
// `.polylines.txt`, lines of points in space, which are moved to the nearest point of the mesh.
namespace program {

/// A line of a file `.polylines.txt`: the number of points, and their coordinates. It is closed if the first point is
/// repeated at the end.
inline Curve_request read_polyline_in_space(Text_scanner& words, const Surface_projector& project)
{
  Curve_request curve;
  long long count = 0;
  if(parse_number(words.next_word(), count) != nullptr || count < 0)
    words.fail("a polyline starts with its number of points; correct the line");
  std::vector<Point_3> points;
  while(static_cast<long long>(points.size()) < count) {
    const Element element = {"point", points.size()};
    std::array<double, 3> x;
    for(double& coordinate : x) {
      coordinate = words.number<double>(words.next_word(), element);
      if(std::abs(coordinate) > largest_coordinate_to_project)
        words.fail(
            element,
            "has a coordinate beyond 1e60, so it cannot be projected onto the mesh; scale the mesh and the points");
    }
    points.emplace_back(x[0], x[1], x[2]);
  }
  if(words.has_word())
    words.fail(
        "there is text after the last point; a line consists of the number of points and three coordinates for each");
  curve.is_closed = count > 3 && points.front() == points.back();
  if(curve.is_closed)
    points.pop_back();
  for(const Point_3& p : points)
    curve.points.push_back(project(p, words.place()));
  return curve;
}

inline Curve_request read_polyline_on_mesh(Point_reader& read_point, Text_scanner& words)
{
  Curve_request curve;
  curve.is_closed = words.take('o');
  for(std::string_view word; !(word = next_point(words)).empty();)
    curve.points.push_back(read_point(word, words.place()));
  return curve;
}

// Whether two points are one: the same vertex, or the same weights of the same vertices, whichever faces they refer to.
inline bool are_coincident(const Mesh& mesh, const CGAL::Flip_geodesics::Surface_location& a,
                           const CGAL::Flip_geodesics::Surface_location& b)
{
  const auto weights_of_vertices = [&](const CGAL::Flip_geodesics::Surface_location& at) {
    const Mesh::Halfedge_index h = mesh_halfedge(at.halfedge);
    const std::array<Mesh::Vertex_index, 3> vertices = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    std::vector<std::pair<Mesh::Vertex_index, double>> result;
    for(std::size_t i = 0; i < 3; ++i)
      if(at.weights[i] != 0)
        result.emplace_back(vertices[i], at.weights[i]);
    if(result.size() == 1)
      result.front().second = 1;
    std::sort(result.begin(), result.end());
    return result;
  };
  return weights_of_vertices(a) == weights_of_vertices(b);
}

// Merges consecutive coincident points, such as those of curves through coincident vertices.
inline void merge_coincident_points(const Mesh& mesh, Curve_request& curve)
{
  std::vector<CGAL::Flip_geodesics::Surface_location>& points = curve.points;
  const auto are_same = [&](const auto& a, const auto& b) { return are_coincident(mesh, a, b); };
  points.erase(std::unique(points.begin(), points.end(), are_same), points.end());
  while(curve.is_closed && points.size() > 1 && are_same(points.front(), points.back()))
    points.pop_back();
}

inline std::vector<Curve_request> read_drawn_curves(const Input_mesh& mesh, const Input_text& input)
{
  const std::string ending = ".polylines.txt";
  std::optional<Surface_projector> project;
  if(boost::algorithm::ends_with(input.file(), ending) && input.file() != ending) {
    check_coordinates_to_project(mesh, input.name());
    project.emplace(mesh);
  }
  Point_reader read_point(mesh);
  std::vector<Curve_request> curves;
  for_each_line(input, [&](Text_scanner& words) {
    const std::string name = words.place();
    curves.push_back(project ? read_polyline_in_space(words, *project) : read_polyline_on_mesh(read_point, words));
    merge_coincident_points(mesh, curves.back());
    curves.back().name = name;
    curves.back().is_drawn = true;
    if(curves.back().points.size() < (curves.back().is_closed ? 3u : 2u))
      words.fail("a polyline requires at least two points, and a closed polyline at least three; add points or remove "
                 "the line");
  });
  check_not_empty(curves, input);
  return curves;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_DRAWN_INPUT_H
