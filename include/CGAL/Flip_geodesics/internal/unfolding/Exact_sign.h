// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H

#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Returns the work limit for one sign in a triangulation: that of its traits, if their signs can remain undecided. */
template <class Triangulation>
std::uint64_t sign_work_limit(const Triangulation& triangulation)
{
  if constexpr(Triangulation::Traits::Has_drift::value)
    return default_sign_work;
  else
    return triangulation.traits().sign_work_limit();
}

/*
 * Computes the sign of the imaginary part of a product of chains of input faces in two kinds of numbers: first with 50
 * digits and an error bound, which decides most nonzero numbers, then exactly, with the square roots in the faces'
 * areas, as far as the work limit allows. An undecided sign is taken for zero and counted.
 *
 * The areas of coplanar faces are rational multiples of each other, so that there are at most as many independent roots
 * as planes.
 */
class Exact_sign
{
public:
  explicit Exact_sign(Decision_statistics& statistics, std::uint64_t work_limit = default_sign_work)
    : m_statistics(statistics)
    , m_work_limit(work_limit)
  {
  }

  Sign operator()(const std::vector<Unfolding_chain>& chains) const
  {
    const std::vector<Integer> squares = squared_roots(chains);
    const bool is_one_root = squares.size() <= 1; // then exact numbers take less time
    Uncertain<Sign> sign = is_one_root ? by_roots(squares, chains) : by_digits(chains);
    if(!sign.is_certain())
      sign = is_one_root ? by_digits(chains) : by_roots(squares, chains);
    if(sign.is_certain())
      return sign.make_certain();
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

  Uncertain<Sign> by_digits(const std::vector<Unfolding_chain>& chains) const
  {
    using Ring = Ball_ring<50>;
    const Ring ring;
    const Uncertain<Sign> sign = Chain_arithmetic<Ring>(ring).sign_of_sine(chains);
    m_statistics.by_precision += sign.is_certain() ? 1 : 0;
    return sign;
  }

  Uncertain<Sign> by_roots(const std::vector<Integer>& squares, const std::vector<Unfolding_chain>& chains) const
  {
    using Ring = Multiquadratic_ring;
    Work_limit work(m_work_limit);
    const Ring ring(squares, work);
    m_statistics.most_roots = (std::max)(m_statistics.most_roots, ring.number_of_roots());
    const Uncertain<Sign> sign = Chain_arithmetic<Ring>(ring).sign_of_sine(chains);
    m_statistics.by_roots += sign.is_certain() ? 1 : 0;
    m_statistics.zeros_by_roots += sign.is_certain() && sign.make_certain() == ZERO ? 1 : 0;
    return sign;
  }

  Decision_statistics& m_statistics;
  std::uint64_t m_work_limit;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SIGN_H
