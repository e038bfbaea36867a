// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A field with its surface, and what holds for each isoline and each boundary.

#ifndef FLIP_GEODESICS_TEST_ISOLINES_CLOSED_FIELD_H
#define FLIP_GEODESICS_TEST_ISOLINES_CLOSED_FIELD_H

#include "Mesh_archetype.h"
#include "closed_forms.h"
#include "generated_meshes.h"
#include "invalid_meshes.h"

#include <CGAL/Flip_geodesics/isolines.h>

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

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;

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

inline Distance from_point(double x, double y)
{
  return [=](const Coordinates& p) { return std::hypot(p[0] - x, p[1] - y); };
}

inline std::vector<Distance> from_points(const std::vector<std::array<double, 2>>& sources)
{
  std::vector<Distance> result;
  for(const auto& s : sources)
    result.push_back(from_point(s[0], s[1]));
  return result;
}

inline Coordinates coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
inline double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

inline double length(const Polyline& polyline)
{
  double sum = 0;
  for(std::size_t i = 0; i + 1 < polyline.points.size(); ++i)
    sum += distance(polyline.points[i], polyline.points[i + 1]);
  return sum;
}

// The faces that have a location, by its weights of zero.
inline std::set<Mesh::Face_index> faces_of(const Mesh& mesh, const Location& location)
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

inline bool is_on_border(const Mesh& mesh, const Location& location)
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
inline void check_polyline(const Mesh& mesh, const Polyline& polyline)
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
inline void check_isoline(const Mesh& mesh, const Closed_field& field, const Isoline& isoline, double tolerance)
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

inline std::vector<Isoline> checked_isolines(const Mesh& mesh, const Closed_field& field,
                                             const std::vector<double>& levels, double tolerance)
{
  const std::vector<Isoline> result = isolines(mesh, field, levels, tolerance);
  for(const Isoline& isoline : result)
    check_isoline(mesh, field, isoline, tolerance);
  return result;
}

inline double total_length(const std::vector<Isoline>& curves, double level)
{
  double sum = 0;
  for(const Isoline& isoline : curves)
    sum += isoline.level == level ? length(isoline) : 0;
  return sum;
}

inline bool do_cross(const Point& p, const Point& q, const Point& r, const Point& s)
{
  const auto side = [](const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  return side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0;
}

inline bool do_cross(const Polyline& a, const Polyline& b)
{
  for(std::size_t i = 0; i + 1 < a.points.size(); ++i)
    for(std::size_t j = 0; j + 1 < b.points.size(); ++j)
      if(do_cross(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1]))
        return true;
  return false;
}

inline bool does_cross_itself(const Polyline& a)
{
  for(std::size_t i = 0; i + 1 < a.points.size(); ++i)
    for(std::size_t j = i + 2; j + 1 < a.points.size(); ++j)
      if(do_cross(a.points[i], a.points[i + 1], a.points[j], a.points[j + 1]))
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
inline Diagram check_diagram(const Mesh& mesh, const Closed_field& field, const std::vector<Boundary>& diagram,
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

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_ISOLINES_CLOSED_FIELD_H
