// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CUT_EDGES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CUT_EDGES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

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
      if(is_leaf(leaf) && degree_before[leaf] != 1)
        if(const std::vector<Halfedge_index> chain = chain_from(leaf); !is_leaf(triangulation().head(chain.back())))
          drop(chain);
  }

  bool is_leaf(Vertex_index v) const { return m_degree[v] == 1 && m_is_on_border[v] == 0; }

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

/*
 * The edges along which each component of a surface is cut to become a disk: those of a tree of shortest paths and
 * those that the cotree does not cross, without dead ends. The border counts as cut. Paths along it have length zero,
 * and its edges are removed in the end. A sphere is cut along the longest of its shortest paths.
 */
template <class Triangulation>
class Cut_edges
{
public:
  /* \throws Interrupted */
  template <class VertexRange>
  Cut_edges(const Triangulation& triangulation, const VertexRange& base_points, Interruption* interruption = nullptr)
    : m_triangulation(triangulation)
    , m_is_on_border(check_surface(triangulation.input()))
    , m_marks(static_cast<std::size_t>(triangulation.input().number_of_halfedges() / 2), 0)
  {
    const Metric_weight<Triangulation> weight{m_triangulation};
    const Edge_forest forest(
        input(), base_points, weight, [this](Input_halfedge_index h) { return is_border_edge(h); },
        [this](Vertex_index v) { return is_on_border(v); }, interruption);
    const Cotree cotree(input(), forest, Borders::LEFT_OPEN, weight, interruption);
    throw_if_interrupted_before_part(interruption);
    mark_trees(forest, cotree);
    prune();
    slit_spheres(forest, cotree);
  }

  const Edge_marks& marks() const { return m_marks; }
  bool is_on_border(Vertex_index v) const { return m_is_on_border[v] != 0; }

private:
  const auto& input() const { return m_triangulation.input(); }

  bool is_border_edge(Input_halfedge_index h) const { return input().is_border(h) || input().is_border(twin_index(h)); }

  void mark_trees(const Edge_forest& forest, const Cotree& cotree)
  {
    for(Edge_index e : descriptors<Edge_index>(static_cast<Index>(m_marks.size())))
      if(forest.contains(input(), as_input(first_side(e))))
        m_marks[e] = 1;
    for(const Cotree::Loop& loop : cotree.generators())
      m_marks[edge_of(as_intrinsic(loop.halfedge))] = 1;
  }

  // Repeatedly removes edges with an end at which no other edge ends, and then the border edges.
  void prune()
  {
    Indexed_by<Vertex_index, std::vector<Index>> degree(m_is_on_border.size(), 0);
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input().number_of_halfedges()))
      degree[input().tail(h)] += m_marks[edge_of(as_intrinsic(h))];
    for(Vertex_index leaf : descriptors<Vertex_index>(input().number_of_vertices()))
      for(Vertex_index v = leaf; degree[v] == 1;) {
        const Input_halfedge_index h = marked_outgoing_halfedge(v);
        m_marks[edge_of(as_intrinsic(h))] = 0;
        --degree[v];
        v = input().tail(twin_index(h));
        --degree[v];
      }
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input().number_of_halfedges()))
      if(is_border_edge(h))
        m_marks[edge_of(as_intrinsic(h))] = 0;
  }

  Input_halfedge_index marked_outgoing_halfedge(Vertex_index v) const
  {
    Input_halfedge_index h = input().outgoing(v);
    while(m_marks[edge_of(as_intrinsic(h))] == 0)
      h = input().next(twin_index(h));
    return h;
  }

  void slit_spheres(const Edge_forest& forest, const Cotree& cotree)
  {
    std::vector<char> is_sphere(forest.roots().size(), 1);
    for(const Cotree::Loop& loop : cotree.generators()) // a border has one as well
      is_sphere[static_cast<std::size_t>(loop.component)] = 0;
    std::vector<Vertex_index> farthest = forest.roots();
    for(Vertex_index v : descriptors<Vertex_index>(input().number_of_vertices()))
      if(forest.component(v) >= 0) {
        Vertex_index& w = farthest[static_cast<std::size_t>(forest.component(v))];
        w = forest.distance(v) > forest.distance(w) ? v : w;
      }
    for(std::size_t c = 0; c < is_sphere.size(); ++c)
      if(is_sphere[c] != 0)
        for(Halfedge_index h : forest.path(input(), farthest[c]))
          m_marks[edge_of(h)] = 1;
  }

  const Triangulation& m_triangulation;
  Indexed_by<Vertex_index, std::vector<char>> m_is_on_border;
  Edge_marks m_marks;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CUT_EDGES_H
