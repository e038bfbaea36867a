// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_TRACE_GEODESIC_RAYS_H
#define FLIP_GEODESICS_TEST_TRACE_GEODESIC_RAYS_H

#include "generated_meshes.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// Rays on surfaces of points.
namespace rays_test {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Face = Surface::Face_index;
using Face_location = std::pair<Face, std::array<double, 3>>;
using Curve_point = FG::Curve_point<Surface, Point>;
using FG::At_vertices;
using FG::Trace_status;

inline Point point_at(const Surface& mesh, const Face_location& location)
{
  const Halfedge h = mesh.halfedge(location.first);
  const std::array<Vertex, 3> corners = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
  Vector sum(0, 0, 0);
  for(int i = 0; i < 3; ++i)
    sum = sum + location.second[i] * (mesh.point(corners[i]) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum;
}

inline double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// The face location of a vertex in one of its faces.
inline Face_location at_vertex(const Surface& mesh, Vertex v)
{
  Halfedge h = mesh.halfedge(v); // arrives
  while(mesh.is_border(h))
    h = mesh.opposite(mesh.next(h));
  Face_location result = {mesh.face(h), {0, 0, 0}};
  Halfedge corner = mesh.halfedge(result.first);
  for(double& weight : result.second) {
    weight = mesh.source(corner) == v ? 1 : 0;
    corner = mesh.next(corner);
  }
  return result;
}

inline Face_location random_location(const Surface& mesh, std::mt19937& random)
{
  std::uniform_real_distribution<double> weight(0.05, 1);
  const std::array<double, 3> w = {weight(random), weight(random), weight(random)};
  const double sum = w[0] + w[1] + w[2];
  return {Face(random() % mesh.number_of_faces()), {w[0] / sum, w[1] / sum, w[2] / sum}};
}

struct Traced
{
  std::vector<Point> points;
  FG::Trace_result<std::back_insert_iterator<std::vector<Point>>, Surface> result;
};

template <class Source, class Direction, class... Options>
Traced trace(const Surface& mesh, const Source& source, const Direction& direction, double length,
             const Options&... options)
{
  std::vector<Point> points;
  const auto result = FG::trace_geodesic(mesh, source, direction, length, std::back_inserter(points), options...);
  return {points, result};
}

inline double length_of(const std::vector<Point>& points)
{
  double length = 0;
  for(std::size_t i = 1; i < points.size(); ++i)
    length += distance(points[i - 1], points[i]);
  return length;
}

inline Surface grid_mesh() { return to_mesh<Surface>(flat_grid(12, 12, Diagonal_rule::ALTERNATING)); }

// From a vertex, in a direction in the plane of one of its faces: told in the face that it starts into.
inline Traced trace_from(const Surface& mesh, Vertex start, const Vector& v, double length,
                         At_vertices at = At_vertices::GO_STRAIGHT)
{
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(start))) {
    const Vector a = mesh.point(mesh.target(mesh.next(h))) - mesh.point(start),
                 b = mesh.point(mesh.source(h)) - mesh.point(start), normal = CGAL::cross_product(a, b);
    if(v * normal == 0 && CGAL::cross_product(a, v) * normal >= 0 && CGAL::cross_product(v, b) * normal > 0) {
      Face_location source = {mesh.face(h), {0, 0, 0}};
      Halfedge corner = mesh.halfedge(source.first);
      for(double& weight : source.second) {
        weight = mesh.source(corner) == start ? 1 : 0;
        corner = mesh.next(corner);
      }
      return trace(mesh, source, v, length, CGAL::parameters::at_vertices(at));
    }
  }
  throw std::logic_error("no face about the vertex has the direction");
}

// From the middle vertex of the grid.
inline Traced trace_from_middle(const Surface& mesh, const Vector& v, double length,
                                At_vertices at = At_vertices::GO_STRAIGHT)
{
  return trace_from(mesh, Vertex(grid_vertex(12, 6, 6)), v, length, at);
}

// A grid folded along each of its columns, so that these are by turns at height 0 and above: all angles are 2 pi.
inline Surface folded_grid(int n, int m, double height, Diagonal_rule rule)
{
  return to_mesh<Surface>(grid(n, m, rule, [height](int i, int) { return height * (i % 2); }));
}

} // namespace rays_test

#endif // FLIP_GEODESICS_TEST_TRACE_GEODESIC_RAYS_H
