// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLANE_VECTORS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLANE_VECTORS_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace CGAL::Flip_geodesics::internal {

/* A vector in the plane of unfolded faces. */
using Plane_vector = std::complex<double>;

inline double cross(const Plane_vector& u, const Plane_vector& v)
{
  return unfused(u.real() * v.imag()) - unfused(u.imag() * v.real());
}

/* Without the treatment of infinite numbers by the operator. */
inline Plane_vector product(const Plane_vector& u, const Plane_vector& v)
{
  return {unfused(u.real() * v.real()) - unfused(u.imag() * v.imag()),
          unfused(u.real() * v.imag()) + unfused(u.imag() * v.real())};
}

inline double magnitude(const Plane_vector& v)
{
  return std::sqrt(unfused(v.real() * v.real()) + unfused(v.imag() * v.imag()));
}

/* Returns the length computed with 106 bits, since the last bits of std::abs() differ between libraries, which would
 * affect comparisons of equal lengths. */
inline double well_rounded_length(const Plane_vector& v)
{
  return sqrt(exact_product(v.real(), v.real()) + exact_product(v.imag(), v.imag())).high;
}

/*
 * The area and the shape of a triangle given by its lengths, in doubles; side i leads from corner i to corner i + 1.
 *
 * The area is computed by Kahan's formula [K14], which is
 * accurate to a few units in the last place for the given lengths. A triangle whose lengths violate the inequality has
 * area 0.
 */
struct Plane_triangle
{
  std::array<double, 3> lengths = {0, 0, 0};
  double area = 0;
  std::array<double, 3> cotangents = {0, 0, 0}; // by corner

  Plane_triangle() = default;

  explicit Plane_triangle(const std::array<double, 3>& l)
    : lengths(l)
    , area(area_of(l))
  {
    for(int i = 0; i < 3; ++i) {
      const double next = l[i], opposite = l[(i + 1) % 3], previous = l[(i + 2) % 3];
      cotangents[i] = dot(next, previous, opposite) / (2 * area);
    }
  }

  bool has_finite_cotangents() const
  {
    return std::isfinite(cotangents[0]) && std::isfinite(cotangents[1]) && std::isfinite(cotangents[2]);
  }

  /* Returns the angle at a corner; pi opposite to a side that is too long, 0 at its ends. */
  double angle(int corner) const
  {
    const double next = lengths[corner], opposite = lengths[(corner + 1) % 3], previous = lengths[(corner + 2) % 3];
    return std::atan2(2 * area, dot(next, previous, opposite));
  }

  /* Returns the third corner, if corner 0 lies at the origin and side 0 on the positive first axis. */
  std::array<double, 2> apex() const
  {
    return {dot(lengths[0], lengths[2], lengths[1]) / lengths[0], 2 * area / lengths[0]};
  }

  /* Returns the gradient of the linear function that is 1 at a corner and 0 at the others, in the frame of apex(). */
  std::array<double, 2> hat_gradient(int corner) const
  {
    const std::array<double, 2> top = apex();
    const std::array<double, 2> corners[3] = {{0, 0}, {lengths[0], 0}, top};
    const auto& from = corners[(corner + 1) % 3];
    const auto& to = corners[(corner + 2) % 3];
    return {-(to[1] - from[1]) / (2 * area), (to[0] - from[0]) / (2 * area)};
  }

private:
  // The product of two sides and the cosine of the angle between them, opposite to the third side.
  static double dot(double a, double b, double opposite)
  {
    // (a^2 + b^2 - c^2)/2, with less cancellation: (a^2 + (b - c)(b + c))/2 with the longer of a, b next to c.
    const double longer = (std::max)(a, b), shorter = (std::min)(a, b);
    return (shorter * shorter + (longer - opposite) * (longer + opposite)) / 2;
  }

  static double area_of(std::array<double, 3> l)
  {
    std::sort(l.begin(), l.end());
    const double a = l[2], b = l[1], c = l[0];
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0 ? std::sqrt(product) / 4 : 0;
  }
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NUMBERS_PLANE_VECTORS_H
