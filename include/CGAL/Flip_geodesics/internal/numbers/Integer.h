// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <bitset>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Boost's integers, which need no other library. CGAL/boost_mp.h, which declares them to CGAL, includes GMP where CGAL
 * was configured with it; therefore functions of CGAL for numbers, such as an unqualified abs(), are not called with
 * them.
 */
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

inline Integer absolute(const Integer& n) { return boost::multiprecision::abs(n); }

/* The positions of the highest and of the lowest bit that is set. \pre not zero */
inline unsigned highest_bit(const Integer& n) { return static_cast<unsigned>(msb(absolute(n))); }
inline unsigned lowest_bit(const Integer& n) { return static_cast<unsigned>(lsb(absolute(n))); }

/* The root of an integer, rounded down, by Newton's method from above; that of Boost 1.74 takes 3 to 20 times as long.
 * \pre n >= 0 */
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

/* Is a residue, modulo a multiple of M, that of a square modulo M? */
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

/* The root of an integer, if that is an integer as well; most others are seen at once not to be squares. */
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
 * What is left of a limit of work with integers, counted in products of two words of 64 bits. An operation with short
 * integers takes as long as some 32 of these, mostly for their memory.
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_INTEGER_H
