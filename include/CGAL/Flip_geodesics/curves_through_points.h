// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H
#define CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H

#include <CGAL/Flip_geodesics/Free_geodesic_spline.h>
#include <CGAL/Flip_geodesics/contracted_surface.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/geodesic_curves.h>
#include <CGAL/Flip_geodesics/internal/polylines/Path_straightener.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/network_builders.h>
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
Curve_index add_curve_through(Network& network, const LocationRange& locations, bool is_closed = false)
{
  auto& triangulation = network.triangulation();
  std::vector<Vertex_index> way_points;
  for(const Surface_location& location : locations)
    way_points.push_back(network.insert(location));
  const auto search = [&](Vertex_index v, Vertex_index w) { return shortest_intrinsic_edge_path(triangulation, v, w); };
  const Curve_index curve = network.add_curve(shortest_halfedges_through(search, way_points, is_closed), is_closed);
  std::size_t next = 1;
  Segment_index s = network.first_segment(curve);
  for(std::size_t legs = way_points.size() - (is_closed ? 0 : 1); next <= legs; s = network.next(s))
    if(triangulation.head(network.halfedge(s)) == way_points[next % way_points.size()]) {
      network.set_head_fixed(s, true); // a shortest path meets its end only there
      ++next;
    }
  return curve;
}

/// \ingroup PkgFlipGeodesicsRef
/// Geodesics from point to point, each by itself.
struct Free_legs
{
  std::vector<std::vector<Surface_location>> legs; ///< the points of each: its ends, and where it crosses edges
  Shortening_report report;                        ///< of all legs together, as one curve
  Curve_certificate certificate;                   ///< the same, for traits that decide exactly
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Joins each two points in a row by a shortest path along edges, and pulls it tight, each in a triangulation that is
 * put back for the next one. So legs do not hold up one another, and may
 * cross, unlike those of `add_curve_through()`; there is no triangulation that has all of them.
 *
 * \param triangulation that of the input, without flips and curves, as it is afterwards
 * \param points at least two, no two in a row in one place
 * \param stop, visitor as for `shorten()`, for each leg; the first `restarted()` for each if it can be
 * \throws Invalid_curve_error for fewer than two points, or two in a row in one place
 * \throws Occupied_triangulation_error if there are curves
 * \throws Disconnected_endpoints_error, and as `Intrinsic_triangulation::insert()`, `shorten()`
 */
template <class Triangulation, class StopPredicate = Never_stop_predicate, class Visitor = Default_shortening_visitor>
Free_legs geodesics_through(Triangulation& triangulation, const std::vector<Surface_location>& points,
                            const StopPredicate& stop = StopPredicate(), Visitor&& visitor = Visitor())
{
  if(points.size() < 2)
    throw Invalid_curve_error("a path needs two points");
  internal::Path_straightener<Triangulation> straightener(triangulation);
  Free_legs result;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& stop_on_leg = internal::restarted(stop);
    const auto tighten = [&](Edge_path_network<Triangulation>& network) {
      return shorten(network, stop_on_leg, visitor);
    };
    result.legs.push_back(straightener.shortest(points[i], points[i + 1], tighten));
  }
  result.report = straightener.report();
  result.certificate = straightener.certificate();
  return result;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Where points of the mesh lie on the surface of a triangulation, as `location_on_surface()`. Where edges of length
 * zero were contracted, points in the place of the one before are left out.
 */
template <class Triangulation>
std::vector<Surface_location> points_on_surface(const Triangulation& triangulation,
                                                const std::vector<Surface_location>& locations)
{
  if(!triangulation.input().is_contracted())
    return locations;
  std::vector<Surface_location> result;
  for(const Surface_location& location : locations) {
    const Surface_location at =
        internal::canonical_location(triangulation.input(), location_on_surface(triangulation, location));
    if(result.empty() || result.back().halfedge != at.halfedge || result.back().weights != at.weights)
      result.push_back(at);
  }
  return result;
}

namespace internal {

/* The same for points as they are given, which are kept in `given` when they are first asked for, on the mesh itself.
 */
template <class Triangulation, class LocationRange>
std::vector<Surface_location> points_on_surface(const Triangulation& triangulation,
                                                const typename Triangulation::Triangle_mesh& mesh,
                                                const LocationRange& locations, std::vector<Surface_location>& given)
{
  if(!triangulation.input().is_contracted())
    for(const auto& location : locations)
      given.push_back(surface_location(triangulation, mesh, location));
  return Flip_geodesics::points_on_surface(triangulation, given);
}

/* The points of a polyline in space; those of another one than the first without its start, the end before. */
template <class Triangulation, class OutputIterator>
OutputIterator write_points(const Triangulation& triangulation, const Surface_polyline& polyline, bool is_first,
                            OutputIterator out)
{
  for(std::size_t i = is_first ? 0 : 1; i < polyline.size(); ++i)
    *out++ = point_in_space(triangulation, surface_point(triangulation, polyline[i]));
  return out;
}

/* A curve of which all points lie in one place: that point twice. */
template <class Triangulation, class OutputIterator>
Geodesic_result<OutputIterator> curve_in_one_place(const Triangulation& triangulation, const Surface_location& place,
                                                   OutputIterator out)
{
  Shortening_report report;
  report.curves.push_back(report_of_point());
  note_contraction(triangulation, report);
  return {write_points(triangulation, {place, place}, true, out), report};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic, a locally shortest path, through points anywhere on the surface: from the first to the last,
 * with a corner at each point in between. Two points give a geodesic between them. The path may cross itself.
 *
 * \param mesh a triangle mesh
 * \param locations a range of vertices of the mesh, of `CGAL::Polygon_mesh_processing::Face_location`s, pairs of a face
 *        and barycentric coordinates, or of `Surface_location`s; see `surface_location()` for how points are snapped
 * \param out receives the points of the path
 * \param np, stop as for `geodesic_path()`, for each leg between two points
 * \return the end of the output, and the report, which has one curve
 * \throws Invalid_location_error, and as `add_curve_through()`, `geodesic_loop()`
 */
template <class TriangleMesh, class LocationRange, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters, class StopPredicate = Never_stop_predicate>
Geodesic_result<OutputIterator> geodesic_path_through(const TriangleMesh& mesh, const LocationRange& locations,
                                                      OutputIterator out,
                                                      const NamedParameters& np = parameters::default_values(),
                                                      const StopPredicate& stop = StopPredicate())
{
  using Triangulation = typename internal::Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  std::vector<Surface_location> given;
  return internal::compute_on_surface(mesh, np, [&](Triangulation& triangulation) {
    const std::vector<Surface_location> points = internal::points_on_surface(triangulation, mesh, locations, given);
    if(given.size() > 1 && points.size() == 1)
      return internal::curve_in_one_place(triangulation, points.front(), out);
    Default_shortening_visitor none;
    auto&& visitor = parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor), none);
    Free_legs path = geodesics_through(triangulation, points, stop, visitor);
    internal::note_contraction(triangulation, path.report);
    OutputIterator end = out;
    for(const std::vector<Surface_location>& leg : path.legs)
      end = internal::write_points(triangulation, leg, &leg == &path.legs.front(), end);
    return Geodesic_result<OutputIterator>{end, path.report};
  });
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic from one point of the surface to another, each a face and barycentric coordinates. Parameters,
 * exceptions and complexity are those of `geodesic_path_through()`.
 */
template <class TriangleMesh, class FT, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters, class StopPredicate = Never_stop_predicate>
Geodesic_result<OutputIterator> geodesic_path(
    const TriangleMesh& mesh,
    const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<FT, 3>>& source,
    const std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<FT, 3>>& target,
    OutputIterator out, const NamedParameters& np = parameters::default_values(),
    const StopPredicate& stop = StopPredicate())
{
  return geodesic_path_through(mesh, std::array<std::decay_t<decltype(source)>, 2>{{source, target}}, out, np, stop);
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic spline [SC20, section 6.2], see `Free_geodesic_spline`: the points where its pieces meet, which
 * lie on the curve, joined by geodesics. The control polygon, and the curve, may cross themselves.
 *
 * \param mesh a triangle mesh
 * \param control_points a range of locations as for `geodesic_path_through()`, at least two, no two in a row in one
 *        place
 * \param kind which spline
 * \param out receives the points of the curve
 * \param np named parameters: `vertex_point_map`, `geom_traits`, and `number_of_iterations`, the number of times that
 * the pieces are halved, 5 by default \return the end of the output, and the report, which has one curve \throws
 * Invalid_location_error, and as `Free_geodesic_spline`
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
  std::vector<Surface_location> given;
  return internal::compute_on_surface(mesh, np, [&](typename Types::Triangulation& triangulation) {
    const std::vector<Surface_location> points =
        internal::points_on_surface(triangulation, mesh, control_points, given);
    if(given.size() > 1 && points.size() == 1)
      return internal::curve_in_one_place(triangulation, points.front(), out);
    Free_geodesic_spline<typename Types::Triangulation> spline(triangulation, points, kind);
    for(unsigned i = 0; i < rounds; ++i)
      spline.refine();
    OutputIterator end = out;
    bool is_first = true;
    for(const std::vector<Surface_location>& piece : spline.finish()) {
      end = internal::write_points(triangulation, piece, is_first, end);
      is_first = false;
    }
    Shortening_report report = spline.report();
    internal::note_contraction(triangulation, report);
    return Geodesic_result<OutputIterator>{end, report};
  });
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H
