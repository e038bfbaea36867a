// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_LOOPS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_LOOPS_H

#include "input/curve_requests.h"
#include "program_mesh.h"
#include "run/progress.h"

#include <vector>

namespace program {

/// Returns loops along edges, one per request, that generate the homology of the surface: those of a basis, or the
/// handle loops and then the tunnel loops of the solid that it bounds. \throws Bad_input
std::vector<Network_request> surface_loops(const Mesh& mesh, bool are_handles_and_tunnels, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SURFACE_LOOPS_H
