// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_LARGEST_TURN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_LARGEST_TURN_H

#include <CGAL/Flip_geodesics/internal/numbers/Funnel.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A turn of a path at an end of a portal, in radians, between 0 and pi. */
struct Portal_turn
{
  std::size_t portal = 0; // the first one with that end
  Portal_side side = LEFT_END;
  double angle = 0;
};

/* The gates of a strip as portals of a funnel: the right end of the first one becomes the origin. \pre there are gates */
template <class Triangulation>
std::vector<Portal> portals_of(const Triangulation& triangulation, const Strip<Triangulation>& strip)
{
  const auto& gates = strip.gates();
  std::vector<Portal> result = {{gates[0].left - gates[0].right, LEFT_END}};
  for(std::size_t i = 1; i < gates.size(); ++i) {
    const bool is_right_kept = gates[i].crossed == triangulation.input().next(twin_index(gates[i - 1].crossed));
    result.push_back(
        {(is_right_kept ? gates[i].left : gates[i].right) - gates[0].right, is_right_kept ? LEFT_END : RIGHT_END});
  }
  return result;
}

/* The largest turn of the shortest path through the gates of a strip, rounded; an angle of 0 if it is straight. */
template <class Triangulation>
Portal_turn largest_turn(const Triangulation& triangulation, const Strip<Triangulation>& strip)
{
  const Plane_vector origin = strip.gates()[0].right, target = strip.end() - origin;
  Funnel funnel;
  funnel.pull(portals_of(triangulation, strip), -origin, target);
  Portal_turn result;
  Plane_vector before = -origin;
  for(std::size_t i = 0; i < funnel.bends().size(); ++i) {
    const Funnel::Bend& bend = funnel.bends()[i];
    const Plane_vector after = i + 1 < funnel.bends().size() ? funnel.bends()[i + 1].position : target;
    const double angle = std::abs(std::arg((after - bend.position) * std::conj(bend.position - before)));
    if(angle > result.angle)
      result = {bend.first, bend.side, angle};
    before = bend.position;
  }
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_LARGEST_TURN_H
