// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CHECK_HAS_NO_CURVES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CHECK_HAS_NO_CURVES_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <string>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* For what may have to flip any edge. \throws Occupied_triangulation_error if a network has curves there */
template <class Triangulation>
void check_has_no_curves(const Triangulation& triangulation, const std::string& what_is_impossible)
{
  if(triangulation.number_of_holds() > 0)
    throw Occupied_triangulation_error(what_is_impossible + " in a triangulation in which a network has curves");
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_CHECK_HAS_NO_CURVES_H
