// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SHORTEST_LOOP_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SHORTEST_LOOP_SEARCH_H

#include <CGAL/Flip_geodesics/internal/distances/Vertex_queue.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Reduced_words.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The shortest loop along edges that passes one of some vertices and is of a certain kind.
 *
 * Through one vertex, it is the loop of an edge: a shortest path to either end, and the edge [Erickson, Har-Peled 2004].
 * Both ends are nearer than half of its length. So each search ends at half of the best length so far, and leaves out
 * the vertices whose loops were searched before. The word of a path is kept at its end, reduced as far as it cancels: the
 * loop of an edge between two ends whose words differ by that of the edge contracts, and only others are looked at.
 */
template <class Triangulation>
class Shortest_loop_search
{
public:
  Shortest_loop_search(const Triangulation& triangulation, const Generator_words& words, Interruption* interruption)
    : m_interruption(interruption)
    , m_triangulation(triangulation)
    , m_words(words)
    , m_labels(static_cast<std::size_t>(input().number_of_vertices()))
  {
  }

  /* Looks for a shorter loop through v, and through no vertex asked about before, whose word has a property.
   * \throws Interrupted */
  template <class IsWanted>
  void search(Vertex_index v, const IsWanted& is_wanted)
  {
    Input_halfedge_index best = null_index;
    m_reduced_words.clear();
    reach(v, 0, null_index, Reduced_words::empty_word);
    while(!m_queue.empty() && 2 * m_queue.priority() < m_length) {
      const Vertex_index u = m_queue.pop();
      if(m_labels[u].is_settled)
        continue;
      throw_if_interrupted(m_interruption);
      m_labels[u].is_settled = true;
      const Input_halfedge_index first = input().outgoing(u);
      Input_halfedge_index h = first;
      do {
        if(pass(u, h, is_wanted))
          best = h;
        h = input().next(twin_index(h));
      } while(h != first);
    }
    if(best != null_index)
      store_loop(best);
    forget();
    m_labels[v].is_left_out = true;
  }

  /* What was found: a chain from the vertex back to it; empty if there is none. */
  const std::vector<Halfedge_index>& loop() const { return m_loop; }

private:
  struct Label
  {
    double distance = std::numeric_limits<double>::infinity();
    Input_halfedge_index incoming = null_index;
    Reduced_words::Word word = Reduced_words::empty_word; // of the path
    bool is_settled = false, is_left_out = false;
  };

  const auto& input() const { return m_triangulation.input(); }

  void reach(Vertex_index v, double distance, Input_halfedge_index incoming, Reduced_words::Word word)
  {
    if(m_labels[v].incoming == null_index)
      m_reached.push_back(v);
    m_labels[v].distance = distance;
    m_labels[v].incoming = incoming;
    m_labels[v].word = word;
    m_queue.push(distance, v);
  }

  // Goes on over a halfedge from a settled vertex. Does it close the best loop so far?
  template <class IsWanted>
  bool pass(Vertex_index u, Input_halfedge_index h, const IsWanted& is_wanted)
  {
    const Vertex_index w = input().tail(twin_index(h));
    const double weight = m_triangulation.metric().weight(input(), h);
    if(!is_zero_or_usable_length(weight))
      throw_unusable_length(weight, u, w);
    const Label& from = m_labels[u];
    const Label& to = m_labels[w];
    const double distance = from.distance + weight;
    if(to.is_left_out || (to.is_settled && !(distance + to.distance < m_length)) ||
       (!to.is_settled && !(distance < to.distance)))
      return false;
    Reduced_words::Word word = from.word;
    m_words.for_each_letter(h, [&](Letter letter) { word = m_reduced_words.appended(word, letter); });
    if(!to.is_settled) {
      reach(w, distance, h, word);
      return false;
    }
    if(word == to.word || !is_wanted(m_reduced_words.quotient(word, to.word)))
      return false;
    m_length = distance + to.distance;
    return true;
  }

  void store_loop(Input_halfedge_index h)
  {
    m_loop.clear();
    for(Input_halfedge_index g = h; g != null_index; g = m_labels[input().tail(g)].incoming)
      m_loop.push_back(as_intrinsic(g));
    std::reverse(m_loop.begin(), m_loop.end());
    for(Input_halfedge_index g = m_labels[input().tail(twin_index(h))].incoming; g != null_index;
        g = m_labels[input().tail(g)].incoming)
      m_loop.push_back(as_intrinsic(twin_index(g)));
  }

  void forget()
  {
    m_queue.clear();
    for(Vertex_index v : m_reached) {
      const bool is_left_out = m_labels[v].is_left_out;
      m_labels[v] = Label();
      m_labels[v].is_left_out = is_left_out;
    }
    m_reached.clear();
  }

  Interruption* m_interruption; // null if it cannot be interrupted
  const Triangulation& m_triangulation;
  const Generator_words& m_words;
  Indexed_by<Vertex_index, std::vector<Label>> m_labels;
  std::vector<Vertex_index> m_reached;
  Vertex_queue m_queue;
  Reduced_words m_reduced_words;
  std::vector<Halfedge_index> m_loop;
  double m_length = std::numeric_limits<double>::infinity(); // of the best loop
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_SHORTEST_LOOP_SEARCH_H
