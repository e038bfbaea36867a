// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H
#define CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Cut_edges.h>
#include <CGAL/Flip_geodesics/internal/topology/Edge_forest.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/topology/Reduced_words.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The shortest loop along edges that passes one of some vertices and is of a certain kind.
 *
 * Each search leaves out the vertices whose loops were searched before. The class of a path is its word, reduced as far
 * as it cancels: the loop of an edge between two ends whose words differ by that of the edge contracts, and only others
 * are looked at.
 */
template <class Triangulation>
class Shortest_loop_search
{
public:
  Shortest_loop_search(const Triangulation& triangulation, const Generator_words& words, Interruption* interruption)
    : m_words(words)
    , m_search(triangulation, interruption)
    , m_is_left_out(static_cast<std::size_t>(triangulation.input().number_of_vertices()), 0)
  {
  }

  /* Looks for a shorter loop through v, and through no vertex asked about before, whose word has a property.
   * \throws Interrupted */
  template <class IsWanted>
  void search(Vertex_index v, const IsWanted& is_wanted)
  {
    m_reduced_words.clear();
    Policy<IsWanted> policy(*this, is_wanted);
    m_search.run(v, Reduced_words::empty_word, policy);
    if(policy.closing() != null_index) {
      const auto [out, back] = m_search.legs(policy.closing());
      m_loop = closed_chain(out, back, 0);
    }
    m_is_left_out[v] = 1;
  }

  /* What was found: a chain from the vertex back to it; empty if there is none. */
  const std::vector<Halfedge_index>& loop() const { return m_loop; }

private:
  using Search = Loop_search<Triangulation, Reduced_words::Word>;

  // Keeps the edge that closes the best loop, if it is shorter than those of other vertices.
  template <class IsWanted>
  class Policy : public Search::template Policy<Policy<IsWanted>>
  {
    using Base = typename Search::template Policy<Policy<IsWanted>>;

  public:
    Policy(Shortest_loop_search& loops, const IsWanted& is_wanted)
      : Base(loops.m_search)
      , m_loops(loops)
      , m_is_wanted(is_wanted)
    {
    }

    Input_halfedge_index closing() const { return m_closing; }

    template <class Queue>
    bool is_finished(Queue& queue) const
    {
      return !(2 * queue.priority() < m_loops.m_length);
    }

    template <class Function>
    void for_each_halfedge(const typename Base::Origin& origin, const Function& function) const
    {
      Base::for_each_halfedge(origin, [&](Input_halfedge_index h) {
        if(m_loops.m_is_left_out[this->head(h)] == 0)
          function(h);
      });
    }

    Reduced_words::Word extended(Reduced_words::Word path, Input_halfedge_index h) const
    {
      m_loops.m_words.for_each_letter(h, [&](Letter letter) { path = m_loops.m_reduced_words.appended(path, letter); });
      return path;
    }

    void meet(const typename Base::Origin& origin, Input_halfedge_index h, Vertex_index w)
    {
      const double length = this->length_of_loop(origin, h, w);
      if(!(length < m_loops.m_length))
        return;
      const Reduced_words::Word word = this->class_over(origin, h), other = this->class_of_path(w);
      if(word == other || !m_is_wanted(m_loops.m_reduced_words.quotient(word, other)))
        return;
      m_loops.m_length = length;
      m_closing = h;
    }

  private:
    Shortest_loop_search& m_loops;
    const IsWanted& m_is_wanted;
    Input_halfedge_index m_closing = null_index;
  };

  const Generator_words& m_words;
  Search m_search;
  Indexed_by<Vertex_index, std::vector<char>> m_is_left_out;
  Reduced_words m_reduced_words;
  std::vector<Halfedge_index> m_loop;
  double m_length = std::numeric_limits<double>::infinity(); // of the best loop
};

} // namespace internal

/// \ingroup PkgFlipGeodesicsLoops
/// Which loops `shortest_loop()` looks for.
enum class Loop_kind {
  NOT_CONTRACTIBLE, ///< those that cannot be contracted to a point
  NOT_BOUNDING      ///< those whose homology class is not zero: on a closed surface, those that do not divide it
};

namespace internal {

/* Searches among the loops through given vertices. \throws Interrupted */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop_through(const Triangulation& triangulation,
                                                  const std::vector<Vertex_index>& vertices, Loop_kind kind,
                                                  Interruption* interruption)
{
  const auto& input = triangulation.input();
  const auto weight = [&](Input_halfedge_index h) { return triangulation.metric().weight(input, h); };
  check_surface(input);
  const Edge_forest forest(input, std::vector<Vertex_index>(), weight, interruption);
  const Generator_words words(input, forest, Cotree(input, forest, Borders::CLOSED_BY_ONE_FACE, weight, interruption),
                              interruption);
  std::vector<Surface_group> groups;
  for(std::size_t c = 0; c < forest.roots().size(); ++c)
    groups.emplace_back(words.relation(static_cast<Index>(c)));

  Shortest_loop_search<Triangulation> search(triangulation, words, interruption);
  for(Vertex_index v : vertices) {
    if(forest.component(v) < 0)
      continue;
    const Surface_group& group = groups[static_cast<std::size_t>(forest.component(v))];
    search.search(v, [&](const std::vector<Letter>& word) {
      switch(kind) {
      case Loop_kind::NOT_CONTRACTIBLE:
        return !group.is_neutral(word);
      case Loop_kind::NOT_BOUNDING:
        return !Surface_group::is_balanced(word);
      }
      return false;
    });
  }
  return search.loop();
}

/* Searches among the loops through vertices of a cut graph. \throws Interrupted */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Loop_kind kind,
                                          Interruption* interruption)
{
  const auto& input = triangulation.input();
  const Cut_edges<Triangulation> cut(triangulation, std::vector<Vertex_index>(), interruption);
  Indexed_by<Vertex_index, std::vector<char>> is_on_cut(static_cast<std::size_t>(input.number_of_vertices()), 0);
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(input.number_of_halfedges()))
    if(cut.marks()[edge_of(as_intrinsic(h))] != 0)
      is_on_cut[input.tail(h)] = 1;
  std::vector<Vertex_index> vertices;
  for(Vertex_index v : descriptors<Vertex_index>(input.number_of_vertices()))
    if(is_on_cut[v] != 0)
      vertices.push_back(v);
  return shortest_loop_through(triangulation, vertices, kind, interruption);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes the shortest loop of edges through a vertex that is of a kind, by [EH04]: its halfedges from the vertex back
 * to it; none if there is no such loop, as on a sphere. A part at the vertex may be passed out and back.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`; its input is searched, and lengths are the metric's
 * \param v, kind the vertex, and which loops are searched
 * \param np named parameters: `visitor`, a model of `FlipOutVisitor`, of which only `go_further()` is called, at
 *        regular intervals. If it returns `false`, then the result is empty
 * \throws Vertex_out_of_range_error
 * \throws Invalid_mesh_error, Invalid_coordinate_error as `Loop_basis`
 *
 * Complexity: \f$O(n \log n)\f$ for a fixed genus and number of borders.
 */
template <class Triangulation, class... NamedParameters>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Vertex_index v,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE, const NamedParameters&... np)
{
  internal::check_vertex(v, triangulation.input().number_of_vertices());
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::shortest_loop_through(triangulation, {v}, kind, interruption);
  });
}

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes the shortest of all loops of edges that are of a kind; none if there is no such loop. The loop passes a
 * vertex of each network that cuts the surface into disks. So only loops through vertices of a cut graph are searched,
 * each to half of the length of the best one so far.
 *
 * Parameters and errors as above.
 *
 * Complexity: \f$O(n \log n + c\,m \log m)\f$ for a fixed genus and number of borders, with c vertices of the cut graph,
 * and at most m vertices nearer to one of them than half of the length of the loops found on the way.
 */
template <class Triangulation, class... NamedParameters>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE, const NamedParameters&... np)
{
  return internal::result_unless_stopped(internal::options_of<internal_np::visitor_t>(np...), [&](auto* interruption) {
    return internal::shortest_loop(triangulation, kind, interruption);
  });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H
