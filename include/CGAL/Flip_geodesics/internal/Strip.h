// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRIP_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The input faces along a crossing word, unfolded into the plane from the input's own coordinates: whatever flips led
 * to the edge, its vector is fresh here. The error is normwise, a few units in the last place per face, whatever the
 * shapes of the faces.
 *
 * The tail lies at the origin; the frame is that of the reference halfedge: `reference()` starts at the tail, keeps the
 * first face on its left, and points along the positive real axis. An edge along an input halfedge refers to itself.
 */
template <class Triangulation>
class Strip
{
public:
  using Vector = std::complex<double>;

  /// The two ends of a crossed input edge as seen by the traveller.
  struct Gate
  {
    Index crossed; // the input halfedge as in the word; its tail is on the right
    Vector right, left;
    double right_error, left_error; // bounds
  };

  Strip(const Triangulation& triangulation, const Crossing_word& word)
    : m_triangulation(&triangulation)
  {
    if(word.along != null_index)
      lay_out_edge(word.along);
    else
      unfold(word.crossed);
  }

  Index reference() const { return m_reference; }
  const std::vector<Gate>& gates() const { return m_gates; }
  const Vector& end() const { return m_end; }
  double length() const { return std::abs(m_end); }

  /* A bound of the error of end(), relative to its length; infinite if that is all error. */
  double relative_error() const
  {
    const double length = std::abs(m_end);
    return length > 2 * m_error ? m_error / (length - m_error) : std::numeric_limits<double>::infinity();
  }

  /*
   * The largest angle by which an end of a crossed edge lies on the wrong side of the straight line from tail to head,
   * seen from the nearer end of that line: zero if the line stays inside the strip.
   */
  double bend() const
  {
    double result = 0;
    for(const Gate& gate : m_gates)
      result = (std::max)({result, wrong_side_angle(gate.left), wrong_side_angle(std::conj(gate.right), true)});
    return result;
  }

  /* Where the straight line crosses gate i, from 0 at the right end to 1 at the left end. */
  double crossing(std::size_t i) const
  {
    const double right = (std::max)(-cross(m_end, m_gates[i].right), 0.0);
    const double left = (std::max)(cross(m_end, m_gates[i].left), 0.0);
    return right + left > 0 ? right / (right + left) : 0.5;
  }

  /* Where gate i crosses the straight line, from 0 at the tail to 1 at the head. */
  double crossing_along(std::size_t i) const
  {
    const Vector right = m_gates[i].right, gate = m_gates[i].left - right;
    const double whole = cross(m_end, gate);
    return whole > 0 ? (std::min)((std::max)(cross(right, gate) / whole, 0.0), 1.0) : 0.5;
  }

private:
  using Face_vectors = std::array<Vector, 3>;

  // Bounds the relative error of the quotient of two vectors of a face, and of the product with another: a layout's
  // vector has 16 units of roundoff at most, from differences (2), dot or cross products (8), roots and quotients (3).
  static constexpr double ratio_error = 48 * std::numeric_limits<double>::epsilon();

  static double cross(const Vector& u, const Vector& v) { return u.real() * v.imag() - u.imag() * v.real(); }

  double wrong_side_angle(const Vector& p, bool is_mirrored = false) const
  {
    const Vector end = is_mirrored ? std::conj(m_end) : m_end;
    const double height = cross(end, p) / std::abs(end);
    if(height >= 0)
      return 0;
    const double base = (std::min)(std::abs(p), std::abs(p - end));
    return base > 0 ? std::asin((std::min)(-height / base, 1.0)) : 0;
  }

  // The vectors of h, next(h), previous(h) of an input face, turned so that h lies along the given vector.
  Face_vectors face_along(Index h, const Vector& along) const
  {
    using Double_traits = Intrinsic_triangulation_traits<typename Triangulation::Metric::Kernel>;
    const auto face = m_triangulation->metric().face_geometry(m_triangulation->input(), h, Double_traits());
    const Vector turn = along / face[0].x; // the layout puts h on the positive real axis
    return {along, turn * Vector(face[1].x, face[1].y), turn * Vector(face[2].x, face[2].y)};
  }

  void lay_out_edge(Index h)
  {
    m_reference = h;
    m_error = 0; // the direction is exact
    m_end = m_triangulation->metric().length(m_triangulation->input(), h);
  }

  void unfold(const std::vector<Index>& crossed)
  {
    const auto& input = m_triangulation->input();
    m_reference = input.next(input.next(crossed.front()));
    const Face_vectors first = face_along(m_reference, m_triangulation->metric().length(input, m_reference));
    Vector right = first[0], left = right + first[1], gate = -first[1];
    double right_error = ratio_error * std::abs(right), left_error = right_error + ratio_error * std::abs(gate);
    m_gates.reserve(crossed.size());
    for(std::size_t i = 0;; ++i) {
      m_gates.push_back({crossed[i], right, left, right_error, left_error});
      // From left to right, on to the apex, and back. The vectors are products of the corners' ratios, never
      // differences of positions, which would magnify the error wherever a gate is short.
      const Index entered = Triangulation::twin(crossed[i]);
      const Face_vectors face = face_along(entered, gate);
      const bool is_near_right = std::abs(face[1]) < std::abs(face[2]);
      const Vector apex = is_near_right ? right + face[1] : left - face[2];
      const double turn_error = static_cast<double>(i + 2) * ratio_error;
      const double apex_error =
          (is_near_right ? right_error + turn_error * std::abs(face[1]) : left_error + turn_error * std::abs(face[2])) +
          ratio_error * std::abs(apex);
      if(i + 1 == crossed.size()) {
        m_end = apex;
        m_error = apex_error;
        return;
      }
      const bool is_leaving_right = crossed[i + 1] == input.next(entered);
      gate = is_leaving_right ? -face[1] : -face[2];
      (is_leaving_right ? left : right) = apex;
      (is_leaving_right ? left_error : right_error) = apex_error;
    }
  }

  const Triangulation* m_triangulation;
  Index m_reference = null_index;
  std::vector<Gate> m_gates;
  Vector m_end;
  double m_error = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRIP_H
