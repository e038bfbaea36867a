// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_JOINT_REPLACEMENT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_JOINT_REPLACEMENT_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Moves a joint of a network over its wedge, and tells which joints are to be looked at again: those of the new
 * segments, and the pair of ends that become neighbours where the old ones go. The manual's section on the queue has
 * the reasons.
 */
template <class Network>
class Joint_replacement
{
  using Triangulation = typename Network::Triangulation;
  using Segments = Segment_store<Triangulation>;

public:
  /* Of a network and its segments. */
  Joint_replacement(const Network& network, Segments& segments)
    : m_network(network)
    , m_segments(segments)
  {
  }

  /* As Edge_path_network::replace_joint(). */
  Segment_index operator()(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    const std::pair<Strand_end, Strand_end> old = m_network.ends(joint);
    const Segment_index x = joint.incoming, y = m_segments.next(x);
    const Strand_end after = survivor_clockwise(old.first, old.second);
    // A joint that turns back also uncovers the ends beside it at its far node.
    const Halfedge_index far_end = Triangulation::twin(old.first.halfedge);
    const Strand_end after_far =
        arc.empty() ? survivor_clockwise({far_end, old.second.segment}, {far_end, old.first.segment}) : Strand_end{};

    const Segment_index upstream = m_segments.next(y) == x ? null_index : m_segments.previous(x);
    const Segment_index first = m_segments.replace_joint(joint, arc);
    if(first == null_index)
      collect_merged_joint(upstream, affected);
    else
      collect_new_joints(upstream, first, arc.size(), joint.side, affected);
    collect_if_adjacent(after, affected);
    collect_if_adjacent(after_far, affected);
    return first;
  }

private:
  // The first end clockwise after two neighbours, `first` and `second`, that is of other segments. Most often there is
  // none, and then the wedge between the two is not walked through.
  Strand_end survivor_clockwise(const Strand_end& first, const Strand_end& second) const
  {
    Strand_end end = m_network.next_clockwise(second);
    while(!end.is_none() && end != first && (end.segment == first.segment || end.segment == second.segment))
      end = m_network.next_clockwise(end);
    return end == first ? Strand_end{} : end;
  }

  // The joint at the head of `upstream`, whose next segment is another one since two have cancelled.
  void collect_merged_joint(Segment_index upstream, std::vector<Joint>& affected) const
  {
    if(upstream == null_index || m_segments.next(upstream) == null_index)
      return;
    collect(upstream, Side::LEFT, affected);
    collect(upstream, Side::RIGHT, affected);
  }

  // The joints of `count` new segments that follow `upstream`. Between two of them the angle on the wedge's side is at
  // least pi; where they begin and end, the angle on the other side has grown.
  void collect_new_joints(Segment_index upstream, Segment_index first, std::size_t count, Side side,
                          std::vector<Joint>& affected) const
  {
    if(upstream != null_index) {
      collect(upstream, side, affected);
      collect(upstream, opposite_side(side), affected);
    }
    Segment_index s = first;
    for(std::size_t i = 1; i < count; ++i, s = m_segments.next(s))
      collect(s, side, affected);
    if(m_segments.next(s) == null_index)
      return;
    collect(s, side, affected);
    collect(s, opposite_side(side), affected);
  }

  // A side of the joint at the head of a segment, unless its angle is known to be at least pi.
  void collect(Segment_index incoming, Side side, std::vector<Joint>& affected) const
  {
    if(!m_segments.is_known_straight(incoming, side))
      affected.push_back({incoming, side});
  }

  // The pair that has become adjacent: an end and the one before it clockwise, if they belong to one joint.
  void collect_if_adjacent(const Strand_end& b, std::vector<Joint>& affected) const
  {
    if(b.is_none())
      return;
    const Strand_end a = m_network.next_counterclockwise(b);
    if(a.is_none())
      return;
    const bool arrives_first = a.halfedge == Triangulation::twin(m_segments.halfedge(a.segment));
    if(arrives_first && m_segments.next(a.segment) == b.segment && b.halfedge == m_segments.halfedge(b.segment))
      affected.push_back({a.segment, Side::LEFT});
    const bool leaves_first = a.halfedge == m_segments.halfedge(a.segment);
    if(leaves_first && m_segments.next(b.segment) == a.segment &&
       b.halfedge == Triangulation::twin(m_segments.halfedge(b.segment)))
      affected.push_back({b.segment, Side::RIGHT});
  }

  const Network& m_network;
  Segments& m_segments;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_JOINT_REPLACEMENT_H
