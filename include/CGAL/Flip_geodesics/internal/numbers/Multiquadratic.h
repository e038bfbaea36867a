// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_MULTIQUADRATIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_MULTIQUADRATIC_H

#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/Root_base.h>
#include <CGAL/Flip_geodesics/internal/numbers/Root_sum.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
    Integer dot, factor;
    std::size_t mask; // bit i: the root of generator i
  };

  Side side(const Integer& dot, const Integer& squared_root, int sign, const Integer& /* divisor */) const
  {
    const Root_base::Root& root = m_base.root(squared_root);
    Side result = {dot, root.factor * sign, 0};
    for(std::size_t i : root.generators)
      result.mask |= std::size_t(1) << i;
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
        result[i ^ side.mask] += a[i] * side.factor * m_products[i & side.mask];
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

  Sign sign(const Number& a) const
  {
    Root_sum sum;
    for(std::size_t i = 0; i < a.size(); ++i)
      sum.add(a[i], m_products[i]);
    return sum.sign();
  }

private:
  const Root_base& m_base;
  std::vector<Integer> m_products; // of the base elements in a mask
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_MULTIQUADRATIC_H
