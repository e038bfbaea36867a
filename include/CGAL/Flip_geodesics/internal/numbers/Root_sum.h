// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ROOT_SUM_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ROOT_SUM_H

#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A sum of integers times roots of integers, and its sign, however many roots there are. Roots of numbers of which no
 * two have a square for their product are linearly independent over the rationals [Besicovitch]. So the sum is zero only
 * if the terms of each class of roots, that are multiples of one another, are; and what is not zero has a sign in the
 * end, unless the limit of work is met before.
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
  // In units of 2^-bits, each root rounded down.
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

  // Less the classes whose sums are zero: with square d of one term, sqrt(d e) of the others is an integer.
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ROOT_SUM_H
