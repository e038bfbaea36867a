// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SURFACE_POINTS_H
#define CGAL_FLIP_GEODESICS_SURFACE_POINTS_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Point_side.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {

template <class TriangleMesh>
struct Curve_place;

/// \ingroup PkgFlipGeodesicsBuilders
/// The location of vertex `v` of a mesh. \throws Vertex_out_of_range_error if it is none, or isolated
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
 * The location of a face and barycentric coordinates, a `CGAL::Polygon_mesh_processing::Face_location`: the coordinates
 * belong to the source, target and third vertex of `halfedge(face, mesh)`.
 *
 * This is where points are snapped, once: coordinates of at most `snap` count as exactly zero. So points that were
 * located with rounding, at -5.6e-17 for instance, are on the edge or at the vertex that is meant.
 *
 * \param snap a barycentric coordinate, not negative and below 1/3; 1e-12 unless given
 * \throws Invalid_location_error if the face is null or none of the mesh's, a coordinate is less than `-snap` or no number, or the three do
 *         not sum to one within 1e-6
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
    const double weight = CGAL::to_double(location.second[i]);
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
/// \throws Invalid_location_error
template <class Triangulation, class FT>
Surface_location surface_location(
    const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
    const std::pair<typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor,
                    std::array<FT, 3>>& location)
{
  return surface_location(triangulation, mesh, location, internal::default_snap);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a point of a curve: the location of a vertex, or of the point on the edge that is crossed.
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh&,
                                  const Surface_point& point)
{
  return internal::surface_location(triangulation, point);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Converts a `Curve_place`, a `Curve_point` or a `Curve_sample`, as their `location`.
/// \throws Invalid_location_error
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const Curve_place<typename Triangulation::Triangle_mesh>& place)
{
  return surface_location(triangulation, mesh, place.location);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// A location as it is.
template <class Triangulation>
Surface_location surface_location(const Triangulation&, const typename Triangulation::Triangle_mesh&,
                                  const Surface_location& location)
{
  return location;
}

namespace internal {

/*
 * The input location of a point near an intrinsic edge, by its vector from the edge's tail in the frame of the edge's
 * strip: of the input faces along the edge, that in which the smallest weight is largest.
 */
template <class Triangulation>
class Location_finder
{
  using Vector = std::complex<double>;

public:
  explicit Location_finder(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Looks at the faces along an edge; `along` is the vector with the edge itself as 1. */
  void look_along(const Crossing_word& word, const Vector& along)
  {
    if(word.crossed.empty())
      return look_in_one_face(word, along);
    const Strip<Triangulation> strip(m_triangulation, word);
    const Vector point = along * strip.end();
    for(std::size_t gap = 0; gap <= word.crossed.size(); ++gap) {
      const auto corners = strip.face(gap);
      std::array<double, 3> weights;
      for(int i = 0; i < 3; ++i)
        weights[i] = cross(corners[(i + 1) % 3].position - point, corners[(i + 2) % 3].position - point);
      note(Point_side<Triangulation>::face_of_gap(word, gap), weights);
    }
  }

  /* The best face, and weights there that are not negative. */
  Surface_location result() const
  {
    Surface_location result = m_best;
    const double sum = result.weights[0] + result.weights[1] + result.weights[2];
    for(double& weight : result.weights)
      weight = weight / sum < zero_weight ? 0 : weight / sum;
    return canonical_location(m_triangulation.input(), result);
  }

  /* The best face, and weights there that are all positive; those on an edge of the face keep what
   * is exactly zero. */
  Surface_location result_inside(bool is_on_edge = false) const
  {
    constexpr double least = 1.0 / (1LL << 50);
    Surface_location result = m_best;
    const double sum = result.weights[0] + result.weights[1] + result.weights[2];
    for(double& weight : result.weights)
      if(!is_on_edge || weight != 0)
        weight = (std::max)(weight / sum, least);
    return result;
  }

private:
  void note(Input_halfedge_index face, const std::array<double, 3>& weights)
  {
    const double sum = weights[0] + weights[1] + weights[2];
    const double smallest = (std::min)({weights[0], weights[1], weights[2]}) / sum;
    if(!(sum > 0) || !(smallest > m_smallest))
      return;
    m_smallest = smallest;
    m_best = {face, weights};
  }

  // In the face on the left of an edge along an input edge, or in that which holds the edge.
  void look_in_one_face(const Crossing_word& word, const Vector& along)
  {
    const Input_halfedge_index h = Point_side<Triangulation>::face_of_gap(word, 0);
    const auto& input = m_triangulation.input();
    const auto from = vertex_weights(m_triangulation, word.tail, input.is_border(h) ? twin_index(h) : h);
    const auto to = vertex_weights(m_triangulation, word.head, input.is_border(h) ? twin_index(h) : h);
    const double from_sum = from[0] + from[1] + from[2], to_sum = to[0] + to[1] + to[2];
    std::array<double, 3> weights;
    for(int i = 0; i < 3; ++i)
      weights[i] = (1 - along.real()) * (from[i] / from_sum) + along.real() * (to[i] / to_sum);
    if(along.imag() != 0)
      add_height(word, h, along.imag(), weights);
    note(input.is_border(h) ? twin_index(h) : h, weights);
  }

  // Moves weights to the left of the edge by a part of its length.
  void add_height(const Crossing_word& word, Input_halfedge_index h, double height,
                  std::array<double, 3>& weights) const
  {
    const auto f = input_face_geometry(m_triangulation, h);
    const Vector u(f[0].x, f[0].y), v(-f[2].x, -f[2].y); // the two sides at the tail of h
    const Vector left = height * Vector(0, 1) * barycentric_vector(word, h, u, v);
    const double area = cross(u, v), at_head = cross(left, v) / area, at_apex = cross(u, left) / area;
    weights[0] -= at_head + at_apex;
    weights[1] += at_head;
    weights[2] += at_apex;
  }

  Vector barycentric_vector(const Crossing_word& word, Input_halfedge_index h, const Vector& u, const Vector& v) const
  {
    const auto d = barycentric_difference(vertex_weights(m_triangulation, word.tail, h),
                                          vertex_weights(m_triangulation, word.head, h));
    return d[1] * u + d[2] * v;
  }

  const Triangulation& m_triangulation;
  Surface_location m_best;
  double m_smallest = -std::numeric_limits<double>::infinity();
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The input location, rounded, of the point that divides intrinsic edge `edge(h)`: `t` of the way from the tail of `h`
 * to its head. It lies on an input edge exactly if the whole edge does. Linear in the input edges that are crossed.
 * \pre 0 < `t` < 1
 */
template <class Triangulation>
Surface_location location_on_edge(const Triangulation& triangulation, Halfedge_index h, double t)
{
  internal::Location_finder<Triangulation> finder(triangulation);
  const Crossing_word word = triangulation.crossing_word(h);
  finder.look_along(word, t);
  return internal::canonical_location(triangulation.input(), finder.result_inside(word.along != null_index));
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The input location, rounded, of the point of an intrinsic face with barycentric coordinates at the tail of `h`, its
 * head, and the third vertex: among the input faces along the face's sides, the one that holds it. Every input face
 * that meets the intrinsic face is among them. Linear in the input edges that the sides cross. \pre `h` is not on the
 * border, and the coordinates are not negative and sum to one
 */
template <class Triangulation>
Surface_location location_in_face(const Triangulation& triangulation, Halfedge_index h,
                                  const std::array<double, 3>& coordinates)
{
  internal::Location_finder<Triangulation> finder(triangulation);
  for(int i = 0; i < 3; ++i, h = triangulation.next(h)) {
    // By lengths alone, which all traits have.
    const double a = triangulation.length(h), b = triangulation.length(triangulation.next(h)),
                 c = triangulation.length(triangulation.previous(h));
    const double x = ((a - b) * (a + b) + c * c) / (2 * a), y = std::sqrt((std::max)((c - x) * (c + x), 0.0));
    const std::complex<double> apex(x / a, y / a);
    finder.look_along(triangulation.crossing_word(h), coordinates[(i + 1) % 3] + coordinates[(i + 2) % 3] * apex);
  }
  return finder.result();
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

/* The barycentric coordinates of a point of a triangle, and how far it is from the origin. */
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

/* The point of side i, from corner i to the next, that is nearest to the origin. */
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

/* The foot of the perpendicular from the origin, by the areas that it cuts off; not finite without an area. */
inline std::array<double, 3> foot_of_perpendicular(const Triangle_places& corners)
{
  const Place_in_space u = difference(corners[1], corners[0]), v = difference(corners[2], corners[0]);
  const Place_in_space normal = cross(u, v), &from = corners[0]; // to the origin it is minus that
  const double squared = dot(normal, normal);
  const double at_1 = dot(cross(v, from), normal) / squared, at_2 = dot(cross(from, u), normal) / squared;
  return {{1 - at_1 - at_2, at_1, at_2}};
}

/*
 * The point of a triangle that is nearest to the origin: the foot of the perpendicular if that lies inside, or a point
 * of a side; the nearest of these, so that in needles, where the first is inaccurate, another one is taken. Computed at
 * the triangle's own scale, so that no square is too small or too large.
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
  if(*std::min_element(foot.begin(), foot.end()) > 0) // never without an area
    consider(foot);
  return result;
}

/* Half the coordinates of a point: differences of such numbers are finite. */
template <class Point>
Place_in_space half_of(const Point& p)
{
  return {{CGAL::to_double(p.x()) / 2, CGAL::to_double(p.y()) / 2, CGAL::to_double(p.z()) / 2}};
}

/* The corner of a face of the mesh at the tail of a halfedge, as seen from a place. */
template <class Triangulation>
Place_in_space corner_seen_from(const Triangulation& triangulation, Input_halfedge_index h, const Place_in_space& from)
{
  const auto& input = triangulation.input().uncontracted();
  const Vertex_index v = input.tail(h);
  const Place_in_space p = half_of(triangulation.metric().point(input, v));
  if(!are_finite(p))
    throw Invalid_coordinate_error("vertex " + std::to_string(v.idx()) + " has a coordinate that is no finite number",
                                   {static_cast<std::size_t>(v.idx())});
  return {{p[0] - from[0], p[1] - from[1], p[2] - from[2]}};
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The location of the point of the mesh that is nearest to a point in space, up to rounding. Where several are as near,
 * it is one of them. It is put on an edge or a vertex where barycentric coordinates are at most 1e-9.
 *
 * All faces are looked at. For many points, `CGAL::Polygon_mesh_processing::locate_with_AABB_tree()` saves time; it
 * gives `Face_location`s.
 *
 * \throws Invalid_location_error if the mesh has no face, or a coordinate of the point is no finite number
 * \throws Invalid_coordinate_error if one of the mesh is not
 * \throws Invalid_mesh_error if a face is not a triangle
 *
 * Complexity: linear in the faces of the mesh.
 */
template <class Triangulation>
Surface_location surface_location(const Triangulation& triangulation, const typename Triangulation::Triangle_mesh& mesh,
                                  const typename Triangulation::Metric::Point_3& point)
{
  using Face = typename boost::graph_traits<typename Triangulation::Triangle_mesh>::face_descriptor;
  const internal::Place_in_space from = internal::half_of(point);
  if(!internal::are_finite(from))
    throw Invalid_location_error("a point in space has a coordinate that is no finite number");
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SURFACE_POINTS_H
