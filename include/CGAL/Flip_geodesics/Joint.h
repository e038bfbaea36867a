// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_JOINT_H
#define CGAL_FLIP_GEODESICS_JOINT_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsCurves
/// The side of a curve, as seen along it.
enum class Side { LEFT, RIGHT };

/// \ingroup PkgFlipGeodesicsCurves
/// The other side.
inline Side opposite_side(Side side) { return side == Side::LEFT ? Side::RIGHT : Side::LEFT; }

/// \ingroup PkgFlipGeodesicsCurves
/// One side of the joint between a segment and the next one of its curve.
struct Joint
{
  Segment_index incoming; ///< the segment that arrives at the node
  Side side;              ///< on which side of the curve
};

/// \ingroup PkgFlipGeodesicsCurves
/// The end of a segment at a node: an outgoing halfedge, which tells the ends of a loop edge apart, and the segment.
struct Strand_end
{
  Halfedge_index halfedge = null_index; ///< outgoing at the node; null if there is no end
  Segment_index segment = null_index;   ///< which starts or ends there along `halfedge`

  /// Is it no end at all?
  bool is_none() const { return halfedge == null_index; }
  /// Is it the same end?
  bool operator==(const Strand_end& other) const { return halfedge == other.halfedge && segment == other.segment; }
  /// Is it another end?
  bool operator!=(const Strand_end& other) const { return !(*this == other); }
};

/// \ingroup PkgFlipGeodesicsCurves
/// What stands in the wedge at one side of a joint.
enum class Wedge_state {
  FREE,     ///< nothing, and the angle is below \f$\pi\f$: the joint can be shortened
  STRAIGHT, ///< the angle is \f$\pi\f$ or more
  BLOCKED,  ///< another strand, or an edge that another network holds, is in the wedge, at an angle below \f$\pi\f$
  BORDER,   ///< the border of the surface is in the wedge, whose angle is infinite
  FIXED     ///< the node is fixed: the wedge is not looked at
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_JOINT_H
