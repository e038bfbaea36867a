// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Geodesic_paths

#include "descriptors.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/geodesic_paths.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace FG = CGAL::Flip_geodesics;
using namespace Flip_geodesics_test;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Pairs = std::vector<std::pair<Vertex, Vertex>>;
using Path = FG::Geodesic_path_result<Kernel::Point_3>;

#ifdef CGAL_LINKED_WITH_TBB
static_assert(std::is_convertible<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value, "threads are tested");
#endif

Pairs random_pairs(const Mesh& mesh, std::size_t size, unsigned seed)
{
  std::mt19937 random(seed);
  const auto vertex = [&] { return Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())); };
  Pairs pairs;
  while(pairs.size() < size) {
    const Vertex s = vertex(), t = vertex();
    if(s != t)
      pairs.emplace_back(s, t);
  }
  return pairs;
}

template <class Tag>
std::vector<Path> paths_of(const Mesh& mesh, const Pairs& pairs)
{
  std::vector<Path> result;
  FG::geodesic_paths<Tag>(mesh, pairs, std::back_inserter(result));
  return result;
}

void check_same(const std::vector<Path>& a, const std::vector<Path>& b)
{
  BOOST_TEST_REQUIRE(a.size() == b.size());
  for(std::size_t i = 0; i < a.size(); ++i) {
    BOOST_TEST((a[i].points == b[i].points));
    BOOST_TEST(a[i].length() == b[i].length());
    BOOST_TEST(!a[i].error == !b[i].error);
  }
}

/// Two spheres that no edge connects.
Mesh two_spheres()
{
  Mesh_soup soup = bumpy_sphere(6, 0.1, 1);
  const Mesh_soup other = sphere(5);
  const int first = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for(const Corners& t : other.triangles)
    soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return to_mesh<Mesh>(soup);
}

} // namespace

BOOST_AUTO_TEST_CASE(paths_are_those_of_single_calls)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(12, 0.1, 3));
  const Pairs pairs = random_pairs(mesh, 40, 5);
  const std::vector<Path> paths = paths_of<CGAL::Sequential_tag>(mesh, pairs);
  BOOST_TEST_REQUIRE(paths.size() == pairs.size());
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<Kernel::Point_3> points;
    const auto single = FG::geodesic_path(mesh, pairs[i].first, pairs[i].second, std::back_inserter(points));
    BOOST_TEST((paths[i].points == points));
    BOOST_TEST(paths[i].length() == single.length());
    BOOST_TEST((paths[i].status() == FG::Shortening_status::LOCALLY_SHORTEST));
    BOOST_TEST((paths[i].error == nullptr));
  }
}

BOOST_AUTO_TEST_CASE(a_stop_predicate_ends_each_path)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(12, 0.1, 3));
  const Pairs pairs = random_pairs(mesh, 40, 5);
  const FG::Length_ratio_stop_predicate stop(0.97);
  std::vector<Path> paths;
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::stop_predicate(stop));
  std::size_t stopped = 0;
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    const FG::Curve_report& report = paths[i].report.curves.front();
    BOOST_TEST(report.length >= 0.97 * report.initial_length);
    stopped += report.status == FG::Shortening_status::LENGTH_LIMIT ? 1 : 0;
    std::vector<Kernel::Point_3> points;
    const auto single = FG::geodesic_path(mesh, pairs[i].first, pairs[i].second, std::back_inserter(points),
                                          CGAL::parameters::stop_predicate(stop));
    BOOST_TEST((paths[i].points == points));
    BOOST_TEST((single.status() == paths[i].status()));
    BOOST_TEST((single.verdict() == paths[i].verdict()));
    BOOST_TEST(single.length() == paths[i].length());
  }
  BOOST_TEST(stopped > 0u);
  BOOST_TEST(stopped < pairs.size());
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_the_results)
{
  const Mesh mesh = to_mesh<Mesh>(torus(40, 20, 3, 1));
  const Pairs pairs = random_pairs(mesh, 200, 7);
  check_same(paths_of<CGAL::Sequential_tag>(mesh, pairs), paths_of<CGAL::Parallel_if_available_tag>(mesh, pairs));
}

BOOST_AUTO_TEST_CASE(an_error_is_the_result_of_its_pair_alone)
{
  const Mesh mesh = two_spheres();
  const Pairs pairs = random_pairs(mesh, 60, 9);
  const std::vector<Path> paths = paths_of<CGAL::Sequential_tag>(mesh, pairs);
  std::size_t errors = 0;
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    if(!paths[i].error) {
      BOOST_TEST(paths[i].points.size() >= 2u);
      continue;
    }
    ++errors;
    BOOST_TEST(paths[i].points.empty());
    BOOST_CHECK_THROW(std::rethrow_exception(paths[i].error), FG::Disconnected_endpoints_error);
  }
  BOOST_TEST(errors > 10u);
  BOOST_TEST(errors < 50u);
  check_same(paths, paths_of<CGAL::Parallel_if_available_tag>(mesh, pairs));

  const std::vector<Path> equal_ends = paths_of<CGAL::Sequential_tag>(mesh, {{Vertex(0), Vertex(0)}, pairs[0]});
  BOOST_TEST(!equal_ends[0].error);
  BOOST_TEST((equal_ends[0].status() == FG::Shortening_status::CONTRACTED));
  BOOST_TEST(equal_ends[0].points.size() == 2u);
  BOOST_TEST((equal_ends[1].points == paths[0].points));
}

namespace {

// Says no, or throws, in the `n`-th query that flips, whatever thread it runs on.
struct Disturbing_visitor : FG::Default_shortening_visitor
{
  std::atomic<int> steps{0};
  int stop_at = 0, throw_at = 0;

  bool go_further()
  {
    const int step = ++steps;
    if(step == throw_at)
      throw std::runtime_error("a visitor may throw");
    return step != stop_at;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(an_interrupted_path_leaves_the_others_alone)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(12, 0.1, 3));
  const Pairs pairs = random_pairs(mesh, 40, 5);
  std::vector<Path> undisturbed;
  Disturbing_visitor none;
  FG::geodesic_paths(mesh, pairs, std::back_inserter(undisturbed), CGAL::parameters::visitor(std::ref(none)));
  for(int throw_at : {300, 303, 307, 312}) { // between steps of a path, after some of its flips
    Disturbing_visitor visitor;
    visitor.stop_at = 50;
    visitor.throw_at = throw_at;
    std::vector<Path> paths;
    if(throw_at == 300)
      FG::geodesic_paths<CGAL::Parallel_if_available_tag>(mesh, pairs, std::back_inserter(paths),
                                                          CGAL::parameters::visitor(std::ref(visitor)));
    else
      FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::visitor(std::ref(visitor)));
    int stopped = 0, thrown = 0;
    for(std::size_t i = 0; i < pairs.size(); ++i) {
      const bool is_stopped = !paths[i].error && paths[i].status() == FG::Shortening_status::STOPPED_BY_VISITOR;
      stopped += is_stopped ? 1 : 0;
      thrown += paths[i].error ? 1 : 0;
      if(!is_stopped && !paths[i].error)
        BOOST_TEST((paths[i].points == undisturbed[i].points));
    }
    BOOST_TEST(stopped == 1);
    BOOST_TEST(thrown == 1);
  }
}

// A pair whose ends are one vertex throws as soon as a path is searched.
BOOST_AUTO_TEST_CASE(no_path_is_searched_once_the_visitor_has_canceled)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(8, 0.2, 3));
  Pairs pairs = random_pairs(mesh, 20, 5);
  for(std::size_t i = 5; i < pairs.size(); ++i)
    pairs[i].second = pairs[i].first;
  struct Cancelling_visitor : FG::Default_shortening_visitor
  {
    std::size_t calls = 0;
    bool go_further()
    {
      ++calls;
      return false;
    }
  } visitor;
  std::vector<Path> paths;
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_TEST_REQUIRE(paths.size() == pairs.size());
  for(const Path& path : paths) {
    BOOST_TEST(!path.error);
    BOOST_TEST(path.points.empty());
    BOOST_TEST((path.status() == FG::Shortening_status::STOPPED_BY_VISITOR));
  }
  BOOST_TEST(visitor.calls == pairs.size());
}

// Whatever a path that was interrupted has flipped, the next one starts from the mesh's own edges.
BOOST_AUTO_TEST_CASE(an_exception_leaves_no_flips_behind)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(8, 0.2, 3));
  Pairs pairs; // each three times, so that the next path passes where the last one did
  for(const auto& pair : random_pairs(mesh, 4, 5))
    pairs.insert(pairs.end(), 3, pair);
  std::vector<Path> undisturbed;
  Disturbing_visitor none;
  FG::geodesic_paths(mesh, pairs, std::back_inserter(undisturbed), CGAL::parameters::visitor(std::ref(none)));
  for(int throw_at = 3; throw_at < none.steps; throw_at += 7) {
    Disturbing_visitor visitor;
    visitor.throw_at = throw_at;
    std::vector<Path> paths;
    FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::visitor(std::ref(visitor)));
    int thrown = 0;
    for(std::size_t i = 0; i < pairs.size(); ++i) {
      thrown += paths[i].error ? 1 : 0;
      if(paths[i].error)
        continue;
      BOOST_TEST((paths[i].points == undisturbed[i].points));
      BOOST_TEST(paths[i].report.curves[0].initial_length == undisturbed[i].report.curves[0].initial_length);
    }
    BOOST_TEST(thrown == 1);
  }
}

BOOST_AUTO_TEST_CASE(without_a_lower_bound_all_searches_are_one_and_landmarks_direct_it)
{
  Mesh mesh = to_mesh<Mesh>(jittered_grid(20, 20, Diagonal_rule::RISING, 0.2, 5));
  using Lengths = Mesh::Property_map<Mesh::Edge_index, double>;
  const Lengths lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  for(Mesh::Edge_index e : mesh.edges())
    put(lengths, e, std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
  using Metric = FG::Edge_length_metric<Mesh, Lengths>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Kernel>, Metric>;
  using Search = FG::Shortest_edge_path<Triangulation>;
  const Triangulation triangulation(mesh, Metric(mesh, lengths));
  Search dijkstra(triangulation, CGAL::parameters::search_method(FG::Search_method::DIJKSTRA)),
      a_star(triangulation, CGAL::parameters::search_method(FG::Search_method::A_STAR)),
      look_back(triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  const FG::Landmark_distances landmarks(dijkstra);
  Search directed(triangulation, CGAL::parameters::landmarks(landmarks));
  const auto length_of = [&](const std::vector<FG::Halfedge_index>& path) {
    return std::accumulate(path.begin(), path.end(), 0.0,
                           [&](double sum, FG::Halfedge_index h) { return sum + triangulation.length(h); });
  };
  std::size_t settled = 0, settled_with_landmarks = 0;
  for(const auto& [source, target] : random_pairs(mesh, 20, 3)) {
    const FG::Vertex_index s = triangulation.index(source), t = triangulation.index(target);
    const auto path = dijkstra(s, t);
    settled += dijkstra.settled_vertices();
    for(Search* search : {&a_star, &look_back}) {
      BOOST_TEST(((*search)(s, t) == path));
      BOOST_TEST(search->settled_vertices() == dijkstra.settled_vertices());
    }
    BOOST_TEST(landmarks.distance_lower_bound(s, t) <= length_of(path));
    BOOST_TEST(landmarks.distance_lower_bound(s, t) == landmarks.distance_lower_bound(t, s));
    BOOST_TEST(landmarks.distance_lower_bound(s, s) == 0);
    BOOST_TEST(length_of(directed(s, t)) < 1.03 * length_of(path));
    settled_with_landmarks += directed.settled_vertices();
  }
  BOOST_TEST(3 * settled_with_landmarks < settled);
}

// Of all pairs, also in components that are smaller than others, and with lengths that are far from the distances in
// space. No bound is above the length of a path, not even in the last digit.
BOOST_AUTO_TEST_CASE(landmarks_bound_edge_paths_in_each_component)
{
  const auto apart = [](Mesh_soup soup) {
    return mapped(soup, [](const Coordinates& p) { return Coordinates{p[0] + 40, p[1], p[2]}; });
  };
  Mesh mesh = to_mesh<Mesh>(disjoint_union(jittered_grid(14, 14, Diagonal_rule::RISING, 0.2, 5),
                                           apart(jittered_grid(9, 9, Diagonal_rule::RISING, 0.2, 6))));
  using Lengths = Mesh::Property_map<Mesh::Edge_index, double>;
  const Lengths lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  std::mt19937 random(4);
  for(Mesh::Edge_index e : mesh.edges())
    put(lengths, e, std::uniform_real_distribution<double>(1, 1.9)(random));
  using Metric = FG::Edge_length_metric<Mesh, Lengths>;
  using Triangulation = FG::Intrinsic_triangulation<Mesh, FG::Intrinsic_triangulation_traits<Kernel>, Metric>;
  const Triangulation triangulation(mesh, Metric(mesh, lengths));
  FG::Shortest_edge_path<Triangulation> search(triangulation,
                                               CGAL::parameters::search_method(FG::Search_method::DIJKSTRA));
  const FG::Landmark_distances landmarks(search);
  for(Vertex v : mesh.vertices()) {
    const FG::Vertex_index source = triangulation.index(v);
    double bounds = 0, distances = 0;
    bool are_bounds = true;
    search.visit_all(source, [&](FG::Vertex_index w, double distance) {
      const double bound = landmarks.distance_lower_bound(source, w);
      are_bounds = are_bounds && bound <= distance;
      bounds += bound;
      distances += distance;
    });
    BOOST_TEST(are_bounds);
    BOOST_TEST(bounds > 0.6 * distances);
  }
}

// The path round the end of a wall, which the line through space knows nothing of.
BOOST_AUTO_TEST_CASE(landmarks_know_the_way_round)
{
  Mesh_soup soup = flat_grid(40, 40, Diagonal_rule::RISING);
  const auto is_in_wall = [&](const auto& face) {
    const auto& p = soup.points[face[0]];
    return p[0] > 18 && p[0] < 22 && p[1] < 35;
  };
  soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(), is_in_wall), soup.triangles.end());
  Mesh mesh = to_mesh<Mesh>(soup);
  const Vertex alone = mesh.add_vertex(Kernel::Point_3(0, 0, 9)), source(41 * 2 + 5), target(41 * 2 + 35);
  const FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
  using Search = FG::Shortest_edge_path<FG::Intrinsic_triangulation<Mesh>>;
  Search look_back(triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  const FG::Landmark_distances landmarks(look_back);
  Search directed(triangulation, CGAL::parameters::landmarks(landmarks));
  look_back(triangulation.index(source), triangulation.index(target));
  directed(triangulation.index(source), triangulation.index(target));
  BOOST_TEST(2 * directed.settled_vertices() < look_back.settled_vertices());

  std::vector<Path> paths, directed_paths;
  const Pairs pairs = {{source, target}, {source, alone}, {Vertex(0), Vertex(40)}};
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths));
  FG::geodesic_paths(mesh, pairs, std::back_inserter(directed_paths), CGAL::parameters::landmarks(landmarks));
  BOOST_CHECK_THROW(std::rethrow_exception(directed_paths[1].error), FG::Disconnected_endpoints_error);
  for(const std::size_t i : {0u, 2u})
    BOOST_TEST(directed_paths[i].length() == paths[i].length(), boost::test_tools::tolerance(1e-12));

  // Landmarks of another mesh have no distances of further vertices.
  mesh.add_vertex(Kernel::Point_3(0, 0, 9));
  const FG::Intrinsic_triangulation<Mesh> larger(mesh);
  BOOST_CHECK_THROW(Search(larger, CGAL::parameters::landmarks(landmarks)), FG::Input_mismatch_error);
  directed_paths.clear();
  FG::geodesic_paths(mesh, pairs, std::back_inserter(directed_paths), CGAL::parameters::landmarks(landmarks));
  BOOST_TEST(directed_paths.size() == pairs.size());
  for(const Path& path : directed_paths)
    BOOST_CHECK_THROW(std::rethrow_exception(path.error), FG::Input_mismatch_error);
}

BOOST_AUTO_TEST_CASE(a_search_towards_a_point_that_is_no_number_says_so)
{
  Mesh mesh = to_mesh<Mesh>(flat_grid(6, 6, Diagonal_rule::RISING));
  mesh.point(Vertex(40)) = Kernel::Point_3(std::nan(""), 0, 0);
  const FG::Intrinsic_triangulation<Mesh> triangulation(mesh);
  for(auto method : {FG::Search_method::LOOK_BACK, FG::Search_method::A_STAR, FG::Search_method::DIJKSTRA}) {
    FG::Shortest_edge_path<FG::Intrinsic_triangulation<Mesh>> search(triangulation,
                                                                     CGAL::parameters::search_method(method));
    BOOST_CHECK_THROW(search(0_v, 40_v), FG::Invalid_coordinate_error);
    BOOST_CHECK_THROW(search(40_v, 0_v), FG::Invalid_coordinate_error);
    BOOST_TEST(search(0_v, 3_v).size() == 3u); // and what lies elsewhere is found
  }
}

BOOST_AUTO_TEST_CASE(the_queue_hands_out_by_priority_and_then_by_vertex)
{
  std::mt19937 random(11);
  FG::internal::Vertex_queue queue;
  std::multiset<std::pair<double, FG::Vertex_index>> reference;
  for(int round = 0; round < 20000; ++round) {
    if(reference.empty() || random() % 5 < 3) {
      const double priority = random() % 3 == 0 ? 0.25 * static_cast<double>(random() % 8) : std::ldexp(random(), -20);
      const FG::Vertex_index vertex(static_cast<FG::Index>(random() % 1000));
      queue.push(priority, vertex);
      reference.emplace(priority, vertex);
    } else {
      BOOST_TEST_REQUIRE(queue.pop() == reference.begin()->second);
      reference.erase(reference.begin());
    }
  }
  for(; !reference.empty(); reference.erase(reference.begin()))
    BOOST_TEST_REQUIRE(queue.pop() == reference.begin()->second);
  BOOST_TEST(queue.empty());
}

BOOST_AUTO_TEST_CASE(the_queue_takes_minus_zero_for_zero)
{
  FG::internal::Vertex_queue queue;
  queue.push(3.0, 0_v);
  queue.push(0.0, 2_v);
  queue.push(-0.0, 1_v);
  for(FG::Vertex_index expected : {1_v, 2_v, 0_v})
    BOOST_TEST(queue.pop() == expected);
#ifndef CGAL_NO_PRECONDITIONS
  BOOST_CHECK_THROW(queue.push(-1.0, 0_v), CGAL::Failure_exception);
#endif
}

// Between points of any kinds, each as by a single call; a point that is too far away is an error of its own pair.
BOOST_AUTO_TEST_CASE(paths_between_points_are_those_of_single_calls)
{
  using Location = std::pair<Mesh::Face_index, std::array<double, 3>>;
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(8, 0.1, 3));
  std::mt19937 random(5);
  const auto location = [&] {
    const double a = static_cast<double>(random() % 64) / 128, b = static_cast<double>(random() % 64) / 128;
    return Location(Mesh::Face_index(static_cast<Mesh::size_type>(random() % mesh.number_of_faces())),
                    {{a, b, 1 - a - b}});
  };
  std::vector<std::pair<Location, Location>> pairs;
  std::vector<std::pair<Vertex, Kernel::Point_3>> mixed;
  for(Mesh::size_type i = 0; i < 20; ++i) {
    pairs.emplace_back(location(), location());
    mixed.emplace_back(Vertex(3 * i), Kernel::Point_3(i == 7 ? 9 : 0.5, 0.25 * i, 1));
  }
  const auto check = [&](const auto& ends, const auto& np) {
    std::vector<Path> paths, in_parallel;
    FG::geodesic_paths(mesh, ends, std::back_inserter(paths), np);
    FG::geodesic_paths<CGAL::Parallel_if_available_tag>(mesh, ends, std::back_inserter(in_parallel), np);
    check_same(paths, in_parallel);
    std::size_t errors = 0;
    for(std::size_t i = 0; i < ends.size(); ++i) {
      if(paths[i].error) {
        ++errors;
        BOOST_CHECK_THROW(std::rethrow_exception(paths[i].error), FG::Distant_point_error);
        continue;
      }
      std::vector<Kernel::Point_3> points;
      const auto single = FG::geodesic_path(mesh, ends[i].first, ends[i].second, std::back_inserter(points), np);
      BOOST_TEST((paths[i].points == points));
      BOOST_TEST(paths[i].length() == single.length());
      BOOST_TEST((paths[i].verdict() == single.verdict()));
      BOOST_TEST(paths[i].report.curves.front().point_distances == single.report.curves.front().point_distances,
                 boost::test_tools::per_element());
    }
    return errors;
  };
  using End = std::variant<Vertex, Location, Kernel::Point_3>;
  std::vector<std::pair<End, End>> of_several_types;
  for(std::size_t i = 0; i < pairs.size(); ++i)
    of_several_types.emplace_back(i % 2 == 0 ? End(pairs[i].first) : End(mixed[i].second), mixed[i].first);
  BOOST_TEST(check(of_several_types, CGAL::parameters::greatest_point_distance(7)) > 0u);
  BOOST_TEST(check(pairs, CGAL::parameters::greatest_point_distance(0)) == 0u);
  BOOST_TEST(check(mixed, CGAL::parameters::greatest_point_distance(7)) > 0u);
}
