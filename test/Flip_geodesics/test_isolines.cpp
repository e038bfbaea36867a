// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Isolines

#include "descriptors.h"
#include "test_isolines/closed_field.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>

using namespace Flip_geodesics_test;

namespace {

// By how much chords are shorter than a circle, for each radian: a chord is shorter than its arc by a third of their
// distance for each radian of the arc, and the distance grows by powers of four of it, too.
double most_shortening(double tolerance) { return 0.4 * tolerance; }

} // namespace

BOOST_AUTO_TEST_CASE(circles_in_the_plane)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(8, 8, Diagonal_rule::ALTERNATING, 0.2, 3));
  const Closed_field field(mesh, from_points({{4.1, 3.8}}));
  for(double tolerance : {0.3, 0.03, 0.003}) {
    const std::vector<double> levels = {2.5, 0.75, 3};
    const std::vector<Isoline> curves = checked_isolines(mesh, field, levels, tolerance);
    BOOST_TEST_REQUIRE(curves.size() == 3u);
    for(std::size_t i = 0; i < 3; ++i) { // in the order of the levels
      BOOST_TEST(curves[i].level == levels[i]);
      BOOST_TEST(curves[i].is_closed);
      const double circle = 2 * pi * levels[i];
      BOOST_TEST(length(curves[i]) <= circle);
      BOOST_TEST(length(curves[i]) >= circle - 2 * pi * most_shortening(tolerance));
      BOOST_TEST(static_cast<double>(curves[i].points.size()) <= 4 * circle / tolerance + 40);
      double area = 0; // the source lies on the left
      for(std::size_t j = 0; j + 1 < curves[i].points.size(); ++j) {
        const Point &p = curves[i].points[j], &q = curves[i].points[j + 1];
        area += (p.x() * q.y() - p.y() * q.x()) / 2;
      }
      BOOST_TEST(area > 0);
    }
  }
}

// A chord of length h of a circle of radius r is h^2 / 8r from it: so long are chords, but for the few in which faces
// end.
BOOST_AUTO_TEST_CASE(points_grow_like_the_root_of_the_tolerance)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(4, 4, Diagonal_rule::ALTERNATING, 0.2, 3));
  const Closed_field field(mesh, from_points({{2.1, 1.9}}));
  const double level = 1.3, circle = 2 * pi * level;
  std::vector<double> tolerances = {1e-2, 1e-3};
  if(has_all_cases) // each takes ten times as long as the one before
    tolerances.insert(tolerances.end(), {1e-4, 1e-5});
  for(double tolerance : tolerances) {
    const std::vector<Isoline> curves = checked_isolines(mesh, field, {level}, tolerance);
    BOOST_TEST_REQUIRE(curves.size() == 1u);
    const double chords = static_cast<double>(curves[0].points.size()) - 1,
                 needed = circle / std::sqrt(8 * level * tolerance);
    const double crossed_edges = 30;
    BOOST_TEST(chords >= needed);
    BOOST_TEST(chords <= 1.5 * needed + 2 * crossed_edges);
  }
}

// Two circles that nearly meet, inside and outside of one another, and lines that bend sharply: chords keep apart.
BOOST_AUTO_TEST_CASE(chords_of_one_level_do_not_cross)
{
  const Mesh mesh = to_mesh<Mesh>(scaled(single_triangle(), 10));
  const double tolerance = 0.05;
  for(double gap : {0.3, 0.1, 0.04, 0.01, 0.003, 0.0003, -0.001, -0.01, -0.1}) {
    const double level = 3 - gap / 2;
    const Closed_field two(mesh, from_points({{7, 8}, {13, 8}}));
    const auto circles = checked_isolines(mesh, two, {level}, tolerance);
    const Closed_field ring(mesh,
                            {[=](const Coordinates& p) { return std::abs(std::hypot(p[0] - 10, p[1] - 9) - 3) + 1; }});
    const auto rings = checked_isolines(mesh, ring, {1 + std::abs(gap) / 2}, tolerance);
    for(const auto& curves : {circles, rings})
      for(std::size_t i = 0; i < curves.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
          BOOST_TEST(!do_cross(curves[i], curves[j]), "curves cross with a gap of " << gap);
    for(const auto& curves : {circles, rings})
      for(const Isoline& curve : curves)
        BOOST_TEST(!does_cross_itself(curve), "a curve crosses itself with a gap of " << gap);
  }
}

// The part of a circle beyond an edge of the mesh is lower than the tolerance, but chords do not cut it off: the level is
// reached beyond the edge as well.
BOOST_AUTO_TEST_CASE(chords_do_not_run_along_edges)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(3, 3, Diagonal_rule::RISING));
  for(const auto& [x, y, dx, dy] : {std::array<double, 4>{1.6, 1.2, 0, 1}, {1.6, 1.7, 0, -1}, {1.2, 1.4, 1, 0}}) {
    const double edge = dx == 0 ? (dy > 0 ? 2 : 1) : 2, to_edge = std::abs(edge - (dx == 0 ? y : x));
    const Closed_field field(mesh, from_points({{x, y}}));
    for(double height : {0.002, 0.008}) {
      const auto curves = checked_isolines(mesh, field, {to_edge + height}, 0.05);
      BOOST_TEST_REQUIRE(curves.size() == 1u);
      const auto beyond = [&, along_x = dx != 0, sign = dx + dy](const Point& p) {
        return sign * ((along_x ? p.x() : p.y()) - edge);
      };
      const auto& points = curves[0].points;
      BOOST_TEST(std::any_of(points.begin(), points.end(), [&](const Point& p) { return beyond(p) > 0; }));
      for(std::size_t i = 0; i + 1 < points.size(); ++i)
        BOOST_TEST((beyond(points[i]) != 0 || beyond(points[i + 1]) != 0));
    }
  }
}

// Levels that are closer to one another than the tolerance is.
BOOST_AUTO_TEST_CASE(chords_of_many_levels_do_not_cross)
{
  const Mesh mesh = to_mesh<Mesh>(scaled(single_triangle(), 10));
  const Closed_field field(mesh, from_points({{9, 9}, {12, 8}}));
  std::vector<double> levels;
  for(double step : {0.001, 0.01, 0.04, 0.1, 0.3})
    for(int i = 0; i < 4; ++i)
      levels.push_back((levels.empty() ? 1 : levels.back()) + step);
  const auto curves = checked_isolines(mesh, field, levels, 0.1);
  BOOST_TEST(curves.size() >= levels.size());
  for(std::size_t i = 0; i < curves.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      BOOST_TEST(!do_cross(curves[i], curves[j]), curves[i].level << " and " << curves[j].level);
}

// The numbers of a place next to a vertex are less than those that a location may have; its isoline is about the
// vertex.
BOOST_AUTO_TEST_CASE(levels_next_to_zero)
{
  using Triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<Mesh>;
  const Mesh mesh = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  const Triangulation triangulation(mesh);
  CGAL::Flip_geodesics::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
  field.add_source(12_v);
  field.compute();
  for(double level : {1e-15, 1e-99, 1e-100, 1e-101, 1e-150, 1e-300, std::numeric_limits<double>::denorm_min()})
    for(double tolerance : {1e-2, 1e-6, 1e-13}) {
      std::vector<Isoline> curves;
      CGAL::Flip_geodesics::isolines(mesh, field, std::vector<double>{level}, std::back_inserter(curves), tolerance);
      BOOST_TEST_REQUIRE(curves.size() == 1u, level);
      BOOST_TEST(curves.front().is_closed);
      for(const auto& [face, weights] : curves.front().locations)
        BOOST_TEST(field(face, weights).distance <= level + 1e-12, level);
    }
}

// What a field knows of a face holds for all of its places, and a field of one source has no boundary to look for.
BOOST_AUTO_TEST_CASE(faces_with_one_nearest_source)
{
  using Triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<Mesh>;
  struct Counted
  {
    const FG::Geodesic_distance_field<Triangulation>& field;
    std::size_t& calls;

    auto operator()(Mesh::Face_index f, const std::array<double, 3>& weights) const
    {
      ++calls;
      return field(f, weights);
    }
    bool has_one_source(Mesh::Face_index f) const { return field.has_one_source(f); }
  };
  Random_numbers random(7);
  int of_several = 0; // faces with one nearest of several sources
  for(const Mesh_soup& soup : {jittered_grid(9, 9, Diagonal_rule::ALTERNATING, 0.2, 3), needle_strip(3, 12, 40),
                               cube(3), disjoint_union(cube(1), translated(cube(1), 9, 0, 0))})
  {
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Triangulation triangulation(mesh);
    for(int sources : {1, 2, 5}) {
      FG::Geodesic_distance_field<Triangulation> field(triangulation, mesh);
      for(int i = 0; i < sources; ++i)
        field.add_source(FG::Vertex_index(random.below(static_cast<int>(mesh.number_of_vertices()) / 2)));
      BOOST_TEST(!field.has_one_source(*mesh.faces().begin())); // nothing is known
      field.compute();
      int single = 0, wrong = 0;
      for(const auto f : mesh.faces()) {
        if(!field.has_one_source(f))
          continue;
        ++single;
        std::set<std::size_t> found;
        for(int i = 0; i < 20; ++i) {
          const double a = random.uniform(0.01, 1), b = random.uniform(0.01, 1), c = random.uniform(0.01, 1);
          found.insert(field(f, {{a / (a + b + c), b / (a + b + c), c / (a + b + c)}}).source);
        }
        wrong += found.size() == 1 ? 0 : 1;
      }
      BOOST_TEST(wrong == 0);
      of_several += sources > 1 ? single : 0;
      if(sources > 1)
        continue;
      BOOST_TEST(single == static_cast<int>(mesh.number_of_faces()));
      std::size_t calls = 0;
      BOOST_TEST(boundaries(mesh, Counted{field, calls}, 1e-6).empty());
      BOOST_TEST(calls == mesh.number_of_vertices());
    }
  }
  BOOST_TEST(of_several > 50);
}

// Not more evaluations than the documentation says, also in needles, and however long the edges are.
BOOST_AUTO_TEST_CASE(work_is_in_proportion_to_the_length)
{
  const auto calls = [](const Mesh_soup& soup, const std::array<double, 2>& source, double level, double tolerance) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    const Closed_field field(mesh, from_points({source}));
    const auto curves = checked_isolines(mesh, field, {level}, tolerance);
    const double before = static_cast<double>(field.calls()) - static_cast<double>(mesh.number_of_vertices());
    BOOST_TEST(curves.size() == 1u);
    return before / (total_length(curves, level) / tolerance);
  };
  BOOST_TEST(calls(flat_grid(4, 4, Diagonal_rule::RISING), {2.1, 1.8}, 1, 0.01) < 25);
  BOOST_TEST(calls(flat_grid(40, 40, Diagonal_rule::RISING), {20.1, 20.8}, 10, 0.1) < 25);
  BOOST_TEST(calls(single_triangle(), {1, 1}, 0.5, 0.001) < 25);
  BOOST_TEST(calls(needle_strip(2, 60, 30), {31, 30}, 12, 0.05) < 100);
}

BOOST_AUTO_TEST_CASE(levels_of_several_sources_do_not_cross)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(10, 10, Diagonal_rule::FALLING));
  const Closed_field field(mesh, from_points({{3, 5}, {7, 5}, {5, 8.2}}));
  std::vector<double> levels;
  for(int i = 1; i < 12; ++i)
    levels.push_back(0.5 * i);
  levels.insert(levels.end(), {1.9, 1.99, 1.999, 2.001, 2.01, 2.1, 2.0001, 2.0002});
  const std::vector<Isoline> curves = checked_isolines(mesh, field, levels, 0.05);
  std::map<double, int> components;
  for(const Isoline& isoline : curves)
    ++components[isoline.level];
  BOOST_TEST(components[1] == 3);
  BOOST_TEST(components[1.5] == 3);
  BOOST_TEST(components[1.9] == 1);  // the third is 3.77 from both others, and these 4 from one another
  BOOST_TEST(components[2.01] == 2); // an outer one, and one around the center, at 2.09
  BOOST_TEST(components[2.5] == 1);
  BOOST_TEST(components[5.5] == 2); // what is left are two corners
  int crossings = 0;
  for(std::size_t i = 0; i < curves.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      crossings += do_cross(curves[i], curves[j]) ? 1 : 0;
  BOOST_TEST(crossings == 0);
}

// Up and down along the sides of parts, and levels as close as rounding errors.
BOOST_AUTO_TEST_CASE(levels_of_a_rough_field_do_not_cross)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(6, 6, Diagonal_rule::FALLING, 0.2, 8));
  const Distance center = from_point(3, 3);
  const Closed_field rough(mesh, {[&](const Coordinates& p) {
                             return 0.3 * center(p) + 0.15 * std::sin(14 * p[0]) * std::sin(14 * p[1]) + 0.5;
                           }});
  std::vector<double> levels = {1, std::nextafter(1, 2), std::nextafter(1, 0), 1};
  for(int i = 0; i < 15; ++i)
    levels.push_back(0.8 + 0.021 * i);
  const auto curves = checked_isolines(mesh, rough, levels, 0.5);
  BOOST_TEST(curves.size() >= levels.size());
  int crossings = 0;
  for(std::size_t i = 0; i < curves.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      crossings += std::abs(curves[i].level - curves[j].level) > 1e-9 && do_cross(curves[i], curves[j]) ? 1 : 0;
  BOOST_TEST(crossings == 0);
}

// What is deeper than the tolerance is found, wherever it is in a face: a circle in one, and what two fronts leave.
BOOST_AUTO_TEST_CASE(small_components_are_found)
{
  const Mesh mesh = to_mesh<Mesh>(scaled(single_triangle(), 100));
  Random_numbers random(11);
  for(int i = 0; i < 20; ++i) {
    const double x = random.uniform(10, 100), y = random.uniform(10, 100), radius = random.uniform(0.06, 0.2);
    const Closed_field field(mesh, {from_point(x, y)});
    const auto circle = checked_isolines(mesh, field, {radius}, 0.05);
    BOOST_TEST(circle.size() == 1u);
    BOOST_TEST(circle[0].is_closed);
    const Closed_field hill(mesh, {[&](const Coordinates& p) { return 50 - std::hypot(p[0] - x, p[1] - y); }});
    const auto top = checked_isolines(mesh, hill, {50 - radius}, 0.05);
    BOOST_TEST(top.size() == 1u);
  }
}

// What is nearer than the level by the tolerance is on the left of all curves, what is farther by it on the right: told
// by how often they wind about a point.
BOOST_AUTO_TEST_CASE(both_sides_are_told_apart)
{
  const Mesh mesh = to_mesh<Mesh>(jittered_grid(20, 20, Diagonal_rule::ALTERNATING, 0.2, 9));
  Random_numbers random(3);
  for(double tolerance : {0.5, 0.1}) {
    std::vector<std::array<double, 2>> sources;
    for(int i = 0; i < 25; ++i)
      sources.push_back({random.uniform(3, 17), random.uniform(3, 17)});
    const Closed_field field(mesh, from_points(sources));
    const double level = 1.7;
    const auto curves = checked_isolines(mesh, field, {level}, tolerance);
    int wrong = 0, near_curves = 0;
    for(int i = 0; i < 2000; ++i) {
      const Coordinates p = {random.uniform(0, 20), random.uniform(0, 20), 0};
      const double distance = field.at(p).distance;
      double winding = 0;
      for(const Isoline& isoline : curves)
        for(std::size_t j = 1; j < isoline.points.size(); ++j) {
          const Point &a = isoline.points[j - 1], &b = isoline.points[j];
          const double ax = a.x() - p[0], ay = a.y() - p[1], bx = b.x() - p[0], by = b.y() - p[1];
          winding += std::atan2(ax * by - ay * bx, ax * bx + ay * by) / (2 * pi);
        }
      const bool is_nearer = winding > 0.5;
      BOOST_TEST((std::abs(winding) < 1e-6 || std::abs(winding - 1) < 1e-6));
      near_curves += std::abs(distance - level) < tolerance ? 1 : 0;
      wrong += std::abs(distance - level) > tolerance && is_nearer != (distance < level) ? 1 : 0;
    }
    BOOST_TEST(wrong == 0);
    BOOST_TEST(near_curves < 1500);
  }
}

BOOST_AUTO_TEST_CASE(levels_at_vertices_and_along_edges)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(10, 10, Diagonal_rule::ALTERNATING));
  const Closed_field round(mesh, from_points({{5, 5}}));
  for(double level : {1., 3., 5.}) {
    const auto curves = checked_isolines(mesh, round, {level}, 0.02);
    BOOST_TEST(curves.size() == 1u);
    BOOST_TEST(std::abs(total_length(curves, level) - 2 * pi * level) < 2 * pi * most_shortening(0.02));
  }
  // Squares: their sides lie along edges of the mesh, and the corners are vertices. The distance is 1-Lipschitz.
  const Closed_field square(mesh,
                            {[](const Coordinates& p) { return (std::max)(std::abs(p[0] - 5), std::abs(p[1] - 5)); }});
  for(double level : {1., 2., 4.}) {
    const auto curves = checked_isolines(mesh, square, {level}, 0.1);
    BOOST_TEST(curves.size() == 1u);
    BOOST_TEST(std::abs(total_length(curves, level) - 8 * level) < 1e-10);
  }
  // The border itself: nothing is farther.
  for(const Isoline& isoline : checked_isolines(mesh, square, {5}, 0.1))
    BOOST_TEST(std::abs(isoline.length() - 40) < 1e-10);
}

BOOST_AUTO_TEST_CASE(plateaus_and_levels_without_isolines)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(6, 6, Diagonal_rule::RISING));
  const Distance center = from_point(3, 3);
  const Closed_field low(mesh, {[&](const Coordinates& p) { return (std::max)(center(p) - 1, 0.); }});
  BOOST_TEST(checked_isolines(mesh, low, {0, -1, -0.0}, 0.05).empty());
  BOOST_TEST(checked_isolines(mesh, low, {0.5}, 0.05).size() == 1u);
  const Closed_field high(mesh, {[&](const Coordinates& p) { return (std::min)(center(p), 2.); }});
  const auto edge = checked_isolines(mesh, high, {2}, 0.05);
  BOOST_TEST(edge.size() == 1u);
  BOOST_TEST(std::abs(total_length(edge, 2) - 4 * pi) < 2 * pi * most_shortening(0.05));
  BOOST_TEST(checked_isolines(mesh, high, {2.0001, 7}, 0.05).empty());
  const Closed_field flat(mesh, {[](const Coordinates&) { return 1.; }});
  BOOST_TEST(checked_isolines(mesh, flat, {0, 1, 2}, 0.05).empty());
  // The farthest point alone is no curve.
  const Closed_field peak(mesh, {[&](const Coordinates& p) { return 4 - center(p); }});
  BOOST_TEST(checked_isolines(mesh, peak, {4}, 0.05).empty());
  BOOST_TEST(checked_isolines(mesh, peak, std::vector<double>(), 0.05).empty());
}

BOOST_AUTO_TEST_CASE(annulus)
{
  const Mesh mesh = to_mesh<Mesh>(grid_with_hole(9, 9, 3, 6, 3, 6));
  const Closed_field field(mesh, from_points({{4.5, 4.5}}));
  const auto curves = checked_isolines(mesh, field, {1.8, 3, 5}, 0.01);
  std::map<double, int> open, closed;
  for(const Isoline& isoline : curves)
    ++(isoline.is_closed ? closed : open)[isoline.level];
  BOOST_TEST(open[1.8] == 4); // around each corner of the hole it is cut off
  BOOST_TEST(closed[1.8] == 0);
  BOOST_TEST(open[3] == 0);
  BOOST_TEST(closed[3] == 1);
  BOOST_TEST(open[5] == 4);
}

// The regular tetrahedron has four points with half the angle, and cut loci. Everything is closed; beyond the points
// fronts meet themselves.
BOOST_AUTO_TEST_CASE(isolines_of_a_tetrahedron)
{
  for(int n : {1, 3}) {
    const Mesh mesh = to_mesh<Mesh>(tetrahedron(n));
    const double size = n;
    const Coordinates corner = {-size, -size, size};
    const Closed_field field(mesh, {[n, corner](const Coordinates& p) { return tetrahedron_distance(n, p, corner); }});
    const double edge = std::sqrt(8.) * n, inner = 0.4 * edge, outer = 0.95 * edge;
    const auto curves = checked_isolines(mesh, field, {inner, outer}, 0.02 * n);
    BOOST_TEST(std::abs(total_length(curves, inner) - pi * inner) < pi * most_shortening(0.02 * n));
    int around_others = 0;
    for(const Isoline& isoline : curves) {
      BOOST_TEST(isoline.is_closed);
      around_others += isoline.level == outer ? 1 : 0;
    }
    BOOST_TEST(around_others == 1); // the other corners and the side between them
  }
}

BOOST_AUTO_TEST_CASE(isolines_of_a_cube)
{
  const Mesh mesh = to_mesh<Mesh>(cube(2));
  const Closed_field field(mesh, {[](const Coordinates& p) { return box_distance(2, 2, 2, {1, 1, 0}, p); }});
  const auto curves = checked_isolines(mesh, field, {0.5, 2, 3.9}, 0.2);
  BOOST_TEST_REQUIRE(curves.size() == 3u);
  for(const Isoline& isoline : curves)
    BOOST_TEST(isoline.is_closed);
}

BOOST_AUTO_TEST_CASE(needles_and_faces_without_area)
{
  const Mesh needles = to_mesh<Mesh>(needle_strip(3, 12, 40));
  const Closed_field far(needles, from_points({{61, 6}}));
  const auto curves = checked_isolines(needles, far, {4, 50}, 0.2);
  BOOST_TEST(curves.size() == 3u);
  const Mesh flat = to_mesh<Mesh>(with_zero_area_face());
  const Closed_field field(flat, from_points({{0.2, 0.1}}));
  const auto arcs = checked_isolines(flat, field, {0.1, 0.5, 0.7}, 0.01);
  BOOST_TEST(arcs.size() >= 3u);
  const Mesh zero = to_mesh<Mesh>(with_zero_length_edge());
  const Closed_field again(zero, from_points({{0.2, 0.1}}));
  BOOST_TEST(checked_isolines(zero, again, {0.1, 0.5}, 0.01).size() >= 2u);
}

BOOST_AUTO_TEST_CASE(components_without_source_and_fields_that_end)
{
  const Mesh mesh = to_mesh<Mesh>(disjoint_union(flat_grid(4, 4, Diagonal_rule::RISING),
                                                 translated(flat_grid(4, 4, Diagonal_rule::RISING), 9, 0, 0)));
  const Distance source = from_point(2, 2);
  const Closed_field reached(mesh, {[&](const Coordinates& p) { return p[0] > 8 ? infinity : source(p); }});
  BOOST_TEST(checked_isolines(mesh, reached, {1, 2.5, 100}, 0.05).size() == 5u);
  const std::size_t calls = reached.calls();
  BOOST_TEST(isolines(mesh, reached, std::vector<double>{1}, 0.01).size() == 1u);
  BOOST_TEST(reached.calls() - calls < 20000u); // nothing is looked for in the other one
  const Closed_field limited(mesh, {[&](const Coordinates& p) { return source(p) > 1.5 ? infinity : source(p); }});
  BOOST_TEST(checked_isolines(mesh, limited, {1, 1.4}, 0.05).size() == 2u);
  for(double beyond : {1.7, 100.}) {
    const auto ends = isolines(mesh, limited, std::vector<double>{beyond}, 0.01);
    BOOST_TEST(ends.size() == 1u);
    for(const Isoline& end : ends) {
      BOOST_TEST(end.is_closed);
      for(std::size_t i = 1; i < end.points.size(); ++i)
        BOOST_TEST(std::abs(source(coordinates(CGAL::midpoint(end.points[i - 1], end.points[i]))) - 1.5) < 0.01);
    }
  }
}

// A field that fails at its n-th call, for each n: nothing is written until all is known.
BOOST_AUTO_TEST_CASE(a_field_that_fails_leaves_no_output)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  for(bool is_isoline : {true, false}) {
    int failures = 0;
    for(int calls = 0;; calls += 5) {
      int left = calls;
      const auto failing = [&](const Coordinates& p) {
        if(left-- == 0)
          throw std::runtime_error("the field fails");
        return p[0];
      };
      const Closed_field field(mesh, {failing, from_point(1.5, 1.5)});
      std::vector<Isoline> lines;
      std::vector<Boundary> borders;
      try {
        if(is_isoline)
          FG::isolines(mesh, field, std::vector<double>{0.25, 0.5}, std::back_inserter(lines), 0.1);
        else
          FG::voronoi_boundaries(mesh, field, std::back_inserter(borders), 0.1);
        BOOST_TEST(lines.size() + borders.size() > 0);
        break;
      } catch(const std::runtime_error&) {
        BOOST_TEST((lines.empty() && borders.empty()));
        ++failures;
      }
    }
    BOOST_TEST(failures > 1);
  }
}

BOOST_AUTO_TEST_CASE(numbers_that_cannot_be)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  const Closed_field field(mesh, from_points({{1, 1}}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(double wrong : {nan, infinity, -infinity})
    BOOST_CHECK_EXCEPTION(isolines(mesh, field, std::vector<double>{1, wrong}, 0.1), FG::Invalid_parameter_error,
                          [](const FG::Error& e) { return e.elements() == std::vector<std::size_t>{1}; });
  for(double wrong : {nan, infinity, 0., -1., 1e-300, 1e-15}) { // the last ones are lost in rounding errors
    BOOST_CHECK_THROW(isolines(mesh, field, std::vector<double>{1}, wrong), FG::Invalid_parameter_error);
    BOOST_CHECK_THROW(boundaries(mesh, field, wrong), FG::Invalid_parameter_error);
  }
  const Closed_field broken(mesh, {[&](const Coordinates& p) { return p[0] == 2 ? nan : p[0]; }});
  BOOST_CHECK_THROW(isolines(mesh, broken, std::vector<double>{1}, 0.1), FG::Invalid_parameter_error);
  const Mesh astray = to_mesh<Mesh>(with_nan_coordinate());
  BOOST_CHECK_EXCEPTION(isolines(astray, field, std::vector<double>{1}, 0.1), FG::Invalid_coordinate_error,
                        [](const FG::Error& e) { // the message names the vertices that it lists
                          const std::vector<std::size_t>& v = e.elements();
                          return std::set<std::size_t>(v.begin(), v.end()).size() == 3 &&
                                 std::string(e.what()).find("vertices " + std::to_string(v[0]) + ", " +
                                                            std::to_string(v[1]) + ", " + std::to_string(v[2]) +
                                                            " has") != std::string::npos;
                        });
  Mesh square;
  const auto v = [&](double x, double y) { return square.add_vertex(Point(x, y, 0)); };
  square.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
  const Closed_field of_square(square, from_points({{1, 1}}));
  BOOST_CHECK_THROW(isolines(square, of_square, std::vector<double>{1}, 0.1), FG::Invalid_mesh_error);
  BOOST_CHECK_THROW(boundaries(square, of_square, 0.1), FG::Invalid_mesh_error);
  BOOST_TEST(isolines(Mesh(), field, std::vector<double>{1}, 0.1).empty());

  using Triangulation = FG::Intrinsic_triangulation<Mesh>;
  const Triangulation triangulation(mesh);
  FG::Geodesic_distance_field<Triangulation> at_vertices(
      triangulation, mesh, CGAL::parameters::extent(FG::Distance_field_extent::VERTICES_ONLY));
  at_vertices.add_source(FG::Vertex_index(0));
  at_vertices.compute();
  BOOST_CHECK_THROW(isolines(mesh, at_vertices, std::vector<double>{1}, 0.1), FG::Invalid_parameter_error);
  BOOST_CHECK_THROW(boundaries(mesh, at_vertices, 0.1), FG::Invalid_parameter_error);
}
