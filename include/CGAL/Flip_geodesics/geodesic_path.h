// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_PATH_H
#define CGAL_FLIP_GEODESICS_GEODESIC_PATH_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <cstddef>
#include <iterator>
#include <vector>

#ifndef CGAL_FLIP_GEODESICS_DECLARATIONS_ONLY
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_paths.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#endif

namespace CGAL::Flip_geodesics {

#ifdef DOXYGEN_RUNNING
/// \ingroup PkgFlipGeodesicsFunctions
/// The type of the vertices of a mesh.
template <class TriangleMesh>
using Mesh_vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
#endif

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic, that is, a locally shortest path, between two vertices of a triangle mesh.
 *
 * A nearly shortest edge path (`Search_method::LOOK_BACK`) is straightened by `add_straightened_path()` and then
 * shortened to a geodesic by `shorten()`.
 *
 * This header includes `curves_through_points.h` and `geodesic_paths.h`, except in programs that link the compiled
 * library.
 *
 * \note The geodesic is not necessarily a globally shortest path, since a path on the other side of a hole or a bump
 * can be shorter. The path computed from `target` to `source` can be a different one. `shortest_path()` computes a
 * globally shortest path.
 *
 * If the two vertices coincide, the path has length zero, the status `Shortening_status::CONTRACTED` and the verdict
 * `Verdict::PROVEN`, and the output consists of its two end points. The end points of a degenerate edge coincide in
 * this sense.
 *
 * If a function that computes locally shortest curves on a mesh encounters a degenerate edge, all degenerate edges and
 * folded faces are contracted, and the curve is computed again; see \ref Flip_geodesicsDegenerate. The result is then a
 * geodesic of the contracted surface, `Curve_report::are_zero_edges_contracted` is `true`, and a visitor observes the
 * steps of both computations.
 *
 * Functions that compute locally shortest curves on a mesh write their output only when the result is complete, so
 * nothing is written if an exception is thrown.
 *
 * \param mesh a triangle mesh
 * \param source, target vertices in the same connected component
 * \param out an output iterator that receives the points of the path from `source` to `target`. The points are written
 *        in the first of the following forms that the output accepts: points in space, if the metric has points;
 *        `CGAL::Polygon_mesh_processing::Face_location`s; and `Curve_point`s, which contain both together with the
 *        crossed halfedges and the tangents. If the metric has no points, `Curve_place`s replace `Curve_point`s
 * \param np an optional sequence of named parameters, in any order, among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertices of the mesh as keys and points as values}
 *     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{metric}
 *     \cgalParamDescription{edge lengths that replace the distances between the points}
 *     \cgalParamType{a model of `IntrinsicMetric`}
 *     \cgalParamDefault{the metric of the points of the mesh}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{the arithmetic of the predicates}
 *     \cgalParamType{a model of `IntrinsicTriangulationTraits`, or the kernel of the points to select the default}
 *     \cgalParamDefault{`Certified_intrinsic_triangulation_traits` of the kernel of the metric, or
 *       `Intrinsic_triangulation_traits` if the metric is a user-defined one without `squared_length()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{stop_predicate}
 *     \cgalParamDescription{a predicate that can end the shortening early; the report then indicates this}
 *     \cgalParamType{a model of `FlipOutStopPredicate`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{`Never_stop_predicate`}
 *     \cgalParamExtra{With a stop predicate or a visitor, the initial straightening is omitted, so that the predicate
 *       or the visitor observes all steps, starting with the edge path.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor that is called for each step}
 *     \cgalParamType{a model of `FlipOutVisitor`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{The search for the edge path also calls `go_further()`, about once per thousand vertices. If this
 *       call returns `false`, nothing is written, and the report has the status
 *       `Shortening_status::STOPPED_BY_VISITOR`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the past-the-end output iterator, and a report with exactly one curve
 *
 * \throws Vertex_out_of_range_error if a vertex does not belong to `mesh`
 * \throws Disconnected_endpoints_error if no edge path connects `source` and `target`
 * \throws Degenerate_face_error if a face violates the triangle inequality; or if the contraction of degenerate edges
 *         leaves no face at one of these edges, or disconnects the ends of the path
 * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
 * \throws Invalid_mesh_error if a visited face is not a triangle, or a `Surface_mesh` contains removed vertices or
 *         edges
 *
 * Complexity: \cgalBigO{k \log k} for the \f$k\f$ vertices that the search visits, plus the time of `shorten()`. A mesh
 * other than a `Surface_mesh` is indexed first, in \cgalBigO{n \log n} time for \f$n\f$ faces.
 *
 * \sa `shortest_path()`
 * \sa `geodesic_paths()`
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

namespace internal {

// Defined in `curves_through_points.h`.
template <class TriangleMesh>
struct Path_between_points;

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic between two points. Each of them can be a vertex of the mesh, a
 * `CGAL::Polygon_mesh_processing::Face_location`, a `Surface_location`, a `Curve_place`, a `Curve_point`, or a point in
 * space. The named parameters and exceptions are those of `geodesic_path_through()`. Programs that link the compiled
 * library must also include `curves_through_points.h`.
 */
template <
    class TriangleMesh, class Source, class Target, class OutputIterator, class... NamedParameters,
    std::enable_if_t<
        !(internal::is_mesh_vertex<TriangleMesh, Source> && internal::is_mesh_vertex<TriangleMesh, Target>), int> = 0>
Geodesic_result<OutputIterator> geodesic_path(const TriangleMesh& mesh, const Source& source, const Target& target,
                                              OutputIterator out, const NamedParameters&... np)
{
  using Paths = internal::Path_between_points<TriangleMesh>;
  static_assert(internal::is_defined<Paths>,
                "for ends that are not vertices, include <CGAL/Flip_geodesics/curves_through_points.h> as well");
  if constexpr(internal::is_defined<Paths>)
    return Paths::compute(mesh, source, target, out,
                          internal::curve_options<internal::Point_distance_parameter>(np...));
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a closed geodesic by shortening a loop of edges.
 *
 * \param mesh a triangle mesh
 * \param vertices a range of vertices. Consecutive vertices must share an edge, and so must the last and the first
 *        vertex. The first vertex may be repeated at the end
 * \param out an output iterator that receives the points of the closed geodesic in the form described at
 *        `geodesic_path()`, with the first point repeated at the end. It receives nothing if the loop contracts
 * \param np named parameters, as for `geodesic_path()`
 * \return the past-the-end output iterator, and a report with exactly one curve
 *
 * \throws Vertex_out_of_range_error if a vertex does not belong to `mesh`
 * \throws Invalid_curve_error if there are fewer than two vertices, or if the vertices do not form a chain of edges
 * \throws Crossing_curves_error if the loop crosses itself at a vertex
 * \throws Ambiguous_order_error if the search for an order of overlapping segments exceeds its budget
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 *
 * Complexity: the time of `geodesic_path()` without that of the search.
 *
 * \sa `geodesic_network()`
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
 * Computes geodesics by shortening several curves together, so that they can touch but do not cross one another.
 *
 * \param mesh a triangle mesh
 * \param curves a range of ranges of vertices. Consecutive vertices of a curve must share an edge; a curve whose last
 *        vertex equals its first is a closed loop
 * \param out an output iterator that receives one `std::vector` of points for each curve, in the order of the curves.
 *        The form of the points is described at `geodesic_path()`
 * \param np named parameters, as for `geodesic_path()`
 * \return the past-the-end output iterator, and a report with one entry per curve
 *
 * \throws Vertex_out_of_range_error if a vertex does not belong to `mesh`
 * \throws Invalid_curve_error if a curve has fewer than two vertices, or if its vertices do not form a chain of edges
 * \throws Crossing_curves_error if curves cross at a vertex
 * \throws Ambiguous_order_error if the search for an order of overlapping segments exceeds its budget
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 *
 * Complexity: the time of `geodesic_path()` without that of the search, for all curves together.
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
      "pass curves as a range of ranges of vertices; for a single curve, pass a range that contains only this "
      "curve");
  std::vector<internal::Vertices_of<TriangleMesh>> copies;
  for(const auto& curve : curves)
    copies.push_back(internal::vertices_of_mesh(mesh, curve));
  return internal::write_computed<Geodesics_result<OutputIterator>>(
      internal::compute_network<Form>(mesh, copies, internal::curve_options(np...)), out);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_GEODESIC_PATH_H
