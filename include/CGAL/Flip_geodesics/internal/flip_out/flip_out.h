// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/flip_out/flip_out_wedge.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A wedge that was free when it was queued. Its joint is identified by both segments, since the arriving one can get
 * another successor. Wedges are ordered by angle, then by the age of the segment, then left before right. An object has
 * 16 bytes, so that the siblings of the heap share a cache line.
 */
class Queued_wedge
{
public:
  /* A key that rounding errors have made negative counts as 0. */
  Queued_wedge(double key, const Joint& joint, Segment_index outgoing)
    : m_key(ordered_bits((std::max)(key, 0.0)))
    , m_segment_and_side(2 * static_cast<std::uint32_t>(joint.incoming.idx()) + (joint.side == Side::LEFT ? 0 : 1))
    , m_outgoing(outgoing)
  {
  }

  double key() const
  {
    double key;
    std::memcpy(&key, &m_key, sizeof key);
    return key;
  }

  Joint joint() const
  {
    return {Segment_index(static_cast<Index>(m_segment_and_side / 2)),
            m_segment_and_side % 2 == 0 ? Side::LEFT : Side::RIGHT};
  }

  Segment_index outgoing() const { return m_outgoing; }

  // Branch-free, because many keys are equal on symmetric meshes.
  static std::size_t is_before(const Queued_wedge& a, const Queued_wedge& b)
  {
    const std::size_t is_older = static_cast<std::size_t>(a.m_segment_and_side < b.m_segment_and_side);
    return static_cast<std::size_t>(a.m_key < b.m_key) | (static_cast<std::size_t>(a.m_key == b.m_key) & is_older);
  }

private:
  std::uint64_t m_key; // the bits of the key
  std::uint32_t m_segment_and_side;
  Segment_index m_outgoing;
};

using Wedge_queue = Heap_of_four<Queued_wedge>;

/*
 * The free wedges of a network with angles below pi, ordered by angle, then by the age of the segment, then left before
 * right, so that the input determines the order.
 *
 * The angle of a wedge does not change while its joint exists, since flips elsewhere preserve the angle between two
 * edges that stay. Keys are therefore always up to date. Whether the wedge is free can change: wedges must be checked
 * again when they leave the queue, and `EdgePathGraph::replace_joint()` returns those that may have become free.
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

  /* Returns whether the queue contains a wedge. */
  bool has_next() const { return !m_queue.empty(); }

  /* Removes and returns the first wedge, which may no longer be free and whose joint may no longer exist. \pre
   * has_next() */
  Queued_wedge pop()
  {
    const Queued_wedge first = m_queue.top();
    m_queue.pop();
    return first;
  }

  /* Sets a removed wedge aside until `release()`. */
  void hold(const Queued_wedge& wedge) { m_held.push_back(wedge); }

  /* Returns the wedges set aside to the queue and calls `function(wedge)` for each. */
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

  /* Returns whether a queued wedge is still free. Its angle is unchanged, but segments may have entered it. */
  bool is_still_free(const Joint& joint) const
  {
    const auto [a, b] = m_network.ends(joint);
    return !m_network.is_head_fixed(joint.incoming) && m_network.next_clockwise(a) == b;
  }

  /* Examines all joints of a curve, regardless of earlier results. */
  void look_at_curve(Curve_index curve)
  {
    // Walking through a fan of faces is a chain of dependent loads; these prefetches are independent of each other.
    m_network.for_each_segment(curve, [&](Segment_index s) {
      m_network.triangulation().prefetch_face(m_network.halfedge(s));
      m_network.triangulation().prefetch_face(Network::Triangulation::twin(m_network.halfedge(s)));
    });
    m_network.for_each_segment(curve, [&](Segment_index s) {
      look_at({s, Side::LEFT});
      look_at({s, Side::RIGHT});
    });
  }

  /* Examines the named joints that still exist. */
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

/* The state of the shortening of a curve. */
struct Curve_state
{
  Shortening_status status = Shortening_status::LOCALLY_SHORTEST; // or not yet shortened
  double length = 0;
  double shortest = 0; // up to rounding errors
  std::size_t steps_since_shortest = 0;
  std::size_t flips = 0;
};

/* The state of the shortening of a network: everything that one run passes on to the next. */
template <class Network>
struct Shortening_state
{
  explicit Shortening_state(Network& network)
    : wedges(network)
    , curves(static_cast<std::size_t>(network.number_of_curves()))
  {
    for(Curve_index c : descriptors<Curve_index>(network.number_of_curves())) {
      curves[c].length = curves[c].shortest = network.length(c);
      length += curves[c].length;
      initial_length += network.initial_length(c);
      if(network.is_contracted(c))
        curves[c].status = Shortening_status::CONTRACTED;
      wedges.look_at_curve(c);
    }
  }

  Free_wedges<Network> wedges;
  Indexed_by<Curve_index, std::vector<Curve_state>> curves;
  double length = 0, initial_length = 0;
  std::size_t flips = 0, steps = 0;
};

/*
 * [SC20, Algorithm 2] for any network: flips out the smallest free wedge with an angle below pi until none is left.
 */
template <class Network, class StopPredicate, class Visitor>
class Flip_out
{
  using Triangulation = typename Network::Triangulation;

  // With exact predicates every step shortens, whatever the rounded lengths are.
  static constexpr bool can_err = Triangulation::Traits::Has_drift::value;

public:
  Flip_out(Network& network, Shortening_state<Network>& state, const StopPredicate& stop, Visitor& visitor)
    : m_network(network)
    , m_triangulation(network.triangulation())
    , m_state(state)
    , m_wedges(state.wedges)
    , m_curves(state.curves)
    , m_stop(stop)
    , m_visitor(visitor)
    , m_first_step(state.steps)
  {
  }

  /* Runs until no wedge is left or the shortening is stopped. */
  void run()
  {
    while(const std::optional<Queued_wedge> candidate = next_candidate()) {
      const Joint joint = candidate->joint();
      const Curve_index curve = m_network.curve(joint.incoming);
      const std::size_t flips_before = m_state.flips;
      if(joint.incoming == candidate->outgoing()) {
        shorten_single_segment_loop(*candidate);
      } else {
        const auto start = m_triangulation.log_position();
        const double change = flip_out(joint);
        if(is_step_permitted(*candidate, curve, change)) {
          apply(joint, change);
          finish_step(curve);
        } else {
          m_triangulation.rollback(start);
        }
      }
      m_curves[curve].flips += m_state.flips - flips_before;
    }
  }

  /* Returns whether the shortening was stopped. */
  bool has_ended() const { return m_end != Shortening_status::LOCALLY_SHORTEST; }

  /* Returns the status of all curves that still have a wedge to flip out. \pre has_ended() */
  Shortening_status end_status() const { return m_end; }

private:
  // Removes wedges from the queue up to the next one to flip out; returns nothing if the run ends.
  std::optional<Queued_wedge> next_candidate()
  {
    while(m_wedges.has_next() && !has_ended()) {
      const Queued_wedge candidate = m_wedges.pop();
      if(is_current(candidate) && m_wedges.is_still_free(candidate.joint()) && !is_stopped_by_visitor(candidate))
        return candidate;
    }
    return {};
  }

  bool is_current(const Queued_wedge& candidate)
  {
    const Segment_index x = candidate.joint().incoming;
    if(!m_network.is_alive(x) || m_network.next(x) != candidate.outgoing())
      return false;
    const Shortening_status status = m_curves[m_network.curve(x)].status;
    if(status == Shortening_status::LENGTH_LIMIT)
      m_wedges.hold(candidate);
    return status == Shortening_status::LOCALLY_SHORTEST;
  }

  bool is_stopped_by_visitor(const Queued_wedge& candidate)
  {
    if(m_visitor.go_further())
      return false;
    m_wedges.hold(candidate);
    m_end = Shortening_status::STOPPED_BY_VISITOR;
    return true;
  }

  // Returns whether a joint that has been flipped out, which changes the length of its curve, is replaced.
  bool is_step_permitted(const Queued_wedge& candidate, Curve_index curve, double change)
  {
    if(can_err && is_visible(change, curve) && change > 0)
      return false; // an increase must be an error: rounding alone made the angle smaller than pi
    return obey(ask(candidate.key(), curve, change), candidate, curve);
  }

  // Flips out a free wedge and writes its outer arc to m_arc. Returns the increase of the curve's length.
  double flip_out(const Joint& joint)
  {
    m_arc.clear();
    const auto [a, c] = m_network.ends(joint);
    const double change = -m_triangulation.length(a.halfedge) - m_triangulation.length(c.halfedge);
    if(m_network.is_turning_back(joint))
      return change;
    return change + flip_out_wedge(m_triangulation, a.halfedge, c.halfedge, m_arc, [&](Halfedge_index h) { flip(h); });
  }

  void flip(Halfedge_index h)
  {
    CGAL_assertion_msg(!m_network.is_occupied(h), "a free wedge must not contain a segment end");
    m_triangulation.flip(h);
    ++m_state.flips;
    m_visitor.on_flip(m_triangulation, h);
  }

  void apply(const Joint& joint, double change)
  {
    add_length(m_network.curve(joint.incoming), change);
    m_network.replace_joint(joint, m_arc, m_affected);
  }

  void finish_step(Curve_index curve)
  {
    ++m_state.steps;
    m_visitor.after_flip_out(m_network, curve);
    if(m_network.is_contracted(curve))
      m_curves[curve].status = Shortening_status::CONTRACTED;
    m_wedges.look_at_all(m_affected);
    m_affected.clear();
    count_blind_step(curve);
  }

  // Returns whether the change exceeds the rounding errors of the length.
  bool is_visible(double change, Curve_index curve) const
  {
    return std::abs(change) > visible_length_change * m_curves[curve].length;
  }

  /*
   * Every step shortens, but if the angle is within 1e-7 of pi, the change is too small for doubles. With exact
   * predicates the algorithm terminates nevertheless. With inexact ones it could cycle, so a curve is aborted if its
   * length has not visibly fallen below its previous minimum for `patience` steps. Since each such period shortens it
   * visibly, there are finitely many.
   */
  void count_blind_step(Curve_index curve)
  {
    constexpr std::size_t patience = 10000;
    Curve_state& state = m_curves[curve];
    ++state.steps_since_shortest;
    if(state.length < state.shortest * (1 - visible_length_change)) {
      state.shortest = state.length;
      state.steps_since_shortest = 0;
    }
    if(can_err && state.steps_since_shortest > patience)
      state.status = Shortening_status::PRECISION_LIMIT;
  }

  /*
   * Shortens a loop of one segment, [SC20, Appendix B], as a compound step: move the loop over the face in its wedge,
   * which lengthens it, flip out the wedge at the old node, and then shorten it back on the other side as long as
   * possible. All of this happens in a flat annulus that contains neither a vertex nor another segment, and the loop
   * ends up shorter than before; the proof is in the manual, in the section on loops of one segment.
   */
  void shorten_single_segment_loop(const Queued_wedge& candidate)
  {
    const Segment_index s = candidate.joint().incoming;
    const Curve_index curve = m_network.curve(s);
    const auto start = m_triangulation.log_position();
    const auto place = m_network.bundle_place(s);
    const double length_before = m_curves[curve].length;

    const auto take_back = [&] {
      m_affected.clear();
      m_triangulation.rollback(start);
      return m_network.restore_loop(curve, place);
    };
    try {
      perturb_and_flip_out({s, candidate.joint().side});
      std::size_t patience = can_err ? 10000 : (std::numeric_limits<std::size_t>::max)();
      while(!m_network.is_contracted(curve) && patience-- > 0 &&
            shorten_somewhere(curve, opposite_side(candidate.joint().side)))
      {
      }
    } catch(...) { // from a face that is not a triangle, or from the visitor
      take_back();
      throw;
    }

    const double change = m_curves[curve].length - length_before;
    add_length(curve, -change);
    const bool is_shorter = !can_err || change < 0;
    const Stop_decision decision = is_shorter ? ask(candidate.key(), curve, change) : Stop_decision::CONTINUE;
    if(is_shorter && decision == Stop_decision::CONTINUE) {
      add_length(curve, change);
      return finish_step(curve);
    }
    const Segment_index restored = take_back();
    obey(decision, {candidate.key(), {restored, candidate.joint().side}, restored}, curve);
  }

  void perturb_and_flip_out(const Joint& loop)
  {
    const Curve_index curve = m_network.curve(loop.incoming);
    const Halfedge_index h = m_network.halfedge(loop.incoming);
    const Segment_index arriving =
        m_network.perturb_loop(loop.incoming, loop.side == Side::LEFT ? h : Triangulation::twin(h));
    add_length(curve, m_network.length(curve) - m_curves[curve].length);
    const Joint old_node = {arriving, loop.side};
    apply(old_node, flip_out(old_node));
  }

  // Makes one step at the first joint of a curve whose wedge on the side is free; returns false if there is none.
  bool shorten_somewhere(Curve_index curve, Side side)
  {
    Segment_index found = null_index;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      if(found == null_index && m_network.next(s) != s && m_wedges.is_free({s, side}))
        found = s;
    });
    if(found == null_index)
      return false;
    const auto start = m_triangulation.log_position();
    const double change = flip_out({found, side});
    if(can_err && change >= 0) {
      m_triangulation.rollback(start);
      return false;
    }
    apply({found, side}, change);
    return true;
  }

  void add_length(Curve_index curve, double change)
  {
    m_curves[curve].length += change;
    m_state.length += change;
  }

  Stop_decision ask(double key, Curve_index curve, double change) const
  {
    return m_stop(Shortening_step{curve, key, m_state.steps - m_first_step, m_network.initial_length(curve),
                                  m_curves[curve].length + change, m_state.initial_length, m_state.length + change,
                                  m_triangulation.memory_of_records()});
  }

  // Applies a predicate's decision on a candidate, which is kept for another run if it was rejected. Returns whether
  // the candidate was accepted.
  bool obey(Stop_decision decision, const Queued_wedge& candidate, Curve_index curve)
  {
    if(decision == Stop_decision::CONTINUE)
      return true;
    m_wedges.hold(candidate);
    (decision == Stop_decision::CURVE_LENGTH_LIMIT ? m_curves[curve].status : m_end) = status_of(decision);
    return false;
  }

  static Shortening_status status_of(Stop_decision decision)
  {
    switch(decision) {
    case Stop_decision::CURVE_LENGTH_LIMIT:
    case Stop_decision::LENGTH_LIMIT:
      return Shortening_status::LENGTH_LIMIT;
    case Stop_decision::ANGLE_LIMIT:
      return Shortening_status::ANGLE_LIMIT;
    case Stop_decision::ITERATION_LIMIT:
      return Shortening_status::ITERATION_LIMIT;
    case Stop_decision::MEMORY_LIMIT:
      return Shortening_status::MEMORY_LIMIT;
    case Stop_decision::CONTINUE:
      break;
    }
    return Shortening_status::LOCALLY_SHORTEST;
  }

  Network& m_network;
  Triangulation& m_triangulation;
  Shortening_state<Network>& m_state;
  Free_wedges<Network>& m_wedges;
  Indexed_by<Curve_index, std::vector<Curve_state>>& m_curves;
  const StopPredicate& m_stop;
  Visitor& m_visitor;
  std::size_t m_first_step;
  Shortening_status m_end = Shortening_status::LOCALLY_SHORTEST;
  std::vector<Halfedge_index> m_arc;
  std::vector<Joint> m_affected;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FLIP_OUT_H
