// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_WINDOW_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_WINDOW_SEARCH_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/base/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/input/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/strips/Vertex_directions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Shortest paths on the input mesh from one vertex, exact up to rounding: windows of straight rays are carried from
 * face to face [MMP87], in the order of a lower bound, and dropped where a shorter way is known [CH90, XW09].
 *
 * A window is a part of an edge together with the place, unfolded into the plane of the edge, of the vertex that the
 * rays come from. It lies in the frame of halfedge h, which has the face to be entered on its left:
 *
 *                     apex
 *                    /    .
 *          hp       /       .  hn          the edge is the segment from 0 to `length` on the x-axis,
 *                  /          .            the rays start at (x, -y), pass between `from` and `to`,
 *         tail 0 --from==to----- length    and have run `sigma` before
 *                    .  /       h
 *                     ./
 *                   (x, -y)
 *
 * With a target, windows are ordered by the least length that a path through them to the target can have.
 */
template <class Triangulation>
class Window_search
{
  using Vector = std::complex<double>;

public:
  /* How a shortest path arrives at a vertex: straight from another, along a word. */
  struct Leg
  {
    Vertex_index from = null_index;
    Crossing_word word;
  };

  Window_search(const Triangulation& triangulation, Vertex_index source, Vertex_index target = null_index)
    : m_triangulation(triangulation)
    , m_source(source)
    , m_target(target)
    , m_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
    , m_faces(static_cast<std::size_t>(triangulation.number_of_halfedges()))
    , m_splits(static_cast<std::size_t>(triangulation.number_of_halfedges()))
  {
    offer(source, 0, null_index, null_index);
  }

  /*
   * Goes on until all paths shorter than `bound` are known, or there are more than `most_windows`. With a target, only
   * those that can lead to it.
   */
  void run(double bound, std::size_t most_windows = (std::numeric_limits<std::size_t>::max)())
  {
    while(!m_heap.empty() && m_windows.size() <= most_windows) {
      const Entry entry = m_heap.front();
      if(entry.priority >= (std::min)(bound, m_target == null_index ? bound : distance(m_target)))
        return;
      std::pop_heap(m_heap.begin(), m_heap.end());
      m_heap.pop_back();
      if(!entry.is_vertex)
        propagate(entry.id);
      else if(const Vertex_index v(entry.id); m_vertices[v].distance == entry.distance)
        start_from(v);
    }
  }

  /* No path to the target, or to a vertex that is not reached yet, is shorter than this unless it is known. */
  double lower_bound() const
  {
    return m_heap.empty() ? std::numeric_limits<double>::infinity() : m_heap.front().priority;
  }

  /* The length of the shortest path found to a vertex; infinite if there is none yet. */
  double distance(Vertex_index v) const
  {
    return is_reached(v) ? m_vertices[v].distance : std::numeric_limits<double>::infinity();
  }

  /* Were there faces so flat that rays can have been lost in them? Then there may be shorter paths. */
  bool has_flat_face() const { return m_has_flat_face; }

  bool is_reached(Vertex_index v) const { return m_vertices[v].is_reached; }
  std::size_t number_of_windows() const { return m_windows.size(); }

  /* The last leg of the shortest path found to a vertex that is not the source. */
  Leg leg(Vertex_index v) const
  {
    const Vertex_record& record = m_vertices[v];
    Leg result;
    if(record.window == null_index) {
      result.from = m_triangulation.input().tail(record.along);
      result.word.along = record.along;
      return result;
    }
    for(Index w = record.window; w != null_index; w = m_windows[w].parent) {
      result.word.crossed.push_back(twin_index(m_windows[w].halfedge));
      result.from = m_windows[w].root;
    }
    std::reverse(result.word.crossed.begin(), result.word.crossed.end());
    return result;
  }

private:
  struct Vertex_record
  {
    double distance;
    Index window; // through which window the path arrives, null_index if along a halfedge
    Input_halfedge_index along;
    bool is_reached;
    char is_passable; // 0 if not known, 1 if shortest paths may pass the vertex, 2 if not
  };

  // The face on the left of a halfedge.
  struct Face_record
  {
    double length;
    double x, y; // of the apex
  };

  // The window that has the shortest way to the apex, of those that enter a face through one edge [CH90].
  struct Split
  {
    double distance, crossing;
    bool is_set;
  };

  struct Window
  {
    Input_halfedge_index halfedge;
    Index parent; // the window before, null_index if there is none
    Vertex_index root;
    double from, to, x, y, sigma;
  };

  struct Entry
  {
    double priority, distance;
    Index id; // of a window or a vertex
    bool is_vertex;

    // std heaps hand out the largest.
    bool operator<(const Entry& other) const
    {
      if(priority != other.priority)
        return priority > other.priority;
      return is_vertex != other.is_vertex ? other.is_vertex : id > other.id;
    }
  };

  const Face_record& face(Input_halfedge_index h)
  {
    Face_record& record = m_faces[h];
    if(record.length == 0) {
      const auto vectors = input_face_geometry(m_triangulation, h);
      record = {vectors[0].x, vectors[0].x + vectors[1].x, vectors[1].y};
      constexpr double flat = 1e-10;
      m_has_flat_face = m_has_flat_face || !(record.y > flat * (record.length + std::abs(record.x)));
    }
    return record;
  }

  void push(double priority, double distance, Index id, bool is_vertex)
  {
    m_heap.push_back({priority, distance, id, is_vertex});
    std::push_heap(m_heap.begin(), m_heap.end());
  }

  double to_target(Vertex_index v) const
  {
    if(m_target == null_index)
      return 0;
    const auto& metric = m_triangulation.metric();
    return metric.distance_lower_bound(metric.place(m_triangulation.input(), v),
                                       metric.place(m_triangulation.input(), m_target));
  }

  // A path to v has been found.
  void offer(Vertex_index v, double distance, Index window, Input_halfedge_index along)
  {
    Vertex_record& record = m_vertices[v];
    if(record.is_reached && record.distance <= distance)
      return;
    record.distance = distance;
    record.window = window;
    record.along = along;
    record.is_reached = true;
    if(v == m_source || is_passable(v))
      push(distance + to_target(v), distance, v.idx(), true);
  }

  // Shortest paths bend at vertices on the border and where the angles add up to more than 2 pi, nowhere else.
  bool is_passable(Vertex_index v)
  {
    char& known = m_vertices[v].is_passable;
    if(known == 0) {
      constexpr double tolerance = 1e-9; // towards more windows
      const Vertex_directions<Triangulation> directions(m_triangulation, v);
      const bool is_convex =
          !directions.has_border() && directions.total() < boost::math::constants::two_pi<double>() - tolerance;
      known = is_convex ? 2 : 1;
    }
    return known == 1;
  }

  // Opens windows on all edges opposite to v, and paths along its edges.
  void start_from(Vertex_index v)
  {
    const auto& input = m_triangulation.input();
    const double sigma = m_vertices[v].distance;
    const Input_halfedge_index first = input.outgoing(v);
    if(first == null_index)
      return;
    Input_halfedge_index h = first;
    do {
      offer(input.tail(twin_index(h)), sigma + m_triangulation.metric().length(input, h), null_index, h);
      if(!input.is_border(h)) {
        const Input_halfedge_index opposite = input.next(h), entered = twin_index(opposite);
        const Face_record& f = face(opposite);
        if(f.y > 0) // seen from the other side the edge is reversed
          open({entered, null_index, v, 0, f.length, f.length - f.x, f.y, sigma});
      }
      h = input.next(twin_index(h));
    } while(h != first);
  }

  // Keeps a window if it can be of use.
  void open(const Window& w)
  {
    const auto& input = m_triangulation.input();
    if(input.is_border(w.halfedge) || !(w.to > w.from))
      return;
    const Vertex_index tail = input.tail(w.halfedge), head = input.tail(twin_index(w.halfedge));
    const double length = face(w.halfedge).length;
    const double to_from = w.sigma + std::hypot(w.from - w.x, w.y), to_to = w.sigma + std::hypot(w.to - w.x, w.y);
    if(distance(tail) + w.to <= to_to || distance(head) + (length - w.from) <= to_from) // all through it are shorter
      return;
    const double nearest = (std::min)((std::max)(w.x, w.from), w.to);
    const double least = w.sigma + std::hypot(nearest - w.x, w.y);
    m_windows.push_back(w);
    push(least + to_target(w), least, static_cast<Index>(m_windows.size()) - 1, false);
  }

  // At least as far as the farther end of the edge, less its length.
  double to_target(const Window& w) const
  {
    if(m_target == null_index)
      return 0;
    const auto& input = m_triangulation.input();
    const double tail = to_target(input.tail(w.halfedge)), head = to_target(input.tail(twin_index(w.halfedge)));
    const double length = m_faces[w.halfedge].length;
    return (std::max)({0.0, tail - w.to, head - (length - w.from)});
  }

  void propagate(Index id)
  {
    const Window w = m_windows[id];
    const Face_record f = face(w.halfedge);
    const auto& input = m_triangulation.input();
    const Input_halfedge_index hn = input.next(w.halfedge), hp = input.next(hn);
    if(!(w.y + f.y > 0))
      return;
    const double crossing = w.x + (f.x - w.x) * (w.y / (w.y + f.y)); // where the ray to the apex passes the edge
    const Vector apex(f.x, f.y), tail(0, 0), head(f.length, 0);
    if(crossing <= w.from)
      return enter(id, twin_index(hn), apex, head, w.from, w.to);
    if(crossing >= w.to)
      return enter(id, twin_index(hp), tail, apex, w.from, w.to);

    const double through = w.sigma + std::hypot(f.x - w.x, f.y + w.y);
    offer(input.tail(hp), through, id, null_index);
    Split& split = m_splits[w.halfedge];
    const bool is_best = !split.is_set || through < split.distance;
    // Towards more windows: which of two rays along one line is on the left is a matter of rounding.
    const double equal = 1e-9 * f.length;
    const bool is_left_of_best = split.is_set && crossing <= split.crossing + equal;
    const bool is_right_of_best = split.is_set && crossing >= split.crossing - equal;
    if(is_best)
      split = {through, crossing, true};
    // One that is not the best at the apex is of no use beyond the best one's ray.
    if(is_best || is_left_of_best)
      enter(id, twin_index(hp), tail, apex, w.from, crossing);
    if(is_best || is_right_of_best)
      enter(id, twin_index(hn), apex, head, crossing, w.to);
  }

  // Carries the rays of a window between two of its points on to the edge of h, which runs from p to q.
  void enter(Index id, Input_halfedge_index h, const Vector& p, const Vector& q, double from, double to)
  {
    const Window& w = m_windows[id];
    const Vector start(w.x, -w.y), axis = (q - p) / std::abs(q - p);
    const double length = std::abs(q - p);
    const Vector seen = (start - p) * std::conj(axis);
    if(!(seen.imag() < 0))
      return;
    const auto hit = [&](double b) {
      const Vector point = (Vector(b, 0) - p) * std::conj(axis);
      const double fall = point.imag() - seen.imag();
      const double x = fall > 0 ? seen.real() - seen.imag() * ((point.real() - seen.real()) / fall) : 0;
      return (std::min)((std::max)(x, 0.0), length);
    };
    open({h, id, w.root, hit(from), hit(to), seen.real(), -seen.imag(), w.sigma});
  }

  const Triangulation& m_triangulation;
  Vertex_index m_source, m_target;
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> m_vertices;
  Indexed_by<Input_halfedge_index, Lazy_array<Face_record>> m_faces;
  Indexed_by<Input_halfedge_index, Lazy_array<Split>> m_splits;
  std::vector<Window> m_windows;
  std::vector<Entry> m_heap;
  bool m_has_flat_face = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_WINDOW_SEARCH_H
