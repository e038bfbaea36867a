// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CROSSING_REMOVAL_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CROSSING_REMOVAL_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* An edge that a straight segment from vertex to vertex crosses, and its left end. */
struct Crossed_edge
{
  Halfedge_index halfedge; // as a side of the face that is left, with its tail on the right
  bool is_left_new;        // is the left end not one of the edge before? of the first edge it is new
  double left_height;      // how far the left end is from the segment, in any unit
};

/*
 * Flips the edges that a segment crosses until it is an edge itself; a flip takes an edge out of the strip of crossed
 * faces, or moves it down to a lower vertex.
 *
 * The vertices on the left of the segment are taken from the strip one after the other, each when the two beside it are
 * no higher. So it has an angle below pi, and what is to the right of it lies beyond the line through the two. Of its
 * edges, first those are flipped that leave the strip; then the ends of those on the right form a chain that bends
 * towards it, and the outermost edges can be flipped; and the last one leaves.
 *
 *           v                      v
 *        / /|\ \                 /   \           u, w: the vertices beside v, no higher
 *      u  / | \  w     ->      u-------w
 *     --/---|---\----         -----------        the segment
 *      a    b    c            a    b    c
 *
 * That takes one to two flips for each edge, most often. But where the right side bends towards the left, as along a
 * ring of a thousand faces, most edges go from each vertex on to the next. So if there are many flips, they are taken
 * back, and the other order has its turn: on both sides of the strip and from its ends, all edges are flipped that leave
 * it at once; and only when none is left, the highest vertex on the left is taken.
 */
template <class Triangulation>
class Crossing_removal
{
public:
  /* Gives up when the triangulation's records take more memory than that, in bytes. */
  Crossing_removal(Triangulation& triangulation, std::size_t most_memory)
    : m_triangulation(triangulation)
    , m_most_memory(most_memory)
  {
  }

  /*
   * Flips. Returns whether all edges have been where they should, as they are not if the strip has a face twice; false
   * as well if it has given up.
   * \pre the strip's faces are the input's
   */
  bool operator()(const std::vector<Crossed_edge>& crossed)
  {
    const auto position = m_triangulation.log_position();
    m_most_flips = few_flips + flips_per_crossing * crossed.size();
    start(crossed);
    for(Index i = 0; i < m_end && !are_flips_many(); ++i)
      if(crossed[static_cast<std::size_t>(i)].is_left_new) {
        take_higher_ones(crossed[static_cast<std::size_t>(i)].left_height, i);
        m_left_side.push_back(i);
      }
    take_higher_ones(0, m_end);
    if(are_flips_many() && !m_has_given_up) {
      m_triangulation.rollback(position);
      start(crossed);
      flip_leaving_ones_first();
    }
    return !m_is_torn && !m_has_given_up;
  }

  /* With those that were taken back. */
  std::size_t number_of_flips() const { return m_flips; }

  /* The edges that the segment still crosses; none but where it passes a vertex, up to rounding. */
  std::vector<Halfedge_index> crossed() const
  {
    std::vector<Halfedge_index> result;
    for(Index i = node(m_end).next; i != m_end; i = node(i).next)
      result.push_back(node(i).halfedge);
    return result;
  }

  /* The halfedge that is the segment. \pre it crosses nothing any more */
  Halfedge_index segment() const { return m_segment; }

private:
  // With so many flips, another order is better.
  static constexpr std::size_t few_flips = 4000, flips_per_crossing = 8;

  // An edge that is crossed. Left vertices are told by the edge at which they were new.
  struct Node
  {
    Halfedge_index halfedge; // null_index when it is not crossed any more
    Index previous, next, left;
    bool is_left_new;
    double left_height;
  };

  Node& node(Index i) { return m_nodes[static_cast<std::size_t>(i)]; }
  const Node& node(Index i) const { return m_nodes[static_cast<std::size_t>(i)]; }

  // The list of the edges closes to a ring at m_end.
  void start(const std::vector<Crossed_edge>& crossed)
  {
    m_end = static_cast<Index>(crossed.size());
    m_left_side.clear();
    m_nodes.clear();
    m_nodes.reserve(crossed.size() + 1);
    Index left = 0;
    for(Index i = 0; i < m_end; ++i) {
      const Crossed_edge& c = crossed[static_cast<std::size_t>(i)];
      left = c.is_left_new ? i : left;
      m_nodes.push_back({c.halfedge, i == 0 ? m_end : i - 1, i + 1, left, c.is_left_new, c.left_height});
    }
    m_nodes.push_back({null_index, m_end - 1, 0, null_index, false, 0});
    m_tail = apex(crossed.front().halfedge);
    m_head = apex(Triangulation::twin(crossed.back().halfedge));
  }

  // Takes the vertices before the one at which `next` is the first crossed edge from the strip, as far as they are as
  // high. Some stay where rounding is as large as the heights.
  void take_higher_ones(double height, Index next)
  {
    while(!m_left_side.empty() && node(m_left_side.back()).left_height >= height) {
      if(has_given_up() || are_flips_many() || !take(m_left_side.back(), next))
        return;
      m_left_side.pop_back();
    }
  }

  bool has_given_up()
  {
    m_has_given_up = m_has_given_up || m_triangulation.memory_of_records() > m_most_memory;
    return m_has_given_up;
  }

  bool are_flips_many() const { return m_flips > m_most_flips; }

  // Flips all edges that can leave the strip; takes the highest vertex on the left if there is none; and so on.
  void flip_leaving_ones_first()
  {
    for(Index i = m_end; i-- > 0;)
      m_waiting.push_back(i);
    for(;;) {
      flip_waiting_ones();
      if(m_is_torn || has_given_up() || node(m_end).next == m_end)
        return;
      Index next = after_highest_one();
      const Index v = node(node(next).previous).left;
      Index before = node(next).previous;
      while(before != m_end && node(before).left == v)
        before = node(before).previous;
      if(!take(v, next))
        return;
      const Index last = next == m_end ? m_end : node(next).next;
      for(Index i = before == m_end ? node(m_end).next : before; i != last; i = node(i).next)
        m_waiting.push_back(i);
    }
  }

  // Flips those of the edges in m_waiting that can leave, and the edges beside them when they can.
  void flip_waiting_ones()
  {
    while(!m_waiting.empty()) {
      const Index i = m_waiting.back();
      m_waiting.pop_back();
      if(node(i).halfedge == null_index || !is_leaving(i) || !is_flippable(i))
        continue;
      const Index before = node(i).previous, after = node(i).next;
      flip_away(i);
      for(Index beside : {before, after})
        if(beside != m_end)
          m_waiting.push_back(beside);
    }
  }

  // The first edge, or m_end, after those at the highest vertex on the left.
  Index after_highest_one() const
  {
    const auto height = [&](Index i) { return node(node(i).left).left_height; };
    Index highest = node(m_end).next;
    for(Index i = highest; i != m_end; i = node(i).next)
      if(height(i) >= height(highest))
        highest = i;
    return node(highest).next;
  }

  // Flips all crossed edges at left vertex v away.
  bool take(Index v, Index& next)
  {
    Index last = node(next).previous;
    const Index first = flip_leaving_ones(v, last);
    return last == m_end || node(last).left != v || flip_outermost_ones(first, last, next);
  }

  // Returns the first edge at v that is left.
  Index flip_leaving_ones(Index v, Index& last)
  {
    Index first = last;
    for(Index i = last; i != m_end && node(i).left == v;) {
      if(!is_leaving(i) || !is_flippable(i)) {
        first = i;
        i = node(i).previous;
        continue;
      }
      const Index before = node(i).previous, after = node(i).next;
      flip_away(i);
      const bool was_last = i == last;
      last = was_last ? before : last;
      i = was_last ? before : after;
    }
    return first;
  }

  // Of the edges at a vertex, from `first` to `last`, before the edge `next`, which is at the vertex beside it.
  bool flip_outermost_ones(Index first, Index last, Index& next)
  {
    for(;;) {
      const Index i = is_flippable(last) ? last : first;
      if(i == first && !is_flippable(first))
        return false;
      const Index before = node(i).previous, after = node(i).next;
      if(is_leaving(i)) {
        flip_away(i);
      } else {
        flip_over(i);
        next = i == last ? i : next;
      }
      if(first == last)
        return true;
      if(i == last)
        last = before;
      else
        first = after;
    }
  }

  // Does the edge leave the strip if it is flipped: are the corners opposite to it on one side, or an end of the
  // segment?
  bool is_leaving(Index i) const
  {
    const Node& n = node(i);
    return n.previous == m_end || n.next == m_end || n.is_left_new == node(n.next).is_left_new;
  }

  bool is_flippable(Index i)
  {
    const Halfedge_index h = node(i).halfedge;
    m_is_torn = m_is_torn || !is_in_place(i);
    const auto is_reflex_at_head = [&](Halfedge_index g) {
      return m_triangulation.is_reflex_at_head(m_triangulation.walker(g));
    };
    return !m_is_torn && !is_reflex_at_head(Triangulation::twin(h)) && !is_reflex_at_head(h);
  }

  // Are the faces beside an edge those of the strip?
  bool is_in_place(Index i) const
  {
    const Node& n = node(i);
    return (n.previous == m_end ? apex(n.halfedge) == m_tail : follows(i, n.previous)) &&
           (n.next == m_end ? apex(Triangulation::twin(n.halfedge)) == m_head : follows(n.next, i));
  }

  bool follows(Index i, Index before) const
  {
    const Halfedge_index right_side = m_triangulation.next(Triangulation::twin(node(before).halfedge));
    return node(i).halfedge == (node(i).is_left_new ? right_side : m_triangulation.next(right_side));
  }

  Vertex_index apex(Halfedge_index h) const { return m_triangulation.head(m_triangulation.next(h)); }

  void flip_away(Index i)
  {
    Node& n = node(i);
    flip(n.halfedge);
    m_segment = Triangulation::twin(n.halfedge); // if it is the last: a flipped halfedge leads backwards
    n.halfedge = null_index;
    node(n.previous).next = n.next;
    node(n.next).previous = n.previous;
  }

  void flip_over(Index i)
  {
    Node &n = node(i), &after = node(n.next);
    flip(n.halfedge);
    if(!n.is_left_new)
      n.halfedge = Triangulation::twin(n.halfedge);
    std::swap(n.is_left_new, after.is_left_new);
    n.left = n.is_left_new ? after.left : node(n.previous).left;
  }

  void flip(Halfedge_index h)
  {
    m_triangulation.flip(h);
    ++m_flips;
  }

  Triangulation& m_triangulation;
  std::size_t m_most_memory;
  std::vector<Node> m_nodes;
  std::vector<Index> m_left_side; // the left vertices so far that are still in the strip
  Index m_end = 0;
  Vertex_index m_tail, m_head;
  Halfedge_index m_segment;
  std::vector<Index> m_waiting; // edges to be looked at
  std::size_t m_flips = 0, m_most_flips = 0;
  bool m_is_torn = false, m_has_given_up = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CROSSING_REMOVAL_H
