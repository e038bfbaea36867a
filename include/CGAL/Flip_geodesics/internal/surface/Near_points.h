// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAR_POINTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAR_POINTS_H

#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

using Soup_coordinates = std::array<double, 3>;

template <class Point_3>
Soup_coordinates soup_coordinates(const Point_3& p)
{
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

/* The largest difference of two coordinates. */
inline double maximum_distance(const Soup_coordinates& p, const Soup_coordinates& q)
{
  return (std::max)({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/* The least corner of the bounding box of those points that are finite, and the length of its longest side. */
struct Soup_box
{
  explicit Soup_box(const std::vector<Soup_coordinates>& points)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Soup_coordinates high = {{-infinity, -infinity, -infinity}};
    low = {{infinity, infinity, infinity}};
    for(const Soup_coordinates& p : points)
      for(int k = 0; k < 3 && are_finite(p); ++k) {
        low[k] = (std::min)(low[k], p[k]);
        high[k] = (std::max)(high[k], p[k]);
      }
    longest_side = low[0] <= high[0] ? maximum_distance(low, high) : 0;
  }

  Soup_coordinates low;
  double longest_side;
};

/*
 * Finds the points whose coordinates differ from those of a place by a distance at most. They are sorted by the cells of
 * a grid, so that those near a place lie in its cell or in neighbors of that.
 *
 * \pre the points are finite, and so is the longest side of their box
 */
class Near_points
{
public:
  Near_points(const std::vector<Soup_coordinates>& points, double distance)
    : m_points(points)
    , m_box(points)
    , m_distance(distance)
    , m_size((std::max)(cell_size * distance, m_box.longest_side * least_cell_size))
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      m_cells.emplace_back(cell(points[i]), i);
    std::sort(m_cells.begin(), m_cells.end());
  }

  /* Calls `use(i, distance)` for each point near a place. */
  template <class Function>
  void for_each(const Soup_coordinates& place, const Function& use) const
  {
    const Soup_coordinates c = cell(place);
    for(double x : {c[0] - 1, c[0], c[0] + 1})
      for(double y : {c[1] - 1, c[1], c[1] + 1}) {
        const std::pair<Soup_coordinates, std::size_t> first = {{{x, y, c[2] - 1}}, 0};
        for(auto it = std::lower_bound(m_cells.begin(), m_cells.end(), first);
            it != m_cells.end() && it->first[0] == x && it->first[1] == y && it->first[2] <= c[2] + 1; ++it)
          if(const double distance = maximum_distance(place, m_points[it->second]); distance <= m_distance)
            use(it->second, distance);
      }
  }

private:
  static constexpr double cell_size = 2; // a rounded quotient errs by less than the half

  Soup_coordinates cell(const Soup_coordinates& p) const
  {
    const auto number = [&](int k) { return m_size > 0 ? std::floor((p[k] - m_box.low[k]) / m_size) : 0; };
    return {{number(0), number(1), number(2)}};
  }

  const std::vector<Soup_coordinates>& m_points;
  Soup_box m_box;
  double m_distance, m_size;
  std::vector<std::pair<Soup_coordinates, std::size_t>> m_cells;
};

/*
 * Moves points into the place of the nearest point before them that was not moved, if there is one within a tolerance,
 * which is relative to the longest side of the bounding box. Returns how many were moved. Those that were not are farther
 * from each other, so that nothing is left to be moved.
 */
template <class Point_3>
std::size_t weld_points(std::vector<Point_3>& points, double tolerance)
{
  std::vector<Soup_coordinates> places;
  std::vector<std::size_t> numbers; // of finite points
  for(std::size_t i = 0; i < points.size(); ++i)
    if(const Soup_coordinates p = soup_coordinates(points[i]); are_finite(p)) {
      places.push_back(p);
      numbers.push_back(i);
    }
  const double distance = tolerance * Soup_box(places).longest_side;
  if(!(distance > 0) || !std::isfinite(distance))
    return 0;
  const Near_points near_points(places, distance);
  std::vector<std::size_t> kept(places.size());
  std::size_t count = 0;
  for(std::size_t i = 0; i < places.size(); ++i) {
    std::pair<double, std::size_t> nearest = {std::numeric_limits<double>::infinity(), i};
    near_points.for_each(places[i], [&](std::size_t j, double d) {
      if(j < i && kept[j] == j)
        nearest = (std::min)(nearest, {d, j});
    });
    kept[i] = nearest.second;
    if(points[numbers[i]] == points[numbers[kept[i]]])
      continue;
    points[numbers[i]] = points[numbers[kept[i]]];
    ++count;
  }
  return count;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAR_POINTS_H
