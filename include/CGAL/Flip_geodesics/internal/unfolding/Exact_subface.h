// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SUBFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SUBFACE_H

#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Rational_number.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_strip.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A triangle in an input face whose corners are given by weights in that face. Its sides are exact: with sides h, hn,
 * hp of the face, as in an `Exact_face`, corner 0 is the origin, corner 1 is h, and corner 2 is -hp. Lengths and
 * directions are rounded last, so that their errors do not depend on the shape of the triangle.
 */
class Exact_subface
{
public:
  /* \param length that of the first side of the face, as a halfedge with its error
   * \param weights of the three corners, counted from the first halfedge of the face */
  Exact_subface(const Exact_face& face, const Precise_halfedge& length,
                const std::array<std::array<double, 3>, 3>& weights)
    : m_radicand(face.doubled_area_squared)
    , m_face_length(length.length)
    , m_error(length.error)
  {
    std::array<std::array<Integer, 3>, 3> w;
    std::array<Integer, 3> sums;
    for(std::size_t i = 0; i < 3; ++i) {
      w[i] = integer_weights(weights[i]);
      sums[i] = w[i][0] + w[i][1] + w[i][2];
    }
    std::array<Integer, 3> x, y; // of the corners, times the sums of all weights
    for(std::size_t i = 0; i < 3; ++i) {
      const Integer others = sums[(i + 1) % 3] * sums[(i + 2) % 3];
      x[i] = (w[i][1] * face.squared_length - w[i][2] * face.dot_previous) * others;
      y[i] = w[i][2] * others;
    }
    set_sides(x, y);
    m_denominator = face.squared_length * (sums[0] * sums[1] * sums[2]);
  }

  /* The triangle from side i on. */
  Exact_face exact_face(std::size_t i) const
  {
    const Integer across = cross(i, i + 1);
    return {dot(i, i), dot(i, i + 1), dot(i, i + 2), across * across * m_radicand};
  }

  /* The length of side i; the error is relative, as that of `Precise_halfedge`. */
  Double_double length(std::size_t i) const
  {
    return m_face_length *
           sqrt(precise_quotient(dot(i, i) * (m_numerator * m_numerator), m_denominator * m_denominator));
  }

  /* The halfedges from side i on. A quotient, a root and a product add less than 32 u^2 to the error of the length, for
   * which `precise_direction_error` has room; directions are rounded from exact numbers. */
  std::array<Precise_halfedge, 3> precise_face(std::size_t i) const
  {
    std::array<Precise_halfedge, 3> result;
    for(std::size_t k = 0; k < 3; ++k) {
      const Double_double size = length(i + k);
      const bool is_usual = size.high > least_unscaled && size.high < greatest_unscaled;
      result[k] = {size, direction(i + k, i + k + 1), is_usual ? m_error : std::numeric_limits<double>::infinity()};
    }
    return result;
  }

  /* The vectors of the sides from side i on, in a frame in which that is on the x-axis. */
  std::array<std::array<double, 2>, 3> vectors(std::size_t i) const
  {
    std::array<std::array<double, 2>, 3> result = {{{{length(i).high, 0}}, {{0, 0}}, {{0, 0}}}};
    for(std::size_t k = 1; k < 3; ++k) {
      const Double_double_vector side = length(i + k) * direction(i, i + k);
      result[k] = {{side.x.high, side.y.high}};
    }
    return result;
  }

private:
  void set_sides(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y)
  {
    m_numerator = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      m_x[i] = x[(i + 1) % 3] - x[i];
      m_y[i] = y[(i + 1) % 3] - y[i];
      m_numerator = boost::multiprecision::gcd(m_numerator, boost::multiprecision::gcd(m_x[i], m_y[i]));
    }
    for(std::size_t i = 0; i < 3; ++i) {
      m_x[i] /= m_numerator;
      m_y[i] /= m_numerator;
    }
  }

  Integer dot(std::size_t i, std::size_t j) const
  {
    return m_x[i % 3] * m_x[j % 3] + m_y[i % 3] * m_y[j % 3] * m_radicand;
  }
  // In units of the root.
  Integer cross(std::size_t i, std::size_t j) const { return m_x[i % 3] * m_y[j % 3] - m_y[i % 3] * m_x[j % 3]; }

  // Of side j in the frame of side i, of length 1.
  Double_double_vector direction(std::size_t i, std::size_t j) const
  {
    const Integer squares = dot(i, i) * dot(j, j), along = dot(i, j), across = cross(i, j);
    const Double_double x = sqrt(precise_quotient(along * along, squares));
    const Double_double y = sqrt(precise_quotient(across * across * m_radicand, squares));
    return {along < 0 ? -x : x, across < 0 ? -y : y};
  }

  // Side i is (m_x[i] + i m_y[i] root) m_numerator / m_denominator times the first side of the face.
  std::array<Integer, 3> m_x, m_y;
  Integer m_numerator, m_denominator, m_radicand;
  Double_double m_face_length;
  double m_error;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_EXACT_SUBFACE_H
