// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LANDMARK_DISTANCES_H
#define CGAL_FLIP_GEODESICS_LANDMARK_DISTANCES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_choice.h>
#include <CGAL/Flip_geodesics/internal/distances/Landmark_rows.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>

#include <cstddef>

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
    try {
      const internal::Landmark_choice choice(search, interruption);
      m_rows = internal::Landmark_rows(m_number_of_vertices, number_of_landmarks, choice.largest_distance());
      choice.far_vertices(search, number_of_landmarks,
                          [&](std::size_t i, Vertex_index v, double distance) { m_rows.set(v, i, distance); });
    } catch(const internal::Interrupted&) {
      m_rows = internal::Landmark_rows(); // all bounds are zero
      m_is_complete = false;
    }
  }

  std::size_t m_number_of_vertices = 0;
  internal::Landmark_rows m_rows;
  bool m_is_complete = true;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_LANDMARK_DISTANCES_H
