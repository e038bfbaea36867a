// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The boundaries of regions with the same nearest source.

#include "test_isolines/closed_field.h"
#include "test_scale.h"

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(bisectors_in_the_plane)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(6, 6, Diagonal_rule::ALTERNATING, 0.2, 5));
  for(double tolerance : {0.1, 0.005}) {
    const Closed_field two(mesh, from_points({{2, 2.3}, {4.1, 3.5}}));
    const auto line = boundaries(mesh, two, tolerance);
    const Diagram simple = check_diagram(mesh, two, line, tolerance);
    BOOST_TEST(simple.open == 1u);
    BOOST_TEST(simple.ends == 2u);
    BOOST_TEST(static_cast<double>(two.calls()) < 60 * (length(line[0]) + 6) / tolerance);
    const double straight = distance(line[0].points.front(), line[0].points.back());
    BOOST_TEST(std::abs(length(line[0]) - straight) < 1e-11);

    const Closed_field three(mesh, from_points({{1.2, 1.4}, {4.5, 2}, {2.2, 4.6}}));
    const auto star = boundaries(mesh, three, tolerance);
    const Diagram diagram = check_diagram(mesh, three, star, tolerance);
    BOOST_TEST(diagram.junctions == 1u);
    BOOST_TEST(diagram.open == 3u);
    BOOST_TEST(diagram.ends == 3u);
    const Point center = CGAL::circumcenter(Point(1.2, 1.4, 0), Point(4.5, 2, 0), Point(2.2, 4.6, 0));
    for(const Boundary& b : star)
      BOOST_TEST(distance(b.junctions[0] != Boundary::none ? b.points.front() : b.points.back(), center) <
                 0.03 * tolerance);
    const Boundary& b = star[0]; // its first source is on the left
    const Point &p = b.points[b.points.size() / 2], &q = b.points[b.points.size() / 2 + 1];
    const Coordinates left = {(p.x() + q.x()) / 2 - 0.01 * (q.y() - p.y()),
                              (p.y() + q.y()) / 2 + 0.01 * (q.x() - p.x()), 0};
    BOOST_TEST(three.at(left).source == b.sources[0]);
  }
}

// A hyperbola, whose chords are as long as those of circles of its curvature.
BOOST_AUTO_TEST_CASE(points_of_boundaries_grow_like_the_root_of_the_tolerance)
{
  const Mesh mesh = to_mesh<Mesh>(scaled(single_triangle(), 2));
  const Distance first = from_point(1.5, 2), second = from_point(2.5, 2);
  const Closed_field field(mesh, {first, [&](const Coordinates& p) { return second(p) + 0.6; }});
  const auto points = [&](double tolerance) {
    const auto curves = boundaries(mesh, field, tolerance);
    BOOST_TEST_REQUIRE(curves.size() == 1u);
    check_diagram(mesh, field, curves, tolerance);
    return static_cast<double>(curves[0].points.size());
  };
  const double coarse = points(1e-2), middle = points(1e-3);
  BOOST_TEST(coarse > 4);
  BOOST_TEST(middle < 2 * std::sqrt(10.) * coarse);
  if(has_all_cases)
    BOOST_TEST(points(1e-4) < 1.5 * std::sqrt(10.) * middle);
}

// V - E + F of the mesh, from the diagram: regions of one source are disks.
BOOST_AUTO_TEST_CASE(regions_of_many_sources)
{
  const Mesh plane = to_mesh<Mesh>(flat_grid(12, 12, Diagonal_rule::RISING));
  Random_numbers random(5);
  std::vector<std::array<double, 2>> sources;
  for(int i = 0; i < 40; ++i)
    sources.push_back({random.uniform(0, 12), random.uniform(0, 12)});
  const Closed_field field(plane, from_points(sources));
  const Diagram d = check_diagram(plane, field, boundaries(plane, field, 0.02), 0.02);
  BOOST_TEST(d.closed == 0u);
  // With the border, each of whose parts between two ends is an edge: V - E + F = 1.
  BOOST_TEST(d.junctions + d.ends + 40 == d.open + d.ends + 1);

  const Mesh tetra = to_mesh<Mesh>(tetrahedron(2));
  std::vector<Distance> distances;
  for(int i = 0; i < 6; ++i) {
    double w[3] = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    const double sum = w[0] + w[1] + w[2];
    const std::array<Coordinates, 4> corners = {{{2, 2, 2}, {2, -2, -2}, {-2, 2, -2}, {-2, -2, 2}}};
    Coordinates s = {0, 0, 0};
    for(int j = 0; j < 3; ++j)
      for(int c = 0; c < 3; ++c)
        s[c] += w[j] / sum * corners[(i + j) % 4][c];
    distances.push_back([s](const Coordinates& p) { return tetrahedron_distance(2, s, p); });
  }
  const Closed_field closed(tetra, distances);
  const Diagram t = check_diagram(tetra, closed, boundaries(tetra, closed, 0.02), 0.02);
  BOOST_TEST(t.ends == 0u);
  BOOST_TEST(t.closed == 0u);
  BOOST_TEST(t.junctions + 6 == t.open + 2);
}

BOOST_AUTO_TEST_CASE(closed_boundaries_and_corners_of_a_cube)
{
  const Mesh mesh = to_mesh<Mesh>(cube(1));
  const auto at = [](const Coordinates& s) {
    return Distance([s](const Coordinates& p) { return box_distance(1, 1, 1, s, p); });
  };
  const Closed_field two(mesh, {at({0.5, 0.5, 0}), at({0.5, 0.5, 1})});
  const auto loop = boundaries(mesh, two, 0.1);
  const Diagram around = check_diagram(mesh, two, loop, 0.1);
  BOOST_TEST(around.closed == 1u);
  BOOST_TEST(around.open == 0u);
  BOOST_TEST(std::abs(length(loop[0]) - 4) < 1e-9);
  // Three adjacent sides: their regions meet in two opposite corners.
  const Closed_field three(mesh, {at({0, 0.5, 0.5}), at({0.5, 0, 0.5}), at({0.5, 0.5, 0})});
  const Diagram corners = check_diagram(mesh, three, boundaries(mesh, three, 0.1), 0.1);
  BOOST_TEST(corners.junctions == 2u);
  BOOST_TEST(corners.open == 3u);
}

// Four regions meet in a point, and regions with one neighbor are inside faces.
BOOST_AUTO_TEST_CASE(ties_and_regions_inside_faces)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Closed_field four(mesh, from_points({{1, 1}, {3, 1}, {1, 3}, {3, 3}}));
  const auto cross = boundaries(mesh, four, 0.05);
  std::size_t ends = 0;
  for(const Boundary& b : cross) {
    check_polyline(mesh, b);
    ends += (b.junctions[0] == Boundary::none ? 1 : 0) + (b.junctions[1] == Boundary::none ? 1 : 0);
  }
  BOOST_TEST(ends == 4u);

  const Mesh triangle = to_mesh<Mesh>(scaled(single_triangle(), 10));
  const Distance far = from_point(10, 10);
  const Closed_field inside(triangle, {[&](const Coordinates& p) { return far(p) + 0.05; }, from_point(10.1, 10)});
  const auto hyperbola = boundaries(triangle, inside, 0.002);
  const Diagram d = check_diagram(triangle, inside, hyperbola, 0.002);
  BOOST_TEST(d.open == 1u);
  const Closed_field islet(
      triangle, {[](const Coordinates& p) { return 0.2 + 0.5 * std::hypot(p[0] - 10, p[1] - 10); }, from_point(9, 9)});
  BOOST_TEST(check_diagram(triangle, islet, boundaries(triangle, islet, 0.01), 0.01).closed == 1u);
  const Closed_field behind(triangle,
                            {[](const Coordinates& p) { return 60.9 + 0.5 * std::hypot(p[0] - 10, p[1] - 10); },
                             [](const Coordinates& p) { return 60.5 + std::hypot(p[0] - 9, p[1] - 9); }});
  BOOST_TEST(check_diagram(triangle, behind, boundaries(triangle, behind, 0.01), 0.01).closed == 1u);

  Random_numbers random(2);
  for(int i = 0; i < (has_all_cases ? 6 : 2); ++i) {
    const double x = random.uniform(3, 9), y = random.uniform(3, 9);
    const Closed_field spot(
        triangle,
        {[=](const Coordinates& p) { return 0.02 + 0.5 * std::hypot(p[0] - x, p[1] - y); }, from_point(x, y)});
    BOOST_TEST(check_diagram(triangle, spot, boundaries(triangle, spot, 0.002), 0.002).closed == 1u);
  }

  // A honeycomb cell that is much smaller than the distance of samples elsewhere.
  std::vector<std::array<double, 2>> comb = {{10, 10}};
  for(int i = 0; i < 6; ++i)
    comb.push_back({10 + 0.04 * std::cos(i * pi / 3 + 0.2), 10 + 0.04 * std::sin(i * pi / 3 + 0.2)});
  const Closed_field cell(triangle, from_points(comb));
  const auto walls = boundaries(triangle, cell, 0.002);
  BOOST_TEST(check_diagram(triangle, cell, walls, 0.002).junctions == 6u);
  double around = 0;
  for(const Boundary& b : walls)
    around += b.sources[0] == 0 || b.sources[1] == 0 ? length(b) : 0;
  BOOST_TEST(std::abs(around - 6 * 0.04 / std::sqrt(3.)) < 1e-3);
}

BOOST_AUTO_TEST_CASE(regions_without_source)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const auto limited = [](double x, double y) {
    const Distance distance = from_point(x, y);
    return Distance([=](const Coordinates& p) { return distance(p) > 1.2 ? infinity : distance(p); });
  };
  const Closed_field field(mesh, {limited(1.3, 2), limited(2.7, 2)});
  std::map<std::set<std::size_t>, int> pairs;
  for(const Boundary& b : boundaries(mesh, field, 0.05)) {
    check_polyline(mesh, b);
    ++pairs[{b.sources[0], b.sources[1]}];
    BOOST_TEST(b.junctions[0] != b.junctions[1]);
  }
  BOOST_TEST((pairs[{0, 1}]) == 1);
  BOOST_TEST((pairs[{0, Boundary::none}]) == 1);
  BOOST_TEST((pairs[{1, Boundary::none}]) == 1);
}

// Such as that of a source within rounding errors of another one.
BOOST_AUTO_TEST_CASE(a_region_of_a_single_point_has_no_boundary)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Closed_field field(mesh, {[](const Coordinates&) { return 1.0; },
                                  [](const Coordinates& p) { return p[0] == 2 && p[1] == 2 ? 0.5 : 2; }});
  BOOST_TEST(boundaries(mesh, field, 0.05).empty());
}
