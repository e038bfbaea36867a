// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_JOINT_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_JOINT_H

#include "checker_mesh.h"
#include "checker_strip.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace polyline_checker {

constexpr long double pi = 3.141592653589793238462643383279502884L;
constexpr long double infinite_angle = std::numeric_limits<long double>::infinity();

/// Two directions at a vertex that differ by less (radians) are taken for the same when a joint is called blocked.
constexpr long double same_direction_tolerance = 1e-9L;

/*
 * A direction at a vertex: in the face of the halfedge `from`, which starts there, turned counterclockwise from it by
 * `offset`. At another place, where the surface is flat: the offset from some halfedge, up to the sum of all angles.
 */
struct Direction
{
  Index from = null_index;
  long double offset = 0;
  long double flat_angle = 0;  // the sum of all angles of a place that is no vertex
  long double uncertainty = 0; // since the other end of the segment is rounded, or this one
};

/// The end of a segment at a place, known by its curve and a number within the curve.
struct Segment_end
{
  Direction direction;
  std::size_t curve, number;
};

/// The ends of segments at each place.
using Segment_ends = std::map<Place, std::vector<Segment_end>>;

inline long double corner_angle(const Mesh& mesh, Index c) { return Corner<long double>(mesh, c).angle(); }

/// The angle by which halfedge h is turned from another of its face.
inline long double turn_within_face(const Mesh& mesh, Index from, Index h)
{
  if(h == from)
    return 0;
  return h == Mesh::next(from) ? pi - corner_angle(mesh, h) : corner_angle(mesh, from) - pi;
}

/// The direction at a place inside a face, or on an edge, that is turned by `angle` from halfedge h of a face there.
inline Direction flat_direction(const Mesh& mesh, const Place& place, Index h, long double angle)
{
  const Index along = mesh.halfedge(place.a, place.b), against = mesh.halfedge(place.b, place.a);
  if(place.is_in_face()) {
    const long double offset = std::fmod(turn_within_face(mesh, along, h) + angle + 4 * pi, 2 * pi);
    return {along, offset, 2 * pi, 0};
  }
  const bool is_left = along != null_index && along / 3 == h / 3;
  const long double from_edge = std::remainder(turn_within_face(mesh, is_left ? along : against, h) + angle, 2 * pi);
  // Between 0 and pi but for rounding.
  const long double offset = from_edge < -pi / 2 ? pi : (std::max)(from_edge, 0.0L);
  if(along == null_index || against == null_index)
    return {is_left ? along : against, offset, pi, 0};
  return {along, is_left ? offset : pi + offset, 2 * pi, 0};
}

/// The direction at the place along halfedge h, if it is on its edge.
inline Direction direction_along_edge(const Mesh& mesh, const Place& place, Index h, bool is_towards_head)
{
  if(!place.is_vertex())
    return flat_direction(mesh, place, h, is_towards_head ? 0 : pi);
  return is_towards_head ? Direction{h} : Direction{Mesh::next(h), corner_angle(mesh, Mesh::next(h))};
}

/// The angle of the faces from `a` counterclockwise to `b` at the same place; infinite if the border is in between.
inline long double angle_counterclockwise(const Mesh& mesh, const Direction& a, const Direction& b)
{
  if(a.from == b.from && a.offset <= b.offset)
    return b.offset - a.offset;
  if(a.flat_angle > 0)
    return a.flat_angle > 1.5L * pi ? a.flat_angle + b.offset - a.offset : infinite_angle;
  long double angle = corner_angle(mesh, a.from) - a.offset;
  Index c = mesh.next_around_vertex(a.from);
  for(; c != null_index && c != b.from; c = mesh.next_around_vertex(c)) {
    if(c == a.from)
      return infinite_angle; // not the same fan: the surface is pinched at this vertex
    angle += corner_angle(mesh, c);
  }
  return c == null_index ? infinite_angle : angle + b.offset;
}

/*
 * Whether another strand ends in the wedge from `a` counterclockwise to `b`, so that the curve cannot be pulled through
 * it. A strand in the very direction of `a` or `b` counts: which of two strands on one edge is the outer one cannot be
 * read off the points, and the curve has the benefit of the doubt.
 */
inline bool is_blocked(const Mesh& mesh, const Direction& a, const Direction& b,
                       const std::vector<Direction>& other_segments)
{
  const long double wedge = angle_counterclockwise(mesh, a, b);
  for(const Direction& d : other_segments)
    if(angle_counterclockwise(mesh, a, d) <= wedge + same_direction_tolerance ||
       angle_counterclockwise(mesh, d, a) <= same_direction_tolerance)
      return true;
  return false;
}

/// The two sides of a curve at a vertex: the smaller angle, and the smaller one among the sides not blocked.
struct Joint_angles
{
  long double smallest = infinite_angle;
  long double smallest_unblocked = infinite_angle;
};

inline Joint_angles joint_angles(const Mesh& mesh, const Direction& incoming, const Direction& outgoing,
                                 const std::vector<Direction>& other_segments)
{
  Joint_angles result;
  const auto look_at_side = [&](const Direction& a, const Direction& b) {
    const long double angle = angle_counterclockwise(mesh, a, b) + a.uncertainty + b.uncertainty;
    result.smallest = (std::min)(result.smallest, angle);
    if(angle < result.smallest_unblocked && (angle >= pi || !is_blocked(mesh, a, b, other_segments)))
      result.smallest_unblocked = angle;
  };
  look_at_side(outgoing, incoming);
  look_at_side(incoming, outgoing);
  return result;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_JOINT_H
