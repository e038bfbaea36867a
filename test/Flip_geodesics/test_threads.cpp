// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What several threads may do at once. Without the thread sanitizer (`cmake --preset thread-sanitizer`), a race is
// mostly not noticed.

#define BOOST_TEST_MODULE Threads

#include "Curve_setting.h"
#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/refine.h>

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

using namespace Flip_geodesics_test;

namespace {

namespace FG = CGAL::Flip_geodesics;
using Triangulation = FG::Intrinsic_triangulation<Surface>; // of certified traits, which leave decisions open

constexpr int number_of_threads = 4;
constexpr std::size_t most_memory = std::size_t(1) << 27; // of records; much more than these meshes need

// Calls a function by several threads, which begin together, with their numbers.
void run_at_once(const std::function<void(int)>& function)
{
  std::atomic<int> waiting{number_of_threads};
  std::vector<std::thread> threads;
  for(int i = 0; i < number_of_threads; ++i)
    threads.emplace_back([&, i] {
      for(--waiting; waiting > 0;)
        std::this_thread::yield();
      function(i);
    });
  for(std::thread& thread : threads)
    thread.join();
}

// All that is read of a halfedge, in numbers that can be compared.
std::vector<double> all_of(const Triangulation& t, FG::Halfedge_index h)
{
  std::vector<double> result = {double(t.tail(h).idx()),       double(t.head(h).idx()),
                                double(t.is_border(h)),        t.length(h),
                                double(t.clockwise(h).idx()),  double(t.counterclockwise(h).idx()),
                                double(t.is_flippable(h)),     double(t.is_locally_delaunay(h)),
                                double(t.holds(t.edge(h))),    double(t.version(t.edge(h))),
                                double(t.crossings(t.edge(h)))};
  if(!t.is_border(h)) {
    result.push_back(t.next(h).idx());
    result.push_back(t.previous(h).idx());
    result.push_back(t.geometry(h).x);
    result.push_back(t.geometry(h).y);
  }
  const auto walker = t.walker(h);
  result.push_back(walker.twin().tail().idx());
  result.push_back(walker.length());
  const FG::Edge_sequence word = t.edge_sequence(h);
  for(FG::Input_halfedge_index crossed : word.crossed)
    result.push_back(crossed.idx());
  // A decision that is open wherever angles are straight.
  typename Triangulation::Turn turn;
  for(FG::Halfedge_index g = h;;) {
    const FG::Halfedge_index next = t.extend_turn_clockwise(turn, g);
    if(next == FG::null_index || next == h)
      break;
    g = next;
    result.push_back(t.is_straight(turn, h, g));
    if(result.back() > 0)
      break;
  }
  const auto precise = FG::internal::Internals<Triangulation>::precise_edge(t, h);
  result.push_back(precise.length);
  result.push_back(t.tail(t.outgoing(t.tail(h))) == t.tail(h));
  return result;
}

std::vector<std::vector<double>> all_of(const Triangulation& t)
{
  std::vector<std::vector<double>> result;
  for(FG::Halfedge_index h : FG::internal::descriptors<FG::Halfedge_index>(t.number_of_halfedges()))
    result.push_back(all_of(t, h));
  return result;
}

// Threads that begin at different halfedges find the same as one thread in another triangulation that is the same.
void check_reads(const Triangulation& read_by_one, const Triangulation& read_by_several)
{
  const std::vector<std::vector<double>> expected = all_of(read_by_one);
  std::atomic<int> mistakes{0};
  run_at_once([&](int thread) {
    const int n = static_cast<int>(expected.size());
    for(int i = 0; i < n; ++i) {
      const int k = thread % 2 == 0 ? (i + thread * n / number_of_threads) % n : n - 1 - i;
      if(all_of(read_by_several, FG::Halfedge_index(k)) != expected[static_cast<std::size_t>(k)])
        ++mistakes;
      if(read_by_several.memory_of_records() > most_memory || read_by_several.decision_statistics().unproven_zeros > 0)
        ++mistakes;
    }
  });
  BOOST_TEST(mistakes == 0);
  BOOST_TEST(read_by_several.is_valid());
}

// So often, those that can be flipped.
void flip_every_third_edge(Triangulation& t, int rounds)
{
  for(int round = 0; round < rounds; ++round)
    for(FG::Index e = round; e < t.number_of_edges(); e += 3)
      if(t.is_flippable(FG::internal::first_side(FG::Edge_index(e))))
        t.flip(FG::internal::first_side(FG::Edge_index(e)));
}

} // namespace

// Faces are copied, straight angles are decided exactly, and both are kept.
BOOST_AUTO_TEST_CASE(an_untouched_triangulation_is_read_by_several_threads)
{
  for(const Mesh_soup& soup : {flat_grid(12, 12, Diagonal_rule::RISING), bumpy_sphere(6, 0.2, 1), cube(4)}) {
    const Surface mesh = to_mesh<Surface>(soup);
    check_reads(Triangulation(mesh), Triangulation(mesh));
  }
}

// Words and vectors are derived, from the flip log where points were inserted.
BOOST_AUTO_TEST_CASE(a_flipped_and_refined_triangulation_is_read_by_several_threads)
{
  for(bool has_points : {false, true})
    for(const Mesh_soup& soup : {lantern(8, 6), bumpy_sphere(5, 0.2, 1)}) {
      const Surface mesh = to_mesh<Surface>(soup);
      Triangulation one(mesh), other(mesh);
      for(Triangulation* t : {&one, &other}) {
        if(has_points)
          FG::refine(*t, {25, 0.3, 200});
        flip_every_third_edge(*t, 3);
      }
      BOOST_TEST(one.log_position() > 0u);
      check_reads(one, other);
    }
}

// Several threads may compute with triangulations of their own over one mesh, as before.
BOOST_AUTO_TEST_CASE(each_thread_has_a_triangulation_of_its_own)
{
  const Surface mesh = to_mesh<Surface>(bumpy_sphere(6, 0.2, 1));
  std::vector<double> lengths(number_of_threads);
  run_at_once([&](int thread) {
    Triangulation t(mesh);
    FG::Edge_path_network<Triangulation> network(t);
    FG::Shortest_edge_path<Triangulation> search(t);
    network.add_curve(search(FG::Vertex_index(0), FG::Vertex_index(100)));
    FG::shorten(network);
    lengths[static_cast<std::size_t>(thread)] = network.length(FG::Curve_index(0));
  });
  for(double length : lengths)
    BOOST_TEST(length == lengths.front());
}
