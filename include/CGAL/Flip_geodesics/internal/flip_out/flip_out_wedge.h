// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_WEDGE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <cstddef>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns whether the angle clockwise from one halfedge of a vertex to another is below pi, with neither the border nor
 * a halfedge that `is_blocked` in between. If so, sets `turn` to that angle. */
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

/* The number of edges of a wedge up to which they are flipped in order. */
constexpr std::size_t few_flips_of_wedge = 64;

/*
 * Repeatedly flips every second flippable edge of a wedge while the wedge has many edges. As in a balanced tree, each
 * round then adds about two edges at a vertex. In order, all edges would end at one vertex and, if that is flipped out
 * next, move on to its neighbor, and so on: a quadratic number of flips.
 *
 * Loop edges and edges whose flip would create one are skipped, so each flip removes one edge from the wedge. The
 * function takes linear time, since every round except the last flips at least an eighth of the edges.
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
    for(Walker before = first, outgoing_halfedge = first.clockwise(); outgoing_halfedge != last; ++passed) {
      Walker after = outgoing_halfedge.clockwise();
      if(!is_loop(before) && !is_loop(outgoing_halfedge) && !is_loop(after) &&
         !triangulation.is_reflex_at_head(outgoing_halfedge))
      {
        flip(outgoing_halfedge.index());
        ++flipped;
        if(after == last)
          break;
        outgoing_halfedge = after;
        after = outgoing_halfedge.clockwise();
      }
      before = outgoing_halfedge;
      outgoing_halfedge = after;
    }
    are_many = 8 * flipped > passed;
  }
}

/*
 * [SC20, Algorithm 1]: flips the edges out of the wedge from halfedge a clockwise to halfedge c of one vertex, whose
 * angle is below pi, always the first edge with beta < pi. If there are more than `most_in_order` edges, they are
 * flipped in another order, which does not change the arc. `flip(h)` must flip the edge of h. Writes the outer arc,
 * which leads from the head of a to that of c with the wedge on its right, and returns its length.
 *
 *            n_1 ------ n_2          edges b -> a, n_1, ..., c are passed clockwise
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
  Walker outgoing_halfedge = first.clockwise();
  for(std::size_t flips = 0; outgoing_halfedge != last;) {
    if(triangulation.is_reflex_at_head(outgoing_halfedge)) {
      outgoing_halfedge = outgoing_halfedge.clockwise();
      continue;
    }
    const Walker before = outgoing_halfedge.counterclockwise(), after = outgoing_halfedge.clockwise();
    flip(outgoing_halfedge.index());
    outgoing_halfedge = before == first ? after : before;
    if(++flips == most_in_order) {
      flip_every_second_one(triangulation, a, c, flip);
      outgoing_halfedge = first.clockwise();
    }
  }

  double length = 0;
  arc.clear();
  outgoing_halfedge = first;
  do { // a == c denotes the full turn
    const Walker outer = outgoing_halfedge.twin().previous().twin();
    outer.prefetch_face(); // will be examined when the curve lies on the arc
    arc.push_back(outer.index());
    length += outer.length();
    outgoing_halfedge = outgoing_halfedge.clockwise();
  } while(outgoing_halfedge != last);
  return length;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_WEDGE_H
