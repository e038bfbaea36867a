// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/*
 * A stack of records in blocks of one size. It takes the memory of its contents plus at most some spare blocks, whereas
 * a vector takes up to twice that, and three times while it grows; records do not move. Unlike `std::deque`, it can be
 * moved without exceptions, and allocates seldom. Removed records are not destroyed before their block.
 */
template <class T>
class Block_array
{
  static constexpr std::size_t block_size = 64;
  static constexpr std::size_t most_spare_bytes = 1 << 22;

public:
  Block_array() = default;
  Block_array(Block_array&& other) noexcept
    : m_blocks(std::move(other.m_blocks))
    , m_size(std::exchange(other.m_size, 0))
  {
  }
  Block_array& operator=(Block_array&& other) noexcept
  {
    m_blocks = std::move(other.m_blocks);
    m_size = std::exchange(other.m_size, 0);
    return *this;
  }

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }

  T& operator[](std::size_t i) { return m_blocks[i / block_size][i % block_size]; }
  const T& operator[](std::size_t i) const { return m_blocks[i / block_size][i % block_size]; }
  T& back() { return (*this)[m_size - 1]; }
  const T& back() const { return (*this)[m_size - 1]; }

  /* Changes nothing if it throws. */
  void push_back(T&& record)
  {
    if(m_size == m_blocks.size() * block_size)
      m_blocks.push_back(std::unique_ptr<T[]>(new T[block_size])); // written before it is read
    (*this)[m_size] = std::move(record);
    ++m_size;
  }

  void pop_back()
  {
    --m_size;
    if(m_size % block_size == 0 && m_blocks.size() * block_size * sizeof(T) > m_size * sizeof(T) + most_spare_bytes)
      m_blocks.pop_back();
  }

  /* Adds copies of a record, or removes records. */
  void resize(std::size_t size, const T& record)
  {
    while(m_size > size)
      pop_back();
    while(m_size < size)
      push_back(T(record));
  }

  /* Returns the memory in bytes, up to a block. */
  std::size_t memory() const { return m_size * sizeof(T); }

private:
  std::vector<std::unique_ptr<T[]>> m_blocks; // of `block_size` records each
  std::size_t m_size = 0;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H
