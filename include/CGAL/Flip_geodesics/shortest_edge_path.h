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
#include <CGAL/Flip_geodesics/metrics.h>

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
 * The distances of all vertices along edges from landmarks, which are vertices far from one another: up to 16 in each
 * component of the mesh. Computed once for many searches on one mesh, they direct the searches around bumps and holes.
 * By the triangle inequality, the difference of the distances of two vertices from a landmark is a lower bound of their
 * own distance [Goldberg, Harrelson, Computing the shortest path: A* search meets graph theory]. This bound is larger
 * than the distance in space on most meshes, and exists for metrics without points, too. `Geodesic_landmarks` provide
 * the same for distances on the surface.
 *
 * They take 32 bytes per vertex, and can be read by several threads at once.
 */
class Landmark_distances
{
public:
  /*!
   * Chooses the landmarks, each the vertex of its component that is farthest from those before, and measures the
   * distances.
   *
   * Complexity: 17 searches over the whole mesh, \f$O(n \log n)\f$.
   *
   * \param search a `Shortest_edge_path`, which measures the distances. By `Search_method::DIJKSTRA` or
   *        `Search_method::A_STAR`, these are the lengths of shortest edge paths. By `Search_method::LOOK_BACK`, they
   *        are estimates of the distances on the surface, for landmarks that are to direct such searches
   * \throws Invalid_coordinate_error as `Shortest_edge_path`, for any edge
   */
  template <class Search>
  explicit Landmark_distances(Search& search)
  {
    make(search, nullptr);
  }

  /*!
   * Chooses the landmarks and measures the distances, and lets a visitor stop that.
   *
   * \param search as above
   * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, before each search and once for
   *        about a thousand vertices. If it returns `false`, then `is_complete()` returns `false`, and all bounds are
   *        zero
   * \throws as above
   */
  template <class Search, class Visitor>
  Landmark_distances(Search& search, Visitor&& visitor)
  {
    internal::Interruption interruption(visitor);
    make(search, &interruption);
  }

  /// Returns whether the distances are known; they are not if a visitor stopped the construction.
  bool is_complete() const { return m_is_complete; }

  /// The number of vertices.
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  /*!
   * Returns a lower bound of the distance of two vertices. If the distances from landmarks were measured along edges,
   * then no edge path between the vertices is shorter: values and differences are rounded down, and rounding errors are
   * subtracted. If they were measured by `Search_method::LOOK_BACK`, then the bound is an estimate, since such
   * distances do not satisfy the triangle inequality. The result is any number for vertices of two components, between
   * which there is no path.
   */
  double distance_lower_bound(Vertex_index v, Vertex_index w) const { return m_rows.distance_lower_bound(v, w); }

private:
  static constexpr std::size_t number_of_landmarks = 16; // of a component

  template <class Search>
  void make(Search& search, internal::Interruption* interruption)
  {
    m_number_of_vertices = static_cast<std::size_t>(search.triangulation().input().number_of_vertices());
    m_is_complete = internal::result_unless_interrupted([&] {
      const internal::Landmark_choice choice(search, interruption);
      m_rows = internal::Landmark_rows(m_number_of_vertices, number_of_landmarks, choice.largest_distance());
      choice.far_vertices(search, number_of_landmarks,
                          [&](std::size_t i, Vertex_index v, double distance) { m_rows.set(v, i, distance); });
      return true;
    });
    if(!m_is_complete)
      m_rows = internal::Landmark_rows(); // all bounds are zero
  }

  std::size_t m_number_of_vertices = 0;
  internal::Landmark_rows m_rows;
  bool m_is_complete = true;
};

/// \ingroup PkgFlipGeodesicsBuilders
/// How an edge path is searched.
enum class Search_method {
  /// A path that is to be pulled tight: close to a shortest one on the surface, rather than shortest along edges. The
  /// distance of a vertex is measured along straight lines from up to two vertices back on the path to it. It is not
  /// taken as less than the path's length over 1.5. So paths that zigzag along a straight line count as nearly
  /// straight, where shortest edge paths swerve to where the edges happen to point. `shorten()` flips several times
  /// fewer edges on smooth meshes. The bound for the remaining way counts 1.1 times: the search does not compare ways
  /// that are all nearly as short. A vertex that is reached again on a way that is hardly shorter keeps its turn. About
  /// a third of the vertices are visited that `A_STAR` visits. The same as `DIJKSTRA` where the metric has no lower
  /// bound.
  LOOK_BACK,
  A_STAR,  ///< a shortest edge path, towards the target by the metric's lower bound; as `DIJKSTRA` where that is zero
  DIJKSTRA ///< a shortest edge path, in all directions
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Searches paths along the edges of the input mesh, which is where curves usually start from: shortest ones, or such as
 * are soon pulled tight. It reads the input alone and touches no triangulation.
 *
 * The labels are made once and told apart by epoch, so that a search costs what it visits: \f$O(k \log k)\f$ for
 * \f$k\f$ vertices visited. Of equally long paths the same one is found each time.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Shortest_edge_path
{
public:
  /// Searches on the input of a triangulation, which must outlive the search, by a method.
  explicit Shortest_edge_path(const Triangulation& triangulation, Search_method method = Search_method::A_STAR)
    : m_triangulation(&triangulation)
    , m_method(method)
    , m_looks_back(has_bound && method == Search_method::LOOK_BACK)
    , m_haste(method == Search_method::LOOK_BACK ? haste : 1)
    , m_search(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
  }

  /// Looks back and is directed by landmarks, which have to live as long; the bound counts 1.02 times then, since it is
  /// nearly met. \pre they were made for this mesh \throws Input_mismatch_error if it has more vertices, or fewer
  Shortest_edge_path(const Triangulation& triangulation, const Landmark_distances& landmarks)
    : Shortest_edge_path(triangulation, Search_method::LOOK_BACK)
  {
    const std::size_t expected = landmarks.number_of_vertices();
    const std::size_t number = static_cast<std::size_t>(triangulation.input().number_of_vertices());
    if(expected != number)
      throw Input_mismatch_error("the landmarks were made for a mesh of " + std::to_string(expected) +
                                 " vertices, not of " + std::to_string(number));
    m_landmarks = &landmarks;
    m_haste = haste_with_landmarks;
  }

  /*!
   * The halfedges of an edge path from `source` to `target`; none if they are equal.
   * \throws Vertex_out_of_range_error
   * \throws Disconnected_endpoints_error
   * \throws Invalid_coordinate_error for an edge that the search meets and whose length is negative or no number; edges
   *         of length zero are passed here, and refused where the curve is straightened over them
   */
  std::vector<Halfedge_index> operator()(Vertex_index source, Vertex_index target) { return path(source, target); }

  /*!
   * Searches the same path, and lets a visitor stop the search.
   * \param source, target as above
   * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, once for about a thousand
   *        vertices. If it returns `false`, then the search ends there and returns no halfedges
   * \throws as above
   */
  template <class Visitor>
  std::vector<Halfedge_index> operator()(Vertex_index source, Vertex_index target, Visitor&& visitor)
  {
    internal::Interruption interruption(visitor);
    return path(source, target, &interruption);
  }

  /*!
   * Calls `visit(v, distance)` for each vertex to which paths lead from `source`, with its distance as this search
   * measures it: in the order of distance.
   * \throws Vertex_out_of_range_error, Invalid_coordinate_error as above
   */
  template <class Visit>
  void visit_all(Vertex_index source, const Visit& visit)
  {
    visit_vertices(source, visit);
  }

  /*!
   * Does the same, and lets a visitor stop the search.
   * \param source, visit as above
   * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, once for about a thousand
   *        vertices. If it returns `false`, then the remaining vertices are not visited
   * \return whether all vertices have been visited
   * \throws as above
   */
  template <class Visit, class Visitor>
  bool visit_all(Vertex_index source, const Visit& visit, Visitor&& visitor)
  {
    internal::Interruption interruption(visitor);
    return visit_vertices(source, visit, &interruption);
  }

#ifndef DOXYGEN_RUNNING
  // For searches that are parts of a computation, with its `internal::Interruption*`, which may be null, or without.

  template <class... Interruptions>
  std::vector<Halfedge_index> path(Vertex_index source, Vertex_index target, Interruptions*... interruption)
  {
    internal::check_vertex(source, m_triangulation->input().number_of_vertices());
    internal::check_vertex(target, m_triangulation->input().number_of_vertices());
    start(source);
    direct(source, target);
    bool is_found = false;
    const bool is_complete = run([&](Vertex_index v) {
      is_found = v == target;
      return !is_found && !internal::is_interrupted(interruption...);
    });
    if(is_found)
      return path_to(target);
    if(!is_complete)
      return {};
    throw Disconnected_endpoints_error(
        "no path of edges joins vertex " + std::to_string(source.idx()) + " and vertex " + std::to_string(target.idx()),
        {static_cast<std::size_t>(source.idx()), static_cast<std::size_t>(target.idx())});
  }

  template <class Visit, class... Interruptions>
  bool visit_vertices(Vertex_index source, const Visit& visit, Interruptions*... interruption)
  {
    internal::check_vertex(source, m_triangulation->input().number_of_vertices());
    start(source);
    return run([&](Vertex_index v) {
      visit(v, m_search[v].distance);
      return !internal::is_interrupted(interruption...);
    });
  }
#endif // DOXYGEN_RUNNING

  /// The triangulation whose input is searched.
  const Triangulation& triangulation() const { return *m_triangulation; }

  /// The number of vertices that the last search settled.
  std::size_t settled_vertices() const { return m_search.number_of_settled(); }

private:
  using Place = typename Triangulation::Metric::Place;
  using Search_labels = internal::Search_labels<Input_halfedge_index>;
  using Search_label = Search_labels::Label;

  // A vertex on the path to the one that is being settled, and what is known of the way from there.
  struct Ancestor
  {
    Place place;
    double distance; // of the ancestor; infinite if there is none
    double length;   // of the path on from it
  };

  static constexpr std::size_t most_ancestors = 2;
  using Ancestors = std::array<Ancestor, most_ancestors>;

  // A vertex whose neighbors are reached through it; a copy, which nothing that is written meanwhile can change.
  struct Origin
  {
    Vertex_index vertex;
    double distance;
    Input_halfedge_index incoming;
    Place place;
    Ancestors ancestors;
  };

  // To a neighbor.
  struct Step
  {
    double distance;
    double weight; // of the edge
    Place place;
  };

  static constexpr bool has_bound = !std::is_empty<Place>::value;
  // Zigzag along a straight line is longer by 2 / sqrt(3) at most on a regular triangulation, by sqrt(2) on a grid.
  static constexpr double most_zigzag = 1.5;
  // What the bound is multiplied by. Landmarks give bounds that are nearly met.
  static constexpr double haste = 1.1, haste_with_landmarks = 1.02;
  // A way that is shorter by less than this part of its last edge does not put a vertex forward in the queue.
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

  // The policy of the search. `visit(v)` is called for each vertex that is settled; the search goes on if it returns
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
        return {v, label.distance, incoming, place, m_paths.ancestors_of(incoming)};
      else
        return {v, label.distance, incoming, place, {}};
    }

    // But for the one back to where the path came from, which is settled.
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

  Ancestors ancestors_of(Input_halfedge_index incoming) const
  {
    const auto& input = m_triangulation->input();
    const auto& metric = m_triangulation->metric();
    Ancestors result;
    result.fill({Place(), std::numeric_limits<double>::infinity(), 0});
    double length = 0;
    for(std::size_t i = 0; i < most_ancestors && incoming != null_index; ++i) {
      const Vertex_index a = input.tail(incoming);
      length += metric.weight(input, incoming);
      const Search_label& label = m_search[a];
      result[i] = {metric.place(input, a), label.distance, length};
      incoming = label.incoming();
    }
    return result;
  }

  double bound_to_target(Vertex_index v, const Place& place) const
  {
    double bound = m_is_bounded ? m_triangulation->metric().distance_lower_bound(place, m_target_place) : 0;
    if(m_landmarks != nullptr && m_target != null_index)
      bound = (std::max)(bound, m_landmarks->distance_lower_bound(v, m_target));
    return internal::unfused(m_haste * bound);
  }

  // The distance of a neighbor, or what it is from an ancestor on if that is less.
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
  Search_method m_method;
  bool m_looks_back;
  double m_haste;
  internal::Label_setting_search<Search_labels> m_search;
  const Landmark_distances* m_landmarks = nullptr;
  Vertex_index m_target = null_index; // none if the search goes in all directions
  Place m_target_place = Place();
  bool m_is_bounded = false; // by the metric
  double m_least_gain = 0;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
