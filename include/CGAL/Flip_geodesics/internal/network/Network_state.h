// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_STATE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_STATE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* All that a network is, apart from its triangulation, ids of segments included. */
struct Network_state
{
  struct Segment
  {
    Segment_index id;
    Halfedge_index halfedge;
    bool is_head_fixed;
  };

  struct Curve
  {
    bool is_closed;
    double initial_length;
    std::vector<Segment> segments;
  };

  struct Stack
  {
    Edge_index edge;
    std::vector<Segment_index> segments; // from left to right along the edge's first halfedge
  };

  Index end_of_segment_ids = 1;
  std::vector<Curve> curves;
  std::vector<Stack> stacks; // of the edges with several segments
};

/* What a network is. That the ends of paths are fixed goes without saying. */
template <class Network>
Network_state network_state(const Network& network)
{
  Network_state state;
  state.end_of_segment_ids = network.end_of_segment_ids();
  for(Curve_index c : descriptors<Curve_index>(network.number_of_curves())) {
    state.curves.push_back({network.is_closed(c), network.initial_length(c), {}});
    network.for_each_segment(c, [&](Segment_index s) {
      const bool is_marked = network.next(s) != null_index && network.is_head_fixed(s);
      state.curves.back().segments.push_back({s, network.halfedge(s), is_marked});
    });
  }
  for(Edge_index e : descriptors<Edge_index>(network.triangulation().number_of_edges())) {
    const std::vector<Segment_index> stack = network.stack(e);
    if(stack.size() > 1)
      state.stacks.push_back({e, stack});
  }
  return state;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_STATE_H
