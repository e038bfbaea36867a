// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LABEL_SETTING_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LABEL_SETTING_SEARCH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/Slot_table.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * The labels of the vertices that a search has reached: the distance, the halfedge through which the path arrives, and
 * whether the vertex is settled. Only vertices that were once reached take memory. Neighbors share a cache line, which
 * holds the labels of four, in the order in which they were first written.
 *
 * A label contains the number of its search, so a new search clears all labels in constant time.
 *
 * \tparam Halfedge `Input_halfedge_index` or `Halfedge_index`
 */
template <class Halfedge>
class Search_labels
{
public:
  /* The label of one vertex. */
  struct Label
  {
    double distance;
    Index arrival;       // the halfedge through which the path arrives
    std::uint32_t stamp; // twice the number of the search, plus one if the vertex is settled

    /* Returns `null_index` at the source. */
    Halfedge incoming() const { return Halfedge(arrival); }
  };

  explicit Search_labels(std::size_t size)
    : m_size(size)
    , m_slots(size / block_size + 1)
    , m_blocks(new Block[m_slots.largest_number_of_slots()]) // uninitialized until they are used
  {
    m_blocks[0] = Block();
  }

  /* Clears all labels. */
  void clear()
  {
    m_stamp += 2;
    if(m_stamp == 0) // all numbers have been used
      *this = Search_labels(m_size);
  }

  /* Returns the label of a vertex, which is meaningful only if the vertex is reached. */
  const Label& operator[](Vertex_index v) const { return m_blocks[index(v)].labels[position(v)]; }

  bool is_settled(const Label& label) const { return label.stamp == m_stamp + 1; }
  /* \pre the vertex is not settled */
  bool is_reached(const Label& label) const { return label.stamp == m_stamp; }

  /* Labels a vertex, which becomes reached and not settled. */
  void reach(Vertex_index v, double distance, Halfedge incoming)
  {
    Index slot = m_slots[block(v)];
    if(slot == 0) {
      slot = m_slots.add(block(v));
      m_blocks[static_cast<std::size_t>(slot)] = Block();
    }
    m_blocks[static_cast<std::size_t>(slot)].labels[position(v)] = {distance, incoming.idx(), m_stamp};
  }

  /* \pre `v` is reached */
  void settle(Vertex_index v) { m_blocks[index(v)].labels[position(v)].stamp = m_stamp + 1; }

private:
  static constexpr std::uint32_t block_size = 4;

  struct alignas(64) Block
  {
    std::array<Label, block_size> labels;
  };
  static_assert(sizeof(Block) == 64, "a block must fill a cache line");
  static_assert(std::is_trivially_default_constructible<Block>::value,
                "the construction of a block must not write to it");

  static Index block(Vertex_index v) { return static_cast<Index>(static_cast<std::uint32_t>(v.idx()) / block_size); }
  static std::size_t position(Vertex_index v) { return static_cast<std::uint32_t>(v.idx()) % block_size; }

  std::size_t index(Vertex_index v) const { return static_cast<std::size_t>(m_slots[block(v)]); }

  std::size_t m_size;
  // Of blocks; the first one belongs to no search.
  Slot_table<1> m_slots;
  std::unique_ptr<Block[]> m_blocks;
  std::uint32_t m_stamp = 2;
};

/*
 * A queue of vertices by priority, the smallest first, and among equal priorities the smallest vertex. This is a total
 * order, so the result does not depend on the shape of the heap. Priorities are stored as integers, which compare
 * without branches.
 */
class Vertex_queue
{
public:
  bool empty() const { return m_heap.empty(); }
  void clear() { m_heap.clear(); }

  /* \pre priority >= 0 */
  void push(double priority, Vertex_index vertex)
  {
    CGAL_precondition(priority >= 0);
    m_heap.push({ordered_bits(priority), vertex});
  }

  /* Returns the priority of the first vertex. \pre not empty */
  double priority()
  {
    double result;
    std::memcpy(&result, &m_heap.top().key, sizeof result);
    return result;
  }

  /* Removes the first vertex. */
  Vertex_index pop()
  {
    const Vertex_index result = m_heap.top().vertex;
    m_heap.pop();
    return result;
  }

private:
  struct Entry
  {
    std::uint64_t key;
    Vertex_index vertex;

    // The branch is predictable, since equal keys are rare, and the other comparison is branch-free.
    static std::size_t is_before(const Entry& a, const Entry& b)
    {
      if(a.key == b.key)
        return a.vertex < b.vertex ? 1 : 0;
      return static_cast<std::size_t>(a.key < b.key);
    }
  };

  Heap_of_four<Entry> m_heap;
};

/*
 * The default members of a policy of `Label_setting_search`, which hides those that it defines itself. A policy plays
 * the role of a graph and a visitor of the Boost Graph Library. In addition to these members it has:
 *
 *     Origin origin(Vertex_index v, const Label& label);   the data common to all steps from the settled vertex v
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

  /* Returns whether a vertex whose label is replaced is moved forward in the queue. */
  template <class Step, class Label>
  bool is_put_forward(const Step&, const Label&) const
  {
    return true;
  }

  /* Is called after a vertex has been labeled, which is reached for the first time or again. */
  template <class Origin, class Halfedge>
  void reach(const Origin&, Halfedge, Vertex_index, bool /* is_first */) const
  {
  }

  /* Returns the key of a vertex in the queue: its distance, plus a lower bound on the remaining distance for A*. */
  template <class Step>
  double key(Vertex_index, const Step& step) const
  {
    return step.distance;
  }
};

/*
 * Dijkstra's algorithm and A* in one loop: the vertex with the least key is taken from the queue and settled, and its
 * neighbors are labeled. A policy determines everything else, see `Search_policy`: the graph, the lengths, the bounds,
 * the end of the search and its result. Of equal keys the smallest vertex is settled first, and of equally long paths
 * the first one found is kept, so results are deterministic.
 *
 * \tparam Labels a type such as `Search_labels`
 * \tparam Queue a type such as `Vertex_queue`
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

  /* Clears all labels. */
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

  /* Settles vertices; returns `false` if the policy's `settle()` has ended the search. */
  template <class Policy>
  bool run(Policy&& policy)
  {
    while(!m_queue.empty() && !policy.is_finished(m_queue)) {
      const Vertex_index v = m_queue.pop();
      if(m_labels.is_settled(m_labels[v]))
        continue; // it has been moved forward since this entry was made
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

  /* Returns the halfedges of the path to a vertex that is reached. `tail(h)` must return the vertex at which a halfedge
   * starts. */
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

/* The length of a halfedge of the input in the metric of a triangulation, for searches that do not touch the
 * triangulation. */
template <class Triangulation>
struct Metric_weight
{
  const Triangulation& triangulation;

  double operator()(Input_halfedge_index h) const { return triangulation.metric().weight(triangulation.input(), h); }
};

/* The common part of policies for searches along edges, whose labels consist of a distance only. */
struct Edge_policy : Search_policy
{
  struct Origin
  {
    Vertex_index vertex;
    double distance;
  };

  struct Step
  {
    double distance;
  };

  template <class Label>
  Origin origin(Vertex_index v, const Label& label) const
  {
    return {v, label.distance};
  }
};

/*
 * The policy of a search over the whole input mesh along its edges. Derived classes hide the members that differ.
 *
 * \tparam Weight `weight(h)` is the length of a halfedge, which is rejected unless it is zero or usable
 */
template <class Input_mesh, class Weight>
class Input_edge_policy : public Edge_policy
{
public:
  /* \param interruption null if the search cannot be interrupted */
  Input_edge_policy(const Input_mesh& input, const Weight& weight, Interruption* interruption)
    : m_input(input)
    , m_weight(weight)
    , m_interruption(interruption)
  {
  }

  /* \throws Interrupted */
  bool settle(Vertex_index) const
  {
    throw_if_interrupted(m_interruption);
    return true;
  }

  /* Visits clockwise, and continues along the border to the next umbrella. */
  template <class Function>
  void for_each_halfedge(const Origin& origin, const Function& function) const
  {
    for_each_outgoing_halfedge(m_input, origin.vertex, function);
  }

  Vertex_index head(Input_halfedge_index h) const { return m_input.tail(twin_index(h)); }

  Step step(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
  {
    return {origin.distance + length(origin, h, w)};
  }

  /* \throws Invalid_coordinate_error */
  double length(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
  {
    const double result = m_weight(h);
    if(!is_zero_or_usable_length(result))
      throw_unusable_length(result, origin.vertex, w);
    return result;
  }

private:
  const Input_mesh& m_input;
  Weight m_weight;
  Interruption* m_interruption;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LABEL_SETTING_SEARCH_H
