// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H

#include <CGAL/Flip_geodesics/internal/distances/Curve_thinner.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The isolines of several levels on one refined surface. A corner is inside if its distance is less than the level, so
 * that a distance equal to the level is not a special case. On each side the crossings of larger levels come after
 * those of smaller ones, and isolines therefore do not cross.
 */
template <class Surface>
class Isoline_tracer
{
public:
  /* The levels must be sorted; only the first of equal ones may be traced. */
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

  /* Calls `write(curve)` for the curves of a level; those that end on the border come first. */
  template <class Write>
  void trace(std::size_t level, const Write& write)
  {
    std::vector<Followed_curve> curves = followed(level);
    Curve_thinner<Surface>(m_surface, m_tolerance, radius(level)).thin(curves);
    for(const Followed_curve& curve : curves)
      write(curve);
  }

private:
  // The distance of replaced vertices from their chord is at most this radius. The field on a chord differs from its
  // level by at most as much, so that chords of two levels do not meet within half of their difference.
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
    crossings.forget_visits(); // a level may be traced again
    const auto is_inside = [&](const Sample& sample) { return sample.distance < m_levels[level]; };
    const auto is_end = [](const auto&) { return false; };
    for(bool is_from_border : {true, false})
      for(const Crossing& crossing : crossings) {
        const Index half = entering_half(m_surface, crossing.side, is_inside);
        if(crossing.is_visited || half == null_index || (is_from_border && !m_surface.is_border(Surface::twin(half))))
          continue;
        Followed_curve curve = follow(m_surface, half, crossings, is_inside, is_end);
        if(curve.samples.size() > 1) // otherwise a point
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
      if(last.distance < *level) { // otherwise two levels differ by rounding errors only
        from = root(half, is_rising, *level, from, last, upper);
        last = from == 1 ? upper : m_surface.sampled(half, is_rising ? from : 1 - from);
      }
      m_crossings[static_cast<std::size_t>(level - m_levels.begin())].push_back(half / 2, last);
    }
  }

  // The fraction of the path from the lower end to the upper one at which the level is first reached, even if it stays
  // there.
  double root(Index half, bool is_rising, double level, double from, const Sample& last, const Sample& upper) const
  {
    const double length = m_surface.length(half);
    const double precision = root_precision * (std::max)(std::abs(level), length) / length;
    // The level itself belongs to the farther side. The step makes the next evaluation find the other side within the
    // precision; infinity cannot be used in computations.
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

/*
 * The boundaries of Voronoi regions on a refined surface. A piece whose corners have three sources has a junction.
 *
 * For some fields, faces in which one source is nearest everywhere are known, and these are not divided. Otherwise a
 * field provides the nearest source, but not the distance of the next one, so that no bound excludes a boundary in a
 * piece whose corners have one source. Pieces therefore have sides of at most sqrt(tolerance * size), and a boundary
 * that bends no more than a circle of an eighth of the size leaves such a piece by less than the tolerance, through one
 * side and back.
 */
template <class Surface>
class Voronoi_tracer
{
public:
  Voronoi_tracer(Surface& surface, double tolerance)
    : m_surface(surface)
    , m_tolerance(tolerance)
  {
    const double largest_side = side_by_tolerance * tolerance, largest_junction = junction_by_tolerance * tolerance,
                 largest_distance = std::sqrt(tolerance * std::sqrt(surface.area()));
    std::vector<char> has_one_source;
    for(Index face = 0; face < surface.number_of_faces(); ++face)
      has_one_source.push_back(surface.has_one_source(face) ? 1 : 0);
    surface.refine([&](const auto& piece) {
      const double length = surface.length(surface.longest(piece));
      if(length <= largest_side)
        return length <= largest_junction || !is_junction(piece);
      if(is_divided(piece))
        return false;
      if(has_one_source[piece.face] != 0)
        return true;
      const Field_bounds bounds(surface, piece);
      return (length <= largest_distance || std::isinf(bounds.least)) &&
             !(bounds.least <= 0 && 0 <= bounds.largest); // a source may be inside
    });
    find_crossings();
    find_junctions();
  }

  /* Calls `write(curve, {left source, right source}, {first junction, last junction})`. */
  template <class Write>
  void trace(const Write& write)
  {
    follow_boundaries();
    Curve_thinner<Surface>(m_surface, m_tolerance, m_tolerance).thin(m_curves);
    for(std::size_t i = 0; i < m_curves.size(); ++i)
      write(m_curves[i], m_ends[i].sources, m_ends[i].junctions);
  }

private:
  using Piece = typename Surface::Piece;

  void follow_boundaries()
  {
    for(std::size_t j = 0; j < m_junctions.size(); ++j)
      for(Index half : m_surface.piece(m_junctions[j].piece).halves)
        if(!m_crossings[half / 2].is_visited)
          trace_from(Surface::twin(half), m_surface.sample(m_surface.head(half)).source,
                     m_surface.sample(m_surface.tail(half)).source, j);
    for(bool is_from_border : {true, false})
      for(const Crossing& crossing : m_crossings) {
        const Index half = m_surface.telling_half(2 * crossing.side);
        if(!crossing.is_visited && (!is_from_border || m_surface.is_border(Surface::twin(half))))
          trace_from(half, m_surface.sample(m_surface.tail(half)).source, m_surface.sample(m_surface.head(half)).source,
                     no_source);
      }
  }

  // Pieces with three sources have sides of at most this length, in units of the tolerance.
  static constexpr double junction_by_tolerance = 0.01;

  struct Junction
  {
    Index piece;
    Sample sample;
  };

  struct Ends
  {
    std::array<std::size_t, 2> sources, junctions; // left and right; first and last
  };

  bool is_divided(const Piece& piece) const
  {
    const std::size_t source = m_surface.corner(piece, 0).source;
    return m_surface.corner(piece, 1).source != source || m_surface.corner(piece, 2).source != source;
  }

  bool is_junction(const Piece& piece) const
  {
    const std::size_t a = m_surface.corner(piece, 0).source, b = m_surface.corner(piece, 1).source,
                      c = m_surface.corner(piece, 2).source;
    return a != b && b != c && c != a;
  }

  void find_crossings()
  {
    for(Index half = 0; half < m_surface.number_of_halves(); half += 2) {
      if(m_surface.is_border(half) && m_surface.is_border(half + 1))
        continue;
      const Index h = m_surface.telling_half(half);
      const Sample &tail = m_surface.sample(m_surface.tail(h)), &head = m_surface.sample(m_surface.head(h));
      if(tail.source != head.source)
        m_crossings.push_back(half / 2, change(h, tail, head));
    }
  }

  // The nearest known point on one side of a change of sources, and the rate at which the distance changes from there.
  struct Approach
  {
    double t, distance, slope;

    void come_to(double other, double d)
    {
      slope = (d - distance) / (other - t);
      t = other;
      distance = d;
    }
    double at(double other) const { return distance + slope * (other - t); }
  };

  // The position at which two linearly extrapolated distances are equal; NaN if a rate is unknown.
  static double guess(const Approach& from, const Approach& to)
  {
    return from.t + (to.at(from.t) - from.distance) / (from.slope - to.slope);
  }

  // The point at which the source at the tail of a half ceases to be the nearest. Two guesses slightly before and
  // beyond the position of apparently equal distances enclose it if they are good; otherwise the midpoint halves the
  // interval.
  Sample change(Index half, const Sample& tail, const Sample& head) const
  {
    const double unknown = std::numeric_limits<double>::quiet_NaN(), length = m_surface.length(half),
                 scale = (std::max)(length, (std::min)(tail.distance, head.distance));
    const double precision = root_precision * scale / length;
    Approach from = {0, tail.distance, unknown}, to = {1, head.distance, unknown};
    const auto ask = [&](double t) {
      if(!(from.t < t && t < to.t))
        return;
      const Sample sample = m_surface.sampled(half, t);
      (sample.source == tail.source ? from : to).come_to(t, sample.distance);
    };
    for(double last = 0.5; length > 0 && to.t - from.t > precision;) {
      const double width = to.t - from.t, t = guess(from, to),
                   margin = (std::max)(precision / 4, (std::min)(width / 8, std::abs(t - last)));
      ask(t - margin);
      ask(t + margin);
      if(!(to.t - from.t <= width / 2))
        ask(from.t + (to.t - from.t) / 2);
      last = t;
    }
    return from.t == 0 ? tail : (to.t == 1 ? head : m_surface.sampled(half, to.t));
  }

  Sample center(const Piece& piece) const
  {
    const std::array<Weights_in_face, 3>& w = piece.weights;
    return m_surface.sampled(piece.face, between(between(w[0], w[1], 0.5), w[2], 1.0 / 3));
  }

  void find_junctions()
  {
    for(Index p = 0; p < m_surface.number_of_pieces(); ++p)
      if(is_junction(m_surface.piece(p))) {
        m_junction_of_piece[p] = m_junctions.size();
        m_junctions.push_back({p, center(m_surface.piece(p))});
      }
  }

  void trace_from(Index half, std::size_t left, std::size_t right, std::size_t first_junction)
  {
    const auto is_inside = [&](const Sample& sample) { return sample.source == left; };
    const auto is_end = [&](const Piece& piece) { return is_junction(piece); };
    Followed_curve curve = follow(m_surface, half, m_crossings, is_inside, is_end);
    std::size_t last_junction = no_source;
    if(first_junction != no_source) {
      const Junction& junction = m_junctions[first_junction];
      curve.samples.insert(curve.samples.begin(), junction.sample);
      curve.faces.insert(curve.faces.begin(), m_surface.piece(junction.piece).face);
    }
    if(curve.last_piece != null_index) {
      last_junction = m_junction_of_piece.at(curve.last_piece);
      curve.samples.push_back(m_junctions[last_junction].sample);
      curve.faces.push_back(m_surface.piece(curve.last_piece).face);
    }
    m_curves.push_back(std::move(curve));
    m_ends.push_back({{{left, right}}, {{first_junction, last_junction}}});
  }

  const Surface& m_surface;
  double m_tolerance;
  Crossings m_crossings;
  std::vector<Junction> m_junctions;
  std::unordered_map<Index, std::size_t> m_junction_of_piece;
  std::vector<Followed_curve> m_curves;
  std::vector<Ends> m_ends; // of the curves
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ISOLINE_TRACER_H
