// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_DECISION_STATISTICS_H
#define CGAL_FLIP_GEODESICS_DECISION_STATISTICS_H

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTraits
/// How the decisions that the filter left open were taken.
struct Decision_statistics
{
  std::size_t by_memory = 0;      ///< as before: of an angle between the same two edges; counted nowhere else
  std::size_t by_strip = 0;       ///< by vectors of doubles, or of pairs of doubles, with an error bound
  std::size_t by_plane = 0;       ///< by points: all faces lie in one plane, or bend along parallel edges only
  std::size_t by_precision = 0;   ///< by numbers of 50 digits with an error bound
  std::size_t by_roots = 0;       ///< by exact arithmetic with the roots of the faces' areas
  std::size_t zeros_by_plane = 0; ///< of `by_plane`: exactly straight
  std::size_t zeros_by_roots = 0; ///< of `by_roots`: exactly straight
  /// Taken for exactly straight without a proof: 50 digits do not tell, and the limit of work was met, see
  /// `Certified_intrinsic_triangulation_traits::sign_work_limit()`.
  std::size_t unproven_zeros = 0;
  /// The largest number of roots in one sign of which no two are rational multiples of each other.
  std::size_t most_roots = 0;

  /// Adds further decisions.
  Decision_statistics& operator+=(const Decision_statistics& other)
  {
    by_memory += other.by_memory;
    by_strip += other.by_strip;
    by_plane += other.by_plane;
    by_precision += other.by_precision;
    by_roots += other.by_roots;
    zeros_by_plane += other.zeros_by_plane;
    zeros_by_roots += other.zeros_by_roots;
    unproven_zeros += other.unproven_zeros;
    most_roots = (std::max)(most_roots, other.most_roots);
    return *this;
  }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_DECISION_STATISTICS_H
