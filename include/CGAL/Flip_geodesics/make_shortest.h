// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_MAKE_SHORTEST_H
#define CGAL_FLIP_GEODESICS_MAKE_SHORTEST_H

#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/arithmetic/imported_number.h>
#include <CGAL/Flip_geodesics/internal/base/Interruption.h>
#include <CGAL/Flip_geodesics/internal/field/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/windows/Last_leg.h>
#include <CGAL/Flip_geodesics/internal/windows/Shortest_tree_repair.h>
#include <CGAL/Flip_geodesics/internal/windows/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/windows/Window_search.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTree
/// How many paths of a tree are globally shortest. Paths are compared with those that the search found, and with nothing
/// else: unless `is_confirmed`, it may have missed vertices, or shorter paths, and 0 longer ones then prove nothing.
struct Shortest_tree_report
{
  std::size_t vertices = 0;         ///< that the search reached within the tree's limit; without the source
  std::size_t longer_before = 0;    ///< of them, whose path was longer than the one found, or missing
  std::size_t longer = 0;           ///< for which it still is; rounding, or degenerate faces, can stand in the way
  double largest_excess_before = 0; ///< the largest part of a shortest length that a path was longer
  double largest_excess = 0;        ///< the same now
  std::size_t windows = 0;          ///< what the search for shortest paths cost
  std::size_t flips = 0;            ///< by which shortest paths were inserted
  /// Was the search neither given up nor stopped, were there no degenerate faces, and was no path of the tree shorter than
  /// the one that was found? Then the figures are exact up to rounding. Never if coordinates or lengths of the mesh are not doubles.
  bool is_confirmed = false;
  /// Are the paths locally shortest, as `Geodesic_tree::grow()` says it? Also of paths that were left as they are.
  /// `STOPPED_BY_VISITOR` if a visitor's `go_further()` returned `false`.
  Shortening_status status = Shortening_status::LOCALLY_SHORTEST;
};

namespace internal {

/* Which paths are longer than shortest ones, and by how much. False if one is shorter, so that the search has failed. */
template <class Tree, class Search>
bool count_longer(const Tree& tree, const Search& search, double tolerance, std::size_t& count, double& excess)
{
  count = 0;
  excess = 0;
  bool is_consistent = true;
  for(Vertex_index v : internal::descriptors<Vertex_index>(tree.triangulation().input().number_of_vertices())) {
    if(!search.is_reached(v) || search.distance(v) > tree.max_distance() || v == tree.source())
      continue;
    const double ratio = tree.distance(v) / search.distance(v) - 1;
    count += ratio > tolerance ? 1 : 0;
    excess = (std::max)(excess, tree.is_reached(v) ? ratio : 0);
    is_consistent = is_consistent && ratio >= -tolerance;
  }
  return is_consistent;
}

} // namespace internal

namespace internal {

/* No path that is wanted is longer: neither than the tree's limit, nor than its longest path if that has all vertices.
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

/* Compares the paths of a tree with those that a search has found. False if the search has missed shorter ones. */
template <class Tree, class Search>
bool compare(const Tree& tree, const Search& search, Shortest_tree_report& report)
{
  report.vertices = 0;
  for(Vertex_index v : descriptors<Vertex_index>(tree.triangulation().input().number_of_vertices()))
    report.vertices += v != tree.source() && search.distance(v) <= tree.max_distance() && search.is_reached(v) ? 1 : 0;
  const bool is_consistent =
      count_longer(tree, search, Shortest_path_report::tolerance(), report.longer_before, report.largest_excess_before);
  report.longer = report.longer_before;
  report.largest_excess = report.largest_excess_before;
  return is_consistent;
}

/* Replaces the paths of a tree that are longer than those that a search has found. */
template <class Tree, class Search>
void replace_longer(Tree& tree, const Search& search, Interruption& interruption, Shortest_tree_report& report)
{
  constexpr double tolerance = Shortest_path_report::tolerance();
  Shortest_tree_repair<Tree, Search> repair(tree, search, tolerance, &interruption);
  const std::vector<Vertex_index> longer = repair.longer();
  if(!longer.empty())
    report.status = repair.run(longer);
  report.flips = repair.flips();
  count_longer(tree, search, tolerance, report.longer, report.largest_excess);
}

/* The paths that a search has found that is rounded outward, with lengths that they do not exceed. */
template <class Triangulation>
class Paths_of_search
{
public:
  Paths_of_search(const Triangulation& triangulation, const Window_search<Triangulation>& search)
    : m_triangulation(triangulation)
    , m_search(search)
  {
  }

  bool is_reached(Vertex_index v) const { return m_search.is_reached(v); }
  double distance(Vertex_index v) const { return m_search.greatest_distance(v); }
  Last_leg last_leg(Vertex_index v) const { return internal::last_leg(m_triangulation, m_search, v); }

private:
  const Triangulation& m_triangulation;
  const Window_search<Triangulation>& m_search;
};

/* Are the lengths of all paths of a tree, and of shortest ones, between the bounds of a search, which are as close as the
 * tolerance? Lengths in the tree can be wrong where edges are much longer than paths. */
template <class Tree, class Search>
bool are_bounds_close(const Tree& tree, const Search& search)
{
  constexpr double tolerance = Shortest_path_report::tolerance();
  for(Vertex_index v : descriptors<Vertex_index>(tree.triangulation().input().number_of_vertices())) {
    const double least = search.least_distance(v), longest = least * (1 + tolerance);
    if(!search.is_reached(v) || v == tree.source() || least > tree.max_distance())
      continue;
    if(!(search.greatest_distance(v) <= longest && tree.distance(v) <= longest &&
         tree.distance(v) >= least * (1 - tolerance)))
      return false;
  }
  return true;
}

/* Replaces the paths of a tree that are not shortest by a search that is rounded outward, where the distances of a field
 * are not accurate. */
template <class Tree>
void prove_shortest(Tree& tree, double longest, std::size_t most_windows, Interruption& interruption,
                    Shortest_tree_report& report)
{
  using Triangulation = typename Tree::Triangulation;
  Unfolded_faces<Triangulation> faces(tree.triangulation());
  Window_search<Triangulation> search(tree.triangulation(), faces, tree.source());
  const bool is_sound =
      run_to_the_end(search, longest * (1 + Shortest_path_report::tolerance()), most_windows, &interruption);
  report.windows += search.number_of_windows();
  const Paths_of_search<Triangulation> paths(tree.triangulation(), search);
  compare(tree, paths, report);
  if(!is_sound || search.lower_bound() < longest)
    return;
  replace_longer(tree, paths, interruption, report);
  report.is_confirmed = !is_input_rounded(tree.triangulation()) && are_bounds_close(tree, search);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Finds the paths of a tree that are not globally shortest, and replaces them. The distances on the input are computed
 * as by `Geodesic_distance_field`, exact up to rounding. Then the longer paths are taken out of the tree, and shortest
 * ones inserted by flips, the nearest first. They do not cross what is there, since shortest paths from one vertex
 * never cross. Vertices within the tree's limit that it did not find are added.
 *
 * Complexity: that of `Geodesic_distance_field::compute()`, and for each path that is replaced the degree of its end and
 * the edges that its last leg crosses; if any is, linear in the size of the mesh on top.
 *
 * \param tree a tree that has been grown to its end
 * \param limit beyond it the search is given up, and the tree stays as it is
 * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, at regular intervals. If it returns
 *        `false`, then the report has the status `Shortening_status::STOPPED_BY_VISITOR` and is not confirmed. The tree
 *        remains valid: it stays as it is if the search is stopped; afterwards, some paths may have been replaced
 * \throws Invalid_coordinate_error
 * \throws Occupied_triangulation_error if a network in the triangulation has curves
 * \throws Vertex_out_of_range_error if the source was inserted. Other inserted vertices have geodesics, which nothing
 * is said about.
 */
template <class Triangulation, class Visitor = Default_shortening_visitor>
Shortest_tree_report make_shortest(Geodesic_tree<Triangulation>& tree, const Window_limit& limit = Window_limit(),
                                   Visitor&& visitor = Visitor())
{
  CGAL_precondition(tree.source() != null_index);
  if(tree.triangulation().is_inserted(tree.source()))
    throw Vertex_out_of_range_error("shortest paths are searched from a vertex of the input mesh, and vertex " +
                                        std::to_string(tree.source().idx()) + " was inserted",
                                    {static_cast<std::size_t>(tree.source().idx())});
  if(tree.triangulation().network_place().has_curves())
    throw Occupied_triangulation_error("the paths of a tree cannot be replaced in a triangulation that has curves");
  const std::size_t most_windows = limit(static_cast<std::size_t>(tree.triangulation().number_of_vertices()));
  const double longest = internal::longest_wanted(tree);
  Shortest_tree_report report;
  report.status = tree.report().status;
  internal::Interruption interruption(visitor);
  internal::Window_propagation<Triangulation> field(tree.triangulation(), false);
  field.add_vertex(tree.source(), 0, 0);
  const bool is_sound = internal::run_to_the_end(field, longest, most_windows, &interruption);
  report.windows = field.number_of_windows();
  if(is_sound && report.windows <= most_windows && !field.has_flat_face() && field.has_inaccurate_distance()) {
    internal::prove_shortest(tree, longest, most_windows, interruption, report);
  } else {
    report.is_confirmed = is_sound && !field.is_given_up(most_windows) && !field.has_flat_face() &&
                          !internal::is_input_rounded(tree.triangulation());
    report.is_confirmed = internal::compare(tree, field, report) && report.is_confirmed;
    if(report.windows <= most_windows && !interruption.has_occurred())
      internal::replace_longer(tree, field, interruption, report);
  }
  if(interruption.has_occurred()) {
    report.status = Shortening_status::STOPPED_BY_VISITOR;
    report.is_confirmed = false;
  }
  return report;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_MAKE_SHORTEST_H
