// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers that are exact or much longer, and random ones.

#ifndef FLIP_GEODESICS_TEST_INTERNAL_ARITHMETIC_NUMBERS_H
#define FLIP_GEODESICS_TEST_INTERNAL_ARITHMETIC_NUMBERS_H

#include "mesh_soup.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/network/Bundle_order.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
namespace FI = FG::internal;

using FI::Integer;
using Rational = boost::multiprecision::cpp_rational;
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>>;

using FI::Double_double;

inline Rational exact(const Double_double& a) { return Rational(a.high) + Rational(a.low); }

// The second number is half a unit in the last place of the first or less.
inline bool is_normal(const Double_double& a) { return a.high + a.low == a.high; }

inline Double_double random_number(Random_numbers& random, int largest_exponent)
{
  const int exponent = random.below(2 * largest_exponent + 1) - largest_exponent;
  const double high = std::ldexp(random.uniform(0.5, 1) * (random.below(2) == 0 ? 1 : -1), exponent);
  return FI::exact_sum(high, std::ldexp(random.uniform(-1, 1), exponent - 53 - random.below(20)));
}

// As random_number(), or all but the opposite of another one.
inline Double_double partner(const Double_double& a, Random_numbers& random, int largest_exponent)
{
  if(random.below(3) != 0)
    return random_number(random, largest_exponent);
  const double tiny = std::ldexp(random.uniform(-1, 1), -random.below(60));
  return FI::ordered_sum(-a.high, random.below(2) == 0 ? tiny * a.low : a.low + 0x1p-53 * tiny * a.high);
}

// The direction of the second of two sides with lengths a and b, in a triangle with the third length c.
inline std::array<Real, 2> direction_of_next(double a, double b, double c)
{
  const Rational x(a), y(b), z(c), dot = (z * z - x * x - y * y) / 2, square = x * x * y * y - dot * dot;
  const Real scale = Real(a) * Real(b);
  return {Real(Real(dot) / scale), Real(sqrt(Real(square)) / scale)};
}

inline void check_precise_face(const std::array<double, 3>& l)
{
  const auto face = FI::Precise_face_traits().construct_face_from_lengths_object()(l[0], l[1], l[2]);
  for(int i = 0; i < 3; ++i) {
    const std::array<Real, 2> expected = direction_of_next(l[i], l[(i + 1) % 3], l[(i + 2) % 3]);
    const Real x = Real(exact(face[i].next.x)) - expected[0], y = Real(exact(face[i].next.y)) - expected[1];
    BOOST_TEST(face[i].error < 0x1p-90);
    BOOST_TEST(x * x + y * y <= Real(face[i].error) * face[i].error);
    BOOST_TEST(exact(face[i].length) == Rational(l[i]));
  }
}

inline Real real(const Integer& n) { return Real(n); }

inline Integer random_integer(Random_numbers& random, int bits)
{
  Integer result = 1;
  for(int i = 1; i < bits; ++i)
    result = 2 * result + random.below(2);
  return result;
}

inline void check_root(const Integer& n)
{
  const Integer root = FI::rounded_root(n);
  BOOST_TEST((root * root <= n && n < (root + 1) * (root + 1)));
  const bool is_square = root * root == n;
  BOOST_TEST(FI::exact_root(n).has_value() == is_square);
  BOOST_TEST((!is_square || *FI::exact_root(n) == root));
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_INTERNAL_ARITHMETIC_NUMBERS_H
