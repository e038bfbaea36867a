// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H
#define CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/loops/Cut_edges.h>
#include <CGAL/Flip_geodesics/internal/loops/Generator_words.h>
#include <CGAL/Flip_geodesics/internal/loops/Shortest_loop_search.h>
#include <CGAL/Flip_geodesics/internal/loops/Surface_group.h>

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

/* Searches among the loops through given vertices. */
template <class Triangulation>
std::vector<Halfedge_index> shortest_loop_through(const Triangulation& triangulation,
                                                  const std::vector<Vertex_index>& vertices, Loop_kind kind)
{
  const auto& input = triangulation.input();
  const auto weight = [&](Input_halfedge_index h) { return triangulation.metric().weight(input, h); };
  check_surface(input);
  const Edge_forest forest(input, std::vector<Vertex_index>(), weight);
  const Generator_words words(input, forest, Cotree(input, forest, Borders::CLOSED_BY_ONE_FACE, weight));
  std::vector<Surface_group> groups;
  for(std::size_t c = 0; c < forest.roots().size(); ++c)
    groups.emplace_back(words.relation(static_cast<Index>(c)));

  Shortest_loop_search<Triangulation> search(triangulation, words);
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
  return internal::shortest_loop_through(triangulation, {v}, kind);
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
  const auto& input = triangulation.input();
  const internal::Cut_edges<Triangulation> cut(triangulation, std::vector<Vertex_index>());
  internal::Indexed_by<Vertex_index, std::vector<char>> is_on_cut(static_cast<std::size_t>(input.number_of_vertices()),
                                                                  0);
  for(Input_halfedge_index h : internal::descriptors<Input_halfedge_index>(input.number_of_halfedges()))
    if(cut.marks()[internal::edge_of(internal::as_intrinsic(h))] != 0)
      is_on_cut[input.tail(h)] = 1;
  std::vector<Vertex_index> vertices;
  for(Vertex_index v : internal::descriptors<Vertex_index>(input.number_of_vertices()))
    if(is_on_cut[v] != 0)
      vertices.push_back(v);
  return internal::shortest_loop_through(triangulation, vertices, kind);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_LOOP_H
