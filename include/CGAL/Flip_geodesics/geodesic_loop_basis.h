// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_LOOP_BASIS_H
#define CGAL_FLIP_GEODESICS_GEODESIC_LOOP_BASIS_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Interrupting_visitor.h>
#include <CGAL/Flip_geodesics/internal/flip_out/compute_on_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/surface/make_visitor.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

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
        internal::append_report(shorten(network, internal::stop_predicate_of(options), remembering), result.report);
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_LOOP_BASIS_H
