// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLANE_VECTORS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLANE_VECTORS_H

#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <cmath>
#include <complex>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A vector in the plane of unfolded faces. */
using Plane_vector = std::complex<double>;

inline double cross(const Plane_vector& u, const Plane_vector& v)
{
  return unfused(u.real() * v.imag()) - unfused(u.imag() * v.real());
}

/* Without the care for infinite numbers that the operator takes. */
inline Plane_vector product(const Plane_vector& u, const Plane_vector& v)
{
  return {unfused(u.real() * v.real()) - unfused(u.imag() * v.imag()),
          unfused(u.real() * v.imag()) + unfused(u.imag() * v.real())};
}

inline double magnitude(const Plane_vector& v)
{
  return std::sqrt(unfused(v.real() * v.real()) + unfused(v.imag() * v.imag()));
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLANE_VECTORS_H
