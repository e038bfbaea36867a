// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_DRAWN_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_DRAWN_INPUT_H

#include "input/point_input.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/version.h>

#include <boost/algorithm/string/predicate.hpp>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Files of polylines that are drawn on the mesh: lines of points as for --points, after `o` closed; or, in a file
// `.polylines.txt`, lines of points in space, which are moved to the nearest point of the mesh.
namespace program {

/// Finds the nearest points of a mesh, among the faces that have an area: they have all edges, but where only faces
/// without area meet. Coordinates of less than 1e-12 of a face's point count as zero.
class Surface_projector
{
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= 1060000000
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
  using Tree = CGAL::AABB_tree<Traits>;

public:
  /// \throws Bad_input if no face has an area
  explicit Surface_projector(const Mesh& mesh)
    : m_mesh(mesh)
  {
    std::vector<Mesh::Face_index> faces;
    std::copy_if(mesh.faces().begin(), mesh.faces().end(), std::back_inserter(faces),
                 [&](Mesh::Face_index f) { return has_area(f); });
    if(faces.empty())
      throw Bad_input("no face of the mesh has an area, so that points cannot be moved to it; correct the mesh");
    m_tree.insert(faces.begin(), faces.end(), mesh);
    m_tree.build();
  }

  CGAL::Flip_geodesics::Surface_location operator()(const Point_3& p) const
  {
    const auto location = CGAL::Polygon_mesh_processing::locate_with_AABB_tree(p, m_tree, m_mesh);
    CGAL::Flip_geodesics::Surface_location result;
    result.halfedge = index_of(m_mesh.halfedge(location.first));
    for(std::size_t i = 0; i < 3; ++i)
      result.weights[i] = location.second[i] < 1e-12 ? 0 : location.second[i];
    return result;
  }

private:
  // Does what CGAL divides by for barycentric coordinates have an inverse?
  bool has_area(Mesh::Face_index f) const
  {
    const Mesh::Halfedge_index h = m_mesh.halfedge(f);
    const Point_3 &p = m_mesh.point(m_mesh.source(h)), &q = m_mesh.point(m_mesh.target(h));
    const Kernel::Vector_3 u = q - p, v = m_mesh.point(m_mesh.target(m_mesh.next(h))) - p;
    const double square = (u * u) * (v * v) - (u * v) * (u * v);
    return square != 0 && std::isfinite(1 / square);
  }

  const Mesh& m_mesh;
  Tree m_tree;
};

// CGAL's projection takes coordinates to the fifth power, and cannot do with infinity.
constexpr double largest_coordinate_to_project = 1e60;

inline void check_coordinates_to_project(const Mesh& mesh, const Input_text& input)
{
  for(const auto v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
      if(std::abs(mesh.point(v)[i]) > largest_coordinate_to_project)
        throw Bad_input(input.name() + ": vertex " + std::to_string(v) +
                        " of the mesh has a coordinate beyond 1e60, so that points cannot be moved to it; scale both");
}

/// A line of a file `.polylines.txt`: the number of points, and their coordinates. It is closed if the first point is
/// repeated at the end.
inline Curve_request read_polyline_in_space(Text_scanner& words, const Surface_projector& project)
{
  Curve_request curve;
  long long count = 0;
  if(parse_number(words.next_word(), count) != nullptr || count < 0)
    words.fail("a polyline starts with its number of points; correct the line");
  std::vector<Point_3> points;
  while(static_cast<long long>(points.size()) < count) {
    const Element element = {"point", points.size()};
    std::array<double, 3> x;
    for(double& coordinate : x) {
      coordinate = words.number<double>(words.next_word(), element);
      if(std::abs(coordinate) > largest_coordinate_to_project)
        words.fail(element, "has a coordinate beyond 1e60, so that it cannot be moved to the mesh; scale both");
    }
    points.emplace_back(x[0], x[1], x[2]);
  }
  if(words.has_word())
    words.fail("there is more after the last of the points; a polyline is their number and three coordinates for each");
  curve.is_closed = count > 3 && points.front() == points.back();
  if(curve.is_closed)
    points.pop_back();
  for(const Point_3& p : points)
    curve.points.push_back(project(p));
  return curve;
}

inline Curve_request read_polyline_on_mesh(const Input_mesh& mesh, Text_scanner& words, const std::string& name)
{
  Curve_request curve;
  curve.is_closed = words.take('o');
  for(std::string_view word; !(word = words.next_word()).empty();)
    curve.points.push_back(read_point(mesh, word, name));
  return curve;
}

inline std::vector<Curve_request> read_drawn_curves(const Input_mesh& mesh, const Input_text& input)
{
  const std::string ending = ".polylines.txt";
  std::optional<Surface_projector> project;
  if(boost::algorithm::ends_with(input.file(), ending) && input.file() != ending) {
    check_coordinates_to_project(mesh, input);
    project.emplace(mesh);
  }
  std::vector<Curve_request> curves;
  for_each_line(input, [&](Text_scanner& words) {
    const std::string name = words.place();
    curves.push_back(project ? read_polyline_in_space(words, *project) : read_polyline_on_mesh(mesh, words, name));
    curves.back().name = name;
    curves.back().is_drawn = true;
    if(curves.back().points.size() < (curves.back().is_closed ? 3u : 2u))
      words.fail("a polyline needs two points, a closed one three; add points or remove the line");
  });
  check_not_empty(curves, input);
  return curves;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_DRAWN_INPUT_H
