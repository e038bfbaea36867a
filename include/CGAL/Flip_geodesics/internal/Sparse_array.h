// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SPARSE_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SPARSE_ARRAY_H

#include <CGAL/Flip_geodesics/internal/Lazy_array.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * An array whose elements start as zero bytes, and of which only those take memory that are written, with their
 * neighbors in a cache line: a table of blocks, and the blocks in the order in which they were first written. A
 * `Lazy_array` takes whole pages of memory, and where a mesh is numbered without order, nearly all of them.
 */
template <class T>
class Sparse_array
{
  static constexpr std::size_t block_size = 4;

public:
  explicit Sparse_array(std::size_t size)
    : m_blocks(size / block_size + 1)
    , m_elements((m_blocks.size() + 1) * block_size)
  {
  }

  const T& operator[](std::size_t i) const
  {
    return m_elements[static_cast<std::size_t>(m_blocks[i / block_size]) * block_size + i % block_size];
  }

  T& writable(std::size_t i)
  {
    std::uint32_t& block = m_blocks[i / block_size];
    if(block == 0)
      block = ++m_number_of_blocks;
    return m_elements[static_cast<std::size_t>(block) * block_size + i % block_size];
  }

private:
  Lazy_array<std::uint32_t> m_blocks; // 0 if not written: the elements of that one stay zero
  Lazy_array<T> m_elements;
  std::uint32_t m_number_of_blocks = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SPARSE_ARRAY_H
