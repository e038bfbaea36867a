// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Containers of the library against those of the standard one: stacks in blocks, and values with versions.

#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/checked_index_bound.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Version_cache.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace FGI = CGAL::Flip_geodesics::internal;
using CGAL::Flip_geodesics::Index;

// A number that is counted as long as it lives.
class Counted
{
public:
  explicit Counted(int value = 0)
    : m_value(value)
  {
    ++s_alive;
  }
  Counted(const Counted& other)
    : m_value(other.m_value)
  {
    ++s_alive;
  }
  Counted& operator=(const Counted&) = default;
  ~Counted() { --s_alive; }

  int value() const { return m_value; }
  static int alive() { return s_alive; }

private:
  int m_value;
  static inline int s_alive = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_stack_in_blocks_is_a_stack)
{
  std::mt19937 random(1);
  {
    FGI::Block_array<Counted> stack;
    std::vector<int> model;
    for(int round = 0; round < 400; ++round) {
      const std::size_t size = random() % 5 == 0 ? 512 * (random() % 4) : random() % 2000;
      switch(random() % 3) {
      case 0: // one by one
        while(model.size() < size) {
          model.push_back(static_cast<int>(random() % 1000));
          stack.push_back(Counted(model.back()));
        }
        while(model.size() > size) {
          model.pop_back();
          stack.pop_back();
        }
        break;
      case 1:
        stack.resize(size, Counted(round));
        model.resize(size, round);
        break;
      case 2: {
        FGI::Block_array<Counted> other(std::move(stack));
        stack = std::move(other);
      }
      }
      BOOST_REQUIRE(stack.size() == model.size());
      BOOST_TEST(stack.empty() == model.empty());
      BOOST_TEST(Counted::alive() == static_cast<int>(model.size()));
      BOOST_TEST(stack.memory() == model.size() * sizeof(Counted));
      if(model.empty())
        continue;
      BOOST_TEST(stack.back().value() == model.back());
      bool is_same = true;
      for(std::size_t i = 0; i < model.size(); ++i)
        is_same = is_same && stack[i].value() == model[i];
      BOOST_TEST(is_same);
    }
  }
  BOOST_TEST(Counted::alive() == 0);
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

BOOST_AUTO_TEST_CASE(more_elements_than_indices_are_refused)
{
  const std::int64_t most = std::numeric_limits<Index>::max();
  BOOST_TEST(FGI::checked_index_bound(most - 1) == most - 1);
  for(std::int64_t count : {most, most + 1, 2 * most + 2, std::numeric_limits<std::int64_t>::max()})
    BOOST_CHECK_THROW(FGI::checked_index_bound(count), CGAL::Flip_geodesics::Invalid_mesh_error);
}
