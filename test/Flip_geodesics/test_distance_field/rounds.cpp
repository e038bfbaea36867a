// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The rounds in which a field is computed, and the threads that share them.

#include "test_distance_field/asked_surface.h"

#include <CGAL/Flip_geodesics/internal/field/Round_queue.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <map>
#include <type_traits>

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
        queue.push(key, pushed);
        pending.insert({key, pushed});
      }
      BOOST_TEST(queue.least() == pending.begin()->first);
      now = queue.least() + step;
      queue.take(now, step, [&](double key, FG::Index id) {
        BOOST_TEST(key <= now);
        const auto [first, last] = pending.equal_range(key);
        const auto found = std::find_if(first, last, [&](const auto& entry) { return entry.second == id; });
        BOOST_REQUIRE((found != last));
        pending.erase(found);
      });
      BOOST_TEST((pending.empty() || pending.begin()->first > now));
      BOOST_TEST(queue.empty() == pending.empty());
    }
  }
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
        several.compute<CGAL::Parallel_if_available_tag>(limits);
        limits.windows = FG::Window_limit();
        BOOST_TEST(several.compute<CGAL::Parallel_if_available_tag>(limits).windows == windows);
      };
#ifdef CGAL_LINKED_WITH_TBB
      tbb::task_arena(4).execute(compute);
#else
      compute();
#endif
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
