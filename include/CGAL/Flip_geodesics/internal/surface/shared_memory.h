// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SHARED_MEMORY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SHARED_MEMORY_H

#include <atomic>
#include <thread>
#include <type_traits>

// For const members that store computed results and may be called by several threads at once.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SHARED_MEMORY_H
