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
#include <memory>
#include <new>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

// Arrays that take little time and memory for large meshes, and variables shared by several threads.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Converts a number of elements to a bound of indices; throws `Invalid_mesh_error` if it is too large. */
template <class Count>
Index checked_index_bound(Count count)
{
  if(static_cast<std::uint64_t>(count) >= static_cast<std::uint64_t>((std::numeric_limits<Index>::max)()))
    throw Invalid_mesh_error("the mesh has more elements than 32-bit indices can number");
  return static_cast<Index>(count);
}

/*
 * Allocates zero bytes and leaves them as the initial elements. If the operating system provides cleared pages, they
 * cost nothing until they are written, so that a workspace as large as the mesh is created in constant time.
 */
template <class T>
struct Zero_allocator
{
  static_assert(alignof(T) <= alignof(std::max_align_t), "std::calloc() aligns no further");

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

/*
 * Assigns slots to the elements of a sequence, in blocks, in the order of their first use. Data of the elements is then
 * stored in an array by slots, in which all used elements are close together, however the sequence is numbered. Stored
 * by elements, distant data would take one page of memory each, and obtaining a page from the operating system takes
 * longer than most operations on an element.
 *
 * The slots of block 0 are those of elements that were never used.
 *
 * Other threads may look up slots while one thread assigns some.
 */
template <std::size_t BlockSize>
class Slot_table
{
public:
  static constexpr std::size_t block_size = BlockSize;

  explicit Slot_table(std::size_t number_of_elements)
  {
    const std::size_t blocks = number_of_blocks(number_of_elements);
    m_starts.reserve(blocks + blocks / 8 + 8); // so that few additional elements do not move all
    m_starts.resize(blocks);
    checked_index_bound(largest_number_of_slots());
  }

  /* Returns the slot of an element; it is less than `block_size` if none is assigned. */
  Index operator[](Index i) const { return start_of(i) + static_cast<Index>(position(i)); }

  bool has_slot(Index i) const { return start_of(i) != 0; }

  /*
   * Assigns the slots from `number_of_slots()` on to the block of an element. Other threads may look up slots
   * simultaneously: data written at these slots before is visible to threads that find them. Returns the first of these
   * slots. \pre the element has none
   */
  Index add(Index i)
  {
    const std::size_t start = number_of_slots();
    store_relaxed(m_number_of_slots, start + block_size);
    store_release(m_starts[block(i)], static_cast<Index>(start));
    return static_cast<Index>(start);
  }

  /* Returns the number of assigned slots, plus those of block 0. */
  std::size_t number_of_slots() const { return load_relaxed(m_number_of_slots); }

  /* Returns the number of slots when all elements have one. */
  std::size_t largest_number_of_slots() const { return (m_starts.size() + 1) * block_size; }

  /* Adds elements up to a new number. */
  void grow(std::size_t number_of_elements)
  {
    if(number_of_blocks(number_of_elements) > m_starts.size())
      m_starts.resize(number_of_blocks(number_of_elements));
    checked_index_bound(largest_number_of_slots());
  }

private:
  static std::size_t number_of_blocks(std::size_t elements) { return (elements + block_size - 1) / block_size; }

  // Of the slots of an element's block.
  Index start_of(Index i) const { return load_acquire(m_starts[block(i)]); }

  static std::size_t block(Index i) { return static_cast<std::uint32_t>(i) / block_size; }
  static std::size_t position(Index i) { return static_cast<std::uint32_t>(i) % block_size; }

  Lazy_array<Index> m_starts; // of a block's slots; 0 if it has none
  std::size_t m_number_of_slots = block_size;
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_CONTAINERS_H
