// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SPOKES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SPOKES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/umbrellas.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

inline Halfedge_index index_of(Halfedge_index h) { return h; }
template <class Walker>
Halfedge_index index_of(const Walker& h)
{
  return h.index();
}

/* Replaces what a range holds by the halfedges that start at v, clockwise, from the border if there is one; as walkers
 * or by their indices. At a non-manifold vertex they come umbrella by umbrella, as the border leads from one to the
 * next. */
template <class Triangulation, class Spoke>
void collect_spokes(const Triangulation& triangulation, Vertex_index v, std::vector<Spoke>& result)
{
  using Walker = typename Triangulation::Walker;
  constexpr bool are_walkers = std::is_same<Spoke, Walker>::value;
  const auto add = [&result](const Walker& h) {
    if constexpr(are_walkers)
      result.push_back(h);
    else
      result.push_back(h.index());
  };
  result.clear();
  const Halfedge_index start = triangulation.outgoing(v);
  if(start == null_index)
    return;
  const auto first = triangulation.walker(start);
  auto h = first;
  do {
    add(h);
    h = h.counterclockwise();
  } while(!h.is_none() && h != first);
  std::reverse(h.is_none() ? result.begin() : result.begin() + 1, result.end());
  if(!h.is_none())
    return;
  for(h = first.clockwise(); !h.is_none(); h = h.clockwise())
    add(h);
  if constexpr(Has_words<Triangulation>::value) // others are manifolds
    for_each_spoke_of_other_umbrellas(triangulation, index_of(result.front()),
                                      [&](Halfedge_index g) { add(triangulation.walker(g)); });
}

/* The halfedges that start at v, clockwise, from the border if there is one. */
template <class Triangulation>
std::vector<Halfedge_index> spokes(const Triangulation& triangulation, Vertex_index v)
{
  std::vector<Halfedge_index> result;
  collect_spokes(triangulation, v, result);
  return result;
}

/* The halfedges that start at the vertex of an input halfedge, as far as they are in the same umbrella. */
template <class Triangulation>
std::vector<Halfedge_index> spokes_beside(const Triangulation& triangulation, Input_halfedge_index h)
{
  const Input_halfedge_index border = border_of_umbrella(triangulation.input(), h);
  if(border == null_index)
    return spokes(triangulation, triangulation.input().tail(h));
  std::vector<Halfedge_index> result;
  for(Halfedge_index g = first_spoke(triangulation, border); g != null_index; g = triangulation.clockwise(g))
    result.push_back(g);
  return result;
}

/* The shortest edge from v to w, of equally long ones the first by index; null_index if there is none. */
template <class Triangulation>
Halfedge_index halfedge_between(const Triangulation& triangulation, Vertex_index v, Vertex_index w)
{
  Halfedge_index best = null_index;
  for(Halfedge_index h : spokes(triangulation, v)) {
    if(triangulation.head(h) != w)
      continue;
    const bool is_better = best == null_index || triangulation.length(h) < triangulation.length(best) ||
                           (triangulation.length(h) == triangulation.length(best) && h < best);
    if(is_better)
      best = h;
  }
  return best;
}

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SPOKES_H
