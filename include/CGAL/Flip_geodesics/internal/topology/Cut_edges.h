// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CUT_EDGES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CUT_EDGES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
    , m_is_on_border(static_cast<std::size_t>(triangulation.input().number_of_vertices()), 0)
    , m_marks(static_cast<std::size_t>(triangulation.input().number_of_halfedges() / 2), 0)
  {
    check_surface(input());
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input().number_of_halfedges()))
      if(input().is_border(h))
        m_is_on_border[input().tail(h)] = 1;
    const auto weight = [this](Input_halfedge_index h) { return m_triangulation.metric().weight(input(), h); };
    const auto is_joined = [this](Input_halfedge_index h) { return is_border_edge(h); };
    const Edge_forest components(input(), base_points, weight, is_joined, interruption);
    const Edge_forest forest(input(), with_roots_on_borders(components, base_points), weight, is_joined, interruption);
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

  // The given base points, and a border vertex in each other component with a border.
  template <class VertexRange>
  std::vector<Vertex_index> with_roots_on_borders(const Edge_forest& components, const VertexRange& base_points) const
  {
    std::vector<Vertex_index> result(std::begin(base_points), std::end(base_points));
    std::vector<char> has_root(components.roots().size(), 0);
    for(Vertex_index v : result)
      has_root[static_cast<std::size_t>(components.component(v))] = 1;
    for(Vertex_index v : descriptors<Vertex_index>(input().number_of_vertices()))
      if(is_on_border(v) && has_root[static_cast<std::size_t>(components.component(v))] == 0) {
        has_root[static_cast<std::size_t>(components.component(v))] = 1;
        result.push_back(v);
      }
    return result;
  }

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
      for(Vertex_index v = leaf; v != null_index && degree[v] == 1;) {
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CUT_EDGES_H
