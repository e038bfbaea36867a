// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Does not compile over number types that cannot be computed with, or without the header for those that can.

#include <CGAL/Flip_geodesics/geodesic_path.h>

#ifdef WITH_HEADER
#include <CGAL/Flip_geodesics/Exact_intrinsic_triangulation_traits.h>
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using Kernel = CGAL::Simple_cartesian<NUMBER>;

void compute(const CGAL::Surface_mesh<Kernel::Point_3>& mesh)
{
  std::vector<Kernel::Point_3> points;
  const auto ends = mesh.vertices();
  FG::geodesic_path(mesh, *ends.begin(), *ends.end(), std::back_inserter(points),
                    CGAL::parameters::geom_traits(FG::Intrinsic_triangulation_traits<Kernel>()));
}
