// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_FIXED_POINT_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_FIXED_POINT_RING_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Arithmetic in multiples of 2^-bits, with a bound of the error carried along; any number of bits will do, so that what
 * is not zero has a sign in the end. Strips are not scaled.
 */
class Fixed_point_ring
{
public:
  struct Number
  {
    Integer middle, radius;
  };

  struct Complex
  {
    Integer re, im, radius;
  };

  /* The factor (dot + sign i sqrt(squared_root)) / divisor, off by `side_radius` at most, and a close bound of its size. */
  struct Side
  {
    Integer dot, root, size;
  };
  static constexpr int side_radius = 3;

  explicit Fixed_point_ring(unsigned bits)
    : m_bits(bits)
  {
  }

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& divisor) const
  {
    const Integer x = scaled(dot) / divisor, root = rounded_root(Integer(squared_root << (2 * m_bits))) / divisor;
    return {x, sign > 0 ? root : Integer(-root), size_of(x, root)};
  }

  Complex one() const { return {scaled(1), 0, 0}; }
  Complex zero() const { return {0, 0, 0}; }

  /* The dot of a side, and its root times n. */
  Complex combination(const Side& q, const Integer& n) const
  {
    return {q.dot, q.root * n, side_radius * (absolute(n) + 1)};
  }

  Complex rescale(const Complex& z, const Integer& /* factor */) const { return z; }
  Complex add(const Complex& a, const Complex& b) const { return {a.re + b.re, a.im + b.im, a.radius + b.radius}; }
  Complex negate(const Complex& z) const { return {-z.re, -z.im, z.radius}; }
  Complex conjugate(const Complex& z) const { return {z.re, -z.im, z.radius}; }

  Complex multiply(const Complex& a, const Complex& b) const
  {
    const Integer of_a = absolute(a.re) + absolute(a.im), of_b = absolute(b.re) + absolute(b.im);
    return product(a, b.re, b.im, of_a * b.radius + of_b * a.radius + a.radius * b.radius);
  }

  Complex times_side(const Complex& z, const Side& q) const
  {
    const Integer of_z = absolute(z.re) + absolute(z.im);
    return product(z, q.dot, q.root, (of_z + z.radius) * side_radius + q.size * z.radius);
  }

  Complex times_integer(const Complex& z, const Integer& n) const
  {
    return {z.re * n, z.im * n, z.radius * absolute(n)};
  }

  Number imaginary_part(const Complex& z) const { return {z.im, z.radius}; }

  Uncertain<Sign> sign(const Number& a) const
  {
    if(absolute(a.middle) > a.radius)
      return a.middle > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

private:
  // With the radius of what is not rounded yet.
  Complex product(const Complex& z, const Integer& re, const Integer& im, const Integer& radius) const
  {
    return {rounded(z.re * re - z.im * im), rounded(z.re * im + z.im * re), (radius >> m_bits) + 3};
  }

  // A bound of the size, above it by a part in 10^12 at most, and a little.
  static Integer size_of(const Integer& x, const Integer& y)
  {
    constexpr int digits = 60;
    const Integer larger = (std::max)(absolute(x), absolute(y));
    const int excess = larger == 0 ? 0 : static_cast<int>(larger.highest_bit()) - digits;
    const unsigned shift = excess > 0 ? static_cast<unsigned>(excess) : 0;
    const double size =
        std::hypot(static_cast<double>(absolute(x) >> shift), static_cast<double>(absolute(y) >> shift));
    return Integer(std::ceil(size * (1 + radius_rounding)) + 2) << shift;
  }

  Integer scaled(const Integer& n) const { return n < 0 ? Integer(-(Integer(-n) << m_bits)) : Integer(n << m_bits); }

  // Towards zero.
  Integer rounded(const Integer& n) const { return n < 0 ? Integer(-(Integer(-n) >> m_bits)) : Integer(n >> m_bits); }

  unsigned m_bits;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_FIXED_POINT_RING_H
