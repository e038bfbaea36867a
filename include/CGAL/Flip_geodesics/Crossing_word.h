// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CROSSING_WORD_H
#define CGAL_FLIP_GEODESICS_CROSSING_WORD_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * The input edges that an intrinsic edge crosses, from its tail to its head. With its ends, it determines the edge: the
 * straight line in the unfolded faces.
 *
 * There are three cases. The edge lies along the input halfedge `along`, or along a part of it, and crosses nothing. Or
 * it crosses nothing and lies inside the input face of the halfedge `face`. Or `crossed` lists input halfedges, each as
 * a side of the face that is left through it. Then `along` and `face` are `null_index`. Edges inside a face end at an
 * inserted vertex.
 */
struct Crossing_word
{
  Input_halfedge_index along = null_index;   ///< the input halfedge that the edge lies along, if it does
  std::vector<Input_halfedge_index> crossed; ///< in order; empty if nothing is crossed
  Input_halfedge_index face = null_index;    ///< a halfedge of the face that holds the whole edge
  Vertex_index tail = null_index;            ///< the vertex at which the edge starts
  Vertex_index head = null_index;            ///< the vertex at which the edge ends

  /// Turns it into the word of the other direction.
  void reverse()
  {
    along = along == null_index ? null_index : internal::twin_index(along);
    std::swap(tail, head);
    std::reverse(crossed.begin(), crossed.end());
    for(Input_halfedge_index& h : crossed)
      h = internal::twin_index(h);
  }

  /// The word of the other direction.
  Crossing_word reversed() const
  {
    Crossing_word result = *this;
    result.reverse();
    return result;
  }

  /// A halfedge of the input face at the tail. \pre the edge does not lie along an input edge
  Input_halfedge_index first_face() const { return crossed.empty() ? face : crossed.front(); }
  /// A halfedge of the input face at the head. \pre the edge does not lie along an input edge
  Input_halfedge_index last_face() const { return crossed.empty() ? face : internal::twin_index(crossed.back()); }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CROSSING_WORD_H
