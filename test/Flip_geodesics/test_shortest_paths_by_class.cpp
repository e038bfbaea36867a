// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The shortest paths of several homotopy classes: against closed forms on flat surfaces, around obstacles, and what the
// report says where there is no closed form.

#define BOOST_TEST_MODULE shortest_paths_by_class

#include "test_shortest_paths_by_class/world.h"

#include <CGAL/Flip_geodesics/internal/topology/Class_paths.h>
#include <CGAL/Flip_geodesics/internal/topology/Covering_surface.h>

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
#include <tuple>
#include <type_traits>
#include <vector>

using namespace ways_test;

namespace {

// The lengths of a lattice of parallelograms on `torus(n, m, ...)`.
struct Skewed_torus_metric
{
  double length(int i, int j) const { return scale * std::hypot(i + shear * j, height * j); }

  double operator()(int u, int v) const
  {
    const auto step = [](int from, int to, int size) {
      const int forward = (to - from + size) % size;
      return forward <= size / 2 ? forward : forward - size;
    };
    return length(step(u % n, v % n, n), step(u / n, v / n, m));
  }

  // From vertex 0 to that of cell (i, j).
  double distance(int i, int j) const
  {
    double least = std::numeric_limits<double>::infinity();
    for(int p = -100; p <= 100; ++p)
      for(int q = -100; q <= 100; ++q)
        least = std::min(least, length(i + p * n, j + q * m));
    return least;
  }

  int n, m;
  double shear, height, scale;
};

} // namespace

// On needles, bounds within 1 % do not single a class out; the search is confined all the same. What it visits does not
// depend on the scale.
BOOST_AUTO_TEST_CASE(needles_of_a_skewed_torus)
{
  const int n = 8, m = 4, i = 5, j = 2;
  const Surface mesh = to_mesh<Surface>(torus(n, m, 3, 1));
  for(const auto& [shear, height] : {std::pair(3.3, 0.3), std::pair(5.3, 0.1), std::pair(17.3, 0.1)}) {
    double length = 0;
    std::size_t visited = 0;
    for(double scale : {1.0, 0x1p-110, 0x1p80}) {
      const Skewed_torus_metric flat = {n, m, shear, height, scale};
      std::map<Surface::Edge_index, double> lengths = edge_lengths(mesh, flat);
      const auto map = boost::make_assoc_property_map(lengths);
      const FG::Edge_length_metric<Surface, std::decay_t<decltype(map)>> metric(mesh, map);
      std::vector<std::vector<FG::Curve_place<Surface>>> out;
      const auto result = FG::shortest_paths_by_class(mesh, Vertex(0), Vertex(static_cast<unsigned>(i + n * j)), 1,
                                                      std::back_inserter(out), CGAL::parameters::metric(metric));
      BOOST_TEST_REQUIRE(result.number_of_curves() == 1u);
      BOOST_TEST(result.report.is_confirmed());
      BOOST_TEST(result.report.visited <= 1000u);
      BOOST_TEST(std::abs(result.length(0) - flat.distance(i, j)) <= 1e-11 * flat.distance(i, j));
      if(scale == 1) {
        length = result.length(0);
        visited = result.report.visited;
      }
      BOOST_TEST(result.length(0) == length * scale);
      BOOST_TEST(result.report.visited == visited);
    }
  }
}

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
                                                    std::back_inserter(out), CGAL::parameters::metric(metric));
    BOOST_TEST_REQUIRE(result.number_of_curves() == 10u);
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
  const World portal(grid, nothing, [](const Point& p, const Point& q) {
    return p.x() == 6 && q.x() == 6 && ((p.y() <= 1 && q.y() <= 1) || (p.y() >= 2 && q.y() >= 2));
  });
  const auto through = portal.paths(source, target, 2, out);
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
    BOOST_TEST((halfedge(edge(h, mesh), mesh) == h));
    BOOST_TEST((face(h, mesh) == face(next(h, mesh), mesh)));
    const auto [g, is_edge] = halfedge(source(h, mesh), target(h, mesh), mesh); // a slit of one edge has two of these
    BOOST_TEST(is_edge);
    BOOST_TEST((source(g, mesh) == source(h, mesh) && target(g, mesh) == target(h, mesh)));
    borders += face(h, mesh) == Surface::null_face() ? 1 : 0;
  }
  BOOST_TEST(borders > 20u);
  BOOST_TEST(FG::internal::Indexed_mesh<Slit>(mesh).number_of_faces() == static_cast<FG::Index>(num_faces(mesh)));
  boost::graph_traits<Slit>::vertex_iterator first, last; // algorithms on graphs take ranges apart
  std::tie(first, last) = vertices(mesh);
  BOOST_TEST(static_cast<std::size_t>(std::distance(first, last)) == num_vertices(mesh));
  boost::graph_traits<Slit>::edge_iterator first_edge, last_edge;
  std::tie(first_edge, last_edge) = edges(mesh);
  BOOST_TEST(static_cast<std::size_t>(std::distance(first_edge, last_edge)) == num_edges(mesh));
  boost::graph_traits<Slit>::halfedge_iterator first_halfedge, last_halfedge;
  std::tie(first_halfedge, last_halfedge) = halfedges(mesh);
  BOOST_TEST(static_cast<std::size_t>(std::distance(first_halfedge, last_halfedge)) == num_halfedges(mesh));
  BOOST_TEST(CGAL::is_valid_halfedge_graph(mesh));
  BOOST_TEST(CGAL::is_valid_face_graph(mesh));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
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
  BOOST_TEST(alone.number_of_curves() == 1u);
  BOOST_TEST(alone.report.is_confirmed());
  BOOST_TEST(alone.report.lower_bound == std::numeric_limits<double>::infinity());
  std::vector<Curve> only;
  BOOST_TEST((open.paths(source, target, 1, only).status() == FG::Class_search_status::FOUND));
  check_classes(open, source, target, one, alone.report);
  for(int size : {1, 2, 3}) { // all is visited on the way to the one class
    const World small(flat_grid(size, size, Diagonal_rule::RISING));
    const auto only = small.paths(0, grid_vertex(size, size, size), 1, one);
    BOOST_TEST((only.status() == FG::Class_search_status::FOUND));
    BOOST_TEST(only.report.is_confirmed());
  }
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
  BOOST_TEST(on_donut.number_of_curves() == 10u);
  BOOST_TEST(on_donut.report.is_confirmed());
  check_classes(donut, 0, 31, out, on_donut.report);
  const Mesh_soup plate = genus_3_plate(1);
  const int last = static_cast<int>(plate.points.size()) - 1;
  for(bool has_border : {false, true}) {
    out.clear();
    const World world(plate, [&](std::size_t f) { return has_border && f == 40; });
    const auto result = world.paths(0, last, 10, out);
    BOOST_TEST(result.number_of_curves() == 10u);
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
    const auto result = world.paths(9, 40, 10, out, CGAL::parameters::search_limit(FG::Covering_limit(limit)));
    BOOST_TEST((result.status() == FG::Class_search_status::COVERING_LIMIT));
    BOOST_TEST(result.number_of_curves() < 10u);
    BOOST_TEST((limit > 1 || out.empty()));
    BOOST_TEST(result.report.visited >= out.size()); // each class has an end of its own
    check_classes(world, 9, 40, out, result.report);
    (result.report.is_confirmed() ? some_are_confirmed : some_are_not) = true;
    for(std::size_t i = 0; i < out.size(); ++i) {
      BOOST_TEST(result.report.paths[i].lower_bound <= result.length(i) * (1 + 1e-12));
      BOOST_TEST((result.verdict(i) == result.report.paths[i].verdict));
      if(result.report.is_confirmed())
        BOOST_TEST(std::abs(result.length(i) - truth.length(i)) < 1e-12 * truth.length(i));
    }
  }
  BOOST_TEST(some_are_confirmed);
  BOOST_TEST(some_are_not);
}

// As many paths as were asked for, but not enough of the cover to say that they are the shortest.
BOOST_AUTO_TEST_CASE(all_paths_and_too_little_of_the_covering)
{
  const World world(cylinder(9, 6, 1, 5));
  bool some_are_complete = false, some_are_not = false;
  for(std::size_t number : {1, 2, 3, 4, 5})
    for(std::size_t limit = 20; limit < 400; limit += 10) {
      std::vector<Curve> out;
      const auto result = world.paths(9, 40, number, out, CGAL::parameters::search_limit(FG::Covering_limit(limit)));
      if(out.size() < number)
        continue;
      const bool is_complete = result.report.lower_bound >= result.length(number - 1);
      BOOST_TEST((result.status() ==
                  (is_complete ? FG::Class_search_status::FOUND : FG::Class_search_status::COVERING_LIMIT)));
      (is_complete ? some_are_complete : some_are_not) = true;
    }
  BOOST_TEST(some_are_complete);
  BOOST_TEST(some_are_not);
}

BOOST_AUTO_TEST_CASE(what_a_report_concludes)
{
  Report report;
  BOOST_TEST(!report.is_confirmed()); // there is no path
  report.lower_bound = 5;
  report.paths.resize(2);
  for(auto& path : report.paths) {
    path.length = 2;
    path.verdict = FG::Verdict::WITHIN_ROUNDING;
  }
  BOOST_TEST(report.is_confirmed());
  report.paths[1].verdict = FG::Verdict::UNDECIDED;
  BOOST_TEST(!report.is_confirmed());
  report.paths[1].verdict = FG::Verdict::WITHIN_ROUNDING;
  report.left_out.resize(1);
  report.left_out[0].lower_bound = 1.5; // of a class that may have a shorter path
  BOOST_TEST(report.lower_bound_of_others() == 1.5);
  BOOST_TEST(!report.is_confirmed());
  report.left_out.clear();
  report.lower_bound = 1.5; // of classes not found
  BOOST_TEST(!report.is_confirmed());
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
    const auto result =
        world.paths(0, grid_vertex(n, n, n), number, out, CGAL::parameters::search_limit(FG::Covering_limit(20000)));
    BOOST_TEST((result.status() == FG::Class_search_status::FOUND));
    BOOST_TEST(result.report.is_confirmed());
    BOOST_TEST(result.number_of_curves() == number);
    BOOST_TEST(result.report.visited < (number == 1 ? 400u : 1400u)); // by the lengths of shortest paths in the part
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
  BOOST_TEST(result.number_of_curves() == 2u);
  BOOST_TEST(std::abs(result.length(0) - 5) < 1e-12);
  for(const auto& path : result.report.paths)
    BOOST_TEST(path.shortening.curves[0].are_zero_edges_contracted);
  out.clear();
  const auto in_one_place = folded.paths(grid_vertex(6, 3, 3), grid_vertex(6, 4, 3), 1, out);
  BOOST_TEST(in_one_place.number_of_curves() == 1u);
  BOOST_TEST(in_one_place.length(0) == 0);
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
                                       CGAL::parameters::metric(metric));
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
  BOOST_TEST(ring.paths(0, grid_vertex(n, 6, 6), 2, out).number_of_curves() == 2u);
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
  BOOST_TEST(result.number_of_curves() == 40u);
  BOOST_TEST(result.report.is_confirmed());
  out.clear();
  const auto few =
      world.paths(0, grid_vertex(n, n, n), 200, out, CGAL::parameters::search_limit(FG::Covering_limit(2000)));
  BOOST_TEST((few.status() == FG::Class_search_status::COVERING_LIMIT));
  BOOST_TEST(few.report.visited < 2200u);
}

// From a vertex of a cylinder to itself: a point, and loops around the cylinder, in either direction.
BOOST_AUTO_TEST_CASE(between_ends_in_one_place_are_a_point_and_loops)
{
  const int n = 8;
  const double ring = n * polygon_side(n, 1);
  std::vector<Curve> out;
  const World world(cylinder(n, 4, 1, 2));
  const auto result = world.paths(2 * n, 2 * n, 4, out);
  BOOST_REQUIRE(result.number_of_curves() == 4u);
  for(std::size_t i = 0; i < 4; ++i) {
    const double expected = (i == 0 ? 0 : (i < 3 ? 1 : 2)) * ring;
    BOOST_TEST(std::abs(result.length(i) - expected) < 1e-12);
    BOOST_TEST(result.report.paths[i].is_confirmed());
  }
}

namespace {

using Triangulation = FG::Intrinsic_triangulation<Surface>;
using Search = FG::internal::Covering_search<Triangulation>;

// Calls visit(lift, neighbor, h) for the edges from all settled lifts.
template <class Visit>
void for_each_edge(const Triangulation& triangulation, const Search& search, const Visit& visit)
{
  const auto& input = triangulation.input();
  for(FG::Index lift = 0; lift < static_cast<FG::Index>(search.number_of_lifts()); ++lift) {
    if(!search.is_settled(lift))
      continue;
    const FG::Input_halfedge_index first = input.outgoing(search.vertex(lift));
    FG::Input_halfedge_index h = first;
    for(std::size_t i = 0; i == 0 || h != first; ++i) {
      visit(lift, search.neighbor(lift, i), h);
      h = input.next(FG::internal::twin_index(h));
    }
  }
}

// No edge shortens the path to a settled lift, and the path has the length that is returned. Counts the edges.
int check_shortest_paths(const Triangulation& triangulation, const Search& search)
{
  const auto length = [&](FG::Input_halfedge_index h) {
    return triangulation.metric().length(triangulation.input(), h);
  };
  int edges = 0;
  for_each_edge(triangulation, search, [&](FG::Index lift, FG::Index neighbor, FG::Input_halfedge_index h) {
    if(!search.is_settled(neighbor))
      return;
    BOOST_TEST(search.distance(neighbor) <= (search.distance(lift) + length(h)) * (1 + 1e-14));
    double sum = 0;
    for(FG::Input_halfedge_index g : search.path(neighbor))
      sum += length(g);
    BOOST_TEST(std::abs(sum - search.distance(neighbor)) <= 1e-14 * sum);
    ++edges;
  });
  return edges;
}

} // namespace

// Bellman's conditions in the cover: once lifts were settled by distance, and again once some were not.
BOOST_AUTO_TEST_CASE(paths_to_settled_lifts_are_shortest_edge_paths)
{
  for(unsigned seed : {1u, 2u, 3u}) {
    std::mt19937 random(seed);
    const Surface mesh = to_mesh<Surface>(mapped(torus(9, 7, 3, 1), [&](const Coordinates& p) {
      const auto moved = [&](double x) { return x + static_cast<double>(random() % 1000) / 2000; };
      return Coordinates{moved(p[0]), moved(p[1]), moved(p[2])};
    }));
    const Triangulation triangulation(mesh);
    FG::Default_shortening_visitor visitor;
    FG::internal::Interruption never(visitor);
    Search search(triangulation, FG::Vertex_index(0), FG::Vertex_index(31), never);
    search.run_to_targets(12, 100000);
    BOOST_TEST(search.targets().size() == 12u);
    const int edges = check_shortest_paths(triangulation, search);
    BOOST_TEST(edges > 200);
    std::vector<FG::internal::Open_lift> open;
    for_each_edge(triangulation, search, [&](FG::Index, FG::Index lift, FG::Input_halfedge_index) {
      if(!search.is_settled(lift))
        open.push_back({lift, search.distance(lift), search.distance(lift)});
    });
    // Inconsistent estimates: the outer ring is searched first, all around, and then what shortens its paths.
    const auto estimate = [](FG::Vertex_index v) { return v.idx() < 9 ? 0. : 30.; };
    search.run_from(open, estimate, 100, 100000);
    search.shorten_paths();
    BOOST_TEST(check_shortest_paths(triangulation, search) > edges + 100);
  }
}

// The cover of a flat surface is flat: no straight angle between its edges requires multiprecision or roots.
BOOST_AUTO_TEST_CASE(straight_angles_in_a_flat_covering_are_decided_in_the_plane)
{
  using Covering_surface = FG::internal::Covering_surface<Surface>;
  using Metric = FG::internal::Covering_metric<Surface, Triangulation::Metric>;
  using Covering = FG::Intrinsic_triangulation<Covering_surface, Triangulation::Traits, Metric>;
  const Surface mesh = to_mesh<Surface>(grid_with_hole(5, 5, 2, 3, 2, 3));
  const Triangulation triangulation(mesh);
  FG::Default_shortening_visitor visitor;
  FG::internal::Interruption never(visitor);
  Search search(triangulation, FG::Vertex_index(0), FG::Vertex_index(20), never);
  search.run_to_targets(4, 100000);
  const Covering_surface surface(mesh, triangulation.input(), search);
  BOOST_TEST(surface.number_of_vertices() > 2 * triangulation.number_of_vertices());
  Covering covering(surface, Metric(triangulation.metric()), triangulation.traits());
  Random_numbers random(3);
  for(int i = 0; i < 2000; ++i) {
    const FG::Halfedge_index h(random.below(2 * covering.number_of_edges()));
    if(!covering.is_border(h) && !covering.is_border(covering.twin(h)) && covering.is_flippable(h))
      covering.flip(h);
  }
  const FG::Decision_statistics statistics = covering.decision_statistics();
  BOOST_TEST(statistics.zeros_by_plane > 50u);
  BOOST_TEST(statistics.by_precision + statistics.by_roots == 0u);
}

BOOST_AUTO_TEST_CASE(least_sum_of_windows_is_a_lower_bound_of_paths_through_both)
{
  FG::internal::Ray_window window = {}, other = {};
  window.to = other.to = 4;
  window.x = 1, window.y = 2, window.sigma = 3;
  other.x = 3, other.y = 1, other.sigma = 5;
  const double length = 8 + std::hypot(2, 3), ulp = std::numeric_limits<double>::epsilon(); // straight through (7/3, 0)
  const double exact = FG::internal::least_sum(window, other);
  BOOST_TEST(exact < length); // what rounding can take off
  BOOST_TEST(exact > length * (1 - 100 * ulp));
  window.radius = 0.25; // of what the windows' places are known
  other.radius = 0.5;
  BOOST_TEST(std::abs(FG::internal::least_sum(window, other) - (exact - 0.75)) < 100 * ulp);
  other.from = 3; // past the straight line
  BOOST_TEST(std::abs(FG::internal::least_sum(window, other) - (8 + std::hypot(2, 2) + 1 - 0.75)) < 100 * ulp);
  window.to = 2; // no place in common
  BOOST_TEST(FG::internal::least_sum(window, other) == std::numeric_limits<double>::infinity());
}

namespace {

// A part of a surface with the same vertices, as a part of the cover lies over it.
struct Part
{
  FG::Vertex_index tail(FG::Input_halfedge_index h) const { return part.input().tail(h); }
  const FG::internal::Indexed_mesh<Surface>& below() const { return whole.input(); }
  FG::Input_halfedge_index below(FG::Input_halfedge_index h) const
  {
    for(FG::Input_halfedge_index g :
        FG::internal::descriptors<FG::Input_halfedge_index>(whole.input().number_of_halfedges()))
      if(whole.input().tail(g) == tail(h) &&
         whole.input().tail(FG::internal::twin_index(g)) == tail(FG::internal::twin_index(h)))
        return g;
    return FG::null_index;
  }

  const Triangulation &part, &whole;
};

} // namespace

// An edge (0, 1) of length 10 is lit from two sides, since a triangle (4, 5, 6) is missing between it and the source:
// up to its middle, paths come around one corner, and beyond it around the other one.
BOOST_AUTO_TEST_CASE(bounds_beyond_an_edge_are_by_both_of_its_cones)
{
  for(double x : {4., 6.}) {
    Mesh_soup soup = {
        {{0, 0, 0}, {10, 0, 0}, {-3, -4, 0}, {13, -4, 0}, {-1, -4, 0}, {11, -4, 0}, {5, -6, 0}, {5, -8, 0}},
        {{0, 4, 5}, {0, 5, 1}, {0, 2, 4}, {2, 7, 4}, {7, 6, 4}, {1, 5, 3}, {5, 7, 3}, {7, 5, 6}}};
    const Surface part = to_mesh<Surface>(soup);
    soup.points.push_back({x, 3, 0});
    soup.triangles.push_back({0, 1, 8});
    const Surface whole = to_mesh<Surface>(soup);
    const Triangulation part_triangulation(part), whole_triangulation(whole);
    const FG::Vertex_index source(7), goal(8);
    FG::Default_shortening_visitor visitor;
    FG::internal::Interruption never(visitor);
    FG::internal::Distance_bounds<Triangulation> from_source(part_triangulation, source, FG::Vertex_index(1), 100),
        from_goal(whole_triangulation, goal, source, 100);
    BOOST_TEST(from_source.sweep(never));
    BOOST_TEST(from_goal.sweep(never));
    const Part surface = {part_triangulation, whole_triangulation};
    const auto& input = part_triangulation.input();
    const double length = std::hypot(6, 4) + std::hypot(5, 7);
    int borders = 0;
    for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(input.number_of_halfedges())) {
      if(!input.is_border(h) || input.tail(h).idx() + input.tail(FG::internal::twin_index(h)).idx() != 1)
        continue;
      const double bound = from_source.beyond(surface, h, from_goal);
      BOOST_TEST(bound <= length);
      BOOST_TEST(bound > 0.99 * length);
      ++borders;
    }
    BOOST_TEST(borders == 1);
  }
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  std::vector<Curve> out;
  const World world(flat_grid(4, 4, Diagonal_rule::RISING));
  const auto point = world.paths(3, 3, 2, out); // a disk has one class
  BOOST_TEST((point.status() == FG::Class_search_status::NO_MORE_CLASSES));
  BOOST_TEST(out.size() == 1u);
  BOOST_TEST(point.length(0) == 0);
  BOOST_CHECK_THROW(world.paths(3, 300, 2, out), FG::Vertex_out_of_range_error);
  const World apart(flat_grid(4, 4, Diagonal_rule::RISING), [](std::size_t f) { return (f / 2) % 4 == 1; });
  BOOST_CHECK_THROW(apart.paths(0, 4, 2, out), FG::Disconnected_endpoints_error);
  const World touching(flat_grid(4, 4, Diagonal_rule::RISING), [](std::size_t f) { return f / 2 == 5 || f / 2 == 10; });
  BOOST_CHECK_THROW(touching.paths(0, 4, 2, out), FG::Invalid_mesh_error);
  BOOST_TEST(out.size() == 1u); // what throws writes nothing
  Mesh_soup bow_tie = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  std::vector<std::vector<Point>> points;
  for(bool is_apart : {false, true}) { // all components are checked
    const auto mesh =
        to_mesh<Surface>(is_apart ? disjoint_union(flat_grid(2, 2, Diagonal_rule::RISING), bow_tie) : bow_tie);
    BOOST_CHECK_THROW(FG::shortest_paths_by_class(mesh, Vertex(1), Vertex(2), 1, std::back_inserter(points)),
                      FG::Invalid_mesh_error);
  }
  BOOST_TEST(points.empty());
}
