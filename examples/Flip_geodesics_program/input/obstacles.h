// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLES_H

#include "program_mesh.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace program {

/// What no path may cross.
struct Obstacles
{
  std::set<Mesh::Face_index> faces;
  std::set<Mesh::Edge_index> walls; ///< edges along which paths may run

  bool are_none() const { return faces.empty() && walls.empty(); }
};

/// The factors of lengths, given for all faces or for all edges.
struct Weights
{
  std::string name; ///< of the file, for messages
  std::vector<double> of_faces, of_edges;
};

/// What changes the lengths of paths.
struct Path_conditions
{
  Obstacles obstacles;
  std::optional<Weights> weights;
  std::optional<double> mollify; ///< the margin of the triangle inequality, relative to the mean length of edges
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLES_H
