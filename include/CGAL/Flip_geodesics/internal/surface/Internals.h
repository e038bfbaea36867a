// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERNALS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERNALS_H

#include <CGAL/Flip_geodesics/Surface_point.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What the library uses of its own classes beyond their documentation. The header of such a class specializes this
 * template. Other models of a concept have nothing but what the concept requires, and the library does without the
 * rest.
 */
template <class Model>
struct Internals
{
  static constexpr bool has_exact_faces = false;     // with exact_face()
  static constexpr bool has_precise_numbers = false; // with precise_edge(), precise_halfedge() and flat_edges()

  /* Makes a point a vertex of a triangulation. That it lies close to a known piece is not used. */
  template <class OnSplit>
  static Vertex_index insert(Model& model, const Surface_location& location, const OnSplit& on_split, Known_piece&)
  {
    return model.insert(location, on_split);
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERNALS_H
