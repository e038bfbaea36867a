// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Vertex_queue.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/surface/check_vertex.h>
#include <CGAL/Flip_geodesics/metrics.h>

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
    for(Vertex_index v : base_points)
      grow_from_given(input, v, weight, is_joined, interruption);
    for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
      if(m_component[v] < 0 && input.outgoing(v) != null_index)
        grow(input, v, weight, is_joined, interruption);
    if(m_spokes != static_cast<std::size_t>(input.number_of_halfedges()))
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
  // The path to the tail of an edge and over it, and the path to its other end.
  template <class Input_mesh>
  std::pair<std::vector<Halfedge_index>, std::vector<Halfedge_index>> legs(const Input_mesh& input,
                                                                           Input_halfedge_index h) const
  {
    std::pair<std::vector<Halfedge_index>, std::vector<Halfedge_index>> result = {
        path(input, input.tail(h)), path(input, input.tail(twin_index(h)))};
    result.first.push_back(as_intrinsic(h));
    return result;
  }

  template <class Input_mesh, class Weight, class IsJoined>
  void grow_from_given(const Input_mesh& input, Vertex_index v, const Weight& weight, const IsJoined& is_joined,
                       Interruption* interruption)
  {
    check_vertex(v, input.number_of_vertices());
    const std::string name = "vertex " + std::to_string(v.idx());
    if(input.outgoing(v) == null_index)
      throw Invalid_parameter_error(name + " is isolated, and no base point", {static_cast<std::size_t>(v.idx())});
    if(m_component[v] >= 0)
      throw Invalid_parameter_error(name + " is in a component that has a base point already",
                                    {static_cast<std::size_t>(v.idx())});
    grow(input, v, weight, is_joined, interruption);
  }

  template <class Input_mesh, class Weight, class IsJoined>
  void grow(const Input_mesh& input, Vertex_index root, const Weight& weight, const IsJoined& is_joined,
            Interruption* interruption)
  {
    const Index component = static_cast<Index>(m_roots.size());
    m_roots.push_back(root);
    m_distance[root] = 0;
    m_queue.push(0, root);
    std::vector<Vertex_index> place; // vertices joined with the one that was reached
    while(!m_queue.empty())
      for(place.push_back(m_queue.pop()); !place.empty();) {
        const Vertex_index v = place.back();
        place.pop_back();
        if(m_component[v] >= 0)
          continue; // has been reached on a shorter way since
        throw_if_interrupted(interruption);
        m_component[v] = component;
        const Input_halfedge_index first = input.outgoing(v);
        Input_halfedge_index h = first;
        do {
          const Vertex_index w = input.tail(twin_index(h));
          if(is_joined(h) && m_component[w] < 0) {
            reach(w, m_distance[v], h);
            place.push_back(w);
          } else {
            relax(v, w, h, weight(h));
          }
          h = input.next(twin_index(h));
          ++m_spokes;
        } while(h != first);
      }
  }

  void relax(Vertex_index v, Vertex_index w, Input_halfedge_index h, double length)
  {
    if(!is_zero_or_usable_length(length))
      throw_unusable_length(length, v, w);
    const double distance = m_distance[v] + length;
    if(m_component[w] >= 0 || !(distance < m_distance[w]))
      return;
    reach(w, distance, h);
    m_queue.push(distance, w);
  }

  void reach(Vertex_index w, double distance, Input_halfedge_index h)
  {
    m_distance[w] = distance;
    m_incoming[w] = h;
  }

  Indexed_by<Vertex_index, std::vector<Input_halfedge_index>> m_incoming;
  Indexed_by<Vertex_index, std::vector<double>> m_distance;
  Indexed_by<Vertex_index, std::vector<Index>> m_component;
  std::vector<Vertex_index> m_roots;
  Vertex_queue m_queue;
  std::size_t m_spokes = 0; // halfedges that start at vertices reached
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_EDGE_FOREST_H
