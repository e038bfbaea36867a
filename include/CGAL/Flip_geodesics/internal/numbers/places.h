// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLACES_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

// Points in space with coordinates in double or rational ones, vectors between them, and exact predicates.

namespace CGAL::Flip_geodesics::internal {

template <class Number>
Number dot(const std::array<Number, 3>& u, const std::array<Number, 3>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& u, const std::array<Number, 3>& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/* Returns the vector from v to u. */
template <class Number>
std::array<Number, 3> difference(const std::array<Number, 3>& u, const std::array<Number, 3>& v)
{
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

using Place_in_space = std::array<double, 3>;

/* The bounding box of places; at first that of none. */
struct Bounding_box
{
  void add(const Place_in_space& p)
  {
    for(std::size_t k = 0; k < 3; ++k) {
      low[k] = (std::min)(low[k], p[k]);
      high[k] = (std::max)(high[k], p[k]);
    }
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Place_in_space low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
};

/* A point with rational coordinates, which have a common denominator. It is positive. */
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
 * The squared lengths of the sides of a face as rational numbers with a common denominator. The lengths, the dot
 * product of each side with the next one and twice the area are computed from them in double-double arithmetic; each is
 * exact except for the rounding of a quotient and of a root.
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

  /* The square of four times the area, in units of the square of the denominator, by Heron's formula. */
  Integer quadrupled_area_squared() const
  {
    const Integer dot = doubled_dot(0);
    return 4 * numerators[0] * numerators[1] - dot * dot;
  }

  bool satisfy_triangle_inequality() const { return quadrupled_area_squared() >= 0; }

private:
  Integer doubled_dot(std::size_t i) const { return numerators[(i + 2) % 3] - numerators[i] - numerators[(i + 1) % 3]; }
};

/* Converts the coordinates of points to integers, in one unit. */
inline void to_integers(const Place_in_space* places, std::size_t size, std::array<Integer, 3>* result)
{
  static_assert(sizeof(Place_in_space) == 3 * sizeof(double) && sizeof(*result) == 3 * sizeof(Integer));
  to_integers(places->data(), 3 * size, result->data());
}

inline void to_integers(const Rational_place* places, std::size_t size, std::array<Integer, 3>* result)
{
  Integer common = 1;
  for(std::size_t i = 0; i < size; ++i)
    if(places[i].denominator != common)
      common = boost::multiprecision::lcm(common, places[i].denominator);
  for(std::size_t i = 0; i < size; ++i) {
    const Integer factor = common / places[i].denominator;
    for(std::size_t k = 0; k < 3; ++k)
      result[i][k] = places[i].numerators[k] * factor;
  }
}

template <class Place, std::size_t N>
std::array<std::array<Integer, 3>, N> to_integers(const std::array<Place, N>& places)
{
  std::array<std::array<Integer, 3>, N> result;
  to_integers(places.data(), N, result.data());
  return result;
}

/* Returns the vector from p to q in double-double arithmetic, exactly. */
inline std::array<Double_double, 3> precise_difference(const Place_in_space& p, const Place_in_space& q)
{
  return {exact_sum(q[0], -p[0]), exact_sum(q[1], -p[1]), exact_sum(q[2], -p[2])};
}

/* Returns the vector from p to q in double-double arithmetic, with the errors of precise_quotient(). */
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

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLACES_H
