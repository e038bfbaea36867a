// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <boost/config.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <ostream>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Boost's integers, which come without a library of their own, behind functions that are compiled once: each operation
 * of theirs is some hundred instructions where it is inlined, and each program would compile them in each place. What is
 * not here is not needed.
 *
 * CGAL/boost_mp.h, which tells CGAL about Boost's, includes GMP where CGAL was configured with it: so functions of CGAL
 * for numbers are not called with these, such as an unqualified abs().
 */
class Integer
{
public:
  using Number = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

  BOOST_NOINLINE Integer() {}
  BOOST_NOINLINE Integer(const Integer& n)
    : m_number(n.m_number)
  {
  }
  BOOST_NOINLINE Integer(Integer&& n) noexcept
    : m_number(std::move(n.m_number))
  {
  }
  BOOST_NOINLINE ~Integer() {}
  BOOST_NOINLINE Integer& operator=(const Integer& n)
  {
    m_number = n.m_number;
    return *this;
  }
  BOOST_NOINLINE Integer& operator=(Integer&& n) noexcept
  {
    m_number.swap(n.m_number);
    return *this;
  }

  template <class T, class = std::enable_if_t<std::is_integral<T>::value>>
  Integer(T n)
    : Integer(Built_in<T>(n), 0)
  {
  }

  BOOST_NOINLINE explicit Integer(double x)
    : m_number(x)
  {
  }

  BOOST_NOINLINE explicit Integer(const Number& n)
    : m_number(n)
  {
  }

  const Number& number() const { return m_number; }

  template <class T, class = std::enable_if_t<std::is_integral<T>::value>>
  explicit operator T() const
  {
    return static_cast<T>(converted(Built_in<T>()));
  }

  BOOST_NOINLINE explicit operator double() const { return m_number.convert_to<double>(); }

  BOOST_NOINLINE int sign() const { return m_number.sign(); }
  BOOST_NOINLINE void swap(Integer& n) noexcept { m_number.swap(n.m_number); }

  /* What is left modulo a number below 2^32, not negative. */
  BOOST_NOINLINE std::uint64_t residue(std::uint64_t modulus) const
  {
    constexpr bool has_long_limbs = sizeof(boost::multiprecision::limb_type) > 4;
    const auto& parts = m_number.backend();
    std::uint64_t result = 0;
    for(std::size_t i = parts.size(); i-- > 0;) {
      const std::uint64_t limb = parts.limbs()[i];
      if(has_long_limbs)
        result = ((result << 32) | (limb >> 32)) % modulus;
      result = ((result << 32) | (limb & 0xffffffff)) % modulus;
    }
    return sign() < 0 && result != 0 ? modulus - result : result;
  }

  /* The number of the highest bit, and of the lowest one that is set. \pre not zero */
  BOOST_NOINLINE unsigned highest_bit() const
  {
    return static_cast<unsigned>(msb(Number(boost::multiprecision::abs(m_number))));
  }
  BOOST_NOINLINE unsigned lowest_bit() const
  {
    return static_cast<unsigned>(lsb(Number(boost::multiprecision::abs(m_number))));
  }

  BOOST_NOINLINE Integer& operator+=(const Integer& n)
  {
    m_number += n.m_number;
    return *this;
  }
  BOOST_NOINLINE Integer& operator-=(const Integer& n)
  {
    m_number -= n.m_number;
    return *this;
  }
  BOOST_NOINLINE Integer& operator*=(const Integer& n)
  {
    m_number *= n.m_number;
    return *this;
  }
  BOOST_NOINLINE Integer& operator/=(const Integer& n)
  {
    m_number /= n.m_number;
    return *this;
  }
  BOOST_NOINLINE Integer& operator%=(const Integer& n)
  {
    m_number %= n.m_number;
    return *this;
  }
  BOOST_NOINLINE Integer& operator<<=(unsigned long bits)
  {
    m_number <<= bits;
    return *this;
  }
  /* \pre not negative */
  BOOST_NOINLINE Integer& operator>>=(unsigned long bits)
  {
    m_number >>= bits;
    return *this;
  }

  friend Integer operator+(Integer a, const Integer& b) { return std::move(a += b); }
  friend Integer operator-(Integer a, const Integer& b) { return std::move(a -= b); }
  friend Integer operator/(Integer a, const Integer& b) { return std::move(a /= b); }
  friend Integer operator%(Integer a, const Integer& b) { return std::move(a %= b); }
  friend Integer operator<<(Integer a, unsigned long bits) { return std::move(a <<= bits); }
  friend Integer operator>>(Integer a, unsigned long bits) { return std::move(a >>= bits); }

  friend BOOST_NOINLINE Integer operator*(const Integer& a, const Integer& b)
  {
    Integer result;
    boost::multiprecision::multiply(result.m_number, a.m_number, b.m_number);
    return result;
  }

  friend BOOST_NOINLINE Integer operator-(Integer a)
  {
    a.m_number.backend().negate();
    return a;
  }

  friend bool operator==(const Integer& a, const Integer& b) { return compare(a, b) == 0; }
  friend bool operator!=(const Integer& a, const Integer& b) { return compare(a, b) != 0; }
  friend bool operator<(const Integer& a, const Integer& b) { return compare(a, b) < 0; }
  friend bool operator>(const Integer& a, const Integer& b) { return compare(a, b) > 0; }
  friend bool operator<=(const Integer& a, const Integer& b) { return compare(a, b) <= 0; }
  friend bool operator>=(const Integer& a, const Integer& b) { return compare(a, b) >= 0; }

  friend std::ostream& operator<<(std::ostream& out, const Integer& n) { return out << n.m_number; }

private:
  template <class T>
  using Built_in = std::conditional_t<std::is_signed<T>::value, std::int64_t, std::uint64_t>;

  BOOST_NOINLINE Integer(std::int64_t n, int)
    : m_number(n)
  {
  }
  BOOST_NOINLINE Integer(std::uint64_t n, int)
    : m_number(n)
  {
  }

  BOOST_NOINLINE std::int64_t converted(std::int64_t) const { return static_cast<std::int64_t>(m_number); }
  BOOST_NOINLINE std::uint64_t converted(std::uint64_t) const { return static_cast<std::uint64_t>(m_number); }

  static BOOST_NOINLINE int compare(const Integer& a, const Integer& b) { return a.m_number.compare(b.m_number); }

  Number m_number;
};

inline Integer absolute(const Integer& n) { return n.sign() < 0 ? -n : n; }

/* The root of an integer, rounded down: from above, by Newton's method. \pre n >= 0 */
inline Integer rounded_root(const Integer& n)
{
  if(n == 0)
    return n;
  constexpr int digits = std::numeric_limits<double>::digits;
  const int excess = static_cast<int>(n.highest_bit()) - 2 * digits;
  const int half_shift = excess > 0 ? excess / 2 : 0;
  const auto leading = static_cast<double>(n >> (2 * half_shift));
  Integer root(std::ceil(std::sqrt(leading) * (1 + root_rounding)) + 1);
  root <<= half_shift;
  for(;;) {
    Integer next = (root + n / root) >> 1;
    if(next >= root)
      return root;
    root.swap(next);
  }
}

/* Which residues modulo M are those of squares? */
template <std::uint64_t M>
constexpr std::array<bool, M> residues_of_squares()
{
  std::array<bool, M> result = {};
  for(std::uint64_t i = 0; i < M; ++i)
    result[i * i % M] = true;
  return result;
}

/* Does a residue modulo the product of some numbers look like that of a square? */
template <std::uint64_t... Moduli>
bool may_be_square(std::uint64_t residue)
{
  static constexpr auto tables = std::make_tuple(residues_of_squares<Moduli>()...);
  return (std::get<std::array<bool, Moduli>>(tables)[residue % Moduli] && ...);
}

/* The root of an integer, if that is one as well; most others are seen at once not to be squares. */
inline std::optional<Integer> exact_root(const Integer& n)
{
  constexpr std::uint64_t product = 64ull * 63 * 65 * 11 * 17 * 19 * 23 * 31;
  if(n.sign() < 0 || !may_be_square<64, 63, 65, 11, 17, 19, 23, 31>(static_cast<std::uint64_t>(n % product)))
    return std::nullopt;
  Integer root = rounded_root(n);
  if(root * root != n)
    return std::nullopt;
  return root;
}

inline bool is_perfect_square(const Integer& n) { return exact_root(n).has_value(); }

/*
 * The quotients of Euclid's algorithm as far as the leading digits of two numbers tell them: the numbers that it leaves
 * are a x + b y and c x + d y [Lehmer; Knuth, The Art of Computer Programming 2, algorithm 4.5.2 L].
 */
struct Leading_quotients
{
  std::int64_t a = 1, b = 0, c = 0, d = 1;

  /* \pre x >= y, of 62 bits at most */
  Leading_quotients(std::int64_t x, std::int64_t y)
  {
    while(y + c != 0 && y + d != 0) {
      const std::int64_t quotient = (x + a) / (y + c);
      if(quotient != (x + b) / (y + d))
        return;
      a = std::exchange(c, a - quotient * c);
      b = std::exchange(d, b - quotient * d);
      x = std::exchange(y, x - quotient * y);
    }
  }
};

/* Much faster than Boost's for numbers of some hundred bits, which finds one bit at a time. \pre x, y >= 0 */
inline Integer greatest_common_divisor(Integer x, Integer y)
{
  constexpr unsigned word = 62;
  if(x < y)
    x.swap(y);
  while(y != 0 && y.highest_bit() >= word) {
    const unsigned shift = x.highest_bit() - (word - 1);
    const Leading_quotients q(static_cast<std::int64_t>(x >> shift), static_cast<std::int64_t>(y >> shift));
    Integer next = q.b == 0 ? Integer(x % y) : Integer(q.c * x + q.d * y);
    x = q.b == 0 ? y : Integer(q.a * x + q.b * y);
    y.swap(next);
  }
  if(y == 0)
    return x;
  const auto low = static_cast<std::uint64_t>(y);
  return Integer(std::gcd(low, static_cast<std::uint64_t>(x % low)));
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H
