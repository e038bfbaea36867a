// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PRECISE_NUMBER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PRECISE_NUMBER_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A double-double number for algorithms written for doubles: it is converted from a double, compared, and infinite
 * whenever a double would be. The second halves of infinite numbers are zero; `Double_double` would make them NaN, and
 * then the first halves as well.
 */
class Precise_number
{
public:
  Precise_number() = default;
  Precise_number(double number)
    : m_value{number, 0}
  {
  }
  explicit Precise_number(const Double_double& value)
    : m_value(value)
  {
  }

  /* Returns the nearest double. */
  double nearest() const { return m_value.high; }

  friend Precise_number operator-(const Precise_number& a) { return Precise_number(-a.m_value); }
  friend Precise_number operator+(const Precise_number& a, const Precise_number& b)
  {
    return finite(a.m_value + b.m_value, a.nearest() + b.nearest());
  }
  friend Precise_number operator-(const Precise_number& a, const Precise_number& b) { return a + -b; }
  friend Precise_number operator*(const Precise_number& a, const Precise_number& b)
  {
    return finite(a.m_value * b.m_value, a.nearest() * b.nearest());
  }
  friend Precise_number operator/(const Precise_number& a, const Precise_number& b)
  {
    const double quotient = a.nearest() / b.nearest();
    return std::isfinite(b.nearest()) ? finite(a.m_value / b.m_value, quotient) : Precise_number(quotient);
  }
  friend Precise_number sqrt(const Precise_number& a) { return finite(sqrt(a.m_value), a.nearest()); }
  friend Precise_number abs(const Precise_number& a) { return a < 0 ? -a : a; }

  friend bool operator<(const Precise_number& a, const Precise_number& b)
  {
    return a.m_value.high < b.m_value.high || (a.m_value.high == b.m_value.high && a.m_value.low < b.m_value.low);
  }
  friend bool operator==(const Precise_number& a, const Precise_number& b)
  {
    return a.m_value.high == b.m_value.high && a.m_value.low == b.m_value.low;
  }
  friend bool operator>(const Precise_number& a, const Precise_number& b) { return b < a; }
  friend bool operator<=(const Precise_number& a, const Precise_number& b) { return a < b || a == b; }
  friend bool operator>=(const Precise_number& a, const Precise_number& b) { return b <= a; }
  friend bool operator!=(const Precise_number& a, const Precise_number& b) { return !(a == b); }

private:
  // Returns a result or, if that is not finite, the result in doubles.
  static Precise_number finite(const Double_double& result, double in_double)
  {
    return std::isfinite(in_double) ? Precise_number(result) : Precise_number(in_double);
  }

  Double_double m_value;
};

using Precise_vector = Complex_number<Precise_number>;

/* The properties of number types required by algorithms for either kind. */
template <class Number>
struct Number_rounding;

template <>
struct Number_rounding<double>
{
  static constexpr double unit = unit_roundoff;
  static double nearest(double number) { return number; }
  static double below(double number) { return number; }
  static double above(double number) { return number; }
};

template <>
struct Number_rounding<Precise_number>
{
  // Bounds the relative errors of sides of faces (`Precise_face_traits`), and also those of 32 operations.
  static constexpr double unit = precise_direction_error;
  static double nearest(const Precise_number& number) { return number.nearest(); }

  /* Returns a double that is not larger. */
  static double below(const Precise_number& number)
  {
    return number.nearest() - 2 * Number_rounding<double>::unit * std::abs(number.nearest());
  }

  /* Returns a double that is not smaller. */
  static double above(const Precise_number& number) { return -below(-number); }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PRECISE_NUMBER_H
