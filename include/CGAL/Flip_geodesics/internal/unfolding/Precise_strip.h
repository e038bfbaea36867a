// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_face.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * An intrinsic edge between input vertices as a vector of about 100 bits, in the frame of its tail's reference, the
 * input halfedge that bounds its first face clockwise, or that it runs along. Its head's reference is that of its other
 * direction. Errors are relative, and infinite where there is no bound.
 */
struct Precise_edge
{
  Double_double_vector end;
  Double_double_vector head_direction; // of the head's reference, in the frame of the tail's
  double length = 0;                   // of `end`
  double end_error = std::numeric_limits<double>::infinity();
  double direction_error = std::numeric_limits<double>::infinity();
  Input_halfedge_index tail_reference = null_index, head_reference = null_index;
  Index first_corner = 0; // 1 if it runs along its references: turns about an end start one corner farther then

  bool has_bound() const { return end_error < 1; }

  /* The other direction. */
  Precise_edge reversed() const
  {
    const Double_double_vector direction = conjugate(head_direction);
    return {
        -(end * direction), direction,      length,         end_error + direction_error + double_double_vector_error,
        direction_error,    head_reference, tail_reference, first_corner};
  }
};

/* The input halfedge h as an edge, from any side of it. */
inline Precise_edge precise_input_edge(Input_halfedge_index h, const Precise_halfedge& side)
{
  return {{side.length, {}}, {{-1, 0}, {}}, side.length.high, side.error, 0, h, twin_index(h), 1};
}

/*
 * As `Strip`, in numbers of about 106 bits: the input faces along a word that crosses edges from one input vertex to
 * another, unfolded from the input's coordinates. Positions err by little more than the number of faces times 2^-97 of
 * the length of the way to them.
 */
template <class Triangulation>
class Precise_strip
{
public:
  /* An end of a crossed edge; the error is absolute. */
  struct Point
  {
    Double_double_vector position;
    double error;
  };

  struct Gate
  {
    Point right, left;
  };

  Precise_strip(const Triangulation& triangulation, const Crossing_word& word, bool has_gates)
    : m_triangulation(triangulation)
  {
    if(has_gates)
      m_gates.reserve(word.crossed.size());
    unfold(word, has_gates);
  }

  const std::vector<Gate>& gates() const { return m_gates; }
  const Precise_edge& edge() const { return m_edge; }

  /* On which side of the line from tail to head does a point lie? POSITIVE is the left. */
  Uncertain<Sign> side(const Point& p) const
  {
    const Double_double sine = (p.position * conjugate(m_edge.end)).y;
    const double size = length(p.position);
    const double error = m_edge.length * (p.error + 2 * size * (m_edge.end_error + double_double_vector_error));
    if(!(std::abs(sine.high) > 2 * error))
      return Uncertain<Sign>::indeterminate();
    return sine.high > 0 ? POSITIVE : NEGATIVE;
  }

private:
  // The direction of a halfedge in the frame of the reference.
  struct Direction
  {
    Double_double_vector vector;
    double error;
  };

  Input_halfedge_index next(Input_halfedge_index h) const { return m_triangulation.input().next(h); }
  decltype(auto) face(Input_halfedge_index h) const { return precise_input_halfedge(m_triangulation, h); }

  Direction next_direction(Input_halfedge_index h, const Direction& d) const
  {
    const Precise_halfedge& side = face(h);
    return {d.vector * side.next, d.error + side.error + double_double_vector_error};
  }

  static Direction opposite(const Direction& d) { return {-d.vector, d.error}; }

  // Before the sum, the position is no farther than after it and the length of the side together.
  Point step(const Point& from, Input_halfedge_index h, const Direction& d) const
  {
    const Precise_halfedge& side = face(h);
    const Double_double_vector position = from.position + side.length * d.vector;
    const double way = side.length.high * (d.error + side.error + 3 * double_double_vector_error);
    return {position, (from.error + way + length(position) * double_double_vector_error) * (1 + bound_rounding)};
  }

  void unfold(const Crossing_word& word, bool has_gates)
  {
    Input_halfedge_index crossed = word.crossed.front();
    const Input_halfedge_index reference = next(next(crossed));
    const Direction first = {{{1, 0}, {}}, 0};
    Direction along = next_direction(reference, first); // the crossed edge, from right to left
    Point right = step({{}, 0}, reference, first), left = step(right, crossed, along), apex = left;
    Input_halfedge_index arrival = null_index;
    for(std::size_t i = 0; i < word.crossed.size(); ++i) {
      if(has_gates)
        m_gates.push_back({right, left});
      const Input_halfedge_index entered = twin_index(crossed), to_apex = next(entered);
      const Direction from_right = next_direction(entered, opposite(along));
      const Direction to_left = next_direction(to_apex, from_right);
      arrival = next(to_apex);
      apex = face(to_apex).length.high < face(arrival).length.high ? step(right, to_apex, from_right)
                                                                   : step(left, arrival, opposite(to_left));
      along = to_left;
      if(i + 1 == word.crossed.size())
        break;
      crossed = word.crossed[i + 1];
      if(crossed == to_apex) {
        left = apex;
        along = from_right;
      } else {
        right = apex;
      }
    }
    set_edge(reference, apex, arrival, along);
  }

  void set_edge(Input_halfedge_index reference, const Point& head, Input_halfedge_index arrival,
                const Direction& direction)
  {
    const double size = length(head.position);
    const double infinity = std::numeric_limits<double>::infinity();
    const bool is_known = head.error < largest_first_order_error * size && direction.error < largest_first_order_error;
    m_edge = {head.position,
              direction.vector,
              size,
              is_known ? head.error / size * (1 + second_order_errors) : infinity,
              is_known ? direction.error * (1 + second_order_errors) : infinity,
              reference,
              arrival,
              0};
  }

  const Triangulation& m_triangulation;
  std::vector<Gate> m_gates;
  Precise_edge m_edge;
};

/* An edge, given by its word, unfolded from the input. Without a bound if an end is an inserted vertex. */
template <class Triangulation>
Precise_edge unfolded_edge(const Triangulation& triangulation, const Crossing_word& word)
{
  if(triangulation.is_inserted(word.tail) || triangulation.is_inserted(word.head))
    return {};
  if(word.along == null_index)
    return Precise_strip<Triangulation>(triangulation, word, false).edge();
  const Input_halfedge_index h = word.along;
  const Input_halfedge_index inside = triangulation.input().is_border(h) ? twin_index(h) : h;
  return precise_input_edge(h, precise_input_halfedge(triangulation, inside));
}

/* The edge of halfedge h, as the triangulation derives and keeps it, or unfolded. */
template <class Triangulation>
Precise_edge precise_edge(const Triangulation& triangulation, Halfedge_index h)
{
  if constexpr(Keeps_precise_numbers<Triangulation>::value)
    return triangulation.precise_edge(h);
  else
    return unfolded_edge(triangulation, triangulation.crossing_word(h));
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H
