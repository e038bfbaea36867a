// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_NEEDLESS_SEAMS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_NEEDLESS_SEAMS_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Finds which edges of a network are required to cut each component of the surface open to a disk, if the network cuts
 * it into several.
 *
 * The complement of a cut graph is one disk. After shortening, parts of the graph can overlap or touch at a vertex, and
 * the region between them has no width: the disk is pinched there, and its parts are disconnected disks.
 *
 *       _______            _____
 *      /       \          /  a  \          a, b: two disks. Two disks joined along a chain form a disk, so that one of
 *      \__ = __/    ->    >--=--<          their common chains is not a seam, and the strip between them is cut once.
 *      /       \          \  b  /
 *
 * Seams are therefore dropped along a spanning forest of the pieces, the longest first.
 */
template <class Network>
class Needless_seams
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Needless_seams(Network& network)
    : m_network(network)
    , m_is_on_border(static_cast<std::size_t>(triangulation().number_of_vertices()), 0)
    , m_is_seam(static_cast<std::size_t>(triangulation().number_of_edges()), 0)
    , m_pieces(static_cast<std::size_t>(triangulation().number_of_halfedges()))
  {
    for(Halfedge_index h : descriptors<Halfedge_index>(triangulation().number_of_halfedges()))
      if(triangulation().is_border(h))
        m_is_on_border[triangulation().tail(h)] = 1;
    for(Edge_index e : descriptors<Edge_index>(triangulation().number_of_edges()))
      m_is_seam[e] = network.is_occupied(first_side(e)) && !is_border_edge(first_side(e)) ? 1 : 0;
    unite_pieces();
  }

  /* Reduces the network to the chains of the required seams, between vertices at which a number of them other than two
   * meet. Returns false and changes nothing if all are required. */
  bool remove()
  {
    if(!is_in_pieces())
      return false;
    replace_curves();
    const auto degree_before = m_degree;
    const bool is_changed = drop_between_pieces();
    prune(degree_before);
    replace_curves();
    return is_changed;
  }

private:
  const Triangulation& triangulation() const { return m_network.triangulation(); }

  bool is_border_edge(Halfedge_index h) const
  {
    return triangulation().is_border(h) || triangulation().is_border(Triangulation::twin(h));
  }

  // A piece is a set of halfedges, connected within faces and across edges that are not seams.
  void unite_pieces()
  {
    for(Halfedge_index h : descriptors<Halfedge_index>(triangulation().number_of_halfedges())) {
      if(triangulation().is_border(h))
        continue;
      unite(m_pieces, h.idx(), triangulation().next(h).idx());
      if(m_is_seam[Triangulation::edge(h)] == 0 && !is_border_edge(h))
        unite(m_pieces, h.idx(), Triangulation::twin(h).idx());
    }
  }

  bool is_in_pieces()
  {
    const auto all = descriptors<Edge_index>(triangulation().number_of_edges());
    return std::any_of(all.begin(), all.end(), [this](Edge_index e) {
      const Halfedge_index h = first_side(e);
      return m_is_seam[e] != 0 && !are_united(m_pieces, h.idx(), Triangulation::twin(h).idx());
    });
  }

  bool is_node(Vertex_index v) const { return m_degree[v] != 2 || m_is_on_border[v] != 0; }

  // By one curve for each chain of seams.
  void replace_curves()
  {
    m_network.clear();
    m_degree = degrees(triangulation(), m_is_seam);
    add_chains(m_network, m_is_seam, [this](Vertex_index v) { return is_node(v); });
  }

  bool drop_between_pieces()
  {
    std::vector<std::pair<double, Curve_index>> chains;
    for(Curve_index c : m_network.curves())
      chains.push_back({-m_network.length(c), c});
    std::sort(chains.begin(), chains.end());
    bool is_changed = false;
    for(const auto& [length, c] : chains) {
      std::vector<Halfedge_index> chain = m_network.halfedges(c);
      if(!unite(m_pieces, chain.front().idx(), Triangulation::twin(chain.front()).idx()))
        continue;
      if(m_network.is_closed(c))
        chain.resize(1); // two disks with their whole boundary in common form a sphere, which must be cut
      drop(chain);
      is_changed = true;
    }
    return is_changed;
  }

  void drop(const std::vector<Halfedge_index>& chain)
  {
    for(Halfedge_index h : chain) {
      m_is_seam[Triangulation::edge(h)] = 0;
      --m_degree[triangulation().tail(h)];
      --m_degree[triangulation().head(h)];
    }
  }

  // Removes chains that have become dead ends. A chain between two such ends is kept: a sphere is cut along it.
  void prune(const Indexed_by<Vertex_index, std::vector<Index>>& degree_before)
  {
    for(Vertex_index leaf : descriptors<Vertex_index>(triangulation().number_of_vertices()))
      for(Vertex_index v = leaf; m_degree[v] == 1 && degree_before[v] > 1 && m_is_on_border[v] == 0;) {
        const std::vector<Halfedge_index> chain = chain_from(v);
        v = triangulation().head(chain.back());
        if(m_degree[v] == 1 && m_is_on_border[v] == 0)
          break;
        drop(chain);
      }
  }

  std::vector<Halfedge_index> chain_from(Vertex_index leaf) const
  {
    std::vector<Halfedge_index> result;
    for(Vertex_index v = leaf; result.empty() || !is_node(v); v = triangulation().head(result.back()))
      for(Halfedge_index h : outgoing_halfedges(triangulation(), v))
        if(m_is_seam[Triangulation::edge(h)] != 0 && (result.empty() || h != Triangulation::twin(result.back()))) {
          result.push_back(h);
          break;
        }
    return result;
  }

  Network& m_network;
  Indexed_by<Vertex_index, std::vector<char>> m_is_on_border;
  Edge_marks m_is_seam;
  Disjoint_sets m_pieces;                                // of halfedges
  Indexed_by<Vertex_index, std::vector<Index>> m_degree; // in the seams
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_NEEDLESS_SEAMS_H
