// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_TRIANGLE_SOUP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_TRIANGLE_SOUP_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The triangles on which a repair works. A vertex is a point of the input, with the same number, or a copy of one,
 * numbered after them. Coincident vertices have the same `place`, the least number of a coincident point.
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

  /* Preserves the order of the others. */
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

  /* Returns the vertex into which v was merged. */
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

using Soup_coordinates = std::array<double, 3>;

template <class Point_3>
Soup_coordinates soup_coordinates(const Point_3& p)
{
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

/* Returns the largest difference of two coordinates. */
inline double maximum_distance(const Soup_coordinates& p, const Soup_coordinates& q)
{
  return (std::max)({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/* The least corner of the bounding box of the finite points, and the length of its longest side. */
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
 * Finds the points whose coordinates differ from those of a given point by at most a distance. They are sorted by the
 * cells of a grid, so that points near the given one lie in its cell or in neighbors of that.
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

  /* Calls `use(i, distance)` for each point near the given one. */
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
  static constexpr double cell_size = 2; // the error of a rounded quotient is less than half of this

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
 * Moves each point to the nearest unmoved point before it within a tolerance, which is relative to the longest side of
 * the bounding box. Returns the number of moved points. The unmoved ones are farther from each other, so that a second
 * call moves nothing.
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

/*
 * Finds border edges that nearly coincide with others: their ends are near the ends of another border edge in a
 * different place. Points written with few digits, or computed in two ways, cause this at seams.
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

  // The distance of the ends of edge i to those of the nearest other one, in either direction; infinite if there is
  // none.
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

  // True also for the edge itself.
  bool is_in_same_place(std::size_t i, std::size_t j) const
  {
    const auto places = [this](const Edge& e) { return std::minmax({m_soup.place(e.first), m_soup.place(e.second)}); };
    return places(m_edges[i]) == places(m_edges[j]);
  }

  const Soup& m_soup;
  std::vector<Edge> m_edges;
  std::vector<Soup_coordinates> m_tails, m_heads;
};

/*
 * Triangulates polygons of a soup, by corners of the polygon: a quadrilateral along the better diagonal, others by a
 * constrained Delaunay triangulation of their projection along an axis in which they are simple. Polygons that are
 * simple in no projection are cut into a fan.
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
  // A simple polygon requires no intersections of constraints, so that predicates on the input suffice.
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

  /* \pre there are at least three corners */
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

  // The diagonal for which both halves have a large area and the same orientation, as CGAL chooses it.
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

  // The axes, beginning with that in whose direction the polygon is widest.
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

  // In the order of their least corners, with which each starts.
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

/* Constructs the triangles of a soup from polygons, and reports the changes. */
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
      if(first < open.size()) { // the same place again: the corners in between are a part
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

  // The position of the place of v among the open corners, or their number.
  std::size_t position_in(const Corners& open, std::size_t v)
  {
    m_position.resize(m_soup.points.size(), 0);
    const std::size_t i = m_position[m_soup.place(v)];
    return i < open.size() && m_soup.place(open[i]) == m_soup.place(v) ? i : open.size();
  }

  Soup& m_soup;
  Repair_record& m_record;
  Soup_polygon_triangulator<Kernel> m_triangulate;
  std::vector<std::size_t> m_position; // of a place in the current polygon; may be out of date
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_TRIANGLE_SOUP_H
