// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_OVERLAPPING_CURVES_H
#define CGAL_FLIP_GEODESICS_OVERLAPPING_CURVES_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>

namespace CGAL {
namespace Flip_geodesics {

template <class Network>
void order_overlapping_curves(Network&)
{
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_OVERLAPPING_CURVES_H
