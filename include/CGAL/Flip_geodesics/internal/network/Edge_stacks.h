// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_EDGE_STACKS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_EDGE_STACKS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Joint.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Where a segment lies in its stack: what is needed to put another one into its place. */
struct Stack_place
{
  Halfedge_index halfedge;
  Segment_index left, right;
};

/*
 * Segments on halfedges of a triangulation, and what lies on each edge, its stack, from left to right as seen along its
 * first halfedge. The leftmost segment of each stack is kept by the place of the edge. The triangulation knows only that
 * the edge is held.
 *
 * The invariant: a stack has segments on its edge only, each once, and an edge is held once if and only if its stack has
 * segments. All that are alive are in one, but those between `create()` and their being linked. Each has a payload, which means nothing here.
 *
 * Ids are given once and never again. In which direction of its edge a halfedge points is as good as random, so that
 * what depends on it is chosen without a branch.
 */
template <class Triangulation, class Payload>
class Edge_stacks
{
public:
  using Walker = typename Triangulation::Walker;

  explicit Edge_stacks(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_segments(1) // id 0 is no segment
  {
  }

  Edge_stacks(Edge_stacks&&) noexcept = default;
  Edge_stacks& operator=(Edge_stacks&&) noexcept = default;

  Triangulation& triangulation() const { return *m_triangulation; }

  /* Says where the triangulation has been moved to. */
  void set_triangulation(Triangulation& triangulation) { m_triangulation = &triangulation; }

  Payload& operator[](Segment_index s) { return m_segments[s].payload; }
  const Payload& operator[](Segment_index s) const { return m_segments[s].payload; }

  Index end_of_ids() const { return static_cast<Index>(m_segments.size()); }
  bool is_alive(Segment_index s) const { return m_segments[s].halfedge != null_index; }
  Halfedge_index halfedge(Segment_index s) const { return m_segments[s].halfedge; }

  /* A side of the edge of s. */
  Walker placed(Segment_index s, Halfedge_index h) const { return m_triangulation->walker(m_segments[s].place, h); }

  /* The leftmost segment on the edge at which a walker stands, along the edge's first halfedge; none with id 0. */
  Segment_index leftmost(const Walker& place) const
  {
    return place.edge_place() < m_leftmost.size() ? m_leftmost[place.edge_place()] : no_segment;
  }

  bool is_occupied(Halfedge_index h) const { return leftmost_on(h) != no_segment; }

  /* The neighbour of s in its stack as seen along h, null_index if s is outermost. */
  Segment_index neighbor(Segment_index s, Halfedge_index h, Side side) const
  {
    const std::size_t i = side_along_first_halfedge(h, side);
    const Segment_index found = m_segments[s].beside[i];
    if(found == s) // alone, as nearly always
      return null_index;
    return chosen(i, s, found) == leftmost(placed(s, h)) ? null_index : found; // the circle closes at the leftmost
  }

  /* The outermost segment on a side of the edge of h, as seen along h. \pre there is one */
  Segment_index outermost(Halfedge_index h, Side side) const { return outermost(h, leftmost_on(h), side); }

  /* The same, with the leftmost segment on the edge. */
  Segment_index outermost(Halfedge_index h, Segment_index first, Side side) const
  {
    return chosen(side_along_first_halfedge(h, side), first, m_segments[first].beside[0]);
  }

  /* The segments on edge e, from left to right as seen along its first halfedge. */
  std::vector<Segment_index> stack(Edge_index e) const
  {
    std::vector<Segment_index> result;
    const Segment_index first = leftmost_on(first_side(e));
    if(first == no_segment)
      return result;
    Segment_index s = first;
    do {
      result.push_back(s);
      s = m_segments[s].beside[1];
    } while(s != first);
    return result;
  }

  /* \pre `order` is a permutation of `stack(e)` */
  void set_stack(Edge_index e, const std::vector<Segment_index>& order)
  {
    for(Segment_index s : order)
      unlink(s);
    for(Segment_index s : order)
      link_outermost(s, first_side(e));
  }

  Stack_place stack_place(Segment_index s) const
  {
    const Halfedge_index first = first_side(Triangulation::edge(halfedge(s)));
    return {halfedge(s), neighbor(s, first, Side::LEFT), neighbor(s, first, Side::RIGHT)};
  }

  /* Makes room for so many segments and one more, on edges that were touched: so one can always be created without
   * memory being asked for, to take back what failed. */
  void make_room(std::size_t number)
  {
    make_room_for_edges(m_triangulation->number_of_edge_places());
    if(m_segments.capacity() - m_segments.size() <= number)
      m_segments.reserve((std::max)(2 * m_segments.capacity(), m_segments.size() + number + 1));
  }

  /* A segment on a halfedge, in no stack. */
  Segment_index create(Halfedge_index h)
  {
    m_segments.emplace_back();
    const Segment_index s(end_of_ids() - 1);
    revive(s, h);
    return s;
  }

  /* The same with an id that was given before. \pre it is not alive */
  void revive(Segment_index s, Halfedge_index h)
  {
    const Walker place = m_triangulation->walker(h);
    make_room_for_edges(place.edge_place() + 1);
    m_segments[s].halfedge = h;
    m_segments[s].place = place.place();
  }

  /* Ids up to here are given, to no segment that is alive. \pre there are none */
  void set_end_of_ids(Index end) { m_segments.resize(static_cast<std::size_t>(end)); }

  /* All segments go, and no edge is held any more. Nothing else may be done then but `clear()`. */
  void release_edges()
  {
    for(Segment_index s(1); s.idx() < end_of_ids(); ++s)
      if(is_alive(s))
        release_edge(placed(s, halfedge(s)));
  }

  /* All segments and ids go. */
  void clear()
  {
    release_edges();
    m_segments.resize(1);
  }

  /* Puts s outermost on the right of its edge as seen along h. \pre it is in no stack, and on that edge */
  void link_outermost(Segment_index s, Halfedge_index h)
  {
    const Walker place = placed(s, h);
    Segment_index& first = m_leftmost[place.edge_place()];
    if(first == no_segment) {
      m_segments[s].beside = {{s, s}};
      first = s;
      place.hold();
      return;
    }
    link_right_of(s, m_segments[first].beside[0]);
    if(!is_first_side(h))
      first = s;
  }

  /* Puts s next to another one on its edge, right of it as seen along the first halfedge. \pre s is in no stack */
  void link_right_of(Segment_index s, Segment_index left)
  {
    const Segment_index right = m_segments[left].beside[1];
    m_segments[s].beside = {{left, right}};
    m_segments[left].beside[1] = s;
    m_segments[right].beside[0] = s;
  }

  /* Takes s out of its stack. */
  void unlink(Segment_index s)
  {
    const Walker place = placed(s, halfedge(s));
    const auto [left, right] = m_segments[s].beside;
    m_segments[left].beside[1] = right;
    m_segments[right].beside[0] = left;
    if(right == s)
      release_edge(place);
    else if(Segment_index& first = m_leftmost[place.edge_place()]; first == s)
      first = right;
  }

  /* \pre s is in no stack */
  void kill(Segment_index s) { m_segments[s].halfedge = null_index; }

private:
  static constexpr Segment_index no_segment{0};

  struct Segment
  {
    Halfedge_index halfedge;             // none if it is dead
    std::array<Segment_index, 2> beside; // by side, in the stack, circular, along the first halfedge
    typename Walker::Place place = typename Walker::Place(); // of a side of its edge
    Payload payload;
  };

  // Also of an edge that was never touched.
  Segment_index leftmost_on(Halfedge_index h) const
  {
    return m_triangulation->holds(Triangulation::edge(h)) > 0 ? leftmost(m_triangulation->walker(h)) : no_segment;
  }

  void make_room_for_edges(std::size_t number)
  {
    if(m_leftmost.size() < number)
      m_leftmost.resize(number, no_segment);
  }

  // Of all its segments.
  void release_edge(const Walker& place)
  {
    Segment_index& first = m_leftmost[place.edge_place()];
    if(first == no_segment)
      return;
    first = no_segment;
    place.release();
  }

  // What is a side along h, along the first halfedge of its edge: 0 left, 1 right.
  static std::size_t side_along_first_halfedge(Halfedge_index h, Side side)
  {
    return static_cast<std::size_t>((h.idx() & 1) ^ (side == Side::RIGHT ? 1 : 0));
  }

  static Segment_index chosen(std::size_t i, Segment_index first, Segment_index second)
  {
    return Segment_index(first.idx() ^ ((first.idx() ^ second.idx()) & -static_cast<Index>(i)));
  }

  Triangulation* m_triangulation;
  Indexed_by<Segment_index, std::vector<Segment>> m_segments;
  std::vector<Segment_index> m_leftmost; // by the place of the edge; grows as edges are touched
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_EDGE_STACKS_H
