// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_WINDOW_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_WINDOW_SEARCH_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/base/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/windows/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/windows/Unfolded_faces.h>

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
 * With a target, and a sweep from there, windows are ordered by the least length that a path through them to the target
 * can have, and dropped where that is longer than all that is looked for.
 */
template <class Triangulation>
class Window_search
{
  using Faces = Unfolded_faces<Triangulation>;
  using Sweep = Cone_sweep<Triangulation>;
  using Vector = typename Faces::Vector;

public:
  /* How a shortest path arrives at a vertex: straight from another, along a word. */
  struct Leg
  {
    Vertex_index from = null_index;
    Crossing_word word;
  };

  /*
   * Searches from the source to all vertices. With a sweep from a target, only paths to there that are no longer than the
   * sweep's bound.
   */
  Window_search(const Triangulation& triangulation, Faces& faces, Vertex_index source, const Sweep* sweep = nullptr)
    : m_triangulation(triangulation)
    , m_faces(faces)
    , m_source(source)
    , m_sweep(sweep)
    , m_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /*
   * Goes on until all paths shorter than `bound` are known, or there are more than `most_windows`. With a sweep, only
   * those that can lead to its source.
   */
  void run(double bound, std::size_t most_windows = (std::numeric_limits<std::size_t>::max)())
  {
    if(!is_reached(m_source))
      offer(m_source, 0, null_index, null_index);
    while(!m_heap.empty() && m_windows.size() <= most_windows) {
      const Entry entry = m_heap.front();
      if(entry.priority >= (m_sweep == nullptr ? bound : (std::min)(bound, distance(m_sweep->source()))))
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
  };

  // The window that has the shortest way to the apex, of those that enter a face through one edge [CH90].
  struct Split
  {
    double distance = 0, crossing = 0;
    bool is_set = false;
  };

  struct Window
  {
    Input_halfedge_index halfedge;
    Index parent; // the window before, null_index if there is none
    Vertex_index root;
    double from, to, x, y, sigma;
  };

  // The other edges of a face, seen from the one that is the x-axis.
  struct Edge
  {
    Input_halfedge_index halfedge; // that has the next face on its left
    double length;
    Vector axis;             // its direction
    double base, base_place; // where it meets the x-axis, there, and on itself
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

  // The place of the corner opposite to a side.
  Vector apex(Index side)
  {
    constexpr double flat = 1e-10;
    const Vector result = m_faces.apex(side);
    m_has_flat_face = m_has_flat_face || !(result.imag() > flat * (m_faces[side].length + std::abs(result.real())));
    return result;
  }

  void push(double priority, double distance, Index id, bool is_vertex)
  {
    m_heap.push_back({priority, distance, id, is_vertex});
    std::push_heap(m_heap.begin(), m_heap.end());
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
    const double rest = m_sweep == nullptr ? 0 : m_sweep->distance_lower_bound(v);
    if((v == m_source || m_faces.is_passable(v)) && is_wanted(distance + rest))
      push(distance + rest, distance, v.idx(), true);
  }

  // Can a path of this length be of use?
  bool is_wanted(double length) const { return m_sweep == nullptr || length <= m_sweep->bound(); }

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
        const Index opposite = Faces::next(m_faces.number(h));
        const Vector place = apex(opposite);
        const auto& [length, cosine, sine, halfedge, tail] = m_faces[opposite];
        static_cast<void>(cosine), static_cast<void>(sine);
        if(place.imag() > 0) // seen from the other side the edge is reversed
          open({twin_index(halfedge), null_index, v, 0, length, length - place.real(), place.imag(), sigma}, length);
      }
      h = input.next(twin_index(h));
    } while(h != first);
  }

  // Keeps a window on an edge of some length if it can be of use.
  void open(const Window& w, double length)
  {
    const auto& input = m_triangulation.input();
    if(input.is_border(w.halfedge) || !(w.to > w.from))
      return;
    const Vertex_index tail = input.tail(w.halfedge), head = input.tail(twin_index(w.halfedge));
    const double to_from = w.sigma + norm(w.from - w.x, w.y), to_to = w.sigma + norm(w.to - w.x, w.y);
    if(distance(tail) + w.to <= to_to || distance(head) + (length - w.from) <= to_from) // all through it are shorter
      return;
    const double nearest = (std::min)((std::max)(w.x, w.from), w.to);
    const double least = w.sigma + norm(nearest - w.x, w.y);
    const double total =
        m_sweep == nullptr ? least : m_sweep->through(w.halfedge, length, {w.x, w.y, w.sigma}, w.from, w.to);
    if(!is_wanted(total))
      return;
    m_windows.push_back(w);
    push(total, least, static_cast<Index>(m_windows.size()) - 1, false);
  }

  void propagate(Index id)
  {
    const Window w = m_windows[id];
    const Index side = m_faces.number(w.halfedge);
    const Vector apex = this->apex(side);
    const auto base = m_faces[side], next = m_faces[Faces::next(side)], previous = m_faces[Faces::previous(side)];
    const Edge left = {twin_index(previous.halfedge), previous.length, {base.cosine, base.sine}, 0, 0};
    const Edge right = {twin_index(next.halfedge), next.length, {next.cosine, -next.sine}, base.length, next.length};
    if(!(w.y + apex.imag() > 0))
      return;
    // Where the ray to the apex passes the edge.
    const double crossing = w.x + (apex.real() - w.x) * (w.y / (w.y + apex.imag()));
    if(crossing <= w.from)
      return enter(id, right, w.from, w.to);
    if(crossing >= w.to)
      return enter(id, left, w.from, w.to);

    const double through = w.sigma + norm(apex.real() - w.x, apex.imag() + w.y);
    offer(previous.tail, through, id, null_index);
    if(m_splits.size() < m_faces.size())
      m_splits.resize(m_faces.size());
    Split& split = m_splits[static_cast<std::size_t>(side)];
    const bool is_best = !split.is_set || through < split.distance;
    // Towards more windows: which of two rays along one line is on the left is a matter of rounding.
    const double equal = 1e-9 * base.length;
    const bool is_left_of_best = split.is_set && crossing <= split.crossing + equal;
    const bool is_right_of_best = split.is_set && crossing >= split.crossing - equal;
    if(is_best)
      split = {through, crossing, true};
    // One that is not the best at the apex is of no use beyond the best one's ray.
    if(is_best || is_left_of_best)
      enter(id, left, w.from, crossing);
    if(is_best || is_right_of_best)
      enter(id, right, crossing, w.to);
  }

  // Carries the rays of a window between two of its points on to another edge of the face that they enter.
  void enter(Index id, const Edge& edge, double from, double to)
  {
    const Window& w = m_windows[id];
    const auto in_frame = [&](double x, double y) {
      return Vector(x - edge.base, y) * std::conj(edge.axis) + edge.base_place;
    };
    const Vector seen = in_frame(w.x, -w.y);
    if(!(seen.imag() < 0))
      return;
    const auto hit = [&](double b) {
      const Vector point = in_frame(b, 0);
      const double fall = point.imag() - seen.imag();
      const double x = fall > 0 ? seen.real() - seen.imag() * ((point.real() - seen.real()) / fall) : 0;
      return (std::min)((std::max)(x, 0.0), edge.length);
    };
    open({edge.halfedge, id, w.root, hit(from), hit(to), seen.real(), -seen.imag(), w.sigma}, edge.length);
  }

  static double norm(double x, double y) { return std::sqrt(x * x + y * y); }

  const Triangulation& m_triangulation;
  Faces& m_faces;
  Vertex_index m_source;
  const Sweep* m_sweep;
  Indexed_by<Vertex_index, Lazy_array<Vertex_record>> m_vertices;
  std::vector<Split> m_splits; // of sides
  std::vector<Window> m_windows;
  std::vector<Entry> m_heap;
  bool m_has_flat_face = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_WINDOW_SEARCH_H
