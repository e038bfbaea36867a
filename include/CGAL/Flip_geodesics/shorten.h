// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEN_H
#define CGAL_FLIP_GEODESICS_SHORTEN_H

#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/internal/flip_out.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>
#include <CGAL/Flip_geodesics/verify.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

template <class Network>
std::vector<Straightness> measure_curves(const Network& network)
{
  std::vector<Straightness> result;
  Straightness_meter<Network> meter(network);
  for(Index c = 0; c < network.number_of_curves(); ++c)
    result.push_back(meter(c));
  return result;
}

/*
 * Joints of a curve that are bent although the triangulation's vectors say otherwise: lays out the faces in their
 * wedges afresh and queues the curve again. Returns whether there were any.
 */
template <class Network, class Engine>
bool refresh_bent_joints(Network& network, Engine& engine, Index curve)
{
  Straightness_meter<Network> meter(network);
  bool has_refreshed = false;
  network.for_each_segment(curve, [&](Index s) {
    for(Side side : {Side::LEFT, Side::RIGHT}) {
      if(network.next(s) == null_index || meter.angle({s, side}) >= Straightness::straight_angle())
        continue;
      has_refreshed = meter.refresh_wedge({s, side}, network.triangulation()) || has_refreshed;
    }
  });
  if(has_refreshed)
    engine.queue_curve(curve);
  return has_refreshed;
}

/* Measures the curves, and goes on until they are as straight as the input says, or fresh vectors no longer help. */
template <class Network, class Engine>
std::vector<Straightness> shorten_where_drift_hid_it(Network& network, Engine& engine)
{
  constexpr int most_rounds = 50;
  for(int round = 0;; ++round) {
    const std::vector<Straightness> result = measure_curves(network);
    bool has_refreshed = false;
    for(Index c = 0; c < network.number_of_curves() && round < most_rounds; ++c)
      if(engine.status(c) == Shortening_status::LOCALLY_SHORTEST && !result[c].is_locally_shortest())
        has_refreshed = refresh_bent_joints(network, engine, c) || has_refreshed;
    if(!has_refreshed)
      return result;
    engine.run_queue();
  }
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsRef
 *
 * Pulls the curves of a network tight by flipping edges [SC20, Algorithm 2], each in its isotopy class, and measures
 * the result afresh from the input. With traits of which `Has_drift` is `CGAL::Tag_true`, a curve is reported
 * `LOCALLY_SHORTEST` only if the measurement says so; `certify()` proves it exactly.
 *
 * Always ends. Deterministic: the smallest angle first, then the older segment, then the left side. A flip takes
 * constant time.
 *
 * \param network the curves; they are moved, and the edges around them flipped
 * \param stop a model of `FlipOutStopPredicate`
 * \param visitor a model of `FlipOutVisitor`
 * \throws Degenerate_face_error, Invalid_coordinate_error if a face that is touched is no triangle; the network and its
 *         triangulation are then valid, and the curves somewhere on their way, none longer than before
 */
template <class Network, class StopPredicate = Never_stop_predicate, class Visitor = Default_shortening_visitor>
Shortening_report shorten(Network& network, const StopPredicate& stop = StopPredicate(), Visitor&& visitor = Visitor())
{
  internal::Flip_out<Network, StopPredicate, std::remove_reference_t<Visitor>> engine(network, stop, visitor);
  constexpr bool has_drift = Network::Triangulation::Traits::Has_drift::value;
  engine.run();
  std::vector<Straightness> measured;
  if constexpr(has_drift)
    measured = internal::shorten_where_drift_hid_it(network, engine);
  else
    measured = internal::measure_curves(network);

  Shortening_report report;
  report.flips = engine.flips();
  report.flip_outs = engine.steps();
  for(Index c = 0; c < network.number_of_curves(); ++c) {
    Shortening_status status = engine.status(c);
    if(has_drift && status == Shortening_status::LOCALLY_SHORTEST && !measured[c].is_locally_shortest())
      status = Shortening_status::PRECISION_LIMIT;
    report.curves.push_back(
        {status, network.initial_length(c), network.length(c), measured[c].smallest_angle, engine.flips(c)});
  }
  return report;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEN_H
