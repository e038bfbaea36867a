// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_LOCATED_PLACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_LOCATED_PLACE_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/nearest_location.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class Triangulation, class TriangleMesh, class Place, class = void>
constexpr bool is_place = false;
template <class Triangulation, class TriangleMesh, class Place>
constexpr bool is_place<
    Triangulation, TriangleMesh, Place,
    std::void_t<decltype(surface_location(std::declval<const Triangulation&>(), std::declval<const TriangleMesh&>(),
                                          std::declval<const Place&>()))>> = true;

/* A place on the mesh, of whichever kind, as a location. */
template <class Triangulation, class TriangleMesh, class Place>
Surface_location located_place(const Triangulation& triangulation, const TriangleMesh& mesh, const Place& place)
{
  static_assert(is_place<Triangulation, TriangleMesh, Place>,
                "this is neither a vertex of the mesh nor a Face_location, a Surface_location or a point in space");
  return surface_location(triangulation, mesh, place);
}

template <class Triangulation, class TriangleMesh, class PlaceRange>
std::vector<Surface_location> located(const Triangulation& triangulation, const TriangleMesh& mesh,
                                      const PlaceRange& places)
{
  std::vector<Surface_location> result;
  for(const auto& place : places)
    result.push_back(located_place(triangulation, mesh, place));
  return result;
}

} // namespace internal

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_LOCATED_PLACE_H
