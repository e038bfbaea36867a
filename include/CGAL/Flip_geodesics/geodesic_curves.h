// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_CURVES_H
#define CGAL_FLIP_GEODESICS_GEODESIC_CURVES_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/contracted_surface.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/base/mistakes.h>
#include <CGAL/Flip_geodesics/internal/input/check_vertex.h>
#include <CGAL/Flip_geodesics/internal/one_call/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/one_call/compiled.h>
#include <CGAL/Flip_geodesics/internal/shortening/Interrupting_visitor.h>
#include <CGAL/Flip_geodesics/internal/shortening/make_visitor.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// A vertex of a mesh, `boost::graph_traits<TriangleMesh>::vertex_descriptor`.
template <class TriangleMesh>
using Mesh_vertex = typename internal::Vertex_of<TriangleMesh>::type;

/// \ingroup PkgFlipGeodesicsFunctions
/// What a function for one curve returns.
template <class OutputIterator>
struct Geodesic_result
{
  OutputIterator out;       ///< the end of the output
  Shortening_report report; ///< what became of the curve

  double length() const { return report.curves.front().length; }                ///< the length of the curve
  Shortening_status status() const { return report.curves.front().status; }     ///< whether the curve is a geodesic
  Certificate_verdict verdict() const { return report.curves.front().verdict; } ///< whether it is proven to be one
};

/// \ingroup PkgFlipGeodesicsFunctions
/// What a function for several curves returns.
template <class OutputIterator>
struct Geodesics_result
{
  OutputIterator out;       ///< the end of the output
  Shortening_report report; ///< what became of the curves, one entry for each
};

namespace internal {

/* Returns the error for a pair of ends that become disconnected when degenerate edges are contracted, by the error that
 * was thrown before. */
inline Degenerate_face_error contracted_in_vain(const Degenerate_face_error& error)
{
  if(error.remedy() != Degeneracy_remedy::CONTRACT)
    return error;
  return {error.problem() + "; once such edges are contracted, no surface joins the ends of the curve, since faces "
                            "without area are gone",
          error.elements(), Degeneracy_remedy::MOLLIFY};
}

/*
 * Calls `compute(triangulation)` over a mesh; and if that meets an edge of length zero, again over the surface that is
 * left when such edges are contracted. Where that does not help either, what was wrong first is thrown.
 */
template <class TriangleMesh, class NamedParameters, class Compute>
auto compute_on_surface(const TriangleMesh& mesh, const NamedParameters& np, const Compute& compute)
{
  try {
    auto triangulation = make_triangulation(mesh, np);
    return compute(triangulation);
  } catch(const Degenerate_face_error& error) {
    auto triangulation = make_triangulation(mesh, np, Zero_length_edges::CONTRACT);
    if(!triangulation.input().is_contracted())
      throw;
    try {
      return compute(triangulation);
    } catch(const Disconnected_endpoints_error&) { // only by faces without area, or in a point
      throw contracted_in_vain(error);
    }
  }
}

/* The values that a computation gives for an output iterator, and its report. */
template <class Value, class Report = Shortening_report>
struct Computed_output
{
  std::vector<Value> values;
  Report report;
};

/* Writes what was computed, which is final: an attempt that was repeated on the contracted surface leaves nothing in the
 * output. Returns a `Result`, the end of the output and the report. */
template <class Result, class Computed, class OutputIterator>
Result write_computed(Computed&& computed, OutputIterator out)
{
  return Result{std::move(computed.values.begin(), computed.values.end(), out), std::move(computed.report)};
}

/* Shortens with the visitor of the named parameters, if there is one. */
template <class Network, class NamedParameters, class StopPredicate>
Shortening_report shorten_with_visitor(Network& network, const NamedParameters& np, const StopPredicate& stop)
{
  static_assert(is_stop_predicate<StopPredicate>,
                "this is neither a stop predicate, a model of FlipOutStopPredicate, nor named parameters");
  auto visitor = make_visitor(np);
  return shorten(network, stop, visitor.get());
}

/* Shortens a path of which only the ends are given, in an empty network: from a straightened start, unless the visitor
 * or the stop predicate is to see all of it. */
template <class Network, class StopPredicate, class Visitor>
Shortening_report shorten_from_start(Network& network, const std::vector<Halfedge_index>& path,
                                     const StopPredicate& stop, Visitor& visitor)
{
  std::size_t flips = 0;
  if constexpr(!observes_steps<Visitor> && std::is_same<StopPredicate, Never_stop_predicate>::value)
    flips = add_straightened_path(network, path);
  else
    network.add_curve(path, false);
  Shortening_report report = shorten(network, stop, visitor);
  report.flips += flips;
  report.curves.front().flips += flips;
  return report;
}

/* Searches the edge path from which a geodesic is to start; there is none if the visitor stops the search. */
template <class Search, class Visitor>
std::vector<Halfedge_index> edge_path_between(Search& search, const std::vector<Vertex_index>& ends, Visitor& visitor)
{
  if constexpr(std::is_same<Visitor, Default_shortening_visitor>::value)
    return shortest_halfedges_through(search, ends);
  else
    return shortest_halfedges_through(search, ends, false, visitor);
}

/* The report of a path that a visitor stopped before there was one. */
inline Shortening_report report_of_stopped_search()
{
  Shortening_report report;
  report.curves.emplace_back();
  report.curves.back().status = Shortening_status::STOPPED_BY_VISITOR;
  return report;
}

/* Returns the points of a curve of a network in the form that the output takes; none of a loop that is a point. */
template <class Form, class Network, class TriangleMesh>
std::vector<Form> curve_forms(const Network& network, const TriangleMesh& mesh, Curve_index curve)
{
  using Triangulation = typename Network::Triangulation;
  std::vector<Form> result;
  if(network.is_closed(curve) && network.length(curve) == 0)
    return result;
  Curve_extractor<Network> extractor(network);
  if constexpr(std::is_same<Form, typename Curve_forms<Triangulation>::All>::value) {
    extractor.curve_points(curve, mesh, std::back_inserter(result));
  } else {
    const Form_converter<Triangulation, Form> convert(network.triangulation(), mesh);
    for(const Surface_point& p : extractor.surface_points(curve))
      result.push_back(convert(p));
  }
  return result;
}

/* A path of length zero, between vertices in one place: its two ends. */
template <class Form, class Triangulation, class TriangleMesh>
Computed_output<Form> path_in_one_place(const Triangulation& triangulation, const TriangleMesh& mesh, Vertex_index v)
{
  check_vertex(v, triangulation.input().number_of_vertices());
  if(triangulation.input().outgoing(v) == null_index) {
    if(triangulation.input().is_contracted())
      throw_no_surface_left(v);
    throw Vertex_out_of_range_error("vertex " + std::to_string(v.idx()) + " is in no face of the mesh",
                                    {static_cast<std::size_t>(v.idx())});
  }
  Computed_output<Form> result;
  result.report.curves.push_back(report_of_point(triangulation));
  note_contraction(triangulation, result.report);
  const Form_converter<Triangulation, Form> convert(triangulation, mesh);
  result.values.assign(2, convert(surface_point_at_vertex(triangulation, v)));
  return result;
}

/* Computes a geodesic between two vertices of a mesh, in an empty network. */
template <class Form, class Network, class Search, class TriangleMesh, class Vertex, class NamedParameters,
          class StopPredicate>
Computed_output<Form> geodesic_between(Network& network, Search& search, const TriangleMesh& mesh, Vertex source,
                                       Vertex target, const NamedParameters& np, const StopPredicate& stop)
{
  static_assert(is_stop_predicate<StopPredicate>,
                "this is neither a stop predicate, a model of FlipOutStopPredicate, nor named parameters");
  const auto& triangulation = network.triangulation();
  const std::vector<Vertex_index> ends = {triangulation.index(source), triangulation.index(target)};
  if(ends[0] == ends[1])
    return path_in_one_place<Form>(triangulation, mesh, ends[0]);
  auto visitor = make_visitor(np);
  const std::vector<Halfedge_index> path = edge_path_between(search, ends, visitor.get());
  if(path.empty())
    return {{}, report_of_stopped_search()};
  Shortening_report report = shorten_from_start(network, path, stop, visitor.get());
  note_contraction(triangulation, report);
  return {curve_forms<Form>(network, mesh, Curve_index(0)), std::move(report)};
}

/* A copy of a range of vertices of the mesh. */
template <class TriangleMesh>
using Vertices_of = std::vector<Mesh_vertex<TriangleMesh>>;

template <class TriangleMesh, class VertexRange>
Vertices_of<TriangleMesh> vertices_of_mesh(const TriangleMesh&, const VertexRange& vertices)
{
  static_assert(is_range_of<VertexRange, Mesh_vertex<TriangleMesh>>, "the curve is no range of vertices of the mesh");
  Vertices_of<TriangleMesh> result;
  for(const auto& v : vertices)
    result.push_back(v);
  return result;
}

/* The indices of vertices of the mesh, before edges are contracted. */
template <class Triangulation, class Vertex>
std::vector<Vertex_index> mesh_indices(const Triangulation& triangulation, const std::vector<Vertex>& vertices)
{
  std::vector<Vertex_index> result;
  for(const Vertex& v : vertices)
    result.push_back(triangulation.input().uncontracted().index(v));
  return result;
}

/* Adds a curve through vertices of the mesh. Returns whether there is one, or all vertices lie in one place. */
template <class Network>
bool add_vertex_curve(Network& network, const std::vector<Vertex_index>& vertices, bool is_closed)
{
  const std::vector<Halfedge_index> halfedges = halfedges_on_surface(network.triangulation(), vertices, is_closed);
  if(halfedges.empty())
    return false;
  network.add_curve(halfedges, is_closed);
  return true;
}

/* The same for many curves, of which those whose last vertex is their first are closed. */
template <class Network, class Vertex>
std::vector<bool> add_vertex_curves(Network& network, const std::vector<std::vector<Vertex>>& curves)
{
  std::vector<bool> result;
  for(const std::vector<Vertex>& curve : curves) {
    std::vector<Vertex_index> vertices = mesh_indices(network.triangulation(), curve);
    const bool is_closed = vertices.size() > 2 && vertices.front() == vertices.back();
    if(is_closed)
      vertices.pop_back();
    result.push_back(add_vertex_curve(network, vertices, is_closed));
  }
  return result;
}

/*
 * The computations of the functions below, which then write the output. They are not inline, and depend on the form of
 * the output alone, so that the compiled library can have instances of them; see `internal/one_call/compiled.h`.
 */

/* Of `geodesic_path()`. */
template <class Form, class TriangleMesh, class StopPredicate, class NamedParameters>
Computed_output<Form> compute_path(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                   Mesh_vertex<TriangleMesh> target, const StopPredicate& stop,
                                   const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return compute_on_surface(mesh, np, [&](typename Types::Triangulation& triangulation) {
    Shortest_edge_path<typename Types::Triangulation> search(triangulation, Search_method::LOOK_BACK);
    typename Types::Network network(triangulation);
    return geodesic_between<Form>(network, search, mesh, source, target, np, stop);
  });
}

/* Of `geodesic_loop()`. */
template <class Form, class TriangleMesh, class StopPredicate, class NamedParameters>
Computed_output<Form> compute_loop(const TriangleMesh& mesh, const Vertices_of<TriangleMesh>& vertices,
                                   const StopPredicate& stop, const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return compute_on_surface(mesh, np, [&](typename Types::Triangulation& triangulation) {
    typename Types::Network network(triangulation);
    std::vector<Vertex_index> loop = mesh_indices(triangulation, vertices);
    if(loop.size() > 1 && loop.front() == loop.back())
      loop.pop_back();
    Computed_output<Form> result;
    if(add_vertex_curve(network, loop, true)) {
      order_overlapping_curves(network);
      result.report = shorten_with_visitor(network, np, stop);
      result.values = curve_forms<Form>(network, mesh, Curve_index(0));
    } else {
      result.report.curves.push_back(report_of_point(triangulation));
    }
    note_contraction(triangulation, result.report);
    return result;
  });
}

/* Of `straighten()`. */
template <class Form, class TriangleMesh, class StopPredicate, class NamedParameters>
Computed_output<std::vector<Form>> compute_network(const TriangleMesh& mesh,
                                                   const std::vector<Vertices_of<TriangleMesh>>& curves,
                                                   const StopPredicate& stop, const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return compute_on_surface(mesh, np, [&](typename Types::Triangulation& triangulation) {
    typename Types::Network network(triangulation);
    const std::vector<bool> has_length = add_vertex_curves(network, curves);
    order_overlapping_curves(network);
    Computed_output<std::vector<Form>> result;
    result.report = shorten_with_visitor(network, np, stop);
    auto& reports = result.report.curves;
    for(std::size_t i = 0, c = 0; i < has_length.size(); ++i) {
      result.values.emplace_back();
      if(has_length[i])
        result.values.back() = curve_forms<Form>(network, mesh, Curve_index(static_cast<Index>(c++)));
      else
        reports.insert(reports.begin() + static_cast<std::ptrdiff_t>(i), report_of_point(triangulation));
    }
    note_contraction(triangulation, result.report);
    return result;
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic, a locally shortest path on the surface, from one vertex to another: an edge path that is nearly
 * shortest (`Search_method::LOOK_BACK`), straightened (`add_straightened_path()`) and pulled tight. A
 * path that takes another way round a hole or a bump may be shorter still. With `curves_through_points.h` the ends can
 * lie anywhere.
 *
 * A path between ends in one place is that point. It has length zero, `Shortening_status::CONTRACTED` and
 * `Certificate_verdict::PROVEN`, and is written as its two ends.
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
 * \param stop a model of `FlipOutStopPredicate`, which ends the process early; the report tells. With one, or with a
 *        visitor, the edge path itself is pulled tight, so that they see every step
 * \param np named parameters: `vertex_point_map`, a model of `ReadablePropertyMap` with the mesh's vertices as keys and
 *        points as values, by default `get(CGAL::vertex_point, mesh)`; or `with_metric()`, a model of `IntrinsicMetric`,
 *        by default that of the points; `geom_traits`, a model of `IntrinsicTriangulationTraits`, by default
 *        `Certified_intrinsic_triangulation_traits` of the metric's kernel, whatever kernel that is, or, for a metric of
 *        one's own without `exact_face()`, `Intrinsic_triangulation_traits`; `visitor`, a model of `FlipOutVisitor`,
 *        which is copied unless it is given by `std::ref()`, by default none. The search for the edge path calls
 *        `go_further()` as well, once for about a thousand vertices. If it returns `false` there, then nothing is
 *        written, and the report has the status `Shortening_status::STOPPED_BY_VISITOR`
 * \return the end of the output, and the report, which has one curve
 * \throws Vertex_out_of_range_error, Disconnected_endpoints_error, Degenerate_face_error, Invalid_coordinate_error,
 *         Invalid_mesh_error
 *
 * Complexity: that of the search, \f$O(k \log k)\f$ for the \f$k\f$ vertices it visits, and of `shorten()`; meshes
 * other than `Surface_mesh` are indexed first, \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class OutputIterator, class StopPredicate, class NamedParameters>
Geodesic_result<OutputIterator> geodesic_path(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                              Mesh_vertex<TriangleMesh> target, OutputIterator out,
                                              const StopPredicate& stop, const NamedParameters& np)
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  using Form = internal::Curve_form<typename Types::Triangulation, OutputIterator>;
  return internal::write_computed<Geodesic_result<OutputIterator>>(
      internal::compute_path<Form>(mesh, source, target, stop, np), out);
}

/// \ingroup PkgFlipGeodesicsFunctions
/// The same with either a stop predicate or named parameters, or neither.
template <class TriangleMesh, class OutputIterator, class Options = parameters::Default_named_parameters>
Geodesic_result<OutputIterator> geodesic_path(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                              Mesh_vertex<TriangleMesh> target, OutputIterator out,
                                              const Options& options = parameters::default_values())
{
  return internal::with_options(options, [&](const auto& stop, const auto& np) {
    return Flip_geodesics::geodesic_path(mesh, source, target, out, stop, np);
  });
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
 * \param stop, np as for `geodesic_path()`
 * \return the end of the output, and the report, which has one curve
 * \throws Vertex_out_of_range_error, Invalid_curve_error, Crossing_curves_error, Ambiguous_order_error,
 *         Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: as `geodesic_path()`, without a search.
 */
template <class TriangleMesh, class VertexRange, class OutputIterator, class StopPredicate, class NamedParameters>
Geodesic_result<OutputIterator> geodesic_loop(const TriangleMesh& mesh, const VertexRange& vertices, OutputIterator out,
                                              const StopPredicate& stop, const NamedParameters& np)
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  using Form = internal::Curve_form<typename Types::Triangulation, OutputIterator>;
  return internal::write_computed<Geodesic_result<OutputIterator>>(
      internal::compute_loop<Form>(mesh, internal::vertices_of_mesh(mesh, vertices), stop, np), out);
}

/// \ingroup PkgFlipGeodesicsFunctions
/// The same with either a stop predicate or named parameters, or neither.
template <class TriangleMesh, class VertexRange, class OutputIterator,
          class Options = parameters::Default_named_parameters>
Geodesic_result<OutputIterator> geodesic_loop(const TriangleMesh& mesh, const VertexRange& vertices, OutputIterator out,
                                              const Options& options = parameters::default_values())
{
  return internal::with_options(options, [&](const auto& stop, const auto& np) {
    return Flip_geodesics::geodesic_loop(mesh, vertices, out, stop, np);
  });
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
 * \param stop, np as for `geodesic_path()`
 * \return the end of the output, and the report, with one entry per curve
 * \throws as `geodesic_loop()`
 *
 * Complexity: as `geodesic_loop()`, with the flips of all curves.
 */
template <class TriangleMesh, class CurveRange, class OutputIterator, class StopPredicate, class NamedParameters>
Geodesics_result<OutputIterator> straighten(const TriangleMesh& mesh, const CurveRange& curves, OutputIterator out,
                                            const StopPredicate& stop, const NamedParameters& np)
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  using Form = internal::Curve_form<typename Types::Triangulation, OutputIterator, internal::Vector_of>;
  static_assert(
      internal::is_range_of_ranges<CurveRange>,
      "several curves are a range of ranges of vertices; geodesic_loop() or geodesic_path_through() takes one");
  std::vector<internal::Vertices_of<TriangleMesh>> copies;
  for(const auto& curve : curves)
    copies.push_back(internal::vertices_of_mesh(mesh, curve));
  return internal::write_computed<Geodesics_result<OutputIterator>>(
      internal::compute_network<Form>(mesh, copies, stop, np), out);
}

/// \ingroup PkgFlipGeodesicsFunctions
/// The same with either a stop predicate or named parameters, or neither.
template <class TriangleMesh, class CurveRange, class OutputIterator,
          class Options = parameters::Default_named_parameters>
Geodesics_result<OutputIterator> straighten(const TriangleMesh& mesh, const CurveRange& curves, OutputIterator out,
                                            const Options& options = parameters::default_values())
{
  return internal::with_options(options, [&](const auto& stop, const auto& np) {
    return Flip_geodesics::straighten(mesh, curves, out, stop, np);
  });
}

#ifdef CGAL_FLIP_GEODESICS_COMPILED
namespace internal {

#define CGAL_FLIP_GEODESICS_INSTANCES(Mesh, Form)                                                                      \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<Form> compute_path(                                              \
      const Mesh&, Mesh_vertex<Mesh>, Mesh_vertex<Mesh>, const Never_stop_predicate&,                                  \
      const parameters::Default_named_parameters&);                                                                    \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<Form> compute_loop(const Mesh&, const Vertices_of<Mesh>&,        \
                                                                         const Never_stop_predicate&,                  \
                                                                         const parameters::Default_named_parameters&); \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<std::vector<Form>> compute_network(                              \
      const Mesh&, const std::vector<Vertices_of<Mesh>>&, const Never_stop_predicate&,                                 \
      const parameters::Default_named_parameters&);
CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(CGAL_FLIP_GEODESICS_INSTANCES)
#undef CGAL_FLIP_GEODESICS_INSTANCES

} // namespace internal
#endif

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_CURVES_H
