// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MESH_RESULT_OPTIONS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MESH_RESULT_OPTIONS_H

#include <optional>
#include <string>

namespace program {

/// What becomes of the triangulation once its curves are finished.
struct Mesh_result_options
{
  bool is_delaunay = false;
  std::optional<double> refine; ///< the smallest angle, in degrees
  std::optional<double> longest_edge;
  std::optional<long long> most_vertices; ///< that are inserted
  std::string subdivision, insertion, cut;

  bool is_any_wanted() const { return is_delaunay || refine || has_files(); }
  bool has_files() const { return !subdivision.empty() || !insertion.empty() || !cut.empty(); }
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MESH_RESULT_OPTIONS_H
