// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_INSERTION_INSERTION_LOG_H
#define CGAL_FLIP_GEODESICS_INTERNAL_INSERTION_INSERTION_LOG_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/base/checked_index_bound.h>
#include <CGAL/Flip_geodesics/internal/insertion/Point_locator.h>
#include <CGAL/Flip_geodesics/internal/store/Halfedge_store.h>

#include <CGAL/assertions.h>

#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* What an insertion changes of the edge or face that is split. */
template <class Halfedge_geometry>
struct Insertion_record
{
  Index number_of_edges;
  Halfedge_index faces[6]; // h, hn, hp and, if the edge was split and has a second face, t, tn, tp
  Vertex_index head_of_h;
  Halfedge_geometry geometry[6];
};

/* Adds a vertex and edges to the arrays of a triangulation, and takes them out again. */
template <class Triangulation>
class Insertion_log
{
public:
  explicit Insertion_log(Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Logs what there is, and adds the vertex. */
  void begin(const Located_point& place, const Surface_location& point)
  {
    Triangulation& t = m_triangulation;
    checked_index_bound(2 * (static_cast<std::size_t>(t.number_of_edges()) + 3));
    const Halfedge_index h = place.halfedge;
    const bool has_two_faces = place.is_on_edge && !t.is_border(Triangulation::twin(h));
    typename Triangulation::Insertion_record record = {t.number_of_edges(), {}, t.head(h), {}};
    for(int i = 0; i < 6; ++i) {
      const Halfedge_index start = i < 3 ? h : (has_two_faces ? Triangulation::twin(h) : null_index);
      const Halfedge_index side = start == null_index ? null_index : (i % 3 == 0 ? start : t.next(record.faces[i - 1]));
      record.faces[i] = side;
      if(side != null_index)
        record.geometry[i] = t.geometry(side);
    }
    t.m_insertions.push_back(record);
    const Edge_index e = Triangulation::edge(h);
    t.m_log.push_back({h, null_index, h, 0, 0, static_cast<Index>(t.m_insertions.size()) - 1, t.version(e),
                       t.crossings(e) + 1, Geometry(), Geometry(), Geometry(), Geometry()});
    t.m_points.push_back(point);
    t.m_halfedges.add_vertex();
  }

  /* A new edge, whose sides are in no face yet; the halfedge with the word. */
  Halfedge_index add_edge(const Crossing_word& word)
  {
    auto& halfedges = m_triangulation.m_halfedges;
    const Slot s = halfedges.add_edge();
    halfedges[s].tail = word.tail;
    halfedges[twin_slot(s)].tail = word.head;
    set_word(halfedges.halfedge(s), word);
    return halfedges.halfedge(s);
  }

  /* Moves the tail of h: the word is that from its new tail on. */
  void shorten_edge(Halfedge_index h, const Crossing_word& word)
  {
    m_triangulation.m_halfedges[m_triangulation.m_halfedges.slot(h)].tail = word.tail;
    set_word(h, word);
  }

  /* Takes the last insertion back, whose entry in the log of flips is given. */
  void undo(const typename Triangulation::Flip_record& log)
  {
    Triangulation& t = m_triangulation;
    const auto& record = t.m_insertions.back();
    while(t.number_of_edges() > record.number_of_edges) {
      const Edge_index e(t.number_of_edges() - 1);
      CGAL_precondition_msg(t.label(e) == 0, "a curve lies on an edge that goes with its point");
      t.m_history.forget(e, t.version(e));
      t.m_halfedges.remove_last_edge();
    }
    t.m_halfedges.remove_last_vertex();
    t.m_points.pop_back();
    auto& halfedges = t.m_halfedges;
    const Slot h = halfedges.slot(log.h);
    halfedges.version(h) = log.old_version;
    halfedges.crossings_plus_one(h) = log.old_crossings;
    halfedges[twin_slot(h)].tail = record.head_of_h;
    for(int i = 0; i < 6 && record.faces[i] != null_index; i += 3)
      t.link_face(record.faces[i], record.faces[i + 1], record.faces[i + 2]);
    for(int i = 0; i < 6 && record.faces[i] != null_index; ++i) {
      const Slot s = halfedges.slot(record.faces[i]);
      halfedges[s].geometry = record.geometry[i];
      if(t.outgoing(halfedges[s].tail).idx() >= t.number_of_halfedges()) // of an edge that is gone
        halfedges.set_outgoing(halfedges[s].tail, s);
    }
    t.m_insertions.pop_back();
  }

private:
  using Geometry = typename Triangulation::Halfedge_geometry;

  void set_word(Halfedge_index h, const Crossing_word& word)
  {
    const Index version = static_cast<Index>(m_triangulation.m_log.size());
    const Slot s = m_triangulation.m_halfedges.slot(h);
    m_triangulation.m_halfedges.version(s) = version;
    m_triangulation.m_halfedges.crossings_plus_one(s) =
        word.along != null_index ? 0 : static_cast<Index>(word.crossed.size()) + 1;
    m_triangulation.m_history.store_word(h, version, word);
  }

  Triangulation& m_triangulation;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_INSERTION_INSERTION_LOG_H
