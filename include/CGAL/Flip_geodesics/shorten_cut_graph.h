// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEN_CUT_GRAPH_H
#define CGAL_FLIP_GEODESICS_SHORTEN_CUT_GRAPH_H

#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Interrupting_visitor.h>
#include <CGAL/Flip_geodesics/internal/topology/Needless_seams.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Pulls a network tight along which each component of a surface is cut open to a disk, so that this remains: each
 * component is one disk afterwards, and all curves are locally shortest between their ends.
 *
 * Curves that were apart can come to run along the same edges, or to touch in a vertex. Cut along all of them, the
 * component falls into several disks then, and some of the curves are needless: two disks with a chain in common are one
 * disk without it. So chains between different disks are dropped, the longest first, and what leads to nowhere without
 * them. A vertex where only two curves are left is no fixed end any more. The network gets shorter each time, and is
 * pulled tight again until no chain is needless. If all curves are needed from the start, this is `shorten()`.
 *
 * \param network a network made by `add_cut_graph()`, or any other one that cuts each component into disks; where curves
 *        are dropped, its curves are numbered anew
 * \param visitor a model of `FlipOutVisitor`, as for `shorten()`. If its `go_further()` returns `false`, then this ends
 *        without looking for needless chains once more: the network still cuts each component open, but into several
 *        disks perhaps
 * \return the report of the last run of `shorten()`, for the curves that are left, with flips and steps of all runs
 * \throws as `shorten()`
 *
 * Complexity: that of `shorten()`, and linear in the triangulation for each run.
 */
template <class Network, class Visitor = Default_shortening_visitor>
Shortening_report shorten_cut_graph(Network& network, Visitor&& visitor = Visitor())
{
  internal::Stop_remembering_visitor<std::remove_reference_t<Visitor>> remembering(visitor);
  std::size_t flips = 0, flip_outs = 0;
  Shortening_report report;
  do {
    report = shorten(network, Never_stop_predicate(), remembering);
    flips += report.flips;
    flip_outs += report.flip_outs;
  } while(!remembering.has_stopped() && internal::Needless_seams<Network>(network).remove());
  report.flips = flips;
  report.flip_outs = flip_outs;
  return report;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEN_CUT_GRAPH_H
