// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Curves whose points are dragged: against closed forms where a class has one geodesic, against flips elsewhere.

#define BOOST_TEST_MODULE Curve_editor

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "rolled_out_surfaces.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Curve_editor.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/networks_from_data.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using FG::Surface_location;
using Editor = FG::Curve_editor<Triangulation>;
using Polyline = std::vector<Surface_location>;

bool is_geodesic(FG::Verdict verdict) { return verdict == FG::Verdict::PROVEN || verdict == FG::Verdict::PROBABLE; }

bool is_same(const Surface_location& p, const Surface_location& q)
{
  return p.halfedge == q.halfedge && p.weights == q.weights;
}

bool is_same(const Polyline& a, const Polyline& b)
{
  bool result = a.size() == b.size();
  for(std::size_t i = 0; result && i < a.size(); ++i)
    result = is_same(a[i], b[i]);
  return result;
}

// ---------------------------------------------------------------- the flat torus, and its plane

// The plane rolled up: cells of side 1 with rising diagonals, `n` by `m` of them.
struct Flat_torus
{
  static constexpr int n = 7, m = 5;

  Flat_torus()
    : mesh(to_mesh<Surface>(torus(n, m, 3, 1)))
    , triangulation(mesh, Length_metric(mesh, Length_map(set_lengths())))
  {
  }

  static int vertex(int i, int j) { return (i % n + n) % n + n * ((j % m + m) % m); }

  Surface_location location(const Flat_point& p) const
  {
    const double x = std::floor(p[0]), y = std::floor(p[1]), u = p[0] - x, v = p[1] - y;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const bool is_upper = v > u; // on the left of the diagonal
    const int a = vertex(i, j), c = vertex(i + 1, j + 1);
    const auto h = is_upper ? halfedge(a, c) : halfedge(c, a);
    if(is_upper) // a, c, and the corner above a
      return {h, {{1 - v, u, v - u}}};
    return {h, {{v, 1 - u, u - v}}};
  }

  FG::Input_halfedge_index halfedge(int v, int w) const
  {
    using Vertex = Surface::Vertex_index;
    return triangulation.input().index(
        CGAL::halfedge(Vertex(static_cast<unsigned>(v)), Vertex(static_cast<unsigned>(w)), mesh).first);
  }

  std::map<Surface::Edge_index, double>& set_lengths()
  {
    for(Surface::Edge_index e : mesh.edges()) {
      const int v = static_cast<int>(mesh.vertex(e, 0).idx()), w = static_cast<int>(mesh.vertex(e, 1).idx());
      lengths[e] = v % n != w % n && v / n != w / n ? std::sqrt(2.0) : 1;
    }
    return lengths;
  }

  Surface mesh;
  std::map<Surface::Edge_index, double> lengths;
  Length_triangulation triangulation;
};

// Somewhere, on an edge, or at a vertex, at most 0.7 away along either axis.
Flat_point moved(const Flat_point& p, Random_numbers& random)
{
  Flat_point result = {p[0] + random.uniform(-0.7, 0.7), p[1] + random.uniform(-0.7, 0.7)};
  const int what = random.below(4);
  for(int k = 0; k < 2; ++k)
    if(what == k || what == 2)
      result[k] = std::round(result[k]);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(legs_on_a_flat_torus_are_the_segments_of_its_plane)
{
  Flat_torus torus;
  Random_numbers random(1);
  std::vector<Flat_point> points = {{0.3, 0.2}, {2.6, 1.1}, {3.2, 2.7}};
  std::vector<Surface_location> places;
  for(const Flat_point& p : points)
    places.push_back(torus.location(p));
  FG::Curve_editor<Length_triangulation> editor(torus.triangulation, places);
  for(std::size_t i = 0; i < 2; ++i) // the first ones are shortest: their class is told by their lengths
    BOOST_REQUIRE(std::abs(editor.length(i) - distance(points[i], points[i + 1])) < 1e-12);
  std::size_t vertices = 0;
  for(int move = 0; move < 600; ++move) {
    const auto i = static_cast<std::size_t>(random.below(3));
    Flat_point to = moved(points[i], random);
    if(move % 100 < 30)
      to[0] += 0.4; // so that points get round
    if((i > 0 && distance(to, points[i - 1]) < 0.1) || (i < 2 && distance(to, points[i + 1]) < 0.1))
      continue;
    const Flat_point middle = {points[i][0] + (to[0] - points[i][0]) / 2, points[i][1] + (to[1] - points[i][1]) / 2};
    const FG::Move_report report = editor.move(i, torus.location(middle));
    BOOST_TEST(report.legs == (i == 1 ? 2u : 1u));
    editor.move(i, torus.location(to));
    points[i] = to;
    for(std::size_t l = 0; l < 2; ++l) {
      BOOST_TEST(std::abs(editor.length(l) - distance(points[l], points[l + 1])) < 1e-11);
      BOOST_TEST(is_geodesic(editor.verdict(l)));
      BOOST_TEST(is_same(editor.leg(l).front(), editor.point(l)));
      BOOST_TEST(is_same(editor.leg(l).back(), editor.point(l + 1)));
    }
    vertices += kind(editor.point(i)) == FG::Location_kind::VERTEX ? 1 : 0;
    BOOST_TEST(torus.triangulation.log_position() == 0u);
  }
  BOOST_TEST(vertices > 50u);
  BOOST_TEST(distance(points[0], points[1]) > Flat_torus::n); // once round, and more
}

namespace {

// The plane grid less a cell in its middle, and places on it.
struct Annulus
{
  Annulus()
    : mesh(to_mesh<Surface>(grid_with_hole(9, 9, 4, 5, 4, 5)))
    , triangulation(mesh)
  {
  }

  Surface_location location(const Flat_point& p) const
  {
    return FG::surface_location(triangulation, mesh, location_on_grid(mesh, mesh, p));
  }

  Surface mesh;
  Triangulation triangulation;
};

// A leg through vertices of a plane: each of them is an end of several edges that the leg crosses, which takes one
// exact comparison, not one for each of the edges.
BOOST_AUTO_TEST_CASE(a_vertex_on_a_leg_is_compared_once)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(6, 3, Diagonal_rule::FALLING));
  const Triangulation triangulation(mesh);
  Triangulation edited(mesh);
  const auto place = [&](const Flat_point& p) {
    return FG::surface_location(triangulation, mesh, location_on_grid(mesh, mesh, p));
  };
  Editor editor(edited, {place({0.5, 0.25}), place({5.5, 2.75})}); // by the vertices (2, 1) and (4, 2)
  BOOST_TEST(is_geodesic(editor.verdict(0)));
  BOOST_TEST(std::abs(editor.length(0) - std::hypot(5, 2.5)) < 1e-12);
  const FG::Decision_statistics& statistics = editor.statistics();
  BOOST_TEST(statistics.zeros_by_roots > 0u);
  BOOST_TEST(statistics.zeros_by_roots <= 20u, statistics.zeros_by_roots << " comparisons");
}

// From the lower end of a circle about the hole once round it, counterclockwise or back, in steps of a quarter cell.
void drag_round_hole(const Annulus& annulus, Editor& editor, int direction)
{
  constexpr int steps = 64;
  for(int i = 1; i <= steps; ++i) {
    const double angle = direction * 2 * pi * i / steps - pi / 2;
    const bool is_end = i == steps;
    editor.move(1, annulus.location(is_end ? Flat_point{4.5, 2}
                                           : Flat_point{4.5 + 2.5 * std::cos(angle), 4.5 + 2.5 * std::sin(angle)}));
    BOOST_TEST(is_geodesic(editor.verdict(0)));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(a_drag_round_a_hole_changes_the_class_and_back_again)
{
  Annulus annulus;
  Editor editor(annulus.triangulation, {annulus.location({4.5, 1}), annulus.location({4.5, 2})});
  const Polyline before = editor.leg(0);
  const Surface_location end = editor.point(1);
  BOOST_TEST(std::abs(editor.length() - 1) < 1e-14);
  for(int direction : {1, -1}) {
    for(int rounds = 1; rounds <= 3; ++rounds) { // from the second on, the path crosses itself
      drag_round_hole(annulus, editor, direction);
      const double tangents = std::hypot(0.5, 3) + std::hypot(0.5, 2), sides = 3 + 4 * (rounds - 1);
      BOOST_TEST(std::abs(editor.length() - tangents - sides) < 1e-12);
    }
    for(int rounds = 3; rounds > 0; --rounds)
      drag_round_hole(annulus, editor, -direction);
    BOOST_TEST(is_same(editor.leg(0), before));
  }
  BOOST_TEST(editor.number_of_moves() == 2 * 6 * 64u);
  drag_round_hole(annulus, editor, 1);
  const Polyline after = editor.leg(0);
  drag_round_hole(annulus, editor, 1);
  for(int i = 0; i < 64; ++i)
    BOOST_REQUIRE(editor.undo());
  BOOST_TEST(is_same(editor.leg(0), after));
  while(editor.undo()) {
  }
  BOOST_TEST(is_same(editor.leg(0), before));
  BOOST_TEST(is_same(editor.point(1), end));
}

BOOST_AUTO_TEST_CASE(way_points_on_developable_surfaces)
{
  for(const Bent_surface& surface : surfaces())
    for(bool is_closed : {false, true}) {
      Random_numbers random(7);
      Triangulation t(surface.bent);
      std::vector<Flat_point> points = {{1.2, 1.1}, {6.3, 1.8}, {6.9, 6.4}, {1.3, 7.1}};
      Editor editor(t, locations(t, surface, points), CGAL::parameters::is_closed(is_closed));
      BOOST_TEST(editor.number_of_legs() == (is_closed ? 4u : 3u));
      for(int move = 0; move < 60; ++move) {
        const auto i = static_cast<std::size_t>(random.below(4));
        Flat_point& p = points[i];
        p = {std::min(std::max(p[0] + random.uniform(-1, 1), 0.1), 7.9),
             std::min(std::max(p[1] + random.uniform(-1, 1), 0.1), 7.9)};
        if(random.below(3) == 0)
          p = {std::round(p[0]), std::round(p[1])};
        std::vector<Polyline> before = editor.legs();
        const double length = editor.length();
        const FG::Move_report report = editor.move(i, locations(t, surface, {p}).front());
        BOOST_TEST(is_geodesic(report.verdict));
        double sum = 0;
        for(std::size_t l = 0; l < editor.number_of_legs(); ++l) {
          const double expected =
              distance(rolled_out(surface.flat, editor.point(l)), rolled_out(surface.flat, editor.point((l + 1) % 4)));
          BOOST_TEST(std::abs(editor.length(l) - expected) < 1e-12);
          sum += expected;
          if(l != i && (l + 1) % 4 != i)
            BOOST_TEST(is_same(editor.leg(l), before[l]));
        }
        BOOST_TEST(std::abs(editor.length() - sum) < 1e-11);
        const std::vector<Polyline> after = editor.legs();
        BOOST_TEST(editor.undo());
        for(std::size_t l = 0; l < before.size(); ++l)
          BOOST_TEST(is_same(editor.leg(l), before[l]));
        BOOST_TEST(editor.length() == length);
        editor.move(i, locations(t, surface, {p}).front());
        for(std::size_t l = 0; l < before.size(); ++l)
          BOOST_TEST(is_same(editor.leg(l), after[l]));
      }
      // Made at once, it is the same.
      std::vector<Surface_location> places;
      for(std::size_t i = 0; i < 4; ++i)
        places.push_back(editor.point(i));
      const Editor fresh(t, places, CGAL::parameters::is_closed(is_closed));
      for(std::size_t l = 0; l < fresh.number_of_legs(); ++l)
        BOOST_TEST(std::abs(fresh.length(l) - editor.length(l)) < 1e-12);
    }
}

namespace {

// A random place of a random kind.
Surface_location random_place(const Triangulation& t, Random_numbers& random)
{
  for(;;) {
    const FG::Input_halfedge_index h(random.below(t.number_of_halfedges()));
    if(t.input().is_border(h))
      continue;
    const int what = random.below(4);
    const double a = random.uniform(0.05, 1), b = random.uniform(0.05, 1), c = random.uniform(0.05, 1);
    return {h, {{a, what == 0 ? 0 : b, what <= 1 ? 0 : c}}};
  }
}

// A few faces further on.
Surface_location place_near(const Triangulation& t, const Surface_location& from, Random_numbers& random)
{
  FG::Input_halfedge_index h = from.halfedge;
  for(int step = 0; step < 4; ++step) {
    for(int turns = random.below(3); turns > 0; --turns)
      h = t.input().next(h);
    const FG::Input_halfedge_index other = FG::internal::twin_index(h);
    h = t.input().is_border(other) ? h : other;
  }
  Surface_location result = random_place(t, random);
  result.halfedge = h;
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(legs_are_geodesics_on_any_surface)
{
  const std::vector<Mesh_soup> soups = {bumpy_sphere(5, 0.15, 3),  genus_3_plate(2), cube(4),
                                        saddle_disk(8, 5, 4 * pi), tetrahedron(4),   sphere(4),
                                        torus(9, 6, 3, 1),         lantern(9, 4)};
  std::size_t moves = 0, flips = 0, unproven = 0;
  for(const Mesh_soup& soup : soups) {
    const Surface mesh = to_mesh<Surface>(soup);
    Triangulation t(mesh);
    Random_numbers random(11);
    Editor editor(t, {random_place(t, random), random_place(t, random), random_place(t, random)});
    FG::internal::Polyline_measure<Triangulation> measure(t);
    for(int move = 0; move < 150; ++move) {
      const auto i = static_cast<std::size_t>(random.below(3));
      const Surface_location to = place_near(t, editor.point(i), random);
      const double before = editor.length();
      FG::Move_report report;
      try {
        report = editor.move(i, to);
      } catch(const FG::Invalid_curve_error&) { // onto another point
        BOOST_TEST(editor.length() == before);
        continue;
      }
      ++moves;
      flips += report.legs_by_flips;
      unproven += is_geodesic(report.verdict) ? 0 : 1;
      for(std::size_t l = 0; l < 2; ++l)
        BOOST_TEST(std::abs(measure.length(editor.leg(l)) - editor.length(l)) < 1e-9);
      BOOST_TEST(t.log_position() == 0u);
    }
  }
  BOOST_TEST(moves > 1000u);
  BOOST_TEST(flips <= 5u);    // along rays of the saddle, whose vertices are flat but for the last bit
  BOOST_TEST(unproven <= 5u); // bent by less than doubles tell, and said to be
}

namespace {

// The plane grid, with the vertices of the middle row off it by next to nothing, up or down.
Mesh_soup with_rough_row(int n, Diagonal_rule rule, Random_numbers& random)
{
  Mesh_soup soup = flat_grid(n, n, rule);
  constexpr std::array<double, 5> heights = {0, 1e-18, -1e-18, 1e-17, -1e-17};
  for(Coordinates& p : soup.points) {
    p[1] -= n / 2;
    if(p[1] == 0 && p[0] > 0 && p[0] < n)
      p[1] = heights[static_cast<std::size_t>(random.below(5))];
  }
  return soup;
}

// Does a polyline from end to end of the row run on its line, exactly?
bool is_on_line(const Triangulation& t, const Polyline& points)
{
  const auto y = [&](FG::Input_halfedge_index h) { return t.metric().point(t.input(), t.input().tail(h)).y(); };
  return std::all_of(points.begin(), points.end(), [&](const Surface_location& p) {
    if(kind(p) == FG::Location_kind::VERTEX)
      return y(p.halfedge) == 0;
    const double tail = y(p.halfedge), head = y(FG::internal::twin_index(p.halfedge));
    return (tail <= 0 && head >= 0) || (tail >= 0 && head <= 0); // also beside a vertex on the line
  });
}

} // namespace

// Doubles do not tell on which side of the line vertices lie; the verdict does.
BOOST_AUTO_TEST_CASE(a_leg_is_proven_if_and_only_if_it_is_straight)
{
  constexpr int n = 8;
  Random_numbers random(3);
  std::size_t straight = 0, bent = 0;
  for(int i = 0; i < 40; ++i) {
    const Surface mesh =
        to_mesh<Surface>(with_rough_row(n, i % 2 == 0 ? Diagonal_rule::RISING : Diagonal_rule::ALTERNATING, random));
    Triangulation t(mesh);
    const auto at = [&](int x, int y) { return t.location(FG::Vertex_index(grid_vertex(n, x, y))); };
    const int step = i % 4 < 2 ? 1 : -1; // from above or below
    Editor editor(t, {at(0, n / 2), at(n, n / 2 + 3 * step), at(n, step > 0 ? n : 0)});
    FG::Move_report report;
    for(int y : {2, 1, 0}) {
      report = editor.move(1, at(n, n / 2 + y * step));
      BOOST_TEST(report.legs_by_flips == 0u); // as they prove no more, with traits in doubles
    }
    BOOST_TEST(std::abs(editor.length(0) - n) < 1e-14);
    const bool is_straight = is_on_line(t, editor.leg(0));
    BOOST_TEST((editor.verdict(0) == FG::Verdict::PROVEN) == is_straight);
    BOOST_TEST(is_geodesic(editor.verdict(1)));
    BOOST_TEST(is_geodesic(report.verdict) == is_straight); // the worst of both
    ++(is_straight ? straight : bent);
    // With certified decisions flips prove what doubles do not.
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<CGAL::Simple_cartesian<double>>>
        certified(mesh);
    FG::Curve_editor<decltype(certified)> proven(certified, {at(0, n / 2), at(n, n / 2 + step)});
    BOOST_TEST((proven.move(1, at(n, n / 2)).legs_by_flips == 1u) == !is_straight);
    BOOST_TEST((proven.verdict(0) == FG::Verdict::PROVEN));
  }
  BOOST_TEST(straight > 5u);
  BOOST_TEST(bent > 5u);
}

// A line through a vertex of a torus of equilateral triangles: that its angle is pi requires a root.
BOOST_AUTO_TEST_CASE(a_leg_beyond_the_work_limit_is_probable)
{
  using Traits = FG::Certified_intrinsic_triangulation_traits<Length_metric::Kernel>;
  using Certified = FG::Intrinsic_triangulation<Surface, Traits, Length_metric>;
  constexpr int n = 9;
  const Surface mesh = to_mesh<Surface>(torus(n, 7, 3, 1));
  std::map<Surface::Edge_index, double> lengths;
  for(Surface::Edge_index e : mesh.edges())
    lengths[e] = 1;
  for(const bool is_limited : {false, true}) {
    Certified t(mesh, Length_metric(mesh, Length_map(lengths)), is_limited ? Traits(0) : Traits());
    const FG::Curve_editor<Certified> editor(t, {t.location(0_v), t.location(FG::Vertex_index(4 + 2 * n))});
    BOOST_TEST(std::abs(editor.length() - 2 * std::sqrt(3.0)) < 1e-12);
    BOOST_TEST((editor.verdict(0) == (is_limited ? FG::Verdict::PROBABLE : FG::Verdict::PROVEN)));
  }
}

BOOST_AUTO_TEST_CASE(angles_from_leg_to_leg_go_round_their_vertex)
{
  for(const double shear : {0.0, 3.0}) { // acute corners, and obtuse ones
    Curve_setting s(mapped(flat_grid(7, 7, Diagonal_rule::RISING), [shear](const Coordinates& p) {
      return Coordinates{p[0] - shear * p[1], p[1], p[2]};
    }));
    struct Seen
    {
      FG::Edge_sequence sequence;
      FG::internal::Edge_sequence_angle angle;
    };
    const auto seen = [&](int x, int y) { // from the vertex (2, 2)
      s.network.clear();
      s.triangulation.rollback();
      s.add_path(FG::Vertex_index(grid_vertex(7, 2, 2)), FG::Vertex_index(grid_vertex(7, x, y)));
      FG::shorten(s.network);
      Seen result;
      s.network.for_each_segment(0_c, [&](FG::Segment_index segment) {
        result.sequence = s.triangulation.edge_sequence(s.network.halfedge(segment));
      });
      const FG::internal::Strip<Curve_setting::Triangulation> strip(s.triangulation, result.sequence);
      result.angle = FG::internal::tail_angle(strip);
      return result;
    };
    FG::Decision_statistics statistics;
    const auto compare = [&](const Seen& a, const Seen& b) {
      return FG::internal::compare_clockwise(s.triangulation, statistics, {a.sequence, true, a.angle},
                                             {b.sequence, true, b.angle});
    };
    const Seen low = seen(7, 3), high = seen(4, 3), left = seen(1, 4); // the first two in one corner
    s.network.clear();
    s.triangulation.rollback();
    BOOST_TEST(compare(high, low) == CGAL::SMALLER);
    BOOST_TEST(compare(low, high) == CGAL::LARGER);
    BOOST_TEST(compare(left, low) == CGAL::SMALLER);
    BOOST_TEST(compare(low, left) == CGAL::LARGER);
    Seen same = low; // but for rounding
    same.angle.angle += same.angle.error;
    BOOST_TEST(compare(low, same) == CGAL::SMALLER);
    BOOST_TEST(compare(same, low) == CGAL::SMALLER);
  }
}

BOOST_AUTO_TEST_CASE(polylines_are_divided_anywhere)
{
  const Curve_setting s(flat_grid(4, 4, Diagonal_rule::RISING));
  const auto at = [&](const Flat_point& p) {
    return FG::internal::canonical_location(
        s.triangulation.input(), FG::surface_location(s.triangulation, s.mesh, location_on_grid(s.mesh, s.mesh, p)));
  };
  const FG::internal::Polyline_measure<Curve_setting::Triangulation> measure(s.triangulation);
  const Polyline polyline = {at({0.75, 0.5}), at({1, 0.5}), at({1.5, 0.5})};
  const double length = measure.length(polyline);
  BOOST_TEST(length == 0.75);
  for(double distance : {-0.1, 0.0, 0.1, 0.25, 0.7, 0.75, 0.8}) {
    const auto [first, second] = measure.divided(polyline, distance);
    const double expected = std::min(std::max(distance, 0.0), length);
    BOOST_TEST(std::abs(measure.length(first) - expected) < 1e-15);
    BOOST_TEST(std::abs(measure.length(second) - (length - expected)) < 1e-15);
    BOOST_TEST(first.size() + second.size() == 5u);
    BOOST_TEST(is_same(first.back(), second.front()));
    for(double weight : first.back().weights)
      BOOST_TEST((weight >= 0 && weight <= 1));
  }
  // By rounding next to the edge is on the edge.
  BOOST_TEST((kind(measure.divided(polyline, std::nextafter(0.25, 0)).first.back()) == FG::Location_kind::EDGE));
  const Polyline one_place = {polyline[0], polyline[0]};
  for(const Surface_location& p : measure.divided(one_place, 0).first)
    BOOST_TEST(measure.length({p, polyline[0]}) == 0);
}

// Along the border, from both sides of its edges, off it, and back.
BOOST_AUTO_TEST_CASE(points_on_the_border)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(4, 4, Diagonal_rule::RISING));
  Triangulation t(mesh);
  const auto at = [&](const Flat_point& p) { return FG::surface_location(t, mesh, location_on_grid(mesh, mesh, p)); };
  const std::vector<Flat_point> places = {{1, 0},   {3, 0}, {4, 0}, {4, 2.5},  {4, 4},
                                          {1.5, 4}, {0, 4}, {0, 2}, {2.5, 1.5}};
  for(const Flat_point& start : places)
    for(const Flat_point& end : places) {
      if(start == end)
        continue;
      Editor editor(t, {at(start), at(end)});
      std::array<Flat_point, 2> ends = {start, end};
      for(std::size_t i : {1, 0})
        for(const Flat_point& to : places) {
          if(to == ends[1 - i])
            continue;
          editor.move(i, at(to));
          ends[i] = to;
          BOOST_TEST(std::abs(editor.length() - distance(ends[0], ends[1])) < 1e-13);
          BOOST_TEST(is_geodesic(editor.verdict(0)));
        }
    }
}

// Round the torus and back to the same vertex: the leg has the same ends, and is another one.
BOOST_AUTO_TEST_CASE(a_point_that_comes_back_from_another_side)
{
  constexpr int n = Flat_torus::n;
  Flat_torus torus;
  FG::Curve_editor<Length_triangulation> editor(torus.triangulation, {torus.location({0, 0}), torus.location({2, 1})});
  Polyline way;
  for(int x = 2; x <= 2 + n; ++x)
    way.push_back(torus.location({static_cast<double>(x), 1}));
  for(int round = 1; round <= 3; ++round) {
    editor.move_along(1, way);
    BOOST_TEST(std::abs(editor.length() - std::hypot(2 + round * n, 1)) < 1e-12);
    BOOST_TEST(is_geodesic(editor.verdict(0)));
  }
}

BOOST_AUTO_TEST_CASE(no_move_after_bad_input)
{
  Mesh_soup two = flat_grid(4, 4, Diagonal_rule::RISING);
  const int n = static_cast<int>(two.points.size());
  for(const Coordinates& p : flat_grid(2, 2, Diagonal_rule::RISING).points)
    two.points.push_back({p[0] + 10, p[1], p[2]});
  for(const Corners& c : flat_grid(2, 2, Diagonal_rule::RISING).triangles)
    two.triangles.push_back({c[0] + n, c[1] + n, c[2] + n});
  const Surface mesh = to_mesh<Surface>(two);
  Triangulation t(mesh);
  const auto at = [&](double x, double y) {
    return FG::surface_location(t, mesh, location_on_grid(mesh, mesh, {x, y}));
  };
  Editor editor(t, {at(0.4, 0.3), at(2.1, 1.7), at(3.6, 3.2)});
  const std::vector<Polyline> before = editor.legs();
  const auto is_unchanged = [&] {
    bool result = editor.number_of_moves() == 0 && t.log_position() == 0;
    for(std::size_t l = 0; l < before.size(); ++l)
      result = result && is_same(editor.leg(l), before[l]);
    return result;
  };
  const auto spoiled = [&](double weight) {
    Surface_location result = at(1.4, 1.2);
    result.weights[1] = weight;
    return result;
  };
  BOOST_CHECK_THROW(editor.move(2, at(11.2, 1.3)), FG::Disconnected_endpoints_error);
  BOOST_CHECK_THROW(editor.move(2, spoiled(std::numeric_limits<double>::quiet_NaN())), FG::Invalid_location_error);
  BOOST_CHECK_THROW(editor.move(1, spoiled(-1)), FG::Invalid_location_error);
  BOOST_CHECK_THROW(editor.move(2, {FG::Input_halfedge_index(100000), {{1, 1, 1}}}), FG::Invalid_location_error);
  BOOST_CHECK_THROW(editor.move(2, editor.point(1)), FG::Invalid_curve_error);
  Surface_location twice = editor.point(1); // the same ratio
  for(double& weight : twice.weights)
    weight *= 2;
  BOOST_CHECK_THROW(editor.move(0, twice), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(editor.move_along(0, {}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(editor.move_along(0, {at(1.4, 1.2), at(1.4, 1.3)}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(editor.move_along(0, {editor.point(0), at(3.4, 1.3)}), FG::Invalid_curve_error);
  Surface_location beside = editor.point(0); // in the same face
  std::swap(beside.weights[0], beside.weights[1]);
  BOOST_CHECK_THROW(editor.move_along(0, {beside, editor.point(0)}), FG::Invalid_curve_error);
  BOOST_TEST(is_unchanged());
  BOOST_TEST(editor.move_along(0, {editor.point(0)}).legs == 0u);
  BOOST_TEST(is_unchanged());
  {
    FG::Edge_path_network<Triangulation> network(t);
    network.add_curve(std::vector<FG::Halfedge_index>{0_h});
    BOOST_CHECK_THROW(editor.move(2, at(3.4, 3.3)), FG::Occupied_triangulation_error);
    BOOST_CHECK_THROW(Editor(t, {at(0.4, 0.3), at(2.1, 1.7)}), FG::Occupied_triangulation_error);
    BOOST_TEST(is_unchanged());
  }
  BOOST_CHECK_THROW(Editor(t, {at(0.4, 0.3)}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(Editor(t, {at(0.4, 0.3), at(0.4, 0.3)}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(Editor(t, {at(0.4, 0.3), at(11.2, 1.3)}), FG::Disconnected_endpoints_error);
  BOOST_TEST(!editor.undo());
  editor.move(2, at(3.4, 3.3));
  editor.forget_moves();
  BOOST_TEST(!editor.undo());
}

BOOST_AUTO_TEST_CASE(a_way_can_start_at_a_vertex_as_any_halfedge_tells_it)
{
  const Curve_setting s(flat_grid(4, 4, Diagonal_rule::RISING));
  Triangulation t(s.mesh);
  const FG::Vertex_index v(grid_vertex(4, 2, 2));
  Editor editor(t, {t.location(FG::Vertex_index(0)), t.location(v)});
  int told = 0;
  for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(t.number_of_halfedges()))
    if(t.input().tail(h) == v) {
      editor.move_along(1, {{h, {{1, 0, 0}}}, t.location(FG::Vertex_index(grid_vertex(4, 3, 2)))});
      BOOST_TEST(editor.undo());
      ++told;
    }
  BOOST_TEST(told == 6);
}

BOOST_AUTO_TEST_CASE(a_way_says_in_which_class_a_leg_goes_on)
{
  Annulus annulus;
  Editor editor(annulus.triangulation, {annulus.location({4.5, 1}), annulus.location({3.5, 3.6})});
  Polyline way = {editor.point(1)};
  for(int i = 1; i <= 40; ++i) // up on the left, over the hole, and down on the right
    way.push_back(annulus.location({i <= 30 ? 3.5 + std::max(0, i - 20) * 0.2 : 5.5,
                                    i <= 20 ? 3.6 + i * 0.1 : (i <= 30 ? 5.6 : 5.6 - (i - 30) * 0.2)}));
  const auto crossings = FG::complete_polyline(annulus.triangulation, way);
  editor.move_along(1, crossings);
  const double expected = std::hypot(0.5, 3) + 1 + 1 + std::hypot(0.5, 1.4);
  BOOST_TEST(std::abs(editor.length() - expected) < 1e-12);
  editor.undo();
  editor.move(1, way.back()); // the short way
  BOOST_TEST(editor.length() < 3.5);
}

BOOST_AUTO_TEST_CASE(a_spline_of_dragged_legs_is_that_of_the_plane)
{
  const Bent_surface surface = surfaces().back();
  Triangulation t(surface.bent);
  std::vector<Flat_point> polygon = {{0.7, 3.1}, {2.2, 6.4}, {4, 1.5}, {5.3, 7}};
  Editor editor(t, locations(t, surface, polygon));
  polygon[2] = {6.1, 2.4};
  editor.move(2, locations(t, surface, {polygon[2]}).front());
  FG::Geodesic_spline<Triangulation> spline(t, editor.legs(), FG::Spline_kind::BEZIER);
  spline.refine();
  const auto pieces = spline.finish();
  BOOST_REQUIRE_EQUAL(pieces.size(), 2u);
  BOOST_TEST(distance(rolled_out(surface.flat, pieces[0].back()), de_casteljau(polygon, 0.5)) < 1e-11);
  BOOST_CHECK_THROW(FG::Geodesic_spline<Triangulation>(t, std::vector<Polyline>{}, FG::Spline_kind::BEZIER),
                    FG::Invalid_curve_error);
  const std::vector<Polyline> short_leg = {{editor.point(0)}};
  BOOST_CHECK_THROW(FG::Geodesic_spline<Triangulation>(t, short_leg, FG::Spline_kind::BEZIER), FG::Invalid_curve_error);
}

// Bends that are none are dropped one after the other; each time only the line near the bend is looked at.
BOOST_AUTO_TEST_CASE(vertices_in_line_take_linear_time)
{
  const auto number_of_decisions = [](int n) {
    const Surface mesh = to_mesh<Surface>(flat_grid(n, n, Diagonal_rule::RISING));
    Triangulation t(mesh);
    const Editor editor(t, {t.location(0_v), t.location(FG::Vertex_index(grid_vertex(n, n, n)))});
    BOOST_TEST(is_geodesic(editor.verdict(0)));
    BOOST_TEST(std::abs(editor.length() - std::sqrt(2.0) * n) < 1e-12 * n);
    const FG::Decision_statistics& statistics = editor.statistics();
    return static_cast<double>(statistics.by_plane + statistics.by_precision + statistics.by_roots);
  };
  const double of_short_row = number_of_decisions(40);
  BOOST_TEST(of_short_row > 40);
  BOOST_TEST(number_of_decisions(80) < 2.5 * of_short_row);
}
