// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Searches along edges, and the landmarks that are made of them, are stopped at each call of a visitor in turn.

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_interruption/stopping.h"

#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/geodesic_paths.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using Search = Setting::Search;
using Points = std::vector<Mesh::Point>;

// A strip so long that a search from end to end calls a visitor three times.
constexpr int strip_length = 2000;
Mesh_soup long_strip() { return flat_grid(strip_length, 1, Diagonal_rule::RISING); }
Vertex_index strip_end() { return Vertex_index(strip_length); }

} // namespace

BOOST_AUTO_TEST_CASE(one_edge_path)
{
  const Setting setting(long_strip());
  for(const FG::Search_method method :
      {FG::Search_method::DIJKSTRA, FG::Search_method::A_STAR, FG::Search_method::LOOK_BACK})
  {
    Search search(setting.triangulation, CGAL::parameters::search_method(method));
    const auto expected = search(0_v, strip_end());
    const std::size_t settled = search.settled_vertices();
    const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
      const auto path = search(0_v, strip_end(), CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST((path == (is_stopped ? std::vector<FG::Halfedge_index>() : expected)));
      BOOST_TEST(search.settled_vertices() == (is_stopped ? most_between_calls * visitor.calls : settled));
      BOOST_TEST((search(0_v, strip_end()) == expected));
    });
    BOOST_TEST(calls == (settled - 1) / most_between_calls);
    BOOST_TEST(calls > 0u);
  }
}

BOOST_AUTO_TEST_CASE(all_vertices_from_one)
{
  const Setting setting(long_strip());
  Search search(setting.triangulation);
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    std::size_t visited = 0;
    BOOST_TEST(search.visit_all(
                   0_v, [&](Vertex_index, double) { ++visited; }, CGAL::parameters::visitor(std::ref(visitor))) ==
               !is_stopped);
    BOOST_TEST(visited == (is_stopped ? most_between_calls * visitor.calls : num_vertices(setting.mesh)));
  });
  BOOST_TEST(calls == num_vertices(setting.mesh) / most_between_calls);
}

// Stopped at the first call, which is one of the search, a path of the functions for one call is not written.
BOOST_AUTO_TEST_CASE(one_path)
{
  constexpr int length = 1200; // shortening takes a time that grows with its square
  static_assert(length > most_between_calls, "the visitor is called in the search, which settles the path at least");
  const Mesh mesh = to_mesh<Mesh>(flat_grid(length, 1, Diagonal_rule::RISING));
  const Mesh::Vertex_index source(0), target(static_cast<unsigned>(length));
  const auto check = [&](const auto& compute, const auto& status) {
    Points expected;
    compute(std::back_inserter(expected), CGAL::parameters::default_values());
    BOOST_TEST(expected.size() > 1u);
    for(const bool is_stopped : {false, true}) {
      Stopping_visitor visitor;
      visitor.most = is_stopped ? 0 : visitor.most;
      Points points;
      const auto result = compute(std::back_inserter(points), CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST((status(result) == FG::Shortening_status::STOPPED_BY_VISITOR) == is_stopped);
      BOOST_TEST((points == (is_stopped ? Points() : expected)));
      BOOST_TEST(visitor.calls > 0u);
    }
  };
  check([&](auto out, const auto& np) { return FG::geodesic_path(mesh, source, target, out, np); },
        [](const auto& result) { return result.status(); });
  check([&](auto out, const auto& np) { return FG::shortest_path(mesh, source, target, out, np); },
        [](const auto& result) {
          BOOST_TEST((result.report.is_confirmed() || result.status() == FG::Shortening_status::STOPPED_BY_VISITOR));
          return result.status();
        });
}

// Before each pair and in each search; nothing else asks as the strip is flat.
BOOST_AUTO_TEST_CASE(many_paths)
{
  const Mesh mesh = to_mesh<Mesh>(long_strip());
  const Mesh::Vertex_index source(0), target(static_cast<unsigned>(strip_length));
  const std::vector<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>> pairs(2, {source, target});
  Stopping_visitor visitor;
  visitor.most = 1;
  std::vector<FG::Geodesic_path_result<Mesh::Point>> paths;
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths), CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_TEST(visitor.calls == 3u); // before the first pair, in its search, and before the second pair
  for(const auto& path : paths) {
    BOOST_TEST(!path.error);
    BOOST_TEST((path.status() == FG::Shortening_status::STOPPED_BY_VISITOR));
    BOOST_TEST(path.points.empty());
  }
}

BOOST_AUTO_TEST_CASE(landmarks_of_edge_paths)
{
  const Setting setting(long_strip());
  Search search(setting.triangulation, CGAL::parameters::search_method(FG::Search_method::LOOK_BACK));
  const FG::Landmark_distances expected(search);
  BOOST_TEST(expected.is_complete());
  BOOST_TEST(expected.distance_lower_bound(0_v, strip_end()) > 0.9 * strip_length);
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    const FG::Landmark_distances landmarks(search, CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(landmarks.is_complete() == !is_stopped);
    for(Vertex_index v : descriptors<Vertex_index>(setting.triangulation.number_of_vertices()))
      BOOST_TEST(landmarks.distance_lower_bound(0_v, v) == (is_stopped ? 0 : expected.distance_lower_bound(0_v, v)));
    BOOST_TEST(!Search(setting.triangulation, CGAL::parameters::landmarks(landmarks))(0_v, strip_end()).empty());
  });
  BOOST_TEST(calls > 50u); // 17 searches
}

BOOST_AUTO_TEST_CASE(geodesic_landmarks)
{
  const Setting setting(bumpy_sphere(12, 0.2, 3));
  const Vertex_index last(setting.triangulation.number_of_vertices() - 1);
  const FG::Geodesic_landmarks expected(setting.triangulation, 4);
  const std::vector<Vertex_index> given = {0_v, 7_v};
  BOOST_TEST(expected.is_complete());
  const auto check = [&](const FG::Geodesic_landmarks& landmarks, std::size_t number, bool is_stopped) {
    BOOST_TEST(landmarks.is_complete() == !is_stopped);
    BOOST_TEST(landmarks.number_of_landmarks() == (is_stopped ? 0 : number));
    BOOST_TEST((landmarks.distance_lower_bound(0_v, last) > 0) == !is_stopped);
    landmarks.check_input(setting.triangulation);
  };
  const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
    const FG::Geodesic_landmarks landmarks(setting.triangulation, 4, CGAL::Sequential_tag(),
                                           CGAL::parameters::visitor(std::ref(visitor)));
    check(landmarks, 4, is_stopped);
    if(!is_stopped)
      BOOST_TEST(landmarks.distance_lower_bound(0_v, last) == expected.distance_lower_bound(0_v, last));
  });
  BOOST_TEST(calls > 10u);
  BOOST_TEST(stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
               check(FG::Geodesic_landmarks(setting.triangulation, given, CGAL::Sequential_tag(),
                                            CGAL::parameters::visitor(std::ref(visitor))),
                     2, is_stopped);
             }) > 5u);
#ifdef CGAL_LINKED_WITH_TBB
  // How often it is called depends on what the other threads do; the first calls are those of the searches.
  for(std::size_t most = 0; most < 4; ++most) {
    Stopping_visitor visitor;
    visitor.most = most;
    check(FG::Geodesic_landmarks(setting.triangulation, 4, CGAL::Parallel_tag(),
                                 CGAL::parameters::visitor(std::ref(visitor))),
          4, true);
    BOOST_TEST(visitor.calls == most + 1);
  }
  Stopping_visitor patient;
  check(FG::Geodesic_landmarks(setting.triangulation, 4, CGAL::Parallel_tag(),
                               CGAL::parameters::visitor(std::ref(patient))),
        4, false);
  BOOST_TEST(!patient.is_called_from_elsewhere);
#endif
}

BOOST_AUTO_TEST_CASE(geodesic_landmarks_of_a_mesh)
{
  const Mesh mesh = to_mesh<Mesh>(bumpy_sphere(6, 0.2, 3));
  const auto check = [&](const auto& chosen) {
    const std::size_t calls = stop_at_each_call([&](Stopping_visitor& visitor, bool is_stopped) {
      const auto landmarks = FG::geodesic_landmarks(mesh, chosen, CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST(landmarks.is_complete() == !is_stopped);
    });
    BOOST_TEST(calls > 1u);
  };
  check(std::size_t(2));
  check(std::vector<Mesh::Vertex_index>(1, Mesh::Vertex_index(0)));
}
