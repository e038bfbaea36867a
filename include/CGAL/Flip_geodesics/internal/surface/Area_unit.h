// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_AREA_UNIT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_AREA_UNIT_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/Number_operations.h>

#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

[[noreturn]] inline void throw_inexact_root()
{
  throw Inexact_root_error("the area of a face is not a rational multiple of the root of the radicand; "
                           "common_radicand() finds the radicand that fits a mesh, if there is one");
}

/*
 * The unit in which areas are counted, and with them the second coordinates of vectors: 1 where the number type has
 * roots, sqrt(d) where it has not. `root(s)` is the root of s in this unit, and `product(a, b)` that of two
 * second coordinates.
 */
template <class NT, Number_kind Kind = Number_operations<NT>::kind>
class Area_unit
{
public:
  using Radicand = NT;

  NT root(const NT& square) const
  {
    // Below zero is a degenerate triangle seen through rounding.
    if constexpr(Number_operations<NT>::kind == Number_kind::FLOATING)
      if(Number_operations<NT>::sign(square) == NEGATIVE)
        return NT(0);
    return Number_operations<NT>::sqrt(square);
  }

  NT product(const NT& a, const NT& b) const { return a * b; }
  double to_double() const { return 1; }
};

template <class NT>
class Area_unit<NT, Number_kind::RATIONAL>
{
  using Operations = Number_operations<NT>;

public:
  using Radicand = NT;

  explicit Area_unit(const NT& radicand = NT(1))
    : m_radicand(radicand)
    , m_is_one(radicand == NT(1))
    , m_value(std::sqrt(Operations::to_double(radicand)))
  {
  }

  NT root(const NT& square) const
  {
    NT result;
    if(!Operations::is_square(square / m_radicand, result))
      throw_inexact_root();
    return result;
  }

  NT product(const NT& a, const NT& b) const { return m_is_one ? NT(a * b) : NT(m_radicand * NT(a * b)); }
  double to_double() const { return m_value; }

private:
  NT m_radicand;
  bool m_is_one;
  double m_value;
};

/* The unit is 1, but roots are found only in the form r sqrt(d) with a coefficient r. */
template <class NT>
class Area_unit<NT, Number_kind::EXTENSION>
{
  using Coefficient = typename NT::NT;

public:
  using Radicand = typename NT::ROOT;

  explicit Area_unit(const Radicand& radicand = Radicand(1))
    : m_radicand(radicand)
  {
  }

  NT root(const NT& square) const
  {
    Coefficient result;
    if(square.is_extended() ||
       !Number_operations<Coefficient>::is_square(square.a0() / Coefficient(m_radicand), result))
      throw_inexact_root();
    return m_radicand == Radicand(1) ? NT(result) : NT(Coefficient(0), result, m_radicand);
  }

  NT product(const NT& a, const NT& b) const { return a * b; }
  double to_double() const { return 1; }

private:
  Radicand m_radicand;
};

/* A positive integer without the squares in it that are easily found. */
inline Integer without_squares(Integer n)
{
  constexpr int limit = 1000;
  for(int p = 2; p < limit; ++p)
    while(n % (p * p) == 0)
      n /= p * p;
  for(int factor = 1; factor < limit; ++factor)
    if(n % factor == 0 && exact_root(n / factor))
      return factor;
  return n;
}

/* The same integer in another number type. */
template <class NT>
NT converted(const Integer& n)
{
  constexpr int digits = 24;
  if(n < (1 << digits))
    return NT(static_cast<double>(n));
  const NT upper = converted<NT>(Integer(n >> digits));
  return upper * NT(static_cast<double>(1 << digits)) + NT(static_cast<double>(n % (1 << digits)));
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_AREA_UNIT_H
