// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OPTIONS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OPTIONS_H

#include <optional>
#include <string>
#include <vector>

// The options of the command line.
namespace program {

/// What becomes of the triangulation once its curves are finished.
struct Mesh_result_options
{
  bool is_delaunay = false;
  std::optional<double> refine; ///< the smallest angle, in degrees
  std::optional<double> longest_edge;
  std::optional<long long> insertion_limit; ///< on vertices that are inserted in the triangulation
  std::optional<long long> vertex_limit;    ///< on those of the common subdivision, or of a flattened mesh
  std::string subdivision, insertion, cut;

  bool is_any_wanted() const { return is_delaunay || refine || has_files(); }
  bool has_files() const { return !subdivision.empty() || !insertion.empty() || !cut.empty(); }
};

/// The names of the other files that are written; empty for those that are not wanted.
struct Result_names
{
  std::string polylines, stats, page, live, map, matrix, json;
  bool has_values = false;          ///< are distances of vertices written to the outputs?
  std::vector<std::string> outputs; ///< meshes: the surface with its curves, or what repair and flatten make of it
  std::optional<double> tubes;      ///< the radius of curves for a viewer; 0 for lines
};

struct Options
{
  std::string command;
  std::string mesh, format;  ///< the format is empty if the name of the mesh determines it
  std::string output_format; ///< of a mesh that goes to standard output
  bool is_repaired = false;
  double weld = 0; ///< the tolerance of the repair
  std::string from, to, pairs, edges, loop, network, segmentation, points, bezier, draw;
  bool is_snapped = false, has_seams = false, has_free_junctions = false, is_shortest = false, has_voronoi = false,
       are_handles = false, is_cut_graph = false;
  int rounds = 5;
  std::optional<long long> landmarks, ways, random;
  std::vector<std::string> sources;
  std::string sources_file;
  std::optional<double> sample;                      ///< the distance between points of curves
  std::string obstacles, face_weights, edge_weights; ///< their files
  std::vector<std::string> traces;                   ///< each a point and two numbers
  std::vector<double> isolines;
  double spacing = 0, tolerance = 0; ///< zero for none and for the default
  long long seed = 1;
  std::string kernel = "certified", search = "lookback";
  std::optional<double> stop_length, stop_curve_length, mollify, memory_limit;
  bool are_zero_edges_refused = false;
  int threads = 1;
  Result_names results;
  Mesh_result_options meshes;
  bool is_replacing_input = false, is_quiet = false;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_OPTIONS_H
