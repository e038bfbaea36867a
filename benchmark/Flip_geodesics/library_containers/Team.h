// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_TEAM_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_TEAM_H

#include <CGAL/tags.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A loop of TBB for each step. */
template <class ConcurrencyTag, bool IsParallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value>
class Team
{
public:
  static std::size_t most_members()
  {
    return IsParallel ? static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) : 1;
  }

  template <class Function>
  void for_each(const std::vector<std::uint32_t>& numbers, const Function& function)
  {
    if(!IsParallel) {
      for(std::size_t i = 0; i < numbers.size(); ++i)
        function(std::size_t(0), i);
      return;
    }
    tbb::parallel_for(std::size_t(0), numbers.size(), [&](std::size_t i) {
      function(static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()), i);
    });
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_TEAM_H
