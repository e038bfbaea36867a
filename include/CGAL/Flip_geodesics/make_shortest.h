// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_MAKE_SHORTEST_H
#define CGAL_FLIP_GEODESICS_MAKE_SHORTEST_H

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/shortest/Shortest_tree_repair.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTree
/// Reports how many paths of a tree are globally shortest. Paths are compared only with those that a search has found.
/// Unless the distances are confirmed, the search may have missed vertices or shorter paths, and the absence of longer
/// paths proves nothing.
struct Distances_report
{
  std::size_t vertices = 0;         ///< the number of vertices other than the source that the search reached within the
                                    ///< limit of the tree
  std::size_t longer_before = 0;    ///< those whose path was missing or longer than the one found
  std::size_t longer = 0;           ///< those whose path still is; rounding errors or degenerate faces can be the cause
  double largest_excess_before = 0; ///< the largest excess length of a path before, relative to the shortest length
  double largest_excess = 0;        ///< the largest excess length of a path now, relative to the shortest length
  std::size_t windows = 0;          ///< the number of windows of the search
  std::size_t flips = 0;            ///< the number of flips that inserted shortest paths
  /// `WITHIN_TOLERANCE` if the figures are exact up to rounding errors, and no shortest path is shorter than the one
  /// found by more than 1e-10 of it. Otherwise `UNDECIDED`: if the search was aborted or stopped, or encountered a
  /// degenerate edge, or if coordinates or lengths of the mesh had to be rounded. Near faces whose height is at most
  /// 1e-10 of their base, and if rounding errors may be as large, the figures are confirmed only by a search with
  /// outward-rounded bounds.
  Verdict verdict = Verdict::UNDECIDED;
  /// Whether the paths are locally shortest, including those that were not replaced, as reported by
  /// `Geodesic_tree::grow()`. `STOPPED_BY_VISITOR` if the `go_further()` of a visitor returned `false`.
  Shortening_status status = Shortening_status::LOCALLY_SHORTEST;

  /// Returns whether the distances are confirmed.
  bool is_confirmed() const { return Flip_geodesics::is_confirmed(verdict); }
};

namespace internal {

/*
 * Counts the paths that are longer than those that a search has found, and records their excess lengths. Returns false
 * if a path is shorter, which means that the search has failed.
 */
template <class Tree, class Search>
bool count_longer(const Tree& tree, const Search& search, Distances_report& report)
{
  constexpr double tolerance = Shortest_path_report::tolerance();
  report.vertices = report.longer = 0;
  report.largest_excess = 0;
  bool is_consistent = true;
  for(Vertex_index v : descriptors<Vertex_index>(tree.triangulation().input().number_of_vertices())) {
    if(!search.is_reached(v) || search.distance(v) > tree.max_distance() || v == tree.source())
      continue;
    ++report.vertices;
    const double ratio = tree.distance(v) / search.distance(v) - 1;
    report.longer += ratio > tolerance ? 1 : 0;
    report.largest_excess = (std::max)(report.largest_excess, tree.is_reached(v) ? ratio : 0);
    is_consistent = is_consistent && ratio >= -tolerance;
  }
  return is_consistent;
}

/*
 * Returns an upper bound of the lengths of the requested paths: the limit of the tree, or its longest path if it
 * contains all vertices.
 */
template <class Tree>
double longest_wanted(const Tree& tree)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(tree.max_distance() < infinity)
    return std::nextafter(tree.max_distance(), infinity);
  double longest = 0;
  for(Vertex_index v : internal::descriptors<Vertex_index>(tree.triangulation().number_of_vertices()))
    longest = (std::max)(longest, tree.is_reached(v) ? tree.distance(v) : 0);
  return longest;
}

/* Counts the longer paths before any path is replaced. */
template <class Tree, class Search>
bool compare(const Tree& tree, const Search& search, Distances_report& report)
{
  const bool is_consistent = count_longer(tree, search, report);
  report.longer_before = report.longer;
  report.largest_excess_before = report.largest_excess;
  return is_consistent;
}

/* Replaces the paths of a tree that are longer than those that a search has found. */
template <class Tree, class Search>
void replace_longer(Tree& tree, const Search& search, Interruption& interruption, Distances_report& report)
{
  Shortest_tree_repair<Tree, Search> repair(tree, search, Shortest_path_report::tolerance(), &interruption);
  const std::vector<Vertex_index> longer = repair.longer();
  if(!longer.empty())
    report.status = repair.run(longer);
  report.flips = repair.flips();
  count_longer(tree, search, report);
}

/* The paths found by a search with outward rounding, with upper bounds of their lengths. */
template <class Triangulation, class Search>
class Paths_of_search
{
public:
  Paths_of_search(const Triangulation& triangulation, const Search& search)
    : m_triangulation(triangulation)
    , m_search(search)
  {
  }

  bool is_reached(Vertex_index v) const { return m_search.is_reached(v); }
  double distance(Vertex_index v) const { return m_search.greatest_distance(v); }
  Last_leg last_leg(Vertex_index v) const { return internal::last_leg(m_triangulation, m_search, v); }

private:
  const Triangulation& m_triangulation;
  const Search& m_search;
};

/*
 * Returns whether the distances of a tree or of the search itself, and those of shortest paths, lie between the bounds
 * of a search with outward rounding, and these bounds agree up to the tolerance, for all distances up to the greatest
 * one. Lengths in a tree can be wrong if edges are much longer than paths.
 */
template <class Distances, class Search>
bool are_bounds_close(const Distances& distances, const Search& search, Index number_of_vertices, double greatest)
{
  constexpr double tolerance = Shortest_path_report::tolerance();
  for(Vertex_index v : descriptors<Vertex_index>(number_of_vertices)) {
    const double least = search.least_distance(v), longest = least * (1 + tolerance);
    if(!search.is_reached(v) || search.is_source(v) || least > greatest)
      continue;
    if(!(search.greatest_distance(v) <= longest && distances.distance(v) <= longest &&
         distances.distance(v) >= least * (1 - tolerance)))
      return false;
  }
  return true;
}

/*
 * The outcome of a search with outward rounding: it is incomplete, its bounds are too far apart, or they confirm the
 * distances.
 */
enum class Search_outcome { INCOMPLETE, UNCLEAR, CONFIRMED };

/*
 * Calls `confirm(search, most_windows)` with a search with outward rounding, in doubles. If its bounds are too far
 * apart, as among needles, `confirm` is called with another search in double-double arithmetic, whose errors are
 * negligible; it requires hardly more windows, and is aborted beyond twice as many. Returns the last outcome.
 */
template <class Triangulation, class Confirm>
Search_outcome confirm_by_search(const Triangulation& triangulation, const std::vector<Vertex_index>& sources,
                                 std::size_t most_windows, const Confirm& confirm)
{
  using Precise_faces = Precise_unfolded_faces<Triangulation>;
  const auto confirm_from_sources = [&](auto search, std::size_t most) {
    for(Vertex_index v : sources)
      search.add_source(v);
    const Search_outcome outcome = confirm(search, most);
    return std::make_pair(outcome, search.effort());
  };
  Unfolded_faces<Triangulation> faces(triangulation);
  const auto [outcome, effort] =
      confirm_from_sources(Window_search<Triangulation>(triangulation, faces, sources.front()), most_windows);
  if(outcome != Search_outcome::UNCLEAR)
    return outcome;
  Precise_faces precise_faces(triangulation, faces);
  using Precise_search = Window_search<Triangulation, Precise_faces>;
  return confirm_from_sources(Precise_search(triangulation, precise_faces, sources.front()), 2 * effort).first;
}

/* Replaces the paths of a tree that are longer than those of a search, if the search confirms its own. */
template <class Tree, class Search>
Search_outcome replace_by_search(Tree& tree, Search& search, double longest, std::size_t most_windows,
                                 Interruption& interruption, Distances_report& report)
{
  const Index n = tree.triangulation().input().number_of_vertices();
  const bool is_sound =
      run_to_the_end(search, longest * (1 + Shortest_path_report::tolerance()), most_windows, &interruption);
  report.windows += search.number_of_windows();
  if(!is_sound || search.lower_bound() < longest)
    return Search_outcome::INCOMPLETE;
  if(!are_bounds_close(search, search, n, tree.max_distance()))
    return Search_outcome::UNCLEAR;
  const Paths_of_search<typename Tree::Triangulation, Search> paths(tree.triangulation(), search);
  compare(tree, paths, report);
  replace_longer(tree, paths, interruption, report);
  return are_bounds_close(tree, search, n, tree.max_distance()) ? Search_outcome::CONFIRMED : Search_outcome::UNCLEAR;
}

/*
 * Replaces the paths of a tree that are not shortest by a search with outward rounding, if the distances of a field are
 * inaccurate. Returns whether they are confirmed to be shortest then.
 */
template <class Tree>
bool prove_shortest(Tree& tree, double longest, std::size_t most_windows, Interruption& interruption,
                    Distances_report& report)
{
  const auto replace = [&](auto& search, std::size_t most) {
    return replace_by_search(tree, search, longest, most, interruption, report);
  };
  return confirm_by_search(tree.triangulation(), {tree.source()}, most_windows, replace) == Search_outcome::CONFIRMED;
}

/*
 * Replaces the paths of a tree that are not shortest, given a field from its source that has been computed up to its
 * longest path unless it was aborted or encountered a degenerate edge.
 */
template <class Triangulation>
Distances_report make_shortest(Geodesic_tree<Triangulation>& tree, const Window_propagation<Triangulation>& field,
                               bool is_sound, std::size_t most_windows, Interruption& interruption)
{
  Distances_report report;
  report.status = tree.report().status;
  report.windows = field.number_of_windows();
  const double longest = longest_wanted(tree);
  const bool is_complete = is_sound && field.reach() >= longest;
  const bool is_accurate = !field.has_flat_face() && !field.has_inaccurate_distance();
  if(is_complete && !is_accurate && prove_shortest(tree, longest, most_windows, interruption, report)) {
    report.verdict = verdict_of_distances(true);
  } else {
    report.verdict = verdict_of_distances(compare(tree, field, report) && is_complete && is_accurate);
    if((is_complete || field.number_of_windows() <= most_windows) && !interruption.has_occurred())
      replace_longer(tree, field, interruption, report);
  }
  if(interruption.has_occurred())
    report.status = Shortening_status::STOPPED_BY_VISITOR;
  if(interruption.has_occurred() || is_input_rounded(tree.triangulation()))
    report.verdict = Verdict::UNDECIDED;
  return report;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Replaces the paths of a tree that are not globally shortest.
 *
 * The distances on the input are computed as by `Geodesic_distance_field`, exact up to rounding errors, or, if it
 * cannot confirm them, by a search with outward-rounded bounds. The longer paths are then removed from the tree, and
 * shortest ones are inserted by flips, the nearest first. They do not cross other paths of the tree, since shortest
 * paths from one vertex never cross. Vertices within the limit of the tree that it did not contain are added.
 *
 * \param tree a tree whose growth was not stopped
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the number of windows after which the search is aborted and the tree remains unchanged}
 *     \cgalParamType{`Window_limit`}
 *     \cgalParamDefault{`Window_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If `go_further()` returns `false`, the report has the status
 *       `Shortening_status::STOPPED_BY_VISITOR` and is not confirmed. The tree remains valid: it is unchanged if the
 *       search was stopped; later, some paths may have been replaced.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the paths of the tree. Inserted vertices have geodesics, but are not part of the report
 * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
 * \throws Occupied_triangulation_error if a network in the triangulation has curves
 * \throws Vertex_out_of_range_error if the source of the tree is an inserted vertex
 *
 * Complexity: that of `Geodesic_distance_field::compute()`, and for each replaced path the degree of its end and the
 * number of edges that its last geodesic segment crosses; if any path is replaced, also linear in the size of the mesh.
 */
template <class Triangulation, class... NamedParameters>
Distances_report make_shortest(Geodesic_tree<Triangulation>& tree, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal::Limit_parameter, internal_np::visitor_t>(np...);
  CGAL_precondition(tree.source() != null_index);
  if(tree.triangulation().is_inserted(tree.source()))
    throw Vertex_out_of_range_error("shortest paths are searched from a vertex of the input mesh, and vertex " +
                                        std::to_string(tree.source().idx()) + " was inserted",
                                    {static_cast<std::size_t>(tree.source().idx())});
  internal::check_has_no_curves(tree.triangulation(), "the paths of a tree cannot be replaced");
  const std::size_t most_windows = internal::search_limit_of<Window_limit>(options)(
      static_cast<std::size_t>(tree.triangulation().number_of_vertices()));
  auto visitor = internal::make_visitor(options);
  internal::Interruption interruption(visitor.get());
  internal::Window_propagation<Triangulation> field(tree.triangulation(), false);
  field.add_vertex(tree.source(), 0, 0);
  const bool is_sound = internal::run_to_the_end(field, internal::longest_wanted(tree), most_windows, &interruption);
  return internal::make_shortest(tree, field, is_sound, most_windows, interruption);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_MAKE_SHORTEST_H
