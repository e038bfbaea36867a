// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_CURVE_ENGINE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_CURVE_ENGINE_H

#include "input/requests.h"
#include "program_mesh.h"
#include "program_options.h"
#include "run/progress.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// What computes the curves, for those who ask for them and write them: without the algorithms, which are compiled by
// themselves.
namespace program {

/// A point of a curve: where on the input, (1 - t) a + t b, and where in space.
struct Curve_point
{
  CGAL::Flip_geodesics::Surface_point on_surface;
  Point_3 in_space;
  bool is_stop = false; ///< not where an edge is crossed
};

/// What became of a curve.
struct Curve_result
{
  std::string name;
  Vertex_index source, target; ///< null if it is closed, or if it does not start or end at a vertex
  std::size_t initial_segments = 0;
  double initial_length = std::numeric_limits<double>::quiet_NaN();
  double length = std::numeric_limits<double>::quiet_NaN();
  std::size_t flips = 0, flip_outs = 0; ///< of the whole run if it is a network
  double smallest_angle = std::numeric_limits<double>::quiet_NaN();
  std::string status = "ERROR";
  std::string certificate = "none"; ///< the verdict, if the arithmetic is certified
  bool is_closed = false, is_of_tree = false;
  bool is_pulled_tight = true;                       ///< or follows from distances or a direction
  bool are_zero_edges_contracted = false;            ///< since it met a degenerate edge
  double search_s = 0, shorten_s = 0, extract_s = 0; ///< the first two of the whole run if it is a network
  std::string error;                                 ///< why the status is ERROR or MEMORY_LIMIT
  std::vector<Curve_point> points;

  bool is_error() const { return status == "ERROR"; }
};

/// What files for viewers show of a curve. \param number in the order of the results \param run of the curves that were
/// shortened together
inline Scene_curve scene_curve(const Curve_result& r, std::size_t number, std::size_t run)
{
  Scene_curve curve = {number,       r.name, r.status, r.certificate, r.initial_length, r.length, r.flips, r.is_closed,
                       r.is_of_tree, run,    {}};
  for(const Curve_point& p : r.points)
    curve.points.push_back(p.in_space);
  return curve;
}

struct Run_options
{
  CGAL::Flip_geodesics::Search_method search = CGAL::Flip_geodesics::Search_method::A_STAR;
  std::optional<double> stop_length;       ///< stop at this share of the initial length; of the total one of a network
  std::optional<double> stop_curve_length; ///< the same of each curve of a network
  bool is_shortest = false;                ///< paths of pairs and of a tree must be globally shortest
  const CGAL::Flip_geodesics::Geodesic_landmarks* landmarks = nullptr; ///< for pairs; null if there are none
  int rounds = 5;                                                      ///< how often the pieces of splines are halved
  bool is_snapped = false;             ///< move polylines to edges, and do not insert their points
  bool are_zero_edges_refused = false; ///< and not contracted where they are met
  Mesh_result_options meshes;
  std::size_t memory_limit = (std::numeric_limits<std::size_t>::max)(); ///< for the records of flips, in bytes
  bool has_map = false;                                                 ///< compute the logarithmic map of a tree
};

/// The requested meshes: they have the edges of a triangulation, or its curves.
struct Result_meshes
{
  std::optional<Mesh> subdivision, insertion, cut;
  std::optional<Mesh> flattened; ///< with `texture_of()`
};

/*!
 * Computes curves on a mesh: each by itself on the same triangulation, whose flips are rolled back in between, or a
 * network. The mesh, the metric and the progress must outlive it.
 */
class Curve_engine
{
public:
  virtual ~Curve_engine() = default;

  /// Looks for curves that cross, which no order of their segments can mend. Paths between points are found, not given:
  /// where those of one curve cross, it alone fails when it is computed. \throws Bad_input
  virtual void check(const Network_request& request) = 0;

  /// Computes curves that are shortened together. A failure is one of all of them: results with the status ERROR.
  virtual std::vector<Curve_result> run(const Network_request& request) = 0;

  /// Has the steps of the next runs recorded, in up to so many points per run; 0 is none.
  void set_most_recorded_points(std::size_t count) { m_most_recorded_points = count; }

  /// The record of the last run, if it was wanted and has not failed.
  const std::optional<Shortening_record>& record() const { return m_record; }

  /// The map of the last run, if it was wanted, and the run was that of a tree and has not failed.
  const std::optional<CGAL::Flip_geodesics::Vertex_logarithmic_map>& map() const { return m_map; }

  /// The meshes of the last run that has not failed.
  const Result_meshes& meshes() const { return m_meshes; }

  /// What was done to the triangulation of the last run, for people.
  const std::string& mesh_results() const { return m_mesh_results; }

  /// What the tree of the last run is like, for people; empty if it had none.
  const std::string& tree_results() const { return m_tree_results; }

protected:
  std::size_t m_most_recorded_points = 0;
  std::optional<Shortening_record> m_record;
  std::optional<CGAL::Flip_geodesics::Vertex_logarithmic_map> m_map;
  Result_meshes m_meshes;
  std::string m_mesh_results, m_tree_results;
};

/// An engine that computes in doubles.
std::unique_ptr<Curve_engine> make_double_engine(const Mesh& mesh, const Program_metric& metric,
                                                 const Run_options& options, Progress& progress);

/// Engines with exact predicates.
std::unique_ptr<Curve_engine> make_certified_engine(const Mesh& mesh, const Program_metric& metric,
                                                    const Run_options& options, Progress& progress);
std::unique_ptr<Curve_engine> make_weighted_engine(const Mesh& mesh, const Weighted_program_metric& metric,
                                                   const Run_options& options, Progress& progress);

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_CURVE_ENGINE_H
