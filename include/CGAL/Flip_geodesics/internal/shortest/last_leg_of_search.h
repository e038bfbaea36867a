// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_LAST_LEG_OF_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_LAST_LEG_OF_SEARCH_H

#include <CGAL/Flip_geodesics/internal/distances/Last_leg.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* How a shortest path arrives that a search has found. \pre the path has an edge */
template <class Triangulation, class Search>
Last_leg last_leg(const Triangulation&, const Search& search, Vertex_index v)
{
  return search.last_leg(v);
}

template <class Triangulation, class Faces>
Last_leg last_leg(const Triangulation& triangulation, const Window_search<Triangulation, Faces>& search, Vertex_index v)
{
  const auto leg = search.leg(v);
  const Strip<Triangulation> strip(triangulation, leg.word.reversed());
  return {leg.from, strip.reference(), angle_from_reference(strip.end()), strip.length()};
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SHORTEST_LAST_LEG_OF_SEARCH_H
