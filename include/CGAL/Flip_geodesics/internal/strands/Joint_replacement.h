// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_JOINT_REPLACEMENT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_JOINT_REPLACEMENT_H

#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/input/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/strands/Segment_store.h>

#include <CGAL/assertions.h>

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
  explicit Joint_replacement(Network& network)
    : m_network(network)
    , m_segments(network.m_segments)
  {
  }

  /* As Edge_path_network::replace_joint(). */
  Segment_index operator()(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    const std::pair<Strand_end, Strand_end> old = m_network.ends(joint);
    const Segment_index x = joint.incoming, y = m_network.next(x);
    CGAL_precondition(x != y);
    m_segments.make_room(arc.size());
    const Strand_end after = survivor_clockwise(old.first, old.second);
    // A joint that turns back also uncovers the ends beside it at its far node.
    const Halfedge_index far = Triangulation::twin(old.first.halfedge);
    const Strand_end after_far =
        arc.empty() ? survivor_clockwise({far, old.second.segment}, {far, old.first.segment}) : Strand_end{};

    const Segment_index upstream = m_network.next(y) == x ? null_index : m_network.previous(x);
    const Segment_index first = splice(x, y, joint.side, arc);
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

  // Replaces x and y by segments along the arc; returns the first of them.
  Segment_index splice(Segment_index x, Segment_index y, Side side, const std::vector<Halfedge_index>& arc)
  {
    const Curve_index curve = m_segments[x].curve;
    const bool was_whole_loop = m_network.next(y) == x;
    const Segment_index before = was_whole_loop ? null_index : m_network.previous(x),
                        after = was_whole_loop ? null_index : m_network.next(y);
    const bool is_end_fixed = m_segments[y].is_head_fixed;
    const bool is_end_straight = m_segments[y].is_head_straight[static_cast<std::size_t>(opposite_side(side))];
    m_segments.remove(x);
    m_segments.remove(y);

    Segment_index first = null_index, last = null_index;
    for(std::size_t i = 0; i < arc.size(); ++i) {
      const Halfedge_index h = side == Side::LEFT ? arc[i] : Triangulation::twin(arc[arc.size() - 1 - i]);
      const Segment_index s = m_segments.create(curve, h);
      m_segments.link_outermost(s, side == Side::LEFT ? h : Triangulation::twin(h));
      if(first == null_index)
        first = s;
      else
        m_segments.link(last, s);
      last = s;
    }
    if(last != null_index) {
      m_segments[last].is_head_fixed = is_end_fixed;
      m_segments[last].is_head_straight[static_cast<std::size_t>(opposite_side(side))] = is_end_straight;
    } else if(before != null_index) // the two nodes become one
      m_segments[before].is_head_fixed = m_segments[before].is_head_fixed || is_end_fixed;
    relink(curve, before, first, last, after, was_whole_loop);
    return first;
  }

  void relink(Curve_index curve, Segment_index before, Segment_index first, Segment_index last, Segment_index after,
              bool was_whole_loop)
  {
    auto& c = m_network.m_curves[curve];
    if(was_whole_loop) {
      if(first != null_index)
        m_segments.link(last, first);
      c.first = first;
      c.last = last;
      return;
    }
    m_segments.link(before, first == null_index ? after : first);
    m_segments.link(last == null_index ? before : last, after);
    const Segment_index head = first == null_index ? after : first, tail = last == null_index ? before : last;
    if(c.is_closed) { // any segment may be the first
      c.first = head;
      c.last = m_segments[head].previous;
      return;
    }
    if(before == null_index)
      c.first = head;
    if(after == null_index)
      c.last = tail;
  }

  // The joint at the head of `upstream`, whose next segment is another one since two have cancelled.
  void collect_merged_joint(Segment_index upstream, std::vector<Joint>& affected)
  {
    if(upstream == null_index || m_network.next(upstream) == null_index)
      return;
    m_segments[upstream].is_head_straight = {};
    collect(upstream, Side::LEFT, affected);
    collect(upstream, Side::RIGHT, affected);
  }

  // The joints of `count` new segments that follow `upstream`. Between two of them the angle on the wedge's side is at
  // least pi; where they begin and end, the angle on the other side has grown.
  void collect_new_joints(Segment_index upstream, Segment_index first, std::size_t count, Side side,
                          std::vector<Joint>& affected)
  {
    if(upstream != null_index) {
      m_segments[upstream].is_head_straight[static_cast<std::size_t>(side)] = false;
      collect(upstream, side, affected);
      collect(upstream, opposite_side(side), affected);
    }
    Segment_index s = first;
    for(std::size_t i = 1; i < count; ++i, s = m_network.next(s)) {
      m_segments[s].is_head_straight[static_cast<std::size_t>(opposite_side(side))] = true;
      collect(s, side, affected);
    }
    if(m_network.next(s) == null_index)
      return;
    collect(s, side, affected);
    collect(s, opposite_side(side), affected);
  }

  // A side of the joint at the head of a segment, unless its angle is known to be at least pi.
  void collect(Segment_index incoming, Side side, std::vector<Joint>& affected) const
  {
    if(!m_segments[incoming].is_head_straight[static_cast<std::size_t>(side)])
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
    const bool arrives_first = a.halfedge == Triangulation::twin(m_network.halfedge(a.segment));
    if(arrives_first && m_network.next(a.segment) == b.segment && b.halfedge == m_network.halfedge(b.segment))
      affected.push_back({a.segment, Side::LEFT});
    const bool leaves_first = a.halfedge == m_network.halfedge(a.segment);
    if(leaves_first && m_network.next(b.segment) == a.segment &&
       b.halfedge == Triangulation::twin(m_network.halfedge(b.segment)))
      affected.push_back({b.segment, Side::RIGHT});
  }

  Network& m_network;
  Segments& m_segments;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_JOINT_REPLACEMENT_H
