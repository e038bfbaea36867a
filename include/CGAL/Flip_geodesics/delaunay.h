// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DELAUNAY_H
#define CGAL_FLIP_GEODESICS_DELAUNAY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Lawson_flips.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDelaunay
/// Reports the outcome of `flip_to_delaunay()`.
struct Delaunay_report
{
  std::size_t flips = 0;       ///< the number of edge flips
  std::size_t constrained = 0; ///< the number of given edges that are not locally Delaunay but lie under a curve
  /// The number of given edges that are not locally Delaunay and do not lie under a curve; 0 unless the process ended
  /// early.
  std::size_t remaining = 0;
  bool is_stopped = false; ///< whether the visitor ended the process
  /// Returns whether each given edge is locally Delaunay or lies under a curve.
  bool is_complete() const { return remaining == 0; }
};

namespace internal {

/* Returns the default limit on the number of flips, which bounds the memory of the flip log. */
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
 * Flips given edges of a triangulation by Lawson's algorithm \cgalCite{BS07} until all of them are locally Delaunay,
 * except for those that lie under curves. Edges that are not given, and edges under curves, are not flipped. If all
 * edges are given and none of them lies under a curve, the result is an intrinsic Delaunay triangulation.
 *
 * An edge is not flipped if the four vertices of its two faces are cocircular. With exact traits, the process
 * terminates on every input: each flip decreases a function of the triangulation, and only finitely many triangulations
 * have a smaller value of this function.
 *
 * With `Intrinsic_triangulation_traits` in double, vertices count as cocircular if they are cocircular within the
 * tolerance of these traits. Faces whose edges are flipped many times are recomputed from the input, so that errors do
 * not accumulate.
 *
 * The number of flips depends on the shapes of faces: about one flip per edge is typical, but on a long thin twisted
 * cylinder, the number of flips per edge is proportional to the aspect ratio of the cylinder.
 *
 * \param triangulation a model of `IntrinsicTriangulation` and, if `Has_drift` of its traits is `CGAL::Tag_true`, of
 *        `IntrinsicTriangulationOfMesh`
 * \param edges a range of edge indices
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of flips after which the process ends early; `Delaunay_report::is_complete()`
 *       returns whether this number of flips was sufficient}
 *     \cgalParamType{an integer}
 *     \cgalParamDefault{one million, plus a thousand for each edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called before each edge is examined, and whose
 *       `on_flip()` is called after each flip. If the visitor throws an exception, the triangulation remains valid}
 *     \cgalParamType{a model of `FlipOutVisitor`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the given edges
 * \throws Invalid_parameter_error if `number_of_iterations` is negative
 * \throws Invalid_mesh_error if a face that has not been accessed before is not a triangle
 * \throws Degenerate_face_error if such a face has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if such a face has a coordinate or length that is not finite or is out of range
 *
 * Complexity: linear in the number of flips plus the number of given edges.
 */
template <class Triangulation, class EdgeRange, class... NamedParameters,
          std::enable_if_t<!internal::is_named_parameters<EdgeRange>, int> = 0>
Delaunay_report flip_to_delaunay(Triangulation& triangulation, const EdgeRange& edges, const NamedParameters&... np)
{
  static_assert(internal::is_range_of<EdgeRange, Edge_index>,
                "the argument after the triangulation must be a range of its edges or a named parameter");
  const auto& options = internal::options_of<internal_np::number_of_iterations_t, internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  const std::size_t standard = internal::default_maximum_of_flips(triangulation.number_of_edges());
  return internal::flip_to_delaunay(triangulation, edges, internal::number_of_iterations(options, standard),
                                    visitor.get());
}

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * Flips the edges of a triangulation until all edges are locally Delaunay, except for those that lie under curves. The
 * result is the intrinsic Delaunay triangulation or, if networks have curves in the triangulation, the intrinsic
 * constrained Delaunay triangulation (iCDT) of all these curves \cgalCite{SC20,section 6.3}.
 *
 * The named parameters and exceptions are those of `flip_to_delaunay()` for given edges.
 *
 * \return a report on all edges
 *
 * Complexity: linear in the size of the mesh plus the number of flips.
 */
template <class Triangulation, class... NamedParameters,
          std::enable_if_t<(internal::is_named_parameters<NamedParameters> && ...), int> = 0>
Delaunay_report flip_to_delaunay(Triangulation& triangulation, const NamedParameters&... np)
{
  return Flip_geodesics::flip_to_delaunay(triangulation,
                                          internal::descriptors<Edge_index>(triangulation.number_of_edges()), np...);
}

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * Returns the edges near the curves of a network, sorted by index. For one ring, these are the edges of the faces
 * around the nodes of the curves. Each further ring adds the edges of the faces around the end points of the previous
 * edges. If these edges are passed to `flip_to_delaunay()`, only the surroundings of the curves change.
 *
 * Complexity: \cgalBigO{k \log k} for a small number of rings, where \f$k\f$ is the number of returned edges. The time
 * does not depend on the size of the mesh.
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
/// Returns whether all edges that do not lie under curves are locally Delaunay. The result is exact if the predicates
/// of the traits are exact. Invalid faces cause the exceptions of `flip_to_delaunay()`.
///
/// Complexity: linear in the size of the mesh.
template <class Triangulation>
bool is_delaunay(const Triangulation& triangulation)
{
  for(Edge_index e : internal::descriptors<Edge_index>(triangulation.number_of_edges()))
    if(triangulation.holds(e) == 0 && !triangulation.is_locally_delaunay(internal::first_side(e)))
      return false;
  return true;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_DELAUNAY_H
