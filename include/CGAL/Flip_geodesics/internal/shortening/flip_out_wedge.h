// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTENING_FLIP_OUT_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTENING_FLIP_OUT_WEDGE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * [SC20, Algorithm 1]: flips the edges out of the wedge from halfedge a clockwise to halfedge c of one vertex, whose
 * angle is below pi, the first with beta < pi first. `flip(h)` is to flip the edge of h. Then writes the outer arc,
 * which leads from the head of a to that of c with the wedge on its right, and returns its length.
 *
 *            n_1 ------ n_2          spokes b -> a, n_1, ..., c are passed clockwise
 *           /   .     .   .
 *          /  beta  .      .         beta_j: the angle at n_j, inside the wedge
 *         a      . .        c
 *          .     .        .
 *            x    .    .  y
 *               .  . .
 *                  b
 */
template <class Triangulation, class Flip>
double flip_out_wedge(const Triangulation& triangulation, Halfedge_index a, Halfedge_index c,
                      std::vector<Halfedge_index>& arc, Flip flip)
{
  using Walker = typename Triangulation::Walker;
  const Walker first = triangulation.walker(a), last = triangulation.walker(c);
  Walker spoke = first.clockwise();
  while(spoke != last) {
    if(triangulation.is_reflex_at_head(spoke)) {
      spoke = spoke.clockwise();
      continue;
    }
    const Walker before = spoke.counterclockwise(), after = spoke.clockwise();
    flip(spoke.index());
    spoke = before == first ? after : before;
  }

  double length = 0;
  arc.clear();
  spoke = first;
  do { // a == c is all the way round
    const Walker outer = spoke.twin().previous().twin();
    outer.prefetch_face(); // to be looked at when the curve lies on the arc
    arc.push_back(outer.index());
    length += outer.length();
    spoke = spoke.clockwise();
  } while(spoke != last);
  return length;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTENING_FLIP_OUT_WEDGE_H
