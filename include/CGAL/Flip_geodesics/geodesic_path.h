// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_PATH_H
#define CGAL_FLIP_GEODESICS_GEODESIC_PATH_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/internal/flip_out/compiled.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#ifndef CGAL_FLIP_GEODESICS_DECLARATIONS_ONLY
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#endif

namespace CGAL {
namespace Flip_geodesics {

#ifdef DOXYGEN_RUNNING
/// \ingroup PkgFlipGeodesicsFunctions
/// A vertex of a mesh.
template <class TriangleMesh>
using Mesh_vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
#else
template <class TriangleMesh>
using Mesh_vertex = internal::Vertex_in<TriangleMesh>;
#endif

/// \ingroup PkgFlipGeodesicsFunctions
/// What a function for one curve returns.
template <class OutputIterator>
struct Geodesic_result
{
  OutputIterator out;       ///< the end of the output
  Shortening_report report; ///< what became of the curve

  double length() const { return report.curves.front().length; }            ///< the length of the curve
  Shortening_status status() const { return report.curves.front().status; } ///< whether the curve is a geodesic
  Verdict verdict() const { return report.curves.front().verdict; }         ///< whether it is proven to be one
};

/// \ingroup PkgFlipGeodesicsFunctions
/// What a function for several curves returns.
template <class OutputIterator>
struct Geodesics_result
{
  OutputIterator out;       ///< the end of the output
  Shortening_report report; ///< what became of the curves, one entry for each

  std::size_t number_of_curves() const { return report.curves.size(); }                ///< how many there are
  double length(std::size_t i) const { return report.curves.at(i).length; }            ///< of a curve
  Shortening_status status(std::size_t i) const { return report.curves.at(i).status; } ///< is it a geodesic?
  Verdict verdict(std::size_t i) const { return report.curves.at(i).verdict; }         ///< is it proven to be one?
};

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic, a locally shortest path on the surface, from one vertex to another: an edge path that is nearly
 * shortest (`Search_method::LOOK_BACK`), straightened (`add_straightened_path()`) and pulled tight. A
 * path that takes another way round a hole or a bump may be shorter still. With `curves_through_points.h` the ends can
 * lie anywhere.
 *
 * A path between ends in one place is that point. It has length zero, `Shortening_status::CONTRACTED` and
 * `Verdict::PROVEN`, and is written as its two ends.
 *
 * If it meets an edge of length zero, such edges are contracted, and the path is computed again: it is a geodesic of
 * the surface that is left, and `Curve_report::are_zero_edges_contracted` says so. The ends of such an edge are in one
 * place. All this holds for all functions that take a mesh and give curves. Whichever
 * attempt succeeds, its result is written once, when it is complete: if an exception is thrown, nothing is written. A
 * visitor observes the steps of both attempts.
 *
 * \param mesh a triangle mesh
 * \param source, target vertices of one component
 * \param out receives the points of the path, from `source` to `target`: in space, as the metric's points, if it has
 *        any, as lengths have none; if the output does not take those, as
 *        `CGAL::Polygon_mesh_processing::Face_location`s; if it takes neither, as `Curve_point`s, which have both, the
 *        crossed halfedges and the tangents, or `Curve_place`s without points
 * \param np named parameters, in any order: `stop_predicate`, a model of `FlipOutStopPredicate`, which ends the process
 *        early; the report tells. With one, or with a visitor, the edge path itself is pulled tight, so that they see
 *        every step; `vertex_point_map`, a model of `ReadablePropertyMap` with the mesh's vertices as keys and
 *        points as values, by default `get(CGAL::vertex_point, mesh)`; or `metric`, a model of `IntrinsicMetric`,
 *        by default that of the points; `geom_traits`, a model of `IntrinsicTriangulationTraits`, or the kernel of the
 *        points for the default: `Certified_intrinsic_triangulation_traits` of the metric's kernel, whatever kernel that
 *        is, or, for a metric of one's own without `exact_face()`, `Intrinsic_triangulation_traits`; `visitor`, a model
 *        of `FlipOutVisitor`, which is copied unless it is given by `std::ref()`, by default none. The search for the edge
 *        path calls `go_further()` as well, once for about a thousand vertices. If it returns `false` there, then nothing is
 *        written, and the report has the status `Shortening_status::STOPPED_BY_VISITOR`
 * \return the end of the output, and the report, which has one curve
 * \throws Vertex_out_of_range_error, Disconnected_endpoints_error, Degenerate_face_error, Invalid_coordinate_error,
 *         Invalid_mesh_error
 *
 * Complexity: that of the search, \f$O(k \log k)\f$ for the \f$k\f$ vertices it visits, and of `shorten()`; meshes
 * other than `Surface_mesh` are indexed first, \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class OutputIterator, class... NamedParameters>
Geodesic_result<OutputIterator> geodesic_path(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                              Mesh_vertex<TriangleMesh> target, OutputIterator out,
                                              const NamedParameters&... np)
{
  internal::compiled::check_instance<TriangleMesh, internal::Joined<NamedParameters...>>();
  using Form = internal::Form_by_name<TriangleMesh, internal::Joined<NamedParameters...>, OutputIterator>;
  return internal::write_computed<Geodesic_result<OutputIterator>>(
      internal::compute_path<Form>(mesh, source, target, internal::curve_options(np...)), out);
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Pulls a closed loop of edges tight.
 *
 * \param mesh a triangle mesh
 * \param vertices a range of vertices of which each two in a row, and the last and the first, share an edge; the first
 *        may stand at the end once more
 * \param out receives the points of the closed geodesic, as `geodesic_path()` writes them, the first again at the end;
 *        nothing if the loop contracts
 * \param np as for `geodesic_path()`
 * \return the end of the output, and the report, which has one curve
 * \throws Vertex_out_of_range_error, Invalid_curve_error, Crossing_curves_error, Ambiguous_order_error,
 *         Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: as `geodesic_path()`, without a search.
 */
template <class TriangleMesh, class VertexRange, class OutputIterator, class... NamedParameters>
Geodesic_result<OutputIterator> geodesic_loop(const TriangleMesh& mesh, const VertexRange& vertices, OutputIterator out,
                                              const NamedParameters&... np)
{
  internal::compiled::check_instance<TriangleMesh, internal::Joined<NamedParameters...>>();
  using Form = internal::Form_by_name<TriangleMesh, internal::Joined<NamedParameters...>, OutputIterator>;
  return internal::write_computed<Geodesic_result<OutputIterator>>(
      internal::compute_loop<Form>(mesh, internal::vertices_of_mesh(mesh, vertices), internal::curve_options(np...)),
      out);
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Pulls several curves tight at once, so that they come to lie side by side and never across one another.
 *
 * \param mesh a triangle mesh
 * \param curves a range of ranges of vertices, each two in a row sharing an edge; a curve whose last vertex is its
 *        first is a closed loop
 * \param out receives one `std::vector` per curve, in order, of what `geodesic_path()` writes
 * \param np as for `geodesic_path()`
 * \return the end of the output, and the report, with one entry per curve
 * \throws as `geodesic_loop()`
 *
 * Complexity: as `geodesic_loop()`, with the flips of all curves.
 */
template <class TriangleMesh, class CurveRange, class OutputIterator, class... NamedParameters>
Geodesics_result<OutputIterator> geodesic_network(const TriangleMesh& mesh, const CurveRange& curves,
                                                  OutputIterator out, const NamedParameters&... np)
{
  internal::compiled::check_instance<TriangleMesh, internal::Joined<NamedParameters...>>();
  using Form =
      internal::Form_by_name<TriangleMesh, internal::Joined<NamedParameters...>, OutputIterator, internal::Vector_of>;
  static_assert(
      internal::is_range_of_ranges<CurveRange>,
      "several curves are a range of ranges of vertices; geodesic_loop() or geodesic_path_through() takes one");
  std::vector<internal::Vertices_of<TriangleMesh>> copies;
  for(const auto& curve : curves)
    copies.push_back(internal::vertices_of_mesh(mesh, curve));
  return internal::write_computed<Geodesics_result<OutputIterator>>(
      internal::compute_network<Form>(mesh, copies, internal::curve_options(np...)), out);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_PATH_H
