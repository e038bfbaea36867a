// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE geodesic_landmarks

#include "Curve_setting.h"
#include "Exact_distances.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/tags.h>

#include <boost/test/unit_test.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <type_traits>
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
                                           : FG::add_shortest_path(setting.network, search, s, t,
                                                                   CGAL::parameters::landmarks(*landmarks));
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

// No bound of a distance from vertex s is above that. Adds up bounds and distances.
void check_bounds(const FG::Geodesic_landmarks& landmarks, int s, const std::vector<double>& distance, double& told,
                  double& all)
{
  for(int t = 0; t < static_cast<int>(distance.size()); ++t) {
    if(!(distance[t] < 1e9)) // in another component
      continue;
    const double bound = landmarks.distance_lower_bound(Vertex_index(s), Vertex_index(t));
    BOOST_TEST(bound <= distance[t], s << " to " << t);
    told += bound;
    all += distance[t];
  }
}

// The bounds of all pairs of vertices, to the bit.
std::vector<double> all_bounds(const FG::Geodesic_landmarks& landmarks, FG::Index number_of_vertices)
{
  std::vector<double> result;
  for(Vertex_index v : descriptors<Vertex_index>(number_of_vertices))
    for(Vertex_index w : descriptors<Vertex_index>(number_of_vertices))
      result.push_back(landmarks.distance_lower_bound(v, w));
  return result;
}

// Runs with so many threads where there is TBB, however few cores there are.
template <class Function>
void run_by(int threads, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena(threads).execute(function);
#else
  static_cast<void>(threads);
  function();
#endif
}

// A torus and, behind it in the numbering, a sphere with fewer vertices, and a triangle.
Mesh_soup three_components()
{
  const auto moved = [](Mesh_soup soup, double offset) {
    return mapped(soup, [=](const Coordinates& p) { return Coordinates{p[0] + offset, p[1], p[2]}; });
  };
  Mesh_soup triangle;
  triangle.points = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  triangle.triangles = {{0, 1, 2}};
  return disjoint_union(disjoint_union(torus(16, 10, 3, 1), moved(bumpy_sphere(3, 0.3, 1), 9)), moved(triangle, 20));
}

} // namespace

// All pairs of vertices against brute force: no bound is above the distance, not even in the last digit, and the
// results are proven as they are without landmarks.
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
        BOOST_TEST(FG::to_string(report.verdict) == "WITHIN_ROUNDING", s << " to " << t << ", gap " << report.gap());
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
      check_bounds(landmarks, s, distance, told, all);
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
      with += updates(&FG::internal::Internals<FG::Geodesic_landmarks>::rows(landmarks));
    }
    BOOST_TEST(with < without);
    BOOST_TEST_MESSAGE(with << " instead of " << without << " cones");
  }
}

// Those that are given tell nearly the distance from them, and all that they tell holds.
BOOST_AUTO_TEST_CASE(given_landmarks)
{
  const Mesh_soup soup = three_components();
  Setting setting(soup);
  const auto& triangulation = setting.triangulation;
  const int n = triangulation.number_of_vertices();
  const std::vector<Vertex_index> given = {90_v, 5_v, 161_v, 47_v}; // three on the torus, one on the sphere
  const FG::Geodesic_landmarks landmarks(triangulation, given);
  BOOST_TEST(landmarks.number_of_landmarks() == 3u);
  landmarks.check_input(triangulation);
  for(int s = 0; s < n; ++s) {
    const bool is_given = std::find(given.begin(), given.end(), Vertex_index(s)) != given.end();
    if(!is_given && s % 11 != 0)
      continue;
    const std::vector<double> distance = distances_upward(triangulation, Vertex_index(s));
    double told = 0, all = 0;
    check_bounds(landmarks, s, distance, told, all);
    BOOST_TEST((!is_given || told > 0.95 * all), s);
  }
  BOOST_TEST(landmarks.distance_lower_bound(Vertex_index(n - 1), Vertex_index(n - 2)) == 0); // the triangle has none
}

// Neither repeated vertices nor their order matter; without any there are no bounds; all of them are nearly distances.
BOOST_AUTO_TEST_CASE(ranges_of_given_landmarks)
{
  Setting setting(three_components());
  const auto& triangulation = setting.triangulation;
  const int n = triangulation.number_of_vertices();
  const FG::Geodesic_landmarks once(triangulation, {90_v, 5_v, 161_v, 47_v}),
      again(triangulation, {47_v, 5_v, 5_v, 90_v, 161_v, 161_v, 47_v, 161_v, 161_v, 90_v});
  BOOST_TEST(again.number_of_landmarks() == 3u);
  BOOST_TEST((all_bounds(once, n) == all_bounds(again, n)));

  const FG::Geodesic_landmarks none(triangulation, std::vector<Vertex_index>());
  BOOST_TEST(none.number_of_landmarks() == 0u);
  none.check_input(triangulation);
  BOOST_TEST((all_bounds(none, n) == std::vector<double>(static_cast<std::size_t>(n) * n, 0)));
  BOOST_TEST(shortest(setting, &none, 0_v, 50_v).is_confirmed());

  const FG::Geodesic_landmarks all(triangulation, descriptors<Vertex_index>(n));
  BOOST_TEST(all.number_of_landmarks() == 160u);
  BOOST_TEST(all.distance_lower_bound(Vertex_index(n - 1), Vertex_index(n - 2)) > 4.99);
  const auto report = shortest(setting, &all, 0_v, 83_v);
  BOOST_TEST(report.is_confirmed());
  BOOST_TEST(report.length <= shortest(setting, nullptr, 0_v, 83_v).length * (1 + 1e-12));

  for(const Vertex_index wrong : {Vertex_index(n), Vertex_index(-7), Vertex_index(FG::null_index)})
    BOOST_CHECK_THROW(FG::Geodesic_landmarks(triangulation, {3_v, wrong}), FG::Vertex_out_of_range_error);
}

// A component with fewer vertices than are asked for has them all, and others go on to have more.
BOOST_AUTO_TEST_CASE(chosen_landmarks)
{
  Setting setting(three_components());
  FG::Shortest_edge_path<Setting::Triangulation> search(setting.triangulation,
                                                        CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
  const FG::internal::Landmark_choice choice(search);
  const int n = setting.triangulation.number_of_vertices();
  BOOST_TEST(choice.order().size() == static_cast<std::size_t>(n));
  const auto sets = choice.far_vertices(search, 5);
  std::vector<std::size_t> sizes;
  for(const auto& set : sets)
    sizes.push_back(set.size());
  BOOST_TEST((sizes == std::vector<std::size_t>{3, 3, 3, 2, 2}));
  const FG::Geodesic_landmarks landmarks(setting.triangulation, 5);
  BOOST_TEST(landmarks.number_of_landmarks() == 5u);
  BOOST_TEST(landmarks.distance_lower_bound(Vertex_index(n - 1), Vertex_index(n - 2)) > 4.99);

  // The first is the farthest from the first vertex, and each as far from those before as any vertex is.
  Vertex_index last = 0_v;
  search.visit_all(last, [&](Vertex_index v, double) { last = v; });
  BOOST_TEST(sets[0][0] == last);
  std::vector<Vertex_index> before = {last};
  std::vector<double> nearest(static_cast<std::size_t>(n), 1e9);
  for(std::size_t i = 1; i < sets.size(); ++i) {
    double most = 0;
    search.visit_all(before.back(), [&](Vertex_index v, double distance) {
      nearest[v.idx()] = (std::min)(nearest[v.idx()], distance);
      most = (std::max)(most, nearest[v.idx()]);
    });
    BOOST_TEST(nearest[sets[i][0].idx()] == most);
    before.push_back(sets[i][0]);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
static_assert(std::is_convertible<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value, "threads are tested");
#endif

// Bounds have the same bits for each number of threads.
BOOST_AUTO_TEST_CASE(threads_change_nothing)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const Mesh_soup soups[] = {three_components(), torus(40, 24, 3, 1), genus_3_plate(1), needle_strip(20, 6, 1e-3)};
  for(const Mesh_soup& soup : soups) {
    const Setting setting(soup);
    const auto& triangulation = setting.triangulation;
    const int n = triangulation.number_of_vertices();
    const std::vector<Vertex_index> given = {2_v, 40_v, 3_v, 17_v, 41_v};
    const std::vector<double> chosen = all_bounds(FG::Geodesic_landmarks(triangulation), n),
                              of_given = all_bounds(FG::Geodesic_landmarks(triangulation, given), n);
    for(const int threads : {1, 2, 3, 8})
      run_by(threads, [&] {
        BOOST_TEST((all_bounds(FG::Geodesic_landmarks(triangulation, 8, Tag()), n) == chosen), threads);
        BOOST_TEST((all_bounds(FG::Geodesic_landmarks(triangulation, given, Tag()), n) == of_given), threads);
      });
  }
}

// What is wrong with a mesh is found by all threads as by one.
BOOST_AUTO_TEST_CASE(errors_with_threads)
{
  Mesh_soup pointed = flat_grid(9, 9, Diagonal_rule::RISING);
  pointed.points[5] = pointed.points[6];
  const Setting degenerate(pointed);
  run_by(4, [&] {
    BOOST_CHECK_THROW(FG::Geodesic_landmarks(degenerate.triangulation, 8, CGAL::Parallel_if_available_tag()),
                      FG::Degenerate_face_error);
  });
}

// By one call; and with other lengths than those in space.
BOOST_AUTO_TEST_CASE(one_call)
{
  const Surface mesh = to_mesh<Surface>(torus(16, 10, 3, 1));
  const FG::Geodesic_landmarks landmarks = FG::geodesic_landmarks(mesh);
  BOOST_TEST(landmarks.number_of_landmarks() == FG::Geodesic_landmarks::default_number);
  const auto s = *vertices(mesh).begin(), t = *std::next(vertices(mesh).begin(), 83);
  std::vector<Surface::Point> points, same;
  const auto result = FG::shortest_path(mesh, s, t, std::back_inserter(points), CGAL::parameters::landmarks(landmarks));
  FG::shortest_path(mesh, s, t, std::back_inserter(same));
  BOOST_TEST(result.report.is_confirmed());
  BOOST_TEST((points == same));
  const std::vector<Surface::Vertex_index> ends = {t, s, t};
  const FG::Geodesic_landmarks of_ends = FG::geodesic_landmarks<CGAL::Parallel_if_available_tag>(mesh, ends);
  BOOST_TEST(of_ends.number_of_landmarks() == 2u);
  BOOST_TEST(of_ends.distance_lower_bound(0_v, 83_v) > 0.95 * result.length());
  BOOST_TEST(FG::geodesic_landmarks<CGAL::Parallel_if_available_tag>(mesh, 3).number_of_landmarks() == 3u);
  BOOST_TEST(FG::geodesic_landmarks(mesh, {s, t}, CGAL::parameters::default_values()).number_of_landmarks() == 2u);
  BOOST_TEST(FG::geodesic_landmarks(mesh, vertices(mesh)).number_of_landmarks() == 160u);
  for(const auto wrong : {Surface::null_vertex(), Surface::Vertex_index(160)})
    BOOST_CHECK_THROW(FG::geodesic_landmarks(mesh, {s, wrong}), FG::Vertex_out_of_range_error);
  points.clear();
  const auto given_up =
      FG::shortest_path(mesh, s, t, std::back_inserter(points), CGAL::parameters::landmarks(landmarks),
                        CGAL::parameters::search_limit(FG::Window_limit(0)));
  BOOST_TEST(given_up.report.lower_bound <= result.length());

  std::map<Surface::Edge_index, double> lengths;
  for(const auto e : mesh.edges())
    lengths[e] = 1;
  const Length_triangulation triangulation(mesh, Length_metric(mesh, Length_map(lengths)));
  const FG::Geodesic_landmarks by_lengths(triangulation, 3);
  BOOST_TEST(by_lengths.distance_lower_bound(0_v, 1_v) <= 1);
  BOOST_TEST(by_lengths.distance_lower_bound(0_v, 83_v) > 1);
  BOOST_CHECK_THROW(landmarks.check_input(triangulation), FG::Input_mismatch_error);
  const FG::Geodesic_landmarks by_given_lengths =
      FG::geodesic_landmarks(mesh, ends, CGAL::parameters::metric(Length_metric(mesh, Length_map(lengths))));
  by_given_lengths.check_input(triangulation);
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
        BOOST_TEST(FG::shortest_path(*other, s, t, std::back_inserter(points), CGAL::parameters::landmarks(landmarks))
                       .report.is_confirmed());
      else
        BOOST_CHECK_THROW(
            FG::shortest_path(*other, s, t, std::back_inserter(points), CGAL::parameters::landmarks(landmarks)),
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
// What follows such an edge may be nothing.
BOOST_AUTO_TEST_CASE(edges_in_no_face)
{
  Surface mesh;
  const auto a = mesh.add_vertex(Surface::Point(0, 0, 0)), b = mesh.add_vertex(Surface::Point(3, 4, 0));
  mesh.add_face(a, b, mesh.add_vertex(Surface::Point(0, 4, 0)));
  const auto c = mesh.add_vertex(Surface::Point(7, 0, 0)), d = mesh.add_vertex(Surface::Point(8, 0, 0));
  mesh.add_edge(c, d);
  BOOST_CHECK_EXCEPTION(FG::geodesic_landmarks(mesh), FG::Invalid_mesh_error, [](const FG::Invalid_mesh_error& error) {
    return std::string(error.what()) == "the edge between vertices 3 and 4 does not belong to a face";
  });
}

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
  BOOST_TEST(
      FG::shortest_path(mesh, a, b, std::back_inserter(points), CGAL::parameters::landmarks(landmarks)).length() == 5);
  BOOST_CHECK_THROW(FG::shortest_path(mesh, a, b, std::back_inserter(points), CGAL::parameters::landmarks(apart)),
                    FG::Input_mismatch_error);
}
