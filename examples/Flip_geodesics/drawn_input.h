// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_DRAWN_INPUT_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_DRAWN_INPUT_H

#include "point_input.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Files of polylines that are drawn on the mesh: lines of points as for --points, after `o` closed; or, in a file
// `.polylines.txt`, lines of points in space, which are moved to the nearest point of the mesh.
namespace program {

/// Finds the nearest points of a mesh. Coordinates of less than 1e-12 of a face's point count as zero.
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
  explicit Surface_projector(const Mesh& mesh)
    : m_mesh(mesh)
  {
    CGAL::Polygon_mesh_processing::build_AABB_tree(mesh, m_tree);
  }

  CGAL::Flip_geodesics::Surface_location operator()(const Point_3& p) const
  {
    const auto location = CGAL::Polygon_mesh_processing::locate_with_AABB_tree(p, m_tree, m_mesh);
    CGAL::Flip_geodesics::Surface_location result;
    result.halfedge = static_cast<Index>(m_mesh.halfedge(location.first));
    for(std::size_t i = 0; i < 3; ++i)
      result.weights[i] = location.second[i] < 1e-12 ? 0 : location.second[i];
    return result;
  }

private:
  const Mesh& m_mesh;
  Tree m_tree;
};

/// A line of a file `.polylines.txt`: the number of points, and their coordinates. It is closed if the first point is
/// repeated at the end.
inline Curve_request read_polyline_in_space(std::istringstream& words, const std::string& name,
                                            const Surface_projector& project)
{
  Curve_request curve;
  std::size_t count = 0;
  words >> count;
  std::vector<Point_3> points;
  for(double x, y, z; points.size() < count && words >> x >> y >> z;)
    points.emplace_back(x, y, z);
  if(points.size() != count || !(words >> std::ws).eof())
    throw Bad_input(name + ": a polyline is its number of points and three coordinates for each; correct the line");
  curve.is_closed = count > 3 && points.front() == points.back();
  if(curve.is_closed)
    points.pop_back();
  for(const Point_3& p : points) {
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Bad_input(name + ": a coordinate is not finite; correct it");
    curve.points.push_back(project(p));
  }
  return curve;
}

inline Curve_request read_polyline_on_mesh(const Mesh& mesh, std::istringstream& words, const std::string& name)
{
  Curve_request curve;
  curve.is_closed = words.peek() == 'o';
  if(curve.is_closed)
    words.get();
  for(std::string word; words >> word;)
    curve.points.push_back(read_point(mesh, word, name));
  return curve;
}

inline std::vector<Curve_request> read_drawn_curves(const Mesh& mesh, const std::string& file)
{
  const std::string ending = ".polylines.txt";
  std::optional<Surface_projector> project;
  if(file.size() > ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0)
    project.emplace(mesh);
  std::vector<Curve_request> curves;
  for_each_line(file, [&](std::istringstream& words, const std::string& name) {
    curves.push_back(project ? read_polyline_in_space(words, name, *project)
                             : read_polyline_on_mesh(mesh, words, name));
    curves.back().name = name;
    curves.back().is_drawn = true;
    if(curves.back().points.size() < (curves.back().is_closed ? 3u : 2u))
      throw Bad_input(name + ": a polyline needs two points, a closed one three; add points or remove the line");
  });
  check_not_empty(curves, file);
  return curves;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_DRAWN_INPUT_H
