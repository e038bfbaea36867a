// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_INTEGER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_INTEGER_H

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Boost's, which come without a library of their own. CGAL/boost_mp.h, which tells CGAL about them, includes GMP where
 * CGAL was configured with it: so functions of CGAL for numbers are not called with these, such as an unqualified
 * abs().
 */
using Integer = boost::multiprecision::cpp_int;

/* The root of an integer, rounded down: from above, by Newton's method. \pre n >= 0 */
inline Integer rounded_root(const Integer& n)
{
  if(n == 0)
    return n;
  constexpr int digits = std::numeric_limits<double>::digits;
  const int excess = static_cast<int>(boost::multiprecision::msb(n)) - 2 * digits;
  const int half_shift = excess > 0 ? excess / 2 : 0;
  const double leading = Integer(n >> (2 * half_shift)).convert_to<double>();
  Integer root(std::ceil(std::sqrt(leading) * (1 + 4 * std::numeric_limits<double>::epsilon())) + 1);
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
  constexpr std::uint64_t product = 63ull * 65 * 11 * 17 * 19 * 23 * 31;
  if(n < 0 || !may_be_square<64>(static_cast<std::uint64_t>(n & 63)) ||
     !may_be_square<63, 65, 11, 17, 19, 23, 31>(static_cast<std::uint64_t>(n % product)))
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
  while(y != 0 && boost::multiprecision::msb(y) >= word) {
    const unsigned shift = boost::multiprecision::msb(x) - (word - 1);
    const Leading_quotients q(static_cast<std::int64_t>(x >> shift), static_cast<std::int64_t>(y >> shift));
    Integer next = q.b == 0 ? Integer(x % y) : Integer(q.c * x + q.d * y);
    x = q.b == 0 ? y : Integer(q.a * x + q.b * y);
    y.swap(next);
  }
  if(y == 0)
    return x;
  const auto small = static_cast<std::uint64_t>(y);
  return Integer(std::gcd(small, static_cast<std::uint64_t>(x % small)));
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_INTEGER_H
