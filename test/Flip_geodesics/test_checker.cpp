// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The checker of polylines finds what is wrong, and nothing where all is right. The right curves come from closed
// forms: straight lines on a plane grid that is folded, rolled up, moved and scaled; the wrong ones are these,
// perturbed.

#define BOOST_TEST_MODULE test_checker
#include "checker_io.h"
#include "folded_grid.h"
#include "polyline_checker.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace polyline_checker;

namespace {

Curve_report check(const Mesh& mesh, const Polyline& curve) { return check_curves(mesh, {curve}).front(); }

void expect_geodesic(const Curve_report& report, long double length)
{
  BOOST_TEST(report.broken == 0u);
  BOOST_TEST(report.first_break == "");
  BOOST_TEST(report.strip_bend < 1e-14L);
  BOOST_TEST(report.point_deviation < 1e-14L);
  BOOST_TEST(report.raw_bend < 1e-12L);
  BOOST_TEST(report.min_vertex_angle > pi - 1e-14L);
  BOOST_TEST(report.bent_vertices == 0u);
  BOOST_TEST(std::fabs(report.length / length - 1) < 1e-14L);
  BOOST_TEST(is_geodesic(report));
}

// Two triangles above and two below the line from (0,0) to (4,0), around the vertex (2, h). The curve passes above it.
struct Kite
{
  Mesh mesh;
  Polyline curve;

  explicit Kite(double h)
    : mesh({{0, 0, 0}, {4, 0, 0}, {2, h, 0}, {2, 2, 0}, {2, -2, 0}}, {{0, 2, 3}, {2, 1, 3}, {0, 4, 2}, {4, 1, 2}})
    , curve{0,
            {{0, 0, 0, {0, 0, 0}},
             {2, 3, (std::max)(1e-100, -h / (2 - h)), {2, (std::max)(h, 0.0), 0}},
             {1, 1, 0, {4, 0, 0}}}}
  {
  }
};

} // namespace

BOOST_AUTO_TEST_SUITE(right_curves)

BOOST_AUTO_TEST_CASE(plane_diagonals)
{
  const Grid grid{12, 8, plane()};
  const Mesh mesh = grid.mesh();
  for(const auto& [x, y] : {std::pair(7, 3), {12, 5}, {11, 8}, {9, 1}})
    expect_geodesic(check(mesh, straight_line(grid, 0, 0, x, y)), std::hypot((long double)x, (long double)y));
}

BOOST_AUTO_TEST_CASE(scaled_and_far_from_the_origin)
{
  for(double scale : {1e-30, 1e30, std::ldexp(1, -60), std::ldexp(1, 60)}) {
    const Grid grid{8, 4, plane(scale)};
    expect_geodesic(check(grid.mesh(), straight_line(grid, 0, 0, 7, 3)), scale * std::sqrt(58.0L));
  }
  const Grid far{8, 4, plane(1, std::ldexp(1, 20), -std::ldexp(1, 23))};
  expect_geodesic(check(far.mesh(), straight_line(far, 0, 0, 7, 3)), std::sqrt(58.0L));
}

BOOST_AUTO_TEST_CASE(around_an_edge_of_a_cube)
{
  const Grid grid{8, 8, folded_at(4)};
  expect_geodesic(check(grid.mesh(), straight_line(grid, 0, 0, 8, 7)), std::sqrt(113.0L));
}

BOOST_AUTO_TEST_CASE(helix_on_a_cylinder)
{
  const Grid grid{6, 5, rolled_up(6), true};
  const Curve_report report = check(grid.mesh(), straight_line(grid, 1, 0, 20, 3)); // three times around
  BOOST_TEST(is_geodesic(report));
  BOOST_TEST(std::fabs(report.length / std::sqrt(370.0L) - 1) < 1e-14L);
}

BOOST_AUTO_TEST_CASE(closed_curves_on_a_cylinder)
{
  const Grid grid{6, 2, rolled_up(6), true};
  const Mesh mesh = grid.mesh();
  for(int y : {0, 1, 2}) { // the first and the last are the border, where the outer side has no angle
    Polyline ring{0, {}};
    for(int x = 0; x <= 6; ++x)
      ring.points.push_back(vertex_point(grid, x, y));
    const Curve_report report = check(mesh, ring);
    BOOST_TEST(report.segments == 6u);
    BOOST_TEST(std::fabs(report.min_vertex_angle - pi) < 1e-14L);
    BOOST_TEST(std::fabs(report.length - 6) < 1e-14L);
    BOOST_TEST(is_geodesic(report));
  }
}

BOOST_AUTO_TEST_CASE(through_a_flat_vertex)
{
  const Grid grid{8, 4, plane()};
  const Mesh mesh = grid.mesh();
  const Polyline passed = joined(straight_line(grid, 0, 0, 3, 1), straight_line(grid, 3, 1, 6, 2));
  const Curve_report report = check(mesh, passed);
  expect_geodesic(report, std::sqrt(40.0L));
  BOOST_TEST(report.segments == 2u);
  BOOST_TEST(std::fabs(report.min_vertex_angle - pi) < 1e-15L);

  // The same as crossings of edges of the vertex, on either side of it.
  const std::vector<std::vector<std::pair<int, int>>> fans = {{{2, 1}, {3, 2}, {4, 2}}, {{2, 0}, {3, 0}, {4, 1}}};
  for(const auto& fan : fans) {
    Polyline beside = straight_line(grid, 0, 0, 3, 1);
    const Polyline rest = straight_line(grid, 3, 1, 6, 2);
    beside.points.pop_back();
    for(const auto& [x, y] : fan)
      beside.points.push_back(edge_point(grid, 3, 1, x, y, 1e-100));
    beside.points.insert(beside.points.end(), rest.points.begin() + 1, rest.points.end());
    const Curve_report crossing = check(mesh, beside);
    BOOST_TEST(crossing.segments == 1u);
    expect_geodesic(crossing, std::sqrt(40.0L));
  }
}

BOOST_AUTO_TEST_CASE(needles)
{
  const double thickness = std::ldexp(1, -70); // angles of 5e-20 degrees
  const Grid grid{8, 4, [=](long double x, long double y) { return Mesh::Point{double(x), double(y * thickness), 0}; }};
  const Curve_report report = check(grid.mesh(), straight_line(grid, 0, 0, 7, 3));
  BOOST_TEST(is_geodesic(report));
  BOOST_TEST(std::fabs(report.length - 7) < 1e-14L);
}

BOOST_AUTO_TEST_CASE(face_without_area)
{
  // A (0,0), B (2,0), C (1,1), M (1,0) on AB, D (1.25,-1); the face BAM has no area.
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1.25, -1, 0}},
                  {{0, 1, 2}, {1, 0, 3}, {3, 0, 4}, {1, 3, 4}});
  const Polyline_point c{2, 2, 0, {1, 1, 0}}, d{4, 4, 0, {1.25, -1, 0}}, on_ab{1, 0, 0.4375, {1.125, 0, 0}};
  expect_geodesic(check(mesh, {0, {c, on_ab, {3, 1, 0.125, {1.125, 0, 0}}, d}}), std::hypot(2.0L, 0.25L));
  const Curve_report wrong_side = check(mesh, {0, {c, on_ab, {3, 0, 1e-100, {1, 0, 0}}, d}});
  BOOST_TEST(wrong_side.broken == 0u);
  BOOST_TEST(!is_geodesic(wrong_side));
}

// Where long double sees noise, 50 digits see what is there.
BOOST_AUTO_TEST_CASE(fifty_digits)
{
  using boost::multiprecision::cpp_bin_float_50;
  using Precise = boost::multiprecision::number<cpp_bin_float_50::backend_type, boost::multiprecision::et_off>;
  const Grid grid{8, 8, folded_at(4)};
  BOOST_TEST(trace_curve<Precise>(grid.mesh(), straight_line(grid, 0, 0, 8, 7)).report.strip_bend == 0);
  for(double h : {1e-3, 1e-12, 1e-40}) {
    const Kite kite(h);
    const long double bend = trace_curve<Precise>(kite.mesh, kite.curve).report.strip_bend;
    BOOST_TEST(std::fabs(bend / std::atan(h / 2.0L) - 1) < 1e-8L);
    BOOST_TEST(trace_curve_reliably(kite.mesh, kite.curve).report.points == 3u);
  }
}

BOOST_AUTO_TEST_CASE(a_point)
{
  const Grid grid{2, 2, plane()};
  const Curve_report report = check(grid.mesh(), {0, {vertex_point(grid, 1, 1), vertex_point(grid, 1, 1)}});
  BOOST_TEST(report.broken == 0u);
  BOOST_TEST(report.segments == 0u);
  BOOST_TEST(report.length == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(wrong_curves)

BOOST_AUTO_TEST_CASE(moved_crossing)
{
  const Grid grid{8, 4, plane()};
  const Mesh mesh = grid.mesh();
  const Polyline line = straight_line(grid, 0, 0, 7, 3);
  for(std::size_t i = 1; i + 1 < line.points.size(); ++i)
    for(double shift : {1e-4, -1e-4}) {
      Polyline moved = line;
      Polyline_point& point = moved.points[i];
      point.t += shift;
      const Mesh::Point &p = mesh.point(point.a), &q = mesh.point(point.b);
      for(int k = 0; k < 3; ++k)
        point.position[k] = p[k] + point.t * (q[k] - p[k]);
      const Curve_report report = check(mesh, moved);
      BOOST_TEST(report.broken == 0u);
      BOOST_TEST(report.strip_bend == 0); // the strip is still right
      BOOST_TEST(report.point_deviation > 4e-6L);
      BOOST_TEST(report.point_deviation < 2e-5L);
      BOOST_TEST(report.raw_bend > 1e-5L);
      BOOST_TEST(!is_geodesic(report));
    }
}

BOOST_AUTO_TEST_CASE(wrong_side_of_a_vertex)
{
  for(double h : {1.0, 1e-2, 1e-5, 4e-6, 1e-9, 1e-15, 0.0, -1e-9, -1e-3}) {
    const Kite kite(h);
    const Curve_report report = check(kite.mesh, kite.curve);
    const long double expected = h > 0 ? std::atan(h / 2.0L) : 0;
    BOOST_TEST_CONTEXT("h = " << h)
    {
      BOOST_TEST(report.broken == 0u);
      BOOST_TEST(std::fabs(report.strip_bend - expected) <= 1e-15L * expected);
      BOOST_TEST(is_geodesic(report) == (expected < 1e-6L));
      if(h >= 0)
        BOOST_TEST(std::fabs(report.raw_bend - 2 * expected) < 1e-15L);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_edge)
{
  const Grid grid{8, 4, plane()};
  const Mesh mesh = grid.mesh();
  const Polyline line = straight_line(grid, 0, 0, 7, 3);
  for(std::size_t i = 1; i + 1 < line.points.size(); ++i) {
    Polyline without = line, doubled = line, other = line, none = line;
    without.points.erase(without.points.begin() + i);
    doubled.points.insert(doubled.points.begin() + i, line.points[i]);
    other.points[i] = edge_point(grid, 7, 4, 8, 4, 0.25);
    none.points[i].b = grid.vertex(8, 0);
    for(const Polyline& wrong : {without, doubled, other, none}) {
      BOOST_TEST(check(mesh, wrong).broken > 0u);
      BOOST_TEST(!is_geodesic(check(mesh, wrong)));
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_points)
{
  const Grid grid{8, 4, plane()};
  const Mesh mesh = grid.mesh();
  const Polyline line = straight_line(grid, 0, 0, 7, 3);
  Polyline displaced = line, outside = line, unknown = line, headless = line, at_end = line;
  displaced.points[3].position[1] += 1e-9;
  outside.points[3].t = 1.5;
  unknown.points[3].a = 1000;
  headless.points.erase(headless.points.begin());
  at_end.points[3].t = 0; // not of a crossing: that is inside
  at_end.points[3].position = mesh.point(at_end.points[3].a);
  for(const Polyline& wrong : {displaced, outside, unknown, headless, at_end})
    BOOST_TEST(check(mesh, wrong).broken == 1u);
  const Polyline jump{0, {vertex_point(grid, 0, 0), vertex_point(grid, 3, 0)}};
  BOOST_TEST(check(mesh, jump).broken == 1u);
}

BOOST_AUTO_TEST_CASE(corner_at_a_vertex)
{
  const Grid grid{8, 4, plane()};
  const Polyline corner = joined(straight_line(grid, 0, 1, 3, 2), straight_line(grid, 3, 2, 8, 3));
  const Curve_report report = check(grid.mesh(), corner);
  const long double turn = std::atan2(1.0L, 3.0L) - std::atan2(1.0L, 5.0L);
  BOOST_TEST(report.strip_bend == 0);
  BOOST_TEST(std::fabs(report.min_vertex_angle - (pi - turn)) < 1e-14L);
  BOOST_TEST(report.min_unblocked_angle == report.min_vertex_angle);
  BOOST_TEST(report.bent_vertices == 1u);
  BOOST_TEST(!is_geodesic(report));
  Joint_options options;
  options.fixed_vertices.insert(grid.vertex(3, 2));
  BOOST_TEST(is_geodesic(check_curves(grid.mesh(), {corner}, options).front()));
}

BOOST_AUTO_TEST_CASE(over_the_corner_of_a_cube)
{
  // Three faces of a cube around the vertex 0, its edges to 1, 2, 3.
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}},
                  {{0, 1, 4}, {0, 4, 2}, {0, 2, 5}, {0, 5, 3}, {0, 3, 6}, {0, 6, 1}});
  const Polyline_point origin{0, 0, 0, {0, 0, 0}}, x{1, 1, 0, {1, 0, 0}}, xy{4, 4, 0, {1, 1, 0}}, z{3, 3, 0, {0, 0, 1}};
  BOOST_TEST(std::fabs(check(mesh, {0, {x, origin, z}}).min_vertex_angle - pi / 2) < 1e-15L);
  const Curve_report diagonal = check(mesh, {0, {xy, origin, z}});
  BOOST_TEST(std::fabs(diagonal.min_vertex_angle - 3 * pi / 4) < 1e-15L);
  BOOST_TEST(std::fabs(diagonal.length - 1 - std::sqrt(2.0L)) < 1e-15L);
}

BOOST_AUTO_TEST_CASE(there_and_back)
{
  const Grid grid{4, 4, plane()};
  const Curve_report report = check(
      grid.mesh(),
      {0, {vertex_point(grid, 0, 0), vertex_point(grid, 1, 0), vertex_point(grid, 2, 0), vertex_point(grid, 1, 0)}});
  BOOST_TEST(report.min_vertex_angle == 0);
  BOOST_TEST(!is_geodesic(report));
}

BOOST_AUTO_TEST_CASE(corner_at_the_base_of_a_loop)
{
  const Grid grid{6, 2, rolled_up(6), true};
  const Mesh mesh = grid.mesh();
  const Polyline loop = joined(straight_line(grid, 0, 0, 3, 1),
                               Polyline{0,
                                        {vertex_point(grid, 3, 1), vertex_point(grid, 4, 1), vertex_point(grid, 5, 1),
                                         vertex_point(grid, 6, 1), vertex_point(grid, 6, 0)}});
  const Curve_report report = check(mesh, loop);
  BOOST_TEST(report.bent_vertices == 3u); // at (3,1), (6,1) and at the base, where one side is the border
  Joint_options options;
  options.bases_are_fixed = true;
  BOOST_TEST(check_curves(mesh, {loop}, options).front().bent_vertices == 2u);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(blocked_joints)

// The curve a-v-b has an angle of pi/2 at v, in which the curve c-v ends.
BOOST_AUTO_TEST_CASE(by_another_curve)
{
  const Grid grid{4, 4, plane()};
  const Mesh mesh = grid.mesh();
  const Polyline bent{0, {vertex_point(grid, 3, 2), vertex_point(grid, 2, 2), vertex_point(grid, 2, 3)}};
  const Polyline inside{1, {vertex_point(grid, 4, 3), edge_point(grid, 3, 2, 3, 3, 0.5), vertex_point(grid, 2, 2)}};
  const Polyline outside{1, {vertex_point(grid, 1, 1), vertex_point(grid, 2, 2)}};
  Joint_options together;
  together.curves_block_each_other = true;
  const auto smallest_unblocked = [&](const Polyline& other, const Joint_options& options) {
    const Curve_report report = check_curves(mesh, {bent, other}, options).front();
    BOOST_TEST(report.bent_vertices == 1u);
    BOOST_TEST(std::fabs(report.min_vertex_angle - pi / 2) < 1e-15L);
    return report.min_unblocked_angle;
  };
  BOOST_TEST(smallest_unblocked(inside, Joint_options()) < pi / 2 + 1e-15L);
  BOOST_TEST(smallest_unblocked(outside, together) < pi / 2 + 1e-15L);
  BOOST_TEST(std::fabs(smallest_unblocked(inside, together) - 3 * pi / 2) < 1e-14L);
}

// The curve goes around its own source and is held up by its first segment.
BOOST_AUTO_TEST_CASE(by_its_own_end)
{
  const Grid grid{4, 4, plane()};
  Polyline curve{0, {}};
  for(const auto& [x, y] : {std::pair(2, 2), {3, 3}, {3, 2}, {2, 2}, {2, 3}})
    curve.points.push_back(vertex_point(grid, x, y));
  curve.points.resize(4);
  curve.points.push_back(vertex_point(grid, 2, 3));
  const Curve_report report = check(grid.mesh(), curve);
  BOOST_TEST(report.bent_vertices == 3u);
  BOOST_TEST(std::fabs(report.min_unblocked_angle - pi / 4) < 1e-14L); // at (3,3); that at (2,2) is blocked

  Segment_ends ends;
  Traced_curve traced = trace_curve(grid.mesh(), curve);
  add_segment_ends(traced, 0, ends);
  traced.report.min_unblocked_angle = infinite_angle;
  measure_joint(grid.mesh(), ends, 0, 2, 3, traced, Tolerances());
  BOOST_TEST(std::fabs(traced.report.min_unblocked_angle - 3 * pi / 2) < 1e-14L);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(stops)

// A stop at any point of the plane: in the triangle that it lies in, on an edge, or at a vertex.
Polyline_point stop(const Grid& grid, double x, double y)
{
  const int i = int(x), j = int(y);
  const double s = x - i, t = y - j;
  const Index a = grid.vertex(i, j), c = grid.vertex(i + 1, j + 1), b = grid.vertex(i + 1, j),
              d = grid.vertex(i, j + 1);
  const Mesh::Point position = grid.lift(x, y);
  if(s == 0 && t == 0)
    return {a, a, 0, position};
  if(t == 0)
    return {a, b, s, position, b, 0};
  if(s == t)
    return {a, c, s, position, c, 0};
  if(t < s)
    return {a, b, s - t, position, c, t};
  return {a, c, s, position, d, t - s};
}

// Crosses the diagonal of its square between two stops on either side.
Polyline over_diagonal(const Grid& grid, double x, double y, double u, double v)
{
  const double r = (x - y) / ((x - y) - (u - v)), at = x + r * (u - x);
  return {0,
          {stop(grid, x, y), edge_point(grid, int(x), int(y), int(x) + 1, int(y) + 1, at - int(x)), stop(grid, u, v)}};
}

BOOST_AUTO_TEST_CASE(straight_between_stops)
{
  const Grid grid{4, 4, plane()};
  const Mesh mesh = grid.mesh();
  const auto expect_length = [&](const Polyline& curve, long double length) {
    const Curve_report report = check(mesh, curve);
    BOOST_TEST(report.first_break == "");
    BOOST_TEST(is_geodesic(report));
    BOOST_TEST(report.segments == 1u);
    BOOST_TEST(std::fabs(report.length / length - 1) < 1e-14L);
  };
  expect_length(over_diagonal(grid, 1.75, 1.25, 1.25, 1.5), std::hypot(0.5L, 0.25L));
  expect_length(over_diagonal(grid, 1.5, 1, 1.25, 1.75), std::hypot(0.25L, 0.75L));
  expect_length({0, {stop(grid, 1.5, 1.25), stop(grid, 1.75, 1.25)}}, 0.25L);               // in one face
  expect_length({0, {stop(grid, 1.5, 1.5), stop(grid, 1.75, 1)}}, std::hypot(0.25L, 0.5L)); // between two edges
  expect_length({0, {stop(grid, 1.25, 1.25), stop(grid, 1.75, 1.75)}}, std::sqrt(0.5L));    // along one
  expect_length({0, {stop(grid, 1, 1), stop(grid, 1.75, 1)}}, 0.75L);
  expect_length({0, {stop(grid, 1, 1), stop(grid, 1.75, 1.25)}}, std::hypot(0.75L, 0.25L));
}

BOOST_AUTO_TEST_CASE(angles_at_stops)
{
  const Grid grid{4, 4, plane()};
  const Mesh mesh = grid.mesh();
  const auto expect_angle = [&](const std::vector<std::pair<double, double>>& places, long double angle) {
    Polyline curve{0, {}};
    for(const auto& [x, y] : places)
      curve.points.push_back(stop(grid, x, y));
    for(int turn = 0; turn < 2; ++turn) {
      const Curve_report report = check(mesh, curve);
      BOOST_TEST(report.first_break == "");
      BOOST_TEST(std::fabs(report.min_vertex_angle - angle) < 1e-12L);
      BOOST_TEST(report.min_unblocked_angle == report.min_vertex_angle);
      BOOST_TEST(is_geodesic(report) == (angle > 3.14L));
      Polyline allowed = curve;
      for(const Polyline_point& point : curve.points)
        allowed.way_points.push_back(point.place());
      BOOST_TEST(is_geodesic(check(mesh, allowed)));
      std::swap(allowed.way_points[0], allowed.way_points[1]);
      BOOST_TEST(check(mesh, allowed).broken > 0u);
      std::reverse(curve.points.begin(), curve.points.end());
    }
  };
  expect_angle({{1.5, 1.25}, {1.75, 1.25}, {1.875, 1.25}}, pi); // inside a face
  expect_angle({{1.5, 1.25}, {1.75, 1.25}, {1.75, 1.5}}, pi / 2);
  expect_angle({{1.5, 1.25}, {1.5, 1.5}, {1.5, 1.75}}, pi);          // over an edge
  expect_angle({{1.5, 1.25}, {1.5, 1.5}, {1.25, 1.5}}, pi / 2);      // in the face on the other side
  expect_angle({{1.25, 1.25}, {1.5, 1.5}, {1.75, 1.75}}, pi);        // along the edge
  expect_angle({{1.25, 1.25}, {1.5, 1.5}, {1.5, 1.75}}, 3 * pi / 4); // from along the edge into a face
  expect_angle({{0.25, 0}, {0.5, 0}, {0.5, 0.25}}, pi / 2);          // on the border, where one side is open
  expect_angle({{0.25, 0}, {0.5, 0}, {0.75, 0}}, pi);
}

BOOST_AUTO_TEST_CASE(wrong_stops)
{
  const Grid grid{4, 4, plane()};
  const Mesh mesh = grid.mesh();
  const Polyline right = over_diagonal(grid, 1.75, 1.25, 1.25, 1.5);
  Polyline turned = right, outside = right, moved = right, unmarked = right, elsewhere = right, bent = right;
  std::swap(turned.points[0].b, turned.points[0].c);
  outside.points[0].u = 1;
  moved.points[0].position[0] += 1e-9;
  unmarked.points[0] = edge_point(grid, 1, 1, 2, 1, 0.5);
  elsewhere.points[2] = stop(grid, 3.25, 3.5);
  for(const Polyline& wrong : {turned, outside, moved, unmarked, elsewhere})
    BOOST_TEST(check(mesh, wrong).broken > 0u);
  bent.points[2] = stop(grid, 1.25, 1.5 + 1e-4);
  BOOST_TEST(check(mesh, bent).broken == 0u);
  BOOST_TEST(!is_geodesic(check(mesh, bent)));
  bent.must_be_closed = true;
  BOOST_TEST(check(mesh, bent).broken == 1u);
}

BOOST_AUTO_TEST_CASE(as_asked_for)
{
  const auto read = [](const std::string& asked, bool are_splines) {
    std::vector<Polyline> curves(2);
    curves[1].id = 1;
    std::istringstream in(asked);
    read_way_points(in, are_splines, curves);
    return curves;
  };
  const auto points = read("# a comment\n3 1,2,0.25 # another\n\n0 1,2,3,0.25,0.5 4\n", false);
  BOOST_TEST((points[0].way_points == std::vector<Place>{Place::vertex(3), Place::on_edge(1, 2, 0.25)}));
  BOOST_TEST((points[1].way_points[1] == Place{1, 2, 3, 0.25, 0.5}));
  const auto splines = read("1 2 3 4\no 1 2 3\n", true);
  BOOST_TEST((splines[0].way_points == std::vector<Place>{Place::vertex(1), Place::vertex(4)}));
  BOOST_TEST(splines[0].may_bend_inside);
  BOOST_TEST(splines[1].must_be_closed);
  BOOST_CHECK_THROW(read("1 2\n", false), Bad_input); // there are two curves
  BOOST_TEST(is_same_place({1, 2, 3, 0.25, 0.5}, {2, 3, 1, 0.5, 0.25}));
  BOOST_TEST(is_same_place({1, 2, 3, 0.25, 0}, Place::on_edge(2, 1, 0.75)));
  BOOST_TEST(!is_same_place({1, 2, 3, 0.25, 1e-12}, Place::on_edge(2, 1, 0.75)));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(files)

const std::string two_lines = "# curve a b t x y z\n\n0 0 0 0 0 0 0\r\n0 1 1 0 1 0 0\n";

std::vector<Polyline> read(const std::string& text)
{
  std::istringstream in(text);
  return read_polylines(in);
}

std::map<long, Verdict> judge_with(const std::string& polylines, const std::string& stats)
{
  std::istringstream in(stats);
  return judge_curves(Grid{1, 1, plane()}.mesh(), read(polylines), read_stats(in));
}

BOOST_AUTO_TEST_CASE(polylines)
{
  const std::vector<Polyline> curves = read(two_lines + "7 0 2 0.25 0 0.25 0\n");
  BOOST_REQUIRE(curves.size() == 2u);
  BOOST_TEST(curves[0].points.size() == 2u);
  BOOST_TEST(curves[1].id == 7);
  BOOST_TEST(curves[1].points[0].b == 2u);
  BOOST_TEST(curves[1].points[0].t == 0.25);
  const std::vector<Polyline> inside = read("0 0 1 2 0.25 0.5 0.25 0.5 0\n0 0 1 1 0.5 0 0.5 0 0\n");
  BOOST_TEST((inside[0].points[0].place() == Place{0, 1, 2, 0.25, 0.5}));
  BOOST_TEST(inside[0].points[1].place().is_on_edge());
  for(const std::string wrong :
      {"0 1 1 0 1 0\n", "0 1 1 0 1 0 0 0\n", "0 a 1 0 1 0 0\n", "7 0 0 0 0 0 0\n0 1 1 0 1 0 0\n"})
    BOOST_CHECK_THROW(read(two_lines + wrong), Bad_input);
}

BOOST_AUTO_TEST_CASE(statistics)
{
  const std::string header = "curve,source,target,length,status\n";
  BOOST_TEST(judge_with(two_lines, header + "0,0,1,1,LOCALLY_SHORTEST\n").at(0).ok);
  BOOST_TEST(!judge_with(two_lines, header + "0,0,2,1,LOCALLY_SHORTEST\n").at(0).ok);
  BOOST_TEST(!judge_with(two_lines, header + "0,3,1,1,LOCALLY_SHORTEST\n").at(0).ok);
  BOOST_TEST(!judge_with(two_lines, header + "0,0,1,1.00001,LOCALLY_SHORTEST\n").at(0).ok);
  BOOST_TEST(!judge_with(two_lines, header + "1,0,1,1,LOCALLY_SHORTEST\n").at(0).ok);
  BOOST_TEST(!judge_with(two_lines, header + "1,0,1,1,LOCALLY_SHORTEST\n").at(1).ok);
  BOOST_TEST(judge_with("", header + "0,0,0,0,CONTRACTED\n").at(0).ok);
  BOOST_CHECK_THROW(judge_with(two_lines, "source,target\n"), Bad_input);
  BOOST_CHECK_THROW(judge_with(two_lines, header + "0,0\n"), Bad_input);
}

BOOST_AUTO_TEST_CASE(stopped_early)
{
  const std::string corner = two_lines + "0 3 3 0 1 1 0\n", stats = "curve,status\n0,";
  BOOST_TEST(!judge_with(corner, stats + "LOCALLY_SHORTEST\n").at(0).report.broken);
  BOOST_TEST(judge_with(corner, stats + "LENGTH_LIMIT\n").at(0).ok);
}

BOOST_AUTO_TEST_CASE(table)
{
  std::ostringstream out;
  write_verdicts(out, judge_with(two_lines, "curve,status,length\n0,LOCALLY_SHORTEST,1\n"));
  BOOST_TEST(out.str().find("\n0,LOCALLY_SHORTEST,2,1,0,0,0,0,inf,0,inf,1,0,1,\n") != std::string::npos);
}

// A square of which the diagonal is doubled, by a face between vertices 2 and 4, which lie in one place.
BOOST_AUTO_TEST_CASE(vertices_in_one_place)
{
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}});
  BOOST_TEST(mesh.merged(4) == 2u);
  BOOST_TEST(mesh.merged(3) == 3u);
  for(Index end : {2u, 4u}) // on either side of the face without area
    for(double t : {0.5, 0.4}) {
      std::vector<Polyline> curves = {{0, {{1, 1, 0, {1, 0, 0}}, {0, end, t, {t, t, 0}}, {3, 3, 0, {0, 1, 0}}}}};
      Stats stats = {{0, {"LOCALLY_SHORTEST", 1, 3, std::sqrt(2.0)}}};
      merge_vertices(mesh, curves, stats);
      BOOST_TEST(judge_curves(mesh, curves, stats).at(0).ok == (t == 0.5));
    }
  std::vector<Polyline> along = {{0, {{0, 0, 0, {0, 0, 0}}, {4, 4, 0, {1, 1, 0}}}}};
  Stats none;
  merge_vertices(mesh, along, none);
  BOOST_TEST(std::fabs(check(mesh, along.front()).length - std::sqrt(2.0L)) < 1e-15L);
}

BOOST_AUTO_TEST_CASE(bad_meshes)
{
  const std::vector<Mesh::Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  BOOST_CHECK_THROW(Mesh(points, {{0, 1, 3}}), Bad_input);
  BOOST_CHECK_THROW(Mesh(points, {{0, 1, 1}}), Bad_input);
  BOOST_CHECK_THROW(Mesh(points, {{0, 1, 2}, {1, 2, 0}}), Bad_input);
  BOOST_CHECK_THROW(Mesh({{0, 0, 0}, {1, std::nan(""), 0}, {0, 1, 0}}, {{0, 1, 2}}), Bad_input);
}

BOOST_AUTO_TEST_SUITE_END()
