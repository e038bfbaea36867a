// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_COMPILED_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_COMPILED_H

/*
 * Linking to CGAL::Flip_geodesics_compiled defines CGAL_FLIP_GEODESICS_COMPILED. Headers then declare the computations
 * behind their free functions without defining them, which saves more than half of the compilation time. The library
 * contains the most common instances; a source that needs others defines CGAL_FLIP_GEODESICS_HEADER_ONLY.
 */
#if defined(CGAL_FLIP_GEODESICS_COMPILED) && !defined(CGAL_FLIP_GEODESICS_HEADER_ONLY)
#define CGAL_FLIP_GEODESICS_DECLARATIONS_ONLY
#endif

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <type_traits>

namespace CGAL {

class Epick;

namespace Flip_geodesics {
namespace internal {
namespace compiled {

template <class TriangleMesh>
constexpr bool is_known_mesh = false;
template <class K>
constexpr bool is_known_mesh<Surface_mesh<Point_3<K>>> =
    std::is_same<K, Simple_cartesian<double>>::value || std::is_same<K, Epick>::value;

/* Complete if any included header has the definitions. */
template <class TriangleMesh>
struct Definitions;

template <class TriangleMesh, class = void>
constexpr bool are_defined = false;
template <class TriangleMesh>
constexpr bool are_defined<TriangleMesh, std::void_t<decltype(sizeof(Definitions<TriangleMesh>))>> = true;

/* Reports a missing definition or instance when compiling, not only when linking. */
template <class TriangleMesh, class NamedParameters>
constexpr void check_instance()
{
  constexpr bool is_in_library =
      is_known_mesh<TriangleMesh> && std::is_same<NamedParameters, parameters::Default_named_parameters>::value;
  static_assert(is_in_library || are_defined<TriangleMesh>,
                "the compiled library has no instance for this mesh, or none with options: define "
                "CGAL_FLIP_GEODESICS_HEADER_ONLY before the first header of the package is included");
}

} // namespace compiled
} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_COMPILED_H
