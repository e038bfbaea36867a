// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
#define CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/Lazy_array.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsRef
/// How a shortest edge path is searched. Both find a shortest one.
enum class Search_method {
  A_STAR,  ///< towards the target, by the metric's lower bound; the same as `DIJKSTRA` where that is zero
  DIJKSTRA ///< in all directions
};

/*!
 * \ingroup PkgFlipGeodesicsRef
 *
 * Searches shortest paths along the edges of the input mesh, which is where curves usually start from. It reads the
 * input alone and touches no triangulation.
 *
 * The labels are made once and told apart by epoch, so that a search costs what it visits: \f$O(k \log k)\f$ for
 * \f$k\f$ vertices visited. Of equally long paths the same one is found each time.
 *
 * \tparam Triangulation an `Intrinsic_triangulation`
 */
template <class Triangulation>
class Shortest_edge_path
{
public:
  explicit Shortest_edge_path(const Triangulation& triangulation, Search_method method = Search_method::A_STAR)
    : m_triangulation(&triangulation)
    , m_method(method)
    , m_labels(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
  }

  /*!
   * The halfedges of a shortest edge path from `source` to `target`; none if they are equal.
   * \throws Vertex_out_of_range_error
   * \throws Disconnected_endpoints_error
   * \throws Invalid_coordinate_error for an edge that the search meets and whose length is negative or no number; edges
   *         of length zero are passed here, and refused where the curve is straightened over them
   */
  std::vector<Index> operator()(Index source, Index target)
  {
    check_vertex(source);
    check_vertex(target);
    start(source);
    while(!m_heap.empty()) {
      const Index v = pop();
      if(v == target)
        return path_to(target);
      if(v != null_index)
        relax_neighbors(v, target);
    }
    throw Disconnected_endpoints_error("no path of edges joins vertex " + std::to_string(source) + " and vertex " +
                                           std::to_string(target),
                                       {static_cast<std::size_t>(source), static_cast<std::size_t>(target)});
  }

  /// The number of vertices that the last search settled.
  std::size_t settled_vertices() const { return m_settled; }

private:
  struct Label
  {
    double distance;
    Index incoming; // the halfedge through which the path arrives
    Index stamp;    // 2 * epoch if reached, 2 * epoch + 1 if settled
  };

  struct Entry
  {
    double priority;
    Index vertex;

    // std heaps hand out the largest.
    bool operator<(const Entry& other) const
    {
      return priority != other.priority ? priority > other.priority : vertex > other.vertex;
    }
  };

  void check_vertex(Index v) const
  {
    if(v < 0 || v >= m_triangulation->input().number_of_vertices())
      throw Vertex_out_of_range_error("vertex " + std::to_string(v) + " is not one of the mesh's " +
                                          std::to_string(m_triangulation->input().number_of_vertices()) + " vertices",
                                      {static_cast<std::size_t>(v)});
  }

  void start(Index source)
  {
    m_epoch += 2;
    m_settled = 0;
    m_heap.clear();
    m_labels[source] = {0, null_index, m_epoch};
    m_heap.push_back({0, source});
  }

  // The nearest vertex that is not settled yet, null_index for an entry that has been overtaken.
  Index pop()
  {
    std::pop_heap(m_heap.begin(), m_heap.end());
    const Index v = m_heap.back().vertex;
    m_heap.pop_back();
    if(m_labels[v].stamp == m_epoch + 1)
      return null_index;
    m_labels[v].stamp = m_epoch + 1;
    ++m_settled;
    return v;
  }

  void relax_neighbors(Index v, Index target)
  {
    const auto& input = m_triangulation->input();
    const Index first = input.outgoing(v);
    if(first == null_index)
      return;
    Index h = first;
    do {
      relax(v, h, target);
      h = input.next(Triangulation::twin(h)); // along the border, too
    } while(h != first);
  }

  void relax(Index v, Index h, Index target)
  {
    const auto& input = m_triangulation->input();
    const Index w = input.tail(Triangulation::twin(h));
    Label& label = m_labels[w];
    if(label.stamp == m_epoch + 1)
      return;
    const double weight = m_triangulation->metric().weight(input, h);
    if(!(weight >= 0) || std::isinf(weight))
      internal::throw_unusable_length(weight, v, w);
    const double distance = m_labels[v].distance + weight;
    if(label.stamp == m_epoch && label.distance <= distance)
      return;
    label = {distance, h, m_epoch};
    m_heap.push_back({distance + lower_bound(w, target), w});
    std::push_heap(m_heap.begin(), m_heap.end());
  }

  double lower_bound(Index v, Index target) const
  {
    return m_method == Search_method::DIJKSTRA
               ? 0
               : m_triangulation->metric().distance_lower_bound(m_triangulation->input(), v, target);
  }

  std::vector<Index> path_to(Index target) const
  {
    std::vector<Index> path;
    for(Index h = m_labels[target].incoming; h != null_index; h = m_labels[m_triangulation->input().tail(h)].incoming)
      path.push_back(h);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const Triangulation* m_triangulation;
  Search_method m_method;
  internal::Lazy_array<Label> m_labels;
  std::vector<Entry> m_heap;
  Index m_epoch = 0;
  std::size_t m_settled = 0;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
