// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_POINTS_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_POINTS_H

#include "checker_joint.h"
#include "checker_mesh.h"
#include "checker_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

// Curves as they are written, and whether their points fit on the mesh, each by itself.
namespace polyline_checker {

/// The unit roundoff of the `double` values that were written.
constexpr long double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// A point of a curve: where it crosses the edge ab, at (1 - t) a + t b, or a stop, if it is a vertex (a == b) or there
/// is a vertex c: the stop of `place()`. And where the file says it is.
struct Polyline_point
{
  Index a, b;
  double t;
  std::array<double, 3> position;
  Index c = null_index;
  double u = 0;

  bool is_stop() const { return a == b || c != null_index; }
  Place place() const { return a == b ? Place::vertex(a) : Place{a, b, c, t, u}; }
};

struct Polyline
{
  long id;
  std::vector<Polyline_point> points;
  std::vector<Place> way_points = {}; // the places that it has to pass, in order, where it may bend
  bool may_bend_inside = false;       // at every stop that is no vertex
  bool must_be_closed = false;
};

struct Curve_report
{
  std::size_t points = 0, segments = 0;
  std::size_t broken = 0;  // points and segments that do not fit on the mesh
  std::string first_break; // where and why
  long double strip_bend = 0;
  long double point_deviation = 0;
  long double raw_bend = 0; // the largest turn at a crossing of the polyline as written
  long double min_vertex_angle = infinite_angle;
  long double min_unblocked_angle = infinite_angle;
  std::size_t bent_vertices = 0; // joints with an angle below pi, blocked or not
  long double length = 0;

  void add_break(const std::string& where_and_why)
  {
    if(broken++ == 0)
      first_break = where_and_why;
  }
};

inline std::string at_point(std::size_t i) { return "point " + std::to_string(i) + ": "; }

/// Where `point` should be, up to the rounding of whoever wrote it: that of the coordinates, and a trillionth of the
/// edges.
inline bool is_position_right(const Mesh& mesh, const Polyline_point& point)
{
  const Mesh::Point& p = mesh.point(point.a);
  const bool is_in_face = point.is_stop() && point.place().is_in_face();
  const Mesh::Point &q = mesh.point(point.b), &r = mesh.point(is_in_face ? point.c : point.a);
  const std::array<long double, 3> edge = difference<long double>(p, q), side = difference<long double>(p, r);
  const long double edge_error = 1e-12L * (length(edge) + length(side));
  for(int i = 0; i < 3; ++i) {
    const long double size = (std::max)({std::fabs(p[i]), std::fabs(q[i]), std::fabs(r[i])});
    const long double error = std::fabs(p[i] + point.t * edge[i] + point.u * side[i] - point.position[i]);
    if(!(error <= 32 * unit_roundoff * size + edge_error))
      return false;
  }
  return true;
}

/// What is wrong with a point where an edge is crossed.
inline std::string crossing_error(const Mesh& mesh, const Polyline_point& point)
{
  if(point.a >= mesh.number_of_vertices() || point.b >= mesh.number_of_vertices())
    return "there is no such vertex";
  if(!mesh.is_edge(point.a, point.b))
    return "there is no edge from " + std::to_string(point.a) + " to " + std::to_string(point.b);
  return point.t > 0 && point.t < 1 ? std::string() : "t is not that of a point inside the edge";
}

/// What is wrong with a single point, nothing if it is right.
inline std::string point_error(const Mesh& mesh, const Polyline_point& point)
{
  const std::string error = point.is_stop() ? place_error(mesh, point.place()) : crossing_error(mesh, point);
  if(!error.empty())
    return error;
  return is_position_right(mesh, point) ? error : "the coordinates are not those of the point on the mesh";
}

inline bool check_points(const Mesh& mesh, const Polyline& curve, Curve_report& report)
{
  for(std::size_t i = 0; i < curve.points.size(); ++i) {
    const std::string error = point_error(mesh, curve.points[i]);
    if(!error.empty())
      report.add_break(at_point(i) + error);
  }
  if(report.broken == 0 && !(curve.points.front().is_stop() && curve.points.back().is_stop()))
    report.add_break("the curve does not begin and end at a vertex or another stop");
  if(report.broken == 0 && curve.must_be_closed && !(curve.points.front().place() == curve.points.back().place()))
    report.add_break("the curve is not closed");
  return report.broken == 0;
}

/// Which points of the curve are its way points: the first and the last of each must be the same, and those in between
/// are the first ones that are, in order. Those missing are breaks.
inline std::set<std::size_t> find_way_points(const Polyline& curve, Curve_report& report)
{
  std::set<std::size_t> result;
  const std::size_t last = curve.way_points.size() - 1;
  std::size_t i = 0;
  for(std::size_t k = 0; k < curve.way_points.size(); ++k) {
    const auto is_there = [&] {
      return curve.points[i].is_stop() && is_same_place(curve.points[i].place(), curve.way_points[k]);
    };
    if(k == last)
      i = curve.points.size() - 1;
    while(k > 0 && k < last && i < curve.points.size() && !is_there())
      ++i;
    if(i >= curve.points.size() || !is_there())
      report.add_break("the curve does not pass way point " + std::to_string(k));
    result.insert(i++);
  }
  return result;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_POINTS_H
