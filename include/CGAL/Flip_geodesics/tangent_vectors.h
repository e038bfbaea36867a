// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TANGENT_VECTORS_H
#define CGAL_FLIP_GEODESICS_TANGENT_VECTORS_H

#include <CGAL/Flip_geodesics/Geodesic_logarithm.h>
#include <CGAL/Flip_geodesics/Parallel_transport.h>
#include <CGAL/Flip_geodesics/internal/distances/Source_directions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/tangents/Place_frame.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/trace_geodesic.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTangents
/// What `logarithmic_map()` of a place returns.
template <class OutputIterator, class TriangleMesh>
struct Logarithm_result
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor; ///< of the mesh

  OutputIterator out;           ///< the end of the output
  halfedge_descriptor halfedge; ///< what the angles are told from, counterclockwise
  double total_angle = 0;    ///< the sum of the angles about the source, \f$2\pi\f$ but at vertices and on the border
  bool is_on_border = false; ///< is the source on the border? Then at a vertex angles can be negative
  Distance_field_report report; ///< what became of the distances
};

namespace internal {

/*
 * What a `Geodesic_logarithm` says of many targets. Of a vertex the distance is known, and where the path starts is found
 * without a walk along it.
 */
template <class Triangulation>
class Logarithm_of_targets
{
public:
  /* \param source that of the logarithm */
  Logarithm_of_targets(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                       const Geodesic_logarithm<Triangulation>& logarithm, const Surface_location& source)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_logarithm(logarithm)
    , m_frame(triangulation, canonical_location(triangulation.input(), source))
    , m_starts(logarithm.distance_field().query())
  {
  }

  template <class Target>
  Polar_coordinates operator()(const Target& target)
  {
    if constexpr(is_mesh_vertex<typename Triangulation::Triangle_mesh, Target>)
      return at_vertex(m_triangulation.index(target));
    else
      return m_logarithm(trace_start(m_triangulation, m_mesh, target));
  }

private:
  // It may be isolated.
  Polar_coordinates at_vertex(Vertex_index v)
  {
    const double radius = m_logarithm.distance_field().distance(v);
    const bool has_path = radius > 0 && radius < std::numeric_limits<double>::infinity();
    const std::optional<Start_direction> start = has_path ? m_starts(v) : std::nullopt;
    if(!start)
      return m_logarithm(v);
    return {radius, m_frame.angle(m_frame.position(start->first, start->direction), m_logarithm.halfedge())};
  }

  const Triangulation& m_triangulation;
  const typename Triangulation::Triangle_mesh& m_mesh;
  const Geodesic_logarithm<Triangulation>& m_logarithm;
  Place_frame<Triangulation> m_frame;
  Source_directions<Triangulation> m_starts;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * The logarithmic map of a place anywhere on the surface: for each target how long the shortest path from the source is,
 * and in which direction it starts. See `Geodesic_logarithm`. `trace_geodesic(mesh, source, std::pair(result.halfedge,
 * p.angle), p.radius, out)` comes back to a target with the coordinates `p`, unless the path bends at a vertex.
 *
 * \param mesh a triangle mesh
 * \param source a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space, as for
 *        `trace_geodesic()`
 * \param targets a range of such; for all vertices `vertices(mesh)`
 * \param out receives `Polar_coordinates`, one for each target
 * \param np named parameters: `vertex_point_map` or `metric` as for `geodesic_path()`
 * \return a `Logarithm_result`. Of a `Face_location` the angles are told from `halfedge(face, mesh)`, of a vertex from a
 *         halfedge that starts there
 * \throws Vertex_out_of_range_error, Invalid_location_error for places that are not on the mesh
 * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: that of `Geodesic_distance_field::compute()`, also for all vertices as targets; and for each other target
 * that of `Geodesic_logarithm`.
 */
template <class TriangleMesh, class Source, class TargetRange, class OutputIterator, class... NamedParameters>
Logarithm_result<OutputIterator, TriangleMesh> logarithmic_map(const TriangleMesh& mesh, const Source& source,
                                                               const TargetRange& targets, OutputIterator out,
                                                               const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Triangulation =
      typename internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>::Triangulation;
  const Triangulation triangulation = internal::make_triangulation(mesh, options);
  const Surface_location from = internal::trace_start(triangulation, mesh, source);
  const Geodesic_logarithm<Triangulation> logarithm(triangulation, mesh, from);
  internal::Logarithm_of_targets<Triangulation> logarithm_of(triangulation, mesh, logarithm, from);
  std::vector<Polar_coordinates> result;
  for(const auto& target : targets)
    result.push_back(logarithm_of(target));
  return {std::copy(result.begin(), result.end(), out), triangulation.input().halfedge(logarithm.halfedge()),
          logarithm.total_angle(), logarithm.is_on_border(), logarithm.report()};
}

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Carries a tangent vector along a curve, so that it does not turn in the surface. See `Parallel_transport`.
 *
 * \param mesh a triangle mesh
 * \param curve a range of vertices, or of `CGAL::Polygon_mesh_processing::Face_location`s, as `geodesic_path()`,
 *        `trace_geodesic()` and `isolines()` write them: each two in a row in one face. The locations of a
 *        `Located_polyline`, for example
 * \param direction at the start of the curve: a halfedge and an angle from there, as for `trace_geodesic()`
 * \param np named parameters: `vertex_point_map` or `metric` as for `geodesic_path()`
 * \return the direction at the end of the curve, in the same form; of a `Face_location` told from `halfedge(face, mesh)`
 * \throws Invalid_curve_error if there is no location, or no face has two in a row
 * \throws Vertex_out_of_range_error, Invalid_location_error for places that are not on the mesh
 * \throws Invalid_parameter_error if the angle is no finite number, or the halfedge no side of a face of the start
 * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error for a face on the way
 *
 * Complexity: linear in the number of locations and the degrees of vertices among them; meshes other than
 * `Surface_mesh` are indexed, \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class LocationRange, class... NamedParameters>
auto parallel_transport(
    const TriangleMesh& mesh, const LocationRange& curve,
    const std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>& direction,
    const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  using Triangulation =
      typename internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>::Triangulation;
  using Direction = std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>;
  const Triangulation triangulation = internal::make_triangulation(mesh, options);
  std::vector<Surface_location> locations;
  for(const auto& place : curve)
    locations.push_back(internal::trace_start(triangulation, mesh, place));
  const Surface_direction end = Parallel_transport<Triangulation>(triangulation)(
      locations, {triangulation.input().index(direction.first), direction.second});
  return Direction(triangulation.input().halfedge(end.halfedge), end.angle);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_TANGENT_VECTORS_H
