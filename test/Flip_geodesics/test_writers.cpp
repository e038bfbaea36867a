// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE writers

#include "Mesh_archetype.h"
#include "generated_meshes.h"
#include "written_files.h"

#include <CGAL/Flip_geodesics/IO/GLB.h>
#include <CGAL/Flip_geodesics/IO/OBJ.h>
#include <CGAL/Flip_geodesics/IO/PLY.h>
#include <CGAL/Flip_geodesics/IO/Tubes.h>
#include <CGAL/Flip_geodesics/IO/VTP.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

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
#include <sstream>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Polyline = std::vector<Point>;
using Polylines = std::vector<Polyline>;

namespace {

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

const std::vector<Format>& formats()
{
  static const std::vector<Format> all = {
      {"GLB", true, true, read_glb},  {"OBJ", false, false, read_obj}, {"PLY", false, false, read_ply},
      {"PLY", true, false, read_ply}, {"VTP", false, false, read_vtp}, {"VTP", true, false, read_vtp},
  };
  return all;
}

// Numbers that do not come back from fewer digits, or by another way than the bits.
const std::vector<double>& awkward_numbers()
{
  static const std::vector<double> all = {
      0.1, 1.0 / 3, -2.0 / 3, std::nextafter(1.0, 2.0), 1e-310, -1e150, 123456789.123456789, 5e-324, -0.0, 1e22};
  return all;
}

Mesh sample_mesh()
{
  return to_mesh<Mesh>(grid(3, 2, Diagonal_rule::ALTERNATING, [](int i, int j) { return 0.3 * i * i - 0.1 * j; }));
}

Polylines sample_curves()
{
  return {{Point(0, 0, 0), Point(0.1, 0.7, 0.3), Point(1.0 / 3, 2, 0)},
          {},
          {Point(1, 1, 1)},
          {Point(2, 0, 0), Point(0, 0, 2)}};
}

bool is_same(double a, double b, bool are_floats)
{
  return are_floats ? std::abs(a - b) < 1e-6 : (a == b && std::signbit(a) == std::signbit(b));
}

void check_points(const Format& format, const std::vector<std::array<double, 3>>& found, const Polyline& expected,
                  std::size_t first)
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
std::map<std::pair<long, long>, int> directed_edges(const std::vector<std::array<long, 3>>& triangles)
{
  std::map<std::pair<long, long>, int> edges;
  for(const auto& t : triangles)
    for(int i = 0; i < 3; ++i)
      ++edges[{t[i], t[(i + 1) % 3]}];
  return edges;
}

long euler_characteristic_of_closed(const Written& file)
{
  const auto edges = directed_edges(file.triangles);
  for(const auto& [edge, count] : edges)
    BOOST_CHECK(count == 1 && edges.count({edge.second, edge.first}) == 1);
  return static_cast<long>(file.points.size()) - static_cast<long>(edges.size() / 2) +
         static_cast<long>(file.triangles.size());
}

double volume(const Written& file)
{
  double sum = 0;
  for(const auto& t : file.triangles) {
    const auto &p = file.points[t[0]], &q = file.points[t[1]], &r = file.points[t[2]];
    sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return sum / 6;
}

double longest_edge(const Written& file)
{
  double result = 0;
  for(const auto& t : file.triangles)
    for(int i = 0; i < 3; ++i) {
      const auto &p = file.points[t[i]], &q = file.points[t[(i + 1) % 3]];
      result = (std::max)(result, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  return result;
}

Written tube_of(const Polyline& curve, double radius, int sides)
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

} // namespace

BOOST_AUTO_TEST_CASE(surface_curves_and_points_are_read_back)
{
  const Mesh mesh = sample_mesh();
  const Polylines curves = sample_curves();
  const Polyline loose = {Point(3, 3, 3), Point(-1, 0.7, 0)};
  const std::size_t vertices = mesh.number_of_vertices();
  for(const Format& format : formats()) {
    BOOST_TEST_CONTEXT(format.name << (format.is_binary ? " in bytes" : " in text"))
    {
      const Written file = format.read(format.text(mesh, curves, loose));
      BOOST_CHECK_EQUAL(file.points.size(), vertices + 8);
      check_points(format, file.points, Polyline(mesh.points().begin(), mesh.points().end()), 0);
      check_points(format, file.points, curves[0], vertices);
      check_points(format, file.points, curves[2], vertices + 3);
      check_points(format, file.points, curves[3], vertices + 4);
      check_points(format, file.points, loose, vertices + 6);
      BOOST_REQUIRE_EQUAL(file.triangles.size(), mesh.number_of_faces());
      for(const auto f : mesh.faces()) {
        std::array<long, 3> corners;
        auto corner = corners.begin();
        for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
          *corner++ = static_cast<long>(v.idx());
        BOOST_CHECK(file.triangles[f.idx()] == corners);
      }
      const long n = static_cast<long>(vertices);
      const std::map<long, std::vector<long>> lines = {{0, {n, n + 1, n + 2}}, {3, {n + 4, n + 5}}};
      BOOST_CHECK(file.lines == lines);
      if(file.has_loose_points)
        BOOST_CHECK((file.loose_points == std::vector<long>{n + 3, n + 6, n + 7}));
    }
  }
}

BOOST_AUTO_TEST_CASE(doubles_come_back_bit_by_bit_whatever_the_stream_is_set_to)
{
  Polyline points;
  for(double x : awkward_numbers())
    points.emplace_back(x, -x, 1);
  for(const Format& format : formats()) {
    const Polyline used = format.is_of_floats ? sample_curves()[0] : points;
    const std::string plain = format.text(Polylines{used}, used);
    const Written file = format.read(plain);
    check_points(format, file.points, used, 0);
    check_points(format, file.points, used, used.size());

    std::ostringstream odd;
    odd.imbue(std::locale(std::locale::classic(), new German_numbers));
    odd << std::fixed << std::showpos << std::hex;
    odd.precision(2);
    odd.width(30);
    format.write(odd, Polylines{used}, used);
    BOOST_CHECK(odd.str() == plain);
    BOOST_CHECK(odd.precision() == 2 && (odd.flags() & std::ios_base::hex) != 0);
    odd.str("");
    odd.width(0);
    odd << std::dec << 12345.5;
    BOOST_CHECK_EQUAL(odd.str(), "+12.345,50");
  }
}

BOOST_AUTO_TEST_CASE(the_locale_of_the_program_has_no_influence)
{
  for(const Format& format : formats()) {
    const std::string plain = format.text(sample_curves());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new German_numbers));
    const std::string german = format.text(sample_curves());
    std::locale::global(before);
    BOOST_CHECK(german == plain);
  }
}

BOOST_AUTO_TEST_CASE(shapes_have_their_names)
{
  const Polyline loose = {Point(3, 3, 3)};
  std::ostringstream obj, surface_alone;
  FG::IO::write_OBJ(obj, sample_mesh(), sample_curves(), loose);
  std::vector<std::string> names;
  std::istringstream lines(obj.str());
  for(std::string line; std::getline(lines, line);)
    if(line.compare(0, 2, "o ") == 0)
      names.push_back(line.substr(2));
  BOOST_CHECK((names == std::vector<std::string>{"surface", "curve_0", "curve_2", "curve_3", "points"}));
  FG::IO::write_VTP(surface_alone, sample_mesh());
  BOOST_CHECK(surface_alone.str().find("<Verts>") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_have_their_lowest_byte_first)
{
  const Polylines curve = {{Point(1, -2, 0.5), Point(1, 0, 0)}};
  std::ostringstream ply, vtp, glb;
  FG::IO::write_PLY(ply, curve);
  const std::string one("\0\0\0\0\0\0\xf0\x3f", 8), minus_two("\0\0\0\0\0\0\0\xc0", 8), half("\0\0\0\0\0\0\xe0\x3f", 8);
  const std::size_t start = ply.str().find("end_header\n") + 11;
  BOOST_CHECK(ply.str().compare(start, 24, one + minus_two + half) == 0);
  BOOST_CHECK(ply.str().substr(start + 48) == std::string("\0\0\0\0\1\0\0\0\0\0\0\0", 12));
  FG::IO::write_VTP(vtp, curve);
  BOOST_CHECK(vtp.str().find("_" + std::string("\60\0\0\0\0\0\0\0", 8) + one + minus_two + half) != std::string::npos);
  FG::IO::write_GLB(glb, Polylines{{Point(1, 0, 0), Point(-1, 0, 0)}});
  BOOST_CHECK(glb.str().compare(0, 8, std::string("glTF\2\0\0\0", 8)) == 0);
  BOOST_CHECK(glb.str().substr(glb.str().size() - 24) ==
              std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\x80\xbf\0\0\0\0\0\0\0\0", 24));
}

BOOST_AUTO_TEST_CASE(the_readers_of_cgal_read_the_surface)
{
  Mesh mesh = sample_mesh();
  Mesh::size_type i = 0;
  for(double x : awkward_numbers())
    if(std::abs(x) > 1e-300) // smaller ones are no numbers to streams
      mesh.point(Mesh::Vertex_index(i++)) = Point(x, 1, -x);
  for(const Format& format : formats()) {
    const std::string name = format.name;
    if(name != "OBJ" && name != "PLY")
      continue; // for the others it has none, or one that needs VTK
    const Polylines curves = name == "PLY" ? sample_curves() : Polylines{{Point(1, 1, 1)}}; // it takes no lines in OBJ
    std::istringstream in(format.text(mesh, curves));
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    BOOST_CHECK(name == "OBJ" ? CGAL::IO::read_OBJ(in, points, polygons) : CGAL::IO::read_PLY(in, points, polygons));
    BOOST_REQUIRE_EQUAL(points.size(), mesh.number_of_vertices() + (name == "PLY" ? 6 : 1));
    BOOST_CHECK(std::equal(mesh.points().begin(), mesh.points().end(), points.begin()));
    BOOST_REQUIRE_EQUAL(polygons.size(), mesh.number_of_faces());
    for(const auto f : mesh.faces()) {
      std::vector<std::size_t> corners;
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        corners.push_back(v);
      BOOST_CHECK(polygons[f] == corners);
    }
  }
}

BOOST_AUTO_TEST_CASE(curves_are_counted_over_all_ranges_and_any_range_will_do)
{
  const std::list<std::array<Point, 2>> first = {{Point(0, 0, 0), Point(1, 0, 0)}, {Point(0, 1, 0), Point(1, 1, 0)}};
  const Polylines second = sample_curves();
  // Polylines that do not exist before they are asked for.
  const auto made = boost::irange(0, 3) | boost::adaptors::transformed([](int i) {
                      return Polyline{Point(i, 0, 0), Point(i, 1, 0), Point(i, 2, 0)};
                    });
  for(const Format& format : formats()) {
    const Written file = format.read(format.text(first, second, made));
    std::vector<long> numbers;
    for(const auto& line : file.lines)
      numbers.push_back(line.first);
    BOOST_CHECK((numbers == std::vector<long>{0, 1, 2, 5, 6, 7, 8}));
    check_points(format, file.points, {Point(2, 0, 0), Point(2, 1, 0), Point(2, 2, 0)}, file.points.size() - 3);
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_without_points_is_written_with_a_map)
{
  const Mesh_soup soup = grid(3, 2, Diagonal_rule::ALTERNATING, [](int i, int j) { return 0.3 * i * i - 0.1 * j; });
  const Mesh_archetype mesh(soup);
  std::ostringstream out, usual;
  FG::IO::write_OBJ(out, mesh, CGAL::parameters::vertex_point_map(Archetype_point_map{&mesh}));
  FG::IO::write_OBJ(usual, to_mesh<Mesh>(soup));
  Written found = read_obj(out.str()), expected = read_obj(usual.str());
  for(Written* file : {&found, &expected}) // its faces start at other corners
    for(auto& t : file->triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  BOOST_CHECK(found.points == expected.points);
  BOOST_CHECK(found.triangles == expected.triangles);
}

BOOST_AUTO_TEST_CASE(digits_can_be_chosen)
{
  std::ostringstream out;
  FG::IO::write_OBJ(out, Polyline{Point(1.0 / 3, 0, 2)}, CGAL::parameters::stream_precision(4));
  BOOST_CHECK_EQUAL(out.str(), "v 0.3333 0 2\no points\np 1\n");
}

BOOST_AUTO_TEST_CASE(tubes_are_closed_surfaces_about_their_curves)
{
  const double step = 2 * pi / 8, area_of_ring = 8 * 0.25 * 0.25 * std::sin(step) / 2;
  const Written rod = tube_of({Point(0, 0, 0), Point(0, 0, 0), Point(1, 2, 2), Point(2, 4, 4)}, 0.25, 8);
  BOOST_CHECK_EQUAL(rod.points.size(), 3 * 8 + 2); // the repeated point has no ring
  BOOST_CHECK_EQUAL(euler_characteristic_of_closed(rod), 2);
  BOOST_CHECK_CLOSE(volume(rod), 6 * area_of_ring, 1e-9);

  const Polyline circle = closed_curve(100, [](double t) { return Point(std::cos(t), std::sin(t), 0); });
  const Written ring = tube_of(circle, 0.1, 16);
  BOOST_CHECK_EQUAL(euler_characteristic_of_closed(ring), 0);
  BOOST_CHECK_CLOSE(volume(ring), 2 * pi * 16 * 0.01 * std::sin(2 * pi / 16) / 2, 0.3); // [Pappus]
  for(std::size_t i = 0; i < ring.points.size(); ++i) {
    const Point &p = circle[i / 16], q(ring.points[i][0], ring.points[i][1], ring.points[i][2]);
    BOOST_CHECK_CLOSE(std::sqrt(CGAL::squared_distance(p, q)), 0.1, 1e-9);
  }
  BOOST_CHECK(ring.triangle_curves == std::vector<long>(ring.triangles.size(), 0));
}

BOOST_AUTO_TEST_CASE(tubes_of_closed_curves_are_not_twisted)
{
  // A trefoil: what is carried round it comes back turned.
  const Polyline knot = closed_curve(300, [](double t) {
    return Point(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
  });
  double longest = 0;
  for(std::size_t i = 1; i < knot.size(); ++i)
    longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(knot[i - 1], knot[i])));
  for(int sides : {3, 7, 24}) {
    const double radius = 0.3, side = 2 * radius * std::sin(pi / sides);
    const Written tube = tube_of(knot, radius, sides);
    BOOST_CHECK_EQUAL(euler_characteristic_of_closed(tube), 0);
    BOOST_CHECK_GT(volume(tube), 0);
    // An edge along the tube is at most half a side beside its way, a diagonal one and a half.
    BOOST_CHECK_LE(longest_edge(tube), 1.5 * longest + 1.51 * side);
  }
}

BOOST_AUTO_TEST_CASE(tubes_stand_sharp_bends_and_all_sizes)
{
  const std::vector<Polyline> curves = {
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 0, 0)}, // straight back
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(1, 1, 1), Point(0, 1, 1)},
      {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, // from one tangent to the normal of the last
      {Point(0, 0, 0), Point(0, 0, 1), Point(0, 0, -1), Point(0, 0, 2)},
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1e-5, 0), Point(1, -1e-5, 0)}, // tangents turn back, but for a little
      {Point(0, 0, 0), Point(0, 1, 0), Point(1e-17, 0, 0)}};
  for(const Polyline& curve : curves)
    for(double scale : {1e-200, 1.0, 1e200}) {
      Polyline scaled;
      for(const Point& p : curve)
        scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
      const Written tube = tube_of(scaled, 0.01 * scale, 5);
      BOOST_CHECK_EQUAL(tube.points.size(), 5 * curve.size() + 2);
      BOOST_CHECK_EQUAL(euler_characteristic_of_closed(tube), 2);
      for(std::size_t i = 0; i < 5 * curve.size(); ++i) {
        const auto& corner = tube.points[i];
        const Point &p = curve[i / 5], q(corner[0] / scale, corner[1] / scale, corner[2] / scale);
        BOOST_CHECK_CLOSE(std::sqrt(CGAL::squared_distance(p, q)), 0.01, 1e-9);
      }
    }
  // What has no length has no tube.
  const Written point = tube_of({Point(1, 1, 1), Point(1, 1, 1)}, 1, 5);
  BOOST_CHECK(point.triangles.empty() && point.points.size() == 2);
}

BOOST_AUTO_TEST_CASE(tubes_stand_beside_a_surface_in_all_formats)
{
  const Mesh mesh = sample_mesh();
  for(const Format& format : formats()) {
    const Written file = format.read(format.text(mesh, FG::IO::Tubes(0.1, 4), sample_curves()));
    const std::size_t faces = mesh.number_of_faces(), corners = 2 * 4; // of a ring, or a cap with its half of a ring
    BOOST_REQUIRE_EQUAL(file.triangles.size(), faces + 3 * corners + 2 * corners);
    BOOST_CHECK(file.lines.empty());
    BOOST_REQUIRE_EQUAL(file.triangle_curves.size(), file.triangles.size());
    BOOST_CHECK_EQUAL(std::count(file.triangle_curves.begin(), file.triangle_curves.end(), -1), faces);
    BOOST_CHECK_EQUAL(std::count(file.triangle_curves.begin(), file.triangle_curves.end(), 3), 2 * corners);
  }
}

BOOST_AUTO_TEST_CASE(nothing_to_write_is_an_error)
{
  for(const Format& format : formats()) {
    const auto check = [&](const auto& part) {
      BOOST_CHECK(elements_of_error<FG::File_write_error>([&](std::ostream& out) { format.write(out, part); }).empty());
    };
    check(Mesh());
    check(Polyline());
    check(Polylines());
    check(Polylines(3));
  }
  // Vertices alone are something, but not where there are only faces.
  Mesh vertex;
  vertex.add_vertex(Point(1, 2, 3));
  std::ostringstream out;
  BOOST_CHECK_THROW(FG::IO::write_GLB(out, vertex), FG::File_write_error);
  for(const Format& format : formats())
    if(!format.is_of_floats)
      BOOST_CHECK_EQUAL(format.read(format.text(vertex)).points.size(), 1);
  // Beside something, what is empty does no harm.
  BOOST_CHECK_EQUAL(read_glb(formats().front().text(vertex, Polylines(2), Polyline{Point(1, 2, 3)})).points.size(), 1);
}

BOOST_AUTO_TEST_CASE(points_that_are_no_points_are_errors)
{
  for(double bad : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()})
    for(const Format& format : formats()) {
      Mesh mesh = sample_mesh();
      Polylines curves = sample_curves();
      Polyline loose = {Point(0, 0, 0), Point(1, 1, 1)};
      const auto elements = [&](const auto&... options) {
        return elements_of_error<FG::Invalid_coordinate_error>(
            [&](std::ostream& out) { format.write(out, mesh, curves, loose, options...); });
      };
      loose[1] = Point(0, bad, 0);
      BOOST_CHECK(elements() == Elements{1});
      curves[3][1] = Point(0, 0, bad);
      BOOST_CHECK((elements() == Elements{3, 1}));
      BOOST_CHECK((elements(FG::IO::Tubes(0.1)) == Elements{3, 1}));
      mesh.point(Mesh::Vertex_index(5)) = Point(bad, 0, 0);
      BOOST_CHECK(elements() == Elements{5});
    }
}

BOOST_AUTO_TEST_CASE(points_beyond_floats_are_an_error_of_glb)
{
  const auto elements = [](const Polylines& curves) {
    return elements_of_error<FG::Invalid_coordinate_error>([&](std::ostream& out) { FG::IO::write_GLB(out, curves); });
  };
  BOOST_CHECK((elements({{Point(0, 0, 0), Point(1, 1, 1), Point(0, 1e60, 0)}}) == Elements{0, 0}));
  BOOST_CHECK((elements({{Point(-1.7e308, 0, 0), Point(1.7e308, 0, 0)}}) == Elements{0, 0}));
  Mesh mesh = sample_mesh();
  BOOST_CHECK((elements_of_error<FG::Invalid_coordinate_error>([&](std::ostream& out) {
                 FG::IO::write_GLB(out, mesh, Polylines{{}, {Point(0, 0, 0), Point(0, 4e38, 0)}});
               }) == Elements{1, 1}));
  // Far from the origin they are as good as at it.
  const Written file = read_glb(formats().front().text(Polylines{{Point(1e60, 0, 0), Point(1e60, 1, 0)}}));
  BOOST_CHECK_EQUAL(file.points[1][0], 1e60);
}

BOOST_AUTO_TEST_CASE(meshes_that_are_none_are_errors)
{
  Mesh quad;
  std::vector<Mesh::Vertex_index> corners;
  for(const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    corners.push_back(quad.add_vertex(p));
  quad.add_face(corners);
  Mesh with_garbage = sample_mesh();
  with_garbage.remove_vertex(with_garbage.add_vertex(Point(0, 0, 0)));
  for(const Format& format : formats()) {
    const auto elements =
        elements_of_error<FG::Invalid_mesh_error>([&](std::ostream& out) { format.write(out, quad); });
    BOOST_CHECK_EQUAL(elements.size(), 4);
    BOOST_CHECK(
        elements_of_error<FG::Invalid_mesh_error>([&](std::ostream& out) { format.write(out, with_garbage); }).empty());
  }
}

BOOST_AUTO_TEST_CASE(more_than_32_bits_can_count_is_an_error)
{
  static const Point point(0, 0, 0); // all points are this one
  const auto points = [](std::size_t n) {
    return boost::irange(std::size_t(0), n) |
           boost::adaptors::transformed([](std::size_t) -> const Point& { return point; });
  };
  const auto is_refused = [](const auto& write) { return elements_of_error<FG::File_write_error>(write).empty(); };
  constexpr std::size_t bytes_of_glb = 4294967295;
  BOOST_CHECK(is_refused([&](std::ostream& out) { FG::IO::write_GLB(out, points(bytes_of_glb / 12 + 1)); }));
  BOOST_CHECK(is_refused([&](std::ostream& out) { // each of them alone would fit
    FG::IO::write_GLB(out, points(bytes_of_glb / 20), points(bytes_of_glb / 20));
  }));
  BOOST_CHECK(is_refused([&](std::ostream& out) { FG::IO::write_PLY(out, points(2147483648)); }));
  BOOST_CHECK(is_refused([&](std::ostream& out) { FG::IO::write_PLY(out, points(1073741824), points(1073741824)); }));
}

BOOST_AUTO_TEST_CASE(a_stream_that_fails_is_an_error)
{
  const Mesh mesh = sample_mesh();
  for(const Format& format : formats()) {
    const std::string all = format.text(mesh, sample_curves());
    for(std::size_t space : {std::size_t(0), std::size_t(7), all.size() / 2, all.size() - 1}) {
      Small_disk disk(space);
      std::ostream out(&disk);
      BOOST_CHECK_THROW(format.write(out, mesh, sample_curves()), FG::File_write_error);
      BOOST_CHECK(out.bad());
    }
    Small_disk disk(all.size());
    std::ostream out(&disk);
    BOOST_CHECK_NO_THROW(format.write(out, mesh, sample_curves()));
    std::ostringstream failed;
    failed.setstate(std::ios_base::failbit);
    BOOST_CHECK_THROW(format.write(failed, mesh), FG::File_write_error);
    BOOST_CHECK(failed.str().empty());
  }
}

BOOST_AUTO_TEST_CASE(files_are_written_and_kept_on_errors)
{
  const auto content = [](const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string name = "test_writers_result", nowhere = "no_such_folder/x", full = "/dev/full";
  for(const Format& format : formats()) {
    format.write(name, sample_mesh(), sample_curves());
    const std::string expected = format.text(sample_mesh(), sample_curves());
    BOOST_CHECK(content(name) == expected);
    BOOST_CHECK_THROW(format.write(name, Polyline()), FG::File_write_error);
    BOOST_CHECK(content(name) == expected);
    BOOST_CHECK_THROW(format.write(nowhere, sample_mesh()), FG::File_write_error);
    if(std::ofstream(full))
      BOOST_CHECK_THROW(format.write(full, sample_mesh()), FG::File_write_error);
  }
  std::remove(name.c_str());
}
