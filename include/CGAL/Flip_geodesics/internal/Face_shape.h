// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FACE_SHAPE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FACE_SHAPE_H

#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Lengths and angles of an intrinsic face, rounded. Side i leads from corner i to corner i + 1; side 0 is h. */
template <class Triangulation>
class Face_shape
{
public:
  Face_shape(const Triangulation& triangulation, Index h)
    : m_triangulation(triangulation)
  {
    for(int i = 0; i < 3; ++i, h = triangulation.next(h)) {
      m_sides[i] = h;
      m_lengths[i] = triangulation.length(h);
    }
  }

  static Index first_halfedge(const Triangulation& triangulation, Index h)
  {
    const Index hn = triangulation.next(h);
    return (std::min)({h, hn, triangulation.next(hn)});
  }

  const std::array<double, 3>& lengths() const { return m_lengths; }

  /* The angle at corner i. */
  double angle(int i) const
  {
    const double a = m_lengths[(i + 1) % 3], b = m_lengths[i], c = m_lengths[(i + 2) % 3];
    // By half-angles [Kahan], which keeps small angles accurate.
    const double low = (std::max)((a - b + c) * (a + b - c), 0.0), high = (std::max)((a + b + c) * (b + c - a), 0.0);
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

  double longest() const { return (std::max)({m_lengths[0], m_lengths[1], m_lengths[2]}); }

  /* The shortest side. */
  Index shortest_side() const { return m_sides[(smallest_corner() + 1) % 3]; }

  /* The angle about the smallest corner's vertex between the constrained edges on both sides; all round without any. */
  double sector_angle() const { return sector_angle(m_sides[smallest_corner()]); }

private:
  // The angle about the tail of h between the constrained edges next to the face of h; all round if there are none.
  double sector_angle(Index h) const
  {
    double sum = angle_at_tail(h);
    for(Index g = h; !is_constrained(g);) { // clockwise
      g = m_triangulation.clockwise(g);
      if(g == h)
        return sum;
      sum += angle_at_tail(g);
    }
    for(Index g = m_triangulation.counterclockwise(h); !is_constrained(g); g = m_triangulation.counterclockwise(g))
      sum += angle_at_tail(g);
    return sum;
  }

  double angle_at_tail(Index h) const { return Face_shape(m_triangulation, h).angle(0); }

  bool is_constrained(Index h) const
  {
    return m_triangulation.label(h >> 1) != 0 || m_triangulation.is_border(h) ||
           m_triangulation.is_border(Triangulation::twin(h));
  }

  const Triangulation& m_triangulation;
  std::array<Index, 3> m_sides;
  std::array<double, 3> m_lengths;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FACE_SHAPE_H
