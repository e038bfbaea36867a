// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_TEAM_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_TEAM_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * One thread that takes many steps, one after the other, or several threads that share each of them with
 * `Parallel_tag`. `for_each(numbers, function)` is such a step.
 */
template <class ConcurrencyTag, bool IsParallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value>
class Team
{
  static_assert(!IsParallel, "CGAL::Parallel_tag needs TBB: link CGAL::TBB_support");

public:
  static std::size_t most_members() { return 1; }

  /* Calls function(0, i) for i from 0 to the number of elements of `numbers` - 1. */
  template <class Function>
  void for_each(const std::vector<std::uint32_t>& numbers, const Function& function)
  {
    for(std::size_t i = 0; i < numbers.size(); ++i)
      function(std::size_t(0), i);
  }
};

#ifdef CGAL_LINKED_WITH_TBB

/*
 * Member 0 is the calling thread. The others, its helpers, are TBB tasks that persist between steps and poll for the
 * next one, so that a step begins and ends in a fraction of a microsecond, whereas forking and joining tasks takes
 * several. The caller never waits for a helper that has not entered the step. It can therefore be only slightly slower
 * than alone and waits for no thread that waits for it, however many teams share however few threads.
 *
 * Each member begins with a part of its own, an interval of the indices that it takes from the front; then it helps
 * others, taking indices from the back. If the caller orders the indices accordingly, its part is much the same each
 * time, and the data is in its cache.
 */
template <class ConcurrencyTag>
class Team<ConcurrencyTag, true>
{
public:
  Team()
    : m_parts(new Part[most_members()])
  {
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team()
  {
    m_state.store(ended, std::memory_order_release);
    m_helpers.wait();
  }

  static std::size_t most_members()
  {
    constexpr std::size_t most = 64; // with work in a short step
    return (std::min)(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()), most);
  }

  /* Calls function(member, i) for i from 0 to the number of elements of `numbers` - 1, with all members simultaneously.
   * If calls throw, rethrows the exception of the call with the least number; it is unspecified which calls with
   * greater numbers have been made. */
  template <class Function>
  void for_each(const std::vector<std::uint32_t>& numbers, const Function& function)
  {
    constexpr std::size_t least_part = 4;
    const std::size_t members = (std::min)(most_members(), numbers.size() / least_part);
    prepare(numbers, (std::max)(members, std::size_t(1)));
    m_function = &function;
    m_call = [](const void* f, std::size_t member, std::size_t i) { (*static_cast<const Function*>(f))(member, i); };
    if(members > 1)
      let_enter();
    work(0);
    if(members > 1)
      wait_for_helpers();
    if(m_error)
      std::rethrow_exception(std::exchange(m_error, nullptr));
  }

private:
  static constexpr std::uint64_t none = std::uint64_t(-1);
  using Call = void (*)(const void*, std::size_t, std::size_t);

  // The remaining part: the first index and, above 32 bits, the end.
  struct alignas(64) Part
  {
    std::atomic<std::uint64_t> left{0};
  };
  static constexpr std::uint64_t one_last = std::uint64_t(1) << 32;

  // The state: the number of helpers in the step, its number of members, whether one can enter, and the number of the
  // step.
  static constexpr std::uint64_t inside = 0xff, one_member = 0x100, all_members = 0xff00, is_open = 0x10000,
                                 ended = 0x20000, one_step = 0x40000;

  void prepare(const std::vector<std::uint32_t>& numbers, std::size_t members)
  {
    m_numbers = numbers.data();
    m_members = members;
    m_failed.store(none, std::memory_order_relaxed);
    for(std::size_t k = 0; k < members; ++k)
      m_parts[k].left.store((k + 1) * numbers.size() / members * one_last + k * numbers.size() / members,
                            std::memory_order_relaxed);
  }

  void let_enter()
  {
    for(; m_number_of_helpers + 1 < m_members; ++m_number_of_helpers)
      m_helpers.run([this] { help(); });
    m_step += one_step;
    m_state.store(m_step | is_open | (m_members * one_member), std::memory_order_release);
  }

  void wait_for_helpers()
  {
    m_state.fetch_and(~is_open, std::memory_order_acq_rel);
    for(unsigned i = 0; (m_state.load(std::memory_order_acquire) & inside) != 0; ++i)
      wait(i);
  }

  void help()
  {
    const std::size_t member = m_next_member.fetch_add(1, std::memory_order_relaxed);
    std::uint64_t last = 0;
    for(unsigned i = 0;; ++i) {
      std::uint64_t state = m_state.load(std::memory_order_acquire);
      if((state & ended) != 0)
        return;
      if((state & is_open) != 0 && state / one_step != last && member < (state & all_members) / one_member &&
         m_state.compare_exchange_strong(state, state + 1, std::memory_order_acquire))
      {
        last = state / one_step;
        work(member);
        m_state.fetch_sub(1, std::memory_order_release);
        i = 0;
      } else {
        wait(i);
      }
    }
  }

  void work(std::size_t member)
  {
    take_parts(member, m_parts[member], [](std::uint64_t first, std::uint64_t end) {
      const std::uint64_t some = (end - first + 3) / 4;
      return Range{first, first + some, first + some, end};
    });
    for(std::size_t k = 1; k < m_members; ++k)
      take_parts(member, m_parts[(member + k) % m_members], [](std::uint64_t first, std::uint64_t end) {
        const std::uint64_t half = (end - first + 1) / 2;
        return Range{end - half, end, first, end - half};
      });
  }

  // The taken part, and the remaining one.
  struct Range
  {
    std::uint64_t first, end, left_first, left_end;
  };

  template <class Divide>
  void take_parts(std::size_t member, Part& part, const Divide& divide)
  {
    for(std::uint64_t left = part.left.load(std::memory_order_relaxed);;) {
      const std::uint64_t first = left % one_last, end = left / one_last;
      if(first >= end)
        return;
      const Range range = divide(first, end);
      if(!part.left.compare_exchange_weak(left, range.left_end * one_last + range.left_first,
                                          std::memory_order_relaxed))
        continue;
      for(std::uint64_t k = range.first; k < range.end; ++k)
        call(member, k);
      left = part.left.load(std::memory_order_relaxed);
    }
  }

  void call(std::size_t member, std::size_t i)
  {
    if(m_numbers[i] > m_failed.load(std::memory_order_relaxed))
      return;
    try {
      m_call(m_function, member, i);
    } catch(...) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if(m_numbers[i] < m_failed.load(std::memory_order_relaxed)) {
        m_failed.store(m_numbers[i], std::memory_order_relaxed);
        m_error = std::current_exception();
      }
    }
  }

  // For the i-th time in a row: finally yields the core to other threads.
  static void wait(unsigned i)
  {
    constexpr unsigned pauses = 1000; // some ten microseconds
    if(i >= pauses)
      std::this_thread::yield();
#if defined(__i386__) || defined(__x86_64__)
    else
      __builtin_ia32_pause();
#endif
  }

  std::unique_ptr<Part[]> m_parts;
  alignas(64) std::atomic<std::uint64_t> m_state{0};
  // Of the step:
  alignas(64) const std::uint32_t* m_numbers = nullptr;
  const void* m_function = nullptr;
  Call m_call = nullptr;
  std::size_t m_members = 0;
  std::uint64_t m_step = 0;
  std::atomic<std::uint64_t> m_failed{0}; // the least number that has thrown, if any
  std::exception_ptr m_error;
  std::mutex m_mutex; // guards both
  std::size_t m_number_of_helpers = 0;
  std::atomic<std::size_t> m_next_member{1};
  tbb::task_group m_helpers;
};

#endif // CGAL_LINKED_WITH_TBB

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_TEAM_H
