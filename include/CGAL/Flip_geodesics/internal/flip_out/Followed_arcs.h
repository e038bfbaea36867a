// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FOLLOWED_ARCS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FOLLOWED_ARCS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A path between two vertices that meets no other: along a halfedge, or across some, each as a side of the face that is
 * left. */
struct Followed_arc
{
  Halfedge_index along; // null_index if some are crossed
  std::vector<Halfedge_index> crossed;
};

/*
 * The two faces at an edge, whose four sides outlast its flip. The flipped edge divides the sides into two pairs:
 *
 *              k                   the edge of h leads from i to j before, and joins l and k after; the side of i has
 *           /  |  \                `at_tail` = (k->i, i->l), that of j has `at_head` = (l->j, j->k)
 *         i ---+--- j
 *           \  |  /
 *              l
 */
template <class Triangulation>
class Flipped_quad
{
public:
  /* Before the flip. */
  Flipped_quad(const Triangulation& triangulation, Halfedge_index h)
    : m_h(h)
    , m_t(Triangulation::twin(h))
  {
    const Halfedge_index hn = triangulation.next(m_h), tn = triangulation.next(m_t);
    m_at_tail = {{triangulation.next(hn), tn}};
    m_at_head = {{triangulation.next(tn), hn}};
  }

  std::array<Halfedge_index, 6> halfedges() const
  {
    return {{m_h, m_t, m_at_tail[0], m_at_tail[1], m_at_head[0], m_at_head[1]}};
  }

  /* Rewrites an arc, after the flip. */
  void rewrite(const Triangulation& triangulation, Followed_arc& arc) const
  {
    const Halfedge_index from_tail = triangulation.next(m_at_tail[1]), from_head = Triangulation::twin(from_tail);
    if(arc.crossed.empty()) {
      if(is_flipped(arc.along))
        arc = {null_index, {arc.along == m_h ? from_tail : from_head}};
    } else if(arc.crossed.size() == 1 && is_flipped(arc.crossed.front())) {
      arc = {arc.crossed.front() == m_h ? from_head : from_tail, {}};
    } else {
      rewrite_crossed(from_tail, from_head, arc.crossed);
    }
  }

private:
  enum class Part { NONE, TAIL, HEAD };

  bool is_flipped(Halfedge_index h) const { return h == m_h || h == m_t; }

  Part part(Halfedge_index side) const
  {
    if(side == m_at_tail[0] || side == m_at_tail[1])
      return Part::TAIL;
    return side == m_at_head[0] || side == m_at_head[1] ? Part::HEAD : Part::NONE;
  }

  // An arc that starts opposite to a side came from the other part; one that starts across the edge now starts on it.
  void rewrite_crossed(Halfedge_index from_tail, Halfedge_index from_head, std::vector<Halfedge_index>& crossed) const
  {
    const auto leaving = [&](Part part) { return part == Part::TAIL ? from_tail : from_head; };
    std::vector<Halfedge_index> result;
    const Part first = part(crossed.front());
    if(first != Part::NONE)
      result.push_back(leaving(first == Part::TAIL ? Part::HEAD : Part::TAIL));
    Part entered = Part::NONE;
    for(Halfedge_index h : crossed) {
      if(is_flipped(h))
        continue;
      if(entered != Part::NONE && entered != part(h))
        result.push_back(leaving(entered));
      result.push_back(h);
      entered = part(Triangulation::twin(h));
    }
    if(entered != Part::NONE && !is_flipped(crossed.back()))
      result.push_back(leaving(entered));
    crossed = std::move(result);
  }

  Halfedge_index m_h, m_t;
  std::array<Halfedge_index, 2> m_at_tail, m_at_head;
};

/*
 * Arcs in a triangulation, kept up to date while its edges are flipped, by topology alone.
 *
 * The invariant: no arc crosses an edge and returns across it at once, and each is registered at all edges that it runs
 * along or crosses.
 */
template <class Triangulation>
class Followed_arcs
{
public:
  explicit Followed_arcs(Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  std::size_t size() const { return m_arcs.size(); }
  const Followed_arc& operator[](std::size_t i) const { return m_arcs[i]; }

  void add(Followed_arc arc)
  {
    m_arcs.push_back(std::move(arc));
    enter(m_arcs.size() - 1);
  }

  /* Flips the edge of h, by `flip()`, and has the arcs follow. */
  template <class Flip>
  void follow(Halfedge_index h, const Flip& flip)
  {
    const Flipped_quad<Triangulation> quad(m_triangulation, h);
    flip();
    std::vector<std::size_t> met;
    for(Halfedge_index side : quad.halfedges()) {
      const auto at_edge = m_arcs_at.find(Triangulation::edge(side));
      if(at_edge != m_arcs_at.end())
        met.insert(met.end(), at_edge->second.begin(), at_edge->second.end());
    }
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    m_arcs_at.erase(Triangulation::edge(h));
    for(std::size_t i : met) {
      quad.rewrite(m_triangulation, m_arcs[i]);
      enter_at(Triangulation::edge(h), i);
    }
  }

  /* Takes flips back, the last first, until the log has `position` entries. */
  void roll_back(typename Triangulation::Log_position position)
  {
    while(m_triangulation.log_position() > position) {
      const auto before = m_triangulation.log_position() - 1;
      const auto undo = [&] { m_triangulation.rollback(before); };
      const auto& record = m_triangulation.flip_record(before);
      if(record.is_flip())
        follow(record.h, undo);
      else
        undo();
    }
  }

private:
  void enter(std::size_t i)
  {
    if(m_arcs[i].along != null_index)
      enter_at(Triangulation::edge(m_arcs[i].along), i);
    for(Halfedge_index h : m_arcs[i].crossed)
      enter_at(Triangulation::edge(h), i);
  }

  void enter_at(Edge_index e, std::size_t i)
  {
    const auto is_at = [e](Halfedge_index h) { return Triangulation::edge(h) == e; };
    const Followed_arc& arc = m_arcs[i];
    const bool is_met =
        arc.crossed.empty() ? is_at(arc.along) : std::any_of(arc.crossed.begin(), arc.crossed.end(), is_at);
    if(is_met)
      m_arcs_at[e].push_back(i);
  }

  Triangulation& m_triangulation;
  std::vector<Followed_arc> m_arcs;
  std::map<Edge_index, std::vector<std::size_t>> m_arcs_at;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_FOLLOWED_ARCS_H
