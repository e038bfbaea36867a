// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_LOOP_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_LOOP_SEARCH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Input_edge_policy.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Searches for loops along edges through a vertex, its root. A shortest one of a kind consists of a shortest path, an
 * edge and a shortest path back [Erickson, Har-Peled 2004]. Both ends of the edge are nearer than half of its length,
 * so that a search ends at half of the best length so far. The class of a path is kept at its end; the classes of the
 * two paths and of the edge determine that of the loop.
 */
template <class Triangulation, class PathClass>
class Loop_search
{
  using Input_mesh = std::decay_t<decltype(std::declval<Triangulation>().input())>;

public:
  /* \param interruption null if searches cannot be interrupted */
  Loop_search(const Triangulation& triangulation, Interruption* interruption)
    : m_triangulation(triangulation)
    , m_interruption(interruption)
    , m_search(number_of_vertices())
    , m_classes(number_of_vertices())
  {
  }

  /*
   * The policy of a search, from which those for loops of some kind are derived. They provide the class of a path that
   * goes on over a halfedge, `extended(path, h)`, and `meet()`, which looks at the loop that an edge closes.
   */
  template <class Derived>
  class Policy : public Input_edge_policy<Input_mesh, Metric_weight<Triangulation>>
  {
    using Base = Input_edge_policy<Input_mesh, Metric_weight<Triangulation>>;

  public:
    explicit Policy(Loop_search& search)
      : Base(search.input(), Metric_weight<Triangulation>(search.m_triangulation), search.m_interruption)
      , m_loops(search)
    {
    }

    /* \throws Interrupted */
    void reach(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w, bool)
    {
      m_loops.m_classes[w] = class_over(origin, h);
    }

  protected:
    PathClass class_over(const typename Base::Origin& origin, Input_halfedge_index h) const
    {
      return static_cast<const Derived&>(*this).extended(m_loops.m_classes[origin.vertex], h);
    }

    const PathClass& class_of_path(Vertex_index v) const { return m_loops.m_classes[v]; }

    /* The length of the loop that a halfedge to a settled vertex closes. */
    double length_of_loop(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w) const
    {
      return this->step(origin, h, w).distance + m_loops.m_search[w].distance;
    }

  private:
    Loop_search& m_loops;
  };

  /* Searches from a vertex, whose path has a class. \throws Interrupted, Invalid_coordinate_error */
  template <class SearchPolicy>
  void run(Vertex_index root, const PathClass& of_root, SearchPolicy& policy)
  {
    m_search.clear();
    m_search.add_source(root);
    m_classes[root] = of_root;
    m_search.run(policy);
  }

  /* The path to the tail of a halfedge and over it, and the path to its head, of the last search. */
  Edge_forest::Legs legs(Input_halfedge_index h) const
  {
    Edge_forest::Legs result = {path(input().tail(h)), path(input().tail(twin_index(h)))};
    result.first.push_back(as_intrinsic(h));
    return result;
  }

private:
  const Input_mesh& input() const { return m_triangulation.input(); }
  std::size_t number_of_vertices() const { return static_cast<std::size_t>(input().number_of_vertices()); }

  std::vector<Halfedge_index> path(Vertex_index v) const
  {
    return m_search.template path<Halfedge_index>(v, [this](Input_halfedge_index h) { return input().tail(h); });
  }

  const Triangulation& m_triangulation;
  Interruption* m_interruption;
  Label_setting_search<Search_labels<Input_halfedge_index>> m_search;
  Indexed_by<Vertex_index, std::vector<PathClass>> m_classes; // of the paths to vertices that are reached
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_LOOP_SEARCH_H
