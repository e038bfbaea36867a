// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_POLYGONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_POLYGONS_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/surface/Triangle_soup.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Cuts polygons of a soup into triangles, by corners of the polygon: a quadrilateral along the better diagonal, others
 * by a constrained Delaunay triangulation of their projection along an axis in which they are simple. Those that are
 * simple in none are cut into a fan.
 */
template <class Kernel>
class Soup_polygon_triangulator
{
  using Soup = Triangle_soup<Kernel>;
  using Point_2 = typename Kernel::Point_2;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Face_base =
      CGAL::Triangulation_face_base_with_info_2<bool, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  // A simple polygon needs no intersections of constraints, so all is decided by predicates on the input.
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                 CGAL::No_constraint_intersection_requiring_constructions_tag>;

public:
  using Corners = std::vector<std::size_t>;
  using Triangle = typename Soup::Triangle;

  explicit Soup_polygon_triangulator(const Soup& soup)
    : m_soup(soup)
  {
  }

  /* \pre three corners or more */
  std::vector<Triangle> operator()(const Corners& corners) const
  {
    if(corners.size() == 3)
      return {{corners[0], corners[1], corners[2]}};
    if(corners.size() == 4)
      return halves(corners);
    for(int axis : axes(corners)) {
      const std::vector<Point_2> projected = project(corners, axis);
      if(CGAL::is_simple_2(projected.begin(), projected.end(), Kernel()))
        return triangulate(corners, projected);
    }
    return fan(corners);
  }

private:
  static std::vector<Triangle> fan(const Corners& c)
  {
    std::vector<Triangle> result;
    for(std::size_t i = 1; i + 1 < c.size(); ++i)
      result.push_back({c[0], c[i], c[i + 1]});
    return result;
  }

  std::array<double, 3> coordinates(std::size_t v) const
  {
    const auto& p = m_soup.point(v);
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // Twice the vector area of a triangle.
  std::array<double, 3> area(std::size_t u, std::size_t v, std::size_t w) const
  {
    const auto p = coordinates(u), q = coordinates(v), r = coordinates(w);
    std::array<double, 3> result;
    for(int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      result[k] = (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
    }
    return result;
  }

  // The diagonal at which both halves have much area and turn the same way, as CGAL chooses it.
  std::vector<Triangle> halves(const Corners& c) const
  {
    const auto product = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const double first = product(area(c[0], c[1], c[2]), area(c[0], c[2], c[3]));
    const double second = product(area(c[0], c[1], c[3]), area(c[1], c[2], c[3]));
    if(second > first)
      return {{c[0], c[1], c[3]}, {c[1], c[2], c[3]}};
    return {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}};
  }

  // The axes, that in whose direction the polygon is widest first.
  std::array<int, 3> axes(const Corners& corners) const
  {
    std::array<double, 3> total = {0, 0, 0};
    for(const Triangle& t : fan(corners)) {
      const auto part = area(t[0], t[1], t[2]);
      for(int k = 0; k < 3; ++k)
        total[k] += part[k];
    }
    std::array<int, 3> result = {0, 1, 2};
    if(std::all_of(total.begin(), total.end(), [](double x) { return std::isfinite(x); }))
      std::stable_sort(result.begin(), result.end(),
                       [&](int i, int j) { return std::abs(total[i]) > std::abs(total[j]); });
    return result;
  }

  std::vector<Point_2> project(const Corners& corners, int axis) const
  {
    std::vector<Point_2> result;
    for(std::size_t v : corners) {
      const auto& p = m_soup.point(v);
      result.push_back(axis == 0 ? Point_2(p.y(), p.z()) : (axis == 1 ? Point_2(p.z(), p.x()) : Point_2(p.x(), p.y())));
    }
    return result;
  }

  static std::vector<Triangle> triangulate(const Corners& corners, const std::vector<Point_2>& projected)
  {
    Triangulation triangulation;
    std::vector<typename Triangulation::Vertex_handle> vertices;
    for(std::size_t i = 0; i < projected.size(); ++i) {
      vertices.push_back(triangulation.insert(projected[i]));
      vertices.back()->info() = i;
    }
    for(std::size_t i = 0; i < vertices.size(); ++i)
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
    mark_outside(triangulation);
    return inner_triangles(corners, triangulation,
                           CGAL::orientation_2(projected.begin(), projected.end(), Kernel()) == CGAL::CLOCKWISE);
  }

  static void mark_outside(Triangulation& triangulation)
  {
    for(auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f)
      f->info() = false;
    std::vector<typename Triangulation::Face_handle> stack = {triangulation.infinite_face()};
    while(!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      if(f->info())
        continue;
      f->info() = true;
      for(int i = 0; i < 3; ++i)
        if(!f->is_constrained(i))
          stack.push_back(f->neighbor(i));
    }
  }

  // In the order of their least corners, which each starts with.
  static std::vector<Triangle> inner_triangles(const Corners& corners, const Triangulation& triangulation,
                                               bool is_clockwise)
  {
    std::vector<Triangle> result;
    for(auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
      if(f->info())
        continue;
      Triangle t = {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
      if(is_clockwise)
        std::reverse(t.begin(), t.end());
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.push_back(t);
    }
    std::sort(result.begin(), result.end());
    for(Triangle& t : result)
      for(std::size_t& corner : t)
        corner = corners[corner];
    return result;
  }

  const Soup& m_soup;
};

/* Makes the triangles of a soup from polygons, and says what it did. */
template <class Kernel>
class Soup_polygons
{
  using Soup = Triangle_soup<Kernel>;
  using Corners = std::vector<std::size_t>;

public:
  Soup_polygons(Soup& soup, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
    , m_triangulate(soup)
  {
  }

  void operator()(const Corners& polygon, std::size_t number)
  {
    if(std::any_of(polygon.begin(), polygon.end(), [this](std::size_t v) { return !is_point(v); }))
      return m_record.add(Repair::POLYGONS_WITHOUT_POINTS);
    const Corners corners = without_repeated_corners(polygon);
    const std::vector<Corners> parts = split_where_pinched(corners);
    if(parts.empty())
      return m_record.add(Repair::POLYGONS_COLLAPSED);
    m_record.add(Repair::CORNERS_REPEATED, polygon.size() - corners.size());
    if(parts.size() > 1 || parts.front().size() < corners.size())
      m_record.add(Repair::POLYGONS_SPLIT);
    bool is_cut = false;
    for(const Corners& part : parts) {
      is_cut = is_cut || part.size() > 3;
      for(const auto& triangle : m_triangulate(part))
        m_soup.add(triangle, number);
    }
    if(is_cut)
      m_record.add(Repair::POLYGONS_TRIANGULATED);
  }

private:
  bool is_point(std::size_t v) const { return v < m_soup.points.size() && m_soup.places[v] != Soup::none; }

  Corners without_repeated_corners(const Corners& polygon) const
  {
    Corners result;
    for(std::size_t v : polygon)
      if(result.empty() || m_soup.place(v) != m_soup.place(result.back()))
        result.push_back(v);
    while(result.size() > 1 && m_soup.place(result.back()) == m_soup.place(result.front()))
      result.pop_back();
    return result;
  }

  // The parts of at least three corners between visits of one place, from the innermost outwards.
  std::vector<Corners> split_where_pinched(const Corners& corners)
  {
    std::vector<Corners> parts;
    Corners open;
    for(std::size_t v : corners) {
      const std::size_t first = position_in(open, v);
      if(first < open.size()) { // the same place again: what lies between is a part
        if(open.size() - first >= 3)
          parts.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
        open.resize(first);
      }
      open.push_back(v);
      m_position[m_soup.place(v)] = open.size() - 1;
    }
    if(open.size() >= 3)
      parts.push_back(open);
    return parts;
  }

  // Where the place of v is among the open corners, or their number.
  std::size_t position_in(const Corners& open, std::size_t v)
  {
    m_position.resize(m_soup.points.size(), 0);
    const std::size_t i = m_position[m_soup.place(v)];
    return i < open.size() && m_soup.place(open[i]) == m_soup.place(v) ? i : open.size();
  }

  Soup& m_soup;
  Repair_record& m_record;
  Soup_polygon_triangulator<Kernel> m_triangulate;
  std::vector<std::size_t> m_position; // of a place in the polygon at hand; may be out of date
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_POLYGONS_H
