// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The rounds in which a field is computed, and the threads that share them.

#include "test_distance_field/asked_surface.h"

#include <CGAL/Flip_geodesics/internal/distances/Round_worker.h>
#include <CGAL/Flip_geodesics/internal/surface/for_each_index.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

using namespace Flip_geodesics_test;

// What is due comes once, at the first time that is asked for it, whatever the steps.
BOOST_AUTO_TEST_CASE(a_queue_of_rounds)
{
  for(const double step : {0.0, 0.01, 1.0}) {
    std::mt19937 random(3);
    const auto number = [&] { return static_cast<double>(random() % 1000) / 1000; };
    FG::internal::Round_queue queue;
    std::multimap<double, FG::Index> pending;
    BOOST_TEST(queue.empty());
    BOOST_TEST(queue.least() == infinity);
    double now = 0;
    FG::Index pushed = 0;
    for(int round = 0; round < 400 || !pending.empty(); ++round) {
      for(int i = 0; round < 400 && i < 10; ++i, ++pushed) {
        const double key = now + number() * (i == 0 ? 100 : 1); // some are due much later
        queue.push({key, pushed, static_cast<std::uint32_t>(3 * pushed)});
        pending.insert({key, pushed});
      }
      BOOST_TEST(queue.least() == pending.begin()->first);
      now = queue.least() + step;
      const std::size_t most = queue.look_ahead(now, step);
      std::size_t taken = 0;
      queue.take(now, [&](const FG::internal::Round_queue::Entry& e) {
        ++taken;
        BOOST_TEST(e.key <= now);
        BOOST_TEST(e.tag == static_cast<std::uint32_t>(3 * e.id));
        const auto [first, last] = pending.equal_range(e.key);
        const auto found = std::find_if(first, last, [&](const auto& entry) { return entry.second == e.id; });
        BOOST_REQUIRE((found != last));
        pending.erase(found);
      });
      BOOST_TEST(taken <= most);
      BOOST_TEST((pending.empty() || pending.begin()->first > now));
      BOOST_TEST(queue.empty() == pending.empty());
    }
  }
}

// Runs with four threads where there is TBB, however few cores there are.
template <class Function>
void run_by_four(const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena(4).execute(function);
#else
  function();
#endif
}

// Each index occurs once in each of many loops, and no two threads of a loop have the same number at the same time.
BOOST_AUTO_TEST_CASE(threads_of_a_loop_have_numbers)
{
  using Tag = CGAL::Parallel_if_available_tag;
  run_by_four([] {
    const std::size_t threads = FG::internal::number_of_threads<Tag>();
    std::vector<std::atomic<int>> at_work(threads);
    std::atomic<bool> is_shared{false};
    for(std::size_t n = 0; n < 300; ++n) {
      std::vector<int> times(n);
      FG::internal::for_each_index<Tag>(n, [&](std::size_t i) {
        const std::size_t thread = FG::internal::thread_index<Tag>();
        is_shared = is_shared || thread >= threads || ++at_work[thread] != 1;
        ++times[i];
        --at_work[thread];
      });
      BOOST_TEST((times == std::vector<int>(n, 1)));
    }
    BOOST_TEST(!is_shared);
  });
}

// A grid some of whose faces are quadrilaterals, several of which are reached in one round from the middle.
Mesh grid_with_quads(int n, std::mt19937& random)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      v.push_back(mesh.add_vertex(Point(i, j, 0)));
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const auto at = [&](int k, int l) { return v[static_cast<std::size_t>((i + k) * (n + 1) + j + l)]; };
      if(random() % 8 == 0 && i != n / 2) {
        mesh.add_face(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
      } else {
        mesh.add_face(at(0, 0), at(1, 0), at(1, 1));
        mesh.add_face(at(0, 0), at(1, 1), at(0, 1));
      }
    }
  return mesh;
}

// If several items of a round throw, the exception of the same face is rethrown for any number of threads.
BOOST_AUTO_TEST_CASE(threads_throw_the_same)
{
  std::mt19937 random(6);
  std::set<std::string> all;
  for(int i = 0; i < 20; ++i) {
    const Mesh mesh = grid_with_quads(12, random);
    const Triangulation triangulation(mesh);
    const auto message = [&](auto tag) {
      Field field(triangulation, mesh);
      field.add_source(FG::Vertex_index(6 * 13 + 6));
      try {
        field.template compute<decltype(tag)>();
      } catch(const FG::Invalid_mesh_error& error) {
        return std::string(error.what());
      }
      return std::string();
    };
    const std::string thrown = message(CGAL::Sequential_tag());
    BOOST_TEST(!thrown.empty());
    all.insert(thrown);
    run_by_four([&] { BOOST_TEST(message(CGAL::Parallel_if_available_tag()) == thrown); });
  }
  BOOST_TEST(all.size() > 10u);
}

#ifdef CGAL_LINKED_WITH_TBB
static_assert(std::is_convertible<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value, "threads are tested");
#endif

// The results have the same bits for each number of threads, and wherever the computation has paused.
BOOST_AUTO_TEST_CASE(threads_change_nothing)
{
  std::mt19937 random(5);
  for(const auto& [name, soup] : meshes()) {
    BOOST_TEST_CONTEXT(name)
    {
      const Asked_surface s(soup);
      const Location point = s.random_location(random), first{point.halfedge, {{5, 1, 1}}};
      const std::vector<Location> curve = {first, {point.halfedge, {{1, 2, 4}}}};
      Field one(s.triangulation, s.mesh), several(s.triangulation, s.mesh);
      for(Field* field : {&one, &several}) {
        field->add_source(3_v);
        field->add_source(point, 0.1);
        field->add_curve(curve, 0.05);
      }
      const std::size_t windows = one.compute().windows;
      FG::Distance_field_limits limits;
      limits.windows = FG::Window_limit(windows / 2);
      const auto compute = [&] {
        several.compute<CGAL::Parallel_if_available_tag>(CGAL::parameters::search_limit(limits));
        limits.windows = FG::Window_limit();
        BOOST_TEST(several.compute<CGAL::Parallel_if_available_tag>(CGAL::parameters::search_limit(limits)).windows ==
                   windows);
      };
      run_by_four(compute);
      for(int i = 0; i < 100; ++i) {
        const Location at = s.random_location(random);
        BOOST_TEST(one.distance(at) == several.distance(at));
        BOOST_TEST(one.answer(at).source == several.answer(at).source);
        std::vector<Point> path, other;
        one.path(at, std::back_inserter(path));
        several.path(at, std::back_inserter(other));
        BOOST_TEST((path == other));
      }
    }
  }
}
