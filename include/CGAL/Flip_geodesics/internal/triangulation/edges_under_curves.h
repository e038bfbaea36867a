// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGES_UNDER_CURVES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGES_UNDER_CURVES_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The edges that a network holds, each once, in increasing order. */
template <class Network>
std::vector<Edge_index> edges_under_curves(const Network& network)
{
  std::vector<Edge_index> edges;
  for(Curve_index c : descriptors<Curve_index>(network.number_of_curves()))
    network.for_each_segment(
        c, [&](Segment_index s) { edges.push_back(Network::Triangulation::edge(network.halfedge(s))); });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGES_UNDER_CURVES_H
