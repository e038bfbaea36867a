// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LAST_LEG_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LAST_LEG_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The last segment of a shortest path to a vertex: the vertex from which it comes straight, its length, and its angle
 * counterclockwise of an input halfedge that starts at the vertex. */
struct Last_leg
{
  Vertex_index from;
  Input_halfedge_index halfedge;
  double angle, length;
};

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LAST_LEG_H
