// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_RATIONAL_PLACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_RATIONAL_PLACES_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Orientation_of_places.h>
#include <CGAL/Flip_geodesics/internal/numbers/Rational_number.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A point with rational coordinates, on a common denominator, which is positive. */
struct Rational_place
{
  std::array<Integer, 3> numerators;
  Integer denominator;
};

inline Rational_place rational_place(const Rational& x, const Rational& y, const Rational& z)
{
  if(x.denominator == y.denominator && x.denominator == z.denominator)
    return {{x.numerator, y.numerator, z.numerator}, x.denominator};
  const Integer common =
      boost::multiprecision::lcm(boost::multiprecision::lcm(x.denominator, y.denominator), z.denominator);
  const auto scaled = [&](const Rational& a) { return Integer(a.numerator * (common / a.denominator)); };
  return {{scaled(x), scaled(y), scaled(z)}, common};
}

/*
 * The squared lengths of the sides of a face as rational numbers on a common denominator, and what follows from them in
 * double-double numbers: the lengths, the dot product of each side with the next one, and twice the area. Each is exact
 * but for the rounding of a quotient, and of a root.
 */
struct Squared_lengths
{
  std::array<Integer, 3> numerators;
  Integer denominator;

  Double_double length(std::size_t i) const { return internal::sqrt(precise_quotient(numerators[i], denominator)); }

  Double_double dot(std::size_t i) const { return precise_quotient(doubled_dot(i), 2 * denominator); }

  Double_double doubled_area() const
  {
    return internal::sqrt(precise_quotient(quadrupled_area_squared(), 4 * denominator * denominator));
  }

  /* The square of four times the area, in units of the square of the denominator. [Heron] */
  Integer quadrupled_area_squared() const
  {
    const Integer dot = doubled_dot(0);
    return 4 * numerators[0] * numerators[1] - dot * dot;
  }

  bool satisfy_triangle_inequality() const { return quadrupled_area_squared() >= 0; }

private:
  Integer doubled_dot(std::size_t i) const { return numerators[(i + 2) % 3] - numerators[i] - numerators[(i + 1) % 3]; }
};

/* The coordinates of points, one after the other, in a unit that makes them integers. */
inline void to_integers(const Rational_place* places, std::size_t size, Integer* result)
{
  Integer common = 1;
  for(std::size_t i = 0; i < size; ++i)
    if(places[i].denominator != common)
      common = boost::multiprecision::lcm(common, places[i].denominator);
  for(std::size_t i = 0; i < size; ++i) {
    const Integer factor = common / places[i].denominator;
    for(const Integer& n : places[i].numerators)
      *result++ = n * factor;
  }
}

/* The vector from one point to another, in double-double numbers with the errors of precise_quotient(). */
inline std::array<Double_double, 3> precise_difference(const Rational_place& p, const Rational_place& q)
{
  std::array<Double_double, 3> result;
  if(p.denominator == q.denominator) {
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = precise_quotient(q.numerators[i] - p.numerators[i], p.denominator);
  } else {
    const Integer common = p.denominator * q.denominator;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = precise_quotient(q.numerators[i] * p.denominator - p.numerators[i] * q.denominator, common);
  }
  return result;
}

/* The orientation of four places in space, or of three as seen along an axis. */
inline Sign orientation(const Rational_place& p, const Rational_place& q, const Rational_place& r,
                        const Rational_place& s)
{
  const std::array<Rational_place, 4> places = {p, q, r, s};
  std::array<std::array<Integer, 3>, 4> points;
  to_integers(places.data(), places.size(), points.front().data());
  return Orientation_of_places<3>::of_integers(points);
}

inline Sign orientation_along(std::size_t axis, const Rational_place& p, const Rational_place& q,
                              const Rational_place& r)
{
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  const std::array<Rational_place, 3> places = {p, q, r};
  std::array<std::array<Integer, 3>, 3> c;
  to_integers(places.data(), places.size(), c.front().data());
  return Orientation_of_places<2>::of_integers({{{c[0][x], c[0][y]}, {c[1][x], c[1][y]}, {c[2][x], c[2][y]}}});
}

/* The vector from one rational place to another up to a positive factor, with the members of `Exact_vector`. */
class Rational_vector
{
public:
  Rational_vector(const Rational_place& from, const Rational_place& to)
  {
    const std::array<Rational_place, 2> places = {from, to};
    std::array<std::array<Integer, 3>, 2> ends;
    to_integers(places.data(), places.size(), ends.front().data());
    for(std::size_t i = 0; i < 3; ++i)
      m_coordinates[i] = ends[1][i] - ends[0][i];
  }

  static constexpr bool has_exact_products() { return true; }

  /* A coordinate, rounded; infinite if it is too large. */
  double operator[](std::size_t i) const { return static_cast<double>(m_coordinates[i]); }

  friend Sign sign_of_dot(const Rational_vector& u, const Rational_vector& v)
  {
    const auto &a = u.m_coordinates, &b = v.m_coordinates;
    return sign_of(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  }

  /* Of a coordinate of the cross product. */
  friend Sign sign_of_cross(const Rational_vector& u, const Rational_vector& v, std::size_t axis)
  {
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    const auto &a = u.m_coordinates, &b = v.m_coordinates;
    return sign_of(a[x] * b[y] - a[y] * b[x]);
  }

  friend bool are_parallel(const Rational_vector& u, const Rational_vector& v)
  {
    return sign_of_cross(u, v, 0) == ZERO && sign_of_cross(u, v, 1) == ZERO && sign_of_cross(u, v, 2) == ZERO;
  }

private:
  static Sign sign_of(const Integer& n) { return n > 0 ? POSITIVE : (n < 0 ? NEGATIVE : ZERO); }

  std::array<Integer, 3> m_coordinates;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_RATIONAL_PLACES_H
