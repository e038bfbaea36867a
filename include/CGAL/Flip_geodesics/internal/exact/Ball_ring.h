// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_BALL_RING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_BALL_RING_H

#include <CGAL/Flip_geodesics/internal/exact/Exact_face.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/multiprecision/mpfr.hpp>

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
  using Float = boost::multiprecision::number<
      boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
      boost::multiprecision::et_off>;

public:
  struct Number
  {
    Float middle;
    double radius;
  };

  /* The factor (dot + sign i sqrt(squared_root)) / divisor. */
  struct Side
  {
    Number dot, root;
  };

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& divisor) const
  {
    const Float length = Float(divisor);
    const Float root = boost::multiprecision::sqrt(Float(squared_root)) / length;
    return {rounded(Float(dot) / length, 0), rounded(sign > 0 ? root : Float(-root), 0)};
  }

  Number integer(int n) const { return {Float(n), 0}; }
  Number rescale(const Number& a, const Integer& /* factor */) const { return a; }
  Number times_integer(const Number& a, const Integer& n) const { return multiply(a, rounded(Float(n), 0)); }
  Number times_dot(const Number& a, const Side& side) const { return multiply(a, side.dot); }
  Number times_root(const Number& a, const Side& side) const { return multiply(a, side.root); }
  Number add(const Number& a, const Number& b) const { return rounded(a.middle + b.middle, a.radius + b.radius); }
  Number negate(const Number& a) const { return {-a.middle, a.radius}; }

  Number multiply(const Number& a, const Number& b) const
  {
    return rounded(a.middle * b.middle, magnitude(a) * b.radius + magnitude(b) * a.radius + a.radius * b.radius);
  }

  Uncertain<Sign> sign(const Number& a) const
  {
    if(boost::multiprecision::abs(a.middle) > a.radius)
      return a.middle > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

private:
  static double magnitude(const Number& a) { return std::abs(a.middle.template convert_to<double>()); }

  // Adds the rounding of the last few operations, generously, and that of the radius itself. A radius too small for a
  // double is kept from vanishing.
  static Number rounded(const Float& middle, double radius)
  {
    static_assert(Digits <= 290, "the radius is a double");
    static const double unit = std::pow(10.0, 2 - static_cast<int>(Digits));
    const double size = std::abs(middle.template convert_to<double>());
    return {middle, (radius + size * unit) * (1 + 1e-12) + (std::numeric_limits<double>::min)()};
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_BALL_RING_H
