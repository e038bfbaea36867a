// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_WORKER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_WORKER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A priority queue from which all entries up to some key are removed at once, in an unspecified but deterministic
 * order. Entries due soon are examined each time, later ones only when no others are left.
 */
class Round_queue
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  struct Entry
  {
    double key;
    Index id;
    std::uint32_t tag; // additional data
  };

  bool empty() const { return m_soon.empty() && m_later.empty(); }

  /* Returns the smallest key; infinity if the queue is empty. */
  double least() const { return m_soon.empty() ? m_least_later : m_least_soon; }

  void push(const Entry& e)
  {
    (e.key < m_horizon ? m_soon : m_later).push_back(e);
    double& least = e.key < m_horizon ? m_least_soon : m_least_later;
    least = (std::min)(least, e.key);
  }

  /* Reserves memory for additional entries. */
  void reserve(std::size_t number)
  {
    for(std::vector<Entry>* entries : {&m_soon, &m_later})
      if(entries->capacity() - entries->size() < number)
        entries->reserve((std::max)(2 * entries->capacity(), entries->size() + number));
  }

  /* Prepares for `take(last)` and returns an upper bound on the number of entries removed by it. Changes nothing if it
   * throws.
   * \param step estimate of the increase of `last` until the next call */
  std::size_t look_ahead(double last, double step)
  {
    constexpr double steps = 16; // between two examinations of later entries
    if(m_least_later <= last || m_soon.empty()) {
      m_soon.reserve(m_soon.size() + m_later.size());
      m_horizon = last + steps * step;
      if(m_least_later <= m_horizon)
        remove(m_later, m_least_later, m_horizon, [this](const Entry& e) {
          m_soon.push_back(e);
          m_least_soon = (std::min)(m_least_soon, e.key);
        });
    }
    return m_soon.size();
  }

  /* Calls `function(entry)` for all entries whose keys are at most `last`, and removes them. The function must not push
   * entries. \pre look_ahead(last) was called since the last push */
  template <class Function>
  void take(double last, const Function& function)
  {
    remove(m_soon, m_least_soon, last, function);
  }

private:
  // Removes the entries whose keys are at most `last` from a list.
  template <class Function>
  static void remove(std::vector<Entry>& entries, double& least, double last, const Function& function)
  {
    least = infinity;
    auto to = entries.begin();
    for(const Entry& e : entries)
      if(e.key <= last) {
        function(e);
      } else {
        least = (std::min)(least, e.key);
        *to++ = e;
      }
    entries.erase(to, entries.end());
  }

  std::vector<Entry> m_soon, m_later; // with keys up to the horizon, and larger ones
  double m_horizon = 0, m_least_soon = infinity, m_least_later = infinity;
};

/* A window that is propagated over a face, in the frame of the side across which it enters. */
struct Crossing_window
{
  Window window;
  double crossing; // where the ray to the vertex opposite crosses the side
};

/* All windows that cross a face from one side together. */
struct Face_crossing
{
  Crossing_window *first, *last;
  Input_halfedge_index halfedge, next, previous; // the side across which they enter, and the sides that follow it
  Vertex_index apex;                             // the vertex opposite
  bool is_shorter;                               // whether the path there is shorter than others
  const Crossing_window* nearest;                // has the shortest path; null if none has one
  double distance;                               // of the vertex by that path

  /* Removes all windows. */
  void clear()
  {
    first = last = nullptr;
    is_shorter = false;
  }

  /* Converts the windows to the frame of the side and finds the nearest one. */
  template <class Sides>
  void begin(Input_halfedge_index h, const Sides& sides)
  {
    const Face_side& f = sides.known(h);
    halfedge = h;
    next = f.next;
    previous = sides.known(next).next;
    apex = sides.known(previous).tail;
    nearest = nullptr;
    distance = std::numeric_limits<double>::infinity();
    for(Crossing_window* i = first; i != last; ++i) {
      Window& w = i->window;
      if(!is_first_side(halfedge))
        w.mirror(f.length);
      const double c = i->crossing = w.crossing(f.x, f.y);
      if(!(c > w.from - beside_window * f.length && c < w.to + beside_window * f.length))
        continue;
      const double through = w.bent_distance(f.x, f.y, c);
      // If the ray misses its window, it reaches the apex only if the bent path is as long as the straight line.
      if(!(c >= w.from && c <= w.to) && through - w.distance(f.x, f.y) > equal_paths * through)
        continue;
      if(through < distance) {
        distance = through;
        nearest = i;
      }
    }
    is_shorter = nearest != nullptr;
  }

  /* Calls `function` for everything that arrives at the side at the tail, in the frame of its twin. */
  template <class Function>
  void arrive_left(const Face_side& f, double length, const Function& function) const
  {
    const double best = nearest == nullptr ? 0 : nearest->crossing, limit = best + beside_window * f.length;
    for(const Crossing_window* i = first; i != last; ++i) {
      const Window& w = i->window;
      const double c = i->crossing;
      if(!(c > w.from) || (is_split(*i) && c > limit))
        continue;
      // The part of a window before the ray to the apex, which crosses at c.
      Window child = turned(w, f.cosine, f.sine, (std::min)(c, w.to), c < w.to + w.error(f.length), length);
      if(!(child.y > 0))
        continue;
      child.mirror(length);
      function(child);
    }
  }

  /* Calls `function` for everything that arrives at the side at the head, by mirror images. */
  template <class Function>
  void arrive_right(const Face_side& f, const Face_side& fn, const Function& function) const
  {
    const double best = nearest == nullptr ? 0 : nearest->crossing, limit = best - beside_window * f.length;
    for(const Crossing_window* i = first; i != last; ++i) {
      const double c = i->crossing;
      if(!(c < i->window.to) || (is_split(*i) && c < limit))
        continue;
      Window w = i->window;
      w.mirror(f.length);
      Window child = turned(w, fn.cosine, fn.sine, (std::min)(f.length - c, w.to),
                            f.length - c < w.to + w.error(f.length), fn.length);
      if(child.y > 0)
        function(child);
    }
  }

private:
  // Returns whether the ray to the apex divides the window. If its path is not the best to the apex, the window is
  // useless beyond the ray of the best one [CH90].
  static bool is_split(const Crossing_window& i) { return i.crossing > i.window.from && i.crossing < i.window.to; }

  // The part of a window up to `to` in the frame of a side that starts at the same vertex, rotated upwards by an angle.
  static Window turned(const Window& w, double cosine, double sine, double to, bool is_to_end, double length)
  {
    Window result = w;
    result.x = w.x * cosine - w.y * sine;
    result.y = w.y * cosine + w.x * sine;
    const double weight = w.weight();
    const auto hit = [&](double b) {
      const double fall = result.y - weight * b * sine;
      return fall > 0 ? (std::min)((std::max)(b * w.y / fall, 0.0), length) : length;
    };
    result.from = hit(w.from);
    result.to = is_to_end ? length : hit(to);
    return result;
  }
};

/* The time at which a vertex or an edge is due; for edges the tag is that of `Edge_record`. */
using Noted = Round_queue::Entry;

/* A part of an array. */
template <class T>
struct Array_part
{
  T *first = nullptr, *last = nullptr;
  T* begin() const { return first; }
  T* end() const { return last; }
  std::ptrdiff_t size() const { return last - first; }
};

/* The paths and windows that start from a vertex in a round, and their results. */
struct Starting
{
  Array_part<Vertex_opening> openings;
  Array_part<Noted> noted;
};

/* The windows that leave an edge on which they were waiting, and their results. */
struct Leaving
{
  double length; // 0 if the edge is not left
  double passed; // the time at which the front has passed the edge, if it must be noted
  Array_part<Noted> noted;
  std::array<Face_crossing, 2> crossings;
};

/* A vertex or an edge that is due in a round. One of the pointers is set once it has been left. */
struct Round_item
{
  Noted due;
  std::uint32_t number; // in the order of the queues, vertices first
  bool is_vertex;
  bool may_reach = false; // whether it can be the shortest path to a vertex
  Starting* starting = nullptr;
  Leaving* leaving = nullptr;
};

/* A round, and the number of one of its items. */
struct Round_place
{
  std::uint32_t round, number;
};

/* Something that arrives at an edge in a round. */
struct Arrival
{
  /* Returns what arrives from the vertex opposite. */
  static Arrival from_vertex(const Round_item& item, Vertex_opening& o)
  {
    const auto place = static_cast<std::uint64_t>(&o - item.starting->openings.first);
    return {(std::uint64_t(item.number) << 32) + place, nullptr, &o, false};
  }
  /* Returns what arrives from a side of the face that has been crossed, at whose tail or head the edge is. */
  static Arrival from_side(const Round_item& item, const Face_crossing& c, bool is_at_tail)
  {
    const unsigned place = (is_first_side(c.halfedge) ? 0 : 2) + (is_at_tail ? 0 : 1);
    return {(std::uint64_t(item.number) << 32) + place, &c, nullptr, is_at_tail};
  }

  std::uint64_t order;           // among the arrivals of a round
  const Face_crossing* crossing; // null if it comes from a vertex
  Vertex_opening* opening;
  bool is_left;
};

/* All arrivals at an edge, in order: from at most two vertices and four sides, from vertices on the border twice. */
class Arrivals
{
public:
  Arrivals() {} // leaves the elements uninitialized

  const Arrival* begin() const { return m_all.data(); }
  const Arrival* end() const { return m_all.data() + m_number; }

  void add(const Arrival& a)
  {
    CGAL_assertion(m_number < m_all.size());
    std::size_t i = m_number++;
    for(; i > 0 && a.order < m_all[i - 1].order; --i)
      m_all[i] = m_all[i - 1];
    m_all[i] = a;
  }

private:
  std::array<Arrival, 8> m_all; // the first of them
  std::size_t m_number = 0;
};

/* The state of an edge while windows are propagated. */
struct Edge_record
{
  double due;        // the least distance of the waiting windows
  Round_place left;  // when it was left
  std::uint32_t tag; // of the last note: the number of notes
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

  /* Records when an edge is due. */
  void note_waiting(Index e, double due, Array_part<Noted>& noted)
  {
    Edge_record& record = edge(e);
    if(due == infinity || (record.is_waiting && record.due <= due))
      return;
    record.is_waiting = true;
    record.due = due;
    *noted.last++ = {due, e, ++record.tag};
  }

  const Triangulation& triangulation;
  Face_sides<Triangulation> sides;
  Edge_windows windows;
  Lazy_array<Edge_record> edges;
  Indexed_by<Vertex_index, Lazy_array<Round_place>> left; // when paths started there
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> vertices;
  std::vector<Round_item> items; // of the current round, the vertices first
};

/*
 * A memory arena for small arrays, which are all released at once and do not move until then. It corresponds to
 * `std::pmr::monotonic_buffer_resource`, which libc++ has only since version 16.
 */
class Scratch
{
public:
  /* Returns memory for some elements, whose values are undefined. */
  template <class T>
  T* allocate(std::size_t size)
  {
    static_assert(std::is_trivially_copyable<T>::value,
                  "elements must be trivially copyable, since they are never destroyed");
    const std::size_t bytes = (size * sizeof(T) + alignment - 1) / alignment * alignment;
    while(m_at == m_blocks.size() || m_blocks[m_at].size - m_used < bytes)
      enter_next_block(bytes);
    std::byte* const result = m_blocks[m_at].first.get() + m_used;
    m_used += bytes;
    return reinterpret_cast<T*>(result);
  }

  void release() { m_at = m_used = 0; }

private:
  static constexpr std::size_t least = 1 << 16, alignment = alignof(std::max_align_t);

  struct Block
  {
    std::unique_ptr<std::byte[]> first;
    std::size_t size;
  };

  void enter_next_block(std::size_t size)
  {
    if(m_at == m_blocks.size()) {
      const std::size_t room = (std::max)(size, m_blocks.empty() ? least : 2 * m_blocks.back().size);
      m_blocks.push_back({std::unique_ptr<std::byte[]>(new std::byte[room]), room});
    } else {
      ++m_at;
    }
    m_used = 0;
  }

  std::vector<Block> m_blocks;
  std::size_t m_at = 0, m_used = 0; // the current block, and its used part
};

/*
 * The work of a thread in a round, with its own data. First `leave()` propagates everything from vertices and edges
 * over the next faces; when all items have been left, and the vertices have been updated, `enter()` puts the results on
 * the edges that they reach. Threads do both simultaneously, with different items.
 *
 * An edge is entered by the thread that has the first of the items from which something arrives; that thread looks up
 * the others itself. Each edge is thus entered once, by one thread, from the items in the order of their numbers,
 * without collecting data for it.
 */
template <class Triangulation>
class Round_worker
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  Round_worker(Field_state<Triangulation>& state, bool keeps_windows)
    : m_state(state)
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
  void leave(std::uint32_t round, Round_item& item)
  {
    begin(round);
    if(item.is_vertex)
      leave_vertex(item);
    else
      leave_edge(item);
  }

  /* \pre all items have been left */
  void enter(std::uint32_t round, const Round_item& item)
  {
    begin(round);
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
    m_scratch.release();
  }

  void leave_vertex(Round_item& item)
  {
    const Vertex_index v(item.due.id);
    Starting& s = *m_scratch.allocate<Starting>(1);
    s = Starting();
    if(m_state.vertices[v].distance == item.due.key && m_state.triangulation.input().outgoing(v) != null_index) {
      for_each_outgoing_halfedge(m_state.triangulation.input(), v, [this](Input_halfedge_index h) { make_known(h); });
      open(s, item);
      m_state.left[v] = {m_round, item.number};
    }
    item.starting = &s;
  }

  void open(Starting& s, Round_item& item)
  {
    const Vertex_index v(item.due.id);
    const std::vector<Vertex_opening>& openings = m_vertex_openings(m_state.sides, v, m_state.vertices[v]);
    s.openings.first = m_scratch.allocate<Vertex_opening>(openings.size());
    s.openings.last = std::copy(openings.begin(), openings.end(), s.openings.first);
    item.may_reach = std::any_of(openings.begin(), openings.end(),
                                 [this](const Vertex_opening& o) { return m_state.is_shorter(o.head, o.distance); });
    m_most_entries += openings.size() + 1;
  }

  void leave_edge(Round_item& item)
  {
    Edge_record& record = m_state.edge(item.due.id);
    Leaving& l = *m_scratch.allocate<Leaving>(1);
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
      record.left = {m_round, item.number};
      item.may_reach = l.crossings[0].is_shorter || l.crossings[1].is_shorter;
      m_most_entries += 5;
    }
    item.leaving = &l;
  }

  // Propagates the windows that wait on an edge over the faces on both sides.
  void cross(Leaving& l, Input_halfedge_index h)
  {
    const auto windows = m_state.windows.on_edge(m_state.edge_of(h));
    Crossing_window *const first = m_scratch.allocate<Crossing_window>(windows.size()), *const last =
                                                                                            first + windows.size();
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

  void make_known(Input_halfedge_index h)
  {
    if(!m_state.triangulation.input().is_border(h) && m_state.sides.make_known(h))
      m_has_flat_face = true;
  }

  void enter(Starting& s, const Round_item& item)
  {
    s.noted.first = s.noted.last = m_scratch.allocate<Noted>(static_cast<std::size_t>(s.openings.size()));
    for(Vertex_opening& o : s.openings)
      if(o.opposite != null_index)
        enter(o.opposite, Arrival::from_vertex(item, o), s.noted);
  }

  void enter(Leaving& l, const Round_item& item)
  {
    l.noted.first = l.noted.last = m_scratch.allocate<Noted>(4);
    for(const Face_crossing& c : l.crossings)
      if(c.first != c.last) {
        enter(c.previous, Arrival::from_side(item, c, true), l.noted);
        enter(c.next, Arrival::from_side(item, c, false), l.noted);
      }
    if(!m_keeps_windows)
      l.passed = passed(item.due.id, l.length);
  }

  // The time at which the front is farther than all points of the edge, so its windows are not required any more.
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
      m_state.note_waiting(m_state.edge_of(h), due, noted);
      throw;
    }
    m_state.note_waiting(m_state.edge_of(h), due, noted);
  }

  // Adds the arrivals at the edge of h from its face.
  void add_arrivals(Input_halfedge_index h, Arrivals& arrivals)
  {
    const auto& input = m_state.triangulation.input();
    const Vertex_index apex = input.tail(input.previous(h));
    if(m_state.left[apex].round == m_round) {
      const Round_item& item = m_state.items[m_state.left[apex].number];
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
    const Face_crossing& c = m_state.items[left.number].leaving->crossings[is_first_side(h) ? 0 : 1];
    if(c.first != c.last)
      arrivals.add(Arrival::from_side(m_state.items[left.number], c, is_left));
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
  bool m_keeps_windows;
  Window_inserter m_inserter;
  Vertex_openings<Triangulation> m_vertex_openings;
  bool m_has_flat_face = false;
  // Of the round:
  std::uint32_t m_round = 0;
  std::size_t m_most_entries = 0;
  Scratch m_scratch;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_WORKER_H
