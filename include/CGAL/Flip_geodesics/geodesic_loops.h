// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Needless_seams.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* Adds what shortening one curve of a network did to the report of many. */
inline void append_report(const Shortening_report& report, Shortening_report& sum)
{
  sum.curves.insert(sum.curves.end(), report.curves.begin(), report.curves.end());
  sum.flips += report.flips;
  sum.flip_outs += report.flip_outs;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes closed geodesics around the handles and holes of a surface: pulls each loop of a `Loop_basis` tight, by
 * itself. Two of them may cross. There are none on a sphere and on a disk.
 *
 * \param mesh a triangle mesh
 * \param out receives one `std::vector` per loop, in the order of the basis, of what `geodesic_path()` writes
 * \param np as for `geodesic_path()`; the stop predicate is asked about each loop by itself. If a visitor's
 *        `go_further()` returns `false`, then the remaining loops are not shortened. If that happens before the basis
 *        is known, then nothing is written, and the report has one entry with `Shortening_status::STOPPED_BY_VISITOR`
 * \return the end of the output, and the report, with one entry per loop
 * \throws Invalid_mesh_error, Degenerate_face_error, Invalid_coordinate_error
 *
 * Complexity: \f$O(n \log n)\f$ and that of `shorten()` for each loop.
 */
template <class TriangleMesh, class OutputIterator, class... NamedParameters>
Geodesics_result<OutputIterator> geodesic_loop_basis(const TriangleMesh& mesh, OutputIterator out,
                                                     const NamedParameters&... np)
{
  const auto& options = internal::curve_options(np...);
  using Types = internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Form = internal::Curve_form<typename Types::Triangulation, OutputIterator, internal::Vector_of>;
  const auto compute = [&](typename Types::Triangulation& triangulation) {
    auto visitor = internal::make_visitor(options);
    internal::Stop_remembering_visitor<std::remove_reference_t<decltype(visitor.get())>> remembering(visitor.get());
    const Loop_basis<typename Types::Triangulation> basis(triangulation, std::vector<Vertex_index>(), remembering);
    internal::Computed_output<std::vector<Form>> result;
    if(!basis.is_complete())
      result.report = internal::report_of_stopped_search();
    for(Index i = 0; i < basis.number_of_loops(); ++i) {
      {
        typename Types::Network network(triangulation);
        const Curve_index curve = network.add_curve(basis.cycle(i), true);
        internal::append_report(internal::shorten(network, internal::stop_predicate_of(options), remembering),
                                result.report);
        result.values.push_back(internal::curve_forms<Form>(network, mesh, curve));
      }
      triangulation.rollback();
    }
    internal::note_contraction(triangulation, result.report);
    return result;
  };
  return internal::write_computed<Geodesics_result<OutputIterator>>(
      internal::compute_on_surface(internal::Mesh_surfaces(mesh, options), compute), out);
}

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
 * \param np named parameters: `visitor`, as for `shorten()`. If its `go_further()` returns `false`, then this ends
 *        without looking for needless chains once more: the network still cuts each component open, but into several
 *        disks perhaps
 * \return the report of the last run of `shorten()`, for the curves that are left, with flips and steps of all runs
 * \throws as `shorten()`
 *
 * Complexity: that of `shorten()`, and linear in the triangulation for each run.
 */
template <class Network, class... NamedParameters>
Shortening_report shorten_cut_graph(Network& network, const NamedParameters&... np)
{
  auto visitor = internal::make_visitor(internal::options_of<internal_np::visitor_t>(np...));
  internal::Stop_remembering_visitor<std::remove_reference_t<decltype(visitor.get())>> remembering(visitor.get());
  std::size_t flips = 0, flip_outs = 0;
  Shortening_report report;
  do {
    report = internal::shorten(network, Never_stop_predicate(), remembering);
    flips += report.flips;
    flip_outs += report.flip_outs;
  } while(!remembering.has_stopped() && internal::Needless_seams<Network>(network).remove());
  report.flips = flips;
  report.flip_outs = flip_outs;
  return report;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_LOOPS_H
