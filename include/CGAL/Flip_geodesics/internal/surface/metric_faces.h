// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The faces of a metric. If the metric has exact squared lengths, faces are made of these.

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

class Flat_edges;

/* Detects the optional member of IntrinsicMetric. */
template <class Metric, class = void>
constexpr bool has_squared_lengths = false;
template <class Metric>
constexpr bool
    has_squared_lengths<Metric, std::void_t<decltype(std::declval<const Metric&>().squared_length(
                                    std::declval<const typename Metric::Mesh&>(), Input_halfedge_index()))>> = true;

/* Are the faces of a metric known in exact numbers? */
template <class Metric>
inline constexpr bool has_exact_faces = has_squared_lengths<Metric> || Internals<Metric>::has_exact_faces;

/* The exact squared lengths of a face from h on. */
template <class Metric, class Mesh>
Squared_lengths squared_lengths(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
{
  using Number = std::decay_t<decltype(metric.squared_length(mesh, h))>;
  static_assert(is_rational_number<Number>,
                "squared_length() of a metric has to return an exact rational number, such as cpp_rational or Gmpq");
  const Input_halfedge_index hn = mesh.next(h);
  const Rational_place squares =
      rational_place(to_rational(metric.squared_length(mesh, h)), to_rational(metric.squared_length(mesh, hn)),
                     to_rational(metric.squared_length(mesh, mesh.next(hn))));
  return {squares.numerators, squares.denominator};
}

/* That of the face on the left of h; rounded lengths are for traits that are not those of the package. */
template <class Metric, class Mesh, class Traits>
typename Traits::Face_geometry face_geometry_from_squares(const Metric& metric, const Mesh& mesh,
                                                          Input_halfedge_index h, const Traits& traits)
{
  const Input_halfedge_index hn = mesh.next(h);
  const double a = metric.length(mesh, h), b = metric.length(mesh, hn), c = metric.length(mesh, mesh.next(hn));
  const Squared_lengths squares = squared_lengths(metric, mesh, h);
  if(!squares.satisfy_triangle_inequality())
    throw_triangle_inequality(mesh, h);
  const auto construct = traits.construct_face_from_lengths_object();
  if constexpr(std::is_invocable<decltype(construct), const Squared_lengths&>::value)
    return construct(squares);
  else
    return construct(a, b, c);
}

/* The geometry of the face on the left of h. \throws Degenerate_face_error, Invalid_coordinate_error */
template <class Metric, class Mesh, class Traits>
typename Traits::Face_geometry face_geometry(const Metric& metric, const Mesh& mesh, Input_halfedge_index h,
                                             const Traits& traits)
{
  if constexpr(has_squared_lengths<Metric>)
    return face_geometry_from_squares(metric, mesh, h, traits);
  else
    return metric.face_geometry(mesh, h, traits);
}

/* The same face in exact numbers. */
template <class Metric, class Mesh>
Exact_face exact_face(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
{
  static_assert(has_exact_faces<Metric>, "the metric has no squared_length(), which exact decisions need");
  if constexpr(has_squared_lengths<Metric>)
    return exact_face_from_squares(squared_lengths(metric, mesh, h).numerators);
  else
    return Internals<Metric>::exact_face(metric, mesh, h);
}

/*
 * The sign of the sine of the wedge from the direction of one edge sequence clockwise over `steps` input corners to
 * that of another, exactly, if the faces lie unfolded in one plane of space, or bend along parallel edges only.
 * `flat_edges` caches results for edges. Returns whether the faces lie so, which is false if the metric has no points.
 */
template <class Metric, class Mesh>
bool sine_in_plane(const Metric& metric, const Mesh& mesh, const Edge_sequence& a, const Edge_sequence& b, Index steps,
                   Flat_edges& flat_edges, Sign& sine)
{
  if constexpr(Internals<Metric>::has_exact_faces)
    return Internals<Metric>::sine_in_plane(metric, mesh, a, b, steps, flat_edges, sine);
  else
    return false;
}

/* Metrics of the library's own use have public members for it. */
template <class Metric>
struct Internals_of_members
{
  static constexpr bool has_exact_faces = true;
  static constexpr bool has_usable_faces = true;

  template <class... Arguments>
  static Exact_face exact_face(const Metric& metric, const Arguments&... arguments)
  {
    return metric.exact_face(arguments...);
  }
  template <class... Arguments>
  static bool sine_in_plane(const Metric& metric, Arguments&... arguments)
  {
    return metric.sine_in_plane(arguments...);
  }
  template <class... Arguments>
  static auto vector(const Metric& metric, const Arguments&... arguments)
  {
    return metric.vector(arguments...);
  }
  template <class... Arguments>
  static bool is_usable_face(const Metric& metric, const Arguments&... arguments)
  {
    return metric.is_usable_face(arguments...);
  }
};

/* The exact faces of metrics whose faces are defined by lengths in double. Lengths do not determine which faces lie in
 * one plane. */
struct Internals_of_lengths
{
  static constexpr bool has_exact_faces = true;
  static constexpr bool has_usable_faces = false;

  template <class Metric, class Mesh>
  static Exact_face exact_face(const Metric& metric, const Mesh& mesh, Input_halfedge_index h)
  {
    return exact_face_from_lengths(face_lengths(metric, mesh, h));
  }

  template <class... Arguments>
  static bool sine_in_plane(Arguments&&...)
  {
    return false;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_FACES_H
