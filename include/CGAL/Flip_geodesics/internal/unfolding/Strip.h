// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRIP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Face_strip.h>

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
 * Returns the difference of the barycentric coordinates of two points, whose weights can have any sum. The products are
 * computed with their rounding errors, so that the result is accurate however close the points are.
 */
inline std::array<double, 3> barycentric_difference(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  const auto sum_with_error = [](const std::array<double, 3>& w) {
    const Double_double a = exact_sum(w[0], w[1]), b = exact_sum(a.high, w[2]);
    return Double_double{b.high, a.low + b.low};
  };
  const Double_double from_sum = sum_with_error(from), to_sum = sum_with_error(to);
  std::array<double, 3> result;
  for(int i = 0; i < 3; ++i) {
    const Double_double product = exact_product(from[i], to_sum.high);
    const double difference = std::fma(to[i], from_sum.high, -product.high) - product.low; // [Kahan]
    result[i] =
        (difference + (unfused(to[i] * from_sum.low) - unfused(from[i] * to_sum.low))) / (from_sum.high * to_sum.high);
  }
  return result;
}

/*
 * The input faces along an edge sequence, unfolded into the plane from the input's own coordinates. The vector of an
 * edge is thus independent of the flips that led to it. The error is that of a `Layout_in_double`.
 *
 * The tail lies at the origin; the frame is that of the reference halfedge, the tail's anchor, which has the first face
 * on its left and points along the positive real axis. If the tail is an input vertex, the reference starts there; if
 * it is a point of an edge, the reference passes through it. An edge along an input halfedge refers to that halfedge.
 */
template <class Triangulation>
class Strip
{
  using Layout = Layout_in_double<Triangulation>;

public:
  using Vector = std::complex<double>;

  /// The two ends of a crossed input edge, as seen along the path.
  struct Portal
  {
    Input_halfedge_index crossed; // the input halfedge as in the sequence; its tail is on the right
    Vector right, left;
    double right_error, left_error; // bounds
  };

  /// A corner of an unfolded face, with a bound of its error.
  using Corner = typename Layout::Corner;

  Strip(const Triangulation& triangulation, const Edge_sequence& sequence)
    : m_triangulation(&triangulation)
  {
    m_reference = tail_anchor(triangulation, sequence);
    if(sequence.along != null_index)
      lay_out_edge(sequence);
    else if(sequence.crossed.empty())
      lay_out_inside(sequence);
    else
      unfold(sequence);
  }

  Input_halfedge_index reference() const { return m_reference; }

  /*
   * Returns the corners of the face between portals i - 1 and i as positions of the tails of h, next(h) and
   * previous(h), where h is the halfedge across which the face is left, or entered if it is the last. \pre there is a
   * portal
   */
  std::array<Corner, 3> face(std::size_t i) const
  {
    const bool is_last = i == m_portals.size();
    const Portal& portal = m_portals[is_last ? i - 1 : i];
    const Corner right = {portal.right, portal.right_error}, left = {portal.left, portal.left_error};
    if(is_last)
      return {left, right, m_last_corner};
    if(i == 0)
      return {right, left, m_first_corner};
    const Portal& before = m_portals[i - 1];
    const bool is_right_kept = portal.crossed == m_triangulation->input().next(twin_index(before.crossed));
    return {right, left,
            is_right_kept ? Corner{before.left, before.left_error} : Corner{before.right, before.right_error}};
  }
  const std::vector<Portal>& portals() const { return m_portals; }
  const Vector& end() const { return m_end; }
  double end_error() const { return m_error; }

  /* Returns the reference of the edge's reverse direction, and below a vector along that direction in the reference's
   * frame; the reference is `null_index` if an end of the edge is an inserted vertex. */
  Input_halfedge_index arrival_reference() const { return m_arrival_reference; }
  const Vector& arrival() const { return m_arrival; }

  double length() const { return std::abs(m_end); }

  /* Returns a bound of the error of arrival(), relative to its length: that of end(), and of the last face's
   * rotation. */
  double arrival_error() const
  {
    return relative_error() + static_cast<double>(m_portals.size() + 3) * face_ratio_error;
  }

  /* Returns a bound of the error of end(), relative to its length; infinite if the error is at least half that
   * length. */
  double relative_error() const
  {
    const double length = std::abs(m_end);
    return length > 2 * m_error ? m_error / (length - m_error) : std::numeric_limits<double>::infinity();
  }

  /*
   * Returns the largest angle by which an end of a crossed edge lies on the wrong side of the straight line from tail
   * to head, seen from the nearer end of that line: zero if the line stays inside the strip.
   */
  double bend() const
  {
    double result = 0;
    for(const Portal& portal : m_portals)
      result = (std::max)(result, bend(portal));
    return result;
  }

  /* Returns that angle for one crossed edge. */
  double bend(const Portal& portal) const
  {
    return (std::max)(wrong_side_angle(portal.left), wrong_side_angle(std::conj(portal.right), true));
  }

  /* Returns the position at which the straight line crosses portal i, from 0 at the right end to 1 at the left end. */
  double crossing(std::size_t i) const
  {
    const double right = (std::max)(-cross(m_end, m_portals[i].right), 0.0);
    const double left = (std::max)(cross(m_end, m_portals[i].left), 0.0);
    return right + left > 0 ? right / (right + left) : 0.5;
  }

  /* Returns the position at which portal i crosses the straight line, from 0 at the tail to 1 at the head. */
  double crossing_along(std::size_t i) const
  {
    const Vector right = m_portals[i].right, portal = m_portals[i].left - right;
    const double whole = cross(m_end, portal);
    return whole > 0 ? (std::min)((std::max)(cross(right, portal) / whole, 0.0), 1.0) : 0.5;
  }

private:
  double wrong_side_angle(const Vector& p, bool is_mirrored = false) const
  {
    const Vector end = is_mirrored ? std::conj(m_end) : m_end;
    const double doubled_area = cross(end, p);
    if(doubled_area >= 0)
      return 0;
    const double height = doubled_area / std::abs(end);
    const double base = (std::min)(std::abs(p), std::abs(p - end));
    return base > 0 ? std::asin((std::min)(-height / base, 1.0)) : 0;
  }

  void lay_out_edge(const Edge_sequence& sequence)
  {
    const Input_halfedge_index h = sequence.along;
    m_error = 0; // the direction is exact
    m_end = m_triangulation->metric().length(m_triangulation->input(), h);
    if(m_triangulation->is_inserted(sequence.tail) || m_triangulation->is_inserted(sequence.head)) {
      m_end *= barycentric_difference(weights(sequence.tail, h), weights(sequence.head, h))[1];
    } else {
      m_arrival_reference = twin_index(h);
      m_arrival = m_end;
    }
  }

  // Computed from weights of both ends in one face, so that the ends may be close together.
  void lay_out_inside(const Edge_sequence& sequence)
  {
    const Face_vectors face = first_face();
    const auto d = barycentric_difference(weights(sequence.tail, m_reference), weights(sequence.head, m_reference));
    m_end = unfused(d[1] * face[0]) - unfused(d[2] * face[2]);
    m_error = face_ratio_error * (std::abs(d[1]) * std::abs(face[0]) + std::abs(d[2]) * std::abs(face[2]));
  }

  Face_vectors first_face() const
  {
    return Layout(*m_triangulation)
        .sides(m_reference, m_triangulation->metric().length(m_triangulation->input(), m_reference));
  }

  std::array<double, 3> weights(Vertex_index v, Input_halfedge_index h) const
  {
    return vertex_weights(*m_triangulation, v, h);
  }

  // The corners of the first face relative to the tail of the edge sequence: the tails of the reference and of the next
  // and the previous halfedge.
  std::array<Corner, 3> first_corners(const Edge_sequence& sequence, const Face_vectors& f) const
  {
    if(!m_triangulation->is_inserted(sequence.tail)) {
      const double error = face_ratio_error * std::abs(f[0]);
      return {{{0, 0}, {f[0], error}, {f[0] + f[1], error + face_ratio_error * std::abs(f[1])}}};
    }
    return Layout::corners(f, weights(sequence.tail, m_reference));
  }

  void unfold(const Edge_sequence& sequence)
  {
    const Face_vectors sides = first_face();
    const std::array<Corner, 3> first = first_corners(sequence, sides);
    Face_strip<Layout> faces(Layout(*m_triangulation), m_reference, sides, first);
    const int side = faces.number_of(sequence.crossed.front());
    faces.leave_over(side);
    m_first_corner = first[(side + 2) % 3];
    m_portals.resize(sequence.crossed.size());
    Portal* here = m_portals.data();
    faces.cross(sequence.crossed, [&](Input_halfedge_index crossed, const Corner& right, const Corner& left) {
      *here++ = {crossed, right.position, left.position, right.error, left.error};
    });
    m_last_corner = faces.corners()[2];
    if(m_triangulation->is_inserted(sequence.head))
      return end_in_face(weights(sequence.head, faces.halfedge()), faces.sides(),
                         Layout::turn_error(sequence.crossed.size()));
    m_end = m_last_corner.position;
    m_error = m_last_corner.error;
    if(!m_triangulation->is_inserted(sequence.tail)) {
      m_arrival_reference = faces.side(2);
      m_arrival = product(-m_end, std::conj(faces.sides()[2]));
    }
  }

  // A point of the last face, computed from the nearer end of the last portal.
  void end_in_face(const std::array<double, 3>& w, const Face_vectors& face, double turn_error)
  {
    const double sum = w[0] + w[1] + w[2], at_left = w[0] / sum, at_right = w[1] / sum, at_apex = w[2] / sum;
    const Portal& portal = m_portals.back();
    const double from_right = unfused(at_left * std::abs(face[0])) + unfused(at_apex * std::abs(face[1]));
    const double from_left = unfused(at_right * std::abs(face[0])) + unfused(at_apex * std::abs(face[2]));
    if(from_right < from_left) {
      m_end = portal.right + unfused(at_apex * face[1]) - unfused(at_left * face[0]);
      m_error = portal.right_error + turn_error * from_right;
    } else {
      m_end = portal.left + unfused(at_right * face[0]) - unfused(at_apex * face[2]);
      m_error = portal.left_error + turn_error * from_left;
    }
    m_error += face_ratio_error * std::abs(m_end);
  }

  const Triangulation* m_triangulation;
  Input_halfedge_index m_reference = null_index, m_arrival_reference = null_index;
  std::vector<Portal> m_portals;
  Corner m_first_corner = {0, 0}, m_last_corner = {0, 0}; // of the first and last face, not on a portal
  Vector m_end, m_arrival;
  double m_error = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_STRIP_H
