// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The shortest paths of several homotopy classes: against closed forms on flat surfaces, around obstacles, and what the
// report says where there is no closed form.

#define BOOST_TEST_MODULE shortest_paths_by_class

#include "generated_curves.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/Loop_basis.h>
#include <CGAL/Flip_geodesics/Slit_mesh.h>
#include <CGAL/Flip_geodesics/Weighted_metric.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/shortest_paths_by_class.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Filtered = CGAL::Face_filtered_graph<Surface>;
using Slit = FG::Slit_mesh<Filtered>;
using Vertex = Surface::Vertex_index;
using Halfedge = Slit::Halfedge;
using Curve = std::vector<FG::Curve_point<Slit, Point>>;
using Report = FG::Paths_by_class_report<Slit>;

// Are the ends of an edge two points between which there is a wall?
using Is_wall = bool (*)(const Point&, const Point&);

// A surface without the faces that are obstacles, and slit along walls.
struct World
{
  struct Wall_map
  {
    using key_type = Surface::Edge_index;
    using value_type = bool;
    using reference = bool;
    using category = boost::readable_property_map_tag;
    const Surface* mesh;
    Is_wall is_wall;
    friend bool get(const Wall_map& map, Surface::Edge_index e)
    {
      const auto h = map.mesh->halfedge(e);
      return map.is_wall(map.mesh->point(map.mesh->source(h)), map.mesh->point(map.mesh->target(h)));
    }
  };

  template <class IsObstacle>
  World(
      const Mesh_soup& soup, const IsObstacle& is_obstacle,
      Is_wall is_wall = [](const Point&, const Point&) { return false; })
    : mesh(to_mesh<Surface>(soup))
    , filtered(mesh, free_faces(is_obstacle))
    , slit(filtered, Wall_map{&mesh, is_wall})
  {
  }

  explicit World(const Mesh_soup& soup)
    : World(soup, [](std::size_t) { return false; })
  {
  }

  template <class IsObstacle>
  std::vector<Surface::Face_index> free_faces(const IsObstacle& is_obstacle) const
  {
    std::vector<Surface::Face_index> result;
    for(Surface::Face_index f : mesh.faces())
      if(!is_obstacle(static_cast<std::size_t>(f)))
        result.push_back(f);
    return result;
  }

  template <class... Options>
  auto paths(int source, int target, std::size_t number, std::vector<Curve>& out, const Options&... options) const
  {
    return FG::shortest_paths_by_class(slit, Vertex(static_cast<unsigned>(source)),
                                       Vertex(static_cast<unsigned>(target)), number, std::back_inserter(out),
                                       options...);
  }

  Surface mesh;
  Filtered filtered;
  Slit slit;
};

// The edges along which a curve can be moved with its ends held.
std::vector<Halfedge> edges_along(const Slit& mesh, const Curve& curve, Slit::Vertex start)
{
  std::vector<Halfedge> result;
  Slit::Vertex u = start;
  const auto move_to = [&](Slit::Vertex v) {
    if(u == v)
      return;
    const auto [h, is_edge] = halfedge(u, v, mesh);
    BOOST_TEST_REQUIRE(is_edge);
    result.push_back(h);
    u = v;
  };
  for(const auto& p : curve) {
    if(p.halfedge != Halfedge()) {
      move_to(source(p.halfedge, mesh));
      continue;
    }
    Halfedge corner = halfedge(p.location.first, mesh);
    Slit::Vertex v = source(corner, mesh);
    for(double weight : p.location.second) {
      if(weight == 1)
        v = source(corner, mesh);
      corner = next(corner, mesh);
    }
    move_to(v);
  }
  return result;
}

// Each curve has the ends and the length that are told, runs in its class, and no two run in one class.
void check_classes(const World& world, int source, int target, const std::vector<Curve>& curves, const Report& report)
{
  using Triangulation = FG::Intrinsic_triangulation<Slit>;
  const Triangulation triangulation(world.slit);
  const FG::Loop_basis<Triangulation> basis(triangulation);
  const Vertex s(static_cast<unsigned>(source)), t(static_cast<unsigned>(target));
  std::vector<std::vector<Halfedge>> chains;
  const auto is_one_class = [&](const std::vector<Halfedge>& a, const std::vector<Halfedge>& b) {
    std::vector<FG::Input_halfedge_index> loop;
    for(Halfedge h : a)
      loop.push_back(triangulation.input().index(h));
    for(std::size_t i = b.size(); i-- > 0;)
      loop.push_back(triangulation.input().index(opposite(b[i], world.slit)));
    return basis.is_contractible(loop);
  };
  BOOST_TEST_REQUIRE(curves.size() == report.paths.size());
  BOOST_TEST_REQUIRE(curves.size() == report.classes.size());
  for(std::size_t i = 0; i < curves.size(); ++i) {
    BOOST_TEST(curves[i].front().point == world.mesh.point(s));
    BOOST_TEST(curves[i].back().point == world.mesh.point(t));
    double length = 0;
    for(std::size_t j = 1; j < curves[i].size(); ++j)
      length += std::sqrt(CGAL::squared_distance(curves[i][j - 1].point, curves[i][j].point));
    BOOST_TEST(std::abs(length - report.paths[i].length) < 1e-9 * length);
    BOOST_TEST(report.classes[i].length == report.paths[i].length);
    BOOST_TEST(report.paths[i].length <= report.classes[i].edge_length * (1 + 1e-12));
    BOOST_TEST((i == 0 || report.paths[i - 1].length <= report.paths[i].length));
    BOOST_TEST(is_one_class(edges_along(world.slit, curves[i], s), report.classes[i].edge_path));
    chains.push_back(report.classes[i].edge_path);
  }
  for(const auto& other : report.left_out)
    chains.push_back(other.edge_path);
  for(std::size_t i = 0; i < chains.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      BOOST_TEST(!is_one_class(chains[i], chains[j]));
}

void check_lengths(const Report& report, const std::vector<double>& expected)
{
  BOOST_TEST(report.is_confirmed());
  BOOST_TEST((report.status == FG::Class_search_status::FOUND));
  BOOST_TEST_REQUIRE(report.paths.size() <= expected.size());
  for(std::size_t i = 0; i < report.paths.size(); ++i) {
    BOOST_TEST(std::abs(report.paths[i].length - expected[i]) < 1e-11 * expected[i]);
    BOOST_TEST((report.paths[i].shortening.curves[0].verdict == FG::Certificate_verdict::PROVEN));
  }
}

struct Place
{
  double x, y;
};

double distance(Place a, Place b) { return std::hypot(b.x - a.x, b.y - a.y); }

// A rectangle in the plane, and taut strings around it.
class Rectangle
{
public:
  Rectangle(double x0, double x1, double y0, double y1)
    : m_corner{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}
    , m_center{(x0 + x1) / 2, (y0 + y1) / 2}
  {
  }

  // Does a segment miss the inside?
  bool misses(Place a, Place b) const
  {
    double from = 0, to = 1;
    const auto clip = [&](double start, double step, double low, double high) {
      if(step == 0)
        return start > low && start < high;
      const double u = (low - start) / step, v = (high - start) / step;
      from = (std::max)(from, (std::min)(u, v));
      to = (std::min)(to, (std::max)(u, v));
      return true;
    };
    const bool is_between =
        clip(a.x, b.x - a.x, m_corner[0].x, m_corner[2].x) && clip(a.y, b.y - a.y, m_corner[0].y, m_corner[2].y);
    return !is_between || to - from < 1e-9;
  }

  // The lengths of the shortest paths between two places that go around different numbers of times, the shortest first.
  std::vector<double> lengths(Place s, Place t) const
  {
    std::map<int, double> shortest;
    const auto offer = [&](double turn, double length) {
      const int turns = static_cast<int>(std::lround((turn - turn_between(s, t)) / (2 * pi)));
      const auto place = shortest.emplace(turns, length).first;
      place->second = (std::min)(place->second, length);
    };
    if(misses(s, t))
      offer(turn_between(s, t), distance(s, t));
    for(int first = 0; first < 4; ++first)
      for(int step : {1, 3}) {
        double length = distance(s, m_corner[first]), turn = turn_between(s, m_corner[first]);
        for(int i = 0, c = first; i < 40 && misses(s, m_corner[first]); ++i, c = (c + step) % 4) {
          if(misses(m_corner[c], t))
            offer(turn + turn_between(m_corner[c], t), length + distance(m_corner[c], t));
          const Place next = m_corner[(c + step) % 4];
          length += distance(m_corner[c], next);
          turn += turn_between(m_corner[c], next);
        }
      }
    std::vector<double> result;
    for(const auto& entry : shortest)
      result.push_back(entry.second);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  double turn_between(Place a, Place b) const
  {
    return std::remainder(
        std::atan2(b.y - m_center.y, b.x - m_center.x) - std::atan2(a.y - m_center.y, a.x - m_center.x), 2 * pi);
  }

  Place m_corner[4];
  Place m_center;
};

} // namespace

// Classes are lattice points.
BOOST_AUTO_TEST_CASE(lattice_on_a_flat_torus)
{
  const int n = 12, m = 10;
  const double a = 12, b = 10;
  const Surface mesh = to_mesh<Surface>(torus(n, m, 3, 1));
  std::map<Surface::Edge_index, double> lengths = edge_lengths(mesh, Flat_torus_metric{n, m, a, b});
  const auto map = boost::make_assoc_property_map(lengths);
  const FG::Edge_length_metric<Surface, std::decay_t<decltype(map)>> metric(mesh, map);
  for(const auto& [i, j] : {std::pair(4, 3), std::pair(1, 5), std::pair(6, 0)}) {
    std::vector<double> expected;
    for(int p = -5; p <= 5; ++p)
      for(int q = -5; q <= 5; ++q)
        expected.push_back(std::hypot(i + p * a, j + q * b));
    std::sort(expected.begin(), expected.end());
    std::vector<std::vector<FG::Curve_place<Surface>>> out;
    const auto result = FG::shortest_paths_by_class(mesh, Vertex(0), Vertex(static_cast<unsigned>(i + n * j)), 10,
                                                    std::back_inserter(out), FG::with_metric(metric));
    BOOST_TEST_REQUIRE(result.number_of_paths() == 10u);
    BOOST_TEST(out.size() == 10u);
    BOOST_TEST(result.report.is_confirmed());
    BOOST_TEST((result.status() == FG::Class_search_status::FOUND));
    for(std::size_t c = 0; c < 10; ++c)
      BOOST_TEST(std::abs(result.length(c) - expected[c]) < 1e-12 * expected[c]);
    // No class between them is forgotten.
    for(const auto& other : result.report.left_out)
      BOOST_TEST(other.lower_bound >= result.length(9) * (1 - 1e-12));
    BOOST_TEST(result.report.lower_bound >= result.length(9));
  }
}

BOOST_AUTO_TEST_CASE(windings_on_a_cylinder)
{
  const int n = 9, m = 6;
  const double side = polygon_side(n, 1), height = 5;
  const World world(cylinder(n, m, 1, height));
  for(const auto& [i, k] : {std::pair(2, 4), std::pair(4, 2), std::pair(3, 0)}) {
    std::vector<double> expected;
    for(int w = -8; w <= 8; ++w)
      expected.push_back(std::hypot((i + w * n) * side, height * k / m));
    std::sort(expected.begin(), expected.end());
    const int source = n, target = i + n * (1 + k);
    std::vector<Curve> out;
    const auto result = world.paths(source, target, 10, out);
    check_lengths(result.report, expected);
    check_classes(world, source, target, out, result.report);
  }
}

// Strings around a block that stands in the way, which is no part of another mesh.
BOOST_AUTO_TEST_CASE(around_an_obstacle)
{
  const int n = 12, m = 9;
  const auto is_obstacle = [](std::size_t f) {
    const std::size_t cell = f / 2, i = cell % 12, j = cell / 12;
    return i >= 4 && i < 8 && j >= 3 && j < 5;
  };
  const World world(flat_grid(n, m, Diagonal_rule::ALTERNATING), is_obstacle);
  const Rectangle block(4, 8, 3, 5);
  struct Ends
  {
    int sx, sy, tx, ty;
  };
  for(const Ends& e : {Ends{1, 4, 11, 4}, Ends{2, 1, 9, 8}, Ends{1, 1, 2, 8}, Ends{4, 3, 8, 5}, Ends{5, 1, 6, 1}}) {
    const int source = grid_vertex(n, e.sx, e.sy), target = grid_vertex(n, e.tx, e.ty);
    std::vector<Curve> out;
    const auto result = world.paths(source, target, 6, out);
    check_lengths(result.report, block.lengths({double(e.sx), double(e.sy)}, {double(e.tx), double(e.ty)}));
    check_classes(world, source, target, out, result.report);
  }
}

// Where edge paths are much longer than geodesics, what is far away is not searched.
BOOST_AUTO_TEST_CASE(only_what_is_near_is_visited)
{
  const int n = 60;
  const World world(flat_grid(n, n, Diagonal_rule::RISING), [](std::size_t f) { return f / 2 == 30 * 60 + 30; });
  std::vector<Curve> out;
  const auto result = world.paths(grid_vertex(n, 27, 34), grid_vertex(n, 34, 27), 2, out);
  check_lengths(result.report, Rectangle(30, 31, 30, 31).lengths({27, 34}, {34, 27}));
  BOOST_TEST(result.report.visited < 1000u);
}

// A wall that paths run along, and do not cross; and two that leave a gate.
BOOST_AUTO_TEST_CASE(along_walls)
{
  const int n = 12, m = 9;
  const Mesh_soup grid = flat_grid(n, m, Diagonal_rule::RISING);
  const int source = grid_vertex(n, 1, 4), target = grid_vertex(n, 11, 4);
  const auto nothing = [](std::size_t) { return false; };
  const World wall(grid, nothing, [](const Point& p, const Point& q) {
    return p.x() == 6 && q.x() == 6 && p.y() >= 3 && q.y() >= 3 && p.y() <= 6 && q.y() <= 6;
  });
  BOOST_TEST(num_vertices(wall.slit) == num_vertices(wall.mesh) + 2);
  BOOST_TEST(num_edges(wall.slit) == num_edges(wall.mesh) + 3);
  const Place s = {1, 4}, t = {11, 4}, below = {6, 3}, above = {6, 6};
  const double a = distance(s, below) + distance(below, t), b = distance(s, above) + distance(above, t);
  std::vector<Curve> out;
  const auto around = wall.paths(source, target, 6, out);
  check_lengths(around.report, {a, b, a + 6, b + 6, a + 12, b + 12});
  check_classes(wall, source, target, out, around.report);
  out.clear();
  // From the border to a wall across, with a gap from (6, 1) to (6, 2): a single way.
  const World gate(grid, nothing, [](const Point& p, const Point& q) {
    return p.x() == 6 && q.x() == 6 && ((p.y() <= 1 && q.y() <= 1) || (p.y() >= 2 && q.y() >= 2));
  });
  const auto through = gate.paths(source, target, 2, out);
  BOOST_TEST((through.status() == FG::Class_search_status::NO_MORE_CLASSES));
  BOOST_TEST_REQUIRE(out.size() == 1u);
  const Place post = {6, 2};
  BOOST_TEST(std::abs(through.length(0) - distance(s, post) - distance(post, t)) < 1e-12 * 20);
  // Where walls cross, each sector has a vertex of its own.
  const World cross(grid, nothing, [](const Point& p, const Point& q) {
    return (p.x() == 6 && q.x() == 6) || (p.y() == 4 && q.y() == 4);
  });
  BOOST_TEST(cross.slit.number_of_copies(Vertex(static_cast<unsigned>(grid_vertex(n, 6, 4)))) == 4u);
  BOOST_TEST(cross.slit.number_of_copies(Vertex(static_cast<unsigned>(grid_vertex(n, 6, 0)))) == 2u);
  BOOST_CHECK_THROW(cross.paths(grid_vertex(n, 1, 1), grid_vertex(n, 11, 8), 1, out), FG::Disconnected_endpoints_error);
}

// Of the copies of a vertex in a slit, each has a distance of its own.
BOOST_AUTO_TEST_CASE(distances_around_a_slit)
{
  const int n = 8;
  const World world(
      flat_grid(n, n, Diagonal_rule::RISING), [](std::size_t) { return false; },
      [](const Point& p, const Point& q) { return p.x() == 4 && q.x() == 4 && p.y() <= 6 && q.y() <= 6; });
  std::map<Slit::Vertex, double> distances;
  FG::geodesic_distances(world.slit, Slit::Vertex(Vertex(static_cast<unsigned>(grid_vertex(n, 1, 3)))),
                         boost::make_assoc_property_map(distances));
  BOOST_TEST(distances.size() == num_vertices(world.slit));
  const Vertex wall(static_cast<unsigned>(grid_vertex(n, 4, 3)));
  BOOST_TEST_REQUIRE(world.slit.number_of_copies(wall) == 2u);
  const double a = distances[{wall, 0}], b = distances[{wall, 1}];
  BOOST_TEST(std::abs((std::min)(a, b) - 3) < 1e-12);
  BOOST_TEST(std::abs((std::max)(a, b) - std::hypot(3, 3) - 3) < 1e-12);
}

// The view is a graph whose links fit together, whatever is slit.
BOOST_AUTO_TEST_CASE(links_of_a_slit_mesh)
{
  const World world(
      torus(7, 6, 3, 1), [](std::size_t f) { return f == 11; },
      [](const Point& p, const Point& q) { return p.z() > 0.1 || p.x() + q.y() > 2.5; });
  const auto& mesh = world.slit;
  BOOST_TEST(num_halfedges(mesh) == 2 * num_edges(mesh));
  std::size_t borders = 0;
  for(const Halfedge& h : halfedges(mesh)) {
    BOOST_TEST((opposite(opposite(h, mesh), mesh) == h));
    BOOST_TEST((prev(next(h, mesh), mesh) == h));
    BOOST_TEST((next(prev(h, mesh), mesh) == h));
    BOOST_TEST((target(h, mesh) == source(next(h, mesh), mesh)));
    BOOST_TEST((target(h, mesh) == source(opposite(h, mesh), mesh)));
    BOOST_TEST((edge(h, mesh) == edge(opposite(h, mesh), mesh)));
    BOOST_TEST((face(h, mesh) == face(next(h, mesh), mesh)));
    const auto [g, is_edge] = halfedge(source(h, mesh), target(h, mesh), mesh); // a slit of one edge has two of these
    BOOST_TEST(is_edge);
    BOOST_TEST((source(g, mesh) == source(h, mesh) && target(g, mesh) == target(h, mesh)));
    borders += face(h, mesh) == Surface::null_face() ? 1 : 0;
  }
  BOOST_TEST(borders > 20u);
  for(const Slit::Vertex& v : vertices(mesh))
    BOOST_TEST((target(halfedge(v, mesh), mesh) == v));
}

// A hill between two places: there is one class, and a second one if the summit must not be crossed.
BOOST_AUTO_TEST_CASE(other_side_of_a_bump)
{
  const int n = 16;
  const Mesh_soup hill = mapped(flat_grid(n, n, Diagonal_rule::ALTERNATING), [](const Coordinates& p) {
    return Coordinates{p[0], p[1], 6 * std::exp(-((p[0] - 8) * (p[0] - 8) + (p[1] - 8.3) * (p[1] - 8.3)) / 8)};
  });
  const int source = grid_vertex(n, 2, 8), target = grid_vertex(n, 14, 8);
  const World open(hill);
  std::vector<Curve> one, two;
  const auto alone = open.paths(source, target, 3, one);
  BOOST_TEST((alone.status() == FG::Class_search_status::NO_MORE_CLASSES));
  BOOST_TEST(alone.number_of_paths() == 1u);
  BOOST_TEST(alone.report.is_confirmed());
  BOOST_TEST(alone.report.lower_bound == std::numeric_limits<double>::infinity());
  check_classes(open, source, target, one, alone.report);
  const World closed(hill, [](std::size_t f) { return f / 2 == 8 * 16 + 8; });
  const auto both = closed.paths(source, target, 2, two);
  BOOST_TEST((both.status() == FG::Class_search_status::FOUND));
  BOOST_TEST(both.report.is_confirmed());
  check_classes(closed, source, target, two, both.report);
  BOOST_TEST(std::abs(both.length(0) - alone.length(0)) < 1e-11 * alone.length(0));
  BOOST_TEST(both.length(1) > both.length(0));
  const auto passes = [](const Curve& curve, double sign) {
    return std::any_of(curve.begin(), curve.end(),
                       [&](const auto& p) { return std::abs(p.point.x() - 8) < 1 && sign * (p.point.y() - 8.3) > 1; });
  };
  for(double sign : {-1., 1.})
    BOOST_TEST(passes(two[0], sign) != passes(two[1], sign));
}

// Groups that are free, of genus 1, and others; paths that cross themselves are among these.
BOOST_AUTO_TEST_CASE(classes_on_surfaces_with_handles)
{
  std::vector<Curve> out;
  const World donut(torus(9, 7, 3, 1));
  const auto on_donut = donut.paths(0, 31, 10, out);
  BOOST_TEST(on_donut.number_of_paths() == 10u);
  BOOST_TEST(on_donut.report.is_confirmed());
  check_classes(donut, 0, 31, out, on_donut.report);
  const Mesh_soup plate = genus_3_plate(1);
  const int last = static_cast<int>(plate.points.size()) - 1;
  for(bool has_border : {false, true}) {
    out.clear();
    const World world(plate, [&](std::size_t f) { return has_border && f == 40; });
    const auto result = world.paths(0, last, 10, out);
    BOOST_TEST(result.number_of_paths() == 10u);
    BOOST_TEST(result.report.is_confirmed());
    check_classes(world, 0, last, out, result.report);
  }
}

// What is left out by length is what is found if more classes are asked for.
BOOST_AUTO_TEST_CASE(fewer_are_the_first_of_more)
{
  const World world(genus_3_plate(1));
  std::vector<Curve> few, many;
  const auto three = world.paths(3, 50, 3, few), nine = world.paths(3, 50, 9, many);
  for(std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(std::abs(three.length(i) - nine.length(i)) < 1e-12 * nine.length(i));
  for(const auto& other : three.report.left_out)
    BOOST_TEST((std::min)(other.length, other.lower_bound) >= three.length(2) * (1 - 1e-12));
}

// Fewer paths, of which nothing is said that does not hold.
BOOST_AUTO_TEST_CASE(limit_of_the_covering)
{
  const World world(cylinder(9, 6, 1, 5));
  std::vector<Curve> all;
  const auto truth = world.paths(9, 40, 10, all);
  bool some_are_confirmed = false, some_are_not = false;
  for(std::size_t limit : {0, 1, 20, 60, 100, 150, 200, 300}) {
    std::vector<Curve> out;
    const auto result = world.paths(9, 40, 10, out, FG::Covering_limit(limit));
    BOOST_TEST((result.status() == FG::Class_search_status::COVERING_LIMIT));
    BOOST_TEST(result.number_of_paths() < 10u);
    BOOST_TEST((limit > 1 || out.empty()));
    check_classes(world, 9, 40, out, result.report);
    (result.report.is_confirmed() ? some_are_confirmed : some_are_not) = true;
    for(std::size_t i = 0; i < out.size(); ++i) {
      BOOST_TEST(result.report.paths[i].lower_bound <= result.length(i) * (1 + 1e-12));
      if(result.report.is_confirmed())
        BOOST_TEST(std::abs(result.length(i) - truth.length(i)) < 1e-12 * truth.length(i));
    }
  }
  BOOST_TEST(some_are_confirmed);
  BOOST_TEST(some_are_not);
}

// Edge paths are several times as long as geodesics, and in far more classes up to that length than are needed.
BOOST_AUTO_TEST_CASE(rough_terrain)
{
  const int n = 12;
  std::mt19937 random(1);
  const auto height = [&] { return 20 * (static_cast<double>(random()) / 2147483648. - 1); };
  const Mesh_soup terrain = mapped(flat_grid(n, n, Diagonal_rule::RISING), [&](const Coordinates& p) {
    return Coordinates{p[0], p[1], height()};
  });
  const World world(terrain, [](std::size_t f) {
    return f == 2 * (3 + 12 * 3) || f == 2 * (6 + 12 * 8) + 1 || f == 2 * (9 + 12 * 4);
  });
  for(std::size_t number : {1, 3}) {
    std::vector<Curve> out;
    const auto result = world.paths(0, grid_vertex(n, n, n), number, out, FG::Covering_limit(20000));
    BOOST_TEST((result.status() == FG::Class_search_status::FOUND));
    BOOST_TEST(result.report.is_confirmed());
    BOOST_TEST(result.number_of_paths() == number);
    BOOST_TEST(result.report.visited < 8000u);
    BOOST_TEST(result.report.lower_bound_of_others() >= result.length(number - 1));
    BOOST_TEST(result.report.classes[0].edge_length > 1.5 * result.length(0));
    check_classes(world, 0, grid_vertex(n, n, n), out, result.report);
  }
}

// There is no end of classes of length zero.
BOOST_AUTO_TEST_CASE(edges_of_length_zero)
{
  std::vector<Curve> out;
  const World point(mapped(flat_grid(4, 4, Diagonal_rule::RISING),
                           [](const Coordinates&) {
                             return Coordinates{1, 2, 3};
                           }),
                    [](std::size_t f) { return f == 10; });
  BOOST_CHECK_THROW(point.paths(0, 24, 1, out), FG::Error);
  BOOST_CHECK_THROW(point.paths(0, 24, 5, out), FG::Error);
  // A column of the grid has no width.
  const World folded(mapped(flat_grid(6, 6, Diagonal_rule::RISING),
                            [](const Coordinates& p) {
                              return Coordinates{p[0] > 3.5 ? p[0] - 1 : p[0], p[1], p[2]};
                            }),
                     [](std::size_t f) { return f == 28; });
  const auto result = folded.paths(grid_vertex(6, 0, 3), grid_vertex(6, 6, 3), 2, out);
  BOOST_TEST(result.number_of_paths() == 2u);
  BOOST_TEST(std::abs(result.length(0) - 5) < 1e-12);
  BOOST_CHECK_EXCEPTION(folded.paths(grid_vertex(6, 3, 3), grid_vertex(6, 4, 3), 1, out), FG::Invalid_curve_error,
                        [](const FG::Invalid_curve_error& error) {
                          return std::string(error.what()).find("edges of length zero") != std::string::npos;
                        });
}

// Weights that are none, and such that no face has a shape.
BOOST_AUTO_TEST_CASE(bad_weights)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(4, 4, Diagonal_rule::RISING));
  using Points = Surface::Property_map<Vertex, Point>;
  const FG::Embedded_metric<Surface, Points> lengths(mesh.points());
  std::map<Vertex, double> weights;
  for(Vertex v : mesh.vertices())
    weights[v] = 1;
  const auto find = [&] {
    const FG::Weighted_metric metric(mesh, lengths, boost::make_assoc_property_map(weights));
    std::vector<std::vector<Point>> out;
    return FG::shortest_paths_by_class(mesh, Vertex(0), Vertex(24), 2, std::back_inserter(out),
                                       FG::with_metric(metric));
  };
  BOOST_TEST(std::abs(find().length(0) - std::sqrt(32.)) < 1e-12);
  using Metric = FG::Weighted_metric<FG::Embedded_metric<Surface, Points>>;
  using Traits = FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>;
  const FG::Intrinsic_triangulation<Surface, Traits, Metric> triangulation(
      mesh, Metric(mesh, lengths, boost::make_assoc_property_map(weights)));
  BOOST_TEST(triangulation.number_of_vertices() == 25);
  const double infinity = std::numeric_limits<double>::infinity();
  for(double bad : {0., -1., infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    weights[Vertex(12)] = bad;
    BOOST_CHECK_THROW(find(), FG::Invalid_parameter_error);
  }
  weights[Vertex(12)] = 100;
  BOOST_CHECK_THROW(find(), FG::Degenerate_face_error);
}

// What obstacles can do to the ends, and to what is between them.
BOOST_AUTO_TEST_CASE(ends_and_obstacles)
{
  const int n = 6;
  std::vector<Curve> out;
  // All faces about the target are obstacles.
  const World inside(flat_grid(n, n, Diagonal_rule::RISING), [](std::size_t f) {
    const std::size_t i = (f / 2) % 6, j = (f / 2) / 6;
    return (i == 2 || i == 3) && (j == 2 || j == 3);
  });
  const int middle = grid_vertex(n, 3, 3);
  BOOST_CHECK_THROW(inside.paths(0, middle, 2, out), FG::Error);
  BOOST_CHECK_THROW(inside.paths(middle, 0, 2, out), FG::Error);
  // A closed slit separates what is in it, and its vertices are on either side.
  const World ring(
      flat_grid(n, n, Diagonal_rule::RISING), [](std::size_t) { return false; },
      [](const Point& p, const Point& q) {
        const auto is_on = [](const Point& r) { return (std::max)(std::abs(r.x() - 3), std::abs(r.y() - 3)) == 1; };
        return is_on(p) && is_on(q) && (p.x() == q.x() || p.y() == q.y());
      });
  BOOST_CHECK_THROW(ring.paths(0, middle, 2, out), FG::Disconnected_endpoints_error);
  BOOST_TEST(ring.paths(0, grid_vertex(n, 6, 6), 2, out).number_of_paths() == 2u);
}

// Many holes and many classes; the limit bounds what is visited.
BOOST_AUTO_TEST_CASE(many_holes)
{
  const int n = 18;
  const World world(flat_grid(n, n, Diagonal_rule::ALTERNATING), [](std::size_t f) {
    const std::size_t i = (f / 2) % 18, j = (f / 2) / 18;
    return i % 3 == 1 && j % 3 == 1;
  });
  std::vector<Curve> out;
  const auto result = world.paths(0, grid_vertex(n, n, n), 40, out);
  BOOST_TEST((result.status() == FG::Class_search_status::FOUND));
  BOOST_TEST(result.number_of_paths() == 40u);
  BOOST_TEST(result.report.is_confirmed());
  out.clear();
  const auto few = world.paths(0, grid_vertex(n, n, n), 200, out, FG::Covering_limit(2000));
  BOOST_TEST((few.status() == FG::Class_search_status::COVERING_LIMIT));
  BOOST_TEST(few.report.visited < 2200u);
}

// In a plane with obstacles each class has one taut path, along segments between corners of obstacles: all of them are
// enumerated by length. Obstacles are faces without their corners in common; triangles of corners.
class Taut_paths
{
public:
  Taut_paths(const Point& source, const Point& target, const std::vector<std::array<Point, 3>>& obstacles)
    : m_nodes({source, target})
  {
    for(const auto& corners : obstacles)
      m_nodes.insert(m_nodes.end(), corners.begin(), corners.end());
  }

  // The lengths of the shortest ones.
  std::vector<double> operator()(std::size_t number) const
  {
    std::vector<double> result;
    std::multimap<double, std::vector<std::size_t>> open = {{distance(0, 1), {0}}}; // by the least length
    while(result.size() < number && !open.empty()) {
      const std::vector<std::size_t> path = open.begin()->second;
      const double length = open.begin()->first - distance(path.back(), 1);
      open.erase(open.begin());
      if(path.back() == 1) {
        result.push_back(length);
        continue;
      }
      for(std::size_t next = 1; next < m_nodes.size(); ++next)
        if(next != path.back() && is_visible(path.back(), next) &&
           (path.size() == 1 || is_taut(path[path.size() - 2], path.back(), next)))
        {
          std::vector<std::size_t> longer = path;
          longer.push_back(next);
          open.emplace(length + distance(path.back(), next) + distance(next, 1), longer);
        }
    }
    return result;
  }

private:
  double distance(std::size_t i, std::size_t k) const
  {
    return std::hypot(m_nodes[i].x() - m_nodes[k].x(), m_nodes[i].y() - m_nodes[k].y());
  }

  double turn(std::size_t i, std::size_t k, std::size_t l) const
  {
    const Point &p = m_nodes[i], &q = m_nodes[k], &r = m_nodes[l];
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  }

  bool is_visible(std::size_t a, std::size_t b) const
  {
    for(std::size_t first = 2; first < m_nodes.size(); first += 3)
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t c = first + i, d = first + (i + 1) % 3;
        if(turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0 && a != c && a != d && b != c &&
           b != d)
          return false;
      }
    return true;
  }

  // Around the corner, with its triangle in the smaller angle.
  bool is_taut(std::size_t before, std::size_t corner, std::size_t after) const
  {
    const std::size_t first = corner - (corner - 2) % 3;
    const double side = turn(before, corner, after);
    for(std::size_t other = first; other < first + 3; ++other)
      if(other != corner && other != before && other != after &&
         (turn(before, corner, other) * side <= 0 || turn(corner, after, other) * side <= 0))
        return false;
    return side != 0;
  }

  std::vector<Point> m_nodes;
};

BOOST_AUTO_TEST_CASE(all_taut_paths_around_obstacles)
{
  constexpr int n = 9;
  constexpr std::size_t number = 6;
  std::mt19937 random(3);
  for(unsigned seed = 0; seed < 12; ++seed) {
    const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RANDOM, 0.24, seed);
    std::set<std::size_t> obstacles;
    std::set<int> corners;
    std::vector<std::array<Point, 3>> triangles;
    while(obstacles.size() < 1 + seed % 3) {
      const std::size_t f = random() % soup.triangles.size();
      std::array<Point, 3> points;
      bool is_free = true;
      for(std::size_t i = 0; i < 3; ++i) {
        const int v = soup.triangles[f][i];
        const auto& p = soup.points[static_cast<std::size_t>(v)];
        points[i] = Point(p[0], p[1], p[2]);
        is_free = is_free && corners.count(v) == 0 && p[0] > 0 && p[0] < n && p[1] > 0 && p[1] < n;
      }
      if(!is_free)
        continue;
      obstacles.insert(f);
      corners.insert(soup.triangles[f].begin(), soup.triangles[f].end());
      triangles.push_back(points);
    }
    const World world(soup, [&](std::size_t f) { return obstacles.count(f) != 0; });
    for(int i = 0; i < 3; ++i) {
      const int source = static_cast<int>(random() % soup.points.size()),
                target = static_cast<int>(random() % soup.points.size());
      if(source == target || corners.count(source) != 0 || corners.count(target) != 0)
        continue;
      const std::vector<double> lengths =
          Taut_paths(world.mesh.point(Vertex(static_cast<unsigned>(source))),
                     world.mesh.point(Vertex(static_cast<unsigned>(target))), triangles)(number + 1);
      std::vector<Curve> curves;
      const auto found = world.paths(source, target, number, curves);
      BOOST_TEST(found.report.is_confirmed());
      BOOST_TEST_REQUIRE(found.number_of_paths() == number);
      for(std::size_t k = 0; k < number; ++k)
        BOOST_TEST(std::abs(found.length(k) - lengths[k]) < 1e-12 * lengths[k]);
      BOOST_TEST(found.report.lower_bound_of_others() < lengths[number] * (1 + 1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  std::vector<Curve> out;
  const World world(flat_grid(4, 4, Diagonal_rule::RISING));
  BOOST_CHECK_THROW(world.paths(3, 3, 2, out), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(world.paths(3, 300, 2, out), FG::Vertex_out_of_range_error);
  const World apart(flat_grid(4, 4, Diagonal_rule::RISING), [](std::size_t f) { return (f / 2) % 4 == 1; });
  BOOST_CHECK_THROW(apart.paths(0, 4, 2, out), FG::Disconnected_endpoints_error);
  const World touching(flat_grid(4, 4, Diagonal_rule::RISING), [](std::size_t f) { return f / 2 == 5 || f / 2 == 10; });
  BOOST_CHECK_THROW(touching.paths(0, 4, 2, out), FG::Invalid_mesh_error);
  BOOST_TEST(out.empty());
}
