// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTAINERS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTAINERS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <thread>
#include <type_traits>
#include <vector>

// Arrays that take little time and memory for large meshes, and variables shared by several threads.

namespace CGAL::Flip_geodesics::internal {

/* Converts a number of elements to a bound on indices; throws `Invalid_mesh_error` if it is too large. */
template <class Count>
Index checked_index_bound(Count count)
{
  if(static_cast<std::uint64_t>(count) >= static_cast<std::uint64_t>((std::numeric_limits<Index>::max)()))
    throw Invalid_mesh_error("the mesh has more elements than 32-bit indices can number");
  return static_cast<Index>(count);
}

/*
 * Allocates zero bytes and leaves them as the initial elements. If the operating system provides cleared pages, they
 * cost nothing until they are written, so a workspace as large as the mesh is created in constant time.
 */
template <class T>
struct Zero_allocator
{
  static_assert(alignof(T) <= alignof(std::max_align_t),
                "the alignment of the elements must not exceed that of std::calloc()");

  using value_type = T;

  Zero_allocator() = default;
  template <class U>
  Zero_allocator(const Zero_allocator<U>&)
  {
  }

  T* allocate(std::size_t size)
  {
    void* const memory = std::calloc(size, sizeof(T));
    if(memory == nullptr)
      throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  void construct(T*) { static_assert(std::is_trivially_destructible_v<T>, "zero bytes must be a valid element"); }

  friend bool operator==(const Zero_allocator&, const Zero_allocator&) { return true; }
  friend bool operator!=(const Zero_allocator&, const Zero_allocator&) { return false; }
};

/* An array whose elements are initially zero bytes. Elements that are removed must be zero bytes as well. It is not
 * copied, which would write all elements. */
template <class T>
class Lazy_array : public std::vector<T, Zero_allocator<T>>
{
public:
  using std::vector<T, Zero_allocator<T>>::vector;

  Lazy_array() = default;
  Lazy_array(Lazy_array&&) = default;
  Lazy_array& operator=(Lazy_array&&) = default;
};

/*
 * Accesses a variable that another thread may access simultaneously. Its type must be one that the processor reads and
 * writes atomically; it is otherwise an ordinary variable, copied and moved with the record to which it belongs.
 */
template <class T>
T load_acquire(const T& variable)
{
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(void*));
#if defined(__GNUC__)
  T value;
  __atomic_load(&variable, &value, __ATOMIC_ACQUIRE);
  return value;
#else
  const T value = *const_cast<const volatile T*>(&variable);
  std::atomic_thread_fence(std::memory_order_acquire);
  return value;
#endif
}

template <class T>
T load_relaxed(const T& variable)
{
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(void*));
#if defined(__GNUC__)
  T value;
  __atomic_load(&variable, &value, __ATOMIC_RELAXED);
  return value;
#else
  return *const_cast<const volatile T*>(&variable);
#endif
}

/* Data written before is visible to a thread that reads the value by load_acquire(). */
template <class T>
void store_release(T& variable, T value)
{
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(void*));
#if defined(__GNUC__)
  __atomic_store(&variable, &value, __ATOMIC_RELEASE);
#else
  std::atomic_thread_fence(std::memory_order_release);
  *const_cast<volatile T*>(&variable) = value;
#endif
}

template <class T>
void store_relaxed(T& variable, T value)
{
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(void*));
#if defined(__GNUC__)
  __atomic_store(&variable, &value, __ATOMIC_RELAXED);
#else
  *const_cast<volatile T*>(&variable) = value;
#endif
}

/*
 * A mutex for operations that take about a microsecond and rarely meet another thread: locking and unlocking take a few
 * nanoseconds. An object that contains one can be moved while no thread uses it.
 */
class Short_lock
{
public:
  Short_lock() = default;
  Short_lock(Short_lock&&) noexcept {}
  Short_lock& operator=(Short_lock&&) noexcept { return *this; }

  bool try_lock() { return !m_is_locked.exchange(true, std::memory_order_acquire); }
  void unlock() { m_is_locked.store(false, std::memory_order_release); }

  void lock()
  {
    while(!try_lock())
      std::this_thread::yield();
  }

private:
  std::atomic<bool> m_is_locked{false};
};

/* A result that is found on first use. Several threads may query at once and may then find the same result. */
class Cached_decision
{
public:
  Cached_decision() = default;
  Cached_decision(const Cached_decision& other)
    : m_state(load_relaxed(other.m_state))
  {
  }
  Cached_decision& operator=(const Cached_decision& other)
  {
    store_relaxed(m_state, load_relaxed(other.m_state));
    return *this;
  }

  /* Returns the result of `find()`, which each thread calls at most once. */
  template <class Find>
  bool operator()(const Find& find) const
  {
    std::uint8_t state = load_relaxed(m_state);
    if(state == unknown) {
      state = find() ? yes : no;
      store_relaxed(m_state, state);
    }
    return state == yes;
  }

private:
  static constexpr std::uint8_t unknown = 0, yes = 1, no = 2;

  mutable std::uint8_t m_state = unknown;
};

/* Records for input edges whether the faces beside them, unfolded, lie in one plane. */
class Flat_edges
{
public:
  /* With space for the results of `number_of_edges` edges; with none, nothing is stored. */
  explicit Flat_edges(std::size_t number_of_edges = 0)
    : m_decisions(number_of_edges)
  {
  }

  std::size_t size() const { return m_decisions.size(); }

  /* Returns the result for the edge of h, which is that of `compute()` in the first query. */
  template <class Compute>
  bool operator()(Input_halfedge_index h, const Compute& compute)
  {
    return size() == 0 ? compute() : m_decisions[static_cast<std::size_t>(h.idx() / 2)](compute);
  }

private:
  Lazy_array<Cached_decision> m_decisions;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTAINERS_H
