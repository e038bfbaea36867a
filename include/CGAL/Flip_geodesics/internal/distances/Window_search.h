// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_SEARCH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A part of an edge through which straight rays pass, in the frame that is drawn at `Window_search`. */
template <class Number>
struct Basic_ray_window
{
  Input_halfedge_index halfedge;
  Index parent; // the previous window, null_index if there is none
  Vertex_index root;
  Number from, to, x, y, sigma, radius, margin;

  // Of the length of a path, from those of a root and a point.
  static constexpr double evaluation_error = 8 * Number_rounding<Number>::unit;

  static Number norm(const Number& x, const Number& y)
  {
    using std::sqrt;
    return sqrt(x * x + y * y);
  }

  /* Returns a lower bound on the length of a path through the window to a position on its edge. */
  Number least(const Number& place) const
  {
    const Number value = sigma + norm(place - x, y);
    return value - (radius + evaluation_error * value);
  }
};

using Ray_window = Basic_ray_window<double>;

/* The length of a path: a lower bound, the computed value, and the length of an existing path. */
template <class Number>
struct Path_length
{
  Number least, computed, most;
  Number error; // of the lower bound, since the last root
};

/* The arrival of a path at a vertex: along a halfedge or through a window; and the length since the last root. */
struct Path_arrival
{
  Index window = null_index;
  Input_halfedge_index along = null_index;
  double leg = 0;
};

/* The state of a vertex in a search. */
template <class Number>
struct Reached_vertex
{
  Path_length<Number> length; // each the smallest of all paths
  Path_arrival arrival;
  Number promised; // the largest start length of the rays from here that suffices for those replaced
  Number started;  // the length from which they have started
  bool is_source = false, is_reached = false, has_started = false, has_tie = false;
};

/* A window whose rays must be propagated, or a vertex from which rays must start. */
template <class Number>
struct Queued_rays
{
  double priority;
  Number least;
  Index id; // of a window or a vertex
  bool is_vertex;

  static std::size_t is_before(const Queued_rays& a, const Queued_rays& b)
  {
    if(a.priority != b.priority)
      return static_cast<std::size_t>(a.priority < b.priority);
    return static_cast<std::size_t>(a.is_vertex != b.is_vertex ? a.is_vertex : a.id < b.id);
  }
};

/*
 * Shortest paths on the input mesh from one vertex, or from the nearest of several: windows of straight rays are
 * propagated from face to face [MMP87] in the order of a lower bound, and dropped if a shorter path is known [CH90,
 * XW09].
 *
 * A window is a part of an edge together with the unfolded source: the position, in the plane of the edge, of the
 * vertex from which the rays come. It lies in the frame of halfedge h, which has the face to be entered on its left:
 *
 *                     apex
 *                    /    .
 *          hp       /       .  hn          the edge is the segment from 0 to `length` on the x-axis,
 *                  /          .            the rays start at (x, -y), pass between `from` and `to`,
 *         tail 0 --from==to----- length    and have covered the length `sigma` before
 *                    .  /       h
 *                     ./
 *                   (x, -y)
 *
 * With a target and lower bounds propagated from there, windows are ordered by a lower bound on the length of a path
 * through them to the target, and dropped if it exceeds the length being searched for.
 *
 * Rounding is directed such that no path is lost and none counts as longer than it is. A window stores a bound `radius`
 * of the distance from its source to the true one, and is as wide as rays from that disk can reach; its true ends are
 * at most `margin` inside its own. `sigma` is at most the true value. The value of a window minus its radius is thus a
 * lower bound for all paths through it, and a path is dropped only if a true path is certainly shorter. A vertex has
 * three numbers: the computed distance, a lower bound for all paths, and the length of an existing path.
 *
 * All errors are in units of the numbers' roundoff, so the analysis also holds for faces in double-double
 * arithmetic.
 *
 * A window whose ends are closer than their errors may be empty. If it passes along a vertex, paths through it are no
 * shorter than those by way of the vertex, minus twice the offset of its rays. If rays start from the vertex, they
 * replace the window; otherwise two windows would follow from it at each vertex of a straight row.
 */
template <class Triangulation, class Faces = Unfolded_faces<Triangulation>>
class Window_search
{
  using Sweep = Cone_sweep<Triangulation>;
  using Number = typename Faces::Number;
  using Rounding = Number_rounding<Number>;
  using Vector = typename Faces::Vector;
  using Direction = typename Unfolded_faces<Triangulation>::Direction;
  using Length = Path_length<Number>;
  using Arrival = Path_arrival;
  using Vertex_record = Reached_vertex<Number>;
  using Window = Basic_ray_window<Number>;
  using Entry = Queued_rays<Number>;

public:
  /* The last segment of a shortest path to a vertex: straight from another vertex, along an edge sequence. */
  struct Leg
  {
    Vertex_index from = null_index;
    Edge_sequence sequence;
  };

  /* Searches from the source to all vertices or, given lower bounds from a target, to that target and up to their
   * bound. */
  Window_search(const Triangulation& triangulation, Faces& faces, Vertex_index source, const Sweep* sweep = nullptr)
    : m_triangulation(triangulation)
    , m_faces(faces)
    , m_source(source)
    , m_sweep(sweep)
    , m_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /* Makes a vertex an additional source. \pre nothing has been searched */
  void add_source(Vertex_index v)
  {
    m_vertices.write(v).is_source = true;
    offer(v, {0, 0, 0, 0}, {});
  }

  bool is_source(Vertex_index v) const { return m_vertices[v].is_source; }

  /*
   * Continues until all paths shorter than `bound` are known, or there are more than `most_windows` windows or as many
   * edges along which rays have started. With a lower-bound propagation, only paths that can lead to its source count.
   */
  void run(double bound, std::size_t most_windows = (std::numeric_limits<std::size_t>::max)(),
           Interruption* interruption = nullptr)
  {
    if(!is_reached(m_source))
      add_source(m_source);
    while(!m_heap.empty() && effort() <= most_windows) {
      const Entry entry = m_heap.top();
      if(entry.priority >= (m_sweep == nullptr ? bound : (std::min)(bound, longest_tie(m_sweep->source()))))
        return;
      if(is_interrupted(interruption))
        return;
      m_heap.pop();
      if(!entry.is_vertex)
        propagate(entry.id);
      else if(const Vertex_index v(entry.id); is_due(m_vertices[v], entry.least))
        start_from(v);
    }
  }

  /* Returns a lower bound for the paths to the target, or to vertices not reached yet, that are not known. */
  double lower_bound() { return m_heap.empty() ? infinity : m_heap.top().priority; }

  /* Returns the length of the shortest path found to a vertex; infinite if there is none yet. */
  double distance(Vertex_index v) const
  {
    return is_reached(v) ? Rounding::nearest(m_vertices[v].length.computed) : infinity;
  }

  /* Returns a lower bound for the paths found to a vertex; infinite if there is none yet. */
  double least_distance(Vertex_index v) const
  {
    return is_reached(v) ? Rounding::below(m_vertices[v].length.least) : infinity;
  }

  /* Returns the length of an existing path to a vertex, rounded up; infinite if there is none yet. */
  double greatest_distance(Vertex_index v) const
  {
    return is_reached(v) ? Rounding::above(m_vertices[v].length.most) : infinity;
  }

  bool is_reached(Vertex_index v) const { return m_vertices[v].is_reached; }

  /* Returns whether there are several shortest paths to a vertex, as far as can be determined. \pre it has been
   * reached */
  bool has_tie(Vertex_index v) const
  {
    while(!is_source(v) && !m_vertices[v].has_tie)
      v = start(m_vertices[v].arrival);
    return !is_source(v);
  }

  /* Returns the least length with which rays start from a vertex or run along it; infinite if there are none. */
  double least_start(Vertex_index v) const
  {
    if(!is_reached(v))
      return infinity;
    const Vertex_record& record = m_vertices[v];
    const Number least = (std::min)(record.length.least, record.promised);
    return Rounding::below(record.has_started ? (std::min)(least, record.started) : least);
  }

  std::size_t number_of_windows() const { return m_windows.size(); }

  /* Returns the number that `run()` compares with its limit. */
  std::size_t effort() const { return (std::max)(m_windows.size(), m_number_of_starts); }
  const std::vector<Window>& windows() const { return m_windows; }

  /* Returns the windows on border halfedges, where they end; stored if requested before the search. */
  const std::vector<Window>& border_windows() const { return m_border_windows; }
  void keep_border_windows() { m_keeps_border_windows = true; }

  /* Returns the last segment of the shortest path found to a vertex that is not the source. */
  Leg leg(Vertex_index v) const
  {
    const Vertex_record& record = m_vertices[v];
    Leg result;
    result.from = start(m_vertices[v].arrival);
    if(record.arrival.window == null_index) {
      result.sequence.along = record.arrival.along;
      return result;
    }
    for(Index w = record.arrival.window; w != null_index; w = m_windows[w].parent)
      result.sequence.crossed.push_back(twin_index(m_windows[w].halfedge));
    std::reverse(result.sequence.crossed.begin(), result.sequence.crossed.end());
    return result;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr bool is_in_double = std::is_same<Number, double>::value;
  // Of a step to a face, relative to the lengths in it: a direction of a side (18 u, see `Unfolded_faces::Side`), a
  // difference (1 u), a product of complex numbers (less than 3 u) and a sum (1 u).
  static constexpr double step_error = 24 * Rounding::unit;
  static constexpr double evaluation_error = Window::evaluation_error;
  static constexpr double row_allowance = 32;         // of errors, at vertices that can be collinear
  static constexpr double same_way = same_path_angle; // angle between the ends of paths regarded as the same
  static constexpr double tie_tolerance = path_tie;   // of the length of a path, within which another one ties

  // The window with the shortest path to the apex, of those that enter a face through one edge [CH90].
  struct Split
  {
    Number length, crossing, error;
    bool is_set;
  };

  // Another edge of a face, seen from the one that is the x-axis.
  struct Edge
  {
    Input_halfedge_index halfedge; // with the next face on its left
    Number length;
    Vector axis;             // its direction
    Number base, base_place; // its intersection with the x-axis, as a position on that and on itself
  };

  // A part of an edge, and a bound on the distance of the true ends inside it.
  struct Part
  {
    Number from, to, margin;
  };

  void push(double priority, const Number& least, Index id, bool is_vertex)
  {
    m_heap.push({priority, least, id, is_vertex});
  }

  // Records a path to v.
  void offer(Vertex_index v, const Length& length, const Arrival& arrival)
  {
    Vertex_record& record = m_vertices.write(v);
    if(!record.is_reached) {
      record.length = {infinity, infinity, infinity, 0};
      record.promised = infinity;
    } else if(record.is_source)
      return;
    record.is_reached = true;
    record.length.most = (std::min)(record.length.most, length.most);
    const Number allowed = tie_tolerance * length.computed;
    using std::abs;
    const bool ties = abs(length.computed - record.length.computed) <= allowed;
    if(ties && are_apart(record.arrival, arrival, Rounding::nearest(length.computed)))
      record.has_tie = true;
    else if((ties ? arrival.leg < record.arrival.leg : length.computed < record.length.computed) &&
            !comes_round(v, arrival))
    {
      record.arrival = arrival;
      record.has_tie = record.has_tie && ties;
    }
    record.length.computed = (std::min)(record.length.computed, length.computed);
    m_may_come_round = m_may_come_round || (!is_source(v) && !is_after(v, start(record.arrival)));
    lower(v, length.least, length.error);
  }

  // Returns whether the path that arrives at v passes v before. The paths of two vertices closer than ties can each
  // seem to pass the other one.
  bool comes_round(Vertex_index v, const Arrival& arrival) const
  {
    if(is_source(v))
      return false;
    Vertex_index u = start(arrival);
    if(!m_may_come_round && is_after(v, u))
      return false;
    while(!is_source(u) && u != v)
      u = start(m_vertices[u].arrival);
    return u == v;
  }

  // Returns whether v is farther away. If each vertex is farther than the one from which its path comes, no path is
  // cyclic.
  bool is_after(Vertex_index v, Vertex_index u) const
  {
    return m_vertices[u].length.computed < m_vertices[v].length.computed;
  }

  double longest_tie(Vertex_index v) const { return distance(v) * (1 + 2 * tie_tolerance); }

  Vertex_index start(const Arrival& arrival) const
  {
    return arrival.window == null_index ? m_triangulation.input().tail(arrival.along) : m_windows[arrival.window].root;
  }

  // The direction from which a path comes.
  Direction direction(const Arrival& arrival)
  {
    if(arrival.window == null_index)
      return {twin_index(arrival.along), 0};
    const Window& w = m_windows[arrival.window];
    const Index side = m_faces.number(w.halfedge);
    const Vector apex = m_faces.apex(side);
    const std::complex<double> to_apex(Rounding::nearest(apex.real()), Rounding::nearest(apex.imag()));
    const std::complex<double> from(Rounding::nearest(w.x), -Rounding::nearest(w.y));
    const double angle = std::arg((from - to_apex) / -to_apex);
    const bool is_straight_angle = 2 * angle < -boost::math::constants::pi<double>(); // rounded to the other side
    const double turn = is_straight_angle ? boost::math::constants::two_pi<double>() : 0;
    return {m_faces[Faces::previous(side)].halfedge, angle + turn};
  }

  /* The direction in which a path leaves its start. */
  Direction departure(const Arrival& arrival)
  {
    if(arrival.window == null_index)
      return {arrival.along, 0};
    const Window* w = &m_windows[arrival.window];
    const Vector apex = m_faces.apex(m_faces.number(w->halfedge));
    Vector ray{apex.real() - w->x, apex.imag() + w->y};
    for(; w->parent != null_index; w = &m_windows[w->parent])
      ray = ray * axis_of(*w);
    const Input_halfedge_index crossed = twin_index(w->halfedge);
    const Index side = m_faces.number(crossed), outgoing_halfedge = Faces::previous(side);
    const Vector to_head{m_faces[side].length - w->x, w->y};
    const Vector turn = ray * conj(to_head);
    return {m_faces[outgoing_halfedge].halfedge,
            std::atan2(Rounding::nearest(turn.imag()), Rounding::nearest(turn.real()))};
  }

  // The direction of a window's edge in the frame of the window from which it follows.
  Vector axis_of(const Window& w)
  {
    const Index side = m_faces.number(m_windows[w.parent].halfedge);
    const auto base = m_faces[side], next = m_faces[Faces::next(side)];
    return twin_index(w.halfedge) == next.halfedge ? Vector{next.cosine, -next.sine} : Vector{base.cosine, base.sine};
  }

  /*
   * Returns whether the direction of a path at one of its ends lies within the face there, up to its error. In a
   * degenerate face, the rounded direction can point out of the face.
   */
  bool is_within_face(const Arrival& arrival, const Direction& direction)
  {
    if(arrival.window == null_index)
      return true;
    const Window& w = m_windows[arrival.window];
    const Index side = m_faces.number(w.halfedge);
    const auto corner = m_faces[m_faces.number(direction.halfedge)];
    const double angle = direction.angle;
    const double most = std::atan2(Rounding::nearest(corner.sine), Rounding::nearest(corner.cosine));
    const Number error = w.radius + step_error * (norm(w.x, w.y) + m_faces[side].length + corner.length);
    const double allowed = same_way + Rounding::nearest(error) / arrival.leg;
    return angle >= -allowed && angle <= most + allowed;
  }

  /*
   * Returns whether two arrivals at a vertex, by paths of some length, belong to different shortest paths. A path that
   * bends slightly at a flat vertex beside a shortest one is hardly longer, but is not a different one.
   *
   * At one end the angle between two paths can be too small to measure, while it is large at the other: for example, if
   * they pass a convex vertex close to the other end. The angle is therefore measured at both ends if the last segments
   * start at the same vertex, and the result is the same from the target to the source. If they start at different
   * vertices and their angle at the arrival is too small to measure, the longer one passes the start of the shorter
   * one, and the tie is decided by their arrivals there.
   */
  bool are_apart(const Arrival& a, const Arrival& b, double length)
  {
    const auto of_a = direction(a), of_b = direction(b);
    if(!is_within_face(a, of_a) || !is_within_face(b, of_b))
      return false;
    double angle = m_faces.in_double().angle_between(of_a, of_b, same_way);
    if(angle == 0 && start(a) == start(b))
      angle = angle_at_start(a, b);
    const Arrival& shorter = a.leg < b.leg ? a : b;
    const bool is_beside = shorter.leg * angle <= same_way * length && m_faces.in_double().is_flat(start(shorter));
    return angle > 0 && !is_beside;
  }

  // The angle between two paths at their common start, zero if it is too small to measure.
  double angle_at_start(const Arrival& a, const Arrival& b)
  {
    const auto of_a = departure(a), of_b = departure(b);
    const bool are_known = is_within_face(a, of_a) && is_within_face(b, of_b);
    return are_known ? m_faces.in_double().angle_between(of_a, of_b, same_way) : 0;
  }

  // Records a lower bound for the paths to v.
  void lower(Vertex_index v, const Number& least, const Number& error)
  {
    Vertex_record& record = m_vertices.write(v);
    if(least >= record.length.least)
      return;
    record.length.least = least;
    record.length.error = error;
    if((record.is_source || m_faces.in_double().is_passable(v)) && !(record.has_started && record.started <= least))
      push_vertex(v, (std::min)(least, record.promised));
  }

  // Queues rays that start from a vertex with a length.
  void push_vertex(Vertex_index v, const Number& length)
  {
    const double total = Rounding::below(length) + (m_sweep == nullptr ? 0 : m_sweep->distance_lower_bound(v));
    if(is_wanted(total))
      push(total, m_vertices[v].length.least, v.idx(), true);
  }

  // Returns whether rays have to start, as decided when this was the lower bound.
  static bool is_due(const Vertex_record& record, const Number& least)
  {
    return record.length.least == least && !(record.has_started && record.started <= least);
  }

  // Returns whether a path of this length can be useful.
  bool is_wanted(double length) const { return m_sweep == nullptr || length <= m_sweep->bound(); }

  // Opens windows on all edges opposite to v, and paths along its edges.
  void start_from(Vertex_index v)
  {
    const auto& input = m_triangulation.input();
    if(input.outgoing(v) == null_index)
      return;
    const Length before = m_vertices[v].length;
    const Number allowance = m_faces.in_double().is_flat(v) ? row_allowance * before.error : Number(0);
    const Number sigma = (std::min)(before.least - allowance, m_vertices[v].promised);
    Vertex_record& record = m_vertices.write(v);
    record.started = sigma;
    record.has_started = true;
    for_each_outgoing_halfedge(input, v, [&](Input_halfedge_index h) {
      ++m_number_of_starts;
      const Number along = m_faces.length(h);
      const Number computed = before.computed + along, error = evaluation_error * (before.computed + along);
      // Never less than the start of the rays: otherwise the ends of an edge shorter than the error would lower each
      // other.
      offer(input.tail(twin_index(h)),
            {(std::max)(sigma, sigma + along - error), computed, before.most + along + error, step_error * along},
            {null_index, h, Rounding::nearest(along)});
      if(!input.is_border(h)) {
        const Index opposite = Faces::next(m_faces.number(h));
        const Vector place = m_faces.apex(opposite);
        const auto& side = m_faces[opposite]; // reversed, as seen from the other side
        open({twin_index(side.halfedge), null_index, v, 0, side.length, side.length - place.real(),
              (std::max)(place.imag(), Number(0)), sigma, step_error * (side.length + along), 0},
             side.length);
      }
    });
  }

  // Stores a window on an edge if it can be useful. The length is a copy, since computing faces moves their sides.
  void open(const Window& w, Number length)
  {
    const auto& input = m_triangulation.input();
    const bool is_border = input.is_border(w.halfedge);
    if((is_border && !m_keeps_border_windows) || !(w.to >= w.from))
      return;
    const Vertex_index tail = input.tail(w.halfedge), head = input.tail(twin_index(w.halfedge));
    const Number to_from = w.least(w.from), to_to = w.least(w.to);
    if(most(tail) + w.to < to_to || most(head) + (length - w.from) < to_from) // shorter by way of an end
      return;
    if(is_border) {
      m_border_windows.push_back(w);
      return;
    }
    const bool may_be_none = w.to - w.from <= 2 * w.margin;
    if(may_be_none && (goes_along(w, tail, 0, w.to) || goes_along(w, head, length, length - w.from) || comes_back(w)))
      return;
    const Number nearest = (std::min)((std::max)(w.x, w.from), w.to);
    const Number least = w.least(nearest);
    const double total = m_sweep == nullptr ? Rounding::below(least) : least_to_target(w, length);
    if(!is_wanted(total))
      return;
    m_windows.push_back(w);
    push(total, least, static_cast<Index>(m_windows.size()) - 1, false);
  }

  // Returns a lower bound for the paths through a window, on an edge of some length, to the target, computed in
  // doubles.
  double least_to_target(const Window& w, const Number& length) const
  {
    const auto nearest = [](const Number& number) { return Rounding::nearest(number); };
    const double rounded = is_in_double ? 0 : nearest(norm(w.x, w.y) + length);
    const Cone cone = {nearest(w.x), nearest(w.y), nearest(w.sigma)};
    return m_sweep->through(w.halfedge, nearest(length), cone, nearest(w.from), nearest(w.to)) -
           (nearest(w.radius) + Ray_window::evaluation_error * (m_sweep->bound() + rounded));
  }

  // The length of an existing path.
  Number most(Vertex_index v) const { return is_reached(v) ? m_vertices[v].length.most : infinity; }

  // Returns whether a vertex replaces the part of a window whose points are at most this far from it.
  bool goes_along(const Window& w, Vertex_index v, const Number& place, const Number& farthest)
  {
    if(!is_reached(v) || !m_faces.in_double().is_passable(v))
      return false;
    // The distance of the rays from the vertex.
    const Number run = norm(place - w.x, w.y) - farthest - w.radius;
    const Number offset = run > 0 ? farthest * (std::min)((w.y + w.radius) / run, Number(1)) : farthest;
    if(offset > 32 * w.radius || !(2 * farthest < m_faces.in_double().nearest_edge(v)))
      return false;
    const Number least = w.least(place) - 2 * offset;
    Vertex_record& record = m_vertices.write(v);
    if(record.has_started)
      return record.started <= least;
    if(least < record.promised) {
      record.promised = least - row_allowance * w.radius;
      push_vertex(v, record.promised);
    }
    return true;
  }

  // Returns whether it crosses an edge twice, which no shortest path does [MMP87], but rounded rays in flat faces can.
  bool comes_back(const Window& w) const
  {
    Index before = w.parent;
    while(before != null_index && m_windows[before].halfedge != w.halfedge)
      before = m_windows[before].parent;
    return before != null_index;
  }

  void propagate(Index id)
  {
    const Window w = m_windows[id];
    const Index side = m_faces.number(w.halfedge);
    const Vector apex = m_faces.apex(side);
    const auto base = m_faces[side], next = m_faces[Faces::next(side)], previous = m_faces[Faces::previous(side)];
    const Edge left = {twin_index(previous.halfedge), previous.length, {base.cosine, base.sine}, 0, 0};
    const Edge right = {twin_index(next.halfedge), next.length, {next.cosine, -next.sine}, base.length, next.length};
    // The position at which the ray to the apex crosses the edge.
    using std::abs;
    const Number height = w.y + apex.imag();
    const Number away = norm(w.x, w.y) + base.length + previous.length;
    const Number error = w.radius + step_error * away;
    const bool is_flat = !(height > 8 * error);
    const Number crossing = is_flat ? w.from : w.x + (apex.real() - w.x) * (w.y / height);
    const Number crossing_error = is_flat ? infinity : 2 * error * (1 + abs(apex.real() - w.x) / height);
    if(crossing + crossing_error < w.from)
      return enter(id, right, {w.from, w.to, w.margin});
    if(crossing - crossing_error > w.to)
      return enter(id, left, {w.from, w.to, w.margin});

    const Number leg = norm(apex.real() - w.x, height);
    const Length& before = m_vertices[w.root].length;
    const Number leg_error = error + evaluation_error * (before.computed + leg);
    const bool is_seen = crossing - crossing_error >= w.from + w.margin && crossing + crossing_error <= w.to - w.margin;
    const Length length = {(std::max)(w.sigma, w.sigma + leg - leg_error), before.computed + leg,
                           is_seen ? before.most + leg + leg_error : infinity, error};
    if(previous.tail != w.root) // to which flat faces can lead back
      offer(previous.tail, length, {id, null_index, Rounding::nearest(leg)});
    const auto [goes_left, goes_right] = sides_to_enter(side, length, crossing, crossing_error);
    const Number margin = (std::max)(w.margin, 2 * crossing_error);
    if(goes_left)
      enter(id, left, {w.from, (std::min)(crossing + crossing_error, w.to), margin});
    if(goes_right)
      enter(id, right, {(std::max)(crossing - crossing_error, w.from), w.to, margin});
  }

  // The sides of the apex on which the rays of a window, with a path to the apex across the edge of a side, can be
  // useful.
  std::pair<bool, bool> sides_to_enter(Index side, const Length& length, const Number& crossing, const Number& error)
  {
    if(!(length.most < infinity))
      return {true, true};
    if(m_splits.size() < m_faces.size())
      m_splits.resize(m_faces.size(), Split());
    Split& split = m_splits[static_cast<std::size_t>(side)];
    const bool is_worse = split.is_set && length.least > split.length;
    const Number allowed = error + split.error;
    const bool is_left = crossing + allowed < split.crossing;
    const bool is_right = crossing - allowed > split.crossing;
    if(!split.is_set || length.most < split.length)
      split = {length.most, crossing, error, true};
    // If its path is not the best at the apex, the window is useless beyond the ray of the best one.
    return {!is_worse || !is_right, !is_worse || !is_left};
  }

  // Propagates the rays of a window through a part of it to another edge of the face that they enter.
  void enter(Index id, const Edge& edge, const Part& part)
  {
    const Window& w = m_windows[id];
    const auto in_frame = [&](const Number& x, const Number& y) {
      return Vector{x - edge.base, y} * conj(edge.axis) + edge.base_place;
    };
    const Vector seen = in_frame(w.x, -w.y);
    const Number away = norm(w.x - edge.base, w.y);
    const Number carried = w.radius + step_error * (away + edge.base + edge.length);
    if(!(seen.imag() < carried))
      return;
    const Number depth = (std::max)(-seen.imag(), Number(0));
    const Number radius = carried + (depth + seen.imag()); // the displacement of the source
    Number margin = 0;
    const auto hit = [&](const Number& b, bool is_end) {
      const Vector point = in_frame(b, 0);
      const Number fall = point.imag() + depth;
      if(!(fall > 4 * radius)) {
        margin = edge.length;
        return is_end ? edge.length : Number(0);
      }
      const Number run = depth * ((point.real() - seen.real()) / fall);
      using std::abs;
      const Number error = 4 * radius * ((abs(run) + depth) / fall);
      const Number spread = (w.y + radius) * ((depth + radius) / fall) / (fall - part.margin);
      margin = fall > 2 * part.margin ? (std::max)(margin, part.margin * spread + 2 * error) : edge.length;
      const Number place = seen.real() + run + (is_end ? error : -error);
      return (std::min)((std::max)(place, Number(0)), edge.length);
    };
    const Number from = hit(part.from, false), to = hit(part.to, true);
    open({edge.halfedge, id, w.root, from, to, seen.real(), depth, w.sigma, radius, margin}, edge.length);
  }

  static Number norm(const Number& x, const Number& y) { return Window::norm(x, y); }

  const Triangulation& m_triangulation;
  Faces& m_faces;
  Vertex_index m_source;
  const Sweep* m_sweep;
  Written_records<Vertex_index, Vertex_record> m_vertices;
  Block_array<Split> m_splits; // of sides
  std::vector<Window> m_windows, m_border_windows;
  bool m_keeps_border_windows = false;
  Heap_of_four<Entry> m_heap;
  std::size_t m_number_of_starts = 0; // of rays along edges; a vertex can start rays repeatedly without a window
  bool m_may_come_round = false;      // whether a vertex may not be farther away than the one from which its path comes
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_SEARCH_H
