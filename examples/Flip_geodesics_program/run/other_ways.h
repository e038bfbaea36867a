// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_OTHER_WAYS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_OTHER_WAYS_H

#include "input/curve_requests.h"
#include "input/obstacles.h"
#include "program_mesh.h"
#include "run/curve_engine.h"
#include "run/progress.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace program {

/// Shortest paths that are wanted, between the ends of each pair those of so many homotopy classes.
struct Ways_request
{
  std::vector<Curve_request> pairs;
  std::size_t number;
  Obstacles obstacles;
  std::optional<double> most_memory; ///< for the part of the universal cover that is searched, in bytes
};

/// The paths, those of a pair by length, and what is known of others, for people.
struct Ways
{
  std::vector<Curve_result> curves;
  std::string others;
};

/// Finds them. The statuses are the names of `Verdict`. \throws Bad_input
Ways other_ways(const Mesh& mesh, const Ways_request& request, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_OTHER_WAYS_H
