// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_CHOICE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_CHOICE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
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
 * It asks for distances along edges alone, which take a small part of the time of the sweeps. So all sets are known
 * before the first sweep, and sweeps do not wait for each other.
 */
class Landmark_choice
{
public:
  using Set = std::vector<Vertex_index>;

  /* Finds the components. \param search by `Search_method::DIJKSTRA`, over the whole mesh \throws Interrupted, as all
   * functions that search */
  template <class Search>
  explicit Landmark_choice(Search& search, Interruption* interruption = nullptr)
    : m_interruption(interruption)
    , m_component(static_cast<std::size_t>(search.triangulation().input().number_of_vertices()), none)
  {
    m_order.reserve(m_component.size());
    for(Vertex_index v : descriptors<Vertex_index>(number_of_vertices())) {
      if(m_component[v] != none)
        continue;
      const Index component = static_cast<Index>(m_last.size());
      visit_all(search, v, [&](Vertex_index w, double distance) {
        m_component[w] = component;
        m_order.push_back(w);
        m_radius = (std::max)(m_radius, distance);
      });
      m_last.push_back(m_order.back());
    }
  }

  /* All vertices: of each component from its first one on, in the order of distance. */
  const std::vector<Vertex_index>& order() const { return m_order; }

  /* No two vertices of a component are farther apart along edges. */
  double largest_distance() const { return 2 * m_radius * (1 + landmark_radius_rounding); }

  /* So many sets, or less if no component has as many vertices: each vertex is the farthest from those before. */
  template <class Search>
  std::vector<Set> far_vertices(Search& search, std::size_t number) const
  {
    std::vector<Set> sets;
    Distances nearest(m_component.size(), std::numeric_limits<double>::infinity());
    while(sets.size() < number) {
      Set next = sets.empty() ? m_last : farthest(search, sets.back(), nearest);
      if(next.empty())
        break;
      sets.push_back(std::move(next));
    }
    return sets;
  }

  /* Sets of the given vertices, whatever their order, each once. \throws Vertex_out_of_range_error */
  std::vector<Set> given_vertices(Set given) const
  {
    for(Vertex_index v : given)
      check_vertex(v, number_of_vertices());
    std::sort(given.begin(), given.end());
    given.erase(std::unique(given.begin(), given.end()), given.end());
    std::vector<Set> sets;
    std::vector<std::size_t> taken(m_last.size(), 0); // of each component
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

  // In each component that has a vertex that is no landmark yet. \param nearest how far landmarks are, but for the last
  template <class Search>
  Set farthest(Search& search, const Set& last, Distances& nearest) const
  {
    for(Vertex_index v : last)
      visit_all(search, v, [&](Vertex_index w, double distance) { nearest[w] = (std::min)(nearest[w], distance); });
    std::vector<double> most(m_last.size(), 0);
    Set best(m_last.size(), null_index);
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
  Set m_last; // of the order, in each component
  double m_radius = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_CHOICE_H
