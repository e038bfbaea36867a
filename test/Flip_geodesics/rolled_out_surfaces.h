// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TEST_ROLLED_OUT_SURFACES_H
#define CGAL_FLIP_GEODESICS_TEST_ROLLED_OUT_SURFACES_H

#include "Double_triangulation.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// Grids of the plane, also bent without stretching, and points on them by their place in the plane.
namespace Flip_geodesics_test {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = Double_triangulation<Mesh>;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;
using Flat_point = std::array<double, 2>;

constexpr int size = 8;

// In the grid before it was bent: the cell, and its face, are found by the point.
inline Face_location location_on_grid(const Mesh& mesh, const Mesh& flat, const Flat_point& p)
{
  for(Mesh::Face_index f : flat.faces()) {
    std::array<double, 3> weights;
    auto h = flat.halfedge(f);
    double smallest = 1;
    const auto cross = [&](const Point& a, const Point& b) {
      return (a.x() - p[0]) * (b.y() - p[1]) - (a.y() - p[1]) * (b.x() - p[0]);
    };
    double sum = 0;
    for(double& weight : weights) {
      weight = cross(flat.point(flat.target(h)), flat.point(flat.target(flat.next(h))));
      smallest = (std::min)(smallest, weight);
      sum += weight;
      h = flat.next(h);
    }
    for(double& weight : weights)
      weight /= sum;
    if(smallest >= 0)
      return {Mesh::Face_index(f), weights};
  }
  BOOST_FAIL("a point is outside of the grid");
  return {mesh.null_face(), {}};
}

inline Flat_point middle(const Flat_point& p, const Flat_point& q, double t)
{
  return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
}

inline Flat_point de_casteljau(std::vector<Flat_point> p, double t)
{
  for(; p.size() > 1; p.pop_back())
    for(std::size_t i = 0; i + 1 < p.size(); ++i)
      p[i] = middle(p[i], p[i + 1], t);
  return p.front();
}

struct Bent_surface
{
  Mesh flat, bent;
};

// The plane; a part of a cylinder, by polygons; and the plane with shaken vertices.
inline std::vector<Bent_surface> surfaces()
{
  std::vector<Bent_surface> result;
  const Mesh_soup flat = flat_grid(size, size, Diagonal_rule::ALTERNATING);
  result.push_back({to_mesh<Mesh>(flat), to_mesh<Mesh>(flat)});
  const Mesh_soup bent = mapped(flat, [](const Coordinates& p) {
    const double radius = 0.5 / std::sin(0.2); // edges across stay 1 long
    return Coordinates{radius * std::cos(0.4 * p[0]), p[1], radius * std::sin(0.4 * p[0])};
  });
  result.push_back({to_mesh<Mesh>(flat), to_mesh<Mesh>(bent)});
  const Mesh_soup shaken = jittered_grid(size, size, Diagonal_rule::RANDOM, 0.2, 3);
  result.push_back({to_mesh<Mesh>(shaken), to_mesh<Mesh>(shaken)});
  return result;
}

// Where a point of the surface is in the plane that it rolls out to.
inline Flat_point rolled_out(const Mesh& flat, const CGAL::Flip_geodesics::Surface_location& at)
{
  auto h = Mesh::Halfedge_index(static_cast<unsigned>(at.halfedge.idx()));
  Flat_point sum = {0, 0};
  const double weights = at.weights[0] + at.weights[1] + at.weights[2];
  for(double weight : at.weights) {
    sum[0] += weight / weights * flat.point(flat.source(h)).x();
    sum[1] += weight / weights * flat.point(flat.source(h)).y();
    h = flat.next(h);
  }
  return sum;
}

// A vertex of a triangulation.
template <class T>
Flat_point rolled_out(const Mesh& flat, const T& t, CGAL::Flip_geodesics::Vertex_index v)
{
  return rolled_out(flat, t.location(v));
}

inline double distance(const Flat_point& p, const Flat_point& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

inline std::vector<CGAL::Flip_geodesics::Surface_location> locations(const Triangulation& t,
                                                                     const Bent_surface& surface,
                                                                     const std::vector<Flat_point>& points)
{
  std::vector<CGAL::Flip_geodesics::Surface_location> result;
  for(const Flat_point& p : points)
    result.push_back(
        CGAL::Flip_geodesics::surface_location(t, surface.bent, location_on_grid(surface.bent, surface.flat, p)));
  return result;
}

inline const std::vector<std::vector<Flat_point>> polygons = {
    {{0.3, 0.4}, {7.6, 6.1}},
    {{0.3, 0.4}, {4.1, 7.2}, {7.6, 0.9}},
    {{1, 1}, {1.5, 6.3}, {6.2, 6.9}, {7.1, 1.3}}, // starts at a vertex
    {{0.7, 3.1}, {2.2, 6.4}, {4, 1.5}, {5.3, 7}, {7.4, 4.2}},
    {{0.5, 2}, {1.4, 5.1}, {2.6, 7.3}, {5.2, 6.6}, {6.9, 4.7}, {6.3, 1.2}, {4.2, 0.6}}};

} // namespace Flip_geodesics_test

#endif // CGAL_FLIP_GEODESICS_TEST_ROLLED_OUT_SURFACES_H
