// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_FLATTENED_MESH_H
#define CGAL_FLIP_GEODESICS_PROGRAM_FLATTENED_MESH_H

#include "input/curve_requests.h"
#include "program_mesh.h"
#include "run/progress.h"

#include <string>

namespace program {

struct Flattened_mesh
{
  Mesh mesh;          ///< with the positions of corners in the plane, see `texture_of()`
  std::string report; ///< a line for people
  std::string defect; ///< why the texture is not injective; empty if it is, up to rounding errors
};

/// Cuts a surface along shortened curves and flattens it conformally. \throws Bad_input
Flattened_mesh flattened_mesh(const Mesh& mesh, const std::string& name, const Network_request& cut,
                              Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_FLATTENED_MESH_H
