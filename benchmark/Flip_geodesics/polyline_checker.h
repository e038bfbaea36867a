// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_POLYLINE_CHECKER_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_POLYLINE_CHECKER_H

#include "checker_joint.h"
#include "checker_mesh.h"
#include "checker_place.h"
#include "checker_points.h"
#include "checker_strip.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

/*
 * Are the curves geodesic? An answer from the input mesh and the written points alone, sharing no code with the
 * library.
 *
 * A curve is cut at its stops: the vertices that it passes, and its ends and way points on edges and inside faces. Each
 * segment in between crosses a strip of faces, given by the edges of its points. The strip is unfolded into the plane
 * and its ends are joined by a straight line; the segment is geodesic if and only if this line stays inside the strip,
 * that is, if each crossed edge has one end on either side of it. So the verdict rests on the crossed edges and not on
 * the positions of the crossing points, whose rounding makes turning angles meaningless where two crossings are close
 * together; the points must then lie on the line.
 *
 * `strip_bend` is the largest angle by which an end of a crossed edge lies beyond the line, seen from the nearer end of
 * the line. The taut string in the strip has to go around that end, and turns by at least this angle, in total, on its
 * side. (The turn at a single point of the taut string is no measure: two ends 1e-16 beyond the line on either side,
 * and as close to each other, turn it by anything.)
 *
 * All is computed in `long double`. A curve that is not clearly straight then is computed again with 50 digits, so that
 * no verdict is due to rounding in here.
 */
namespace polyline_checker {

/// What counts as straight. Angles in radians, the others relative.
struct Tolerances
{
  long double angle = 1e-6L;
  long double point_deviation = 1e-6L; // of the length of the segment
  long double length = 1e-6L;          // of the length reported
};

/// Points closer than this fraction of the segment or of the longest crossed edge are one point for `raw_bend`.
constexpr long double merge_distance = 1e-10L;

/// The written points first .. last of a curve, both stops, and the directions in which it leaves them.
struct Segment
{
  Strip strip;
  std::size_t first, last;
  Direction at_source, at_target;
};

/// A curve cut into segments that fit on the mesh. Measured, but for its joints.
struct Traced_curve
{
  std::vector<Segment> segments;
  bool is_closed = false;
  std::set<std::size_t> way_points; // as numbers of written points
  Curve_report report;
};

/// Which joints have to be straight, and what blocks them.
struct Joint_options
{
  std::set<Index> fixed_vertices;       // curves may bend here
  bool bases_are_fixed = false;         // so they may where a closed curve begins and ends
  bool curves_block_each_other = false; // they were shortened together, and not each alone
};

// ---------------------------------------------------------------------------------------------- the strips --

/// Whether `c` is a halfedge of the edge of `point`.
inline bool is_on(const Mesh& mesh, Index c, const Polyline_point& point)
{
  const Index tail = mesh.vertex(c), head = mesh.vertex(Mesh::next(c));
  return (tail == point.a && head == point.b) || (tail == point.b && head == point.a);
}

/// \returns the first point that does not lie in the face that the strip has come to; `last` on success, then `strip`
/// is complete if it ends at its target. `first_crossed` is the halfedge of the first crossing, in the first face.
inline std::size_t extend_strip(const Mesh& mesh, const Polyline& curve, const Segment& segment, Index first_crossed,
                                Strip& strip)
{
  strip.crossed.assign(1, first_crossed);
  for(std::size_t i = segment.first + 2; i <= segment.last; ++i) {
    const Index entered = mesh.twin(strip.crossed.back());
    if(entered == null_index)
      return i - 1;
    const Polyline_point& point = curve.points[i];
    const Index right = Mesh::next(entered), left = Mesh::previous(entered);
    if(i == segment.last)
      return lies_beyond(mesh, entered, strip.target) ? i + 1 : i;
    if(!is_on(mesh, right, point) && !is_on(mesh, left, point))
      return i;
    strip.crossed.push_back(is_on(mesh, right, point) ? right : left);
  }
  return segment.last + 1;
}

/// Finds the strip of faces of a segment that crosses an edge. \returns the point at which this fails, or last + 1.
inline std::size_t find_strip(const Mesh& mesh, const Polyline& curve, Segment& segment)
{
  const Polyline_point& crossing = curve.points[segment.first + 1];
  std::size_t reached = segment.first + 1;
  for(const Index c : {mesh.halfedge(crossing.a, crossing.b), mesh.halfedge(crossing.b, crossing.a)}) {
    // On two triangles glued back to back both sides start well.
    if(c == null_index || !lies_beyond(mesh, c, segment.strip.source) || reached > segment.last)
      continue;
    Strip strip{segment.strip.source, segment.strip.target, {}};
    reached = (std::max)(reached, extend_strip(mesh, curve, segment, c, strip));
    if(reached > segment.last)
      segment.strip = strip;
  }
  return reached;
}

// ----------------------------------------------------------------------------------------------------- measures --

/// The written crossing points in the plane.
template <class NT>
std::vector<Vector_2<NT>> unfolded_points(const Mesh& mesh, const Polyline& curve, const Segment& segment,
                                          const Unfolded_strip<NT>& unfolded)
{
  std::vector<Vector_2<NT>> result;
  for(std::size_t i = 0; i < segment.strip.crossed.size(); ++i) {
    const auto& portal = unfolded.portals()[i];
    const Polyline_point& point = curve.points[segment.first + 1 + i];
    const bool from_right = point.a == mesh.vertex(segment.strip.crossed[i]);
    result.push_back(from_right ? portal.right + portal.edge * NT(point.t) : portal.left - portal.edge * NT(point.t));
  }
  return result;
}

/// The largest distance of a point from the line to the target, less what the rounding of its t explains, relative to
/// the length of this line.
template <class NT>
long double largest_deviation(const Unfolded_strip<NT>& unfolded, const std::vector<Vector_2<NT>>& points)
{
  long double result = 0;
  const NT line = length(unfolded.target());
  for(std::size_t i = 0; i < points.size(); ++i) {
    const NT distance = cross(unfolded.target(), points[i]) / line;
    const NT rounding = NT(4 * unit_roundoff) * length(unfolded.portals()[i].edge) + NT(unfolded.uncertainty_of_line());
    const NT deviation = ((distance < 0 ? NT(-distance) : distance) - rounding) / line;
    result = (std::max)(result, static_cast<long double>(deviation));
  }
  return result;
}

/// The largest turn of the polyline source, points, target, where points that are too close to each other are merged.
template <class NT>
long double largest_turn(const Unfolded_strip<NT>& unfolded, const std::vector<Vector_2<NT>>& points)
{
  NT scale = length(unfolded.target());
  for(const auto& portal : unfolded.portals())
    scale = (std::max)(scale, length(portal.edge));
  const auto is_far = [&](const Vector_2<NT>& v) { return length(v) > NT(merge_distance) * scale; };

  long double result = 0;
  Vector_2<NT> here{NT(0), NT(0)}, incoming{NT(0), NT(0)};
  const auto go_to = [&](const Vector_2<NT>& p) {
    const Vector_2<NT> outgoing = p - here;
    if(length(incoming) > 0)
      result = (std::max)(result, std::fabs(angle_between(incoming, outgoing)));
    here = p;
    incoming = outgoing;
  };
  for(const Vector_2<NT>& p : points)
    if(is_far(p - here) && is_far(unfolded.target() - p))
      go_to(p);
  if(is_far(unfolded.target() - here))
    go_to(unfolded.target());
  return result;
}

/// The direction at the source of an unfolded strip that crosses halfedge `crossed` first.
template <class NT>
Direction direction_at_source(const Mesh& mesh, const Place& source, Index crossed, const Unfolded_strip<NT>& unfolded,
                              long double uncertainty)
{
  Direction result{Mesh::previous(crossed), unfolded.direction(true)};
  if(!source.is_vertex())
    result = flat_direction(mesh, source, crossed, unfolded.direction(false));
  result.uncertainty = uncertainty;
  return result;
}

/// Unfolds the strip from both ends and adds its figures to `report`. \returns whether that was possible
template <class NT>
bool measure_strip(const Mesh& mesh, const Polyline& curve, Segment& segment, Curve_report& report)
{
  const Strip reversed = segment.strip.reversed(mesh);
  const Unfolded_strip<NT> forward(mesh, segment.strip), backward(mesh, reversed);
  const long double line = static_cast<long double>(length(forward.target()));
  if(!std::isfinite(line) || !std::isfinite(static_cast<long double>(length(backward.target()))))
    return false; // a face has a zero-length edge
  const long double uncertainty = forward.uncertainty_of_line() > 0 ? forward.uncertainty_of_line() / line : 0;
  segment.at_source =
      direction_at_source(mesh, segment.strip.source, segment.strip.crossed.front(), forward, uncertainty);
  segment.at_target = direction_at_source(mesh, reversed.source, reversed.crossed.front(), backward, uncertainty);
  const long double bend = (std::max)(bend_seen_from_source(forward), bend_seen_from_source(backward));
  report.strip_bend = (std::max)(report.strip_bend, line > 0 ? bend : pi);
  report.length += line;
  if(!(line > 0))
    return true;
  const std::vector<Vector_2<NT>> points = unfolded_points(mesh, curve, segment, forward);
  report.point_deviation = (std::max)(report.point_deviation, largest_deviation(forward, points));
  report.raw_bend = (std::max)(report.raw_bend, largest_turn(forward, points));
  return true;
}

/// The direction at `from` to another place in the same face, that of h, or on the edge of h if both lie there.
template <class NT>
Direction direction_in_face(const Mesh& mesh, Index h, const Place& from, const Place& to)
{
  const Index apex = mesh.vertex(Mesh::previous(h));
  if(weight<NT>(from, apex) == 0 && weight<NT>(to, apex) == 0)
    return direction_along_edge(mesh, from, h, weight<NT>(to, mesh.vertex(h)) < weight<NT>(from, mesh.vertex(h)));
  while(from.is_vertex() && mesh.vertex(h) != from.a)
    h = Mesh::next(h);
  const long double angle = angle_between(Vector_2<NT>{NT(1), NT(0)}, vector_in_face<NT>(mesh, h, from, to));
  return from.is_vertex() ? Direction{h, angle} : flat_direction(mesh, from, h, angle);
}

/// A segment along an edge or through the inside of one face. \returns whether there is such a face
template <class NT>
bool measure_in_face(const Mesh& mesh, Segment& segment, Curve_report& report)
{
  const Place &source = segment.strip.source, &target = segment.strip.target;
  const Index h = common_halfedge(mesh, source, target);
  if(h == null_index || source == target)
    return false;
  segment.at_source = direction_in_face<NT>(mesh, h, source, target);
  segment.at_target = direction_in_face<NT>(mesh, h, target, source);
  const Index apex = mesh.vertex(Mesh::previous(h));
  const bool is_on_edge = weight<NT>(source, apex) == 0 && weight<NT>(target, apex) == 0;
  const NT along = weight<NT>(target, mesh.vertex(h)) - weight<NT>(source, mesh.vertex(h));
  const long double line =
      static_cast<long double>(is_on_edge ? NT(edge_length<NT>(mesh, h) * (along < 0 ? -along : along))
                                          : length(vector_in_face<NT>(mesh, h, source, target)));
  const long double uncertain = uncertainty(mesh, h, source) + uncertainty(mesh, h, target);
  if(!is_on_edge && uncertain > 0)
    segment.at_source.uncertainty = segment.at_target.uncertainty = uncertain / line;
  report.length += line;
  return true;
}

template <class NT>
void trace_segment(const Mesh& mesh, const Polyline& curve, Segment segment, Traced_curve& traced)
{
  Curve_report& report = traced.report;
  if(segment.last == segment.first + 1) {
    if(!measure_in_face<NT>(mesh, segment, report))
      return report.add_break(at_point(segment.last) + "there is no edge or face with the stop before and this one");
  } else {
    const std::size_t reached = find_strip(mesh, curve, segment);
    if(reached <= segment.last)
      return report.add_break(at_point(reached) + "it does not lie in the face that the curve has come to");
    if(!measure_strip<NT>(mesh, curve, segment, report))
      return report.add_break(at_point(segment.first) + "a face with a zero-length edge cannot be unfolded");
  }
  traced.segments.push_back(segment);
}

/// Cuts the curve into segments and measures these. A curve shrunk to a vertex has none.
template <class NT = long double>
Traced_curve trace_curve(const Mesh& mesh, const Polyline& curve)
{
  Traced_curve traced;
  Curve_report& report = traced.report;
  const std::vector<Polyline_point>& points = curve.points;
  report.points = points.size();
  if(points.empty() || !check_points(mesh, curve, report))
    return traced;
  const auto is_at_start = [&](const Polyline_point& p) { return p.is_stop() && p.place() == points.front().place(); };
  if(std::all_of(points.begin(), points.end(), is_at_start))
    return traced;
  traced.is_closed = is_at_start(points.back());
  traced.way_points = find_way_points(curve, report);
  std::size_t first = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    if(points[i].is_stop()) {
      const Strip ends{points[first].place(), points[i].place(), {}};
      trace_segment<NT>(mesh, curve, Segment{ends, first, i, {}, {}}, traced);
      ++report.segments;
      first = i;
    }
  return traced;
}

// ------------------------------------------------------------------------------------------------------- joints --

/// Adds the ends of the segments of a curve: number 2i is the source of segment i, 2i + 1 its target.
inline void add_segment_ends(const Traced_curve& traced, std::size_t curve, Segment_ends& ends)
{
  for(std::size_t i = 0; i < traced.segments.size(); ++i) {
    const Segment& segment = traced.segments[i];
    ends[segment.strip.source].push_back({segment.at_source, curve, 2 * i});
    ends[segment.strip.target].push_back({segment.at_target, curve, 2 * i + 1});
  }
}

/// Measures the joint where segment `x` of the curve ends and segment `y` begins.
inline void measure_joint(const Mesh& mesh, const Segment_ends& ends, std::size_t curve, std::size_t x, std::size_t y,
                          Traced_curve& traced, const Tolerances& tolerances)
{
  const Direction& incoming = traced.segments[x].at_target;
  const Direction& outgoing = traced.segments[y].at_source;
  std::vector<Direction> others;
  for(const Segment_end& end : ends.at(traced.segments[y].strip.source))
    if(end.curve != curve || (end.number != 2 * x + 1 && end.number != 2 * y))
      others.push_back(end.direction);
  const Joint_angles angles = joint_angles(mesh, incoming, outgoing, others);
  Curve_report& report = traced.report;
  report.min_vertex_angle = (std::min)(report.min_vertex_angle, angles.smallest);
  report.min_unblocked_angle = (std::min)(report.min_unblocked_angle, angles.smallest_unblocked);
  if(angles.smallest < pi - tolerances.angle)
    ++report.bent_vertices;
}

/// Measures the joints of an unbroken curve; `ends` are those of all curves that may block it, itself included.
inline void measure_joints(const Mesh& mesh, const Segment_ends& ends, std::size_t curve, Traced_curve& traced,
                           const Joint_options& options, const Tolerances& tolerances, bool may_bend_inside)
{
  const std::size_t n = traced.segments.size();
  if(traced.report.broken > 0)
    return;
  const auto is_fixed = [&](std::size_t y) {
    const Place& place = traced.segments[y].strip.source;
    return traced.way_points.count(traced.segments[y].first) > 0 ||
           (place.is_vertex() ? options.fixed_vertices.count(place.a) > 0 : may_bend_inside);
  };
  for(std::size_t y = 1; y < n; ++y)
    if(!is_fixed(y))
      measure_joint(mesh, ends, curve, y - 1, y, traced, tolerances);
  if(traced.is_closed && n > 0 && !options.bases_are_fixed && !is_fixed(0))
    measure_joint(mesh, ends, curve, n - 1, 0, traced, tolerances);
}

// ------------------------------------------------------------------------------------------------ whole curves --

/// Whether the segments are straight and the points on them.
inline bool has_straight_segments(const Curve_report& report, const Tolerances& tolerances = Tolerances())
{
  return report.broken == 0 && report.strip_bend < tolerances.angle &&
         report.point_deviation < tolerances.point_deviation;
}

/// Whether the curve is a geodesic that nothing could make shorter.
inline bool is_geodesic(const Curve_report& report, const Tolerances& tolerances = Tolerances())
{
  return has_straight_segments(report, tolerances) && report.min_unblocked_angle > pi - tolerances.angle;
}

/// As `trace_curve()`, and again with 50 digits if the strips are not clearly straight.
inline Traced_curve trace_curve_reliably(const Mesh& mesh, const Polyline& curve,
                                         const Tolerances& tolerances = Tolerances())
{
  using boost::multiprecision::cpp_bin_float_50;
  using Precise = boost::multiprecision::number<cpp_bin_float_50::backend_type, boost::multiprecision::et_off>;
  const Traced_curve traced = trace_curve(mesh, curve);
  Tolerances strict = tolerances;
  strict.angle /= 1000;
  strict.point_deviation /= 1000;
  if(traced.report.broken > 0 || has_straight_segments(traced.report, strict))
    return traced;
  return trace_curve<Precise>(mesh, curve);
}

/// Checks all curves of a file.
inline std::vector<Curve_report> check_curves(const Mesh& mesh, const std::vector<Polyline>& curves,
                                              const Joint_options& options = Joint_options(),
                                              const Tolerances& tolerances = Tolerances())
{
  std::vector<Traced_curve> traced;
  Segment_ends all_ends;
  for(std::size_t i = 0; i < curves.size(); ++i) {
    traced.push_back(trace_curve_reliably(mesh, curves[i], tolerances));
    if(options.curves_block_each_other)
      add_segment_ends(traced[i], i, all_ends);
  }
  std::vector<Curve_report> reports;
  for(std::size_t i = 0; i < curves.size(); ++i) {
    Segment_ends own_ends;
    if(!options.curves_block_each_other)
      add_segment_ends(traced[i], i, own_ends);
    const Segment_ends& ends = options.curves_block_each_other ? all_ends : own_ends;
    measure_joints(mesh, ends, i, traced[i], options, tolerances, curves[i].may_bend_inside);
    reports.push_back(traced[i].report);
  }
  return reports;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_POLYLINE_CHECKER_H
