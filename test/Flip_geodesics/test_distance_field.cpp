// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE distance_field

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/internal/windows/Window_search.h>
#include <CGAL/Flip_geodesics/network_builders.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

namespace {

using Setting = Curve_setting;
using Triangulation = Setting::Triangulation;
using Mesh = Triangulation::Triangle_mesh;
using Field = FG::Geodesic_distance_field<Triangulation>;
using Location = FG::Surface_location;
using Point = Triangulation::Metric::Point_3;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Asked_surface
{
  explicit Asked_surface(const Mesh_soup& soup)
    : mesh(to_mesh<Mesh>(soup))
    , triangulation(mesh)
  {
  }

  Point at(const Location& p) const { return point_in_space(triangulation, surface_point(triangulation, p)); }

  // A location in a random face; on an edge or at a vertex each fourth time.
  Location random_location(std::mt19937& random) const
  {
    Location result;
    do
      result.halfedge = FG::Input_halfedge_index(
          static_cast<FG::Index>(random() % static_cast<unsigned>(triangulation.number_of_halfedges())));
    while(triangulation.input().is_border(result.halfedge));
    for(double& weight : result.weights)
      weight = 1e-3 + static_cast<double>(random() % 1000);
    const unsigned kind = random() % 8;
    result.weights[2] = kind < 2 ? 0 : result.weights[2];
    result.weights[1] = kind < 1 ? 0 : result.weights[1];
    return result;
  }

  Location vertex(int v) const { return {triangulation.input().outgoing(Vertex_index(v)), {{1, 0, 0}}}; }

  Mesh mesh;
  Triangulation triangulation;
};

double distance_in_space(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

void check_close(double a, double b, double scale, const std::string& what)
{
  BOOST_TEST(std::abs(a - b) <= 1e-9 * scale, what << ": " << a << " and " << b);
}

// The path has the length of the distance, and ends at a source.
void check_path(const Asked_surface& s, const Field& field, const Location& from, double scale)
{
  std::vector<Point> points;
  field.path(from, std::back_inserter(points));
  BOOST_REQUIRE(points.size() >= 2u);
  BOOST_TEST(points.size() <= 2 + s.mesh.number_of_edges() + s.mesh.number_of_vertices());
  double length = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    length += distance_in_space(points[i - 1], points[i]);
  check_close(length, field.distance(from), scale, "length of a path");
  check_close(distance_in_space(points.front(), s.at(from)), 0, scale, "start of a path");
}

// The distance grows along the gradient at the rate of one.
void check_gradient(const Asked_surface& s, const Field& field, const Location& at)
{
  if(kind(at) != FG::Location_kind::FACE)
    return;
  const auto g = field.gradient_in_space(at);
  BOOST_TEST(std::abs(g.squared_length() - 1) < 1e-6);
  const auto plane = field.gradient(at);
  BOOST_TEST(std::abs(std::hypot(plane[0], plane[1]) - 1) < 1e-9);
  // In the face the function is 1-Lipschitz and bends away from the gradient at one point only; so compare in pieces.
  constexpr double h = 1e-5;
  const auto& input = s.triangulation.input();
  const auto hn = input.next(at.halfedge);
  const auto corner = [&](auto e) { return s.triangulation.metric().point(input, input.tail(e)); };
  const double sum = at.weights[0] + at.weights[1] + at.weights[2];
  const Point p = corner(at.halfedge);
  for(int i : {1, 2}) {
    Location moved = at;
    for(double& weight : moved.weights)
      weight /= sum;
    if(moved.weights[0] < 2 * h)
      return;
    moved.weights[i] += h;
    moved.weights[0] -= h;
    const auto along = (corner(i == 1 ? hn : input.next(hn)) - p) * h;
    const double grown = field.distance(moved) - field.distance(at), told = g * along;
    BOOST_TEST(grown <= told + 1e-3 * std::sqrt(along.squared_length())); // concave where paths meet, else equal
  }
}

std::vector<std::pair<std::string, Mesh_soup>> meshes()
{
  return {{"bumpy sphere", bumpy_sphere(8, 0.3, 1)},
          {"torus", torus(20, 12, 2, 1)},
          {"jittered grid", jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.2, 3)},
          {"grid with a hole", grid_with_hole(9, 9, 3, 6, 2, 5)},
          {"plate of genus 3", genus_3_plate(2)},
          {"cube", cube(4)},
          {"needles", needle_strip(6, 6, 50)},
          {"saddle", saddle_disk(6, 4, 3 * pi)},
          {"lantern", lantern(8, 8)},
          {"flat grid", flat_grid(14, 14, Diagonal_rule::RANDOM)},
          {"convex polyhedron", random_convex_polyhedron(60, 5)}};
}

} // namespace

BOOST_AUTO_TEST_CASE(distances_of_vertices_are_those_of_the_window_search)
{
  for(const auto& [name, soup] : meshes()) {
    const Asked_surface s(soup);
    for(int v : {0, s.triangulation.number_of_vertices() / 2}) {
      FG::internal::Unfolded_faces<Triangulation> faces(s.triangulation);
      FG::internal::Window_search<Triangulation> search(s.triangulation, faces, Vertex_index(v));
      search.run(infinity);
      for(const auto extent : {FG::Distance_field_extent::EVERYWHERE, FG::Distance_field_extent::VERTICES_ONLY}) {
        Field field(s.triangulation, s.mesh, extent);
        BOOST_TEST(field.add_source(Vertex_index(v)) == 0u);
        const auto report = field.compute();
        BOOST_TEST((report.status == FG::Distance_field_status::COMPLETE));
        BOOST_TEST(!report.has_flat_face);
        BOOST_TEST(report.windows <= search.number_of_windows() + 100);
        for(Vertex_index w : descriptors<Vertex_index>(s.triangulation.number_of_vertices()))
          BOOST_TEST(std::abs(field.distance(w) - search.distance(w)) <= 1e-11 * search.distance(w), name << w);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_paths_and_gradients_anywhere_agree_with_cgal)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Method = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Exact_mesh>>;
  std::mt19937 random(7);
  for(const auto& [name, soup] : meshes()) {
    if(name == "flat grid") // there it is CGAL's that are too long
      continue;
    const Asked_surface s(soup);
    const Exact_mesh mesh = to_mesh<Exact_mesh>(soup);
    Method method(mesh);
    Field field(s.triangulation, s.mesh);
    const auto face_location = [&](const Location& p) {
      return FG::face_location(s.triangulation, s.mesh, surface_point(s.triangulation, p));
    };
    for(int i = 0; i < 3; ++i) {
      Location source = s.random_location(random);
      while(kind(source) != FG::Location_kind::FACE) // CGAL's are wrong for sources at vertices told by a face
        source = s.random_location(random);
      const auto [face, weights] = face_location(source);
      method.add_source_point(face, {{weights[0], weights[1], weights[2]}});
      field.add_source(source);
    }
    field.compute();
    int too_long = 0;
    for(int i = 0; i < 1000; ++i) {
      const Location at = s.random_location(random);
      const auto [face, weights] = face_location(at);
      const double expected =
          method.shortest_distance_to_source_points(face, {{weights[0], weights[1], weights[2]}}).first;
      const auto answer = field.answer(at);
      BOOST_TEST(answer.distance <= expected + 1e-9 * (1 + expected), name);
      if(answer.distance < expected - 1e-9 * (1 + expected)) { // where faces lie in one plane, CGAL's can be too long
        check_path(s, field, at, 1 + expected);
        ++too_long;
      }
      const auto in_face = field(face, weights);
      check_close(answer.distance, in_face.distance, 1 + expected, name);
      if(i % 10 == 0)
        check_path(s, field, at, 1 + expected);
      if(i % 10 == 0 && answer.distance > 1e-2)
        check_gradient(s, field, at);
    }
    BOOST_TEST(too_long <= (name == "saddle" ? 30 : 0), name);
  }
}

BOOST_AUTO_TEST_CASE(distances_in_the_plane)
{
  std::mt19937 random(3);
  const Asked_surface s(flat_grid(14, 14, Diagonal_rule::RANDOM));
  for(int round = 0; round < 5; ++round) {
    Field field(s.triangulation, s.mesh);
    std::vector<Point> sources;
    std::vector<double> offsets;
    for(int i = 0; i < 4; ++i) {
      const Location source = s.random_location(random);
      sources.push_back(s.at(source));
      offsets.push_back(0.5 * i);
      field.add_source(source, offsets.back());
    }
    field.compute();
    for(int i = 0; i < 300; ++i) {
      const Location at = s.random_location(random);
      double nearest = infinity;
      for(std::size_t k = 0; k < sources.size(); ++k)
        nearest = (std::min)(nearest, offsets[k] + distance_in_space(s.at(at), sources[k]));
      const auto answer = field.answer(at);
      check_close(answer.distance, nearest, 1 + nearest, "plane");
      check_close(offsets[answer.source] + distance_in_space(s.at(at), sources[answer.source]), nearest, 1 + nearest,
                  "nearest source");
    }
  }
}

// Almost as near to all places as the first source lets it be, the second one is the nearest in a narrow region only: on
// edges across it, in the middle. The same beside a row of edges, whose rays are parallel.
BOOST_AUTO_TEST_CASE(narrow_regions_in_the_plane)
{
  std::mt19937 random(17);
  const Asked_surface s(flat_grid(5, 5, Diagonal_rule::RANDOM));
  std::vector<Location> row;
  for(int i = 0; i <= 5; ++i)
    row.push_back(s.vertex(grid_vertex(5, i, 2)));
  for(int round = 0; round < 60; ++round) {
    const Location first = s.random_location(random), second = s.random_location(random);
    const Point p = s.at(first), q = s.at(second);
    const double offset = (round % 2 == 0 ? 0.97 : 0.995) * distance_in_space(p, q);
    Field field(s.triangulation, s.mesh);
    field.add_source(round % 3 == 0 ? second : first, round % 3 == 0 ? offset : 0);
    field.add_source(round % 3 == 0 ? first : second, round % 3 == 0 ? 0 : offset);
    field.compute();
    for(int i = 0; i < 300; ++i) {
      const Location at = s.random_location(random);
      const double nearest = (std::min)(distance_in_space(s.at(at), p), offset + distance_in_space(s.at(at), q));
      check_close(field.distance(at), nearest, 1, "narrow region");
    }
    const double beside = (round % 2 == 0 ? 0.97 : 0.8) * std::abs(q.y() - 2);
    Field from_row(s.triangulation, s.mesh);
    from_row.add_curve(row);
    from_row.add_source(second, beside);
    from_row.compute();
    for(int i = 0; i < 300; ++i) {
      const Location at = s.random_location(random);
      const double nearest = (std::min)(std::abs(s.at(at).y() - 2), beside + distance_in_space(s.at(at), q));
      check_close(from_row.distance(at), nearest, 1, "narrow region beside a row");
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_on_boxes)
{
  std::mt19937 random(19);
  for(const auto& [a, b, c] : {Coordinates{4, 4, 4}, {1, 2, 5}}) {
    const Asked_surface s(box(a, b, c, 4));
    const auto place = [&](const Location& at) {
      const Point p = s.at(at);
      return Coordinates{p.x(), p.y(), p.z()};
    };
    for(int round = 0; round < 6; ++round) {
      const Location source = round == 0 ? s.vertex(0) : s.random_location(random);
      Field field(s.triangulation, s.mesh);
      field.add_source(source);
      field.compute();
      for(int i = 0; i < 100; ++i) {
        const Location at = s.random_location(random);
        const double expected = box_distance(a, b, c, place(source), place(at));
        BOOST_TEST(std::abs(field.distance(at) - expected) <= 1e-12 * (a + b + c));
        check_path(s, field, at, 1);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_on_a_cylinder)
{
  std::mt19937 random(23);
  constexpr int n = 11, m = 5;
  constexpr double radius = 1, height = 3;
  const Asked_surface s(cylinder(n, m, radius, height));
  const double side = polygon_side(n, radius);
  // Where it is when the side is rolled out, up to turns.
  const auto rolled_out = [&](const Location& at) {
    const auto& input = s.triangulation.input();
    std::array<double, 3> along;
    std::array<FG::Input_halfedge_index, 3> h = {at.halfedge, input.next(at.halfedge), {}};
    h[2] = input.next(h[1]);
    for(std::size_t i = 0; i < 3; ++i)
      along[i] = input.tail(h[i]).idx() % n;
    const bool is_at_seam = std::count(along.begin(), along.end(), n - 1.0) > 0;
    double x = 0, sum = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      x += at.weights[i] * (is_at_seam && along[i] == 0 ? n : along[i]);
      sum += at.weights[i];
    }
    return std::array<double, 2>{side * x / sum, s.at(at).z()};
  };
  for(int round = 0; round < 10; ++round) {
    const Location source = s.random_location(random);
    const auto p = rolled_out(source);
    Field field(s.triangulation, s.mesh);
    field.add_source(source);
    field.compute();
    for(int i = 0; i < 200; ++i) {
      const Location at = s.random_location(random);
      const auto q = rolled_out(at);
      double expected = infinity;
      for(int turns : {-1, 0, 1})
        expected = (std::min)(expected, std::hypot(q[0] - p[0] + turns * n * side, q[1] - p[1]));
      BOOST_TEST(std::abs(field.distance(at) - expected) <= 1e-12);
      check_path(s, field, at, 1);
    }
    if(kind(source) == FG::Location_kind::VERTEX) {
      const Vertex_index u = s.triangulation.input().tail(source.halfedge);
      for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices()))
        BOOST_TEST(std::abs(field.distance(v) - cylinder_distance(n, m, radius, height, u.idx(), v.idx())) <= 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(windows_of_an_edge_are_ordered)
{
  // Where there are many ties, some of which are broken later.
  for(const Mesh_soup& soup : {cube(4), cube(8), cylinder(12, 6, 1, 2), saddle_disk(6, 4, 3 * pi)}) {
    const Asked_surface s(soup);
    std::mt19937 random(1);
    for(int round = 0; round < 20; ++round) {
      FG::internal::Window_propagation<Triangulation> propagation(s.triangulation, true);
      for(std::size_t i = 0; i < 3; ++i) {
        const FG::Index v = static_cast<FG::Index>(random() % 1000) % s.triangulation.number_of_vertices();
        propagation.add_vertex(Vertex_index(v), 0.25 * static_cast<double>(i), i);
      }
      propagation.run(infinity, 1000000);
      for(FG::Index e = 0; e < s.triangulation.number_of_halfedges() / 2; ++e) {
        const auto windows = propagation.windows().on_edge(e);
        BOOST_TEST(std::is_sorted(windows.begin(), windows.end(),
                                  [](const auto& v, const auto& w) { return v.from < w.from; }));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(sources_with_offsets_give_the_least_of_single_ones)
{
  std::mt19937 random(5);
  const Asked_surface s(bumpy_sphere(6, 0.3, 4));
  Field all(s.triangulation, s.mesh);
  std::vector<Field> single;
  for(int i = 0; i < 5; ++i) {
    const Location source = s.random_location(random);
    all.add_source(source, 0.1 * i);
    single.emplace_back(s.triangulation, s.mesh);
    single.back().add_source(source, 0.1 * i);
    single.back().compute();
  }
  all.compute();
  for(int i = 0; i < 500; ++i) {
    const Location at = s.random_location(random);
    double least = infinity;
    for(const Field& field : single)
      least = (std::min)(least, field.distance(at));
    const auto answer = all.answer(at);
    check_close(answer.distance, least, 1, "several sources");
    check_close(single[answer.source].distance(at), least, 1, "nearest source");
  }
}

BOOST_AUTO_TEST_CASE(sources_on_edges_and_vertices_are_limits_of_those_in_faces)
{
  std::mt19937 random(13);
  const Asked_surface s(bumpy_sphere(6, 0.3, 8));
  for(int round = 0; round < 20; ++round) {
    Location source = s.random_location(random), near = source;
    source.weights[2] = 0;
    source.weights[1] = round % 2 == 0 ? 0 : source.weights[1];
    for(std::size_t i = 0; i < 3; ++i)
      near.weights[i] = source.weights[i] == 0 ? 1e-9 * source.weights[0] : source.weights[i];
    Field at_source(s.triangulation, s.mesh), beside(s.triangulation, s.mesh);
    at_source.add_source(source);
    at_source.compute();
    beside.add_source(near);
    beside.compute();
    for(int i = 0; i < 200; ++i) {
      const Location at = s.random_location(random);
      BOOST_TEST(std::abs(at_source.distance(at) - beside.distance(at)) < 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_from_curves)
{
  std::mt19937 random(11);
  for(const Mesh_soup& soup : {flat_grid(10, 10, Diagonal_rule::RANDOM), bumpy_sphere(6, 0.3, 2), cube(3)}) {
    const Asked_surface s(soup);
    // A polyline through the middles of faces and edges, one along edges, and a segment inside a face.
    const auto& input = s.triangulation.input();
    FG::Input_halfedge_index h = input.outgoing(Vertex_index(s.triangulation.number_of_vertices() / 2));
    std::vector<Location> across, along;
    for(int i = 0; i < 6 && !input.is_border(h); ++i) {
      across.push_back({h, {{1, 1, 1.5}}});
      h = input.next(h);
      across.push_back({h, {{1, 2, 0}}});
      h = FG::internal::twin_index(h);
    }
    if(input.is_border(h))
      across.pop_back();
    h = input.outgoing(0_v);
    along.push_back(s.vertex(0));
    for(int i = 0; i < 3; ++i) {
      along.push_back({h, {{0, 1, 0}}});
      h = input.next(h);
    }
    for(const std::vector<Location>& curve : {across, along}) {
      Field field(s.triangulation, s.mesh), dense(s.triangulation, s.mesh);
      field.add_curve(curve, 0.25);
      constexpr int steps = 200;
      std::vector<Point> points;
      for(const Location& p : curve)
        points.push_back(s.at(p));
      field.compute();
      // Points close to one another on the curve.
      double spacing = 0;
      for(std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const auto f = FG::internal::common_face(input, FG::internal::canonical_location(input, curve[i]),
                                                 FG::internal::canonical_location(input, curve[i + 1]));
        const auto corner = [&](auto e) { return s.triangulation.metric().point(input, input.tail(e)); };
        const Point a = corner(f), b = corner(input.next(f)), c = corner(input.next(input.next(f)));
        const double area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length());
        for(int k = 0; k <= steps; ++k) {
          const Point p = points[i] + (points[i + 1] - points[i]) * (static_cast<double>(k) / steps);
          const auto part = [&](const Point& u, const Point& v) {
            const double w = std::sqrt(CGAL::cross_product(u - p, v - p).squared_length()) / area;
            return w < 1e-9 ? 0 : w;
          };
          dense.add_source(Location{f, {{part(b, c), part(c, a), part(a, b)}}}, 0.25);
        }
        spacing = (std::max)(spacing, distance_in_space(points[i], points[i + 1]) / steps);
      }
      dense.compute();
      for(int i = 0; i < 300; ++i) {
        const Location at = s.random_location(random);
        const double d = field.distance(at), expected = dense.distance(at);
        BOOST_TEST(d <= expected + 1e-9);
        BOOST_TEST(d >= expected - spacing / 2 - 1e-9);
        // Off the curve the nearest of the dense points is farther by a second order term.
        if(d > 0.25 + 20 * spacing)
          BOOST_TEST(d >= expected - spacing * spacing / (d - 0.25) - 1e-9);
        if(i % 5 == 0) {
          std::vector<Point> path;
          field.path(at, std::back_inserter(path));
          double length = 0;
          for(std::size_t k = 1; k < path.size(); ++k)
            length += distance_in_space(path[k - 1], path[k]);
          check_close(length + 0.25, d, 1 + d, "path to a curve");
          BOOST_TEST(field.distance(at) >= 0.25);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(distances_from_a_line_in_the_plane_are_exact)
{
  // A row of edges across a flat strip, and a geodesic of a network.
  Setting setting(flat_grid(8, 8, Diagonal_rule::RANDOM));
  const auto& mesh = setting.mesh;
  setting.network.add_curve(
      FG::halfedges_through(setting.triangulation, std::vector<Vertex_index>{36_v, 37_v, 38_v}, false), false);
  Field field(setting.triangulation, mesh);
  field.add_curve(setting.network, FG::Curve_index(0));
  field.compute();
  const auto& input = setting.triangulation.input();
  const auto at = [&](Vertex_index v) { return setting.triangulation.metric().point(input, v); };
  const Point p = at(36_v), q = at(38_v);
  for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
    check_close(field.distance(v),
                std::sqrt(CGAL::squared_distance(at(v), CGAL::Segment_3<CGAL::Simple_cartesian<double>>(p, q))), 1,
                "segment");
  setting.network.clear();
}

// Parallel to its sides, so that the rays of some run along others; from a corner; on a side. With a point whose region
// is narrow.
BOOST_AUTO_TEST_CASE(distances_from_segments_in_faces_are_exact)
{
  using Weights = std::array<double, 3>;
  const std::vector<std::pair<Weights, Weights>> segments = {
      {Weights{2, 1, 1}, Weights{1, 2, 1}}, {Weights{6, 1, 1}, Weights{1, 1, 6}}, {Weights{1, 1, 2}, Weights{1, 2, 1}},
      {Weights{3, 1, 0}, Weights{1, 2, 0}}, {Weights{0, 1, 0}, Weights{1, 0, 1}}, {Weights{5, 3, 2}, Weights{1, 3, 7}},
      {Weights{1, 3, 0}, Weights{0, 3, 1}}};
  std::mt19937 random(23);
  const Asked_surface s(flat_grid(4, 4, Diagonal_rule::RANDOM));
  for(const auto& [first, last] : segments)
    for(FG::Index i = 0; i < s.triangulation.number_of_halfedges(); i += 3) {
      const FG::Input_halfedge_index h(i);
      if(s.triangulation.input().is_border(h))
        continue;
      const std::vector<Location> curve = {{h, first}, {h, last}};
      const CGAL::Segment_3<CGAL::Simple_cartesian<double>> segment(s.at(curve[0]), s.at(curve[1]));
      const Location point = s.random_location(random);
      const double offset = (i % 2 == 0 ? 0.9 : 0.98) * std::sqrt(CGAL::squared_distance(s.at(point), segment));
      Field field(s.triangulation, s.mesh), both(s.triangulation, s.mesh);
      field.add_curve(curve);
      field.compute();
      both.add_source(point, offset);
      both.add_curve(curve);
      both.compute();
      for(int k = 0; k < 100; ++k) {
        const Location at = s.random_location(random);
        const double expected = std::sqrt(CGAL::squared_distance(s.at(at), segment));
        check_close(field.distance(at), expected, 1, "segment");
        check_close(both.distance(at), (std::min)(expected, offset + distance_in_space(s.at(at), s.at(point))), 1,
                    "segment and point");
      }
    }
}

// Away from the source also on edges, and beside them, whichever side the place is told from.
BOOST_AUTO_TEST_CASE(gradients_in_the_plane)
{
  std::mt19937 random(29);
  const Asked_surface s(flat_grid(5, 5, Diagonal_rule::RANDOM));
  const auto& input = s.triangulation.input();
  const auto turned = [](const std::array<double, 3>& w) { return std::array<double, 3>{w[1], w[2], w[0]}; };
  const auto check = [&](const Field& field, const Location& at, const Point& nearest) {
    const auto g = field.gradient_in_space(at), away = s.at(at) - nearest;
    if(away.squared_length() > 1e-4)
      BOOST_TEST(std::sqrt((g - away / std::sqrt(away.squared_length())).squared_length()) < 1e-5);
  };
  for(int round = 0; round < 20; ++round) {
    const Location source = s.random_location(random);
    Field field(s.triangulation, s.mesh), line(s.triangulation, s.mesh);
    field.add_source(source);
    field.compute();
    const Location end{source.halfedge, {{1, 2, 3}}};
    const CGAL::Segment_3<CGAL::Simple_cartesian<double>> segment(s.at(source), s.at(end));
    line.add_curve(std::vector<Location>{source, end});
    line.compute();
    for(int i = 0; i < 100; ++i) {
      Location at = s.random_location(random);
      at.weights[2] = i % 3 == 0 ? 0 : (i % 3 == 1 ? 1e-9 : at.weights[2]);
      at.weights[1] += 1; // no vertex
      if(input.is_border(FG::internal::twin_index(at.halfedge)) && i % 3 < 2)
        continue;
      check(field, at, s.at(source));
      const auto direction = segment.to_vector();
      const double t = (s.at(at) - segment.source()) * direction / direction.squared_length();
      if(std::abs(t) > 1e-2 && std::abs(t - 1) > 1e-2)
        check(line, at, segment.source() + direction * (std::min)((std::max)(t, 0.0), 1.0));
    }
    // At sources, also as a point of one, and at vertices there is none.
    const Location corner{source.halfedge, {{0, 1, 0}}};
    for(const Location& at : {source, Location{input.next(source.halfedge), turned(source.weights)}, corner}) {
      BOOST_TEST(field.gradient(at)[0] == 0);
      BOOST_TEST(field.gradient(at)[1] == 0);
    }
    const double sum = source.weights[0] + source.weights[1] + source.weights[2];
    for(const double part : {0.0, 0.3, 0.5, 0.77, 1.0}) {
      Location at = end;
      for(std::size_t k = 0; k < 3; ++k)
        at.weights[k] = part * at.weights[k] / 6 + (1 - part) * source.weights[k] / sum;
      BOOST_TEST(line.gradient(at)[0] == 0);
      BOOST_TEST(line.gradient(at)[1] == 0);
    }
  }
}

// The direction of each point on the way is that in which the path goes on, as for all curves.
BOOST_AUTO_TEST_CASE(paths_as_curve_points)
{
  const Asked_surface s(bumpy_sphere(6, 0.3, 4));
  Field field(s.triangulation, s.mesh);
  field.add_source(3_v);
  field.compute();
  for(int v : {3, 50, 100}) {
    std::vector<FG::Curve_point<Mesh, Point>> points;
    field.path(s.vertex(v), std::back_inserter(points));
    BOOST_REQUIRE(points.size() >= 2u);
    for(std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t from = i + 1 < points.size() ? i : i - 1;
      const auto step = points[from + 1].point - points[from].point;
      const double length = std::sqrt(step.squared_length());
      BOOST_TEST(std::sqrt((points[i].tangent * length - step).squared_length()) <= 1e-12);
    }
  }
}

// What a window says of its rays, against the same told another way.
BOOST_AUTO_TEST_CASE(formulas_of_windows)
{
  std::mt19937 random(37);
  const auto number = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random() % 1000000) / 1e6;
  };
  for(int round = 0; round < 400; ++round) {
    const double length = number(1, 3), angle = number(0.1, 3);
    FG::internal::Window w = {number(0, 0.4), number(0.6, 1), number(-1, 4), number(0.1, 2), 0.25, 0, 0, false, true};
    w.is_far = round % 2 == 0;
    if(w.is_far) {
      w.x = std::cos(angle);
      w.y = std::sin(angle);
    }
    double least = infinity;
    for(int i = 0; i <= 1000; ++i)
      least = (std::min)(least, w.distance(w.from + (w.to - w.from) * i / 1000));
    BOOST_TEST(w.least_distance() <= least + 1e-12);
    BOOST_TEST(w.least_distance() >= least - 1e-5);
    const double b = number(w.from, w.to), height = number(0, 1);
    BOOST_TEST(std::abs(w.slope(b) - (w.distance(b + 1e-5) - w.distance(b - 1e-5)) / 2e-5) < 1e-8);
    const double place = w.crossing(b, height); // the ray does not bend there
    BOOST_TEST(std::abs(w.distance(b, height) - w.distance(place) - std::hypot(b - place, height)) < 1e-12);
    FG::internal::Window mirrored = w;
    mirrored.mirror(length);
    BOOST_TEST(std::abs(mirrored.from + w.to - length) < 1e-12);
    BOOST_TEST(std::abs(mirrored.to + w.from - length) < 1e-12);
    BOOST_TEST(std::abs(mirrored.distance(length - b, height) - w.distance(b, height)) < 1e-12);
  }
}

// About as many windows are made as are kept, those of an edge hardly overlap, and a field of vertices only gives them
// back. Where rays can go on from vertices that cannot be shortest, there are half as many more.
BOOST_AUTO_TEST_CASE(windows_are_few)
{
  using Propagation = FG::internal::Window_propagation<Triangulation>;
  const auto flat = mapped(bumpy_sphere(8, 0.4, 3), [](const Coordinates& p) {
    return Coordinates{p[0], p[1], 0.2 * p[2]};
  });
  const std::vector<std::pair<std::size_t, Mesh_soup>> most_windows = {
      {4400, bumpy_sphere(12, 0.3, 1)}, {12950, jittered_grid(24, 24, Diagonal_rule::RANDOM, 0.2, 3)},
      {5280, torus(26, 14, 2, 1)},      {1700, flat_grid(14, 14, Diagonal_rule::RANDOM)},
      {1760, genus_3_plate(2)},         {2280, flat}};
  std::size_t all_kept = 0, all_room = 0;
  for(const auto& [most, soup] : most_windows) {
    const Asked_surface s(soup);
    const auto& input = s.triangulation.input();
    Propagation whole(s.triangulation, true), passing(s.triangulation, false);
    for(Propagation* propagation : {&whole, &passing}) {
      propagation->add_vertex(5_v, 0, 0);
      propagation->run(infinity, std::numeric_limits<std::size_t>::max());
      BOOST_TEST(propagation->reach() == infinity);
    }
    std::size_t kept = 0, left = 0;
    double covered = 0, length = 0;
    for(FG::Index e = 0; e < s.triangulation.number_of_edges(); ++e) {
      kept += whole.windows().on_edge(e).size();
      left += passing.windows().on_edge(e).size();
      const auto h = FG::Input_halfedge_index(2 * e);
      length += whole.sides().copy(input.is_border(h) ? FG::internal::twin_index(h) : h).length;
      for(const FG::internal::Window& w : whole.windows().on_edge(e))
        covered += w.to - w.from;
    }
    BOOST_TEST(whole.number_of_windows() <= most);
    BOOST_TEST(whole.number_of_windows() <= 1.2 * kept);
    BOOST_TEST(covered <= 1.001 * length);
    BOOST_TEST(passing.number_of_windows() <= 1.01 * whole.number_of_windows());
    BOOST_TEST(passing.windows().capacity() <= 0.4 * whole.windows().capacity());
    BOOST_TEST(left <= 0.02 * kept);
    all_kept += kept;
    all_room += whole.windows().capacity();
  }
  BOOST_TEST(all_room <= 1.75 * all_kept);
}

BOOST_AUTO_TEST_CASE(paths_that_pass_vertices_are_not_lost)
{
  // All places are those of a lattice, so that rays pass vertices exactly, or within rounding.
  for(const Mesh_soup& soup :
      {genus_3_plate(2), box(4, 3, 2, 2), grid_with_hole(9, 9, 3, 6, 2, 5), cylinder(12, 6, 1, 2)})
  {
    const Asked_surface s(soup);
    const FG::Index n = s.triangulation.number_of_halfedges();
    for(FG::Index source : {0, n / 3, n / 2}) {
      FG::Input_halfedge_index h(source);
      h = s.triangulation.input().is_border(h) ? FG::internal::twin_index(h) : h;
      Field field(s.triangulation, s.mesh);
      field.add_source(Location{h, {{1, 1, 0}}});
      field.compute();
      for(FG::Index i = 0; i < n; ++i)
        if(const FG::Input_halfedge_index to(i); !s.triangulation.input().is_border(to))
          for(const auto& weights : {std::array<double, 3>{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}})
            check_path(s, field, Location{to, weights}, 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(limits_of_a_field)
{
  std::mt19937 random(2);
  const Asked_surface s(bumpy_sphere(12, 0.2, 9));
  Field whole(s.triangulation, s.mesh);
  whole.add_source(5_v);
  const auto all = whole.compute();
  Field field(s.triangulation, s.mesh);
  field.add_source(5_v);
  FG::Distance_field_limits limits;
  limits.radius = 0.7;
  const auto near = field.compute(limits);
  BOOST_TEST((near.status == FG::Distance_field_status::RADIUS_REACHED));
  BOOST_TEST(near.windows < all.windows / 2);
  for(int i = 0; i < 500; ++i) {
    const Location at = s.random_location(random);
    if(whole.distance(at) <= field.reach())
      BOOST_TEST(std::abs(whole.distance(at) - field.distance(at)) < 1e-12);
    else
      BOOST_TEST(field.distance(at) == infinity);
  }
  BOOST_TEST(field.reach() >= limits.radius);
  const Location in_face{s.triangulation.input().outgoing(20_v), {{1, 2, 3}}};
  for(const double radius : {10.0, infinity})
    for(const bool is_vertex_last : {false, true}) {
      Field some(s.triangulation, s.mesh);
      some.add_source(5_v);
      limits.radius = radius;
      limits.targets = {s.vertex(0), in_face};
      if(is_vertex_last)
        std::swap(limits.targets[0], limits.targets[1]);
      const auto targets = some.compute(limits);
      BOOST_TEST((targets.status == FG::Distance_field_status::TARGETS_REACHED));
      for(const Location& target : limits.targets)
        BOOST_TEST(std::abs(whole.distance(target) - some.distance(target)) < 1e-12);
    }
  limits.radius = infinity;
  field.compute(limits);
  limits.targets.clear();
  limits.windows = FG::Window_limit(10);
  Field small(s.triangulation, s.mesh);
  small.add_source(5_v);
  BOOST_TEST((small.compute(limits).status == FG::Distance_field_status::WINDOW_LIMIT_REACHED));
  limits.windows = FG::Window_limit();
  BOOST_TEST((small.compute(limits).status == FG::Distance_field_status::COMPLETE));
  for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
    BOOST_TEST(small.distance(v) == whole.distance(v));
    BOOST_TEST((field.distance(v) == infinity || std::abs(field.distance(v) - whole.distance(v)) < 1e-12));
  }
}

// Each distance up to the reach is known, wherever the front stands.
BOOST_AUTO_TEST_CASE(growing_radii)
{
  std::mt19937 random(31);
  const Mesh_soup rough = mapped(flat_grid(8, 8, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
    return Coordinates{p[0], p[1], static_cast<double>(random() % 1000) / 400};
  });
  for(const Mesh_soup& soup : {bumpy_sphere(6, 0.4, 9), flat_grid(8, 8, Diagonal_rule::RANDOM), cube(3), rough}) {
    const Asked_surface s(soup);
    const Location source = s.random_location(random), other = s.random_location(random);
    const std::vector<Location> curve = {{source.halfedge, {{5, 1, 1}}}, {source.halfedge, {{1, 2, 4}}}};
    Field whole(s.triangulation, s.mesh), field(s.triangulation, s.mesh);
    double largest = 0;
    for(Field* f : {&whole, &field}) {
      f->add_curve(curve, 0.1);
      f->add_source(other, 0.2);
    }
    whole.compute();
    for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices()))
      largest = (std::max)(largest, whole.distance(v));
    std::vector<Location> places;
    for(int k = 0; k < 1000; ++k)
      places.push_back(s.random_location(random));
    std::vector<double> distances;
    for(const Location& at : places)
      distances.push_back(whole.distance(at));
    for(int i = 1; i < 100; ++i) {
      FG::Distance_field_limits limits;
      limits.radius = largest * i / 100;
      field.compute(limits);
      for(std::size_t k = 0; k < places.size(); ++k)
        if(distances[k] <= field.reach() && distances[k] > field.reach() - 0.2 * largest)
          BOOST_TEST(std::abs(distances[k] - field.distance(places[k])) < 1e-12);
    }
  }
}

// Rays can be lost in a face that is almost a line.
BOOST_AUTO_TEST_CASE(flat_faces_are_told)
{
  for(double height : {1e-11, 1e-3}) {
    const Asked_surface s(Mesh_soup{{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}, {1, height, 0}, {0.9, -1, 0}},
                                    {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}}});
    Field field(s.triangulation, s.mesh);
    field.add_source(5_v);
    BOOST_TEST(field.compute().has_flat_face == (height < 1e-10));
  }
}

BOOST_AUTO_TEST_CASE(the_default_limit_grows_like_the_windows)
{
  double windows = 0;
  for(int n : {40, 80}) { // four times the vertices have eight times the windows
    const Asked_surface s(torus(n, n, 2, 1));
    Field field(s.triangulation, s.mesh, FG::Distance_field_extent::VERTICES_ONLY);
    field.add_source(0_v);
    const double more = static_cast<double>(field.compute().windows);
    BOOST_TEST(more < 9 * (windows > 0 ? windows : more));
    windows = more;
  }
  for(double vertices : {1e6, 1e8})
    BOOST_TEST(static_cast<double>(FG::Window_limit()(static_cast<std::size_t>(vertices))) >
               2 * windows * std::pow(vertices / (80 * 80), 1.5));
}

BOOST_AUTO_TEST_CASE(sources_at_special_places)
{
  // An end in the face of a source; the source itself; a vertex given as a location; a source on the border.
  const Asked_surface s(flat_grid(4, 4, Diagonal_rule::RANDOM));
  const auto& input = s.triangulation.input();
  FG::Input_halfedge_index border(0);
  while(!input.is_border(border))
    ++border;
  const FG::Input_halfedge_index inside = FG::internal::twin_index(border);
  for(const Location& source : {Location{inside, {{1, 1, 1}}}, Location{inside, {{1, 2, 0}}},
                                Location{border, {{1, 1, 0}}}, Location{inside, {{0, 0, 1}}}, s.vertex(0)})
  {
    Field field(s.triangulation, s.mesh);
    field.add_source(source);
    field.compute();
    BOOST_TEST(field.distance(source) < 1e-15);
    for(const Location& at : {Location{inside, {{1, 5, 3}}}, Location{inside, {{3, 1, 0}}},
                              Location{border, {{1, 7, 0}}}, Location{inside, {{0, 1, 0}}}, s.vertex(7)})
    {
      check_close(field.distance(at), distance_in_space(s.at(at), s.at(source)), 1, "in one face");
      check_path(s, field, at, 1);
    }
    check_path(s, field, source, 1);
    // The same vertex in every way that it can be told.
    for(FG::Index i = 0; i < input.number_of_halfedges(); ++i)
      if(const FG::Input_halfedge_index h(i); input.tail(h) == 7_v)
        BOOST_TEST(field.distance(Location{h, {{1, 0, 0}}}) == field.distance(7_v));
  }
}

// Two fans that share a vertex only: beyond the border all directions are open.
BOOST_AUTO_TEST_CASE(paths_pass_a_vertex_of_two_fans)
{
  const Asked_surface s(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {-2, -1, 0}},
                                  {{0, 1, 2}, {0, 3, 4}, {0, 4, 5}, {4, 3, 6}}});
  for(int source : {1, 2, 3, 4, 5, 6}) {
    Field field(s.triangulation, s.mesh);
    field.add_source(Vertex_index(source));
    field.compute();
    const Point p = s.at(s.vertex(source));
    for(FG::Index i = 0; i < s.triangulation.number_of_halfedges(); ++i) {
      const Location at{FG::Input_halfedge_index(i), {{1, 2, 4}}};
      if(s.triangulation.input().is_border(at.halfedge))
        continue;
      const Point q = s.at(at), o(0, 0, 0);
      const bool is_same_fan = (source <= 2) == (q.y() > 0);
      check_close(field.distance(at),
                  is_same_fan ? distance_in_space(p, q) : distance_in_space(p, o) + distance_in_space(o, q), 1,
                  "two fans");
    }
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reached_is_infinite)
{
  Mesh_soup soup = with_isolated_vertices(cube(2), 0, 1);
  const int n = static_cast<int>(soup.points.size());
  const Mesh_soup far = tetrahedron();
  for(const auto& p : far.points)
    soup.points.push_back({p[0] + 10, p[1], p[2]});
  for(const auto& t : far.triangles)
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const Asked_surface s(soup);
  Field field(s.triangulation, s.mesh);
  field.add_source(0_v);
  BOOST_TEST((field.compute().status == FG::Distance_field_status::COMPLETE));
  Field from_nowhere(s.triangulation, s.mesh);
  from_nowhere.add_source(Vertex_index(n - 1), 0.5);
  BOOST_TEST((from_nowhere.compute().status == FG::Distance_field_status::COMPLETE));
  BOOST_TEST(from_nowhere.distance(Vertex_index(n - 1)) == 0.5);
  BOOST_TEST(from_nowhere.distance(0_v) == infinity);
  BOOST_TEST(field.distance(Vertex_index(n)) == infinity);
  BOOST_TEST(field.distance(Vertex_index(n - 1)) == infinity);
  BOOST_TEST(field.surface_points(s.vertex(n)).empty());
  const Location in_face{s.triangulation.input().outgoing(Vertex_index(n)), {{1, 1, 1}}};
  BOOST_TEST(field.distance(in_face) == infinity);
  BOOST_TEST(field.gradient(in_face)[0] == 0);
}

BOOST_AUTO_TEST_CASE(wrong_sources_are_refused)
{
  const Asked_surface s(cube(2));
  Field field(s.triangulation, s.mesh);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto h = s.triangulation.input().outgoing(0_v);
  BOOST_CHECK_THROW(field.add_source(Vertex_index(1000)), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(field.add_source(FG::null_index), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(field.add_source(Location{h, {{1, -1, 0}}}), FG::Invalid_location_error);
  BOOST_CHECK_THROW(field.add_source(Location{h, {{nan, 0, 0}}}), FG::Invalid_location_error);
  for(double offset : {nan, infinity, -1.0})
    BOOST_CHECK_THROW(field.add_source(0_v, offset), FG::Invalid_coordinate_error);
  for(double offset : {1e11, 1e300}) { // beside them the mesh is lost in roundings, and all ways are equally long
    BOOST_CHECK_THROW(field.add_source(0_v, offset), FG::Invalid_coordinate_error);
    BOOST_CHECK_THROW(field.add_source(Location{h, {{1, 1, 1}}}, offset), FG::Invalid_coordinate_error);
    BOOST_CHECK_THROW(field.add_curve(std::vector<Location>{s.vertex(0)}, offset), FG::Invalid_coordinate_error);
  }
  BOOST_CHECK_THROW(field.add_curve(std::vector<Location>()), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(field.add_curve(std::vector<Location>{s.vertex(0), s.vertex(25)}), FG::Invalid_curve_error);
  BOOST_TEST(field.number_of_sources() == 0u);
  Field late(s.triangulation, s.mesh);
  late.add_source(0_v, 1e9);
  for(double radius : {nan, -1.0, -infinity}) {
    FG::Distance_field_limits limits;
    limits.radius = radius;
    BOOST_CHECK_THROW(late.compute(limits), FG::Invalid_parameter_error);
  }
  BOOST_TEST(late.compute().windows < 1000u);
  BOOST_TEST(std::abs(late.distance(s.vertex(7)) - 1e9) < 10);
  Field at_vertices(s.triangulation, s.mesh, FG::Distance_field_extent::VERTICES_ONLY);
  at_vertices.add_source(0_v);
  at_vertices.compute();
  BOOST_TEST(at_vertices.distance(s.vertex(0)) == 0);
  BOOST_CHECK_THROW(at_vertices.distance(Location{h, {{1, 1, 1}}}), FG::Invalid_parameter_error);
  // A vertex twice: the smaller offset counts.
  Field twice(s.triangulation, s.mesh);
  for(double offset : {0.75, 0.25, 0.5})
    twice.add_source(0_v, offset);
  twice.compute();
  BOOST_TEST(twice.distance(0_v) == 0.25);
  BOOST_TEST(twice.answer(0_v).source == 1u);
  // Repeated points, and a curve of one.
  field.add_curve(std::vector<Location>{s.vertex(0), s.vertex(0)});
  field.add_curve(std::vector<Location>{Location{h, {{1, 1, 1}}}, Location{h, {{1, 1, 1}}}});
  field.compute();
  BOOST_TEST(field.distance(0_v) == 0);
  BOOST_TEST(field.answer(Location{h, {{1, 1, 1}}}).source == 1u);
}

BOOST_AUTO_TEST_CASE(fields_in_property_maps)
{
  Asked_surface s(torus(16, 10, 2, 1));
  Field field(s.triangulation, s.mesh);
  field.add_source(3_v);
  field.add_source(80_v, 0.5);
  field.compute();
  auto distances = s.mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", -1).first;
  auto sources = s.mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:source", 7).first;
  write_distances(field, s.triangulation, s.mesh, distances);
  write_nearest_sources(field, s.triangulation, s.mesh, sources);
  for(const auto v : s.mesh.vertices()) {
    BOOST_TEST(distances[v] == field.distance(s.triangulation.index(v)));
    BOOST_TEST(sources[v] < 2u);
  }
  BOOST_TEST(sources[Mesh::Vertex_index(80)] == 1u);
}
