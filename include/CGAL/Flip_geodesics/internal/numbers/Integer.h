// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/number.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <type_traits>

namespace CGAL {

template <typename ET>
class Lazy_exact_nt;

namespace Flip_geodesics::internal {

/*
 * Boost's integers, which need no other library. CGAL/boost_mp.h, which declares them to CGAL, includes GMP where CGAL
 * was configured with it; therefore functions of CGAL for numbers, such as an unqualified abs(), are not called with
 * them.
 */
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

inline Integer absolute(const Integer& n) { return boost::multiprecision::abs(n); }

/* Returns the position of the highest bit that is set; below, that of the lowest one. \pre not zero */
inline unsigned highest_bit(const Integer& n) { return static_cast<unsigned>(msb(absolute(n))); }
inline unsigned lowest_bit(const Integer& n) { return static_cast<unsigned>(lsb(absolute(n))); }

/*
 * An input face in exact numbers, up to one positive factor: with the face's halfedges h, hn, hp as complex numbers in
 * any frame, hn / h = (dot_next + i sqrt(doubled_area_squared)) / squared_length, and
 * hp / h = (dot_previous - i sqrt(doubled_area_squared)) / squared_length.
 */
struct Exact_face
{
  Integer squared_length, dot_next, dot_previous, doubled_area_squared;
};

/* Converts doubles to integers with a common power of two taken out. */
inline void to_integers(const double* numbers, std::size_t size, Integer* result)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  int smallest = (std::numeric_limits<int>::max)(), exponent;
  for(std::size_t i = 0; i < size; ++i)
    if(std::frexp(numbers[i], &exponent) != 0)
      smallest = (std::min)(smallest, exponent);
  for(std::size_t i = 0; i < size; ++i) {
    const double mantissa = std::frexp(numbers[i], &exponent);
    result[i] = static_cast<long long>(std::ldexp(mantissa, digits));
    if(mantissa != 0)
      result[i] <<= static_cast<unsigned long>(exponent - smallest);
  }
}

template <std::size_t N>
std::array<Integer, N> to_integers(const std::array<double, N>& numbers)
{
  std::array<Integer, N> result;
  to_integers(numbers.data(), N, result.data());
  return result;
}

/* Returns the weights of a point as integers without a common factor. */
inline std::array<Integer, 3> integer_weights(const std::array<double, 3>& weights)
{
  std::array<Integer, 3> result = to_integers(weights);
  const Integer common = boost::multiprecision::gcd(boost::multiprecision::gcd(result[0], result[1]), result[2]);
  for(Integer& weight : result)
    weight /= common;
  return result;
}

/* Returns the face with these squared lengths. They are doubled, so that half sums are integers: |hp|^2 = |h + hn|^2
 * and |hn|^2 = |h + hp|^2. */
inline Exact_face exact_face_from_squares(const std::array<Integer, 3>& squares)
{
  const Integer a = 2 * squares[0], b = 2 * squares[1], c = 2 * squares[2];
  Exact_face face = {a, (c - a - b) / 2, (b - a - c) / 2, 0};
  face.doubled_area_squared = a * b - face.dot_next * face.dot_next;
  return face;
}

inline Exact_face exact_face_from_lengths(const std::array<double, 3>& lengths)
{
  const auto [a, b, c] = to_integers(lengths);
  return exact_face_from_squares({a * a, b * b, c * c});
}

/* The ways of reading the exact value of a number. */
enum class Rational_kind {
  NONE,     // it is a double, or has no value that is known to be rational
  LAZY,     // by the number type that evaluates it
  INTEGER,  // it is one
  FRACTION, // by CGAL's traits
  BOOST     // by the functions of Boost.Multiprecision
};

template <class NT>
constexpr bool is_lazy_number = false;
template <class ET>
constexpr bool is_lazy_number<Lazy_exact_nt<ET>> = true;

template <class NT>
constexpr bool is_exact_integer()
{
  using Structure = Algebraic_structure_traits<NT>;
  using Category = typename Structure::Algebraic_category;
  return Structure::Is_exact::value && std::is_convertible<Category, Euclidean_ring_tag>::value &&
         !std::is_convertible<Category, Field_tag>::value;
}

/* Returns whether all operations of a number type are exact, including division. */
template <class NT>
constexpr bool is_exact_field()
{
  using Structure = Algebraic_structure_traits<NT>;
  if constexpr(std::is_arithmetic<NT>::value)
    return false;
  else if constexpr(boost::multiprecision::is_number<NT>::value)
    return boost::multiprecision::number_category<NT>::value == boost::multiprecision::number_kind_rational;
  else
    return Structure::Is_exact::value && std::is_convertible<typename Structure::Algebraic_category, Field_tag>::value;
}

template <class NT>
constexpr Rational_kind rational_kind()
{
  if constexpr(std::is_arithmetic<NT>::value)
    return std::is_integral<NT>::value && !is_within_double<NT> ? Rational_kind::INTEGER : Rational_kind::NONE;
  else if constexpr(boost::multiprecision::is_number<NT>::value)
    return boost::multiprecision::number_category<NT>::value == boost::multiprecision::number_kind_rational
               ? Rational_kind::BOOST
               : (boost::multiprecision::number_category<NT>::value == boost::multiprecision::number_kind_integer
                      ? Rational_kind::INTEGER
                      : Rational_kind::NONE);
  else if constexpr(is_lazy_number<NT>)
    return rational_kind<typename NT::ET>() != Rational_kind::NONE ? Rational_kind::LAZY : Rational_kind::NONE;
  else if constexpr(Fraction_traits<NT>::Is_fraction::value)
    return is_exact_integer<typename Fraction_traits<NT>::Numerator_type>() ? Rational_kind::FRACTION
                                                                            : Rational_kind::NONE;
  else
    return is_exact_integer<NT>() ? Rational_kind::INTEGER : Rational_kind::NONE;
}

/* Whether the exact value of every number of a type can be read as a rational number, which need not be a double. */
template <class NT>
inline constexpr bool is_rational_number = rational_kind<NT>() != Rational_kind::NONE;

/* An integer of another number type. */
template <class NT>
Integer to_integer(const NT& n)
{
  constexpr int digits = std::numeric_limits<double>::digits - 1;
  if constexpr(std::is_integral<NT>::value || boost::multiprecision::is_number<NT>::value) {
    return Integer(n);
  } else if(n < NT(0)) {
    return -to_integer(NT(-n));
  } else {
    const NT unit(static_cast<double>(std::uint64_t(1) << digits));
    if(n < unit)
      return Integer(CGAL::to_double(n));
    NT quotient, rest;
    CGAL::div_mod(n, unit, quotient, rest);
    return (to_integer(quotient) << digits) + Integer(CGAL::to_double(rest));
  }
}

/* A fraction of integers; the denominator is positive. */
struct Rational
{
  Integer numerator, denominator;
};

/* The exact value of a number. */
template <class NT>
Rational to_rational(const NT& x)
{
  constexpr Rational_kind kind = rational_kind<NT>();
  static_assert(kind != Rational_kind::NONE);
  if constexpr(kind == Rational_kind::LAZY) {
    return to_rational(x.exact());
  } else if constexpr(kind == Rational_kind::INTEGER) {
    return {to_integer(x), 1};
  } else if constexpr(kind == Rational_kind::BOOST) {
    return {Integer(numerator(x)), Integer(denominator(x))};
  } else {
    typename Fraction_traits<NT>::Numerator_type above;
    typename Fraction_traits<NT>::Denominator_type below;
    typename Fraction_traits<NT>::Decompose()(x, above, below);
    const Integer denominator = to_integer(below);
    return denominator < 0 ? Rational{-to_integer(above), -denominator} : Rational{to_integer(above), denominator};
  }
}

/* Returns an integer in another number type. */
template <class NT>
NT converted(const Integer& n)
{
  constexpr int digits = 24;
  if(n < 0)
    return NT(-converted<NT>(Integer(-n)));
  if(n < (1 << digits))
    return NT(static_cast<double>(n));
  const NT upper = converted<NT>(Integer(n >> digits));
  return upper * NT(static_cast<double>(1 << digits)) + NT(static_cast<double>(n % (1 << digits)));
}

/* Returns a fraction in another number type, which has division. */
template <class NT>
NT from_rational(const Rational& x)
{
  return NT(converted<NT>(x.numerator) / converted<NT>(x.denominator));
}

/*
 * A fraction in double-double numbers. The first 119 digits are taken as three doubles, of which the sum of the last
 * two is rounded once: so the result errs by little more than 2^-106 of itself, unless it leaves the range of doubles.
 * Its second half is zero only if the first one is the exact value. \pre d > 0
 */
inline Double_double precise_quotient(const Integer& n, const Integer& d)
{
  if(n == 0)
    return {};
  constexpr int digits = 120, of_last = 20, of_middle = 50;
  const int shift = digits + static_cast<int>(highest_bit(d)) - static_cast<int>(highest_bit(n));
  Integer dividend = absolute(n), divisor = d, quotient, rest;
  (shift > 0 ? dividend : divisor) <<= std::abs(shift);
  boost::multiprecision::divide_qr(dividend, divisor, quotient, rest);
  const auto part = [&](int lowest, std::uint64_t mask) {
    return std::ldexp(static_cast<double>(static_cast<std::uint64_t>(Integer((quotient >> lowest) & mask))), lowest);
  };
  const auto mask = [](int size) { return (std::uint64_t(1) << size) - 1; };
  const Double_double leading =
      ordered_sum(part(of_last + of_middle, ~std::uint64_t(0)), part(of_last, mask(of_middle)));
  Double_double result = ordered_sum(leading.high, leading.low + part(0, mask(of_last)));
  if(result.low == 0 && rest != 0)
    result.low = 0.5;
  const double sign = n < 0 ? -1 : 1;
  return {std::ldexp(sign * result.high, -shift), std::ldexp(sign * result.low, -shift)};
}

/* A number, and a bound on its error, which is zero only if the number is exact. */
struct Approximate_number
{
  double value, error;
};

/* The coordinates of a point, as searches use them. */
using Approximate_place = std::array<Approximate_number, 3>;

/* A number in double-double numbers. */
template <class NT>
Double_double precise_number(const NT& x)
{
  const Rational exact = to_rational(x);
  return precise_quotient(exact.numerator, exact.denominator);
}

/* The nearest double, which is zero only if the number is. */
template <class NT>
double rounded_number(const NT& x)
{
  const double result = precise_number(x).high;
  return result == 0 && !(x == NT(0)) ? (std::numeric_limits<double>::min)() : result;
}

} // namespace Flip_geodesics::internal
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H
