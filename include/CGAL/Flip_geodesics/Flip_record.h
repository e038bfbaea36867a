// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_FLIP_RECORD_H
#define CGAL_FLIP_GEODESICS_FLIP_RECORD_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsCurves
 *
 * What the log of an `Intrinsic_triangulation` keeps of a flip: enough to take it back, and to derive the crossings of
 * the new edge. If `hp` is `null_index`, nothing was flipped. Either the face of `h` was laid out afresh: then `tn` is
 * `null_index` as well, and the first three vectors are the old ones. Or a point was inserted: then `number` is the
 * number of the insertion, `version_hp` the `gap()`, and `tn` is `h` if its face was split, its twin if its edge was.
 *
 * \tparam Halfedge_geometry that of the triangulation
 */
template <class Halfedge_geometry>
struct Flip_record
{
  Halfedge_index h;         ///< the flipped halfedge, i->j before and l->k after
  Halfedge_index hp;        ///< k->i
  Halfedge_index tn;        ///< i->l
  Index version_hp;         ///< the version of `hp` at the time
  Index version_tn;         ///< the version of `tn` at the time
  Index number;             ///< of input edges that the new edge crosses; -1 if it lies along one
  Index old_version;        ///< of the edge, before
  Index old_crossings;      ///< one more than the number of input edges that the edge crossed before
  Halfedge_geometry old_h;  ///< what `h` stored before
  Halfedge_geometry old_t;  ///< what the other side of the edge stored before
  Halfedge_geometry old_tn; ///< what `tn` stored before
  Halfedge_geometry old_tp; ///< what the halfedge l->j stored before

  /// Was an edge flipped?
  bool is_flip() const { return hp != null_index; }
  /// Was a point inserted?
  bool is_insertion() const { return hp == null_index && tn != null_index; }
  /// Was the point inserted on the edge of `h`, rather than into its face? \pre `is_insertion()`
  bool is_on_edge() const { return tn != h; }
  /// The gap of the crossing word of `h` whose input face holds the inserted point. \pre `is_insertion()`
  Index gap() const { return version_hp; }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_FLIP_RECORD_H
