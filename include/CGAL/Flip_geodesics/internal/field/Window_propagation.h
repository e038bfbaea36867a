// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FIELD_WINDOW_PROPAGATION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FIELD_WINDOW_PROPAGATION_H

#include <CGAL/Flip_geodesics/internal/base/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/base/for_each_index.h>
#include <CGAL/Flip_geodesics/internal/field/Edge_windows.h>
#include <CGAL/Flip_geodesics/internal/field/Face_crossing.h>
#include <CGAL/Flip_geodesics/internal/field/Face_sides.h>
#include <CGAL/Flip_geodesics/internal/field/Round_queue.h>
#include <CGAL/Flip_geodesics/internal/field/Source_part.h>
#include <CGAL/Flip_geodesics/internal/field/Vertex_fan.h>
#include <CGAL/Flip_geodesics/internal/windows/Last_leg.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Distances on the input mesh from vertices and from straight lines in faces, exact up to rounding: windows of rays are
 * carried from face to face [MMP87]. An edge carries on all that wait on it when the nearest is due, and keeps the lower
 * envelope of what has come to it; so few windows are made twice, and the queue holds edges and vertices only.
 *
 * This is done in rounds: what is due not much later than the first comes at once. It does not matter for the distances
 * in what order windows are carried on. In each round first the faces are crossed, from all edges and vertices; then what
 * has crossed them is put on the edges that it comes to. So threads can share both halves, the edges that are left
 * and those that are entered; the results are the same for each number of threads, since one thread has the same rounds.
 */
template <class Triangulation>
class Window_propagation
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  /* \param keeps_windows if not, windows are given back once the front has passed them */
  Window_propagation(const Triangulation& triangulation, bool keeps_windows)
    : m_triangulation(triangulation)
    , m_keeps_windows(keeps_windows)
    , m_sides(triangulation)
    , m_windows(number_of_edges(triangulation))
    , m_edges(number_of_edges(triangulation))
    , m_vertices(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
    make_workers(1);
  }

  /* Makes a vertex a source. */
  void add_vertex(Vertex_index v, double offset, std::size_t source)
  {
    if(is_shorter(v, offset))
      accept(v, {offset, Window(), null_index, null_index, v.idx(), true, true, source});
  }

  /* Makes a line in a face a source, apart from ends that are vertices. */
  void add_part(const Source_part& part)
  {
    const Index root = m_triangulation.input().number_of_vertices() + static_cast<Index>(m_parts.size());
    m_parts.push_back(part);
    Input_halfedge_index h = part.halfedge;
    std::array<Face_weights, 2> ends = part.ends;
    for(Face_weights corner = {{1, 0, 0}}; h != null_index;) {
      const Vertex_index v = m_sides(h).tail;
      const double distance = part.distance(m_sides(part.halfedge), corner);
      if(is_shorter(v, distance))
        accept(v, {distance, Window(), null_index, null_index, root, true, false, 0});
      Window w = Source_part::window(m_sides(h), ends[0], ends[1], part.offset);
      w.root = root;
      note_waiting(edge_of(h), w.from < w.to ? put_beyond(m_workers.front()->inserter, h, w) : infinity);
      h = m_sides(h).next == part.halfedge ? Input_halfedge_index(null_index) : m_sides(h).next;
      ends = {{rotated(ends[0]), rotated(ends[1])}};
      corner = {{corner[2], corner[0], corner[1]}};
    }
  }

  /* Goes on until all paths shorter than `bound` are known, or there are more than `most_windows`. */
  template <class ConcurrencyTag = Sequential_tag>
  void run(double bound, std::size_t most_windows)
  {
    make_workers(number_of_threads<ConcurrencyTag>());
    if(m_workers.size() > 1)
      m_sides.share();
    while(number_of_windows() <= most_windows && reach() < bound) {
      begin_round(bound);
      try {
        compute_sides<ConcurrencyTag>();
      } catch(...) {
        give_up_round();
        throw;
      }
      cross_faces<ConcurrencyTag>();
      enter_edges<ConcurrencyTag>();
      give_back_passed();
    }
  }

  /* All paths that are shorter than this are known. */
  double reach() const { return (std::min)(m_vertex_queue.least(), m_edge_queue.least()); }

  bool is_reached(Vertex_index v) const { return m_vertices[v].is_reached; }
  double distance(Vertex_index v) const { return is_reached(v) ? m_vertices[v].distance : infinity; }
  const Vertex_record& vertex(Vertex_index v) const { return m_vertices[v]; }
  /* \pre it comes from a vertex, and is none that was made a source */
  Last_leg last_leg(Vertex_index v) const
  {
    double angle = 0;
    const Vertex_record& record = m_vertices[v];
    const Input_halfedge_index h = Vertex_fan<Triangulation>(m_triangulation).first_halfedge(m_sides, v, record, angle);
    const Vertex_index from(record.root);
    if(record.along != null_index)
      return {from, h, 0, m_triangulation.metric().length(m_triangulation.input(), record.along)};
    const Face_side& f = m_sides.known(record.through);
    return {from, h, -angle, std::hypot(f.x - record.window.x, f.y + record.window.y)};
  }
  /* The source from which paths come to a root, a vertex or a part of a source: the one at which they end. */
  std::size_t source(Index root) const
  {
    const Index n = m_triangulation.input().number_of_vertices();
    while(root < n && !m_vertices[Vertex_index(root)].is_source)
      root = m_vertices[Vertex_index(root)].root;
    return root < n ? m_vertices[Vertex_index(root)].source : m_parts[static_cast<std::size_t>(root - n)].source;
  }
  const std::vector<Source_part>& parts() const { return m_parts; }
  const Face_sides<Triangulation>& sides() const { return m_sides; }
  const Edge_windows& windows() const { return m_windows; }
  std::size_t number_of_windows() const { return sum(&Window_inserter::number_made); }
  /* Of how many windows there is room. */
  std::size_t capacity() const { return sum(&Window_inserter::capacity); }
  /* Were there faces so flat that rays can have been lost in them? */
  bool has_flat_face() const
  {
    return std::any_of(m_workers.begin(), m_workers.end(), [](const auto& w) { return w->has_flat_face; });
  }

private:
  struct Edge_record
  {
    double due;           // the least distance of the windows that are waiting
    bool is_waiting;      // are there any?
    bool is_noted;        // is it in the queue for when the front has passed it?
    std::uint32_t target; // its number among the targets of the round
  };

  // What a thread has for itself.
  struct Worker
  {
    Window_inserter inserter;
    Vertex_fan<Triangulation> fan;
    bool has_flat_face = false;
  };

  // A vertex from which paths go on in a round, or an edge whose waiting windows are carried on; and the room for them. An
  // edge has those that enter its second face at the end of it.
  template <class Place>
  struct Due
  {
    Place place;
    std::size_t first, last;
  };

  // Where windows come from to an edge.
  enum Origin { LEFT, RIGHT, VERTEX }; // of a side that they crossed; or the vertex opposite

  // An edge to which windows come in a round: from two vertices and four sides at most, from vertices on the border twice.
  struct Target
  {
    Index edge;
    std::uint32_t number;
    std::array<std::uint32_t, 8> from; // crossings or openings, by their number, times four, and the origin
    double due;
  };

  std::size_t sum(std::size_t (Window_inserter::*number)() const) const
  {
    std::size_t result = 0;
    for(const auto& worker : m_workers)
      result += (worker->inserter.*number)();
    return result;
  }

  static std::size_t number_of_edges(const Triangulation& triangulation)
  {
    return static_cast<std::size_t>(triangulation.input().number_of_halfedges()) / 2;
  }
  static Index edge_of(Input_halfedge_index h) { return h.idx() / 2; }
  Edge_record& edge_record(Index edge) { return m_edges[static_cast<std::size_t>(edge)]; }
  bool is_shorter(Vertex_index v, double distance) const { return !is_reached(v) || distance < m_vertices[v].distance; }

  void accept(Vertex_index v, const Vertex_record& record)
  {
    m_vertices[v] = record;
    m_vertex_queue.push(record.distance, v.idx());
  }

  void make_workers(std::size_t number)
  {
    while(m_workers.size() < number)
      m_workers.push_back(
          std::make_unique<Worker>(Worker{Window_inserter(), Vertex_fan<Triangulation>(m_triangulation), false}));
  }

  // Takes what is due out of the queues: the first, and what is due not much later.
  void begin_round(double bound)
  {
    const double first = reach();
    const double last = first + m_step < bound ? first + m_step : std::nextafter(bound, 0);
    m_starting.clear();
    m_leaving.clear();
    m_vertex_queue.take(last, m_step, [this](double distance, Index v) {
      if(m_vertices[Vertex_index(v)].distance == distance &&
         m_triangulation.input().outgoing(Vertex_index(v)) != null_index)
        m_starting.push_back({Vertex_index(v), 0, 0});
    });
    m_edge_queue.take(last, m_step, [this](double due, Index edge) {
      if(edge_record(edge).is_waiting && edge_record(edge).due == due) {
        edge_record(edge).is_waiting = false;
        m_leaving.push_back({edge, 0, 0});
      }
    });
  }

  // Puts it back.
  void give_up_round()
  {
    for(const Due<Vertex_index>& s : m_starting)
      m_vertex_queue.push(m_vertices[s.place].distance, s.place.idx());
    for(const Due<Index>& l : m_leaving) {
      edge_record(l.place).is_waiting = true;
      m_edge_queue.push(edge_record(l.place).due, l.place);
    }
  }

  // Computes the sides of the faces that are to be crossed, and makes room for what comes from them.
  template <class ConcurrencyTag>
  void compute_sides()
  {
    for_each_index<ConcurrencyTag>(m_starting.size() + m_leaving.size(), [this](std::size_t i) {
      Worker& worker = *m_workers[this_thread<ConcurrencyTag>()];
      if(i < m_starting.size()) {
        m_starting[i].last = compute_sides(worker, m_starting[i].place);
        return;
      }
      Due<Index>& l = m_leaving[i - m_starting.size()];
      compute_sides(worker, Input_halfedge_index(2 * l.place));
      compute_sides(worker, Input_halfedge_index(2 * l.place + 1));
      l.last = m_windows.on_edge(l.place).size();
    });
    std::size_t openings = 0, windows = 0;
    for(Due<Vertex_index>& s : m_starting) {
      s.first = openings;
      openings = s.last += openings;
    }
    for(Due<Index>& l : m_leaving) {
      l.first = windows;
      windows = l.last += windows;
    }
    m_openings.resize((std::max)(m_openings.size(), openings));
    m_crossing_windows.resize((std::max)(m_crossing_windows.size(), windows));
    m_crossings.resize((std::max)(m_crossings.size(), 2 * m_leaving.size()));
  }

  // Of the faces at a vertex. Returns how much can go on from there.
  std::size_t compute_sides(Worker& worker, Vertex_index v)
  {
    const auto& input = m_triangulation.input();
    std::size_t result = 0;
    Input_halfedge_index h = input.outgoing(v);
    do {
      compute_sides(worker, h);
      result += 2;
      h = input.next(twin_index(h));
    } while(h != input.outgoing(v));
    return result;
  }

  void compute_sides(Worker& worker, Input_halfedge_index h)
  {
    if(!m_triangulation.input().is_border(h) && m_sides.claim(h))
      worker.has_flat_face = m_sides.compute(h) || worker.has_flat_face;
  }

  // Carries what goes on from vertices and edges over the next faces, and notes where it comes to.
  template <class ConcurrencyTag>
  void cross_faces()
  {
    for_each_index<ConcurrencyTag>(m_starting.size() + m_leaving.size(), [this](std::size_t i) {
      if(i < m_starting.size())
        open(m_workers[this_thread<ConcurrencyTag>()]->fan, m_starting[i]);
      else
        cross(i - m_starting.size());
    });
    m_targets.clear();
    for(const Due<Vertex_index>& s : m_starting)
      for(std::size_t i = s.first; i < s.last; ++i)
        arrive_along(s.place, i);
    for(std::size_t i = 0; i < 2 * m_leaving.size(); ++i)
      if(m_crossings[i].first != m_crossings[i].last)
        arrive_across(i);
  }

  void open(Vertex_fan<Triangulation>& fan, Due<Vertex_index>& s)
  {
    const std::vector<Vertex_opening>& openings = fan.openings(m_sides, s.place, m_vertices[s.place]);
    s.last = s.first;
    for(const Vertex_opening& o : openings)
      if(o.opposite != null_index || is_shorter(o.head, o.distance))
        m_openings[s.last++] = o;
  }

  void cross(std::size_t i)
  {
    const Due<Index>& l = m_leaving[i];
    Crossing_window* const first = m_crossing_windows.data() + l.first;
    Crossing_window* const last = m_crossing_windows.data() + l.last;
    Crossing_window *to = first, *from = last;
    for(Window& w : m_windows.on_edge(l.place))
      if(w.is_waiting) {
        w.is_waiting = false;
        (w.side == 0 ? *to++ : *--from).window = w;
      }
    cross(m_crossings[2 * i], Input_halfedge_index(2 * l.place), first, to);
    cross(m_crossings[2 * i + 1], Input_halfedge_index(2 * l.place + 1), from, last);
  }

  void cross(Face_crossing& c, Input_halfedge_index h, Crossing_window* first, Crossing_window* last)
  {
    c.first = first;
    c.last = last;
    if(first == last)
      return;
    c.begin(h, m_sides);
    c.is_shorter = c.is_shorter && is_shorter(c.apex, c.distance);
  }

  void arrive_along(Vertex_index v, std::size_t i)
  {
    const Vertex_opening& o = m_openings[i];
    if(is_shorter(o.head, o.distance))
      accept(o.head, {o.distance, Window(), null_index, o.along, v.idx(), true, false, 0});
    if(o.opposite != null_index)
      add_target(o.opposite, i, VERTEX);
  }

  void arrive_across(std::size_t i)
  {
    const Face_crossing& c = m_crossings[i];
    if(c.is_shorter && is_shorter(c.apex, c.distance)) {
      const Window& w = c.nearest->window;
      accept(c.apex, {c.distance, w, c.halfedge, null_index, w.root, true, false, 0});
    }
    add_target(c.previous, i, LEFT);
    add_target(c.next, i, RIGHT);
  }

  void add_target(Input_halfedge_index h, std::size_t number, Origin origin)
  {
    if(m_triangulation.input().is_border(twin_index(h)))
      return;
    std::uint32_t& target = edge_record(edge_of(h)).target;
    if(!(target < m_targets.size() && m_targets[target].edge == edge_of(h))) {
      target = static_cast<std::uint32_t>(m_targets.size());
      m_targets.push_back({edge_of(h), 0, {}, infinity});
    }
    Target& t = m_targets[target];
    CGAL_assertion(t.number < t.from.size());
    t.from[t.number++] = 4 * static_cast<std::uint32_t>(number) + origin;
  }

  // Puts windows on the edges to which they come.
  template <class ConcurrencyTag>
  void enter_edges()
  {
    for_each_index<ConcurrencyTag>(m_targets.size(), [this](std::size_t i) {
      enter(m_workers[this_thread<ConcurrencyTag>()]->inserter, m_targets[i]);
    });
    for(const Target& t : m_targets)
      note_waiting(t.edge, t.due);
    double inverse_lengths = 0;
    for(const Due<Index>& l : m_leaving) {
      const Input_halfedge_index h(2 * l.place), t = twin_index(h);
      const double edge_length = m_sides.known(m_triangulation.input().is_border(h) ? t : h).length;
      inverse_lengths += 1 / edge_length;
      if(!m_keeps_windows)
        note_passing(l.place, edge_length);
    }
    if(!m_leaving.empty())
      m_step = static_cast<double>(m_leaving.size()) / inverse_lengths / 4; // longer ones waste windows
  }

  void enter(Window_inserter& inserter, Target& target)
  {
    for(std::uint32_t k = 0; k < target.number; ++k) {
      const std::uint32_t number = target.from[k] / 4, origin = target.from[k] % 4;
      if(origin == VERTEX) {
        Vertex_opening& o = m_openings[number];
        target.due = (std::min)(target.due, put_beyond(inserter, o.opposite, o.window));
        continue;
      }
      const Face_crossing& c = m_crossings[number];
      const Face_side& f = m_sides.known(c.halfedge);
      const Input_halfedge_index h = origin == LEFT ? c.previous : c.next;
      const auto put = [&](Window& w) { target.due = (std::min)(target.due, put_beyond(inserter, h, w)); };
      if(origin == LEFT)
        c.arrive_left(f, m_sides.known(h).length, put);
      else
        c.arrive_right(f, m_sides.known(h), put);
    }
  }

  /* Puts a window on the edge of h, in whose frame it is, which leaves the face on the left of h. Returns when it is due,
   * infinity if it is of no use. */
  double put_beyond(Window_inserter& inserter, Input_halfedge_index h, Window& w)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index entered = twin_index(h);
    if(input.is_border(entered))
      return infinity;
    const double length = m_sides.known(h).length;
    w.trim(distance(input.tail(h)));
    w.mirror(length);
    w.trim(distance(input.tail(entered)));
    if(!(w.from < w.to))
      return infinity;
    if(is_first_side(h)) // windows of an edge are in the frame of its first side
      w.mirror(length);
    w.side = is_first_side(entered) ? 0 : 1;
    w.is_waiting = true;
    return inserter.insert(m_windows, edge_of(h), w) ? w.least_distance() : infinity;
  }

  void note_waiting(Index edge, double due)
  {
    Edge_record& record = edge_record(edge);
    if(due == infinity || (record.is_waiting && record.due <= due))
      return;
    record.is_waiting = true;
    record.due = due;
    m_edge_queue.push(due, edge);
  }

  // When the front is farther than any point of the edge, its windows are not needed any more.
  void note_passing(Index edge, double length)
  {
    const Input_halfedge_index h(2 * edge), t = twin_index(h);
    const auto& input = m_triangulation.input();
    const double bound = (distance(input.tail(h)) + distance(input.tail(t)) + length) / 2;
    if(edge_record(edge).is_noted || bound == infinity)
      return;
    edge_record(edge).is_noted = true;
    m_passing.push(bound, edge);
  }

  void give_back_passed()
  {
    const auto has_less_spare = [](const auto& a, const auto& b) { return a->inserter.spare() < b->inserter.spare(); };
    const auto clear = [&](double, Index edge) {
      (*std::min_element(m_workers.begin(), m_workers.end(), has_less_spare))->inserter.clear(m_windows, edge);
    };
    m_passing.take(std::nextafter(reach(), 0), m_step, clear);
  }

  const Triangulation& m_triangulation;
  bool m_keeps_windows;
  Face_sides<Triangulation> m_sides;
  Edge_windows m_windows;
  Lazy_array<Edge_record> m_edges;
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> m_vertices;
  std::vector<Source_part> m_parts;
  Round_queue m_vertex_queue, m_edge_queue; // by their distances, and by when the nearest window is due
  Round_queue m_passing;                    // edges, by when the front has passed them
  std::vector<std::unique_ptr<Worker>> m_workers;
  // Of the round:
  double m_step = 0; // how much later than the first what is due is taken, too
  std::vector<Due<Vertex_index>> m_starting;
  std::vector<Due<Index>> m_leaving;
  std::vector<Vertex_opening> m_openings;
  std::vector<Crossing_window> m_crossing_windows;
  std::vector<Face_crossing> m_crossings; // two for each edge that is left
  std::vector<Target> m_targets;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FIELD_WINDOW_PROPAGATION_H
