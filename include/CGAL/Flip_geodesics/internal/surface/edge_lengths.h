// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EDGE_LENGTHS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EDGE_LENGTHS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Rational_number.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Lengths whose squares and products of squares are normal doubles, by the range in tolerances.h. */
inline bool is_usable_length(double length) { return length > least_length && length < greatest_length; }

/* The same for searches along edges, which pass degenerate edges. */
inline bool is_zero_or_usable_length(double length) { return length == 0 || is_usable_length(length); }

/* Returns whether a > b + c, exactly. */
inline bool is_longer_than_sum(double a, double b, double c)
{
  const Double_double sum = exact_sum(b, c);
  return a > sum.high || (a == sum.high && sum.low < 0);
}

[[noreturn]] inline void throw_unusable_length(double length, Vertex_index v, Vertex_index w)
{
  const std::string edge = "the edge between vertices " + std::to_string(v.idx()) + " and " + std::to_string(w.idx());
  const std::vector<std::size_t> elements = {static_cast<std::size_t>(v.idx()), static_cast<std::size_t>(w.idx())};
  if(length == 0)
    throw Degenerate_face_error(edge + " has length zero", elements, Degeneracy_remedy::CONTRACT);
  std::ostringstream number;
  number << length;
  throw Invalid_coordinate_error(
      edge + " has the length " + number.str() + ", which is not a number between 1e-70 and 1e70", elements);
}

inline bool satisfy_triangle_inequality(double a, double b, double c)
{
  return !is_longer_than_sum(a, b, c) && !is_longer_than_sum(b, c, a) && !is_longer_than_sum(c, a, b);
}

/* Has a metric the places of vertices in space, from which it lays out faces? */
template <class Metric>
inline constexpr bool has_places_in_space = std::is_same<typename Metric::Place, std::array<double, 3>>::value ||
                                            std::is_same<typename Metric::Place, Approximate_place>::value;

/* Returns whether a metric makes the vectors of a face, without throwing an exception. */
template <class Metric, class Input_mesh>
bool is_usable_face(const Metric& metric, const Input_mesh& mesh, Input_halfedge_index h)
{
  if constexpr(Internals<Metric>::has_usable_faces) {
    return Internals<Metric>::is_usable_face(metric, mesh, h);
  } else {
    const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
    const double a = metric.weight(mesh, h), b = metric.weight(mesh, hn), c = metric.weight(mesh, hp);
    return is_usable_length(a) && is_usable_length(b) && is_usable_length(c) &&
           (has_places_in_space<Metric> || satisfy_triangle_inequality(a, b, c));
  }
}

template <class Input_mesh>
[[noreturn]] void throw_triangle_inequality(const Input_mesh& mesh, Input_halfedge_index h)
{
  const Index u = mesh.tail(h).idx(), v = mesh.tail(mesh.next(h)).idx(), w = mesh.tail(mesh.previous(h)).idx();
  throw Degenerate_face_error("the edge lengths of the face with vertices " + std::to_string(u) + ", " +
                                  std::to_string(v) + ", " + std::to_string(w) + " violate the triangle inequality",
                              {static_cast<std::size_t>(u), static_cast<std::size_t>(v), static_cast<std::size_t>(w)});
}

/* Throws if the lengths of a face, from `h` on, violate the triangle inequality. */
template <class Input_mesh>
void check_triangle_inequality(const Input_mesh& mesh, Input_halfedge_index h, double a, double b, double c)
{
  if(!satisfy_triangle_inequality(a, b, c))
    throw_triangle_inequality(mesh, h);
}

/* Returns the length of an edge for a metric that defines its weight. \throws the exceptions of IntrinsicMetric */
template <class Metric, class Input_mesh>
double length_by_weight(const Metric& metric, const Input_mesh& mesh, Input_halfedge_index h)
{
  const double length = metric.weight(mesh, h);
  if(!is_usable_length(length))
    throw_unusable_length(length, mesh.tail(h), mesh.tail(twin_index(h)));
  return length;
}

/* Returns the lengths of the sides of a face, from `h` on. */
template <class Metric, class Input_mesh>
std::array<double, 3> face_lengths(const Metric& metric, const Input_mesh& mesh, Input_halfedge_index h)
{
  const Input_halfedge_index hn = mesh.next(h), hp = mesh.next(hn);
  return {metric.length(mesh, h), metric.length(mesh, hn), metric.length(mesh, hp)};
}

/* Returns the geometry of the face with these lengths. \throws Degenerate_face_error, Invalid_coordinate_error */
template <class Metric, class Input_mesh, class Traits>
typename Traits::Face_geometry face_geometry_by_lengths(const Metric& metric, const Input_mesh& mesh,
                                                        Input_halfedge_index h, const Traits& traits)
{
  const auto [a, b, c] = face_lengths(metric, mesh, h);
  check_triangle_inequality(mesh, h, a, b, c);
  return traits.construct_face_from_lengths_object()(a, b, c);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_EDGE_LENGTHS_H
