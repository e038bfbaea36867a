// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEN_H
#define CGAL_FLIP_GEODESICS_SHORTEN_H

#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/internal/flip_out.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>
#include <CGAL/Flip_geodesics/verify.h>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/*
 * Joints of a curve that are bent although the triangulation's vectors say otherwise: lays out the faces in their
 * wedges afresh and queues the curve again. Returns whether there were any.
 */
template <class Network, class Engine>
bool refresh_bent_joints(Network& network, Engine& engine, Index curve)
{
  if(engine.status(curve) != Shortening_status::LOCALLY_SHORTEST)
    return false;
  Straightness_meter<Network> meter(network);
  if(meter(curve).is_locally_shortest())
    return false;
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

/* Goes on until the curves are as straight as the input says, or fresh vectors no longer help. */
template <class Network, class Engine>
void shorten_where_drift_hid_it(Network& network, Engine& engine)
{
  constexpr int most_rounds = 50;
  bool has_refreshed = true;
  for(int round = 0; round < most_rounds && has_refreshed; ++round) {
    has_refreshed = false;
    for(Index c = 0; c < network.number_of_curves(); ++c)
      has_refreshed = refresh_bent_joints(network, engine, c) || has_refreshed;
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
 *         triangulation are then valid, and the curves somewhere on their way; a loop of one segment may be longer than
 *         before
 */
template <class Network, class StopPredicate = Never_stop_predicate, class Visitor = Default_shortening_visitor>
Shortening_report shorten(Network& network, const StopPredicate& stop = StopPredicate(), Visitor&& visitor = Visitor())
{
  internal::Flip_out<Network, StopPredicate, std::remove_reference_t<Visitor>> engine(network, stop, visitor);
  engine.run();
  if constexpr(Network::Triangulation::Traits::Has_drift::value)
    internal::shorten_where_drift_hid_it(network, engine);

  Shortening_report report;
  report.flips = engine.flips();
  report.flip_outs = engine.steps();
  Straightness_meter<Network> meter(network);
  for(Index c = 0; c < network.number_of_curves(); ++c) {
    const Straightness straightness = meter(c);
    Shortening_status status = engine.status(c);
    if(status == Shortening_status::LOCALLY_SHORTEST && Network::Triangulation::Traits::Has_drift::value &&
       !straightness.is_locally_shortest())
      status = Shortening_status::PRECISION_LIMIT;
    report.curves.push_back({status, network.initial_length(c), network.length(c), straightness.smallest_angle});
  }
  return report;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEN_H
