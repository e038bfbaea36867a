// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_RIGHT_ANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_RIGHT_ANGLE_H

#include <CGAL/Flip_geodesics/internal/arithmetic/Double_double.h>
#include <CGAL/Flip_geodesics/internal/exact/Orientation_of_places.h>

#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Is the angle at a place between two others right, proven? By the dot product of the vectors to them, each a double and
 * its rounding error, so that it is a sum of 12 products. Most that are not zero are seen not to be in double.
 */
inline bool is_right_angle(const std::array<double, 3>& node, const std::array<double, 3>& a,
                           const std::array<double, 3>& b)
{
  // Products of two neither overflow, nor does their last bit underflow.
  const auto has_exact_products = [](double x) { return x == 0 || (std::abs(x) > 0x1p-450 && std::abs(x) < 0x1p450); };
  std::array<Double_double, 3> u, v;
  double value = 0, size = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    u[i] = exact_sum(a[i], -node[i]);
    v[i] = exact_sum(b[i], -node[i]);
    for(double x : {u[i].high, u[i].low, v[i].high, v[i].low})
      if(!has_exact_products(x))
        return false;
    value += u[i].high * v[i].high;
    size += std::abs(u[i].high * v[i].high);
  }
  if(std::abs(value) > 0x1p-50 * size)
    return false;
  Exact_sum<24> sum;
  for(std::size_t i = 0; i < 3; ++i)
    for(double x : {u[i].low, u[i].high})
      for(double y : {v[i].low, v[i].high})
        sum.add_product(x, y);
  return sum.sign() == ZERO;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_RIGHT_ANGLE_H
