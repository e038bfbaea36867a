// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_ARITHMETIC_DEFAULT_TRAITS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_ARITHMETIC_DEFAULT_TRAITS_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class TriangleMesh>
using Default_point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type;

template <class TriangleMesh>
using Default_traits = Intrinsic_triangulation_traits<
    typename Kernel_traits<typename boost::property_traits<Default_point_map<TriangleMesh>>::value_type>::Kernel>;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_ARITHMETIC_DEFAULT_TRAITS_H
