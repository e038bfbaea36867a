// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_OVERLAPPING_CURVES_H
#define CGAL_FLIP_GEODESICS_OVERLAPPING_CURVES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/internal/network/Stack_order.h>
#include <CGAL/Flip_geodesics/internal/network/Stack_order_search.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* Orders the strands on each edge. Returns what is in the way, if there is anything; then the order is of no use. */
template <class Network>
Order_conflict order_stacks(Network& network)
{
  const Stack_pairs<Network> pairs(network);
  if(pairs.conflict() || pairs.number_of_stacks() == 0)
    return pairs.conflict();
  Crossing_equations<Network> equations(pairs);
  if(equations.conflict())
    return equations.conflict();
  Stack_order_search<Network> search(equations);
  if(const Order_conflict conflict = search.run())
    return conflict;
  for(Index i = 0; i < pairs.number_of_stacks(); ++i)
    network.set_stack(pairs.edge(i), search.order(i));
  return {};
}

/* As `order_overlapping_curves()`, but returns what it throws. */
template <class Network>
Order_conflict order_if_possible(Network& network)
{
  Order_conflict conflict = order_stacks(network);
  if(conflict)
    return conflict;
  const auto& triangulation = network.triangulation();
  for_each_vertex(triangulation, occupied_halfedges(network), [&](auto first, auto) {
    if(!conflict && !network.is_non_crossing_at({*first, network.outermost(*first, Side::LEFT)}))
      conflict.v = triangulation.tail(*first);
  });
  return conflict;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Finds the order in which the curves of a network lie side by side on the edges that they share. In it no two cross,
 * nor does one cross itself. To be called after the curves were added: `add_curve()` puts them on an edge in the order
 * in which they come.
 *
 * Two strands that share a run of edges are ordered by where they part, at either end of it. Where a path ends, or has
 * a fixed node, the order is left open. But all such ends at a vertex, and the border, must be on one side of each
 * curve that passes. What is left open at both ends follows from the order of others on the same edges, or else is
 * chosen. The strand that was added first is then on the left, as seen along it. It is seen against it if its curve has
 * turned back an odd number of times before. So copies of a curve that does not turn back lie to its right.
 *
 * The answer depends on the connectivity only, and is exact. If there is an order, it is found. If there is none, the
 * curves cross however they lie. Two do that part on opposite sides at the ends of a run. So does one that goes around
 * an annulus twice before it closes. Only where long paths turn back on each other again and again, and their choices
 * interlock, may the search be given up.
 *
 * If it throws, the curves are unchanged, but the order along the edges may not be.
 *
 * Complexity: for \f$n\f$ segments, \f$O(n \log n)\f$ and the degrees of the vertices they pass. If edges have several,
 * there are \f$p\f$ pairs of segments on one edge besides. They take \f$O(p \log p)\f$ time, half a second per million,
 * and \f$O(p)\f$ memory. Where the choices above do not fit together, it is \f$p\f$ times the most segments on one
 * edge.
 *
 * \param network an `Edge_path_network`
 * \throws Crossing_curves_error with a vertex at which curves cross; where only several vertices together make it
 *         impossible that they do not, with one of these
 * \throws Ambiguous_order_error with the vertices of a shared edge, if the search is given up
 */
template <class Network>
void order_overlapping_curves(Network& network)
{
  if(const internal::Order_conflict conflict = internal::order_if_possible(network))
    conflict.raise();
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_OVERLAPPING_CURVES_H
