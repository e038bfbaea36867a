// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FOR_EACH_INDEX_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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
  static_assert(!is_parallel, "CGAL::Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  for(std::size_t i = 0; i < n; ++i)
    function(i);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FOR_EACH_INDEX_H
