// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_IS_VALID_HALFEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_IS_VALID_HALFEDGE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Does the face on the left of h close, and, if the twin's face is known, do both sides have one length and vertex? */
template <class Triangulation>
bool is_valid_halfedge(const Triangulation& triangulation, Halfedge_index h, double tolerance, bool is_twin_known)
{
  const Halfedge_index t = Triangulation::twin(h), hn = triangulation.next(h), hp = triangulation.next(hn);
  if(triangulation.next(hp) != h || (is_twin_known && triangulation.tail(t) != triangulation.tail(hn)))
    return false;
  const double a = triangulation.length(h), b = triangulation.length(hn), c = triangulation.length(hp);
  const double scale = tolerance * (std::max)({a, b, c});
  if(a > b + c + scale)
    return false;
  return !is_twin_known || triangulation.is_border(t) || std::abs(a - triangulation.length(t)) <= scale;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_IS_VALID_HALFEDGE_H
