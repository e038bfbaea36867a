// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What holds for curves in each form that they come in.

#ifndef FLIP_GEODESICS_TEST_ONE_CALL_CHECKED_CURVES_H
#define FLIP_GEODESICS_TEST_ONE_CALL_CHECKED_CURVES_H

#include "Curve_setting.h"
#include "Mesh_archetype.h"
#include "Policy_archetypes.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Face = Surface::Face_index;
using Point = Surface::Point;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Face_location = std::pair<Face, std::array<double, 3>>;
using Curve_point = FG::Curve_point<Surface, Point>;

inline Surface bumpy_sphere_mesh() { return to_mesh<Surface>(bumpy_sphere(6, 0.3, 7)); }
inline Surface torus_mesh() { return to_mesh<Surface>(torus(24, 14, 2, 1)); }

inline std::vector<std::pair<Vertex, Vertex>> random_pairs(const Surface& mesh, int count)
{
  std::mt19937 random(5);
  std::vector<std::pair<Vertex, Vertex>> result;
  while(result.size() < static_cast<std::size_t>(count)) {
    const Vertex v(random() % mesh.number_of_vertices()), w(random() % mesh.number_of_vertices());
    if(v != w)
      result.emplace_back(v, w);
  }
  return result;
}

inline double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }
inline double distance(const Vector& u, const Vector& v) { return std::sqrt((u - v).squared_length()); }

// The point of a face location, from the convention of Polygon Mesh Processing.
inline Point point_at(const Surface& mesh, const Face_location& location)
{
  const Halfedge h = mesh.halfedge(location.first);
  const std::array<Vertex, 3> corners = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
  Vector result(0, 0, 0);
  for(std::size_t i = 0; i < 3; ++i)
    result = result + location.second[i] * (mesh.point(corners[i]) - CGAL::ORIGIN);
  return CGAL::ORIGIN + result;
}

// Is a location's point one of a face, whichever face it is given in?
inline bool is_on_face(const Surface& mesh, const Face_location& location, Face f)
{
  const auto corners = mesh.vertices_around_face(mesh.halfedge(f));
  Halfedge h = mesh.halfedge(location.first);
  for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
    if(location.second[i] != 0 && std::find(corners.begin(), corners.end(), mesh.source(h)) == corners.end())
      return false;
  return true;
}

// Places, halfedges and tangents of a curve belong to its points.
inline void check_curve_points(const Surface& mesh, const std::vector<Curve_point>& curve)
{
  BOOST_REQUIRE_GE(curve.size(), 2u);
  for(std::size_t i = 0; i < curve.size(); ++i) {
    const Curve_point& p = curve[i];
    BOOST_CHECK_SMALL(distance(point_at(mesh, p.location), p.point), 1e-12);
    BOOST_CHECK_CLOSE(p.tangent.squared_length(), 1., 1e-9);
    const Curve_point& from = curve[i + 1 < curve.size() ? i : i - 1];
    const Point& to = curve[i + 1 < curve.size() ? i + 1 : i].point;
    if(distance(from.point, to) > 1e-6)
      BOOST_CHECK_SMALL(distance((to - from.point) / distance(from.point, to), p.tangent), 1e-8);
    if(i > 0 && i + 1 < curve.size() && p.halfedge != Surface::null_halfedge()) { // it leaves the halfedge's face
      BOOST_CHECK(is_on_face(mesh, curve[i - 1].location, mesh.face(p.halfedge)));
      BOOST_CHECK(is_on_face(mesh, curve[i + 1].location, mesh.face(mesh.opposite(p.halfedge))));
      const double side = distance(mesh.point(mesh.source(p.halfedge)), mesh.point(mesh.target(p.halfedge)));
      BOOST_CHECK_SMALL(distance(mesh.point(mesh.source(p.halfedge)), p.point) +
                            distance(p.point, mesh.point(mesh.target(p.halfedge))) - side,
                        1e-12);
    }
  }
}

inline void check_same_points(const std::vector<Point>& points, const std::vector<Curve_point>& curve)
{
  BOOST_REQUIRE_EQUAL(points.size(), curve.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    BOOST_CHECK_EQUAL(points[i], curve[i].point);
}

inline void check_same_places(const std::vector<Face_location>& places, const std::vector<Curve_point>& curve)
{
  BOOST_REQUIRE_EQUAL(places.size(), curve.size());
  for(std::size_t i = 0; i < places.size(); ++i)
    BOOST_CHECK(places[i] == curve[i].location);
}

// Counts what it sees. It can be copied, so that a count stays zero unless it is passed by reference.
struct Counting_visitor : FG::Default_shortening_visitor
{
  std::size_t flips = 0;
  std::size_t* shared = nullptr;

  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index)
  {
    ++flips;
    if(shared)
      ++*shared;
  }
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_ONE_CALL_CHECKED_CURVES_H
