// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_DEFAULT_TRAITS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_DEFAULT_TRAITS_H

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/surface/Contracted_metric.h>

#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The traits where none are named: they decide exactly over a metric that has its faces exactly. */
template <class Metric>
using Default_traits = std::conditional_t<Has_exact_faces<Metric>::value,
                                          Certified_intrinsic_triangulation_traits<typename Metric::Kernel>,
                                          Intrinsic_triangulation_traits<typename Metric::Kernel>>;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_DEFAULT_TRAITS_H
