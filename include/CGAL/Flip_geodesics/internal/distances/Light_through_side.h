// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LIGHT_THROUGH_SIDE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LIGHT_THROUGH_SIDE_H

#include <CGAL/Flip_geodesics/internal/distances/Edge_cones.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What comes in through a side of a face, from the points of its cones, and lights another side, which lies on the x-axis
 * from 0 on. The first one leaves 0 in some direction, and ends at the apex.
 */
class Light_through_side
{
  using Vector = std::complex<double>;

public:
  Light_through_side(const Edge_cones& cones, double side_length, const Vector& direction, double error)
    : m_cones(cones)
    , m_side_length(side_length)
    , m_direction(direction)
    , m_error(error)
  {
  }

  /* Adds it to what lights a side of some length, or its mirror image; returns up to where, if that is one cone. */
  double add_to(Lit_parts& parts, double length, bool is_mirrored) const
  {
    const int number = m_cones.split < m_side_length ? 2 : 1;
    double end = 0;
    for(int i = 0; i < number; ++i) {
      Cone cone = seen(i == 0 ? m_cones.first : m_cones.second);
      const bool is_first = i + 1 < number;
      // No gap is left between what two cones light, nor where the second one lights nothing.
      const bool is_alone = is_first && seen(m_cones.second).y < -m_error && cone.y >= -m_error;
      const double lit = lit_length(cone, is_first ? m_cones.split : m_side_length, length);
      const double to = is_alone ? length : lit;
      const double from = i == 0 ? 0 : (std::min)(lit_length(cone, m_cones.split, length) - cone_overlap * length, end);
      cone.y = std::abs(cone.y); // what lies below the edge sends nothing up, up to rounding
      const Cone turned = is_mirrored ? Cone{length - cone.x, cone.y, cone.sigma} : cone;
      if(is_mirrored)
        parts.add(turned, length - to, length - (std::max)(from, 0.0));
      else
        parts.add(turned, (std::max)(from, 0.0), to);
      end = (std::max)(end, to);
    }
    return number == 1 ? end : 0;
  }

private:
  // A cone over the side it comes in through, in the frame of the side that is lit.
  Cone seen(const Cone& cone) const
  {
    const Vector place = Vector(cone.x, cone.y) * m_direction;
    return {place.real(), place.imag(), cone.sigma};
  }

  /*
   * How much of a side from 0 on is lit from a point, past a place on the side it comes in through that is farther on: up
   * to where the line through there ends, and a little more.
   */
  double lit_length(const Cone& cone, double place, double length) const
  {
    if(cone.y < -m_error)
      return 0;
    const Vector past = place * m_direction;
    const double fall = cone.y - past.imag();
    if(!(fall > 8 * m_error))
      return length;
    const double end = past.real() + (past.real() - cone.x) * (past.imag() / fall);
    const double enlargement = cone_enlargement + 8 * m_error / fall; // of the edge
    return (std::min)((std::max)(end, 0.0) + enlargement * length, length);
  }

  const Edge_cones& m_cones;
  double m_side_length;
  Vector m_direction;
  double m_error;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LIGHT_THROUGH_SIDE_H
