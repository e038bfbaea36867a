// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_DESCRIPTORS_H
#define FLIP_GEODESICS_TEST_DESCRIPTORS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

namespace Flip_geodesics_test {

/// Descriptors by their numbers: `3_v` is vertex 3.
inline namespace descriptor_literals {

constexpr CGAL::Flip_geodesics::Vertex_index operator""_v(unsigned long long number)
{
  return CGAL::Flip_geodesics::Vertex_index(static_cast<CGAL::Flip_geodesics::Index>(number));
}

constexpr CGAL::Flip_geodesics::Halfedge_index operator""_h(unsigned long long number)
{
  return CGAL::Flip_geodesics::Halfedge_index(static_cast<CGAL::Flip_geodesics::Index>(number));
}

constexpr CGAL::Flip_geodesics::Input_halfedge_index operator""_input_h(unsigned long long number)
{
  return CGAL::Flip_geodesics::Input_halfedge_index(static_cast<CGAL::Flip_geodesics::Index>(number));
}

constexpr CGAL::Flip_geodesics::Edge_index operator""_e(unsigned long long number)
{
  return CGAL::Flip_geodesics::Edge_index(static_cast<CGAL::Flip_geodesics::Index>(number));
}

constexpr CGAL::Flip_geodesics::Segment_index operator""_s(unsigned long long number)
{
  return CGAL::Flip_geodesics::Segment_index(static_cast<CGAL::Flip_geodesics::Index>(number));
}

constexpr CGAL::Flip_geodesics::Curve_index operator""_c(unsigned long long number)
{
  return CGAL::Flip_geodesics::Curve_index(static_cast<CGAL::Flip_geodesics::Index>(number));
}

} // namespace descriptor_literals
} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_DESCRIPTORS_H
