// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TEXTURE_COORDINATES_H
#define CGAL_FLIP_GEODESICS_TEXTURE_COORDINATES_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/curve_samples.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/tangents/Logarithm_everywhere.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/tangent_vectors.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTangents
/// Reports on the faces with texture coordinates.
struct Texture_report
{
  std::size_t faces = 0; ///< the number of faces with coordinates
  /// the number of these faces that are unfolded separately; see `texture_coordinates()`
  std::size_t torn = 0;
};

namespace internal {

/* Lays the faces out in the tangent plane of a source, in which a direction at the source is the first axis. */
template <class Triangulation>
class Tangent_plane_layout
{
public:
  using Vector = std::complex<double>;
  using Corners = std::array<Vector, 3>;

  Tangent_plane_layout(const Triangulation& triangulation, const Logarithmic_map<Triangulation>& logarithm,
                       const Surface_location& source, const Vector& axis)
    : m_triangulation(triangulation)
    , m_logarithm(logarithm)
    , m_everywhere(triangulation, logarithm, source)
    , m_axis(axis)
  {
    for(Vertex_index v : descriptors<Vertex_index>(triangulation.input().number_of_vertices()))
      m_vertices.push_back(in_plane(m_everywhere(v)));
  }

  /*
   * Returns the corners of the face of h, beginning at its tail; not finite if one is too far away. Sets `is_torn` if
   * they differ from the images of the vertices.
   */
  Corners operator()(Input_halfedge_index h, bool& is_torn)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index hn = input.next(h);
    const Corners corners = {m_vertices[input.tail(h)], m_vertices[input.tail(hn)],
                             m_vertices[input.tail(input.next(hn))]};
    const auto sides = input_face_geometry(m_triangulation, h);
    const Corners vectors = {Vector(sides[0].x, sides[0].y), Vector(sides[1].x, sides[1].y),
                             Vector(sides[2].x, sides[2].y)};
    is_torn = false;
    if(is_whole(corners, vectors) || !std::isfinite(std::abs(corners[0] + corners[1] + corners[2])))
      return corners;
    is_torn = true;
    return about_center(h, vectors, corners);
  }

private:
  static constexpr double most_stretch = 2; // of a side; curvature causes less stretch over one face

  Vector in_plane(const Polar_coordinates& p) const
  {
    if(p.radius == std::numeric_limits<double>::infinity())
      return {p.radius, p.radius};
    const auto [x, y] = m_logarithm.in_plane(p);
    return Vector(x, y) / m_axis;
  }

  // Returns whether the map keeps a face connected, with the same orientation.
  static bool is_whole(const Corners& corners, const Corners& sides)
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(!(std::abs(corners[(i + 1) % 3] - corners[i]) <= most_stretch * std::abs(sides[i])))
        return false;
    return is_up(corners);
  }

  static bool is_up(const Corners& corners)
  {
    const Vector first = corners[1] - corners[0], second = corners[2] - corners[1];
    const double longest = (std::max)({std::abs(first), std::abs(second), std::abs(first + second)});
    return std::imag(std::conj(first) * second) >
           internal::least_map_height * longest * longest; // for a line it is a rounding error
  }

  // Lays out the face from the end of the shortest path to its center. Corners near the images of their vertices are
  // moved there, unless the face would be reversed.
  Corners about_center(Input_halfedge_index h, const Corners& sides, const Corners& vertices)
  {
    const auto [p, carried] = m_everywhere(h, {{1.0 / 3, 1.0 / 3, 1.0 / 3}});
    const Vector place = in_plane(p);
    if(p.radius == 0 || !(p.radius < std::numeric_limits<double>::infinity()))
      return vertices;
    const Vector turn = place / p.radius * std::polar(1.0, -carried);
    const Corners alone = {place + turn * (sides[2] - sides[0]) / 3.0, place + turn * (sides[0] - sides[1]) / 3.0,
                           place + turn * (sides[1] - sides[2]) / 3.0};
    Corners result = alone;
    const double close_by = (std::max)({std::abs(sides[0]), std::abs(sides[1]), std::abs(sides[2])}) / 2;
    for(std::size_t i = 0; i < 3; ++i)
      if(std::abs(result[i] - vertices[i]) <= close_by)
        result[i] = vertices[i];
    return is_up(result) ? result : alone;
  }

  const Triangulation& m_triangulation;
  const Logarithmic_map<Triangulation>& m_logarithm;
  Logarithm_everywhere<Triangulation> m_everywhere;
  Vector m_axis;
  Indexed_by<Vertex_index, std::vector<Vector>> m_vertices;
};

template <class Triangulation>
double longest_side(const Triangulation& triangulation)
{
  double longest = 0;
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(triangulation.input().number_of_halfedges()))
    if(is_first_side(h))
      longest = (std::max)(longest, triangulation.metric().length(triangulation.input(), h));
  return longest;
}

/* Converts image coordinates to the value type of a map. */
template <class Value>
Value picture_place(double x, double y)
{
  if constexpr(std::is_constructible<Value, double, double>::value)
    return Value(x, y);
  else
    return Value{{x, y}};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTangents
 *
 * Maps an image onto the surface like a decal, by assigning texture coordinates to the corners of faces
 * \cgalCite{SGW06}. The coordinates are those of the logarithmic map of a source point. The center of the image is
 * mapped to this point.
 *
 * In texture coordinates, the image is the unit square. Along each ray from its center, lengths are preserved up to the
 * scale; curvature stretches or compresses the image in the perpendicular direction. The logarithmic map is
 * discontinuous where shortest paths arrive from two sides, and degenerates to a line behind a vertex at which shortest
 * paths bend.
 *
 * If the logarithmic map would therefore reverse a face, collapse it to a line, or more than double the length of a
 * side, the face is unfolded separately, along the shortest path from the source point to the center of the face. The
 * coordinates of the corners of such a face can differ from those of the same vertices in adjacent faces.
 *
 * \param mesh a triangle mesh
 * \param source the source point: a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space
 * \param right the direction from the source point to the right side of the image: a halfedge and an angle, as for
 *        `trace_geodesic()`
 * \param size the length of the sides of the image on the surface, in the unit of the coordinates
 * \param corners a model of `WritablePropertyMap` with the halfedges of the mesh as keys, which represent the corners
 *        at their targets, and `std::array<double, 2>` or `Point_2` as values. Corners of faces that are unreachable or
 *        too far from the image receive NaN. Border halfedges receive no value
 * \param np the named parameters `vertex_point_map` or `metric`, as for `geodesic_path()`, and `geom_traits`, of which
 *        only the work limit is used
 * \return a report on the faces
 * \throws Invalid_parameter_error if the size is not positive and finite, the angle is not finite, or the halfedge is
 *        not one that `trace_geodesic()` accepts
 * \throws Vertex_out_of_range_error if a vertex given as the source does not belong to the mesh
 * \throws Invalid_location_error if the source does not lie on the mesh
 * \throws Degenerate_face_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_coordinate_error as `Geodesic_distance_field::compute()` does
 * \throws Invalid_mesh_error as `Geodesic_distance_field::compute()` does
 *
 * Complexity: the time of computing a `Geodesic_distance_field` up to a radius. The radius is the distance from the
 * center of the image to its corners plus the length of the longest edge of the mesh. In addition, at most as many
 * windows as in this field are created, and every face of the mesh is visited.
 */
template <class TriangleMesh, class Source, class CornerMap, class... NamedParameters>
Texture_report texture_coordinates(
    const TriangleMesh& mesh, const Source& source,
    const std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>& right, double size,
    CornerMap corners, const NamedParameters&... np)
{
  const auto& options = internal::surface_options(np...);
  static_assert(internal::is_property_map<CornerMap>());
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Value = typename boost::property_traits<CornerMap>::value_type;
  if(!(size > 0 && std::isfinite(size)))
    throw Invalid_parameter_error("the size of an image on a surface must be positive and finite");
  const Surface surface = internal::make_surface(mesh, options);
  const auto& input = surface.input();
  const Surface_location middle = internal::trace_start(surface, mesh, source);
  Distance_field_limits limits;
  limits.radius = std::sqrt(0.5) * size + internal::longest_side(surface);
  const Logarithmic_map<Surface> logarithm(surface, mesh, middle, parameters::search_limit(limits));
  const double angle =
      angle_between(surface, middle, {logarithm.halfedge(), 0}, {input.index(right.first), right.second});
  const auto [x, y] = logarithm.in_plane({1, angle});
  internal::Tangent_plane_layout<Surface> layout(surface, logarithm, middle, {x, y});

  Texture_report report;
  std::vector<std::pair<Input_halfedge_index, Value>> values; // with the halfedge of each target
  for(const auto& f : faces(mesh)) {
    Input_halfedge_index h = input.index(internal::graph_halfedge(f, mesh));
    bool is_torn = false;
    const auto places = layout(h, is_torn);
    const bool is_known = std::isfinite(std::abs(places[0] + places[1] + places[2]));
    report.faces += is_known ? 1 : 0;
    report.torn += is_known && is_torn ? 1 : 0;
    for(const std::complex<double>& place : places) { // of the tail, where the previous halfedge ends
      const double nan = std::numeric_limits<double>::quiet_NaN();
      const Value value = is_known
                              ? internal::picture_place<Value>(0.5 + place.real() / size, 0.5 + place.imag() / size)
                              : internal::picture_place<Value>(nan, nan);
      values.emplace_back(input.next(input.next(h)), value);
      h = input.next(h);
    }
  }
  for(const auto& [h, value] : values)
    put(corners, input.halfedge(h), value);
  return report;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_TEXTURE_COORDINATES_H
