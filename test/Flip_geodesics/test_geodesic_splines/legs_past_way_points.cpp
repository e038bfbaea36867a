// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The legs of curves through points pass the other way points as geodesics do.

#include "Double_triangulation.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Leg_drawer.h>
#include <CGAL/Flip_geodesics/shorten.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace legs_past_way_points {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = Double_triangulation<Mesh>;
using Network = FG::Edge_path_network<Triangulation>;
using Plane_point = std::array<double, 2>;
using Polygon = std::vector<Plane_point>;

inline double area(const Plane_point& p, const Plane_point& q, const Plane_point& r)
{
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

inline bool crosses_itself(const Polygon& p)
{
  for(std::size_t i = 0; i + 1 < p.size(); ++i)
    for(std::size_t j = i + 2; j + 1 < p.size(); ++j)
      if(area(p[i], p[i + 1], p[j]) * area(p[i], p[i + 1], p[j + 1]) < 0 &&
         area(p[j], p[j + 1], p[i]) * area(p[j], p[j + 1], p[i + 1]) < 0)
        return true;
  return false;
}

inline double length(const Polygon& p)
{
  double sum = 0;
  for(std::size_t i = 0; i + 1 < p.size(); ++i)
    sum += std::hypot(p[i][0] - p[i + 1][0], p[i][1] - p[i + 1][1]);
  return sum;
}

/* Control points between 0 and `extent`. */
inline Polygon random_polygon(Random_numbers& random, std::size_t size, double extent)
{
  constexpr int steps = 4096;
  Polygon result;
  while(result.size() < size) {
    const double x = random.below(steps) + 0.5, y = random.below(steps) + 0.25;
    result.push_back({extent * x / steps, extent * y / steps});
  }
  return result;
}

inline FG::Surface_location location(const Triangulation& triangulation, const Mesh& mesh, const Plane_point& p)
{
  for(Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    std::array<Plane_point, 3> corners;
    auto corner = h;
    for(Plane_point& q : corners) {
      q = {mesh.point(mesh.source(corner)).x(), mesh.point(mesh.source(corner)).y()};
      corner = mesh.next(corner);
    }
    const std::array<double, 3> weights = {
        {area(p, corners[1], corners[2]), area(p, corners[2], corners[0]), area(p, corners[0], corners[1])}};
    if(weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0)
      return {triangulation.input().index(h), weights};
  }
  BOOST_FAIL("a point is outside of the mesh");
  return {};
}

struct Counts
{
  int simple = 0, crossing = 0, refused = 0, bent = 0, missed = 0;
};

/* Draws random control polygons, and counts those of splines that are not what they are in the plane. */
inline Counts count_polygons(const Mesh& mesh, double extent, std::size_t size, int number, unsigned seed)
{
  Triangulation triangulation(mesh);
  Random_numbers random(seed);
  Counts counts;
  for(int i = 0; i < number; ++i) {
    const Polygon polygon = random_polygon(random, size, extent);
    const bool is_crossing = crosses_itself(polygon);
    ++(is_crossing ? counts.crossing : counts.simple);
    {
      Network network(triangulation);
      std::vector<FG::Surface_location> points;
      for(const Plane_point& p : polygon)
        points.push_back(location(triangulation, mesh, p));
      try {
        const FG::Curve_index curve = FG::add_curve_through(network, points);
        FG::order_overlapping_curves(network);
        FG::shorten(network);
        BOOST_TEST(network.is_valid());
        counts.missed += is_crossing ? 1 : 0;
        counts.bent += !is_crossing && std::abs(network.length(curve) - length(polygon)) > 1e-9 ? 1 : 0;
      } catch(const FG::Crossing_curves_error&) {
        counts.refused += is_crossing ? 0 : 1;
      }
    }
    BOOST_TEST(triangulation.is_valid());
    triangulation.rollback();
  }
  return counts;
}

inline void check_polygons(const Mesh& mesh, double extent, std::size_t size, unsigned seed)
{
  const Counts counts = count_polygons(mesh, extent, size, 200, seed);
  BOOST_TEST(counts.simple > 50);
  BOOST_TEST(counts.crossing > 20);
  BOOST_TEST(counts.refused == 0);
  BOOST_TEST(counts.bent == 0);
  BOOST_TEST(counts.missed == 0);
}

BOOST_AUTO_TEST_CASE(control_polygons_of_the_plane_are_drawn_as_they_are)
{
  Mesh triangle;
  triangle.add_face(triangle.add_vertex(Point(0, 0, 0)), triangle.add_vertex(Point(2, 0, 0)),
                    triangle.add_vertex(Point(0, 2, 0)));
  check_polygons(triangle, 1, 4, 1);
  for(int n : {1, 2, 3, 8})
    check_polygons(to_mesh<Mesh>(flat_grid(n, n, Diagonal_rule::ALTERNATING)), n, n < 3 ? 4 : 5,
                   static_cast<unsigned>(n));
}

// Between vertices, geodesics that are pulled tight one at a time start from the same paths.
BOOST_AUTO_TEST_CASE(legs_on_a_torus_are_the_geodesics_one_at_a_time)
{
  const Mesh mesh = to_mesh<Mesh>(torus(24, 12, 1, 0.4));
  Triangulation triangulation(mesh);
  Random_numbers random(3);
  int drawn = 0;
  for(int i = 0; i < 60; ++i) {
    std::vector<FG::Surface_location> points;
    for(int k = 0; k < 5; ++k)
      points.push_back(triangulation.location(FG::Vertex_index(random.below(triangulation.number_of_vertices()))));
    const double expected = FG::geodesics_through(triangulation, points).report.curves.front().length;
    {
      Network network(triangulation);
      try {
        const FG::Curve_index curve = FG::add_curve_through(network, points);
        FG::order_overlapping_curves(network);
        BOOST_TEST(std::abs(network.length(curve) - expected) < 1e-9);
        FG::shorten(network);
        BOOST_TEST(std::abs(network.length(curve) - expected) < 1e-9);
        BOOST_TEST(network.is_valid());
        ++drawn;
      } catch(const FG::Crossing_curves_error&) {
      } catch(const FG::Ambiguous_order_error&) {
      }
    }
    triangulation.rollback();
  }
  BOOST_TEST(drawn > 20);
}

// The curve that is there crosses the straight line between two way points, and need not.
BOOST_AUTO_TEST_CASE(legs_that_would_cross_another_curve_follow_edges)
{
  const Mesh mesh = to_mesh<Mesh>(flat_grid(6, 6, Diagonal_rule::RISING));
  Triangulation triangulation(mesh);
  Network network(triangulation);
  const auto vertex = [](int x, int y) { return FG::Vertex_index(7 * y + x); };
  std::vector<FG::Vertex_index> there = {vertex(1, 3), vertex(1, 2), vertex(2, 2), vertex(2, 1)};
  network.add_curve(FG::halfedges_through(triangulation, there));
  std::vector<FG::Surface_location> points;
  for(FG::Vertex_index v : {vertex(1, 2), vertex(2, 1), vertex(5, 1)})
    points.push_back(triangulation.location(v));
  const FG::Curve_index curve = FG::add_curve_through(network, points);
  FG::order_overlapping_curves(network);
  FG::shorten(network);
  BOOST_TEST(network.is_valid());
  BOOST_TEST(std::abs(network.length(curve) - (3 + std::sqrt(2.0))) < 1e-9);
}

/* The number of edges that arcs cross another number of times than the edges of the input do. */
inline int count_differences(const Triangulation& triangulation, const FG::internal::Followed_arcs<Triangulation>& arcs)
{
  std::vector<int> crossings(static_cast<std::size_t>(triangulation.number_of_edges()), 0);
  for(std::size_t i = 0; i < arcs.size(); ++i)
    for(FG::Halfedge_index h : arcs[i].crossed)
      ++crossings[static_cast<std::size_t>(Triangulation::edge(h).idx())];
  int result = 0;
  for(std::size_t e = 0; e < crossings.size(); ++e)
    result += crossings[e] == (std::max)(triangulation.crossings(FG::Edge_index(static_cast<FG::Index>(e))), 0) ? 0 : 1;
  return result;
}

// The edges of the input, followed through flips, cross each edge as often as its normal coordinate tells.
BOOST_AUTO_TEST_CASE(arcs_follow_flips_there_and_back)
{
  for(const Mesh_soup& soup : {torus(8, 5, 1, 0.4), flat_grid(4, 4, Diagonal_rule::ALTERNATING)}) {
    const Mesh mesh = to_mesh<Mesh>(soup);
    Triangulation triangulation(mesh);
    FG::internal::Followed_arcs<Triangulation> arcs(triangulation);
    for(FG::Index e = 0; e < triangulation.number_of_edges(); ++e)
      arcs.add({FG::Halfedge_index(2 * e), {}});
    Random_numbers random(7);
    int flips = 0;
    for(int i = 0; i < 2000; ++i) {
      const FG::Halfedge_index h(random.below(triangulation.number_of_halfedges()));
      if(!triangulation.is_flippable(h))
        continue;
      arcs.follow(h, [&] { triangulation.flip(h); });
      ++flips;
    }
    BOOST_TEST(flips > 100);
    BOOST_TEST(count_differences(triangulation, arcs) == 0);
    arcs.roll_back(0);
    for(FG::Index e = 0; e < triangulation.number_of_edges(); ++e)
      BOOST_TEST(arcs[static_cast<std::size_t>(e)].along == FG::Halfedge_index(2 * e));
  }
}

} // namespace legs_past_way_points
