// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Straightened_path

#include "Curve_setting.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "invalid_meshes.h"
#include "random_curves.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>
#include <CGAL/Flip_geodesics/straightened_path.h>

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using FG::Halfedge_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Certified_setting =
    Basic_curve_setting<FG::Intrinsic_triangulation<Surface, FG::Certified_intrinsic_triangulation_traits<Kernel>>>;
using Settings = boost::mpl::list<Curve_setting, Certified_setting>;

struct Outcome
{
  std::size_t first_flips; // to insert the straightened path
  double first_length;     // of that
  FG::Shortening_report report;
};

/// Pulls a path tight from its straightened form, checks what holds for any, and takes everything back.
template <class Setting>
Outcome pulled_from_straightened(Setting& setting, const std::vector<Halfedge_index>& path)
{
  double path_length = 0;
  for(Halfedge_index h : path)
    path_length += setting.triangulation.length(h);
  Outcome outcome;
  outcome.first_flips = FG::add_straightened_path(setting.network, path);
  outcome.first_length = setting.network.length(0_c);
  BOOST_TEST(setting.network.is_valid());
  BOOST_TEST(setting.triangulation.is_valid());
  BOOST_TEST(outcome.first_length <= path_length * (1 + 1e-12));
  outcome.report = setting.pull();
  BOOST_TEST(outcome.report.is_complete());
  BOOST_TEST(outcome.report.curves[0].initial_length == path_length, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(outcome.report.curves[0].length <= outcome.first_length * (1 + 1e-12));
  if constexpr(!Setting::Triangulation::Traits::Has_drift::value)
    BOOST_TEST(FG::certify(setting.network).is_locally_shortest());
  setting.network.clear();
  setting.triangulation.rollback();
  return outcome;
}

template <class Setting>
Outcome pulled_from_straightened(Setting& setting, Vertex_index source, Vertex_index target)
{
  typename Setting::Search search(setting.triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  return pulled_from_straightened(setting, search(source, target));
}

template <class Visit>
void for_random_pairs(const Surface& mesh, int pairs, const Visit& visit)
{
  std::mt19937 random(1);
  const int n = static_cast<int>(mesh.number_of_vertices());
  for(int i = 0; i < pairs;) {
    const Vertex_index source(static_cast<int>(random() % n)), target(static_cast<int>(random() % n));
    if(source == target)
      continue;
    visit(source, target);
    ++i;
  }
}

/// A regular polygon with an even number of corners, that are joined to and fro from one to the opposite one.
Mesh_soup zigzag_disk(int n)
{
  Mesh_soup soup;
  for(int i = 0; i < n; ++i)
    soup.points.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0});
  for(int low = 0, high = n - 1; low + 1 < high; ++low, --high) {
    soup.triangles.push_back({{low, low + 1, high}});
    soup.triangles.push_back({{low + 1, high - 1, high}});
  }
  return soup;
}

double distance_in_space(const Surface& mesh, Vertex_index u, Vertex_index v)
{
  const auto point = [&](Vertex_index w) {
    return mesh.point(Surface::Vertex_index(static_cast<std::uint32_t>(w.idx())));
  };
  return std::sqrt(CGAL::squared_distance(point(u), point(v)));
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_path_in_the_plane_is_straight_at_once, Setting, Settings)
{
  for(bool is_jittered : {false, true}) {
    Setting setting(is_jittered ? jittered_grid(20, 20, Diagonal_rule::ALTERNATING, 0.2, 7)
                                : flat_grid(20, 20, Diagonal_rule::RISING));
    for_random_pairs(setting.mesh, 40, [&](Vertex_index u, Vertex_index v) {
      const Outcome outcome = pulled_from_straightened(setting, u, v);
      const double distance = distance_in_space(setting.mesh, u, v);
      BOOST_TEST(outcome.first_length == distance, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(outcome.report.curves[0].length == distance, boost::test_tools::tolerance(1e-12));
    });
  }
}

BOOST_AUTO_TEST_CASE(paths_on_cones_pass_the_apex_on_either_side)
{
  const int n = 12, m = 8;
  for(double total : {pi, 1.5 * pi, 2.6 * pi}) {
    Curve_setting setting(total < 2 * pi ? cone_disk(n, m, total) : saddle_disk(n, m, total));
    for(int i = 1; i <= n / 2; ++i) {
      const Vertex_index source(disk_vertex(n, 6, 0)), target(disk_vertex(n, 7, i));
      const Outcome outcome = pulled_from_straightened(setting, source, target);
      const double angle = i * total / n;
      const double length = outcome.report.curves[0].length;
      const double error = (std::min)(std::abs(length - cone_distance(6, 7, angle)),
                                      std::abs(length - cone_distance(6, 7, total - angle)));
      BOOST_TEST(error < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_path_over_the_corner_of_a_cube_leaves_it)
{
  const int n = 6;
  Curve_setting setting(cube(n));
  for_random_pairs(setting.mesh, 60, [&](Vertex_index u, Vertex_index v) {
    const Outcome outcome = pulled_from_straightened(setting, u, v);
    BOOST_TEST(outcome.report.curves[0].length >= distance_in_space(setting.mesh, u, v) * (1 - 1e-12));
  });
}

BOOST_AUTO_TEST_CASE(paths_turn_at_borders)
{
  Curve_setting setting(grid_with_hole(16, 16, 4, 12, 6, 10));
  for_random_pairs(setting.mesh, 60, [&](Vertex_index u, Vertex_index v) { pulled_from_straightened(setting, u, v); });
  // Across, past two corners of the hole.
  const Mesh_soup soup = grid_with_hole(16, 16, 4, 12, 6, 10);
  const Vertex_index u(index_of(soup, {2, 8, 0})), v(index_of(soup, {14, 8, 0}));
  const Outcome outcome = pulled_from_straightened(setting, u, v);
  BOOST_TEST(outcome.report.curves[0].length == 2 * std::hypot(2, 2) + 8, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(lengths_are_those_without_and_flips_are_fewer, Setting, Settings)
{
  Setting setting(torus(160, 80, 3, 1));
  double sum = 0, plain_sum = 0;
  std::size_t flips = 0, plain_flips = 0, segments = 0;
  for_random_pairs(setting.mesh, 20, [&](Vertex_index u, Vertex_index v) {
    typename Setting::Search search(setting.triangulation,
                                    CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
    const std::vector<Halfedge_index> path = search(u, v);
    const Outcome outcome = pulled_from_straightened(setting, path);
    sum += outcome.report.curves[0].length;
    flips += outcome.first_flips + outcome.report.flips;
    segments += path.size();
    setting.network.add_curve(path);
    const FG::Shortening_report plain = setting.pull();
    plain_sum += plain.curves[0].length;
    plain_flips += plain.flips;
    setting.network.clear();
    setting.triangulation.rollback();
  });
  BOOST_TEST(sum == plain_sum, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(flips < plain_flips);
  BOOST_TEST(flips < 6 * segments);
}

// Flips that straighten a path and crossings of the straight one, from vertex to vertex.
template <class Setting>
std::pair<std::size_t, std::size_t> flips_and_crossings(Setting& setting, Vertex_index source, Vertex_index target)
{
  typename Setting::Search search(setting.triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  const std::size_t flips = FG::add_straightened_path(setting.network, search(source, target));
  std::size_t crossings = 0;
  for(Halfedge_index h : setting.network.halfedges(0_c))
    crossings += setting.triangulation.edge_sequence(h).crossed.size();
  setting.network.clear();
  setting.triangulation.rollback();
  return {flips, crossings};
}

BOOST_AUTO_TEST_CASE(legs_are_inserted_by_few_flips)
{
  Curve_setting setting(jittered_grid(60, 60, Diagonal_rule::ALTERNATING, 0.2, 5));
  std::size_t flips = 0, crossings = 0;
  for_random_pairs(setting.mesh, 20, [&](Vertex_index u, Vertex_index v) {
    const auto numbers = flips_and_crossings(setting, u, v);
    flips += numbers.first;
    crossings += numbers.second;
  });
  BOOST_TEST(flips >= crossings);
  BOOST_TEST(flips < 1.5 * crossings);
}

// Pulling the side of the strip straight would bring almost all edges into the way of almost all vertices.
BOOST_AUTO_TEST_CASE(a_leg_across_needles_is_inserted_by_a_flip_for_each)
{
  const int n = 400;
  Curve_setting setting(zigzag_disk(n));
  const auto [flips, crossings] = flips_and_crossings(setting, 0_v, Vertex_index(n / 2));
  BOOST_TEST(crossings == std::size_t(n - 3));
  BOOST_TEST(flips == crossings);
}

// Around the apex, one side of the strip bends towards the other, and that is not always the same.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_leg_past_an_apex_of_many_edges_is_inserted_by_few_flips, Setting, Settings)
{
  const int n = 4000;
  Setting setting(cone(n, 2, 1, 1));
  for_random_pairs(setting.mesh, 20, [&](Vertex_index u, Vertex_index v) {
    for(const auto& [from, to] : {std::make_pair(u, v), std::make_pair(v, u)}) {
      const auto [flips, crossings] = flips_and_crossings(setting, from, to);
      BOOST_TEST(flips <= 2 * crossings);
      pulled_from_straightened(setting, from, to);
    }
  });
}

// Paths along a ring are pulled over to the apex by one fan of edges after the other.
BOOST_AUTO_TEST_CASE(paths_between_places_on_a_cone_of_many_sides_take_few_flips)
{
  const int n = 4000;
  const Curve_setting setting(cone(n, 2, 1, 1));
  Random_numbers random(1);
  const auto place = [&] {
    Surface::Halfedge_index h;
    do
      h = Surface::Halfedge_index(static_cast<unsigned>(random.below(static_cast<int>(num_halfedges(setting.mesh)))));
    while(setting.mesh.is_border(h));
    return FG::Surface_location{FG::Input_halfedge_index(static_cast<int>(h)),
                                {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}};
  };
  for(int i = 0; i < 20; ++i) {
    const std::vector<FG::Surface_location> places = {place(), place()};
    std::vector<Kernel::Point_3> points;
    const auto result = FG::geodesic_path_through(setting.mesh, places, std::back_inserter(points));
    BOOST_TEST((result.verdict() == FG::Verdict::PROVEN));
    BOOST_TEST(result.report.flips < 20 * n);
  }
}

BOOST_AUTO_TEST_CASE(rough_and_needle_meshes_are_no_worse)
{
  for(const Mesh_soup& soup : {bumpy_sphere(12, 0.3, 3), random_convex_polyhedron(150, 5), needle_strip(12, 12, 1e-6),
                               genus_3_plate(3), tetrahedron(5)})
  {
    Curve_setting setting(soup);
    for_random_pairs(setting.mesh, 30,
                     [&](Vertex_index u, Vertex_index v) { pulled_from_straightened(setting, u, v); });
  }
}

// Lengths alone, without points: the same geodesics.
BOOST_AUTO_TEST_CASE(a_metric_of_lengths_does)
{
  Curve_setting setting(bumpy_sphere(6, 0.2, 3));
  std::map<boost::graph_traits<Surface>::edge_descriptor, double> lengths;
  for(const auto e : setting.mesh.edges())
    lengths[e] = setting.triangulation.length(setting.triangulation.index(halfedge(e, setting.mesh)));
  Surface mesh = setting.mesh;
  const Length_metric metric(mesh, Length_map(lengths));
  Length_triangulation triangulation(mesh, metric);
  for_random_pairs(mesh, 20, [&](Vertex_index u, Vertex_index v) {
    Curve_setting::Search search(setting.triangulation);
    const std::vector<Halfedge_index> path = search(u, v);
    FG::Edge_path_network<Length_triangulation> network(triangulation);
    FG::add_straightened_path(network, path);
    const double length = FG::shorten(network).curves[0].length;
    BOOST_TEST(length == pulled_from_straightened(setting, path).report.curves[0].length,
               boost::test_tools::tolerance(1e-9));
    network.clear();
    triangulation.rollback();
  });
}

// Paths that wind about a tube: their geodesics pass faces twice, and legs of them the faces of others.
BOOST_AUTO_TEST_CASE(paths_that_wind_about_a_tube)
{
  std::size_t inserted = 0, given_up = 0;
  std::mt19937 random(1);
  for(int n : {3, 4, 6})
    for(int m : {2, 4, 7})
      for(double amplitude : {0.0, 0.05, 0.15, 0.3})
        for(int round = 0; round < 4; ++round) {
          const Mesh_soup tube = cylinder(n, m, 1, 0.5 * m);
          Curve_setting setting(amplitude > 0 ? shaken(tube, amplitude, static_cast<unsigned>(random())) : tube);
          Vertex_sequence way = {0_v};
          for(int row = 0, column = 0; row <= m; ++row) { // no vertex twice
            const int steps = 1 + static_cast<int>(random() % static_cast<unsigned>(n - 1));
            for(int i = 0; i < steps; ++i) {
              column = (column + 1) % n;
              way.emplace_back(column + n * row);
            }
            if(row < m)
              way.emplace_back(column + n * (row + 1));
          }
          const std::vector<Halfedge_index> path = FG::halfedges_through(setting.triangulation, way);
          const Outcome outcome = pulled_from_straightened(setting, path);
          (outcome.first_length < outcome.report.curves[0].initial_length * (1 - 1e-9) ? inserted : given_up) += 1;
        }
  BOOST_TEST(inserted > 10u);
  BOOST_TEST(given_up > 10u);
}

// About a hole, and then along an edge that the first leg crosses: the path itself is the curve.
BOOST_AUTO_TEST_CASE(a_leg_along_an_edge_that_another_leg_crosses)
{
  const Mesh_soup soup = grid_with_hole(12, 12, 4, 8, 4, 8);
  Vertex_sequence way;
  for(const std::array<int, 2>& p : std::vector<std::array<int, 2>>{
          {1, 6}, {2, 6}, {2, 5}, {3, 5}, {3, 4}, {4, 4}, {5, 4}, {6, 4}, {7, 4}, {8, 4}, {8, 5}, {8, 6},
          {8, 7}, {8, 8}, {7, 8}, {6, 8}, {5, 8}, {4, 8}, {3, 8}, {2, 8}, {1, 7}, {0, 6}, {0, 5}, {1, 5}})
    way.emplace_back(index_of(soup, {double(p[0]), double(p[1]), 0}));
  Curve_setting setting(soup);
  const std::vector<Halfedge_index> path = FG::halfedges_through(setting.triangulation, way);
  const Outcome outcome = pulled_from_straightened(setting, path);
  BOOST_TEST(outcome.first_length == outcome.report.curves[0].initial_length);
  BOOST_TEST(outcome.first_flips > 0u); // which were taken back
}

#ifndef CGAL_NO_PRECONDITIONS
BOOST_AUTO_TEST_CASE(a_path_is_straightened_on_the_input_alone)
{
  Curve_setting setting(jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 1));
  const std::vector<Halfedge_index> path = Curve_setting::Search(setting.triangulation)(0_v, 40_v);
  Halfedge_index h = 0_h;
  while(!setting.triangulation.is_flippable(h))
    ++h;
  setting.triangulation.flip(h);
  BOOST_CHECK_THROW(FG::add_straightened_path(setting.network, path), CGAL::Precondition_exception);
  setting.triangulation.rollback();
  setting.network.add_curve(path);
  BOOST_CHECK_THROW(FG::add_straightened_path(setting.network, path), CGAL::Precondition_exception);
}
#endif

BOOST_AUTO_TEST_CASE(beside_a_face_without_area_the_path_itself_is_added)
{
  for(const Mesh_soup& soup : {with_zero_area_face(), with_zero_length_edge(), single_triangle()}) {
    Curve_setting setting(soup);
    const std::vector<Halfedge_index> path = {0_h};
    BOOST_TEST(FG::add_straightened_path(setting.network, path) == 0u);
    BOOST_TEST(setting.network.halfedges(0_c) == path, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_stop_predicate_sees_the_edge_path)
{
  const Surface mesh = to_mesh<Surface>(torus(40, 20, 3, 1));
  const Surface::Vertex_index s(0), t(415);
  std::vector<Surface::Point> points;
  const auto stopped = FG::geodesic_path(mesh, s, t, std::back_inserter(points),
                                         CGAL::parameters::stop_predicate(FG::Iteration_stop_predicate(0)));
  BOOST_TEST(stopped.report.curves[0].length == stopped.report.curves[0].initial_length);
  const auto finished = FG::geodesic_path(mesh, s, t, std::back_inserter(points));
  BOOST_TEST(finished.report.flips > 0u);
  BOOST_TEST(finished.report.curves[0].flips == finished.report.flips);
  BOOST_TEST(finished.report.curves[0].initial_length == stopped.report.curves[0].initial_length);
  BOOST_TEST(finished.report.curves[0].length < finished.report.curves[0].initial_length);
}

// Distances along edges by the Bellman-Ford algorithm.
BOOST_AUTO_TEST_CASE(shortest_edge_paths_are_as_long_as_edges_relaxed_again_and_again_say)
{
  for(const Mesh_soup& soup :
      {jittered_grid(6, 6, Diagonal_rule::RANDOM, 0.2, 1), bumpy_sphere(3, 0.3, 2), needle_strip(5, 5, 20)})
  {
    const Curve_setting setting(soup);
    const auto& t = setting.triangulation;
    for(Vertex_index source : {0_v, 7_v, 20_v}) {
      FG::internal::Indexed_by<Vertex_index, std::vector<double>> distances(t.number_of_vertices(),
                                                                            std::numeric_limits<double>::infinity());
      distances[source] = 0;
      for(bool is_done = false; !is_done;) {
        is_done = true;
        for(Halfedge_index h : descriptors<Halfedge_index>(t.number_of_halfedges()))
          if(distances[t.tail(h)] + t.length(h) < distances[t.head(h)]) {
            distances[t.head(h)] = distances[t.tail(h)] + t.length(h);
            is_done = false;
          }
      }
      for(FG::Search_method method : {FG::Search_method::A_STAR, FG::Search_method::DIJKSTRA}) {
        FG::Shortest_edge_path<Curve_setting::Triangulation> search(t, CGAL::parameters::search_method(method));
        for(Vertex_index target : descriptors<Vertex_index>(t.number_of_vertices())) {
          double length = 0;
          Vertex_index at = source;
          for(Halfedge_index h : search(source, target)) {
            BOOST_REQUIRE_EQUAL(t.tail(h), at);
            at = t.head(h);
            length += t.length(h);
          }
          BOOST_REQUIRE_EQUAL(at, target);
          BOOST_CHECK_LE(std::abs(length - distances[target]), 1e-12 * distances[target]);
        }
      }
    }
  }
}

// With 7 on both sides, in radians, of a vertex of angle 14, there is nothing to shorten.
BOOST_AUTO_TEST_CASE(paths_over_a_vertex_of_large_angle_stay)
{
  constexpr int k = 16;
  Curve_setting setting(saddle_disk(k, 5, 14));
  for(int i = 0; i < k; ++i) {
    Vertex_sequence way;
    for(int r = 5; r >= 0; --r)
      way.emplace_back(disk_vertex(k, r, i));
    for(int r = 1; r <= 5; ++r)
      way.emplace_back(disk_vertex(k, r, i + k / 2));
    const auto path = FG::halfedges_through(setting.triangulation, way);
    BOOST_TEST(FG::add_straightened_path(setting.network, path) == 0u);
    BOOST_TEST(setting.network.length(0_c) == 10, boost::test_tools::tolerance(1e-12));
    setting.network.clear();
    setting.triangulation.rollback();
  }
}

#ifndef CGAL_NO_PRECONDITIONS
BOOST_AUTO_TEST_CASE(a_triangulation_that_was_flipped_is_refused)
{
  Curve_setting setting(jittered_grid(5, 5, Diagonal_rule::RANDOM, 0.2, 1));
  Curve_setting::Search search(setting.triangulation);
  const auto path = search(0_v, 30_v);
  Halfedge_index h = 0_h;
  while(!setting.triangulation.is_flippable(h))
    ++h;
  setting.triangulation.flip(h);
  BOOST_CHECK_THROW(FG::add_straightened_path(setting.network, path), CGAL::Failure_exception);
}
#endif

BOOST_AUTO_TEST_CASE(an_edge_of_infinite_length_is_refused)
{
  const Surface mesh = to_mesh<Surface>(flat_grid(4, 4, Diagonal_rule::RISING));
  auto lengths = edge_lengths(mesh, [](int, int) { return 1.0; });
  lengths.begin()->second = std::numeric_limits<double>::infinity();
  const Length_triangulation triangulation(mesh, Length_metric(mesh, Length_map(lengths)));
  FG::Shortest_edge_path<Length_triangulation> search(triangulation);
  BOOST_CHECK_THROW(search.visit_all(0_v, [](Vertex_index, double) {}), FG::Invalid_coordinate_error);
}
