// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H

#include <CGAL/Flip_geodesics/internal/distances/Curve_thinner.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The isolines of several levels on one refined surface. A corner is inside if its distance is less than the level, so
 * that one whose distance is the level itself is no special case. On each side the crossings of larger levels come
 * after those of smaller ones, and so isolines do not cross.
 */
template <class Surface>
class Isoline_tracer
{
public:
  /* The levels are sorted; of equal ones the first is to be traced. */
  Isoline_tracer(Surface& surface, const std::vector<double>& levels, double tolerance)
    : m_surface(surface)
    , m_levels(levels)
    , m_tolerance(tolerance)
    , m_crossings(levels.size())
  {
    const double largest_side = side_by_tolerance * tolerance;
    surface.refine([&](const auto& piece) {
      if(surface.length(surface.longest(piece)) <= largest_side)
        return true;
      const Field_bounds bounds(surface, piece);
      const auto level = std::lower_bound(m_levels.begin(), m_levels.end(), bounds.least);
      return level == m_levels.end() || *level > bounds.largest;
    });
    for(Index half = 0; half < surface.number_of_halves(); half += 2)
      if(!surface.is_border(half) || !surface.is_border(half + 1))
        find_crossings(surface.telling_half(half));
  }

  /* Calls `write(curve)` for the curves of a level: first those that end on the border. */
  template <class Write>
  void trace(std::size_t level, const Write& write)
  {
    std::vector<Followed_curve> curves = followed(level);
    Curve_thinner<Surface>(m_surface, m_tolerance, radius(level)).thin(curves);
    for(const Followed_curve& curve : curves)
      write(curve);
  }

private:
  // How far what chords replace may be from them. The field on a chord differs by as much at most from its level, so
  // that chords of two levels do not meet within half of their difference.
  double radius(std::size_t level) const
  {
    const double at = m_levels[level];
    const auto [first, last] = std::equal_range(m_levels.begin(), m_levels.end(), at);
    double result = m_tolerance;
    if(first != m_levels.begin())
      result = (std::min)(result, (at - first[-1]) / 2);
    return last == m_levels.end() ? result : (std::min)(result, (*last - at) / 2);
  }

  std::vector<Followed_curve> followed(std::size_t level)
  {
    std::vector<Followed_curve> curves;
    Crossings& crossings = m_crossings[level];
    crossings.forget_visits(); // a level may be asked for again
    const auto is_inside = [&](const Sample& sample) { return sample.distance < m_levels[level]; };
    const auto is_end = [](const auto&) { return false; };
    for(bool is_from_border : {true, false})
      for(const Crossing& crossing : crossings) {
        const Index half = entering_half(m_surface, crossing.side, is_inside);
        if(crossing.is_visited || half == null_index || (is_from_border && !m_surface.is_border(Surface::twin(half))))
          continue;
        Followed_curve curve = follow(m_surface, half, crossings, is_inside, is_end);
        if(curve.samples.size() > 1) // else a point
          curves.push_back(std::move(curve));
      }
    return curves;
  }

  void find_crossings(Index half)
  {
    const Sample &tail = m_surface.sample(m_surface.tail(half)), &head = m_surface.sample(m_surface.head(half));
    const bool is_rising = tail.distance < head.distance;
    const Sample &lower = is_rising ? tail : head, &upper = is_rising ? head : tail;
    auto level = std::upper_bound(m_levels.begin(), m_levels.end(), lower.distance);
    double from = 0;
    Sample last = lower;
    for(; level != m_levels.end() && *level <= upper.distance; ++level) {
      if(last.distance < *level) { // else two levels are as close as roundings
        from = root(half, is_rising, *level, from, last, upper);
        last = from == 1 ? upper : m_surface.sampled(half, is_rising ? from : 1 - from);
      }
      m_crossings[static_cast<std::size_t>(level - m_levels.begin())].push_back(half / 2, last);
    }
  }

  // The part of the way from the lower end to the upper at which the level is reached first, where it is for a while.
  double root(Index half, bool is_rising, double level, double from, const Sample& last, const Sample& upper) const
  {
    const double length = m_surface.length(half);
    const double precision = root_precision * (std::max)(std::abs(level), length) / length;
    // The level itself lies on the farther side, by so much that the next step finds the other side within the
    // precision. Infinity is no number to compute with.
    const double step = precision * length / 2;
    const auto excess = [&](double distance) {
      return distance < level ? distance - level : (std::min)(distance - level + step, 2 * length + step);
    };
    std::uintmax_t most_steps = 200;
    const auto bracket = boost::math::tools::toms748_solve(
        [&](double s) { return excess(m_surface.sampled(half, is_rising ? s : 1 - s).distance); }, from, 1.0,
        excess(last.distance), excess(upper.distance), [&](double a, double b) { return b - a <= precision; },
        most_steps);
    return bracket.second;
  }

  const Surface& m_surface;
  const std::vector<double>& m_levels;
  double m_tolerance;
  std::vector<Crossings> m_crossings; // by level
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H
