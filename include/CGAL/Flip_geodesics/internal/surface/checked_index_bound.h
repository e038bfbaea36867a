// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKED_INDEX_BOUND_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CHECKED_INDEX_BOUND_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A number of elements as an index, if all of them can be numbered; throws `Invalid_mesh_error` otherwise. */
template <class Count>
Index checked_index_bound(Count count)
{
  if(static_cast<std::uint64_t>(count) >= static_cast<std::uint64_t>((std::numeric_limits<Index>::max)()))
    throw Invalid_mesh_error("the mesh has more elements than 32-bit indices can number");
  return static_cast<Index>(count);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif
