// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_BALL_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_BALL_RING_H

#include <CGAL/Flip_geodesics/internal/Exact_face.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/multiprecision/mpfr.hpp>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Floating-point arithmetic of a fixed number of decimal digits, with a bound of the error carried along. */
template <unsigned Digits>
class Ball_ring
{
  using Float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<Digits>,
                                              boost::multiprecision::et_off>;

public:
  struct Number
  {
    Float middle, radius;
  };

  Number integer(const Integer& n) const { return rounded(Float(n), Float(0)); }
  Number add(const Number& a, const Number& b) const { return rounded(a.middle + b.middle, a.radius + b.radius); }
  Number negate(const Number& a) const { return {-a.middle, a.radius}; }
  Number scale(const Number& a, const Integer& n) const { return multiply(a, integer(n)); }
  Number times_root(const Number& a, const Integer& d) const { return multiply(a, rounded(boost::multiprecision::sqrt(Float(d)), Float(0))); }

  Number multiply(const Number& a, const Number& b) const
  {
    return rounded(a.middle * b.middle, boost::multiprecision::abs(a.middle) * b.radius + boost::multiprecision::abs(b.middle) * a.radius + a.radius * b.radius);
  }

  Uncertain<Sign> sign(const Number& a) const
  {
    if(boost::multiprecision::abs(a.middle) > a.radius)
      return a.middle > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

private:
  // Adds the rounding of the last operations, generously; the radius is itself rounded, by less than this adds.
  static Number rounded(const Float& middle, const Float& radius)
  {
    static const Float unit = boost::multiprecision::pow(Float(10), 2 - static_cast<int>(Digits));
    return {middle, radius * (1 + unit) + boost::multiprecision::abs(middle) * unit};
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_BALL_RING_H
