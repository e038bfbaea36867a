// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * For each vertex a row of values, one for each of several functions. The values of a function at two vertices differ
 * by at most their distance plus an error of the function, so the differences are lower bounds on the distance.
 *
 * A value is a number of units rounded down, in two bytes. A difference is therefore lowered by one unit, and by
 * another one for the error of these divisions, which is far smaller, as is the error of distances along edges, which
 * are sums of fewer than 2^31 lengths with relative rounding errors of 2^-53 each: at most 2^-6 units in two vertices.
 */
class Landmark_rows
{
public:
  Landmark_rows() = default;

  /* \param largest the largest relevant value; larger ones are stored as this one */
  Landmark_rows(std::size_t number_of_vertices, std::size_t number_of_functions, double largest)
    : m_unit(largest > 0 ? largest / largest_number : 1)
    , m_losses(number_of_functions, rounding_loss)
    , m_numbers(number_of_vertices * number_of_functions, unknown)
  {
  }

  std::size_t number_of_functions() const { return m_losses.size(); }

  /* Sets the error of the values of a function, at two vertices together. */
  void set_error(std::size_t i, double error)
  {
    m_losses[i] = static_cast<std::uint16_t>((std::min)(rounding_loss + std::ceil(error / m_unit), largest_number));
  }

  /* Sets a value; values that are not set, or are infinite, have no effect. */
  void set(Vertex_index v, std::size_t i, double value)
  {
    const double number = (std::min)((std::max)(value / m_unit, 0.0), largest_number);
    m_numbers[static_cast<std::size_t>(v.idx()) * m_losses.size() + i] = static_cast<std::uint16_t>(number);
  }

  bool has_row(Vertex_index v) const { return static_cast<std::size_t>(v.idx()) * m_losses.size() < m_numbers.size(); }

  /* Returns a lower bound on the length of a path between the vertices. It is arbitrary for vertices of two
   * components. */
  double distance_lower_bound(Vertex_index v, Vertex_index w) const
  {
    const std::uint16_t *const a = row(v), *const b = row(w), *const losses = m_losses.data();
    const std::size_t n = m_losses.size(), end_of_blocks = n - n % block_size;
    std::array<std::uint16_t, block_size> largest = {}; // at each position in a block
    for(std::size_t start = 0; start < end_of_blocks; start += block_size)
      for(std::size_t i = 0; i < block_size; ++i)
        largest[i] = (std::max)(largest[i], bound(a[start + i], b[start + i], losses[start + i]));
    for(std::size_t i = end_of_blocks; i < n; ++i)
      largest[0] = (std::max)(largest[0], bound(a[i], b[i], losses[i]));
    std::uint16_t result = 0;
    for(std::size_t i = 0; i < block_size; ++i)
      result = (std::max)(result, largest[i]);
    return m_unit * result;
  }

private:
  static constexpr std::uint16_t all_bits = 65535, unknown = all_bits;
  static constexpr double largest_number = unknown - 1;
  static constexpr std::uint16_t rounding_loss = 2;
  static constexpr std::size_t block_size = 8; // numbers in a vector register

  // Of a distance, in units. Branch-free arithmetic in 16 bits is compiled into vector instructions.
  static std::uint16_t bound(std::uint16_t a, std::uint16_t b, std::uint16_t loss)
  {
    const std::uint16_t high = (std::max)(a, b), low = (std::min)(a, b);
    const std::uint16_t difference = static_cast<std::uint16_t>(high - low);
    const std::uint16_t lowered = static_cast<std::uint16_t>((std::max)(difference, loss) - loss);
    return static_cast<std::uint16_t>(lowered & (high == unknown ? 0 : all_bits));
  }

  const std::uint16_t* row(Vertex_index v) const
  {
    return m_numbers.data() + static_cast<std::size_t>(v.idx()) * m_losses.size();
  }

  double m_unit = 1;
  std::vector<std::uint16_t> m_losses; // of each function, in units
  std::vector<std::uint16_t> m_numbers;
};

/*
 * Chooses landmarks in sets with at most one vertex of each component, since one propagation starts from a whole set.
 *
 * The choice depends on distances along edges alone. For `Landmark_distances` these are the values themselves. For
 * `Geodesic_landmarks` they take a small part of the time of the propagations and, since all sets are known in advance,
 * the propagations can run concurrently.
 */
class Landmark_choice
{
public:
  using Set = std::vector<Vertex_index>;

  /* Finds the components. \param search over the whole mesh \throws Interrupted, like all functions that search */
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

  /* Returns all vertices: for each component from its first vertex on, in order of distance. */
  const std::vector<Vertex_index>& order() const { return m_order; }

  /* Returns a bound on the distance along edges between two vertices of a component, if `search` measures these
   * distances. */
  double largest_distance() const { return 2 * m_radius * (1 + landmark_radius_rounding); }

  /*
   * Returns `number` sets, or fewer if no component has as many vertices; each vertex is the farthest from the previous
   * ones. `record(i, v, distance)` is called for each vertex of the components that have a vertex in set `i`, with its
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

  /* Returns the same sets without recording distances. */
  template <class Search>
  std::vector<Set> far_vertices(Search& search, std::size_t number) const
  {
    return far_vertices(search, number, [](std::size_t, Vertex_index, double) {});
  }

  /* Returns sets of the given vertices, independent of their order, each once. \throws Vertex_out_of_range_error */
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

  // In each component with a vertex that is not a landmark yet.
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
  Set m_farthest; // from the first vertex of each component; of equally far ones, the first one visited
  double m_radius = 0;
};

/*
 * Lower bounds on the distances to a vertex: the Euclidean distance, or the bound of landmarks if it is larger. Zero if
 * neither is available.
 *
 * Landmarks have no rows of points that became vertices later. By the triangle inequality the bound for a neighbor of
 * such a goal, minus the length of the edge, is a bound for the goal. From such a vertex the bound is the Euclidean
 * distance.
 */
template <class Triangulation>
class Goal_bound
{
public:
  Goal_bound(const Triangulation& triangulation, Vertex_index goal = null_index,
             const Landmark_rows* landmarks = nullptr)
    : m_triangulation(triangulation)
    , m_goal(goal)
    , m_landmarks(landmarks)
  {
    if(goal != null_index)
      m_place = triangulation.metric().place(triangulation.input(), goal);
    if(landmarks != nullptr)
      find_known_vertices();
  }

  double operator()(Vertex_index v) const
  {
    if(m_goal == null_index)
      return 0;
    const auto& metric = m_triangulation.metric();
    const double in_space = metric.distance_lower_bound(metric.place(m_triangulation.input(), v), m_place);
    return m_landmarks == nullptr || !m_landmarks->has_row(v) ? in_space : (std::max)(in_space, by_landmarks(v));
  }

private:
  // A vertex that has a row, and an upper bound on its distance from the goal.
  struct Known_vertex
  {
    Vertex_index vertex;
    double distance;
  };

  void find_known_vertices()
  {
    if(m_landmarks->has_row(m_goal)) {
      m_known.push_back({m_goal, 0});
      return;
    }
    const auto& input = m_triangulation.input();
    for_each_outgoing_halfedge(input, m_goal, [&](Input_halfedge_index h) {
      const Vertex_index neighbor = input.tail(twin_index(h));
      if(m_landmarks->has_row(neighbor))
        m_known.push_back({neighbor, m_triangulation.metric().weight(input, h) * (1 + distance_bound_rounding)});
    });
  }

  double by_landmarks(Vertex_index v) const
  {
    double result = 0;
    for(const Known_vertex& known : m_known)
      result = (std::max)(result, m_landmarks->distance_lower_bound(v, known.vertex) - known.distance);
    return result;
  }

  const Triangulation& m_triangulation;
  Vertex_index m_goal; // null if every bound is zero
  typename Triangulation::Metric::Place m_place = {};
  const Landmark_rows* m_landmarks;
  std::vector<Known_vertex> m_known; // the goal, or neighbors of it
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H
