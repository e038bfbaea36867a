// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Formats, samples to write, and what holds of the files.

#ifndef FLIP_GEODESICS_TEST_WRITERS_WRITER_SETTING_H
#define FLIP_GEODESICS_TEST_WRITERS_WRITER_SETTING_H

#include "Mesh_archetype.h"
#include "generated_meshes.h"
#include "written_files.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>
#include <CGAL/Flip_geodesics/IO/appearance.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <ios>
#include <iterator>
#include <limits>
#include <list>
#include <locale>
#include <map>
#include <numeric>
#include <sstream>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

namespace FG = CGAL::Flip_geodesics;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyline = std::vector<Point>;
using Polylines = std::vector<Polyline>;

// Each way to write, and to read what was written.
struct Format
{
  const char* name;
  bool is_binary, is_of_floats;
  std::function<Written(const std::string&)> read;

  template <class Destination, class... Parts>
  void write(Destination& out, const Parts&... parts) const
  {
    const auto mode = CGAL::parameters::use_binary_mode(is_binary);
    if(std::string(name) == "GLB")
      FG::IO::write_GLB(out, parts..., mode);
    else if(std::string(name) == "OBJ")
      FG::IO::write_OBJ(out, parts..., mode);
    else if(std::string(name) == "PLY")
      FG::IO::write_PLY(out, parts..., mode);
    else
      FG::IO::write_VTP(out, parts..., mode);
  }

  template <class... Parts>
  std::string text(const Parts&... parts) const
  {
    std::ostringstream out;
    write(out, parts...);
    return out.str();
  }
};

inline const std::vector<Format>& formats()
{
  static const std::vector<Format> all = {
      {"GLB", true, true, read_glb},  {"OBJ", false, false, read_obj}, {"PLY", false, false, read_ply},
      {"PLY", true, false, read_ply}, {"VTP", false, false, read_vtp}, {"VTP", true, false, read_vtp},
  };
  return all;
}

// Numbers that do not come back from fewer digits, or by another way than the bits.
inline const std::vector<double>& awkward_numbers()
{
  static const std::vector<double> all = {
      0.1, 1.0 / 3, -2.0 / 3, std::nextafter(1.0, 2.0), 1e-310, -1e150, 123456789.123456789, 5e-324, -0.0, 1e22};
  return all;
}

inline Mesh sample_mesh()
{
  return to_mesh<Mesh>(grid(3, 2, Diagonal_rule::ALTERNATING, [](int i, int j) { return 0.3 * i * i - 0.1 * j; }));
}

inline Polylines sample_curves()
{
  return {{Point(0, 0, 0), Point(0.1, 0.7, 0.3), Point(1.0 / 3, 2, 0)},
          {},
          {Point(1, 1, 1)},
          {Point(2, 0, 0), Point(0, 0, 2)}};
}

inline bool is_same(double a, double b, bool are_floats)
{
  return are_floats ? std::abs(a - b) < 1e-6 : (a == b && std::signbit(a) == std::signbit(b));
}

inline void check_points(const Format& format, const std::vector<std::array<double, 3>>& found,
                         const Polyline& expected, std::size_t first)
{
  BOOST_REQUIRE_GE(found.size(), first + expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i)
    for(int k = 0; k < 3; ++k)
      BOOST_CHECK_MESSAGE(is_same(found[first + i][k], expected[i][k], format.is_of_floats),
                          format.name << ": coordinate " << k << " of point " << first + i << " is "
                                      << found[first + i][k] << ", not " << expected[i][k]);
}

// Takes so many bytes and no more, as a disk does.
class Small_disk : public std::streambuf
{
public:
  explicit Small_disk(std::size_t space)
    : m_space(space)
  {
  }

protected:
  int_type overflow(int_type c) override { return m_space-- == 0 ? (m_space = 0, traits_type::eof()) : c; }

private:
  std::size_t m_space;
};

struct German_numbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// The directed edges of triangles; each at most once in an oriented manifold.
inline std::map<std::pair<long, long>, int> directed_edges(const std::vector<std::array<long, 3>>& triangles)
{
  std::map<std::pair<long, long>, int> edges;
  for(const auto& t : triangles)
    for(int i = 0; i < 3; ++i)
      ++edges[{t[i], t[(i + 1) % 3]}];
  return edges;
}

inline long euler_characteristic_of_closed(const Written& file)
{
  const auto edges = directed_edges(file.triangles);
  for(const auto& [edge, count] : edges)
    BOOST_CHECK(count == 1 && edges.count({edge.second, edge.first}) == 1);
  return static_cast<long>(file.points.size()) - static_cast<long>(edges.size() / 2) +
         static_cast<long>(file.triangles.size());
}

inline double volume(const Written& file)
{
  double sum = 0;
  for(const auto& t : file.triangles) {
    const auto &p = file.points[t[0]], &q = file.points[t[1]], &r = file.points[t[2]];
    sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return sum / 6;
}

inline double longest_edge(const Written& file)
{
  double result = 0;
  for(const auto& t : file.triangles)
    for(int i = 0; i < 3; ++i) {
      const auto &p = file.points[t[i]], &q = file.points[t[(i + 1) % 3]];
      result = (std::max)(result, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  return result;
}

inline Written tube_of(const Polyline& curve, double radius, int sides)
{
  std::ostringstream out;
  FG::IO::write_PLY(out, Polylines{curve}, FG::IO::Tubes(radius, sides));
  return read_ply(out.str());
}

// A closed curve; its last point is its first.
template <class Position>
Polyline closed_curve(int n, const Position& position)
{
  Polyline result;
  for(int i = 0; i < n; ++i)
    result.push_back(position(2 * pi * i / n));
  result.push_back(result.front());
  return result;
}

// Calls a function and returns the elements of the error that it throws, after looking that nothing was written.
template <class Error, class Write>
std::vector<std::size_t> elements_of_error(const Write& write)
{
  std::ostringstream out;
  std::vector<std::size_t> elements = {987654321};
  try {
    write(out);
  } catch(const Error& error) {
    elements = error.elements();
  }
  BOOST_CHECK(out.str().empty());
  BOOST_CHECK(out);
  return elements;
}

using Elements = std::vector<std::size_t>;

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_WRITERS_WRITER_SETTING_H
