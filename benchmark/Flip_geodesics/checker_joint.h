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

/// A direction at the vertex of `corner`: in its face, turned counterclockwise by `offset` from the halfedge `corner`.
struct Direction
{
  Index corner = null_index;
  long double offset = 0;
};

/// The end of a segment at a vertex, known by its curve and a number within the curve.
struct Strand_end
{
  Direction direction;
  std::size_t curve, number;
};

/// The ends of segments at each vertex.
using Strand_ends = std::map<Index, std::vector<Strand_end>>;

inline long double corner_angle(const Mesh& mesh, Index c) { return Corner<long double>(mesh, c).angle(); }

/// The direction at `v` along the edge to its neighbour `u`.
inline Direction direction_along_edge(const Mesh& mesh, Index v, Index u)
{
  const Index h = mesh.halfedge(v, u);
  if(h != null_index)
    return {h, 0};
  const Index corner = Mesh::next(mesh.halfedge(u, v)); // the mesh is on the other side of this border edge only
  return {corner, corner_angle(mesh, corner)};
}

/// The angle of the faces from `a` counterclockwise to `b` at the same vertex; infinite if the border is in between.
inline long double angle_counterclockwise(const Mesh& mesh, const Direction& a, const Direction& b)
{
  if(a.corner == b.corner && a.offset <= b.offset)
    return b.offset - a.offset;
  long double angle = corner_angle(mesh, a.corner) - a.offset;
  Index c = mesh.next_around_vertex(a.corner);
  for(; c != null_index && c != b.corner; c = mesh.next_around_vertex(c)) {
    if(c == a.corner)
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
                       const std::vector<Direction>& other_strands)
{
  const long double wedge = angle_counterclockwise(mesh, a, b);
  for(const Direction& d : other_strands)
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
                                 const std::vector<Direction>& other_strands)
{
  Joint_angles result;
  const auto look_at_side = [&](const Direction& a, const Direction& b) {
    const long double angle = angle_counterclockwise(mesh, a, b);
    result.smallest = (std::min)(result.smallest, angle);
    if(angle < result.smallest_unblocked && (angle >= pi || !is_blocked(mesh, a, b, other_strands)))
      result.smallest_unblocked = angle;
  };
  look_at_side(outgoing, incoming);
  look_at_side(incoming, outgoing);
  return result;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_JOINT_H
