// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What most tests include beside the package, with calls of what most of them call: precompiled together with
// package_info/cmake/shared_instances.h. No test includes it or depends on it.

#ifndef FLIP_GEODESICS_TEST_SHARED_SETTINGS_H
#define FLIP_GEODESICS_TEST_SHARED_SETTINGS_H

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>

#include <CGAL/Polyhedron_3.h>

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>

namespace Flip_geodesics_test {

template <class Setting>
void use_setting(const Mesh_soup& soup)
{
  Setting setting(soup);
  const CGAL::Flip_geodesics::Vertex_index v(0);
  setting.add({}, true);
  setting.add_path(v, v);
  setting.pulled_path(v, v);
  setting.pulled({}, true);
  setting.flips();
  BOOST_TEST(setting.network.is_valid());
}

inline void use_settings(const Mesh_soup& soup)
{
  use_setting<Curve_setting>(soup);
  use_setting<Basic_curve_setting<CGAL::Flip_geodesics::Intrinsic_triangulation<Surface>>>(soup);
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_SHARED_SETTINGS_H
