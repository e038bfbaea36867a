// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_TRACED_CURVES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_TRACED_CURVES_H

#include "input/curve_requests.h"
#include "input/obstacles.h"
#include "program_mesh.h"
#include "run/curve_engine.h"
#include "run/progress.h"

#include <vector>

namespace program {

/// Traces them, in the order of the requests. Their statuses are the names of `Trace_status`. \throws Bad_input
std::vector<Curve_result> traced_curves(const Mesh& mesh, const std::vector<Trace_request>& requests,
                                        const Path_conditions& conditions, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_TRACED_CURVES_H
