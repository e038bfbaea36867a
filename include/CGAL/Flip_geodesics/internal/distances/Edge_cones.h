// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_CONES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_CONES_H

#include <CGAL/Flip_geodesics/internal/distances/Cone.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A part of an edge, and what lights it. */
struct Lit_part
{
  Cone cone;
  double from, to;
};

/* All that lights an edge: through two other sides two cones each, and by way of the apex. */
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

  /* The least value at a place, also of what lights another part of the edge, and goes on along it; and which part. */
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

/* A cone over an edge, or two: one for the places up to the split, another for those beyond it, where two fronts meet. */
struct Edge_cones
{
  Cone first = {0, 0, 0}, second = {0, 0, 0};
  double split = std::numeric_limits<double>::infinity();

  /* That over the end of an edge of some length. */
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

  /* Are they nowhere above what lights the edge, but for a tolerance? */
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

  /* The same from the other end of an edge of some length. */
  Edge_cones mirrored(double length) const
  {
    const auto reversed = [length](const Cone& cone) { return Cone{length - cone.x, cone.y, cone.sigma}; };
    if(split < length)
      return {reversed(second), reversed(first), length - split};
    return {reversed(first), second, split};
  }
};

/* A place on an edge, and the value of a cone there. */
struct Place_and_value
{
  double place, value;
};

/* The sigma of a cone that is not above the parts where this one is highest above them; its own, if it is nowhere. */
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
 * The sigma of the flattest cone that is not above a part at the ends of the part; at an end that the part shares with
 * the edge, the cone does not rise over it from there. Mostly it is not above the part in between then, since two cones
 * have two places in common at most.
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
 * The flattest cone that has the given values at two places, is below all parts between them, and whose point is no
 * farther away than theirs.
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
  // Where it touches a part in the middle, it may be a little too high beside that place: a little more, then.
  for(double more = least_cone_lift; more < 1 && sigma < cones.largest_sigma(); more *= 4) {
    const Cone cone = cones(sigma);
    const double lower = sigma_below(cone, cones, parts, error);
    if(!(lower > sigma))
      return moved_back(cone);
    sigma = lower + more * (cones.largest_sigma() - lower);
  }
  return moved_back(cones(cones.largest_sigma()));
}

/* One cone, if it is not much below the parts where what lights the two ends meets; otherwise two that meet there. */
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_EDGE_CONES_H
