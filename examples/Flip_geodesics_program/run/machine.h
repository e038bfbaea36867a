// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_MACHINE_H
#define CGAL_FLIP_GEODESICS_PROGRAM_MACHINE_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

// The memory and the threads of the machine.
namespace program {

/// The memory of the machine, in bytes; that of a large one if it cannot be queried.
inline double memory_of_machine()
{
#ifdef _SC_PHYS_PAGES
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if(pages > 0 && size > 0)
    return static_cast<double>(pages) * static_cast<double>(size);
#endif
  return 0x1p36;
}

/// Can several threads be used at all?
#ifdef CGAL_LINKED_WITH_TBB
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

/// So many threads as are wanted, but no more than the machine runs at the same time: others would only wait.
inline int usable_threads(int wanted)
{
#ifdef CGAL_LINKED_WITH_TBB
  return (std::min)(wanted, tbb::this_task_arena::max_concurrency());
#else
  return wanted;
#endif
}

/*!
 * Calls `sink(requests[i], results)` in the order of the requests, with what `run(requests[i])` of a runner returns.
 * Each thread has a runner of its own, made by `make_runner()`; portions of the requests are computed ahead.
 *
 * \pre `has_threads`
 */
template <class Request, class MakeRunner, class Sink>
void run_in_parallel(const std::vector<Request>& requests, int threads, const MakeRunner& make_runner, const Sink& sink)
{
#ifdef CGAL_LINKED_WITH_TBB
  using Runner = decltype(make_runner());
  using Results = decltype(std::declval<Runner>()->run(std::declval<Request>()));
  const std::size_t portion = 256 * static_cast<std::size_t>(threads);
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<Runner> runners(make_runner);
  for(std::size_t begin = 0; begin < requests.size(); begin += portion) {
    std::vector<Results> results((std::min)(portion, requests.size() - begin));
    arena.execute([&] {
      tbb::parallel_for(std::size_t(0), results.size(),
                        [&](std::size_t i) { results[i] = runners.local()->run(requests[begin + i]); });
    });
    for(std::size_t i = 0; i < results.size(); ++i)
      sink(requests[begin + i], results[i]);
  }
#else
  static_cast<void>(threads);
  const auto runner = make_runner();
  for(const Request& request : requests)
    sink(request, runner->run(request));
#endif
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_MACHINE_H
