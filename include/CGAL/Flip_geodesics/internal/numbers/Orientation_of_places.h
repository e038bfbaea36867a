// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ORIENTATION_OF_PLACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ORIENTATION_OF_PLACES_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The sign of the determinant of the vectors from one place to N others, exactly. The predicates of CGAL's kernels give
 * the same, but include the number types that CGAL was configured with.
 *
 * The determinant is evaluated in double with a bound of its error, where nothing is rounded without; then with twice
 * the digits. What that does not decide is mostly zero. It is shown by a sum of doubles if the vectors are doubles, and
 * else by integers.
 */
template <std::size_t N>
class Orientation_of_places
{
  static_assert(N == 2 || N == 3, "in the plane or in space");

  template <class Number>
  using Matrix = std::array<std::array<Number, N>, N>;

public:
  using Place = std::array<double, N>;

  /* The first place and the N others. */
  Sign operator()(const std::array<Place, N + 1>& places) const
  {
    const Matrix<double> vectors = differences<double>(places, [](double a, double b) { return a - b; });
    const double size = error_scale(vectors), value = determinant(vectors);
    if(std::abs(value) > determinant_error * size + underflow_of_products)
      return value > 0 ? POSITIVE : NEGATIVE;
    if(has_zero_column(vectors))
      return ZERO;
    if(are_short(places))
      return sign_of(value);
    const auto precise_vectors =
        differences<Double_double>(places, [](double a, double b) { return exact_sum(a, -b); });
    const double precise_value = determinant(precise_vectors).high;
    if(std::abs(precise_value) > 8 * double_double_error * size + underflow_of_products)
      return precise_value > 0 ? POSITIVE : NEGATIVE;
    return are_doubles(precise_vectors) ? sign_of_sum(vectors) : sign_of_integer(places);
  }

  /* The same of integers. */
  static Sign of_integers(const std::array<std::array<Integer, N>, N + 1>& places)
  {
    const auto vectors =
        differences<Integer>(places, [](const Integer& a, const Integer& b) { return Integer(a - b); });
    return sign_of(determinant(vectors).sign());
  }

private:
  static Sign sign_of(double x) { return x > 0 ? POSITIVE : (x < 0 ? NEGATIVE : ZERO); }

  template <class Number, class Places, class Difference>
  static Matrix<Number> differences(const Places& places, Difference difference)
  {
    Matrix<Number> result;
    for(std::size_t i = 0; i < N; ++i)
      for(std::size_t k = 0; k < N; ++k)
        result[i][k] = difference(places[i + 1][k], places[0][k]);
    return result;
  }

  // Neither does a product of three overflow, nor does its last bit underflow.
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

  // Are they all multiples of some unit, 2^15 of them at most? Then nothing is rounded: neither differences nor, with
  // six products that are less than 2^48 each, the determinant. A large number that is added rounds to such a unit.
  static bool are_short(const std::array<Place, N + 1>& places)
  {
    double largest = 0;
    for(const Place& place : places)
      for(double x : place)
        largest = (std::max)(largest, std::abs(x));
    if(!(largest > least_unscaled && largest < greatest_unscaled))
      return false;
    const double shift = largest * short_coordinate_shift;
    for(const Place& place : places)
      for(double x : place)
        if((x + shift) - shift != x)
          return false;
    return true;
  }

  // As where all faces lie in a plane along two axes.
  static bool has_zero_column(const Matrix<double>& v)
  {
    for(std::size_t k = 0; k < N; ++k)
      if(std::all_of(v.begin(), v.end(), [k](const Place& row) { return row[k] == 0; }))
        return true;
    return false;
  }

  // Leibniz' formula, with pairs of products subtracted, as in the determinant, or added.
  template <class Number, class Operation>
  static Number sum_of_products(const Matrix<Number>& v, Operation of)
  {
    if constexpr(N == 2)
      return of(v[0][0] * v[1][1], v[0][1] * v[1][0]);
    else
      return v[0][0] * of(v[1][1] * v[2][2], v[1][2] * v[2][1]) + v[0][1] * of(v[1][2] * v[2][0], v[1][0] * v[2][2]) +
             v[0][2] * of(v[1][0] * v[2][1], v[1][1] * v[2][0]);
  }

  template <class Number>
  static Number determinant(const Matrix<Number>& v)
  {
    return sum_of_products(v, [](const Number& a, const Number& b) { return Number(a - b); });
  }

  // What errors of the determinant are relative to. Infinite where a tiny product that lost its digits may be
  // multiplied by a huge number.
  static double error_scale(const Matrix<double>& v)
  {
    Matrix<double> sizes;
    for(std::size_t i = 0; i < N; ++i)
      for(std::size_t k = 0; k < N; ++k)
        sizes[i][k] = std::abs(v[i][k]);
    for(double x : sizes[0])
      if(!(x < greatest_of_three_factors))
        return std::numeric_limits<double>::infinity();
    return sum_of_products(sizes, [](double a, double b) { return a + b; });
  }

  static Sign sign_of_sum(const Matrix<double>& v)
  {
    Exact_sum<4 * 6> sum;
    for(std::size_t i = 0; i < N; ++i) {
      const std::size_t j = (i + 1) % N, k = (i + 2) % N;
      if constexpr(N == 2) {
        sum.add_product(i == 0 ? v[0][i] : -v[0][i], v[1][j]);
      } else {
        sum.add_product(v[1][j], v[2][k], v[0][i]);
        sum.add_product(-v[1][k], v[2][j], v[0][i]);
      }
    }
    return sum.sign();
  }

  static Sign sign_of_integer(const std::array<Place, N + 1>& places)
  {
    std::array<double, N*(N + 1)> coordinates;
    for(std::size_t i = 0; i <= N; ++i)
      std::copy(places[i].begin(), places[i].end(), coordinates.begin() + static_cast<std::ptrdiff_t>(N * i));
    const auto integers = to_integers(coordinates);
    std::array<std::array<Integer, N>, N + 1> points;
    for(std::size_t i = 0; i < integers.size(); ++i)
      points[i / N][i % N] = integers[i];
    return of_integers(points);
  }
};

/* The orientation of four places in space, or of three as seen along an axis. */
using Place_in_double = std::array<double, 3>;

inline Sign orientation(const Place_in_double& p, const Place_in_double& q, const Place_in_double& r,
                        const Place_in_double& s)
{
  return Orientation_of_places<3>()({p, q, r, s});
}

inline Sign orientation_along(std::size_t axis, const Place_in_double& p, const Place_in_double& q,
                              const Place_in_double& r)
{
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  return Orientation_of_places<2>()({{{p[x], p[y]}, {q[x], q[y]}, {r[x], r[y]}}});
}

/* The coordinates of places, one after the other, as integers. */
inline void to_integers(const Place_in_double* places, std::size_t size, Integer* result)
{
  static_assert(sizeof(Place_in_double) == 3 * sizeof(double));
  to_integers(places->data(), 3 * size, result);
}

/* The vector from one place to another in double-double numbers, exactly. */
inline std::array<Double_double, 3> precise_difference(const Place_in_double& p, const Place_in_double& q)
{
  return {exact_sum(q[0], -p[0]), exact_sum(q[1], -p[1]), exact_sum(q[2], -p[2])};
}

/*
 * The vector from one place in space to another, exactly: each coordinate a double and its rounding error. The signs of
 * products are exact as well; most are seen in double.
 */
class Exact_vector
{
public:
  using Place = std::array<double, 3>;

  Exact_vector(const Place& from, const Place& to)
  {
    for(std::size_t i = 0; i < 3; ++i)
      m_coordinates[i] = exact_sum(to[i], -from[i]);
  }

  /* Products of two neither overflow, nor does their last bit underflow. What follows has this as a precondition. */
  bool has_exact_products() const
  {
    const auto is_in_range = [](double x) {
      return x == 0 || (std::abs(x) > least_of_two_factors && std::abs(x) < greatest_of_two_factors);
    };
    return std::all_of(m_coordinates.begin(), m_coordinates.end(),
                       [&](const Double_double& x) { return is_in_range(x.high) && is_in_range(x.low); });
  }

  /* A coordinate, rounded. */
  double operator[](std::size_t i) const { return m_coordinates[i].high; }

  friend Sign sign_of_dot(const Exact_vector& u, const Exact_vector& v)
  {
    const auto &a = u.m_coordinates, &b = v.m_coordinates;
    return sign_of_products<3>({{{a[0], b[0]}, {a[1], b[1]}, {a[2], b[2]}}});
  }

  /* Of a coordinate of the cross product. */
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
  // Both factors and the product of them are rounded, and then the sum.
  template <std::size_t N>
  static Sign sign_of_products(const std::array<std::array<Double_double, 2>, N>& factors)
  {
    double value = 0, size = 0;
    for(const auto& [a, b] : factors) {
      const double product = unfused(a.high * b.high);
      value += product;
      size += std::abs(product);
    }
    if(std::abs(value) > product_sum_error * size)
      return value > 0 ? POSITIVE : NEGATIVE;
    Exact_sum<8 * N> sum;
    for(const auto& [a, b] : factors)
      for(double x : {a.low, a.high})
        for(double y : {b.low, b.high})
          if(x != 0 && y != 0)
            sum.add_product(x, y);
    return sum.sign();
  }

  std::array<Double_double, 3> m_coordinates;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ORIENTATION_OF_PLACES_H
