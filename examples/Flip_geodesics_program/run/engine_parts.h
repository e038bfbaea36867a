// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_ENGINE_PARTS_H
#define CGAL_FLIP_GEODESICS_PROGRAM_ENGINE_PARTS_H

#include "messages.h"
#include "program_mesh.h"
#include "run/curve_engine.h"
#include "run/limited_subdivision.h"
#include "run/progress.h"

#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/refine.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/subdivide.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Parts of the engine: searches for shortest pairs, and what becomes of a tree and of a triangulation once its curves
// are finished: lines for people, flips, refinement, and meshes with the curves.
namespace program {

/// Describes the paths of a tree, in lines for people.
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
    return "shortest not confirmed: the search for shorter paths was aborted, or rounding errors or degenerate faces "
           "prevent the confirmation\n";
  std::ostringstream out;
  out << "shortest " << readable(report.vertices - report.longer) << " paths, confirmed; "
      << readable(report.longer_before) << " were longer before the search, by up to "
      << 100 * report.largest_excess_before << " %\n";
  return out.str();
}

/// How a refinement has ended, if not as wanted.
inline std::string ending(const CGAL::Flip_geodesics::Refinement_report& report)
{
  using CGAL::Flip_geodesics::Refinement_status;
  switch(report.status) {
  case Refinement_status::BOUNDS_REACHED:
    return "";
  case Refinement_status::BOUNDS_NOT_REACHABLE: {
    const std::size_t refused = report.missed - report.given_up;
    std::string reasons;
    if(report.given_up > 0)
      reasons = counted(report.given_up, "face", "faces") + " would require far more vertices than allowed";
    if(refused > 0)
      reasons += (reasons.empty() ? "" : ", and ") + counted(refused, "face is", "faces are") +
                 " too small for double precision, or adjacent to a face that is too small";
    return "; the bounds cannot be reached: " + reasons;
  }
  case Refinement_status::VERTEX_LIMIT:
    return "; ended because the limit on inserted vertices was reached; increase --insertion-limit";
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
    text << "delaunay " << counted(report.flips, "flip", "flips") << "; "
         << counted(report.constrained, "edge of a curve is", "edges of curves are") << " not locally Delaunay\n";
  }
  if(options.refine) {
    FG::Refinement_options bounds;
    bounds.smallest_angle = *options.refine;
    bounds.longest_edge = options.longest_edge.value_or(bounds.longest_edge);
    if(options.insertion_limit)
      bounds.maximum_insertions = static_cast<std::size_t>(*options.insertion_limit);
    progress.enter("refining", "vertices inserted");
    Refinement_progress visitor(progress);
    const FG::Refinement_report report = FG::refine(network, bounds, CGAL::parameters::visitor(std::ref(visitor)));
    text << "refined  " << counted(report.insertions, "vertex", "vertices") << " inserted, "
         << counted(report.splits, "edge", "edges") << " split; smallest angle " << report.smallest_angle << " degrees";
    if(report.exempt > 0)
      text << ", " << report.smallest_free_angle << " degrees without "
           << counted(report.exempt, "face whose small angle is unavoidable",
                      "faces whose small angles are unavoidable");
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
    meshes.subdivision = limited_subdivision(network.triangulation(), mesh, options).mesh();
  if(!options.insertion.empty())
    meshes.insertion = FG::insert_curves(network, mesh).mesh();
  if(!options.cut.empty())
    meshes.cut = FG::cut_along_curves(network, mesh).mesh();
  return meshes;
}

/// A search of edge paths that notes how long it took, and what it found.
template <class Search>
class Noted_search
{
public:
  explicit Noted_search(Search& search)
    : m_search(search)
  {
  }

  template <class... Visitor>
  auto operator()(Vertex_index source, Vertex_index target, Visitor&&... visitor)
  {
    const Stopwatch stopwatch;
    const auto path = m_search(source, target, visitor...);
    m_seconds += stopwatch.seconds();
    m_segments = path.size();
    return path;
  }

  double seconds() const { return m_seconds; }
  std::size_t segments() const { return m_segments; }

private:
  Search& m_search;
  double m_seconds = 0;
  std::size_t m_segments = 0;
};

/// How many windows fit in so many bytes, and no more than a search makes on meshes without needles.
inline CGAL::Flip_geodesics::Window_limit window_limit(std::size_t number_of_vertices, std::size_t memory_limit)
{
  constexpr std::size_t bytes_per_window = 64;
  const std::size_t usual = CGAL::Flip_geodesics::Window_limit()(number_of_vertices);
  return CGAL::Flip_geodesics::Window_limit((std::min)(usual, memory_limit / bytes_per_window));
}

/// Adds the shortest of all paths between two vertices to an empty network. \param landmarks null if there are none
template <class Network, class Search, class Visitor>
CGAL::Flip_geodesics::Shortest_path_report add_shortest_pair(Network& network, Search& search,
                                                             const CGAL::Flip_geodesics::Geodesic_landmarks* landmarks,
                                                             const std::vector<Vertex_index>& ends,
                                                             std::size_t memory_limit, Visitor& visitor)
{
  namespace FG = CGAL::Flip_geodesics;
  const FG::Window_limit limit =
      window_limit(static_cast<std::size_t>(network.triangulation().number_of_vertices()), memory_limit);
  return landmarks == nullptr
             ? FG::add_shortest_path(network, search, ends[0], ends[1], CGAL::parameters::search_limit(limit),
                                     CGAL::parameters::visitor(std::ref(visitor)))
             : FG::add_shortest_path(network, search, ends[0], ends[1], CGAL::parameters::search_limit(limit),
                                     CGAL::parameters::landmarks(*landmarks),
                                     CGAL::parameters::visitor(std::ref(visitor)));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_ENGINE_PARTS_H
