// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
#define CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Stores the distances of all vertices from landmarks, to guide searches for edge paths. Landmarks are vertices far
 * from one another, up to 16 in each component of the mesh.
 *
 * Landmarks can be computed once and used for many searches on one mesh. By the triangle inequality, the difference of
 * the distances of two vertices from a landmark is a lower bound on the distance between the two vertices
 * \cgalCite{GH05}. Unlike the distance in space, this bound also exists for metrics without points. The class
 * `Geodesic_landmarks` provides bounds on distances on the surface instead of distances along edges.
 *
 * The distances take 32 bytes per vertex, and can be read by several threads concurrently.
 */
class Landmark_distances
{
public:
  /*!
   * Chooses the landmarks and computes the distances. In each component, the first landmark is the vertex farthest from
   * the first vertex of the component, and each further landmark is the vertex farthest from the previous ones.
   *
   * \param search a `Shortest_edge_path`, which computes the distances. With `Search_method::DIJKSTRA` or
   *        `Search_method::A_STAR`, these are the lengths of shortest edge paths. With `Search_method::LOOK_BACK`, they
   *        estimate distances on the surface
   * \param np an optional named parameter `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is
   *        called, before each search and about once per thousand vertices. If it returns `false`, `is_complete()`
   *        returns `false`, and all bounds are zero
   * \throws Invalid_coordinate_error if the length of an edge is negative or not finite
   *
   * Complexity: 17 searches over the whole mesh, each in \cgalBigO{n \log n} time for \f$n\f$ vertices.
   */
  template <class Search, class... NamedParameters>
  explicit Landmark_distances(Search& search, const NamedParameters&... np)
  {
    m_is_complete = internal::result_unless_stopped(
        internal::options_of<internal_np::visitor_t>(np...),
        [&](internal::Interruption* interruption) { return make(search, interruption); });
    if(!m_is_complete)
      m_rows = internal::Landmark_rows(); // all bounds are zero
  }

  /// Returns whether the construction was completed; a visitor can stop it.
  bool is_complete() const { return m_is_complete; }

  /// Returns the number of vertices of the mesh.
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  /*!
   * Returns a lower bound on the distance between two vertices.
   *
   * If the distances from landmarks are lengths of edge paths, no edge path between the vertices is shorter than the
   * bound, even with rounding errors. If the distances were computed by `Search_method::LOOK_BACK`, the bound is an
   * estimate, since these distances need not satisfy the triangle inequality.
   *
   * The result is meaningless for vertices of different components.
   */
  double distance_lower_bound(Vertex_index v, Vertex_index w) const { return m_rows.distance_lower_bound(v, w); }

private:
  static constexpr std::size_t number_of_landmarks = 16; // of a component

  // \throws Interrupted
  template <class Search>
  bool make(Search& search, internal::Interruption* interruption)
  {
    m_number_of_vertices = static_cast<std::size_t>(search.triangulation().input().number_of_vertices());
    const internal::Landmark_choice choice(search, interruption);
    m_rows = internal::Landmark_rows(m_number_of_vertices, number_of_landmarks, choice.largest_distance());
    choice.far_vertices(search, number_of_landmarks,
                        [&](std::size_t i, Vertex_index v, double distance) { m_rows.set(v, i, distance); });
    return true;
  }

  std::size_t m_number_of_vertices = 0;
  internal::Landmark_rows m_rows;
  bool m_is_complete = true;
};

/// \ingroup PkgFlipGeodesicsBuilders
/// Specifies the method of a search for an edge path.
enum class Search_method {
  /// an any-angle search \cgalCite{NKT10} for a path that will be shortened. The path is usually close to a shortest
  /// path on the surface, but need not be shortest along edges.
  ///
  /// The search measures lengths along edges, except that the last two or three edges of a path are replaced by a
  /// straight line if this line is shorter. The length of such a line is the lower bound of the metric on the distance
  /// between its ends, but at least two thirds of the length of the replaced edges.
  ///
  /// Paths that zigzag along a straight line thus count as nearly straight. On smooth meshes, `shorten()` flips several
  /// times as many edges after a search for a shortest edge path as after this search.
  ///
  /// The lower bound on the remaining distance is multiplied by 1.1 (weighted A*), so that paths of nearly equal length
  /// need not be compared. The number of visited vertices is typically 20 to 60 % of that of `A_STAR`. If the metric
  /// has no lower bound and no landmarks are given, the method is equivalent to `DIJKSTRA`.
  LOOK_BACK,
  /// a search for a shortest edge path, guided towards the target by the lower bound of the metric; equivalent to
  /// `DIJKSTRA` if this bound is zero
  A_STAR,
  DIJKSTRA ///< a search in all directions for a shortest edge path
};

namespace internal {

enum Search_method_parameter { search_method_parameter };

} // namespace internal
} // namespace Flip_geodesics

namespace parameters {

/// \ingroup PkgFlipGeodesicsParameters
/// Sets the method of a search for edge paths.
inline auto search_method(Flip_geodesics::Search_method method)
{
  return Named_function_parameters<Flip_geodesics::Search_method, Flip_geodesics::internal::Search_method_parameter>(
      method);
}

} // namespace parameters

namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Searches for paths along the edges of the input mesh. Such paths are the usual initial curves of `shorten()`. A
 * search reads only the input, and does not change the triangulation.
 *
 * A search takes \cgalBigO{k \log k} time, where \f$k\f$ is the number of vertices that it visits. If several paths
 * have equal length, the search always finds the same one.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Shortest_edge_path
{
public:
  /*!
   * Constructs a search on the input of a triangulation.
   *
   * \param triangulation the triangulation, which must outlive the search
   * \param np an optional sequence of named parameters among those listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{search_method}
   *     \cgalParamDescription{the method of the search}
   *     \cgalParamType{`Search_method`}
   *     \cgalParamDefault{`Search_method::A_STAR`, or `Search_method::LOOK_BACK` if landmarks are given}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{landmarks}
   *     \cgalParamDescription{landmarks that guide the search. With landmarks, the lower bound is multiplied by only
   *       1.02, since it is close to the distance}
   *     \cgalParamType{`Landmark_distances`}
   *     \cgalParamDefault{no landmarks}
   *     \cgalParamPrecondition{the landmarks were computed for this mesh, and the method is `Search_method::LOOK_BACK`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws Input_mismatch_error if the landmarks were computed for a mesh with a different number of vertices
   */
  template <class... NamedParameters>
  explicit Shortest_edge_path(const Triangulation& triangulation, const NamedParameters&... np)
    : m_triangulation(&triangulation)
    , m_search(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
    const auto& options = internal::options_of<internal::Search_method_parameter, internal::Landmarks_parameter>(np...);
    m_landmarks = internal::landmarks_of<Landmark_distances>(options);
    const Search_method standard = m_landmarks != nullptr ? Search_method::LOOK_BACK : Search_method::A_STAR;
    m_method =
        parameters::choose_parameter(parameters::get_parameter(options, internal::search_method_parameter), standard);
    m_looks_back = has_bound && m_method == Search_method::LOOK_BACK;
    m_bound_weight = m_method != Search_method::LOOK_BACK
                         ? 1
                         : (m_landmarks != nullptr ? bound_weight_with_landmarks : bound_weight);
    if(m_landmarks == nullptr)
      return;
    CGAL_precondition(m_method == Search_method::LOOK_BACK);
    const std::size_t expected = m_landmarks->number_of_vertices();
    const std::size_t number = static_cast<std::size_t>(triangulation.input().number_of_vertices());
    if(expected != number)
      throw Input_mismatch_error("the landmarks were computed for a mesh of " + std::to_string(expected) +
                                 " vertices, not of " + std::to_string(number));
  }

  /*!
   * Returns the halfedges of an edge path from `source` to `target`, or no halfedges if the two vertices are equal.
   *
   * \param source, target vertices of the input
   * \param np an optional named parameter `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is
   *        called, about once per thousand vertices. If it returns `false`, the search ends and returns no halfedges
   * \throws Vertex_out_of_range_error if `source` or `target` is not a vertex of the input
   * \throws Disconnected_endpoints_error if no edge path connects the vertices
   * \throws Invalid_coordinate_error if the length of an edge that the search visits is negative or not finite. Edges
   *         of length zero are accepted here, but `shorten()` rejects those that it encounters
   */
  template <class... NamedParameters>
  std::vector<Halfedge_index> operator()(Vertex_index source, Vertex_index target, const NamedParameters&... np)
  {
    return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...),
                                           [&](auto* interruption) { return path(source, target, interruption); });
  }

  /*!
   * Calls `visit(v, distance)` for each vertex that is reachable from `source`, with its distance as measured by this
   * search. The vertices are visited in the order in which the search settles them. Except with
   * `Search_method::LOOK_BACK`, this is the order of increasing distance.
   *
   * \param source a vertex of the input
   * \param visit a function object
   * \param np an optional named parameter `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is
   *        called, about once per thousand vertices. If it returns `false`, the remaining vertices are not visited
   * \return whether all reachable vertices have been visited
   * \throws Vertex_out_of_range_error if `source` is not a vertex of the input
   * \throws Invalid_coordinate_error if the length of an edge that the search visits is negative or not finite
   */
  template <class Visit, class... NamedParameters>
  bool visit_all(Vertex_index source, const Visit& visit, const NamedParameters&... np)
  {
    return internal::result_unless_stopped(
        internal::options_of<internal_np::visitor_t>(np...),
        [&](auto* interruption) { return visit_vertices(source, visit, interruption); });
  }

#ifndef DOXYGEN_RUNNING
  // For searches that are parts of a computation, with its interruption.

  std::vector<Halfedge_index> path(Vertex_index source, Vertex_index target, internal::Interruption* interruption)
  {
    internal::check_vertex(source, m_triangulation->input().number_of_vertices(), "the source");
    internal::check_vertex(target, m_triangulation->input().number_of_vertices(), "the target");
    start(source);
    direct(source, target);
    bool is_found = false;
    const bool is_complete = run([&](Vertex_index v) {
      is_found = v == target;
      return !is_found && !internal::is_interrupted(interruption);
    });
    if(is_found)
      return path_to(target);
    if(!is_complete)
      return {};
    internal::throw_disconnected(source, target);
  }

  template <class Visit>
  bool visit_vertices(Vertex_index source, const Visit& visit, internal::Interruption* interruption)
  {
    internal::check_vertex(source, m_triangulation->input().number_of_vertices());
    start(source);
    return run([&](Vertex_index v) {
      visit(v, m_search[v].distance);
      return !internal::is_interrupted(interruption);
    });
  }
#endif // DOXYGEN_RUNNING

  /// Returns the triangulation whose input is searched.
  const Triangulation& triangulation() const { return *m_triangulation; }

  /// Returns the number of vertices that the last search settled.
  std::size_t settled_vertices() const { return m_search.number_of_settled(); }

private:
  using Place = typename Triangulation::Metric::Place;
  using Search_labels = internal::Search_labels<Input_halfedge_index>;
  using Search_label = Search_labels::Label;

  // A vertex on the path to the vertex being settled, with the distances needed to look back to it.
  struct Ancestor
  {
    Place place;
    double distance; // of the ancestor; infinite if it does not exist
    double length;   // of the path from it
  };

  static constexpr std::size_t most_ancestors = 2;
  using Ancestors = std::array<Ancestor, most_ancestors>;

  // A vertex whose neighbors are reached through it; a copy, which is not affected by changes during the search.
  struct Origin
  {
    Vertex_index vertex;
    double distance;
    Input_halfedge_index incoming;
    Place place;
    Ancestors ancestors;
  };

  struct Step
  {
    double distance;
    double weight; // of the edge
    Place place;
  };

  static constexpr bool has_bound = !std::is_empty<Place>::value;
  // A zigzag along a straight line is longer by at most 2 / sqrt(3) on a regular triangulation, and sqrt(2) on a grid.
  static constexpr double most_zigzag = 1.5;
  // The factors of the bound (weighted A*). Landmarks provide bounds that are nearly attained.
  static constexpr double bound_weight = 1.1, bound_weight_with_landmarks = 1.02;
  // A path that is shorter by less than this fraction of its last edge does not advance a vertex in the queue.
  static constexpr double least_gain = 0.2;

  void start(Vertex_index source)
  {
    m_target = null_index;
    m_is_bounded = false;
    m_least_gain = 0;
    m_search.clear();
    m_search.add_source(source);
  }

  void direct(Vertex_index source, Vertex_index target)
  {
    if(m_method == Search_method::DIJKSTRA)
      return;
    const auto& metric = m_triangulation->metric();
    m_target = target;
    m_least_gain = m_looks_back ? least_gain : 0;
    m_target_place = metric.place(m_triangulation->input(), target);
    m_is_bounded =
        has_bound &&
        std::isfinite(metric.distance_lower_bound(metric.place(m_triangulation->input(), source), m_target_place));
  }

  // The policy of the search. `visit(v)` is called for each vertex that is settled; the search continues if it returns
  // `true`.
  template <bool LooksBack, class Visit>
  class Policy : public internal::Search_policy
  {
  public:
    Policy(const Shortest_edge_path& paths, const Visit& visit)
      : m_paths(paths)
      , m_visit(visit)
    {
    }

    bool settle(Vertex_index v) const { return m_visit(v); }

    Origin origin(Vertex_index v, const Search_label& label) const
    {
      const Input_halfedge_index incoming = label.incoming();
      const Place place = m_paths.m_triangulation->metric().place(m_paths.m_triangulation->input(), v);
      if constexpr(LooksBack)
        return {v, label.distance, incoming, place, m_paths.ancestors_of(incoming, place)};
      else
        return {v, label.distance, incoming, place, {}};
    }

    // Omits the halfedge back to the predecessor, which is settled.
    template <class Function>
    void for_each_halfedge(const Origin& origin, const Function& function) const
    {
      const bool is_source = origin.incoming == null_index;
      const Input_halfedge_index first =
          is_source ? m_paths.m_triangulation->input().outgoing(origin.vertex) : internal::twin_index(origin.incoming);
      if(first == null_index)
        return;
      Input_halfedge_index h = is_source ? first : m_paths.next_around(first);
      do {
        function(h);
        h = m_paths.next_around(h);
      } while(h != first);
    }

    Vertex_index head(Input_halfedge_index h) const
    {
      return m_paths.m_triangulation->input().tail(internal::twin_index(h));
    }

    Step step(const Origin& origin, Input_halfedge_index h, Vertex_index w) const
    {
      const auto& input = m_paths.m_triangulation->input();
      const auto& metric = m_paths.m_triangulation->metric();
      const Place place = metric.place(input, w);
      const double weight = metric.weight(input, h, origin.place, place);
      if(!(weight >= 0 && weight <= (std::numeric_limits<double>::max)()))
        internal::throw_unusable_length(weight, origin.vertex, w);
      if constexpr(LooksBack)
        return {m_paths.distance_looking_back(origin, place, weight), weight, place};
      else
        return {origin.distance + weight, weight, place};
    }

    bool is_put_forward(const Step& step, const Search_label& label) const
    {
      return label.distance - step.distance >= m_paths.m_least_gain * step.weight;
    }

    double key(Vertex_index w, const Step& step) const
    {
      return step.distance + m_paths.bound_to_target(w, step.place);
    }

  private:
    const Shortest_edge_path& m_paths;
    const Visit& m_visit;
  };

  // Returns whether all vertices were visited.
  template <class Visit>
  bool run(const Visit& visit)
  {
    return m_looks_back ? m_search.run(Policy<true, Visit>(*this, visit))
                        : m_search.run(Policy<false, Visit>(*this, visit));
  }

  // Along the border, too.
  Input_halfedge_index next_around(Input_halfedge_index h) const
  {
    return m_triangulation->input().next(internal::twin_index(h));
  }

  // \param at is the place of the vertex that the halfedge leads to
  Ancestors ancestors_of(Input_halfedge_index incoming, Place at) const
  {
    const auto& input = m_triangulation->input();
    const auto& metric = m_triangulation->metric();
    Ancestors result;
    result.fill({Place(), std::numeric_limits<double>::infinity(), 0});
    double length = 0;
    for(std::size_t i = 0; i < most_ancestors && incoming != null_index; ++i) {
      const Vertex_index a = input.tail(incoming);
      const Place place = metric.place(input, a);
      length += metric.weight(input, incoming, place, at);
      const Search_label& label = m_search[a];
      result[i] = {place, label.distance, length};
      at = place;
      incoming = label.incoming();
    }
    return result;
  }

  double bound_to_target(Vertex_index v, const Place& place) const
  {
    double bound = m_is_bounded ? m_triangulation->metric().distance_lower_bound(place, m_target_place) : 0;
    if(m_landmarks != nullptr && m_target != null_index)
      bound = (std::max)(bound, m_landmarks->distance_lower_bound(v, m_target));
    return internal::unfused(m_bound_weight * bound);
  }

  // Returns the distance of a neighbor, or that measured from an ancestor if it is smaller.
  double distance_looking_back(const Origin& origin, const Place& place, double weight) const
  {
    double distance = origin.distance + weight;
    for(const Ancestor& a : origin.ancestors) {
      const double straight = m_triangulation->metric().distance_lower_bound(a.place, place);
      distance = (std::min)(
          distance, a.distance + (std::max)(straight, internal::unfused((a.length + weight) * (1 / most_zigzag))));
    }
    return distance;
  }

  std::vector<Halfedge_index> path_to(Vertex_index target) const
  {
    return m_search.template path<Halfedge_index>(
        target, [this](Input_halfedge_index h) { return m_triangulation->input().tail(h); });
  }

  const Triangulation* m_triangulation;
  Search_method m_method = Search_method::A_STAR;
  bool m_looks_back = false;
  double m_bound_weight = 1;
  internal::Label_setting_search<Search_labels> m_search;
  const Landmark_distances* m_landmarks = nullptr;
  Vertex_index m_target = null_index; // null if the search proceeds in all directions
  Place m_target_place = Place();
  bool m_is_bounded = false; // by the metric
  double m_least_gain = 0;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
