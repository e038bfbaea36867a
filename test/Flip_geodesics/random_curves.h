// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_RANDOM_CURVES_H
#define FLIP_GEODESICS_TEST_RANDOM_CURVES_H

#include "mesh_soup.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/* Random Delta-complexes, made by flipping small meshes, and random curves on them that do not cross. */
namespace Flip_geodesics_test {

/// Moves every point by up to `amplitude` in each coordinate.
inline Mesh_soup shaken(const Mesh_soup& soup, double amplitude, unsigned seed)
{
  Random_numbers random(seed);
  return mapped(soup, [&](const Coordinates& p) {
    Coordinates q = p;
    for(double& x : q)
      x += random.uniform(-amplitude, amplitude);
    return q;
  });
}

/// Tries `attempts` flips of random halfedges; returns how many could be flipped.
template <class Triangulation>
int flip_at_random(Triangulation& triangulation, int attempts, Random_numbers& random)
{
  int flips = 0;
  for(int i = 0; i < attempts; ++i) {
    const int h = random.below(triangulation.number_of_halfedges());
    if(!triangulation.is_flippable(h))
      continue;
    triangulation.flip(h);
    ++flips;
  }
  return flips;
}

/// The halfedges that start where `h` starts, in some order.
template <class Triangulation>
std::vector<int> spokes_at_tail(const Triangulation& triangulation, int h)
{
  std::vector<int> result = {h};
  for(int g = triangulation.clockwise(h); g != h; g = triangulation.clockwise(g)) {
    if(g == -1) {
      for(g = triangulation.counterclockwise(h); g != -1; g = triangulation.counterclockwise(g))
        result.push_back(g);
      return result;
    }
    result.push_back(g);
  }
  return result;
}

/// A random walk of halfedges; a closed one ends where it starts, or is empty if it does not come back within `steps`.
/// Half of the walks avoid vertices that they have been at, if they can. One in six edges turns back if it can.
template <class Triangulation>
std::vector<int> random_walk(const Triangulation& triangulation, int steps, bool is_closed, Random_numbers& random)
{
  std::vector<int> walk = {random.below(triangulation.number_of_halfedges())};
  const int start = triangulation.tail(walk.front());
  const bool avoids_old_vertices = random.below(2) == 0;
  std::vector<bool> is_visited(static_cast<std::size_t>(triangulation.number_of_vertices()), false);
  while(!is_closed || triangulation.head(walk.back()) != start) {
    if(static_cast<int>(walk.size()) >= steps)
      return is_closed ? std::vector<int>() : walk;
    is_visited[triangulation.head(walk.back())] = true;
    const std::vector<int> spokes = spokes_at_tail(triangulation, walk.back() ^ 1);
    int h = walk.back() ^ 1;
    for(int i = 0; i < 6; ++i) {
      const int g = spokes[random.below(static_cast<int>(spokes.size()))];
      if((g ^ 1) == walk.back() && i < 5)
        continue;
      h = g;
      if(!avoids_old_vertices || !is_visited[triangulation.head(h)])
        break;
    }
    walk.push_back(h);
  }
  return walk;
}

/// A random edge from a vertex to itself, as a walk of one halfedge; empty if none is found.
template <class Triangulation>
std::vector<int> random_loop_edge(const Triangulation& triangulation, Random_numbers& random)
{
  for(int i = 0; i < triangulation.number_of_halfedges(); ++i) {
    const int h = random.below(triangulation.number_of_halfedges());
    if(triangulation.tail(h) == triangulation.head(h))
      return {h};
  }
  return {};
}

/// Shuffles the stacks of the edges under `walk` until the network is valid; false if it does not become so.
template <class Network>
bool order_at_random(Network& network, const std::vector<int>& walk, int attempts, Random_numbers& random)
{
  for(int i = 0; i < attempts; ++i) {
    if(network.is_valid())
      return true;
    for(int h : walk) {
      auto stack = network.stack(h / 2);
      for(std::size_t k = stack.size(); k > 1; --k)
        std::swap(stack[k - 1], stack[random.below(static_cast<int>(k))]);
      if(stack.size() > 1)
        network.set_stack(h / 2, stack);
    }
  }
  return network.is_valid();
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_RANDOM_CURVES_H
