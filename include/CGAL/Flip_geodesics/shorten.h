// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEN_H
#define CGAL_FLIP_GEODESICS_SHORTEN_H

#include <CGAL/Flip_geodesics/Shortener.h>
#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

namespace CGAL {
namespace Flip_geodesics {

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
 * \param stop a model of `FlipOutStopPredicate`
 * \param visitor a model of `FlipOutVisitor`
 * \throws Degenerate_face_error, Invalid_coordinate_error if a face that is touched is no triangle; the network and its
 *         triangulation are then valid, and the curves somewhere on their way, none longer than before
 *
 * \sa `Shortener`, for many short runs
 */
template <class Network, class StopPredicate = Never_stop_predicate, class Visitor = Default_shortening_visitor>
Shortening_report shorten(Network& network, const StopPredicate& stop = StopPredicate(), Visitor&& visitor = Visitor())
{
  Shortener<Network> shortener(network);
  shortener.run(stop, visitor);
  return shortener.report();
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEN_H
