// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WEDGE_H

#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>

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
double flip_out_wedge(const Triangulation& triangulation, Index a, Index c, std::vector<Index>& arc, Flip flip)
{
  Index spoke = triangulation.clockwise(a);
  while(spoke != c) {
    if(triangulation.is_reflex_at_head(spoke)) {
      spoke = triangulation.clockwise(spoke);
      continue;
    }
    const Index before = triangulation.counterclockwise(spoke), after = triangulation.clockwise(spoke);
    flip(spoke);
    spoke = before == a ? after : before;
  }

  double length = 0;
  arc.clear();
  spoke = a;
  do { // a == c is all the way round
    const Index t = Triangulation::twin(spoke);
    arc.push_back(Triangulation::twin(triangulation.previous(t)));
    triangulation.prefetch_face(arc.back()); // to be looked at when the curve lies on the arc
    length += triangulation.length(arc.back());
    spoke = triangulation.next(t);
  } while(spoke != c);
  return length;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WEDGE_H
