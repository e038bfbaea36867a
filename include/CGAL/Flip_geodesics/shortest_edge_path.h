// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
#define CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H

#include <CGAL/Flip_geodesics/Landmark_distances.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/Sparse_array.h>
#include <CGAL/Flip_geodesics/internal/Vertex_queue.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsRef
/// How an edge path is searched.
enum class Search_method {
  /// A path that is to be pulled tight: close to a shortest one on the surface, rather than shortest along edges. The
  /// distance of a vertex is measured along straight lines from up to two vertices back on the path to it, and not as
  /// less than the path's length over 1.5. So paths that zigzag along a straight line count as nearly straight, where
  /// shortest edge paths swerve to where the edges happen to point; `shorten()` flips several times fewer edges on
  /// smooth meshes. The bound for the remaining way counts 1.05 times, so that the search does not compare ways that
  /// are
  /// all nearly as short, and visits about half of the vertices that `A_STAR` does. The same as `DIJKSTRA` where the
  /// metric
  /// has no lower bound.
  LOOK_BACK,
  A_STAR,  ///< a shortest edge path, towards the target by the metric's lower bound; as `DIJKSTRA` where that is zero
  DIJKSTRA ///< a shortest edge path, in all directions
};

/*!
 * \ingroup PkgFlipGeodesicsRef
 *
 * Searches paths along the edges of the input mesh, which is where curves usually start from: shortest ones, or such as
 * are soon pulled tight. It reads the input alone and touches no triangulation.
 *
 * The labels are made once and told apart by epoch, so that a search costs what it visits: \f$O(k \log k)\f$ for
 * \f$k\f$ vertices visited. Of equally long paths the same one is found each time.
 *
 * \tparam Triangulation an `Intrinsic_triangulation`
 */
template <class Triangulation>
class Shortest_edge_path
{
public:
  explicit Shortest_edge_path(const Triangulation& triangulation, Search_method method = Search_method::A_STAR)
    : m_triangulation(&triangulation)
    , m_method(method)
    , m_haste(method == Search_method::LOOK_BACK ? haste : 1)
    , m_labels(static_cast<std::size_t>(triangulation.input().number_of_vertices()))
  {
  }

  /// Looks back and is directed by landmarks, which have to live as long; the bound counts 1.02 times then, since it is
  /// nearly met. \pre they were made for this mesh
  Shortest_edge_path(const Triangulation& triangulation, const Landmark_distances& landmarks)
    : Shortest_edge_path(triangulation, Search_method::LOOK_BACK)
  {
    CGAL_precondition(landmarks.number_of_vertices() ==
                      static_cast<std::size_t>(triangulation.input().number_of_vertices()));
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
  std::vector<Index> operator()(Index source, Index target)
  {
    check_vertex(source);
    check_vertex(target);
    start(source);
    direct(source, target);
    for(Index v = settle_next(); v != null_index; v = settle_next()) {
      if(v == target)
        return path_to(target);
      relax_neighbors(v);
    }
    throw Disconnected_endpoints_error("no path of edges joins vertex " + std::to_string(source) + " and vertex " +
                                           std::to_string(target),
                                       {static_cast<std::size_t>(source), static_cast<std::size_t>(target)});
  }

  /*!
   * Calls `visit(v, distance)` for each vertex to which paths lead from `source`, with its distance as this search
   * measures it: in the order of distance.
   * \throws Vertex_out_of_range_error, Invalid_coordinate_error as above
   */
  template <class Visit>
  void visit_all(Index source, const Visit& visit)
  {
    check_vertex(source);
    start(source);
    for(Index v = settle_next(); v != null_index; v = settle_next()) {
      visit(v, m_labels[v].distance);
      relax_neighbors(v);
    }
  }

  /// The triangulation whose input is searched.
  const Triangulation& triangulation() const { return *m_triangulation; }

  /// The number of vertices that the last search settled.
  std::size_t settled_vertices() const { return m_settled; }

private:
  using Place = typename Triangulation::Metric::Place;

  struct Label
  {
    double distance;
    Index incoming; // the halfedge through which the path arrives
    Index stamp;    // m_epoch if reached, m_epoch + 1 if settled
  };

  // A vertex on the path to the one that is being settled, and what is known of the way from there.
  struct Ancestor
  {
    Place place;
    double distance; // of the ancestor
    double length;   // of the path on from it
  };

  static constexpr bool has_bound = !std::is_empty<Place>::value;
  static constexpr std::size_t most_ancestors = 2;
  // Zigzag along a straight line is longer by 2 / sqrt(3) at most on a regular triangulation, by sqrt(2) on a grid.
  static constexpr double most_zigzag = 1.5;
  // What the bound is multiplied by. Landmarks give bounds that are nearly met.
  static constexpr double haste = 1.05, haste_with_landmarks = 1.02;

  void check_vertex(Index v) const
  {
    if(v < 0 || v >= m_triangulation->input().number_of_vertices())
      throw Vertex_out_of_range_error("vertex " + std::to_string(v) + " is not one of the mesh's " +
                                          std::to_string(m_triangulation->input().number_of_vertices()) + " vertices",
                                      {static_cast<std::size_t>(v)});
  }

  void start(Index source)
  {
    m_target = null_index;
    m_is_bounded = false;
    m_epoch += 2;
    m_settled = 0;
    m_queue.clear();
    m_labels.writable(source) = {0, null_index, m_epoch};
    m_queue.push(0, source);
  }

  void direct(Index source, Index target)
  {
    if(m_method == Search_method::DIJKSTRA)
      return;
    const auto& metric = m_triangulation->metric();
    m_target = target;
    m_target_place = metric.place(m_triangulation->input(), target);
    m_is_bounded =
        has_bound &&
        std::isfinite(metric.distance_lower_bound(metric.place(m_triangulation->input(), source), m_target_place));
  }

  // The next vertex, `null_index` if there is none.
  Index settle_next()
  {
    while(!m_queue.empty()) {
      const Index v = m_queue.pop();
      if(m_labels[v].stamp == m_epoch + 1)
        continue; // has been reached on a shorter way since
      m_labels.writable(v).stamp = m_epoch + 1;
      ++m_settled;
      return v;
    }
    return null_index;
  }

  void relax_neighbors(Index v)
  {
    const auto& input = m_triangulation->input();
    const Label label = m_labels[v];
    const Index first = label.incoming == null_index ? input.outgoing(v) : Triangulation::twin(label.incoming);
    if(first == null_index)
      return;
    collect_ancestors(label);
    Index h = first;
    do {
      relax(v, label.distance, h);
      h = input.next(Triangulation::twin(h)); // along the border, too
    } while(h != first);
  }

  void collect_ancestors(const Label& label)
  {
    m_number_of_ancestors = 0;
    if(!has_bound || m_method != Search_method::LOOK_BACK)
      return;
    const auto& input = m_triangulation->input();
    const auto& metric = m_triangulation->metric();
    double length = 0;
    Index incoming = label.incoming;
    while(incoming != null_index && m_number_of_ancestors < most_ancestors) {
      const Index a = input.tail(incoming);
      length += metric.weight(input, incoming);
      m_ancestors[m_number_of_ancestors++] = {metric.place(input, a), m_labels[a].distance, length};
      incoming = m_labels[a].incoming;
    }
  }

  void relax(Index v, double distance_of_v, Index h)
  {
    const auto& input = m_triangulation->input();
    const auto& metric = m_triangulation->metric();
    const Index w = input.tail(Triangulation::twin(h));
    const Label& label = m_labels[w];
    if(label.stamp == m_epoch + 1)
      return;
    const double weight = metric.weight(input, h);
    if(!(weight >= 0) || std::isinf(weight))
      internal::throw_unusable_length(weight, v, w);
    const Place place = metric.place(input, w);
    const double distance = distance_looking_back(place, distance_of_v + weight, weight);
    if(label.stamp == m_epoch && label.distance <= distance)
      return;
    m_labels.writable(w) = {distance, h, m_epoch};
    m_queue.push(distance + bound_to_target(w, place), w);
  }

  double bound_to_target(Index v, const Place& place) const
  {
    double bound = m_is_bounded ? m_triangulation->metric().distance_lower_bound(place, m_target_place) : 0;
    if(m_landmarks != nullptr && m_target != null_index)
      bound = (std::max)(bound, m_landmarks->distance_lower_bound(v, m_target));
    return m_haste * bound;
  }

  // The distance of a vertex, or what it is from an ancestor on if that is less.
  double distance_looking_back(const Place& place, double distance, double weight) const
  {
    for(std::size_t i = 0; i < m_number_of_ancestors; ++i) {
      const Ancestor& a = m_ancestors[i];
      const double straight = m_triangulation->metric().distance_lower_bound(a.place, place);
      distance = (std::min)(distance, a.distance + (std::max)(straight, (a.length + weight) / most_zigzag));
    }
    return distance;
  }

  std::vector<Index> path_to(Index target) const
  {
    std::vector<Index> path;
    for(Index h = m_labels[target].incoming; h != null_index; h = m_labels[m_triangulation->input().tail(h)].incoming)
      path.push_back(h);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const Triangulation* m_triangulation;
  Search_method m_method;
  double m_haste;
  internal::Sparse_array<Label> m_labels;
  internal::Vertex_queue m_queue;
  std::array<Ancestor, most_ancestors> m_ancestors = {};
  std::size_t m_number_of_ancestors = 0;
  const Landmark_distances* m_landmarks = nullptr;
  Index m_target = null_index; // none if the search goes in all directions
  Place m_target_place = Place();
  bool m_is_bounded = false; // by the metric
  Index m_epoch = 0;
  std::size_t m_settled = 0;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_EDGE_PATH_H
