// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE proven_shortest

#include "Curve_setting.h"
#include "Exact_distances.h"
#include "closed_forms.h"
#include "generated_meshes.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Vertex_index;
using namespace Flip_geodesics_test;

namespace {

using Setting = Basic_curve_setting<
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Length_metric::Kernel>>>;
using Number = Exact_distances::Number;

FG::Shortest_path_report shortest(Setting& setting, int s, int t, const FG::Window_limit& limit = FG::Window_limit())
{
  Setting::Search search(setting.triangulation);
  const auto report = FG::add_shortest_path(setting.network, search, Vertex_index(s), Vertex_index(t),
                                            CGAL::parameters::search_limit(limit));
  setting.network.clear();
  setting.triangulation.rollback();
  return report;
}

// Every `step`-th vertex with each other.
template <class Function>
void for_pairs(const Mesh_soup& soup, int step, const Function& function)
{
  const int n = static_cast<int>(soup.points.size());
  for(int s = 0; s < n; s += step)
    for(int t = 0; t < n; t += step)
      if(s != t)
        function(s, t);
}

struct Counts
{
  std::size_t pairs = 0, ties = 0;
};

// All pairs of vertices against brute force: no bound is above the distance, not even in the last digit.
Counts check(const char* name, const Mesh_soup& soup)
{
  Counts counts;
  BOOST_TEST_CONTEXT(name)
  {
    const Exact_distances exact(soup);
    Setting setting(soup);
    for_pairs(soup, 1, [&](int s, int t) {
      const auto report = shortest(setting, s, t);
      const Number& distance = exact.distance(s, t);
      BOOST_TEST(FG::to_string(report.verdict) == "WITHIN_ROUNDING", s << " to " << t << ", gap " << report.gap());
      BOOST_TEST((Number(report.lower_bound) <= distance), s << " to " << t);
      BOOST_TEST((distance <= Number(report.lower_bound) * (1 + 1e-12)), s << " to " << t);
      BOOST_TEST((abs(Number(report.length) - distance) <= distance * 1e-14), s << " to " << t);
      BOOST_TEST(report.has_tie == (exact.number_of_paths(s, t) > 1), s << " to " << t);
      ++counts.pairs;
      counts.ties += report.has_tie ? 1 : 0;
    });
  }
  return counts;
}

// A pyramid over a square.
Mesh_soup pyramid(double height)
{
  return {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, height}},
          {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

// Coordinates in sixteenths.
Mesh_soup with_short_coordinates(const Mesh_soup& soup)
{
  return mapped(soup, [](const Coordinates& p) {
    return Coordinates{std::round(16 * p[0]) / 16, std::round(16 * p[1]) / 16, std::round(16 * p[2]) / 16};
  });
}

} // namespace

// The distances that the others are compared with, where they are known.
BOOST_AUTO_TEST_CASE(brute_force)
{
  const Mesh_soup soup = box(1, 1, 1, 1);
  const Exact_distances exact(soup);
  std::size_t opposite = 0;
  for(int s = 0; s < 8; ++s)
    for(int t = 0; t < 8; ++t) {
      double square = 0;
      for(int i = 0; i < 3; ++i)
        square += std::abs(soup.points[s][i] - soup.points[t][i]);
      const double expected = square == 3 ? std::sqrt(5.0) : std::sqrt(square);
      BOOST_TEST(std::abs(static_cast<double>(exact.distance(s, t)) - expected) <= 1e-15);
      BOOST_TEST(exact.number_of_paths(s, t) == (square == 3 ? 6u : 1u));
      opposite += square == 3 ? 1 : 0;
    }
  BOOST_TEST(opposite == 8u);
}

BOOST_AUTO_TEST_CASE(boxes)
{
  const Counts cube = check("cube", box(1, 1, 1, 1));
  BOOST_TEST(cube.ties == 8u);
  check("cube, two by two", box(2, 2, 2, 2));
  check("box", box(3, 2, 1, 1));
  check("box of thirds", mapped(box(3, 2, 1, 1), [](const Coordinates& p) {
          return Coordinates{p[0] / 3, p[1] / 7, p[2] / 5};
        }));
  check("box far away", mapped(box(1, 2, 3, 1), [](const Coordinates& p) {
          return Coordinates{p[0] + 1e6, p[1] - 3e5, p[2] + 7e4};
        }));
}

BOOST_AUTO_TEST_CASE(pyramids)
{
  for(double height : {0.25, 1.0, 5.0, 1e-3, 1e-5})
    check("pyramid", pyramid(height));
  check("octahedron", octahedron());
  check("octahedron, two by two", octahedron(2));
  check("tetrahedron, two by two", tetrahedron(2));
}

BOOST_AUTO_TEST_CASE(random_hulls)
{
  for(unsigned seed = 1; seed <= 6; ++seed)
    check("hull", random_convex_polyhedron(10, seed));
  check("hull with short coordinates", with_short_coordinates(random_convex_polyhedron(12, 7)));
}

// With saddles, borders, flat parts, and needles.
BOOST_AUTO_TEST_CASE(other_surfaces)
{
  Random_numbers random(5);
  check("terrain", mapped(flat_grid(3, 3, Diagonal_rule::RANDOM), [&](const Coordinates& p) {
          return Coordinates{p[0], p[1], random.uniform(0, 2)};
        }));
  const Counts lattice = check("lattice", flat_grid(4, 3, Diagonal_rule::ALTERNATING));
  BOOST_TEST(lattice.ties == 0u);
  check("hole", grid_with_hole(3, 3, 1, 2, 1, 2));
  check("needles", needle_strip(5, 2, 1e-6));
  check("thin box", box(1e-7, 1, 1, 1));
  check("saddle", saddle_disk(6, 2, 8));
}

// Rays from one vertex run through rows of others. What passes them on both sides by rounding is not followed twice:
// the number of windows would double at each.
BOOST_AUTO_TEST_CASE(windows_do_not_multiply_along_rows)
{
  const auto squashed = [](const Mesh_soup& soup) {
    return mapped(soup, [](const Coordinates& p) { return Coordinates{p[0] / 3, p[1] / 7, p[0] / 11 + p[1] / 13}; });
  };
  for(const Mesh_soup& soup :
      {flat_grid(16, 4, Diagonal_rule::ALTERNATING), squashed(flat_grid(20, 6, Diagonal_rule::RISING)),
       cylinder(12, 16, 1, 4), cylinder(24, 16, 1, 4, true)})
  {
    Setting setting(soup);
    for_pairs(soup, static_cast<int>(soup.points.size()) / 20, [&](int s, int t) {
      const auto report = shortest(setting, s, t, FG::Window_limit(20000));
      BOOST_TEST(report.is_confirmed(), s << " to " << t);
      BOOST_TEST(report.gap() <= 5e-12 * report.length, s << " to " << t << ", gap " << report.gap());
      BOOST_TEST(report.windows < 4000u, s << " to " << t << ": " << report.windows);
    });
  }
}

// The rounding errors of steps across long faces and along rows of flat vertices add up to more than the tolerance of a
// proof. Bounds in double-double arithmetic are within it, and not above the distance.
BOOST_AUTO_TEST_CASE(long_faces_and_rows_of_flat_vertices)
{
  check("steep pyramid", pyramid(1e4));
  check("steep cone", cone(7, 1, 1, 1000));
  const auto is_in_sponge = [](int x, int y, int z) { return x % 2 + y % 2 + z % 2 < 2; };
  for(const Mesh_soup& soup :
      {cylinder(26, 1, 1, 100), cylinder(100, 10, 1, 100), cylinder(200, 2, 1, 5), cylinder(26, 2, 1, 2, true),
       cone(26, 1, 1, 100), grid_with_hole(6, 6, 2, 4, 2, 4), genus_3_plate(1), voxel_surface(5, 5, 5, is_in_sponge)})
  {
    Setting setting(soup);
    const int ends = has_all_cases ? 40 : 17; // all pairs of them
    for_pairs(soup, 1 + static_cast<int>(soup.points.size()) / ends, [&](int s, int t) {
      const auto report = shortest(setting, s, t);
      BOOST_TEST(FG::to_string(report.verdict) == "WITHIN_ROUNDING", s << " to " << t << ", gap " << report.gap());
    });
  }
}

// Around a cylinder of long faces, distances are those in the plane.
BOOST_AUTO_TEST_CASE(bounds_on_cylinders_are_not_above_the_distance)
{
  constexpr int n = 26, m = 2;
  constexpr double radius = 1, height = 100;
  const Mesh_soup soup = cylinder(n, m, radius, height);
  Setting setting(soup);
  for_pairs(soup, 3, [&](int s, int t) {
    const double distance = cylinder_distance(n, m, radius, height, s, t);
    const auto report = shortest(setting, s, t);
    BOOST_TEST(FG::to_string(report.verdict) == "WITHIN_ROUNDING", s << " to " << t << ", gap " << report.gap());
    BOOST_TEST(report.lower_bound <= distance * (1 + 2e-15), s << " to " << t); // of the rounded coordinates
  });
}

// Whether a path ties with another one does not depend on its direction, also where rows of vertices are pushed
// together to one line: rounded rays that turn back in degenerate faces arrive from the wrong side.
BOOST_AUTO_TEST_CASE(ties_are_the_same_in_both_directions)
{
  const auto pushed_together = [](double shift, Diagonal_rule rule) {
    return mapped(flat_grid(4, 3, rule), [shift](const Coordinates& p) {
      return p[1] < 1 ? p : Coordinates{p[1] == 1 ? p[0] + shift : p[0], p[1] - 1, 0};
    });
  };
  const auto is_in_sponge = [](int x, int y, int z) { return x % 2 + y % 2 + z % 2 < 2; };
  std::vector<Mesh_soup> soups = {cube(2), octahedron(3), cylinder(8, 4, 1, 2, true), torus(8, 6, 3, 1),
                                  voxel_surface(3, 3, 3, is_in_sponge)};
  for(double shift : {0.25, 0.5, 1.25, 1.5})
    for(Diagonal_rule rule : {Diagonal_rule::RISING, Diagonal_rule::ALTERNATING, Diagonal_rule::RANDOM})
      soups.push_back(pushed_together(shift, rule));
  for(const Mesh_soup& soup : soups) {
    Setting setting(soup);
    for_pairs(soup, 1, [&](int s, int t) {
      if(s < t)
        BOOST_TEST(shortest(setting, s, t).has_tie == shortest(setting, t, s).has_tie, s << " and " << t);
    });
  }
}

// Two paths around the top of a pyramid, one as the other in a mirror, that lie next to each other all the way from a
// vertex beside the top: the angle between them is less than can be told at their far end, and large at the near one.
BOOST_AUTO_TEST_CASE(ties_around_a_top_that_is_close_to_an_end)
{
  for(double offset : {1e-2, 1e-5, 1e-7, 1e-9}) {
    const Coordinates near_top = {offset, 0, 1 - offset};
    const Mesh_soup pyramid = {{{0, 0, 1}, near_top, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                               {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 2}}};
    Setting setting(pyramid);
    for(const bool is_forward : {true, false}) {
      const auto report = is_forward ? shortest(setting, 1, 4) : shortest(setting, 4, 1);
      BOOST_TEST(report.is_confirmed(), offset);
      BOOST_TEST(report.has_tie, offset << (is_forward ? ", towards the far end" : ", from the far end"));
    }
  }
}

// Faces without area, whose corners lie in a line, can be passed again and again at one place.
BOOST_AUTO_TEST_CASE(faces_without_area)
{
  const std::vector<Mesh_soup> folded = {
      {{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {2, -1, 0}},
       {{0, 1, 5}, {0, 2, 1}, {2, 3, 1}, {3, 4, 1}, {0, 6, 2}, {2, 6, 3}, {3, 6, 4}, {4, 6, 1}}},
      {{{0, 0, 0}, {6, 0, 0}, {1, 0, 0}, {5, 0, 0}, {2, 0, 0}, {4, 0, 0}, {3, 2, 0}, {3, -2, 0}, {3, 0, 0}},
       {{0, 1, 6},
        {0, 2, 1},
        {2, 3, 1},
        {2, 4, 3},
        {4, 5, 3},
        {4, 8, 5},
        {0, 7, 2},
        {2, 7, 4},
        {4, 7, 8},
        {8, 7, 5},
        {5, 7, 3},
        {3, 7, 1}}}};
  for(const Mesh_soup& soup : folded) {
    Setting setting(soup);
    for_pairs(soup, 1, [&](int s, int t) {
      const auto report = shortest(setting, s, t, FG::Window_limit(20000));
      const auto &p = soup.points[s], &q = soup.points[t]; // all lie in a plane, without gaps
      BOOST_TEST(FG::to_string(report.verdict) == "WITHIN_ROUNDING", s << " to " << t);
      BOOST_TEST(std::abs(report.length - std::hypot(p[0] - q[0], p[1] - q[1])) <= 1e-14 * report.length);
      BOOST_TEST(report.windows < 8000u, s << " to " << t);
    });
  }
}

// Of two lights that meet on an edge, as from two vertices: what is fitted to them is nowhere above them, and a cone
// that is flatter by a hair is.
BOOST_AUTO_TEST_CASE(fitted_cones_touch_what_they_are_fitted_to)
{
  using namespace FG::internal;
  std::mt19937 random(1);
  const auto number = [&](double from, double to) { return from + (to - from) * (random() / 4294967296.0); };
  std::size_t touching = 0, fitted = 0;
  for(int i = 0; i < 10000; ++i) {
    const double length = number(0.1, 3), middle = length * number(0.1, 0.9);
    const Cone first = {number(-2, 5), number(0.01, 5), 0};
    const Cone moved = {first.x + number(-0.1, 0.1), first.y * number(0.9, 1.1), 0};
    const Cone second = {moved.x, moved.y, first(middle) - moved(middle)};
    Lit_parts parts;
    parts.add(first, 0, middle);
    parts.add(second, middle, length);
    const double start = parts.least_at(0).value, end = parts.least_at(length).value;
    const Cone cone = fitted_cone({0, start}, {length, end}, parts, 1e-14);
    const auto excess = [&](const Cone& of) {
      double most = -1;
      for(int j = 0; j <= 200; ++j) {
        const double q = length * j / 200;
        most = (std::max)(most, of(q) - parts.part[q < middle ? 0 : 1].cone(q));
      }
      return (std::max)(most, of(middle) - first(middle));
    };
    BOOST_TEST(excess(cone) <= 1e-13);
    BOOST_TEST(std::abs(cone(0) - start) <= 1e-13);
    BOOST_TEST(std::abs(cone(length) - end) <= 1e-13);
    if(cone.sigma <= (std::min)(first.sigma, second.sigma))
      continue; // as flat as may be
    ++fitted;
    const Cones_through_ends cones = {length, start, end};
    touching += excess(cones(cone.sigma - 1e-3 * std::abs(cones.largest_sigma() - cone.sigma))) > 1e-14 ? 1 : 0;
  }
  BOOST_TEST(fitted > 3000u);
  BOOST_TEST(touching * 100 > fitted * 95);
}

// If fronts come from both ends of an edge, there are two cones, which meet where the fronts do: they are no lower than
// the fronts in between by much.
BOOST_AUTO_TEST_CASE(two_fitted_cones_meet_where_fronts_meet)
{
  using namespace FG::internal;
  std::mt19937 random(3);
  const auto number = [&](double from, double to) { return from + (to - from) * (random() / 4294967296.0); };
  for(int i = 0; i < 1000; ++i) {
    const double length = number(0.1, 3), delay = length * number(-0.5, 0.5);
    const Cone first = {-length * number(0.1, 2), length * number(0.01, 1), 0};
    const Cone from_end = {length * number(1.1, 3), length * number(0.01, 1), 0};
    const Cone second = {from_end.x, from_end.y, first(length / 2) - from_end(length / 2) + delay};
    Lit_parts parts;
    parts.add(first, 0, length);
    parts.add(second, 0, length);
    if(!(first(0) < second(0) && second(length) < first(length)))
      continue;
    const Edge_cones cones = fitted_cones(parts, length, 1e-14);
    BOOST_TEST((0 < cones.split && cones.split < length));
    BOOST_TEST(std::abs(first(cones.split) - second(cones.split)) <= 0.02 * length);
  }
}

// Over each part of an edge with two cones, the least sum with a cone from the other side is that of dense samples.
BOOST_AUTO_TEST_CASE(least_sums_of_cones_are_those_of_samples)
{
  using namespace FG::internal;
  std::mt19937 random(2);
  const auto number = [&](double from, double to) { return from + (to - from) * (random() / 4294967296.0); };
  for(int i = 0; i < 2000; ++i) {
    const double length = number(0.1, 3), from = length * number(0, 1), to = from + (length - from) * number(0, 1);
    const auto cone = [&] { return Cone{number(-2, 5), number(0.01, 5), number(0, 2)}; };
    const Cone other = cone();
    const Edge_cones cones = {cone(), cone(), length * number(0, 1)};
    double least = std::numeric_limits<double>::infinity();
    for(int j = 0; j <= 1000; ++j) {
      const double q = from + (to - from) * j / 1000;
      least = (std::min)(least, other(q) + (q <= cones.split ? cones.first : cones.second)(q));
    }
    // Slopes are at most 2, and parts begin between samples.
    const double found = cones.least_sum(other, from, to);
    BOOST_TEST(found <= least + 1e-12);
    BOOST_TEST(found >= least - 2 * (to - from) / 1000 - 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(verdicts)
{
  using Verdict = FG::Verdict;
  FG::Shortest_path_report report;
  report.length = 2;
  report.shortening.curves.emplace_back();
  const auto verdict = [&](Verdict of_curve, double bound) {
    report.shortening.curves[0].verdict = of_curve;
    report.lower_bound = 2 * bound;
    return FG::internal::verdict_of(report);
  };
  BOOST_CHECK(verdict(Verdict::PROVEN, 1 - 0.9e-12) == FG::Verdict::WITHIN_ROUNDING);
  BOOST_CHECK(verdict(Verdict::PROVEN, 1 - 1.1e-12) == FG::Verdict::WITHIN_TOLERANCE);
  BOOST_CHECK(verdict(Verdict::PROVEN, 1 - 0.9e-10) == FG::Verdict::WITHIN_TOLERANCE);
  BOOST_CHECK(verdict(Verdict::PROVEN, 1 - 1.1e-10) == FG::Verdict::UNDECIDED);
  for(Verdict other : {Verdict::PROBABLE, Verdict::BENT_SEGMENT, Verdict::BENT_JOINT, Verdict::UNDECIDED})
    BOOST_CHECK(verdict(other, 1) == FG::Verdict::WITHIN_TOLERANCE);
  BOOST_TEST(FG::to_string(FG::Verdict::UNDECIDED) == "UNDECIDED");
  BOOST_TEST(FG::to_string(FG::Verdict::WITHIN_TOLERANCE) == "WITHIN_TOLERANCE");
  for(Verdict confirming : {Verdict::PROVEN, Verdict::PROBABLE, Verdict::WITHIN_ROUNDING, Verdict::WITHIN_TOLERANCE})
    BOOST_TEST(FG::is_confirmed(confirming));
  for(Verdict other : {Verdict::BENT_SEGMENT, Verdict::BENT_JOINT, Verdict::UNDECIDED})
    BOOST_TEST(!FG::is_confirmed(other));
  report.shortening.curves[0].status = FG::Shortening_status::STOPPED_BY_VISITOR;
  BOOST_CHECK(verdict(Verdict::PROVEN, 1) == FG::Verdict::UNDECIDED);
}
