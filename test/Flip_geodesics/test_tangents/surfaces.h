// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TEST_TANGENTS_SURFACES_H
#define CGAL_FLIP_GEODESICS_TEST_TANGENTS_SURFACES_H

#include "closed_forms.h"
#include "generated_meshes.h"
#include "mesh_soup.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <stdexcept>

// Surfaces, places on them, and what is known of these without the package.
namespace tangents_test {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = FG::Intrinsic_triangulation<Mesh>;

inline Point point(const Triangulation& t, FG::Input_halfedge_index h)
{
  return t.metric().point(t.input(), t.input().tail(h));
}

inline Point in_space(const Triangulation& t, const FG::Surface_location& at)
{
  const auto& w = at.weights;
  const Point p = point(t, at.halfedge), q = point(t, t.input().next(at.halfedge)),
              r = point(t, t.input().next(t.input().next(at.halfedge)));
  const double sum = w[0] + w[1] + w[2];
  return CGAL::ORIGIN + (w[0] * (p - CGAL::ORIGIN) + w[1] * (q - CGAL::ORIGIN) + w[2] * (r - CGAL::ORIGIN)) / sum;
}

inline double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

inline std::complex<double> in_plane(const Triangulation& t, const FG::Surface_location& at)
{
  const Point p = in_space(t, at);
  return {p.x(), p.y()};
}

// The direction of a halfedge of a mesh in the plane.
inline std::complex<double> direction_in_plane(const Triangulation& t, FG::Input_halfedge_index h)
{
  const Point p = point(t, h), q = point(t, FG::internal::twin_index(h));
  const std::complex<double> way(q.x() - p.x(), q.y() - p.y());
  return way / std::abs(way);
}

inline double arg_in_plane(const Triangulation& t, const FG::Surface_location& at)
{
  return std::arg(direction_in_plane(t, at.halfedge));
}

// The place of a point of a plane mesh.
inline FG::Surface_location location_of(const Triangulation& t, const std::complex<double>& p)
{
  for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(t.input().number_of_halfedges()))
    if(!t.input().is_border(h)) {
      const auto corner = [&](FG::Input_halfedge_index g) {
        return std::complex<double>(point(t, g).x(), point(t, g).y()) - p;
      };
      const auto cross = [](const std::complex<double>& a, const std::complex<double>& b) {
        return a.real() * b.imag() - a.imag() * b.real();
      };
      const auto a = corner(h), b = corner(t.input().next(h)), c = corner(t.input().next(t.input().next(h)));
      const std::array<double, 3> weights = {cross(b, c), cross(c, a), cross(a, b)};
      if(*std::min_element(weights.begin(), weights.end()) >= 0)
        return {h, weights};
    }
  throw std::logic_error("a point is outside of the mesh");
}

// A vertex, a point of an edge, or one of a face.
inline FG::Surface_location random_location(const Triangulation& t, int kind, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(0.05, 1);
  FG::Input_halfedge_index h;
  do
    h = FG::Input_halfedge_index(static_cast<FG::Index>(random() % t.input().number_of_halfedges()));
  while(t.input().is_border(h));
  return {h, {{number(random), kind > 0 ? number(random) : 0, kind > 1 ? number(random) : 0}}};
}

inline bool is_on_border(const Triangulation& t, const FG::Surface_location& at)
{
  FG::Input_halfedge_index h = at.halfedge;
  if(at.weights[1] != 0)
    return at.weights[2] == 0 && t.input().is_border(FG::internal::twin_index(h));
  do {
    if(t.input().is_border(h))
      return true;
    h = t.input().next(FG::internal::twin_index(h));
  } while(h != at.halfedge);
  return false;
}

inline double corner_angle(const Triangulation& t, FG::Input_halfedge_index h)
{
  const Vector a = point(t, t.input().next(h)) - point(t, h),
               b = point(t, t.input().next(t.input().next(h))) - point(t, h);
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

// The sum of the angles about a vertex.
inline double angle_sum(const Triangulation& t, FG::Vertex_index v)
{
  double sum = 0;
  const FG::Input_halfedge_index first = t.input().outgoing(v);
  FG::Input_halfedge_index h = first;
  do {
    sum += t.input().is_border(h) ? 0 : corner_angle(t, h);
    h = t.input().next(FG::internal::twin_index(h));
  } while(h != first);
  return sum;
}

// By which angle the direction in which a path arrives is turned to go straight back. At a vertex of the border there
// are no whole turns, and a path arrives by half a turn counterclockwise from where it comes from.
inline double turn_back(const Triangulation& t, const FG::Surface_location& at)
{
  if(at.weights[1] != 0 || at.weights[2] != 0)
    return pi;
  return is_on_border(t, at) ? -pi : angle_sum(t, t.input().tail(at.halfedge)) / 2;
}

} // namespace tangents_test

#endif // CGAL_FLIP_GEODESICS_TEST_TANGENTS_SURFACES_H
