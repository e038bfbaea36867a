// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SOUP_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <vector>

namespace program {

/// Points and polygons as they are in a file, in its order. All coordinates are finite, unless an `Input_text` may have
/// others; all indices are those of points.
struct Soup
{
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::string> remarks = {}; ///< a line for each thing that a user should know about the file
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SOUP_H
