// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_BALL_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_BALL_RING_H

#include <CGAL/Flip_geodesics/internal/exact/Exact_face.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Floating-point arithmetic of a fixed number of decimal digits, with a bound of the error carried along. Strips are
 * not scaled: numbers stay as large as the ratios of edge lengths, so that doubles can hold the bounds.
 */
template <unsigned Digits>
class Ball_ring
{
  using Float =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

public:
  struct Number
  {
    Float middle;
    double radius, size; // the middle's, rounded: the conversion takes about as long as a product
  };

  /* The factor (dot + sign i sqrt(squared_root)) / divisor. */
  struct Side
  {
    Number dot, root;
  };

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& divisor) const
  {
    if(!(m_squared_root == squared_root && m_divisor == divisor)) {
      m_squared_root = squared_root;
      m_divisor = divisor;
      m_inverse = 1 / Float(divisor.number());
      m_root = root_of(squared_root) * m_inverse;
    }
    return {rounded(Float(dot.number()) * m_inverse, 0), rounded(sign > 0 ? m_root : Float(-m_root), 0)};
  }

  Number integer(int n) const { return {Float(n), 0, std::abs(static_cast<double>(n))}; }
  Number rescale(const Number& a, const Integer& /* factor */) const { return a; }
  Number times_integer(const Number& a, const Integer& n) const { return multiply(a, rounded(Float(n.number()), 0)); }
  Number times_dot(const Number& a, const Side& side) const { return multiply(a, side.dot); }
  Number times_root(const Number& a, const Side& side) const { return multiply(a, side.root); }
  Number add(const Number& a, const Number& b) const { return rounded(a.middle + b.middle, a.radius + b.radius); }
  Number negate(const Number& a) const { return {-a.middle, a.radius, a.size}; }

  Number multiply(const Number& a, const Number& b) const
  {
    return rounded(a.middle * b.middle, a.size * b.radius + b.size * a.radius + a.radius * b.radius);
  }

  Uncertain<Sign> sign(const Number& a) const
  {
    if(boost::multiprecision::abs(a.middle) > a.radius)
      return a.middle > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

private:
  // By Newton's method for the inverse of the root, without a division. Boost's own root finds one bit at a time.
  static Float root_of(const Integer& n)
  {
    if(n == 0)
      return 0;
    const int half_exponent = static_cast<int>(n.highest_bit()) / 2;
    const Float x = boost::multiprecision::ldexp(Float(n.number()), -2 * half_exponent); // from 1 to 4
    Float inverse = 1 / std::sqrt(x.template convert_to<double>());
    for(int bits = 50; bits < std::numeric_limits<Float>::digits; bits = 2 * bits - 2)
      inverse += boost::multiprecision::ldexp(Float(inverse * (1 - x * inverse * inverse)), -1);
    return boost::multiprecision::ldexp(Float(x * inverse), half_exponent);
  }

  // Adds the rounding of the last few operations, generously, and that of the radius itself. A radius too small for a
  // double is kept from vanishing.
  static Number rounded(const Float& middle, double radius)
  {
    static_assert(Digits <= 290, "the radius is a double");
    static const double unit = std::pow(10.0, 2 - static_cast<int>(Digits));
    const double size = std::abs(middle.template convert_to<double>());
    return {middle, (radius + size * unit) * (1 + 1e-12) + (std::numeric_limits<double>::min)(), size};
  }

  // Of the last face: two sides of it are asked for one after the other.
  mutable Integer m_squared_root = 0, m_divisor = 0;
  mutable Float m_inverse, m_root;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_BALL_RING_H
