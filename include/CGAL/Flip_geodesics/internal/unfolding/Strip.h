// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRIP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/surface/point_coordinates.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Face_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * Returns the difference of the barycentric coordinates of two points, whose weights can have any sum. The products are
 * computed with their rounding errors, so that the result is accurate however close the points are.
 */
inline std::array<double, 3> barycentric_difference(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  const auto sum_with_error = [](const std::array<double, 3>& w) {
    const Double_double a = exact_sum(w[0], w[1]), b = exact_sum(a.high, w[2]);
    return Double_double{b.high, a.low + b.low};
  };
  const Double_double from_sum = sum_with_error(from), to_sum = sum_with_error(to);
  std::array<double, 3> result;
  for(int i = 0; i < 3; ++i) {
    const Double_double product = exact_product(from[i], to_sum.high);
    const double difference = std::fma(to[i], from_sum.high, -product.high) - product.low; // [JLM13]
    result[i] =
        (difference + (unfused(to[i] * from_sum.low) - unfused(from[i] * to_sum.low))) / (from_sum.high * to_sum.high);
  }
  return result;
}

/*
 * The input faces along an edge sequence, unfolded into the plane from the input's own coordinates. The vector of an
 * edge is thus independent of the flips that led to it. The error is that of a `Layout_in_double`.
 *
 * The tail lies at the origin; the frame is that of the reference halfedge, the tail's anchor, which has the first face
 * on its left and points along the positive real axis. If the tail is an input vertex, the reference starts there; if
 * it is a point of an edge, the reference passes through it. An edge along an input halfedge refers to that halfedge.
 */
template <class Triangulation>
class Strip
{
  using Layout = Layout_in_double<Triangulation>;

public:
  using Vector = std::complex<double>;

  /// The two ends of a crossed input edge, as seen along the path.
  struct Portal
  {
    Input_halfedge_index crossed; // the input halfedge as in the sequence; its tail is on the right
    Vector right, left;
    double right_error, left_error; // bounds
  };

  /// A corner of an unfolded face, with a bound on its error.
  using Corner = typename Layout::Corner;

  Strip(const Triangulation& triangulation, const Edge_sequence& sequence)
    : m_triangulation(&triangulation)
  {
    m_reference = tail_anchor(triangulation, sequence);
    if(sequence.along != null_index)
      lay_out_edge(sequence);
    else if(sequence.crossed.empty())
      lay_out_inside(sequence);
    else
      unfold(sequence);
  }

  Input_halfedge_index reference() const { return m_reference; }

  /*
   * Returns the corners of the face between portals i - 1 and i as positions of the tails of h, next(h) and
   * previous(h), where h is the halfedge across which the face is left, or entered if it is the last. \pre there is a
   * portal
   */
  std::array<Corner, 3> face(std::size_t i) const
  {
    const bool is_last = i == m_portals.size();
    const Portal& portal = m_portals[is_last ? i - 1 : i];
    const Corner right = {portal.right, portal.right_error}, left = {portal.left, portal.left_error};
    if(is_last)
      return {left, right, m_last_corner};
    if(i == 0)
      return {right, left, m_first_corner};
    const Portal& before = m_portals[i - 1];
    const bool is_right_kept = portal.crossed == m_triangulation->input().next(twin_index(before.crossed));
    return {right, left,
            is_right_kept ? Corner{before.left, before.left_error} : Corner{before.right, before.right_error}};
  }
  const std::vector<Portal>& portals() const { return m_portals; }
  const Vector& end() const { return m_end; }
  double end_error() const { return m_error; }

  /* Returns the reference of the edge's reverse direction, and below a vector along that direction in the reference's
   * frame; the reference is `null_index` if an end of the edge is an inserted vertex. */
  Input_halfedge_index arrival_reference() const { return m_arrival_reference; }
  const Vector& arrival() const { return m_arrival; }

  double length() const { return std::abs(m_end); }

  /* Returns a bound on the error of arrival(), relative to its length: that of end(), and of the last face's
   * rotation. */
  double arrival_error() const
  {
    return relative_error() + static_cast<double>(m_portals.size() + 3) * face_ratio_error;
  }

  /* Returns a bound on the error of end(), relative to its length; infinite if the error is at least half that
   * length. */
  double relative_error() const
  {
    const double length = std::abs(m_end);
    return length > 2 * m_error ? m_error / (length - m_error) : std::numeric_limits<double>::infinity();
  }

  /*
   * Returns the largest angle by which an end of a crossed edge lies on the wrong side of the straight line from tail
   * to head, seen from the nearer end of that line: zero if the line stays inside the strip.
   */
  double bend() const
  {
    double result = 0;
    for(const Portal& portal : m_portals)
      result = (std::max)({result, wrong_side_angle(portal.left), wrong_side_angle(std::conj(portal.right), true)});
    return result;
  }

  /* Returns the position at which the straight line crosses portal i, from 0 at the right end to 1 at the left end. */
  double crossing(std::size_t i) const
  {
    const double right = (std::max)(-cross(m_end, m_portals[i].right), 0.0);
    const double left = (std::max)(cross(m_end, m_portals[i].left), 0.0);
    return right + left > 0 ? right / (right + left) : 0.5;
  }

  /* Returns the position at which portal i crosses the straight line, from 0 at the tail to 1 at the head. */
  double crossing_along(std::size_t i) const
  {
    const Vector right = m_portals[i].right, portal = m_portals[i].left - right;
    const double whole = cross(m_end, portal);
    return whole > 0 ? (std::min)((std::max)(cross(right, portal) / whole, 0.0), 1.0) : 0.5;
  }

private:
  double wrong_side_angle(const Vector& p, bool is_mirrored = false) const
  {
    const Vector end = is_mirrored ? std::conj(m_end) : m_end;
    const double doubled_area = cross(end, p);
    if(doubled_area >= 0)
      return 0;
    const double height = doubled_area / std::abs(end);
    const double base = (std::min)(std::abs(p), std::abs(p - end));
    return base > 0 ? std::asin((std::min)(-height / base, 1.0)) : 0;
  }

  void lay_out_edge(const Edge_sequence& sequence)
  {
    const Input_halfedge_index h = sequence.along;
    m_error = 0; // the direction is exact
    m_end = m_triangulation->metric().length(m_triangulation->input(), h);
    if(m_triangulation->is_inserted(sequence.tail) || m_triangulation->is_inserted(sequence.head)) {
      m_end *= barycentric_difference(weights(sequence.tail, h), weights(sequence.head, h))[1];
    } else {
      m_arrival_reference = twin_index(h);
      m_arrival = m_end;
    }
  }

  // Computed from weights of both ends in one face, so that the ends may be close together.
  void lay_out_inside(const Edge_sequence& sequence)
  {
    const Face_vectors face = first_face();
    const auto d = barycentric_difference(weights(sequence.tail, m_reference), weights(sequence.head, m_reference));
    m_end = unfused(d[1] * face[0]) - unfused(d[2] * face[2]);
    m_error = face_ratio_error * (std::abs(d[1]) * std::abs(face[0]) + std::abs(d[2]) * std::abs(face[2]));
  }

  Face_vectors first_face() const
  {
    return Layout(*m_triangulation)
        .sides(m_reference, m_triangulation->metric().length(m_triangulation->input(), m_reference));
  }

  std::array<double, 3> weights(Vertex_index v, Input_halfedge_index h) const
  {
    return vertex_weights(*m_triangulation, v, h);
  }

  // The corners of the first face relative to the tail of the edge sequence: the tails of the reference and of the next
  // and the previous halfedge.
  std::array<Corner, 3> first_corners(const Edge_sequence& sequence, const Face_vectors& f) const
  {
    if(!m_triangulation->is_inserted(sequence.tail)) {
      const double error = face_ratio_error * std::abs(f[0]);
      return {{{0, 0}, {f[0], error}, {f[0] + f[1], error + face_ratio_error * std::abs(f[1])}}};
    }
    return Layout::corners(f, weights(sequence.tail, m_reference));
  }

  void unfold(const Edge_sequence& sequence)
  {
    const Face_vectors sides = first_face();
    const std::array<Corner, 3> first = first_corners(sequence, sides);
    Face_strip<Layout> faces(Layout(*m_triangulation), m_reference, sides, first);
    const int side = faces.number_of(sequence.crossed.front());
    faces.leave_over(side);
    m_first_corner = first[(side + 2) % 3];
    m_portals.resize(sequence.crossed.size());
    Portal* here = m_portals.data();
    faces.cross(sequence.crossed, [&](Input_halfedge_index crossed, const Corner& right, const Corner& left) {
      *here++ = {crossed, right.position, left.position, right.error, left.error};
    });
    m_last_corner = faces.corners()[2];
    if(m_triangulation->is_inserted(sequence.head))
      return end_in_face(weights(sequence.head, faces.halfedge()), faces.sides(),
                         Layout::turn_error(sequence.crossed.size()));
    m_end = m_last_corner.position;
    m_error = m_last_corner.error;
    if(!m_triangulation->is_inserted(sequence.tail)) {
      m_arrival_reference = faces.side(2);
      m_arrival = product(-m_end, std::conj(faces.sides()[2]));
    }
  }

  // A point of the last face, computed from the nearer end of the last portal.
  void end_in_face(const std::array<double, 3>& w, const Face_vectors& face, double turn_error)
  {
    const double sum = w[0] + w[1] + w[2], at_left = w[0] / sum, at_right = w[1] / sum, at_apex = w[2] / sum;
    const Portal& portal = m_portals.back();
    const double from_right = unfused(at_left * std::abs(face[0])) + unfused(at_apex * std::abs(face[1]));
    const double from_left = unfused(at_right * std::abs(face[0])) + unfused(at_apex * std::abs(face[2]));
    if(from_right < from_left) {
      m_end = portal.right + unfused(at_apex * face[1]) - unfused(at_left * face[0]);
      m_error = portal.right_error + turn_error * from_right;
    } else {
      m_end = portal.left + unfused(at_right * face[0]) - unfused(at_apex * face[2]);
      m_error = portal.left_error + turn_error * from_left;
    }
    m_error += face_ratio_error * std::abs(m_end);
  }

  const Triangulation* m_triangulation;
  Input_halfedge_index m_reference = null_index, m_arrival_reference = null_index;
  std::vector<Portal> m_portals;
  Corner m_first_corner = {0, 0}, m_last_corner = {0, 0}; // of the first and last face, not on a portal
  Vector m_end, m_arrival;
  double m_error = 0;
};

/* Returns the number of corners clockwise from one outgoing halfedge of a vertex to another, all of them if the two are
 * the same; -1 if the border intervenes. */
template <class Input_mesh>
Index number_of_corners_clockwise(const Input_mesh& input, Input_halfedge_index from, Input_halfedge_index to)
{
  Index result = 0;
  Input_halfedge_index h = from;
  do {
    if(input.is_border(twin_index(h)))
      return -1;
    h = clockwise_of(input, h);
    ++result;
  } while(h != to);
  return result;
}

/* Calls visit(t) for `number` corners clockwise from outgoing halfedge h of a vertex; t is the halfedge of the corner's
 * face that ends at the vertex. */
template <class Input_mesh, class Visit>
void for_each_corner_clockwise(const Input_mesh& input, Input_halfedge_index h, Index number, const Visit& visit)
{
  for(Index i = 0; i < number; ++i) {
    visit(twin_index(h));
    h = clockwise_of(input, h);
  }
}

/* A sum of angles between 0 and pi, given as complex numbers: their product, and the number of half turns lost in
 * it. */
class Angle_sum
{
public:
  void add(const std::complex<double>& corner)
  {
    const double x = unfused(m_x * corner.real()) - unfused(m_y * corner.imag());
    const double y = unfused(m_x * corner.imag()) + unfused(m_y * corner.real());
    const double scale = 1 / (std::abs(x) + std::abs(y));
    const bool is_past_straight = y < 0 || (y == 0 && x < 0);
    m_half_turns += is_past_straight ? 1 : 0;
    m_x = is_past_straight ? -x * scale : x * scale;
    m_y = std::abs(y) * scale;
  }

  double value() const { return unfused(m_half_turns * boost::math::constants::pi<double>()) + std::atan2(m_y, m_x); }

  /* Returns the rotation by the sum, scaled. */
  std::complex<double> rotation() const
  {
    return m_half_turns % 2 == 0 ? std::complex<double>(m_x, m_y) : std::complex<double>(-m_x, -m_y);
  }

private:
  double m_x = 1, m_y = 0; // with an angle of at least 0 and below pi
  int m_half_turns = 0;
};

/* Returns the sum of `number` input corners clockwise from input halfedge h around an input vertex. */
template <class Triangulation>
Angle_sum sum_of_input_corners(const Triangulation& triangulation, Input_halfedge_index h, Index number)
{
  Angle_sum sum;
  for_each_corner_clockwise(triangulation.input(), h, number,
                            [&](Input_halfedge_index t) { sum.add(input_corner_vector(triangulation, t)); });
  return sum;
}

/* An angle, in radians, and a bound on its error. */
struct Wedge_angle
{
  double value;
  double error;

  /* EQUAL if the error hides the result. */
  Comparison_result compare_with_straight() const
  {
    const double pi = boost::math::constants::pi<double>();
    if(!(std::abs(value - pi) > error))
      return EQUAL;
    return value < pi ? SMALLER : LARGER;
  }
};

/* Returns the angle of an edge from its reference halfedge: between 0 and pi, up to rounding, which can turn pi into
 * -pi. */
inline double angle_from_reference(const std::complex<double>& end)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const double angle = std::arg(end);
  return angle < -pi / 2 ? angle + 2 * pi : angle;
}

/* An angle and a complex number of any length that rotates by it, computed only by operations that IEEE 754 rounds
 * correctly. */
struct Wedge_rotation
{
  Wedge_angle angle;
  std::complex<double> rotation;
};

/* Two straight lines from one vertex, given by their edge sequences, and the number of input corners clockwise between
 * their references. */
struct Wedge_edge_sequences
{
  Edge_sequence from, to;
  Index steps;
};

/* Bounds the error from those of the strips at both ends, relative to their lengths, and `steps` corners in between. */
inline double error_of_wedge_angle(double from, double to, Index steps)
{
  return 1.6 * (from + to) + static_cast<double>(steps + 4) * input_corner_error; // including the arc sine
}

/* The angle counterclockwise from a halfedge of the input to the straight line of an edge sequence that starts at the
 * same vertex, and a bound on its error. Only at vertices of the input. */
struct Edge_sequence_angle
{
  Input_halfedge_index reference = null_index;
  double angle = 0;
  double error = 0;
};

/* The direction of a halfedge at its tail, computed from the input. A reference does not exist if an end of its edge is
 * an inserted vertex. */
struct Edge_end
{
  Halfedge_index halfedge = null_index;
  Edge_sequence_angle direction;
  bool is_along = false; // whether it is an edge of the input
};

/* The measured straightness of an edge. */
struct Measured_edge
{
  Edge_end tail, head;                       // the latter of the reverse direction
  double bend = 0;                           // the angle by which the edge leaves its strip of input faces
  bool has_strip = true, is_straight = true; // the latter exact; true if not examined
};

/* At the tail of an edge sequence. */
template <class Triangulation>
Edge_sequence_angle tail_angle(const Strip<Triangulation>& strip)
{
  return {strip.reference(), angle_from_reference(strip.end()), strip.relative_error()};
}

/* Returns the angle clockwise from one straight line to another, with a number of input corners between their
 * references. */
template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, const Edge_sequence_angle& from,
                        const Edge_sequence_angle& to, Index steps)
{
  return {from.angle - to.angle + sum_of_input_corners(triangulation, from.reference, steps).value(),
          error_of_wedge_angle(from.error, to.error, steps)};
}

/* Computes the wedge between two edges from the input: `steps` input corners between their reference halfedges,
 * corrected by their strips at both ends. \pre not around a point inside a face */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, Vertex_index tail, const Strip<Triangulation>& from,
                              const Strip<Triangulation>& to, Index steps)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const bool is_on_edge = triangulation.is_inserted(tail);
  Angle_sum corners;
  if(!is_on_edge)
    corners = sum_of_input_corners(triangulation, from.reference(), steps);
  const double between = is_on_edge ? steps * pi : corners.value();
  const std::complex<double> half_turns = is_on_edge && steps % 2 != 0 ? -1 : 1;
  const double sum = angle_from_reference(from.end()) - angle_from_reference(to.end()) + between;
  return {{sum, error_of_wedge_angle(from.relative_error(), to.relative_error(), steps)},
          product(product(from.end(), std::conj(to.end())), half_turns * corners.rotation())};
}

/* Computes the wedge between two edge sequences, as above. */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, const Wedge_edge_sequences& sequences)
{
  const Strip<Triangulation> from(triangulation, sequences.from), to(triangulation, sequences.to);
  return wedge_rotation(triangulation, sequences.from.tail, from, to, sequences.steps);
}

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
 * The bound on the errors, in units of u^2 = 2^-106. From points: differences of doubles are exact, those of rational
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

    Face_geometry operator()(const std::array<Integer, 3>& squares, const Integer& denominator) const
    {
      const Squared_lengths l = {squares, denominator};
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

    static Double_double doubled_area(double a, double b, double c) // by Heron's formula
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

  using Corner = Unfolded_corner<Double_double_vector>;

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

/* Constructs chains for edge sequences and for fans of input corners. */
template <class Triangulation>
class Unfolding_chains
{
  using Kind = Unfolding_step::Kind;
  using Weights = std::array<Integer, 3>;

public:
  explicit Unfolding_chains(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_faces(triangulation)
  {
  }

  /* Returns the head of an edge sequence relative to its tail. */
  Unfolding_chain head(const Edge_sequence& sequence, bool is_conjugate) const
  {
    Unfolding_chain result;
    if(sequence.along == null_index && sequence.crossed.empty())
      result = inside_face(sequence);
    else if(sequence.along == null_index && m_triangulation.is_inserted(sequence.head))
      result = point_in_face(sequence, sequence.crossed.size(), weights(sequence.head, sequence.last_face()));
    else
      result = portal(sequence, sequence.crossed.size(), false);
    result.is_conjugate = is_conjugate;
    return result;
  }

  /* Returns an end of the crossed edge with the given number; after the last one, the apex of the last face. */
  Unfolding_chain portal(const Edge_sequence& sequence, std::size_t number, bool is_left) const
  {
    Unfolding_chain result;
    if(sequence.along == null_index)
      result = start(sequence);
    for(std::size_t i = 0; i < number && sequence.along == null_index; ++i)
      result.steps.push_back(step_across(m_triangulation.input(), m_faces, sequence.crossed, i));
    result.reads_left = is_left;
    return result;
  }

  /*
   * Returns a point of the face between portals gap - 1 and gap, by weights relative to the halfedge across which the
   * face is left, or entered if it is the last.
   */
  Unfolding_chain point(const Edge_sequence& sequence, std::size_t gap, const std::array<double, 3>& w) const
  {
    const Weights n = integer_weights(w);
    if(gap == sequence.crossed.size())
      return point_in_face(sequence, gap, n);
    const Input_halfedge_index reference = sequence.crossed[gap];
    if(gap > 0)
      return point_in_face(sequence, gap, turned(n, reference, twin_index(sequence.crossed[gap - 1])));
    const Input_halfedge_index h = tail_anchor(m_triangulation, sequence);
    const Weights v = turned(n, reference, h), from = weights(sequence.tail, h);
    Weights sum = {0, 0, 0};
    for(int i = 0; i < 3; ++i) {
      const Weights corner = corner_from_point(from, i);
      for(int k = 0; k < 3; ++k)
        sum[k] += v[i] * corner[k];
    }
    return chain_in_face(face(h), sum);
  }

  /* Returns the rotation over `count` input corners clockwise from input halfedge h. */
  Unfolding_chain corners(Input_halfedge_index h, Index count) const
  {
    Unfolding_chain result;
    for_each_corner_clockwise(m_triangulation.input(), h, count, [&](Input_halfedge_index t) {
      result.steps.push_back({Kind::CORNER, &face(t)}); // from next(t) to -t: -conj(q) up to a positive factor
    });
    return result;
  }

private:
  const Exact_face& face(Input_halfedge_index h) const { return m_faces(h); }

  Weights weights(Vertex_index v, Input_halfedge_index h) const
  {
    return integer_weights(vertex_weights(m_triangulation, v, h));
  }

  // Converts weights of a face's corners from one reference halfedge to another.
  Weights turned(const Weights& w, Input_halfedge_index from, Input_halfedge_index to) const
  {
    const int shift = side_number(m_triangulation.input(), from, to);
    return {w[shift], w[(shift + 1) % 3], w[(shift + 2) % 3]};
  }

  Unfolding_chain start(const Edge_sequence& sequence) const
  {
    const Input_halfedge_index h = tail_anchor(m_triangulation, sequence), first = sequence.crossed.front();
    const Weights w = m_triangulation.is_inserted(sequence.tail) ? weights(sequence.tail, h) : Weights{1, 0, 0};
    return chain_to_side(face(h), w, side_number(m_triangulation.input(), h, first));
  }

  // The vector between two points of one face.
  Unfolding_chain inside_face(const Edge_sequence& sequence) const
  {
    const Input_halfedge_index h = tail_anchor(m_triangulation, sequence);
    const Weights from = weights(sequence.tail, h), to = weights(sequence.head, h);
    const Integer from_sum = from[0] + from[1] + from[2], to_sum = to[0] + to[1] + to[2];
    return chain_in_face(face(h), {Integer(to[1] * from_sum - from[1] * to_sum), Integer(0),
                                   Integer(from[2] * to_sum - to[2] * from_sum)});
  }

  // By weights relative to the halfedge across which the face is entered.
  Unfolding_chain point_in_face(const Edge_sequence& sequence, std::size_t gap, const Weights& w) const
  {
    Unfolding_chain result = portal(sequence, gap, false);
    result.steps.back().kind = Kind::POINT;
    result.weights = w;
    return result;
  }

  const Triangulation& m_triangulation;
  Exact_input_faces<Triangulation> m_faces;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRIP_H
