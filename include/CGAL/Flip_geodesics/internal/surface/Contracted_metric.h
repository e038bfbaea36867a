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

/* Has a metric its faces in exact numbers? */
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

/* Has the face no area, and does the vertex opposite to its first side lie between the ends of that? */
inline bool is_apex_on_side(const Exact_face& face)
{
  return face.doubled_area_squared == 0 && face.dot_next < 0 && face.dot_previous < 0;
}

/* Do the apexes of two faces lie on the first side, in one place? Of the other face it is the first the other way. */
inline bool are_apexes_in_one_place(const Exact_face& face, const Exact_face& other)
{
  return is_apex_on_side(face) && is_apex_on_side(other) &&
         face.dot_previous * other.squared_length + other.dot_previous * face.squared_length ==
             -(face.squared_length * other.squared_length);
}

/* What a `Zero_edge_contractor` asks of the metric of a mesh. Without exact faces nothing is folded for certain. */
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
