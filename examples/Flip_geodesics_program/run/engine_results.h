// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_ENGINE_RESULTS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_ENGINE_RESULTS_H

#include "messages.h"
#include "program_mesh.h"
#include "run/curve_engine.h"
#include "run/progress.h"

#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

// What becomes of a tree and of a triangulation once its curves are finished: lines for people, flips, refinement, and
// meshes with the curves.
namespace program {

/// Where the paths of a tree lead, in lines for people.
template <class Tree>
std::string describe_tree(const Tree& tree, std::size_t flips)
{
  Vertex_index farthest = tree.source();
  std::size_t number_of_paths = 0;
  for(Vertex_index v(0); v.idx() < tree.triangulation().input().number_of_vertices(); ++v) {
    if(v == tree.source() || !tree.is_reached(v))
      continue;
    ++number_of_paths;
    if(tree.distance(v) > tree.distance(farthest))
      farthest = v;
  }
  std::ostringstream out;
  const bool is_inserted = tree.triangulation().is_inserted(tree.source());
  out << "paths    " << readable(number_of_paths) << " from "
      << (is_inserted ? "the source" : "vertex " + std::to_string(tree.source().idx())) << ", the longest to vertex "
      << farthest.idx() << ", " << tree.distance(farthest) << " long\nflips    " << readable(flips) << '\n';
  return out.str();
}

/// What was done to make the paths of a tree shortest, in a line for people.
inline std::string describe_shortest_paths(const CGAL::Flip_geodesics::Distances_report& report)
{
  if(!report.is_confirmed())
    return "shortest not confirmed: the search for shorter paths was aborted or encountered degenerate faces\n";
  std::ostringstream out;
  out << "shortest " << readable(report.vertices - report.longer) << " of them, confirmed; "
      << readable(report.longer_before) << " were longer at first, by up to " << 100 * report.largest_excess_before
      << " %\n";
  return out.str();
}

/// How a refinement has ended, if not as wanted.
inline std::string ending(const CGAL::Flip_geodesics::Refinement_report& report)
{
  using CGAL::Flip_geodesics::Refinement_status;
  switch(report.status) {
  case Refinement_status::BOUNDS_REACHED:
    return "";
  case Refinement_status::BOUNDS_NOT_REACHABLE:
    return "; the bounds cannot be reached: " + std::to_string(report.given_up) +
           " faces would require far more vertices than allowed, " + std::to_string(report.missed - report.given_up) +
           " are too small for double precision or adjacent to such faces";
  case Refinement_status::VERTEX_LIMIT:
    return "; ended because the maximal number of vertices was reached";
  case Refinement_status::STOPPED_BY_VISITOR:
    return "; interrupted";
  }
  return "";
}

/// Counts vertices inserted, instead of faces looked at.
class Refinement_progress : public Progress_visitor
{
public:
  explicit Refinement_progress(Progress& progress)
    : Progress_visitor(progress)
    , m_progress(progress)
  {
  }

  bool go_further() { return true; }

  template <class Triangulation>
  void on_insertion(const Triangulation&, CGAL::Flip_geodesics::Vertex_index)
  {
    m_progress.add_steps(1);
  }

private:
  Progress& m_progress;
};

/// Flips and refines the triangulation of a network whose curves are finished. Returns lines for people.
template <class Network>
std::string improve_triangulation(const Mesh_result_options& options, Network& network, Progress& progress)
{
  namespace FG = CGAL::Flip_geodesics;
  std::ostringstream text;
  if(options.is_delaunay) {
    progress.enter("flipping to Delaunay");
    Progress_visitor visitor(progress);
    const FG::Delaunay_report report =
        FG::flip_to_delaunay(network.triangulation(), CGAL::parameters::visitor(std::ref(visitor)));
    text << "delaunay " << report.flips << " flips, " << report.constrained << " edges fixed by curves\n";
  }
  if(options.refine) {
    FG::Refinement_options bounds;
    bounds.smallest_angle = *options.refine;
    bounds.longest_edge = options.longest_edge.value_or(bounds.longest_edge);
    if(options.vertex_limit)
      bounds.maximum_insertions = static_cast<std::size_t>(*options.vertex_limit);
    progress.enter("refining", "vertices inserted");
    Refinement_progress visitor(progress);
    const FG::Refinement_report report = FG::refine(network, bounds, CGAL::parameters::visitor(std::ref(visitor)));
    text << "refined  " << counted(report.insertions, "vertex", "vertices") << " inserted, "
         << counted(report.splits, "edge", "edges") << " split; smallest angle " << report.smallest_angle << " degrees";
    if(report.exempt > 0)
      text << ", " << report.smallest_free_angle << " without "
           << counted(report.exempt, "exempt face", "exempt faces");
    text << "; " << counted(report.missed, "face", "faces") << " outside the bounds" << ending(report) << '\n';
  }
  return text.str();
}

/// The requested meshes.
template <class Network>
Result_meshes result_meshes(const Mesh_result_options& options, const Mesh& mesh, const Network& network)
{
  namespace FG = CGAL::Flip_geodesics;
  Result_meshes meshes;
  if(!options.subdivision.empty())
    meshes.subdivision = FG::common_subdivision(network.triangulation(), mesh).mesh();
  if(!options.insertion.empty())
    meshes.insertion = FG::insert_curves(network, mesh).mesh();
  if(!options.cut.empty())
    meshes.cut = FG::cut_along_curves(network, mesh).mesh();
  return meshes;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_ENGINE_RESULTS_H
