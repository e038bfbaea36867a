// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_MULTIQUADRATIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_MULTIQUADRATIC_H

#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns the root of an integer, rounded down, by Newton's method from above; Boost 1.74's own root takes 3 to 20
 * times as long. \pre n >= 0 */
inline Integer rounded_root(const Integer& n)
{
  if(n == 0)
    return n;
  constexpr int digits = std::numeric_limits<double>::digits;
  const int excess = static_cast<int>(highest_bit(n)) - 2 * digits;
  const int half_shift = excess > 0 ? excess / 2 : 0;
  const auto leading = static_cast<double>(Integer(n >> (2 * half_shift)));
  Integer root(std::ceil(std::sqrt(leading) * (1 + root_rounding)) + 1);
  root <<= half_shift;
  for(;;) {
    Integer next = (root + n / root) >> 1;
    if(next >= root)
      return root;
    root.swap(next);
  }
}

/* Returns whether a residue, modulo a multiple of M, is that of a square modulo M. */
template <std::uint64_t M>
bool is_square_modulo(std::uint64_t residue)
{
  static const std::bitset<M> squares = [] {
    std::bitset<M> result;
    for(std::uint64_t i = 0; i < M; ++i)
      result.set(i * i % M);
    return result;
  }();
  return squares[residue % M];
}

/* Returns the root of an integer if it is an integer as well; most other integers are quickly found not to be
 * squares. */
inline std::optional<Integer> exact_root(const Integer& n)
{
  constexpr std::uint64_t product = 64ull * 63 * 65 * 11 * 17 * 19 * 23 * 31;
  if(n < 0)
    return std::nullopt;
  const auto r = static_cast<std::uint64_t>(Integer(n % product));
  if(!(is_square_modulo<64>(r) && is_square_modulo<63>(r) && is_square_modulo<65>(r) && is_square_modulo<11>(r) &&
       is_square_modulo<17>(r) && is_square_modulo<19>(r) && is_square_modulo<23>(r) && is_square_modulo<31>(r)))
    return std::nullopt;
  Integer root = rounded_root(n);
  if(root * root != n)
    return std::nullopt;
  return root;
}

/*
 * The remainder of a work limit for operations with integers, counted in products of two 64-bit words. An operation
 * with short integers takes as long as about 32 of these, mostly for their memory.
 */
class Work_limit
{
public:
  static constexpr std::uint64_t of_operation = 32;

  explicit Work_limit(std::uint64_t limit = default_sign_work)
    : m_left(limit)
  {
  }

  bool is_met() const { return m_left == 0; }
  void charge(std::uint64_t work) { m_left -= work < m_left ? work : m_left; }

  /* Charges for the product of two integers, or for the root of one. */
  void charge_product(const Integer& a, const Integer& b) { charge(of_operation + words(a) * words(b)); }
  void charge_root(const Integer& n) { charge(steps_of_root * (of_operation + words(n) * words(n))); }

private:
  // Newton's method doubles the digits of a double four times for numbers of a thousand digits.
  static constexpr std::uint64_t steps_of_root = 6;

  static std::uint64_t words(const Integer& n)
  {
    return (std::uint64_t(n.backend().size()) * sizeof(boost::multiprecision::limb_type) + 7) / 8;
  }

  std::uint64_t m_left;
};

/*
 * A sum of integers times square roots of integers, and its sign, for any number of roots. Roots of numbers no two of
 * which have a square as their product are linearly independent over the rationals [B40]. The sum is therefore
 * zero only if the terms of each class of roots that are multiples of one another sum up to zero; the sign of a nonzero
 * sum is found eventually, unless the work limit is exceeded before.
 */
class Root_sum
{
  struct Term
  {
    Integer factor, square;
  };

public:
  /* \pre square >= 0 */
  void add(const Integer& factor, const Integer& square)
  {
    if(square != 0)
      m_factors[square] += factor;
  }

  Uncertain<Sign> sign(Work_limit& work) const
  {
    std::vector<Term> terms;
    for(const auto& [square, factor] : m_factors)
      if(factor != 0)
        terms.push_back({factor, square});
    for(unsigned bits = 64; !terms.empty() && !work.is_met(); bits *= 2) {
      const Uncertain<Sign> sign = sign_by_digits(terms, bits, work);
      if(sign.is_certain())
        return sign;
      if(bits == 64)
        terms = without_zeros(std::move(terms), work);
    }
    return work.is_met() ? Uncertain<Sign>::indeterminate() : Uncertain<Sign>(ZERO);
  }

private:
  // In units of 2^-bits, with each root rounded down.
  static Uncertain<Sign> sign_by_digits(const std::vector<Term>& terms, unsigned bits, Work_limit& work)
  {
    Integer sum = 0, error = 0;
    for(const Term& term : terms) {
      const Integer square = term.square << (2 * bits);
      work.charge_root(square);
      if(work.is_met())
        return Uncertain<Sign>::indeterminate();
      sum += term.factor * rounded_root(square);
      error += absolute(term.factor);
    }
    if(absolute(sum) > error)
      return sum > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

  // Removes the classes whose sums are zero: with square d of one term, sqrt(d e) of the others is an integer.
  static std::vector<Term> without_zeros(std::vector<Term> terms, Work_limit& work)
  {
    std::vector<Term> result;
    while(!terms.empty() && !work.is_met()) {
      const Integer square = terms.front().square;
      std::vector<Term> of_class, others;
      Integer sum = 0; // times the root of the square
      for(Term& term : terms) {
        work.charge_product(square, term.square);
        const std::optional<Integer> root = exact_root(square * term.square);
        if(root)
          sum += term.factor * *root;
        (root ? of_class : others).push_back(std::move(term));
      }
      if(sum != 0)
        std::move(of_class.begin(), of_class.end(), std::back_inserter(result));
      terms = std::move(others);
    }
    return result;
  }

  std::map<Integer, Integer> m_factors; // by squares
};

/*
 * Exact complex numbers over Z[sqrt d_1, ..., sqrt d_r], for `Chain_arithmetic`: one integer for each set of roots, the
 * coefficient of their product. No product of two of the d is a square; a product of more can be, which `Root_sum`
 * detects.
 *
 * Once the work limit is exceeded, numbers are empty, and the sign is uncertain.
 */
class Multiquadratic_ring
{
public:
  using Number = std::vector<Integer>; // by masks: bit i stands for root i

  struct Complex
  {
    Number re, im;
  };

  /* A root of an integer, as a multiple of one of the ring or of 1. */
  struct Root
  {
    Integer factor;
    std::size_t mask;
  };

  /* The factor dot + i root, for numbers that are rescaled by the divisor instead. */
  struct Side
  {
    Integer dot;
    Root root;
  };

  Multiquadratic_ring(const std::vector<Integer>& radicands, Work_limit& work)
    : m_work(work)
  {
    for(const Integer& d : radicands)
      add_radicand(d);
    charge_product_of_numbers();
    if(m_work.is_met())
      return;
    for(const Integer& d : radicands)
      m_roots.emplace(d, root_of(d));
    for(std::size_t i = 1; i < m_radicands.size(); ++i)
      for(std::size_t mask = 0, end = m_products.size(); mask < end; ++mask)
        m_products.push_back(m_products[mask] * m_radicands[i]);
  }

  /* Returns the number of roots, no two of which are rational multiples of each other. */
  std::size_t number_of_roots() const { return m_radicands.size() - 1; }

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& /* divisor */) const
  {
    if(m_work.is_met())
      return {};
    const Root& root = m_roots.at(squared_root);
    return {dot, {root.factor * sign, root.mask}};
  }

  Complex one() const { return {integer(1), integer(0)}; }

  /* Returns the dot of a side, and its root times n. */
  Complex combination(const Side& q, const Integer& n) const
  {
    return {integer(q.dot), times_integer(times_root(integer(1), q.root), n)};
  }

  Complex add(const Complex& a, const Complex& b) const
  {
    return {add(a.re, b.re, POSITIVE), add(a.im, b.im, POSITIVE)};
  }
  Complex negate(const Complex& z) const { return {times_integer(z.re, -1), times_integer(z.im, -1)}; }
  Complex conjugate(const Complex& z) const { return {z.re, times_integer(z.im, -1)}; }
  Complex rescale(const Complex& z, const Integer& factor) const { return times_integer(z, factor); }

  Complex multiply(const Complex& a, const Complex& b) const
  {
    return {add(multiply(a.re, b.re), multiply(a.im, b.im), NEGATIVE),
            add(multiply(a.re, b.im), multiply(a.im, b.re), POSITIVE)};
  }

  Complex times_side(const Complex& z, const Side& q) const
  {
    return {add(times_integer(z.re, q.dot), times_root(z.im, q.root), NEGATIVE),
            add(times_integer(z.im, q.dot), times_root(z.re, q.root), POSITIVE)};
  }

  Complex times_integer(const Complex& z, const Integer& n) const
  {
    return {times_integer(z.re, n), times_integer(z.im, n)};
  }

  /* Returns the sign of the imaginary part. */
  Uncertain<Sign> sign_of_sine(const Complex& z) const
  {
    const Number& a = z.im;
    Root_sum sum;
    if(m_work.is_met())
      return Uncertain<Sign>::indeterminate();
    for(std::size_t i = 0; i < a.size(); ++i)
      sum.add(a[i], m_products[i]);
    return sum.sign(m_work);
  }

private:
  // ---------------------------------------------------------------- roots

  // A product of two numbers takes 4^r products of integers: with 29 roots, the work exceeds 64 bits.
  void charge_product_of_numbers()
  {
    constexpr std::size_t far_too_many = 29;
    const std::size_t r = number_of_roots();
    m_work.charge(r < far_too_many ? Work_limit::of_operation << (2 * r) : UINT64_MAX);
  }

  // For a class of integers whose pairwise products are squares, the ring has the root of their greatest common
  // divisor, which belongs to the class as well and divides the others by squares. The first class is that of squares.
  void add_radicand(const Integer& d)
  {
    if(d == 0)
      return;
    for(Integer& g : m_radicands) {
      if(m_work.is_met())
        return;
      m_work.charge_product(g, d);
      if(exact_root(g * d)) {
        if(d % g != 0)
          g = boost::multiprecision::gcd(g, d);
        return;
      }
    }
    m_radicands.push_back(d);
  }

  Root root_of(const Integer& d) const
  {
    for(std::size_t i = 0; i < m_radicands.size() && d != 0; ++i)
      if(const std::optional<Integer> root = exact_root(d * m_radicands[i]))
        return {*root / m_radicands[i], (std::size_t(1) << i) >> 1};
    return {0, 0};
  }

  // ---------------------------------------------------------------- real numbers

  Number integer(const Integer& n) const
  {
    Number result(m_work.is_met() ? 0 : m_products.size());
    if(!result.empty())
      result[0] = n;
    return result;
  }

  // a + sign b
  Number add(Number a, const Number& b, Sign sign) const
  {
    if(m_work.is_met())
      return {};
    for(std::size_t i = 0; i < a.size(); ++i)
      sign == POSITIVE ? a[i] += b[i] : a[i] -= b[i];
    return a;
  }

  Number times_integer(Number a, const Integer& n) const
  {
    if(m_work.is_met())
      return {};
    for(Integer& c : a) {
      m_work.charge_product(c, n);
      c *= n;
    }
    return a;
  }

  Number times_root(const Number& a, const Root& root) const
  {
    if(m_work.is_met())
      return {};
    Number result(a.size());
    for(std::size_t i = 0; i < a.size(); ++i)
      add_product(a[i], root.factor, i, root.mask, result);
    return result;
  }

  Number multiply(const Number& a, const Number& b) const
  {
    Number result(a.size());
    for(std::size_t i = 0; i < a.size(); ++i)
      for(std::size_t j = 0; j < b.size(); ++j) {
        if(m_work.is_met())
          return {};
        add_product(a[i], b[j], i, j, result);
      }
    return result;
  }

  // Adds the product of two coefficients.
  void add_product(const Integer& a, const Integer& b, std::size_t i, std::size_t j, Number& result) const
  {
    m_work.charge_product(a, b);
    if(a == 0 || b == 0)
      return;
    const Integer product = a * b;
    m_work.charge_product(product, m_products[i & j]);
    result[i ^ j] += product * m_products[i & j];
  }

  Work_limit& m_work;
  std::vector<Integer> m_radicands = {1};
  std::map<Integer, Root> m_roots;       // of the given integers
  std::vector<Integer> m_products = {1}; // of the radicands in a mask
};

/*
 * Floating-point arithmetic with a fixed number of decimal digits and an error bound. Strips are not scaled: numbers
 * stay as large as the ratios of edge lengths, so doubles can represent the bounds.
 */
template <unsigned Digits>
class Ball_ring
{
  using Float =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

public:
  struct Complex
  {
    Float re, im;
    double radius, size; // the size is at least that of re + i im, and at most twice it
  };

  /* The factor (dot + sign i sqrt(squared_root)) / divisor, and a tight bound on its size. */
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

  /* Returns the dot of a side, and its root times n. */
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

  /* Returns the sign of the imaginary part. */
  Uncertain<Sign> sign_of_sine(const Complex& z) const
  {
    if(boost::multiprecision::abs(z.im) > z.radius)
      return z.im > 0 ? POSITIVE : NEGATIVE;
    return Uncertain<Sign>::indeterminate();
  }

private:
  // Newton's method for the inverse of the root, without a division. Boost's own root computes one bit at a time.
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

  // With a radius and the rounding errors.
  static Complex product(const Complex& z, const Float& re, const Float& im, double radius, double size)
  {
    return rounded(z.re * re - z.im * im, z.re * im + z.im * re, radius + z.size * size * unit());
  }

  // A generous bound for the last few operations.
  static double unit()
  {
    static_assert(Digits <= 290, "the radius must be representable as a double");
    static const double result = std::pow(10.0, 2 - static_cast<int>(Digits));
    return result;
  }

  // Adds the rounding errors, including that of the radius itself. A radius too small for a double is kept positive.
  static Complex rounded(const Float& re, const Float& im, double radius)
  {
    const double size = (std::abs(as_double(re)) + std::abs(as_double(im))) * (1 + radius_rounding);
    return {re, im, (radius + size * unit()) * (1 + product_radius_rounding) + (std::numeric_limits<double>::min)(),
            size};
  }

  // Of the last face: two sides of it are requested consecutively.
  mutable Integer m_squared_root = 0, m_divisor = 0;
  mutable Float m_inverse, m_root;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_MULTIQUADRATIC_H
