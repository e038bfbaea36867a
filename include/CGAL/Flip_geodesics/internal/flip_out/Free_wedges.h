// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FREE_WEDGES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FREE_WEDGES_H

#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Wedge_queue.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The wedges of a network that are free and below pi, the smallest angle first, then the older segment, then the left
 * side, so that the order is determined by the input.
 *
 * A wedge's angle does not change while its joint lives, since flips elsewhere keep the angle between two edges that
 * stay. So a key never goes stale. Whether the wedge is free does change: what comes out of the queue is to be looked
 * at again, and `EdgePathGraph::replace_joint()` names the wedges that may have become free.
 */
template <class Network>
class Free_wedges
{
public:
  explicit Free_wedges(Network& network)
    : m_network(network)
  {
  }

  bool empty() const { return m_queue.empty() && m_held.empty(); }

  /* Can another wedge be had? */
  bool has_next() const { return !m_queue.empty(); }

  /* Takes the first wedge out. It may not be free any more, nor its joint be there. \pre has_next() */
  Queued_wedge pop()
  {
    const Queued_wedge first = m_queue.top();
    m_queue.pop();
    return first;
  }

  /* Keeps a wedge that was taken out until `release()`. */
  void hold(const Queued_wedge& wedge) { m_held.push_back(wedge); }

  /* Queues what is held, and calls `function(wedge)` for each. */
  template <class Function>
  void release(Function function)
  {
    for(const Queued_wedge& wedge : m_held) {
      m_queue.push(wedge);
      function(wedge);
    }
    m_held.clear();
  }

  bool is_free(const Joint& joint) const { return m_network.wedge(joint).state == Wedge_state::FREE; }

  /* Is a wedge that was queued still free? Its angle is what it was, but strands may have come in. */
  bool is_still_free(const Joint& joint) const
  {
    const auto [a, b] = m_network.ends(joint);
    return !m_network.is_head_fixed(joint.incoming) && m_network.next_clockwise(a) == b;
  }

  /* Looks at all joints of a curve, whatever was known of them. */
  void look_at_curve(Curve_index curve)
  {
    // A fan of faces is a chain of loads, each waiting for the one before; these do not wait for each other.
    m_network.for_each_segment(curve, [&](Segment_index s) {
      m_network.triangulation().prefetch_face(m_network.halfedge(s));
      m_network.triangulation().prefetch_face(Network::Triangulation::twin(m_network.halfedge(s)));
    });
    m_network.for_each_segment(curve, [&](Segment_index s) {
      look_at({s, Side::LEFT});
      look_at({s, Side::RIGHT});
    });
  }

  /* Looks at joints that have been named, if they are there. */
  void look_at_all(const std::vector<Joint>& named)
  {
    for(const Joint& joint : named)
      look_at(joint);
  }

private:
  void look_at(const Joint& joint)
  {
    const Segment_index x = joint.incoming;
    if(!m_network.is_alive(x) || m_network.next(x) == null_index)
      return;
    const typename Network::Wedge wedge = m_network.wedge(joint);
    if(wedge.state == Wedge_state::FREE)
      m_queue.push({m_network.triangulation().traits().turn_key_object()(wedge.turn), joint, m_network.next(x)});
  }

  Network& m_network;
  Wedge_queue m_queue;
  std::vector<Queued_wedge> m_held;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FREE_WEDGES_H
