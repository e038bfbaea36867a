// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_LAZY_ARRAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_LAZY_ARRAY_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * An array whose elements start as zero bytes and cost nothing until they are written: the operating system hands out
 * zero pages on the first write. So a workspace as large as the mesh is made in constant time. It has room for some more
 * elements, and moves to twice the room when that is used up.
 *
 * Elements that are not trivially copyable (number types that own memory) fall back to a vector.
 */
template <class T, bool IsTrivial = std::is_trivially_copyable<T>::value>
class Lazy_array
{
  static constexpr std::size_t cache_line = 64;

  struct Free
  {
    void operator()(void* memory) const { std::free(memory); }
  };

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
    m_memory.reset(std::calloc(capacity * sizeof(T) + cache_line, 1));
    if(m_memory == nullptr)
      throw std::bad_alloc();
    void* aligned = m_memory.get();
    std::size_t space = capacity * sizeof(T) + cache_line;
    m_data = static_cast<T*>(std::align(cache_line, capacity * sizeof(T), aligned, space));
    m_capacity = capacity;
  }

  void swap(Lazy_array& other) noexcept
  {
    std::swap(m_memory, other.m_memory);
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
    std::swap(m_capacity, other.m_capacity);
  }

  std::unique_ptr<void, Free> m_memory;
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
  void resize(std::size_t size) { m_data.resize(size); }

private:
  std::vector<T> m_data;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_LAZY_ARRAY_H
