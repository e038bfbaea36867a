// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_BALL_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_BALL_RING_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

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
    double radius;
  };

  struct Complex
  {
    Float re, im;
    double radius, size; // the size not below that of re + i im, and at most twice it
  };

  /* The factor (dot + sign i sqrt(squared_root)) / divisor, and a close bound of its size. */
  struct Side
  {
    Float dot, root;
    double size;
  };

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& divisor) const
  {
    if(!(m_squared_root == squared_root && m_divisor == divisor)) {
      m_squared_root = squared_root;
      m_divisor = divisor;
      m_inverse = 1 / Float(divisor);
      m_root = root_of(squared_root) * m_inverse;
    }
    const Float x = Float(dot) * m_inverse;
    const double size = std::hypot(as_double(x), as_double(m_root));
    return {x, sign > 0 ? m_root : Float(-m_root), size * (1 + radius_rounding)};
  }

  Complex one() const { return {1, 0, 0, 1}; }
  Complex zero() const { return {0, 0, 0, 0}; }

  /* The dot of a side, and its root times n. */
  Complex combination(const Side& q, const Integer& n) const { return rounded(q.dot, q.root * Float(n), 0); }

  Complex rescale(const Complex& z, const Integer& /* factor */) const { return z; }
  Complex add(const Complex& a, const Complex& b) const
  {
    return rounded(a.re + b.re, a.im + b.im, a.radius + b.radius);
  }
  Complex negate(const Complex& z) const { return {-z.re, -z.im, z.radius, z.size}; }
  Complex conjugate(const Complex& z) const { return {z.re, -z.im, z.radius, z.size}; }

  Complex multiply(const Complex& a, const Complex& b) const
  {
    return product(a, b.re, b.im, a.size * b.radius + b.size * a.radius + a.radius * b.radius, b.size);
  }

  Complex times_side(const Complex& z, const Side& q) const
  {
    return product(z, q.dot, q.root, z.radius * q.size, q.size);
  }

  Complex times_integer(const Complex& z, const Integer& n) const
  {
    const Float factor(n);
    return rounded(z.re * factor, z.im * factor, z.radius * std::abs(as_double(factor)));
  }

  Number imaginary_part(const Complex& z) const { return {z.im, z.radius}; }

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
    const int half_exponent = static_cast<int>(highest_bit(n)) / 2;
    const Float x = boost::multiprecision::ldexp(Float(n), -2 * half_exponent); // from 1 to 4
    Float inverse = 1 / std::sqrt(x.template convert_to<double>());
    for(int bits = 50; bits < std::numeric_limits<Float>::digits; bits = 2 * bits - 2)
      inverse += boost::multiprecision::ldexp(Float(inverse * (1 - x * inverse * inverse)), -1);
    return boost::multiprecision::ldexp(Float(x * inverse), half_exponent);
  }

  static double as_double(const Float& x) { return x.template convert_to<double>(); }

  // With a radius, and rounding.
  static Complex product(const Complex& z, const Float& re, const Float& im, double radius, double size)
  {
    return rounded(z.re * re - z.im * im, z.re * im + z.im * re, radius + z.size * size * unit());
  }

  // Of the last few operations, generously.
  static double unit()
  {
    static_assert(Digits <= 290, "the radius is a double");
    static const double result = std::pow(10.0, 2 - static_cast<int>(Digits));
    return result;
  }

  // Adds rounding, and that of the radius itself. A radius too small for a double is kept from vanishing.
  static Complex rounded(const Float& re, const Float& im, double radius)
  {
    const double size = (std::abs(as_double(re)) + std::abs(as_double(im))) * (1 + radius_rounding);
    return {re, im, (radius + size * unit()) * (1 + product_radius_rounding) + (std::numeric_limits<double>::min)(),
            size};
  }

  // Of the last face: two sides of it are asked for one after the other.
  mutable Integer m_squared_root = 0, m_divisor = 0;
  mutable Float m_inverse, m_root;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_BALL_RING_H
