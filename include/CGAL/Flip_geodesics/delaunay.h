// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DELAUNAY_H
#define CGAL_FLIP_GEODESICS_DELAUNAY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Lawson_flips.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDelaunay
/// What `flip_to_delaunay()` did.
struct Delaunay_report
{
  std::size_t flips = 0;       ///< edge flips
  std::size_t constrained = 0; ///< edges that are not locally Delaunay, and that a curve holds
  std::size_t remaining = 0;   ///< others of the edges in question; not zero only if the process was ended early
  bool is_stopped = false;     ///< did the visitor end it?
  /// Is each edge in question locally Delaunay, or held by a curve?
  bool is_complete() const { return remaining == 0; }
};

namespace internal {

/* A guard of the memory that the flip log takes. Ten flips an edge are much, unless faces are extremely thin. */
inline std::size_t default_maximum_of_flips(Index number_of_edges)
{
  return 1000000 + 1000 * static_cast<std::size_t>(number_of_edges);
}

template <class Triangulation, class EdgeRange, class Visitor>
Delaunay_report flip_to_delaunay(Triangulation& triangulation, const EdgeRange& edges, std::size_t maximum_flips,
                                 Visitor&& visitor)
{
  Lawson_flips<Triangulation> lawson(triangulation);
  for(Edge_index e : edges)
    lawson.allow(e);
  Delaunay_report report;
  report.flips = lawson.flip(maximum_flips, visitor);
  report.is_stopped = lawson.is_stopped();
  for(Edge_index e : edges)
    if(!triangulation.is_locally_delaunay(first_side(e)))
      ++(triangulation.holds(e) != 0 ? report.constrained : report.remaining);
  return report;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * Flips given edges of a triangulation until each is locally Delaunay, by Lawson's algorithm [Bobenko and Springborn
 * 2007]; other edges stay. So, given all edges, the triangulation becomes an intrinsic Delaunay triangulation.
 *
 * Edges that are tied, since four points lie on one circle, are Delaunay both ways and are not flipped. With exact
 * traits the process ends on every input: each flip lowers a function of the triangulation, of which there are finitely
 * many below a given value. With `Intrinsic_triangulation_traits` ties have the width of its tolerance. Faces whose
 * edges are flipped again and again are laid out afresh from the input; so errors do not add up. How many flips are
 * needed depends on the shapes of faces: about one an edge on ordinary meshes, as many as the aspect ratio where a long
 * thin cylinder is twisted.
 *
 * \param triangulation a model of `IntrinsicTriangulation`; edges under curves of networks are constrained, and stay
 * \param edges a range of edge indices
 * \param np named parameters: `number_of_iterations`, after how many flips the process ends early, by default a million
 *        and a thousand for each edge; `Delaunay_report::is_complete()` returns whether they sufficed; and `visitor`, a
 *        model of `FlipOutVisitor`: `go_further()` is called before each edge, and `on_flip()` after each flip; it may
 *        also throw, and leaves a valid triangulation
 * \throws Invalid_parameter_error for a negative number of flips
 * \throws what is thrown when faces are first touched
 *
 * Complexity: linear in the flips and the edges given.
 */
template <class Triangulation, class EdgeRange, class... NamedParameters,
          std::enable_if_t<!internal::Is_named_parameters<EdgeRange>::value, int> = 0>
Delaunay_report flip_to_delaunay(Triangulation& triangulation, const EdgeRange& edges, const NamedParameters&... np)
{
  static_assert(internal::is_range_of<EdgeRange, Edge_index>,
                "what follows the triangulation is not a range of edges of the triangulation, nor a named parameter");
  const auto& options = internal::options_of<internal_np::number_of_iterations_t, internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  const std::size_t standard = internal::default_maximum_of_flips(triangulation.number_of_edges());
  return internal::flip_to_delaunay(triangulation, edges, internal::number_of_iterations(options, standard),
                                    visitor.get());
}

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * Flips all edges of a triangulation until each is locally Delaunay: the result is the intrinsic Delaunay
 * triangulation. If networks have curves in the triangulation, it is the intrinsic constrained Delaunay triangulation
 * of all these curves, the iCDT [SC20, section 6.3]. Named parameters and exceptions are those of the first overload.
 * Complexity: linear in the mesh and the flips.
 */
template <class Triangulation, class... NamedParameters,
          std::enable_if_t<(internal::Is_named_parameters<NamedParameters>::value && ...), int> = 0>
Delaunay_report flip_to_delaunay(Triangulation& triangulation, const NamedParameters&... np)
{
  return Flip_geodesics::flip_to_delaunay(triangulation,
                                          internal::descriptors<Edge_index>(triangulation.number_of_edges()), np...);
}

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * The edges near the curves of a network, in increasing order: of the faces that touch a vertex which a curve passes,
 * and so on for `rings` rings of vertices. For local use of `flip_to_delaunay()`, at a cost that does not depend on the
 * mesh: \f$O(k \log k)\f$ for k edges.
 */
template <class Network>
std::vector<Edge_index> edges_near_curves(const Network& network, int rings = 1)
{
  const auto& triangulation = network.triangulation();
  std::vector<Vertex_index> front;
  std::vector<Edge_index> edges;
  for(Curve_index c : internal::descriptors<Curve_index>(network.number_of_curves()))
    network.for_each_segment(c, [&](Segment_index s) {
      front.push_back(triangulation.tail(network.halfedge(s)));
      front.push_back(triangulation.head(network.halfedge(s)));
    });
  const auto make_unique = [](auto& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  };
  for(int ring = 0; ring < rings; ++ring) {
    make_unique(front);
    std::vector<Vertex_index> next_front = front;
    for(Vertex_index v : front)
      internal::for_each_edge_in_star(triangulation, v, [&](Halfedge_index h) {
        edges.push_back(Network::Triangulation::edge(h));
        next_front.push_back(triangulation.tail(h));
        next_front.push_back(triangulation.head(h));
      });
    front.swap(next_front);
  }
  make_unique(edges);
  return edges;
}

/// \ingroup PkgFlipGeodesicsDelaunay
/// Are all edges locally Delaunay, those under curves excepted? Exact where the traits are. Linear in the mesh.
template <class Triangulation>
bool is_delaunay(const Triangulation& triangulation)
{
  for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges()))
    if(triangulation.holds(e) == 0 && !triangulation.is_locally_delaunay(internal::first_side(e)))
      return false;
  return true;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_DELAUNAY_H
