// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_LAWSON_H
#define FLIP_GEODESICS_TEST_LAWSON_H

#include <vector>

namespace Flip_geodesics_test {

/// Flips edges that are not locally Delaunay, the last found first, until none is left or `limit` are flipped.
/// \return the number of flips, -1 if the limit was met or an edge could not be flipped
template <class Triangulation>
int flip_to_delaunay(Triangulation& triangulation, int limit)
{
  std::vector<int> pending;
  for(int h = 0; h < triangulation.number_of_halfedges(); h += 2)
    pending.push_back(h);
  int flips = 0;
  while(!pending.empty()) {
    const int h = pending.back();
    pending.pop_back();
    if(triangulation.is_locally_delaunay(h))
      continue;
    if(flips == limit || !triangulation.is_flippable(h))
      return -1;
    triangulation.flip(h);
    ++flips;
    for(int side : {h, h ^ 1})
      pending.insert(pending.end(), {triangulation.next(side), triangulation.previous(side)});
  }
  return flips;
}

template <class Triangulation>
bool is_delaunay(const Triangulation& triangulation)
{
  for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(!triangulation.is_locally_delaunay(h))
      return false;
  return true;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_LAWSON_H
