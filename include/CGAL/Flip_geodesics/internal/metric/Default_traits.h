// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_METRIC_DEFAULT_TRAITS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_METRIC_DEFAULT_TRAITS_H

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class Metric, class = void>
struct Default_traits_of
{
  using type = Intrinsic_triangulation_traits<typename Metric::Kernel>;
};

template <class Metric>
struct Default_traits_of<Metric, std::void_t<decltype(std::declval<const Metric&>().exact_face(
                                     std::declval<const typename Metric::Mesh&>(), Input_halfedge_index()))>>
{
  using type = Certified_intrinsic_triangulation_traits<typename Metric::Kernel>;
};

/* The traits where none are named: they decide exactly over a metric that has its faces exactly. */
template <class Metric>
using Default_traits = typename Default_traits_of<Metric>::type;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_METRIC_DEFAULT_TRAITS_H
