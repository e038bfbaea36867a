// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_POLYLINES_IO_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_POLYLINES_IO_H

#include <fstream>
#include <limits>
#include <string>
#include <vector>

/// Writes polylines in the format `.polylines.txt` of CGAL's demo: a line each, the number of points and the points.
template <class Point>
bool write_polylines(const std::string& file, const std::vector<std::vector<Point>>& polylines)
{
  std::ofstream out(file);
  out.precision(std::numeric_limits<double>::max_digits10);
  for(const std::vector<Point>& polyline : polylines) {
    out << polyline.size();
    for(const Point& p : polyline)
      out << ' ' << p;
    out << '\n';
  }
  return static_cast<bool>(out.flush());
}

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_POLYLINES_IO_H
