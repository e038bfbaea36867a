// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_BLOCK_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_BLOCK_ARRAY_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A stack of records in blocks of one size. It takes the memory of what it holds and at most a block more, where a
 * vector takes up to twice that, and thrice while it grows; and nothing is moved. What is taken back from the end
 * leaves some blocks for reuse.
 */
template <class T>
class Block_array
{
  static constexpr std::size_t block_size = 512;
  static constexpr std::size_t most_spare_bytes = 1 << 22;

public:
  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }

  T& operator[](std::size_t i) { return m_blocks[i / block_size][i % block_size]; }
  const T& operator[](std::size_t i) const { return m_blocks[i / block_size][i % block_size]; }
  T& back() { return (*this)[m_size - 1]; }
  const T& back() const { return (*this)[m_size - 1]; }

  /* If it throws, nothing has changed. */
  void push_back(T record)
  {
    if(m_size == m_blocks.size() * block_size)
      add_block();
    m_blocks[m_size / block_size].push_back(std::move(record));
    ++m_size;
  }

  void pop_back()
  {
    --m_size;
    m_blocks[m_size / block_size].pop_back();
    if(m_size % block_size == 0 && (m_blocks.size() - m_size / block_size) * block_size * sizeof(T) > most_spare_bytes)
      m_blocks.pop_back();
  }

  /* Adds records, all the same, or takes some back. */
  void resize(std::size_t size, const T& record)
  {
    while(m_size > size)
      pop_back();
    while(m_size < size)
      push_back(record);
  }

  /* The bytes that it takes, up to a block. */
  std::size_t memory() const { return m_size * sizeof(T); }

private:
  void add_block()
  {
    std::vector<T> block;
    block.reserve(block_size);
    m_blocks.push_back(std::move(block));
  }

  std::vector<std::vector<T>> m_blocks; // each has room for `block_size` records
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_BLOCK_ARRAY_H
