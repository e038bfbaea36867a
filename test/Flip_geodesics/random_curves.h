// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_RANDOM_CURVES_H
#define FLIP_GEODESICS_TEST_RANDOM_CURVES_H

#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

/* Random Delta-complexes, made by flipping small meshes, and random curves on them that do not cross. */
namespace Flip_geodesics_test {

/// Halfedges of a triangulation in a row.
using Halfedge_sequence = std::vector<CGAL::Flip_geodesics::Halfedge_index>;

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
    const CGAL::Flip_geodesics::Halfedge_index h(random.below(triangulation.number_of_halfedges()));
    if(!triangulation.is_flippable(h))
      continue;
    triangulation.flip(h);
    ++flips;
  }
  return flips;
}

/// The halfedges that start where `h` starts, in some order.
template <class Triangulation>
Halfedge_sequence outgoing_halfedges_at_tail(const Triangulation& triangulation, CGAL::Flip_geodesics::Halfedge_index h)
{
  using CGAL::Flip_geodesics::null_index;
  Halfedge_sequence result = {h};
  for(auto g = triangulation.clockwise(h); g != h; g = triangulation.clockwise(g)) {
    if(g == null_index) {
      for(g = triangulation.counterclockwise(h); g != null_index; g = triangulation.counterclockwise(g))
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
Halfedge_sequence random_walk(const Triangulation& triangulation, int steps, bool is_closed, Random_numbers& random)
{
  using CGAL::Flip_geodesics::Halfedge_index;
  using CGAL::Flip_geodesics::Vertex_index;
  Halfedge_sequence walk = {Halfedge_index(random.below(triangulation.number_of_halfedges()))};
  const Vertex_index start = triangulation.tail(walk.front());
  const bool avoids_old_vertices = random.below(2) == 0;
  CGAL::Flip_geodesics::internal::Indexed_by<Vertex_index, std::vector<bool>> is_visited(
      static_cast<std::size_t>(triangulation.number_of_vertices()), false);
  while(!is_closed || triangulation.head(walk.back()) != start) {
    if(static_cast<int>(walk.size()) >= steps)
      return is_closed ? Halfedge_sequence() : walk;
    is_visited[triangulation.head(walk.back())] = true;
    const Halfedge_index back = Triangulation::twin(walk.back());
    const Halfedge_sequence outgoing_halfedges = outgoing_halfedges_at_tail(triangulation, back);
    Halfedge_index h = back;
    for(int i = 0; i < 6; ++i) {
      const Halfedge_index g = outgoing_halfedges[random.below(static_cast<int>(outgoing_halfedges.size()))];
      if(g == back && i < 5)
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
Halfedge_sequence random_loop_edge(const Triangulation& triangulation, Random_numbers& random)
{
  for(int i = 0; i < triangulation.number_of_halfedges(); ++i) {
    const CGAL::Flip_geodesics::Halfedge_index h(random.below(triangulation.number_of_halfedges()));
    if(triangulation.tail(h) == triangulation.head(h))
      return {h};
  }
  return {};
}

/// Shuffles the stacks of the edges under `walk` until the network is valid; false if it does not become so.
template <class Network>
bool order_at_random(Network& network, const Halfedge_sequence& walk, int attempts, Random_numbers& random)
{
  for(int i = 0; i < attempts; ++i) {
    if(network.is_valid())
      return true;
    for(const auto h : walk) {
      const auto e = Network::Triangulation::edge(h);
      auto bundle = network.bundle(e);
      for(std::size_t k = bundle.size(); k > 1; --k)
        std::swap(bundle[k - 1], bundle[random.below(static_cast<int>(k))]);
      if(bundle.size() > 1)
        network.set_bundle(e, bundle);
    }
  }
  return network.is_valid();
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_RANDOM_CURVES_H
