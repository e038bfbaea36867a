// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H
#define CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H

#include <CGAL/Flip_geodesics/Geodesic_spline.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/network_builders.h>
#include <CGAL/Flip_geodesics/overlapping_curves.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds a curve through points of the surface: makes them vertices, joins each two in a row by a shortest path along
 * edges, and fixes the curve's nodes there.
 *
 * \param locations a range of `Surface_location`s, at least two, no two in a row in one place; a closed curve does not
 *        repeat the first
 * \return the curve's index
 * \throws Invalid_curve_error for fewer than two points, or two in a row in one place
 * \throws Disconnected_endpoints_error
 * \throws as `Edge_path_network::insert()`
 */
template <class Network, class LocationRange>
Index add_curve_through(Network& network, const LocationRange& locations, bool is_closed = false)
{
  auto& triangulation = network.triangulation();
  std::vector<Index> way_points;
  for(const Surface_location& location : locations)
    way_points.push_back(network.insert(location));
  const auto search = [&](Index v, Index w) { return shortest_intrinsic_edge_path(triangulation, v, w); };
  const Index curve = network.add_curve(shortest_halfedges_through(search, way_points, is_closed), is_closed);
  std::size_t next = 1;
  Index s = network.first_segment(curve);
  for(std::size_t legs = way_points.size() - (is_closed ? 0 : 1); next <= legs; s = network.next(s))
    if(triangulation.head(network.halfedge(s)) == way_points[next % way_points.size()]) {
      network.set_head_fixed(s, true); // a shortest path meets its end only there
      ++next;
    }
  return curve;
}

namespace internal {

template <class Triangulation, class LocationRange>
std::vector<Surface_location> surface_locations(const Triangulation& triangulation,
                                                const typename Triangulation::Triangle_mesh& mesh,
                                                const LocationRange& locations)
{
  std::vector<Surface_location> result;
  for(const auto& location : locations)
    result.push_back(surface_location(triangulation, mesh, location));
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic, a locally shortest path, through points anywhere on the surface: from the first to the last, with
 * a corner at each point in between. Two points give a geodesic between them.
 *
 * \param mesh a triangle mesh
 * \param locations a range of vertices of the mesh, of `CGAL::Polygon_mesh_processing::Face_location`s, pairs of a face
 *        and barycentric coordinates, or of `Surface_location`s; see `surface_location()` for how points are snapped
 * \param out receives the points of the path
 * \param np as for `geodesic_path()`
 * \return the end of the output, and the report, which has one curve
 * \throws Invalid_location_error, and as `add_curve_through()`, `geodesic_loop()`
 */
template <class TriangleMesh, class LocationRange, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
Geodesic_result<OutputIterator> geodesic_path_through(const TriangleMesh& mesh, const LocationRange& locations,
                                                      OutputIterator out,
                                                      const NamedParameters& np = parameters::default_values())
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  auto triangulation = internal::make_triangulation(mesh, np);
  typename Types::Network network(triangulation);
  add_curve_through(network, internal::surface_locations(triangulation, mesh, locations));
  order_overlapping_curves(network);
  const Shortening_report report = internal::shorten_with_visitor(network, np);
  out = Curve_extractor<typename Types::Network>(network).points(0, out);
  return {out, report};
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic from one point of the surface to another, each a face and barycentric coordinates. Parameters,
 * exceptions and complexity are those of `geodesic_path_through()`.
 */
template <class TriangleMesh, class FT, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
Geodesic_result<OutputIterator> geodesic_path(
    const TriangleMesh& mesh,
    const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<FT, 3>>& source,
    const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<FT, 3>>& target,
    OutputIterator out, const NamedParameters& np = parameters::default_values())
{
  return geodesic_path_through(mesh, std::array<std::decay_t<decltype(source)>, 2>{{source, target}}, out, np);
}

/// \ingroup PkgFlipGeodesicsRef
/// What the control points of a spline are the control points of.
enum class Spline_kind {
  BEZIER,                ///< one B&eacute;zier curve, of a degree one less than their number
  CUBIC_B_SPLINE,        ///< a uniform cubic B-spline that starts and ends at the first and last point
  CLOSED_CUBIC_B_SPLINE, ///< a closed uniform cubic B-spline, of at least three points
};

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic spline [SC20, section 6.2], see `Geodesic_spline`: the points where its pieces meet, which lie on
 * the curve, joined by geodesics.
 *
 * \param mesh a triangle mesh
 * \param control_points a range of locations as for `geodesic_path_through()`, at least two, no two in a row in one place
 * \param kind which spline
 * \param out receives the points of the curve
 * \param np as for `geodesic_path()`, and `number_of_iterations`, the number of times that the pieces are halved, 5 by
 *        default
 * \return the end of the output, and the report, which has one curve
 * \throws Invalid_location_error, Crossing_curves_error if the control polygon crosses itself, and as
 *         `add_curve_through()`, `Geodesic_spline::refine()`
 */
template <class TriangleMesh, class LocationRange, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
Geodesic_result<OutputIterator> geodesic_spline(const TriangleMesh& mesh, const LocationRange& control_points,
                                                Spline_kind kind, OutputIterator out,
                                                const NamedParameters& np = parameters::default_values())
{
  using Types = internal::Curve_types<TriangleMesh, NamedParameters>;
  const unsigned rounds = static_cast<unsigned>(
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), 5));
  const bool is_closed = kind == Spline_kind::CLOSED_CUBIC_B_SPLINE;
  auto triangulation = internal::make_triangulation(mesh, np);
  typename Types::Network network(triangulation);
  const auto locations = internal::surface_locations(triangulation, mesh, control_points);
  if(is_closed && locations.size() < 3)
    throw Invalid_curve_error("a closed spline needs at least three control points");
  const Index curve = add_curve_through(network, locations, is_closed);
  order_overlapping_curves(network);
  auto spline = kind == Spline_kind::BEZIER
                    ? Geodesic_spline<typename Types::Network>(network, curve)
                    : Geodesic_spline<typename Types::Network>::cubic_b_spline(network, curve);
  for(unsigned i = 0; i < rounds; ++i)
    spline.refine();
  const Shortening_report report = spline.finish();
  out = Curve_extractor<typename Types::Network>(network).points(curve, out);
  return {out, report};
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H
