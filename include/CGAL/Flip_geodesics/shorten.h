// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEN_H
#define CGAL_FLIP_GEODESICS_SHORTEN_H

#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/internal/flip_out/flip_out.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsShortening
 *
 * Pulls the curves of a network tight as `shorten()` does, but in as many runs as one likes: what is known of the
 * joints is kept from run to run, so that a run takes time for its steps alone, not for the size of the network. For
 * animation, for budgets of time, for limits that are raised bit by bit. Where nothing stops it, the result is that of
 * one `shorten()`, bit by bit.
 *
 * While a shortener is in use, its network and triangulation are changed by nothing else. After an exception it is of
 * no use any more; make another one.
 *
 * \tparam Network_ a model of `EdgePathGraph`
 */
template <class Network_>
class Shortener
{
  static_assert(internal::Has_words<typename Network_::Triangulation>::value ||
                    !Network_::Triangulation::Traits::Has_drift::value,
                "decisions that can err are measured from the input, with which the triangulation does not correspond");

  using Traits = typename Network_::Triangulation::Traits;
  using Verdicts = internal::Indexed_by<Curve_index, std::vector<Verdict>>;
  using Straightnesses = internal::Indexed_by<Curve_index, std::vector<Straightness>>;

public:
  using Network = Network_; ///< the template parameter

  /// Looks at every joint of the network's curves, which must outlive the shortener. Linear in the segments and the
  /// degrees of their ends.
  explicit Shortener(Network& network)
    : m_network(network)
    , m_state(network)
  {
  }

  /*!
   * Goes on until every curve is locally shortest, or one of the arguments ends it. Steps that an earlier run was not
   * to take are open again, and `Shortening_step::steps` counts from 0.
   *
   * A flip takes constant time. What has become of the curves is measured only when no step is left, once.
   *
   * \param stop a model of `FlipOutStopPredicate`
   * \param visitor a model of `FlipOutVisitor`
   * \return `is_finished()`
   * \throws as `shorten()`
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

  /// Has a run found no step left to take?
  bool is_finished() const { return m_is_finished; }

  /// The steps taken so far in all runs [SC20, Algorithm 1].
  std::size_t number_of_steps() const { return m_state.steps; }
  /// The edges flipped so far in all runs, those of steps that were taken back included: each run that is stopped adds
  /// some.
  std::size_t number_of_flips() const { return m_state.flips; }

  /// The network's length, kept from step to step and not summed: constant time, and off by the rounding of the steps.
  double length() const { return m_state.length; }
  /// A curve's length, as above.
  double length(Curve_index curve) const { return m_state.curves[curve].length; }

  /// What has become of the curves so far. It is measured afresh from the input if the triangulation corresponds with
  /// one, and certified if the traits decide exactly. Linear in the network and in the input edges that it crosses.
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

  // Are coordinates or lengths of the input rounded? Then curves are measured, and not certified.
  bool is_rounded() const { return internal::is_input_rounded(m_network.triangulation()); }

  // Has a loop no length? Faces without area have loops of edges that are points.
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

  // Where decisions are exact, and numbers are not rounded, there are verdicts, too.
  Straightnesses measured([[maybe_unused]] Verdicts& verdicts) const
  {
    Straightnesses result(static_cast<std::size_t>(m_network.number_of_curves()));
    if constexpr(internal::Has_words<typename Network::Triangulation>::value) {
      Straightness_meter<Network> meter(m_network);
      [[maybe_unused]] Decision_statistics statistics;
      [[maybe_unused]] const bool is_certified = !Traits::Has_drift::value && !is_rounded();
      for(Curve_index c : internal::descriptors<Curve_index>(m_network.number_of_curves())) {
        if constexpr(!Traits::Has_drift::value)
          if(is_certified) {
            verdicts[c] = meter.certify(c, result[c], statistics).verdict;
            continue;
          }
        result[c] = meter(c);
      }
    }
    return result;
  }

  // Measures the curves, and goes on until they are as straight as the input says, or fresh vectors no longer help.
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

  // Joints of a curve that are bent although the triangulation's vectors say otherwise: lays out the faces in their
  // wedges afresh and looks at the curve again. Returns whether there were any.
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
  Shortening_status m_end = Shortening_status::LOCALLY_SHORTEST; // how the last run ended, this if by itself
  bool m_is_finished = false;
  Straightnesses m_straightness; // of the curves as they are now, or empty
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
 * Pulls the curves of a network tight by flipping edges [SC20, Algorithm 2], each in its isotopy class. It measures the
 * result afresh from the input. With traits of which `Has_drift` is `CGAL::Tag_true`, a curve is reported
 * `LOCALLY_SHORTEST` only if the measurement says so; `certify()` proves it exactly.
 *
 * Always ends. Deterministic: the smallest angle first, then the older segment, then the left side. A flip takes
 * constant time.
 *
 * \param network the curves; they are moved, and the edges around them flipped. Where they share edges,
 *        `order_overlapping_curves()` has to put them in order first. Curves that cross go on crossing, and no status
 *        tells; `Edge_path_network::is_valid()` does.
 * \param np named parameters, in any order: `stop_predicate`, a model of `FlipOutStopPredicate`, by default
 *        `Never_stop_predicate`; and `visitor`, a model of `FlipOutVisitor`, which is copied unless it is given by
 *        `std::ref()`, by default none
 * \throws Degenerate_face_error, Invalid_coordinate_error if a face that is touched is no triangle; the network and its
 *         triangulation are then valid, and the curves somewhere on their way, none longer than before
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEN_H
