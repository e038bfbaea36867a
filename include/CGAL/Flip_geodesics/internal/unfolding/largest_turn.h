// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_LARGEST_TURN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_LARGEST_TURN_H

#include <CGAL/Flip_geodesics/internal/numbers/Taut_string.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A turn of a path about an end of a gate, in radians, between 0 and pi. */
struct Gate_turn
{
  std::size_t gate = 0; // the first one with that end
  Gate_side side = LEFT_END;
  double angle = 0;
};

/* The gates of a strip for a string: the right end of the first one becomes the origin. \pre there are gates */
template <class Triangulation>
std::vector<Unfolded_gate> unfolded_gates(const Triangulation& triangulation, const Strip<Triangulation>& strip)
{
  const auto& gates = strip.gates();
  std::vector<Unfolded_gate> result = {{gates[0].left - gates[0].right, LEFT_END}};
  for(std::size_t i = 1; i < gates.size(); ++i) {
    const bool is_right_kept = gates[i].crossed == triangulation.input().next(twin_index(gates[i - 1].crossed));
    result.push_back(
        {(is_right_kept ? gates[i].left : gates[i].right) - gates[0].right, is_right_kept ? LEFT_END : RIGHT_END});
  }
  return result;
}

/* The largest turn of the shortest path through the gates of a strip, rounded; an angle of 0 if it is straight. */
template <class Triangulation>
Gate_turn largest_turn(const Triangulation& triangulation, const Strip<Triangulation>& strip)
{
  const Plane_vector origin = strip.gates()[0].right, target = strip.end() - origin;
  Taut_string string;
  string.pull(unfolded_gates(triangulation, strip), -origin, target);
  Gate_turn result;
  Plane_vector before = -origin;
  for(std::size_t i = 0; i < string.bends().size(); ++i) {
    const Taut_string::Bend& bend = string.bends()[i];
    const Plane_vector after = i + 1 < string.bends().size() ? string.bends()[i + 1].position : target;
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
