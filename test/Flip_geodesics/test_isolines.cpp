// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Isolines

#include "Mesh_archetype.h"
#include "closed_forms.h"
#include "generated_meshes.h"
#include "invalid_meshes.h"

#include <CGAL/Flip_geodesics/Interpolated_distances.h>
#include <CGAL/Flip_geodesics/isolines.h>
#include <CGAL/Flip_geodesics/voronoi_boundaries.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Isoline = FG::Isoline<Mesh>;
using Boundary = FG::Voronoi_boundary<Mesh>;
using Polyline = FG::Located_polyline<Mesh>;
using Location = Polyline::Face_location;
using Distance = std::function<double(const Coordinates&)>;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Answer
{
  double distance;
  std::size_t source;
};

// A field of closed forms, one per source, that counts what it is asked.
class Closed_field
{
public:
  Closed_field(const Mesh& mesh, std::vector<Distance> distances)
    : m_mesh(mesh)
    , m_distances(std::move(distances))
  {
  }

  Answer operator()(Mesh::Face_index f, const std::array<double, 3>& weights) const
  {
    ++m_calls;
    Coordinates p = {0, 0, 0};
    Mesh::Halfedge_index h = m_mesh.halfedge(f);
    const Point start = m_mesh.point(m_mesh.source(h));
    bool is_constant[3] = {true, true, true};
    for(double w : weights) {
      const Point& q = m_mesh.point(m_mesh.source(h));
      for(int d = 0; d < 3; ++d) {
        p[d] += w * q[d];
        is_constant[d] = is_constant[d] && q[d] == start[d];
      }
      h = m_mesh.next(h);
    }
    for(int d = 0; d < 3; ++d) // the sides of a box are known by equal coordinates
      p[d] = is_constant[d] ? start[d] : p[d];
    return at(p);
  }

  Answer at(const Coordinates& p) const
  {
    Answer result = {infinity, 0};
    for(std::size_t i = 0; i < m_distances.size(); ++i) {
      const double d = m_distances[i](p);
      if(!(result.distance <= d))
        result = {d, i};
    }
    return result;
  }

  double from(std::size_t source, const Coordinates& p) const { return m_distances[source](p); }
  std::size_t calls() const { return m_calls; }

private:
  const Mesh& m_mesh;
  std::vector<Distance> m_distances;
  mutable std::size_t m_calls = 0;
};

Distance from_point(double x, double y)
{
  return [=](const Coordinates& p) { return std::hypot(p[0] - x, p[1] - y); };
}

std::vector<Distance> from_points(const std::vector<std::array<double, 2>>& sources)
{
  std::vector<Distance> result;
  for(const auto& s : sources)
    result.push_back(from_point(s[0], s[1]));
  return result;
}

Coordinates coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

double length(const Polyline& polyline)
{
  double sum = 0;
  for(std::size_t i = 0; i + 1 < polyline.points.size(); ++i)
    sum += distance(polyline.points[i], polyline.points[i + 1]);
  return sum;
}

// The faces that have a location, by its weights of zero.
std::set<Mesh::Face_index> faces_of(const Mesh& mesh, const Location& location)
{
  std::set<Mesh::Face_index> result = {location.first};
  Mesh::Halfedge_index h = mesh.halfedge(location.first);
  for(int i = 0; i < 3; ++i, h = mesh.next(h)) {
    if(location.second[(i + 2) % 3] == 0 && !mesh.is_border(mesh.opposite(h)))
      result.insert(mesh.face(mesh.opposite(h)));
    if(location.second[(i + 2) % 3] == 0 && location.second[(i + 1) % 3] == 0)
      for(const auto f : mesh.faces_around_target(mesh.prev(h)))
        if(f != Mesh::null_face())
          result.insert(f);
  }
  return result;
}

bool is_on_border(const Mesh& mesh, const Location& location)
{
  Mesh::Halfedge_index h = mesh.halfedge(location.first);
  for(int i = 0; i < 3; ++i, h = mesh.next(h)) {
    if(location.second[(i + 2) % 3] == 0 && mesh.is_border(mesh.opposite(h)))
      return true;
    if(location.second[i] == 1 && mesh.is_border(mesh.source(h)))
      return true;
  }
  return false;
}

// Points are where the locations say, each two in a row are in one face, and ends are in their places.
void check_polyline(const Mesh& mesh, const Polyline& polyline)
{
  BOOST_TEST_REQUIRE(polyline.points.size() >= 2u);
  BOOST_TEST_REQUIRE(polyline.points.size() == polyline.locations.size());
  bool is_in_place = true, is_in_faces = true, has_steps = true;
  for(std::size_t i = 0; i < polyline.points.size(); ++i) {
    const auto& [face, w] = polyline.locations[i];
    Mesh::Halfedge_index h = mesh.halfedge(face);
    Coordinates p = {0, 0, 0};
    for(int j = 0; j < 3; ++j, h = mesh.next(h))
      for(int d = 0; d < 3; ++d)
        p[d] += w[j] * mesh.point(mesh.source(h))[d];
    is_in_place = is_in_place && distance(Point(p[0], p[1], p[2]), polyline.points[i]) < 1e-12;
    if(i == 0)
      continue;
    has_steps = has_steps && polyline.locations[i] != polyline.locations[i - 1];
    const auto faces = faces_of(mesh, polyline.locations[i]), before = faces_of(mesh, polyline.locations[i - 1]);
    is_in_faces = is_in_faces && std::any_of(faces.begin(), faces.end(), [&](auto f) { return before.count(f) != 0; });
  }
  BOOST_TEST(is_in_place);
  BOOST_TEST(is_in_faces);
  BOOST_TEST(has_steps);
  BOOST_TEST((polyline.points.front() == polyline.points.back()) == polyline.is_closed);
}

// The largest |field - level| along isolines, and at their vertices.
void check_isoline(const Mesh& mesh, const Closed_field& field, const Isoline& isoline, double tolerance)
{
  check_polyline(mesh, isoline);
  if(!isoline.is_closed) {
    BOOST_TEST(is_on_border(mesh, isoline.locations.front()));
    BOOST_TEST(is_on_border(mesh, isoline.locations.back()));
  }
  double deviation = 0, root = 0;
  for(std::size_t i = 0; i < isoline.points.size(); ++i) {
    root = (std::max)(root, std::abs(field.at(coordinates(isoline.points[i])).distance - isoline.level));
    for(double t : {0.25, 0.5, 0.75})
      if(i > 0) {
        const Point p = isoline.points[i - 1] + t * (isoline.points[i] - isoline.points[i - 1]);
        deviation = (std::max)(deviation, std::abs(field.at(coordinates(p)).distance - isoline.level));
      }
  }
  BOOST_TEST(root <= 1e-12 * (1 + isoline.level));
  BOOST_TEST(deviation <= tolerance);
}

template <class Field, class Levels>
std::vector<Isoline> isolines(const Mesh& mesh, const Field& field, const Levels& levels, double tolerance)
{
  std::vector<Isoline> result;
  FG::isolines(mesh, field, levels, std::back_inserter(result), tolerance);
  return result;
}

std::vector<Isoline> checked_isolines(const Mesh& mesh, const Closed_field& field, const std::vector<double>& levels,
                                      double tolerance)
{
  const std::vector<Isoline> result = isolines(mesh, field, levels, tolerance);
  for(const Isoline& isoline : result)
    check_isoline(mesh, field, isoline, tolerance);
  return result;
}

double total_length(const std::vector<Isoline>& curves, double level)
{
  double sum = 0;
  for(const Isoline& isoline : curves)
    sum += isoline.level == level ? length(isoline) : 0;
  return sum;
}

bool do_cross(const Point& p, const Point& q, const Point& r, const Point& s)
{
  const auto side = [](const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  return side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
}

bool do_cross(const Polyline& a, const Polyline& b)
{
  for(std::size_t i = 0; i + 1 < a.points.size(); ++i)
    for(std::size_t j = 0; j + 1 < b.points.size(); ++j)
      if(do_cross(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1]))
        return true;
  return false;
}

template <class Field>
std::vector<Boundary> boundaries(const Mesh& mesh, const Field& field, double tolerance)
{
  std::vector<Boundary> result;
  FG::voronoi_boundaries(mesh, field, std::back_inserter(result), tolerance);
  return result;
}

// What a diagram consists of: junctions, ends on the border, boundaries and closed ones.
struct Diagram
{
  std::size_t junctions = 0, ends = 0, open = 0, closed = 0;
};

// Vertices of boundaries are where two distances are equal and least, all else is within the tolerance of that;
// junctions have three ends at the same point.
Diagram check_diagram(const Mesh& mesh, const Closed_field& field, const std::vector<Boundary>& diagram,
                      double tolerance)
{
  Diagram result;
  std::map<std::size_t, std::vector<Point>> junctions;
  for(const Boundary& b : diagram) {
    check_polyline(mesh, b);
    ++(b.is_closed && b.junctions[0] == Boundary::none ? result.closed : result.open);
    BOOST_TEST(b.sources[0] != b.sources[1]);
    for(int end : {0, 1}) {
      const bool is_junction = b.junctions[end] != Boundary::none;
      if(is_junction)
        junctions[b.junctions[end]].push_back(end == 0 ? b.points.front() : b.points.back());
      else if(!b.is_closed) {
        BOOST_TEST(is_on_border(mesh, end == 0 ? b.locations.front() : b.locations.back()));
        ++result.ends;
      }
    }
    double root = 0, deviation = 0, at_junction = 0;
    for(std::size_t i = 0; i < b.points.size(); ++i) {
      const auto gap = [&](const Point& p) {
        return std::abs(field.from(b.sources[0], coordinates(p)) - field.from(b.sources[1], coordinates(p)));
      };
      const bool is_near =
          (b.junctions[0] != Boundary::none && distance(b.points[i], b.points.front()) < 0.05 * tolerance) ||
          (b.junctions[1] != Boundary::none && distance(b.points[i], b.points.back()) < 0.05 * tolerance);
      (is_near ? at_junction : root) = (std::max)(is_near ? at_junction : root, gap(b.points[i]));
      deviation = i == 0 ? 0 : (std::max)(deviation, gap(CGAL::midpoint(b.points[i - 1], b.points[i])));
    }
    BOOST_TEST(root <= 1e-11);
    BOOST_TEST(at_junction <= 0.1 * tolerance);
    BOOST_TEST(deviation <= 2 * tolerance); // of a function that is 2-Lipschitz
  }
  for(const auto& [number, ends] : junctions) {
    BOOST_TEST(number < junctions.size());
    BOOST_TEST(ends.size() == 3u);
    for(const Point& p : ends)
      BOOST_TEST((p == ends.front()));
  }
  result.junctions = junctions.size();
  return result;
}

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
      BOOST_TEST(length(curves[i]) >= circle * (1 - tolerance * tolerance));
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

// Up and down along the sides of parts, and levels as close as roundings.
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

// What is nearer than the level by the tolerance is on the left of all curves, what is farther by it on the right: told by
// how often they wind about a point.
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
    BOOST_TEST(std::abs(total_length(curves, level) - 2 * pi * level) < 1e-3);
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
    BOOST_TEST(std::abs(length(isoline) - 40) < 1e-10);
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
  BOOST_TEST(std::abs(total_length(edge, 2) - 4 * pi) < 0.05);
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
    BOOST_TEST(std::abs(total_length(curves, inner) - pi * inner) < 1e-2 * inner);
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

BOOST_AUTO_TEST_CASE(numbers_that_cannot_be)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(2, 2, Diagonal_rule::RISING));
  const Closed_field field(mesh, from_points({{1, 1}}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(double wrong : {nan, infinity, -infinity})
    BOOST_CHECK_EXCEPTION(isolines(mesh, field, std::vector<double>{1, wrong}, 0.1), FG::Invalid_parameter_error,
                          [](const FG::Error& e) { return e.elements() == std::vector<std::size_t>{1}; });
  for(double wrong : {nan, infinity, 0., -1., 1e-300, 1e-15}) { // the last ones are lost in roundings
    BOOST_CHECK_THROW(isolines(mesh, field, std::vector<double>{1}, wrong), FG::Invalid_parameter_error);
    BOOST_CHECK_THROW(boundaries(mesh, field, wrong), FG::Invalid_parameter_error);
  }
  const Closed_field broken(mesh, {[&](const Coordinates& p) { return p[0] == 2 ? nan : p[0]; }});
  BOOST_CHECK_THROW(isolines(mesh, broken, std::vector<double>{1}, 0.1), FG::Invalid_parameter_error);
  const Mesh astray = to_mesh<Mesh>(with_nan_coordinate());
  BOOST_CHECK_THROW(isolines(astray, field, std::vector<double>{1}, 0.1), FG::Invalid_coordinate_error);
  Mesh square;
  const auto v = [&](double x, double y) { return square.add_vertex(Point(x, y, 0)); };
  square.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
  const Closed_field of_square(square, from_points({{1, 1}}));
  BOOST_CHECK_THROW(isolines(square, of_square, std::vector<double>{1}, 0.1), FG::Invalid_mesh_error);
  BOOST_CHECK_THROW(boundaries(square, of_square, 0.1), FG::Invalid_mesh_error);
  BOOST_TEST(isolines(Mesh(), field, std::vector<double>{1}, 0.1).empty());
}

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
  for(int i = 0; i < 6; ++i) {
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

// With points of its own for a mesh that has none, and a field that is linear in faces.
BOOST_AUTO_TEST_CASE(interpolated_distances)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(5, 5, Diagonal_rule::ALTERNATING));
  using Map = std::map<Mesh::Vertex_index, double>;
  std::vector<Map> distances(2);
  for(const auto v : mesh.vertices()) {
    distances[0][v] = mesh.point(v).x();
    distances[1][v] = 5.5 - mesh.point(v).x();
  }
  using Pmap = boost::const_associative_property_map<Map>;
  const FG::Interpolated_distances<Mesh, Pmap> field(mesh, {Pmap(distances[0]), Pmap(distances[1])});
  const auto curves = isolines(mesh, field, std::vector<double>{1, 2.25}, 0.2);
  BOOST_TEST_REQUIRE(curves.size() == 4u);
  for(const Isoline& isoline : curves) {
    check_polyline(mesh, isoline);
    BOOST_TEST(std::abs(length(isoline) - 5) < 1e-12);
  }
  const auto middle = boundaries(mesh, field, 0.2);
  BOOST_TEST_REQUIRE(middle.size() == 1u);
  BOOST_TEST(std::abs(length(middle[0]) - 5) < 1e-11);
  BOOST_TEST(std::abs(middle[0].points.front().x() - 2.75) < 1e-12);
}

BOOST_AUTO_TEST_CASE(interpolated_infinities_and_ties)
{
  const Mesh mesh = to_mesh<Mesh>(single_triangle());
  using Map = std::map<Mesh::Vertex_index, double>;
  using Pmap = boost::const_associative_property_map<Map>;
  const Mesh::Vertex_index a(0), b(1), c(2);
  const Map first = {{a, 1}, {b, infinity}, {c, 3}}, second = {{a, 1}, {b, 5}, {c, 2}},
            broken = {{a, std::numeric_limits<double>::quiet_NaN()}, {b, 5}, {c, 2}};
  const FG::Interpolated_distances<Mesh, Pmap> field(mesh, {Pmap(first), Pmap(second)}), alone(mesh, {Pmap(first)});
  const Mesh::Face_index f(0);
  std::array<double, 3> at_a = {0, 0, 0}, at_b = {0, 0, 0}, between_a_and_c = {0.5, 0.5, 0.5};
  Mesh::Halfedge_index h = mesh.halfedge(f);
  for(int i = 0; i < 3; ++i, h = mesh.next(h)) {
    at_a[i] = mesh.source(h) == a ? 1 : 0;
    at_b[i] = mesh.source(h) == b ? 1 : 0;
    between_a_and_c[i] = mesh.source(h) == b ? 0 : 0.5;
  }
  BOOST_TEST(field(f, at_a).distance == 1);
  BOOST_TEST(field(f, at_a).source == 0u);
  BOOST_TEST(field(f, at_b).distance == 5);
  BOOST_TEST(field(f, at_b).source == 1u);
  BOOST_TEST(field(f, between_a_and_c).distance == 1.5);
  BOOST_TEST(alone(f, at_b).distance == infinity);
  BOOST_TEST(alone(f, between_a_and_c).distance == 2);
  const FG::Interpolated_distances<Mesh, Pmap> damaged(mesh, {Pmap(broken)});
  BOOST_CHECK_THROW(isolines(mesh, damaged, std::vector<double>{1}, 0.1), FG::Invalid_parameter_error);
}

BOOST_AUTO_TEST_CASE(any_mesh_with_points_of_its_own)
{
  const Mesh_archetype mesh(flat_grid(3, 3, Diagonal_rule::RISING));
  const Archetype_point_map points = {&mesh};
  const auto field = [&](Mesh_archetype::Face f, const std::array<double, 3>& w) {
    Coordinates p = {0, 0, 0};
    auto h = halfedge(f, mesh);
    for(int i = 0; i < 3; ++i, h = next(h, mesh))
      for(int d = 0; d < 3; ++d)
        p[d] += w[i] * get(points, source(h, mesh))[d];
    return Answer{std::hypot(p[0] - 1.4, p[1] - 1.7), 0};
  };
  std::vector<FG::Isoline<Mesh_archetype, Mesh_archetype::Point>> curves;
  FG::isolines(mesh, field, std::vector<double>{1}, std::back_inserter(curves), 0.05,
               CGAL::parameters::vertex_point_map(points));
  BOOST_TEST_REQUIRE(curves.size() == 1u);
  BOOST_TEST(curves[0].is_closed);
  std::vector<FG::Voronoi_boundary<Mesh_archetype, Mesh_archetype::Point>> none;
  FG::voronoi_boundaries(mesh, field, std::back_inserter(none), 0.05, CGAL::parameters::vertex_point_map(points));
  BOOST_TEST(none.empty());
}
