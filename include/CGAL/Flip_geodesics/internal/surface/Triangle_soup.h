// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_TRIANGLE_SOUP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_TRIANGLE_SOUP_H

#include <CGAL/Flip_geodesics/Repair_report.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The triangles on which a repair works. A vertex is a point of the input, with the same number, or a copy of one,
 * numbered after them. Vertices in the same place have the same `place`, the least number of a point there.
 */
template <class Kernel_>
struct Triangle_soup
{
  using Kernel = Kernel_;
  using Point_3 = typename Kernel::Point_3;
  using Triangle = std::array<std::size_t, 3>;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  explicit Triangle_soup(std::vector<Point_3> points_)
    : points(std::move(points_))
    , origins(points.size())
    , merged_into(points.size())
  {
    std::iota(origins.begin(), origins.end(), std::size_t(0));
    std::iota(merged_into.begin(), merged_into.end(), std::size_t(0));
    find_places();
  }

  std::size_t place(std::size_t v) const { return places[origins[v]]; }
  const Point_3& point(std::size_t v) const { return points[origins[v]]; }

  void add(const Triangle& triangle, std::size_t polygon)
  {
    triangles.push_back(triangle);
    polygons.push_back(polygon);
    is_reversed.push_back(0);
  }

  void reverse(std::size_t t)
  {
    std::reverse(triangles[t].begin(), triangles[t].end());
    is_reversed[t] ^= 1;
  }

  bool is_collinear(const Triangle& t) const
  {
    return Kernel().collinear_3_object()(point(t[0]), point(t[1]), point(t[2]));
  }

  /* Keeps the order of the others. */
  void remove(const std::vector<char>& is_dropped)
  {
    std::size_t kept = 0;
    for(std::size_t t = 0; t < triangles.size(); ++t) {
      if(is_dropped[t] != 0)
        continue;
      triangles[kept] = triangles[t];
      polygons[kept] = polygons[t];
      is_reversed[kept++] = is_reversed[t];
    }
    triangles.resize(kept);
    polygons.resize(kept);
    is_reversed.resize(kept);
  }

  /* Stable. */
  void sort_by_polygon()
  {
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t s, std::size_t t) { return polygons[s] < polygons[t]; });
    permute(triangles, order);
    permute(polygons, order);
    permute(is_reversed, order);
  }

  /* The vertex that v became part of. */
  std::size_t resolve(std::size_t v) const
  {
    while(merged_into[v] != v)
      v = merged_into[v];
    return v;
  }

  const std::vector<Point_3> points; // of the input
  std::vector<std::size_t> places;   // for each point, none if it is not finite
  std::vector<std::size_t> origins;  // for each vertex its point
  std::vector<std::size_t> merged_into;
  std::vector<Triangle> triangles;
  std::vector<std::size_t> polygons; // for each triangle
  std::vector<char> is_reversed;

private:
  template <class Value>
  static void permute(std::vector<Value>& values, const std::vector<std::size_t>& order)
  {
    std::vector<Value> result;
    result.reserve(order.size());
    for(std::size_t i : order)
      result.push_back(values[i]);
    values = std::move(result);
  }

  static bool is_finite_point(const Point_3& p)
  {
    return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(p.z());
  }

  void find_places()
  {
    std::vector<std::size_t> order;
    for(std::size_t i = 0; i < points.size(); ++i)
      if(is_finite_point(points[i]))
        order.push_back(i);
    std::sort(order.begin(), order.end(), [this](std::size_t i, std::size_t j) {
      const auto comparison = Kernel().compare_xyz_3_object()(points[i], points[j]);
      return comparison == CGAL::EQUAL ? i < j : comparison == CGAL::SMALLER;
    });
    places.assign(points.size(), none);
    for(std::size_t k = 0; k < order.size(); ++k) {
      const bool is_first = k == 0 || points[order[k]] != points[order[k - 1]];
      places[order[k]] = is_first ? order[k] : places[order[k - 1]];
    }
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_TRIANGLE_SOUP_H
