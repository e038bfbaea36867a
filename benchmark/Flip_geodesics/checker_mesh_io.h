// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_MESH_IO_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_MESH_IO_H

#include "checker_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace polyline_checker {

/// The vertices and faces of an OBJ file, whatever else is in it; `v/t/n` and indices from the end are understood.
inline Mesh read_obj(const std::string& file)
{
  std::ifstream in(file);
  std::vector<Mesh::Point> points;
  std::vector<Mesh::Face> faces;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if(keyword == "v") {
      points.emplace_back();
      words >> points.back()[0] >> points.back()[1] >> points.back()[2];
    } else if(keyword == "f") {
      std::vector<Index> corners;
      for(std::string corner; words >> corner;) {
        const long long i = std::stoll(corner);
        corners.push_back(static_cast<Index>(i < 0 ? static_cast<long long>(points.size()) + i : i - 1));
      }
      if(corners.size() != 3)
        throw Bad_input("face " + std::to_string(faces.size()) + " is not a triangle");
      faces.push_back({corners[0], corners[1], corners[2]});
    }
  }
  if(faces.empty())
    throw Bad_input("it cannot be read, or has no faces");
  return Mesh(std::move(points), faces);
}

inline Mesh read_mesh(const std::string& file)
{
  if(file.size() > 4 && file.compare(file.size() - 4, 4, ".obj") == 0)
    return read_obj(file);
  using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Surface_mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0)
    throw Bad_input("it cannot be read as an oriented manifold mesh, or has no faces");
  std::vector<Mesh::Point> points;
  for(const auto v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  std::vector<Mesh::Face> faces;
  for(const auto f : mesh.faces()) {
    if(mesh.degree(f) != 3)
      throw Bad_input("face " + std::to_string(std::size_t(f)) + " is not a triangle");
    const auto h = mesh.halfedge(f);
    faces.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  return Mesh(std::move(points), faces);
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_MESH_IO_H
