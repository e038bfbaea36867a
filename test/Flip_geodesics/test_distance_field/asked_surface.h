// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Surfaces whose distances are asked for, and what holds for each path and each gradient.

#ifndef FLIP_GEODESICS_TEST_DISTANCE_FIELD_ASKED_SURFACE_H
#define FLIP_GEODESICS_TEST_DISTANCE_FIELD_ASKED_SURFACE_H

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>

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

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using FG::Vertex_index;
using FG::internal::descriptors;

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

inline double distance_in_space(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

inline void check_close(double a, double b, double scale, const std::string& what)
{
  BOOST_TEST(std::abs(a - b) <= 1e-9 * scale, what << ": " << a << " and " << b);
}

// The path has the length of the distance, and ends at a source.
inline void check_path(const Asked_surface& s, const Field& field, const Location& from, double scale)
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
inline void check_gradient(const Asked_surface& s, const Field& field, const Location& at)
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

inline std::vector<std::pair<std::string, Mesh_soup>> meshes()
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

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_DISTANCE_FIELD_ASKED_SURFACE_H
