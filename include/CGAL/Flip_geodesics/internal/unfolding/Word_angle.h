// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WORD_ANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WORD_ANGLE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_comparison.h>

#include <CGAL/enum.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The angle counterclockwise from a halfedge of the input to the straight line of a word that starts there as well, and
 * a bound of its error. Only at vertices of the input. */
struct Word_angle
{
  Input_halfedge_index reference = null_index;
  double angle = 0;
  double error = 0;
};

/* At the tail of a word. */
template <class Triangulation>
Word_angle tail_angle(const Strip<Triangulation>& strip)
{
  return {strip.reference(), angle_from_reference(strip.end()), strip.relative_error()};
}

/* At its head, of the other direction. */
template <class Triangulation>
Word_angle head_angle(const Triangulation& triangulation, const Strip<Triangulation>& strip, const Crossing_word& word)
{
  if(strip.arrival_reference() == null_index)
    return tail_angle(Strip<Triangulation>(triangulation, word.reversed()));
  return {strip.arrival_reference(), angle_from_reference(strip.arrival()), strip.arrival_error()};
}

/* A straight line as seen from one of its ends. */
struct Seen_word
{
  const Crossing_word& word;
  bool is_from_tail;
  Word_angle angle;

  Crossing_word seen() const { return is_from_tail ? word : word.reversed(); }
};

/* How the angle clockwise from one straight line to another about a vertex of the input compares with pi, exactly;
 * LARGER if the border is in between, SMALLER if it is next to nothing. */
template <class Triangulation>
Comparison_result compare_clockwise(const Triangulation& triangulation, Decision_statistics& statistics,
                                    const Seen_word& from, const Seen_word& to)
{
  const auto& input = triangulation.input();
  const Word_angle &a = from.angle, &b = to.angle;
  const bool is_one_corner = a.reference == b.reference;
  if(is_one_corner && std::abs(a.angle - b.angle) <= 1.6 * (a.error + b.error))
    return SMALLER;
  const bool is_in_one_face = is_one_corner && !(a.angle < b.angle);
  const Index steps = is_in_one_face ? 0 : number_of_corners_clockwise(input, a.reference, b.reference);
  if(steps < 0)
    return LARGER;
  const double error = 1.6 * (a.error + b.error) + static_cast<double>(steps + 4) * input_corner_error;
  Angle_sum sum;
  for_each_corner_clockwise(input, a.reference, steps, [&](Input_halfedge_index t) {
    check_triangle(input, t);
    sum.add(input_corner_vector(triangulation, t));
  });
  const Comparison_result quick = Wedge_angle{a.angle - b.angle + sum.value(), error}.compare_with_straight();
  if(quick == EQUAL)
    return Wedge_comparison<Triangulation>(triangulation, statistics)(Wedge_words{from.seen(), to.seen(), steps});
  ++statistics.by_strip;
  return quick;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WORD_ANGLE_H
