// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SURFACE_POINTS_H
#define CGAL_FLIP_GEODESICS_SURFACE_POINTS_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

template <class TriangleMesh>
struct Curve_place;

/// \ingroup PkgFlipGeodesicsBuilders
/// Returns the location of vertex `v` of a mesh. \throws Vertex_out_of_range_error if `v` does not belong to the mesh
/// or is isolated
template <class Triangulation>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh&,
    typename boost::graph_traits<typename Triangulation::Triangle_mesh>::vertex_descriptor v)
{
  const Vertex_index i = triangulation.input().index(v);
  if(i == null_index || triangulation.input().outgoing(i) == null_index)
    throw Vertex_out_of_range_error("a location is at a vertex that no face of the mesh has");
  return triangulation.location(i);
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the location of a face and barycentric coordinates, a `CGAL::Polygon_mesh_processing::Face_location`. The
 * coordinates belong to the source, target and third vertex of `halfedge(face, mesh)`, and are rounded to double, even
 * from exact number types.
 *
 * Points are snapped here and only here: coordinates of at most `snap` count as exactly zero. Points that were located
 * with rounding errors, with a coordinate of -5.6e-17 for instance, thus lie on the intended edge or vertex.
 *
 * \param triangulation the triangulation
 * \param mesh its mesh
 * \param location the face and the coordinates
 * \param snap a barycentric coordinate, not negative and below 1/3; by default 1e-12
 * \throws Invalid_location_error if the face is null or does not belong to the mesh, a coordinate is less than `-snap`
 *         or NaN, or the three coordinates do not sum to one within 1e-6
 *
 * Complexity: constant.
 */
template <class Triangulation, class FT>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
    const std::pair<typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor,
                    std::array<FT, 3>>& location,
    double snap)
{
  if(!internal::is_face(location.first, mesh))
    throw Invalid_location_error("a location is in no face of the mesh");
  Surface_location result;
  result.halfedge = triangulation.input().index(internal::graph_halfedge(location.first, mesh));
  double sum = 0;
  for(std::size_t i = 0; i < 3; ++i) {
    const double weight = internal::imported_number(location.second[i]);
    if(!(weight >= -snap && weight <= 1 + internal::weight_sum_tolerance))
      throw Invalid_location_error("a barycentric coordinate of a location is " + std::to_string(weight) +
                                   ", not between 0 and 1");
    sum += weight;
    result.weights[i] = weight <= snap ? 0 : weight;
  }
  if(!(std::abs(sum - 1) <= internal::weight_sum_tolerance))
    throw Invalid_location_error("the barycentric coordinates of a location sum to " + std::to_string(sum) +
                                 ", not to one");
  internal::check_location(triangulation.input(), result);
  return result;
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a `Face_location`, where weights of at most 1e-12 count as zero.
/// \throws Invalid_location_error if it is not a point of the mesh
template <class Triangulation, class FT>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
    const std::pair<typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor,
                    std::array<FT, 3>>& location)
{
  return surface_location(triangulation, mesh, location, internal::default_snap);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a point of a curve, which is a vertex or the point on a crossed edge, to a location.
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh&,
                                  const Surface_point& point)
{
  return internal::surface_location(triangulation, point);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a `Curve_place`, a `Curve_point` or a `Curve_sample` to a location, by its member `location`.
/// \throws Invalid_location_error if it is not a point of the mesh
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const Curve_place<typename Triangulation::Triangle_mesh>& place)
{
  return surface_location(triangulation, mesh, place.location);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Returns a location unchanged.
template <class Triangulation>
Surface_location surface_location(const Triangulation&, const typename Triangulation::Triangle_mesh&,
                                  const Surface_location& location)
{
  return location;
}

namespace internal {

using Place_in_space = std::array<double, 3>;

inline double dot(const Place_in_space& u, const Place_in_space& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline Place_in_space cross(const Place_in_space& u, const Place_in_space& v)
{
  return {{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
}

inline Place_in_space difference(const Place_in_space& u, const Place_in_space& v)
{
  return {{u[0] - v[0], u[1] - v[1], u[2] - v[2]}};
}

/* The barycentric coordinates of a point of a triangle, and its distance from the origin. */
struct Nearest_weights
{
  std::array<double, 3> weights = {{1, 0, 0}};
  double distance = std::numeric_limits<double>::infinity();
};

using Triangle_places = std::array<Place_in_space, 3>;

inline double distance_of(const Triangle_places& corners, const std::array<double, 3>& weights)
{
  Place_in_space p = {{0, 0, 0}};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += weights[i] * corners[i][k];
  return std::sqrt(dot(p, p));
}

/* Returns the point of side i, from corner i to the next, that is nearest to the origin. */
inline std::array<double, 3> nearest_on_side(const Triangle_places& corners, std::size_t i)
{
  const std::size_t j = (i + 1) % 3;
  const Place_in_space d = difference(corners[j], corners[i]);
  const double squared_length = dot(d, d);
  const double t = squared_length > 0 ? -dot(corners[i], d) / squared_length : 0;
  std::array<double, 3> weights = {{0, 0, 0}};
  weights[j] = (std::min)((std::max)(t, 0.0), 1.0);
  weights[i] = 1 - weights[j];
  return weights;
}

/* Returns the foot of the perpendicular from the origin, by the areas that it cuts off; not finite for a degenerate
 * face. */
inline std::array<double, 3> foot_of_perpendicular(const Triangle_places& corners)
{
  const Place_in_space u = difference(corners[1], corners[0]), v = difference(corners[2], corners[0]);
  const Place_in_space normal = cross(u, v), &from = corners[0]; // to the origin it is minus that
  const double squared = dot(normal, normal);
  const double at_1 = dot(cross(v, from), normal) / squared, at_2 = dot(cross(from, u), normal) / squared;
  return {{1 - at_1 - at_2, at_1, at_2}};
}

/*
 * Returns the point of a triangle that is nearest to the origin: the foot of the perpendicular if that lies inside, or
 * a point of a side. The nearest of these is chosen, so that another one is taken in needles, where the first is
 * inaccurate. The triangle is scaled to avoid overflow and underflow of squares.
 */
inline Nearest_weights nearest_weights(Triangle_places corners)
{
  double scale = 0;
  for(const Place_in_space& p : corners)
    scale = (std::max)({scale, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if(scale == 0)
    return {{{1, 0, 0}}, 0};
  for(Place_in_space& p : corners)
    for(double& x : p)
      x /= scale;
  Nearest_weights result;
  const auto consider = [&](const std::array<double, 3>& weights) {
    const double distance = scale * distance_of(corners, weights);
    if(distance < result.distance) {
      result.distance = distance;
      result.weights = weights;
    }
  };
  for(std::size_t i = 0; i < 3; ++i)
    consider(nearest_on_side(corners, i));
  const std::array<double, 3> foot = foot_of_perpendicular(corners);
  if(*std::min_element(foot.begin(), foot.end()) > 0) // never degenerate
    consider(foot);
  return result;
}

/* Returns half the coordinates of a point: differences of such numbers are finite. */
template <class Point>
Place_in_space half_of(const Point& p)
{
  return {{imported_number(p.x()) / 2, imported_number(p.y()) / 2, imported_number(p.z()) / 2}};
}

/* Returns the corner of a face of the mesh at the tail of a halfedge, relative to a given position. */
template <class Triangulation>
Place_in_space corner_seen_from(const Triangulation& triangulation, Input_halfedge_index h, const Place_in_space& from)
{
  const auto& input = triangulation.input().uncontracted();
  const Vertex_index v = input.tail(h);
  const Place_in_space p = half_of(triangulation.metric().point(input, v));
  if(!are_finite(p))
    throw Invalid_coordinate_error("vertex " + std::to_string(v.idx()) +
                                       " has a coordinate that is not a finite number",
                                   {static_cast<std::size_t>(v.idx())});
  return {{p[0] - from[0], p[1] - from[1], p[2] - from[2]}};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the location of the point of the mesh that is nearest to a point in space, up to rounding errors. If several
 * points are equally near, one of them is chosen.
 *
 * The location is moved to an edge or a vertex if barycentric coordinates are at most 1e-9. All faces are considered.
 * For many points, `CGAL::Polygon_mesh_processing::locate_with_AABB_tree()` is faster; it returns `Face_location`s.
 *
 * \throws Invalid_location_error if the mesh has no face, or a coordinate of the point is not finite
 * \throws Invalid_coordinate_error if a coordinate of the mesh is not finite
 * \throws Invalid_mesh_error if a face is not a triangle
 *
 * Complexity: linear in the number of faces of the mesh.
 */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const typename Triangulation::Metric::Point_3& point)
{
  using Face = typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor;
  const internal::Place_in_space from = internal::half_of(point);
  if(!internal::are_finite(from))
    throw Invalid_location_error("a point in space has a coordinate that is not a finite number");
  const auto& input = triangulation.input().uncontracted();
  internal::Nearest_weights nearest;
  Face found{};
  for(const Face f : CGAL::make_range(faces(mesh))) {
    const Input_halfedge_index h = input.index(internal::graph_halfedge(f, mesh));
    internal::check_triangle(input, h);
    const internal::Nearest_weights here =
        internal::nearest_weights({{internal::corner_seen_from(triangulation, h, from),
                                    internal::corner_seen_from(triangulation, input.next(h), from),
                                    internal::corner_seen_from(triangulation, input.next(input.next(h)), from)}});
    if(here.distance < nearest.distance) {
      nearest = here;
      found = f;
    }
  }
  if(nearest.distance == std::numeric_limits<double>::infinity())
    throw Invalid_location_error("a mesh without faces has no point nearest to one in space");
  return surface_location(triangulation, mesh, std::make_pair(found, nearest.weights), internal::nearest_point_snap);
}

namespace internal {

template <class Triangulation, class TriangleMesh, class Place, class = void>
constexpr bool is_place = false;
template <class Triangulation, class TriangleMesh, class Place>
constexpr bool is_place<
    Triangulation, TriangleMesh, Place,
    std::void_t<decltype(surface_location(std::declval<const Triangulation&>(), std::declval<const TriangleMesh&>(),
                                          std::declval<const Place&>()))>> = true;

template <class T>
struct Is_variant : std::false_type
{
};

template <class... Alternatives>
struct Is_variant<std::variant<Alternatives...>> : std::true_type
{
};

/* Converts a surface point of any kind, or a variant of several kinds, to a location. */
template <class Triangulation, class TriangleMesh, class Place>
Surface_location located_place(const Triangulation& triangulation, const TriangleMesh& mesh, const Place& place)
{
  if constexpr(Is_variant<Place>::value) {
    return std::visit([&](const auto& p) { return located_place(triangulation, mesh, p); }, place);
  } else {
    static_assert(is_place<Triangulation, TriangleMesh, Place>,
                  "this is neither a vertex of the mesh nor a Face_location, a Surface_location or a point in space");
    if constexpr(is_place<Triangulation, TriangleMesh, Place>)
      return surface_location(triangulation, mesh, place);
    else
      return {}; // so that no other message follows
  }
}

template <class Triangulation, class TriangleMesh, class PlaceRange>
std::vector<Surface_location> located(const Triangulation& triangulation, const TriangleMesh& mesh,
                                      const PlaceRange& places)
{
  std::vector<Surface_location> result;
  for(const auto& place : places)
    result.push_back(located_place(triangulation, mesh, place));
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SURFACE_POINTS_H
