// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_SEQUENCE_ANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_SEQUENCE_ANGLE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* At the head of an edge sequence, for its reverse direction. */
template <class Triangulation>
Edge_sequence_angle head_angle(const Triangulation& triangulation, const Strip<Triangulation>& strip,
                               const Edge_sequence& sequence)
{
  if(strip.arrival_reference() == null_index)
    return tail_angle(Strip<Triangulation>(triangulation, sequence.reversed()));
  return {strip.arrival_reference(), angle_from_reference(strip.arrival()), strip.arrival_error()};
}

/* A straight line as seen from one of its ends. */
struct Seen_edge_sequence
{
  const Edge_sequence& sequence;
  bool is_from_tail;
  Edge_sequence_angle angle;

  Edge_sequence seen() const { return is_from_tail ? sequence : sequence.reversed(); }
};

/* Returns the exact position of one straight line relative to another in one corner: CLOCKWISE, COUNTERCLOCKWISE, or
 * COLLINEAR if they have the same direction. In a degenerate face that is a half plane, they can be opposite. */
template <class Triangulation>
Orientation order_in_one_corner(const Triangulation& triangulation, Decision_statistics& statistics,
                                const Seen_edge_sequence& from, const Seen_edge_sequence& to)
{
  constexpr double half_pi = boost::math::constants::half_pi<double>();
  const double turn = from.angle.angle - to.angle.angle, error = 1.6 * (from.angle.error + to.angle.error);
  if(std::abs(turn) > error && std::abs(turn) < half_pi)
    return turn > 0 ? CLOCKWISE : COUNTERCLOCKWISE;
  const Unfolding_chains<Triangulation> unfolding(triangulation);
  const Edge_sequence first = from.seen(), second = to.seen();
  const Sign sine = Exact_sign(statistics, sign_work_limit(triangulation))(
      {unfolding.head(first, false), unfolding.head(second, true)});
  if(sine == ZERO && std::abs(turn) < half_pi)
    return COLLINEAR;
  return sine == POSITIVE || (sine == ZERO && turn > 0) ? CLOCKWISE : COUNTERCLOCKWISE;
}

/* The exact comparison of an angle with pi, and the angle, rounded. */
struct Compared_angle
{
  Comparison_result with_straight;
  double value;
};

/* Computes the angle clockwise from one straight line to another around a vertex of the input; LARGER if the border is
 * in between, 0 if the lines have the same direction. */
template <class Triangulation>
Compared_angle compared_angle_clockwise(const Triangulation& triangulation, Decision_statistics& statistics,
                                        const Seen_edge_sequence& from, const Seen_edge_sequence& to)
{
  const auto& input = triangulation.input();
  const Input_halfedge_index first = from.angle.reference, last = to.angle.reference;
  const Orientation order = first == last ? order_in_one_corner(triangulation, statistics, from, to) : COUNTERCLOCKWISE;
  if(order == COLLINEAR)
    return {SMALLER, 0};
  const Index steps = order == CLOCKWISE ? 0 : number_of_corners_clockwise(input, first, last);
  if(steps < 0)
    return {LARGER, std::numeric_limits<double>::infinity()};
  for_each_corner_clockwise(input, first, steps, [&](Input_halfedge_index t) { check_triangle(input, t); });
  const Wedge_angle angle = wedge_angle(triangulation, from.angle, to.angle, steps);
  const Comparison_result quick = angle.compare_with_straight();
  if(quick == EQUAL)
    return {
        Wedge_comparison<Triangulation>(triangulation, statistics)(Wedge_edge_sequences{from.seen(), to.seen(), steps}),
        angle.value};
  ++statistics.by_strip;
  return {quick, angle.value};
}

template <class Triangulation>
Comparison_result compare_clockwise(const Triangulation& triangulation, Decision_statistics& statistics,
                                    const Seen_edge_sequence& from, const Seen_edge_sequence& to)
{
  return compared_angle_clockwise(triangulation, statistics, from, to).with_straight;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_SEQUENCE_ANGLE_H
