// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_FIXED_POINT_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_FIXED_POINT_RING_H

#include <CGAL/Flip_geodesics/internal/exact/Exact_face.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

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

  /* The factor (dot + sign i sqrt(squared_root)) / divisor. */
  struct Side
  {
    Number dot, root;
  };

  explicit Fixed_point_ring(unsigned bits)
    : m_bits(bits)
  {
  }

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& divisor) const
  {
    const Integer root = rounded_root(Integer(squared_root << (2 * m_bits))) / divisor;
    return {{Integer(scaled(dot) / divisor), 1}, {sign > 0 ? root : Integer(-root), 2}};
  }

  Number integer(int n) const { return {scaled(n), 0}; }
  Number rescale(const Number& a, const Integer& /* factor */) const { return a; }
  Number times_integer(const Number& a, const Integer& n) const { return {a.middle * n, a.radius * absolute(n)}; }
  Number times_dot(const Number& a, const Side& side) const { return multiply(a, side.dot); }
  Number times_root(const Number& a, const Side& side) const { return multiply(a, side.root); }
  Number add(const Number& a, const Number& b) const { return {a.middle + b.middle, a.radius + b.radius}; }
  Number negate(const Number& a) const { return {-a.middle, a.radius}; }

  Number multiply(const Number& a, const Number& b) const
  {
    const Integer product = a.middle * b.middle;
    const Integer error = absolute(a.middle) * b.radius + absolute(b.middle) * a.radius + a.radius * b.radius;
    return {product < 0 ? Integer(-(Integer(-product) >> m_bits)) : Integer(product >> m_bits), (error >> m_bits) + 2};
  }

  Uncertain<Sign> sign(const Number& a) const
  {
    if(absolute(a.middle) > a.radius)
      return a.middle > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

private:
  Integer scaled(const Integer& n) const { return n < 0 ? Integer(-(Integer(-n) << m_bits)) : Integer(n << m_bits); }

  unsigned m_bits;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_FIXED_POINT_RING_H
