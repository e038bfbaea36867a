// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Face_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_face.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
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
 * Lays out input faces in numbers of about 106 bits, for a `Face_strip`. Positions err by little more than the number of
 * faces times 2^-97 of the length of the way to them.
 */
template <class Triangulation>
class Layout_in_double_double
{
public:
  struct Side
  {
    Double_double_vector direction; // of length 1
    double error;                   // of the direction
    Double_double length;
    double length_error; // relative
  };

  struct Corner
  {
    Double_double_vector position;
    double error; // a bound
  };

  using Sides = std::array<Side, 3>;

  explicit Layout_in_double_double(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Input_halfedge_index next(Input_halfedge_index h) const { return m_triangulation.input().next(h); }

  static Side opposite(const Side& side) { return {-side.direction, side.error, side.length, side.length_error}; }

  /* The sides of the face of h in a plane in which h has a given direction. */
  Sides sides(Input_halfedge_index h, const Side& along) const
  {
    Sides result;
    Double_double_vector direction = along.direction;
    double error = along.error;
    for(Side& side : result) {
      const Precise_halfedge& face = precise_input_halfedge(m_triangulation, h);
      side = {direction, error, face.length, face.error};
      direction = direction * face.next;
      error = error + face.error + double_double_vector_error;
      h = next(h);
    }
    return result;
  }

  /* Before the sum, the position is no farther than after it and the length of the side together. */
  static Corner step(const Corner& from, const Side& side)
  {
    const Double_double_vector position = from.position + side.length * side.direction;
    const double way = side.length.high * (side.error + side.length_error + 3 * double_double_vector_error);
    return {position, (from.error + way + length(position) * double_double_vector_error) * (1 + bound_rounding)};
  }

  /* The third corner of a face, by the shorter one of the sides that lead to it. */
  static Corner apex(const Sides& sides, const Corner& right, const Corner& left, std::size_t)
  {
    return sides[1].length.high < sides[2].length.high ? step(right, sides[1]) : step(left, opposite(sides[2]));
  }

private:
  const Triangulation& m_triangulation;
};

/*
 * As `Strip`, in numbers of about 106 bits: the input faces along a word that crosses edges from one input vertex to
 * another, unfolded from the input's coordinates.
 */
template <class Triangulation>
class Precise_strip
{
  using Layout = Layout_in_double_double<Triangulation>;

public:
  /* An end of a crossed edge; the error is absolute. */
  using Point = typename Layout::Corner;

  struct Gate
  {
    Point right, left;
  };

  Precise_strip(const Triangulation& triangulation, const Crossing_word& word, bool has_gates)
  {
    if(has_gates)
      m_gates.reserve(word.crossed.size());
    unfold(Layout(triangulation), word, has_gates);
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
  void unfold(const Layout& layout, const Crossing_word& word, bool has_gates)
  {
    const Input_halfedge_index reference = layout.next(layout.next(word.crossed.front()));
    const auto sides = layout.sides(reference, {{{1, 0}, {}}, 0, {}, 0});
    const Point tail = {{}, 0}, right = layout.step(tail, sides[0]), left = layout.step(right, sides[1]);
    Face_strip<Layout> faces(layout, reference, sides, {tail, right, left});
    faces.leave_over(1);
    faces.cross(word.crossed, [&](Input_halfedge_index, const Point& at_right, const Point& at_left) {
      if(has_gates)
        m_gates.push_back({at_right, at_left});
    });
    set_edge(reference, faces.corners()[2], faces.side(2), faces.sides()[2]);
  }

  void set_edge(Input_halfedge_index reference, const Point& head, Input_halfedge_index arrival,
                const typename Layout::Side& arrival_side)
  {
    const double size = length(head.position);
    const double infinity = std::numeric_limits<double>::infinity();
    const bool is_known =
        head.error < largest_first_order_error * size && arrival_side.error < largest_first_order_error;
    m_edge = {head.position,
              arrival_side.direction,
              size,
              is_known ? head.error / size * (1 + second_order_errors) : infinity,
              is_known ? arrival_side.error * (1 + second_order_errors) : infinity,
              reference,
              arrival,
              0};
  }

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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H
