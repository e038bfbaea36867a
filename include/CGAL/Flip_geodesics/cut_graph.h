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

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* \throws Interrupted, and leaves the network as it is then */
template <class Network, class VertexRange>
Index add_cut_graph(Network& network, const VertexRange& base_points, Interruption* interruption)
{
  static_assert(is_range_of<VertexRange, Vertex_index>,
                "the base points are not a range of vertices of the triangulation, Vertex_index");
  const auto& triangulation = network.triangulation();
  const Cut_edges<typename Network::Triangulation> cut(triangulation, base_points, interruption);
  const auto degree = degrees(triangulation, cut.marks());
  // A curve that touches a border is cut there: pulled off it, it would leave what is cut in one piece with a hole.
  return add_chains(network, cut.marks(), [&](Vertex_index v) { return degree[v] != 2 || cut.is_on_border(v); });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Adds a network along which each component of a surface is cut open to a topological disk. Where curves meet they have
 * fixed ends, so that the network can be pulled tight, by `shorten_cut_graph()`; `cut_along_curves()` and
 * `Conformal_flattening` take it then.
 *
 * In each component, the shortest loops that generate [EW05] make the network, as for `Loop_basis`, without ways that
 * all of them go out and back. So it is short, but not the shortest: that is NP-hard to find [EH04]. Borders are cut
 * already. Curves lead from one border to another, and end where they meet it; ways along the border have no length. A
 * disk gets no curve. A sphere gets one, from its base point to the vertex farthest from it along edges.
 *
 * \param network an empty network in a triangulation whose edges are the input's
 * \param base_points vertices, at most one in each component; where there is none, the first vertex of the border is
 *        taken, or the first vertex
 * \param np named parameters: `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is called, at
 *        regular intervals. If it returns `false`, then no curve is added
 * \return the number of curves added
 * \throws as `Loop_basis`
 * \pre the triangulation's edges are still the input's
 *
 * Complexity: \f$O(n \log n)\f$.
 */
template <class Network, class VertexRange, class... NamedParameters,
          std::enable_if_t<!internal::Is_named_parameters<VertexRange>::value, int> = 0>
Index add_cut_graph(Network& network, const VertexRange& base_points, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::add_cut_graph(network, base_points, interruption);
  });
}

/// \ingroup PkgFlipGeodesicsLoops
/// Adds a cut graph with a base point of the function's choice in each component.
template <class Network, class... NamedParameters,
          std::enable_if_t<(internal::Is_named_parameters<NamedParameters>::value && ...), int> = 0>
Index add_cut_graph(Network& network, const NamedParameters&... np)
{
  return Flip_geodesics::add_cut_graph(network, std::vector<Vertex_index>(), np...);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CUT_GRAPH_H
