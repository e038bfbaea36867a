// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_FIELD_CURVES_H
#define CGAL_FLIP_GEODESICS_PROGRAM_FIELD_CURVES_H

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

/// What is wanted of the distances from some points.
struct Field_request
{
  std::vector<Named_point> sources;
  std::vector<double> levels; ///< of isolines
  double spacing = 0;         ///< isolines at all multiples of this as well, as far as the vertices; none if it is zero
  bool is_diagram = false;    ///< are the boundaries of the Voronoi diagram wanted, too?
  bool is_map = false;        ///< are the distances of all vertices wanted?
  bool is_matrix = false;     ///< are the distances between the sources wanted?
  double tolerance = 0;       ///< zero for a thousandth of the diagonal of the mesh's box
  Path_conditions conditions; ///< which distances depend on
};

/// The distances of the vertices, infinite for those without a path, and the numbers of their nearest sources.
struct Distance_map
{
  std::vector<double> distances;
  std::vector<std::size_t> nearest;
};

struct Field_curves
{
  std::optional<Distance_map> map;
  std::vector<std::vector<double>> matrix; ///< the rows
  std::vector<Curve_result> curves;        ///< the isolines, in the order of the levels, and then the boundaries
  std::string remarks; ///< lines for people about levels without isolines and sources without boundaries
};

/// \throws Bad_input if the tolerance or the spacing is so small that the results would not fit anywhere, or a source
/// lies in an obstacle
Field_curves field_curves(const Mesh& mesh, const Field_request& request, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_FIELD_CURVES_H
