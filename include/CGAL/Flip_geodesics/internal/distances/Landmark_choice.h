// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_CHOICE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_CHOICE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/check_vertex.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Chooses landmarks, in sets that have one vertex of a component at most: a sweep starts from a whole set.
 *
 * The choice depends on distances along edges alone. For `Landmark_distances` these are the values themselves. For
 * `Geodesic_landmarks` they take a small part of the time of the sweeps, and since all sets are known before the first
 * sweep, sweeps do not wait for each other.
 */
class Landmark_choice
{
public:
  using Set = std::vector<Vertex_index>;

  /* Finds the components. \param search over the whole mesh \throws Interrupted, as all functions that search */
  template <class Search>
  explicit Landmark_choice(Search& search, Interruption* interruption = nullptr)
    : m_interruption(interruption)
    , m_component(static_cast<std::size_t>(search.triangulation().input().number_of_vertices()), none)
  {
    m_order.reserve(m_component.size());
    for(Vertex_index v : descriptors<Vertex_index>(number_of_vertices())) {
      if(m_component[v] != none)
        continue;
      const Index component = static_cast<Index>(m_farthest.size());
      Vertex_index farthest = v;
      double radius = 0;
      visit_all(search, v, [&](Vertex_index w, double distance) {
        m_component[w] = component;
        m_order.push_back(w);
        if(distance > radius) {
          radius = distance;
          farthest = w;
        }
      });
      m_farthest.push_back(farthest);
      m_radius = (std::max)(m_radius, radius);
    }
  }

  /* All vertices: of each component from its first one on, in the order of distance. */
  const std::vector<Vertex_index>& order() const { return m_order; }

  /* No two vertices of a component are farther apart along edges, if `search` measures the distances along edges. */
  double largest_distance() const { return 2 * m_radius * (1 + landmark_radius_rounding); }

  /*
   * So many sets, or less if no component has as many vertices: each vertex is the farthest from those before.
   * `record(i, v, distance)` is called for each vertex of the components that have a vertex in set `i`, with its
   * distance from that vertex.
   */
  template <class Search, class Record>
  std::vector<Set> far_vertices(Search& search, std::size_t number, const Record& record) const
  {
    std::vector<Set> sets;
    Distances nearest(m_component.size(), std::numeric_limits<double>::infinity()); // landmark
    for(Set next = m_farthest; sets.size() < number && !next.empty(); next = farthest(nearest)) {
      for(Vertex_index v : next)
        visit_all(search, v, [&](Vertex_index w, double distance) {
          nearest[w] = (std::min)(nearest[w], distance);
          record(sets.size(), w, distance);
        });
      sets.push_back(std::move(next));
    }
    return sets;
  }

  /* The same sets alone. */
  template <class Search>
  std::vector<Set> far_vertices(Search& search, std::size_t number) const
  {
    return far_vertices(search, number, [](std::size_t, Vertex_index, double) {});
  }

  /* Sets of the given vertices, whatever their order, each once. \throws Vertex_out_of_range_error */
  std::vector<Set> given_vertices(Set given) const
  {
    for(Vertex_index v : given)
      check_vertex(v, number_of_vertices());
    std::sort(given.begin(), given.end());
    given.erase(std::unique(given.begin(), given.end()), given.end());
    std::vector<Set> sets;
    std::vector<std::size_t> taken(m_farthest.size(), 0); // of each component
    for(Vertex_index v : given) {
      const std::size_t i = taken[static_cast<std::size_t>(m_component[v])]++;
      if(i == sets.size())
        sets.emplace_back();
      sets[i].push_back(v);
    }
    return sets;
  }

private:
  using Distances = Indexed_by<Vertex_index, std::vector<double>>;

  static constexpr Index none = -1;

  Index number_of_vertices() const { return static_cast<Index>(m_component.size()); }

  template <class Search, class Visit>
  void visit_all(Search& search, Vertex_index source, const Visit& visit) const
  {
    throw_if_interrupted_before_part(m_interruption);
    if(!search.visit_vertices(source, visit, m_interruption))
      throw Interrupted();
  }

  // In each component that has a vertex that is not a landmark yet.
  Set farthest(const Distances& nearest) const
  {
    std::vector<double> most(m_farthest.size(), 0);
    Set best(m_farthest.size(), null_index);
    for(Vertex_index v : descriptors<Vertex_index>(number_of_vertices())) {
      const std::size_t component = static_cast<std::size_t>(m_component[v]);
      if(nearest[v] > most[component]) {
        most[component] = nearest[v];
        best[component] = v;
      }
    }
    best.erase(std::remove(best.begin(), best.end(), Vertex_index(null_index)), best.end());
    return best;
  }

  Interruption* m_interruption; // null if it cannot be interrupted
  Indexed_by<Vertex_index, std::vector<Index>> m_component;
  std::vector<Vertex_index> m_order;
  Set m_farthest; // from the first vertex of each component; of equally far ones, the first that is visited
  double m_radius = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_CHOICE_H
