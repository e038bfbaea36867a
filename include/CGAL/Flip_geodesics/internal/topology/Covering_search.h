// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SEARCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SEARCH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/topology/Reduced_words.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A lift from which a search continues, with lower bounds of the paths from the source to it, and of those to the
 * target by way of it. */
struct Open_lift
{
  Index lift;
  double distance, total;
};

/*
 * Shortest edge paths from one vertex to another in homotopy classes, in order of length: a search in the universal
 * covering of the surface, whose vertices are the *lifts* of each vertex, that is, the classes of paths from the source
 * to it. They are created when they are reached.
 *
 * Lifts are settled in the order of a lower bound of the edge paths to the target by way of them. The remaining path is
 * not shorter than a shortest one of any class, so that the search is directed and never reaches a settled lift on a
 * shorter path.
 *
 * Afterwards the search continues where paths that do not follow edges and are shorter than these may pass. On a rough
 * mesh, edge paths are several times as long, and there are far more classes of edge paths up to that length than
 * required.
 */
template <class Triangulation>
class Covering_search
{
public:
  /* \throws Vertex_out_of_range_error, Disconnected_endpoints_error, Invalid_mesh_error, Invalid_coordinate_error,
   * Interrupted. `run_to_targets()` also throws Degenerate_face_error if it encounters a zero-length edge. */
  Covering_search(const Triangulation& triangulation, Vertex_index source, Vertex_index target,
                  Interruption& interruption)
    : m_triangulation(triangulation)
    , m_interruption(interruption)
    , m_target(target)
    , m_forest(checked_input(triangulation, source, target), std::vector<Vertex_index>(1, target), weight(),
               &interruption)
    , m_words(words(m_forest.component(target)))
  {
    if(m_forest.component(source) != m_forest.component(target))
      throw_disconnected(source, target);
    m_lifts[lift(source, 0)].distance = 0;
    m_queue.push(m_forest.distance(source), Vertex_index(0));
  }

  /* Continues until `number` lifts of the target are settled, there are more than `most_lifts` in total, or it is
   * interrupted. */
  void run_to_targets(std::size_t number, std::size_t most_lifts)
  {
    while(m_targets.size() < number && !m_queue.empty() && number_of_lifts() <= most_lifts &&
          !m_interruption.count_step())
      settle_next();
  }

  /*
   * Continues from unsettled lifts, beginning with those by way of which paths to the target seem shortest, as long as
   * these are not longer than `bound`. At least half as many additional lifts are settled, so that few such calls are
   * necessary; at most as many again, since a larger part may reveal shorter paths and thus a smaller bound.
   *
   * \param to_target lower bound of the length of a path from a vertex to the target
   */
  template <class LowerBound>
  void run_from(const std::vector<Open_lift>& starts, const LowerBound& to_target, double bound, std::size_t most_lifts)
  {
    const std::size_t enough = m_number_of_settled + m_number_of_settled / 2 + 16;
    const std::size_t most = 2 * m_number_of_settled + 64;
    std::unordered_map<Index, double> distance;
    Vertex_queue queue;
    const auto open = [&](const Open_lift& next) {
      const auto [place, is_new] = distance.emplace(next.lift, next.distance);
      if(is_settled(next.lift) || (!is_new && place->second <= next.distance))
        return;
      place->second = next.distance;
      queue.push(next.total, Vertex_index(next.lift));
    };
    for(const Open_lift& start : starts)
      open(start);
    const auto is_to_go_on = [&] {
      return queue.priority() <= bound ? m_number_of_settled < most : m_number_of_settled < enough;
    };
    while(!queue.empty() && is_to_go_on() && number_of_lifts() <= most_lifts && !m_interruption.count_step()) {
      const Index l = queue.pop().idx();
      if(is_settled(l))
        continue;
      settle(l);
      const double here = distance.find(l)->second;
      for_each_neighbor(l, [&](Index to, Input_halfedge_index h) {
        const double there = here + m_triangulation.metric().weight(input(), h);
        open({to, there, there + to_target(vertex(to))});
      });
    }
  }

  /* Makes the paths shortest ones among settled lifts, even if these were not settled in order. */
  void shorten_paths()
  {
    m_queue.clear();
    for(Index l = 0; l < static_cast<Index>(m_lifts.size()); ++l)
      if(is_settled(l))
        shorten_paths_over(l);
    while(!m_queue.empty())
      shorten_paths_over(m_queue.pop().idx());
  }

  /* Returns whether the whole covering has been searched. */
  bool is_exhausted() const { return m_number_of_settled == m_lifts.size(); }

  std::size_t number_of_lifts() const { return m_lifts.size(); }
  /* Returns the settled lifts of the target, those of `run_to_targets()` first and by distance. The source is lift
   * 0. */
  const std::vector<Index>& targets() const { return m_targets; }

  Vertex_index vertex(Index lift) const { return at(lift).vertex; }
  double distance(Index lift) const { return at(lift).distance; }
  bool is_settled(Index lift) const { return at(lift).neighbors != none; }
  /* Returns the lift to which halfedge `i` leads, counted clockwise from `outgoing()` at a settled lift's vertex. */
  Index neighbor(Index lift, std::size_t i) const { return m_neighbors[at(lift).neighbors + i]; }

  /* Returns the shortest edge path to a lift. */
  std::vector<Input_halfedge_index> path(Index lift) const
  {
    std::vector<Input_halfedge_index> result;
    for(; at(lift).incoming != null_index; lift = at(lift).previous)
      result.push_back(at(lift).incoming);
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Lift
  {
    Vertex_index vertex;
    Index older; // the one created before with the same vertex and key, -1 if there is none
    Path_words::Word word;
    double distance = std::numeric_limits<double>::infinity();
    Index previous = -1; // on the shortest path, with the edge from there
    Input_halfedge_index incoming = null_index;
    std::size_t neighbors = none; // the position of the first one, once it is settled
  };

  struct Key
  {
    Vertex_index vertex;
    std::uint64_t word;

    friend bool operator==(const Key& a, const Key& b) { return a.vertex == b.vertex && a.word == b.word; }
  };

  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      std::uint64_t z = (key.word * 0x9e3779b97f4a7c15u) ^ static_cast<std::uint64_t>(key.vertex.idx());
      z = (z ^ (z >> 32)) * 0xd6e8feb86659fd93u;
      return static_cast<std::size_t>(z ^ (z >> 32));
    }
  };

  static const auto& checked_input(const Triangulation& triangulation, Vertex_index source, Vertex_index target)
  {
    const auto& input = triangulation.input();
    check_vertex(source, input.number_of_vertices());
    check_vertex(target, input.number_of_vertices());
    check_surface(input);
    if(input.outgoing(source) == null_index || input.outgoing(target) == null_index)
      throw_disconnected(source, target);
    return input;
  }

  [[noreturn]] static void throw_disconnected(Vertex_index source, Vertex_index target)
  {
    throw Disconnected_endpoints_error(
        "no path of edges joins vertex " + std::to_string(source.idx()) + " and vertex " + std::to_string(target.idx()),
        {static_cast<std::size_t>(source.idx()), static_cast<std::size_t>(target.idx())});
  }

  const auto& input() const { return m_triangulation.input(); }
  auto weight() const
  {
    return [this](Input_halfedge_index h) { return m_triangulation.metric().weight(input(), h); };
  }
  const Lift& at(Index lift) const { return m_lifts[static_cast<std::size_t>(lift)]; }

  template <class Function>
  void for_each_neighbor(Index l, const Function& function) const
  {
    const Input_halfedge_index first = input().outgoing(vertex(l));
    Input_halfedge_index h = first;
    std::size_t i = 0;
    do {
      function(neighbor(l, i++), h);
      h = input().next(twin_index(h));
    } while(h != first);
  }

  void shorten_paths_over(Index l)
  {
    for_each_neighbor(l, [&](Index to, Input_halfedge_index h) {
      Lift& head = m_lifts[static_cast<std::size_t>(to)];
      const double length = distance(l) + m_triangulation.metric().weight(input(), h);
      if(!(length < head.distance))
        return;
      head.distance = length;
      head.previous = l;
      head.incoming = h;
      if(is_settled(to))
        m_queue.push(length, Vertex_index(to));
    });
  }

  Path_words words(Index component) const
  {
    const Cotree cotree(input(), m_forest, Borders::CLOSED_BY_ONE_FACE, weight(), &m_interruption);
    Generator_words words(input(), m_forest, cotree, &m_interruption);
    const std::vector<Letter> relation = words.relation(component);
    return {std::move(words), relation};
  }

  // The lift of a vertex to which a path with the given word leads.
  std::size_t lift(Vertex_index v, Path_words::Word word)
  {
    const auto [place, is_new] = m_newest.emplace(Key{v, m_words.key(word)}, -1);
    for(Index l = place->second; l >= 0; l = at(l).older)
      if(m_words.are_homotopic(word, at(l).word))
        return static_cast<std::size_t>(l);
    m_lifts.push_back({v, place->second, word});
    place->second = checked_index_bound(m_lifts.size()) - 1;
    return m_lifts.size() - 1;
  }

  void settle_next()
  {
    const Index l = m_queue.pop().idx();
    if(!is_settled(l)) // otherwise it has been moved forward
      settle(l);
  }

  void settle(Index l)
  {
    ++m_number_of_settled;
    m_lifts[static_cast<std::size_t>(l)].neighbors = m_neighbors.size();
    const Lift from = at(l);
    if(from.vertex == m_target)
      m_targets.push_back(l);
    const Input_halfedge_index first = input().outgoing(from.vertex);
    Input_halfedge_index h = first;
    do {
      const std::size_t to = lift(input().tail(twin_index(h)), m_words.continued(from.word, h));
      m_neighbors.push_back(static_cast<Index>(to));
      // Edges of length zero are not allowed: they would lead to infinitely many classes.
      const double distance = from.distance + m_triangulation.metric().length(input(), h);
      if(distance < m_lifts[to].distance && m_lifts[to].neighbors == none) {
        m_lifts[to].distance = distance;
        m_lifts[to].previous = l;
        m_lifts[to].incoming = h;
        m_queue.push(distance + m_forest.distance(m_lifts[to].vertex), Vertex_index(static_cast<Index>(to)));
      }
      h = input().next(twin_index(h));
    } while(h != first);
  }

  const Triangulation& m_triangulation;
  Interruption& m_interruption;
  Vertex_index m_target;
  Edge_forest m_forest; // from the target
  Path_words m_words;
  std::vector<Lift> m_lifts;
  std::size_t m_number_of_settled = 0;
  std::unordered_map<Key, Index, Hash> m_newest; // lift of a vertex, among those whose words have one key
  std::vector<Index> m_neighbors;
  std::vector<Index> m_targets;
  Vertex_queue m_queue; // of lifts
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_SEARCH_H
