// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OPTIONS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OPTIONS_H

#include <optional>
#include <string>
#include <vector>

// What the command line says.
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
  /// Is a triangulation wanted that has the curves as edges?
  bool is_triangulation_wanted() const { return is_delaunay || refine || !subdivision.empty(); }
  bool has_files() const { return !subdivision.empty() || !insertion.empty() || !cut.empty(); }
};

/// The names of the other files that are written; empty for those that are not wanted.
struct Result_names
{
  std::string polylines, stats, viewer, page, live, map, repaired;
  std::optional<double> tubes; ///< the radius of curves for a viewer; 0 for lines
};

struct Options
{
  std::string mesh, format;  ///< the format empty if the name of the mesh tells it
  std::string output_format; ///< of a mesh that goes to standard output
  bool is_repaired = false;
  std::optional<double> weld; ///< the tolerance of the repair
  std::optional<long long> from, to;
  std::string pairs, edges, loop, network, segmentation, points, bezier, draw;
  bool is_snapped = false, is_as_drawn = false;
  std::optional<int> rounds;
  bool has_seams = false, has_free_junctions = false, is_shortest = false;
  std::optional<long long> landmarks;
  std::vector<long long> sources;
  std::optional<long long> ways;   ///< how many between the ends of each pair
  std::string obstacles;           ///< their file
  std::vector<std::string> traces; ///< each three numbers
  std::vector<double> isolines;
  std::optional<double> spacing;
  bool has_voronoi = false;
  std::optional<double> tolerance;
  std::optional<long long> random;
  long long seed = 1;
  std::optional<std::string> kernel; ///< "certified" if it is not given
  std::string search = "lookback";
  std::optional<double> stop_length, mollify, most_memory;
  bool are_zero_edges_refused = false;
  int threads = 1;
  Result_names results;
  Mesh_result_options meshes;
  bool is_replacing_input = false, is_quiet = false;

  /// Are the ends of curves given by pairs of vertices?
  bool has_pairs() const { return from || to || random || !pairs.empty(); }

  /// Are curves wanted that follow from distances, and no tree?
  bool is_field_wanted() const { return !isolines.empty() || spacing || has_voronoi; }
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OPTIONS_H
