// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_CONES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_CONES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Distances along an edge, which is the x-axis from 0 on: those from a pseudo-source in the plane of a face, plus the
 * length `sigma` up to that source. As a function of the position on the edge it is convex with slopes of at most 1.
 */
struct Cone
{
  double x, y; // y >= 0
  double sigma;

  double operator()(double q) const { return sigma + std::sqrt((q - x) * (q - x) + y * y); }

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

/* The least value of `a - b` between two positions: at an end, or where both have the same slope. */
struct Least_difference
{
  double place, value;
};

inline Least_difference least_difference(const Cone& a, const Cone& b, double from, double to)
{
  Least_difference least = {from, a(from) - b(from)};
  if(const double value = a(to) - b(to); value < least.value)
    least = {to, value};
  const double q = (a.x * b.y - b.x * a.y) / (b.y - a.y);
  if(q > from && q < to)
    if(const double value = a(q) - b(q); least.value > value)
      least = {q, value};
  return least;
}

/* The cones with given values at the two ends of an edge; the larger sigma is, the lower they are in between. */
class Cones_through_ends
{
public:
  Cones_through_ends(double length, double at_start, double at_end)
    : m_length(length)
    , m_start(at_start)
    , m_end(at_end)
  {
  }

  double length() const { return m_length; }
  double at_start() const { return m_start; }
  double at_end() const { return m_end; }

  /* Returns the sigma of the lowest cone, which falls and rises with slope 1. */
  double largest_sigma() const { return 0.5 * (m_start + m_end - m_length); }

  /* Returns the sigma of the cone with a third value in between; minus infinity if no cone is that high. */
  double sigma(double place, double value) const
  {
    const double t = place / m_length, sag = (1 - t) * m_start + t * m_end - value;
    if(!(sag > cone_sag_rounding * m_length))
      return -std::numeric_limits<double>::infinity();
    // Stewart's theorem for the distances from the pseudo-source to the three positions; avoids the cancellation of
    // squares.
    const double a = m_start - value, b = m_end - value;
    return value + ((1 - t) * a * a + t * b * b - place * (m_length - place)) / (2 * sag);
  }

  /* Returns the sigma of the flattest cone with at most this slope at the first end; minus infinity if all cones
   * satisfy this. */
  double sigma_at_start(double slope) const { return m_start + sigma_from_end(slope * m_length + m_start - m_end); }

  /* Returns the sigma of the flattest cone with at least this slope at the second end; minus infinity if all cones
   * satisfy this. */
  double sigma_at_end(double slope) const { return m_end + sigma_from_end(m_end - m_start - slope * m_length); }

  Cone operator()(double sigma) const
  {
    const double a = m_start - sigma, b = m_end - sigma;
    const double x = 0.5 * (m_length + (a - b) * ((a + b) / m_length));
    return {x, std::sqrt((std::max)((a - x) * (a + x), 0.0)), sigma};
  }

private:
  // Minus the distance from the first end to the pseudo-source. The slope there, times the length, equals the rise of
  // the values from that end minus `(length^2 - rise^2) / (2 distance)`; `steepness` is its bound minus the rise.
  double sigma_from_end(double steepness) const
  {
    const double rise = m_end - m_start;
    return steepness < 0 ? 0.5 * (std::max)((m_length - rise) * (m_length + rise), 0.0) / steepness
                         : -std::numeric_limits<double>::infinity();
  }

  double m_length, m_start, m_end;
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
    const auto reversed = [length](const Cone& cone) { return Cone{length - cone.x, cone.y, cone.sigma}; };
    if(split < length)
      return {reversed(second), reversed(first), length - split};
    return {reversed(first), second, split};
  }
};

/* A position on an edge, and the value of a cone there. */
struct Place_and_value
{
  double place, value;
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
  else if(at_from <= cones.at_start() + error && at_from > cone.sigma)
    before = cones.sigma_at_start((from - cone.x) / (at_from - cone.sigma));
  if(to < cones.length())
    after = cones.sigma(to, at_to);
  else if(at_to <= cones.at_end() + error && at_to > cone.sigma)
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
  const Cones_through_ends cones(length, start.value, end.value);
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
class Light_through_side
{
  using Vector = std::complex<double>;

public:
  Light_through_side(const Edge_cones& cones, double side_length, const Vector& direction, double error)
    : m_cones(cones)
    , m_side_length(side_length)
    , m_direction(direction)
    , m_error(error)
  {
  }

  /* Adds it, or its mirror image, to the parts of a side of some length; returns its extent if it is one cone. */
  double add_to(Lit_parts& parts, double length, bool is_mirrored) const
  {
    const int number = m_cones.split < m_side_length ? 2 : 1;
    double end = 0;
    for(int i = 0; i < number; ++i) {
      Cone cone = seen(i == 0 ? m_cones.first : m_cones.second);
      const bool is_first = i + 1 < number;
      // No gap remains between the ranges of two cones, nor if the second one reaches nothing.
      const bool is_alone = is_first && seen(m_cones.second).y < -m_error && cone.y >= -m_error;
      const double lit = lit_length(cone, is_first ? m_cones.split : m_side_length, length);
      const double to = is_alone ? length : lit;
      const double from = i == 0 ? 0 : (std::min)(lit_length(cone, m_cones.split, length) - cone_overlap * length, end);
      cone.y = std::abs(cone.y); // a source on the wrong side of the edge reaches it only up to rounding errors
      const Cone turned = is_mirrored ? Cone{length - cone.x, cone.y, cone.sigma} : cone;
      if(is_mirrored)
        parts.add(turned, length - to, length - (std::max)(from, 0.0));
      else
        parts.add(turned, (std::max)(from, 0.0), to);
      end = (std::max)(end, to);
    }
    return number == 1 ? end : 0;
  }

private:
  // A cone over the side of entrance in the frame of the side that is reached.
  Cone seen(const Cone& cone) const
  {
    const Vector place = Vector(cone.x, cone.y) * m_direction;
    return {place.real(), place.imag(), cone.sigma};
  }

  /*
   * The length of a side, from 0 on, that is reached from a pseudo-source past a position on the side of entrance that
   * is farther on: up to the end of the line through that position, enlarged slightly.
   */
  double lit_length(const Cone& cone, double place, double length) const
  {
    if(cone.y < -m_error)
      return 0;
    const Vector past = place * m_direction;
    const double fall = cone.y - past.imag();
    if(!(fall > 8 * m_error))
      return length;
    const double end = past.real() + (past.real() - cone.x) * (past.imag() / fall);
    const double enlargement = cone_enlargement + 8 * m_error / fall; // of the edge
    return (std::min)((std::max)(end, 0.0) + enlargement * length, length);
  }

  const Edge_cones& m_cones;
  double m_side_length;
  Vector m_direction;
  double m_error;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_CONES_H
