// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_LANDMARK_DISTANCES_H
#define CGAL_FLIP_GEODESICS_LANDMARK_DISTANCES_H

#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The distances of all vertices from 16 landmarks, which are vertices far from one another. Made once for many searches
 * on one mesh, they direct them round bumps and holes: by the triangle inequality, two vertices are not closer to each
 * other than their distances from a landmark differ [Goldberg, Harrelson, Computing the shortest path: A* search meets
 * graph theory]. That is more than the line through space, and is there for metrics without points, too.
 *
 * They serve pairs of vertices of the component that has the most. They take 32 bytes a vertex, and may be read by
 * several threads at once.
 */
class Landmark_distances
{
public:
  /*!
   * Chooses the landmarks, each the vertex that is farthest from those before, and measures the distances.
   *
   * Complexity: 18 searches over the whole mesh, \f$O(n \log n)\f$.
   *
   * \param search a `Shortest_edge_path`, which measures the distances: by `Search_method::LOOK_BACK`, if they are to
   *        direct such searches
   * \throws Invalid_coordinate_error as `Shortest_edge_path`, for any edge
   */
  template <class Search>
  explicit Landmark_distances(Search& search)
    : m_rows(static_cast<std::size_t>(search.triangulation().input().number_of_vertices()))
  {
    make(search);
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
    : m_rows(static_cast<std::size_t>(search.triangulation().input().number_of_vertices()))
  {
    internal::Interruption interruption(visitor);
    make(search, &interruption);
  }

  /// Returns whether the distances are known; they are not if a visitor stopped the construction.
  bool is_complete() const { return m_is_complete; }

  /// The number of vertices.
  std::size_t number_of_vertices() const { return m_rows.size(); }

  /// A lower bound of the distance of two vertices, as nearly as the distances have been measured.
  double distance_lower_bound(Vertex_index v, Vertex_index w) const
  {
    const Row &a = m_rows[v], &b = m_rows[w];
    int largest = 1; // the distances have been rounded down
    for(std::size_t i = 0; i < number_of_landmarks; ++i)
      largest = (std::max)(largest, std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i])));
    return m_unit * (largest - 1);
  }

private:
  static constexpr std::size_t number_of_landmarks = 16;
  using Row = std::array<std::uint16_t, number_of_landmarks>; // in units of m_unit

  template <class Search, class... Interruptions>
  void make(Search& search, Interruptions*... interruption)
  {
    try {
      if(!m_rows.empty())
        choose_landmarks(search, vertex_of_largest_component(search, interruption...), interruption...);
    } catch(const internal::Interrupted&) {
      std::fill(m_rows.begin(), m_rows.end(), Row()); // all of which say nothing
      m_is_complete = false;
    }
  }

  template <class Search, class Visit, class... Interruptions>
  static void visit_all(Search& search, Vertex_index source, const Visit& visit, Interruptions*... interruption)
  {
    (internal::throw_if_interrupted_before_part(interruption), ...);
    if(!search.visit_vertices(source, visit, interruption...))
      throw internal::Interrupted();
  }

  template <class Search, class... Interruptions>
  Vertex_index vertex_of_largest_component(Search& search, Interruptions*... interruption) const
  {
    internal::Indexed_by<Vertex_index, std::vector<char>> is_reached(m_rows.size(), 0);
    Vertex_index best(0);
    std::size_t most = 0;
    for(Vertex_index v : internal::descriptors<Vertex_index>(static_cast<Index>(m_rows.size()))) {
      if(is_reached[v] != 0)
        continue;
      visit_all(
          search, v, [&](Vertex_index w, double) { is_reached[w] = 1; }, interruption...);
      if(search.settled_vertices() > most) {
        most = search.settled_vertices();
        best = v;
      }
    }
    return best;
  }

  template <class Search, class... Interruptions>
  void choose_landmarks(Search& search, Vertex_index start, Interruptions*... interruption)
  {
    internal::Indexed_by<Vertex_index, std::vector<double>> nearest(
        m_rows.size(), -1); // how far the nearest landmark is; -1 outside the component
    Vertex_index landmark = start;
    double radius = 0;
    const auto find_farthest = [&](Vertex_index v, double distance) {
      nearest[v] = (std::numeric_limits<double>::max)();
      if(distance > radius) {
        radius = distance;
        landmark = v;
      }
    };
    visit_all(search, start, find_farthest, interruption...);
    // Twice the radius is more than all distances, but for what looking back makes of them.
    constexpr double largest = (std::numeric_limits<std::uint16_t>::max)();
    m_unit = radius > 0 ? 2 * radius / largest : 1;
    for(std::size_t i = 0; i < number_of_landmarks; ++i) {
      const auto measure = [&](Vertex_index v, double distance) {
        m_rows[v][i] = static_cast<std::uint16_t>((std::min)(distance / m_unit, largest));
        nearest[v] = (std::min)(nearest[v], distance);
      };
      visit_all(search, landmark, measure, interruption...);
      landmark = Vertex_index(static_cast<Index>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin()));
    }
  }

  internal::Indexed_by<Vertex_index, std::vector<Row>> m_rows;
  double m_unit = 1;
  bool m_is_complete = true;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_LANDMARK_DISTANCES_H
