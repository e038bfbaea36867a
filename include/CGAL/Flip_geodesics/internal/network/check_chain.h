// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_CHECK_CHAIN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_CHECK_CHAIN_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Throws Invalid_curve_error unless the halfedges of a triangulation are a chain, and what touching its faces throws. */
template <class Triangulation, class HalfedgeRange>
void check_chain(const Triangulation& triangulation, const HalfedgeRange& halfedges, bool is_closed)
{
  static_assert(is_range_of<HalfedgeRange, Halfedge_index>,
                "the curve is not a range of halfedges of the triangulation, Halfedge_index");
  std::size_t position = 0;
  Halfedge_index first = null_index, last = null_index;
  for(Halfedge_index h : halfedges) {
    if(!h.is_valid() || h.idx() >= triangulation.number_of_halfedges())
      throw Invalid_curve_error("a curve has a halfedge that the mesh does not have", {position});
    if(last != null_index && triangulation.head(last) != triangulation.tail(h))
      throw Invalid_curve_error("a curve is not connected at position " + std::to_string(position), {position});
    triangulation.length(h); // copies its face, which may throw: before the network changes
    if(first == null_index)
      first = h;
    last = h;
    ++position;
  }
  if(first == null_index)
    throw Invalid_curve_error("a curve has no edge");
  if(is_closed && triangulation.head(last) != triangulation.tail(first))
    throw Invalid_curve_error("a closed curve does not end where it starts", {position});
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_CHECK_CHAIN_H
