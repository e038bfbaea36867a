// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H

#include <boost/config.hpp>

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A stack of records in blocks of one size. It takes the memory of its contents plus at most one block, whereas a
 * vector takes up to twice that, and three times while it grows; records do not move. Removing records leaves some
 * blocks for reuse.
 *
 * Invariant: `m_end` lies behind the last record, in the block that begins at `m_begin`, so that the record before it
 * is always the last one. All three pointers are null while the stack is empty.
 */
template <class T>
class Block_array
{
  static constexpr std::size_t block_size = 512;
  static constexpr std::size_t most_spare_bytes = 1 << 22;

public:
  Block_array() = default;
  Block_array(Block_array&& other) noexcept { swap(other); }
  Block_array& operator=(Block_array&& other) noexcept
  {
    swap(other);
    return *this;
  }
  ~Block_array()
  {
    while(!empty())
      pop_back();
  }

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }

  T& operator[](std::size_t i) { return *(block(i / block_size) + i % block_size); }
  const T& operator[](std::size_t i) const { return *(block(i / block_size) + i % block_size); }
  T& back() { return *(m_end - 1); }
  const T& back() const { return *(m_end - 1); }

  /* Changes nothing if it throws. */
  void push_back(T&& record)
  {
    if(BOOST_UNLIKELY(m_end == m_end_of_block)) {
      push_to_next_block(std::move(record));
      return;
    }
    ::new(static_cast<void*>(m_end)) T(std::move(record));
    ++m_end;
    ++m_size;
  }

  void pop_back()
  {
    (--m_end)->~T();
    --m_size;
    if(BOOST_UNLIKELY(m_end == m_begin))
      leave_block();
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
  struct alignas(T) Place
  {
    unsigned char bytes[sizeof(T)];
  };

  T* block(std::size_t i) const { return reinterpret_cast<T*>(m_blocks[i].get()); }

  // \pre the last block is full, or there is none
  BOOST_NOINLINE void push_to_next_block(T&& record)
  {
    const std::size_t next = m_size / block_size;
    if(next == m_blocks.size())
      m_blocks.push_back(std::unique_ptr<Place[]>(new Place[block_size]));
    ::new(static_cast<void*>(block(next))) T(std::move(record));
    enter(next, 1);
    ++m_size;
  }

  // \pre the block is empty
  BOOST_NOINLINE void leave_block()
  {
    const std::size_t left = m_size / block_size;
    if((m_blocks.size() - left) * block_size * sizeof(T) > most_spare_bytes)
      m_blocks.pop_back();
    if(left == 0)
      m_begin = m_end = m_end_of_block = nullptr;
    else
      enter(left - 1, block_size);
  }

  void enter(std::size_t i, std::size_t number_of_records)
  {
    m_begin = block(i);
    m_end = m_begin + number_of_records;
    m_end_of_block = m_begin + block_size;
  }

  void swap(Block_array& other) noexcept
  {
    std::swap(m_blocks, other.m_blocks);
    std::swap(m_size, other.m_size);
    std::swap(m_begin, other.m_begin);
    std::swap(m_end, other.m_end);
    std::swap(m_end_of_block, other.m_end_of_block);
  }

  std::vector<std::unique_ptr<Place[]>> m_blocks; // each with space for `block_size` records
  std::size_t m_size = 0;
  T *m_begin = nullptr, *m_end = nullptr, *m_end_of_block = nullptr;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_BLOCK_ARRAY_H
