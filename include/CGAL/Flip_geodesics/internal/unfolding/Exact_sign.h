// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/internal/numbers/Ball_ring.h>
#include <CGAL/Flip_geodesics/internal/numbers/Complex_pairs.h>
#include <CGAL/Flip_geodesics/internal/numbers/Fixed_point_ring.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/Residue_ring.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Corner_product.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vanishing_proof.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The sign of the imaginary part of a product of chains of input faces. In stages: corners whose product is seen to be
 * real; 50 digits, which find the sign of most numbers that are not zero; with few roots, arithmetic in their field;
 * else the proof that the number vanishes; else its residue, and if that is not zero, as many digits as it takes.
 */
class Exact_sign
{
  // Arithmetic with r independent roots costs 2^r integers a number.
  static constexpr std::size_t few_roots = 3, most_roots = 12;
  static constexpr unsigned few_bits = 512;

public:
  explicit Exact_sign(Decision_statistics& statistics)
    : m_statistics(statistics)
  {
  }

  Sign operator()(const std::vector<Unfolding_chain>& chains) const
  {
    if(Corner_product::is_real(chains))
      return zero_by_roots();
    const std::vector<Integer> squares = squared_roots(chains);
    if(squares.size() > 1) {
      const Uncertain<Sign> sign = sign_by_precision(Ball_ring<50>(), chains);
      if(sign.is_certain())
        return sign.make_certain();
    }
    const Root_base base(squares);
    const std::size_t roots = base.generators().size();
    m_statistics.most_roots = (std::max)(m_statistics.most_roots, roots);
    if(roots <= few_roots)
      return sign_by_roots(base, chains);
    // A number that is not zero, but below 50 digits, takes less time so than until it is known not to be zero.
    const Uncertain<Sign> sign = sign_by_precision(Fixed_point_ring(few_bits), chains);
    if(sign.is_certain())
      return sign.make_certain();
    if(Vanishing_proof(chains, base)())
      return zero_by_roots();
    if(!has_residue_zero(base, chains))
      return sign_of_non_zero(chains);
    if(roots <= most_roots)
      return sign_by_roots(base, chains);
    ++m_statistics.unproven_zeros;
    return ZERO;
  }

private:
  static std::vector<Integer> squared_roots(const std::vector<Unfolding_chain>& chains)
  {
    std::vector<Integer> result;
    for(const Unfolding_chain& chain : chains)
      for(const Unfolding_step& step : chain.steps)
        result.push_back(step.squared_root());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  template <class Ring>
  Uncertain<Sign> sign_by_precision(const Ring& ring, const std::vector<Unfolding_chain>& chains) const
  {
    const Uncertain<Sign> sign = ring.sign(Chain_arithmetic<Ring>(ring).sine(chains));
    m_statistics.by_precision += sign.is_certain() ? 1 : 0;
    return sign;
  }

  Sign sign_of_non_zero(const std::vector<Unfolding_chain>& chains) const
  {
    for(unsigned bits = 2 * few_bits;; bits *= 2) {
      const Uncertain<Sign> sign = sign_by_precision(Fixed_point_ring(bits), chains);
      if(sign.is_certain())
        return sign.make_certain();
    }
  }

  Sign sign_by_roots(const Root_base& base, const std::vector<Unfolding_chain>& chains) const
  {
    using Ring = Complex_pairs<Multiquadratic_ring>;
    const Ring ring(base);
    const Sign sign = ring.sign(Chain_arithmetic<Ring>(ring).sine(chains));
    if(sign == ZERO)
      return zero_by_roots();
    ++m_statistics.by_roots;
    return sign;
  }

  Sign zero_by_roots() const
  {
    ++m_statistics.by_roots;
    ++m_statistics.zeros_by_roots;
    return ZERO;
  }

  /*
   * A number that is not zero has 2^r conjugates below 2^b. So its norm, an integer, has at most 2^r b / m prime
   * divisors of m bits, among more than 2^m / (2 m) primes that are 3 mod 4 [Dusart, for m of some size; and
   * Dirichlet's density].
   */
  static bool has_residue_zero(const Root_base& base, const std::vector<Unfolding_chain>& chains)
  {
    constexpr unsigned security = 128; // of this, 20 bits are for what the estimate leaves out
    unsigned long bits = 1;
    for(const Unfolding_chain& chain : chains) {
      for(const Unfolding_step& step : chain.steps)
        bits += 3 + number_of_bits(step.squared_length()) + number_of_bits(step.dot()) +
                number_of_bits(step.squared_root());
      for(const Side_combination& c : {chain.right, chain.left})
        bits += number_of_bits(c.number) + number_of_bits(c.root_coefficient);
      for(const Integer& weight : chain.weights)
        bits += number_of_bits(weight);
    }
    const unsigned size = security + static_cast<unsigned>(base.generators().size()) + number_of_bits(Integer(bits));
    using Ring = Complex_pairs<Residue_ring>;
    const Ring ring(base, fixed_prime(size));
    return ring.is_zero(Chain_arithmetic<Ring>(ring).sine(chains));
  }

  static unsigned number_of_bits(const Integer& n) { return n == 0 ? 1 : static_cast<unsigned>(n.highest_bit()) + 1; }

  Decision_statistics& m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
