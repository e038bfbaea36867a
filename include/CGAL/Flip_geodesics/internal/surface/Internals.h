// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERNALS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_INTERNALS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace CGAL {
namespace Flip_geodesics {

struct Surface_location;

namespace internal {

struct Known_piece;

/*
 * The members of the library's own classes that it uses beyond their documentation. The header of such a class
 * specializes this template. Other models of a concept provide only what the concept requires, and the library works
 * without the rest.
 */
template <class Model>
struct Internals
{
  static constexpr bool has_exact_faces = false;     // provides exact_face()
  static constexpr bool has_precise_numbers = false; // provides precise_edge(), precise_halfedge() and flat_edges()
  static constexpr bool has_usable_faces = false;    // provides is_usable_face()

  /* Inserts a point as a vertex of a triangulation, without using the known piece close to it. */
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
