// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_NETWORK_BUILDERS_H
#define CGAL_FLIP_GEODESICS_NETWORK_BUILDERS_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The chain of halfedges of the triangulation that passes given vertices, one edge between each two.
 *
 * \param vertices a range of vertex indices; a closed curve does not repeat the first
 * \throws Vertex_out_of_range_error
 * \throws Invalid_curve_error if there are fewer than two vertices, or two in a row share no edge
 *
 * Complexity: linear in the degrees of the vertices.
 */
template <class Triangulation, class VertexRange>
std::vector<Halfedge_index> halfedges_through(const Triangulation& triangulation, const VertexRange& vertices,
                                              bool is_closed)
{
  static_assert(internal::is_range_of<VertexRange, Vertex_index>,
                "the vertices are not a range of vertices of the triangulation, Vertex_index");
  std::vector<Vertex_index> v;
  for(Vertex_index vertex : vertices) {
    internal::check_vertex(vertex, triangulation.number_of_vertices(), v.size());
    v.push_back(vertex);
  }
  if(v.size() < 2)
    throw Invalid_curve_error("a curve needs at least two vertices");
  if(is_closed)
    v.push_back(v.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < v.size(); ++i) {
    result.push_back(internal::halfedge_between(triangulation, v[i], v[i + 1]));
    if(result.back() == null_index)
      throw Invalid_curve_error("a curve is not connected: no edge joins vertex " + std::to_string(v[i].idx()) +
                                    " and vertex " + std::to_string(v[i + 1].idx()),
                                {static_cast<std::size_t>(v[i].idx()), static_cast<std::size_t>(v[i + 1].idx())});
  }
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The chain of input halfedges along shortest edge paths from each way point to the next.
 *
 * \param search a `Shortest_edge_path` over the network's triangulation, whose edges are still the input's
 * \param way_points vertex indices, at least two; those that repeat the one before count once. A closed curve need not
 *        repeat the first
 * \param is_closed says whether the chain leads back to the first way point
 * \param visitor nothing, or a model of `FlipOutVisitor`, of which only `go_further()` is called, by the searches. If
 *        it returns `false`, then no halfedges are returned
 * \throws Invalid_curve_error for fewer than two way points, or if all are one vertex
 * \throws Vertex_out_of_range_error, Disconnected_endpoints_error as `Shortest_edge_path`
 */
template <class Search, class VertexRange, class... Visitor>
std::vector<Halfedge_index> shortest_halfedges_through(Search& search, const VertexRange& way_points,
                                                       bool is_closed = false, Visitor&&... visitor)
{
  std::vector<Vertex_index> v(std::begin(way_points), std::end(way_points));
  if(v.size() < 2)
    throw Invalid_curve_error("a curve needs at least two way points");
  if(is_closed)
    v.push_back(v.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < v.size(); ++i) {
    const std::vector<Halfedge_index> leg = search(v[i], v[i + 1], visitor...); // also refuses what is no vertex
    if(leg.empty() && v[i] != v[i + 1])                                         // stopped by the visitor
      return {};
    result.insert(result.end(), leg.begin(), leg.end());
  }
  if(result.empty())
    throw Invalid_curve_error("all way points of a curve are vertex " + std::to_string(v.front().idx()) +
                                  "; the curve is a point, and has no edges",
                              {static_cast<std::size_t>(v.front().idx())});
  return result;
}

namespace internal {

/* A set of edges of a triangulation: a sign for each. */
using Edge_marks = Indexed_by<Edge_index, std::vector<char>>;

/* How many edges of a set end at each vertex. */
template <class Triangulation>
Indexed_by<Vertex_index, std::vector<Index>> degrees(const Triangulation& triangulation, const Edge_marks& is_marked)
{
  Indexed_by<Vertex_index, std::vector<Index>> result(static_cast<std::size_t>(triangulation.number_of_vertices()), 0);
  for(Edge_index e : descriptors<Edge_index>(triangulation.number_of_edges()))
    if(is_marked[e] != 0) {
      ++result[triangulation.tail(first_side(e))];
      ++result[triangulation.head(first_side(e))];
    }
  return result;
}

/* Calls `add()`, which adds curves. Returns how many; if it throws, a network that was empty is empty again. */
template <class Network, class Add>
Index add_all_or_none(Network& network, const Add& add)
{
  const Index before = network.number_of_curves();
  try {
    add();
  } catch(...) {
    if(before == 0)
      network.clear();
    throw;
  }
  return network.number_of_curves() - before;
}

/* Adds the chains of a set of edges between the vertices for which `is_node(v)` holds, and the closed ones. Returns how
 * many. \pre two edges end at each vertex of the set that is no node */
template <class Network, class IsNode>
Index add_chains(Network& network, Edge_marks is_open, const IsNode& is_node)
{
  const auto& triangulation = network.triangulation();
  // The way on from the head of h, null_index at a node.
  const auto next_open = [&](Halfedge_index h) -> Halfedge_index {
    if(is_node(triangulation.head(h)))
      return null_index;
    for(Halfedge_index g : spokes(triangulation, triangulation.head(h)))
      if(is_open[Network::Triangulation::edge(g)] != 0)
        return g;
    return null_index;
  };
  const auto walk = [&](Halfedge_index h) {
    std::vector<Halfedge_index> chain;
    for(; h != null_index; h = next_open(h)) {
      is_open[Network::Triangulation::edge(h)] = 0;
      chain.push_back(h);
    }
    return chain;
  };

  return add_all_or_none(network, [&] {
    for(Halfedge_index h : descriptors<Halfedge_index>(triangulation.number_of_halfedges()))
      if(is_open[Network::Triangulation::edge(h)] != 0 && is_node(triangulation.tail(h)))
        network.add_curve(walk(h), false);
    for(Edge_index e : descriptors<Edge_index>(triangulation.number_of_edges()))
      if(is_open[e] != 0)
        network.add_curve(walk(first_side(e)), true);
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds the network formed by the marked edges of the input mesh: a curve for each chain between vertices where other
 * than two marked edges meet, which are its fixed ends. A loop without such a vertex becomes a closed one. Open curves
 * come first. Each begins with the smaller of the halfedges that leave its two ends and lie on it, and they are ordered
 * by these halfedges. Closed curves follow, ordered by their smallest edges. If the function throws, a network that was
 * empty is empty again. Linear in the mesh.
 *
 * \param mesh the triangulation's mesh
 * \param is_marked a model of `ReadablePropertyMap` with the mesh's edges as keys and `bool` as values
 * \return the number of curves added
 * \pre the triangulation's edges are still the input's
 */
template <class Network, class TriangleMesh, class EdgeIsMarkedMap>
Index add_marked_edges(Network& network, const TriangleMesh& mesh, EdgeIsMarkedMap is_marked)
{
  static_assert(internal::is_property_map<EdgeIsMarkedMap>());
  const auto& triangulation = network.triangulation();
  internal::Edge_marks marks(static_cast<std::size_t>(triangulation.number_of_edges()), 0);
  for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges())) {
    const auto h = triangulation.input().halfedge(internal::as_input(internal::first_side(e)));
    marks[e] = get(is_marked, edge(h, mesh)) ? 1 : 0;
  }
  const auto degree = internal::degrees(triangulation, marks);
  return internal::add_chains(network, std::move(marks), [&](Vertex_index v) { return degree[v] != 2; });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_NETWORK_BUILDERS_H
