// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FOR_EACH_INDEX_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL::Flip_geodesics::internal {

/* Calls function(i) for i from 0 to n - 1, in any order and at the same time with CGAL::Parallel_tag. */
template <class ConcurrencyTag, class Function>
void for_each_index(std::size_t n, const Function& function)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n), [&](const tbb::blocked_range<std::size_t>& range) {
      for(std::size_t i = range.begin(); i != range.end(); ++i)
        function(i);
    });
    return;
  }
#else
  static_assert(!is_parallel, "CGAL::Parallel_tag requires TBB: link CGAL::TBB_support");
#endif
  for(std::size_t i = 0; i < n; ++i)
    function(i);
}

/* Returns a bound on `thread_index()` in the calls of `for_each_index()`. */
template <class ConcurrencyTag>
std::size_t number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value)
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
#endif
  return 1;
}

/* Returns a number of the thread that makes a call of `for_each_index()`, unique among the threads that make calls at
 * the same time. */
template <class ConcurrencyTag>
std::size_t thread_index()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value)
    return static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
#endif
  return 0;
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FOR_EACH_INDEX_H
