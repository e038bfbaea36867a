// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Containers of the library against those of the standard one: stacks in blocks, values with versions, queues, and
// records.

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/distances/Round_worker.h>
#include <CGAL/Flip_geodesics/internal/network/Bundle_order.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Edge_history.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace FGI = CGAL::Flip_geodesics::internal;
using CGAL::Flip_geodesics::Index;

} // namespace

BOOST_AUTO_TEST_CASE(a_stack_in_blocks_is_a_stack)
{
  std::mt19937 random(1);
  FGI::Block_array<int> stack;
  std::vector<int> model;
  for(int round = 0; round < 400; ++round) {
    const std::size_t size = random() % 5 == 0 ? 512 * (random() % 4) : random() % 2000;
    switch(random() % 3) {
    case 0: // one by one
      while(model.size() < size) {
        model.push_back(static_cast<int>(random() % 1000));
        stack.push_back(int(model.back()));
      }
      while(model.size() > size) {
        model.pop_back();
        stack.pop_back();
      }
      break;
    case 1:
      stack.resize(size, round);
      model.resize(size, round);
      break;
    case 2: {
      FGI::Block_array<int> other(std::move(stack));
      stack = std::move(other);
    }
    }
    BOOST_REQUIRE(stack.size() == model.size());
    BOOST_TEST(stack.empty() == model.empty());
    BOOST_TEST(stack.memory() == model.size() * sizeof(int));
    if(model.empty())
      continue;
    BOOST_TEST(stack.back() == model.back());
    bool is_same = true;
    for(std::size_t i = 0; i < model.size(); ++i)
      is_same = is_same && stack[i] == model[i];
    BOOST_TEST(is_same);
  }
}

BOOST_AUTO_TEST_CASE(a_cache_of_versions_drops_what_was_not_asked_for_longest)
{
  struct Entry
  {
    Index version;
    int value;
    std::size_t bytes;
  };
  FGI::Version_cache<int> cache;
  std::list<Entry> model; // the newest first
  Index slots = 0, last = 0;
  cache.insert(1, 5, 0);
  const std::size_t entry_size = cache.memory() - sizeof(Index);
  std::vector<int> dropped;
  const auto recycle = [&](int value) { dropped.push_back(value); };
  cache.forget(1, recycle);
  BOOST_TEST((dropped == std::vector<int>{5}));
  BOOST_TEST(cache.memory() == 0u);

  const auto found = [&](Index v) {
    return std::find_if(model.begin(), model.end(), [v](const Entry& e) { return e.version == v; });
  };
  std::mt19937 random(2);
  for(int step = 0; step < 20000; ++step) {
    const auto choice = random() % 8;
    if(choice < 2 || last == 0)
      ++last;
    const Index v = 1 + static_cast<Index>(random() % static_cast<unsigned>(last));
    const auto entry = found(v);
    dropped.clear();
    std::vector<int> expected; // to be dropped
    BOOST_REQUIRE(cache.contains(v) == (entry != model.end()));
    if(choice < 5) {
      int* value = cache.find(v);
      BOOST_REQUIRE((value != nullptr) == (entry != model.end()));
      if(value != nullptr) {
        BOOST_TEST(*value == entry->value);
        model.splice(model.begin(), model, entry);
      } else {
        model.push_front({v, step, random() % 50});
        BOOST_TEST(cache.insert(v, int(step), model.front().bytes) == step);
        slots = (std::max)(slots, v);
      }
    } else if(choice < 7) {
      const auto of_last = found(last);
      if(of_last != model.end()) {
        expected.push_back(of_last->value);
        model.erase(of_last);
      }
      slots = (std::min)(slots, last - 1);
      cache.forget(last--, recycle);
    } else if(random() % 8 == 0) {
      const std::size_t most = random() % 2000;
      std::size_t bytes = 0;
      for(const Entry& e : model)
        bytes += entry_size + e.bytes;
      for(; bytes > most; model.pop_back()) {
        bytes -= entry_size + model.back().bytes;
        expected.push_back(model.back().value);
      }
      cache.shrink(most, recycle);
    }
    BOOST_REQUIRE((dropped == expected));
    std::size_t bytes = static_cast<std::size_t>(slots) * sizeof(Index);
    for(const Entry& e : model)
      bytes += entry_size + e.bytes;
    BOOST_REQUIRE(cache.memory() == bytes);
  }
}

namespace {

struct Queued
{
  double key;
  int number;

  static std::size_t is_before(const Queued& a, const Queued& b)
  {
    return a.key < b.key || (a.key == b.key && a.number < b.number) ? 1 : 0;
  }
  friend bool operator<(const Queued& a, const Queued& b) { return is_before(a, b) == 1; }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_heap_of_four_is_a_priority_queue)
{
  std::mt19937 random(3);
  for(const std::size_t usual_size : {3, 6, 40, 400}) { // small ones have few siblings
    FGI::Heap_of_four<Queued> heap;
    std::set<Queued> model;
    for(int step = 0; step < 4000; ++step) {
      if(random() % (2 * usual_size) > model.size()) {
        const Queued entry = {static_cast<double>(random() % 100), step};
        heap.push(entry);
        model.insert(entry);
      } else if(!model.empty()) {
        BOOST_REQUIRE(heap.top().number == model.begin()->number);
        heap.pop();
        model.erase(model.begin());
      }
      BOOST_REQUIRE(heap.empty() == model.empty());
    }
    heap.clear();
    BOOST_TEST(heap.empty());
    heap.push({1, 1});
    BOOST_TEST(heap.top().number == 1);
  }
}

BOOST_AUTO_TEST_CASE(bits_of_numbers_have_their_order)
{
  const std::vector<double> numbers = {0, 5e-324,      1e-300, 0.5,
                                       1, 1 + 0x1p-52, 1e300,  std::numeric_limits<double>::infinity()};
  for(std::size_t i = 0; i + 1 < numbers.size(); ++i)
    BOOST_TEST(FGI::ordered_bits(numbers[i]) < FGI::ordered_bits(numbers[i + 1]));
  BOOST_TEST(FGI::ordered_bits(-0.0) == FGI::ordered_bits(0.0));
}

BOOST_AUTO_TEST_CASE(arrays_in_scratch_memory_do_not_overlap)
{
  FGI::Scratch scratch;
  std::mt19937 random(4);
  for(int round = 0; round < 3; ++round) { // from the second on, in the same memory
    std::vector<std::pair<int*, std::size_t>> arrays;
    for(int i = 0; i < 200; ++i) {
      const std::size_t size = i == 50 ? 50000 : random() % 200; // one is larger than the next block would be
      arrays.emplace_back(scratch.allocate<int>(size), size);
      std::fill_n(arrays.back().first, size, i);
    }
    for(int i = 0; i < 200; ++i) {
      const auto [first, size] = arrays[static_cast<std::size_t>(i)];
      BOOST_TEST(std::count(first, first + size, i) == static_cast<std::ptrdiff_t>(size));
    }
    scratch.release();
  }
}

BOOST_AUTO_TEST_CASE(written_records_are_those_of_their_elements)
{
  using CGAL::Flip_geodesics::Vertex_index;
  FGI::Written_records<Vertex_index, int> records(100);
  std::map<int, int> model;
  std::mt19937 random(5);
  for(int step = 0; step < 300; ++step) {
    const int element = static_cast<int>(random() % 100);
    if(step % 3 == 0)
      records.write(Vertex_index(element)) = model[element] = step;
    BOOST_TEST(records[Vertex_index(element)] == (model.count(element) != 0 ? model[element] : 0));
  }
}

namespace {

struct Counting_visitor
{
  int calls = 0, last_call = 0;
  bool go_further() { return ++calls != last_call; }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_visitor_is_asked_every_1024_steps)
{
  Counting_visitor visitor;
  visitor.last_call = 3;
  FGI::Interruption interruption(visitor);
  for(int step = 1; step < 3 * 1024; ++step) {
    BOOST_REQUIRE(!interruption.count_step());
    BOOST_REQUIRE(visitor.calls == step / 1024);
  }
  BOOST_TEST(interruption.count_step());
  BOOST_TEST(interruption.count_step());
  BOOST_TEST(interruption.has_occurred());
  BOOST_TEST(interruption.begin_part());
  BOOST_TEST(visitor.calls == 3); // after an interruption it is not asked again
}

BOOST_AUTO_TEST_CASE(places_are_finite_if_all_coordinates_are)
{
  BOOST_TEST(FGI::are_finite({{1, -2, 1e308}}));
  for(const double wrong : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for(std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> place = {{1, 2, 3}};
      place[i] = wrong;
      BOOST_TEST(!FGI::are_finite(place));
    }
}

BOOST_AUTO_TEST_CASE(vertices_of_one_priority_leave_a_queue_in_their_order)
{
  using CGAL::Flip_geodesics::Vertex_index;
  FGI::Vertex_queue queue;
  std::set<std::pair<double, Index>> model;
  std::mt19937 random(6);
  for(int step = 0; step < 2000; ++step) {
    if(random() % 3 != 0) {
      const std::pair<double, Index> entry(static_cast<double>(random() % 4), static_cast<Index>(random() % 1000));
      if(model.insert(entry).second)
        queue.push(entry.first, Vertex_index(entry.second));
    } else if(!model.empty()) {
      BOOST_REQUIRE(queue.priority() == model.begin()->first);
      BOOST_REQUIRE(queue.pop().idx() == model.begin()->second);
      model.erase(model.begin());
    }
    BOOST_REQUIRE(queue.empty() == model.empty());
  }
}

BOOST_AUTO_TEST_CASE(labels_are_those_of_the_last_search)
{
  using CGAL::Flip_geodesics::Input_halfedge_index;
  using CGAL::Flip_geodesics::Vertex_index;
  FGI::Search_labels<Input_halfedge_index> labels(50);
  for(int search = 0; search < 3; ++search) {
    for(Index v = search; v < 50; v += 3) {
      BOOST_TEST(!labels.is_reached(labels[Vertex_index(v)]));
      BOOST_TEST(!labels.is_settled(labels[Vertex_index(v)]));
      labels.reach(Vertex_index(v), v + 0.5, Input_halfedge_index(2 * v));
      const auto& label = labels[Vertex_index(v)];
      BOOST_TEST(labels.is_reached(label));
      BOOST_TEST(!labels.is_settled(label));
      BOOST_TEST(label.distance == v + 0.5);
      BOOST_TEST(label.incoming().idx() == 2 * v);
      if(v % 2 == 0) {
        labels.settle(Vertex_index(v));
        BOOST_TEST(!labels.is_reached(label));
        BOOST_TEST(labels.is_settled(label));
      }
    }
    labels.clear();
  }
}

BOOST_AUTO_TEST_CASE(buckets_keep_the_order_of_items)
{
  const FGI::Buckets buckets(4, {2, 0, 2, -1, 3, 2, 0});
  const std::vector<std::vector<Index>> expected = {{1, 6}, {}, {0, 2, 5}, {4}};
  BOOST_TEST_REQUIRE(buckets.size() == 4);
  for(Index i = 0; i < 4; ++i) {
    const auto range = buckets[i];
    BOOST_TEST(std::vector<Index>(range.begin(), range.end()) == expected[static_cast<std::size_t>(i)],
               boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(more_elements_than_indices_are_refused)
{
  const std::int64_t most = std::numeric_limits<Index>::max();
  BOOST_TEST(FGI::checked_index_bound(most - 1) == most - 1);
  for(std::int64_t count : {most, most + 1, 2 * most + 2, std::numeric_limits<std::int64_t>::max()})
    BOOST_CHECK_THROW(FGI::checked_index_bound(count), CGAL::Flip_geodesics::Invalid_mesh_error);
}
