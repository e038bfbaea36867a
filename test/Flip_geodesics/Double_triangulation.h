// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_DOUBLE_TRIANGULATION_H
#define FLIP_GEODESICS_TEST_DOUBLE_TRIANGULATION_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>

#include <CGAL/Kernel_traits.h>

namespace Flip_geodesics_test {

/// With decisions in double: for what is not about arithmetic. It compiles faster than the default.
template <class Mesh>
using Double_triangulation = CGAL::Flip_geodesics::Intrinsic_triangulation<
    Mesh, CGAL::Flip_geodesics::Intrinsic_triangulation_traits<
              typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel, double>>;

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_DOUBLE_TRIANGULATION_H
