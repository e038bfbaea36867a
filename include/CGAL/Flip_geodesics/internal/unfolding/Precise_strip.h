// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A halfedge of an input face: its length, and the direction of the next halfedge, of length 1, in the frame in which
 * its own direction is 1 and the face is on the upper side.
 */
struct Precise_halfedge
{
  Double_double length;
  Double_double_vector next;
  double error; // bounds that of the direction, and that of the length relative to it
};

/*
 * Computes faces in double-double arithmetic, as `IntrinsicMetric::face_geometry()` requires of its traits.
 *
 * The bound of the errors, in units of u^2 = 2^-106. From points: differences of doubles are exact, those of rational
 * numbers err by 1 in each coordinate; a dot product of e and f errs by 52 of |e| |f|, three products of 16, two sums
 * and the differences; a cross product by 60, as a vector, its length by another 41 relative to itself; lengths by 42;
 * the product of two by 100, its reciprocal and the last product by 32 more. In all |(52, 101)| + 100 + 32 < 256 = 2^8,
 * as the cross product of the two shortest sides is no less accurate for the others. From lengths: (c - a)(c + a) - b^2
 * for a >= b errs by 112 of a b, as |c - a| <= b; the factors of Heron's formula are sums of three doubles with an
 * error of at most 2, their product has at most 56, its root at most 44. The total is smaller.
 *
 * For lengths between 2^-200 and 2^200, overflow does not occur and underflow is negligible: roots of what is lost are
 * below 2^-535, and the square of 2^-200 times 2^-106 is above. Other faces have no bound.
 */
class Precise_face_traits
{
public:
  using Face_geometry = std::array<Precise_halfedge, 3>;

  class Construct_face_3
  {
  public:
    template <class Point_3>
    Face_geometry operator()(const Point_3& p, const Point_3& q, const Point_3& r) const
    {
      const std::array<std::array<Double_double, 3>, 3> e = {precise_vector(p, q), precise_vector(q, r),
                                                             precise_vector(r, p)};
      std::array<Double_double, 3> lengths, dots;
      for(int i = 0; i < 3; ++i) {
        lengths[i] = sqrt(dot(e[i], e[i]));
        dots[i] = dot(e[i], e[(i + 1) % 3]);
      }
      const int longest = index_of_longest(lengths);
      const auto n = cross(e[(longest + 1) % 3], e[(longest + 2) % 3]);
      return assembled(lengths, dots, sqrt(dot(n, n)));
    }
  };

  class Construct_face_from_lengths
  {
  public:
    Face_geometry operator()(double a, double b, double c) const
    {
      return assembled({{{a, 0}, {b, 0}, {c, 0}}}, {{dot(a, b, c), dot(b, c, a), dot(c, a, b)}}, doubled_area(a, b, c));
    }

    Face_geometry operator()(const Squared_lengths& l) const
    {
      return assembled({{l.length(0), l.length(1), l.length(2)}}, {{l.dot(0), l.dot(1), l.dot(2)}}, l.doubled_area());
    }

  private:
    // For the sides with lengths a and b, one after the other.
    static Double_double dot(double a, double b, double c)
    {
      if(a < b)
        std::swap(a, b);
      const Double_double twice = exact_sum(c, -a) * exact_sum(c, a) - exact_product(b, b);
      return {0.5 * twice.high, 0.5 * twice.low};
    }

    static Double_double doubled_area(double a, double b, double c) // [Heron]
    {
      const Double_double twice = sqrt((sum(a, b, c) * sum(a, b, -c)) * (sum(b, c, -a) * sum(c, a, -b)));
      return {0.5 * twice.high, 0.5 * twice.low};
    }

    static Double_double sum(double a, double b, double c)
    {
      const Double_double first = exact_sum(a, b), all = exact_sum(first.high, c);
      return ordered_sum(all.high, all.low + first.low);
    }
  };

  Construct_face_3 construct_face_3_object() const { return {}; }
  Construct_face_from_lengths construct_face_from_lengths_object() const { return {}; }

private:
  static int index_of_longest(const std::array<Double_double, 3>& lengths)
  {
    const auto is_shorter = [](const Double_double& a, const Double_double& b) { return a.high < b.high; };
    return static_cast<int>((std::max_element)(lengths.begin(), lengths.end(), is_shorter) - lengths.begin());
  }

  static Face_geometry assembled(const std::array<Double_double, 3>& lengths, const std::array<Double_double, 3>& dots,
                                 const Double_double& doubled_area)
  {
    const auto is_usual = [](const Double_double& a) { return a.high > least_unscaled && a.high < greatest_unscaled; };
    const bool are_usual = std::all_of(lengths.begin(), lengths.end(), is_usual);
    Face_geometry result;
    for(int i = 0; i < 3; ++i) {
      const Double_double scale = Double_double{1, 0} / (lengths[i] * lengths[(i + 1) % 3]);
      result[i] = {lengths[i],
                   {dots[i] * scale, doubled_area * scale},
                   are_usual ? precise_direction_error : std::numeric_limits<double>::infinity()};
    }
    return result;
  }
};

/* Returns input halfedge h as stored by the triangulation, or computes it. */
template <class Triangulation>
decltype(auto) precise_input_halfedge(const Triangulation& triangulation, Input_halfedge_index h)
{
  if constexpr(Internals<Triangulation>::has_precise_numbers)
    return Internals<Triangulation>::precise_halfedge(triangulation, h);
  else
    return Precise_halfedge(input_face_geometry(triangulation, h, Precise_face_traits())[0]);
}

/*
 * An intrinsic edge between input vertices as a double-double vector in the frame of its tail's reference, which is the
 * input halfedge that bounds its first face clockwise or along which it runs. The head's reference is that of the
 * reverse direction. Errors are relative, and infinite if there is no bound.
 */
struct Precise_edge
{
  Double_double_vector end;
  Double_double_vector head_direction; // of the head's reference, in the frame of the tail's
  double length = 0;                   // of `end`
  double end_error = std::numeric_limits<double>::infinity();
  double direction_error = std::numeric_limits<double>::infinity();
  Input_halfedge_index tail_reference = null_index, head_reference = null_index;
  Index first_corner = 0; // 1 if it runs along its references: turns around an end then start one corner farther

  bool has_bound() const { return end_error < 1; }

  /* Returns the reverse direction. */
  Precise_edge reversed() const
  {
    const Double_double_vector direction = conj(head_direction);
    return {
        -(end * direction), direction,      length,         end_error + direction_error + double_double_vector_error,
        direction_error,    head_reference, tail_reference, first_corner};
  }
};

/* Returns the input halfedge h as an edge, given any side of it. */
inline Precise_edge precise_input_edge(Input_halfedge_index h, const Precise_halfedge& side)
{
  return {{side.length, {}}, {{-1, 0}, {}}, side.length.high, side.error, 0, h, twin_index(h), 1};
}

/*
 * Unfolds input faces in double-double arithmetic, for a `Face_strip`. The error of a position is little more than the
 * number of faces times 2^-97 of the length of the path to it.
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

  /* Returns the sides of the face of h in a plane in which h has a given direction. */
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

  /* The distance before the sum is at most the sum of the distance after it and the length of the side. */
  static Corner step(const Corner& from, const Side& side)
  {
    const Double_double_vector position = from.position + side.length * side.direction;
    const double way = side.length.high * (side.error + side.length_error + 3 * double_double_vector_error);
    return {position, (from.error + way + length(position) * double_double_vector_error) * (1 + bound_rounding)};
  }

  /* Returns the third corner of a face, computed along the shorter of the sides that lead to it. */
  static Corner apex(const Sides& sides, const Corner& right, const Corner& left, std::size_t)
  {
    return sides[1].length.high < sides[2].length.high ? step(right, sides[1]) : step(left, opposite(sides[2]));
  }

private:
  const Triangulation& m_triangulation;
};

/*
 * The double-double version of `Strip`: the input faces along an edge sequence that crosses edges from one input vertex
 * to another, unfolded from the input's coordinates.
 */
template <class Triangulation>
class Precise_strip
{
  using Layout = Layout_in_double_double<Triangulation>;

public:
  /* An end of a crossed edge; the error is absolute. */
  using Point = typename Layout::Corner;

  struct Portal
  {
    Point right, left;
  };

  Precise_strip(const Triangulation& triangulation, const Edge_sequence& sequence, bool has_portals)
  {
    if(has_portals)
      m_portals.reserve(sequence.crossed.size());
    unfold(Layout(triangulation), sequence, has_portals);
  }

  const std::vector<Portal>& portals() const { return m_portals; }
  const Precise_edge& edge() const { return m_edge; }

  /* Returns the side of the line from tail to head on which a point lies. POSITIVE is the left side. */
  Uncertain<Sign> side(const Point& p) const
  {
    const Double_double sine = (p.position * conj(m_edge.end)).y;
    const double size = length(p.position);
    const double error = m_edge.length * (p.error + 2 * size * (m_edge.end_error + double_double_vector_error));
    if(!(std::abs(sine.high) > 2 * error))
      return Uncertain<Sign>::indeterminate();
    return sine.high > 0 ? POSITIVE : NEGATIVE;
  }

private:
  void unfold(const Layout& layout, const Edge_sequence& sequence, bool has_portals)
  {
    const Input_halfedge_index reference = layout.next(layout.next(sequence.crossed.front()));
    const auto sides = layout.sides(reference, {{{1, 0}, {}}, 0, {}, 0});
    const Point tail = {{}, 0}, right = layout.step(tail, sides[0]), left = layout.step(right, sides[1]);
    Face_strip<Layout> faces(layout, reference, sides, {tail, right, left});
    faces.leave_over(1);
    faces.cross(sequence.crossed, [&](Input_halfedge_index, const Point& at_right, const Point& at_left) {
      if(has_portals)
        m_portals.push_back({at_right, at_left});
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

  std::vector<Portal> m_portals;
  Precise_edge m_edge;
};

/* Returns an edge given by its edge sequence, unfolded from the input. It has no bound if an end is an inserted
 * vertex. */
template <class Triangulation>
Precise_edge unfolded_edge(const Triangulation& triangulation, const Edge_sequence& sequence)
{
  if(triangulation.is_inserted(sequence.tail) || triangulation.is_inserted(sequence.head))
    return {};
  if(sequence.along == null_index)
    return Precise_strip<Triangulation>(triangulation, sequence, false).edge();
  const Input_halfedge_index h = sequence.along;
  const Input_halfedge_index inside = triangulation.input().is_border(h) ? twin_index(h) : h;
  return precise_input_edge(h, precise_input_halfedge(triangulation, inside));
}

/*
 * A triangle in an input face whose corners are given by weights in that face. Its sides are exact: with sides h, hn,
 * hp of the face, as in an `Exact_face`, corner 0 is the origin, corner 1 is h, and corner 2 is -hp. Lengths and
 * directions are rounded last, so that their errors do not depend on the shape of the triangle.
 */
class Exact_subface
{
public:
  /* \param length that of the first side of the face, as a halfedge with its error
   * \param weights of the three corners, counted from the first halfedge of the face */
  Exact_subface(const Exact_face& face, const Precise_halfedge& length,
                const std::array<std::array<double, 3>, 3>& weights)
    : m_radicand(face.doubled_area_squared)
    , m_face_length(length.length)
    , m_error(length.error)
  {
    std::array<std::array<Integer, 3>, 3> w;
    std::array<Integer, 3> sums;
    for(std::size_t i = 0; i < 3; ++i) {
      w[i] = integer_weights(weights[i]);
      sums[i] = w[i][0] + w[i][1] + w[i][2];
    }
    std::array<Integer, 3> x, y; // of the corners, times the sums of all weights
    for(std::size_t i = 0; i < 3; ++i) {
      const Integer others = sums[(i + 1) % 3] * sums[(i + 2) % 3];
      x[i] = (w[i][1] * face.squared_length - w[i][2] * face.dot_previous) * others;
      y[i] = w[i][2] * others;
    }
    set_sides(x, y);
    m_denominator = face.squared_length * (sums[0] * sums[1] * sums[2]);
  }

  /* The triangle from side i on. */
  Exact_face exact_face(std::size_t i) const
  {
    const Integer across = cross(i, i + 1);
    return {dot(i, i), dot(i, i + 1), dot(i, i + 2), across * across * m_radicand};
  }

  /* The length of side i; the error is relative, as that of `Precise_halfedge`. */
  Double_double length(std::size_t i) const
  {
    return m_face_length *
           sqrt(precise_quotient(dot(i, i) * (m_numerator * m_numerator), m_denominator * m_denominator));
  }

  /* The halfedges from side i on. A quotient, a root and a product add less than 32 u^2 to the error of the length, for
   * which `precise_direction_error` has room; directions are rounded from exact numbers. */
  std::array<Precise_halfedge, 3> precise_face(std::size_t i) const
  {
    std::array<Precise_halfedge, 3> result;
    for(std::size_t k = 0; k < 3; ++k) {
      const Double_double size = length(i + k);
      const bool is_usual = size.high > least_unscaled && size.high < greatest_unscaled;
      result[k] = {size, direction(i + k, i + k + 1), is_usual ? m_error : std::numeric_limits<double>::infinity()};
    }
    return result;
  }

  /* The vectors of the sides from side i on, in a frame in which that is on the x-axis. */
  std::array<std::array<double, 2>, 3> vectors(std::size_t i) const
  {
    std::array<std::array<double, 2>, 3> result = {{{{length(i).high, 0}}, {{0, 0}}, {{0, 0}}}};
    for(std::size_t k = 1; k < 3; ++k) {
      const Double_double_vector side = length(i + k) * direction(i, i + k);
      result[k] = {{side.x.high, side.y.high}};
    }
    return result;
  }

private:
  void set_sides(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y)
  {
    m_numerator = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      m_x[i] = x[(i + 1) % 3] - x[i];
      m_y[i] = y[(i + 1) % 3] - y[i];
      m_numerator = boost::multiprecision::gcd(m_numerator, boost::multiprecision::gcd(m_x[i], m_y[i]));
    }
    for(std::size_t i = 0; i < 3; ++i) {
      m_x[i] /= m_numerator;
      m_y[i] /= m_numerator;
    }
  }

  Integer dot(std::size_t i, std::size_t j) const
  {
    return m_x[i % 3] * m_x[j % 3] + m_y[i % 3] * m_y[j % 3] * m_radicand;
  }
  // In units of the root.
  Integer cross(std::size_t i, std::size_t j) const { return m_x[i % 3] * m_y[j % 3] - m_y[i % 3] * m_x[j % 3]; }

  // Of side j in the frame of side i, of length 1.
  Double_double_vector direction(std::size_t i, std::size_t j) const
  {
    const Integer squares = dot(i, i) * dot(j, j), along = dot(i, j), across = cross(i, j);
    const Double_double x = sqrt(precise_quotient(along * along, squares));
    const Double_double y = sqrt(precise_quotient(across * across * m_radicand, squares));
    return {along < 0 ? -x : x, across < 0 ? -y : y};
  }

  // Side i is (m_x[i] + i m_y[i] root) m_numerator / m_denominator times the first side of the face.
  std::array<Integer, 3> m_x, m_y;
  Integer m_numerator, m_denominator, m_radicand;
  Double_double m_face_length;
  double m_error;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_STRIP_H
