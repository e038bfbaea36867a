// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_MULTIQUADRATIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_MULTIQUADRATIC_H

#include <CGAL/Flip_geodesics/internal/Exact_face.h>

#include <CGAL/enum.h>

#include <boost/multiprecision/cpp_int.hpp>

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
    std::size_t mask; // bit i: the root of base element i
  };

  explicit Root_base(const std::vector<Integer>& radicands)
  {
    for(const Integer& d : radicands)
      insert(d);
    std::vector<Integer> generators;
    for(const Integer& g : m_elements)
      if(!is_square(g))
        generators.push_back(g);
      else
        m_squares.push_back(g);
    m_elements.swap(generators);
    for(const Integer& d : radicands)
      m_roots.emplace(d, factored_root(d));
  }

  const std::vector<Integer>& generators() const { return m_elements; }

  /* The root of one of the given integers. */
  const Root& root(const Integer& d) const { return m_roots.at(d); }

private:
  Root factored_root(Integer d) const
  {
    Root result = {1, 0};
    if(d == 0)
      return {0, 0};
    for(const Integer& g : m_squares)
      while(d % g == 0) {
        d /= g;
        result.factor *= boost::multiprecision::sqrt(g);
      }
    for(std::size_t i = 0; i < m_elements.size(); ++i) {
      bool is_odd = false;
      for(; d % m_elements[i] == 0; d /= m_elements[i]) {
        if(is_odd)
          result.factor *= m_elements[i];
        is_odd = !is_odd;
      }
      if(is_odd)
        result.mask |= std::size_t(1) << i;
    }
    return result;
  }

  static bool is_square(const Integer& n)
  {
    Integer remainder;
    boost::multiprecision::sqrt(n, remainder);
    return remainder == 0;
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
      for(std::size_t i = 0; i < m_elements.size() && is_coprime; ++i) {
        const Integer common = gcd(n, m_elements[i]);
        if(common == 1)
          continue;
        is_coprime = false;
        const Integer rest = m_elements[i] / common;
        n /= common;
        if(rest == 1) {
          pending.push_back(n);
        } else {
          m_elements.erase(m_elements.begin() + static_cast<std::ptrdiff_t>(i));
          pending.insert(pending.end(), {n, rest, common});
        }
      }
      if(is_coprime)
        m_elements.push_back(n);
    }
  }

  std::vector<Integer> m_elements, m_squares;
  std::map<Integer, Root> m_roots;
};

/* Exact arithmetic in Z[sqrt g_1, ..., sqrt g_r]: one integer per product of distinct roots. */
class Multiquadratic_ring
{
public:
  using Number = std::vector<Integer>;

  explicit Multiquadratic_ring(const Root_base& base)
    : m_base(base)
    , m_products(std::size_t(1) << base.generators().size(), Integer(1))
  {
    for(std::size_t mask = 0; mask < m_products.size(); ++mask)
      for(std::size_t i = 0; i < base.generators().size(); ++i)
        if((mask >> i & 1) != 0)
          m_products[mask] *= base.generators()[i];
  }

  Number integer(const Integer& n) const
  {
    Number result(m_products.size());
    result[0] = n;
    return result;
  }

  Number add(Number a, const Number& b) const
  {
    for(std::size_t i = 0; i < a.size(); ++i)
      a[i] += b[i];
    return a;
  }

  Number negate(Number a) const
  {
    for(Integer& c : a)
      c = -c;
    return a;
  }

  /* The factor dot + sign i sqrt(squared_root), for numbers that are rescaled by the divisor instead. */
  struct Side
  {
    Integer dot;
    Root_base::Root root;
  };

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& /* divisor */) const
  {
    Side result = {dot, m_base.root(squared_root)};
    result.root.factor *= sign;
    return result;
  }

  Number rescale(Number a, const Integer& factor) const
  {
    for(Integer& c : a)
      c *= factor;
    return a;
  }

  Number times_integer(const Number& a, const Integer& n) const { return rescale(a, n); }
  Number times_dot(const Number& a, const Side& side) const { return rescale(a, side.dot); }

  Number times_root(const Number& a, const Side& side) const
  {
    Number result(m_products.size());
    for(std::size_t i = 0; i < a.size(); ++i)
      if(a[i] != 0)
        result[i ^ side.root.mask] += a[i] * side.root.factor * m_products[i & side.root.mask];
    return result;
  }

  Number multiply(const Number& a, const Number& b) const
  {
    Number result(m_products.size());
    for(std::size_t i = 0; i < a.size(); ++i)
      for(std::size_t j = 0; a[i] != 0 && j < b.size(); ++j)
        if(b[j] != 0)
          result[i ^ j] += a[i] * b[j] * m_products[i & j];
    return result;
  }

  /* The exact sign: zero if all coefficients are, and otherwise found by growing precision, which must end. */
  Sign sign(const Number& a) const
  {
    bool is_zero = true;
    for(const Integer& c : a)
      is_zero = is_zero && c == 0;
    if(is_zero)
      return ZERO;
    if(a.size() == 1)
      return a[0] > 0 ? POSITIVE : NEGATIVE;
    for(unsigned bits = 64;; bits *= 2) {
      Integer sum = 0, error = 0; // in units of 2^-bits, each root rounded down
      for(std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * boost::multiprecision::sqrt(Integer(m_products[i] << (2 * bits)));
        error += abs(a[i]);
      }
      if(abs(sum) > error)
        return sum > 0 ? POSITIVE : NEGATIVE;
    }
  }

private:
  const Root_base& m_base;
  std::vector<Integer> m_products; // of the base elements in a mask
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_MULTIQUADRATIC_H
