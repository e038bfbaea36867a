// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLES_H

#include "program_mesh.h"

#include <set>

namespace program {

/// What no path may cross.
struct Obstacles
{
  std::set<Mesh::Face_index> faces;
  std::set<Mesh::Edge_index> walls; ///< edges along which paths may run

  bool are_none() const { return faces.empty() && walls.empty(); }
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_OBSTACLES_H
