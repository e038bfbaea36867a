// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_BOUNDING_LOOP_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_BOUNDING_LOOP_SEARCH_H

#include <CGAL/Flip_geodesics/internal/distances/Vertex_queue.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* What tells classes apart modulo 2^64: sums over the edges of a loop. It does not bound on the surface if its name is
 * not zero, and bounds on a side in space if its remainder on that side is zero. */
struct Class_sums
{
  std::uint64_t name = 0;
  std::array<std::uint64_t, 2> remainders = {0, 0}; // behind the surface and in front of it

  Class_sums& add(const Class_sums& other, bool is_backwards)
  {
    const auto add_to = [is_backwards](std::uint64_t& a, std::uint64_t b) { a += is_backwards ? -b : b; };
    add_to(name, other.name);
    for(std::size_t side : {0, 1})
      add_to(remainders[side], other.remainders[side]);
    return *this;
  }

  bool bounds(std::size_t side) const { return name != 0 && remainders[side] == 0; }
};

/*
 * The shortest loops through a vertex that are made of a shortest path, an edge and a shortest path back, and bound
 * behind the surface or in front of it: one of either kind, of those that are wanted. The search ends where longer ones begin, or when many
 * vertices were reached.
 */
template <class Triangulation>
class Bounding_loop_search
{
public:
  using Sums = Indexed_by<Edge_index, std::vector<Class_sums>>;
  using Loop = std::vector<Halfedge_index>;

  /* `sums` are those of the first sides of edges; searches can be stopped. */
  Bounding_loop_search(const Triangulation& triangulation, const Sums& sums, Interruption* interruption)
    : m_interruption(interruption)
    , m_triangulation(triangulation)
    , m_sums(sums)
    , m_labels(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
  }

  /* The loops of which `is_wanted(side, sums)` holds, empty where none was found among `most` vertices; without a way
   * that is passed out and back. \throws Interrupted */
  template <class IsWanted>
  std::array<Loop, 2> operator()(Vertex_index root, std::size_t most, const IsWanted& is_wanted)
  {
    m_lengths.fill(std::numeric_limits<double>::infinity());
    m_closing.fill(null_index);
    reach(root, 0, null_index, Class_sums());
    while(!m_queue.empty() && m_reached.size() < most && 2 * m_queue.priority() < longest()) {
      const Vertex_index u = m_queue.pop();
      if(m_labels[u].is_settled)
        continue;
      throw_if_interrupted(m_interruption);
      m_labels[u].is_settled = true;
      const Input_halfedge_index first = input().outgoing(u);
      Input_halfedge_index h = first;
      do {
        pass(u, h, is_wanted);
        h = input().next(twin_index(h));
      } while(h != first);
    }
    const std::array<Loop, 2> result = {loop(m_closing[0]), loop(m_closing[1])};
    m_queue.clear();
    for(Vertex_index v : m_reached)
      m_labels[v] = Label();
    m_reached.clear();
    return result;
  }

private:
  struct Label
  {
    double distance = std::numeric_limits<double>::infinity();
    Input_halfedge_index incoming = null_index;
    Class_sums sums; // of the path
    bool is_settled = false;
  };

  const auto& input() const { return m_triangulation.input(); }
  double longest() const { return (std::max)(m_lengths[0], m_lengths[1]); }

  void reach(Vertex_index v, double distance, Input_halfedge_index incoming, const Class_sums& sums)
  {
    if(m_labels[v].distance == std::numeric_limits<double>::infinity())
      m_reached.push_back(v);
    m_labels[v] = {distance, incoming, sums, false};
    m_queue.push(distance, v);
  }

  template <class IsWanted>
  void pass(Vertex_index u, Input_halfedge_index h, const IsWanted& is_wanted)
  {
    const Vertex_index w = input().tail(twin_index(h));
    const double distance = m_labels[u].distance + m_triangulation.metric().weight(input(), h);
    Class_sums sums = m_labels[u].sums;
    sums.add(m_sums[edge_of(as_intrinsic(h))], !is_first_side(h));
    const Label& to = m_labels[w];
    if(!to.is_settled) {
      if(distance < to.distance)
        reach(w, distance, h, sums);
      return;
    }
    sums.add(to.sums, true);
    for(std::size_t side : {0, 1})
      if(sums.bounds(side) && distance + to.distance < m_lengths[side] && is_wanted(side, sums)) {
        m_lengths[side] = distance + to.distance;
        m_closing[side] = h;
      }
  }

  Loop loop(Input_halfedge_index h) const
  {
    if(h == null_index)
      return {};
    Loop out = path(input().tail(h)), back = path(input().tail(twin_index(h)));
    out.push_back(as_intrinsic(h));
    return closed_chain(out, back, common_start(out, back));
  }

  Loop path(Vertex_index v) const
  {
    Loop result;
    for(Input_halfedge_index h = m_labels[v].incoming; h != null_index; h = m_labels[input().tail(h)].incoming)
      result.push_back(as_intrinsic(h));
    std::reverse(result.begin(), result.end());
    return result;
  }

  Interruption* m_interruption; // null if it cannot be interrupted
  const Triangulation& m_triangulation;
  const Sums& m_sums;
  Indexed_by<Vertex_index, std::vector<Label>> m_labels;
  std::vector<Vertex_index> m_reached;
  Vertex_queue m_queue;
  std::array<double, 2> m_lengths;               // of the best loops
  std::array<Input_halfedge_index, 2> m_closing; // their edges that are in no path
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_BOUNDING_LOOP_SEARCH_H
