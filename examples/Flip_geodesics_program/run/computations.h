// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_COMPUTATIONS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_COMPUTATIONS_H

#include "input/requests.h"
#include "program_mesh.h"
#include "program_options.h"
#include "run/curve_engine.h"
#include "run/progress.h"

#include <CGAL/Flip_geodesics/shortest_path.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// What the program computes beside the curves of a `Curve_engine`, for those who ask for it: without the algorithms,
// which are compiled by themselves.
namespace program {

/// The numbers of elements of a component.
struct Component_info
{
  std::size_t vertices = 0, edges = 0, faces = 0, borders = 0;

  std::size_t genus() const { return (2 + edges - vertices - faces - borders) / 2; }
};

struct Mesh_info
{
  bool is_repaired = false; ///< is it the mesh after a repair, and not as it is in the file?
  std::vector<Component_info> components;
  std::size_t isolated_vertices = 0, degenerate_edges = 0, degenerate_faces = 0;
  double area = 0, shortest_edge = 0, longest_edge = 0;
  std::vector<std::string> defects; ///< lines about the file and what a repair does
};

Mesh_info mesh_info(const Mesh& mesh, bool is_repaired, const std::vector<std::string>& defects);

/// Lines for people.
std::string describe(const Mesh_info& info, const Mesh& mesh);

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

/// Returns loops along edges, one per request, that generate the homology of the surface: those of a basis, or the
/// handle loops and then the tunnel loops of the solid that it bounds. \throws Bad_input
std::vector<Network_request> surface_loops(const Mesh& mesh, bool are_handles_and_tunnels, Progress& progress);

/// Traces them, in the order of the requests. Their statuses are the names of `Trace_status`. \throws Bad_input
std::vector<Curve_result> traced_curves(const Mesh& mesh, const std::vector<Trace_request>& requests,
                                        const Path_conditions& conditions, Progress& progress);

/// Shortest paths that are wanted, between the ends of each pair those of so many homotopy classes.
struct Ways_request
{
  std::vector<Curve_request> pairs;
  std::size_t number;
  Obstacles obstacles;
  std::optional<double> memory_limit; ///< for the part of the universal cover that is searched, in bytes
};

/// The paths, those of a pair by length, and what is known of others, for people.
struct Ways
{
  std::vector<Curve_result> curves;
  std::string others;
};

/// Finds them. The statuses are the names of `Verdict`. \throws Bad_input
Ways other_ways(const Mesh& mesh, const Ways_request& request, Progress& progress);

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

struct Flattened_mesh
{
  Mesh mesh;          ///< with the positions of corners in the plane, see `texture_of()`
  std::string report; ///< a line for people
  std::string defect; ///< why the texture is not injective; empty if it is, up to rounding errors
};

/// Cuts a surface along shortened curves and flattens it conformally. \throws Bad_input also as `limited_subdivision()`
Flattened_mesh flattened_mesh(const Mesh& mesh, const std::string& name, const Network_request& cut,
                              const Mesh_result_options& options, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_COMPUTATIONS_H
