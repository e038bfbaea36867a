// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAR_BORDERS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAR_BORDERS_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Near_points.h>
#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Finds border edges that nearly coincide with others: their ends are near the ends of another border edge in a
 * different place, which is what points written with few digits, or computed in two ways, make of a seam.
 */
template <class Kernel>
class Near_borders
{
  using Soup = Triangle_soup<Kernel>;
  using Edge = std::pair<std::size_t, std::size_t>;

public:
  explicit Near_borders(const Soup& soup)
    : m_soup(soup)
    , m_edges(border_edges(soup))
  {
    for(const Edge& e : m_edges) {
      m_tails.push_back(soup_coordinates(soup.point(e.first)));
      m_heads.push_back(soup_coordinates(soup.point(e.second)));
    }
  }

  void operator()(Repair_record& record) const
  {
    const double side = Soup_box(m_tails).longest_side, distance = near_border_distance * side;
    if(!(distance > 0) || !std::isfinite(side))
      return;
    const Near_points tails(m_tails, distance);
    for(std::size_t i = 0; i < m_edges.size(); ++i)
      if(const double gap = distance_to_nearest(i, tails, distance); gap <= distance) {
        ++record.near_border_edges;
        record.near_border_distance = (std::max)(record.near_border_distance, gap / side);
      }
  }

private:
  static constexpr double least_length = 4; // in near distances: the ends of one edge are not near each other

  static std::vector<Edge> border_edges(const Soup& soup)
  {
    std::vector<Edge> sides, result;
    sides.reserve(3 * soup.triangles.size());
    for(const auto& t : soup.triangles)
      for(int i = 0; i < 3; ++i)
        sides.emplace_back(t[i], t[(i + 1) % 3]);
    std::sort(sides.begin(), sides.end());
    for(const Edge& side : sides)
      if(!std::binary_search(sides.begin(), sides.end(), Edge(side.second, side.first)))
        result.push_back(side);
    return result;
  }

  // The distance of the ends of edge i to those of the nearest other one, in either direction; infinite if there is none.
  double distance_to_nearest(std::size_t i, const Near_points& tails, double distance) const
  {
    double result = std::numeric_limits<double>::infinity();
    const auto measure = [&](std::size_t j, double at_one_end, const Soup_coordinates& end,
                             const Soup_coordinates& other) {
      if(is_long(i, distance) && is_long(j, distance) && !is_in_same_place(i, j))
        result = (std::min)(result, (std::max)(at_one_end, maximum_distance(end, other)));
    };
    tails.for_each(m_tails[i], [&](std::size_t j, double d) { measure(j, d, m_heads[i], m_heads[j]); });
    tails.for_each(m_heads[i], [&](std::size_t j, double d) { measure(j, d, m_tails[i], m_heads[j]); });
    return result;
  }

  bool is_long(std::size_t i, double distance) const
  {
    return maximum_distance(m_tails[i], m_heads[i]) >= least_length * distance;
  }

  // So is an edge itself.
  bool is_in_same_place(std::size_t i, std::size_t j) const
  {
    const auto places = [this](const Edge& e) { return std::minmax({m_soup.place(e.first), m_soup.place(e.second)}); };
    return places(m_edges[i]) == places(m_edges[j]);
  }

  const Soup& m_soup;
  std::vector<Edge> m_edges;
  std::vector<Soup_coordinates> m_tails, m_heads;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_NEAR_BORDERS_H
