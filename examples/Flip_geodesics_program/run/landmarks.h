// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_LANDMARKS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_LANDMARKS_H

#include "program_mesh.h"
#include "run/program_metric.h"
#include "run/progress.h"

#include <CGAL/Flip_geodesics/shortest_path.h>

#include <cstddef>
#include <string>

namespace program {

/// What makes many shortest paths faster, and a line about it for people.
struct Landmarks
{
  CGAL::Flip_geodesics::Geodesic_landmarks bounds;
  std::string remark;
};

/// Makes those that are wanted, by as many threads as curves are computed by. \throws Bad_input
/// \tparam Metric `Program_metric` or `Weighted_program_metric`
template <class Metric>
Landmarks make_landmarks(std::size_t number, int threads, const Mesh& mesh, const Metric& metric, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_LANDMARKS_H
