// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INPUT_FACE_GEOMETRY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INPUT_FACE_GEOMETRY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The vectors of the input face on the left of h, from h on, in the numbers of some traits; it has to be a triangle. */
template <class Triangulation, class Traits>
auto input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h, const Traits& traits)
{
  check_triangle(triangulation.input(), h);
  return triangulation.metric().face_geometry(triangulation.input(), h, traits);
}

/* The same in double, with h on the positive real axis, of a face that has been found to be a triangle. */
template <class Triangulation>
auto known_input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h)
{
  using Double_traits = Intrinsic_triangulation_traits<typename Triangulation::Metric::Kernel>;
  return triangulation.metric().face_geometry(triangulation.input(), h, Double_traits());
}

/* The same of any face. */
template <class Triangulation>
auto input_face_geometry(const Triangulation& triangulation, Input_halfedge_index h)
{
  check_triangle(triangulation.input(), h);
  return known_input_face_geometry(triangulation, h);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INPUT_FACE_GEOMETRY_H
