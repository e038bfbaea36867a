// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_FACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_FACE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/imported_number.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Does a triangulation keep what it has computed with about 100 bits? */
template <class Triangulation, class = void>
struct Keeps_precise_numbers : std::false_type
{
};

template <class Triangulation>
struct Keeps_precise_numbers<Triangulation,
                             std::void_t<decltype(std::declval<const Triangulation&>().precise_edge(Halfedge_index()))>>
  : std::true_type
{
};

/*
 * A halfedge of an input face: its length, and the direction of the next halfedge, of length 1, in the frame in which
 * its own is 1 and the face is on the upper side.
 */
struct Precise_halfedge
{
  Double_double length;
  Double_double_vector next;
  double error; // bounds that of the direction, and that of the length relative to it
};

/*
 * Lays faces out in numbers of about 106 bits, as `IntrinsicMetric::face_geometry()` asks its traits to.
 *
 * The bound of the errors, in units of u^2 = 2^-106. From points: differences are exact; a dot product of e and f errs
 * by 50 of |e| |f|, three products of 16 and two sums; a cross product by 57, as a vector, its length by another 41
 * relative to itself; lengths by 41; the product of two by 98, its reciprocal and the last product by 32 more. In all
 * |(50, 98)| + 98 + 32 < 256 = 2^8, as the cross product of the two shortest sides is no less accurate for the others.
 * From lengths: (c - a)(c + a) - b^2 for a >= b errs by 112 of a b, as |c - a| <= b; the factors of Heron's formula are
 * sums of three doubles, right up to 2, their product up to 56, its root up to 44. That makes less.
 *
 * Nothing overflows or underflows so far that it shows where lengths are between 2^-200 and 2^200: roots of what is
 * lost are below 2^-535, and the square of 2^-200 times 2^-106 is above. Other faces have no bound.
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
      const std::array<Vector_3, 3> e = {difference(p, q), difference(q, r), difference(r, p)};
      std::array<Double_double, 3> lengths, dots;
      for(int i = 0; i < 3; ++i) {
        lengths[i] = sqrt(dot(e[i], e[i]));
        dots[i] = dot(e[i], e[(i + 1) % 3]);
      }
      const int longest = index_of_longest(lengths);
      const Vector_3 n = cross(e[(longest + 1) % 3], e[(longest + 2) % 3]);
      return assembled(lengths, dots, sqrt(dot(n, n)));
    }

  private:
    using Vector_3 = std::array<Double_double, 3>;

    template <class Point_3>
    static Vector_3 difference(const Point_3& p, const Point_3& q)
    {
      return {exact_sum(imported_number(q.x()), -imported_number(p.x())),
              exact_sum(imported_number(q.y()), -imported_number(p.y())),
              exact_sum(imported_number(q.z()), -imported_number(p.z()))};
    }

    static Double_double dot(const Vector_3& u, const Vector_3& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

    static Vector_3 cross(const Vector_3& u, const Vector_3& v)
    {
      return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    }
  };

  class Construct_face_from_lengths
  {
  public:
    Face_geometry operator()(double a, double b, double c) const
    {
      return assembled({{{a, 0}, {b, 0}, {c, 0}}}, {{dot(a, b, c), dot(b, c, a), dot(c, a, b)}}, doubled_area(a, b, c));
    }

  private:
    // Of the sides with lengths a and b, one after the other.
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

/* Input halfedge h, as the triangulation keeps it, or computed. */
template <class Triangulation>
decltype(auto) precise_input_halfedge(const Triangulation& triangulation, Input_halfedge_index h)
{
  if constexpr(Keeps_precise_numbers<Triangulation>::value)
    return triangulation.precise_input_halfedge(h);
  else
    return Precise_halfedge(input_face_geometry(triangulation, h, Precise_face_traits())[0]);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_PRECISE_FACE_H
