// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SEGMENT_INSERTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SEGMENT_INSERTION_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/flip_out/flip_out_wedge.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* An edge crossed by a straight segment from vertex to vertex, and its left end. */
struct Crossed_edge
{
  Halfedge_index halfedge; // a side of the face that the segment leaves, with its tail on the right
  bool is_left_new;        // whether the left end differs from that of the previous edge; true for the first edge
  double left_height;      // the distance of the left end from the segment, in any unit
};

/*
 * Flips the edges crossed by a segment until the segment is itself an edge. A flip removes an edge from the strip of
 * crossed faces if the corners opposite to the edge are on one side of the segment. Otherwise the flipped edge crosses
 * the segment as well.
 *
 * First all edges that leave the strip immediately are flipped, from both ends of the strip and on both of its sides.
 * When none is left, the highest vertex on the left of the segment is removed from the strip, of equally high ones the
 * last, then the next highest, and so on. One of its neighbors is then lower. Its angle in the strip is below pi, and
 * everything to the right of it lies beyond the line through its two
 * neighbors on the strip's boundary, which are not higher. The right ends of its edges therefore form a chain that
 * bends towards it, and the outermost edges can be flipped until the last one leaves.
 *
 *           v                      v
 *        / /|\ \                 /   \           u, w: the vertices beside v, not higher
 *      u  / | \  w     ->      u-------w
 *     --/---|---\----         -----------        the segment
 *      a    b    c            a    b    c
 *
 * On most surfaces this takes fewer than 1.4 flips per edge.
 */
template <class Triangulation>
class Crossing_removal
{
public:
  /* Aborts when the records of the triangulation exceed `most_memory` bytes. */
  Crossing_removal(Triangulation& triangulation, std::size_t most_memory)
    : m_triangulation(triangulation)
    , m_most_memory(most_memory)
  {
  }

  /*
   * Flips the edges. Returns whether all edges were in their expected places, which fails if the strip contains a face
   * twice; also returns false if the computation was aborted.
   * \pre the strip's faces are the input's
   */
  bool operator()(const std::vector<Crossed_edge>& crossed)
  {
    start(crossed);
    m_waiting.reserve(crossed.size());
    for(Index i = m_end; i-- > 0;)
      m_waiting.push_back(i);
    flip_waiting_ones();
    for(const auto& [height, v] : left_vertices_from_above()) {
      if(m_is_torn || m_has_given_up || (is_in_strip(v) && !take(v)))
        break;
      flip_waiting_ones();
    }
    return !m_is_torn && !m_has_given_up;
  }

  std::size_t number_of_flips() const { return m_flips; }

  /* Returns the edges that the segment still crosses; up to rounding errors, there are none unless it passes a
   * vertex. */
  std::vector<Halfedge_index> crossed() const
  {
    std::vector<Halfedge_index> result;
    for(Index i = node(m_end).next; i != m_end; i = node(i).next)
      result.push_back(node(i).halfedge);
    return result;
  }

  /* Returns the halfedge that is the segment. \pre it crosses no edge */
  Halfedge_index segment() const { return m_segment; }

private:
  // A crossed edge. Left vertices are identified by the edge at which they were new.
  struct Node
  {
    Halfedge_index halfedge; // null_index when it is no longer crossed
    Index previous, next, left;
    bool is_left_new;
    double left_height;
  };

  Node& node(Index i) { return m_nodes[static_cast<std::size_t>(i)]; }
  const Node& node(Index i) const { return m_nodes[static_cast<std::size_t>(i)]; }

  // The list of the edges is a ring through m_end.
  void start(const std::vector<Crossed_edge>& crossed)
  {
    m_end = static_cast<Index>(crossed.size());
    m_last_at.assign(crossed.size(), m_end);
    m_nodes.clear();
    m_nodes.reserve(crossed.size() + 1);
    Index left = 0;
    for(Index i = 0; i < m_end; ++i) {
      const Crossed_edge& c = crossed[static_cast<std::size_t>(i)];
      left = c.is_left_new ? i : left;
      m_nodes.push_back({c.halfedge, i == 0 ? m_end : i - 1, i + 1, left, c.is_left_new, c.left_height});
      last_at(left) = i;
    }
    m_nodes.push_back({null_index, m_end - 1, 0, null_index, false, 0});
    m_tail = apex(crossed.front().halfedge);
    m_head = apex(Triangulation::twin(crossed.back().halfedge));
  }

  // The last edge at a vertex on the left; m_end if the vertex is no longer in the strip.
  Index& last_at(Index v) { return m_last_at[static_cast<std::size_t>(v)]; }
  bool is_in_strip(Index v) const { return m_last_at[static_cast<std::size_t>(v)] != m_end; }

  // Returns the left vertices in the strip by decreasing height; of equal heights the last one comes first.
  std::vector<std::pair<double, Index>> left_vertices_from_above() const
  {
    std::vector<std::pair<double, Index>> result;
    for(Index i = node(m_end).next; i != m_end; i = node(i).next)
      if(i == m_last_at[static_cast<std::size_t>(node(i).left)]) {
        const double height = node(node(i).left).left_height; // NaN if products of large coordinates overflow
        result.push_back({std::isnan(height) ? 0 : height, node(i).left});
      }
    std::sort(result.rbegin(), result.rend());
    return result;
  }

  // Flips the edges in m_waiting that can leave the strip, and then the edges beside them if possible.
  void flip_waiting_ones()
  {
    while(!m_waiting.empty() && !m_has_given_up) {
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

  // Flips all crossed edges at left vertex v away, the outermost ones first, and appends the edges from the one before
  // them to the one after them to m_waiting. Returns false if neither outermost edge can be flipped, which happens when
  // rounding errors are as large as heights.
  bool take(Index v)
  {
    Index last = last_at(v), first = last;
    while(node(first).previous != m_end && node(node(first).previous).left == v)
      first = node(first).previous;
    const Index before = node(first).previous, after = node(last).next;
    while(is_in_strip(v) && !m_has_given_up) {
      const bool is_at_last = is_flippable(last);
      if(!is_at_last && !is_flippable(first))
        return false;
      const Index i = is_at_last ? last : first, previous = node(i).previous, next = node(i).next;
      if(is_leaving(i))
        flip_away(i);
      else
        flip_over(i);
      last = is_at_last ? previous : last;
      first = is_at_last ? first : next;
    }
    wait(before == m_end ? node(m_end).next : before, after);
    return true;
  }

  // Appends the edges from `first` to `last`, or up to the end of the strip if that is m_end, to m_waiting.
  void wait(Index first, Index last)
  {
    for(Index i = first; i != m_end; i = node(i).next) {
      m_waiting.push_back(i);
      if(i == last)
        break;
    }
  }

  // Returns whether a flip removes the edge from the strip, that is, whether the corners opposite to it are on one side
  // or one of them is an end of the segment.
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

  // Returns whether the faces beside an edge are those of the strip.
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
    m_segment = Triangulation::twin(n.halfedge); // used if it is the last one: a flipped halfedge leads backwards
    leave_left_vertex(i);
    n.halfedge = null_index;
    node(n.previous).next = n.next;
    node(n.next).previous = n.previous;
  }

  void flip_over(Index i)
  {
    Node &n = node(i), &after = node(n.next);
    flip(n.halfedge);
    leave_left_vertex(i);
    if(!n.is_left_new)
      n.halfedge = Triangulation::twin(n.halfedge);
    std::swap(n.is_left_new, after.is_left_new);
    n.left = n.is_left_new ? after.left : node(n.previous).left;
    if(!n.is_left_new)
      last_at(n.left) = i;
  }

  void leave_left_vertex(Index i)
  {
    const Node& n = node(i);
    if(last_at(n.left) == i)
      last_at(n.left) = n.previous != m_end && node(n.previous).left == n.left ? n.previous : m_end;
  }

  void flip(Halfedge_index h)
  {
    m_triangulation.flip(h);
    ++m_flips;
    m_has_given_up = m_triangulation.memory_of_records() > m_most_memory;
  }

  Triangulation& m_triangulation;
  std::size_t m_most_memory;
  std::vector<Node> m_nodes;
  std::vector<Index> m_last_at;
  Index m_end = 0;
  Vertex_index m_tail, m_head;
  Halfedge_index m_segment;
  std::vector<Index> m_waiting; // edges to be examined
  std::size_t m_flips = 0;
  bool m_is_torn = false, m_has_given_up = false;
};

/*
 * Returns the left side of the strip of faces along which the given halfedges are crossed, each given as a side of the
 * face that is left: a chain of halfedges from the vertex at which the strip starts to that at which it ends.
 *
 *            __ left __ . __
 *     start /  |  \   /  \   \ end        the chain runs above; the crossed edges lie in between
 *           \__|___\./____\__/
 *              right
 */
template <class Triangulation>
std::vector<Halfedge_index> left_side_of_strip(const Triangulation& triangulation,
                                               const std::vector<Halfedge_index>& crossed)
{
  std::vector<Halfedge_index> chain = {Triangulation::twin(triangulation.next(crossed.front()))};
  for(std::size_t i = 0; i < crossed.size(); ++i) {
    const Halfedge_index entered = Triangulation::twin(crossed[i]);
    const bool is_last = i + 1 == crossed.size();
    if(is_last || crossed[i + 1] == triangulation.next(entered))
      chain.push_back(Triangulation::twin(triangulation.previous(entered)));
  }
  return chain;
}

/*
 * Flips edges on the right of a chain until all angles there are at least pi; returns the number of flips. `flip(h)`
 * must flip the edge of h. If the chain is the left side of a strip of distinct faces that contains the straight
 * segment between its ends, only edges inside the strip are flipped, and the chain becomes one halfedge, the segment:
 * the polygon between the chain and the segment has interior angles of less than pi only at its two ends.
 */
template <class Triangulation, class Flip>
std::size_t straighten_on_the_right(const Triangulation& triangulation, std::vector<Halfedge_index>& chain,
                                    const Flip& flip)
{
  std::size_t flips = 0;
  std::vector<Halfedge_index> arc;
  for(std::size_t i = 0; i + 1 < chain.size();) {
    const Halfedge_index back = Triangulation::twin(chain[i]), on = chain[i + 1];
    typename Triangulation::Turn turn;
    const auto is_blocked = [](const auto&) { return false; };
    if(on == back ||
       !is_free_wedge(triangulation, triangulation.walker(on), triangulation.walker(back), turn, is_blocked)) {
      ++i;
      continue;
    }
    flip_out_wedge(triangulation, on, back, arc, [&](Halfedge_index h) {
      flip(h);
      ++flips;
    });
    // The arc leads back from the head of `on` to the tail of chain[i].
    std::vector<Halfedge_index> replacement;
    for(std::size_t j = arc.size(); j-- > 0;)
      replacement.push_back(Triangulation::twin(arc[j]));
    const auto position =
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i), chain.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    chain.insert(position, replacement.begin(), replacement.end());
    i = i == 0 ? 0 : i - 1;
  }
  return flips;
}

template <class Triangulation>
std::size_t straighten_on_the_right(Triangulation& triangulation, std::vector<Halfedge_index>& chain)
{
  return straighten_on_the_right(triangulation, chain, [&](Halfedge_index h) { triangulation.flip(h); });
}

/* Returns whether all three edges of the face on the left of a halfedge are the input's. */
template <class Triangulation>
bool is_untouched(const Triangulation& triangulation, Halfedge_index h)
{
  const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
  return triangulation.version(Triangulation::edge(h)) == 0 && triangulation.version(Triangulation::edge(hn)) == 0 &&
         triangulation.version(Triangulation::edge(hp)) == 0;
}

/* Returns the edges crossed by a straight edge sequence. */
template <class Triangulation>
std::vector<Crossed_edge> crossed_edges(const Triangulation& triangulation, const Edge_sequence& sequence)
{
  const Strip<Triangulation> strip(triangulation, sequence);
  std::vector<Crossed_edge> result;
  Input_halfedge_index right_side;
  for(const auto& portal : strip.portals()) {
    const double left_height = strip.end().real() * portal.left.imag() - strip.end().imag() * portal.left.real();
    result.push_back({as_intrinsic(portal.crossed), result.empty() || portal.crossed == right_side, left_height});
    right_side = triangulation.input().next(twin_index(portal.crossed));
  }
  return result;
}

/*
 * Appends the straight segment along an input halfedge, or across the edges of a strip, to a path. Returns whether that
 * was possible: it fails if edges of the strip have been flipped already, if the strip contains a face twice, or if the
 * records of the triangulation would exceed the given memory.
 */
template <class Triangulation>
bool insert_leg(Triangulation& triangulation, Input_halfedge_index along, const std::vector<Crossed_edge>& crossed,
                std::vector<Halfedge_index>& path, std::size_t& flips,
                std::size_t most_memory = (std::numeric_limits<std::size_t>::max)())
{
  if(along != null_index) {
    path.push_back(as_intrinsic(along));
    return triangulation.version(Triangulation::edge(path.back())) == 0;
  }
  for(const Crossed_edge& c : crossed)
    if(!is_untouched(triangulation, c.halfedge))
      return false;
  if(!is_untouched(triangulation, Triangulation::twin(crossed.back().halfedge)))
    return false;
  Crossing_removal<Triangulation> removal(triangulation, most_memory);
  const bool is_done = removal(crossed);
  flips += removal.number_of_flips();
  if(!is_done)
    return false;
  const std::vector<Halfedge_index> rest = removal.crossed();
  if(rest.empty()) {
    path.push_back(removal.segment());
    return true;
  }
  std::vector<Halfedge_index> chain = left_side_of_strip(triangulation, rest);
  flips += straighten_on_the_right(triangulation, chain);
  path.insert(path.end(), chain.begin(), chain.end());
  return true;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_SEGMENT_INSERTION_H
