// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ORIENTATION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ORIENTATION_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

// Exact predicates of points in space, in double first.

namespace CGAL::Flip_geodesics::internal {

/*
 * Computes the exact sign of the determinant of the vectors from one place to three others. The predicates of CGAL's
 * kernels do the same, but include the number types for which CGAL was configured.
 *
 * The determinant is evaluated in double with an error bound, then in double-double arithmetic. Undecided determinants
 * are mostly zero, which a sum of doubles proves if the vectors are doubles, and integers otherwise.
 */
class Orientation_of_places
{
  template <class Number>
  using Matrix = std::array<std::array<Number, 3>, 3>;
  using Places = std::array<Place_in_space, 4>;

public:
  Sign operator()(const Places& p) const
  {
    const Matrix<double> vectors = {difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0])};
    const double size = error_scale(vectors), value = determinant(vectors);
    if(std::abs(value) > determinant_error * size + underflow_of_products)
      return value > 0 ? POSITIVE : NEGATIVE;
    if(has_zero_column(vectors))
      return ZERO;
    if(are_short(p))
      return sign_of(value);
    const Matrix<Double_double> precise_vectors = {precise_difference(p[0], p[1]), precise_difference(p[0], p[2]),
                                                   precise_difference(p[0], p[3])};
    const double precise_value = determinant(precise_vectors).high;
    if(std::abs(precise_value) > 8 * double_double_error * size + underflow_of_products)
      return precise_value > 0 ? POSITIVE : NEGATIVE;
    return are_doubles(precise_vectors) ? sign_of_sum(vectors) : of_integers(to_integers(p));
  }

  /* Computes the sign for places with integer coordinates. */
  static Sign of_integers(const std::array<std::array<Integer, 3>, 4>& p)
  {
    const Matrix<Integer> vectors = {difference(p[1], p[0]), difference(p[2], p[0]), difference(p[3], p[0])};
    return static_cast<Sign>(determinant(vectors).sign());
  }

private:
  static Sign sign_of(double x) { return x > 0 ? POSITIVE : (x < 0 ? NEGATIVE : ZERO); }

  // Returns whether a product of three such numbers neither overflows nor loses its last bit.
  static bool has_exact_products(double x)
  {
    return x == 0 || (std::abs(x) > least_of_three_factors && std::abs(x) < greatest_of_three_factors);
  }

  static bool are_doubles(const Matrix<Double_double>& vectors)
  {
    for(const auto& row : vectors)
      for(const Double_double& x : row)
        if(x.low != 0 || !has_exact_products(x.high))
          return false;
    return true;
  }

  // Returns whether all coordinates are multiples of one unit, by factors of at most 2^15. No operation is then
  // rounded: neither differences nor, with six products below 2^48, the determinant. Adding a large number rounds to
  // such a unit.
  static bool are_short(const Places& places)
  {
    double largest = 0;
    for(const Place_in_space& place : places)
      for(double x : place)
        largest = (std::max)(largest, std::abs(x));
    if(!(largest > least_unscaled && largest < greatest_unscaled))
      return false;
    const double shift = largest * short_coordinate_shift;
    for(const Place_in_space& place : places)
      for(double x : place)
        if((x + shift) - shift != x)
          return false;
    return true;
  }

  // For example, if all faces lie in a plane along two axes.
  static bool has_zero_column(const Matrix<double>& v)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(std::all_of(v.begin(), v.end(), [k](const Place_in_space& row) { return row[k] == 0; }))
        return true;
    return false;
  }

  // Leibniz' formula, with pairs of products subtracted, as in the determinant, or added.
  template <class Number, class Operation>
  static Number sum_of_products(const Matrix<Number>& v, Operation of)
  {
    return v[0][0] * of(v[1][1] * v[2][2], v[1][2] * v[2][1]) + v[0][1] * of(v[1][2] * v[2][0], v[1][0] * v[2][2]) +
           v[0][2] * of(v[1][0] * v[2][1], v[1][1] * v[2][0]);
  }

  template <class Number>
  static Number determinant(const Matrix<Number>& v)
  {
    return sum_of_products(v, [](const Number& a, const Number& b) { return Number(a - b); });
  }

  // The size to which errors of the determinant are relative; infinite if a tiny product that lost its digits may be
  // multiplied by a huge number.
  static double error_scale(const Matrix<double>& v)
  {
    Matrix<double> sizes;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t k = 0; k < 3; ++k)
        sizes[i][k] = std::abs(v[i][k]);
    for(double x : sizes[0])
      if(!(x < greatest_of_three_factors))
        return std::numeric_limits<double>::infinity();
    return sum_of_products(sizes, [](double a, double b) { return a + b; });
  }

  static Sign sign_of_sum(const Matrix<double>& v)
  {
    Exact_sum<4 * 6> sum;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum.add_product(v[1][j], v[2][k], v[0][i]);
      sum.add_product(-v[1][k], v[2][j], v[0][i]);
    }
    return sum.sign();
  }
};

/* Returns the orientation of four places in space. */
inline Sign orientation(const Place_in_space& p, const Place_in_space& q, const Place_in_space& r,
                        const Place_in_space& s)
{
  return Orientation_of_places()({p, q, r, s});
}

inline Sign orientation(const Rational_place& p, const Rational_place& q, const Rational_place& r,
                        const Rational_place& s)
{
  return Orientation_of_places::of_integers(to_integers(std::array<Rational_place, 4>{p, q, r, s}));
}

/* Returns the vector from p to q up to a positive factor, exactly: each coordinate is a double and its rounding error,
 * or an integer. */
inline std::array<Double_double, 3> exact_difference(const Place_in_space& p, const Place_in_space& q)
{
  return precise_difference(p, q);
}

inline std::array<Integer, 3> exact_difference(const Rational_place& p, const Rational_place& q)
{
  const auto ends = to_integers(std::array<Rational_place, 2>{p, q});
  return difference(ends[1], ends[0]);
}

inline double rounded_coordinate(const Double_double& a) { return a.high; }
inline double rounded_coordinate(const Integer& a) { return static_cast<double>(a); }

/* Returns whether products of two such numbers neither overflow nor lose their last bit. */
inline bool has_exact_products(const Double_double& a)
{
  const auto is_in_range = [](double x) {
    return x == 0 || (std::abs(x) > least_of_two_factors && std::abs(x) < greatest_of_two_factors);
  };
  return is_in_range(a.high) && is_in_range(a.low);
}

template <std::size_t N>
Sign sign_of_products(const std::array<std::array<Integer, 2>, N>& factors)
{
  Integer sum = 0;
  for(const auto& [a, b] : factors)
    sum += a * b;
  return static_cast<Sign>(sum.sign());
}

template <std::size_t N>
Sign sign_of_integer_products(const std::array<std::array<Double_double, 2>, N>& factors)
{
  std::array<std::array<double, 4>, N> parts;
  for(std::size_t i = 0; i < N; ++i)
    parts[i] = {factors[i][0].high, factors[i][0].low, factors[i][1].high, factors[i][1].low};
  std::array<std::array<Integer, 4>, N> n;
  to_integers(parts.front().data(), 4 * N, n.front().data());
  Integer sum = 0;
  for(const auto& [a, b, c, d] : n)
    sum += (a + b) * (c + d);
  return static_cast<Sign>(sum.sign());
}

/* Returns the exact sign of a sum of products of two. In double, both factors and each product are rounded, and then
 * the sum; a product that underflows errs by less than the smallest normal number. */
template <std::size_t N>
Sign sign_of_products(const std::array<std::array<Double_double, 2>, N>& factors)
{
  double value = 0, size = 0;
  for(const auto& [a, b] : factors) {
    const double product = unfused(a.high * b.high);
    value += product;
    size += std::abs(product);
  }
  if(std::abs(value) > product_sum_error * size + (std::numeric_limits<double>::min)())
    return value > 0 ? POSITIVE : NEGATIVE;
  Exact_sum<8 * N> sum;
  for(const auto& [a, b] : factors) {
    if(!has_exact_products(a) || !has_exact_products(b))
      return sign_of_integer_products(factors);
    for(double x : {a.low, a.high})
      for(double y : {b.low, b.high})
        if(x != 0 && y != 0)
          sum.add_product(x, y);
  }
  return sum.sign();
}

/*
 * The vector from one place in space to another, up to a positive factor. The signs of products are exact; most of them
 * are decided in double.
 */
template <class Place>
class Exact_vector
{
public:
  Exact_vector(const Place& from, const Place& to)
    : m_coordinates(exact_difference(from, to))
  {
  }

  /* Returns a coordinate, rounded; infinite if it is too large. */
  double operator[](std::size_t i) const { return rounded_coordinate(m_coordinates[i]); }

  friend Sign sign_of_dot(const Exact_vector& u, const Exact_vector& v)
  {
    const auto &a = u.m_coordinates, &b = v.m_coordinates;
    return sign_of_products<3>({{{a[0], b[0]}, {a[1], b[1]}, {a[2], b[2]}}});
  }

  /* Returns the sign of a coordinate of the cross product. */
  friend Sign sign_of_cross(const Exact_vector& u, const Exact_vector& v, std::size_t axis)
  {
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    const auto &a = u.m_coordinates, &b = v.m_coordinates;
    return sign_of_products<2>({{{a[x], b[y]}, {-a[y], b[x]}}});
  }

  friend bool are_parallel(const Exact_vector& u, const Exact_vector& v)
  {
    return sign_of_cross(u, v, 0) == ZERO && sign_of_cross(u, v, 1) == ZERO && sign_of_cross(u, v, 2) == ZERO;
  }

private:
  decltype(exact_difference(std::declval<Place>(), std::declval<Place>())) m_coordinates;
};

/* Returns the orientation of three places as seen along an axis. */
template <class Place>
Sign orientation_along(std::size_t axis, const Place& p, const Place& q, const Place& r)
{
  return sign_of_cross(Exact_vector<Place>(p, q), Exact_vector<Place>(p, r), axis);
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ORIENTATION_H
