// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_DELAUNAY_REFINER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_DELAUNAY_REFINER_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Halfedge_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Lawson_flips.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns the third corner of a triangle on the left of the segment from p to q, by its distances from q and from p. */
inline std::complex<double> apex_of(const std::complex<double>& p, const std::complex<double>& q, double from_q,
                                    double to_p)
{
  const double length = std::abs(q - p);
  const double x = ((to_p - from_q) * (to_p + from_q) + length * length) / (2 * length);
  const double y = std::sqrt((std::max)((to_p - x) * (to_p + x), 0.0));
  return p + (q - p) / length * std::complex<double>(x, y);
}

/* A surface point in the input face, or on its border, that corresponds to a gap in the edge sequence of an intrinsic
 * halfedge. */
struct Point_at_piece
{
  Surface_location location;
  Halfedge_index halfedge;
  std::size_t gap;
};

/*
 * Maps points of an intrinsic face to surface points of the input: the input face that contains them and the position
 * in it.
 *
 * The face of h = A->B lies in the plane with A at the origin and B on the positive real axis. Side i leads from corner
 * i + 1 to corner i + 2; side 0 is h. The input edges that pass cut the face into parts, each given by the sides of
 * which it has a piece. A part is mapped into its input face by the motion that takes its two most distant vertices
 * there, so that errors are relative to the size of the part.
 */
template <class Triangulation>
class Face_chart
{
public:
  using Complex = std::complex<double>;
  using Weights = std::array<double, 3>;

  Face_chart(const Triangulation& triangulation, Halfedge_index h)
    : m_triangulation(triangulation)
  {
    m_sides[0].halfedge = h;
    m_sides[1].halfedge = triangulation.next(h);
    m_sides[2].halfedge = triangulation.next(m_sides[1].halfedge);
    m_corners[1] = 0;
    m_corners[2] = triangulation.length(h);
    m_corners[0] = apex_of(m_corners[1], m_corners[2], triangulation.length(m_sides[1].halfedge),
                           triangulation.length(m_sides[2].halfedge));
    for(Side& side : m_sides)
      measure(side);
  }

  /* Locates a point of the plane that lies in the face up to rounding errors; returns nothing if this fails. */
  std::optional<Point_at_piece> locate(const Complex& z) const
  {
    const Part part = part_of(z);
    const Vertex* from = &part.vertices.front();
    const Vertex* to = from;
    for(const Vertex& u : part.vertices)
      for(const Vertex& v : part.vertices)
        if(std::abs(u.position - v.position) > std::abs(from->position - to->position)) {
          from = &u;
          to = &v;
        }
    const std::optional<Surface_location> location = moved(*from, *to, z);
    if(!location)
      return {};
    return Point_at_piece{*location, part.halfedge, part.gap};
  }

private:
  struct Side
  {
    Halfedge_index halfedge;
    Edge_sequence sequence;
    std::vector<double> along, on_input; // of each crossing, as computed by the strip
  };

  // A vertex of a part, with its weights in the part's input face.
  struct Vertex
  {
    Complex position;
    Weights weights;
    Input_halfedge_index face;
  };

  // Given by a side and a gap in its edge sequence, in which the part has a piece of that side.
  struct Part
  {
    Halfedge_index halfedge;
    std::size_t gap;
    std::vector<Vertex> vertices;
  };

  void measure(Side& side) const
  {
    side.sequence = m_triangulation.edge_sequence(side.halfedge);
    if(side.sequence.crossed.empty())
      return;
    const Strip<Triangulation> strip(m_triangulation, side.sequence);
    for(std::size_t i = 0; i < strip.portals().size(); ++i) {
      side.along.push_back(strip.crossing_along(i));
      side.on_input.push_back(strip.crossing(i));
    }
  }

  // Point k of side i: the tail, the crossings, the head.
  Complex position(int i, std::size_t k) const
  {
    const Complex tail = m_corners[(i + 1) % 3], head = m_corners[(i + 2) % 3];
    if(k == 0)
      return tail;
    return k > m_sides[i].along.size() ? head : tail + m_sides[i].along[k - 1] * (head - tail);
  }

  Part part_of(const Complex& z) const
  {
    const auto number = [this](int i) { return static_cast<Index>(m_sides[i].along.size()); };
    const Triangle_crossings passing(number(0), number(1), number(2));
    for(int corner = 0; corner < 3; ++corner) {
      const int before = (corner + 1) % 3, after = (corner + 2) % 3;
      for(Index k = 0; k < passing.cutting[corner]; ++k) { // from the corner outwards
        const Complex u = position(after, k + 1), v = position(before, number(before) - k);
        if(cross(v - u, z - u) <= 0)
          continue;
        Part part = part_at(after, k);
        add_piece(before, number(before) - k, part);
        return part;
      }
    }
    for(int i = 0; i < 3; ++i)
      if(passing.emanating[i] > 0)
        return part_of_fan(i, passing, z);
    Part part = part_at(0, passing.cutting[1]);
    for(int i = 1; i < 3; ++i)
      add_piece(i, passing.cutting[(i + 1) % 3], part);
    return part;
  }

  // Finds the part at corner i, from which input edges emanate.
  Part part_of_fan(int i, const Triangle_crossings& passing, const Complex& z) const
  {
    Index gap = passing.cutting[(i + 1) % 3];
    const Index last = gap + passing.emanating[i];
    while(gap < last && cross(position(i, gap + 1) - m_corners[i], z - m_corners[i]) > 0)
      ++gap;
    Part part = part_at(i, gap);
    const Input_halfedge_index face = part.vertices.front().face;
    const Vertex_index corner = m_triangulation.tail(m_sides[(i + 2) % 3].halfedge);
    part.vertices.push_back({m_corners[i], vertex_weights(m_triangulation, corner, face), face});
    return part;
  }

  // The part with the piece of side i in a gap of its edge sequence.
  Part part_at(int i, std::size_t gap) const
  {
    Part part = {m_sides[i].halfedge, gap, {}};
    add_piece(i, gap, part);
    return part;
  }

  // Adds the ends of the piece of side i in a gap of its edge sequence.
  void add_piece(int i, std::size_t gap, Part& part) const
  {
    const auto& input = m_triangulation.input();
    const Edge_sequence& sequence = m_sides[i].sequence;
    const Input_halfedge_index own = face_of_gap(sequence, gap);
    const Input_halfedge_index face = part.vertices.empty() ? own : part.vertices.front().face;
    for(const std::size_t k : {gap, gap + 1}) {
      Weights weights;
      if(k == 0)
        weights = vertex_weights(m_triangulation, sequence.tail, face);
      else if(k > sequence.crossed.size())
        weights = vertex_weights(m_triangulation, sequence.head, face);
      else if(k > gap) // left through the crossed edge at the end of the piece
        weights = weights_on_side(input, face, sequence.crossed[k - 1], m_sides[i].on_input[k - 1]);
      else // entered through that at its start
        weights = weights_on_side(input, face, twin_index(sequence.crossed[k - 1]), 1 - m_sides[i].on_input[k - 1]);
      part.vertices.push_back({position(i, k), divided_by_sum(weights), face});
    }
  }

  std::optional<Surface_location> moved(const Vertex& from, const Vertex& to, const Complex& z) const
  {
    if(from.position == to.position)
      return {};
    const auto face = input_face_geometry(m_triangulation, from.face);
    const Complex b(face[0].x, face[0].y), c(-face[2].x, -face[2].y);
    const auto place = [&](const Weights& w) { return w[1] * b + w[2] * c; };
    const Complex motion = (place(to.weights) - place(from.weights)) / (to.position - from.position);
    const Complex p = place(from.weights) + motion * (z - from.position);
    const double area = cross(b, c);
    Surface_location result = {from.face, {{0, cross(p, c) / area, cross(b, p) / area}}};
    result.weights[0] = 1 - result.weights[1] - result.weights[2];
    for(double& weight : result.weights) {
      if(!(std::abs(weight) < 2))
        return {}; // a degenerate face
      weight = weight < zero_layout_weight ? 0 : weight;
    }
    return result;
  }

  const Triangulation& m_triangulation;
  std::array<Side, 3> m_sides;
  std::array<Complex, 3> m_corners;
};

/* A point on an intrinsic edge: its surface point on the input, and the gap of the edge sequence that contains it. */
struct Point_on_edge
{
  Surface_location location;
  std::size_t gap;
};

/*
 * Returns a point at about `t` along halfedge h, from 0 at the tail to 1 at the head. It lies inside an input face if
 * the edge does, and is therefore shifted slightly where the edge crosses an input edge. Returns nothing if the piece
 * is too short.
 */
template <class Triangulation>
std::optional<Point_on_edge> point_on_edge(const Triangulation& triangulation, Halfedge_index h, double t)
{
  constexpr double margin = 0.05; // of the piece in an input face
  const Edge_sequence sequence = triangulation.edge_sequence(h);
  const Input_halfedge_index face = face_of_gap(sequence, 0);
  Point_on_edge result = {{face, {{0, 0, 0}}}, 0};
  if(sequence.crossed.empty()) {
    std::array<double, 3> a = vertex_weights(triangulation, sequence.tail, face);
    std::array<double, 3> b = vertex_weights(triangulation, sequence.head, face);
    const double sum_a = a[0] + a[1] + a[2], sum_b = b[0] + b[1] + b[2];
    for(int i = 0; i < 3; ++i)
      result.location.weights[i] = (1 - t) * a[i] / sum_a + t * b[i] / sum_b;
    return result;
  }
  const Strip<Triangulation> strip(triangulation, sequence);
  double low = 0, best_distance = 2, best_t = t;
  for(std::size_t i = 0; i <= sequence.crossed.size(); ++i) {
    const double high = i < sequence.crossed.size() ? strip.crossing_along(i) : 1, room = margin * (high - low);
    const double nearest = (std::min)((std::max)(t, low + room), high - room);
    if(room > least_point_spacing && std::abs(nearest - t) < best_distance) {
      best_distance = std::abs(nearest - t);
      best_t = nearest;
      result.gap = i;
    }
    low = (std::max)(low, high);
  }
  if(best_distance > 1)
    return {};
  const auto corners = strip.face(result.gap);
  const std::complex<double> p = best_t * strip.end(), b = corners[1].position - corners[0].position,
                             c = corners[2].position - corners[0].position, d = p - corners[0].position;
  const double area = cross(b, c);
  result.location.halfedge = face_of_gap(sequence, result.gap);
  result.location.weights = {{0, cross(d, c) / area, cross(b, d) / area}};
  result.location.weights[0] = 1 - result.location.weights[1] - result.location.weights[2];
  for(double weight : result.location.weights)
    if(!(weight > zero_layout_weight && weight < 1))
      return {};
  return result;
}

/*
 * Predicts whether the vertices that refinement may still insert suffice to remove the thin faces in its queue.
 *
 * A face of area A with shortest side s takes about A / s^2 vertices if faces cannot grow away from that side, as on a
 * tube as thin as s or between curves as close. Elsewhere they can, a few vertices suffice, and the *need*, the sum of
 * A / s^2 over the bad faces, falls by half or more per generation, in which as many faces are treated as were queued
 * at its start. If the need is many times the number of allowed vertices and has not fallen for two generations, the
 * bounds are therefore considered out of reach.
 */
class Refinement_outlook
{
public:
  /* Returns the contribution of a face to the need. */
  static double need(const std::array<double, 3>& lengths, double sine_of_smallest_angle)
  {
    const double shortest = (std::min)({lengths[0], lengths[1], lengths[2]});
    const double longest = (std::max)({lengths[0], lengths[1], lengths[2]});
    const double middle = lengths[0] + lengths[1] + lengths[2] - shortest - longest;
    return 0.5 * sine_of_smallest_angle * (longest / shortest) * (middle / shortest);
  }

  /* Adds a thin face that enters the queue. */
  void add(double need)
  {
    m_need += need;
    ++m_size;
  }

  /* Removes a thin face that leaves the queue. */
  void remove(double need)
  {
    m_need -= need;
    --m_size;
    if(m_left_of_generation > 0)
      --m_left_of_generation;
  }

  /* Returns whether the bounds are out of reach with `allowed` more vertices. Must be called before each thin face. */
  bool is_hopeless(std::size_t allowed)
  {
    if(m_left_of_generation > 0)
      return false;
    const bool is_stagnant = m_need > most_kept * m_need_before && m_need > certainty * static_cast<double>(allowed);
    m_stagnant_generations = is_stagnant ? m_stagnant_generations + 1 : 0;
    m_need_before = m_need;
    m_left_of_generation = m_size;
    return m_stagnant_generations >= 2;
  }

  /* Returns the mean need of the faces in the queue. */
  double mean_need() const { return m_need / static_cast<double>((std::max)(m_size, std::size_t(1))); }

private:
  static constexpr double most_kept = 0.9; // of the need over a generation, if the bounds are in reach
  static constexpr double certainty = 16;  // required ratio of the need, an estimate, to the allowed number

  double m_need = 0;
  double m_need_before = std::numeric_limits<double>::infinity();
  std::size_t m_size = 0, m_left_of_generation = 0;
  int m_stagnant_generations = 0;
};

/*
 * Makes the faces around a new vertex Delaunay. Each flip creates an edge at the vertex, and such edges are not flipped
 * again, except in a few ties or after wrong flips. Flips are therefore few and cannot be interrupted.
 */
template <class Triangulation>
class Star_flips
{
public:
  explicit Star_flips(Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_lawson(triangulation, true)
  {
  }

  /* Returns false and leaves the faces unchanged if flips were wrong. The visitor observes each flip. */
  template <class Visitor>
  bool flip_around(Vertex_index x, Visitor& visitor)
  {
    const auto before = m_triangulation.log_position();
    m_lawson.clear();
    for_each_edge_in_star(m_triangulation, x, [this](Halfedge_index h) { m_lawson.look_at(Triangulation::edge(h)); });
    m_flipped.clear();
    Recorder<Visitor> recorder = {visitor, m_flipped, x};
    try {
      m_flips += m_lawson.flip((std::numeric_limits<std::size_t>::max)(), recorder);
      if(!recorder.has_lost_its_way() &&
         std::all_of(m_flipped.begin(), m_flipped.end(), [this](Halfedge_index h) { return has_right_sequence(h); }))
        return true;
    } catch(const Insertion_error&) { // an edge sequence does not lead from end to end
    }
    m_triangulation.rollback(before);
    return false;
  }

  /* The halfedges that were flipped around the last vertex. */
  const std::vector<Halfedge_index>& flipped() const { return m_flipped; }

  /* Returns the number of all flips, including those rolled back. */
  std::size_t flips() const { return m_flips; }

private:
  // Records flips, forwards them to the visitor, and stops if they are wrong.
  template <class Visitor>
  struct Recorder
  {
    Visitor& visitor;
    std::vector<Halfedge_index>& flipped;
    Vertex_index x;
    int strays = 0;

    bool go_further() const { return !has_lost_its_way(); }
    bool has_lost_its_way() const { return strays > 64; }
    void on_flip(const Triangulation& triangulation, Halfedge_index h)
    {
      strays += triangulation.tail(h) == x || triangulation.head(h) == x ? 0 : 1;
      flipped.push_back(h);
      visitor.on_flip(triangulation, h);
    }
  };

  // Returns false or throws if flips were wrong: the sequence of a flipped edge must lead from end to end inside the
  // surface.
  bool has_right_sequence(Halfedge_index h) const
  {
    const Edge_sequence sequence = m_triangulation.edge_sequence(h);
    const auto is_inside = [&input = m_triangulation.input()](Input_halfedge_index g) {
      return !input.is_border(g) && !input.is_border(twin_index(g));
    };
    return (sequence.along == null_index || is_inside(sequence.along)) &&
           std::all_of(sequence.crossed.begin(), sequence.crossed.end(), is_inside);
  }

  Triangulation& m_triangulation;
  Lawson_flips<Triangulation> m_lawson;
  std::vector<Halfedge_index> m_flipped;
  std::size_t m_flips = 0;
};

/* Detects models of CurveNetwork, as opposed to triangulations, by their curves. */
template <class T, class = void>
constexpr bool has_curves = false;
template <class T>
constexpr bool
    has_curves<T, std::void_t<typename T::Triangulation, decltype(std::declval<const T&>().number_of_curves())>> = true;

/* Returns whether the edge of h carries a curve or lies on the border. */
template <class Triangulation>
bool is_constrained_edge(const Triangulation& triangulation, Halfedge_index h)
{
  return triangulation.holds(Triangulation::edge(h)) != 0 || triangulation.is_border(h) ||
         triangulation.is_border(Triangulation::twin(h));
}

/* The rounded lengths and angles of an intrinsic face. Side i leads from corner i to corner i + 1; side 0 is h. */
template <class Triangulation>
class Face_shape
{
public:
  Face_shape(const Triangulation& triangulation, Halfedge_index h)
  {
    for(int i = 0; i < 3; ++i, h = triangulation.next(h)) {
      m_sides[i] = h;
      m_lengths[i] = triangulation.length(h);
    }
  }

  const std::array<double, 3>& lengths() const { return m_lengths; }

  /* Returns the angle at corner i. */
  double angle(int i) const
  {
    // The half-angle formula [K14] is accurate for every shape if differences are evaluated in this order.
    const double a = m_lengths[(i + 1) % 3], b = (std::max)(m_lengths[i], m_lengths[(i + 2) % 3]),
                 c = (std::min)(m_lengths[i], m_lengths[(i + 2) % 3]);
    const double rest = c >= a ? a - (b - c) : c - (b - a);
    const double low = (std::max)(((b - c) + a) * rest, 0.0), high = (std::max)((b + (c + a)) * ((b - a) + c), 0.0);
    return 2 * std::atan2(std::sqrt(low), std::sqrt(high));
  }

  /* Returns the cosine of the angle opposite to side 0. */
  double cosine_opposite() const { return std::cos(angle(2)); }

  int smallest_corner() const
  {
    const int shortest = static_cast<int>((std::min_element)(m_lengths.begin(), m_lengths.end()) - m_lengths.begin());
    return (shortest + 2) % 3;
  }

  double smallest_angle() const { return angle(smallest_corner()); }

  double shortest() const { return (std::min)({m_lengths[0], m_lengths[1], m_lengths[2]}); }
  double longest() const { return (std::max)({m_lengths[0], m_lengths[1], m_lengths[2]}); }

  /* Returns the shortest side. */
  Halfedge_index shortest_side() const { return m_sides[(smallest_corner() + 1) % 3]; }

  /* Returns the side with the smallest corner at its tail. */
  Halfedge_index outgoing_halfedge_of_smallest_corner() const { return m_sides[smallest_corner()]; }

private:
  std::array<Halfedge_index, 3> m_sides;
  std::array<double, 3> m_lengths;
};

/* The vertices at which refinement has split initially constrained edges, the *segments*. */
template <class Triangulation>
class Segment_points
{
public:
  /* A point on a segment: the ends of the segment and the distances to them. */
  struct Point
  {
    std::array<Vertex_index, 2> ends;
    std::array<double, 2> distances;
  };

  explicit Segment_points(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  void add(Vertex_index v, const Point& point) { m_points[v] = point; }

  /* Returns the point of a vertex that would split the edge of h at distance `length` from its tail. */
  Point point(Halfedge_index h, double length) const
  {
    const std::array<Vertex_index, 2> at = {m_triangulation.tail(h), m_triangulation.head(h)};
    const std::array<double, 2> halves = {length, m_triangulation.length(h) - length};
    Point result;
    for(int i = 0; i < 2; ++i) {
      result.ends[i] = at[i];
      result.distances[i] = halves[i];
      const auto found = m_points.find(at[i]);
      if(found == m_points.end())
        continue;
      const Point& old = found->second;
      const int beyond = end_beyond(old, at[1 - i]);
      result.ends[i] = old.ends[beyond];
      result.distances[i] += old.distances[beyond];
    }
    return result;
  }

  /* Returns whether h leads from one segment to another one with a common end, at about equal distances from that
   * end. */
  bool spans_small_angle(Halfedge_index h) const
  {
    const auto p = m_points.find(m_triangulation.tail(h)), q = m_points.find(m_triangulation.head(h));
    if(p == m_points.end() || q == m_points.end() || is_constrained_edge(m_triangulation, h))
      return false;
    for(int i = 0; i < 2; ++i)
      for(int j = 0; j < 2; ++j) {
        const double a = p->second.distances[i], b = q->second.distances[j];
        if(p->second.ends[i] == q->second.ends[j] && std::abs(a - b) < 0.2 * (std::min)(a, b))
          return true;
      }
    return false;
  }

private:
  // The end of the point's segment away from v, which is another vertex of the segment.
  int end_beyond(const Point& point, Vertex_index v) const
  {
    const auto found = m_points.find(v);
    if(found == m_points.end())
      return point.ends[0] == v ? 1 : 0;
    const int same = found->second.ends[0] == point.ends[0] ? 0 : 1;
    return found->second.distances[same] > point.distances[0] ? 0 : 1;
  }

  const Triangulation& m_triangulation;
  std::unordered_map<Vertex_index, Point> m_points;
};

/*
 * Determines the *sharp sectors*: the sectors between constrained edges at a vertex, or the full angle around it, that
 * are smaller than 60 degrees. Flips and insertions do not change these angles, so sharp sectors are recorded at
 * their halfedges and not measured again. A halfedge takes constant amortized time while its version lasts, however
 * many of them the sector contains. Other sectors are measured only until they reach 60 degrees.
 */
template <class Triangulation>
class Sharp_sectors
{
public:
  explicit Sharp_sectors(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Returns whether the corner at the tail of h, in the face on its left, is in a sharp sector. */
  bool operator()(Halfedge_index h)
  {
    m_walked.assign(1, h);
    double sum = angle_at_tail(h);
    bool is_known = is_noted(h);
    for(Halfedge_index g = h; !is_known && !is_constrained(g) && sum < sharp;) {
      g = m_triangulation.clockwise(g);
      if(g == h)
        return note(sum);
      is_known = walk_over(g, sum);
    }
    for(Halfedge_index g = m_triangulation.counterclockwise(h); !is_known && sum < sharp && !is_constrained(g);
        g = m_triangulation.counterclockwise(g))
      is_known = walk_over(g, sum);
    return note(is_known ? 0 : sum);
  }

private:
  static constexpr double sharp = boost::math::constants::pi<double>() / 3;

  // Returns whether the sector is recorded there.
  bool walk_over(Halfedge_index g, double& sum)
  {
    m_walked.push_back(g);
    sum += angle_at_tail(g);
    return is_noted(g);
  }

  bool note(double sum)
  {
    if(sum < sharp - sharp_sector_margin)
      for(Halfedge_index g : m_walked) {
        if(m_versions.size() <= static_cast<std::size_t>(g.idx()))
          m_versions.resize(static_cast<std::size_t>(m_triangulation.number_of_halfedges()), null_index);
        m_versions[static_cast<std::size_t>(g.idx())] = m_triangulation.version(Triangulation::edge(g));
      }
    return sum < sharp;
  }

  bool is_noted(Halfedge_index g) const
  {
    return static_cast<std::size_t>(g.idx()) < m_versions.size() &&
           m_versions[static_cast<std::size_t>(g.idx())] == m_triangulation.version(Triangulation::edge(g));
  }

  double angle_at_tail(Halfedge_index h) const { return Face_shape<Triangulation>(m_triangulation, h).angle(0); }

  bool is_constrained(Halfedge_index h) const { return is_constrained_edge(m_triangulation, h); }

  const Triangulation& m_triangulation;
  std::vector<Index> m_versions; // by halfedge: the version of its edge when its sector was found sharp
  std::vector<Halfedge_index> m_walked;
};

/*
 * Delaunay refinement [C93, R95, S02] of an intrinsic triangulation [SSC19, section 4.3]: a
 * vertex is inserted at the circumcenter of each bad face, the worst first. If a constrained edge is in the way, or if
 * the vertex would see one under an angle above 120 degrees, that edge is split instead and the vertex is rolled back
 * by the log.
 *
 * If the allowed vertices are far too few, the faces with the greatest need are abandoned, and the others are refined
 * until their need does not decrease any more either.
 *
 * \tparam OnSplit is called for the halves of each edge that is split, to divide the curves on it
 * \tparam Visitor is called before each face, for each flip and for each vertex
 */
template <class Triangulation, class OnSplit, class Visitor>
class Delaunay_refiner
{
  using Complex = std::complex<double>;

public:
  struct Limits
  {
    double smallest_angle; // radians
    double longest_edge;
    std::size_t insertions;
  };

  struct Counts
  {
    std::size_t splits = 0, refused = 0;
  };

  enum class End { NO_FACE_LEFT, LIMIT, VISITOR };

  Delaunay_refiner(Triangulation& triangulation, const OnSplit& on_split, const Limits& limits, Visitor& visitor)
    : m_triangulation(triangulation)
    , m_on_split(on_split)
    , m_visitor(visitor)
    , m_limits(limits)
    , m_star(triangulation)
    , m_is_in_sharp_sector(triangulation)
    , m_points(triangulation)
    , m_number_of_old_vertices(triangulation.number_of_vertices())
  {
  }

  /* Refines a triangulation that is constrained Delaunay. */
  End run()
  {
    for(Halfedge_index h : descriptors<Halfedge_index>(m_triangulation.number_of_halfedges()))
      if(!m_triangulation.is_border(h) && least_in_face(m_triangulation, h) == h)
        look_at(h);
    while(!m_queue.empty()) {
      if(is_full())
        return End::LIMIT;
      // Faces with edges that are too long come first, and do not reduce the need.
      if(!is_too_long(m_queue.top().lengths) &&
         m_outlook.is_hopeless(has_given_up() ? 0 : m_limits.insertions - number_of_new_vertices()))
      {
        if(has_given_up())
          break;
        give_up();
      }
      const Bad_face bad = take_worst();
      if(is_given_up(bad.lengths) || !is_current(bad))
        continue;
      if(!m_visitor.go_further())
        return End::VISITOR;
      if(improve(bad.halfedge))
        look_at(bad.halfedge); // still bad if only an edge was split
      else
        ++m_counts.refused;
    }
    return End::NO_FACE_LEFT;
  }

  const Counts& counts() const { return m_counts; }

  /* Returns the number of flips, including those rolled back. */
  std::size_t flips() const { return m_star.flips(); }

  /* Returns the number of vertices inserted into faces and constrained edges. */
  std::size_t number_of_new_vertices() const
  {
    return static_cast<std::size_t>(m_triangulation.number_of_vertices() - m_number_of_old_vertices);
  }

  /*
   * Returns the badness of a face; 0 if it is good or exempt. A face is exempt from the bound on angles if its smallest
   * angle lies between constrained edges that meet at less than 60 degrees or around a vertex with a smaller total
   * angle, or if its shortest side spans such an angle between points at nearly equal distances from the vertex [S02].
   */
  double badness(Halfedge_index h)
  {
    const Shape shape(m_triangulation, h);
    if(is_too_long(shape.lengths()))
      return 2 + shape.longest() / m_limits.longest_edge;
    const double angle = shape.smallest_angle();
    return angle < m_limits.smallest_angle && !is_exempt(shape) ? 2 - angle / m_limits.smallest_angle : 0;
  }

  bool is_exempt(Halfedge_index h) { return is_exempt(Shape(m_triangulation, h)); }

  /* Returns whether a bad face was abandoned because the allowed vertices cannot suffice. */
  bool is_given_up(Halfedge_index h) const { return is_given_up(Shape(m_triangulation, h).lengths()); }

private:
  using Shape = Face_shape<Triangulation>;
  using Lengths = std::array<double, 3>;

  struct Bad_face
  {
    double badness, need;
    Halfedge_index halfedge; // the smallest halfedge of the face
    Lengths lengths;

    bool operator<(const Bad_face& other) const
    {
      return badness != other.badness ? badness < other.badness : halfedge > other.halfedge;
    }
  };

  // ---------------------------------------------------------------- the queue

  void look_at(Halfedge_index h)
  {
    if(m_triangulation.is_border(h))
      return;
    const Halfedge_index first = least_in_face(m_triangulation, h);
    const double how_bad = badness(first);
    if(how_bad <= 0)
      return;
    const Shape shape(m_triangulation, first);
    if(is_given_up(shape.lengths()))
      return;
    m_queue.push({how_bad, need(shape), first, shape.lengths()});
    if(!is_too_long(shape.lengths()))
      m_outlook.add(need(shape));
  }

  Bad_face take_worst()
  {
    const Bad_face worst = m_queue.top();
    m_queue.pop();
    if(!is_too_long(worst.lengths))
      m_outlook.remove(worst.need);
    return worst;
  }

  bool is_full() const { return number_of_new_vertices() >= m_limits.insertions; }

  // The contribution of a thin face to the need.
  double need(const Shape& shape) const
  {
    return is_too_long(shape.lengths()) ? 0
                                        : Refinement_outlook::need(shape.lengths(), std::sin(shape.smallest_angle()));
  }

  bool is_too_long(const Lengths& lengths) const
  {
    return *std::max_element(lengths.begin(), lengths.end()) > m_limits.longest_edge;
  }

  bool has_given_up() const { return m_finest_side > 0; }

  bool is_given_up(const Lengths& lengths) const
  {
    return *std::min_element(lengths.begin(), lengths.end()) <= m_finest_side && !is_too_long(lengths);
  }

  // Abandons faces by the length of their shortest sides, up to that of the faces with the greatest need. Smaller faces
  // are not refined anywhere, since otherwise the abandoned faces would be refined step by step from their ends.
  void give_up()
  {
    const double many = m_outlook.mean_need() / 2;
    for(Halfedge_index h : descriptors<Halfedge_index>(m_triangulation.number_of_halfedges())) {
      if(m_triangulation.is_border(h) || least_in_face(m_triangulation, h) != h || !(badness(h) > 0))
        continue;
      const Shape shape(m_triangulation, h);
      if(need(shape) >= many)
        m_finest_side = (std::max)(m_finest_side, shape.shortest());
    }
  }

  // Returns whether the face still exists.
  bool is_current(const Bad_face& bad) const
  {
    if(bad.halfedge.idx() >= m_triangulation.number_of_halfedges() || m_triangulation.is_border(bad.halfedge))
      return false;
    if(least_in_face(m_triangulation, bad.halfedge) != bad.halfedge)
      return false;
    const std::array<double, 3> lengths = Shape(m_triangulation, bad.halfedge).lengths();
    for(int i = 0; i < 3; ++i) // the face may have been recomputed from the input
      if(std::abs(lengths[i] - bad.lengths[i]) > same_shape * bad.lengths[i])
        return false;
    return true;
  }

  bool is_exempt(const Shape& shape)
  {
    return m_is_in_sharp_sector(shape.outgoing_halfedge_of_smallest_corner()) ||
           m_points.spans_small_angle(shape.shortest_side());
  }

  // ---------------------------------------------------------------- one face

  // A point in the face on the left of `halfedge`, whose tail is the origin and whose head lies on the positive real
  // axis.
  struct Place
  {
    Halfedge_index halfedge;
    Complex point;
    bool is_blocked; // by the edge of the halfedge
  };

  bool improve(Halfedge_index h)
  {
    const std::optional<Place> center = walk_to_circumcenter(h);
    if(!center)
      return false;
    if(center->is_blocked)
      return split(center->halfedge);
    const auto before = m_triangulation.log_position();
    const Vertex_index x = insert(*center);
    if(x == null_index)
      return false;
    const bool is_removable = !is_on_constrained_edge(x), are_flips_right = m_star.flip_around(x, m_visitor);
    std::vector<Edge_index> encroached;
    if(is_removable && are_flips_right)
      encroached = encroached_by(x);
    if(!encroached.empty() || (is_removable && !are_flips_right)) {
      m_triangulation.rollback(before);
      return split_all(encroached);
    }
    look_around(x);
    m_visitor.on_insertion(m_triangulation, x);
    return true;
  }

  // Inserts a vertex. Returns null_index if numbers are too coarse or there is a vertex already. Points are located
  // from corners of their input faces, as if each were inserted alone, until that becomes too expensive.
  Vertex_index insert(const Place& center)
  {
    constexpr std::size_t letters_per_point = 512;
    const Vertex_index wanted(m_triangulation.number_of_vertices());
    try {
      const auto place = Face_chart<Triangulation>(m_triangulation, center.halfedge).locate(center.point);
      if(!place || !has_room(place->location, std::abs(center.point)))
        return null_index;
      Known_piece close_by = {place->halfedge, place->gap, m_letters + letters_per_point};
      const Vertex_index x = Internals<Triangulation>::insert(m_triangulation, place->location, m_on_split, close_by);
      m_letters = close_by.letters;
      return x == wanted ? x : null_index;
    } catch(const Insertion_error&) {
      return null_index;
    }
  }

  // The point was exactly on the edge, which was therefore split, and a curve with it.
  bool is_on_constrained_edge(Vertex_index x) const
  {
    bool result = false;
    for_each_edge_in_star(m_triangulation, x, [&](Halfedge_index h) {
      const bool is_outgoing_halfedge = m_triangulation.tail(h) == x || m_triangulation.head(h) == x;
      result = result || (is_outgoing_halfedge && is_constrained(h));
    });
    return result;
  }

  // Returns whether weights in the input face are fine enough for edges of length `distance`.
  bool has_room(const Surface_location& location, double distance) const
  {
    double longest = 0;
    Input_halfedge_index h = location.halfedge;
    for(int i = 0; i < 3; ++i, h = m_triangulation.input().next(h))
      longest = (std::max)(longest, m_triangulation.metric().length(m_triangulation.input(), h));
    return distance > least_point_spacing * longest;
  }

  std::optional<Place> walk_to_circumcenter(Halfedge_index h) const
  {
    constexpr int most_steps = 100000;
    std::array<Complex, 3> p = laid_out(h, 0, m_triangulation.length(h));
    const Complex start = (p[0] + p[1] + p[2]) / 3.0;
    const std::optional<Complex> center = circumcenter(p);
    if(!center)
      return {};
    const auto turn = [&](bool is_to_next) {
      h = is_to_next ? m_triangulation.next(h) : m_triangulation.previous(h);
      std::rotate(p.begin(), p.begin() + (is_to_next ? 1 : 2), p.end());
    };
    for(int i = 0; i < 3 && is_left(p[0], p[1], *center); ++i) // turn to the side of exit
      turn(true);
    // If the circumcenter is beyond two sides, the line to it crosses one of them.
    if(!is_left(p[0], p[1], *center) && !is_between(start, *center, p[0], p[1]))
      turn(!is_left(p[1], p[2], *center));
    for(int step = 0; step < most_steps; ++step) {
      if(is_left(p[0], p[1], *center))
        return Place{h, (*center - p[0]) * std::abs(p[1] - p[0]) / (p[1] - p[0]), false};
      if(is_constrained(h))
        return Place{h, 0, true};
      h = Triangulation::twin(h);
      p = laid_out(h, p[1], p[0]);
      const bool is_inside = is_left(p[1], p[2], *center) && is_left(p[2], p[0], *center);
      if(is_inside)
        continue; // the next step would return, since the center is on the left of h as well
      turn(is_left(start, *center, p[2]));
    }
    return {};
  }

  std::array<Complex, 3> laid_out(Halfedge_index h, const Complex& tail, const Complex& head) const
  {
    const Halfedge_index hn = m_triangulation.next(h);
    return {tail, head,
            apex_of(tail, head, m_triangulation.length(hn), m_triangulation.length(m_triangulation.next(hn)))};
  }

  static bool is_left(const Complex& p, const Complex& q, const Complex& z) { return cross(q - p, z - p) >= 0; }
  static bool is_between(const Complex& from, const Complex& to, const Complex& p, const Complex& q)
  {
    return !is_left(from, to, p) && is_left(from, to, q);
  }

  static std::optional<Complex> circumcenter(const std::array<Complex, 3>& p)
  {
    const Complex b = p[1] - p[0], c = p[2] - p[0];
    const Complex center = Complex(0, 1) * (b * std::norm(c) - c * std::norm(b)) / (2 * cross(b, c));
    if(!std::isfinite(center.real()) || !std::isfinite(center.imag()))
      return {};
    return p[0] + center;
  }

  // ---------------------------------------------------------------- splits and flips

  bool is_constrained(Halfedge_index h) const { return is_constrained_edge(m_triangulation, h); }

  bool split(Halfedge_index h)
  {
    if(m_triangulation.is_border(h))
      h = Triangulation::twin(h);
    const double t = split_position(h);
    const auto in_segment = m_points.point(h, t * m_triangulation.length(h));
    Vertex_index x = null_index;
    try {
      const std::optional<Point_on_edge> point = point_on_edge(m_triangulation, h, t);
      if(!point || !has_room(point->location, (std::min)(t, 1 - t) * m_triangulation.length(h)))
        return false;
      x = m_triangulation.split_edge(h, point->location, point->gap, m_on_split);
    } catch(const Insertion_error&) {
      return false;
    }
    m_points.add(x, in_segment);
    ++m_counts.splits;
    m_star.flip_around(x, m_visitor);
    look_around(x);
    m_visitor.on_insertion(m_triangulation, x);
    return true;
  }

  /*
   * Returns the midpoint or, if one end is an old vertex, a power of two as the distance from it. Constrained edges
   * that meet there are then split at equal distances, and their halves do not keep encroaching upon each other
   * [R95].
   */
  double split_position(Halfedge_index h) const
  {
    const bool is_tail_old = m_triangulation.tail(h).idx() < m_number_of_old_vertices;
    const bool is_head_old = m_triangulation.head(h).idx() < m_number_of_old_vertices;
    if(is_tail_old == is_head_old)
      return 0.5;
    const double length = m_triangulation.length(h);
    const double t = std::exp2(std::round(std::log2(length / 2))) / length;
    return is_tail_old ? t : 1 - t;
  }

  // Splits edges; returns whether any was split.
  bool split_all(const std::vector<Edge_index>& edges)
  {
    bool result = false;
    for(Edge_index e : edges)
      result = (!is_full() && split(first_side(e))) || result;
    return result;
  }

  // The constrained edges that vertex x sees under more than 120 degrees.
  std::vector<Edge_index> encroached_by(Vertex_index x) const
  {
    std::vector<Edge_index> encroached;
    for_each_edge_in_star(m_triangulation, x, [&](Halfedge_index h) {
      const bool is_opposite = !m_triangulation.is_border(h) && m_triangulation.tail(h) != x &&
                               m_triangulation.head(h) != x && is_constrained(h);
      if(is_opposite && Shape(m_triangulation, h).cosine_opposite() < -0.5)
        encroached.push_back(Triangulation::edge(h));
    });
    return encroached;
  }

  void look_around(Vertex_index x)
  {
    std::vector<Halfedge_index> around;
    for_each_edge_in_star(m_triangulation, x, [&around](Halfedge_index h) { around.push_back(h); });
    for(Halfedge_index h : m_star.flipped())
      around.insert(around.end(), {h, Triangulation::twin(h)});
    for(Halfedge_index& h : around)
      h = m_triangulation.is_border(h) ? null_index : least_in_face(m_triangulation, h);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for(Halfedge_index h : around)
      if(h != null_index)
        look_at(h);
  }

  Triangulation& m_triangulation;
  const OnSplit& m_on_split;
  Visitor& m_visitor;
  Limits m_limits;
  Star_flips<Triangulation> m_star;
  Sharp_sectors<Triangulation> m_is_in_sharp_sector;
  Segment_points<Triangulation> m_points;
  Refinement_outlook m_outlook;
  double m_finest_side = 0;         // thin faces with a side no longer than this are abandoned
  std::size_t m_letters = 0x200000; // that the search for points may pass
  Index m_number_of_old_vertices;
  std::priority_queue<Bad_face> m_queue;
  Counts m_counts;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_DELAUNAY_REFINER_H
