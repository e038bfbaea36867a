// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_IEEE_ARITHMETIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_IEEE_ARITHMETIC_H

#include <array>
#include <cfloat>
#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>

/* Proofs rely on bounds of rounding errors, on computed errors, and on infinity as the absence of a bound. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) ||                          \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST)
#error "Flip_geodesics relies on IEEE 754 arithmetic: compile without -ffast-math, -Ofast and similar options"
#endif
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD == -1)
#error "Flip_geodesics requires results that are rounded to double: for the x87 unit, add -msse2 -mfpmath=sse"
#endif

/* If the processor can round a product and a sum in one operation, compilers may fuse the two across statements. An
 * empty instruction that may change the product, or else its place in memory, prevents this. */
#if defined(__x86_64__) || defined(__i386__)
#if defined(__FMA__) || defined(__FMA4__)
#define CGAL_FLIP_GEODESICS_UNFUSED_REGISTER "+x"
#endif
#elif defined(__aarch64__)
#define CGAL_FLIP_GEODESICS_UNFUSED_REGISTER "+w"
#elif defined(__GNUC__)
#define CGAL_FLIP_GEODESICS_UNFUSED_REGISTER "+m"
#endif

namespace CGAL::Flip_geodesics::internal {

/*
 * Returns a product to be added to another number, rounded separately, so that results do not depend on the processor
 * or the options of compilation.
 */
inline double unfused(double product)
{
#ifdef CGAL_FLIP_GEODESICS_UNFUSED_REGISTER
  __asm__("" : CGAL_FLIP_GEODESICS_UNFUSED_REGISTER(product));
#endif
  return product;
}

inline std::complex<double> unfused(const std::complex<double>& product)
{
  return {unfused(product.real()), unfused(product.imag())};
}

#undef CGAL_FLIP_GEODESICS_UNFUSED_REGISTER

/* Returns whether all coordinates of a point in space are finite. */
inline bool are_finite(const std::array<double, 3>& coordinates)
{
  return std::isfinite(coordinates[0]) && std::isfinite(coordinates[1]) && std::isfinite(coordinates[2]);
}

/* Whether every number of a type is a double. */
template <class NT>
inline constexpr bool is_within_double = std::is_arithmetic<NT>::value&& std::numeric_limits<NT>::radix == 2 &&
                                         std::numeric_limits<NT>::digits <= std::numeric_limits<double>::digits;

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_IEEE_ARITHMETIC_H
