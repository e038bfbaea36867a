// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_NETWORK_STATE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_NETWORK_STATE_H

#include <CGAL/Flip_geodesics/internal/input/Indexed_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* All that an `Edge_path_network` is, apart from its triangulation, ids of segments included. */
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

/* Reads a network's state, and sets it. */
template <class Network>
class Network_access
{
  using Triangulation = typename Network::Triangulation;

public:
  static Network_state state(const Network& network)
  {
    Network_state state;
    state.end_of_segment_ids = network.end_of_segment_ids();
    for(Curve_index c : descriptors<Curve_index>(network.number_of_curves())) {
      state.curves.push_back({network.is_closed(c), network.initial_length(c), {}});
      network.for_each_segment(c, [&](Segment_index s) {
        state.curves.back().segments.push_back({s, network.halfedge(s), network.m_segments[s].is_head_fixed});
      });
    }
    for(Edge_index e : descriptors<Edge_index>(network.triangulation().number_of_edges())) {
      const std::vector<Segment_index> stack = network.stack(e);
      if(stack.size() > 1)
        state.stacks.push_back({e, stack});
    }
    return state;
  }

  /*
   * Puts a state into an empty network. Returns false, and leaves the network empty, if the state is none: ids or
   * halfedges that do not exist or are used twice, chains that do not hang together, stacks of other segments.
   */
  static bool restore(Network& network, const Network_state& state)
  {
    const bool is_restored = add_curves(network, state) && set_stacks(network, state) && network.is_valid();
    if(!is_restored)
      network.clear();
    return is_restored;
  }

private:
  static bool add_curves(Network& network, const Network_state& state)
  {
    const Triangulation& triangulation = network.triangulation();
    network.m_segments.set_end_of_ids(state.end_of_segment_ids);
    for(const Network_state::Curve& curve : state.curves) {
      const Curve_index c(network.number_of_curves());
      network.m_curves.push_back({null_index, null_index, curve.is_closed, curve.initial_length});
      network.m_claim.set_has_curves(true);
      for(const Network_state::Segment& s : curve.segments) {
        const bool is_free = s.id.idx() > 0 && s.id.idx() < state.end_of_segment_ids && !network.is_alive(s.id);
        if(!is_free || !s.halfedge.is_valid() || s.halfedge.idx() >= triangulation.number_of_halfedges())
          return false;
        const Segment_index last = network.m_curves[c].last;
        if(last != null_index && triangulation.head(network.halfedge(last)) != triangulation.tail(s.halfedge))
          return false;
        network.m_segments.set_halfedge(s.id, s.halfedge);
        network.m_segments[s.id].curve = c;
        network.m_segments[s.id].is_head_fixed = s.is_head_fixed;
        network.m_segments.link_outermost(s.id, s.halfedge);
        network.m_segments.link(last, s.id);
        network.m_curves[c].last = s.id;
        if(last == null_index)
          network.m_curves[c].first = s.id;
      }
      if(!close(network, c))
        return false;
    }
    return true;
  }

  static bool close(Network& network, Curve_index curve)
  {
    const Segment_index first = network.first_segment(curve), last = network.last_segment(curve);
    if(!network.is_closed(curve) || first == null_index)
      return true;
    const Triangulation& triangulation = network.triangulation();
    if(triangulation.head(network.halfedge(last)) != triangulation.tail(network.halfedge(first)))
      return false;
    network.m_segments.link(last, first);
    return true;
  }

  static bool set_stacks(Network& network, const Network_state& state)
  {
    for(const Network_state::Stack& stack : state.stacks) {
      if(!stack.edge.is_valid() || stack.edge.idx() >= network.triangulation().number_of_edges())
        return false;
      std::vector<Segment_index> there = network.stack(stack.edge), wanted = stack.segments;
      std::sort(there.begin(), there.end());
      std::sort(wanted.begin(), wanted.end());
      if(there != wanted)
        return false;
      network.set_stack(stack.edge, stack.segments);
    }
    return true;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_NETWORK_STATE_H
