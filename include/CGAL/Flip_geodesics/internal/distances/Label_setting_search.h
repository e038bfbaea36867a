// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LABEL_SETTING_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LABEL_SETTING_SEARCH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Search_labels.h>
#include <CGAL/Flip_geodesics/internal/distances/Vertex_queue.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The default members of a policy of `Label_setting_search`, which hides those that it defines itself. A policy plays
 * the role of a graph and a visitor of the Boost Graph Library. Besides these members it has:
 *
 *     Origin origin(Vertex_index v, const Label& label);   what all steps from the settled vertex v need
 *     void for_each_halfedge(const Origin&, Function f);   calls f(h) for the halfedges along which v is left
 *     Vertex_index head(Halfedge h);
 *     Step step(const Origin&, Halfedge h, Vertex_index w); the step along h to w; `Step` has a member `distance`,
 *                                                          the distance of w on the path by way of v
 */
struct Search_policy
{
  /* Returns whether the search ends before it settles the first vertex of the queue, which is not empty. */
  template <class Queue>
  bool is_finished(Queue&) const
  {
    return false;
  }

  /* Is called for each vertex when it is settled; the search ends there if it returns `false`. */
  bool settle(Vertex_index) const { return true; }

  /* Is called for each step to a vertex that is settled. */
  template <class Origin, class Halfedge>
  void meet(const Origin&, Halfedge, Vertex_index) const
  {
  }

  /* Returns whether a step replaces the label of a vertex that is reached. */
  template <class Step, class Label>
  bool is_better(const Step& step, const Label& label) const
  {
    return step.distance < label.distance;
  }

  /* Returns whether a vertex whose label is replaced is put forward in the queue. */
  template <class Step, class Label>
  bool is_put_forward(const Step&, const Label&) const
  {
    return true;
  }

  /* Is called after a vertex has been labelled, which is reached for the first time or again. */
  template <class Origin, class Halfedge>
  void reach(const Origin&, Halfedge, Vertex_index, bool /* is_first */) const
  {
  }

  /* Returns the key of a vertex in the queue: its distance, and for A* a lower bound of the remaining distance more. */
  template <class Step>
  double key(Vertex_index, const Step& step) const
  {
    return step.distance;
  }
};

/*
 * Dijkstra's algorithm and A*, in one loop: the vertex with the least key is taken from the queue and settled, and its
 * neighbors are labelled. Everything else is up to a policy, see `Search_policy`: the graph, the lengths, the bounds,
 * the end of the search and its result. Of equal keys the smallest vertex is settled first, and of equally long paths
 * the one that is found first stays, so that results are deterministic.
 *
 * \tparam Labels as `Search_labels`
 * \tparam Queue as `Vertex_queue`
 */
template <class Labels, class Queue = Vertex_queue>
class Label_setting_search
{
public:
  using Label = typename Labels::Label;

  explicit Label_setting_search(std::size_t number_of_vertices)
    : m_labels(number_of_vertices)
  {
  }

  /* Forgets all labels. */
  void clear()
  {
    m_labels.clear();
    m_queue.clear();
    m_number_of_settled = 0;
  }

  /* Adds a vertex from which paths start. */
  void add_source(Vertex_index v, double key = 0)
  {
    m_labels.reach(v, 0, null_index);
    m_queue.push(key, v);
  }

  /* Settles vertices; returns `false` if the policy has ended that by its `settle()`. */
  template <class Policy>
  bool run(Policy&& policy)
  {
    while(!m_queue.empty() && !policy.is_finished(m_queue)) {
      const Vertex_index v = m_queue.pop();
      if(m_labels.is_settled(m_labels[v]))
        continue; // it has been put forward since this entry was made
      m_labels.settle(v);
      ++m_number_of_settled;
      if(!policy.settle(v))
        return false;
      const auto origin = policy.origin(v, m_labels[v]);
      policy.for_each_halfedge(origin, [&](auto h) { relax(policy, origin, h); });
    }
    return true;
  }

  const Labels& labels() const { return m_labels; }
  const Label& operator[](Vertex_index v) const { return m_labels[v]; }
  std::size_t number_of_settled() const { return m_number_of_settled; }

  /* The halfedges of the path to a vertex that is reached. `tail(h)` is the vertex at which a halfedge starts. */
  template <class Halfedge, class Tail>
  std::vector<Halfedge> path(Vertex_index v, const Tail& tail) const
  {
    std::vector<Halfedge> result;
    for(auto h = m_labels[v].incoming(); h != null_index; h = m_labels[tail(h)].incoming())
      result.push_back(Halfedge(h.idx()));
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  template <class Policy, class Origin, class Halfedge>
  void relax(Policy& policy, const Origin& origin, Halfedge h)
  {
    const Vertex_index w = policy.head(h);
    const Label& label = m_labels[w];
    if(m_labels.is_settled(label)) {
      policy.meet(origin, h, w);
      return;
    }
    const auto step = policy.step(origin, h, w);
    const bool is_first = !m_labels.is_reached(label);
    if(!is_first && !policy.is_better(step, label))
      return;
    const bool is_queued = is_first || policy.is_put_forward(step, label);
    m_labels.reach(w, step.distance, h);
    policy.reach(origin, h, w, is_first);
    if(is_queued)
      m_queue.push(policy.key(w, step), w);
  }

  Labels m_labels;
  Queue m_queue;
  std::size_t m_number_of_settled = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LABEL_SETTING_SEARCH_H
