// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which vertices straightest geodesics meet: exactly, on surfaces that are flat about them and from beside them.

#include "closed_forms.h"
#include "generated_meshes.h"
#include "mesh_soup.h"
#include "rays.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/boost/graph/generators.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace rays_test;

BOOST_AUTO_TEST_CASE(vertices_on_its_way_are_met_exactly)
{
  const Surface mesh = grid_mesh();
  for(int x = -5; x <= 5; ++x)
    for(int y = -5; y <= 5; ++y) {
      if(x == 0 && y == 0)
        continue;
      const Vector v(x, y, 0), first = v / std::gcd(x, y);
      const double size = std::sqrt(first.squared_length());
      const Traced stopped = trace_from_middle(mesh, v, 100, At_vertices::STOP);
      BOOST_TEST((stopped.result.status() == Trace_status::VERTEX));
      BOOST_TEST(stopped.result.report.vertices == 0u);
      BOOST_TEST(std::abs(stopped.result.length() - size) < 1e-14 * size);
      BOOST_TEST(distance(stopped.points.back(), Point(6, 6, 0) + first) < 1e-14);
      const Traced passed = trace_from_middle(mesh, v, 1.1 * size);
      BOOST_TEST((passed.result.status() == Trace_status::LENGTH));
      BOOST_TEST(passed.result.report.vertices == 1u);
      BOOST_TEST(distance(passed.points.back(), Point(6, 6, 0) + passed.result.length() / size * first) < 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(flat_vertices_are_passed_without_rounding)
{
  // Each step would miss the next vertex by rounding: the columns are by turns the roots of 1, 2, 25/16 and 10 wide.
  constexpr int n = 60, m = 40;
  for(const double height : {0.0, 1.0, 0.75, 3.0})
    for(const Diagonal_rule rule : {Diagonal_rule::ALTERNATING, Diagonal_rule::RANDOM}) {
      const Surface mesh = folded_grid(n, m, height, rule);
      for(const auto& [a, b] : std::vector<std::pair<int, int>>{
              {1, 0}, {1, 1}, {1, -1}, {2, 1}, {3, -2}, {3, 1}, {5, 3}, {1, 4}, {7, -2}, {0, 1}, {0, -1}})
      {
        const std::array<int, 2> start = {2, b > 0 ? 2 : (b < 0 ? 38 : 20)};
        const Traced t = trace_from(mesh, Vertex(grid_vertex(n, start[0], start[1])), Vector(a, b, height * a), 1e3);
        BOOST_TEST((t.result.status() == Trace_status::BORDER));
        std::size_t passed = 0, at = 0;
        for(int x = start[0] + a, y = start[1] + b; x < n && y < m && y > 0; x += a, y += b, ++passed) {
          const Point p = mesh.point(Vertex(grid_vertex(n, x, y)));
          while(at < t.points.size() && t.points[at] != p)
            ++at;
        }
        BOOST_TEST(at < t.points.size()); // all of them, in their order
        BOOST_TEST(t.result.report.vertices == passed);
        BOOST_TEST(t.result.report.statistics.unproven_zeros == 0u);
        BOOST_TEST(std::abs(length_of(t.points) - t.result.length()) < 1e-12);
      }
    }
}

BOOST_AUTO_TEST_CASE(flat_vertices_are_passed_without_rounding_from_inside_a_face)
{
  constexpr int n = 40, m = 24;
  const Surface mesh = folded_grid(n, m, 0, Diagonal_rule::RANDOM);
  for(const Face f : {Face(300), Face(771)}) {
    const Face_location source = {f, {0.25, 0.25, 0.5}};
    const Point start = point_at(mesh, source);
    for(int p = 1; p < 12; ++p)
      for(int q = -9; q < 9; ++q) {
        if(std::gcd(p, q) != 1)
          continue;
        const Traced t = trace(mesh, source, Vector(p, q, 0), 1e3);
        std::size_t passed = 0; // all is in quarters
        for(int x = int(4 * start.x()) + p, y = int(4 * start.y()) + q; x < 4 * n && y > 0 && y < 4 * m; x += p, y += q)
          passed += x % 4 == 0 && y % 4 == 0 ? 1 : 0;
        BOOST_TEST(t.result.report.vertices == passed);
        const Point end = t.points.back();
        BOOST_TEST(std::abs((end.x() - start.x()) * q - (end.y() - start.y()) * p) < 1e-12);
      }
  }
}

BOOST_AUTO_TEST_CASE(on_a_cube_it_comes_back_to_its_start_exactly)
{
  const Surface mesh = to_mesh<Surface>(cube(4));
  const auto vertex_at = [&mesh](const Point& p) {
    for(const Vertex v : mesh.vertices())
      if(mesh.point(v) == p)
        return v;
    throw std::logic_error("no vertex is there");
  };
  // Around six faces, through 12 vertices in each round; edges are crossed where vertices are.
  const double round = 12 * std::sqrt(2.0);
  for(const Point& start : {Point(1, 2, 4), Point(2, 1, 4), Point(1, 2, 0)}) {
    const Traced t = trace_from(mesh, vertex_at(start), Vector(1, 1, 0), 100 * round + 0.5);
    BOOST_TEST(t.result.report.vertices == 1200u);
    std::size_t visits = 0;
    for(const Point& p : t.points)
      visits += p == start ? 1 : 0;
    BOOST_TEST(visits == 101u);
    const double half = 0.5 / std::sqrt(2.0);
    BOOST_TEST(distance(t.points.back(), start + Vector(half, half, 0)) < 1e-9); // of a length of 1700
  }
}

// The faces of a tetrahedron with equal opposite edges unfold to a tiling of the plane with translated lines: an edge
// is crossed wherever a barycentric coordinate passes an integer. Doubles do not decide all corners of such a long ray,
// and numbers of any fixed number of digits would not if their errors grew by a factor with each face.
BOOST_AUTO_TEST_CASE(rays_over_two_hundred_thousand_edges_are_decided_by_few_digits)
{
  const Point points[] = {{0, 0, 0}, {3, 4, 0}, {3, 0, 5}, {0, 4, 5}};
  Surface mesh;
  CGAL::make_tetrahedron(points[0], points[1], points[2], points[3], mesh);
  std::size_t by_precision = 0;
  for(const double slope : {0.381966, 1.7320508}) {
    const Face face(0);
    const Halfedge h = mesh.halfedge(face);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = mesh.point(mesh.target(mesh.next(h)));
    const Vector v = (q - p) + slope * (r - p);
    const double length = 500000, rate = length / std::sqrt(v.squared_length());
    const Traced t = trace(mesh, Face_location(face, {0.25, 0.375, 0.375}), v, length);
    BOOST_TEST((t.result.status() == Trace_status::LENGTH));
    std::size_t crossed = 0;
    for(const auto& [start, change] :
        {std::make_pair(0.25, -1 - slope), std::make_pair(0.375, 1.0), std::make_pair(0.375, slope)})
    {
      const double end = start + rate * change, beyond = std::abs(end - std::round(end));
      BOOST_TEST(beyond > 1e-6);
      crossed += static_cast<std::size_t>(std::abs(std::floor(end)));
    }
    BOOST_TEST(t.result.report.edges == crossed);
    BOOST_TEST(crossed > 200000u);
    BOOST_TEST(t.result.report.statistics.by_roots == 0u);
    by_precision += t.result.report.statistics.by_precision;
  }
  BOOST_TEST(by_precision > 0u);
}

BOOST_AUTO_TEST_CASE(lengths_say_that_vertices_are_flat)
{
  // A torus of congruent triangles has no curvature, whatever their sides are.
  constexpr int n = 15, m = 8, steps = 300;
  using Length_map = Surface::Property_map<Surface::Edge_index, double>;
  using Metric = FG::Edge_length_metric<Surface, Length_map>;
  using Triangulation = FG::Intrinsic_triangulation<Surface, FG::Intrinsic_triangulation_traits<Kernel>, Metric>;
  Surface mesh = to_mesh<Surface>(torus(n, m, 2, 1));
  const Length_map lengths = mesh.add_property_map<Surface::Edge_index, double>("e:length", 1).first;
  for(const std::array<double, 3>& sides : {std::array<double, 3>{1, 1, 1}, {13, 14, 15}, {2, 3, 4}}) {
    for(const auto e : mesh.edges()) {
      const unsigned u = mesh.vertex(e, 0), v = mesh.vertex(e, 1);
      lengths[e] = u / n == v / n ? sides[0] : (u % n == v % n ? sides[1] : sides[2]);
    }
    const Triangulation triangulation(mesh, Metric(mesh, lengths));
    const FG::Geodesic_tracer<Triangulation> tracer(triangulation);
    const Halfedge along = mesh.halfedge(Vertex(0), Vertex(1)); // its face has the diagonal
    const FG::Surface_location start = {triangulation.input().index(along), {{1, 0, 0}}};
    for(const auto& [a, b] : std::vector<std::pair<int, int>>{{1, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 3}, {5, 4}}) {
      const double dot = 0.5 * (sides[0] * sides[0] + sides[2] * sides[2] - sides[1] * sides[1]);
      const double step = std::sqrt(a * a * sides[0] * sides[0] + b * b * sides[2] * sides[2] + 2 * a * b * dot);
      std::vector<FG::Index> expected, passed;
      for(int k = 1; k <= steps; ++k)
        expected.push_back(k * (a + b) % n + n * (k * b % m));
      std::vector<FG::Surface_point> points;
      const FG::Trace_report trace = tracer.trace(start, std::array<double, 2>{double(a), double(b)},
                                                  (steps + 0.5) * step, std::back_inserter(points));
      for(std::size_t i = 1; i < points.size(); ++i)
        if(points[i].is_vertex())
          passed.push_back(points[i].a.idx());
      BOOST_TEST((trace.status == Trace_status::LENGTH));
      BOOST_TEST(passed == expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_vertex_that_it_misses_by_the_last_digit_is_missed)
{
  const Surface mesh = grid_mesh();
  for(double y : {std::nextafter(2.0, 3.0), std::nextafter(2.0, 1.0)}) {
    const Traced t = trace_from_middle(mesh, Vector(1, y, 0), 6, At_vertices::STOP);
    BOOST_TEST((t.result.status() == Trace_status::LENGTH));
    BOOST_TEST(t.result.report.vertices == 0u);
    BOOST_TEST(t.result.report.statistics.by_roots + t.result.report.statistics.by_precision > 0u);
  }
}

BOOST_AUTO_TEST_CASE(vertices_are_met_exactly_from_inside_a_face)
{
  const Surface mesh = grid_mesh();
  std::size_t rays = 0;
  for(const std::array<double, 3>& weights : {std::array<double, 3>{0.5, 0.25, 0.25}, {0.125, 0.25, 0.625}})
    for(const Face f : {Face(130), Face(155)})
      for(const Vertex v : mesh.vertices()) {
        const Point start = point_at(mesh, {f, weights});
        const Vector way = mesh.point(v) - start;
        const Traced t =
            trace(mesh, Face_location{f, weights}, way, 100, CGAL::parameters::at_vertices(At_vertices::STOP));
        const double part = t.result.length() / std::sqrt(way.squared_length()); // of the way, up to its first vertex
        const bool is_at_v = part > 1 - 1e-14;
        BOOST_TEST(part < 1 + 1e-14);
        BOOST_TEST((t.result.status() == (is_at_v && mesh.is_border(v) ? Trace_status::BORDER : Trace_status::VERTEX)));
        BOOST_TEST(distance(t.points.back(), start + part * way) < 1e-13);
        rays += is_at_v ? 1 : 0;
      }
  BOOST_TEST(rays > 300u);
}

BOOST_AUTO_TEST_CASE(directions_at_a_vertex_are_told_from_each_side_of_its_faces)
{
  const Surface mesh = grid_mesh();
  const Vertex middle(grid_vertex(12, 6, 6));
  for(const Halfedge arriving : mesh.halfedges_around_target(mesh.halfedge(middle)))
    for(const Halfedge side : mesh.halfedges_around_face(arriving))
      for(double direction : {0.1, 1.3, 2.9, 4.4, 5.9}) {
        const Vector along = mesh.point(mesh.target(side)) - mesh.point(mesh.source(side));
        const Traced t = trace(mesh, middle, std::make_pair(side, direction - std::atan2(along.y(), along.x())), 3);
        BOOST_TEST(distance(t.points.back(), Point(6 + 3 * std::cos(direction), 6 + 3 * std::sin(direction), 0)) <
                   1e-13);
      }
}
