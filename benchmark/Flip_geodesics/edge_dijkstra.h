// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_EDGE_DIJKSTRA_H
#define FLIP_GEODESICS_BENCHMARK_EDGE_DIJKSTRA_H

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

/*
 * The opponent that all searches are measured against: Dijkstra's algorithm with a binary heap and early exit, over a
 * `Surface_mesh` as it is, with contiguous arrays that are made once and cleared where they were touched.
 */
template <class Mesh>
class Edge_dijkstra
{
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Entry = std::pair<double, std::uint32_t>;

public:
  explicit Edge_dijkstra(const Mesh& mesh)
    : m_mesh(mesh)
    , m_points(mesh.points())
    , m_distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity())
    , m_arrival(mesh.number_of_vertices())
  {
  }

  /// The halfedges of a shortest edge path; empty if there is none.
  std::vector<Halfedge> operator()(Vertex source, Vertex target)
  {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    set(source, 0, Mesh::null_halfedge());
    queue.emplace(0.0, source);
    m_settled = 0;
    bool is_found = false;
    while(!queue.empty() && !is_found) {
      const auto [distance, id] = queue.top();
      queue.pop();
      const Vertex v(id);
      if(distance > m_distance[v])
        continue;
      ++m_settled;
      is_found = v == target;
      if(is_found)
        break;
      const auto& p = m_points[v];
      for(Halfedge in : CGAL::halfedges_around_target(v, m_mesh)) {
        const Vertex w = m_mesh.source(in);
        const auto& q = m_points[w];
        const double x = q.x() - p.x(), y = q.y() - p.y(), z = q.z() - p.z();
        const double through_v = distance + std::sqrt(x * x + y * y + z * z);
        if(through_v < m_distance[w]) {
          set(w, through_v, m_mesh.opposite(in));
          queue.emplace(through_v, w);
        }
      }
    }
    std::vector<Halfedge> path;
    for(Vertex v = target; is_found && v != source; v = m_mesh.source(m_arrival[v]))
      path.push_back(m_arrival[v]);
    std::reverse(path.begin(), path.end());
    m_length = m_distance[target];
    for(Vertex v : m_touched)
      m_distance[v] = std::numeric_limits<double>::infinity();
    m_touched.clear();
    return path;
  }

  /// The number of vertices that the last search settled.
  std::size_t settled_vertices() const { return m_settled; }

  /// The length of the last path, infinite if there was none.
  double length() const { return m_length; }

private:
  void set(Vertex v, double distance, Halfedge arrival)
  {
    if(std::isinf(m_distance[v]))
      m_touched.push_back(v);
    m_distance[v] = distance;
    m_arrival[v] = arrival;
  }

  const Mesh& m_mesh;
  typename Mesh::template Property_map<Vertex, typename Mesh::Point> m_points;
  std::vector<double> m_distance;
  std::vector<Halfedge> m_arrival;
  std::vector<Vertex> m_touched;
  std::size_t m_settled = 0;
  double m_length = 0;
};

#endif // FLIP_GEODESICS_BENCHMARK_EDGE_DIJKSTRA_H
