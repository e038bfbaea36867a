// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_FIELD_CURVES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_FIELD_CURVES_H

#include "program_mesh.h"
#include "run/curve_engine.h"
#include "run/progress.h"

#include <vector>

namespace program {

/// What is wanted of the distances from some vertices.
struct Field_request
{
  std::vector<Vertex_index> sources;
  std::vector<double> levels; ///< of isolines
  bool is_diagram = false;    ///< are the boundaries of the Voronoi diagram wanted, too?
  double tolerance = 0;       ///< zero for a thousandth of the diagonal of the mesh's box
};

/// The isolines, in the order of the levels, and then the boundaries.
std::vector<Curve_result> field_curves(const Mesh& mesh, const Field_request& request, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_FIELD_CURVES_H
