// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_PLAIN_TRIANGULATION_H
#define FLIP_GEODESICS_TEST_PLAIN_TRIANGULATION_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/*
 * An intrinsic triangulation as one would write it down: the faces of a mesh are copied, halfedges lie in a vector, and
 * the log keeps copies of what a flip changes. It knows nothing of the mesh any more.
 *
 * Made from the page of the concept `IntrinsicTriangulation`, by composition, and with no public member that the page
 * does not have, but for the constructor.
 */
template <class Traits_>
class Plain_triangulation
{
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Vertex_index = CGAL::Flip_geodesics::Vertex_index;
  using Edge_index = CGAL::Flip_geodesics::Edge_index;
  using Index = CGAL::Flip_geodesics::Index;

  struct Halfedge
  {
    Halfedge_index next; // none on the border
    Vertex_index tail;
    typename Traits_::Halfedge_geometry geometry;
  };

  // What a flip has changed: six halfedges, and where two vertices begin.
  struct Flip
  {
    std::array<std::pair<Halfedge_index, Halfedge>, 6> halfedges;
    std::array<std::pair<Vertex_index, Halfedge_index>, 2> outgoing;
  };

public:
  using Traits = Traits_;
  using Turn = typename Traits::Turn;
  using Log_position = std::size_t;

  class Walker
  {
  public:
    using Place = Halfedge_index;

    Walker(const Plain_triangulation& triangulation, Halfedge_index h)
      : m_triangulation(&triangulation)
      , m_halfedge(h)
    {
    }

    Halfedge_index index() const { return m_halfedge; }
    Place place() const { return m_halfedge; }
    bool is_none() const { return !m_halfedge.is_valid(); }
    bool operator==(const Walker& other) const { return m_halfedge == other.m_halfedge; }
    bool operator!=(const Walker& other) const { return m_halfedge != other.m_halfedge; }

    Vertex_index tail() const { return m_triangulation->tail(m_halfedge); }
    Walker twin() const { return at(Plain_triangulation::twin(m_halfedge)); }
    Walker previous() const { return at(m_triangulation->previous(m_halfedge)); }
    Walker clockwise() const { return at(m_triangulation->clockwise(m_halfedge)); }
    Walker counterclockwise() const { return at(m_triangulation->counterclockwise(m_halfedge)); }

    double length() const { return m_triangulation->length(m_halfedge); }
    void prefetch_face() const {}
    Walker extend_turn_clockwise(Turn& turn) const
    {
      return at(m_triangulation->extend_turn_clockwise(turn, m_halfedge));
    }

    std::size_t edge_place() const { return static_cast<std::size_t>(Plain_triangulation::edge(m_halfedge).idx()); }
    bool is_held() const { return m_triangulation->m_holds[edge_place()] > 0; }
    void hold() const { m_triangulation->change_holds(edge_place(), 1); }
    void release() const { m_triangulation->change_holds(edge_place(), -1); }

  private:
    Walker at(Halfedge_index h) const { return Walker(*m_triangulation, h); }

    const Plain_triangulation* m_triangulation;
    Halfedge_index m_halfedge;
  };

  template <class Point>
  explicit Plain_triangulation(const CGAL::Surface_mesh<Point>& mesh, const Traits& traits = Traits())
    : m_traits(traits)
    , m_halfedges(mesh.number_of_halfedges())
    , m_holds(mesh.number_of_edges(), 0)
    , m_outgoing(mesh.number_of_vertices())
  {
    const auto index = [](auto d) { return static_cast<Index>(d); };
    for(const auto h : mesh.halfedges()) {
      m_halfedges[h].tail = Vertex_index(index(mesh.source(h)));
      if(!mesh.is_border(h))
        m_halfedges[h].next = Halfedge_index(index(mesh.next(h)));
    }
    for(const auto v : mesh.vertices())
      if(!mesh.is_isolated(v))
        m_outgoing[v] = Halfedge_index(index(mesh.opposite(mesh.halfedge(v))));
    for(const auto h : mesh.halfedges()) {
      const auto second = mesh.next(h), third = mesh.next(second);
      if(mesh.is_border(h) || second < h || third < h)
        continue;
      const auto face = m_traits.construct_face_3_object()(mesh.point(mesh.source(h)), mesh.point(mesh.source(second)),
                                                           mesh.point(mesh.source(third)));
      m_halfedges[h].geometry = face[0];
      m_halfedges[second].geometry = face[1];
      m_halfedges[third].geometry = face[2];
    }
  }

  Index number_of_vertices() const { return static_cast<Index>(m_outgoing.size()); }
  Index number_of_halfedges() const { return static_cast<Index>(m_halfedges.size()); }
  Index number_of_edges() const { return static_cast<Index>(m_holds.size()); }

  static Halfedge_index twin(Halfedge_index h) { return Halfedge_index(h.idx() ^ 1); }
  static Edge_index edge(Halfedge_index h) { return Edge_index(h); }
  Halfedge_index next(Halfedge_index h) const { return at(h).next; }
  Halfedge_index previous(Halfedge_index h) const { return next(next(h)); }
  Vertex_index tail(Halfedge_index h) const { return at(h).tail; }
  Vertex_index head(Halfedge_index h) const { return at(twin(h)).tail; }
  bool is_border(Halfedge_index h) const { return !at(h).next.is_valid(); }
  Halfedge_index clockwise(Halfedge_index h) const { return next(twin(h)); }
  Halfedge_index counterclockwise(Halfedge_index h) const
  {
    return is_border(h) ? Halfedge_index() : twin(previous(h));
  }
  Halfedge_index outgoing(Vertex_index v) const { return m_outgoing[static_cast<std::size_t>(v.idx())]; }
  void prefetch_face(Halfedge_index) const {}

  const Traits& traits() const { return m_traits; }
  double length(Halfedge_index h) const
  {
    return m_traits.compute_length_object()(at(is_border(h) ? twin(h) : h).geometry);
  }

  Halfedge_index extend_turn_clockwise(Turn& turn, Halfedge_index h) const
  {
    if(!is_border(twin(h)))
      extend_turn_at_head(turn, twin(h));
    return clockwise(h);
  }

  bool is_straight(const Turn& turn, Halfedge_index, Halfedge_index) const
  {
    return m_traits.compare_turn_with_straight_object()(turn).make_certain() != CGAL::SMALLER;
  }

  bool is_locally_delaunay(Halfedge_index h) const
  {
    const Halfedge_index t = twin(h);
    if(is_border(h) || is_border(t) || next(h) == t || next(t) == h)
      return true;
    return m_traits
        .is_locally_delaunay_object()(at(h).geometry, at(next(h)).geometry, at(previous(h)).geometry, at(t).geometry,
                                      at(next(t)).geometry, at(previous(t)).geometry)
        .make_certain();
  }

  bool is_flippable(Halfedge_index h) const
  {
    const Halfedge_index t = twin(h);
    return !is_border(h) && !is_border(t) && next(h) != t && next(t) != h && holds(edge(h)) == 0 &&
           !is_reflex_at_head(walker(h)) && !is_reflex_at_head(walker(t));
  }

  void flip(Halfedge_index h)
  {
    const Halfedge_index t = twin(h), hn = next(h), hp = next(hn), tn = next(t), tp = next(tn);
    const Vertex_index i = tail(h), j = tail(t), k = tail(hp), l = tail(tp);
    m_log.push_back({{{{h, at(h)}, {hn, at(hn)}, {hp, at(hp)}, {t, at(t)}, {tn, at(tn)}, {tp, at(tp)}}},
                     {{{i, outgoing(i)}, {j, outgoing(j)}}}});
    const auto flipped = m_traits.flip_object()(at(h).geometry, at(hn).geometry, at(hp).geometry, at(t).geometry,
                                                at(tn).geometry, at(tp).geometry);
    for(const auto& [from, to] : {std::make_pair(h, hp), {hp, tn}, {tn, h}, {t, tp}, {tp, hn}, {hn, t}})
      at(from).next = to;
    at(h).tail = l;
    at(t).tail = k;
    at(h).geometry = flipped.h;
    at(t).geometry = flipped.t;
    at(tn).geometry = flipped.tn;
    at(tp).geometry = flipped.tp;
    m_outgoing[static_cast<std::size_t>(i.idx())] = tn;
    m_outgoing[static_cast<std::size_t>(j.idx())] = hn;
  }

  Log_position log_position() const { return m_log.size(); }

  void rollback(Log_position position)
  {
    for(; m_log.size() > position; m_log.pop_back()) {
      for(const auto& [h, halfedge] : m_log.back().halfedges)
        at(h) = halfedge;
      for(const auto& [v, h] : m_log.back().outgoing)
        m_outgoing[static_cast<std::size_t>(v.idx())] = h;
    }
  }

  std::size_t memory_of_records() const { return m_log.size() * sizeof(Flip); }

  Index holds(Edge_index e) const { return m_holds[static_cast<std::size_t>(e.idx())]; }
  void hold(Edge_index e) { change_holds(static_cast<std::size_t>(e.idx()), 1); }
  void release(Edge_index e) { change_holds(static_cast<std::size_t>(e.idx()), -1); }
  std::size_t number_of_holds() const { return m_number_of_holds; }
  std::size_t number_of_edge_places() const { return m_holds.size(); }

  Walker walker(Halfedge_index h) const { return Walker(*this, h); }
  Walker walker(Halfedge_index, Halfedge_index h) const { return Walker(*this, h); }

  bool is_reflex_at_head(const Walker& at_h) const
  {
    Turn turn;
    const Halfedge_index h = at_h.index(), in = previous(twin(h));
    extend_turn_at_head(turn, h);
    extend_turn_at_head(turn, in);
    return is_straight(turn, twin(in), next(h));
  }

private:
  Halfedge& at(Halfedge_index h) { return m_halfedges[static_cast<std::size_t>(h.idx())]; }
  const Halfedge& at(Halfedge_index h) const { return m_halfedges[static_cast<std::size_t>(h.idx())]; }

  void change_holds(std::size_t edge, Index change) const
  {
    m_holds[edge] += change;
    m_number_of_holds += static_cast<std::size_t>(change);
  }

  // The corner from h to next(h).
  void extend_turn_at_head(Turn& turn, Halfedge_index h) const
  {
    m_traits.extend_turn_object()(turn, at(h).geometry, at(next(h)).geometry, at(previous(h)).geometry);
  }

  Traits m_traits;
  std::vector<Halfedge> m_halfedges;
  mutable std::vector<Index> m_holds; // a walker changes them
  mutable std::size_t m_number_of_holds = 0;
  std::vector<Halfedge_index> m_outgoing;
  std::vector<Flip> m_log;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_PLAIN_TRIANGULATION_H
