// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H
#define CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Cut_edges.h>
#include <CGAL/Flip_geodesics/internal/topology/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/topology/Shortest_loop_search.h>
#include <CGAL/Flip_geodesics/internal/topology/Surface_group.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

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

/* Calls `search(interruption)`; there is no loop if the visitor stops it. */
template <class Visitor, class Search>
std::vector<Halfedge_index> loop_unless_stopped(Visitor& visitor, const Search& search)
{
  Interruption interruption(visitor);
  try {
    return search(&interruption);
  } catch(const Interrupted&) {
    return {};
  }
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * The shortest loop of edges through a vertex that is of a kind, by [EH04]: its halfedges from the vertex back to it;
 * empty if there is none, as on a sphere. A part at the vertex may be passed out and back.
 *
 * \param triangulation a model of `IntrinsicTriangulationOfMesh`; its input is searched, and lengths are the metric's
 * \throws Vertex_out_of_range_error
 * \throws Invalid_mesh_error, Invalid_coordinate_error as `Loop_basis`
 *
 * Complexity: \f$O(n \log n)\f$ for a fixed genus and number of borders.
 */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Vertex_index v,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE)
{
  internal::check_vertex(v, triangulation.input().number_of_vertices());
  return internal::shortest_loop_through(triangulation, {v}, kind, nullptr);
}

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes the same, and lets a visitor stop that.
 *
 * \param triangulation, v, kind as above
 * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, at regular intervals. If it
 *        returns `false`, then the result is empty
 * \throws as above
 */
template <class Triangulation, class Visitor>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Vertex_index v, Loop_kind kind,
                                          Visitor&& visitor)
{
  internal::check_vertex(v, triangulation.input().number_of_vertices());
  return internal::loop_unless_stopped(visitor, [&](internal::Interruption* interruption) {
    return internal::shortest_loop_through(triangulation, {v}, kind, interruption);
  });
}

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * The shortest of all loops of edges that are of a kind; empty if there is none. Such a loop passes a vertex of each
 * network that cuts the surface into disks. So only loops through vertices of a cut graph are searched, each to half of
 * the length of the best one so far.
 *
 * Parameters and errors as above.
 *
 * Complexity: \f$O(n \log n + c\,m \log m)\f$ for a fixed genus and number of borders, with c vertices of the cut graph,
 * and at most m vertices nearer to one of them than half of the length of the loops found on the way.
 */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation,
                                          Loop_kind kind = Loop_kind::NOT_CONTRACTIBLE)
{
  return internal::shortest_loop(triangulation, kind, nullptr);
}

/*!
 * \ingroup PkgFlipGeodesicsLoops
 *
 * Computes the same, and lets a visitor stop that.
 *
 * \param triangulation, kind as above
 * \param visitor a model of `FlipOutVisitor`, of which only `go_further()` is called, at regular intervals. If it
 *        returns `false`, then the result is empty
 * \throws as above
 */
template <class Triangulation, class Visitor>
std::vector<Halfedge_index> shortest_loop(const Triangulation& triangulation, Loop_kind kind, Visitor&& visitor)
{
  return internal::loop_unless_stopped(visitor, [&](internal::Interruption* interruption) {
    return internal::shortest_loop(triangulation, kind, interruption);
  });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H
