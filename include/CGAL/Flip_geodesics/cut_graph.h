// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CUT_GRAPH_H
#define CGAL_FLIP_GEODESICS_CUT_GRAPH_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/topology/Cut_edges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

namespace internal {

/* \throws Interrupted, and leaves the network in its current state */
template <class Network, class VertexRange>
Index add_cut_graph(Network& network, const VertexRange& base_points, Interruption* interruption)
{
  static_assert(is_range_of<VertexRange, Vertex_index>,
                "the base points must be a range of vertices of the triangulation (Vertex_index)");
  const auto& triangulation = network.triangulation();
  const Cut_edges<typename Network::Triangulation> cut(triangulation, base_points, interruption);
  const auto degree = degrees(triangulation, cut.marks());
  // A curve that touches a border is split there: if it slid off the border, the cut surface would remain in one piece
  // with a hole.
  return add_chains(network, cut.marks(), [&](Vertex_index v) { return degree[v] != 2 || cut.is_on_border(v); });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Fills an empty network with curves along which each component of a surface can be cut open into a topological disk.
 * The ends of the curves are fixed, so the network can be shortened by `shorten_cut_graph()`. The shortened network can
 * be passed to `cut_along_curves()` or `Conformal_flattening`.
 *
 * In a closed component, the network consists of the edges of the shortest loops that generate the fundamental group
 * \cgalCite{EW05}, as in `Loop_basis`; dead ends are removed. The network is therefore short, but in general not the
 * shortest cut graph, whose computation is NP-hard \cgalCite{EH04}. In a component with borders, curves can also end at
 * the border. Paths along the border count as having length zero, since the surface need not be cut along the border. A
 * disk receives no curve. A sphere receives one curve, from the base point to the vertex that is farthest from this
 * point along edges.
 *
 * \param network an empty network
 * \param base_points a range of vertices, at most one in each component. In a component without a given base point, the
 *        base point is the first vertex on the border, or the first vertex of the component if it has no border
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals. If it returns `false`, no
 *       curve is added}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the number of curves added
 * \pre the edges of the triangulation are still those of the input
 * \throws Vertex_out_of_range_error as `Loop_basis` does
 * \throws Invalid_parameter_error as `Loop_basis` does
 * \throws Invalid_mesh_error as `Loop_basis` does
 * \throws Invalid_coordinate_error as `Loop_basis` does
 *
 * Complexity: \cgalBigO{n \log n} for \f$n\f$ edges.
 */
template <class Network, class VertexRange, class... NamedParameters,
          std::enable_if_t<!internal::is_named_parameters<VertexRange>, int> = 0>
Index add_cut_graph(Network& network, const VertexRange& base_points, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::add_cut_graph(network, base_points, interruption);
  });
}

/// \ingroup PkgFlipGeodesicsLoops
/// Fills an empty network with curves along which each component of a surface can be cut open into a topological disk.
/// The function chooses a base point in each component. The parameters and exceptions are those of the overload with
/// base points.
template <class Network, class... NamedParameters,
          std::enable_if_t<(internal::is_named_parameters<NamedParameters> && ...), int> = 0>
Index add_cut_graph(Network& network, const NamedParameters&... np)
{
  return Flip_geodesics::add_cut_graph(network, std::vector<Vertex_index>(), np...);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CUT_GRAPH_H
