// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Distances along an edge, which is the x-axis from 0 on: those from a point in the plane of a face, plus what is before
 * that point, `sigma`. As a function of the place on the edge it is convex, and nowhere steeper than 1.
 */
struct Cone
{
  double x, y; // y >= 0
  double sigma;

  double operator()(double q) const { return sigma + std::sqrt((q - x) * (q - x) + y * y); }

  /* The least value between two places. */
  double least(double from, double to) const { return (*this)((std::min)((std::max)(x, from), to)); }

  /* The least sum with another cone, which lies on the other side of the edge: straight through, if that is possible. */
  double least_sum(const Cone& other, double from, double to) const
  {
    const double height = y + other.y;
    const double straight = height > 0 ? x + (other.x - x) * (y / height) : (std::max)(x, other.x);
    const double q = (std::min)((std::max)(straight, from), to);
    return (*this)(q) + other(q);
  }
};

/* The least value of `a - b` between two places: at an end, or where both have the same slope. */
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

  /* That of the lowest, which falls and rises with slope 1. */
  double largest_sigma() const { return 0.5 * (m_start + m_end - m_length); }

  /* That of the one with a third value in between; minus infinity if no cone is that high. */
  double sigma(double place, double value) const
  {
    const double t = place / m_length, sag = (1 - t) * m_start + t * m_end - value;
    if(!(sag > cone_sag_rounding * m_length))
      return -std::numeric_limits<double>::infinity();
    // Stewart's theorem for the distances from the point to the three places. Squares of differences do not cancel.
    const double a = m_start - value, b = m_end - value;
    return value + ((1 - t) * a * a + t * b * b - place * (m_length - place)) / (2 * sag);
  }

  /* That of the flattest one that does not rise more than this at the first end; minus infinity if all do not. */
  double sigma_at_start(double slope) const { return m_start + sigma_from_end(slope * m_length + m_start - m_end); }

  /* That of the flattest one that does not rise less than this at the second end; minus infinity if all do not. */
  double sigma_at_end(double slope) const { return m_end + sigma_from_end(m_end - m_start - slope * m_length); }

  Cone operator()(double sigma) const
  {
    const double a = m_start - sigma, b = m_end - sigma;
    const double x = 0.5 * (m_length + (a - b) * ((a + b) / m_length));
    return {x, std::sqrt((std::max)((a - x) * (a + x), 0.0)), sigma};
  }

private:
  // Less the distance from the first end to the point: the slope there, times the length, is what the values rise from
  // that end on, less `(length^2 - rise^2) / (2 distance)`. `steepness` is what it may be, less the rise.
  double sigma_from_end(double steepness) const
  {
    const double rise = m_end - m_start;
    return steepness < 0 ? 0.5 * (std::max)((m_length - rise) * (m_length + rise), 0.0) / steepness
                         : -std::numeric_limits<double>::infinity();
  }

  double m_length, m_start, m_end;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_H
