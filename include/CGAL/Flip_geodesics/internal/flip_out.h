// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/internal/Wedge_queue.h>
#include <CGAL/Flip_geodesics/internal/flip_out_wedge.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * [SC20, Algorithm 2] for any network: while a wedge that is free has an angle below pi, take the smallest and flip it
 * out. Wedges are queued by angle, then segment, then side, so that the result is determined by the input.
 *
 * A wedge's angle does not change while its joint lives, since flips elsewhere keep the angle between two edges that
 * stay. So a key never goes stale. Whether the wedge is free does change: a wedge that is found blocked is dropped, and
 * `EdgePathGraph::replace_joint()` names it again when it may be free.
 */
template <class Network, class StopPredicate, class Visitor>
class Flip_out
{
  using Triangulation = typename Network::Triangulation;
  using Wedge = typename Network::Wedge;

  // With exact decisions every step shortens, whatever the rounded lengths say.
  static constexpr bool can_err = Triangulation::Traits::Has_drift::value;

public:
  Flip_out(Network& network, const StopPredicate& stop, Visitor& visitor)
    : m_network(network)
    , m_triangulation(network.triangulation())
    , m_stop(stop)
    , m_visitor(visitor)
    , m_curves(static_cast<std::size_t>(network.number_of_curves()))
  {
    for(Index c = 0; c < network.number_of_curves(); ++c) {
      m_curves[c].length = m_curves[c].shortest = network.length(c);
      m_length += m_curves[c].length;
      m_initial_length += network.initial_length(c);
      if(network.is_contracted(c))
        m_curves[c].status = Shortening_status::CONTRACTED;
    }
  }

  void run()
  {
    queue_all_joints();
    run_queue();
  }

  void run_queue()
  {
    while(!m_queue.empty() && !m_has_ended) {
      const Queued_wedge candidate = m_queue.top();
      m_queue.pop();
      if(is_current(candidate) && is_free(candidate.joint()))
        take_step(candidate);
    }
  }

  /// Looks at all joints of a curve again.
  void queue_curve(Index curve)
  {
    // A fan of faces is a chain of loads, each waiting for the one before; these do not wait for each other.
    m_network.for_each_segment(curve, [&](Index s) { m_triangulation.prefetch_faces(m_network.halfedge(s)); });
    m_network.for_each_segment(curve, [&](Index s) {
      if(m_network.next(s) != null_index) {
        queue({s, Side::LEFT});
        queue({s, Side::RIGHT});
      }
    });
  }

  Shortening_status status(Index curve) const { return m_curves[curve].status; }
  std::size_t flips() const { return m_flips; }
  std::size_t flips(Index curve) const { return m_curves[curve].flips; }
  std::size_t steps() const { return m_steps; }

private:
  struct Curve_state
  {
    Shortening_status status = Shortening_status::LOCALLY_SHORTEST;
    double length = 0;
    double shortest = 0; // up to what rounding makes of it
    std::size_t steps_since_shortest = 0;
    std::size_t flips = 0;
  };

  void queue_all_joints()
  {
    for(Index c = 0; c < m_network.number_of_curves(); ++c)
      queue_curve(c);
  }

  void queue(const Joint& joint)
  {
    const Wedge wedge = m_network.wedge(joint);
    if(wedge.state == Wedge_state::FREE)
      m_queue.push({turn_key(wedge.turn), joint, m_network.next(joint.incoming)});
  }

  double turn_key(const typename Triangulation::Turn& turn) const
  {
    return m_triangulation.traits().turn_key_object()(turn);
  }

  bool is_current(const Queued_wedge& candidate) const
  {
    const Index x = candidate.joint().incoming;
    return m_network.is_alive(x) && m_network.next(x) == candidate.outgoing() &&
           m_curves[m_network.curve(x)].status == Shortening_status::LOCALLY_SHORTEST;
  }

  bool is_free(const Joint& joint) const { return m_network.wedge(joint).state == Wedge_state::FREE; }

  void take_step(const Queued_wedge& candidate)
  {
    if(!m_visitor.go_further())
      return end(Shortening_status::STOPPED_BY_VISITOR);
    const Index curve = m_network.curve(candidate.joint().incoming);
    const std::size_t flips_before = m_flips;
    if(candidate.joint().incoming == candidate.outgoing())
      shorten_single_segment_loop(candidate);
    else
      shorten_joint(candidate);
    m_curves[curve].flips += m_flips - flips_before;
  }

  void shorten_joint(const Queued_wedge& candidate)
  {
    const Index curve = m_network.curve(candidate.joint().incoming);
    const auto start = m_triangulation.log_position();
    const double change = flip_out(candidate.joint());
    const bool is_longer = can_err && is_visible(change, curve) && change > 0;
    const Stop_decision decision = is_longer ? Stop_decision::CONTINUE : ask(candidate.key(), curve, change);
    if(is_longer || decision != Stop_decision::CONTINUE) {
      m_triangulation.rollback(start); // longer can only be wrong: the angle was below pi by rounding alone
      return obey(decision, curve);
    }
    apply(candidate.joint(), change);
    finish_step(curve);
  }

  // Flips out a free wedge, whose outer arc goes to m_arc. Returns by how much the curve becomes longer.
  double flip_out(const Joint& joint)
  {
    m_arc.clear();
    const auto [a, c] = m_network.ends(joint);
    const double change = -m_triangulation.length(a.halfedge) - m_triangulation.length(c.halfedge);
    if(m_network.is_turning_back(joint))
      return change;
    return change + flip_out_wedge(m_triangulation, a.halfedge, c.halfedge, m_arc, [&](Index h) { flip(h); });
  }

  void flip(Index h)
  {
    CGAL_assertion_msg(!m_network.is_occupied(h), "a free wedge holds no strand");
    m_triangulation.flip(h);
    ++m_flips;
    m_visitor.on_flip(m_triangulation, h);
  }

  void apply(const Joint& joint, double change)
  {
    const Index curve = m_network.curve(joint.incoming);
    m_network.replace_joint(joint, m_arc, m_affected);
    add_length(curve, change);
  }

  void finish_step(Index curve)
  {
    ++m_steps;
    m_visitor.after_flip_out(m_network, curve);
    if(m_network.is_contracted(curve))
      m_curves[curve].status = Shortening_status::CONTRACTED;
    queue_affected();
    count_blind_step(curve);
  }

  // Is the change larger than what rounding makes of the length?
  bool is_visible(double change, Index curve) const { return std::abs(change) > 1e-14 * m_curves[curve].length; }

  /*
   * Every step shortens, but by less than doubles see where the angle is within 1e-7 of pi. Exact decisions end all the
   * same; those of doubles could go round in circles, and a curve that has not become visibly shorter than ever before
   * in so many steps is given up. As each round shortens it visibly, there are finitely many.
   */
  void count_blind_step(Index curve)
  {
    constexpr std::size_t patience = 10000;
    Curve_state& state = m_curves[curve];
    ++state.steps_since_shortest;
    if(state.length < state.shortest * (1 - 1e-14)) {
      state.shortest = state.length;
      state.steps_since_shortest = 0;
    }
    if(can_err && state.steps_since_shortest > patience)
      state.status = Shortening_status::PRECISION_LIMIT;
  }

  void queue_affected()
  {
    for(const Joint& joint : m_affected)
      if(m_network.is_alive(joint.incoming) && m_network.next(joint.incoming) != null_index)
        queue(joint);
    m_affected.clear();
  }

  /*
   * A loop of one segment, [SC20, Appendix B], as one unit: move the loop over the face in its wedge, which lengthens
   * it, flip out the wedge at the old node, and then shorten it back on the other side as long as that is possible.
   * All of it happens in a flat annulus that holds no vertex and no other strand, and ends shorter than it began; the
   * manual's section on termination has the proof.
   */
  void shorten_single_segment_loop(const Queued_wedge& candidate)
  {
    const Index s = candidate.joint().incoming, curve = m_network.curve(s);
    const auto start = m_triangulation.log_position();
    const auto place = m_network.stack_place(s);
    const double length_before = m_curves[curve].length;

    const auto take_back = [&] {
      m_affected.clear();
      m_triangulation.rollback(start);
      m_network.restore_loop(curve, place);
    };
    try {
      perturb_and_flip_out({s, candidate.joint().side});
      std::size_t patience = can_err ? 10000 : (std::numeric_limits<std::size_t>::max)();
      while(!m_network.is_contracted(curve) && patience-- > 0 &&
            shorten_somewhere(curve, opposite_side(candidate.joint().side)))
      {
      }
    } catch(...) { // of a face that is no triangle, or of the visitor
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
    take_back();
    obey(decision, curve);
  }

  void perturb_and_flip_out(const Joint& loop)
  {
    const Index curve = m_network.curve(loop.incoming);
    const Index h = m_network.halfedge(loop.incoming);
    const Index arriving = m_network.perturb_loop(loop.incoming, loop.side == Side::LEFT ? h : Triangulation::twin(h));
    add_length(curve, m_network.length(curve) - m_curves[curve].length);
    const Joint old_node = {arriving, loop.side};
    apply(old_node, flip_out(old_node));
  }

  // One step at the first joint of a curve whose wedge on a side is free; false if there is none.
  bool shorten_somewhere(Index curve, Side side)
  {
    Index found = null_index;
    m_network.for_each_segment(curve, [&](Index s) {
      if(found == null_index && m_network.next(s) != s && is_free({s, side}))
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

  void add_length(Index curve, double change)
  {
    m_curves[curve].length += change;
    m_length += change;
  }

  Stop_decision ask(double key, Index curve, double change) const
  {
    return m_stop(Shortening_step{curve, key, m_steps, m_network.initial_length(curve), m_curves[curve].length + change,
                                  m_initial_length, m_length + change});
  }

  void obey(Stop_decision decision, Index curve)
  {
    switch(decision) {
    case Stop_decision::CONTINUE:
      return;
    case Stop_decision::CURVE_LENGTH_LIMIT:
      m_curves[curve].status = Shortening_status::LENGTH_LIMIT;
      return;
    case Stop_decision::LENGTH_LIMIT:
      return end(Shortening_status::LENGTH_LIMIT);
    case Stop_decision::ANGLE_LIMIT:
      return end(Shortening_status::ANGLE_LIMIT);
    case Stop_decision::ITERATION_LIMIT:
      return end(Shortening_status::ITERATION_LIMIT);
    }
  }

  // Every curve that still has a wedge to flip out gets the status; the others are locally shortest as they are.
  void end(Shortening_status status)
  {
    m_has_ended = true;
    for(Index c = 0; c < m_network.number_of_curves(); ++c)
      if(m_curves[c].status == Shortening_status::LOCALLY_SHORTEST && has_free_wedge(c))
        m_curves[c].status = status;
  }

  bool has_free_wedge(Index curve) const
  {
    bool found = false;
    m_network.for_each_segment(curve, [&](Index s) {
      if(m_network.next(s) != null_index)
        found = found || is_free({s, Side::LEFT}) || is_free({s, Side::RIGHT});
    });
    return found;
  }

  Network& m_network;
  Triangulation& m_triangulation;
  const StopPredicate& m_stop;
  Visitor& m_visitor;
  Wedge_queue m_queue;
  std::vector<Curve_state> m_curves;
  double m_length = 0, m_initial_length = 0;
  std::size_t m_flips = 0, m_steps = 0;
  bool m_has_ended = false;
  std::vector<Index> m_arc;
  std::vector<Joint> m_affected;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_H
