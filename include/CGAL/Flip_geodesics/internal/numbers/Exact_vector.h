// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_EXACT_VECTOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_EXACT_VECTOR_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Orientation_of_places.h>
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_EXACT_VECTOR_H
