// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_BOUNDING_LOOP_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_BOUNDING_LOOP_SEARCH_H

#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Loop_search.h>

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
 * behind the surface or in front of it: one of either kind, of those that are wanted. The search ends where longer ones
 * begin, or when many vertices were reached.
 */
template <class Triangulation>
class Bounding_loop_search
{
public:
  using Sums = Indexed_by<Edge_index, std::vector<Class_sums>>;
  using Loop = std::vector<Halfedge_index>;

  /* `sums` are those of the first sides of edges; searches can be stopped. */
  Bounding_loop_search(const Triangulation& triangulation, const Sums& sums, Interruption* interruption)
    : m_sums(sums)
    , m_search(triangulation, interruption)
  {
  }

  /* The loops of which `is_wanted(side, sums)` holds, empty where none was found among `most` vertices; without a way
   * that is passed out and back. \throws Interrupted */
  template <class IsWanted>
  std::array<Loop, 2> operator()(Vertex_index root, std::size_t most, const IsWanted& is_wanted)
  {
    Policy<IsWanted> policy(m_search, m_sums, most, is_wanted);
    m_search.run(root, Class_sums(), policy);
    return {loop(policy.closing(0)), loop(policy.closing(1))};
  }

private:
  using Search = Loop_search<Triangulation, Class_sums>;

  // Keeps the edges that close the best loops of either kind.
  template <class IsWanted>
  class Policy : public Search::template Policy<Policy<IsWanted>>
  {
    using Base = typename Search::template Policy<Policy<IsWanted>>;

  public:
    Policy(Search& search, const Sums& sums, std::size_t most, const IsWanted& is_wanted)
      : Base(search)
      , m_sums(sums)
      , m_most(most)
      , m_is_wanted(is_wanted)
    {
      m_lengths.fill(std::numeric_limits<double>::infinity());
      m_closing.fill(null_index);
    }

    Input_halfedge_index closing(std::size_t side) const { return m_closing[side]; }

    template <class Queue>
    bool is_finished(Queue& queue) const
    {
      return m_number_of_reached >= m_most || !(2 * queue.priority() < (std::max)(m_lengths[0], m_lengths[1]));
    }

    Class_sums extended(Class_sums path, Input_halfedge_index h) const
    {
      return path.add(m_sums[edge_of(as_intrinsic(h))], !is_first_side(h));
    }

    void reach(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w, bool is_first)
    {
      Base::reach(origin, h, w, is_first);
      m_number_of_reached += is_first ? 1 : 0;
    }

    void meet(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w)
    {
      const double length = this->length_of_loop(origin, h, w);
      const Class_sums sums = this->class_over(origin, h).add(this->class_of_path(w), true);
      for(std::size_t side : {0, 1})
        if(sums.bounds(side) && length < m_lengths[side] && m_is_wanted(side, sums)) {
          m_lengths[side] = length;
          m_closing[side] = h;
        }
    }

  private:
    const Sums& m_sums;
    std::size_t m_most, m_number_of_reached = 1; // the root
    const IsWanted& m_is_wanted;
    std::array<double, 2> m_lengths;               // of the best loops
    std::array<Input_halfedge_index, 2> m_closing; // their edges that are in no path
  };

  Loop loop(Input_halfedge_index h) const
  {
    if(h == null_index)
      return {};
    const auto [out, back] = m_search.legs(h);
    return closed_chain(out, back, common_start(out, back));
  }

  const Sums& m_sums;
  Search m_search;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_BOUNDING_LOOP_SEARCH_H
