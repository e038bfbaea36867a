// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H
#define CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>
#include <CGAL/Flip_geodesics/Geodesic_tree.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Source_directions.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_propagation.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/shortest/Shortest_tree_repair.h>
#include <CGAL/Flip_geodesics/internal/shortest/geodesic_tree_parts.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_path.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTree
/// Reports on distances and, if a tree of geodesics has been grown, on how many paths of the tree are globally
/// shortest. The paths of the tree are compared with those that a search has found. If the distances are not confirmed,
/// the search may have missed vertices or shorter paths. In this case, even a path of the tree that is not longer than
/// the path found by the search need not be shortest.
struct Distances_report
{
  /// the number of vertices that the search reached, without the sources; if a tree has been grown, only vertices
  /// within its `Geodesic_tree::max_distance()` are counted. In the report of `geodesic_distance_matrix()`, the number
  /// of pairs of points with a finite distance
  std::size_t vertices = 0;
  /// the number of these vertices whose path in the tree was initially missing or longer than the path that the search
  /// found
  std::size_t longer_before = 0;
  /// the number of these vertices whose path is still missing or longer after paths have been replaced
  std::size_t longer = 0;
  double largest_excess_before = 0; ///< the largest initial excess length of a path, relative to the shortest length
  double largest_excess = 0;        ///< the largest remaining excess length of a path, relative to the shortest length
  std::size_t windows = 0;          ///< the number of windows of all searches
  std::size_t flips = 0;            ///< the number of flips by which shortest paths were inserted
  /// The verdict. `WITHIN_TOLERANCE` means that no path found by the search exceeds the length of a shortest path by
  /// more than 1e-10 of this length. The verdict is `UNDECIDED` in the following cases:
  /// - the search was aborted or stopped, or encountered a degenerate edge;
  /// - coordinates or lengths of the mesh had to be rounded, or the contraction of degenerate edges may have removed
  ///   shortest paths;
  /// - the search encountered a face whose height is at most 1e-10 of its base, or rounding errors may exceed 1e-10 of
  ///   a distance.
  ///
  /// In the last case, a second search with outward-rounded bounds can still confirm the results. It is run if all
  /// sources are vertices, except by `geodesic_distance_matrix()`.
  Verdict verdict = Verdict::UNDECIDED;
  /// The status of all paths of the tree, including those that were not replaced, as in `Geodesic_tree_report::status`.
  /// It is `LOCALLY_SHORTEST` if no tree was grown, and `STOPPED_BY_VISITOR` if `go_further()` of a visitor returned
  /// `false`.
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
 * Returns an upper bound on the lengths of the requested paths: the limit of the tree, or its longest path if it has no
 * limit.
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

/* The paths found by a search with outward rounding, with upper bounds on their lengths. */
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
 * The distances are computed exactly up to rounding errors by a `Geodesic_distance_field` or, if the field cannot
 * confirm them, by a search with outward-rounded bounds. Paths of the tree that are longer than these distances are
 * removed, and shortest paths to the same vertices are inserted by flips. Vertices that lie within
 * `Geodesic_tree::max_distance()` but are missing from the tree are added.
 *
 * \param tree a tree whose growth was not stopped by a visitor
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the number of windows after which the field is aborted; in this case, the tree remains
 *       unchanged. This number also limits the search with outward-rounded bounds}
 *     \cgalParamType{`Window_limit`}
 *     \cgalParamDefault{`Window_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If `go_further()` returns `false`, the report has the status
 *       `Shortening_status::STOPPED_BY_VISITOR` and is not confirmed. The tree remains valid. If the search was
 *       stopped, the tree is unchanged; if the replacement of paths was stopped, some paths may have been replaced.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the paths of the tree. The report does not count paths to vertices that were inserted into the
 *         triangulation, although these vertices receive geodesics
 * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
 * \throws Occupied_triangulation_error if a network in the triangulation has curves
 * \throws Vertex_out_of_range_error if the source of the tree is an inserted vertex
 * \throws Invalid_parameter_error if the tree has not been grown
 *
 * Complexity: that of `Geodesic_distance_field::compute()`. If paths are replaced, the replacement takes time linear in
 * the size of the mesh. In addition, each replaced path takes time linear in the degree of its end plus the number of
 * edges that its last geodesic segment crosses.
 */
template <class Triangulation, class... NamedParameters>
Distances_report make_shortest(Geodesic_tree<Triangulation>& tree, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal::Limit_parameter, internal_np::visitor_t>(np...);
  internal::check_is_grown(tree);
  if(tree.triangulation().is_inserted(tree.source()))
    internal::throw_naming<Vertex_out_of_range_error>(
        "shortest paths must start at a vertex of the input mesh, but vertex ", tree.source(), " was inserted");
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

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Writes the lengths of the paths of a tree into a property map of the mesh; vertices without a path receive infinity.
 *
 * \param tree a tree that has been grown
 * \param mesh the mesh of the tree
 * \param distances a model of `WritablePropertyMap` with the vertices of the mesh as keys and `double`s as values
 * \throws Invalid_parameter_error if the tree has not been grown
 *
 * Complexity: linear in the number of vertices of the mesh.
 */
template <class Triangulation, class VertexDistanceMap>
void put_distances(const Geodesic_tree<Triangulation>& tree, const typename Triangulation::Triangle_mesh& mesh,
                   VertexDistanceMap distances)
{
  static_assert(internal::is_property_map<VertexDistanceMap>());
  internal::check_is_grown(tree);
  for(const auto v : vertices(mesh))
    put(distances, v, tree.distance(tree.triangulation().input().index(v)));
}

namespace internal {

template <class Triangulation, class VertexPolarMap>
void put_logarithmic_map(const Vertex_logarithmic_map& map, const Triangulation& triangulation,
                         const typename Triangulation::Triangle_mesh& mesh, VertexPolarMap coordinates)
{
  for(const auto v : vertices(mesh))
    put(coordinates, v, map[triangulation.input().index(v)]);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Writes the polar coordinates of all vertices with respect to the source of a tree into a property map of the mesh.
 *
 * \param map the result of `logarithmic_map(tree)`
 * \param tree the tree
 * \param mesh the mesh of the tree
 * \param coordinates a model of `WritablePropertyMap` with the vertices of the mesh as keys and `Polar_coordinates` as
 *        values
 *
 * Complexity: linear in the number of vertices of the mesh.
 */
template <class Triangulation, class VertexPolarMap>
void put_logarithmic_map(const Vertex_logarithmic_map& map, const Geodesic_tree<Triangulation>& tree,
                         const typename Triangulation::Triangle_mesh& mesh, VertexPolarMap coordinates)
{
  static_assert(internal::is_property_map<VertexPolarMap>());
  internal::put_logarithmic_map(map, tree.triangulation(), mesh, coordinates);
}

/*!
 * \ingroup PkgFlipGeodesicsDistances
 *
 * Writes the distances of a field at the vertices of a mesh into a property map; unknown distances are written as
 * infinity.
 *
 * \param field a field that has been computed
 * \param triangulation the triangulation of the field
 * \param mesh the mesh of the field
 * \param distances a model of `WritablePropertyMap` with the vertices of the mesh as keys and `double`s as values
 * \throws Invalid_parameter_error if `Geodesic_distance_field::compute()` has not been called
 *
 * Complexity: linear in the number of vertices of the mesh.
 */
template <class Triangulation, class VertexDistanceMap>
void put_distances(const Geodesic_distance_field<Triangulation>& field, const Triangulation& triangulation,
                   const typename Triangulation::Triangle_mesh& mesh, VertexDistanceMap distances)
{
  static_assert(internal::is_property_map<VertexDistanceMap>());
  for(const auto v : vertices(mesh))
    put(distances, v, field.distance(triangulation.input().index(v)));
}

/// \ingroup PkgFlipGeodesicsDistances
/// Writes the number of the nearest source of each vertex into a property map, or 0 if the nearest source is not known.
/// The parameters are those of `put_distances()`, except that the values of the property map are integers.
/// \throws Invalid_parameter_error if `Geodesic_distance_field::compute()` has not been called
template <class Triangulation, class VertexSourceMap>
void put_nearest_sources(const Geodesic_distance_field<Triangulation>& field, const Triangulation& triangulation,
                         const typename Triangulation::Triangle_mesh& mesh, VertexSourceMap sources)
{
  static_assert(internal::is_property_map<VertexSourceMap>());
  for(const auto v : vertices(mesh))
    put(sources, v, field.answer(triangulation.input().index(v)).source);
}

namespace internal {

/* Values at the vertices of a mesh in the order of `vertices(mesh)`, with a report on them. */
template <class Value>
using Computed_values = Computed_output<Value, Distances_report>;

inline bool is_stopped_by_visitor(const Distances_report& report)
{
  return report.status == Shortening_status::STOPPED_BY_VISITOR;
}

template <class Map, class Key, class Value, class = void>
constexpr bool can_put = false;
template <class Map, class Key, class Value>
constexpr bool can_put<
    Map, Key, Value,
    std::void_t<decltype(put(std::declval<Map&>(), std::declval<const Key&>(), std::declval<const Value&>()))>> = true;

/* Writes values into a property map of the mesh, unless the visitor has stopped their computation. */
template <class TriangleMesh, class Value, class VertexMap>
void write_values(const TriangleMesh& mesh, const Computed_values<Value>& computed, VertexMap map)
{
  static_assert(is_property_map<VertexMap>());
  constexpr bool is_writable = can_put<VertexMap, Mesh_vertex<TriangleMesh>, Value>;
  static_assert(is_writable || is_container_with_keys<VertexMap>,
                "the property map must accept the values that the function computes");
  if(is_stopped_by_visitor(computed.report))
    return;
  auto value = computed.values.begin();
  for(const auto v : vertices(mesh))
    if constexpr(is_writable)
      put(map, v, *value++);
}

/* A property map that stores values in the order in which they are put. */
template <class Key, class Value>
struct Value_collector
{
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;

  std::vector<Value>* values;

  friend void put(const Value_collector& map, const Key&, const Value& value) { map.values->push_back(value); }
};

template <class Triangulation>
std::size_t most_windows(const Triangulation& triangulation, const Window_limit& limit)
{
  return limit(static_cast<std::size_t>(triangulation.input().number_of_vertices()));
}

/* Grows the tree of shortest paths from the source of a field, and collects the values that `write(tree, map)` puts. */
template <class Value, class Triangulation, class Visitor, class Write>
Computed_values<Value> make_shortest_tree(Triangulation& triangulation,
                                          const Geodesic_distance_field<Triangulation>& field, Vertex_index source,
                                          std::size_t most_windows, Visitor& visitor, const Write& write)
{
  Geodesic_tree<Triangulation> tree(triangulation);
  Computed_values<Value> result;
  result.report.status = tree.grow(source, parameters::visitor(std::ref(visitor))).status;
  if(!is_stopped_by_visitor(result.report)) {
    Interruption interruption(visitor);
    result.report = make_shortest(tree, query_of(field).propagation(), true, most_windows, interruption);
  }
  if(is_stopped_by_visitor(result.report))
    return result;
  if(result.report.status != Shortening_status::LOCALLY_SHORTEST && is_contraction_of_use(triangulation))
    throw Degenerate_face_error(
        "geodesics are bent, possibly at vertices that coincide because faces are degenerate; construct the "
        "triangulation with Zero_length_edges::CONTRACT",
        {});
  if(result.report.longer > 0)
    result.report.verdict = Verdict::UNDECIDED;
  write(tree, Value_collector<typename Triangulation::Mesh_vertex, Value>{&result.values});
  return result;
}

/* Returns the number of vertices with a finite distance that are not sources. */
template <class Triangulation, class Distances>
std::size_t number_of_finite(const Triangulation& triangulation, const Distances& distances)
{
  const auto all = descriptors<Vertex_index>(triangulation.input().number_of_vertices());
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](Vertex_index v) {
    return distances.distance(v) > 0 && distances.distance(v) < std::numeric_limits<double>::infinity();
  }));
}

/* Computes a field whose sources have been added, and reports on its distances. */
template <class Triangulation, class Visitor>
Distances_report compute_from_sources(Geodesic_distance_field<Triangulation>& field, const Triangulation& triangulation,
                                      const Window_limit& limit, Visitor& visitor)
{
  Distance_field_limits limits;
  limits.windows = limit;
  const Distance_field_report computed =
      field.compute(parameters::search_limit(limits), parameters::visitor(std::ref(visitor)));
  Distances_report report;
  if(computed.status == Distance_field_status::STOPPED_BY_VISITOR)
    report.status = Shortening_status::STOPPED_BY_VISITOR;
  report.windows = computed.windows;
  report.verdict = verdict_of_distances(computed.status == Distance_field_status::COMPLETE && !computed.has_flat_face &&
                                        !computed.has_inaccurate_distance);
  report.vertices = number_of_finite(triangulation, field);
  return report;
}

/* Writes the distances that a field or a search has computed. */
template <class Triangulation, class Distances>
void take_distances(const Distances& distances, const Triangulation& triangulation,
                    const typename Triangulation::Triangle_mesh& mesh, Computed_values<double>& result)
{
  result.values.clear();
  for(const auto v : vertices(mesh))
    result.values.push_back(distances.distance(triangulation.input().index(v)));
  result.report.vertices = number_of_finite(triangulation, distances);
}

/* Computes distances by a search with outward rounding, and uses them if all of them are confirmed. */
template <class Triangulation, class Visitor>
void search_distances(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                      const std::vector<Vertex_index>& sources, std::size_t most_windows, Visitor& visitor,
                      Computed_values<double>& result)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Interruption interruption(visitor);
  confirm_by_search(triangulation, sources, most_windows, [&](auto& search, std::size_t most) {
    const bool is_sound = run_to_the_end(search, infinity, most, &interruption);
    result.report.windows += search.number_of_windows();
    if(!is_sound || search.lower_bound() < infinity)
      return Search_outcome::INCOMPLETE;
    if(!are_bounds_close(search, search, triangulation.input().number_of_vertices(), infinity))
      return Search_outcome::UNCLEAR;
    result.report.verdict = verdict_of_distances(true);
    take_distances(search, triangulation, mesh, result);
    return Search_outcome::CONFIRMED;
  });
  if(interruption.has_occurred())
    result.report.status = Shortening_status::STOPPED_BY_VISITOR;
}

/* A source of distances: a vertex, or the locations of a curve; a single location is a point. */
struct Distance_source
{
  bool is_vertex;
  Vertex_index vertex;
  std::vector<Surface_location> locations;
};

/*
 * Computes the distances from sources by a field. If rounding errors may have changed them and all sources are
 * vertices, a search follows.
 */
template <class Triangulation, class Visitor>
Computed_values<double> field_distances(Geodesic_distance_field<Triangulation>& field,
                                        const Triangulation& triangulation,
                                        const typename Triangulation::Triangle_mesh& mesh,
                                        const std::vector<Distance_source>& sources, const Window_limit& limit,
                                        Visitor& visitor)
{
  std::vector<Vertex_index> vertices;
  for(const Distance_source& source : sources)
    if(source.is_vertex) {
      vertices.push_back(source.vertex);
      field.add_source(source.vertex);
    } else
      field.add_curve(source.locations);
  Computed_values<double> result;
  result.report = compute_from_sources(field, triangulation, limit, visitor);
  take_distances(field, triangulation, mesh, result);
  const bool is_complete = field.reach() == std::numeric_limits<double>::infinity();
  if(is_complete && !result.report.is_confirmed() && !is_stopped_by_visitor(result.report) &&
     vertices.size() == sources.size())
    search_distances(triangulation, mesh, vertices, most_windows(triangulation, limit), visitor, result);
  return result;
}

/*
 * Returns the logarithmic map of the source of a field, or nothing if the initial direction of a path is lost in
 * rounding errors.
 */
template <class Triangulation>
std::optional<Vertex_logarithmic_map> logarithmic_map_of_field(const Geodesic_distance_field<Triangulation>& field,
                                                               const Triangulation& triangulation, Vertex_index source)
{
  const Vertex_directions<Triangulation> directions(triangulation, source);
  Source_directions<Triangulation> starts(query_of(field));
  Vertex_logarithmic_map map(triangulation.number_of_vertices(), directions.total(), directions.has_border());
  for(Vertex_index v : descriptors<Vertex_index>(triangulation.input().number_of_vertices())) {
    Polar_coordinates& p = map[v];
    p.radius = field.distance(v);
    if(v == source || !(p.radius < std::numeric_limits<double>::infinity()))
      continue;
    const std::optional<Start_direction> start = starts(v);
    if(!start)
      return std::nullopt;
    p.angle = directions.of_input(start->first) + std::arg(start->direction);
    p.angle += !map.is_on_border() && p.angle < 0 ? map.total_angle() : 0;
  }
  return map;
}

/* Computes the polar coordinates of vertices by a field; returns no values unless all are confirmed. */
template <class Triangulation, class Visitor>
Computed_values<Polar_coordinates> field_coordinates(Geodesic_distance_field<Triangulation>& field,
                                                     const Triangulation& triangulation,
                                                     const typename Triangulation::Triangle_mesh& mesh,
                                                     Vertex_index source, const Window_limit& limit, Visitor& visitor)
{
  Computed_values<Polar_coordinates> result;
  field.add_source(source);
  result.report = compute_from_sources(field, triangulation, limit, visitor);
  if(!result.report.is_confirmed())
    return result;
  const std::optional<Vertex_logarithmic_map> map = logarithmic_map_of_field(field, triangulation, source);
  result.report.verdict = verdict_of_distances(map.has_value());
  if(map)
    put_logarithmic_map(*map, triangulation, mesh,
                        Value_collector<typename Triangulation::Mesh_vertex, Polar_coordinates>{&result.values});
  return result;
}

/* Converts a vertex, another surface point, a range of surface points, or a variant of these to a source. */
template <class Triangulation, class TriangleMesh, class Source>
Distance_source distance_source(const Triangulation& triangulation, const TriangleMesh& mesh,
                                Place_finder<Triangulation>& find, const Source& source)
{
  if constexpr(Is_variant<Source>::value)
    return std::visit([&](const auto& s) { return distance_source(triangulation, mesh, find, s); }, source);
  else if constexpr(is_mesh_vertex<TriangleMesh, Source>)
    return {true, triangulation.index(Mesh_vertex<TriangleMesh>(source)), {}};
  else if constexpr(is_place<Triangulation, TriangleMesh, Source>)
    return {false, {}, {find(source)}};
  else {
    static_assert(is_range<Source>, "a vertex of the mesh, another source or a range of sources is expected here; "
                                    "the order of the arguments is mesh, source, property map");
    Distance_source result = {false, {}, {}};
    if constexpr(is_range<Source>)
      for(const auto& place : source)
        result.locations.push_back(find(place));
    return result;
  }
}

template <class Triangulation, class TriangleMesh, class Sources>
std::vector<Distance_source> distance_sources(const Triangulation& triangulation, const TriangleMesh& mesh,
                                              const Sources& sources)
{
  constexpr bool is_one =
      is_mesh_vertex<TriangleMesh, Sources> || is_place<Triangulation, TriangleMesh, Sources> || !is_range<Sources>;
  std::vector<Distance_source> result;
  Place_finder<Triangulation> find(triangulation, mesh);
  if constexpr(is_one)
    result.push_back(distance_source(triangulation, mesh, find, sources));
  else
    for(const auto& source : sources)
      result.push_back(distance_source(triangulation, mesh, find, source));
  return result;
}

template <class TriangleMesh, class NamedParameters>
using Locate_sources = std::function<std::vector<Distance_source>(
    const typename Curve_types<TriangleMesh, NamedParameters>::Triangulation&)>;

/*
 * Returns the sources that `locate(triangulation)` finds. They are located once, on the mesh itself, and stored in
 * `given`, from which they are transferred to the contracted surface.
 */
template <class Triangulation, class Locate>
std::vector<Distance_source> sources_on_surface(const Triangulation& triangulation, const Locate& locate,
                                                std::vector<Distance_source>& given)
{
  if(!triangulation.input().is_contracted())
    return given = locate(triangulation);
  std::vector<Distance_source> result = given;
  for(Distance_source& source : result)
    for(Surface_location& at : source.locations)
      at = canonical_location(triangulation.input(), location_on_surface(triangulation, at));
  return result;
}

/* Returns the numbers of the nearest sources at the vertices of a mesh, in the order of `vertices(mesh)`. */
template <class Triangulation>
std::vector<std::size_t> nearest_sources(const Geodesic_distance_field<Triangulation>& field,
                                         const Triangulation& triangulation,
                                         const typename Triangulation::Triangle_mesh& mesh)
{
  std::vector<std::size_t> result;
  put_nearest_sources(field, triangulation, mesh,
                      Value_collector<typename Triangulation::Mesh_vertex, std::size_t>{&result});
  return result;
}

/* Keeps the confirmation of a result only if the mesh was neither rounded nor contracted with a loss of paths. */
template <class Triangulation, class Value>
Computed_values<Value> confirmed_of_mesh(const Triangulation& triangulation, Computed_values<Value>&& result)
{
  if(result.report.is_confirmed() && (has_lost_paths(triangulation.input()) || is_input_rounded(triangulation)))
    result.report.verdict = Verdict::UNDECIDED;
  return std::move(result);
}

/*
 * Implements `geodesic_distances()`, where a tree is the fallback for a single vertex, and `logarithmic_map()`; not
 * inline, like `compute_path()`. `nearest` receives the nearest sources unless it is null.
 */
template <class TriangleMesh, class NamedParameters>
Computed_values<double> compute_distances(const TriangleMesh& mesh,
                                          const Locate_sources<TriangleMesh, NamedParameters>& locate, bool is_single,
                                          std::vector<std::size_t>* nearest, const NamedParameters& np)
{
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  auto visitor = make_visitor(np);
  const auto limit = search_limit_of<Window_limit>(np);
  std::vector<Distance_source> given;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](Triangulation& triangulation) {
    const std::vector<Distance_source> sources = sources_on_surface(triangulation, locate, given);
    Geodesic_distance_field<Triangulation> field(triangulation, mesh,
                                                 parameters::extent(Distance_field_extent::VERTICES_ONLY));
    auto result = field_distances(field, triangulation, mesh, sources, limit, visitor.get());
    if(nearest != nullptr)
      *nearest = nearest_sources(field, triangulation, mesh);
    if(is_single && !result.report.is_confirmed() && !is_stopped_by_visitor(result.report))
      result = make_shortest_tree<double>(triangulation, field, sources.front().vertex,
                                          most_windows(triangulation, limit), visitor.get(),
                                          [&](const auto& tree, const auto& map) { put_distances(tree, mesh, map); });
    return confirmed_of_mesh(triangulation, std::move(result));
  });
}

template <class TriangleMesh, class NamedParameters>
Computed_values<Polar_coordinates> compute_logarithmic_map(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                                           const NamedParameters& np)
{
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  auto visitor = make_visitor(np);
  const auto limit = search_limit_of<Window_limit>(np);
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](Triangulation& triangulation) {
    const Vertex_index s = triangulation.index(source);
    Geodesic_distance_field<Triangulation> field(triangulation, mesh,
                                                 parameters::extent(Distance_field_extent::VERTICES_ONLY));
    auto result = field_coordinates(field, triangulation, mesh, s, limit, visitor.get());
    if(!result.report.is_confirmed() && !is_stopped_by_visitor(result.report))
      result = make_shortest_tree<Polar_coordinates>(
          triangulation, field, s, most_windows(triangulation, limit), visitor.get(),
          [&](const auto& tree, const auto& map) { put_logarithmic_map(logarithmic_map(tree), tree, mesh, map); });
    return confirmed_of_mesh(triangulation, std::move(result));
  });
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDistances
 *
 * Computes the distance of every vertex from one source or from the nearest of several sources.
 *
 * The distances are computed with a `Geodesic_distance_field`. Two fallbacks handle difficult input:
 * - A search with outward-rounded bounds, provided that all sources are vertices. It is run if the field encounters a
 *   face so close to degenerate that rays can be lost in it, or if rounding errors may have changed a distance by more
 *   than 1e-10 of its value.
 * - A tree of geodesics (`Geodesic_tree::grow()`), provided that the only source is a vertex that was passed by itself
 *   and not in a range. It is grown if the search does not confirm the distances, or if the field exceeds its limit.
 *   Unless the field exceeded its limit, paths of the tree are then replaced wherever shorter paths have been found
 *   (`make_shortest()`).
 *
 * \param mesh a triangle mesh
 * \param sources a single source that is not a curve, or a range of sources. The number of a source is its position in
 *        the range. If the range is empty, all distances are infinite. A source is one of the following, or a
 *        `std::variant` of several of these types:
 *        - a vertex of the mesh;
 *        - a point: a `CGAL::Polygon_mesh_processing::Face_location`, a `Surface_location`, or a point in space, for
 *          which `surface_location()` finds the nearest point of the mesh;
 *        - a curve: a range of vertices or of points; consecutive ones must lie in one face or on its boundary
 * \param distances a model of `WritablePropertyMap` with the vertices of the mesh as keys and `double`s as values.
 *        Vertices that are not connected to a source receive infinity. If degenerate edges had to be contracted,
 *        vertices that were connected to a source only by degenerate faces also receive infinity, and the distances are
 *        not confirmed. If a computation is aborted at its limit and the second fallback has grown a tree, the
 *        distances are the lengths of the paths of the tree. If it is aborted without a tree, unknown distances are
 *        infinite
 * \param np an optional sequence of named parameters among those listed below, and `vertex_point_map`, `metric` and
 *        `geom_traits` as for `geodesic_path()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the number of windows after which the field is aborted; this number also limits the
 *       searches of the fallbacks}
 *     \cgalParamType{`Window_limit`}
 *     \cgalParamDefault{`Window_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{nearest_source_map}
 *     \cgalParamDescription{a property map that receives, for each vertex, the number of the nearest source, or 0 if
 *       the distance is unknown}
 *     \cgalParamType{a model of `WritablePropertyMap` with the vertices of the mesh as keys and integers as values}
 *     \cgalParamDefault{no map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals, and whose `on_flip()` is
 *       called if a tree is grown}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If `go_further()` returns `false`, nothing is written into `distances`, and the report is
 *       unconfirmed and has the status `Shortening_status::STOPPED_BY_VISITOR`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the distances: the number of vertices other than sources that have been reached, and whether
 *         all distances are confirmed
 *
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Invalid_curve_error as `Geodesic_distance_field::add_curve()` does
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 *
 * Complexity: that of `Geodesic_distance_field::compute()`, plus that of `Geodesic_tree::grow()` and `make_shortest()`
 * if a tree is grown. If sources are points in space, a search tree over the \f$n\f$ faces is built in
 * \cgalBigO{n \log n} time, and locating each point that is close to the surface takes \cgalBigO{\log n} time.
 *
 * The search of the first fallback takes \cgalBigO{w \log w} time, where \f$w\f$ is the number of its windows; the
 * `Window_limit` bounds \f$w\f$ as it does for the field. If doubles are not accurate enough, the search is repeated in
 * double-double arithmetic, with at most twice as many windows.
 */
template <class TriangleMesh, class Sources = std::vector<Mesh_vertex<TriangleMesh>>, class VertexDistanceMap,
          class... NamedParameters>
Distances_report geodesic_distances(const TriangleMesh& mesh, const Sources& sources, VertexDistanceMap distances,
                                    const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::visitor_t, internal::Limit_parameter, internal::Nearest_source_parameter>(
          np...);
  constexpr bool has_map = internal::is_given<internal::Joined<NamedParameters...>, internal::Nearest_source_parameter>;
  std::vector<std::size_t> nearest;
  const auto locate = [&](const auto& triangulation) {
    return internal::distance_sources(triangulation, mesh, sources);
  };
  const auto computed = internal::compute_distances<TriangleMesh, internal::Joined<NamedParameters...>>(
      mesh, locate, internal::is_mesh_vertex<TriangleMesh, Sources>, has_map ? &nearest : nullptr, options);
  internal::write_values(mesh, computed, distances);
  if constexpr(has_map)
    internal::write_values(mesh, internal::Computed_values<std::size_t>{std::move(nearest), computed.report},
                           parameters::get_parameter(options, internal::nearest_source_parameter));
  return computed.report;
}

/*!
 * \ingroup PkgFlipGeodesicsTree
 *
 * Computes the logarithmic map of a vertex, that is, the length and initial direction of a shortest path to every other
 * vertex.
 *
 * The directions are angles on the surface in radians, counterclockwise, between 0 and the sum of the face angles
 * around the source. If the source is on the border, they are measured from the border. Otherwise, they are measured
 * from the halfedge `Logarithmic_map_result::halfedge()` of the result that a call with targets returns for the same
 * source; for a `Surface_mesh`, it is `opposite(halfedge(source, mesh), mesh)`.
 *
 * The map is computed with a `Geodesic_distance_field`. If the result of the field is not confirmed, a tree of
 * geodesics is grown, and its paths are made shortest, as in `geodesic_distances()`.
 *
 * \param mesh a triangle mesh
 * \param source a vertex of the mesh
 * \param coordinates a model of `WritablePropertyMap` with the vertices of the mesh as keys and `Polar_coordinates` as
 *        values
 * \param np the named parameters of `geodesic_distances()`, except `nearest_source_map`
 * \return a report: the number of vertices other than the source that have been reached, and whether the paths are
 *         confirmed to be shortest
 * \throws Vertex_out_of_range_error if `source` is not a vertex of the mesh
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 *
 * Complexity: that of `Geodesic_distance_field::compute()`, plus that of `Geodesic_tree::grow()` and `make_shortest()`
 * if a tree is grown.
 */
template <class TriangleMesh, class Source, class VertexPolarMap, class... NamedParameters,
          std::enable_if_t<(internal::is_named_parameters<NamedParameters> && ...), int> = 0>
Distances_report logarithmic_map(const TriangleMesh& mesh, const Source& source, VertexPolarMap coordinates,
                                 const NamedParameters&... np)
{
  static_assert(internal::is_mesh_vertex<TriangleMesh, Source>,
                "a vertex of the mesh is expected here; the order of the arguments is mesh, source, property map; for "
                "a source that is not a vertex, pass "
                "targets and an output, and include tangent_vectors.h");
  const auto& options = internal::surface_options<internal_np::visitor_t, internal::Limit_parameter>(np...);
  const auto computed = internal::compute_logarithmic_map(mesh, Mesh_vertex<TriangleMesh>(source), options);
  internal::write_values(mesh, computed, coordinates);
  return computed.report;
}

#ifdef CGAL_FLIP_GEODESICS_COMPILED
namespace internal {

#define CGAL_FLIP_GEODESICS_INSTANCES(Mesh)                                                                            \
  CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE Computed_values<double> compute_distances(                                    \
      const Mesh&, const Locate_sources<Mesh, parameters::Default_named_parameters>&, bool, std::vector<std::size_t>*, \
      const parameters::Default_named_parameters&);                                                                    \
  CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE Computed_values<Polar_coordinates> compute_logarithmic_map(                   \
      const Mesh&, Mesh_vertex<Mesh>, const parameters::Default_named_parameters&);
CGAL_FLIP_GEODESICS_FOR_COMPILED_MESHES(CGAL_FLIP_GEODESICS_INSTANCES)
#undef CGAL_FLIP_GEODESICS_INSTANCES

} // namespace internal
#endif

namespace internal {

/* A visitor of fields that are computed concurrently; the calling thread reports how many are finished. */
template <class Visitor>
class Progress_visitor
{
public:
  Progress_visitor(Visitor& visitor, std::size_t number)
    : m_visitor(visitor)
    , m_number(number)
  {
  }

  void finish_one() { ++m_finished; }

  bool go_further()
  {
    report_progress(m_visitor, m_finished, m_number);
    return m_visitor.go_further();
  }

private:
  Visitor& m_visitor;
  std::size_t m_number;
  std::atomic<std::size_t> m_finished{0};
};

/* The rows of a matrix of distances between points. Each row is computed from the diagonal on. */
template <class Triangulation>
class Distance_matrix_rows
{
  using Triangle_mesh = typename Triangulation::Triangle_mesh;
  using Field = Geodesic_distance_field<Triangulation>;

public:
  Distance_matrix_rows(const Triangulation& triangulation, const Triangle_mesh& mesh,
                       std::vector<Surface_location> points, const Window_limit& limit)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_points(std::move(points))
    , m_limit(limit)
    , m_extent(std::all_of(m_points.begin(), m_points.end(), is_vertex) ? Distance_field_extent::VERTICES_ONLY
                                                                        : Distance_field_extent::EVERYWHERE)
  {
  }

  /* Computes all rows in any order; a field is destroyed when its row is complete. */
  template <class ConcurrencyTag, class Visitor>
  Computed_values<std::vector<double>> compute(Visitor& visitor) const
  {
    Computed_values<std::vector<double>> result;
    result.values.assign(m_points.size(), std::vector<double>(m_points.size(), 0));
    std::vector<Distance_field_report> reports(m_points.size());
    Progress_visitor<Visitor> progress(visitor, m_points.size());
    Interruption interruption(progress);
    Shared_interruption shared(interruption);
    for_each_index<ConcurrencyTag>(m_points.size(), [&](std::size_t i) {
      if(i + 1 < m_points.size() && shared.go_further())
        reports[i] = compute_row(i, shared, result.values[i]);
      progress.finish_one();
    });
    interruption.begin_part();
    mirror(result.values);
    summarize(reports, interruption, result);
    return result;
  }

private:
  static bool is_vertex(const Surface_location& at) { return kind(at) == Location_kind::VERTEX; }

  Distance_field_report compute_row(std::size_t i, Shared_interruption& shared, std::vector<double>& row) const
  {
    Field field(m_triangulation, m_mesh, parameters::extent(m_extent));
    field.add_source(m_points[i]);
    Distance_field_limits limits;
    limits.windows = m_limit;
    const auto next = m_points.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    limits.targets.assign(next, m_points.end());
    const Distance_field_report report =
        field.compute(parameters::search_limit(limits), parameters::visitor(std::ref(shared)));
    std::transform(next, m_points.end(), row.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   [&](const Surface_location& at) { return field.distance(at); });
    return report;
  }

  static void mirror(std::vector<std::vector<double>>& rows)
  {
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        rows[i][j] = rows[j][i];
  }

  static bool is_confirmed(const Distance_field_report& report)
  {
    return (report.status == Distance_field_status::COMPLETE ||
            report.status == Distance_field_status::TARGETS_REACHED) &&
           !report.has_flat_face && !report.has_inaccurate_distance;
  }

  static void summarize(const std::vector<Distance_field_report>& reports, const Interruption& interruption,
                        Computed_values<std::vector<double>>& result)
  {
    for(const Distance_field_report& report : reports)
      result.report.windows += report.windows;
    for(std::size_t i = 0; i < result.values.size(); ++i)
      result.report.vertices += static_cast<std::size_t>(
          std::count_if(result.values[i].begin() + static_cast<std::ptrdiff_t>(i) + 1, result.values[i].end(),
                        [](double distance) { return std::isfinite(distance); }));
    result.report.verdict =
        verdict_of_distances(!interruption.has_occurred() && std::all_of(reports.begin(), reports.end(), is_confirmed));
    if(interruption.has_occurred())
      result.report.status = Shortening_status::STOPPED_BY_VISITOR;
  }

  const Triangulation& m_triangulation;
  const Triangle_mesh& m_mesh;
  std::vector<Surface_location> m_points;
  Window_limit m_limit;
  Distance_field_extent m_extent;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDistances
 *
 * Computes the distances on the surface between all pairs of given points, as the rows of a symmetric matrix with zero
 * diagonal.
 *
 * For \f$i < j\f$, the entries \f$(i, j)\f$ and \f$(j, i)\f$ are both the distance of point \f$j\f$ in the
 * `Geodesic_distance_field` of point \f$i\f$. If the report is confirmed, all distances are exact up to rounding
 * errors. The field of point \f$i\f$ is computed until it reaches all later points, and is destroyed when row
 * \f$i\f$ is complete. The function therefore requires the memory of one field per thread, plus that of the matrix.
 * The result does not depend on the number of threads.
 *
 * \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the program must be linked to
 *         TBB for `Parallel_tag`
 *
 * \param mesh a triangle mesh
 * \param points a range of vertices of the mesh, of `CGAL::Polygon_mesh_processing::Face_location`s, of
 *        `Surface_location`s, of points in space, or of `std::variant`s of several of these. `surface_location()`
 *        describes how points are snapped, and which point of the mesh represents a point in space
 * \param rows an output iterator that receives a `std::vector<double>` for each point, in the order of the points. The
 *        entry of a pair of points is infinite if the points lie in different components, or if the field was aborted
 *        at its limit before it reached the other point
 * \param np an optional sequence of named parameters among those listed below, and `vertex_point_map`, `metric` and
 *        `geom_traits` as for `geodesic_path()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{search_limit}
 *     \cgalParamDescription{the number of windows after which a field is aborted}
 *     \cgalParamType{`Window_limit`}
 *     \cgalParamDefault{`Window_limit()`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called at regular intervals from the calling thread}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If the visitor has a member `on_progress()`, it is called before each call of `go_further()` with
 *       the fraction of complete rows, a `double` from 0 to 1. If `go_further()` returns `false`, no row is written,
 *       and the report is unconfirmed and has the status `Shortening_status::STOPPED_BY_VISITOR`.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the distances: the number of pairs whose distance is finite (in the member `vertices`), the
 *         number of windows of all fields, and whether all distances are confirmed
 * \throws Vertex_out_of_range_error if a point given as a vertex is not a vertex of the mesh
 * \throws Invalid_location_error if a point does not lie on the mesh
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 *
 * Complexity: for \f$k\f$ points, that of \f$k - 1\f$ calls of `Geodesic_distance_field::compute()`, each of which ends
 * at the farthest of the later points. The matrix takes \cgalBigO{k^2} memory. Locating \f$k\f$ points in space takes
 * \cgalBigO{n \log n + k \log n} time, where \f$n\f$ is the number of faces of the mesh, if the points lie close to the
 * surface.
 *
 * \sa `geodesic_distances()`
 */
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh, class PointRange, class OutputIterator,
          class... NamedParameters>
Distances_report geodesic_distance_matrix(const TriangleMesh& mesh, const PointRange& points, OutputIterator rows,
                                          const NamedParameters&... np)
{
  using Options = internal::Joined<NamedParameters...>;
  using Triangulation = typename internal::Curve_types<TriangleMesh, Options>::Triangulation;
  static_assert(
      internal::is_range<PointRange>,
      "a range of points is expected here; the order of the arguments is mesh, points, output, named parameters");
  const auto& options = internal::surface_options<internal_np::visitor_t, internal::Limit_parameter>(np...);
  const auto limit = internal::search_limit_of<Window_limit>(options);
  auto visitor = internal::make_visitor(options);
  const auto locate = [&](const Triangulation& triangulation) {
    std::vector<internal::Distance_source> result;
    internal::Place_finder<Triangulation> find(triangulation, mesh);
    for(const auto& point : points)
      result.push_back({false, {}, {find(point)}});
    return result;
  };
  std::vector<internal::Distance_source> given;
  const auto compute = [&](Triangulation& triangulation) {
    std::vector<Surface_location> locations;
    for(const internal::Distance_source& source : internal::sources_on_surface(triangulation, locate, given))
      locations.push_back(source.locations.front());
    const internal::Distance_matrix_rows<Triangulation> matrix(triangulation, mesh, std::move(locations), limit);
    return internal::confirmed_of_mesh(triangulation, matrix.template compute<ConcurrencyTag>(visitor.get()));
  };
  auto computed = internal::compute_on_surface(internal::Mesh_surfaces(mesh, options), compute);
  if(!internal::is_stopped_by_visitor(computed.report))
    std::move(computed.values.begin(), computed.values.end(), rows);
  return computed.report;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_GEODESIC_DISTANCES_H
