// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_WEDGE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Is the angle clockwise from one halfedge of a vertex to another below pi, with neither the border in between nor a
 * halfedge that `is_blocked`? Then `turn` is that angle. */
template <class Triangulation, class IsBlocked>
bool is_free_wedge(const Triangulation& triangulation, const typename Triangulation::Walker& a,
                   const typename Triangulation::Walker& c, typename Triangulation::Turn& turn,
                   const IsBlocked& is_blocked)
{
  auto h = a;
  do {
    h = h.extend_turn_clockwise(turn);
    if(h.is_none() || triangulation.is_straight(turn, a.index(), h.index()) || (h != c && is_blocked(h)))
      return false;
  } while(h != c);
  return true;
}

/* So many edges of a wedge are flipped in order. */
constexpr std::size_t few_flips_of_wedge = 64;

/*
 * Flips every second edge of a wedge, of those that can be flipped, again and again while these are many. So the edges
 * end up in the manner of a balanced tree, about two for each round at a vertex. In order, all would end at one vertex,
 * and if that is the next to be flipped out, all go on to its neighbor, and so on: a quadratic number of flips.
 *
 * Loop edges and what would become one are left alone, so that each flip takes one edge from the wedge. Linear, since a
 * round flips an eighth of the edges or is the last one.
 */
template <class Triangulation, class Flip>
void flip_every_second_one(const Triangulation& triangulation, Halfedge_index a, Halfedge_index c, Flip flip)
{
  using Walker = typename Triangulation::Walker;
  const Walker first = triangulation.walker(a), last = triangulation.walker(c);
  const Vertex_index middle = triangulation.tail(a);
  const auto is_loop = [&](const Walker& h) { return triangulation.head(h.index()) == middle; };
  for(bool are_many = true; are_many;) {
    std::size_t passed = 0, flipped = 0;
    for(Walker before = first, spoke = first.clockwise(); spoke != last; ++passed) {
      Walker after = spoke.clockwise();
      if(!is_loop(before) && !is_loop(spoke) && !is_loop(after) && !triangulation.is_reflex_at_head(spoke)) {
        flip(spoke.index());
        ++flipped;
        if(after == last)
          break;
        spoke = after;
        after = spoke.clockwise();
      }
      before = spoke;
      spoke = after;
    }
    are_many = 8 * flipped > passed;
  }
}

/*
 * [SC20, Algorithm 1]: flips the edges out of the wedge from halfedge a clockwise to halfedge c of one vertex, whose
 * angle is below pi, the first with beta < pi first; but not if they are more than `most_in_order`, since the order
 * makes no difference to the arc. `flip(h)` is to flip the edge of h. Then writes the outer arc, which leads from the
 * head of a to that of c with the wedge on its right, and returns its length.
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
                      std::vector<Halfedge_index>& arc, Flip flip, std::size_t most_in_order = few_flips_of_wedge)
{
  using Walker = typename Triangulation::Walker;
  const Walker first = triangulation.walker(a), last = triangulation.walker(c);
  Walker spoke = first.clockwise();
  for(std::size_t flips = 0; spoke != last;) {
    if(triangulation.is_reflex_at_head(spoke)) {
      spoke = spoke.clockwise();
      continue;
    }
    const Walker before = spoke.counterclockwise(), after = spoke.clockwise();
    flip(spoke.index());
    spoke = before == first ? after : before;
    if(++flips == most_in_order) {
      flip_every_second_one(triangulation, a, c, flip);
      spoke = first.clockwise();
    }
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_WEDGE_H
