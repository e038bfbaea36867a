// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FIELD_WINDOW_PROPAGATION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FIELD_WINDOW_PROPAGATION_H

#include <CGAL/Flip_geodesics/internal/base/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/base/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/field/Edge_windows.h>
#include <CGAL/Flip_geodesics/internal/field/Face_sides.h>
#include <CGAL/Flip_geodesics/internal/field/Source_part.h>
#include <CGAL/Flip_geodesics/internal/windows/Last_leg.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Distances on the input mesh from vertices and from straight lines in faces, exact up to rounding: windows of rays are
 * carried from face to face [MMP87]. An edge carries on all that wait on it when the nearest is due, and keeps the lower
 * envelope of what has come to it; so few windows are made twice, and the queue holds edges and vertices only.
 *
 * Vertices become sources themselves, for the directions in which shortest paths can go on from them: at an angle of at
 * least pi from where they came, on both sides.
 */
template <class Triangulation>
class Window_propagation
{
  using Vector = std::complex<double>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  /* How the shortest path known arrives at a vertex. */
  struct Vertex_record
  {
    double distance;
    Window window;                // through which it arrives, in the frame of `through`
    Input_halfedge_index through; // the side by which it enters its last face; null if it crosses no edge
    Input_halfedge_index along;   // the halfedge along which it arrives, or null
    Index root;                   // the vertex, or the part of a source, that it comes from
    bool is_reached, is_source;
    std::size_t source;
  };

  /* \param keeps_windows if not, windows are given back once the front has passed them */
  Window_propagation(const Triangulation& triangulation, bool keeps_windows)
    : m_triangulation(triangulation)
    , m_keeps_windows(keeps_windows)
    , m_sides(triangulation)
    , m_windows(number_of_edges(triangulation))
    , m_edges(number_of_edges(triangulation))
    , m_vertices(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
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
        accept(v, {distance, Window(), null_index, null_index, root, true, false, part.source});
      Window w = Source_part::window(m_sides(h), ends[0], ends[1], part.offset);
      w.root = root;
      note_waiting(edge_of(h), w.from < w.to ? open_beyond(h, w) : infinity);
      h = m_sides(h).next == part.halfedge ? Input_halfedge_index(null_index) : m_sides(h).next;
      ends = {{rotated(ends[0]), rotated(ends[1])}};
      corner = {{corner[2], corner[0], corner[1]}};
    }
  }

  /* Goes on until all paths shorter than `bound` are known, or there are more than `most_windows`. */
  void run(double bound, std::size_t most_windows)
  {
    while(!m_queue.empty() && number_of_windows() <= most_windows && m_queue.top().key() < bound) {
      const Entry entry = m_queue.top();
      m_queue.pop();
      switch(entry.kind()) {
      case Entry::PASSED_EDGE:
        m_windows.clear(entry.id());
        break;
      case Entry::EDGE:
        if(edge_record(entry.id()).is_waiting && edge_record(entry.id()).due == entry.key())
          carry_on(entry.id());
        break;
      case Entry::VERTEX:
        if(m_vertices[Vertex_index(entry.id())].distance == entry.key())
          start_from(Vertex_index(entry.id()));
        break;
      }
    }
  }

  /* All paths that are shorter than this are known. */
  double reach() { return m_queue.empty() ? infinity : m_queue.top().key(); }

  bool is_reached(Vertex_index v) const { return m_vertices[v].is_reached; }
  double distance(Vertex_index v) const { return is_reached(v) ? m_vertices[v].distance : infinity; }
  const Vertex_record& vertex(Vertex_index v) const { return m_vertices[v]; }
  /* \pre it comes from a vertex, and is none that was made a source */
  Last_leg last_leg(Vertex_index v) const
  {
    double angle = 0;
    const Input_halfedge_index h = first_halfedge(v, angle);
    const Vertex_record& record = m_vertices[v];
    const Vertex_index from(record.root);
    if(record.along != null_index)
      return {from, h, 0, m_triangulation.metric().length(m_triangulation.input(), record.along)};
    const Face_side& f = m_sides.known(record.through);
    return {from, h, -angle, std::hypot(f.x - record.window.x, f.y + record.window.y)};
  }
  const std::vector<Source_part>& parts() const { return m_parts; }
  const Face_sides<Triangulation>& sides() const { return m_sides; }
  const Edge_windows& windows() const { return m_windows; }
  std::size_t number_of_windows() const { return m_windows.number_made(); }
  /* Were there faces so flat that rays can have been lost in them? */
  bool has_flat_face() const { return m_sides.has_flat_face(); }

private:
  struct Edge_record
  {
    double due;      // the least distance of the windows that are waiting
    bool is_waiting; // are there any?
    bool is_noted;   // is it in the queue for when the front has passed it?
  };

  struct Entry
  {
    enum Kind { PASSED_EDGE, EDGE, VERTEX };

    std::uint64_t bits, what;

    Entry() = default;
    Entry(double key, Kind kind, Index id)
      : bits(ordered_bits(key))
      , what((static_cast<std::uint64_t>(kind) << 32) | static_cast<std::uint32_t>(id))
    {
    }
    double key() const
    {
      double result;
      std::memcpy(&result, &bits, sizeof result);
      return result;
    }
    Kind kind() const { return static_cast<Kind>(what >> 32); }
    Index id() const { return static_cast<Index>(what & 0xffffffffu); }

    static std::size_t is_before(const Entry& a, const Entry& b)
    {
      return static_cast<std::size_t>(a.bits < b.bits) |
             (static_cast<std::size_t>(a.bits == b.bits) & static_cast<std::size_t>(a.what < b.what));
    }
  };

  // A face at a vertex, counterclockwise of a halfedge that starts there.
  struct Fan_face
  {
    Input_halfedge_index halfedge;
    double angle, corner; // of the halfedge, from where the path to the vertex comes; and of the face
  };

  static std::size_t number_of_edges(const Triangulation& triangulation)
  {
    return static_cast<std::size_t>(triangulation.input().number_of_halfedges()) / 2;
  }
  static Index edge_of(Input_halfedge_index h) { return h.idx() / 2; }
  Edge_record& edge_record(Index edge) { return m_edges[static_cast<std::size_t>(edge)]; }
  bool is_shorter(Vertex_index v, double distance) const { return !is_reached(v) || distance < m_vertices[v].distance; }

  std::size_t source_of(Index root) const
  {
    const Index n = m_triangulation.input().number_of_vertices();
    return root < n ? m_vertices[Vertex_index(root)].source : m_parts[static_cast<std::size_t>(root - n)].source;
  }

  void accept(Vertex_index v, const Vertex_record& record)
  {
    m_vertices[v] = record;
    m_queue.push(Entry(record.distance, Entry::VERTEX, v.idx()));
  }

  // Opens paths along the edges of a vertex, and windows on the edges opposite.
  void start_from(Vertex_index v)
  {
    if(m_triangulation.input().outgoing(v) == null_index)
      return;
    double angle = 0;
    const Input_halfedge_index start = first_halfedge(v, angle);
    const Vertex_record& record = m_vertices[v];
    const bool is_free = record.through == null_index && record.along == null_index;
    const Input_halfedge_index border = walk_counterclockwise(start, angle);
    const double bend = is_free ? -infinity : boost::math::constants::pi<double>() - rounding;
    const double total = m_fan.back().angle + m_fan.back().corner - angle;
    const double most = border == null_index ? total - bend : infinity;
    for(const Fan_face& face : m_fan)
      open_opposite(v, face, bend, most);
    if(border == null_index)
      return;
    walk_clockwise(start, angle, border);
    for(const Fan_face& face : m_fan)
      open_opposite(v, face, -infinity, -bend);
  }

  // A halfedge that starts at v, and its angle counterclockwise from where the path to v comes.
  Input_halfedge_index first_halfedge(Vertex_index v, double& angle) const
  {
    const Vertex_record& record = m_vertices[v];
    if(record.along != null_index)
      return twin_index(record.along);
    if(record.through == null_index)
      return m_triangulation.input().outgoing(v);
    const Face_side& f = m_sides.known(record.through);
    const Window& w = record.window;
    const Vector apex(f.x, f.y), back = Vector(w.x, -w.y) - w.weight() * apex;
    angle = -std::arg(back * std::conj(-apex));
    return m_sides.known(f.next).next;
  }

  // Up to the border, whose halfedge is returned, or all round.
  Input_halfedge_index walk_counterclockwise(Input_halfedge_index start, double angle)
  {
    m_fan.clear();
    Input_halfedge_index h = start;
    do {
      if(m_triangulation.input().is_border(h)) {
        m_fan.push_back({h, angle, 0});
        return h;
      }
      const Face_side& f = m_sides(h);
      m_fan.push_back({h, angle, std::atan2(f.sine, f.cosine)});
      angle += m_fan.back().corner;
      h = twin_index(m_sides.known(f.next).next);
    } while(h != start);
    return null_index;
  }

  // From there on, also over the border, beyond which all directions are open.
  void walk_clockwise(Input_halfedge_index start, double angle, Input_halfedge_index end)
  {
    constexpr double far_away = 1e100;
    const auto& input = m_triangulation.input();
    m_fan.clear();
    for(Input_halfedge_index h = start;;) {
      angle = input.is_border(twin_index(h)) ? -far_away : angle;
      h = input.next(twin_index(h));
      if(h == end)
        return;
      const double corner = input.is_border(h) ? 0 : std::atan2(m_sides(h).sine, m_sides(h).cosine);
      angle -= corner;
      m_fan.push_back({h, angle, corner});
    }
  }

  // A path along the edge at which a face starts, and a window on the edge opposite, for angles in [least, most].
  void open_opposite(Vertex_index v, const Fan_face& face, double least, double most)
  {
    const Vertex_record& record = m_vertices[v];
    const Input_halfedge_index h = face.halfedge, t = twin_index(h);
    const bool is_border = m_triangulation.input().is_border(h);
    const double distance = record.distance + (is_border ? m_sides(t) : m_sides(h)).length;
    const Vertex_index head = m_triangulation.input().tail(t);
    if(is_shorter(head, distance))
      accept(head, {distance, Window(), null_index, h, v.idx(), true, false, record.source});
    if(is_border || face.angle > most || face.angle + face.corner < least)
      return;
    const Input_halfedge_index opposite = m_sides.known(h).next;
    const Face_side& f = m_sides.known(opposite);
    const double first = face.angle < least ? hit(f, least - face.angle) : 0;
    const double last = face.angle + face.corner > most ? hit(f, most - face.angle) : f.length;
    Window w = {first, last, f.x, f.y, record.distance, v.idx(), 0, false, true};
    if(first < last && f.y > 0)
      note_waiting(edge_of(opposite), open_beyond(opposite, w));
  }

  // Where a ray from the vertex opposite meets a side, at an angle from the line to the tail.
  static double hit(const Face_side& f, double angle)
  {
    const Vector ray = Vector(-f.x, -f.y) * std::polar(1.0, angle);
    if(!(ray.imag() < 0))
      return ray.real() < 0 ? 0 : f.length;
    return (std::min)((std::max)(f.x - f.y * (ray.real() / ray.imag()), 0.0), f.length);
  }

  /* Puts a window on the edge of h, in whose frame it is, which leaves the face on the left of h. Returns when it is due,
   * infinity if it is of no use. */
  double open_beyond(Input_halfedge_index h, Window& w)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index entered = twin_index(h);
    if(input.is_border(entered))
      return infinity;
    const double length = m_sides(h).length;
    trim(w, distance(input.tail(h)));
    w.mirror(length);
    trim(w, distance(input.tail(entered)));
    if(!(w.from < w.to))
      return infinity;
    if(is_first_side(h)) // windows of an edge are in the frame of its first side
      w.mirror(length);
    w.side = is_first_side(entered) ? 0 : 1;
    w.is_waiting = true;
    return m_windows.insert(edge_of(h), w) ? w.least_distance() : infinity;
  }

  // Takes off the part to which it is nearer from the start of the edge, along the edge.
  static void trim(Window& w, double to_start)
  {
    constexpr double tie = 2e-14; // towards more windows
    const double more = to_start * (1 + tie) - w.sigma;
    if(!(w.distance(w.from) - w.sigma > w.from + more))
      return;
    if(w.distance(w.to) - w.sigma > w.to + more) {
      w.from = w.to;
      return;
    }
    const double b = w.is_far ? -more / (1 + w.x) : (w.x * w.x + w.y * w.y - more * more) / (2 * (w.x + more));
    w.from = (std::min)((std::max)(w.from, b), w.to);
  }

  void note_waiting(Index edge, double due)
  {
    Edge_record& record = edge_record(edge);
    if(due == infinity || (record.is_waiting && record.due <= due))
      return;
    record.is_waiting = true;
    record.due = due;
    m_queue.push(Entry(due, Entry::EDGE, edge));
  }

  // Carries the waiting windows of an edge over the faces that they enter.
  void carry_on(Index edge)
  {
    edge_record(edge).is_waiting = false;
    for(std::vector<Window>& batch : m_batches)
      batch.clear();
    for(Window& w : m_windows.on_edge(edge))
      if(w.is_waiting) {
        w.is_waiting = false;
        m_batches[w.side].push_back(w);
      }
    for(std::size_t side = 0; side < 2; ++side)
      if(!m_batches[side].empty())
        cross_face(Input_halfedge_index(2 * edge + static_cast<Index>(side)), m_batches[side]);
    if(!m_keeps_windows)
      note_passing(edge);
  }

  // When the front is farther than any point of the edge, its windows are not needed any more.
  void note_passing(Index edge)
  {
    const Input_halfedge_index h(2 * edge), t = twin_index(h);
    const auto& input = m_triangulation.input();
    const double length = m_sides(input.is_border(h) ? t : h).length;
    const double bound = (distance(input.tail(h)) + distance(input.tail(t)) + length) / 2;
    if(edge_record(edge).is_noted || bound == infinity)
      return;
    edge_record(edge).is_noted = true;
    m_queue.push(Entry(bound, Entry::PASSED_EDGE, edge));
  }

  void cross_face(Input_halfedge_index h, std::vector<Window>& batch)
  {
    const Face_side f = m_sides(h), fn = m_sides.known(f.next);
    if(!is_first_side(h))
      for(Window& w : batch)
        w.mirror(f.length);
    const double equal = 1e-9 * f.length;
    const double best_crossing = arrive_at_apex(h, f, m_sides.known(fn.next).tail, batch, equal);
    double due_left = infinity, due_right = infinity;
    for(const Window& w : batch) {
      const double c = w.crossing(f.x, f.y);
      // One that is not the best at the apex is of no use beyond the best one's ray [CH90].
      const bool is_split = c > w.from && c < w.to;
      if(c > w.from && (!is_split || c <= best_crossing + equal))
        due_left = (std::min)(due_left, enter_left(w, c, equal, f, fn.next));
      if(c < w.to && (!is_split || c >= best_crossing - equal))
        due_right = (std::min)(due_right, enter_right(w, c, equal, f, fn));
    }
    note_waiting(edge_of(fn.next), due_left);
    note_waiting(edge_of(f.next), due_right);
  }

  // Offers the vertex opposite the path through the window that has the shortest. Returns where that crosses the edge.
  double arrive_at_apex(Input_halfedge_index h, const Face_side& f, Vertex_index apex, const std::vector<Window>& batch,
                        double equal)
  {
    double best = infinity, best_crossing = 0;
    const Window* nearest = nullptr;
    for(const Window& w : batch) {
      const double c = w.crossing(f.x, f.y);
      if(!(c > w.from - equal && c < w.to + equal))
        continue;
      const double through = w.distance(f.x, f.y);
      if(through < best) {
        best = through;
        best_crossing = c;
        nearest = &w;
      }
    }
    if(nearest != nullptr && is_shorter(apex, best))
      accept(apex, {best, *nearest, h, null_index, nearest->root, true, false, source_of(nearest->root)});
    return best_crossing;
  }

  // Of a window the part before the ray to the apex, which crosses at c, goes on through the side at the tail, hp.
  double enter_left(const Window& w, double c, double equal, const Face_side& f, Input_halfedge_index hp)
  {
    const double length = m_sides.known(hp).length;
    Window child = turned(w, f.cosine, f.sine, (std::min)(c, w.to), c < w.to + equal, length);
    if(!(child.y > 0))
      return infinity;
    child.mirror(length);
    return open_beyond(hp, child);
  }

  // The part behind it through the side at the head: mirror images.
  double enter_right(Window w, double c, double equal, const Face_side& f, const Face_side& fn)
  {
    w.mirror(f.length);
    Window child =
        turned(w, fn.cosine, fn.sine, (std::min)(f.length - c, w.to), f.length - c < w.to + equal, fn.length);
    return child.y > 0 ? open_beyond(f.next, child) : infinity;
  }

  // The part of a window up to `to` in the frame of a side that starts at the same vertex, at an angle above.
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

  static constexpr double rounding = 1e-12; // of sums of angles, towards more windows

  const Triangulation& m_triangulation;
  bool m_keeps_windows;
  Face_sides<Triangulation> m_sides;
  Edge_windows m_windows;
  Lazy_array<Edge_record> m_edges;
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> m_vertices;
  std::vector<Source_part> m_parts;
  Heap_of_four<Entry> m_queue;
  std::array<std::vector<Window>, 2> m_batches; // being carried on, by the side that they enter
  std::vector<Fan_face> m_fan;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FIELD_WINDOW_PROPAGATION_H
