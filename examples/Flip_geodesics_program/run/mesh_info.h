// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MESH_INFO_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MESH_INFO_H

#include "program_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace program {

/// The numbers of elements of a component.
struct Component_info
{
  std::size_t vertices = 0, edges = 0, faces = 0, borders = 0;

  std::size_t genus() const { return (2 + edges - vertices - faces - borders) / 2; }
};

struct Mesh_info
{
  std::vector<Component_info> components;
  std::size_t isolated_vertices = 0, degenerate_edges = 0, degenerate_faces = 0;
  double area = 0, shortest_edge = 0, longest_edge = 0;
  std::vector<std::string> defects; ///< lines about the file and what a repair does
};

Mesh_info mesh_info(const Mesh& mesh, const std::vector<std::string>& defects);

/// Lines for people.
std::string describe(const Mesh_info& info, const Mesh& mesh);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESH_INFO_H
