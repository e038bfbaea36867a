// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LAZY_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LAZY_ARRAY_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#define CGAL_FLIP_GEODESICS_HAS_MMAP
#include <sys/mman.h>
#endif

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Zeroed memory that costs nothing until it is written, aligned to cache lines. Asked from the operating system itself
 * where that is known how: `calloc` takes and clears memory of the heap again once a block of the size has been freed.
 * Not so little memory that to clear it takes less time than to be given some pages of it: a page takes as long as to
 * clear ten.
 */
class Zero_pages
{
  static constexpr std::size_t cache_line = 64;
  static constexpr std::size_t least_mapped_size = 1 << 20;

public:
  explicit Zero_pages(std::size_t size = 0)
    : m_size(size)
  {
    if(size == 0)
      return;
    if(is_mapped())
      map();
    else
      allocate();
  }

  Zero_pages(Zero_pages&& other) noexcept { swap(other); }
  Zero_pages& operator=(Zero_pages&& other) noexcept
  {
    swap(other);
    return *this;
  }

  ~Zero_pages()
  {
#ifdef CGAL_FLIP_GEODESICS_HAS_MMAP
    if(m_memory != nullptr && is_mapped()) {
      munmap(m_memory, m_size);
      return;
    }
#endif
    std::free(m_memory);
  }

  void* data() const { return m_data; }

  /* Asks for all its pages at once, where it is known how: that takes a fraction of the time of asking for one after the
   * other, above all while several threads run. */
  void populate() const
  {
#if defined(CGAL_FLIP_GEODESICS_HAS_MMAP) && defined(MADV_POPULATE_WRITE)
    if(m_memory != nullptr && is_mapped())
      madvise(m_memory, m_size, MADV_POPULATE_WRITE); // if it fails, they come one after the other
#endif
  }

private:
  bool is_mapped() const
  {
#ifdef CGAL_FLIP_GEODESICS_HAS_MMAP
    return m_size >= least_mapped_size;
#else
    return false;
#endif
  }

  void map()
  {
#ifdef CGAL_FLIP_GEODESICS_HAS_MMAP
    void* memory = mmap(nullptr, m_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if(memory == MAP_FAILED)
      throw std::bad_alloc();
    m_memory = m_data = memory;
#endif
  }

  void allocate()
  {
    m_memory = m_data = std::calloc(m_size + cache_line, 1);
    if(m_memory == nullptr)
      throw std::bad_alloc();
    std::size_t space = m_size + cache_line;
    std::align(cache_line, m_size, m_data, space);
  }

  void swap(Zero_pages& other) noexcept
  {
    std::swap(m_memory, other.m_memory);
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
  }

  void* m_memory = nullptr;
  void* m_data = nullptr; // the first cache line in it
  std::size_t m_size = 0;
};

/*
 * An array whose elements start as zero bytes and cost nothing until they are written. So a workspace as large as the
 * mesh is made in constant time. It has room for some more elements, and moves to twice the room when that is used up.
 *
 * Elements that are not trivially copyable (number types that own memory) fall back to a vector.
 */
template <class T, bool IsTrivial = std::is_trivially_copyable<T>::value>
class Lazy_array
{
public:
  explicit Lazy_array(std::size_t size = 0)
    : m_size(size)
  {
    if(size > 0)
      allocate(size + size / 8 + 8);
  }

  Lazy_array(Lazy_array&& other) noexcept { swap(other); }
  Lazy_array& operator=(Lazy_array&& other) noexcept
  {
    swap(other);
    return *this;
  }

  T& operator[](std::size_t i) { return m_data[i]; }
  const T& operator[](std::size_t i) const { return m_data[i]; }
  std::size_t size() const { return m_size; }

  /// Prepares for most elements to be written.
  void populate() const { m_pages.populate(); }

  /// Changes the size; new elements are zero bytes. \pre elements that are cut off are zero bytes
  void resize(std::size_t size)
  {
    if(size > m_capacity) {
      Lazy_array larger;
      larger.allocate(2 * size);
      std::copy_n(m_data, m_size, larger.m_data);
      swap(larger);
    }
    m_size = size;
  }

private:
  void allocate(std::size_t capacity)
  {
    m_pages = Zero_pages(capacity * sizeof(T));
    m_data = static_cast<T*>(m_pages.data());
    m_capacity = capacity;
  }

  void swap(Lazy_array& other) noexcept
  {
    std::swap(m_pages, other.m_pages);
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
    std::swap(m_capacity, other.m_capacity);
  }

  Zero_pages m_pages;
  T* m_data = nullptr;
  std::size_t m_size = 0, m_capacity = 0;
};

template <class T>
class Lazy_array<T, false>
{
public:
  explicit Lazy_array(std::size_t size = 0)
    : m_data(size)
  {
  }

  T& operator[](std::size_t i) { return m_data[i]; }
  const T& operator[](std::size_t i) const { return m_data[i]; }
  std::size_t size() const { return m_data.size(); }
  void populate() const {}
  void resize(std::size_t size) { m_data.resize(size); }

private:
  std::vector<T> m_data;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LAZY_ARRAY_H
