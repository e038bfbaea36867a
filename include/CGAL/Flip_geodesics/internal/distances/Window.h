// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/Iterator_range.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Whether a window must still be propagated over the face that it enters, was among the last windows of its edge to be
 * propagated, or was propagated before. */
enum class Window_state : std::uint8_t { DONE, WAITING, CROSSING };

/*
 * A part of an edge, and rays that cross it, in a frame whose x-axis is the edge: rays from the unfolded source (x,
 * -y), or rays parallel to (-x, y) if they come from a segment. A source is thus (x : -y : 1) or (x : -y : 0) in
 * homogeneous coordinates, and most formulas are the same for both.
 *
 *          from    to
 *     0 -----======----- length
 *             .  .
 *              . .
 *               ..
 *             (x, -y)
 */
struct Window
{
  double from, to, x, y;
  double sigma;      // the length of the paths before the source; for parallel rays, up to the origin
  Index root;        // the vertex that is the source or, after all vertices, a part of a source in a face
  std::uint8_t side; // the halfedge of the edge on whose side the entered face lies
  bool is_far;       // whether the rays are parallel
  Window_state state;

  double weight() const { return is_far ? 0 : 1; }

  /* Returns the length of the path to a point above the edge, or on it. */
  double distance(double b, double height = 0) const
  {
    if(is_far)
      return sigma - x * b + y * height;
    const double dx = b - x, dy = height + y;
    return sigma + std::sqrt(dx * dx + dy * dy);
  }

  /* Returns the length of the path to a point above the edge whose ray crosses the edge at `crossing`. If that lies
   * outside the window, the path bends at the nearer end: it is the shortest path through the window. */
  double bent_distance(double b, double height, double crossing) const
  {
    const double at = (std::min)((std::max)(crossing, from), to);
    return at == crossing ? distance(b, height) : distance(at) + std::hypot(b - at, height);
  }

  /* Returns the least distance of all its points. */
  double least_distance() const
  {
    return is_far ? (std::min)(distance(from), distance(to)) : distance((std::min)((std::max)(x, from), to));
  }

  /* Returns the derivative of the distance along the edge. */
  double slope(double b) const
  {
    if(is_far)
      return -x;
    const double dx = b - x;
    return dx / std::sqrt(dx * dx + y * y);
  }

  /* Returns the position at which the ray to a point above the edge crosses the edge. */
  double crossing(double b, double height) const { return (x * height + b * y) / (y + weight() * height); }

  /* Bounds the displacement of the source, relative to the size of the frame, when a window is propagated over a
   * face. */
  static constexpr double step_error = window_step_error;

  /* The bound for several faces. */
  static constexpr double place_error = window_place_error;

  /* Returns the bound in the frame of an edge of a given length. */
  double error(double length) const { return place_error * (length + weight() * (std::abs(x) + y)); }

  /* Removes the part whose points are nearer to the source by way of the start of the edge, which is at distance
   * `to_start`. */
  void trim(double to_start)
  {
    const double more = to_start * (1 + equal_paths) - sigma; // rather too many windows
    if(!(distance(from) - sigma > from + more))
      return;
    if(distance(to) - sigma > to + more) {
      from = to;
      return;
    }
    const double b = is_far ? -more / (1 + x) : (x * x + y * y - more * more) / (2 * (x + more));
    from = (std::min)((std::max)(from, b), to);
  }

  /* Converts the window to the frame of the opposite direction. */
  void mirror(double length)
  {
    const double end = length - from;
    from = length - to;
    to = end;
    if(is_far)
      sigma -= x * length;
    x = weight() * length - x;
  }
};

static_assert(sizeof(Window) == 48, "a window must take 48 bytes");

/*
 * For each edge the windows with the shortest known paths to its points, from both sides, ordered by where they begin:
 * the lower envelope of their distances [MMP87]. Since a shortest path through a point enters one face only, windows of
 * both sides compete. A `Window_inserter` inserts them.
 */
class Edge_windows
{
public:
  explicit Edge_windows(std::size_t number_of_edges)
    : m_lists(number_of_edges)
  {
  }

  /* Returns the windows of an edge, in order. */
  CGAL::Iterator_range<Window*> on_edge(Index edge)
  {
    const List& l = list(edge);
    return CGAL::make_range(l.first, l.first + l.size);
  }
  CGAL::Iterator_range<const Window*> on_edge(Index edge) const
  {
    const List& l = m_lists[static_cast<std::size_t>(edge)];
    return CGAL::make_range<const Window*>(l.first, l.first + l.size);
  }

private:
  friend class Window_inserter;

  struct List
  {
    Window* first;
    std::uint32_t size;
    std::uint32_t block; // the logarithm of the capacity, plus 1; 0 if there is none
  };

  List& list(Index edge) { return m_lists[static_cast<std::size_t>(edge)]; }

  Lazy_array<List> m_lists;
};

/*
 * Inserts the parts of windows on edges that are shorter than the windows there. Several threads can do so
 * simultaneously, on different edges, each with an inserter of its own; all inserters must outlive the windows.
 *
 * If two windows are equally near up to rounding errors, both are kept, since their rays may lead to different places.
 * Only if their rays are the same, the window with more of them is kept. Windows may therefore overlap, and removing
 * part of one can put it behind another.
 *
 * The windows of an edge lie in a block of memory whose capacity is a power of two; released blocks are reused.
 */
class Window_inserter
{
  using List = Edge_windows::List;

public:
  /* Returns the total number of windows inserted on edges; below, the number for which memory is allocated. */
  std::size_t number_made() const { return m_made; }
  std::size_t capacity() const { return m_capacity; }
  /* Returns the capacity, in windows, of the released blocks. */
  std::size_t spare() const { return m_spare; }
  /* Returns the largest number of windows that an edge has had. */
  std::size_t most_on_an_edge() const { return m_most_on_an_edge; }
  /* Returns the total number of windows present on edges at insertions, a measure of the work. */
  std::size_t number_passed() const { return m_passed; }

  /* Removes the windows of an edge. */
  void clear(Edge_windows& windows, Index edge)
  {
    give_back(windows.list(edge));
    windows.list(edge) = List();
  }

  /* Inserts the parts of a window that are not longer than others on the edge. Returns whether there are any. */
  bool insert(Edge_windows& windows, Index edge, const Window& w)
  {
    const auto old = windows.on_edge(edge);
    const auto is_apart = [&](const Window& v) { return v.to <= w.from || v.from >= w.to; };
    const Window *first = old.begin(), *last = old.end();
    while(first != last && first->to <= w.from)
      ++first;
    while(last != first && last[-1].from >= w.to)
      --last;
    m_passed += static_cast<std::size_t>(old.size());
    m_result.clear();
    m_lost.clear();
    for(const Window* v = first; v != last; ++v)
      if(is_apart(*v))
        add_part(*v, v->from, v->to);
      else
        compete(*v, w);
    const std::size_t made = m_made;
    for_each_part(w, m_lost, [&](double from, double to) {
      add_part(w, from, to);
      ++m_made;
    });
    if(m_made == made)
      return false;
    replace(windows.list(edge), static_cast<std::uint32_t>(first - old.begin()),
            static_cast<std::uint32_t>(last - first));
    return true;
  }

private:
  struct Interval
  {
    double from, to;
  };

  // Removes the parts of an old window and a new one in which the other one is nearer.
  void compete(const Window& old, const Window& w)
  {
    const double l = (std::max)(w.from, old.from), r = (std::min)(w.to, old.to);
    const double at_l = w.distance(l), at_r = w.distance(r), equal = equal_paths * (std::max)(at_l, at_r);
    const double dl = at_l - old.distance(l), dr = at_r - old.distance(r);
    m_old_lost.clear();
    // The difference is monotone except where a ray of both crosses the edge.
    const double gl = turn(w, old, l), gr = turn(w, old, r);
    const bool is_turning = (gl < 0) != (gr < 0);
    const double b = is_turning ? l + (r - l) * (gl / (gl - gr)) : l;
    if(b > l && b < r) {
      const double d = w.distance(b) - old.distance(b);
      settle(old, w, {l, b}, dl, d, equal);
      settle(old, w, {b, r}, d, dr, equal);
    } else {
      settle(old, w, {l, r}, dl, dr, equal);
    }
    for_each_part(old, m_old_lost, [&](double from, double to) { add_part(old, from, to); });
  }

  // Removes these parts where the difference is monotone, given the excess of the new window's distance at both ends.
  void settle(const Window& old, const Window& w, const Interval& at, double dl, double dr, double equal)
  {
    if((std::max)(dl, dr) <= equal && (std::min)(dl, dr) >= -equal) {
      if(std::abs(w.slope(at.from) - old.slope(at.from)) + std::abs(w.slope(at.to) - old.slope(at.to)) < parallel_rays)
        (w.to - w.from > old.to - old.from ? m_old_lost : m_lost).push_back(at);
      return;
    }
    if((std::min)(dl, dr) > equal)
      return m_lost.push_back(at);
    if((std::max)(dl, dr) < -equal)
      return m_old_lost.push_back(at);
    const bool is_crossed = std::abs(dl) > equal && std::abs(dr) > equal;
    const double difference = is_crossed ? 0 : ((std::max)(dl, dr) > equal ? equal : -equal);
    const double b = crossing(w, old, at, dl < dr, difference, equal);
    const double margin = is_crossed ? 2 * equal / std::abs(w.slope(b) - old.slope(b)) : 0;
    const Interval left = {at.from, b - margin}, right = {b + margin, at.to};
    if(left.from < left.to && std::abs(dl) > equal)
      (dl > 0 ? m_lost : m_old_lost).push_back(left);
    if(right.from < right.to && std::abs(dr) > equal)
      (dr > 0 ? m_lost : m_old_lost).push_back(right);
  }

  // Zero where the rays of both are parallel.
  static double turn(const Window& v, const Window& w, double b)
  {
    return (b * v.weight() - v.x) * w.y - (b * w.weight() - w.x) * v.y;
  }

  // The position at which the new window is longer by `difference`, a value between those at the ends, within half of
  // `equal`.
  static double crossing(const Window& w, const Window& old, Interval at, bool is_rising, double difference,
                         double equal)
  {
    const double accuracy = equal / 2;
    double b = (at.from + at.to) / 2;
    for(int i = 0; b > at.from && b < at.to; ++i) {
      const double d = w.distance(b) - old.distance(b) - difference;
      if(std::abs(d) <= accuracy)
        break;
      ((d < 0) == is_rising ? at.from : at.to) = b;
      b -= d / (w.slope(b) - old.slope(b));
      if(!(b > at.from && b < at.to) || i % 8 == 7) // the interval must shrink
        b = (at.from + at.to) / 2;
    }
    return b;
  }

  // Calls `function(from, to)` for the parts of a window that are not lost.
  template <class Function>
  static void for_each_part(const Window& w, std::vector<Interval>& lost, const Function& function)
  {
    if(lost.size() > 1)
      std::sort(lost.begin(), lost.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    double from = w.from;
    for(const Interval& gap : lost) {
      if(from < gap.from)
        function(from, gap.from);
      from = (std::max)(from, gap.to);
    }
    if(from < w.to)
      function(from, w.to);
  }

  // Inserts a part of a window into the result, behind those with the same beginning.
  void add_part(const Window& w, double from, double to)
  {
    auto at = m_result.end();
    while(at != m_result.begin() && from < at[-1].from)
      --at;
    at = m_result.insert(at, w);
    at->from = from;
    at->to = to;
  }

  // Replaces some windows of a list by those of the result.
  void replace(List& l, std::uint32_t first, std::uint32_t number)
  {
    const std::uint32_t added = static_cast<std::uint32_t>(m_result.size()), rest = l.size - first - number;
    const std::uint32_t size = first + added + rest;
    if(l.block == 0 || size > room(l.block)) {
      List larger = take(size);
      std::copy_n(l.first, first, larger.first);
      std::copy_n(l.first + first + number, rest, larger.first + first + added);
      give_back(l);
      l = larger;
    } else if(added != number) {
      Window *const from = l.first + first + number, *const to = l.first + first + added;
      if(added < number)
        std::copy(from, from + rest, to);
      else
        std::copy_backward(from, from + rest, to + rest);
    }
    std::copy(m_result.begin(), m_result.end(), l.first + first);
    l.size = size;
    m_most_on_an_edge = (std::max)(m_most_on_an_edge, static_cast<std::size_t>(size));
  }

  static constexpr std::uint32_t room(std::uint32_t block) { return 1u << (block - 1); }

  List take(std::uint32_t size)
  {
    std::uint32_t block = 3;
    while(room(block) < size)
      ++block;
    std::vector<Window*>& unused = m_unused[block];
    if(unused.empty())
      return {take_new(room(block)), size, block};
    Window* const first = unused.back();
    unused.pop_back();
    m_spare -= room(block);
    return {first, size, block};
  }

  // Unused memory; if necessary, slightly more than an eighth of the total is allocated at once.
  Window* take_new(std::size_t size)
  {
    constexpr std::size_t least = 1024;
    if(m_left < size) {
      const std::size_t room = (std::max)({size, least, m_capacity / 8});
      std::unique_ptr<Window[]> chunk(new Window[room]);
      m_chunks.push_back(std::move(chunk));
      m_next = m_chunks.back().get();
      m_left = room;
    }
    Window* const result = m_next;
    m_next += size;
    m_left -= size;
    m_capacity += size;
    return result;
  }

  void give_back(const List& l)
  {
    if(l.block == 0)
      return;
    m_unused[l.block].push_back(l.first);
    m_spare += room(l.block);
  }

  std::vector<std::unique_ptr<Window[]>> m_chunks;
  Window* m_next = nullptr;                      // unused memory in the last chunk
  std::size_t m_left = 0;                        // the number of windows that fit there
  std::array<std::vector<Window*>, 32> m_unused; // blocks, by the logarithm of their capacity
  std::size_t m_made = 0, m_capacity = 0, m_spare = 0, m_most_on_an_edge = 0, m_passed = 0;
  // Of the current insertion:
  std::vector<Window> m_result;
  std::vector<Interval> m_lost, m_old_lost; // parts of the new window, and of an old one
};

/*
 * A face in the frame of one of its sides, halfedge h, which starts at the origin and runs along the x-axis with the
 * face above. It contains the data required for a window to cross it, in one cache line.
 */
struct Face_side
{
  double length;
  double x, y;         // of the vertex opposite
  double cosine, sine; // of the angle at the tail
  Input_halfedge_index next;
  Vertex_index tail;
};

/* The sides of the input faces, computed when a face is first requested, possibly by several threads simultaneously. */
template <class Triangulation>
class Face_sides
{
public:
  explicit Face_sides(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_sides(static_cast<std::size_t>(triangulation.number_of_halfedges()))
    , m_is_known(m_sides.size())
  {
  }

  /* \pre h is not on the border. \throws as the metric, Invalid_mesh_error */
  const Face_side& operator()(Input_halfedge_index h)
  {
    make_known(h);
    return m_sides[h];
  }

  /* Computes the sides of a face unless they are known. Returns whether this has made known a face so flat that rays
   * can be lost in it. */
  bool make_known(Input_halfedge_index h)
  {
    if(load_acquire(m_is_known[h]) != 0)
      return false;
    // The result is the same for each halfedge of the face.
    const std::array<Face_side, 3> sides = computed(least_in_face(m_triangulation.input(), h));
    const std::lock_guard<Short_lock> guard(m_lock);
    if(m_is_known[h] != 0) // another thread was faster
      return false;
    bool is_flat = false;
    for(const Face_side& side : sides) {
      const Input_halfedge_index g = m_triangulation.input().previous(side.next);
      m_sides[g] = side;
      store_release(m_is_known[g], char(1));
      is_flat = is_flat || !(side.y > flat_face * (side.length + std::abs(side.x)));
    }
    return is_flat;
  }

  /* Returns the side of a face that has been requested. */
  const Face_side& known(Input_halfedge_index h) const { return m_sides[h]; }

  /* Returns the side of any face, as a copy. */
  Face_side copy(Input_halfedge_index h) const
  {
    if(m_is_known[h] != 0)
      return m_sides[h];
    const Input_halfedge_index first = least_in_face(m_triangulation.input(), h);
    return computed(first)[h == first ? 0 : (h == m_triangulation.input().next(first) ? 1 : 2)];
  }

private:
  // The sides of a face, starting with h.
  std::array<Face_side, 3> computed(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation.input();
    const auto v = input_face_geometry(m_triangulation, h);
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    const double length = v[0].x, next = std::hypot(v[1].x, v[1].y), previous = std::hypot(v[2].x, v[2].y);
    // Rays pass degenerate faces as well: from a vertex on the longest side into the face beyond.
    const double height = (std::max)(v[1].y, least_face_height * length), area = length * height;
    // If the side at the tail is short, the sum suffers from cancellation, which would falsify the angle there.
    const double x = previous < short_side * length ? -v[2].x : length + v[1].x;
    const double xn = -length * v[1].x / next, xp = -(v[1].x * v[2].x + v[1].y * v[2].y) / previous;
    return {{{length, x, height, x / previous, height / previous, hn, input.tail(h)},
             {next, xn, area / next, xn / length, area / (next * length), hp, input.tail(hn)},
             {previous, xp, area / previous, xp / next, area / (previous * next), h, input.tail(hp)}}};
  }

  // Up to this ratio the error of the angle from a difference of lengths is at most eight rounding errors.
  static constexpr double short_side = 0.125;

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Face_side>> m_sides;
  Indexed_by<Input_halfedge_index, Lazy_array<char>> m_is_known;
  Short_lock m_lock;
};

/* The arrival of the shortest known path at a vertex. */
struct Vertex_record
{
  double distance;
  Window window;                // through which it arrives, in the frame of `through`
  Input_halfedge_index through; // the side by which it enters its last face; null_index if it crosses no edge
  Input_halfedge_index along;   // the halfedge along which it arrives, or null_index
  Index root;                   // the vertex, or the part of a source, from which it comes
  bool is_reached, is_source;
  std::size_t source; // its number if it is one
};

/* The continuation from a vertex: a path along a halfedge, and a window on the opposite side, in the frame of that
 * side. */
struct Vertex_opening
{
  Input_halfedge_index along;
  Input_halfedge_index opposite; // null_index without a window
  Vertex_index head;             // of `along`
  double distance;               // its length
  Window window;
};

/*
 * Finds the continuations of paths from a vertex. Vertices are pseudo-sources for the directions in which shortest
 * paths can continue, at an angle of at least pi on both sides from their arrival. All faces at the vertex must be
 * known to `Face_sides`. The angles of its `Vertex_fan` begin in the direction from which the path to the vertex comes.
 */
template <class Triangulation>
class Vertex_openings
{
  using Vector = std::complex<double>;
  using Sides = Face_sides<Triangulation>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  explicit Vertex_openings(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Returns the paths along the edges of a vertex and the windows on the opposite edges, at most two per outgoing
   * halfedge. */
  const std::vector<Vertex_opening>& operator()(const Sides& sides, Vertex_index v, const Vertex_record& record)
  {
    m_openings.clear();
    double angle = 0;
    const Input_halfedge_index start = first_halfedge(sides, v, record, angle);
    const bool is_free = record.through == null_index && record.along == null_index;
    m_fan.collect(m_triangulation.input(), start, angle, [&](Input_halfedge_index h) { return corner(sides, h); });
    const double bend = is_free ? -infinity : boost::math::constants::pi<double>() - slack(sides);
    const double most = m_fan.has_border() ? infinity : m_fan.total() - bend;
    for(const Outgoing_halfedge& o : m_fan.halfedges())
      open(sides, v, record, o, bend, most);
    if(m_fan.has_border())
      open_clockwise(sides, v, record, start, angle, -bend);
    return m_openings;
  }

  /* Returns a halfedge that starts at v, and its angle counterclockwise from the direction from which the path to v
   * comes. */
  Input_halfedge_index first_halfedge(const Sides& sides, Vertex_index v, const Vertex_record& record,
                                      double& angle) const
  {
    if(record.along != null_index)
      return twin_index(record.along);
    if(record.through == null_index)
      return m_triangulation.input().outgoing(v);
    const Face_side& f = sides.known(record.through);
    const Window& w = record.window;
    const Vector apex(f.x, f.y), back = Vector(w.x, -w.y) - w.weight() * apex;
    angle = -std::arg(back * std::conj(-apex));
    return sides.known(f.next).next;
  }

private:
  using Outgoing_halfedge = Vertex_fan::Outgoing_halfedge;

  static double corner(const Sides& sides, Input_halfedge_index h)
  {
    const Face_side& f = sides.known(h);
    return std::atan2(f.sine, f.cosine);
  }

  /*
   * Returns the amount by which the angle of a path at the vertex may be less than pi. The window of a ray that passes
   * the vertex closer than the rounding errors of positions on its longest edge can be lost. Such a ray turns by at
   * most that error relative to the lengths of the path before and after the vertex; windows from the vertex take its
   * place. Their distances are the lengths of existing paths, so additional windows never make a distance too
   * short.
   */
  double slack(const Sides& sides) const
  {
    double shortest = infinity, longest = 0;
    for(const Outgoing_halfedge& o : m_fan.halfedges()) {
      const Input_halfedge_index h = o.halfedge;
      const double length = sides.known(m_triangulation.input().is_border(h) ? twin_index(h) : h).length;
      shortest = (std::min)(shortest, length);
      longest = (std::max)(longest, length);
    }
    return (std::max)(angle_sum_rounding, 2 * Window::place_error * (longest / shortest));
  }

  // Clockwise from a halfedge up to the last one of the fan, across the border, beyond which all directions are open.
  void open_clockwise(const Sides& sides, Vertex_index v, const Vertex_record& record, Input_halfedge_index start,
                      double angle, double most)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index end = m_fan.halfedges().back().halfedge;
    for(Input_halfedge_index h = start;;) {
      angle = input.is_border(twin_index(h)) ? -beyond_all_angles : angle;
      h = clockwise_of(input, h);
      if(h == end)
        return;
      const double whole = input.is_border(h) ? 0 : corner(sides, h);
      angle -= whole;
      open(sides, v, record, {h, angle, whole}, -infinity, most);
    }
  }

  // Opens a path along the edge at which a face starts, and a window on the opposite edge, for angles in [least, most].
  void open(const Sides& sides, Vertex_index v, const Vertex_record& record, const Outgoing_halfedge& o, double least,
            double most)
  {
    const Input_halfedge_index h = o.halfedge;
    const bool is_border = m_triangulation.input().is_border(h);
    const double distance = record.distance + sides.known(is_border ? twin_index(h) : h).length;
    m_openings.push_back({h, null_index, m_triangulation.input().tail(twin_index(h)), distance, Window()});
    if(is_border || o.angle > most || o.angle + o.corner < least)
      return;
    const Input_halfedge_index opposite = sides.known(h).next;
    const Face_side& f = sides.known(opposite);
    const bool is_thin = f.y < thin_face * f.length; // the crossing of a ray does not determine its direction then
    const double first = o.angle < least && !is_thin ? hit(f, least - o.angle) : 0;
    const double last = o.angle + o.corner > most && !is_thin ? hit(f, most - o.angle) : f.length;
    if(!(first < last))
      return;
    m_openings.back().opposite = opposite;
    m_openings.back().window = {first, last, f.x, f.y, record.distance, v.idx(), 0, false, Window_state::WAITING};
  }

  // The crossing with a side of a ray from the opposite vertex, at an angle from the line to the tail.
  static double hit(const Face_side& f, double angle)
  {
    const Vector ray = Vector(-f.x, -f.y) * std::polar(1.0, angle);
    if(!(ray.imag() < 0))
      return ray.real() < 0 ? 0 : f.length;
    return (std::min)((std::max)(f.x - f.y * (ray.real() / ray.imag()), 0.0), f.length);
  }

  const Triangulation& m_triangulation;
  Vertex_fan m_fan;
  std::vector<Vertex_opening> m_openings;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_H
