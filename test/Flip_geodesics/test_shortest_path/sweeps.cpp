// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sweeps that bound distances, and searches that they narrow to a corridor.

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "shortest.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/Geodesic_distance_field.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace shortest_path_test;

// The bound on the errors of windows rests on that of these directions, 18 u.
BOOST_AUTO_TEST_CASE(directions_of_sides_are_accurate)
{
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                             boost::multiprecision::et_off>;
  using Vector = std::array<Real, 3>;
  const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  std::mt19937 random(1);
  const auto number = [&](double size) { return size * (2e-9 * (random() % 1000000007) - 1); };
  Mesh_soup soup;
  for(int f = 0; f < 4000; ++f) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 24) - 12);
    const double width = std::ldexp(1.0, -static_cast<int>(random() % 20)), along = number(1);
    std::array<std::array<double, 3>, 3> corners;
    for(int k = 0; k < 3; ++k) {
      corners[0][k] = number(size);
      corners[1][k] = number(size);
      corners[2][k] = corners[0][k] + along * (corners[1][k] - corners[0][k]) + number(size * width);
    }
    soup.points.insert(soup.points.end(), corners.begin(), corners.end());
    soup.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  Setting setting(soup);
  FG::internal::Unfolded_faces<Setting::Triangulation> faces(setting.triangulation);
  double greatest = 0;
  const auto& input = setting.triangulation.input();
  for(auto h : descriptors<FG::Input_halfedge_index>(setting.triangulation.number_of_halfedges())) {
    if(input.is_border(h))
      continue;
    const auto to = [&](FG::Input_halfedge_index g) {
      const auto &from = soup.points[input.tail(h).idx()], &end = soup.points[input.tail(g).idx()];
      return Vector{Real(end[0]) - from[0], Real(end[1]) - from[1], Real(end[2]) - from[2]};
    };
    const Vector a = to(input.next(h)), b = to(input.next(input.next(h)));
    const Vector n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const Real lengths = sqrt(dot(a, a) * dot(b, b));
    const auto side = faces[faces.number(h)];
    const Real x = side.cosine - dot(a, b) / lengths, y = side.sine - sqrt(dot(n, n)) / lengths;
    greatest = (std::max)(greatest, static_cast<double>(sqrt(x * x + y * y)));
  }
  BOOST_TEST(greatest > 2 * FG::internal::unit_roundoff);
  BOOST_TEST(greatest < 12 * FG::internal::unit_roundoff);
}

// Whatever the mesh, no distance is less than a sweep says; on smooth ones it says nearly all of it.
BOOST_AUTO_TEST_CASE(sweeps_bound_distances)
{
  const auto check = [](const Mesh_soup& soup, double deficit) {
    Setting setting(soup);
    auto& triangulation = setting.triangulation;
    FG::internal::Unfolded_faces<Setting::Triangulation> faces(triangulation);
    FG::internal::Window_search<Setting::Triangulation> windows(triangulation, faces, 1_v);
    windows.run(1e9);
    Vertex_index farthest = 0_v;
    for(Vertex_index v : descriptors<Vertex_index>(triangulation.number_of_vertices()))
      farthest = windows.distance(v) > windows.distance(farthest) ? v : farthest;
    FG::internal::Cone_sweep<Setting::Triangulation> sweep(triangulation, faces, 1_v, {triangulation, farthest});
    sweep.run(3 * windows.distance(farthest));
    double sum = 0;
    for(Vertex_index v : descriptors<Vertex_index>(triangulation.number_of_vertices())) {
      BOOST_TEST(sweep.distance_lower_bound(v) <= windows.distance(v) * (1 + 1e-13), "vertex " << v.idx());
      sum += v == 1_v ? 0 : 1 - sweep.distance_lower_bound(v) / windows.distance(v);
    }
    BOOST_TEST(sum <= deficit * triangulation.number_of_vertices());
    return sweep.is_useful();
  };
  BOOST_TEST(check(flat_grid(10, 10, Diagonal_rule::RANDOM), 0.01));
  BOOST_TEST(check(jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.24, 5), 0.01));
  BOOST_TEST(check(bumpy_sphere(12, 0.3, 1), 0.02));
  BOOST_TEST(check(torus(26, 14, 3, 1), 0.02));
  BOOST_TEST(check(saddle_disk(12, 8, 9), 0.02));
  BOOST_TEST(check(grid_with_hole(12, 14, 3, 8, 4, 11), 0.02));
  // Fronts meet on long edges: cones that fit badly there would lower one another until the bounds are of no use.
  if(stride == 1) { // a search without bounds, as the check does it, has long heaps here
    BOOST_TEST(check(shaken(torus(12, 60, 3, 1), 0.05, 1), 0.03));
    BOOST_TEST(check(shaken(torus(20, 60, 3, 1), 0.09, 1), 0.06));
  }
  int useful = 0;
  const std::vector<Mesh_soup> rough = {box(5, 4, 3, 1),
                                        tetrahedron(3),
                                        cone_disk(9, 9, 2),
                                        needle_strip(20, 6, 1e-3),
                                        lantern(10, 40),
                                        genus_3_plate(2),
                                        cylinder(24, 3, 1, 30, true),
                                        random_convex_polyhedron(150, 7),
                                        mapped(bumpy_sphere(7, 0.2, 2), [](const Coordinates& p) {
                                          return Coordinates{p[0], p[1], 1e-4 * p[2]};
                                        })};
  for(const Mesh_soup& soup : rough)
    useful += check(soup, 1) ? 1 : 0;
  BOOST_TEST_MESSAGE(useful << " of " << rough.size() << " sweeps over rough meshes are of use");
}

// Cones at needles lower each other many times. If they may do so freely, the sweep ends as useless before it costs as
// much as windows do.
BOOST_AUTO_TEST_CASE(sweeps_over_needles_end_early)
{
  Setting setting(mapped(torus(26, 14, 3, 1), [](const Coordinates& p) {
    return Coordinates{p[0], 1e-3 * p[1], p[2]};
  }));
  const auto& triangulation = setting.triangulation;
  for(int free_updates : {6, 1000}) {
    FG::internal::Unfolded_faces<Setting::Triangulation> faces(triangulation);
    FG::internal::Cone_sweep<Setting::Triangulation> sweep(
        triangulation, faces, 0_v, {triangulation, Vertex_index(triangulation.number_of_vertices() - 1)}, free_updates);
    sweep.run(100);
    BOOST_TEST(sweep.is_useful() == (free_updates == 6));
    BOOST_TEST(sweep.number_of_updates() <= 26 * static_cast<std::size_t>(triangulation.input().number_of_halfedges()));
  }
}

// What a sweep says of paths over a part of an edge, to a point beyond it, against the distances of places there.
BOOST_AUTO_TEST_CASE(sweeps_bound_paths_over_edges)
{
  for(const Mesh_soup& soup :
      {jittered_grid(10, 10, Diagonal_rule::RANDOM, 0.24, 5), shaken(torus(20, 60, 3, 1), 0.09, 2),
       shaken(torus(26, 14, 3, 1), 0.25, 2), shaken(genus_3_plate(2), 0.3, 4), random_convex_polyhedron(150, 7),
       needle_strip(8, 6, 1e-2), saddle_disk(12, 8, 9), mapped(bumpy_sphere(8, 0.3, 1), [](const Coordinates& p) {
         return Coordinates{p[0], 0.1 * p[1], p[2]};
       })})
  {
    Setting setting(soup);
    const auto& triangulation = setting.triangulation;
    FG::Geodesic_distance_field<Setting::Triangulation> field(triangulation, setting.mesh);
    field.add_source(1_v);
    field.compute();
    Vertex_index farthest = 0_v;
    for(Vertex_index v : descriptors<Vertex_index>(triangulation.number_of_vertices()))
      farthest = field.distance(v) > field.distance(farthest) ? v : farthest;
    FG::internal::Unfolded_faces<Setting::Triangulation> faces(triangulation);
    FG::internal::Cone_sweep<Setting::Triangulation> sweep(triangulation, faces, 1_v, {triangulation, farthest});
    sweep.run(3 * field.distance(farthest));
    if(!sweep.is_useful())
      continue;
    Random_numbers random(3);
    std::size_t from_the_left = 0;
    for(FG::Index e = 0; e < triangulation.input().number_of_halfedges(); e += stride) {
      const FG::Input_halfedge_index h(e);
      if(triangulation.input().is_border(h))
        continue;
      const double length = faces[faces.number(h)].length;
      for(int i = 0; i < 4; ++i) {
        const FG::internal::Cone cone = {random.uniform(-length, 2 * length), random.uniform(0, length), 0};
        const double from = random.uniform(0, 0.9 * length), to = random.uniform(from, length);
        const double bound = sweep.through(h, length, cone, from, to);
        for(int k = 1; k < 10; ++k) {
          const double place = from + (to - from) * k / 10, t = place / length;
          const FG::Surface_location at = {h, {{1 - t, t, 0}}};
          if(field.gradient(at)[1] > 0) // the shortest path comes from the other face
            continue;
          BOOST_TEST(bound <= (cone(place) + field.distance(at)) * (1 + 1e-13), h.idx() << " at " << t);
          ++from_the_left;
        }
      }
    }
    BOOST_TEST(from_the_left > 0u);
  }
}

namespace {

// The path that a search finds in a corridor against that of one which goes everywhere.
void check_sleeve(Setting& setting, Vertex_index source, Vertex_index target, double distance)
{
  const auto report = shortest(setting, source, target);
  BOOST_TEST(report.is_confirmed());
  BOOST_TEST(std::abs(report.length - distance) <= 1e-10 * report.length, source.idx() << " to " << target.idx());
}

} // namespace

// A search that a sweep narrows finds what one finds that goes everywhere: on rough meshes, where fronts meet on long
// edges, and lines pass vertices closely.
BOOST_AUTO_TEST_CASE(a_sleeve_loses_no_path)
{
  for(const Mesh_soup& soup :
      {grid(14, 14, Diagonal_rule::RANDOM, [](int i, int j) { return ((i * 7 + j * 13) % 5) * 0.9; }),
       shaken(genus_3_plate(2), 0.3, 4), random_convex_polyhedron(150, 7), shaken(torus(26, 14, 3, 1), 0.25, 2),
       mapped(bumpy_sphere(8, 0.3, 1), [](const Coordinates&p) {
         return Coordinates{p[0], 0.2 * p[1], p[2]};
       })})
  {
    Setting setting(soup);
    const int n = setting.triangulation.number_of_vertices();
    Random_numbers random(11);
    for(int i = 0; i < 6; i += stride) {
      const Vertex_index source(random.below(n));
      FG::internal::Unfolded_faces<Setting::Triangulation> faces(setting.triangulation);
      FG::internal::Window_search<Setting::Triangulation> windows(setting.triangulation, faces, source);
      windows.run(1e9);
      for(int j = 0; j < 20; ++j) {
        const Vertex_index target(random.below(n));
        if(target != source)
          check_sleeve(setting, source, target, windows.distance(target));
      }
    }
  }
}

// Bounds are wrong if paths by way of a vertex count only where a shortest path can turn: here a fitted cone's rays go
// past the edge that they should hit, and the paths found were longer by up to 1e-4.
BOOST_AUTO_TEST_CASE(a_sleeve_counts_paths_by_way_of_all_vertices)
{
  struct Example
  {
    unsigned seed;
    Vertex_index source, target;
  };
  for(const auto& [seed, source, target] : {Example{2, 648_v, 1175_v}, Example{5, 611_v, 367_v}}) {
    Setting setting(shaken(torus(20, 60, 3, 1), 0.09, seed));
    FG::Geodesic_distance_field<Setting::Triangulation> field(setting.triangulation, setting.mesh);
    field.add_source(source);
    field.compute();
    check_sleeve(setting, source, target, field.distance(target));
  }
}
