// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_STORE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_STORE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The complete state of a network apart from its triangulation, including the ids of segments. */
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

  struct Bundle
  {
    Edge_index edge;
    std::vector<Segment_index> segments; // from left to right along the edge's first halfedge
  };

  Index end_of_segment_ids = 1;
  std::vector<Curve> curves;
  std::vector<Bundle> bundles; // of the edges with several segments
};

/* Returns the state of a network. The fixed ends of paths are implied and not recorded. */
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
    const std::vector<Segment_index> bundle = network.bundle(e);
    if(bundle.size() > 1)
      state.bundles.push_back({e, bundle});
  }
  return state;
}

/* The position of a segment in its bundle, which is needed to put another segment in its place. */
struct Bundle_place
{
  Halfedge_index halfedge;
  Segment_index left, right;
};

/*
 * The segments of a network on halfedges of a triangulation, its curves as chains of segments and, for each edge, its
 * bundle: the overlapping segments on the edge from left to right as seen along its first halfedge. The leftmost
 * segment of each bundle is stored by the place of the edge. The triangulation only records that the edge is held.
 *
 * Invariant, preserved by each public function: a bundle consists of exactly the segments on its edge, each once, and
 * an edge is held once if and only if its bundle has segments; the segments of a curve form a chain from the first to
 * the last one, which is cyclic if the curve is closed; and an angle known to be straight is that of the joint between
 * a segment and its current successor. The network ensures that chains are connected in the triangulation and do not
 * cross.
 *
 * Ids are never reused. The direction of a halfedge relative to its edge is practically random, so choices that
 * depend on it are made without branches.
 */
template <class Triangulation>
class Segment_store
{
public:
  using Walker = typename Triangulation::Walker;

  explicit Segment_store(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_segments(1) // id 0 is not a segment
  {
  }

  Segment_store(Segment_store&&) noexcept = default;
  Segment_store& operator=(Segment_store&&) noexcept = default;

  Triangulation& triangulation() const { return *m_triangulation; }

  /* Must be called when the triangulation has been moved. */
  void set_triangulation(Triangulation& triangulation) { m_triangulation = &triangulation; }

  // ---------------------------------------------------------------- bundles

  Index end_of_ids() const { return static_cast<Index>(m_segments.size()); }
  bool is_alive(Segment_index s) const { return m_segments[s].halfedge != null_index; }
  Halfedge_index halfedge(Segment_index s) const { return m_segments[s].halfedge; }

  /* Returns the walker at a side of the edge of s. */
  Walker placed(Segment_index s, Halfedge_index h) const { return m_triangulation->walker(m_segments[s].place, h); }

  /* Returns the leftmost segment, along the edge's first halfedge, on the edge at which a walker stands; the segment
   * with id 0 if there is none. */
  Segment_index leftmost(const Walker& place) const
  {
    return place.edge_place() < m_leftmost.size() ? m_leftmost[place.edge_place()] : no_segment;
  }

  bool is_occupied(Halfedge_index h) const { return leftmost_on(h) != no_segment; }

  /* Returns the neighbor of s in its bundle as seen along h, or null_index if s is outermost. */
  Segment_index neighbor(Segment_index s, Halfedge_index h, Side side) const
  {
    const std::size_t i = side_along_first_halfedge(h, side);
    const Segment_index found = m_segments[s].beside[i];
    if(found == s) // alone, the most frequent case
      return null_index;
    return chosen(i, s, found) == leftmost(placed(s, h)) ? null_index : found; // the ring closes at the leftmost
  }

  /* Returns the outermost segment on a side of the edge of h, as seen along h. \pre there is one */
  Segment_index outermost(Halfedge_index h, Side side) const { return outermost(h, leftmost_on(h), side); }

  /* Returns the outermost segment on a side of the edge of h, as seen along h, given the leftmost segment on the
   * edge. */
  Segment_index outermost(Halfedge_index h, Segment_index first, Side side) const
  {
    return chosen(side_along_first_halfedge(h, side), first, m_segments[first].beside[0]);
  }

  /* Returns the segments on edge e, from left to right as seen along its first halfedge. */
  std::vector<Segment_index> bundle(Edge_index e) const
  {
    std::vector<Segment_index> result;
    const Segment_index first = leftmost_on(first_side(e));
    if(first == no_segment)
      return result;
    Segment_index s = first;
    do {
      result.push_back(s);
      s = m_segments[s].beside[1];
    } while(s != first);
    return result;
  }

  /* \pre `order` is a permutation of `bundle(e)` */
  void set_bundle(Edge_index e, const std::vector<Segment_index>& order)
  {
    for(Segment_index s : order)
      unlink(s);
    for(Segment_index s : order)
      link_outermost(s, first_side(e));
  }

  Bundle_place bundle_place(Segment_index s) const
  {
    const Halfedge_index first = first_side(Triangulation::edge(halfedge(s)));
    return {halfedge(s), neighbor(s, first, Side::LEFT), neighbor(s, first, Side::RIGHT)};
  }

  /* Releases all edges. Only `clear()` may be called afterwards. */
  void release_edges()
  {
    for(Segment_index s(1); s.idx() < end_of_ids(); ++s)
      if(is_alive(s))
        release_edge(placed(s, halfedge(s)));
  }

  // ---------------------------------------------------------------- curves

  Index number_of_curves() const { return static_cast<Index>(m_curves.size()); }
  Segment_index first(Curve_index curve) const { return m_curves[curve].first; }
  Segment_index last(Curve_index curve) const { return m_curves[curve].last; }
  bool is_closed(Curve_index curve) const { return m_curves[curve].is_closed; }
  double initial_length(Curve_index curve) const { return m_curves[curve].initial_length; }
  void set_initial_length(Curve_index curve, double length) { m_curves[curve].initial_length = length; }

  /* Calls `function(s)` for each segment of a curve, in order; it must not change the curve. */
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const
  {
    const Segment_index first = m_curves[curve].first;
    for(Segment_index s = first; s != null_index;) {
      function(s);
      s = m_segments[s].next;
      if(s == first)
        return;
    }
  }

  // ---------------------------------------------------------------- segments

  Curve_index curve(Segment_index s) const { return m_segments[s].curve; }
  Segment_index next(Segment_index s) const { return m_segments[s].next; }
  Segment_index previous(Segment_index s) const { return m_segments[s].previous; }
  bool is_head_fixed(Segment_index s) const { return next(s) == null_index || m_segments[s].is_head_fixed; }
  void set_head_fixed(Segment_index s, bool is_fixed) { m_segments[s].is_head_fixed = is_fixed; }

  /* Returns whether the joint at the head of s is known to have an angle of at least pi on a side, or the border there.
   * This remains true while the joint exists. */
  bool is_known_straight(Segment_index s, Side side) const { return m_segments[s].is_head_straight[number(side)]; }
  void note_straight(Segment_index s, Side side, bool is_straight) const
  {
    m_segments[s].is_head_straight[number(side)] = is_straight;
  }

  // ---------------------------------------------------------------- modifications

  /* Adds a curve along halfedges; each segment is rightmost on its edge as seen along its halfedge. \pre they form a
   * chain */
  template <class HalfedgeRange>
  Curve_index add_curve(const HalfedgeRange& halfedges, bool is_closed)
  {
    make_room(static_cast<std::size_t>(std::distance(std::begin(halfedges), std::end(halfedges))));
    const Curve_index curve(number_of_curves());
    m_curves.push_back({null_index, null_index, is_closed, 0});
    for(Halfedge_index h : halfedges)
      append(create(curve, h));
    if(is_closed)
      link(last(curve), first(curve));
    return curve;
  }

  void clear()
  {
    release_edges();
    m_segments.resize(1);
    m_curves.clear();
  }

  /*
   * Replaces the two segments at a joint by segments along `arc`, which leads from the head of the joint's first end to
   * that of its second; each new segment is outermost on its right. Returns the first new one in the direction of the
   * curve. If the arc is empty, returns null_index; the two nodes then become one, which is fixed if one of them was.
   *
   * \pre the angles of the arc on its right, where the joint was, are at least pi, so they are known to be
   * straight, and the angles at its ends on that side have not become smaller
   */
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc)
  {
    make_room(arc.size());
    const Segment_index x = joint.incoming, y = next(x);
    CGAL_precondition(x != y);
    const Side other = opposite_side(joint.side);
    const bool was_whole_loop = next(y) == x, is_end_fixed = m_segments[y].is_head_fixed,
               is_end_straight = is_known_straight(y, other);
    const Gap gap = {curve(x), was_whole_loop ? null_index : previous(x), was_whole_loop ? null_index : next(y),
                     was_whole_loop};
    remove(x);
    remove(y);
    const auto [first, last] = create_chain(gap.curve, arc, joint.side);
    if(last != null_index) {
      set_head_fixed(last, is_end_fixed);
      note_straight(last, other, is_end_straight);
    }
    if(gap.before != null_index && last == null_index)
      m_segments[gap.before].is_head_fixed = m_segments[gap.before].is_head_fixed || is_end_fixed;
    if(gap.before != null_index) {
      note_straight(gap.before, joint.side, false);
      if(last == null_index)
        note_straight(gap.before, other, false);
    }
    fill(gap, first, last);
    return first;
  }

  /* Moves the segments on an edge that is split, in their order, to its halves. Changes nothing if it throws.
   * \throws Occupied_triangulation_error if another network holds the edge */
  template <class Edge_halves>
  void divide_bundle(const Edge_halves& halves)
  {
    const Halfedge_index h = halves.first;
    const std::array<Halfedge_index, 2> chain = {h, halves.second};
    if(m_triangulation->holds(Triangulation::edge(h)) > (is_occupied(h) ? 1 : 0))
      throw Occupied_triangulation_error(
          "a curve of another network lies on an edge that must be split; use another triangulation");
    std::vector<Segment_index> segments = bundle(Triangulation::edge(h));
    if(!is_first_side(h))
      std::reverse(segments.begin(), segments.end()); // from left to right as seen along h
    make_room(2 * segments.size());
    for(Segment_index s : segments)
      unlink(s);
    for(Segment_index s : segments) {
      const bool is_along = halfedge(s) == h;
      const Segment_index a = create(curve(s), is_along ? chain[0] : Triangulation::twin(chain[1]));
      const Segment_index b = create(curve(s), is_along ? chain[1] : Triangulation::twin(chain[0]));
      link_outermost(a, is_along ? chain[0] : chain[1]);
      link_outermost(b, is_along ? chain[1] : chain[0]);
      replace_in_curve(s, a, b);
    }
  }

  /* Replaces the only segment of a loop by two, along the other two edges of the face on the left of h, which is the
   * segment's halfedge or its twin. Returns the one that arrives at the old node. */
  Segment_index perturb_loop(Segment_index s, Halfedge_index h)
  {
    const Halfedge_index hn = triangulation().next(h), hp = triangulation().next(hn);
    const Curve_index curve = this->curve(s);
    const bool is_along = h == halfedge(s);
    make_room(2);
    remove(s);
    const Segment_index a = create(curve, is_along ? Triangulation::twin(hp) : hn);
    const Segment_index b = create(curve, is_along ? Triangulation::twin(hn) : hp);
    // The face lies to the left of hn and hp.
    link_outermost(a, is_along ? Triangulation::twin(hp) : Triangulation::twin(hn));
    link_outermost(b, is_along ? Triangulation::twin(hn) : Triangulation::twin(hp));
    link(a, b);
    link(b, a);
    m_curves[curve].first = a;
    m_curves[curve].last = b;
    return b;
  }

  /* Replaces a closed curve by the single segment that it was when `place` was recorded. */
  Segment_index restore_loop(Curve_index curve, const Bundle_place& place)
  {
    std::vector<Segment_index> segments;
    for_each_segment(curve, [&](Segment_index s) { segments.push_back(s); });
    for(Segment_index s : segments)
      remove(s);
    const Segment_index s = create(curve, place.halfedge);
    if(place.left != null_index)
      link_right_of(s, place.left);
    else if(place.right != null_index)
      link_outermost(s, Triangulation::twin(first_side(Triangulation::edge(place.halfedge))));
    else
      link_outermost(s, place.halfedge);
    link(s, s);
    m_curves[curve].first = m_curves[curve].last = s;
    return s;
  }

  // ---------------------------------------------------------------- state

  /* Loads a state into an empty store. Returns false if the state is invalid: ids or halfedges that do not exist or are
   * used twice, disconnected chains, or bundles with segments of other edges. The store must be cleared in that
   * case. */
  bool restore(const Network_state& state)
  {
    m_segments.resize(static_cast<std::size_t>(state.end_of_segment_ids));
    for(const Network_state::Curve& curve : state.curves)
      if(!restore_curve(curve))
        return false;
    for(const Network_state::Bundle& bundle : state.bundles)
      if(!restore_bundle(bundle))
        return false;
    return true;
  }

private:
  static constexpr Segment_index no_segment{0};

  struct Segment
  {
    Halfedge_index halfedge;             // null_index if it is dead
    std::array<Segment_index, 2> beside; // by side, in the circular bundle, along the first halfedge
    typename Walker::Place place = typename Walker::Place(); // of a side of its edge
    Segment_index next, previous;                            // in the chain of its curve
    Curve_index curve;
    bool is_head_fixed = false;
    mutable std::array<bool, 2> is_head_straight = {{false, false}}; // by side; true only if known
  };

  struct Curve
  {
    Segment_index first, last;
    bool is_closed;
    double initial_length;
  };

  // The place in a curve where segments are missing: between two segments, of which one is null_index at an end of a
  // path.
  struct Gap
  {
    Curve_index curve;
    Segment_index before, after;
    bool is_whole_loop;
  };

  static std::size_t number(Side side) { return static_cast<std::size_t>(side); }

  // ---------------------------------------------------------------- bundles

  // Also valid for an edge that was never touched.
  Segment_index leftmost_on(Halfedge_index h) const
  {
    return m_triangulation->holds(Triangulation::edge(h)) > 0 ? leftmost(m_triangulation->walker(h)) : no_segment;
  }

  void make_room_for_edges(std::size_t number)
  {
    if(m_leftmost.size() < number)
      m_leftmost.resize(number);
  }

  // Releases the edge of all its segments.
  void release_edge(const Walker& place)
  {
    Segment_index& first = m_leftmost[place.edge_place()];
    if(first == no_segment)
      return;
    first = no_segment;
    place.release();
  }

  // Converts a side as seen along h to one as seen along the first halfedge of its edge: 0 left, 1 right.
  static std::size_t side_along_first_halfedge(Halfedge_index h, Side side)
  {
    return static_cast<std::size_t>((h.idx() & 1) ^ (side == Side::RIGHT ? 1 : 0));
  }

  static Segment_index chosen(std::size_t i, Segment_index first, Segment_index second)
  {
    return Segment_index(first.idx() ^ ((first.idx() ^ second.idx()) & -static_cast<Index>(i)));
  }

  // Reserves memory for `number` segments and one more, on edges that were touched. One segment can then always be
  // created without an allocation, which rolling back a failed operation requires.
  void make_room(std::size_t number)
  {
    make_room_for_edges(m_triangulation->number_of_edge_places());
    if(m_segments.capacity() - m_segments.size() <= number)
      m_segments.reserve((std::max)(2 * m_segments.capacity(), m_segments.size() + number + 1));
  }

  // Recreates a segment with a previously used id, in no bundle. \pre it is not alive
  void revive(Segment_index s, Halfedge_index h)
  {
    const Walker place = m_triangulation->walker(h);
    make_room_for_edges(place.edge_place() + 1);
    m_segments[s].halfedge = h;
    m_segments[s].place = place.place();
  }

  // Makes s the outermost segment on the right of its edge as seen along h. \pre it is on that edge, but in no bundle
  void link_outermost(Segment_index s, Halfedge_index h)
  {
    const Walker place = placed(s, h);
    Segment_index& first = m_leftmost[place.edge_place()];
    if(first == no_segment) {
      m_segments[s].beside = {{s, s}};
      first = s;
      place.hold();
      return;
    }
    link_right_of(s, m_segments[first].beside[0]);
    if(!is_first_side(h))
      first = s;
  }

  // Puts s immediately right of another segment on its edge as seen along the first halfedge. \pre s is in no bundle
  void link_right_of(Segment_index s, Segment_index left)
  {
    const Segment_index right = m_segments[left].beside[1];
    m_segments[s].beside = {{left, right}};
    m_segments[left].beside[1] = s;
    m_segments[right].beside[0] = s;
  }

  // Removes s from its bundle.
  void unlink(Segment_index s)
  {
    const Walker place = placed(s, halfedge(s));
    const auto [left, right] = m_segments[s].beside;
    m_segments[left].beside[1] = right;
    m_segments[right].beside[0] = left;
    if(right == s)
      release_edge(place);
    else if(Segment_index& first = m_leftmost[place.edge_place()]; first == s)
      first = right;
  }

  // ---------------------------------------------------------------- chains

  // Creates a segment of a curve on a halfedge, in no chain and no bundle.
  Segment_index create(Curve_index curve, Halfedge_index h)
  {
    m_segments.emplace_back();
    const Segment_index s(end_of_ids() - 1);
    revive(s, h);
    m_segments[s].curve = curve;
    return s;
  }

  // Makes t the successor of s in their chain; either may be null_index.
  void link(Segment_index s, Segment_index t)
  {
    if(s != null_index)
      m_segments[s].next = t;
    if(t != null_index)
      m_segments[t].previous = s;
  }

  // Appends a new segment to its curve; it is rightmost on its edge.
  void append(Segment_index s)
  {
    Curve& curve = m_curves[this->curve(s)];
    link_outermost(s, halfedge(s));
    link(curve.last, s);
    curve.last = s;
    if(curve.first == null_index)
      curve.first = s;
  }

  // Creates segments along an arc for a curve that has the arc on the given side. Returns the first and the last one.
  std::pair<Segment_index, Segment_index> create_chain(Curve_index curve, const std::vector<Halfedge_index>& arc,
                                                       Side side)
  {
    Segment_index first = null_index, last = null_index;
    for(std::size_t i = 0; i < arc.size(); ++i) {
      const Halfedge_index h = side == Side::LEFT ? arc[i] : Triangulation::twin(arc[arc.size() - 1 - i]);
      const Segment_index s = create(curve, h);
      link_outermost(s, side == Side::LEFT ? h : Triangulation::twin(h));
      if(first == null_index) {
        first = s;
      } else {
        link(last, s);
        note_straight(last, opposite_side(side), true);
      }
      last = s;
    }
    return {first, last};
  }

  // Inserts a chain into a gap; an empty one, given by null_index twice, closes the gap.
  void fill(const Gap& gap, Segment_index first, Segment_index last)
  {
    Curve& c = m_curves[gap.curve];
    if(gap.is_whole_loop) {
      if(first != null_index)
        link(last, first);
      c.first = first;
      c.last = last;
      return;
    }
    link(gap.before, first == null_index ? gap.after : first);
    link(last == null_index ? gap.before : last, gap.after);
    const Segment_index head = first == null_index ? gap.after : first, tail = last == null_index ? gap.before : last;
    if(c.is_closed) { // any segment may be the first
      c.first = head;
      c.last = m_segments[head].previous;
      return;
    }
    if(gap.before == null_index)
      c.first = head;
    if(gap.after == null_index)
      c.last = tail;
  }

  // Replaces s, which is no longer in a bundle, by a and b.
  void replace_in_curve(Segment_index s, Segment_index a, Segment_index b)
  {
    const Segment old = m_segments[s];
    Curve& c = m_curves[old.curve];
    const bool was_whole_loop = old.next == s;
    link(a, b);
    link(was_whole_loop ? b : old.previous, a);
    if(!was_whole_loop && old.previous != null_index)
      m_segments[old.previous].is_head_straight = {};
    link(b, was_whole_loop ? a : old.next);
    m_segments[b].is_head_fixed = old.is_head_fixed;
    m_segments[s].halfedge = null_index;
    c.first = c.first == s ? a : c.first;
    c.last = c.last == s ? b : c.last;
  }

  void remove(Segment_index s)
  {
    unlink(s);
    m_segments[s].halfedge = null_index;
  }

  // ---------------------------------------------------------------- reading

  bool restore_curve(const Network_state::Curve& curve)
  {
    const Curve_index c(number_of_curves());
    m_curves.push_back({null_index, null_index, curve.is_closed, curve.initial_length});
    for(const Network_state::Segment& s : curve.segments) {
      const bool is_free = s.id.idx() > 0 && s.id.idx() < end_of_ids() && !is_alive(s.id);
      if(!is_free || !s.halfedge.is_valid() || s.halfedge.idx() >= triangulation().number_of_halfedges())
        return false;
      if(last(c) != null_index && triangulation().head(halfedge(last(c))) != triangulation().tail(s.halfedge))
        return false;
      revive(s.id, s.halfedge);
      m_segments[s.id].curve = c;
      set_head_fixed(s.id, s.is_head_fixed);
      append(s.id);
    }
    return !curve.is_closed || last(c) == null_index || close(c);
  }

  bool close(Curve_index curve)
  {
    if(triangulation().head(halfedge(last(curve))) != triangulation().tail(halfedge(first(curve))))
      return false;
    link(last(curve), first(curve));
    return true;
  }

  bool restore_bundle(const Network_state::Bundle& bundle)
  {
    if(!bundle.edge.is_valid() || bundle.edge.idx() >= triangulation().number_of_edges())
      return false;
    std::vector<Segment_index> there = this->bundle(bundle.edge), wanted = bundle.segments;
    std::sort(there.begin(), there.end());
    std::sort(wanted.begin(), wanted.end());
    if(there != wanted)
      return false;
    set_bundle(bundle.edge, bundle.segments);
    return true;
  }

  Triangulation* m_triangulation;
  Indexed_by<Segment_index, std::vector<Segment>> m_segments;
  Lazy_array<Segment_index> m_leftmost; // by the place of the edge, no_segment initially; grows as edges are touched
  Indexed_by<Curve_index, std::vector<Curve>> m_curves;
};

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

  // The joint at the head of `upstream`, which has a new successor because two segments have canceled.
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

/* Returns the end that a joint connects with the given one; none if the node is fixed. */
template <class Network>
Segment_end joined_end(const Network& network, const Segment_end& end)
{
  const bool is_head = end.halfedge != network.halfedge(end.segment);
  const Segment_index x = is_head ? end.segment : network.previous(end.segment);
  if(x == null_index || network.is_head_fixed(x))
    return {};
  const auto [at_x, at_y] = network.ends({x, Side::LEFT});
  return is_head ? at_y : at_x;
}

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
      const Segment_end mate = joined_end(m_network, end);
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
                "the curve must be a range of halfedges of the triangulation (Halfedge_index)");
  std::size_t position = 0;
  Halfedge_index first = null_index, last = null_index;
  for(Halfedge_index h : halfedges) {
    if(!h.is_valid() || h.idx() >= triangulation.number_of_halfedges())
      throw_naming<Invalid_curve_error>("the halfedge at position ", Element{position},
                                        " of a curve does not belong to the triangulation");
    if(last != null_index && triangulation.head(last) != triangulation.tail(h))
      throw_naming<Invalid_curve_error>("the halfedge at position ", Element{position},
                                        " of a curve does not start where the previous one ends");
    triangulation.length(h); // copies its face, which may throw: before the network changes
    if(first == null_index)
      first = h;
    last = h;
    ++position;
  }
  if(first == null_index)
    throw Invalid_curve_error("a curve has no edges; pass at least one halfedge");
  if(is_closed && triangulation.head(last) != triangulation.tail(first))
    throw Invalid_curve_error("the last halfedge of a closed curve does not end where the first one starts",
                              {position});
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_STORE_H
