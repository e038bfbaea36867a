// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Input_edge_policy.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/distances/Vertex_queue.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/surface/check_vertex.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Throws Invalid_mesh_error unless all faces are triangles, each edge is in one, and no vertex is passed by the border
 * twice: sheets that hang together in a vertex are no surface, and loops through it have no class.
 */
template <class Input_mesh>
void check_surface(const Input_mesh& input)
{
  Indexed_by<Vertex_index, std::vector<char>> is_on_border(static_cast<std::size_t>(input.number_of_vertices()), 0);
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(!input.is_border(h)) {
      check_triangle(input, h);
      continue;
    }
    check_has_face(input, h);
    const Vertex_index v = input.tail(h);
    if(is_on_border[v] != 0)
      throw Invalid_mesh_error("sheets of the surface meet in vertex " + std::to_string(v.idx()) + " only",
                               {static_cast<std::size_t>(v.idx())});
    is_on_border[v] = 1;
  }
}

/* Calls `use(border)` for each border, as a chain of halfedges with the surface on the left, that of its smallest edge
 * first. */
template <class Input_mesh, class Use>
void for_each_border(const Input_mesh& input, const Use& use)
{
  Indexed_by<Input_halfedge_index, std::vector<char>> is_used(static_cast<std::size_t>(input.number_of_halfedges()), 0);
  for(Input_halfedge_index first : descriptors<Input_halfedge_index>(input.number_of_halfedges())) {
    if(!input.is_border(first) || is_used[first] != 0)
      continue;
    std::vector<Halfedge_index> border;
    Input_halfedge_index h = first;
    do {
      border.push_back(as_intrinsic(twin_index(h)));
      is_used[h] = 1;
      h = input.previous(h);
    } while(h != first);
    use(border);
  }
}

/* How many halfedges two chains have in common at first. */
inline std::size_t common_start(const std::vector<Halfedge_index>& a, const std::vector<Halfedge_index>& b)
{
  std::size_t common = 0;
  while(common < a.size() && common < b.size() && a[common] == b[common])
    ++common;
  return common;
}

/* Two chains between the same vertices from a position on, the second one backwards. */
inline std::vector<Halfedge_index> closed_chain(const std::vector<Halfedge_index>& out,
                                                const std::vector<Halfedge_index>& back, std::size_t first)
{
  std::vector<Halfedge_index> result(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
  for(std::size_t i = back.size(); i-- > first;)
    result.push_back(twin_index(back[i]));
  return result;
}

/*
 * Shortest paths along the edges of the input from one base point in each component to all its vertices: a tree for each
 * component. `weight(h)` is the length of a halfedge. Of equally long ways, that which was found first stays.
 *
 * Where `is_joined(h)` holds, the ends of an edge count as one place: whoever comes to one goes on to the other at once.
 * So a tree has as many of these edges as it can.
 */
class Edge_forest
{
public:
  /* The path to the tail of an edge and over it, and the path to its other end. */
  using Legs = std::pair<std::vector<Halfedge_index>, std::vector<Halfedge_index>>;

  /* None. */
  Edge_forest() = default;

  /* Grows a tree from each base point, and from the first vertex of each other component. \throws Interrupted */
  template <class Input_mesh, class VertexRange, class Weight, class IsJoined>
  Edge_forest(const Input_mesh& input, const VertexRange& base_points, const Weight& weight, const IsJoined& is_joined,
              Interruption* interruption = nullptr)
    : m_incoming(static_cast<std::size_t>(input.number_of_vertices()), null_index)
    , m_distance(static_cast<std::size_t>(input.number_of_vertices()), std::numeric_limits<double>::infinity())
    , m_component(static_cast<std::size_t>(input.number_of_vertices()), -1)
  {
    throw_if_interrupted_before_part(interruption);
    Search search(static_cast<std::size_t>(input.number_of_vertices()));
    Policy<Input_mesh, Weight, IsJoined> policy(*this, search, input, weight, is_joined, interruption);
    for(Vertex_index v : base_points) {
      check_base_point(input, v);
      grow(v, search, policy);
    }
    for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
      if(m_component[v] < 0 && input.outgoing(v) != null_index)
        grow(v, search, policy);
    if(policy.number_of_steps() != static_cast<std::size_t>(input.number_of_halfedges()))
      throw Invalid_mesh_error("sheets of the surface meet in a vertex only");
  }

  /* The same with no edges joined. */
  template <class Input_mesh, class VertexRange, class Weight>
  Edge_forest(const Input_mesh& input, const VertexRange& base_points, const Weight& weight,
              Interruption* interruption = nullptr)
    : Edge_forest(
          input, base_points, weight, [](Input_halfedge_index) { return false; }, interruption)
  {
  }

  /* The base point of each component. */
  const std::vector<Vertex_index>& roots() const { return m_roots; }
  /* The component of a vertex, -1 if it is isolated. */
  Index component(Vertex_index v) const { return m_component[v]; }
  /* The length of the path to a vertex. */
  double distance(Vertex_index v) const { return m_distance[v]; }
  /* The last halfedge of the path to a vertex, `null_index` at a base point. */
  Input_halfedge_index incoming(Vertex_index v) const { return m_incoming[v]; }

  /* Is an edge on a path? */
  template <class Input_mesh>
  bool contains(const Input_mesh& input, Input_halfedge_index h) const
  {
    return m_incoming[input.tail(h)] == twin_index(h) || m_incoming[input.tail(twin_index(h))] == h;
  }

  /* The path from the base point to a vertex. */
  template <class Input_mesh>
  std::vector<Halfedge_index> path(const Input_mesh& input, Vertex_index v) const
  {
    std::vector<Halfedge_index> result;
    for(Input_halfedge_index h = m_incoming[v]; h != null_index; h = m_incoming[input.tail(h)])
      result.push_back(as_intrinsic(h));
    std::reverse(result.begin(), result.end());
    return result;
  }

  /* The path to an edge, over it, and the path back to the base point. */
  template <class Input_mesh>
  std::vector<Halfedge_index> loop(const Input_mesh& input, Input_halfedge_index h) const
  {
    const auto [out, back] = legs(input, h);
    return closed_chain(out, back, 0);
  }

  /* The same without what it goes out and back. */
  template <class Input_mesh>
  std::vector<Halfedge_index> cycle(const Input_mesh& input, Input_halfedge_index h) const
  {
    const auto [out, back] = legs(input, h);
    return closed_chain(out, back, common_start(out, back));
  }

private:
  // Vertices with a negative key come out at once, the last one first.
  class Queue : public Vertex_queue
  {
  public:
    bool empty() const { return m_joined.empty() && Vertex_queue::empty(); }

    void push(double key, Vertex_index v)
    {
      if(key < 0)
        m_joined.push_back(v);
      else
        Vertex_queue::push(key, v);
    }

    Vertex_index pop()
    {
      if(m_joined.empty())
        return Vertex_queue::pop();
      const Vertex_index result = m_joined.back();
      m_joined.pop_back();
      return result;
    }

  private:
    std::vector<Vertex_index> m_joined;
  };

  using Search = Label_setting_search<Search_labels<Input_halfedge_index>, Queue>;

  // Writes labels into the forest when they are settled.
  template <class Input_mesh, class Weight, class IsJoined>
  class Policy : public Input_edge_policy<Input_mesh, Weight>
  {
    using Base = Input_edge_policy<Input_mesh, Weight>;
    using Origin = typename Base::Origin;

  public:
    struct Step
    {
      double distance;
      bool is_joined; // with the vertex from which it starts
    };

    Policy(Edge_forest& forest, const Search& search, const Input_mesh& input, const Weight& weight,
           const IsJoined& is_joined, Interruption* interruption)
      : Base(input, weight, interruption)
      , m_forest(forest)
      , m_search(search)
      , m_is_joined(is_joined)
    {
    }

    /* Of all searches: the halfedges that start at settled vertices. */
    std::size_t number_of_steps() const { return m_number_of_steps; }

    /* \throws Interrupted */
    bool settle(Vertex_index v)
    {
      m_forest.m_component[v] = static_cast<Index>(m_forest.m_roots.size()) - 1;
      m_forest.m_distance[v] = m_search[v].distance;
      m_forest.m_incoming[v] = m_search[v].incoming();
      return Base::settle(v);
    }

    template <class Function>
    void for_each_halfedge(const Origin& origin, const Function& function)
    {
      Base::for_each_halfedge(origin, [&](Input_halfedge_index h) {
        ++m_number_of_steps;
        function(h);
      });
    }

    Step step(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
    {
      if(m_is_joined(h))
        return {origin.distance, true};
      return {Base::step(origin, h, w).distance, false};
    }

    /* Checks the length of an edge of which both ends are known, too. */
    void meet(const Origin& origin, Input_halfedge_index h, Vertex_index w) const { this->length(origin, h, w); }

    template <class Label>
    bool is_better(const Step& step, const Label& label) const
    {
      return step.is_joined || Base::is_better(step, label);
    }

    double key(Vertex_index, const Step& step) const { return step.is_joined ? -1 : step.distance; }

  private:
    Edge_forest& m_forest;
    const Search& m_search;
    const IsJoined& m_is_joined;
    std::size_t m_number_of_steps = 0;
  };

  template <class Input_mesh>
  Legs legs(const Input_mesh& input, Input_halfedge_index h) const
  {
    Legs result = {path(input, input.tail(h)), path(input, input.tail(twin_index(h)))};
    result.first.push_back(as_intrinsic(h));
    return result;
  }

  template <class Input_mesh>
  void check_base_point(const Input_mesh& input, Vertex_index v) const
  {
    check_vertex(v, input.number_of_vertices());
    const std::string name = "vertex " + std::to_string(v.idx());
    if(input.outgoing(v) == null_index)
      throw Invalid_parameter_error(name + " is isolated, and no base point", {static_cast<std::size_t>(v.idx())});
    if(m_component[v] >= 0)
      throw Invalid_parameter_error(name + " is in a component that has a base point already",
                                    {static_cast<std::size_t>(v.idx())});
  }

  template <class SearchPolicy>
  void grow(Vertex_index root, Search& search, SearchPolicy& policy)
  {
    m_roots.push_back(root);
    search.add_source(root);
    search.run(policy);
  }

  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> m_incoming;
  Indexed_by<Vertex_index, std::vector<double>> m_distance;
  Indexed_by<Vertex_index, std::vector<Index>> m_component;
  std::vector<Vertex_index> m_roots;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H
