// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_INPUT_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_INPUT_H

#include "input/input_mesh.h"
#include "input/requests.h"
#include "program_options.h"
#include "run/progress.h"

#include <string>
#include <vector>

// What the files of the command line hold, for those who compute: without the readers, which are compiled by
// themselves.
namespace program {

/// The mesh, which is an oriented manifold of triangles: as it is in the file, or repaired. \throws Bad_input
Input_mesh read_input_mesh(const Options& options, Progress& progress);

/// The independent runs: one curve each, or all curves of a network. \throws Bad_input
std::vector<Network_request> read_requests(const Options& options, const Input_mesh& mesh);

/// The points of `--source`. \throws Bad_input
std::vector<Named_point> read_sources(const Options& options, const Input_mesh& mesh);

/// The straightest geodesics of `--trace`. \throws Bad_input
std::vector<Trace_request> read_traces(const Options& options, const Input_mesh& mesh);

/// Obstacles and weights, as far as there are files of them. \throws Bad_input
Path_conditions read_conditions(const Options& options, const Input_mesh& mesh);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_INPUT_H
