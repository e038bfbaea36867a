// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE polygon_soup_repair

#include "generated_meshes.h"
#include "invalid_meshes.h"
#include "mesh_soup.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/polygon_soup_to_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using FG::Repair;
using FG::Repair_report;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Polygon = std::vector<std::size_t>;

struct Soup
{
  std::vector<Point_3> points;
  std::vector<Polygon> polygons;
};

Soup to_soup(const Mesh_soup& mesh)
{
  Soup soup;
  for(const Coordinates& p : mesh.points)
    soup.points.emplace_back(p[0], p[1], p[2]);
  for(const Corners& t : mesh.triangles)
    soup.polygons.emplace_back(t.begin(), t.end());
  return soup;
}

Soup to_soup(const Mesh& mesh)
{
  Soup soup;
  for(const auto v : mesh.vertices())
    soup.points.push_back(mesh.point(v));
  for(const auto f : mesh.faces()) {
    soup.polygons.emplace_back();
    for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      soup.polygons.back().push_back(v);
  }
  return soup;
}

/// Each triangle with points of its own.
Soup taken_apart(const Soup& soup)
{
  Soup result;
  for(const Polygon& polygon : soup.polygons) {
    result.polygons.emplace_back();
    for(const std::size_t v : polygon) {
      result.polygons.back().push_back(result.points.size());
      result.points.push_back(soup.points[v]);
    }
  }
  return result;
}

bool is_rotation(const Polygon& a, Polygon b)
{
  for(std::size_t i = 0; i < b.size() && a != b; ++i)
    std::rotate(b.begin(), b.begin() + 1, b.end());
  return a == b;
}

// An oriented manifold without collinear triangles, found without halfedges.
void check_mesh(const Mesh& mesh)
{
  const Soup soup = to_soup(mesh);
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  std::vector<std::map<std::size_t, std::size_t>> links(soup.points.size()); // from corner to corner around a vertex
  for(const Polygon& t : soup.polygons) {
    BOOST_REQUIRE_EQUAL(t.size(), 3u);
    BOOST_CHECK(!CGAL::collinear(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
    for(std::size_t i = 0; i < 3; ++i) {
      BOOST_CHECK_EQUAL((++sides[{t[i], t[(i + 1) % 3]}]), 1);
      links[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    }
  }
  for(const auto& link : links) { // one chain, or one cycle
    std::set<std::size_t> heads;
    for(const auto& step : link)
      heads.insert(step.second);
    std::size_t start = link.empty() ? 0 : link.begin()->first, length = 0;
    for(const auto& step : link)
      start = heads.count(step.first) == 0 ? step.first : start;
    for(auto at = link.find(start); at != link.end() && length < link.size(); at = link.find(at->second))
      ++length;
    BOOST_CHECK_EQUAL(length, link.size());
  }
}

bool is_finite(const Point_3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

void check_vertex_map(const Soup& soup, const Mesh& mesh, const Repair_report& report)
{
  BOOST_REQUIRE_EQUAL(report.number_of_points(), soup.points.size());
  BOOST_CHECK_EQUAL(mesh.number_of_vertices(), soup.points.size() + report.number_of(Repair::VERTICES_SPLIT));
  for(const auto v : mesh.vertices()) {
    const std::size_t i = report.point_of_vertex(v);
    BOOST_CHECK(is_finite(mesh.point(v)));
    BOOST_CHECK(!is_finite(soup.points[i]) || mesh.point(v) == soup.points[i]);
    BOOST_CHECK(v >= soup.points.size() || i == v);
    const auto vertices = report.vertices_of_point(i);
    BOOST_CHECK(mesh.is_isolated(v) || std::count(vertices.begin(), vertices.end(), v) == 1);
  }
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(const std::size_t v : report.vertices_of_point(i)) {
      BOOST_CHECK(mesh.point(Mesh::Vertex_index(static_cast<unsigned>(v))) == soup.points[i]);
      BOOST_CHECK(!mesh.is_isolated(Mesh::Vertex_index(static_cast<unsigned>(v))));
    }
}

void check_face_map(const Soup& soup, const Mesh& mesh, const Repair_report& report)
{
  BOOST_REQUIRE_EQUAL(report.number_of_polygons(), soup.polygons.size());
  std::size_t count = 0, last = 0;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    for(const std::size_t f : report.faces_of_polygon(i)) {
      BOOST_CHECK_EQUAL(f, count++);
      BOOST_CHECK_EQUAL(report.polygon_of_face(f), i);
      last = i;
    }
  BOOST_CHECK_EQUAL(count, mesh.number_of_faces());
  BOOST_CHECK(last < soup.polygons.size());
}

struct Repaired
{
  Mesh mesh;
  Repair_report report;

  std::size_t number_of_components() const
  {
    Mesh copy = mesh;
    const auto components = FG::internal::face_components(copy);
    return components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
  }

  std::size_t number_of_border_edges() const
  {
    const auto edges = mesh.edges();
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [this](Mesh::Edge_index e) { return mesh.is_border(e); }));
  }

  std::size_t number_of_used_vertices() const
  {
    const auto vertices = mesh.vertices();
    return static_cast<std::size_t>(
        std::count_if(vertices.begin(), vertices.end(), [this](Mesh::Vertex_index v) { return !mesh.is_isolated(v); }));
  }

  // As far as it is seen from above; from below it counts as negative.
  double area_from_above() const
  {
    double sum = 0;
    const Soup soup = to_soup(mesh);
    for(const Polygon& t : soup.polygons)
      sum += CGAL::cross_product(soup.points[t[1]] - soup.points[t[0]], soup.points[t[2]] - soup.points[t[0]]).z() / 2;
    return sum;
  }

  double area() const
  {
    double sum = 0;
    const Soup soup = to_soup(mesh);
    for(const Polygon& t : soup.polygons)
      sum += std::sqrt(CGAL::squared_area(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]));
    return sum;
  }
};

void check_same(const Soup& a, const Soup& b)
{
  BOOST_CHECK(a.points == b.points);
  BOOST_CHECK(a.polygons == b.polygons);
}

/// A repair with all that holds of every one.
Repaired repair_once(const Soup& soup)
{
  Repaired result;
  result.report = FG::polygon_soup_to_triangle_mesh(soup.points, soup.polygons, result.mesh);
  check_mesh(result.mesh);
  check_vertex_map(soup, result.mesh, result.report);
  check_face_map(soup, result.mesh, result.report);
  return result;
}

/// A repair after which a second one finds nothing to do.
Repaired repair(const Soup& soup)
{
  const Repaired result = repair_once(soup);
  const Repaired again = repair_once(to_soup(result.mesh));
  BOOST_CHECK(again.report.is_empty());
  check_same(to_soup(again.mesh), to_soup(result.mesh));
  return result;
}

/// Just these repairs, so often.
void check_repairs(const Repair_report& report, const std::map<Repair, std::size_t>& expected)
{
  for(std::size_t i = 0; i < FG::number_of_repairs; ++i) {
    const auto kind = static_cast<Repair>(i);
    const auto it = expected.find(kind);
    BOOST_TEST_INFO(FG::describe(kind, report.number_of(kind)));
    BOOST_CHECK_EQUAL(report.number_of(kind), it == expected.end() ? 0u : it->second);
  }
  BOOST_CHECK_EQUAL(report.lines().size(), expected.size());
  BOOST_CHECK_EQUAL(report.is_empty(), expected.empty());
}

} // namespace

BOOST_AUTO_TEST_CASE(nothing_is_done_to_a_clean_mesh)
{
  const Mesh_soup back_to_back = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}};
  for(const Mesh_soup& clean :
      {single_triangle(), tetrahedron(3), cube(3), genus_3_plate(), torus(9, 7, 3, 1), cylinder(8, 3, 1, 2),
       back_to_back, with_isolated_vertices(cube(2), 2, 3), disjoint_union(cube(1), translated(back_to_back, 0, 0, 7))})
  {
    const Soup soup = to_soup(clean);
    const Repaired repaired = repair(soup);
    BOOST_CHECK(repaired.report.is_empty());
    BOOST_CHECK(repaired.report.lines().empty());
    BOOST_CHECK(to_soup(repaired.mesh).points == soup.points);
    for(std::size_t f = 0; f < soup.polygons.size(); ++f)
      BOOST_CHECK(is_rotation(to_soup(repaired.mesh).polygons[f], soup.polygons[f]));
  }
}

BOOST_AUTO_TEST_CASE(polygons_are_triangulated)
{
  // A step seen from the side, with a corner on a straight side; the fan from corner 0 would leave it.
  const Soup step = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                     {{6, 5, 4, 3, 2, 1, 0}}};
  for(int k = 0; k < 7; ++k) {
    Soup soup = step;
    std::rotate(soup.polygons[0].begin(), soup.polygons[0].begin() + k, soup.polygons[0].end());
    const Repaired repaired = repair(soup);
    check_repairs(repaired.report, {{Repair::POLYGONS_TRIANGULATED, 1}});
    BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), 5u);
    BOOST_CHECK_CLOSE(repaired.area(), 3, 1e-12);
    BOOST_CHECK_CLOSE(repaired.area_from_above(), -3, 1e-12);
    std::reverse(soup.polygons[0].begin(), soup.polygons[0].end());
    BOOST_CHECK_CLOSE(repair(soup).area_from_above(), 3, 1e-12);
  }
  // A quadrilateral with a corner on a straight side has one diagonal only.
  for(int k = 0; k < 4; ++k) {
    Soup soup = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}};
    std::rotate(soup.polygons[0].begin(), soup.polygons[0].begin() + k, soup.polygons[0].end());
    const Repaired repaired = repair(soup);
    check_repairs(repaired.report, {{Repair::POLYGONS_TRIANGULATED, 1}});
    BOOST_CHECK_CLOSE(repaired.area(), 2, 1e-12);
  }
  // A star of five lines is simple in no projection.
  Soup star = {{}, {{0, 2, 4, 1, 3}}};
  for(int i = 0; i < 5; ++i)
    star.points.emplace_back(std::cos(i * 2 * pi / 5), std::sin(i * 2 * pi / 5), 0);
  BOOST_CHECK_EQUAL(repair(star).mesh.number_of_faces(), 3u);
}

// Neither the directions of the axes nor the unit of length have an influence on the triangles.
BOOST_AUTO_TEST_CASE(polygons_are_triangulated_in_the_projection_in_which_they_are_widest)
{
  Soup along_z = {{}, {{}}};
  for(std::size_t i = 0; i < 9; ++i) {
    const double radius = 1 + 0.1 * static_cast<double>(i * i % 7), angle = 2 * pi * static_cast<double>(i) / 9;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    along_z.points.emplace_back(x, y, 0.7 * x + 0.2 * y);
    along_z.polygons[0].push_back(i);
  }
  const std::vector<Polygon> triangles = to_soup(repair(along_z).mesh).polygons;
  BOOST_CHECK_EQUAL(triangles.size(), 7u);
  for(const double scale : {1.0, 1.0 / 1024})
    for(const bool is_along_x : {true, false}) {
      Soup turned = along_z;
      for(Point_3& p : turned.points)
        p = is_along_x ? Point_3(scale * p.z(), scale * p.x(), scale * p.y())
                       : Point_3(scale * p.y(), scale * p.z(), scale * p.x());
      BOOST_CHECK(to_soup(repair(turned).mesh).polygons == triangles);
    }
}

BOOST_AUTO_TEST_CASE(polygons_are_cleaned)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 0, 0},   {1, 1, 0},  {0, 1, 0}, {nan, 0, 0},
                                       {1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {9, 9, 9}};
  // Point 5 repeats point 1; the last polygon passes point 0 twice.
  const Soup soup = {points,
                     {{0, 1, 5, 2, 3, 3}, {0, 2, 4}, {0, 1, 99}, {1, 5, 2}, {8, 8, 8}, {0, 6, 7}, {3, 2, 0, 7, 6, 0}}};
  const Repaired repaired = repair(soup);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POINTS_NOT_FINITE), 1u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POLYGONS_WITHOUT_POINTS), 2u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POLYGONS_COLLAPSED), 2u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::CORNERS_REPEATED), 2u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POLYGONS_SPLIT), 1u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POINTS_LEFT), 1u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POINTS_MERGED), 1u);
  BOOST_CHECK(repaired.report.vertices_of_point(4).empty());
  BOOST_CHECK(repaired.report.vertices_of_point(8).empty());
  BOOST_CHECK(repaired.report.vertices_of_point(5) == repaired.report.vertices_of_point(1));
  BOOST_CHECK(repaired.report.faces_of_polygon(1).empty());

  // Both parts of a polygon that passes a point twice are kept.
  const Repaired pinched =
      repair(Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2, 0, 3, 4}}});
  BOOST_CHECK_EQUAL(pinched.report.number_of(Repair::POLYGONS_SPLIT), 1u);
  BOOST_CHECK_EQUAL(pinched.report.faces_of_polygon(0).size(), 2u);

  // The first corner again at the end, which closes what is closed.
  const Soup closed = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 0, 0}}};
  check_repairs(repair(closed).report, {{Repair::CORNERS_REPEATED, 2}, {Repair::POLYGONS_TRIANGULATED, 1}});

  // Whichever coordinate is no number.
  for(const double x : {nan, std::numeric_limits<double>::infinity()})
    for(const Point_3& bad : {Point_3(x, 1, 1), Point_3(1, x, 1), Point_3(1, 1, x)}) {
      Soup with_bad = closed;
      with_bad.points.push_back(bad);
      with_bad.polygons = {{0, 1, 2}, {0, 2, 4}};
      const Repair_report report = repair(with_bad).report;
      BOOST_CHECK_EQUAL(report.number_of(Repair::POINTS_NOT_FINITE), 1u);
      BOOST_CHECK_EQUAL(report.number_of(Repair::POLYGONS_WITHOUT_POINTS), 1u);
    }
}

BOOST_AUTO_TEST_CASE(duplicates_are_dropped)
{
  const std::size_t last = cube(2).triangles.size() - 1;
  for(const std::size_t copied : {std::size_t(0), std::size_t(5), last}) {
    Soup soup = to_soup(cube(2));
    const Polygon copy = soup.polygons[copied];
    soup.polygons.push_back({copy[1], copy[2], copy[0]});                                          // turned
    soup.polygons.push_back({copy[1], copy[0], copy[2]});                                          // turned over
    soup.polygons.push_back({soup.points.size(), soup.points.size() + 1, soup.points.size() + 2}); // of its own points
    for(const std::size_t v : copy)
      soup.points.push_back(Point_3(soup.points[v]));
    const Repaired repaired = repair(soup);
    check_repairs(repaired.report, {{Repair::DUPLICATES_DROPPED, 3}, {Repair::POINTS_MERGED, 3}});
    BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 0u);
  }
}

BOOST_AUTO_TEST_CASE(most_orientations_are_kept)
{
  Soup soup = to_soup(sphere(4));
  std::reverse(soup.polygons[0].begin(), soup.polygons[0].end());
  std::reverse(soup.polygons[7].begin(), soup.polygons[7].end());
  const Repaired repaired = repair(soup);
  check_repairs(repaired.report, {{Repair::POLYGONS_REVERSED, 2}});
  BOOST_CHECK(is_rotation(to_soup(repaired.mesh).polygons[1], soup.polygons[1]));
}

BOOST_AUTO_TEST_CASE(what_is_no_manifold_is_cut_apart)
{
  const Repaired fin = repair(to_soup(with_non_manifold_edge()));
  check_repairs(fin.report, {{Repair::EDGES_CUT, 1}, {Repair::VERTICES_SPLIT, 4}});
  BOOST_CHECK_EQUAL(fin.report.vertices_of_point(0).size(), 3u);

  const Repaired two = repair(to_soup(with_non_manifold_vertex()));
  check_repairs(two.report, {{Repair::VERTICES_SPLIT, 1}});
  BOOST_CHECK_EQUAL(two.number_of_border_edges(), 0u);
  BOOST_CHECK_EQUAL(two.number_of_components(), 2u);

  const Repaired band = repair(to_soup(moebius_band()));
  BOOST_CHECK_EQUAL(band.number_of_components(), 1u);
  BOOST_CHECK_EQUAL(band.report.number_of(Repair::VERTICES_SPLIT), 2u);
  BOOST_CHECK_EQUAL(band.mesh.number_of_faces(), 5u);
}

// Two boxes share the vertices of an edge, in several pieces: each is closed again after it was cut.
BOOST_AUTO_TEST_CASE(solids_that_share_edges_stay_closed)
{
  const Mesh_soup boxes = disjoint_union(cube(3), translated(cube(3), 3, 3, 0));
  Soup soup = to_soup(boxes);
  std::map<Point_3, std::size_t> vertices;
  for(Polygon& polygon : soup.polygons)
    for(std::size_t& v : polygon)
      v = vertices.emplace(soup.points[v], v).first->second;
  const Repaired repaired = repair(soup);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::EDGES_CUT), 3u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::VERTICES_SPLIT), 4u);
  BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 0u);
  BOOST_CHECK_EQUAL(repaired.number_of_components(), 2u);
}

BOOST_AUTO_TEST_CASE(borders_in_one_place_are_stitched)
{
  for(const Mesh_soup& whole : {cube(2), torus(9, 7, 3, 1), sphere(3)}) {
    Soup soup = taken_apart(to_soup(whole));
    for(std::size_t f = 0; f < soup.polygons.size(); f += 3)
      std::reverse(soup.polygons[f].begin(), soup.polygons[f].end());
    const Repaired repaired = repair(soup);
    BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 0u);
    BOOST_CHECK_EQUAL(repaired.number_of_components(), 1u);
    BOOST_CHECK_EQUAL(repaired.number_of_used_vertices(), whole.points.size());
    BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POINTS_MERGED), soup.points.size() - whole.points.size());
    BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::POLYGONS_REVERSED), (soup.polygons.size() + 2) / 3);
    for(std::size_t i = 0; i < soup.points.size(); ++i)
      BOOST_CHECK_EQUAL(repaired.report.vertices_of_point(i).size(), 1u);
  }
}

// Points on straight edges of one side only, as many as there is room for, leave degenerate triangles between.
// Two prisms without their ends, each cut open along the edge from p to q. They share two further edges, one at p and one
// at q. If all borders in one place were stitched, two edges would lead from p to q.
BOOST_AUTO_TEST_CASE(borders_stay_open_where_stitching_doubles_an_edge)
{
  const Point_3 p(0, 0, 1), q(0, 0, 0), a(1, 0, 1), e(1, 0, 0), b(0, 1, 1), f(0, 1, 0), d(0, -1, 1), h(0, -1, 0);
  Soup soup = {{p, q, p, q, a, e, b, f, p, q, p, q, a, e, d, h}, {}};
  soup.polygons = {{0, 1, 4},  {4, 1, 5},   {4, 5, 7},    {4, 7, 6},    {6, 7, 3},    {3, 2, 6},
                   {8, 9, 14}, {14, 9, 15}, {14, 15, 13}, {14, 13, 12}, {11, 10, 13}, {10, 12, 13}};
  const Repaired open = repair(soup);
  BOOST_CHECK(open.report.is_empty());
  BOOST_CHECK_EQUAL(open.number_of_components(), 2u);
  // A seam elsewhere is closed all the same.
  for(const Point_3& place :
      {Point_3(5, 0, 0), Point_3(6, 0, 0), Point_3(5, 1, 0), Point_3(6, 0, 0), Point_3(6, 1, 0), Point_3(5, 1, 0)})
    soup.points.push_back(place);
  soup.polygons.insert(soup.polygons.begin(), {{16, 17, 18}, {19, 20, 21}});
  const Repaired closed = repair(soup);
  check_repairs(closed.report, {{Repair::POINTS_MERGED, 2}});
  BOOST_CHECK_EQUAL(closed.number_of_components(), 3u);
  BOOST_CHECK_EQUAL(closed.number_of_border_edges(), open.number_of_border_edges() + 4);
}

BOOST_AUTO_TEST_CASE(collinear_triangles_are_flipped_away)
{
  for(int n : {1, 2, 5, 9}) { // points between (0,0) and (n+1,0)
    Soup soup;
    for(int i = 0; i <= n + 1; ++i)
      soup.points.emplace_back(i, 0, 0);
    const auto last = static_cast<std::size_t>(n + 1), below = last + 1, above = last + 2;
    soup.points.emplace_back(1, -2, 0);
    soup.points.emplace_back(1, 3, 0);
    for(std::size_t i = 0; i < last; ++i)
      soup.polygons.push_back({i, below, i + 1});
    soup.polygons.push_back({0, last, above});
    for(std::size_t i = 1; i < last; ++i) // a fan from point 0, flat
      soup.polygons.push_back({0, i, i + 1});
    const Repaired repaired = repair(soup);
    check_repairs(repaired.report, {{Repair::DEGENERATE_FACES_FLIPPED, static_cast<std::size_t>(n)}});
    BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 4u);
    BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), soup.polygons.size());
    BOOST_CHECK_CLOSE(repaired.area(), 2.5 * (n + 1), 1e-12);
    // What has no area becomes a part of the triangle beyond.
    BOOST_CHECK_EQUAL(repaired.report.faces_of_polygon(last).size(), last);
    for(std::size_t i = last + 1; i < soup.polygons.size(); ++i)
      BOOST_CHECK(repaired.report.faces_of_polygon(i).empty());
    // It is that triangle's orientation, too, that its parts had before.
    for(const std::size_t turned : {std::size_t(0), last})
      std::reverse(soup.polygons[turned].begin(), soup.polygons[turned].end());
    BOOST_CHECK_EQUAL(repair(soup).report.number_of(Repair::POLYGONS_REVERSED), last - 1);
  }
}

// Both sides of a triangle ACD, one with a point B on AC: a flip would make an edge BD that is there already. What has
// no area is dropped, and leaves a slit; whatever the number of faces about B, and their order.
BOOST_AUTO_TEST_CASE(no_edge_is_made_twice)
{
  for(const std::size_t more : {0u, 1u, 8u}) {
    Soup soup = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 2, 3}, {1, 3, 2}, {2, 0, 1}}};
    std::size_t last = 3; // faces about B, between A and D
    for(std::size_t i = 1; i <= more; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(more + 1);
      soup.points.emplace_back(1 - t, 1 - t, 0.2);
      soup.polygons.push_back({1, soup.points.size() - 1, last});
      soup.polygons.push_back({0, last, soup.points.size() - 1});
      last = soup.points.size() - 1;
    }
    soup.polygons.push_back({1, 0, last});
    for(std::size_t k = 0; k < soup.polygons.size(); ++k) {
      std::rotate(soup.polygons.begin(), soup.polygons.begin() + 1, soup.polygons.end());
      const Repaired repaired = repair(soup);
      check_repairs(repaired.report, {{Repair::DEGENERATE_FACES_DROPPED, 1}});
      BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), soup.polygons.size() - 1);
      BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 3u);
    }
  }
}

// Two degenerate triangles on each other, with points of their own in one place: both are dropped.
BOOST_AUTO_TEST_CASE(no_edge_of_length_zero_is_made)
{
  const Soup soup = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, -2, 0}},
                     {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {3, 0, 5}, {2, 3, 5}}};
  const Repaired repaired = repair(soup);
  BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), 4u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::DEGENERATE_FACES_FLIPPED), 0u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::DEGENERATE_FACES_DROPPED), 2u);
  BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 4u);
  BOOST_CHECK_CLOSE(repaired.area(), 4, 1e-12);
}

BOOST_AUTO_TEST_CASE(collinear_triangles_at_a_border_are_dropped)
{
  const Soup soup = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}}};
  const Repaired repaired = repair(soup);
  check_repairs(repaired.report, {{Repair::DEGENERATE_FACES_DROPPED, 1}});
  BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), 2u);
}

// A zero-length edge inside a surface closes: its two triangles go, and its ends are merged.
BOOST_AUTO_TEST_CASE(edges_of_length_zero_close)
{
  Soup soup = to_soup(flat_grid(4, 4, Diagonal_rule::RISING));
  soup.points[12] = soup.points[13];
  const Repaired repaired = repair(soup);
  check_repairs(repaired.report, {{Repair::POLYGONS_COLLAPSED, 2}, {Repair::POINTS_MERGED, 1}});
  BOOST_CHECK_EQUAL(repaired.number_of_border_edges(), 16u);
  BOOST_CHECK(repaired.report.vertices_of_point(12) == repaired.report.vertices_of_point(13));
}

namespace {

// A grid in two halves, with points of their own along the seam, those of one moved by less than `error`.
Soup grid_with_seam(double scale_of_all, double error)
{
  Soup soup;
  Random_numbers random(5);
  for(int half = 0; half < 2; ++half)
    for(int y = 0; y <= 6; ++y)
      for(int x = 3 * half; x <= 3 * half + 3; ++x) {
        const double e = half == 1 && x == 3 ? error : 0;
        const double dx = random.uniform(-e, e), dy = random.uniform(-e, e), dz = random.uniform(-e, e);
        soup.points.emplace_back(scale_of_all * (x + dx), scale_of_all * (y + dy), scale_of_all * (0.1 * x + dz));
      }
  for(std::size_t half = 0; half < 2; ++half)
    for(std::size_t y = 0; y < 6; ++y)
      for(std::size_t x = 0; x < 3; ++x) {
        const std::size_t p = 28 * half + 4 * y + x;
        soup.polygons.push_back({p, p + 1, p + 5});
        soup.polygons.push_back({p, p + 5, p + 4});
      }
  return soup;
}

Repaired weld(const Soup& soup, double tolerance)
{
  Repaired result;
  result.report = FG::polygon_soup_to_triangle_mesh(soup.points, soup.polygons, result.mesh,
                                                    CGAL::parameters::snapping_tolerance(tolerance));
  check_mesh(result.mesh);
  check_face_map(soup, result.mesh, result.report);
  return result;
}

} // namespace

// The box is 6 wide.
BOOST_AUTO_TEST_CASE(borders_that_nearly_coincide_are_reported_and_welded)
{
  for(const double factor : {1.0, 1e-9, 1e12})
    for(const double error : {1e-15, 1e-12, 1e-7}) {
      const Soup soup = grid_with_seam(factor, error);
      const Repaired open = repair(soup);
      BOOST_CHECK_EQUAL(open.number_of_components(), 2u);
      BOOST_CHECK(open.report.is_empty());
      BOOST_CHECK_EQUAL(open.report.number_of_near_border_edges(), 12u);
      BOOST_REQUIRE_EQUAL(open.report.lines().size(), 1u);
      BOOST_CHECK_EQUAL(open.report.lines()[0].find("12 border edges nearly coincide with others and stay open"), 0u);
      const double distance = open.report.distance_of_near_border_edges();
      BOOST_CHECK_GT(distance, error / 60);
      BOOST_CHECK_LT(distance, error / 6 * 1.5 + 1e-15);

      const Repaired welded = weld(soup, 2 * distance);
      check_repairs(welded.report, {{Repair::POINTS_WELDED, welded.report.number_of(Repair::POINTS_WELDED)},
                                    {Repair::POINTS_MERGED, 7}});
      BOOST_CHECK_LE(welded.report.number_of(Repair::POINTS_WELDED), 7u);
      BOOST_CHECK_EQUAL(welded.number_of_components(), 1u);
      BOOST_CHECK_EQUAL(welded.number_of_border_edges(), 24u);
      BOOST_CHECK_EQUAL(welded.report.number_of_near_border_edges(), 0u);
      BOOST_CHECK(weld(to_soup(welded.mesh), 2 * distance).report.is_empty());
    }
  // Neither the order of the polygons nor the orientations of the halves matter.
  Soup soup = grid_with_seam(1, 1e-12);
  const Repair_report expected = repair(soup).report;
  std::shuffle(soup.polygons.begin(), soup.polygons.end(), std::mt19937(3));
  for(Polygon& polygon : soup.polygons)
    if(polygon[0] >= 28)
      std::swap(polygon[0], polygon[1]);
  const Repair_report report = repair(soup).report;
  BOOST_CHECK_EQUAL(report.number_of_near_border_edges(), 12u);
  BOOST_CHECK_EQUAL(report.distance_of_near_border_edges(), expected.distance_of_near_border_edges());
  // Edges inside of two surfaces that nearly coincide are not borders.
  const Mesh_soup inner = cube(2);
  const Soup double_walled = to_soup(disjoint_union(inner, scaled(inner, 1 + 1e-12)));
  BOOST_CHECK_EQUAL(repair(double_walled).report.number_of_near_border_edges(), 0u);
  // Borders that are apart, and one that coincides to the bit, are not mentioned.
  BOOST_CHECK_EQUAL(repair(grid_with_seam(1, 1e-3)).report.number_of_near_border_edges(), 0u);
  BOOST_CHECK_EQUAL(repair(grid_with_seam(1, 0)).report.number_of_near_border_edges(), 0u);
}

// Of points in a row, closer to each other than the tolerance, some stay; no chain of them falls into one place.
BOOST_AUTO_TEST_CASE(points_are_not_welded_farther_than_the_tolerance)
{
  Soup soup;
  for(int i = 0; i <= 100; ++i)
    for(int j = 0; j < 2; ++j)
      soup.points.emplace_back(i, 40 * j, 0);
  for(std::size_t i = 0; i < 100; ++i)
    soup.polygons.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  const Repaired repaired = weld(soup, 0.025); // points at 0, 3, 6, ...
  BOOST_CHECK_EQUAL(repaired.number_of_used_vertices(), 2 * 34u);
  BOOST_CHECK_CLOSE(repaired.area(), 99 * 40, 1e-9);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    BOOST_CHECK_LE(std::abs(repaired.mesh.point(Mesh::Vertex_index(static_cast<unsigned>(i))).x() - soup.points[i].x()),
                   2.5);
  BOOST_CHECK(weld(to_soup(repaired.mesh), 0.025).report.is_empty());
  // Points that are not finite have no box, and a box can be far from the origin in one direction.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(weld({{{nan, 0, 0}, {1, nan, 0}, {0, 1, nan}}, {{0, 1, 2}}}, 0.025), FG::Invalid_mesh_error);
  const Soup far_off = {{{0, 50, 0}, {1, 50, 0}, {0, 51, 0}, {1e-3, 50, 0}}, {{0, 1, 2}, {3, 1, 2}}};
  BOOST_CHECK_EQUAL(weld(far_off, 0.025).report.number_of(Repair::POINTS_WELDED), 1u);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_repaired_is_said)
{
  const auto reason = [](const Soup& soup) -> std::string {
    Mesh mesh;
    try {
      FG::polygon_soup_to_triangle_mesh(soup.points, soup.polygons, mesh);
    } catch(const FG::Invalid_mesh_error& error) {
      BOOST_CHECK_EQUAL(mesh.number_of_vertices(), 0u);
      return error.what();
    }
    return "none";
  };
  BOOST_CHECK_EQUAL(reason({{}, {}}), "the polygon soup has no polygons");
  BOOST_CHECK_EQUAL(reason({{{0, 0, 0}}, {{0, 0, 0}}}),
                    "no triangle remains after the repair: 1 polygon removed: fewer than three distinct corners; 1 "
                    "point left without faces");
  BOOST_CHECK_EQUAL(reason({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}).substr(0, 39),
                    "no triangle remains after the repair: 1");
}

BOOST_AUTO_TEST_CASE(each_repair_has_words)
{
  std::set<std::string> texts;
  for(std::size_t i = 0; i < FG::number_of_repairs; ++i) {
    texts.insert(FG::describe(static_cast<Repair>(i), 2));
    BOOST_CHECK_EQUAL(FG::describe(static_cast<Repair>(i), 2).substr(0, 2), "2 ");
    BOOST_CHECK(FG::describe(static_cast<Repair>(i), 1).substr(1) != FG::describe(static_cast<Repair>(i), 2).substr(1));
    BOOST_CHECK(FG::describe(static_cast<Repair>(i), 0).substr(1) == FG::describe(static_cast<Repair>(i), 2).substr(1));
  }
  BOOST_CHECK_EQUAL(texts.size(), FG::number_of_repairs);
}

namespace {

// Damages of a soup; each keeps it a soup, and nothing more.
void damage(Soup& soup, Random_numbers& random)
{
  const auto point = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(soup.points.size()))); };
  const auto polygon = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(soup.polygons.size()))); };
  const std::size_t f = polygon(), v = point();
  switch(random.below(11)) {
  case 0:
    soup.polygons.erase(soup.polygons.begin() + static_cast<std::ptrdiff_t>(f));
    break;
  case 1:
    soup.polygons.push_back(Polygon(soup.polygons[f]));
    break;
  case 2:
    std::reverse(soup.polygons[f].begin(), soup.polygons[f].end());
    break;
  case 3: // merge two points
    for(Polygon& corners : soup.polygons)
      std::replace(corners.begin(), corners.end(), v, point());
    break;
  case 4:
    soup.points[v] = Point_3(soup.points[point()]);
    break;
  case 5: // onto a straight line
    soup.points[v] = CGAL::midpoint(soup.points[point()], soup.points[point()]);
    break;
  case 6: // a corner in the middle of a side, not in the neighbor's
    soup.points.push_back(CGAL::midpoint(soup.points[soup.polygons[f][0]], soup.points[soup.polygons[f][1]]));
    soup.polygons[f].insert(soup.polygons[f].begin() + 1, soup.points.size() - 1);
    break;
  case 7: // a triangle anywhere
    soup.polygons.push_back({point(), point(), point()});
    break;
  case 8:
    soup.polygons.push_back({point(), point(), point(), point(), point(), point()});
    break;
  case 9:
    soup.points[v] = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
    break;
  default: // points of its own
    for(std::size_t& corner : soup.polygons[f]) {
      soup.points.push_back(Point_3(soup.points[corner]));
      corner = soup.points.size() - 1;
    }
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(whatever_is_damaged_is_repaired)
{
  const std::vector<Mesh_soup> meshes = {tetrahedron(), cube(2), flat_grid(5, 4, Diagonal_rule::RISING),
                                         torus(6, 5, 3, 1)};
  const int runs = 300 * scale / (has_all_cases ? 1 : 2);
  for(int run = 0; run < runs; ++run) {
    BOOST_TEST_CONTEXT("run " << run)
    {
      Random_numbers random(static_cast<unsigned>(run));
      Soup soup = to_soup(meshes[static_cast<std::size_t>(run) % meshes.size()]);
      for(int i = 1 + random.below(run % 3 == 0 ? 40 : 5); i > 0 && !soup.polygons.empty(); --i)
        damage(soup, random);
      try {
        repair(soup);
      } catch(const FG::Invalid_mesh_error& error) {
        BOOST_CHECK_EQUAL(run % 4, 0); // of a tetrahedron, nothing may be left
        BOOST_TEST_MESSAGE(error.what());
      }
    }
  }
}

// The second repair would stitch the two edges from (0, 0) to (0, 1), in a place where there are no others, since the
// first one has reversed a triangle after it looked for borders.
BOOST_AUTO_TEST_CASE(borders_are_stitched_after_triangles_are_reversed)
{
  const Repaired repaired =
      repair({{{0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {0, 0, 0}, {2, 1, 0}},
              {{6, 7, 5}, {7, 1, 2}, {7, 2, 6}, {5, 2, 7}}});
  BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), 4u);
}

// Triangles that were dropped in a later round leave others to be cut apart, whether one was flipped or not.
BOOST_AUTO_TEST_CASE(triangles_are_cut_apart_after_others_were_dropped)
{
  const Repaired repaired = repair({{{1, 1, 0},
                                     {2, 2, 0},
                                     {0, 0, 0},
                                     {1, 1, 0},
                                     {0, 2, 0},
                                     {2, 0, 0},
                                     {1, 1, 0},
                                     {1, 2, 0},
                                     {1, 1, 0},
                                     {1, 1, 0},
                                     {1, 0, 0}},
                                    {{8, 2, 5}, {0, 7, 1}, {1, 9, 2}}});
  BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), 2u);
  BOOST_CHECK_EQUAL(repaired.number_of_components(), 2u);
}

BOOST_AUTO_TEST_CASE(duplicates_made_by_flips_are_dropped)
{
  const Repaired repaired =
      repair({{{2, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 2, 0}, {0, 0, 0}}, {{2, 3, 1}, {0, 4, 3}, {1, 2, 0}, {4, 1, 3}}});
  BOOST_CHECK_EQUAL(repaired.mesh.number_of_faces(), 2u);
  BOOST_CHECK_EQUAL(repaired.report.number_of(Repair::DUPLICATES_DROPPED), 1u);
}

namespace {

// A few polygons on few places of a lattice, most of which have several points.
Soup crowded_soup(Random_numbers& random)
{
  Soup soup;
  const int number_of_points = 5 + random.below(8), depth = 1 + random.below(3);
  for(int i = 0; i < number_of_points; ++i) {
    const int x = random.below(3), y = random.below(3), z = random.below(depth);
    soup.points.emplace_back(x, y, z);
  }
  for(int i = 3 + random.below(12); i > 0; --i) {
    soup.polygons.emplace_back();
    for(int corners = random.below(6) == 0 ? 4 + random.below(2) : 3; corners > 0; --corners)
      soup.polygons.back().push_back(static_cast<std::size_t>(random.below(number_of_points)));
  }
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_second_repair_of_a_crowded_soup_changes_nothing)
{
  const int runs = 4000 * scale / (has_all_cases ? 1 : 5);
  int repaired = 0;
  for(int run = 0; run < runs; ++run) {
    BOOST_TEST_CONTEXT("run " << run)
    {
      Random_numbers random(static_cast<unsigned>(run));
      try {
        repair(crowded_soup(random));
        ++repaired;
      } catch(const FG::Invalid_mesh_error& error) { // all polygons have collapsed
        BOOST_TEST_MESSAGE(error.what());
      }
    }
  }
  BOOST_CHECK_GT(repaired, runs / 4 * 3);
}

BOOST_AUTO_TEST_CASE(the_finished_fraction_grows)
{
  struct Fractions
  {
    std::vector<double> all;

    void on_progress(double fraction) { all.push_back(fraction); }
  };

  const Soup soup = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  Fractions fractions;
  Mesh mesh;
  FG::polygon_soup_to_triangle_mesh(soup.points, soup.polygons, mesh, CGAL::parameters::visitor(std::ref(fractions)));
  BOOST_CHECK_GT(fractions.all.size(), 2);
  BOOST_CHECK(std::is_sorted(fractions.all.begin(), fractions.all.end()));
  BOOST_CHECK(fractions.all.front() >= 0 && fractions.all.back() <= 1);
}
