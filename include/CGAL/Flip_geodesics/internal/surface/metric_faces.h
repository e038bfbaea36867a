// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_METRIC_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Rational_number.h>
#include <CGAL/Flip_geodesics/internal/numbers/places.h>
#include <CGAL/Flip_geodesics/internal/surface/Internals.h>
#include <CGAL/Flip_geodesics/internal/surface/edge_lengths.h>

#include <CGAL/enum.h>

#include <type_traits>
#include <utility>

// The faces of a metric. If the metric has exact squared lengths, faces are made of these.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
