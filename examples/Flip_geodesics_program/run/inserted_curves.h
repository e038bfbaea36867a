// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_INSERTED_CURVES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_INSERTED_CURVES_H

#include "input/curve_requests.h"
#include "program_mesh.h"
#include "run/curve_engine.h"
#include "run/mesh_result_options.h"
#include "run/progress.h"

#include <vector>

// Curves that belong to no triangulation, as they are: polylines as drawn, and meshes with any curves as edges.
namespace program {

/// The polylines of requests, completed where points in a row share no face. \throws Bad_input
std::vector<Curve_result> drawn_curves(const Mesh& mesh, const std::vector<Network_request>& requests,
                                       Progress& progress);

/// The polylines of requests, certified as they are, with an error for each that is not locally shortest.
std::vector<Curve_result> certified_curves(const Mesh& mesh, const std::vector<Network_request>& requests,
                                           Progress& progress);

/// The mesh with the curves as edges, and cut open along them, as far as these are wanted. Curves may cross.
Result_meshes meshes_along(const Mesh& mesh, const std::vector<Curve_result>& curves,
                           const Mesh_result_options& options, Progress& progress);

/// Replaces the points of curves by others at equal distances along them, of at most `distance`.
void sample_curves(const Mesh& mesh, double distance, std::vector<Curve_result>& curves);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_INSERTED_CURVES_H
