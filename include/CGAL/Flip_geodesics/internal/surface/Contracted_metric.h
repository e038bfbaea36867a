// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTED_METRIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTED_METRIC_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/surface/metric_faces.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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

  /* Points need no exact comparison: two sides that join the same two places have the same rounded length. */
  bool are_equally_long(Input_halfedge_index g, Input_halfedge_index h) const
  {
    if constexpr(has_squared_lengths<Metric>)
      return metric.squared_length(input, g) == metric.squared_length(input, h);
    else
      return !(length(g) < length(h) || length(h) < length(g));
  }

  bool is_folded([[maybe_unused]] Input_halfedge_index h, [[maybe_unused]] Input_halfedge_index t) const
  {
    if constexpr(has_exact_faces<Metric>)
      return are_apexes_in_one_place(exact_face(metric, input, h), exact_face(metric, input, t));
    else
      return false;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTRACTED_METRIC_H
