// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_LAWSON_FLIPS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_LAWSON_FLIPS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>

#include <cstddef>
#include <deque>
#include <unordered_map>
#include <utility>

namespace CGAL::Flip_geodesics::internal {

/* Calls function(h) for each edge of the faces around v. */
template <class Triangulation, class Function>
void for_each_edge_in_star(const Triangulation& triangulation, Vertex_index v, Function function)
{
  Halfedge_index start = triangulation.outgoing(v);
  if(start == null_index)
    return;
  for(Halfedge_index h = triangulation.clockwise(start); h != null_index && h != triangulation.outgoing(v);
      h = triangulation.clockwise(h))
    start = h; // the last one before the border
  if(triangulation.clockwise(start) != null_index)
    start = triangulation.outgoing(v);
  Halfedge_index h = start;
  do {
    function(h);
    if(!triangulation.is_border(h))
      function(triangulation.next(h));
    h = triangulation.counterclockwise(h);
  } while(h != null_index && h != start);
}

/*
 * Lawson's algorithm on a set of edges, or on all: flips edges that are not locally Delaunay in the order of a queue,
 * and then examines the four edges around each again. Labeled edges, which lie under curves, are not flipped.
 */
template <class Triangulation>
class Lawson_flips
{
  static_assert(has_edge_sequences<Triangulation> || !Triangulation::Traits::Has_drift::value,
                "traits with Has_drift == Tag_true require a model of IntrinsicTriangulationOfMesh, since inaccurate "
                "faces are recomputed from the input mesh");

public:
  /* Works on the edges admitted later or, if `allows_all`, on all edges; edges are queued when they are examined. */
  explicit Lawson_flips(Triangulation& triangulation, bool allows_all = false)
    : m_triangulation(triangulation)
    , m_allows_all(allows_all)
  {
  }

  /* Admits an edge to the set and queues it. */
  void allow(Edge_index e) { enqueue(e, m_edges.emplace(e, Edge{false, 0}).first->second); }

  /* Clears the list of flipped edges and the queue. */
  void clear()
  {
    m_edges.clear();
    m_queue.clear();
  }

  /* Queues an edge of the set again. */
  void look_at(Edge_index e)
  {
    if(m_allows_all)
      return allow(e);
    if(const auto found = m_edges.find(e); found != m_edges.end())
      enqueue(e, found->second);
  }

  /* Flips until no edge remains, `maximum` flips are done, or the visitor stops the process. Returns the number of
   * flips. */
  template <class Visitor>
  std::size_t flip(std::size_t maximum, Visitor& visitor)
  {
    std::size_t flips = 0;
    m_is_stopped = false;
    while(!m_queue.empty() && flips < maximum) {
      if(!visitor.go_further()) {
        m_is_stopped = true;
        return flips;
      }
      const Edge_index e = m_queue.front();
      const Halfedge_index h = first_side(e);
      m_queue.pop_front();
      Edge& edge = m_edges.at(e);
      edge.is_queued = false;
      if(m_triangulation.holds(e) != 0 || m_triangulation.is_locally_delaunay(h) || !is_still_to_flip(edge, h))
        continue;
      m_triangulation.flip(h);
      visitor.on_flip(m_triangulation, h);
      ++flips;
      ++edge.flips;
      for(Halfedge_index side : {h, Triangulation::twin(h)}) {
        look_at(Triangulation::edge(m_triangulation.next(side)));
        look_at(Triangulation::edge(m_triangulation.previous(side)));
      }
    }
    return flips;
  }

  /* Returns whether the visitor stopped the last call of flip(). */
  bool is_stopped() const { return m_is_stopped; }

private:
  struct Edge
  {
    bool is_queued;
    unsigned flips;
  };

  void enqueue(Edge_index e, Edge& edge)
  {
    if(!std::exchange(edge.is_queued, true))
      m_queue.push_back(e);
  }

  // An edge that was flipped 32, 64, ... times is examined from the input, before rounding errors can lead to a cycle.
  bool is_still_to_flip(const Edge& edge, Halfedge_index h)
  {
    if constexpr(Triangulation::Traits::Has_drift::value)
      if(edge.flips >= 32 && (edge.flips & (edge.flips - 1)) == 0) {
        refresh_face(m_triangulation, h);
        refresh_face(m_triangulation, Triangulation::twin(h));
        return !m_triangulation.is_locally_delaunay(h);
      }
    return true;
  }

  Triangulation& m_triangulation;
  bool m_allows_all;
  bool m_is_stopped = false;
  std::unordered_map<Edge_index, Edge> m_edges;
  std::deque<Edge_index> m_queue;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_LAWSON_FLIPS_H
