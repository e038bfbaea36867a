// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_PARTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_PARTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Moves a joint of a network over its wedge and returns the joints that must be examined again: those of the new
 * segments, and the pair of ends that become neighbors where the old ones are removed. The manual's section on the
 * queue gives the reasons.
 */
template <class Network>
class Joint_replacement
{
  using Triangulation = typename Network::Triangulation;
  using Segments = Segment_store<Triangulation>;

public:
  /* For a network and its segments. */
  Joint_replacement(const Network& network, Segments& segments)
    : m_network(network)
    , m_segments(segments)
  {
  }

  /* See Edge_path_network::replace_joint(). */
  Segment_index operator()(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    const std::pair<Segment_end, Segment_end> old = m_network.ends(joint);
    const Segment_index x = joint.incoming, y = m_segments.next(x);
    const Segment_end after = survivor_clockwise(old.first, old.second);
    // A joint that turns back also uncovers the ends beside it at its far node.
    const Halfedge_index far_end = Triangulation::twin(old.first.halfedge);
    const Segment_end after_far =
        arc.empty() ? survivor_clockwise({far_end, old.second.segment}, {far_end, old.first.segment}) : Segment_end{};

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
  // The first end clockwise after two neighboring ends `first` and `second` that belongs to other segments. Usually
  // there is none, and the wedge between the two is then not traversed.
  Segment_end survivor_clockwise(const Segment_end& first, const Segment_end& second) const
  {
    Segment_end end = m_network.next_clockwise(second);
    while(!end.is_none() && end != first && (end.segment == first.segment || end.segment == second.segment))
      end = m_network.next_clockwise(end);
    return end == first ? Segment_end{} : end;
  }

  // The joint at the head of `upstream`, which has a new successor because two segments have cancelled.
  void collect_merged_joint(Segment_index upstream, std::vector<Joint>& affected) const
  {
    if(upstream == null_index || m_segments.next(upstream) == null_index)
      return;
    collect(upstream, Side::LEFT, affected);
    collect(upstream, Side::RIGHT, affected);
  }

  // The joints of `count` new segments that follow `upstream`. Between two of them the angle on the wedge's side is at
  // least pi; at the first and the last joint, the angle on the other side has grown.
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

  // Adds a side of the joint at the head of a segment, unless its angle is known to be at least pi.
  void collect(Segment_index incoming, Side side, std::vector<Joint>& affected) const
  {
    if(!m_segments.is_known_straight(incoming, side))
      affected.push_back({incoming, side});
  }

  // Adds the pair that has become adjacent: an end and its predecessor clockwise, if they belong to one joint.
  void collect_if_adjacent(const Segment_end& b, std::vector<Joint>& affected) const
  {
    if(b.is_none())
      return;
    const Segment_end a = m_network.next_counterclockwise(b);
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

/* Inserts points into the triangulation of a network and divides the segments on the edges that are split. */
template <class Triangulation>
class Segment_division
{
public:
  Segment_division(Triangulation& triangulation, Segment_store<Triangulation>& segments)
    : m_triangulation(triangulation)
    , m_segments(segments)
  {
  }

  Vertex_index insert(const Surface_location& location)
  {
    return m_triangulation.insert(location, [this](const auto& halves) { this->divide_bundle(halves); });
  }

  Vertex_index insert(const Surface_location& location, Known_piece& close_by)
  {
    return Internals<Triangulation>::insert(
        m_triangulation, location, [this](const auto& halves) { this->divide_bundle(halves); }, close_by);
  }

  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return m_triangulation.split_edge(h, location, gap, [this](const auto& halves) { this->divide_bundle(halves); });
  }

private:
  // See Segment_store::divide_bundle(). \throws Occupied_triangulation_error if another network holds the edge
  template <class Edge_halves>
  void divide_bundle(const Edge_halves& halves)
  {
    const Index own_holds = m_segments.leftmost(m_triangulation.walker(halves.first)).idx() != 0 ? 1 : 0;
    if(m_triangulation.holds(Triangulation::edge(halves.first)) > own_holds)
      throw Occupied_triangulation_error("a curve of another network lies on the edge that would be split");
    m_segments.divide_bundle(halves.first, {{halves.first, halves.second}});
  }

  Triangulation& m_triangulation;
  Segment_store<Triangulation>& m_segments;
};

/* Checks the invariant of Edge_path_network through its public members alone. */
template <class Network>
class Network_validity
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Network_validity(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  bool is_valid() const
  {
    if(!has_valid_chains())
      return false;
    for(Segment_index s(1); s.idx() < m_network.end_of_segment_ids(); ++s)
      if(m_network.is_alive(s) && !(is_non_crossing_at({m_network.halfedge(s), s}) &&
                                    is_non_crossing_at({Triangulation::twin(m_network.halfedge(s)), s})))
        return false;
    return true;
  }

  /* Returns whether the curves are chains and the bundles consist of the segments on their edges. Curves may cross. */
  bool has_valid_chains() const
  {
    for(Curve_index c : descriptors<Curve_index>(m_network.number_of_curves()))
      if(!is_valid_chain(c))
        return false;
    for(Segment_index s(1); s.idx() < m_network.end_of_segment_ids(); ++s)
      if(m_network.is_alive(s) && !is_valid_bundle(s))
        return false;
    return true;
  }

  bool is_non_crossing_at(const Segment_end& end) const
  {
    Segment_end start = end;
    bool has_border = false;
    for(Segment_end e = m_network.next_beyond_others(start, Side::LEFT); e != end;
        e = m_network.next_beyond_others(start, Side::LEFT))
    {
      if(e.is_none()) {
        has_border = true;
        break;
      }
      start = e;
    }
    return is_non_crossing_from(has_border ? start : end, has_border);
  }

private:
  bool is_valid_chain(Curve_index curve) const
  {
    bool is_chain = true;
    Segment_index last = null_index;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      is_chain = is_chain && m_network.is_alive(s) && m_network.curve(s) == curve;
      const Segment_index t = m_network.next(s);
      is_chain = is_chain &&
                 (t == null_index || (m_network.previous(t) == s && m_triangulation.head(m_network.halfedge(s)) ==
                                                                        m_triangulation.tail(m_network.halfedge(t))));
      last = s;
    });
    return is_chain && last == m_network.last_segment(curve) &&
           (last == null_index || (m_network.next(last) == null_index) != m_network.is_closed(curve));
  }

  bool is_valid_bundle(Segment_index s) const
  {
    const Edge_index e = Triangulation::edge(m_network.halfedge(s));
    const std::vector<Segment_index> bundle = m_network.bundle(e);
    for(Segment_index t : bundle)
      if(!m_network.is_alive(t) || Triangulation::edge(m_network.halfedge(t)) != e)
        return false;
    return std::find(bundle.begin(), bundle.end(), s) != bundle.end() &&
           m_network.outermost(first_side(e), Side::LEFT) == bundle.front() &&
           m_network.outermost(first_side(e), Side::RIGHT) == bundle.back();
  }

  // The end that a joint connects with this one, unless the node is fixed.
  Segment_end partner(const Segment_end& end) const
  {
    const Segment_index s = end.segment;
    if(end.halfedge == m_network.halfedge(s)) {
      const Segment_index p = m_network.previous(s);
      return p == null_index || m_network.is_head_fixed(p) ? Segment_end{}
                                                           : Segment_end{Triangulation::twin(m_network.halfedge(p)), p};
    }
    return m_network.is_head_fixed(s) ? Segment_end{}
                                      : Segment_end{m_network.halfedge(m_network.next(s)), m_network.next(s)};
  }

  // Traverses clockwise from an end, which comes first after the border if there is one. Matched ends must nest like
  // brackets, and single ends, like the border, must all lie at one depth, either outside all brackets or inside the
  // same one.
  bool is_non_crossing_from(const Segment_end& start, bool has_border) const
  {
    std::vector<Segment_end> open;
    Segment_end region; // the innermost open bracket around the single ends
    bool has_region = has_border;
    Segment_end end = start;
    do {
      const Segment_end mate = partner(end);
      if(mate.is_none()) {
        const Segment_end here = open.empty() ? Segment_end{} : open.back();
        if(has_region && region != here)
          return false;
        region = here;
        has_region = true;
      } else if(!open.empty() && open.back() == mate) {
        open.pop_back();
      } else {
        open.push_back(end);
      }
      end = m_network.next_beyond_others(end, Side::RIGHT);
    } while(!end.is_none() && end != start);
    return open.empty();
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
};

/* Throws Invalid_curve_error unless the halfedges of a triangulation form a chain; also throws what touching their
 * faces throws. */
template <class Triangulation, class HalfedgeRange>
void check_chain(const Triangulation& triangulation, const HalfedgeRange& halfedges, bool is_closed)
{
  static_assert(is_range_of<HalfedgeRange, Halfedge_index>,
                "the curve is not a range of halfedges of the triangulation, Halfedge_index");
  std::size_t position = 0;
  Halfedge_index first = null_index, last = null_index;
  for(Halfedge_index h : halfedges) {
    if(!h.is_valid() || h.idx() >= triangulation.number_of_halfedges())
      throw Invalid_curve_error("a curve has a halfedge that the mesh does not have", {position});
    if(last != null_index && triangulation.head(last) != triangulation.tail(h))
      throw Invalid_curve_error("a curve is not connected at position " + std::to_string(position), {position});
    triangulation.length(h); // copies its face, which may throw: before the network changes
    if(first == null_index)
      first = h;
    last = h;
    ++position;
  }
  if(first == null_index)
    throw Invalid_curve_error("a curve has no edge");
  if(is_closed && triangulation.head(last) != triangulation.tail(first))
    throw Invalid_curve_error("a closed curve does not end where it starts", {position});
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_NETWORK_PARTS_H
