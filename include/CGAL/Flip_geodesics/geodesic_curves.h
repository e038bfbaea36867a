// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_CURVES_H
#define CGAL_FLIP_GEODESICS_GEODESIC_CURVES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// What a one-call function returns: where its output ends, and what became of the curves.
template <class OutputIterator>
struct Geodesic_result
{
  OutputIterator out;
  Shortening_report report;
};

namespace internal {

/* The types behind the named parameters of the one-call functions, resolved in one place. */
template <class TriangleMesh, class NamedParameters>
struct Curve_types
{
  using Point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Metric = Embedded_metric<TriangleMesh, Point_map>;
  using Traits =
      typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                   Intrinsic_triangulation_traits<typename Metric::Kernel>>::type;
  using Triangulation = Intrinsic_triangulation<TriangleMesh, Traits, Metric>;
  using Network = Edge_path_network<Triangulation>;
};

template <class TriangleMesh, class NamedParameters>
auto make_triangulation(const TriangleMesh& mesh, const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_const_property_map(CGAL::vertex_point, mesh));
  const auto traits =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits), typename Types::Traits());
  return typename Types::Triangulation(mesh, typename Types::Metric(points), traits);
}

/* Shortens with the visitor of the named parameters, if there is one. */
template <class Network, class NamedParameters, class StopPredicate>
Shortening_report shorten_with_visitor(Network& network, const NamedParameters& np, const StopPredicate& stop)
{
  Default_shortening_visitor none;
  auto&& visitor = parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor), none);
  return shorten(network, stop, visitor);
}

/* Shortens a path of which only the ends are given, in an empty network: from a straightened start, unless the visitor
 * or the stop predicate is to see all of it. */
template <class Network, class NamedParameters, class StopPredicate>
Shortening_report shorten_between_ends(Network& network, const std::vector<Index>& path, const NamedParameters& np,
                                       const StopPredicate& stop)
{
  constexpr bool has_visitor = !parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value;
  std::size_t flips = 0;
  if constexpr(!has_visitor && std::is_same<StopPredicate, Never_stop_predicate>::value)
    flips = add_straightened_path(network, path);
  else
    network.add_curve(path, false);
  Shortening_report report = shorten_with_visitor(network, np, stop);
  report.flips += flips;
  report.curves.front().flips += flips;
  return report;
}

/* Adds a curve through vertices of the mesh; a curve whose last vertex is its first is closed. */
template <class Network, class VertexRange>
void add_vertex_curve(Network& network, const VertexRange& vertices)
{
  std::vector<Index> indices;
  for(const auto& v : vertices)
    indices.push_back(network.triangulation().index(v));
  const bool is_closed = indices.size() > 2 && indices.front() == indices.back();
  if(is_closed)
    indices.pop_back();
  network.add_curve(halfedges_through(network.triangulation(), indices, is_closed), is_closed);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic, a locally shortest path on the surface, from one vertex to another: an edge path that is nearly
 * shortest (`Search_method::LOOK_BACK`), straightened (`add_straightened_path()`) and pulled tight. A
 * path that takes another way round a hole or a bump may be shorter still.
 *
 * \param mesh a triangle mesh
 * \param source, target different vertices of one component
 * \param out receives the points of the path, from `source` to `target`, as the mesh's points
 * \param np named parameters: `vertex_point_map`, `geom_traits` (a model of `IntrinsicTriangulationTraits`), `visitor`;
 *        the mesh must have a vertex point property of its own even if the first is given
 * \param stop a model of `FlipOutStopPredicate`, which ends the process early; the report tells. With one, or with a
 *        visitor, the edge path itself is pulled tight, so that they see every step
 * \return the end of the output, and the report, which has one curve
 * \throws Vertex_out_of_range_error, Disconnected_endpoints_error, Invalid_curve_error if `source == target`,
 *         Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: that of the search, \f$O(k \log k)\f$ for the \f$k\f$ vertices it visits, and of `shorten()`; meshes
 * other than `Surface_mesh` are indexed first, \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class OutputIterator, class NamedParameters = parameters::Default_named_parameters,
          class StopPredicate = Never_stop_predicate>
Geodesic_result<OutputIterator> geodesic_path(const TriangleMesh& mesh,
                                              typename boost::graph_traits<TriangleMesh>::vertex_descriptor source,
                                              typename boost::graph_traits<TriangleMesh>::vertex_descriptor target,
                                              OutputIterator out,
                                              const NamedParameters& np = parameters::default_values(),
                                              const StopPredicate& stop = StopPredicate())
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  auto triangulation = internal::make_triangulation(mesh, np);
  Shortest_edge_path<typename Types::Triangulation> search(triangulation, Search_method::LOOK_BACK);
  typename Types::Network network(triangulation);
  const std::vector<Index> ends = {triangulation.index(source), triangulation.index(target)};
  const Shortening_report report =
      internal::shorten_between_ends(network, shortest_halfedges_through(search, ends), np, stop);
  out = Curve_extractor<typename Types::Network>(network).points(0, out);
  return {out, report};
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Pulls a closed loop of edges tight.
 *
 * \param mesh a triangle mesh
 * \param vertices a range of vertices of which each two in a row, and the last and the first, share an edge
 * \param out receives the points of the closed geodesic, the first again at the end; nothing if the loop contracts
 * \param np, stop as for `geodesic_path()`
 * \return the end of the output, and the report, which has one curve
 * \throws Vertex_out_of_range_error, Invalid_curve_error, Crossing_curves_error, Ambiguous_order_error,
 *         Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: as `geodesic_path()`, without a search.
 */
template <class TriangleMesh, class VertexRange, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters, class StopPredicate = Never_stop_predicate>
Geodesic_result<OutputIterator> geodesic_loop(const TriangleMesh& mesh, const VertexRange& vertices, OutputIterator out,
                                              const NamedParameters& np = parameters::default_values(),
                                              const StopPredicate& stop = StopPredicate())
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  auto triangulation = internal::make_triangulation(mesh, np);
  typename Types::Network network(triangulation);
  std::vector<Index> loop;
  for(const auto& v : vertices)
    loop.push_back(triangulation.index(v));
  network.add_curve(halfedges_through(triangulation, loop, true), true);
  order_overlapping_curves(network);
  const Shortening_report report = internal::shorten_with_visitor(network, np, stop);
  out = Curve_extractor<typename Types::Network>(network).points(0, out);
  return {out, report};
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Pulls several curves tight at once, so that they come to lie side by side and never across one another.
 *
 * \param mesh a triangle mesh
 * \param curves a range of ranges of vertices, each two in a row sharing an edge; a curve whose last vertex is its
 *        first is a closed loop
 * \param out receives one `std::vector` of points per curve, in order
 * \param np, stop as for `geodesic_path()`
 * \return the end of the output, and the report, with one entry per curve
 * \throws as `geodesic_loop()`
 *
 * Complexity: as `geodesic_loop()`, with the flips of all curves.
 */
template <class TriangleMesh, class CurveRange, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters, class StopPredicate = Never_stop_predicate>
Geodesic_result<OutputIterator> straighten(const TriangleMesh& mesh, const CurveRange& curves, OutputIterator out,
                                           const NamedParameters& np = parameters::default_values(),
                                           const StopPredicate& stop = StopPredicate())
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  auto triangulation = internal::make_triangulation(mesh, np);
  typename Types::Network network(triangulation);
  for(const auto& curve : curves)
    internal::add_vertex_curve(network, curve);
  order_overlapping_curves(network);
  const Shortening_report report = internal::shorten_with_visitor(network, np, stop);
  Curve_extractor<typename Types::Network> extractor(network);
  for(Index c = 0; c < network.number_of_curves(); ++c) {
    std::vector<typename Types::Metric::Point_3> points;
    extractor.points(c, std::back_inserter(points));
    *out++ = points;
  }
  return {out, report};
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_CURVES_H
