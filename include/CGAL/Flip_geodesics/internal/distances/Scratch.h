// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SCRATCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SCRATCH_H

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A memory arena for small arrays, which are all released at once and stay in their places until then. As
 * `std::pmr::monotonic_buffer_resource`, which libc++ has only since its version 16.
 */
template <class T>
class Scratch
{
  static_assert(std::is_trivially_copyable<T>::value, "elements are not destroyed");

public:
  /* Returns memory for some elements, which have no defined values. */
  T* allocate(std::size_t size)
  {
    while(m_at == m_blocks.size() || m_blocks[m_at].size - m_used < size)
      enter_next_block(size);
    T* const result = m_blocks[m_at].first.get() + m_used;
    m_used += size;
    return result;
  }

  void release() { m_at = m_used = 0; }

private:
  static constexpr std::size_t least = 256;

  struct Block
  {
    std::unique_ptr<T[]> first;
    std::size_t size;
  };

  void enter_next_block(std::size_t size)
  {
    if(m_at == m_blocks.size()) {
      const std::size_t larger = m_blocks.empty() ? least : 2 * m_blocks.back().size;
      const std::size_t room = (std::max)(size, larger);
      m_blocks.push_back({std::unique_ptr<T[]>(new T[room]), room});
    } else {
      ++m_at;
    }
    m_used = 0;
  }

  std::vector<Block> m_blocks;
  std::size_t m_at = 0, m_used = 0; // the block that is being used, and how much of it
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SCRATCH_H
