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

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * An array whose elements are initially zero bytes. If the operating system provides cleared pages, they cost nothing
 * until they are written, so that a workspace as large as the mesh is created in constant time. It has capacity for
 * some additional elements, and doubles it when it is exhausted.
 *
 * Elements that are not trivially copyable, such as number types that own memory, are stored in a vector.
 */
template <class T, bool IsTrivial = std::is_trivially_copyable<T>::value>
class Lazy_array
{
  static_assert(alignof(T) <= alignof(std::max_align_t), "std::calloc() aligns no further");

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

  T& operator[](std::size_t i) { return m_data.get()[i]; }
  const T& operator[](std::size_t i) const { return m_data.get()[i]; }
  std::size_t size() const { return m_size; }

  /// Changes the size; new elements are zero bytes. \pre removed elements are zero bytes
  void resize(std::size_t size)
  {
    if(size > m_capacity) {
      Lazy_array larger;
      larger.allocate(2 * size);
      std::copy_n(m_data.get(), m_size, larger.m_data.get());
      swap(larger);
    }
    m_size = size;
  }

private:
  struct Free
  {
    void operator()(void* memory) const { std::free(memory); }
  };

  void allocate(std::size_t capacity)
  {
    m_data.reset(static_cast<T*>(std::calloc(capacity, sizeof(T))));
    if(!m_data)
      throw std::bad_alloc();
    m_capacity = capacity;
  }

  void swap(Lazy_array& other) noexcept
  {
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
    std::swap(m_capacity, other.m_capacity);
  }

  std::unique_ptr<T, Free> m_data;
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LAZY_ARRAY_H
