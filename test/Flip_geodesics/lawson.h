// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_LAWSON_H
#define FLIP_GEODESICS_TEST_LAWSON_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <vector>

namespace Flip_geodesics_test {

/// Flips edges that are not locally Delaunay, the last found first, until none is left or `limit` are flipped.
/// \return the number of flips, -1 if the limit was met or an edge could not be flipped
template <class Triangulation>
int flip_to_delaunay(Triangulation& triangulation, int limit)
{
  namespace FG = CGAL::Flip_geodesics;
  std::vector<FG::Halfedge_index> pending;
  for(FG::Edge_index e : FG::internal::descriptors<FG::Edge_index>(triangulation.number_of_edges()))
    pending.push_back(FG::internal::first_side(e));
  int flips = 0;
  while(!pending.empty()) {
    const FG::Halfedge_index h = pending.back();
    pending.pop_back();
    if(triangulation.is_locally_delaunay(h))
      continue;
    if(flips == limit || !triangulation.is_flippable(h))
      return -1;
    triangulation.flip(h);
    ++flips;
    for(FG::Halfedge_index side : {h, Triangulation::twin(h)})
      pending.insert(pending.end(), {triangulation.next(side), triangulation.previous(side)});
  }
  return flips;
}

template <class Triangulation>
bool are_all_edges_delaunay(const Triangulation& triangulation)
{
  namespace FG = CGAL::Flip_geodesics;
  for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(triangulation.number_of_halfedges()))
    if(!triangulation.is_locally_delaunay(h))
      return false;
  return true;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_LAWSON_H
