// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_IEEE_ARITHMETIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_IEEE_ARITHMETIC_H

#include <array>
#include <cfloat>
#include <cmath>
#include <complex>

/* What is proven relies on bounds of rounding errors, on errors that are computed, and on infinity: no bound. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) ||                          \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST)
#error "Flip_geodesics proves its results by IEEE 754 arithmetic: compile without -ffast-math, -Ofast and their parts"
#endif
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD == -1)
#error "Flip_geodesics needs doubles that are rounded to double: for the x87 add -msse2 -mfpmath=sse"
#endif

/* Can the processor round a product and a sum in one operation? Then compilers make one of the two across statements,
 * as they like. An empty instruction that may change the product, or else its place in memory, is in their way. */
#if defined(__x86_64__) || defined(__i386__)
#if defined(__FMA__) || defined(__FMA4__)
#define CGAL_FLIP_GEODESICS_UNFUSED_REGISTER "+x"
#endif
#elif defined(__aarch64__)
#define CGAL_FLIP_GEODESICS_UNFUSED_REGISTER "+w"
#elif defined(__GNUC__)
#define CGAL_FLIP_GEODESICS_UNFUSED_REGISTER "+m"
#endif

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A product, to be added to something, rounded by itself: what depends on the result is the same whatever processor and
 * whatever options a program is compiled for.
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

/* Returns whether all coordinates of a place in space are finite. */
inline bool are_finite(const std::array<double, 3>& coordinates)
{
  return std::isfinite(coordinates[0]) && std::isfinite(coordinates[1]) && std::isfinite(coordinates[2]);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_IEEE_ARITHMETIC_H
