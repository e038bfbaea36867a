// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_SHAPE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_SHAPE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Does a curve lie on the edge of h, or is it on the border? */
template <class Triangulation>
bool is_constrained_edge(const Triangulation& triangulation, Halfedge_index h)
{
  return triangulation.holds(Triangulation::edge(h)) != 0 || triangulation.is_border(h) ||
         triangulation.is_border(Triangulation::twin(h));
}

/* Lengths and angles of an intrinsic face, rounded. Side i leads from corner i to corner i + 1; side 0 is h. */
template <class Triangulation>
class Face_shape
{
public:
  Face_shape(const Triangulation& triangulation, Halfedge_index h)
  {
    for(int i = 0; i < 3; ++i, h = triangulation.next(h)) {
      m_sides[i] = h;
      m_lengths[i] = triangulation.length(h);
    }
  }

  static Halfedge_index first_halfedge(const Triangulation& triangulation, Halfedge_index h)
  {
    const Halfedge_index hn = triangulation.next(h);
    return (std::min)({h, hn, triangulation.next(hn)});
  }

  const std::array<double, 3>& lengths() const { return m_lengths; }

  /* The angle at corner i. */
  double angle(int i) const
  {
    // By half-angles [Kahan]: accurate whatever the shape is, if differences are taken in this order.
    const double a = m_lengths[(i + 1) % 3], b = (std::max)(m_lengths[i], m_lengths[(i + 2) % 3]),
                 c = (std::min)(m_lengths[i], m_lengths[(i + 2) % 3]);
    const double rest = c >= a ? a - (b - c) : c - (b - a);
    const double low = (std::max)(((b - c) + a) * rest, 0.0), high = (std::max)((b + (c + a)) * ((b - a) + c), 0.0);
    return 2 * std::atan2(std::sqrt(low), std::sqrt(high));
  }

  /* The cosine of the angle opposite to side 0. */
  double cosine_opposite() const { return std::cos(angle(2)); }

  int smallest_corner() const
  {
    const int shortest = static_cast<int>((std::min_element)(m_lengths.begin(), m_lengths.end()) - m_lengths.begin());
    return (shortest + 2) % 3;
  }

  double smallest_angle() const { return angle(smallest_corner()); }

  double shortest() const { return (std::min)({m_lengths[0], m_lengths[1], m_lengths[2]}); }
  double longest() const { return (std::max)({m_lengths[0], m_lengths[1], m_lengths[2]}); }

  /* The shortest side. */
  Halfedge_index shortest_side() const { return m_sides[(smallest_corner() + 1) % 3]; }

  /* The spoke with the smallest corner on its left. */
  Halfedge_index spoke_of_smallest_corner() const { return m_sides[smallest_corner()]; }

private:
  std::array<Halfedge_index, 3> m_sides;
  std::array<double, 3> m_lengths;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_FACE_SHAPE_H
