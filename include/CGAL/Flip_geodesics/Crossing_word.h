// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CROSSING_WORD_H
#define CGAL_FLIP_GEODESICS_CROSSING_WORD_H

#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsRef
 *
 * The input edges that an intrinsic edge crosses, from its tail to its head.
 *
 * Either the intrinsic edge lies along the input halfedge `along`, and crosses nothing; or `along` is `null_index` and
 * `crossed` lists input halfedges, each as a side of the face that is left through it.
 */
struct Crossing_word
{
  Index along = null_index;
  std::vector<Index> crossed;

  /// The word of the other direction.
  Crossing_word reversed() const
  {
    Crossing_word result;
    result.along = along == null_index ? null_index : internal::twin_index(along);
    result.crossed.reserve(crossed.size());
    for(std::size_t i = crossed.size(); i-- > 0;)
      result.crossed.push_back(internal::twin_index(crossed[i]));
    return result;
  }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CROSSING_WORD_H
