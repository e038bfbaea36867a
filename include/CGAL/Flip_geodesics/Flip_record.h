// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_FLIP_RECORD_H
#define CGAL_FLIP_GEODESICS_FLIP_RECORD_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsRef
 *
 * What the log of an `Intrinsic_triangulation` keeps of a flip: enough to take it back, and to derive the crossings of
 * the new edge. Where `hp` is `null_index`, nothing was flipped: either the face of `h` was laid out afresh, `tn` is
 * `null_index` as well, and the first three vectors are the old ones; or a point was inserted, and `rotation` is the
 * number of the insertion.
 *
 * \tparam Halfedge_geometry that of the triangulation
 */
template <class Halfedge_geometry>
struct Flip_record
{
  Halfedge_index h;             ///< the flipped halfedge, i->j before and l->k after
  Halfedge_index hp, tn;        ///< k->i and i->l
  Index version_hp, version_tn; ///< their versions at the time
  Index rotation;               ///< how many input edges a turn about i from ik to il crosses
  Index old_version, old_crossings;
  Halfedge_geometry old_h, old_t, old_tn, old_tp;

  /// Was an edge flipped?
  bool is_flip() const { return hp != null_index; }
  /// Was a point inserted?
  bool is_insertion() const { return hp == null_index && tn != null_index; }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_FLIP_RECORD_H
