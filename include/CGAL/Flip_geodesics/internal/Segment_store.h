// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SEGMENT_STORE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SEGMENT_STORE_H

#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/Placed_halfedge.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A segment of a curve. */
struct Segment
{
  Index halfedge = null_index; // null_index if it is dead
  Index next = null_index, previous = null_index;
  std::array<Index, 2> beside = {{null_index, null_index}}; // by side, in the stack, circular, along the first halfedge
  Index curve = null_index;
  Slot place = Slot::NONE; // of a side of its edge
  bool is_head_fixed = false;
  // By side: is the angle at the head known to be pi or more, or to hold the border? It stays so while the joint lives.
  std::array<bool, 2> is_head_straight = {{false, false}};
};

/*
 * The segments of a network, with the chains of its curves and the stacks on the edges: the label of an edge is its
 * leftmost segment as seen along its first halfedge, 0 if it has none.
 *
 * Ids are given once and never again. In which direction of its edge a halfedge points is as good as random, so that
 * what depends on it is chosen without a branch.
 */
template <class Triangulation>
class Segment_store
{
public:
  explicit Segment_store(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_segments(1) // id 0 is no segment, as label 0 is no stack
  {
  }

  Segment& operator[](Index s) { return m_segments[static_cast<std::size_t>(s)]; }
  const Segment& operator[](Index s) const { return m_segments[static_cast<std::size_t>(s)]; }

  Index end_of_ids() const { return static_cast<Index>(m_segments.size()); }
  void set_end_of_ids(Index end) { m_segments.resize(static_cast<std::size_t>(end)); }
  bool is_alive(Index s) const { return (*this)[s].halfedge != null_index; }

  /* Makes room for so many segments and one more: so one can always be created without memory being asked for, to take
   * back what failed. */
  void make_room(std::size_t number)
  {
    if(m_segments.capacity() - m_segments.size() <= number)
      m_segments.reserve((std::max)(2 * m_segments.capacity(), m_segments.size() + number + 1));
  }

  /* A segment of a curve on a halfedge, in no chain and no stack. */
  Index create(Index curve, Index h)
  {
    m_segments.emplace_back();
    m_segments.back().curve = curve;
    set_halfedge(end_of_ids() - 1, h);
    return end_of_ids() - 1;
  }

  /* Puts s on a halfedge, but not into the stack there. */
  void set_halfedge(Index s, Index h)
  {
    (*this)[s].halfedge = h;
    (*this)[s].place = Placed_halfedge<Triangulation>::take(*m_triangulation, h).slot();
  }

  /* A side of the edge of s. */
  Placed_halfedge<Triangulation> placed(Index s, Index h) const
  {
    return Placed_halfedge<Triangulation>(*m_triangulation, side_slot((*this)[s].place, h));
  }

  /* Puts t after s in their chain; either may be null_index. */
  void link(Index s, Index t)
  {
    if(s != null_index)
      (*this)[s].next = t;
    if(t != null_index)
      (*this)[t].previous = s;
  }

  /* The neighbour of s in its stack as seen along h, null_index if s is outermost. */
  Index neighbor(Index s, Index h, Side side) const
  {
    const std::size_t i = side_along_first_halfedge(h, side);
    const Index found = (*this)[s].beside[i];
    if(found == s) // alone, as nearly always
      return null_index;
    return chosen(i, s, found) == placed(s, h).label() ? null_index : found; // the circle closes at the leftmost
  }

  /* The outermost segment on a side of the edge of h, as seen along h. \pre there is one */
  Index outermost(Index h, Side side) const { return outermost(h, leftmost(h), side); }

  /* The same, with the label of the edge. */
  Index outermost(Index h, Index first, Side side) const
  {
    return chosen(side_along_first_halfedge(h, side), first, (*this)[first].beside[0]);
  }

  /* The segments on edge e, from left to right as seen along its first halfedge. */
  std::vector<Index> stack(Index e) const
  {
    std::vector<Index> result;
    const Index first = leftmost(2 * e);
    if(first == 0)
      return result;
    Index s = first;
    do {
      result.push_back(s);
      s = (*this)[s].beside[1];
    } while(s != first);
    return result;
  }

  /* Puts s outermost on the right of its edge as seen along h. */
  void link_outermost(Index s, Index h)
  {
    const Placed_halfedge<Triangulation> place = placed(s, h);
    const Index first = place.label();
    if(first == 0) {
      (*this)[s].beside = {{s, s}};
      place.set_label(s);
      return;
    }
    link_right_of(s, (*this)[first].beside[0]);
    if((h & 1) != 0)
      place.set_label(s);
  }

  void link_right_of(Index s, Index left)
  {
    const Index right = (*this)[left].beside[1];
    (*this)[s].beside = {{left, right}};
    (*this)[left].beside[1] = s;
    (*this)[right].beside[0] = s;
  }

  /* Takes s out of its stack. */
  void unlink(Index s)
  {
    const Placed_halfedge<Triangulation> place = placed(s, (*this)[s].halfedge);
    const auto [left, right] = (*this)[s].beside;
    (*this)[left].beside[1] = right;
    (*this)[right].beside[0] = left;
    if(place.label() == s)
      place.set_label(right == s ? 0 : right);
  }

  void remove(Index s)
  {
    unlink(s);
    (*this)[s].halfedge = null_index;
  }

private:
  Index leftmost(Index h) const { return m_triangulation->label(Triangulation::edge(h)); }

  // What is a side along h, along the first halfedge of its edge: 0 left, 1 right.
  static std::size_t side_along_first_halfedge(Index h, Side side)
  {
    return static_cast<std::size_t>((h & 1) ^ (side == Side::RIGHT ? 1 : 0));
  }

  static Index chosen(std::size_t i, Index first, Index second)
  {
    return first ^ ((first ^ second) & -static_cast<Index>(i));
  }

  Triangulation* m_triangulation;
  std::vector<Segment> m_segments;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SEGMENT_STORE_H
