// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H

#include <CGAL/Flip_geodesics/internal/distances/Round_worker.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The weights of a point of a face, at the tail of a halfedge, its head and the third vertex; they sum to one. */
using Face_weights = std::array<double, 3>;

inline Face_weights rotated(const Face_weights& weights) { return {{weights[1], weights[2], weights[0]}}; }

/* Normalizes weights of any sum. \pre they are not all 0 */
inline Face_weights normalized(Face_weights weights)
{
  const double largest = (std::max)({weights[0], weights[1], weights[2]});
  const double sum = weights[0] / largest + weights[1] / largest + weights[2] / largest;
  for(double& weight : weights)
    weight = weight / largest / sum;
  return weights;
}

/* Returns a point of a face in the frame of a side, to whose tail the first of its weights refers. */
inline std::complex<double> position(const Face_side& side, const Face_weights& weights)
{
  return {weights[1] * side.length + weights[2] * side.x, weights[2] * side.y};
}

/* A part of a source in a face: a straight line between two points, which may coincide. */
struct Source_part
{
  Input_halfedge_index halfedge; // a side of the face to which the weights refer
  std::array<Face_weights, 2> ends;
  double offset;
  std::size_t source;

  /* Returns the position along the line, from 0 to 1, of its point nearest to another point in the face. */
  double nearest(const Face_side& side, const Face_weights& weights) const
  {
    const auto first = position(side, ends[0]), along = position(side, ends[1]) - first;
    const double square = std::norm(along);
    if(!(square > 0))
      return 0;
    const double t = ((position(side, weights) - first) * std::conj(along)).real() / square;
    return (std::min)((std::max)(t, 0.0), 1.0);
  }

  Face_weights at(double t) const
  {
    Face_weights result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = t == 0 ? ends[0][i] : (t == 1 ? ends[1][i] : (1 - t) * ends[0][i] + t * ends[1][i]);
    return result;
  }

  double distance(const Face_side& side, const Face_weights& weights) const
  {
    return offset + std::abs(position(side, weights) - position(side, at(nearest(side, weights))));
  }

  /* Returns the window of its rays that leave the face through a side, in the frame of that side; empty if there are
   * none. The rays of a line are perpendicular to it. */
  static Window window(const Face_side& side, const Face_weights& first, const Face_weights& last, double offset)
  {
    const std::complex<double> p = position(side, first), line = position(side, last) - p;
    Window w = {0, side.length, p.real(), p.imag(), offset, null_index, 0, false, Window_state::WAITING};
    if(line == std::complex<double>(0)) {
      w.to = w.y > 0 ? w.to : 0;
      return w;
    }
    const double length = std::abs(line);
    const std::complex<double> direction = line / length;
    const double down = std::abs(direction.real()); // the normal that leads below is (n, -down)
    if(!(down > perpendicular))
      return {0, 0, 0, 0, 0, null_index, 0, true, Window_state::WAITING};
    const double n = direction.real() > 0 ? direction.imag() : -direction.imag();
    const double a = p.real() + p.imag() * direction.imag() / direction.real(), b = a + length / direction.real();
    w.from = (std::max)((std::min)(a, b), 0.0);
    w.to = (std::min)((std::max)(a, b), side.length);
    w.is_far = true;
    w.sigma = offset - p.real() * n + p.imag() * down;
    w.x = -n;
    w.y = down;
    return w;
  }
};

/*
 * Distances on the input mesh from vertices and from straight lines in faces, exact up to rounding errors: windows of
 * rays are propagated from face to face [MMP87]. When the nearest window waiting on an edge is due, all waiting ones
 * are propagated, and the edge keeps the lower envelope of those that have arrived. Few windows are thus computed
 * twice, and the queue contains only edges and vertices.
 *
 * The propagation proceeds in rounds: everything that is due soon after the first item is processed together. The
 * distances do not depend on the order in which windows are propagated. Each round first crosses the faces, from all
 * edges and vertices, and then puts the results on the edges that they reach. Threads can share both halves of a round:
 * the edges that are left and those that are entered. The results are the same for every number of threads, since one
 * thread performs the same rounds, and arrivals are put on an edge in the same order.
 */
template <class Triangulation>
class Window_propagation
{
  using State = Field_state<Triangulation>;
  using Worker = Round_worker<Triangulation>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t most_on_an_edge = 5000; // windows

public:
  /* \param keeps_windows whether windows are kept once the front has passed them */
  Window_propagation(const Triangulation& triangulation, bool keeps_windows)
    : m_triangulation(triangulation)
    , m_keeps_windows(keeps_windows)
    , m_state(std::make_unique<State>(triangulation))
  {
    make_workers(1);
  }

  /* Makes a vertex a source. */
  void add_vertex(Vertex_index v, double offset, std::size_t source)
  {
    if(m_state->is_shorter(v, offset))
      accept(v, {offset, Window(), null_index, null_index, v.idx(), true, true, source});
  }

  /* Makes a line in a face a source, except for ends that are vertices. */
  void add_part(const Source_part& part)
  {
    const Index root = m_triangulation.input().number_of_vertices() + static_cast<Index>(m_parts.size());
    m_parts.push_back(part);
    Input_halfedge_index h = part.halfedge;
    std::array<Face_weights, 2> ends = part.ends;
    for(Face_weights corner = {{1, 0, 0}}; h != null_index;) {
      const Vertex_index v = m_state->sides(h).tail;
      const double distance = part.distance(m_state->sides(part.halfedge), corner);
      if(m_state->is_shorter(v, distance))
        accept(v, {distance, Window(), null_index, null_index, root, true, false, 0});
      Window w = Source_part::window(m_state->sides(h), ends[0], ends[1], part.offset);
      w.root = root;
      const double due = w.from < w.to ? m_workers.front()->put_beyond(h, w) : infinity;
      note_waiting(State::edge_of(h), due);
      h = m_state->sides(h).next == part.halfedge ? Input_halfedge_index(null_index) : m_state->sides(h).next;
      ends = {{rotated(ends[0]), rotated(ends[1])}};
      corner = {{corner[2], corner[0], corner[1]}};
    }
  }

  /* Continues until all paths shorter than `bound` are known, or there are more than `most_windows`, or it is
   * interrupted before a round, by the calling thread. If it throws, the previous results remain valid, and it can be
   * called again. */
  template <class ConcurrencyTag = Sequential_tag>
  void run(double bound, std::size_t most_windows, Interruption* interruption = nullptr)
  {
    make_workers(number_of_threads<ConcurrencyTag>());
    while(!is_given_up(most_windows) && reach() < bound && !is_interrupted_before_part(interruption))
      take_round<ConcurrencyTag>(bound);
  }

  /* Returns the length below which all paths are known. */
  double reach() const { return (std::min)(m_vertex_queue.least(), m_edge_queue.least()); }

  bool is_reached(Vertex_index v) const { return m_state->is_reached(v); }
  double distance(Vertex_index v) const { return m_state->distance(v); }
  const Vertex_record& vertex(Vertex_index v) const { return m_state->vertices[v]; }
  /* \pre the path comes from a vertex, and v was not made a source */
  Last_leg last_leg(Vertex_index v) const
  {
    double angle = 0;
    const Vertex_record& record = vertex(v);
    const Input_halfedge_index h =
        Vertex_openings<Triangulation>(m_triangulation).first_halfedge(sides(), v, record, angle);
    const Vertex_index from(record.root);
    if(record.along != null_index)
      return {from, h, 0, m_triangulation.metric().length(m_triangulation.input(), record.along)};
    const Face_side& f = sides().known(record.through);
    return {from, h, -angle, std::hypot(f.x - record.window.x, f.y + record.window.y)};
  }
  /* Returns the source from which paths reach a root, that is, a vertex or a part of a source. */
  std::size_t source(Index root) const
  {
    while(!is_part(root) && !vertex(Vertex_index(root)).is_source)
      root = vertex(Vertex_index(root)).root;
    return is_part(root) ? part(root).source : vertex(Vertex_index(root)).source;
  }
  const std::vector<Source_part>& parts() const { return m_parts; }
  /* Returns whether a root is a part of a source, and not a vertex. */
  bool is_part(Index root) const { return root >= m_triangulation.input().number_of_vertices(); }
  const Source_part& part(Index root) const
  {
    return m_parts[static_cast<std::size_t>(root - m_triangulation.input().number_of_vertices())];
  }
  const Face_sides<Triangulation>& sides() const { return m_state->sides; }
  const Edge_windows& windows() const { return m_state->windows; }
  std::size_t number_of_windows() const { return sum(&Window_inserter::number_made); }
  /* Returns the number of windows for which memory is allocated. */
  std::size_t capacity() const { return sum(&Window_inserter::capacity); }
  /* Returns whether there were faces so flat that rays can have been lost in them. */
  bool has_flat_face() const
  {
    return std::any_of(m_workers.begin(), m_workers.end(), [](const auto& w) { return w->has_flat_face(); });
  }

  /* Returns whether rounding errors can have changed the known distance of a vertex by more than 1e-10 of it. */
  bool has_inaccurate_distance() const { return m_has_inaccurate_distance; }

  /* Returns whether there are too many windows in total, or so many on one edge that rays circle around vertices that
   * degenerate faces make coincide. They would do so until rounding errors end it. Other edges may have as many
   * windows, but not on average over all windows. */
  bool is_given_up(std::size_t most_windows) const
  {
    const auto is_crowded = [](const auto& w) { return w->inserter().most_on_an_edge() > most_on_an_edge; };
    const std::size_t made = number_of_windows();
    return made > most_windows || sum(&Window_inserter::number_passed) / most_on_an_edge > made ||
           (has_flat_face() && std::any_of(m_workers.begin(), m_workers.end(), is_crowded));
  }

private:
  std::size_t sum(std::size_t (Window_inserter::*number)() const) const
  {
    std::size_t result = 0;
    for(const auto& worker : m_workers)
      result += (worker->inserter().*number)();
    return result;
  }

  void make_workers(std::size_t number)
  {
    while(m_workers.size() < number)
      m_workers.push_back(std::make_unique<Worker>(*m_state, m_keeps_windows));
  }

  void accept(Vertex_index v, const Vertex_record& record)
  {
    m_vertex_queue.push({record.distance, v.idx(), 0});
    m_state->vertices[v] = record;
  }

  void note_waiting(Index edge, double due)
  {
    Noted noted;
    Array_part<Noted> all{&noted, &noted};
    m_state->note_waiting(edge, due, all);
    push(all);
  }

  void push(const Array_part<Noted>& noted)
  {
    for(const Noted& e : noted)
      m_edge_queue.push(e);
  }

  template <class ConcurrencyTag>
  void take_round(double bound)
  {
    begin_round(bound);
    try {
      for_each_item<ConcurrencyTag>([this](Worker& worker, Round_item& item) { worker.leave(m_round, item); });
      make_room();
      note_accuracy();
      accept_vertices();
      for_each_item<ConcurrencyTag>([this](Worker& worker, Round_item& item) { worker.enter(m_round, item); });
    } catch(...) {
      roll_back_round();
      throw;
    }
    end_round();
    give_back_passed();
  }

  // Removes the first item from the queues, together with those due soon after it. Removes nothing if it throws.
  void begin_round(double bound)
  {
    const double first = reach();
    const double last = first + m_step < bound ? first + m_step : std::nextafter(bound, 0);
    std::vector<Round_item>& items = m_state->items;
    items.clear();
    items.reserve(m_vertex_queue.look_ahead(last, m_step) + m_edge_queue.look_ahead(last, m_step));
    ++m_round;
    const auto take = [&](Round_queue& queue, bool is_vertex) {
      queue.take(last, [&](const Noted& e) {
        items.push_back({e, static_cast<std::uint32_t>(items.size()), is_vertex});
      });
    };
    take(m_vertex_queue, true);
    take(m_edge_queue, false);
  }

  // Calls `step(worker, item)` for all items of the round. If calls throw, rethrows the exception of the first of their
  // items, so that it does not depend on the number of threads.
  template <class ConcurrencyTag, class Step>
  void for_each_item(const Step& step)
  {
    std::vector<Round_item>& items = m_state->items;
    std::atomic<std::size_t> failed{items.size()};
    std::exception_ptr error;
    std::mutex mutex; // guards both
    for_each_index<ConcurrencyTag>(items.size(), [&](std::size_t i) {
      if(i > failed.load(std::memory_order_relaxed))
        return;
      try {
        step(*m_workers[thread_index<ConcurrencyTag>()], items[i]);
      } catch(...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if(i < failed)
          error = std::current_exception();
        failed = (std::min)(failed.load(), i);
      }
    });
    if(error)
      std::rethrow_exception(error);
  }

  // Reserves memory in the queues for everything that the round can insert or restore.
  void make_room()
  {
    std::size_t most = 0;
    for(const auto& worker : m_workers)
      most += worker->most_entries(m_round);
    m_vertex_queue.reserve(most);
    m_edge_queue.reserve(most);
    m_passing.reserve(most);
  }

  /*
   * Determines whether the distances that are final now are accurate. Windows have crossed at most one face per round.
   * In the frame of an edge, their source is no farther than the length of the path plus that of the edge; each face
   * moves it by the fraction `Window::step_error` of these lengths. A window lost to these errors passes a vertex
   * within them, and paths by way of the vertex are hardly longer. The sum therefore bounds the error of all distances
   * up to the longest of the round.
   */
  void note_accuracy()
  {
    double shortest = infinity;
    for(const Round_item& item : m_state->items)
      if(!item.is_vertex)
        m_longest_edge = (std::max)(m_longest_edge, item.leaving->length);
      else if(item.due.key > 0)
        shortest = (std::min)(shortest, item.due.key);
    const double part = Window::step_error * static_cast<double>(m_round);
    if(shortest < infinity && part * (shortest + 2 * m_longest_edge) > accurate_distance * shortest)
      m_has_inaccurate_distance = true;
  }

  // Updates the vertices at which paths end.
  void accept_vertices()
  {
    for(const Round_item& item : m_state->items)
      if(item.may_reach) {
        if(item.is_vertex)
          accept_along(item.due, *item.starting);
        else
          accept_across(*item.leaving);
      }
  }

  void accept_along(const Noted& e, const Starting& s)
  {
    for(const Vertex_opening& o : s.openings)
      if(m_state->is_shorter(o.head, o.distance))
        accept(o.head, {o.distance, Window(), null_index, o.along, e.id, true, false, 0});
  }

  void accept_across(const Leaving& l)
  {
    for(const Face_crossing& c : l.crossings)
      if(c.is_shorter && m_state->is_shorter(c.apex, c.distance)) {
        const Window& w = c.nearest->window;
        accept(c.apex, {c.distance, w, c.halfedge, null_index, w.root, true, false, 0});
      }
  }

  // Restores the items that a round has removed, to be processed once more, and records the results so far.
  void roll_back_round()
  {
    for(const Round_item& item : m_state->items)
      if(item.is_vertex) {
        if(item.starting != nullptr)
          push(item.starting->noted);
        m_vertex_queue.push(item.due);
      } else if(item.leaving != nullptr) {
        roll_back(*item.leaving, item.due);
      } else {
        m_edge_queue.push(item.due);
      }
  }

  void roll_back(const Leaving& l, const Noted& e)
  {
    push(l.noted);
    if(l.passed < infinity)
      m_passing.push({l.passed, e.id, 0});
    if(!(l.length > 0)) // was not waiting
      return;
    double due = infinity;
    for(Window& w : m_state->windows.on_edge(e.id))
      if(w.state == Window_state::CROSSING) {
        w.state = Window_state::WAITING;
        due = (std::min)(due, w.least_distance());
      }
    note_waiting(e.id, due);
  }

  void end_round()
  {
    double inverse_lengths = 0;
    std::size_t number = 0;
    for(const Round_item& item : m_state->items)
      if(item.is_vertex) {
        push(item.starting->noted);
      } else if(item.leaving->length > 0) {
        push(item.leaving->noted);
        ++number;
        inverse_lengths += 1 / item.leaving->length;
        if(item.leaving->passed < infinity)
          m_passing.push({item.leaving->passed, item.due.id, 0});
      }
    if(number > 0)
      m_step = static_cast<double>(number) / inverse_lengths / 4; // longer steps waste windows
  }

  void give_back_passed()
  {
    const auto has_less_spare = [](const auto& a, const auto& b) {
      return a->inserter().spare() < b->inserter().spare();
    };
    const auto clear = [&](const Noted& e) {
      (*std::min_element(m_workers.begin(), m_workers.end(), has_less_spare))->inserter().clear(m_state->windows, e.id);
    };
    const double last = std::nextafter(reach(), 0);
    m_passing.look_ahead(last, m_step);
    m_passing.take(last, clear);
  }

  const Triangulation& m_triangulation;
  bool m_keeps_windows;
  std::unique_ptr<State> m_state;
  std::vector<Source_part> m_parts;
  Round_queue m_vertex_queue, m_edge_queue; // by their distances, and by when their nearest windows are due
  Round_queue m_passing;                    // edges, by the times at which the front has passed them
  std::vector<std::unique_ptr<Worker>> m_workers;
  double m_longest_edge = 0; // of those that windows have crossed
  bool m_has_inaccurate_distance = false;
  // Of the round:
  double m_step = 0; // items due up to this much later than the first are processed as well
  std::uint32_t m_round = 0;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_PROPAGATION_H
