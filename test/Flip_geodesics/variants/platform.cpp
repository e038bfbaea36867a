// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Flips, verdicts, lengths, points, lower bounds and window counts of geodesics and shortest paths on small meshes,
// numbers as the hexadecimal digits of their 64 bits, and distances of fields to nine digits: the lines are the same on
// every platform. Needs nothing but headers.

#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/geodesic_distances.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;

void print(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  std::printf(" %016" PRIx64, bits);
}

void print(const std::vector<Point>& points)
{
  for(const Point& p : points) {
    print(p.x());
    print(p.y());
    print(p.z());
  }
}

struct Flip_printer : FG::Default_shortening_visitor
{
  template <class Triangulation>
  void on_flip(const Triangulation&, FG::Halfedge_index h) const
  {
    std::printf(" %d", static_cast<int>(h.idx()));
  }
};

void print_geodesic(const Surface& mesh, Vertex s, Vertex t)
{
  std::printf("flips");
  std::vector<Point> points;
  const auto path =
      FG::geodesic_path(mesh, s, t, std::back_inserter(points), CGAL::parameters::visitor(Flip_printer()));
  std::printf("\ngeodesic %s", to_string(path.verdict()));
  print(path.length());
  print(points);
}

void print_shortest(const Surface& mesh, Vertex s, Vertex t)
{
  std::vector<Point> points;
  const auto report = FG::shortest_path(mesh, s, t, std::back_inserter(points)).report;
  std::printf("\nshortest %s %lu", to_string(report.verdict), static_cast<unsigned long>(report.windows));
  print(report.length);
  print(report.lower_bound);
  print(points);
}

void print_distances(const Surface& mesh, Vertex s)
{
  std::vector<double> distances(mesh.number_of_vertices());
  const auto report = FG::geodesic_distances(
      mesh, s, boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)));
  std::printf("\ndistances %s", to_string(report.verdict));
  for(const double d : distances) // fields take lengths by hypot(), whose last bit depends on the library
    std::printf(" %lld", std::llround(d * 0x1p30));
  std::printf("\n");
}

} // namespace

int main()
{
  const std::vector<std::pair<const char*, Mesh_soup>> inputs = {
      {"flat grid", flat_grid(9, 8, Diagonal_rule::ALTERNATING)},
      {"jittered grid", jittered_grid(10, 10, Diagonal_rule::RANDOM, 0.24, 5)},
      {"cube", cube(4)},
      {"saddle", saddle_disk(12, 6, 9)},
      {"lantern", lantern(8, 20)},
      {"torus", torus(16, 9, 3, 1)},
      {"bumpy sphere", bumpy_sphere(6, 0.3, 1)},
      {"shaken plate", shaken(genus_3_plate(2), 0.3, 4)}};
  for(const auto& [name, soup] : inputs) {
    std::printf("%s\n", name);
    const Surface mesh = to_mesh<Surface>(with_rounded_coordinates(soup));
    const auto n = static_cast<unsigned>(mesh.number_of_vertices());
    for(unsigned i = 0; i < 6; ++i) {
      const Vertex s(i * 17 % n), t((i * 29 + n / 2) % n);
      if(s == t)
        continue;
      print_geodesic(mesh, s, t);
      print_shortest(mesh, s, t);
      print_distances(mesh, s);
    }
  }
}
