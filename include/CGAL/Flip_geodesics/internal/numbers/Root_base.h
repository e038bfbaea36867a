// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ROOT_BASE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ROOT_BASE_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A base of pairwise coprime integers, none a square, over which the roots of given integers are products: each sqrt(d)
 * is a factor times the root of a product of distinct base elements. The roots of all such products are linearly
 * independent over the rationals, since a product of distinct coprime numbers is a square only if each is.
 */
class Root_base
{
public:
  struct Root
  {
    Integer factor;
    std::vector<std::size_t> generators; // whose roots are multiplied
  };

  explicit Root_base(const std::vector<Integer>& radicands)
  {
    for(const Integer& d : radicands)
      insert(d);
    for(const Integer& g : m_coprime)
      (is_perfect_square(g) ? m_squares : m_elements).push_back(g);
    for(const Integer& d : radicands)
      m_roots.emplace(d, factored_root(d));
  }

  const std::vector<Integer>& generators() const { return m_elements; }

  /* The root of one of the given integers. */
  const Root& root(const Integer& d) const { return m_roots.at(d); }

  Integer product(const std::vector<std::size_t>& generators) const
  {
    Integer result = 1;
    for(std::size_t i : generators)
      result *= m_elements[i];
    return result;
  }

private:
  Root factored_root(Integer d) const
  {
    Root result = {1, {}};
    if(d == 0)
      return {0, {}};
    for(const Integer& g : m_squares)
      while(d % g == 0) {
        d /= g;
        result.factor *= rounded_root(g);
      }
    for(std::size_t i = 0; i < m_elements.size(); ++i) {
      bool is_odd = false;
      for(; d % m_elements[i] == 0; d /= m_elements[i]) {
        if(is_odd)
          result.factor *= m_elements[i];
        is_odd = !is_odd;
      }
      if(is_odd)
        result.generators.push_back(i);
    }
    return result;
  }

  // Keeps the elements coprime: what d shares with one of them becomes an element of its own.
  void insert(Integer d)
  {
    std::vector<Integer> pending = {std::move(d)};
    while(!pending.empty()) {
      Integer n = std::move(pending.back());
      pending.pop_back();
      if(n <= 1)
        continue;
      bool is_coprime = true;
      for(std::size_t i = 0; i < m_coprime.size() && is_coprime; ++i) {
        const Integer common = greatest_common_divisor(n, m_coprime[i]);
        if(common == 1)
          continue;
        is_coprime = false;
        const Integer rest = m_coprime[i] / common;
        n /= common;
        if(rest == 1) {
          pending.push_back(n);
        } else {
          m_coprime.erase(m_coprime.begin() + static_cast<std::ptrdiff_t>(i));
          pending.insert(pending.end(), {n, rest, common});
        }
      }
      if(is_coprime)
        m_coprime.push_back(n);
    }
  }

  std::vector<Integer> m_coprime;
  std::vector<Integer> m_elements, m_squares;
  std::map<Integer, Root> m_roots;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_ROOT_BASE_H
