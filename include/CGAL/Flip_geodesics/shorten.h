// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEN_H
#define CGAL_FLIP_GEODESICS_SHORTEN_H

#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/internal/flip_out/flip_out.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/concepts.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsShortening
 *
 * Shortens the curves of a network as `shorten()` does, but in any number of runs.
 *
 * Several runs are useful for animations, time budgets, and limits that are relaxed gradually. A shortener keeps the
 * state of the joints between runs, so a later run does not inspect all joints again. A single run is equivalent to a
 * call of `shorten()` with the same stop predicate and visitor: the results are bitwise identical.
 *
 * While a shortener is in use, do not change its network or the triangulation by other means. A shortener that has
 * thrown an exception must not be used any longer; construct a new one instead.
 *
 * \tparam Network_ a model of `EdgePathGraph`. If `Has_drift` of its traits is `CGAL::Tag_true`, its triangulation must
 *         be a model of `IntrinsicTriangulationOfMesh`
 */
template <class Network_>
class Shortener
{
  static_assert(internal::has_edge_sequences<typename Network_::Triangulation> ||
                    !Network_::Triangulation::Traits::Has_drift::value,
                "traits with Has_drift == Tag_true require a model of IntrinsicTriangulationOfMesh, since results are "
                "measured on the input mesh");

  using Traits = typename Network_::Triangulation::Traits;
  using Verdicts = internal::Indexed_by<Curve_index, std::vector<Verdict>>;
  using Straightnesses = internal::Indexed_by<Curve_index, std::vector<Straightness>>;

public:
  using Network = Network_; ///< the type of the network

  /// Constructs a shortener and inspects every joint of the curves of `network`. The network must outlive the
  /// shortener.
  ///
  /// Complexity: linear in the number of segments plus the sum of the degrees of their end points.
  explicit Shortener(Network& network)
    : m_network(network)
    , m_state(network)
  {
    static_assert(internal::is_edge_path_graph<Network>());
  }

  /*!
   * Shortens the curves until no step remains, or until the stop predicate or the visitor ends the run.
   *
   * Each run reconsiders the steps that a stop predicate rejected in an earlier run, and counts
   * `Shortening_step::steps` from 0.
   *
   * \param stop a model of `FlipOutStopPredicate`
   * \param visitor a model of `FlipOutVisitor`
   * \return the value of `is_finished()`
   * \throws Degenerate_face_error as `shorten()` does
   * \throws Invalid_coordinate_error as `shorten()` does
   *
   * Complexity: typically linear in the number of flips. With traits whose `Has_drift` is `CGAL::Tag_true`, the curves
   * are also measured when no step remains. A measurement takes the time of a call of `report()`. If a measurement
   * finds a bend, the faces at the bend are recomputed, and the curves are shortened further and measured again, at
   * most 50 times.
   */
  template <class StopPredicate = Never_stop_predicate, class Visitor = Default_shortening_visitor>
  bool run(const StopPredicate& stop = StopPredicate(), Visitor&& visitor = Visitor())
  {
    static_assert(internal::is_visitor<Visitor, Network>,
                  "the visitor lacks a member of FlipOutVisitor: derive it from Default_shortening_visitor");
    if(is_finished())
      return true;
    m_state.wedges.release([this](const internal::Queued_wedge& wedge) {
      m_state.curves[m_network.curve(wedge.joint().incoming)].status = Shortening_status::LOCALLY_SHORTEST;
    });
    internal::Flip_out<Network, StopPredicate, std::remove_reference_t<Visitor>> flip_out(m_network, m_state, stop,
                                                                                          visitor);
    flip_out.run();
    if constexpr(Traits::Has_drift::value)
      go_on_where_drift_hid_it(flip_out);
    m_end = flip_out.end_status();
    m_is_finished = !flip_out.has_ended() && m_state.wedges.empty();
    return m_is_finished;
  }

  /// Returns whether a run has ended because no step remained. Steps that a stop predicate has rejected count as
  /// remaining.
  bool is_finished() const { return m_is_finished; }

  /// Returns the number of steps taken so far in all runs \cgalCite{SC20,Algorithm 1}.
  std::size_t number_of_steps() const { return m_state.steps; }
  /// Returns the number of flips so far in all runs, including the flips of steps that were rolled back.
  std::size_t number_of_flips() const { return m_state.flips; }

  /// Returns the length of the network in constant time. Since the length is updated with each step, it accumulates the
  /// rounding errors of all steps.
  double length() const { return m_state.length; }
  /// Returns the length of a curve in constant time. Like the length of the network, it is updated with each step.
  double length(Curve_index curve) const { return m_state.curves[curve].length; }

  /// Returns a report on the curves in their current state. If the triangulation is a model of
  /// `IntrinsicTriangulationOfMesh`, the straightness of the curves is computed from the input. If, in addition, the
  /// predicates of the traits are exact and the input is not rounded, the curves are certified.
  ///
  /// Complexity: if the floating-point filter suffices, linear in the number of segments plus the number of input edges
  /// that the curves cross plus the sum of the degrees of the vertices through which the curves pass.
  Shortening_report report() const
  {
    Verdicts verdicts(static_cast<std::size_t>(m_network.number_of_curves()), Verdict::UNDECIDED);
    const Straightnesses straightness = m_straightness.empty() ? measured(verdicts) : m_straightness;
    Shortening_report report;
    report.flips = m_state.flips;
    report.flip_outs = m_state.steps;
    for(Curve_index c : internal::descriptors<Curve_index>(m_network.number_of_curves()))
      report.curves.push_back({status(c, straightness[c], verdicts[c]),
                               m_network.initial_length(c),
                               m_network.length(c),
                               straightness[c].smallest_angle,
                               m_state.curves[c].flips,
                               verdict(c, verdicts[c]),
                               false,
                               {}});
    return report;
  }

private:
  Shortening_status status(Curve_index curve, const Straightness& straightness, Verdict verdict) const
  {
    const Shortening_status status = is_point(curve) ? Shortening_status::CONTRACTED : m_state.curves[curve].status;
    if(status != Shortening_status::LOCALLY_SHORTEST)
      return status;
    if(m_end != Shortening_status::LOCALLY_SHORTEST && has_free_wedge(curve))
      return m_end;
    const bool is_measured = Traits::Has_drift::value || is_rounded();
    if(is_measured && !(straightness.is_locally_shortest() && std::isfinite(m_network.length(curve))))
      return Shortening_status::PRECISION_LIMIT;
    if(verdict == Verdict::BENT_SEGMENT || verdict == Verdict::BENT_JOINT)
      return Shortening_status::DEGENERATE_FACES;
    return status;
  }

  Verdict verdict(Curve_index curve, Verdict verdict) const
  {
    return !Traits::Has_drift::value && is_point(curve) && !is_rounded() ? Verdict::PROVEN : verdict;
  }

  // Returns whether coordinates or lengths of the input are rounded. If they are, curves are measured, but not
  // certified.
  bool is_rounded() const { return internal::is_input_rounded(m_network.triangulation()); }

  // Returns whether a curve is closed and has length zero. Degenerate faces can have loops of length zero as edges.
  bool is_point(Curve_index curve) const { return m_network.is_closed(curve) && m_network.length(curve) == 0; }

  bool has_free_wedge(Curve_index curve) const
  {
    bool found = false;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      if(m_network.next(s) != null_index)
        found = found || m_state.wedges.is_free({s, Side::LEFT}) || m_state.wedges.is_free({s, Side::RIGHT});
    });
    return found;
  }

  // Returns the straightness of each curve. Also computes the verdicts if the predicates are exact and the input is not
  // rounded.
  Straightnesses measured([[maybe_unused]] Verdicts& verdicts) const
  {
    Straightnesses result(static_cast<std::size_t>(m_network.number_of_curves()));
    if constexpr(internal::has_edge_sequences<typename Network::Triangulation>) {
      Straightness_meter<Network> meter(m_network);
      [[maybe_unused]] Decision_statistics statistics;
      [[maybe_unused]] const bool is_certified = !Traits::Has_drift::value && !is_rounded();
      for(Curve_index c : internal::descriptors<Curve_index>(m_network.number_of_curves())) {
        if constexpr(!Traits::Has_drift::value)
          if(is_certified) {
            verdicts[c] = meter.certify(c, result[c], statistics).verdict();
            continue;
          }
        result[c] = meter(c);
      }
    }
    return result;
  }

  // Measures the curves, recomputes the faces at bends from the input, and continues to shorten, in at most 50 rounds.
  // Ends when no face is recomputed, because all curves are straight or because no face can be recomputed.
  template <class Engine>
  void go_on_where_drift_hid_it(Engine& flip_out)
  {
    constexpr int most_rounds = 50;
    m_straightness.clear();
    for(int round = 0; !flip_out.has_ended(); ++round) {
      Verdicts none;
      m_straightness = measured(none);
      bool has_refreshed = false;
      for(Curve_index c(0); c.idx() < m_network.number_of_curves() && round < most_rounds; ++c)
        if(m_state.curves[c].status == Shortening_status::LOCALLY_SHORTEST && !m_straightness[c].is_locally_shortest())
          has_refreshed = refresh_bent_joints(c) || has_refreshed;
      if(!has_refreshed)
        return;
      m_straightness.clear();
      flip_out.run();
    }
  }

  // Recomputes the faces in the wedges at those bends of a curve that drift has hidden, and inspects the curve again.
  // Returns whether any wedge was recomputed.
  bool refresh_bent_joints(Curve_index curve)
  {
    Straightness_meter<Network> meter(m_network);
    bool has_refreshed = false;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      for(Side side : {Side::LEFT, Side::RIGHT}) {
        if(m_network.next(s) == null_index || meter.angle({s, side}) >= Straightness::straight_angle())
          continue;
        has_refreshed = meter.refresh_wedge({s, side}, m_network.triangulation()) || has_refreshed;
      }
    });
    if(has_refreshed)
      m_state.wedges.look_at_curve(curve);
    return has_refreshed;
  }

  Network& m_network;
  internal::Shortening_state<Network> m_state;
  Shortening_status m_end = Shortening_status::LOCALLY_SHORTEST; // of the last run; this value if no step remained
  bool m_is_finished = false;
  Straightnesses m_straightness; // of the current curves, or empty
};

namespace internal {

template <class Network, class StopPredicate, class Visitor>
Shortening_report shorten(Network& network, const StopPredicate& stop, Visitor&& visitor)
{
  Shortener<Network> shortener(network);
  shortener.run(stop, visitor);
  return shortener.report();
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsShortening
 *
 * Shortens each curve of a network to a geodesic within the isotopy class of the curve, by flipping edges
 * \cgalCite{SC20,Algorithm 2}.
 *
 * The process always terminates, and it is deterministic. The smallest angle is widened first. Ties are broken in favor
 * of the older segment and, at one segment, in favor of the left side.
 *
 * If the triangulation is a model of `IntrinsicTriangulationOfMesh`, the straightness of the resulting curves is
 * computed from the input. With traits whose `Has_drift` is `CGAL::Tag_true`, a curve receives the status
 * `LOCALLY_SHORTEST` only if this measurement confirms that the curve is locally shortest up to
 * `Straightness::tolerance()`. To verify such a curve by exact predicates, call `certify()`.
 *
 * If one of the exceptions listed below is thrown, the network and its triangulation remain valid, and no curve is
 * longer than before the call.
 *
 * \param network the network, of a type that `Shortener` accepts. Its curves are shortened, and the edges around them
 *        are flipped. If several segments lie on one edge, call `order_overlapping_curves()` first. If curves cross
 *        before the call, they still cross after the call. No status indicates such crossings, but
 *        `Edge_path_network::is_valid()` returns `false` if curves cross at free nodes
 * \param np an optional sequence of named parameters, in any order, among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{stop_predicate}
 *     \cgalParamDescription{a predicate that can end the process early}
 *     \cgalParamType{a model of `FlipOutStopPredicate`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{`Never_stop_predicate`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose members are called before each step, after each flip and after each step}
 *     \cgalParamType{a model of `FlipOutVisitor`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report with one entry per curve
 * \throws Degenerate_face_error if a visited face has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if a visited face has a coordinate or length that is not finite or is out of range
 *
 * Complexity: typically linear in the number of segments plus the number of flips.
 *
 * \sa `Shortener`, for many short runs
 */
template <class Network, class... NamedParameters>
Shortening_report shorten(Network& network, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal::Stop_parameter, internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  return internal::shorten(network, internal::stop_predicate_of(options), visitor.get());
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_SHORTEN_H
