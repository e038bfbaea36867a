// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_WORKER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_WORKER_H

#include <CGAL/Flip_geodesics/internal/distances/Round_items.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The state of an edge while windows are propagated. */
struct Edge_record
{
  double due;        // the least distance of the waiting windows
  Round_place left;  // when it was left
  std::uint32_t tag; // of the last note: the bearing, and the number of earlier notes
  bool is_waiting;   // whether windows wait on it
  bool is_noted;     // whether it is queued for the time at which the front has passed it
};

/* The state of the vertices and edges of the input during and after the propagation of windows. */
template <class Triangulation>
struct Field_state
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  explicit Field_state(const Triangulation& t)
    : triangulation(t)
    , sides(t)
    , windows(number_of_edges(t))
    , edges(number_of_edges(t))
    , left(static_cast<std::size_t>(t.input().number_of_vertices()))
    , vertices(static_cast<std::size_t>(t.input().number_of_vertices()))
  {
  }

  static std::size_t number_of_edges(const Triangulation& t)
  {
    return static_cast<std::size_t>(t.input().number_of_halfedges()) / 2;
  }
  static Index edge_of(Input_halfedge_index h) { return h.idx() / 2; }
  Edge_record& edge(Index e) { return edges[static_cast<std::size_t>(e)]; }

  bool is_reached(Vertex_index v) const { return vertices[v].is_reached; }
  double distance(Vertex_index v) const { return is_reached(v) ? vertices[v].distance : infinity; }
  bool is_shorter(Vertex_index v, double d) const { return !is_reached(v) || d < vertices[v].distance; }

  /* Records when an edge is due. \param place has a member `bearing()` */
  template <class Place>
  void note_waiting(Index e, double due, const Place& place, Array_part<Noted>& noted)
  {
    Edge_record& record = edge(e);
    if(due == infinity || (record.is_waiting && record.due <= due))
      return;
    record.is_waiting = true;
    record.due = due;
    record.tag = record.tag / Bearing::number * Bearing::number + Bearing::number + place.bearing();
    *noted.last++ = {due, e, record.tag};
  }

  const Triangulation& triangulation;
  Face_sides<Triangulation> sides;
  Edge_windows windows;
  Lazy_array<Edge_record> edges;
  Indexed_by<Vertex_index, Lazy_array<Round_place>> left; // when paths started there
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> vertices;
};

/*
 * A memory arena for small arrays, which are all released at once and do not move until then. It corresponds to
 * `std::pmr::monotonic_buffer_resource`, which libc++ has only since version 16.
 */
template <class T>
class Scratch
{
  static_assert(std::is_trivially_copyable<T>::value, "elements are not destroyed");

public:
  /* Returns memory for some elements, whose values are undefined. */
  T* allocate(std::size_t size)
  {
    while(m_at == m_blocks.size() || m_blocks[m_at].size - m_used < size)
      enter_next_block(size);
    T* const result = m_blocks[m_at].first.get() + m_used;
    m_used += size;
    return result;
  }

  void release() { m_at = m_used = 0; }

private:
  static constexpr std::size_t least = 256;

  struct Block
  {
    std::unique_ptr<T[]> first;
    std::size_t size;
  };

  void enter_next_block(std::size_t size)
  {
    if(m_at == m_blocks.size()) {
      const std::size_t larger = m_blocks.empty() ? least : 2 * m_blocks.back().size;
      const std::size_t room = (std::max)(size, larger);
      m_blocks.push_back({std::unique_ptr<T[]>(new T[room]), room});
    } else {
      ++m_at;
    }
    m_used = 0;
  }

  std::vector<Block> m_blocks;
  std::size_t m_at = 0, m_used = 0; // the current block, and its used part
};

/*
 * The work of a member of a team in a round, with its own data. First `leave()` propagates everything from vertices and
 * edges over the next faces; when all items have been left, and the vertices have been updated, `enter()` puts the
 * results on the edges that they reach. Members do both simultaneously, with different items.
 *
 * An edge is entered by the member that has the first of the items from which something arrives; that member looks up
 * the others itself. Each edge is thus entered once, by one member, from the items in the order of their numbers,
 * without collecting data for it.
 */
template <class Triangulation>
class Round_worker
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  Round_worker(Field_state<Triangulation>& state, Round_items& items, bool keeps_windows)
    : m_state(state)
    , m_items(items)
    , m_keeps_windows(keeps_windows)
    , m_vertex_openings(state.triangulation)
  {
  }

  Window_inserter& inserter() { return m_inserter; }
  const Window_inserter& inserter() const { return m_inserter; }
  /* Returns whether there was a face so flat that rays can have been lost in it. */
  bool has_flat_face() const { return m_has_flat_face; }
  /* Returns the largest number of entries that its results of a round can have in a queue. */
  std::size_t most_entries(std::uint32_t round) const { return m_round == round ? m_most_entries : 0; }

  /* \throws as the metric, Invalid_mesh_error; the item is then unchanged */
  void leave(std::uint32_t round, std::size_t place)
  {
    begin(round);
    if(m_items[place].is_vertex)
      leave_vertex(place);
    else
      leave_edge(place);
  }

  /* \pre all items have been left */
  void enter(std::uint32_t round, std::size_t place)
  {
    begin(round);
    const Round_item& item = m_items[place];
    if(item.is_vertex)
      enter(*item.starting, item);
    else if(item.leaving->length > 0)
      enter(*item.leaving, item);
  }

  /* Puts a window on the edge of h, in whose frame it is, which leaves the face on the left of h. Returns when it is
   * due, or infinity if it is useless. */
  double put_beyond(Input_halfedge_index h, Window& w)
  {
    const auto& input = m_state.triangulation.input();
    const Input_halfedge_index entered = twin_index(h);
    if(input.is_border(entered))
      return infinity;
    const double length = m_state.sides.known(h).length;
    w.trim(m_state.distance(input.tail(h)));
    w.mirror(length);
    w.trim(m_state.distance(input.tail(entered)));
    if(!(w.from < w.to))
      return infinity;
    if(is_first_side(h)) // windows of an edge are in the frame of its first side
      w.mirror(length);
    w.side = is_first_side(entered) ? 0 : 1;
    w.state = Window_state::WAITING;
    return m_inserter.insert(m_state.windows, m_state.edge_of(h), w) ? w.least_distance() : infinity;
  }

private:
  void begin(std::uint32_t round)
  {
    if(m_round == round)
      return;
    m_round = round;
    m_most_entries = 0;
    m_starting.release();
    m_leaving.release();
    m_openings.release();
    m_paths.release();
    m_windows.release();
    m_noted.release();
  }

  void leave_vertex(std::size_t place)
  {
    Round_item& item = m_items[place];
    const Vertex_index v(item.due.id);
    Starting& s = *m_starting.allocate(1);
    s = Starting();
    if(m_state.vertices[v].distance == item.due.key && m_state.triangulation.input().outgoing(v) != null_index) {
      make_faces_known(v);
      open(s, item);
      m_state.left[v] = {m_round, static_cast<std::uint32_t>(place)};
    }
    item.starting = &s;
  }

  void open(Starting& s, Round_item& item)
  {
    const Vertex_index v(item.due.id);
    s.is_source = m_state.vertices[v].is_source;
    const std::vector<Vertex_opening>& openings = m_vertex_openings(m_state.sides, v, m_state.vertices[v]);
    s.openings.first = s.openings.last = m_openings.allocate(openings.size());
    s.paths.first = s.paths.last = m_paths.allocate(openings.size());
    for(const Vertex_opening& o : openings) {
      if(o.opposite != null_index)
        *s.openings.last++ = o;
      if(m_state.is_shorter(o.head, o.distance)) {
        *s.paths.last++ = {o.head, o.along, o.distance};
        item.may_reach = true;
      }
    }
    m_most_entries += openings.size() + 1;
  }

  void leave_edge(std::size_t place)
  {
    Round_item& item = m_items[place];
    Edge_record& record = m_state.edge(item.due.id);
    Leaving& l = *m_leaving.allocate(1);
    l.length = 0;
    l.passed = infinity;
    l.noted = {};
    l.crossings[0].clear();
    l.crossings[1].clear();
    if(record.tag == item.due.tag && record.due == item.due.key && record.is_waiting) {
      const Input_halfedge_index h(2 * item.due.id);
      make_known(h);
      make_known(twin_index(h));
      cross(l, h);
      record.is_waiting = false;
      record.left = {m_round, static_cast<std::uint32_t>(place)};
      item.may_reach = l.crossings[0].is_shorter || l.crossings[1].is_shorter;
      m_most_entries += 5;
    }
    item.leaving = &l;
  }

  // Propagates the windows that wait on an edge over the faces on both sides.
  void cross(Leaving& l, Input_halfedge_index h)
  {
    const auto windows = m_state.windows.on_edge(m_state.edge_of(h));
    Crossing_window *const first = m_windows.allocate(windows.size()), *const last = first + windows.size();
    Crossing_window *to = first, *from = last;
    for(Window& w : windows)
      if(w.state != Window_state::DONE) {
        if(w.state == Window_state::WAITING)
          (w.side == 0 ? *to++ : *--from).window = w;
        w.state = w.state == Window_state::WAITING ? Window_state::CROSSING : Window_state::DONE;
      }
    const Input_halfedge_index t = twin_index(h);
    l.length = m_state.sides.known(m_state.triangulation.input().is_border(h) ? t : h).length;
    cross(l.crossings[0], h, first, to);
    cross(l.crossings[1], t, from, last);
  }

  void cross(Face_crossing& c, Input_halfedge_index h, Crossing_window* first, Crossing_window* last)
  {
    if(first == last)
      return;
    c.first = first;
    c.last = last;
    c.begin(h, m_state.sides);
    c.is_shorter = c.is_shorter && m_state.is_shorter(c.apex, c.distance);
  }

  void make_faces_known(Vertex_index v)
  {
    const auto& input = m_state.triangulation.input();
    Input_halfedge_index h = input.outgoing(v);
    do {
      make_known(h);
      h = input.next(twin_index(h));
    } while(h != input.outgoing(v));
  }

  void make_known(Input_halfedge_index h)
  {
    if(!m_state.triangulation.input().is_border(h) && m_state.sides.make_known(h))
      m_has_flat_face = true;
  }

  void enter(Starting& s, const Round_item& item)
  {
    s.noted.first = s.noted.last = m_noted.allocate(static_cast<std::size_t>(s.openings.size()));
    for(Vertex_opening& o : s.openings)
      enter(o.opposite, Arrival::from_vertex(item, o), s.noted);
  }

  void enter(Leaving& l, const Round_item& item)
  {
    l.noted.first = l.noted.last = m_noted.allocate(4);
    for(const Face_crossing& c : l.crossings)
      if(c.first != c.last) {
        enter(c.previous, Arrival::from_side(item, c, true), l.noted);
        enter(c.next, Arrival::from_side(item, c, false), l.noted);
      }
    if(!m_keeps_windows)
      l.passed = passed(item.due.id, l.length);
  }

  // The time at which the front is farther than all points of the edge, so that its windows are not required any more.
  // Infinite if that time has been recorded.
  double passed(Index edge, double length)
  {
    const Input_halfedge_index h(2 * edge), t = twin_index(h);
    const auto& input = m_state.triangulation.input();
    const double result = (m_state.distance(input.tail(h)) + m_state.distance(input.tail(t)) + length) / 2;
    if(m_state.edge(edge).is_noted || result == infinity)
      return infinity;
    m_state.edge(edge).is_noted = true;
    return result;
  }

  // Puts all arrivals from both sides on the edge of h, which is entered from its face, if the given one is the first.
  void enter(Input_halfedge_index h, const Arrival& first, Array_part<Noted>& noted)
  {
    if(m_state.triangulation.input().is_border(twin_index(h)))
      return;
    Arrivals arrivals;
    add_arrivals(h, arrivals);
    add_arrivals(twin_index(h), arrivals);
    if(arrivals.begin()->order != first.order)
      return;
    double due = infinity;
    try {
      for(const Arrival& a : arrivals)
        enter(a, due);
    } catch(...) {
      m_state.note_waiting(m_state.edge_of(h), due, arrivals, noted);
      throw;
    }
    m_state.note_waiting(m_state.edge_of(h), due, arrivals, noted);
  }

  // Adds the arrivals at the edge of h from its face.
  void add_arrivals(Input_halfedge_index h, Arrivals& arrivals)
  {
    const auto& input = m_state.triangulation.input();
    const Vertex_index apex = input.tail(input.previous(h));
    if(m_state.left[apex].round == m_round) {
      const Round_item& item = m_items[m_state.left[apex].place];
      for(Vertex_opening& o : item.starting->openings)
        if(o.opposite == h)
          arrivals.add(Arrival::from_vertex(item, o));
    }
    add_crossing(input.next(h), true, arrivals);
    add_crossing(input.previous(h), false, arrivals);
  }

  void add_crossing(Input_halfedge_index h, bool is_left, Arrivals& arrivals)
  {
    const Round_place& left = m_state.edge(m_state.edge_of(h)).left;
    if(left.round != m_round)
      return;
    const Face_crossing& c = m_items[left.place].leaving->crossings[is_first_side(h) ? 0 : 1];
    if(c.first != c.last)
      arrivals.add(Arrival::from_side(m_items[left.place], c, is_left));
  }

  // \param due when the edge is due, decreased if that becomes earlier
  void enter(const Arrival& a, double& due)
  {
    if(a.opening != nullptr) {
      due = (std::min)(due, put_beyond(a.opening->opposite, a.opening->window));
      return;
    }
    const Face_crossing& c = *a.crossing;
    const Face_side& f = m_state.sides.known(c.halfedge);
    const Input_halfedge_index h = a.is_left ? c.previous : c.next;
    const auto put = [&](Window& w) { due = (std::min)(due, put_beyond(h, w)); };
    if(a.is_left)
      c.arrive_left(f, m_state.sides.known(h).length, put);
    else
      c.arrive_right(f, m_state.sides.known(h), put);
  }

  Field_state<Triangulation>& m_state;
  Round_items& m_items;
  bool m_keeps_windows;
  Window_inserter m_inserter;
  Vertex_openings<Triangulation> m_vertex_openings;
  bool m_has_flat_face = false;
  // Of the round:
  std::uint32_t m_round = 0;
  std::size_t m_most_entries = 0;
  Scratch<Starting> m_starting;
  Scratch<Leaving> m_leaving;
  Scratch<Vertex_opening> m_openings;
  Scratch<Edge_path> m_paths;
  Scratch<Crossing_window> m_windows;
  Scratch<Noted> m_noted;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_WORKER_H
