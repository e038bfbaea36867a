// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_IS_CURVE_NETWORK_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_IS_CURVE_NETWORK_H

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Is a type a model of CurveNetwork, rather than a triangulation? Told by the curves of one. */
template <class T, class = void>
struct Is_curve_network : std::false_type
{
};

template <class T>
struct Is_curve_network<T,
                        std::void_t<typename T::Triangulation, decltype(std::declval<const T&>().number_of_curves())>>
  : std::true_type
{
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_IS_CURVE_NETWORK_H
