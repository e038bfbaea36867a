// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_INSERTION_EDITOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_INSERTION_EDITOR_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/surface/checked_index_bound.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Flip_log.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_locator.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A point that was inserted: where it is on the input, and what was changed of the edge or face that was split. */
template <class Halfedge_geometry>
struct Inserted_point
{
  Surface_location location;
  Index number_of_edges;
  Halfedge_index faces[6]; // h, hn, hp and, if the edge was split and has a second face, t, tn, tp
  Vertex_index head_of_h;
  Halfedge_geometry geometry[6];
};

/*
 * What an insertion may do to a triangulation, which makes it of its parts: log what there is and add a vertex, and
 * then add edges, link faces and lay them out. All of it can be taken back from when `begin()` has returned.
 */
template <class Triangulation, class Store>
class Insertion_editor
{
public:
  using Point = Inserted_point<typename Store::Halfedge_geometry>;

  Insertion_editor(const Triangulation& triangulation, Store& halfedges, Flip_log<Store>& log,
                   std::vector<Point>& points, Edge_history<Triangulation>& history)
    : m_triangulation(triangulation)
    , m_halfedges(halfedges)
    , m_log(log)
    , m_points(points)
    , m_history(history)
  {
  }

  /* Logs what there is, and adds the vertex. If it throws, nothing has changed. */
  Vertex_index begin(const Located_point& place, const Surface_location& location)
  {
    const Triangulation& t = m_triangulation;
    checked_index_bound(2 * (static_cast<std::size_t>(t.number_of_edges()) + 3));
    const auto number = static_cast<std::ptrdiff_t>(m_points.size());
    m_halfedges.add_vertex();
    try {
      m_points.push_back(record(place, location));
      m_log.note_insertion(m_halfedges, place.halfedge, place.is_on_edge, static_cast<Index>(place.gap),
                           static_cast<Index>(number));
    } catch(...) {
      m_points.erase(m_points.begin() + number, m_points.end());
      m_halfedges.remove_last_vertex();
      throw;
    }
    return Vertex_index(t.number_of_vertices() - 1);
  }

  /* A new edge, whose sides are in no face yet; the halfedge with the word. */
  Halfedge_index add_edge(const Crossing_word& word)
  {
    const Slot s = m_halfedges.add_edge();
    m_halfedges[s].tail = word.tail;
    m_halfedges[twin_slot(s)].tail = word.head;
    set_word(m_halfedges.halfedge(s), word);
    return m_halfedges.halfedge(s);
  }

  /* Moves the tail of h: the word is that from its new tail on. */
  void shorten_edge(Halfedge_index h, const Crossing_word& word)
  {
    m_halfedges[m_halfedges.slot(h)].tail = word.tail;
    set_word(h, word);
  }

  void link_face(Halfedge_index a, Halfedge_index b, Halfedge_index c)
  {
    m_halfedges.link_face(m_halfedges.slot(a), m_halfedges.slot(b), m_halfedges.slot(c));
  }

  /* Says that h has no face. */
  void put_on_border(Halfedge_index h) { m_halfedges[m_halfedges.slot(h)].encoded_next = Store::Record::border; }

  /* Keeps h for the new vertex, at which it starts. */
  void set_outgoing(Vertex_index x, Halfedge_index h) { m_halfedges.set_outgoing(x, m_halfedges.slot(h)); }

  /* If `from` is the halfedge that is kept for v, keeps `to` instead. */
  void move_outgoing(Vertex_index v, Halfedge_index from, Halfedge_index to)
  {
    m_halfedges.move_outgoing(v, m_halfedges.slot(from), m_halfedges.slot(to));
  }

  /* Sets the vectors of the face on the left of h, from it on. */
  template <class Face_geometry>
  void lay_out(Halfedge_index h, const Face_geometry& geometry)
  {
    m_halfedges.set_face_geometry(h, geometry[0], geometry[1], geometry[2]);
  }

  /* Takes the last insertion back. \pre nothing was logged after it */
  void take_back()
  {
    const auto& log = m_log.back();
    const Point& record = m_points.back();
    remove_edges(record.number_of_edges);
    m_halfedges.remove_last_vertex();
    const Slot h = m_halfedges.slot(log.h);
    m_halfedges.version(h) = log.old_version;
    m_halfedges.crossings_plus_one(h) = log.old_crossings;
    m_halfedges[twin_slot(h)].tail = record.head_of_h;
    for(int i = 0; i < 6 && record.faces[i] != null_index; i += 3)
      link_face(record.faces[i], record.faces[i + 1], record.faces[i + 2]);
    for(int i = 0; i < 6 && record.faces[i] != null_index; ++i) {
      const Slot s = m_halfedges.slot(record.faces[i]);
      const Vertex_index v = m_halfedges[s].tail;
      m_halfedges[s].geometry = record.geometry[i];
      if(m_halfedges.outgoing(v).idx() >= m_triangulation.number_of_halfedges()) // of an edge that is gone
        m_halfedges.set_outgoing(v, s);
    }
    m_points.pop_back();
    m_log.take_back(m_halfedges);
  }

private:
  Point record(const Located_point& place, const Surface_location& location) const
  {
    const Triangulation& t = m_triangulation;
    const Halfedge_index h = place.halfedge;
    const bool has_two_faces = place.is_on_edge && !t.is_border(Triangulation::twin(h));
    Point result = {location, t.number_of_edges(), {}, t.head(h), {}};
    for(int i = 0; i < 6; ++i) {
      const Halfedge_index start = i < 3 ? h : (has_two_faces ? Triangulation::twin(h) : null_index);
      const Halfedge_index side = start == null_index ? null_index : (i % 3 == 0 ? start : t.next(result.faces[i - 1]));
      result.faces[i] = side;
      if(side != null_index)
        result.geometry[i] = t.geometry(side);
    }
    return result;
  }

  void remove_edges(Index number_left)
  {
    while(m_triangulation.number_of_edges() > number_left) {
      const Edge_index e(m_triangulation.number_of_edges() - 1);
      CGAL_precondition_msg(m_triangulation.holds(e) == 0, "a curve lies on an edge that goes with its point");
      m_history.forget(e, m_triangulation.version(e));
      m_halfedges.remove_last_edge();
    }
  }

  void set_word(Halfedge_index h, const Crossing_word& word)
  {
    const Index version = static_cast<Index>(m_log.size());
    const Slot s = m_halfedges.slot(h);
    m_halfedges.version(s) = version;
    m_halfedges.crossings_plus_one(s) = word.along != null_index ? 0 : static_cast<Index>(word.crossed.size()) + 1;
    m_history.store_word(h, version, word);
  }

  const Triangulation& m_triangulation;
  Store& m_halfedges;
  Flip_log<Store>& m_log;
  std::vector<Point>& m_points;
  Edge_history<Triangulation>& m_history;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_INSERTION_EDITOR_H
