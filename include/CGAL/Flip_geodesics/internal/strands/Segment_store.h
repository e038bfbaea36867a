// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_SEGMENT_STORE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_SEGMENT_STORE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Joint.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A segment of a curve. */
template <class Place>
struct Segment
{
  Halfedge_index halfedge; // none if it is dead
  Segment_index next, previous;
  std::array<Segment_index, 2> beside; // by side, in the stack, circular, along the first halfedge
  Curve_index curve;
  Place place = Place(); // of a side of its edge
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
  using Walker = typename Triangulation::Walker;

public:
  using Segment = internal::Segment<typename Walker::Place>;

  explicit Segment_store(Triangulation& triangulation)
    : m_triangulation(&triangulation)
    , m_segments(1) // id 0 is no segment, as label 0 is no stack
  {
  }

  Segment& operator[](Segment_index s) { return m_segments[s]; }
  const Segment& operator[](Segment_index s) const { return m_segments[s]; }

  Index end_of_ids() const { return static_cast<Index>(m_segments.size()); }
  void set_end_of_ids(Index end) { m_segments.resize(static_cast<std::size_t>(end)); }
  bool is_alive(Segment_index s) const { return (*this)[s].halfedge != null_index; }

  /* Makes room for so many segments and one more: so one can always be created without memory being asked for, to take
   * back what failed. */
  void make_room(std::size_t number)
  {
    if(m_segments.capacity() - m_segments.size() <= number)
      m_segments.reserve((std::max)(2 * m_segments.capacity(), m_segments.size() + number + 1));
  }

  /* A segment of a curve on a halfedge, in no chain and no stack. */
  Segment_index create(Curve_index curve, Halfedge_index h)
  {
    m_segments.emplace_back();
    m_segments.back().curve = curve;
    const Segment_index s(end_of_ids() - 1);
    set_halfedge(s, h);
    return s;
  }

  /* Puts s on a halfedge, but not into the stack there. */
  void set_halfedge(Segment_index s, Halfedge_index h)
  {
    (*this)[s].halfedge = h;
    (*this)[s].place = m_triangulation->walker(h).place();
  }

  /* A side of the edge of s. */
  Walker placed(Segment_index s, Halfedge_index h) const { return Walker(*m_triangulation, (*this)[s].place, h); }

  /* Puts t after s in their chain; either may be null_index. */
  void link(Segment_index s, Segment_index t)
  {
    if(s != null_index)
      (*this)[s].next = t;
    if(t != null_index)
      (*this)[t].previous = s;
  }

  /* The neighbour of s in its stack as seen along h, null_index if s is outermost. */
  Segment_index neighbor(Segment_index s, Halfedge_index h, Side side) const
  {
    const std::size_t i = side_along_first_halfedge(h, side);
    const Segment_index found = (*this)[s].beside[i];
    if(found == s) // alone, as nearly always
      return null_index;
    return chosen(i, s, found).idx() == placed(s, h).label() ? null_index : found; // the circle closes at the leftmost
  }

  /* The outermost segment on a side of the edge of h, as seen along h. \pre there is one */
  Segment_index outermost(Halfedge_index h, Side side) const { return outermost(h, leftmost(h), side); }

  /* The same, with the label of the edge. */
  Segment_index outermost(Halfedge_index h, Segment_index first, Side side) const
  {
    return chosen(side_along_first_halfedge(h, side), first, (*this)[first].beside[0]);
  }

  /* The segments on edge e, from left to right as seen along its first halfedge. */
  std::vector<Segment_index> stack(Edge_index e) const
  {
    std::vector<Segment_index> result;
    const Segment_index first = leftmost(first_side(e));
    if(first == no_segment)
      return result;
    Segment_index s = first;
    do {
      result.push_back(s);
      s = (*this)[s].beside[1];
    } while(s != first);
    return result;
  }

  /* Puts s outermost on the right of its edge as seen along h. */
  void link_outermost(Segment_index s, Halfedge_index h)
  {
    const Walker place = placed(s, h);
    const Segment_index first(place.label());
    if(first == no_segment) {
      (*this)[s].beside = {{s, s}};
      place.set_label(s.idx());
      return;
    }
    link_right_of(s, (*this)[first].beside[0]);
    if(!is_first_side(h))
      place.set_label(s.idx());
  }

  void link_right_of(Segment_index s, Segment_index left)
  {
    const Segment_index right = (*this)[left].beside[1];
    (*this)[s].beside = {{left, right}};
    (*this)[left].beside[1] = s;
    (*this)[right].beside[0] = s;
  }

  /* Takes s out of its stack. */
  void unlink(Segment_index s)
  {
    const Walker place = placed(s, (*this)[s].halfedge);
    const auto [left, right] = (*this)[s].beside;
    (*this)[left].beside[1] = right;
    (*this)[right].beside[0] = left;
    if(place.label() == s.idx())
      place.set_label(right == s ? no_segment.idx() : right.idx());
  }

  void remove(Segment_index s)
  {
    unlink(s);
    (*this)[s].halfedge = null_index;
  }

private:
  static constexpr Segment_index no_segment{0};

  Segment_index leftmost(Halfedge_index h) const
  {
    return Segment_index(m_triangulation->label(Triangulation::edge(h)));
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
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRANDS_SEGMENT_STORE_H
