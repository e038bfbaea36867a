// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/Slot_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Flip_geodesics::internal {

/*
 * Distances along an edge, which is the x-axis from 0 on: those from a pseudo-source in the plane of a face, plus the
 * length `sigma` up to that source. As a function of the position on the edge it is convex with slopes of at most 1.
 */
struct Cone
{
  double x, y; // y >= 0
  double sigma;

  double operator()(double q) const { return sigma + std::sqrt((q - x) * (q - x) + y * y); }

  /* Returns the cone as seen from the other end of an edge of some length. */
  Cone mirrored(double length) const { return {length - x, y, sigma}; }

  /* Returns the least value between two positions. */
  double least(double from, double to) const { return (*this)((std::min)((std::max)(x, from), to)); }

  /* Returns the least sum with another cone, which lies on the other side of the edge: straight through, if
   * possible. */
  double least_sum(const Cone& other, double from, double to) const
  {
    const double height = y + other.y;
    const double straight = height > 0 ? x + (other.x - x) * (y / height) : (std::max)(x, other.x);
    const double q = (std::min)((std::max)(straight, from), to);
    return (*this)(q) + other(q);
  }
};

/* A position on an edge, and the value of a cone there, or the difference of two cones. */
struct Place_and_value
{
  double place, value;
};

/* Returns the least value of `a - b` between two positions: at an end, or where both have the same slope. */
inline Place_and_value least_difference(const Cone& a, const Cone& b, double from, double to)
{
  Place_and_value least = {from, a(from) - b(from)};
  if(const double value = a(to) - b(to); value < least.value)
    least = {to, value};
  const double q = (a.x * b.y - b.x * a.y) / (b.y - a.y);
  if(q > from && q < to)
    if(const double value = a(q) - b(q); least.value > value)
      least = {q, value};
  return least;
}

/* The cones with given values at the two ends of an edge; the larger sigma is, the lower they are in between. */
struct Cones_through_ends
{
  double length, at_start, at_end;

  /* Returns the sigma of the lowest cone, which falls and rises with slope 1. */
  double largest_sigma() const { return 0.5 * (at_start + at_end - length); }

  /* Returns the sigma of the cone with a third value in between; minus infinity if no cone is that high. */
  double sigma(double place, double value) const
  {
    const double t = place / length, sag = (1 - t) * at_start + t * at_end - value;
    if(!(sag > cone_sag_rounding * length))
      return -std::numeric_limits<double>::infinity();
    // Stewart's theorem for the distances from the pseudo-source to the three positions; avoids the cancellation of
    // squares.
    const double a = at_start - value, b = at_end - value;
    return value + ((1 - t) * a * a + t * b * b - place * (length - place)) / (2 * sag);
  }

  /* Returns the sigma of the flattest cone with at most this slope at the first end; minus infinity if all cones
   * satisfy this. */
  double sigma_at_start(double slope) const { return at_start + sigma_from_end(slope * length + at_start - at_end); }

  /* Returns the sigma of the flattest cone with at least this slope at the second end; minus infinity if all cones
   * satisfy this. */
  double sigma_at_end(double slope) const { return at_end + sigma_from_end(at_end - at_start - slope * length); }

  Cone operator()(double sigma) const
  {
    const double a = at_start - sigma, b = at_end - sigma;
    const double x = 0.5 * (length + (a - b) * ((a + b) / length));
    return {x, std::sqrt((std::max)((a - x) * (a + x), 0.0)), sigma};
  }

private:
  // Minus the distance from the first end to the pseudo-source. The slope there, times the length, equals the rise of
  // the values from that end minus `(length^2 - rise^2) / (2 distance)`; `steepness` is its bound minus the rise.
  double sigma_from_end(double steepness) const
  {
    const double rise = at_end - at_start;
    return steepness < 0 ? 0.5 * (std::max)((length - rise) * (length + rise), 0.0) / steepness
                         : -std::numeric_limits<double>::infinity();
  }
};

/* A part of an edge, and the cone that reaches it. */
struct Lit_part
{
  Cone cone;
  double from, to;
};

/* All cones that reach an edge: up to two through each of the other two sides, and those by way of the apex. */
struct Lit_parts
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::array<Lit_part, 5> part;
  std::size_t size = 0;

  void add(const Cone& cone, double from, double to)
  {
    if(from < to)
      part[size++] = {cone, from, to};
  }

  struct Least
  {
    std::size_t part;
    double value;
  };

  /* Returns the least value at a position and the number of its part; it may belong to another part and continue along
   * the edge. */
  Least least_at(double q) const
  {
    Least least = {0, infinity};
    for(std::size_t i = 0; i < size; ++i) {
      const double nearest = (std::min)((std::max)(q, part[i].from), part[i].to);
      const double value = part[i].cone(nearest) + std::abs(q - nearest);
      if(value < least.value)
        least = {i, value};
    }
    return least;
  }
};

/* One or two cones over an edge: if two fronts meet, one for the positions up to the split and another beyond it. */
struct Edge_cones
{
  Cone first = {0, 0, 0}, second = {0, 0, 0};
  double split = std::numeric_limits<double>::infinity();

  /* Returns the cone over the end of an edge of some length. */
  const Cone& last(double length) const { return split < length ? second : first; }

  double least_sum(const Cone& cone, double from, double to) const
  {
    double least = std::numeric_limits<double>::infinity();
    if(from <= split)
      least = cone.least_sum(first, from, (std::min)(to, split));
    if(to > split)
      least = (std::min)(least, cone.least_sum(second, (std::max)(from, split), to));
    return least;
  }

  /* Returns whether the cones are nowhere above those that reach the edge, up to a tolerance. */
  bool are_below(const Lit_parts& parts, double length, double tolerance) const
  {
    const double end = (std::min)(split, length);
    for(std::size_t i = 0; i < parts.size; ++i) {
      const auto& [cone, from, to] = parts.part[i];
      if(from < end && least_difference(cone, first, from, (std::min)(to, end)).value < -tolerance)
        return false;
      if(to > end && least_difference(cone, second, (std::max)(from, end), to).value < -tolerance)
        return false;
    }
    return true;
  }

  /* Returns the cones as seen from the other end of an edge of some length. */
  Edge_cones mirrored(double length) const
  {
    if(split < length)
      return {second.mirrored(length), first.mirrored(length), length - split};
    return {first.mirrored(length), second, split};
  }
};

/* Returns the sigma of a cone that is not above the parts where this one exceeds them most; its own sigma if it nowhere
 * does. */
inline double sigma_below(const Cone& cone, const Cones_through_ends& cones, const Lit_parts& parts, double error)
{
  double excess = error, sigma = cone.sigma;
  for(std::size_t i = 0; i < parts.size; ++i) {
    const Lit_part& part = parts.part[i];
    const auto least = least_difference(part.cone, cone, part.from, part.to);
    if(-least.value > excess) {
      excess = -least.value;
      sigma = (std::max)(cones.sigma(least.place, part.cone(least.place)), sigma + error);
    }
  }
  return sigma;
}

/*
 * Returns the sigma of the flattest cone that is not above a part at the ends of the part; at an end that the part
 * shares with the edge, the cone does not rise above it from there. Usually it is then not above the part in between
 * either, since two cones have at most two positions in common.
 */
inline double sigma_at_ends(const Lit_part& part, const Cones_through_ends& cones, double error)
{
  const auto& [cone, from, to] = part;
  const double at_from = cone(from), at_to = cone(to);
  double before = -Lit_parts::infinity, after = -Lit_parts::infinity;
  if(from > 0)
    before = cones.sigma(from, at_from);
  else if(at_from <= cones.at_start + error && at_from > cone.sigma)
    before = cones.sigma_at_start((from - cone.x) / (at_from - cone.sigma));
  if(to < cones.length)
    after = cones.sigma(to, at_to);
  else if(at_to <= cones.at_end + error && at_to > cone.sigma)
    after = cones.sigma_at_end((to - cone.x) / (at_to - cone.sigma));
  return (std::max)(before, after);
}

/*
 * Returns the flattest cone that has the given values at two positions, is below all parts between them, and whose
 * pseudo-source is not farther away than theirs.
 *
 * \pre the values are at most the least ones there
 */
inline Cone fitted_cone(const Place_and_value& start, const Place_and_value& end, const Lit_parts& all, double error)
{
  const double length = end.place - start.place;
  const auto moved_back = [&start](const Cone& cone) { return Cone{cone.x + start.place, cone.y, cone.sigma}; };
  const Cones_through_ends cones = {length, start.value, end.value};
  Lit_parts parts;
  double sigma = Lit_parts::infinity, least = -Lit_parts::infinity;
  for(std::size_t i = 0; i < all.size; ++i) {
    const auto& [cone, from, to] = all.part[i];
    const Cone moved = {cone.x - start.place, cone.y, cone.sigma};
    const double begin = (std::max)(from - start.place, 0.0), finish = (std::min)(to - start.place, length);
    if(!(begin < finish))
      continue;
    parts.add(moved, begin, finish);
    sigma = (std::min)(sigma, cone.sigma);
    least = (std::max)(least, sigma_at_ends({moved, begin, finish}, cones, error));
  }
  sigma = (std::max)(sigma, least);
  // Where it touches the interior of a part, it may be slightly too high nearby; sigma is increased in that case.
  for(double more = least_cone_lift; more < 1 && sigma < cones.largest_sigma(); more *= 4) {
    const Cone cone = cones(sigma);
    const double lower = sigma_below(cone, cones, parts, error);
    if(!(lower > sigma))
      return moved_back(cone);
    sigma = lower + more * (cones.largest_sigma() - lower);
  }
  return moved_back(cones(cones.largest_sigma()));
}

/* Returns one cone if it is not much below the parts where the cones that reach the two ends meet, and otherwise two
 * cones that meet there. */
inline Edge_cones fitted_cones(const Lit_parts& parts, double length, double error)
{
  Edge_cones result;
  result.first = parts.part[0].cone;
  if(parts.size == 1)
    return result;
  const auto at_start = parts.least_at(0), at_end = parts.least_at(length);
  const Place_and_value start = {0, at_start.value}, end = {length, at_end.value};
  result.first = fitted_cone(start, end, parts, error);
  const Cone &first = parts.part[at_start.part].cone, &second = parts.part[at_end.part].cone;
  const double before = second(0) - first(0), after = first(length) - second(length);
  if(!(before > 0 && after > 0))
    return result;
  double place = length * before / (before + after);
  const double there = second(place) - first(place);
  place = there > 0 ? place + (length - place) * there / (there + after) : place * before / (before - there);
  const Place_and_value middle = {place, parts.least_at(place).value};
  if(!(middle.value - result.first(place) > least_cone_sag * length))
    return result;
  return {fitted_cone(start, middle, parts, error), fitted_cone(middle, end, parts, error), place};
}

/* The result of a `Cone_sweep` at a halfedge: its cones, and the data to which they were fitted. */
struct Cone_wave
{
  Edge_cones cones;
  double at_tail = 0, at_split = 0, at_head = 0;
  double apex_distance = std::numeric_limits<double>::infinity(); // of the opposite corner, when last examined
  std::array<std::int32_t, 2> seen = {0, 0}; // examined versions of the waves across the other sides
  std::int32_t version = 0, number_of_updates = 0;
  bool is_set = false, is_waiting = false;
  bool is_borrowed = false; // from the twin halfedge, and possibly lower than necessary

  /* Returns the key in the queue. It is closer to the smaller value, since propagation across the edge continues first
   * at that end. */
  std::uint64_t key() const
  {
    const double less = (std::min)(at_tail, at_head), more = (std::max)(at_tail, at_head);
    return ordered_bits((std::max)(0.75 * less + 0.25 * more, 0.0));
  }
};

/* The state of a vertex in the propagation. */
struct Swept_vertex
{
  double distance = 0, to_goal = 0;
  bool is_reached = false, is_waiting = false, has_bound = false;
};

/* A wave to be propagated, or a vertex from which waves will start. */
struct Queued_wave
{
  std::uint64_t key;
  Index id; // of a side, or -1 minus that of a vertex

  static std::size_t is_before(const Queued_wave& a, const Queued_wave& b)
  {
    return a.key == b.key ? static_cast<std::size_t>(a.id < b.id) : static_cast<std::size_t>(a.key < b.key);
  }
};

/*
 * Everything that enters a face through a side, from the pseudo-sources of its cones, and reaches another side, which
 * lies on the x-axis from 0 on. The first side leaves 0 in some direction and ends at the apex.
 */
struct Light_through_side
{
  using Vector = std::complex<double>;

  const Edge_cones& cones;
  double side_length;
  Vector direction;
  double error;

  /* Adds it, or its mirror image, to the parts of a side of some length; returns its extent if it is one cone. */
  double add_to(Lit_parts& parts, double length, bool is_mirrored) const
  {
    const int number = cones.split < side_length ? 2 : 1;
    double end = 0;
    for(int i = 0; i < number; ++i) {
      Cone cone = seen(i == 0 ? cones.first : cones.second);
      const bool is_first = i + 1 < number;
      // No gap remains between the ranges of two cones, nor if the second one reaches nothing.
      const bool is_alone = is_first && seen(cones.second).y < -error && cone.y >= -error;
      const double lit = lit_length(cone, is_first ? cones.split : side_length, length);
      const double to = is_alone ? length : lit;
      const double from = i == 0 ? 0 : (std::min)(lit_length(cone, cones.split, length) - cone_overlap * length, end);
      cone.y = std::abs(cone.y); // a source on the wrong side of the edge reaches it only up to rounding errors
      if(is_mirrored)
        parts.add(cone.mirrored(length), length - to, length - (std::max)(from, 0.0));
      else
        parts.add(cone, (std::max)(from, 0.0), to);
      end = (std::max)(end, to);
    }
    return number == 1 ? end : 0;
  }

private:
  // A cone over the side of entrance in the frame of the side that is reached.
  Cone seen(const Cone& cone) const
  {
    const Vector place = Vector(cone.x, cone.y) * direction;
    return {place.real(), place.imag(), cone.sigma};
  }

  /*
   * The length of a side, from 0 on, that is reached from a pseudo-source past a position on the side of entrance that
   * is farther on: up to the end of the line through that position, enlarged slightly.
   */
  double lit_length(const Cone& cone, double place, double length) const
  {
    if(cone.y < -error)
      return 0;
    const Vector past = place * direction;
    const double fall = cone.y - past.imag();
    if(!(fall > 8 * error))
      return length;
    const double end = past.real() + (past.real() - cone.x) * (past.imag() / fall);
    const double enlargement = cone_enlargement + 8 * error / fall; // of the edge
    return (std::min)((std::max)(end, 0.0) + enlargement * length, length);
  }
};

/*
 * Records for the elements of a sequence, only few of which are written. Written records are contiguous, in the order
 * of their first writing, and do not move. All others share one record with its initial value.
 */
template <class Key, class Record>
class Written_records
{
public:
  explicit Written_records(std::size_t number_of_elements)
    : m_slots(number_of_elements)
  {
    m_records.push_back(Record());
  }

  const Record& operator[](Key key) const { return m_records[static_cast<std::size_t>(m_slots[key.idx()])]; }

  /* Returns the element's own record for writing. */
  Record& write(Key key)
  {
    const Index slot = m_slots[key.idx()];
    if(slot == 0) {
      m_slots.add(key.idx());
      m_records.push_back(Record());
      return m_records.back();
    }
    return m_records[static_cast<std::size_t>(slot)];
  }

private:
  Slot_table<1> m_slots;
  Block_array<Record> m_records; // by slots
};

/*
 * Lower-bound propagation: lower bounds on the distances from a vertex, within about 1%, at a small part of the cost of
 * the distances.
 *
 * Each halfedge has a cone, or two side by side: the distance function of an unfolded pseudo-source. No path from the
 * source that leaves the halfedge's face through it, at any point, is shorter than the least of three values: that of
 * the cone at the point, and the distances of the two ends plus the path from there along the edge. Such cones follow
 * from each other. A path that leaves face abc through ab has entered it through bc or ca, or comes from c. No path is
 * therefore shorter than the least value that the cones of those edges and the distance of c allow:
 *
 *               c
 *              / .               paths that enter through ca come straight from the cone's pseudo-source and reach ab
 *       P     /   .     N        up to the end of the line through c; those that enter through bc reach the other end;
 *            /     .             the paths by way of c, and those along ab, are longer, or they are considered
 *           a-------b            separately
 *
 * The cone of ab is fitted to these values, so that it is nowhere above them and meets them at a and b: if it were
 * lower there, cones around a vertex would lower each other indefinitely. If two fronts meet on an edge, it has two
 * cones. The bounds thus hold whatever the fit and whatever the order in which faces are passed; they are good at low
 * cost if faces are passed in the order of distance. A face is passed again when a cone is not low enough any more. The
 * waves of a fast marching method with virtual sources [NK02] are cones of this kind, fitted to be near the distance
 * but not below it.
 *
 * Most halfedges are passed by a front from one face to the other only. Paths that come back across the twin halfedge
 * follow from vertices behind the front and matter little: the cones of the first halfedge are low enough there and are
 * borrowed. They may be much lower than necessary and would then lower others; in that case the twin gets cones fitted
 * to the paths that come back.
 *
 * Since paths by way of all corners count, also of those at which no shortest path turns, the bounds depend on the
 * triangle inequality alone: the pseudo-source of a fitted cone may be where its rays miss the edge that they should
 * reach.
 *
 * The part of an edge reached by a cone is enlarged slightly to allow for rounding errors. A shortest path takes at
 * most one step per face, and the possible error of all steps together is subtracted from the results.
 */
template <class Triangulation>
class Cone_sweep
{
  using Faces = Unfolded_faces<Triangulation>;
  using Vector = typename Faces::Vector;
  using Wave = Cone_wave;
  using Vertex_record = Swept_vertex;
  using Entry = Queued_wave;

public:
  /* \param goal the end of the paths that matter
   * \param free_updates number of exact updates of a cone; more are expensive at needles, but keep the bounds good */
  Cone_sweep(const Triangulation& triangulation, Faces& faces, Vertex_index source,
             const Goal_bound<Triangulation>& goal, int free_updates = 6)
    : m_triangulation(triangulation)
    , m_faces(faces)
    , m_source(source)
    , m_goal(goal)
    , m_vertices(static_cast<std::size_t>(triangulation.number_of_vertices()))
    , m_free_updates(free_updates)
  {
  }

  /*
   * Propagates over everything passed by paths from the source to the goal that are not longer than `bound`. The
   * propagation is not useful if it was interrupted.
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
   */
  void run(double bound, Interruption* interruption = nullptr)
  {
    run_from(std::array<Vertex_index, 1>{{m_source}}, bound, interruption);
  }

  /* Propagates from the nearest of several vertices. */
  template <class Vertices>
  void run_from(const Vertices& sources, double bound, Interruption* interruption = nullptr)
  {
    m_bound = bound;
    m_error = cone_error * bound;
    m_total_error = 2 * static_cast<double>(m_triangulation.number_of_halfedges()) * m_error;
    for(const Vertex_index v : sources)
      reach(v, 0, 0);
    while(!m_queue.empty() && is_useful()) {
      if(is_interrupted(interruption))
        m_total_error = infinity;
      else
        pass_first();
    }
  }

  /* Returns false if the errors that had to be allowed for termination make the result worthless. */
  bool is_useful() const { return m_total_error <= largest_cone_error * m_bound; }

  Vertex_index source() const { return m_source; }
  double bound() const { return m_bound; }

  /* Returns a lower bound on the lengths of the relevant paths from the source to v. */
  double distance_lower_bound(Vertex_index v) const
  {
    if(!is_useful())
      return in_space(v);
    return m_vertices[v].is_reached ? m_vertices[v].distance - m_total_error : infinity;
  }

  /*
   * Returns a lower bound on the lengths of paths that end at the source and come as a cone predicts across the edge of
   * h, between two points on it, into the face on the left of h.
   */
  double through(Input_halfedge_index h, double length, const Cone& cone, double from, double to) const
  {
    const Vertex_index a = m_triangulation.input().tail(h), b = m_triangulation.input().tail(twin_index(h));
    if(is_useful()) {
      const Wave* wave = known_wave(m_faces.known_number(h));
      const double across = wave == nullptr ? infinity : wave->cones.least_sum(cone, from, to) - m_total_error;
      const double along =
          (std::min)(cone(from) + from + distance_lower_bound(a), cone(to) + (length - to) + distance_lower_bound(b));
      return (std::min)(across, along);
    }
    const double tail = cone(to) - to + in_space(a); // since the slope of a cone is at most 1
    const double head = cone(from) - (length - from) + in_space(b);
    return (std::max)({cone.least(from, to), tail, head});
  }

  /* Returns the cones over the edge of h of paths that leave the face on the left of h; their values are too high by at
   * most `total_error()`. Returns null if no such path matters. \pre is_useful() */
  const Edge_cones* cones(Input_halfedge_index h) const
  {
    const Wave* const wave = known_wave(m_faces.known_number(h));
    return wave == nullptr ? nullptr : &wave->cones;
  }
  double total_error() const { return m_total_error; }

  /* Returns the cost of the propagation: the number of times that a halfedge was examined. */
  std::size_t number_of_updates() const { return m_updates; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // On average. More cost as much as windows, and end a useless propagation; six free updates cannot cause that many.
  static constexpr std::size_t most_updates_per_side = 26;

  // The way in which paths come to a side of a face: across the previous side, across the next side, or by way of the
  // apex.
  enum class Entrance : char { BEFORE, AFTER, APEX };

  double in_space(Vertex_index v) const
  {
    const auto& metric = m_triangulation.metric();
    const auto& input = m_triangulation.input();
    return metric.distance_lower_bound(metric.place(input, v), metric.place(input, m_source));
  }

  void pass_first()
  {
    const Entry entry = m_queue.top();
    m_queue.pop();
    if(entry.id < 0)
      leave_vertex(Vertex_index(-1 - entry.id));
    else if(Wave& wave = m_waves[static_cast<std::size_t>(entry.id)]; wave.is_waiting && wave.key() == entry.key) {
      wave.is_waiting = false;
      enter_face(entry.id);
    }
  }

  // Propagates the wave of a side into the face on the other side of the edge.
  void enter_face(Index left_side)
  {
    Index side = m_faces.known_twin(left_side);
    if(side < 0) {
      const Input_halfedge_index h = twin_index(m_faces[left_side].halfedge);
      if(m_triangulation.input().is_border(h))
        return;
      side = m_faces.number(h);
    }
    const Index next = Faces::next(side), previous = Faces::previous(side);
    if(known_wave(left_side)->is_borrowed &&
       !(is_unmoved(next, Entrance::BEFORE) && is_unmoved(previous, Entrance::AFTER)))
      return fit(left_side);
    update(next, Entrance::BEFORE);
    update(previous, Entrance::AFTER);
  }

  // Returns whether the cone of a side, if there is one, is unaffected by everything that comes by an entrance.
  bool is_unmoved(Index side, Entrance entrance) { return known_wave(side) == nullptr || holds(side, entrance); }

  // Propagates to all edges opposite to a vertex and to its neighbors.
  void leave_vertex(Vertex_index v)
  {
    Vertex_record& record = m_vertices.write(v);
    if(!record.is_waiting)
      return;
    record.is_waiting = false;
    const auto& input = m_triangulation.input();
    const double distance = record.distance;
    for_each_outgoing_halfedge(input, v, [&](Input_halfedge_index h) {
      const Input_halfedge_index t = twin_index(h);
      const bool is_border = input.is_border(h);
      const Index side = m_faces.number(is_border ? t : h);
      reach(input.tail(t), distance + m_faces[side].length, m_faces[side].length);
      if(!is_border && !has_noticed(Faces::next(side), distance))
        update(Faces::next(side), Entrance::APEX);
    });
  }

  double to_goal(Vertex_record& record, Vertex_index v)
  {
    if(!record.has_bound) {
      record.to_goal = m_goal(v);
      record.has_bound = true;
    }
    return record.to_goal;
  }

  // Records a path to v. The vertex is left slightly later, once it has been passed, so that less work is done twice.
  Vertex_record& reach(Vertex_index v, double distance, double delay)
  {
    Vertex_record& record = m_vertices.write(v);
    if(record.is_reached && record.distance <= distance)
      return record;
    record.distance = distance;
    record.is_reached = true;
    if(distance + to_goal(record, v) > m_bound + m_total_error)
      return record;
    record.is_waiting = true;
    m_queue.push({ordered_bits((std::max)(distance + delay, 0.0)), -1 - v.idx()});
    return record;
  }

  // Returns the wave of a side, if there is one.
  const Wave* known_wave(Index side) const
  {
    const auto i = static_cast<std::size_t>(side);
    return side < 0 || i >= m_waves.size() || !m_waves[i].is_set ? nullptr : &m_waves[i];
  }

  // Returns whether the cone of a side takes the distance of the corner opposite to it into account.
  bool has_noticed(Index side, double distance) const
  {
    const Wave* wave = known_wave(side);
    return wave != nullptr && wave->apex_distance <= distance;
  }

  // Updates the cone of a side so that it is valid for everything that enters its face, part of which has changed.
  void update(Index side, Entrance changed)
  {
    if(m_waves.size() < m_faces.size())
      m_waves.resize(m_faces.size(), Wave());
    if(m_waves[static_cast<std::size_t>(side)].is_set ? !holds(side, changed) : !borrow(side))
      fit(side);
  }

  /*
   * Takes over the cones of the twin halfedge if they are valid: a front has passed the edge in the other direction,
   * and the paths that come back behind it matter too little for cones of their own.
   */
  bool borrow(Index side)
  {
    const Wave* const lender = known_wave(m_faces.known_twin(side));
    if(lender == nullptr || lender->is_borrowed)
      return false;
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    wave.cones = lender->cones.mirrored(m_faces[side].length);
    wave.at_tail = lender->at_head;
    wave.at_split = lender->at_split;
    wave.at_head = lender->at_tail;
    wave.seen = {0, 0};
    wave.is_set = true;
    if(holds(side, Entrance::BEFORE) && holds(side, Entrance::AFTER) && holds(side, Entrance::APEX)) {
      wave.is_borrowed = true;
      send(side);
    } else
      wave.is_set = false;
    return wave.is_set;
  }

  // Returns whether the cone of a side is low enough for everything that comes by one entrance.
  bool holds(Index side, Entrance entrance)
  {
    return entrance == Entrance::APEX ? holds_for_apex(side) : holds_for_side(side, entrance);
  }

  bool holds_for_apex(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    wave.apex_distance = distance_of_apex(side);
    if((std::max)({wave.at_tail, wave.at_split, wave.at_head}) <= wave.apex_distance + m_faces.apex(side).imag())
      return true;
    const double length = m_faces[side].length;
    Lit_parts parts;
    add_apex(parts, side, 0, length);
    return wave.cones.are_below(parts, length, tolerance(wave));
  }

  bool holds_for_side(Index side, Entrance entrance)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    const Wave* const other = entering(side, entrance);
    std::int32_t& seen = wave.seen[entrance == Entrance::AFTER ? 1 : 0];
    if(other == nullptr || seen == other->version)
      return true;
    if(!clearly_holds(side, *other, entrance)) {
      Lit_parts parts;
      light_from(parts, side, entrance);
      if(!wave.cones.are_below(parts, m_faces[side].length, tolerance(wave)))
        return false;
    }
    seen = other->version;
    return true;
  }

  // The wave that comes across the side before or after a side, if any.
  const Wave* entering(Index side, Entrance entrance) const
  {
    const Wave* const wave =
        known_wave(m_faces.known_twin(entrance == Entrance::AFTER ? Faces::next(side) : Faces::previous(side)));
    // A borrowed wave must wait until it is known to be harmless.
    return wave == nullptr || (wave->is_borrowed && wave->is_waiting) ? nullptr : wave;
  }

  /*
   * A quick sufficient test that the cones of a side are low enough for everything that comes across the side before or
   * after it: their chords are not above the tangent of the incoming cone at the common corner.
   */
  bool clearly_holds(Index side, const Wave& other, Entrance entrance) const
  {
    const bool is_mirrored = entrance == Entrance::AFTER;
    const auto& edge = m_faces[is_mirrored ? Faces::next(side) : Faces::previous(side)];
    if(other.cones.split < edge.length)
      return false;
    const Wave& wave = *known_wave(side);
    const double length = m_faces[side].length;
    const double here = is_mirrored ? wave.at_head : wave.at_tail, there = is_mirrored ? wave.at_tail : wave.at_head;
    const double start = is_mirrored ? other.at_head : other.at_tail;
    if(here > start + m_error)
      return false;
    const Cone& cone = other.cones.first;
    const auto& corner = m_faces[is_mirrored ? Faces::next(side) : side];
    const double run = start - cone.sigma; // from the pseudo-source to the corner
    const double slope = corner.sine * cone.y - corner.cosine * (is_mirrored ? edge.length - cone.x : cone.x) - m_error;
    const bool is_split = wave.cones.split < length;
    const double to_split = is_mirrored ? length - wave.cones.split : wave.cones.split;
    return (there - start) * run <= length * slope && (!is_split || (wave.at_split - start) * run <= to_split * slope);
  }

  // Fits the cone of a side to everything that enters its face.
  void fit(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    const Lit_parts parts = lit_parts(side);
    wave.apex_distance = distance_of_apex(side);
    if(parts.size == 0) {
      wave.is_set = false; // nothing enters its face yet
      return;
    }
    const double length = m_faces[side].length;
    ++m_updates;
    ++wave.number_of_updates;
    if(wave.number_of_updates > m_free_updates)
      m_total_error += tolerance(wave);
    if(m_updates > most_updates_per_side * m_faces.size()) // not useful any more
      m_total_error = infinity;
    wave.cones = fitted_cones(parts, length, m_error);
    wave.is_set = true;
    wave.is_borrowed = false;
    wave.at_tail = wave.cones.first(0);
    wave.at_head = wave.cones.last(length)(length);
    wave.at_split = wave.cones.split < length ? wave.cones.first(wave.cones.split) : wave.at_tail;
    for(const Entrance entrance : {Entrance::BEFORE, Entrance::AFTER}) {
      const Wave* const other = entering(side, entrance);
      wave.seen[entrance == Entrance::AFTER ? 1 : 0] = other == nullptr ? 0 : other->version;
    }
    send(side);
  }

  // Passes the values of a side's cone to its ends, and queues the cone for propagation if it matters.
  void send(Index side)
  {
    Wave& wave = m_waves[static_cast<std::size_t>(side)];
    ++wave.version;
    const double length = m_faces[side].length;
    const Vertex_index tail = m_faces[side].tail, head = m_faces[Faces::next(side)].tail;
    const double from_tail = to_goal(reach(tail, wave.at_tail, length), tail);
    const double from_head = to_goal(reach(head, wave.at_head, length), head);
    // The slope of a cone is at most 1.
    wave.is_waiting =
        (std::max)(wave.at_head + from_tail, wave.at_tail + from_head) - length <= m_bound + m_total_error;
    if(wave.is_waiting)
      m_queue.push({wave.key(), side});
  }

  /*
   * The amount by which a cone may be too high. Cones around a vertex with a small angle, and at needle-shaped faces,
   * lower each other repeatedly; each time the tolerance grows, so they terminate.
   */
  double tolerance(const Wave& wave) const
  {
    const int further = wave.number_of_updates - m_free_updates;
    return further <= 0 ? m_error : std::ldexp(m_error, 2 * further);
  }

  // Everything that comes by all entrances, in the frame of a side that extends from 0 to its length on the x-axis with
  // its face above.
  Lit_parts lit_parts(Index side) const
  {
    const double length = m_faces[side].length;
    Lit_parts parts;
    const Lit_end before = light_from(parts, side, Entrance::BEFORE), after = light_from(parts, side, Entrance::AFTER);
    // If one cone reaches the edge, the paths by way of the apex are not shorter if the cone's value at the apex is not
    // larger.
    const double enough = distance_of_apex(side) + m_error;
    add_apex(parts, side, before.apex_value <= enough ? before.place : 0,
             after.apex_value <= enough ? length - after.place : length);
    return parts;
  }

  // The extent to which one cone reaches an edge from an end on, and its value at the apex.
  struct Lit_end
  {
    double place = 0, apex_value = infinity;
  };

  // Adds everything that comes across the side before or after a side.
  Lit_end light_from(Lit_parts& parts, Index number, Entrance entrance) const
  {
    const Index next_number = Faces::next(number), previous_number = Faces::previous(number);
    const bool is_mirrored = entrance == Entrance::AFTER; // mirrored, as seen from the head
    const auto &close_by = m_faces[is_mirrored ? next_number : number], &side = m_faces[number];
    const double length = m_faces[is_mirrored ? next_number : previous_number].length;
    const Wave* const wave = entering(number, entrance);
    if(wave == nullptr)
      return {};
    const Edge_cones cones = is_mirrored ? wave->cones.mirrored(length) : wave->cones;
    Lit_end end;
    end.apex_value = cones.last(length)(length);
    const Light_through_side light = {cones, length, Vector(close_by.cosine, close_by.sine), m_error};
    end.place = light.add_to(parts, side.length, is_mirrored);
    return end;
  }

  // The distance of the corner opposite to a side; waves pass their values to their ends, so that it is not above
  // these.
  double distance_of_apex(Index side) const
  {
    const Vertex_record& record = m_vertices[m_faces[Faces::previous(side)].tail];
    return record.is_reached ? record.distance : infinity;
  }

  // Adds the paths by way of the apex to a part of a side.
  void add_apex(Lit_parts& parts, Index side, double from, double to) const
  {
    const double distance = distance_of_apex(side);
    if(!(distance < infinity))
      return;
    const Vector apex = m_faces.apex(side);
    parts.add({apex.real(), std::abs(apex.imag()), distance}, from, to);
  }

  const Triangulation& m_triangulation;
  Faces& m_faces;
  Vertex_index m_source;
  Goal_bound<Triangulation> m_goal;
  Block_array<Wave> m_waves; // of sides, that is, of halfedges whose faces have been computed
  Written_records<Vertex_index, Vertex_record> m_vertices;
  int m_free_updates;
  Heap_of_four<Entry> m_queue;
  double m_bound = infinity, m_error = 0, m_total_error = 0;
  std::size_t m_updates = 0;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_SWEEP_H
