// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POLYGON_TRIANGULATOR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POLYGON_TRIANGULATOR_H

#include <CGAL/Flip_geodesics/internal/triangulation/Overlay_layout.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Triangulates the polygons of an overlay, which are convex up to rounding, by diagonals: of all triangulations the one
 * whose worst triangle is best, by dynamic programming [Klincsek, Minimal Triangulations of Polygonal Domains].
 *
 * No diagonal joins two vertices of one straight line, that is, of a run of sides along one edge. That is decided by
 * labels and not by positions, so that the result has no double edges whatever rounding does.
 */
template <class Triangulation>
class Polygon_triangulator
{
  using Overlay = internal::Overlay<Triangulation>;
  using Layout = Overlay_layout<Triangulation>;
  using Point_2 = typename Layout::Point_2;

public:
  Polygon_triangulator(Overlay& overlay, Layout& layout)
    : m_overlay(overlay)
    , m_layout(layout)
  {
  }

  /* Triangulates all polygons. Cubic in the sides of each, of which there are rarely more than six. */
  void operator()()
  {
    std::vector<Overlay_halfedge> polygons;
    m_overlay.for_each_polygon([&](Overlay_halfedge h) { polygons.push_back(h); });
    for(Overlay_halfedge h : polygons)
      triangulate(h);
  }

private:
  // Beyond this, polygons are halved first: so many vertices lie on straight lines.
  static constexpr std::size_t largest = 32;

  void triangulate(Overlay_halfedge h)
  {
    std::vector<Overlay_halfedge> sides;
    m_overlay.for_each_side(h, [&](Overlay_halfedge side) { sides.push_back(side); });
    if(sides.size() <= 3)
      return;
    find_runs(sides);
    if(sides.size() > largest && halve(sides))
      return;
    m_points.clear();
    const auto corners = m_layout.corners(m_layout.face(h));
    for(Overlay_halfedge side : sides)
      m_points.push_back(Layout::point(corners, m_layout.weights(side)));
    find_best(sides.size());
    add_diagonals(sides, 0, sides.size() - 1, sides.back());
  }

  bool is_on_one_line(Overlay_halfedge side, Overlay_halfedge other) const
  {
    const Input_halfedge_index input = m_overlay.input_halfedge(side);
    const Halfedge_index intrinsic = m_overlay.intrinsic_halfedge(side);
    return (input != null_index && input == m_overlay.input_halfedge(other)) ||
           (intrinsic != null_index && intrinsic == m_overlay.intrinsic_halfedge(other));
  }

  // How many sides from each on lie on one line.
  void find_runs(const std::vector<Overlay_halfedge>& sides)
  {
    const std::size_t n = sides.size();
    m_runs.assign(n, 1);
    for(std::size_t i = 0; i < n; ++i)
      while(m_runs[i] < n && is_on_one_line(sides[i], sides[(i + m_runs[i]) % n]))
        ++m_runs[i];
  }

  bool is_diagonal(std::size_t i, std::size_t j) const // i < j
  {
    return m_runs[i] < j - i && m_runs[j] < m_runs.size() - (j - i);
  }

  bool halve(const std::vector<Overlay_halfedge>& sides)
  {
    const std::size_t n = sides.size(), half = n / 2;
    for(std::size_t i = 0; i < n - half; ++i)
      if(is_diagonal(i, i + half)) {
        const Overlay_halfedge d = add_diagonal(sides[i], sides[i + half]);
        triangulate(d);
        triangulate(Overlay::twin(d));
        return true;
      }
    return false;
  }

  // m_best of (i, j) is the quality of the worst triangle of the best triangulation of the vertices i to j.
  void find_best(std::size_t n)
  {
    constexpr double none = -std::numeric_limits<double>::infinity();
    m_best.assign(n * n, none);
    m_apex.assign(n * n, 0);
    for(std::size_t i = 0; i + 1 < n; ++i)
      m_best[i * n + i + 1] = (std::numeric_limits<double>::max)();
    for(std::size_t width = 2; width < n; ++width)
      for(std::size_t i = 0; i + width < n; ++i) {
        const std::size_t j = i + width;
        if(width + 1 < n && !is_diagonal(i, j))
          continue;
        for(std::size_t k = i + 1; k < j; ++k) {
          const double worst = (std::min)({m_best[i * n + k], m_best[k * n + j], quality(i, k, j)});
          if(worst > m_best[i * n + j] || m_apex[i * n + j] == 0) {
            m_best[i * n + j] = worst;
            m_apex[i * n + j] = k;
          }
        }
      }
  }

  // Twice the area over the squares of the sides; negative if rounding has turned the triangle over.
  double quality(std::size_t i, std::size_t j, std::size_t k) const
  {
    const auto difference = [](const Point_2& p, const Point_2& q) { return Point_2{q[0] - p[0], q[1] - p[1]}; };
    const auto square = [](const Point_2& v) { return v[0] * v[0] + v[1] * v[1]; };
    const Point_2 u = difference(m_points[i], m_points[j]), v = difference(m_points[i], m_points[k]);
    const double sum = square(u) + square(v) + square(difference(m_points[j], m_points[k]));
    return sum > 0 ? (u[0] * v[1] - u[1] * v[0]) / sum : 0;
  }

  // Sides i to j - 1 and `closing`, which leads from vertex j to vertex i, are a polygon of the overlay.
  void add_diagonals(const std::vector<Overlay_halfedge>& sides, std::size_t i, std::size_t j, Overlay_halfedge closing)
  {
    if(j - i < 2)
      return;
    const std::size_t k = m_apex[i * sides.size() + j];
    if(k - i > 1)
      add_diagonals(sides, i, k, Overlay::twin(add_diagonal(sides[i], sides[k])));
    if(j - k > 1)
      add_diagonals(sides, k, j, Overlay::twin(add_diagonal(sides[k], closing)));
  }

  Overlay_halfedge add_diagonal(Overlay_halfedge a, Overlay_halfedge b)
  {
    const Overlay_halfedge d = m_overlay.add_diagonal(a, b);
    m_layout.add_diagonal(a, b);
    return d;
  }

  Overlay& m_overlay;
  Layout& m_layout;
  std::vector<Point_2> m_points;
  std::vector<std::size_t> m_runs, m_apex;
  std::vector<double> m_best;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_POLYGON_TRIANGULATOR_H
