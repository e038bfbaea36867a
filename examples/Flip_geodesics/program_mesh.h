// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_PROGRAM_MESH_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_PROGRAM_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

// The mesh of the program.
namespace program {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_PROGRAM_MESH_H
