// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_DRAWER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_DRAWER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Segment_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A path between two vertices that meets no other path: along a halfedge, or across several, each given as a side of
 * the face that the path leaves. */
struct Followed_arc
{
  Halfedge_index along; // null_index if edges are crossed
  std::vector<Halfedge_index> crossed;
};

/*
 * The two faces at an edge, whose four sides survive its flip. The flipped edge divides the sides into two pairs:
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
  /* Must be constructed before the flip. */
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

  /* Updates an arc after the flip. */
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

  // An arc that starts opposite to a side came from the other face; an arc that started across the edge now starts on
  // it.
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
 * Arcs in a triangulation, kept up to date by topology alone while its edges are flipped.
 *
 * Invariant: no arc crosses an edge and immediately returns across it, and each arc is registered at all edges that it
 * runs along or crosses.
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

  /* Flips the edge of h by `flip()` and updates the arcs. */
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

  /* Rolls flips back, the last one first, until the log has `position` entries. */
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

/* Releases the edges under the curves of a network for the lifetime of the object, during which the network must not be
 * used. The edges must exist again when it is destroyed. */
template <class Network>
class Released_edges
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Released_edges(Network& network)
    : m_triangulation(network.triangulation())
    , m_edges(edges_under_curves(network))
  {
    for(Edge_index e : m_edges)
      m_triangulation.release(e);
  }
  Released_edges(const Released_edges&) = delete;
  Released_edges& operator=(const Released_edges&) = delete;
  ~Released_edges()
  {
    for(Edge_index e : m_edges)
      m_triangulation.hold(e);
  }

private:
  Triangulation& m_triangulation;
  std::vector<Edge_index> m_edges;
};

/*
 * Makes geodesics between vertices edges of one common triangulation. Each geodesic is shortened separately from an
 * edge path, as if there were no other curves. It therefore passes the ends of the other geodesics on the sides of a
 * geodesic, not on those of its initial path. A geodesic that crosses a curve of the network is replaced by its initial
 * path; `order_overlapping_curves()` then determines whether the curves cross or can be separated.
 */
template <class Network>
class Leg_drawer
{
  using Triangulation = typename Network::Triangulation;
  using Chain = std::vector<Halfedge_index>;

public:
  explicit Leg_drawer(Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
    , m_arcs(m_triangulation)
  {
  }

  /* Returns a chain along the geodesics to which the consecutive paths are shortened; its nodes are their ends. */
  Drawn_chain operator()(const std::vector<Chain>& paths)
  {
    std::vector<std::size_t> arcs_before_end;
    for(const Chain& path : paths) {
      for(const Followed_arc& arc : arcs_of_leg(path))
        m_arcs.add(arc);
      arcs_before_end.push_back(m_arcs.size());
    }
    Drawn_chain result;
    std::size_t arc = 0;
    for(std::size_t end : arcs_before_end) {
      if(arc == end) // a path that contracts to a point
        continue;
      for(; arc < end; ++arc)
        draw(arc, result.halfedges);
      result.nodes.push_back(result.halfedges.size() - 1);
    }
    return result;
  }

private:
  std::vector<Followed_arc> arcs_of_leg(const Chain& path)
  {
    const auto before = m_triangulation.log_position();
    Followed_arcs<Triangulation> arcs(m_triangulation);
    {
      const Released_edges<Network> released(m_network);
      const Rollback<Triangulation> at_end(m_triangulation);
      for(Halfedge_index h : shortened(path))
        arcs.add({h, {}});
      arcs.roll_back(before);
    }
    std::vector<Followed_arc> result;
    for(std::size_t i = 0; i < arcs.size() && is_free(arcs[i]); ++i)
      result.push_back(arcs[i]);
    if(result.size() == arcs.size())
      return result;
    result.clear();
    for(Halfedge_index h : path)
      result.push_back({h, {}});
    return result;
  }

  Chain shortened(const Chain& path)
  {
    if(path.empty())
      return {};
    Edge_path_network<Triangulation> network(m_triangulation);
    const Curve_index curve = network.add_curve(path);
    order_overlapping_curves(network);
    shorten(network);
    return network.halfedges(curve);
  }

  bool is_free(const Followed_arc& arc) const
  {
    return std::none_of(arc.crossed.begin(), arc.crossed.end(), [this](Halfedge_index h) { return is_occupied(h); });
  }

  bool is_occupied(Halfedge_index h) const
  {
    return m_triangulation.holds(Triangulation::edge(h)) > 0 || m_drawn.count(Triangulation::edge(h)) != 0;
  }

  // The arcs of a geodesic are straight, and the strip of crossed faces contains the leg.
  void draw(std::size_t i, Chain& chain)
  {
    const Followed_arc arc = m_arcs[i];
    Chain edges(1, arc.along);
    if(!arc.crossed.empty()) {
      for(Halfedge_index h : arc.crossed)
        check_is_free(h);
      edges = left_side_of_strip(m_triangulation, arc.crossed);
      straighten_on_the_right(m_triangulation, edges, [this](Halfedge_index h) {
        check_is_free(h);
        m_arcs.follow(h, [&] { m_triangulation.flip(h); });
      });
    }
    for(Halfedge_index h : edges)
      m_drawn.insert(Triangulation::edge(h));
    chain.insert(chain.end(), edges.begin(), edges.end());
  }

  void check_is_free(Halfedge_index h) const
  {
    if(!is_occupied(h))
      return;
    const Vertex_index v = m_triangulation.tail(h), w = m_triangulation.head(h);
    throw_naming<Crossing_curves_error>(
        "a segment of a curve crosses the curve itself or another curve at the edge between vertices ", v, " and ", w);
  }

  Network& m_network;
  Triangulation& m_triangulation;
  Followed_arcs<Triangulation> m_arcs;
  std::set<Edge_index> m_drawn; // by this drawer
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_LEG_DRAWER_H
