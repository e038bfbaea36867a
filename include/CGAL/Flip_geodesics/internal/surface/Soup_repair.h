// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H

#include <CGAL/Flip_geodesics/Repair_report.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A triangle of a soup, with the number of its polygon, and whether its orientation is opposite to that one's. */
struct Soup_triangle : std::array<std::size_t, 3>
{
  std::size_t polygon = 0;
  bool is_reversed = false;
};

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

  void add(const Triangle& triangle, std::size_t polygon) { triangles.push_back({triangle, polygon, false}); }

  void reverse(std::size_t t)
  {
    std::reverse(triangles[t].begin(), triangles[t].end());
    triangles[t].is_reversed = !triangles[t].is_reversed;
  }

  bool is_collinear(const Triangle& t) const
  {
    return Kernel().collinear_3_object()(point(t[0]), point(t[1]), point(t[2]));
  }

  /* Preserves the order of the others. */
  void remove(const std::vector<char>& is_dropped)
  {
    std::size_t kept = 0;
    for(std::size_t t = 0; t < triangles.size(); ++t)
      if(is_dropped[t] == 0)
        triangles[kept++] = triangles[t];
    triangles.resize(kept);
  }

  /* Stable. */
  void sort_by_polygon()
  {
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const Soup_triangle& s, const Soup_triangle& t) { return s.polygon < t.polygon; });
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
  std::vector<Soup_triangle> triangles;

private:
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

template <class Point_3>
Place_in_space soup_coordinates(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

/* Returns the largest difference of two coordinates. */
inline double maximum_distance(const Place_in_space& p, const Place_in_space& q)
{
  return (std::max)({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/* The bounding box of the finite points, and the length of its longest side; infinite if there are none. */
struct Soup_box : Bounding_box
{
  explicit Soup_box(const std::vector<Place_in_space>& points)
  {
    for(const Place_in_space& p : points)
      if(are_finite(p))
        add(p);
    longest_side = maximum_distance(low, high);
  }

  double longest_side;
};

/*
 * Finds the points whose coordinates differ from those of a given point by at most a distance. They are sorted by the
 * cells of a grid, so points near the given one lie in its cell or in neighbors of that.
 *
 * \pre the points are finite, and so is the longest side of their box
 */
class Near_points
{
public:
  Near_points(const std::vector<Place_in_space>& points, double distance)
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
  void for_each(const Place_in_space& place, const Function& use) const
  {
    const Place_in_space c = cell(place);
    for(double x : {c[0] - 1, c[0], c[0] + 1})
      for(double y : {c[1] - 1, c[1], c[1] + 1}) {
        const std::pair<Place_in_space, std::size_t> first = {{{x, y, c[2] - 1}}, 0};
        for(auto it = std::lower_bound(m_cells.begin(), m_cells.end(), first);
            it != m_cells.end() && it->first[0] == x && it->first[1] == y && it->first[2] <= c[2] + 1; ++it)
          if(const double distance = maximum_distance(place, m_points[it->second]); distance <= m_distance)
            use(it->second, distance);
      }
  }

private:
  static constexpr double cell_size = 2; // the error of a rounded quotient is less than half of this

  Place_in_space cell(const Place_in_space& p) const
  {
    const auto number = [&](int k) { return m_size > 0 ? std::floor((p[k] - m_box.low[k]) / m_size) : 0; };
    return {{number(0), number(1), number(2)}};
  }

  const std::vector<Place_in_space>& m_points;
  Soup_box m_box;
  double m_distance, m_size;
  std::vector<std::pair<Place_in_space, std::size_t>> m_cells;
};

/*
 * Moves each point to the nearest unmoved point before it within a tolerance, which is relative to the longest side of
 * the bounding box. Returns the number of moved points. The unmoved ones are farther from each other, so a second
 * call moves nothing.
 */
template <class Point_3>
std::size_t weld_points(std::vector<Point_3>& points, double tolerance)
{
  std::vector<Place_in_space> places;
  std::vector<std::size_t> numbers; // of finite points
  for(std::size_t i = 0; i < points.size(); ++i)
    if(const Place_in_space p = soup_coordinates(points[i]); are_finite(p)) {
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
    const auto measure = [&](std::size_t j, double at_one_end, const Place_in_space& end, const Place_in_space& other) {
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
  std::vector<Place_in_space> m_tails, m_heads;
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
  // A simple polygon requires no intersections of constraints, so predicates on the input suffice.
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

  // Returns twice the vector area of a triangle.
  Place_in_space area(std::size_t u, std::size_t v, std::size_t w) const
  {
    const Place_in_space p = soup_coordinates(m_soup.point(u));
    return cross(difference(soup_coordinates(m_soup.point(v)), p), difference(soup_coordinates(m_soup.point(w)), p));
  }

  // The diagonal for which both halves have a large area and the same orientation, as CGAL chooses it.
  std::vector<Triangle> halves(const Corners& c) const
  {
    const double first = dot(area(c[0], c[1], c[2]), area(c[0], c[2], c[3]));
    const double second = dot(area(c[0], c[1], c[3]), area(c[1], c[2], c[3]));
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
    m_position.resize(m_soup.points.size());
    const std::size_t i = m_position[m_soup.place(v)];
    return i < open.size() && m_soup.place(open[i]) == m_soup.place(v) ? i : open.size();
  }

  Soup& m_soup;
  Repair_record& m_record;
  Soup_polygon_triangulator<Kernel> m_triangulate;
  std::vector<std::size_t> m_position; // of a place in the current polygon; may be out of date
};

template <class Kernel>
using Soup_mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;

/*
 * Returns a soup as a mesh, for operations that require neighbors: vertex v of the soup has index v, triangle t index
 * t.
 *
 * \pre the soup is an oriented manifold
 */
template <class Kernel>
Soup_mesh<Kernel> make_soup_mesh(const Triangle_soup<Kernel>& soup)
{
  std::vector<typename Kernel::Point_3> points;
  points.reserve(soup.origins.size());
  for(std::size_t v = 0; v < soup.origins.size(); ++v)
    points.push_back(soup.point(v));
  Soup_mesh<Kernel> mesh;
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh);
  return mesh;
}

/* Returns the corners of a face, starting with the head of its halfedge. */
template <class Mesh>
std::array<std::size_t, 3> corners(const Mesh& mesh, typename Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {static_cast<std::size_t>(mesh.target(h)), static_cast<std::size_t>(mesh.target(mesh.next(h))),
          static_cast<std::size_t>(mesh.source(h))};
}

/* Returns for each face its edge-connected component, counted from 0 in the order of their first faces. */
template <class Mesh>
std::vector<std::size_t> face_components(Mesh& mesh)
{
  const auto map = mesh.template add_property_map<typename Mesh::Face_index, std::size_t>("f:component", 0).first;
  Polygon_mesh_processing::connected_components(mesh, map);
  std::vector<std::size_t> result;
  for(const auto f : mesh.faces())
    result.push_back(get(map, f));
  return result;
}

/*
 * Stitches coinciding borders of a soup with opposite directions: first pairs of border edges of one component, so that
 * cuts where parts touch are closed again, then those of any two components. If more than two edges of a component, or
 * of different components, coincide, none is stitched, since it is ambiguous which belong together. Pairs stay open if
 * their vertices, once merged, would be the ends of two edges, which would have to be cut again.
 *
 * \pre the soup is an oriented manifold, and it remains one
 */
template <class Kernel>
class Soup_stitcher
{
  using Soup = Triangle_soup<Kernel>;
  using Mesh = Soup_mesh<Kernel>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Pair = std::pair<Halfedge, Halfedge>;
  using Triangle = typename Soup::Triangle;

  struct Border_edge
  {
    std::size_t component, low, high; // the latter two are places
    bool is_ascending;
    Halfedge h;

    auto key() const { return std::tie(component, low, high); }
    bool operator<(const Border_edge& other) const
    {
      return std::make_tuple(component, low, high, h) <
             std::make_tuple(other.component, other.low, other.high, other.h);
    }
  };

public:
  explicit Soup_stitcher(Soup& soup)
    : m_soup(soup)
    , m_mesh(make_soup_mesh(soup))
  {
  }

  /* Returns whether borders were stitched. */
  bool operator()()
  {
    collect_border_edges();
    std::vector<Pair> pairs;
    take_pairs(pairs);
    for(Border_edge& edge : m_edges)
      edge.component = 0;
    take_pairs(pairs);
    std::sort(pairs.begin(), pairs.end()); // an order independent of the numbers of points
    if(pairs.empty() || Polygon_mesh_processing::stitch_borders(m_mesh, pairs) == 0)
      return false;
    find_stitched();
    read_back();
    return true;
  }

private:
  void collect_border_edges()
  {
    const std::vector<std::size_t> components = face_components(m_mesh);
    for(const Halfedge h : m_mesh.halfedges()) {
      if(!m_mesh.is_border(h))
        continue;
      const std::size_t p = m_soup.place(m_mesh.source(h)), q = m_soup.place(m_mesh.target(h));
      m_edges.push_back({components[m_mesh.face(m_mesh.opposite(h))], (std::min)(p, q), (std::max)(p, q), p < q, h});
    }
  }

  // Moves edges to the pairs if there are exactly two with the same key and opposite directions.
  void take_pairs(std::vector<Pair>& pairs)
  {
    std::sort(m_edges.begin(), m_edges.end());
    std::vector<Border_edge> rest;
    for(std::size_t begin = 0, end = 0; begin < m_edges.size(); begin = end) {
      while(end < m_edges.size() && m_edges[end].key() == m_edges[begin].key())
        ++end;
      if(end - begin == 2 && m_edges[begin].is_ascending != m_edges[begin + 1].is_ascending)
        pairs.emplace_back(m_edges[begin].h, m_edges[begin + 1].h);
      else
        rest.insert(rest.end(), m_edges.begin() + static_cast<std::ptrdiff_t>(begin),
                    m_edges.begin() + static_cast<std::ptrdiff_t>(end));
    }
    m_edges = std::move(rest);
  }

  // Stitching preserves faces and positions, but neither vertices nor the first corner of a face.
  void find_stitched()
  {
    m_stitched.clear();
    m_now.assign(m_soup.origins.size(), Soup::none);
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t) {
      const Triangle& before = m_soup.triangles[t];
      Triangle now = corners(m_mesh, typename Mesh::Face_index(static_cast<typename Mesh::size_type>(t)));
      while(m_soup.place(now[0]) != m_soup.place(before[0]))
        std::rotate(now.begin(), now.begin() + 1, now.end());
      for(int i = 0; i < 3; ++i)
        m_now[before[i]] = now[i];
      m_stitched.push_back(now);
    }
  }

  // The vertices of a stitched triangle become the least of those from which they were merged.
  void read_back()
  {
    std::vector<std::size_t> representative(m_soup.origins.size(), Soup::none);
    for(std::size_t v = 0; v < m_now.size(); ++v)
      if(m_now[v] != Soup::none)
        representative[m_now[v]] = (std::min)(representative[m_now[v]], v);
    for(std::size_t t = 0; t < m_stitched.size(); ++t)
      for(int i = 0; i < 3; ++i)
        m_soup.triangles[t][i] = representative[m_stitched[t][i]];
    for(std::size_t v = 0; v < m_now.size(); ++v)
      if(m_now[v] != Soup::none)
        m_soup.merged_into[v] = representative[m_now[v]];
  }

  Soup& m_soup;
  Mesh m_mesh;
  std::vector<Border_edge> m_edges;
  std::vector<Triangle> m_stitched;
  std::vector<std::size_t> m_now; // for each vertex of the soup its stitched vertex, none if it has no faces
};

/*
 * Removes triangles with collinear corners, which have their middle corner B on their longest edge AC. If a
 * nondegenerate triangle ACD lies beyond that edge, a flip converts both into two nondegenerate triangles, and the
 * surface is unchanged:
 *
 *        D                 D
 *      /   \             / | \
 *     A-----C    ->     A--B--C
 *      \-B-/
 *
 * If ACD is collinear as well and AC is its longest edge, a flip decreases the sum of lengths; if another edge is
 * longest, that longer edge is examined first. The process therefore terminates. A triangle that no flip can remove is
 * dropped: at a border the surface is the same without it; elsewhere this leaves a slit.
 *
 * \pre the soup is an oriented manifold, which it need not be afterwards, and no triangle has two coincident corners
 */
template <class Kernel>
class Soup_flips
{
  using Soup = Triangle_soup<Kernel>;
  using Mesh = Soup_mesh<Kernel>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Face = typename Mesh::Face_index;

public:
  Soup_flips(Soup& soup, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
  {
  }

  /* Returns whether anything was changed. */
  bool operator()()
  {
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      if(m_soup.is_collinear(m_soup.triangles[t]))
        m_stack.emplace_back(static_cast<typename Mesh::size_type>(t));
    if(m_stack.empty())
      return false;
    m_mesh = make_soup_mesh(m_soup);
    m_is_dropped.assign(m_soup.triangles.size(), 0);
    m_flips_left = 100 * m_stack.size();
    while(!m_stack.empty()) {
      const Face f = m_stack.back();
      m_stack.pop_back();
      if(!is_done(f))
        remove(f);
    }
    for(char is_dropped : m_is_dropped)
      m_record.add(Repair::DEGENERATE_FACES_DROPPED, is_dropped != 0 ? 1 : 0);
    m_soup.remove(m_is_dropped);
    return true;
  }

private:
  bool is_done(Face f) const { return m_is_dropped[f] != 0 || !m_soup.is_collinear(m_soup.triangles[f]); }

  void remove(Face f)
  {
    const Halfedge h = longest(f), o = m_mesh.opposite(h);
    if(m_mesh.is_border(o) || m_flips_left == 0)
      return drop(f);
    const Face g = m_mesh.face(o);
    if(m_is_dropped[g] != 0) // equivalent to a border
      return drop(f);
    if(!is_done(g) && longest(g) != o)
      m_stack.insert(m_stack.end(), {f, g});
    else
      flip_or_drop(f, h, g);
  }

  void drop(Face f) { m_is_dropped[f] = 1; }

  void flip_or_drop(Face f, Halfedge h, Face g)
  {
    const auto b = m_mesh.target(m_mesh.next(h)), d = m_mesh.target(m_mesh.next(m_mesh.opposite(h)));
    if(are_neighbors(b, d) || m_soup.place(b) == m_soup.place(d)) {
      drop(f);
      if(m_soup.is_collinear(m_soup.triangles[g]))
        drop(g);
      return;
    }
    if(!m_soup.is_collinear(m_soup.triangles[g]))
      m_record.add(Repair::DEGENERATE_FACES_FLIPPED);
    Euler::flip_edge(h, m_mesh);
    --m_flips_left;
    m_soup.triangles[f] = m_soup.triangles[g];
    for(const Face face : {f, g}) {
      static_cast<typename Soup::Triangle&>(m_soup.triangles[face]) = corners(m_mesh, face);
      m_stack.push_back(face);
    }
  }

  // The halfedge of a collinear face opposite to the middle corner.
  Halfedge longest(Face f) const
  {
    const auto is_ordered = Kernel().collinear_are_ordered_along_line_3_object();
    Halfedge h = m_mesh.halfedge(f);
    for(int i = 0; i < 2; ++i, h = m_mesh.next(h))
      if(is_ordered(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(m_mesh.next(h))),
                    m_mesh.point(m_mesh.target(h))))
        return h;
    return h;
  }

  // Linear in the smaller of the degrees.
  bool are_neighbors(typename Mesh::Vertex_index u, typename Mesh::Vertex_index v) const
  {
    Halfedge g = m_mesh.halfedge(u), h = m_mesh.halfedge(v);
    const Halfedge first_of_u = g, first_of_v = h;
    do {
      if(m_mesh.source(g) == v || m_mesh.source(h) == u)
        return true;
      g = m_mesh.opposite(m_mesh.next(g));
      h = m_mesh.opposite(m_mesh.next(h));
    } while(g != first_of_u && h != first_of_v);
    return false;
  }

  Soup& m_soup;
  Repair_record& m_record;
  Mesh m_mesh;
  std::vector<Face> m_stack;
  std::vector<char> m_is_dropped;
  std::size_t m_flips_left = 0;
};

/* Records which triangles CGAL's orientation reverses, and which edges it finds to have more than two triangles. */
class Orientation_recorder : public Polygon_mesh_processing::Default_orientation_visitor
{
public:
  using Edge = std::pair<std::size_t, std::size_t>;

  Orientation_recorder(std::vector<Soup_triangle>& triangles, std::vector<Edge>& edges)
    : m_triangles(&triangles)
    , m_edges(&edges)
  {
  }

  void polygon_orientation_reversed(std::size_t t) { (*m_triangles)[t].is_reversed = !(*m_triangles)[t].is_reversed; }

  void non_manifold_edge(std::size_t u, std::size_t v, std::size_t)
  {
    m_edges->emplace_back((std::min)(u, v), (std::max)(u, v));
  }

private:
  std::vector<Soup_triangle>* m_triangles;
  std::vector<Edge>* m_edges;
};

/*
 * Converts a soup into an oriented manifold without collinear triangles. A round drops duplicate triangles, orients all
 * consistently, cuts them apart where they are not a manifold, stitches coinciding borders, and flips or drops
 * collinear triangles. Rounds repeat until one changes nothing. A repair of the result, which is a round that starts
 * from the same triangles in the same order, therefore changes nothing either.
 *
 * The process terminates: the number of triangles never grows, a flip decreases the number of collinear ones or, with
 * the same number, the sum of lengths, and a stitch, which requires no cut, shortens borders. A step that increases one
 * of the later quantities has decreased an earlier one, and there are finitely many triangles on the vertices of the
 * soup.
 */
template <class Kernel>
class Soup_repair
{
  using Soup = Triangle_soup<Kernel>;
  using Triangle = typename Soup::Triangle;
  using Edge = Orientation_recorder::Edge;

public:
  Soup_repair(Soup& soup, Repair_record& record)
    : m_soup(soup)
    , m_record(record)
  {
  }

  void operator()()
  {
    std::vector<Soup_triangle> before;
    do {
      before = m_soup.triangles;
      apply_round();
      if(m_soup.triangles != before) {
        keep_most_orientations();
        m_soup.sort_by_polygon();
      }
    } while(m_soup.triangles != before);
    record_edges();
  }

private:
  void apply_round()
  {
    if(drop_duplicates() || !m_is_manifold)
      orient();
    m_is_manifold = true;
    if(has_vertices_in_one_place())
      stitch();
    if(Soup_flips<Kernel>(m_soup, m_record)())
      orient();
  }

  struct Place_triangle
  {
    Triangle places; // ascending
    std::size_t t;

    bool operator<(const Place_triangle& other) const
    {
      return places != other.places ? places < other.places : t < other.t;
    }
  };

  static Edge edge(const Triangle& t, int i)
  {
    return {(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])};
  }

  std::vector<Edge> sorted_edges() const
  {
    std::vector<Edge> result;
    for(const Triangle& t : m_soup.triangles)
      for(int i = 0; i < 3; ++i)
        result.push_back(edge(t, i));
    std::sort(result.begin(), result.end());
    return result;
  }

  Triangle sorted_places(std::size_t t) const
  {
    Triangle result;
    std::transform(m_soup.triangles[t].begin(), m_soup.triangles[t].end(), result.begin(),
                   [this](std::size_t v) { return m_soup.place(v); });
    std::sort(result.begin(), result.end());
    return result;
  }

  // Of coinciding triangles, the first is kept; others are dropped if they have the same vertices, or no neighbors.
  bool drop_duplicates()
  {
    std::vector<Place_triangle> order;
    for(std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      order.push_back({sorted_places(t), t});
    std::sort(order.begin(), order.end());
    std::vector<Edge> edges;
    std::vector<char> is_dropped(m_soup.triangles.size(), 0);
    for(std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      while(end < order.size() && order[end].places == order[begin].places)
        ++end;
      if(end - begin > 1 && edges.empty())
        edges = sorted_edges();
      for(std::size_t k = begin + 1; k < end; ++k)
        is_dropped[order[k].t] = is_duplicate(order[begin].t, order[k].t, edges) ? 1 : 0;
    }
    const auto count = static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), 1));
    m_record.add(Repair::DUPLICATES_DROPPED, count);
    m_soup.remove(is_dropped);
    return count > 0;
  }

  // Two triangles back to back, each the only neighbor of the other, are a closed surface and not duplicates.
  bool is_duplicate(std::size_t first, std::size_t t, const std::vector<Edge>& edges) const
  {
    const Triangle &a = m_soup.triangles[first], &b = m_soup.triangles[t];
    std::size_t most = 0, least = edges.size();
    for(int i = 0; i < 3; ++i) {
      const auto range = std::equal_range(edges.begin(), edges.end(), edge(b, i));
      most = (std::max)(most, static_cast<std::size_t>(range.second - range.first));
      least = (std::min)(least, static_cast<std::size_t>(range.second - range.first));
    }
    if(most == 1)
      return true;
    if(!std::is_permutation(a.begin(), a.end(), b.begin()))
      return false;
    return most > 2 || is_even(a, b);
  }

  // Returns whether b is a rotation of a.
  static bool is_even(const Triangle& a, const Triangle& b)
  {
    const auto at = std::find(b.begin(), b.end(), a[0]);
    return b[static_cast<std::size_t>(at - b.begin() + 1) % 3] == a[1];
  }

  bool has_vertices_in_one_place() const
  {
    std::vector<std::size_t> vertex_at(m_soup.points.size(), Soup::none);
    for(const Triangle& triangle : m_soup.triangles)
      for(std::size_t v : triangle) {
        std::size_t& at = vertex_at[m_soup.place(v)];
        if(at != Soup::none && at != v)
          return true;
        at = v;
      }
    return false;
  }

  // Reverses triangles such that coinciding borders have opposite directions and can be stitched. Triangles are passed
  // with the least place first, since CGAL's choice between conflicting neighbors depends on the first corner.
  void align_parts()
  {
    std::vector<Soup_triangle> triangles = m_soup.triangles;
    for(Soup_triangle& triangle : triangles) {
      for(std::size_t& v : triangle)
        v = m_soup.place(v);
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      triangle.is_reversed = false;
    }
    std::vector<std::size_t> vertices(m_soup.points.size(), 0);
    std::vector<Edge> ignored;
    Polygon_mesh_processing::orient_polygon_soup(vertices, triangles,
                                                 CGAL::parameters::visitor(Orientation_recorder(triangles, ignored)));
    for(std::size_t t = 0; t < triangles.size(); ++t)
      if(triangles[t].is_reversed)
        m_soup.reverse(t);
  }

  // The alignment of parts serves only the stitching: if nothing is stitched, the original orientations are kept.
  void stitch()
  {
    const std::vector<Soup_triangle> triangles = m_soup.triangles;
    align_parts();
    orient();
    if(Soup_stitcher<Kernel>(m_soup)())
      return;
    m_soup.triangles = triangles;
  }

  // Orients and cuts apart. Vertices added by this are appended to the origins, as copies.
  void orient()
  {
    std::vector<Edge> edges;
    Polygon_mesh_processing::orient_polygon_soup(
        m_soup.origins, m_soup.triangles, CGAL::parameters::visitor(Orientation_recorder(m_soup.triangles, edges)));
    for(const Edge& e : edges) {
      const auto ends = std::minmax(m_soup.origins[e.first], m_soup.origins[e.second]);
      m_edges.emplace_back(ends.first, ends.second);
    }
    for(std::size_t v = m_soup.merged_into.size(); v < m_soup.origins.size(); ++v)
      m_soup.merged_into.push_back(v);
  }

  // CGAL orients a component like its first triangle, which may reverse all others.
  void keep_most_orientations()
  {
    if(std::none_of(m_soup.triangles.begin(), m_soup.triangles.end(),
                    [](const Soup_triangle& t) { return t.is_reversed; }))
      return;
    Soup_mesh<Kernel> mesh = make_soup_mesh(m_soup);
    const std::vector<std::size_t> components = face_components(mesh);
    std::vector<std::size_t> kept(components.size(), 0), reversed(components.size(), 0);
    for(std::size_t t = 0; t < components.size(); ++t)
      ++(m_soup.triangles[t].is_reversed ? reversed : kept)[components[t]];
    for(std::size_t t = 0; t < components.size(); ++t)
      if(reversed[components[t]] > kept[components[t]])
        m_soup.reverse(t);
  }

  void record_edges()
  {
    std::sort(m_edges.begin(), m_edges.end());
    m_record.add(Repair::EDGES_CUT,
                 static_cast<std::size_t>(std::unique(m_edges.begin(), m_edges.end()) - m_edges.begin()));
    std::vector<std::size_t> reversed;
    for(const Soup_triangle& triangle : m_soup.triangles)
      if(triangle.is_reversed)
        reversed.push_back(triangle.polygon);
    std::sort(reversed.begin(), reversed.end());
    m_record.add(Repair::POLYGONS_REVERSED,
                 static_cast<std::size_t>(std::unique(reversed.begin(), reversed.end()) - reversed.begin()));
  }

  Soup& m_soup;
  Repair_record& m_record;
  std::vector<Edge> m_edges; // edges that were cut, by the points of the input
  bool m_is_manifold = false;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SOUP_REPAIR_H
