// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_COMPLEX_PAIRS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_COMPLEX_PAIRS_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The complex numbers over a ring of exact numbers, as pairs; for `Chain_arithmetic`. */
template <class Numbers>
class Complex_pairs : public Numbers
{
public:
  using Number = typename Numbers::Number;
  using Side = typename Numbers::Side;

  struct Complex
  {
    Number re, im;
  };

  using Numbers::add;
  using Numbers::multiply;
  using Numbers::negate;
  using Numbers::Numbers;
  using Numbers::rescale;

  Complex one() const { return {this->integer(1), this->integer(0)}; }
  Complex zero() const { return {this->integer(0), this->integer(0)}; }

  /* The dot of a side, and its root times n. */
  Complex combination(const Side& q, const Integer& n) const
  {
    const Number one = this->integer(1);
    return {this->times_dot(one, q), Numbers::times_integer(this->times_root(one, q), n)};
  }

  Complex add(const Complex& a, const Complex& b) const { return {add(a.re, b.re), add(a.im, b.im)}; }
  Complex negate(const Complex& a) const { return {negate(a.re), negate(a.im)}; }
  Complex conjugate(const Complex& a) const { return {a.re, negate(a.im)}; }
  Complex rescale(const Complex& a, const Integer& n) const { return {rescale(a.re, n), rescale(a.im, n)}; }

  Complex multiply(const Complex& a, const Complex& b) const
  {
    return {add(multiply(a.re, b.re), negate(multiply(a.im, b.im))), add(multiply(a.re, b.im), multiply(a.im, b.re))};
  }

  Complex times_side(const Complex& z, const Side& q) const
  {
    return {add(this->times_dot(z.re, q), negate(this->times_root(z.im, q))),
            add(this->times_dot(z.im, q), this->times_root(z.re, q))};
  }

  Complex times_integer(const Complex& z, const Integer& n) const
  {
    return {Numbers::times_integer(z.re, n), Numbers::times_integer(z.im, n)};
  }

  Number imaginary_part(const Complex& z) const { return z.im; }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_COMPLEX_PAIRS_H
