// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_DESCRIPTORS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_DESCRIPTORS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

struct Overlay_vertex_element
{
  static constexpr const char* letter = "overlay v";
};

struct Overlay_halfedge_element
{
  static constexpr const char* letter = "overlay h";
};

/* The elements of an overlay, which are neither the input's nor the triangulation's. */
using Overlay_vertex = Descriptor<Overlay_vertex_element>;
using Overlay_halfedge = Descriptor<Overlay_halfedge_element>;

/* One value for each of them. */
template <class T>
using Per_overlay_vertex = Indexed_by<Overlay_vertex, std::vector<T>>;
template <class T>
using Per_overlay_halfedge = Indexed_by<Overlay_halfedge, std::vector<T>>;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_OVERLAY_DESCRIPTORS_H
