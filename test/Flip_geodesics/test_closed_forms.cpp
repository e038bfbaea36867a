// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE closed_forms

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Shortening_status;
using namespace Flip_geodesics_test;

namespace {

constexpr double tolerance = 1e-10; // relative, of lengths
const auto within_1e_9 = boost::unit_test::tolerance(1e-9);

bool is_close(double a, double b) { return std::abs(a - b) <= tolerance * std::abs(b); }

void check_shortest(const FG::Curve_report& report, double expected)
{
  BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
  BOOST_TEST(is_close(report.length, expected), report.length << " instead of " << expected);
  BOOST_TEST(report.length <= report.initial_length * (1 + tolerance));
}

// Geodesics between random vertices against the true distance: never shorter, and mostly as short.
template <class Distance>
void check_distances(const char* name, const Mesh_soup& soup, int pairs, const Distance& distance)
{
  Curve_setting setting(soup);
  Random_numbers random(1);
  int equal = 0;
  for(int i = 0; i < pairs; ++i) {
    const int n = static_cast<int>(soup.points.size());
    const int u = random.below(n), v = (u + 1 + random.below(n - 1)) % n;
    const FG::Curve_report report = setting.pulled_path(FG::Vertex_index(u), FG::Vertex_index(v));
    const double expected = distance(u, v);
    BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
    BOOST_TEST(report.length >= expected * (1 - tolerance), u << " to " << v);
    BOOST_TEST(report.length <= report.initial_length * (1 + tolerance));
    equal += is_close(report.length, expected) ? 1 : 0;
  }
  std::cout << name << ": " << equal << " of " << pairs << " geodesics are shortest paths\n";
  BOOST_TEST(equal >= pairs * 3 / 4);
}

} // namespace

// ---------------------------------------------------------------- paths

BOOST_AUTO_TEST_CASE(plane)
{
  for(Diagonal_rule rule : {Diagonal_rule::RISING, Diagonal_rule::RANDOM}) {
    const Mesh_soup soup = flat_grid(9, 7, rule);
    check_distances("grid", soup, 100 * scale, [&](int u, int v) { return distance(soup.points[u], soup.points[v]); });
  }
  const Mesh_soup soup = jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.24, 1);
  check_distances("jittered grid", soup, 200 * scale,
                  [&](int u, int v) { return distance(soup.points[u], soup.points[v]); });
}

BOOST_AUTO_TEST_CASE(boxes)
{
  for(const auto& [a, b, c] : {Coordinates{1, 1, 1}, Coordinates{3, 2, 1}, Coordinates{1, 0.1, 2}}) {
    const Mesh_soup soup = box(a, b, c, 5);
    check_distances("box", soup, 100 * scale, [&, a = a, b = b, c = c](int u, int v) {
      return box_distance(a, b, c, soup.points[u], soup.points[v]);
    });
  }
}

// The distance that inexact unfolding elsewhere has been seen to miss.
BOOST_AUTO_TEST_CASE(cube_of_edge_32)
{
  const Mesh_soup soup = translated(scaled(cube(16), 2), -16, -16, -16);
  Curve_setting setting(soup);
  const int u = index_of(soup, {-16, -6, 0}), v = index_of(soup, {8, -16, 12});
  BOOST_REQUIRE(u >= 0);
  BOOST_REQUIRE(v >= 0);
  check_shortest(setting.pulled_path(FG::Vertex_index(u), FG::Vertex_index(v)), std::sqrt(1300.0));
}

BOOST_AUTO_TEST_CASE(tetrahedra)
{
  for(int n : {1, 2, 5}) {
    const Mesh_soup soup = tetrahedron(n);
    check_distances("tetrahedron", soup, 100 * scale,
                    [&](int u, int v) { return tetrahedron_distance(n, soup.points[u], soup.points[v]); });
  }
}

BOOST_AUTO_TEST_CASE(cylinder_helices)
{
  const int n = 7, m = 6;
  const double radius = 1.5, height = 4;
  Curve_setting setting(cylinder(n, m, radius, height));
  for(int steps = 0; steps <= 3 * n; ++steps)
    check_shortest(setting.pulled(cylinder_helix(n, m, 2, steps), false),
                   std::hypot(height, steps * polygon_side(n, radius)));
  for(int k = 1; k < m; ++k)
    check_shortest(setting.pulled(with_detours(cylinder(n, m, radius, height), cylinder_ring(n, k), true), true),
                   n * polygon_side(n, radius));
}

// An apex below pi, above pi, and of more than 2 pi: the path stays on its side of the apex if it can.
BOOST_AUTO_TEST_CASE(cones_and_saddles)
{
  const int k = 12, m = 4;
  for(double total : {0.9, 2.5, 3.9, 5.8, 7.0, 9.5, 14.0}) {
    Curve_setting setting(total < 2 * pi ? cone_disk(k, m, total) : saddle_disk(k, m, total));
    for(int r = 1; r <= m; ++r)
      for(int steps = 1; steps < k; ++steps) {
        const double angle = total * steps / k, other = total - angle;
        if(std::abs(angle - pi) < 1e-6 || std::abs(other - pi) < 1e-6)
          continue; // a tie
        const double expected = cone_distance(r, r, angle < pi ? angle : other);
        const FG::Curve_report report = setting.pulled(disk_arc(k, r, 1, steps), false);
        if(r == m && total > 2 * pi)
          continue; // the border is in the way
        check_shortest(report, expected);
      }
  }
}

BOOST_AUTO_TEST_CASE(a_saddle_vertex_is_passed)
{
  const int k = 6, m = 3;
  Curve_setting setting(saddle_disk(k, m, 9));
  setting.add(disk_arc(k, 1, 0, 3), false);
  const FG::Shortening_report report = setting.pull();
  check_shortest(report.curves[0], 2);
  BOOST_TEST(report.curves[0].smallest_angle == 4.5, boost::test_tools::tolerance(1e-9));
  bool passes = false;
  for(FG::Halfedge_index h : setting.network.halfedges(0_c))
    passes = passes || setting.triangulation.tail(h) == 0_v;
  BOOST_TEST(passes);
}

// ---------------------------------------------------------------- loops

BOOST_AUTO_TEST_CASE(flat_tori)
{
  const int n = 6, m = 5;
  const double a = 3, b = 2;
  const Mesh_soup soup = torus(n, m, 3, 1);
  const Surface mesh = to_mesh<Surface>(soup);
  std::map<Surface::Edge_index, double> lengths = edge_lengths(mesh, Flat_torus_metric{n, m, a, b});
  Length_triangulation triangulation(mesh, Length_metric(mesh, Length_map(lengths)));
  for(int p = -4; p <= 4; ++p)
    for(int q = 0; q <= 4; ++q) {
      if(std::gcd(p, q) != 1)
        continue;
      FG::Edge_path_network<Length_triangulation> network(triangulation);
      const Vertex_sequence loop = torus_loop(n, m, p, q);
      network.add_curve(FG::halfedges_through(triangulation, loop, CGAL::parameters::is_closed(true)),
                        CGAL::parameters::is_closed(true));
      FG::order_overlapping_curves(network);
      check_shortest(FG::shorten(network).curves[0], std::hypot(p * a, q * b));
      network.clear();
      triangulation.rollback();
    }
}

BOOST_AUTO_TEST_CASE(closed_geodesics_of_the_tetrahedron)
{
  for(int n : {2, 4, 6}) {
    Curve_setting setting(tetrahedron(n));
    const double length = 2 * n * std::sqrt(8.0);
    check_shortest(setting.pulled(tetrahedron_loop(n), true), length);
    check_shortest(setting.pulled(with_detours(tetrahedron(n), tetrahedron_loop(n), true, 2), true), length);
  }
}

// A simple loop either contracts or ends at 2 * edge * sqrt(p*p + p*q + q*q) for coprime p, q: there are no others.
BOOST_AUTO_TEST_CASE(random_loops_on_the_tetrahedron)
{
  for(int n : {2, 3}) {
    Curve_setting setting(tetrahedron(n));
    std::map<int, int> found;
    Random_numbers random(2);
    for(int i = 0; i < 6000 * scale; ++i) {
      flip_at_random(setting.triangulation, random.below(40), random);
      const Halfedge_sequence walk = random_walk(setting.triangulation, 12, true, random);
      if(!walk.empty()) {
        setting.network.add_curve(walk, CGAL::parameters::is_closed(true));
        if(order_at_random(setting.network, walk, 5, random)) {
          const FG::Curve_report report = setting.pull().curves[0];
          const double norm = std::pow(report.length / (2 * n * std::sqrt(8.0)), 2);
          ++found[static_cast<int>(std::lround(norm))];
          BOOST_TEST(std::abs(norm - std::lround(norm)) < 1e-9);
          BOOST_TEST((report.status == Shortening_status::CONTRACTED || norm > 0.5));
          BOOST_TEST((report.status != Shortening_status::PRECISION_LIMIT));
        }
        setting.network.clear();
      }
      setting.triangulation.rollback();
    }
    std::cout << "loops on a tetrahedron, by p*p + p*q + q*q:";
    for(const auto& [norm, count] : found)
      std::cout << ' ' << norm << " (" << count << ')';
    std::cout << '\n';
    BOOST_TEST(found[1] > 0);
    for(int impossible : {2, 4, 5, 6, 8, 9, 10, 11, 12})
      BOOST_TEST(found[impossible] == 0);
  }
}

BOOST_AUTO_TEST_CASE(hexagons_on_the_octahedron)
{
  const int n = 4;
  const Mesh_soup soup = octahedron(n);
  const Vertex_sequence hexagon =
      vertices_on_polyline(soup, {{2, -2, 0}, {2, 0, -2}, {0, 2, -2}, {-2, 2, 0}, {-2, 0, 2}, {0, -2, 2}}, true);
  Curve_setting setting(soup);
  check_shortest(setting.pulled(hexagon, true), 3 * n * std::sqrt(2.0));
  check_shortest(setting.pulled(with_detours(soup, hexagon, true, 3), true), 3 * n * std::sqrt(2.0));
}

BOOST_AUTO_TEST_CASE(handles_of_genus_3)
{
  for(int n : {1, 2, 3}) {
    const Mesh_soup soup = genus_3_plate(n);
    Curve_setting setting(soup);
    for(const Vertex_sequence& loop : genus_3_loops(n)) {
      check_shortest(setting.pulled(loop, true), 4 * n);
      for(int period : {1, 2, 3}) {
        const FG::Curve_report report = setting.pulled(with_detours(soup, loop, true, period), true);
        BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
        BOOST_TEST(report.length >= 4 * n * (1 - tolerance));
        BOOST_TEST(report.length <= report.initial_length * (1 + tolerance));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(contractible_loops)
{
  Curve_setting smallest(thirteen_vertex_cone_disk());
  for(int r : {1, 2})
    BOOST_TEST(FG::to_string(smallest.pulled(disk_ring(6, r), true).status) == "CONTRACTED");
  for(double total : {0.5, 2.0, 4.0, 6.0}) {
    Curve_setting setting(cone_disk(7, 5, total));
    for(int r = 1; r <= 5; ++r)
      BOOST_TEST(FG::to_string(setting.pulled(disk_ring(7, r), true).status) == "CONTRACTED");
  }
  Curve_setting saddle(saddle_disk(8, 4, 11));
  for(int r = 1; r <= 4; ++r)
    BOOST_TEST(FG::to_string(saddle.pulled(disk_ring(8, r), true).status) == "CONTRACTED");
}

BOOST_AUTO_TEST_CASE(loops_contract_on_convex_surfaces)
{
  std::map<std::string, int> counts;
  Random_numbers random(3);
  const std::vector<Mesh_soup> soups = {random_convex_polyhedron(20, 1), random_convex_polyhedron(60, 2),
                                        random_convex_polyhedron(8, 3), sphere(3)};
  for(const Mesh_soup& soup : soups) {
    Curve_setting setting(soup);
    for(int i = 0; i < 3000 * scale; ++i) {
      flip_at_random(setting.triangulation, random.below(200), random);
      const Halfedge_sequence walk = random_walk(setting.triangulation, 25, true, random);
      if(!walk.empty()) {
        setting.network.add_curve(walk, CGAL::parameters::is_closed(true));
        if(order_at_random(setting.network, walk, 5, random))
          ++counts[FG::to_string(setting.pull().curves[0].status)];
        setting.network.clear();
      }
      setting.triangulation.rollback();
    }
  }
  for(const auto& [status, count] : counts)
    std::cout << "loops on convex surfaces: " << status << ' ' << count << '\n';
  BOOST_TEST(counts["CONTRACTED"] > 100);
  BOOST_TEST(counts["LOCALLY_SHORTEST"] == 0);
  BOOST_TEST(counts["PRECISION_LIMIT"] * 1000 <= counts["CONTRACTED"]);
}

// ---------------------------------------------------------------- the closed forms themselves, compared with other
// routes

BOOST_AUTO_TEST_CASE(distances_on_boxes, *within_1e_9)
{
  BOOST_TEST(box_distance(32, 32, 32, {0, 10, 16}, {24, 0, 28}) == std::sqrt(1300.));
  BOOST_TEST(box_distance(1, 1, 1, {0, 0, 0}, {1, 1, 1}) == std::sqrt(5.));
  BOOST_TEST(box_distance(1, 1, 1, {0, 0, 0}, {1, 1, 0}) == std::sqrt(2.));
  BOOST_TEST(box_distance(1, 1, 1, {0.5, 0.5, 0}, {0.5, 0.5, 1}) == 2);
  BOOST_TEST(box_distance(1, 1, 2, {0, 0, 0}, {1, 1, 2}) == std::sqrt(8.));
  // The spider and the fly: the shortest of the ways over one, two and three further sides is the longest in sides.
  BOOST_TEST(box_distance(30, 12, 12, {0, 6, 1}, {30, 6, 11}) == 40);
  BOOST_TEST(box_distance(1, 2, 3, {0, 0, 1}, {0, 0, 1}) == 0);
}

BOOST_AUTO_TEST_CASE(distances_on_boxes_form_a_metric)
{
  const std::vector<Coordinates> points = box(2, 3, 5, 2).points;
  for(const Coordinates& p : points)
    for(const Coordinates& q : points) {
      const double pq = box_distance(2, 3, 5, p, q);
      BOOST_TEST(pq >= distance(p, q) - 1e-12);
      BOOST_TEST(pq == box_distance(2, 3, 5, q, p), boost::test_tools::tolerance(1e-12));
      BOOST_TEST(pq <= box_distance(2, 3, 5, p, points[9]) + box_distance(2, 3, 5, points[9], q) + 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(distances_on_tetrahedra, *within_1e_9)
{
  const double edge = 4 * std::sqrt(8.);
  const std::vector<Coordinates> points = tetrahedron(4).points;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j)
      BOOST_TEST(tetrahedron_distance(4, points[i], points[j]) == (i == j ? 0 : edge));
  BOOST_TEST(tetrahedron_distance(4, {0, 0, 4}, {0, 0, -4}) == edge); // midpoints of opposite edges
  const Coordinates base_center = {4. / 3, 4. / 3, -4. / 3};
  BOOST_TEST(tetrahedron_distance(4, {-4, 4, -4}, {4, 4, 4}) == edge);
  BOOST_TEST(tetrahedron_distance(4, {-4. / 3, 4. / 3, 4. / 3}, {4, -4, -4}) == edge * 2 / std::sqrt(3.));
  BOOST_TEST(tetrahedron_distance(4, base_center, {4, -4, -4}) == edge / std::sqrt(3.));
}

// Within a face the distance is that in space, and everywhere it is symmetric and satisfies the triangle inequality.
BOOST_AUTO_TEST_CASE(distances_on_tetrahedra_form_a_metric)
{
  const Mesh_soup soup = tetrahedron(4);
  const auto is_on_face = [](const Coordinates& p, int sign) { return p[0] * sign + p[1] * sign + p[2] == -4; };
  for(const Coordinates& p : soup.points)
    for(const Coordinates& q : soup.points) {
      const double pq = tetrahedron_distance(4, p, q);
      BOOST_TEST(pq >= distance(p, q) - 1e-6);
      BOOST_TEST(std::abs(pq - tetrahedron_distance(4, q, p)) < 1e-6);
      for(int sign : {-1, 1})
        if(is_on_face(p, sign) && is_on_face(q, sign))
          BOOST_TEST(std::abs(pq - distance(p, q)) < 1e-6);
      for(const Coordinates& r : soup.points)
        if(tetrahedron_distance(4, p, r) + tetrahedron_distance(4, r, q) < pq - 1e-6)
          BOOST_ERROR("triangle inequality");
    }
}

BOOST_AUTO_TEST_CASE(distances_on_cylinders_and_cones, *within_1e_9)
{
  BOOST_TEST(cylinder_distance(4, 3, std::sqrt(2.), 9, 0, 3 + 4 * 2) == std::hypot(2, 6));
  BOOST_TEST(cylinder_distance(4, 3, std::sqrt(2.), 9, 0, 2) == 4);
  BOOST_TEST(cone_distance(3, 4, pi / 2) == 5);
  BOOST_TEST(cone_distance(3, 4, pi) == 7);
  BOOST_TEST(cone_distance(3, 4, 4) == 7);
  BOOST_TEST(cone_distance(3, 3, 0) == 0);
  const Mesh_soup cone = cone_disk(5, 4, 3); // along a sector, where the chord is in the mesh
  BOOST_TEST(distance(cone.points[disk_vertex(5, 2, 0)], cone.points[disk_vertex(5, 4, 1)]) ==
             cone_distance(2, 4, 3. / 5));
}

// ---------------------------------------------------------------- weights

namespace {

using Plane_point = CGAL::Simple_cartesian<double>::Point_3;
using Plane_mesh = CGAL::Surface_mesh<Plane_point>;
using Plane_metric = FG::Default_metric<Plane_mesh>;

// A grid of n times n cells over [0, 2] x [1, 3].
Plane_mesh half_plane(int n)
{
  return to_mesh<Plane_mesh>(mapped(flat_grid(n, n, Diagonal_rule::ALTERNATING), [n](const Coordinates& p) {
    return Coordinates{2 * p[0] / n, 1 + 2 * p[1] / n, 0};
  }));
}

template <class Key, class Weight>
FG::Weighted_metric<Plane_metric> weighted(const Plane_mesh& mesh, const Weight& weight)
{
  return {mesh, Plane_metric(mesh.points()), boost::make_function_property_map<Key>(weight)};
}

// The length of a geodesic of doubles, and the highest point that it passes.
std::pair<double, double> length_and_height(const Plane_mesh& mesh, const FG::Weighted_metric<Plane_metric>& metric,
                                            int source, int target)
{
  std::vector<Plane_point> points;
  const auto result = FG::geodesic_path(
      mesh, Plane_mesh::Vertex_index(static_cast<unsigned>(source)),
      Plane_mesh::Vertex_index(static_cast<unsigned>(target)), std::back_inserter(points),
      CGAL::parameters::metric(metric).geom_traits(FG::Intrinsic_triangulation_traits<Plane_metric::Kernel>()));
  BOOST_TEST(FG::to_string(result.status()) == "LOCALLY_SHORTEST");
  double height = 0;
  for(const Plane_point& p : points)
    height = (std::max)(height, p.y());
  return {result.length(), height};
}

} // namespace

// With the weight 1 / y, geodesics are arcs of circles about places on the x-axis: Poincare's half-plane.
BOOST_AUTO_TEST_CASE(weights_of_the_half_plane)
{
  double error_before = 0;
  for(int n : {8, 16, 32, 64}) {
    const Plane_mesh mesh = half_plane(n);
    const auto metric =
        weighted<Plane_mesh::Vertex_index>(mesh, [&](Plane_mesh::Vertex_index v) { return 1 / mesh.point(v).y(); });
    // From (0.25, 1.25) to (1.75, 1.5).
    const int source = grid_vertex(n, n / 8, n / 8), target = grid_vertex(n, 7 * n / 8, n / 4);
    const auto [length, height] = length_and_height(mesh, metric, source, target);
    const double expected = std::acosh(1 + (1.5 * 1.5 + 0.25 * 0.25) / (2 * 1.25 * 1.5));
    const double error = std::abs(length - expected);
    BOOST_TEST(error < 0.6 / (n * n));
    BOOST_TEST((n == 8 || error < 0.4 * error_before));
    error_before = error;
    const double center = 1 + (1.5 * 1.5 - 1.25 * 1.25) / (2 * 1.5), radius = std::hypot(center - 0.25, 1.25);
    BOOST_TEST(std::abs(height - radius) < 2. / n);
  }
}

// One weight everywhere is another unit of length; and a face's counts at its corners.
BOOST_AUTO_TEST_CASE(weights_of_faces)
{
  const int n = 16;
  const Plane_mesh mesh = half_plane(n);
  const auto one = weighted<Plane_mesh::Face_index>(mesh, [](Plane_mesh::Face_index) { return 1.; });
  const auto four = weighted<Plane_mesh::Face_index>(mesh, [](Plane_mesh::Face_index) { return 4.; });
  const int source = grid_vertex(n, 1, 2), target = grid_vertex(n, 15, 7);
  const double length = length_and_height(mesh, one, source, target).first;
  BOOST_TEST(is_close(length, std::hypot(14 * 0.125, 5 * 0.125)));
  BOOST_TEST(is_close(length_and_height(mesh, four, source, target).first, 4 * length));
  const FG::Weighted_metric<Plane_metric>::Mesh numbered(mesh);
  const double bound = four.distance_lower_bound(four.place(numbered, FG::Vertex_index(source)),
                                                 four.place(numbered, FG::Vertex_index(target)));
  BOOST_TEST(bound <= 4 * length);
  BOOST_TEST(bound > 4 * length * (1 - 1e-5));
  // Twice the weight in a square in the way.
  const auto is_heavy = [](Plane_mesh::Face_index f) {
    const std::size_t cell = static_cast<std::size_t>(f) / 2, i = cell % 16, j = cell / 16;
    return i >= 5 && i < 11 && j < 8;
  };
  const auto square =
      weighted<Plane_mesh::Face_index>(mesh, [&](Plane_mesh::Face_index f) { return is_heavy(f) ? 2. : 1.; });
  // Of the edge to the right, whose ends have the means of the weights of their faces.
  const auto factor = [&](int i, int j) {
    const auto vertex = [&](int k) { return Plane_mesh::Vertex_index(static_cast<unsigned>(grid_vertex(n, k, j))); };
    const auto h = mesh.halfedge(vertex(i), vertex(i + 1));
    return square.factor(FG::Input_halfedge_index(static_cast<FG::Index>(h)));
  };
  BOOST_TEST(factor(8, 4) == 2);
  BOOST_TEST(factor(8, 12) == 1);
  BOOST_TEST((1 < factor(5, 8) && factor(5, 8) < 1.5));
  const auto around = length_and_height(mesh, square, grid_vertex(n, 1, 6), grid_vertex(n, 15, 6));
  BOOST_TEST(around.second >= 2); // the square ends there
  BOOST_TEST(around.first < 14 * 0.125 * 1.2);
  BOOST_TEST(around.first > 14 * 0.125);
}

// The lower bound of a search holds: what it directs finds what is found without it.
BOOST_AUTO_TEST_CASE(weights_direct_searches)
{
  const int n = 24;
  const Plane_mesh mesh = half_plane(n);
  Random_numbers random(5);
  std::vector<double> weights;
  for(std::size_t i = 0; i < mesh.number_of_vertices(); ++i)
    weights.push_back(1 + random.below(100) * 0.03);
  const auto metric = weighted<Plane_mesh::Vertex_index>(
      mesh, [&](Plane_mesh::Vertex_index v) { return weights[static_cast<std::size_t>(v)]; });
  using Triangulation =
      FG::Intrinsic_triangulation<Plane_mesh, FG::Intrinsic_triangulation_traits<Plane_metric::Kernel>,
                                  FG::Weighted_metric<Plane_metric>>;
  const Triangulation triangulation(mesh, metric);
  FG::Shortest_edge_path<Triangulation> directed(triangulation,
                                                 CGAL::parameters::search_method(FG::Search_method::A_STAR)),
      plain(triangulation, CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
  const auto length = [&](const std::vector<FG::Halfedge_index>& path) {
    double sum = 0;
    for(FG::Halfedge_index h : path)
      sum += metric.weight(triangulation.input(), FG::Input_halfedge_index(h.idx()));
    return sum;
  };
  for(int i = 0; i < 20; ++i) {
    const FG::Vertex_index u(random.below(625)), v(random.below(625));
    BOOST_TEST(is_close(length(directed(u, v)), length(plain(u, v))));
  }
}

// A length that is negative, infinite or not a number is refused by every search that meets its edge.
BOOST_AUTO_TEST_CASE(edges_without_a_length_are_refused)
{
  Plane_mesh mesh = half_plane(4);
  using Lengths = Plane_mesh::Property_map<Plane_mesh::Edge_index, double>;
  const Lengths lengths = mesh.add_property_map<Plane_mesh::Edge_index, double>("e:length", 1).first;
  const FG::Edge_length_metric<Plane_mesh, Lengths> metric(mesh, lengths);
  using Triangulation =
      FG::Intrinsic_triangulation<Plane_mesh, FG::Intrinsic_triangulation_traits<Plane_metric::Kernel>,
                                  FG::Edge_length_metric<Plane_mesh, Lengths>>;
  const Triangulation triangulation(mesh, metric);
  const auto edge = mesh.edge(mesh.halfedge(Plane_mesh::Vertex_index(12)));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for(FG::Search_method method : {FG::Search_method::DIJKSTRA, FG::Search_method::A_STAR, FG::Search_method::LOOK_BACK})
  {
    FG::Shortest_edge_path<Triangulation> search(triangulation, CGAL::parameters::search_method(method));
    for(double length : {-1.0, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
      lengths[edge] = length;
      BOOST_CHECK_THROW(search(0_v, 24_v), FG::Invalid_coordinate_error);
      lengths[edge] = 1;
      BOOST_TEST(search(0_v, 24_v).size() >= 4u);
    }
  }
}

// A face whose sides weigh more than its height becomes flatter, so that a path across it is shorter than distances in
// space times the least weight; bounds have to know.
BOOST_AUTO_TEST_CASE(weights_flatten_faces)
{
  // A kite: the sides are 1.5 times as long, and the diagonal twice as long.
  Plane_mesh mesh;
  const auto top = mesh.add_vertex(Plane_point(0, 1, 0)), bottom = mesh.add_vertex(Plane_point(0, -1, 0));
  const auto left = mesh.add_vertex(Plane_point(-1, 0, 0)), right = mesh.add_vertex(Plane_point(1, 0, 0));
  mesh.add_face(top, left, right);
  mesh.add_face(bottom, right, left);
  const auto metric = weighted<Plane_mesh::Vertex_index>(
      mesh, [&](Plane_mesh::Vertex_index v) { return v == left || v == right ? 2. : 1.; });
  std::vector<Plane_point> points;
  const auto path = FG::shortest_path(mesh, top, bottom, std::back_inserter(points), CGAL::parameters::metric(metric));
  BOOST_TEST(is_close(path.length(), 2 * std::sqrt(1.5 * 1.5 * 2 - 4)));
  BOOST_TEST(path.report.lower_bound <= path.length() * (1 + 1e-15));
  BOOST_TEST(FG::to_string(path.report.verdict) == "WITHIN_ROUNDING");
}

// Factors of edges are as good as the weights of vertices that they follow from. Factors that leave no triangle are
// mended by a length that is added to all edges.
BOOST_AUTO_TEST_CASE(weights_of_edges)
{
  const int n = 8;
  const Plane_mesh mesh = half_plane(n);
  const auto of_vertices =
      weighted<Plane_mesh::Vertex_index>(mesh, [&](Plane_mesh::Vertex_index v) { return 1 / mesh.point(v).y(); });
  const auto of_edges = weighted<Plane_mesh::Edge_index>(mesh, [&](Plane_mesh::Edge_index e) {
    return 0.5 * (1 / mesh.point(mesh.vertex(e, 0)).y() + 1 / mesh.point(mesh.vertex(e, 1)).y());
  });
  const int source = grid_vertex(n, 1, 1), target = grid_vertex(n, 7, 2);
  BOOST_TEST(
      (length_and_height(mesh, of_edges, source, target) == length_and_height(mesh, of_vertices, source, target)));

  const auto is_spoilt = [&](Plane_mesh::Edge_index e) { return static_cast<std::size_t>(e) % 7 == 0; };
  const auto spoilt =
      weighted<Plane_mesh::Edge_index>(mesh, [&](Plane_mesh::Edge_index e) { return is_spoilt(e) ? 5. : 1.; });
  std::vector<Plane_point> points;
  const auto path = [&](const auto& metric) {
    return FG::geodesic_path(mesh, Plane_mesh::Vertex_index(static_cast<unsigned>(source)),
                             Plane_mesh::Vertex_index(static_cast<unsigned>(target)), std::back_inserter(points),
                             CGAL::parameters::metric(metric));
  };
  BOOST_CHECK_THROW(path(spoilt), FG::Degenerate_face_error);
  const FG::Mollified_metric<FG::Weighted_metric<Plane_metric>> mended(mesh, spoilt);
  BOOST_TEST(mended.added_length() > 0);
  BOOST_TEST(FG::to_string(path(mended).verdict()) == "PROVEN");
  BOOST_CHECK_THROW(weighted<Plane_mesh::Edge_index>(mesh, [](Plane_mesh::Edge_index) { return 0.; }),
                    FG::Invalid_parameter_error);
}

// Of the two ways round an octahedron, one leads over a ridge of slightly less weight. The same lengths without places
// in space, which have no bound, tell which is shorter.
BOOST_AUTO_TEST_CASE(weights_do_not_hide_a_shorter_way)
{
  Plane_mesh mesh;
  const auto south = mesh.add_vertex(Plane_point(0, 1, 0)), north = mesh.add_vertex(Plane_point(0, -1, 0));
  std::array<Plane_mesh::Vertex_index, 4> ring;
  for(std::size_t i = 0; i < 4; ++i)
    ring[i] = mesh.add_vertex(Plane_point(i == 0 || i == 3 ? -1 : 1, 0, i < 2 ? 1 : -1));
  for(std::size_t i = 0; i < 4; ++i) {
    mesh.add_face(south, ring[i], ring[(i + 1) % 4]);
    mesh.add_face(north, ring[(i + 1) % 4], ring[i]);
  }
  const auto metric = weighted<Plane_mesh::Vertex_index>(mesh, [&](Plane_mesh::Vertex_index v) {
    return v == south || v == north ? 1. : (v == ring[0] || v == ring[1] ? 6. : 5.9);
  });
  std::map<Plane_mesh::Edge_index, double> lengths;
  const FG::Numbered_mesh<Plane_mesh> numbered(mesh);
  for(Plane_mesh::Edge_index e : mesh.edges())
    lengths[e] = metric.weight(numbered, numbered.index(mesh.halfedge(e)));
  const boost::associative_property_map<std::map<Plane_mesh::Edge_index, double>> length_map(lengths);
  std::vector<Plane_point> points;
  const auto path = FG::shortest_path(mesh, south, north, std::back_inserter(points), CGAL::parameters::metric(metric));
  std::vector<std::pair<Plane_mesh::Face_index, std::array<double, 3>>> places;
  const auto other = FG::shortest_path(
      mesh, south, north, std::back_inserter(places),
      CGAL::parameters::metric(FG::Edge_length_metric<Plane_mesh, decltype(length_map)>(mesh, length_map)));
  BOOST_TEST(is_close(path.length(), other.length()));
  BOOST_TEST(is_close(path.report.lower_bound, other.report.lower_bound));
  const auto landmarks = FG::geodesic_landmarks(mesh, 4, CGAL::parameters::metric(metric));
  BOOST_TEST(landmarks.distance_lower_bound(FG::Vertex_index(0), FG::Vertex_index(1)) <= other.length());
}

BOOST_AUTO_TEST_CASE(weights_that_are_none)
{
  const int n = 8;
  const Plane_mesh mesh = half_plane(n);
  for(double bad : {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    BOOST_CHECK_THROW(weighted<Plane_mesh::Vertex_index>(
                          mesh, [&](Plane_mesh::Vertex_index v) { return static_cast<unsigned>(v) == 7 ? bad : 1.; }),
                      FG::Invalid_parameter_error);
    BOOST_CHECK_THROW(weighted<Plane_mesh::Face_index>(
                          mesh, [&](Plane_mesh::Face_index f) { return static_cast<unsigned>(f) == 7 ? bad : 1.; }),
                      FG::Invalid_parameter_error);
  }
  // A jump that no triangle can have.
  const auto cliff = weighted<Plane_mesh::Vertex_index>(
      mesh, [&](Plane_mesh::Vertex_index v) { return mesh.point(v).x() > 1 ? 100. : 1.; });
  std::vector<Plane_point> points;
  BOOST_CHECK_THROW(length_and_height(mesh, cliff, grid_vertex(n, 1, 1), grid_vertex(n, 7, 6)),
                    FG::Degenerate_face_error);
}
