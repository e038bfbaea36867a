// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_COMPILED_INSTANCES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_COMPILED_INSTANCES_H

/*
 * The instances in the compiled library: those of the free functions' computations with default options. A header of
 * such functions declares them if CGAL_FLIP_GEODESICS_COMPILED is defined. All other instances are compiled where they
 * are used, as without the library.
 */

#ifdef CGAL_FLIP_GEODESICS_COMPILED

#include <CGAL/Flip_geodesics/Curve_point.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {
namespace compiled {

using Cartesian_mesh = Surface_mesh<Simple_cartesian<double>::Point_3>;
using Filtered_mesh = Surface_mesh<Exact_predicates_inexact_constructions_kernel::Point_3>;

/* The value type of an output. */
template <class Mesh>
using Point = typename Mesh::Point;
template <class Mesh>
using Location = std::pair<typename boost::graph_traits<Mesh>::face_descriptor, std::array<double, 3>>;
template <class Mesh>
using All = Curve_point<Mesh, typename Mesh::Point>;

} // namespace compiled
} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

/* Expands to `INSTANCES(mesh)` for each mesh. */
#define CGAL_FLIP_GEODESICS_FOR_COMPILED_MESHES(INSTANCES)                                                             \
  INSTANCES(compiled::Cartesian_mesh)                                                                                  \
  INSTANCES(compiled::Filtered_mesh)

/* Expands to `INSTANCES(mesh, form)` for each mesh and each value type of an output. */
#define CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(INSTANCES)                                                              \
  INSTANCES(compiled::Cartesian_mesh, compiled::Point<compiled::Cartesian_mesh>)                                       \
  INSTANCES(compiled::Cartesian_mesh, compiled::Location<compiled::Cartesian_mesh>)                                    \
  INSTANCES(compiled::Cartesian_mesh, compiled::All<compiled::Cartesian_mesh>)                                         \
  INSTANCES(compiled::Filtered_mesh, compiled::Point<compiled::Filtered_mesh>)                                         \
  INSTANCES(compiled::Filtered_mesh, compiled::Location<compiled::Filtered_mesh>)                                      \
  INSTANCES(compiled::Filtered_mesh, compiled::All<compiled::Filtered_mesh>)

/* A source file of the library defines one of these macros as `template`; the instances of the other headers are
 * declared. */
#ifndef CGAL_FLIP_GEODESICS_CURVES_INSTANCE
#define CGAL_FLIP_GEODESICS_CURVES_INSTANCE extern template
#endif
#ifndef CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_INSTANCE
#define CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_INSTANCE extern template
#endif
#ifndef CGAL_FLIP_GEODESICS_SHORTEST_PATH_INSTANCE
#define CGAL_FLIP_GEODESICS_SHORTEST_PATH_INSTANCE extern template
#endif
#ifndef CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE
#define CGAL_FLIP_GEODESICS_DISTANCES_INSTANCE extern template
#endif

#endif // CGAL_FLIP_GEODESICS_COMPILED

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_COMPILED_INSTANCES_H
