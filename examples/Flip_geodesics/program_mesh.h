// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_PROGRAM_MESH_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_PROGRAM_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cctype>
#include <string>

// The mesh of the program, and what its files are called.
namespace program {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

/// The extension of a file name in lower case, without the dot.
inline std::string extension(const std::string& file)
{
  const std::size_t dot = file.find_last_of("./\\");
  std::string result = dot == std::string::npos || file[dot] != '.' ? "" : file.substr(dot + 1);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_PROGRAM_MESH_H
