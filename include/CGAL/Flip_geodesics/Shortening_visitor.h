// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTENING_VISITOR_H
#define CGAL_FLIP_GEODESICS_SHORTENING_VISITOR_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsStop
 *
 * A visitor that does nothing; derive from it and hide what you need.
 *
 * \cgalModels{FlipOutVisitor}
 * \cgalModels{RefinementVisitor}
 */
struct Default_shortening_visitor
{
  /// After the edge of halfedge `h` was flipped. A step that is not taken after all flips back without a call.
  template <class Triangulation>
  void on_flip(const Triangulation&, Halfedge_index /* h */)
  {
  }

  /// After a step: a joint of `curve` has been moved over its wedge.
  template <class Network>
  void after_flip_out(const Network&, Curve_index /* curve */)
  {
  }

  /// After `refine()` has inserted vertex `v`, with the flips around it.
  template <class Triangulation>
  void on_insertion(const Triangulation&, Vertex_index /* v */)
  {
  }

  /// Asked before each step: shall the shortening go on?
  bool go_further() { return true; }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTENING_VISITOR_H
