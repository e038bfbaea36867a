// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SHORTEST_LOOP_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SHORTEST_LOOP_SEARCH_H

#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Loop_search.h>
#include <CGAL/Flip_geodesics/internal/topology/Reduced_words.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The shortest loop along edges that passes one of some vertices and is of a certain kind.
 *
 * Each search leaves out the vertices whose loops were searched before. The class of a path is its word, reduced as far
 * as it cancels: the loop of an edge between two ends whose words differ by that of the edge contracts, and only others
 * are looked at.
 */
template <class Triangulation>
class Shortest_loop_search
{
public:
  Shortest_loop_search(const Triangulation& triangulation, const Generator_words& words, Interruption* interruption)
    : m_words(words)
    , m_search(triangulation, interruption)
    , m_is_left_out(static_cast<std::size_t>(triangulation.input().number_of_vertices()), 0)
  {
  }

  /* Looks for a shorter loop through v, and through no vertex asked about before, whose word has a property.
   * \throws Interrupted */
  template <class IsWanted>
  void search(Vertex_index v, const IsWanted& is_wanted)
  {
    m_reduced_words.clear();
    Policy<IsWanted> policy(*this, is_wanted);
    m_search.run(v, Reduced_words::empty_word, policy);
    if(policy.closing() != null_index) {
      const auto [out, back] = m_search.legs(policy.closing());
      m_loop = closed_chain(out, back, 0);
    }
    m_is_left_out[v] = 1;
  }

  /* What was found: a chain from the vertex back to it; empty if there is none. */
  const std::vector<Halfedge_index>& loop() const { return m_loop; }

private:
  using Search = Loop_search<Triangulation, Reduced_words::Word>;

  // Keeps the edge that closes the best loop, if it is shorter than those of other vertices.
  template <class IsWanted>
  class Policy : public Search::template Policy<Policy<IsWanted>>
  {
    using Base = typename Search::template Policy<Policy<IsWanted>>;

  public:
    Policy(Shortest_loop_search& loops, const IsWanted& is_wanted)
      : Base(loops.m_search)
      , m_loops(loops)
      , m_is_wanted(is_wanted)
    {
    }

    Input_halfedge_index closing() const { return m_closing; }

    template <class Queue>
    bool is_finished(Queue& queue) const
    {
      return !(2 * queue.priority() < m_loops.m_length);
    }

    template <class Function>
    void for_each_halfedge(const typename Base::Origin& origin, const Function& function) const
    {
      Base::for_each_halfedge(origin, [&](Input_halfedge_index h) {
        if(m_loops.m_is_left_out[this->head(h)] == 0)
          function(h);
      });
    }

    Reduced_words::Word extended(Reduced_words::Word path, Input_halfedge_index h) const
    {
      m_loops.m_words.for_each_letter(h, [&](Letter letter) { path = m_loops.m_reduced_words.appended(path, letter); });
      return path;
    }

    void meet(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w)
    {
      const double length = this->length_of_loop(origin, h, w);
      if(!(length < m_loops.m_length))
        return;
      const Reduced_words::Word word = this->class_over(origin, h), other = this->class_of_path(w);
      if(word == other || !m_is_wanted(m_loops.m_reduced_words.quotient(word, other)))
        return;
      m_loops.m_length = length;
      m_closing = h;
    }

  private:
    Shortest_loop_search& m_loops;
    const IsWanted& m_is_wanted;
    Input_halfedge_index m_closing = null_index;
  };

  const Generator_words& m_words;
  Search m_search;
  Indexed_by<Vertex_index, std::vector<char>> m_is_left_out;
  Reduced_words m_reduced_words;
  std::vector<Halfedge_index> m_loop;
  double m_length = std::numeric_limits<double>::infinity(); // of the best loop
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SHORTEST_LOOP_SEARCH_H
