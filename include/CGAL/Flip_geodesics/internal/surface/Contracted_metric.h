// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTED_METRIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTED_METRIC_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Detects metrics that provide faces in exact numbers. */
template <class Metric, class = void>
struct Has_exact_faces : std::false_type
{
};

template <class Metric>
struct Has_exact_faces<Metric, std::void_t<decltype(std::declval<const Metric&>().exact_face(
                                   std::declval<const typename Metric::Mesh&>(), Input_halfedge_index()))>>
  : std::true_type
{
};

/* Returns whether the face is degenerate and the vertex opposite to its first side lies between the ends of that
 * side. */
inline bool is_apex_on_side(const Exact_face& face)
{
  return face.doubled_area_squared == 0 && face.dot_next < 0 && face.dot_previous < 0;
}

/* Returns whether the apexes of two faces coincide on the first side, which is that of the other face reversed. */
inline bool are_apexes_in_one_place(const Exact_face& face, const Exact_face& other)
{
  return is_apex_on_side(face) && is_apex_on_side(other) &&
         face.dot_previous * other.squared_length + other.dot_previous * face.squared_length ==
             -(face.squared_length * other.squared_length);
}

/* The operations that a `Zero_edge_contractor` requires of the metric of a mesh. Without exact faces, none is certainly
 * folded. */
template <class Metric>
struct Contracted_metric
{
  const Metric& metric;
  const typename Metric::Mesh& input;

  double length(Input_halfedge_index h) const { return metric.weight(input, h); }

  bool is_folded([[maybe_unused]] Input_halfedge_index h, [[maybe_unused]] Input_halfedge_index t) const
  {
    if constexpr(Has_exact_faces<Metric>::value)
      return are_apexes_in_one_place(metric.exact_face(input, h), metric.exact_face(input, t));
    else
      return false;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTED_METRIC_H
