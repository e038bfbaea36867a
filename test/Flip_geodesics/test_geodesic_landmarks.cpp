// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE geodesic_landmarks

#include "Curve_setting.h"
#include "Exact_distances.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/Geodesic_landmarks.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

namespace {

using Setting = Basic_curve_setting<
    FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Length_metric::Kernel>>>;
using Number = Exact_distances::Number;

// With landmarks, or without if there are none.
FG::Shortest_path_report shortest(Setting& setting, const FG::Geodesic_landmarks* landmarks, Vertex_index s,
                                  Vertex_index t)
{
  Setting::Search search(setting.triangulation);
  const auto report = landmarks == nullptr ? FG::add_shortest_path(setting.network, search, s, t)
                                           : FG::add_shortest_path(setting.network, search, *landmarks, s, t);
  setting.network.clear();
  setting.triangulation.rollback();
  return report;
}

// Distances from a vertex, of which none is above the true one.
std::vector<double> distances_upward(const Setting::Triangulation& triangulation, Vertex_index source)
{
  FG::internal::Unfolded_faces<Setting::Triangulation> faces(triangulation);
  FG::internal::Window_search<Setting::Triangulation> windows(triangulation, faces, source);
  windows.run(1e9);
  std::vector<double> result;
  for(Vertex_index v : descriptors<Vertex_index>(triangulation.number_of_vertices()))
    result.push_back(windows.distance(v) * (1 + 1e-13));
  return result;
}

} // namespace

// All pairs of vertices against brute force: no bound is above the distance, not even in the last digit, and the results
// are proven as they are without landmarks.
BOOST_AUTO_TEST_CASE(brute_force)
{
  for(const Mesh_soup& soup :
      {box(3, 2, 1, 1), cube(2), tetrahedron(2), octahedron(2), random_convex_polyhedron(14, 3)}) {
    const Exact_distances exact(soup);
    Setting setting(soup);
    const FG::Geodesic_landmarks landmarks(setting.triangulation, 4);
    BOOST_TEST(landmarks.number_of_landmarks() == 4u);
    const int n = setting.triangulation.number_of_vertices();
    double told = 0;
    for(int s = 0; s < n; ++s)
      for(int t = 0; t < n; ++t) {
        const double bound = landmarks.distance_lower_bound(Vertex_index(s), Vertex_index(t));
        BOOST_TEST(bound == landmarks.distance_lower_bound(Vertex_index(t), Vertex_index(s)));
        if(s == t) {
          BOOST_TEST(bound == 0);
          continue;
        }
        const Number& distance = exact.distance(s, t);
        BOOST_TEST((Number(bound) <= distance), s << " to " << t);
        told += bound / static_cast<double>(distance);
        const auto report = shortest(setting, &landmarks, Vertex_index(s), Vertex_index(t));
        BOOST_TEST(FG::to_string(report.verdict) == "PROVEN_SHORTEST", s << " to " << t << ", gap " << report.gap());
        BOOST_TEST((Number(report.lower_bound) <= distance), s << " to " << t);
        BOOST_TEST((abs(Number(report.length) - distance) <= distance * 1e-14), s << " to " << t);
        BOOST_TEST(report.has_tie == (exact.number_of_paths(s, t) > 1), s << " to " << t);
      }
    BOOST_TEST(told > 0.5 * n * (n - 1));
  }
}

// Bounds hold on rough meshes, too, and in each component of a mesh.
BOOST_AUTO_TEST_CASE(bounds_hold)
{
  const Mesh_soup apart = disjoint_union(torus(16, 10, 3, 1), mapped(bumpy_sphere(4, 0.3, 1), [](const Coordinates& p) {
                                           return Coordinates{p[0] / 7 + 9, p[1] / 7, p[2] / 7};
                                         }));
  for(const Mesh_soup& soup :
      {flat_grid(8, 8, Diagonal_rule::RANDOM), jittered_grid(10, 10, Diagonal_rule::RANDOM, 0.24, 5),
       grid_with_hole(10, 11, 3, 7, 4, 8), saddle_disk(12, 8, 9), genus_3_plate(1), needle_strip(20, 6, 1e-3),
       random_convex_polyhedron(100, 7), apart})
  {
    Setting setting(soup);
    const FG::Geodesic_landmarks landmarks(setting.triangulation);
    const int n = setting.triangulation.number_of_vertices();
    double told = 0, all = 0;
    for(int s = 0; s < n; s += 7) {
      const std::vector<double> distance = distances_upward(setting.triangulation, Vertex_index(s));
      for(int t = 0; t < n; ++t) {
        if(!(distance[t] < 1e9)) // in another component
          continue;
        const double bound = landmarks.distance_lower_bound(Vertex_index(s), Vertex_index(t));
        BOOST_TEST(bound <= distance[t], s << " to " << t);
        told += bound;
        all += distance[t];
      }
    }
    BOOST_TEST(told > 0.6 * all);
  }
}

// The same paths are found; sweeps fit fewer cones.
BOOST_AUTO_TEST_CASE(results_are_the_same)
{
  for(const Mesh_soup& soup : {torus(40, 24, 3, 1), bumpy_sphere(12, 0.3, 1), genus_3_plate(2),
                               grid_with_hole(24, 24, 6, 18, 6, 18), cylinder(24, 6, 1, 30, true)})
  {
    Setting setting(soup);
    const auto& triangulation = setting.triangulation;
    const FG::Geodesic_landmarks landmarks(triangulation);
    Random_numbers random(5);
    const int n = triangulation.number_of_vertices();
    std::size_t without = 0, with = 0;
    for(int i = 0; i < 30; ++i) {
      const Vertex_index s(random.below(n)), t(random.below(n));
      if(s == t)
        continue;
      const auto a = shortest(setting, nullptr, s, t), b = shortest(setting, &landmarks, s, t);
      BOOST_TEST(a.is_confirmed() == b.is_confirmed(), s.idx() << " to " << t.idx());
      BOOST_TEST(std::abs(a.length - b.length) <= 1e-12 * a.length, s.idx() << " to " << t.idx());
      BOOST_TEST(a.has_tie == b.has_tie, s.idx() << " to " << t.idx());
      const auto updates = [&](const FG::internal::Landmark_rows* rows) {
        FG::internal::Unfolded_faces<Setting::Triangulation> faces(triangulation);
        FG::internal::Cone_sweep<Setting::Triangulation> sweep(triangulation, faces, t, {triangulation, s, rows});
        sweep.run(a.length);
        return sweep.number_of_updates();
      };
      without += updates(nullptr);
      with += updates(&landmarks.rows());
    }
    BOOST_TEST(with < without);
    BOOST_TEST_MESSAGE(with << " instead of " << without << " cones");
  }
}

// By one call; and with other lengths than those in space.
BOOST_AUTO_TEST_CASE(one_call)
{
  const Surface mesh = to_mesh<Surface>(torus(16, 10, 3, 1));
  const FG::Geodesic_landmarks landmarks = FG::geodesic_landmarks(mesh);
  BOOST_TEST(landmarks.number_of_landmarks() == FG::Geodesic_landmarks::default_number);
  const auto s = *vertices(mesh).begin(), t = *std::next(vertices(mesh).begin(), 83);
  std::vector<Surface::Point> points, same;
  const auto result = FG::shortest_path(mesh, landmarks, s, t, std::back_inserter(points));
  FG::shortest_path(mesh, s, t, std::back_inserter(same));
  BOOST_TEST(result.report.is_confirmed());
  BOOST_TEST((points == same));
  points.clear();
  const auto given_up = FG::shortest_path(mesh, landmarks, s, t, std::back_inserter(points), FG::Window_limit(0));
  BOOST_TEST(given_up.report.lower_bound <= result.length());

  std::map<Surface::Edge_index, double> lengths;
  for(const auto e : mesh.edges())
    lengths[e] = 1;
  const Length_triangulation triangulation(mesh, Length_metric(mesh, Length_map(lengths)));
  const FG::Geodesic_landmarks by_lengths(triangulation, 3);
  BOOST_TEST(by_lengths.distance_lower_bound(0_v, 1_v) <= 1);
  BOOST_TEST(by_lengths.distance_lower_bound(0_v, 83_v) > 1);
  BOOST_CHECK_THROW(landmarks.check_input(triangulation), FG::Input_mismatch_error);
}

BOOST_AUTO_TEST_CASE(errors)
{
  const Mesh_soup soup = torus(16, 10, 3, 1);
  Setting setting(soup),
      larger(mapped(soup,
                    [](const Coordinates&p) {
                      return Coordinates{2 * p[0], 2 * p[1], 2 * p[2]};
                    })),
      other(torus(10, 16, 3, 1)), finer(torus(17, 10, 3, 1));
  const FG::Geodesic_landmarks landmarks(setting.triangulation), none(setting.triangulation, 0);
  landmarks.check_input(setting.triangulation);
  BOOST_CHECK_THROW(landmarks.check_input(larger.triangulation), FG::Input_mismatch_error);
  BOOST_CHECK_THROW(landmarks.check_input(finer.triangulation), FG::Input_mismatch_error);
  BOOST_CHECK_THROW(shortest(other, &landmarks, 0_v, 50_v), FG::Input_mismatch_error);
  BOOST_TEST(none.distance_lower_bound(0_v, 50_v) == 0);
  BOOST_TEST(shortest(setting, &none, 0_v, 50_v).is_confirmed());

  Mesh_soup pointed = flat_grid(3, 3, Diagonal_rule::RISING);
  pointed.points[5] = pointed.points[6];
  const Setting degenerate(pointed);
  BOOST_CHECK_THROW(FG::Geodesic_landmarks(degenerate.triangulation, 2), FG::Degenerate_face_error);
}

// A face more or less leaves all vertices and edges: bounds of the mesh that lacks it are no bounds on the whole one.
BOOST_AUTO_TEST_CASE(faces_that_one_mesh_lacks)
{
  const Surface whole = to_mesh<Surface>(torus(16, 10, 3, 1));
  const auto without = [&](std::size_t face) {
    Surface mesh = whole;
    const auto h = halfedge(*std::next(faces(mesh).begin(), static_cast<std::ptrdiff_t>(face)), mesh);
    CGAL::Euler::remove_face(h, mesh);
    mesh.collect_garbage();
    BOOST_TEST(num_edges(mesh) == num_edges(whole));
    return mesh;
  };
  const Surface holed = without(7), holed_elsewhere = without(100);
  const auto s = *vertices(whole).begin(), t = *std::next(vertices(whole).begin(), 83);
  std::vector<Surface::Point> points;
  for(const Surface* mine : {&whole, &holed, &holed_elsewhere}) {
    const FG::Geodesic_landmarks landmarks = FG::geodesic_landmarks(*mine);
    for(const Surface* other : {&whole, &holed, &holed_elsewhere})
      if(mine == other)
        BOOST_TEST(FG::shortest_path(*other, landmarks, s, t, std::back_inserter(points)).report.is_confirmed());
      else
        BOOST_CHECK_THROW(FG::shortest_path(*other, landmarks, s, t, std::back_inserter(points)),
                          FG::Input_mismatch_error);
  }

  const std::vector<Surface::Face_index> all(whole.faces().begin(), whole.faces().end());
  using Filtered = CGAL::Face_filtered_graph<Surface>;
  const Filtered all_faces(whole, all), less_faces(whole, std::vector<Surface::Face_index>(all.begin() + 1, all.end())),
      other_faces(whole, std::vector<Surface::Face_index>(all.begin(), all.end() - 1));
  const FG::Intrinsic_triangulation<Filtered> of_all(all_faces), of_less(less_faces), of_others(other_faces);
  const FG::Geodesic_landmarks landmarks(of_less);
  landmarks.check_input(of_less);
  BOOST_CHECK_THROW(landmarks.check_input(of_all), FG::Input_mismatch_error);
  BOOST_CHECK_THROW(landmarks.check_input(of_others), FG::Input_mismatch_error);
}

// More than there are vertices would be the same ones again, and take all memory.
BOOST_AUTO_TEST_CASE(more_landmarks_than_vertices)
{
  Setting setting(tetrahedron(2));
  const std::size_t n = static_cast<std::size_t>(setting.triangulation.number_of_vertices());
  const FG::Geodesic_landmarks all(setting.triangulation, n);
  for(std::size_t number : {n + 1, std::size_t(1) << 40, static_cast<std::size_t>(-1)}) {
    const FG::Geodesic_landmarks landmarks(setting.triangulation, number);
    BOOST_TEST(landmarks.number_of_landmarks() == n);
    BOOST_TEST(landmarks.distance_lower_bound(0_v, 1_v) == all.distance_lower_bound(0_v, 1_v));
  }
}

// Where there is nothing to sweep over.
BOOST_AUTO_TEST_CASE(meshes_without_edges)
{
  Surface mesh;
  BOOST_TEST(FG::geodesic_landmarks(mesh).number_of_landmarks() == 0u);
  mesh.add_vertex(Surface::Point(1, 2, 3));
  mesh.add_vertex(Surface::Point(3, 2, 1));
  const FG::Geodesic_landmarks apart = FG::geodesic_landmarks(mesh);
  BOOST_TEST(apart.distance_lower_bound(0_v, 1_v) == 0);
  const auto a = mesh.add_vertex(Surface::Point(0, 0, 0)), b = mesh.add_vertex(Surface::Point(3, 4, 0));
  mesh.add_face(a, b, mesh.add_vertex(Surface::Point(0, 4, 0)));
  const FG::Geodesic_landmarks landmarks = FG::geodesic_landmarks(mesh);
  BOOST_TEST(landmarks.distance_lower_bound(2_v, 3_v) > 4.9);
  BOOST_TEST(landmarks.distance_lower_bound(2_v, 3_v) <= 5);
  std::vector<Surface::Point> points;
  BOOST_TEST(FG::shortest_path(mesh, landmarks, a, b, std::back_inserter(points)).length() == 5);
  BOOST_CHECK_THROW(FG::shortest_path(mesh, apart, a, b, std::back_inserter(points)), FG::Input_mismatch_error);
}
