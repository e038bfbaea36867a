// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_FACES_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <array>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsExtraction
/// A face of the intrinsic triangulation; side `i` leads from vertex `i` to vertex `(i + 1) % 3`.
struct Intrinsic_face
{
  std::array<Vertex_index, 3> vertices;    ///< the tails of the halfedges
  std::array<Halfedge_index, 3> halfedges; ///< counterclockwise around the face
  std::array<double, 3> lengths;           ///< of the halfedges, in the unit of the mesh, rounded to double
};

/*!
 * \ingroup PkgFlipGeodesicsExtraction
 *
 * Writes all faces of a triangulation, which contains the curves of its network as edges, ordered by their smallest
 * halfedge, which comes first. Copies what was not touched yet: linear in the mesh.
 */
template <class Triangulation, class OutputIterator>
OutputIterator intrinsic_faces(const Triangulation& triangulation, OutputIterator out)
{
  for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges())) {
    if(triangulation.is_border(h))
      continue;
    const Halfedge_index hn = triangulation.next(h), hp = triangulation.next(hn);
    if(hn < h || hp < h)
      continue;
    *out++ = Intrinsic_face{{triangulation.tail(h), triangulation.tail(hn), triangulation.tail(hp)},
                            {h, hn, hp},
                            {triangulation.length(h), triangulation.length(hn), triangulation.length(hp)}};
  }
  return out;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_FACES_H
