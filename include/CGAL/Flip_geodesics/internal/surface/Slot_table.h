// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLOT_TABLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLOT_TABLE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/shared_memory.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Gives slots to the elements of a sequence, by blocks, in the order in which they are first used. What is kept of the
 * elements lies in an array by slots then, where all that was used is together, however the sequence is numbered. Kept
 * by elements, far from each other, each would take a page of memory of its own, and to be given one by the operating
 * system takes more time than most of what is done with an element.
 *
 * The slots of block 0 are nobody's: those of elements that were never used.
 *
 * If the table `IsShared`, other threads may look up slots while one thread gives some.
 */
template <std::size_t BlockSize, bool IsShared = false>
class Slot_table
{
public:
  static constexpr std::size_t block_size = BlockSize;

  explicit Slot_table(std::size_t number_of_elements)
    : m_starts(number_of_blocks(number_of_elements))
  {
    checked_index_bound(largest_number_of_slots());
  }

  /* The slot of an element; below `block_size` if it has none. */
  Index operator[](Index i) const { return start_of(i) + static_cast<Index>(position(i)); }

  bool has_slot(Index i) const { return start_of(i) != 0; }

  /*
   * Gives an element and the others of its block the slots from `number_of_slots()` on. Other threads may look up slots
   * at the same time: what was written at these slots before is seen by those that find them. Returns the first of them.
   * \pre it has none
   */
  Index add(Index i)
  {
    const std::size_t start = number_of_slots();
    store_relaxed(m_number_of_slots, start + block_size);
    store_release(m_starts[block(i)], static_cast<Index>(start));
    return static_cast<Index>(start);
  }

  /* Those that were given, and those of nobody. */
  std::size_t number_of_slots() const { return load_relaxed(m_number_of_slots); }

  /* The number of slots when all elements have one. */
  std::size_t largest_number_of_slots() const { return (m_starts.size() + 1) * block_size; }

  /* Makes room for more elements. */
  void grow(std::size_t number_of_elements)
  {
    if(number_of_blocks(number_of_elements) > m_starts.size())
      m_starts.resize(number_of_blocks(number_of_elements));
    checked_index_bound(largest_number_of_slots());
  }

private:
  static std::size_t number_of_blocks(std::size_t elements) { return (elements + block_size - 1) / block_size; }

  // Of the slots of an element's block.
  Index start_of(Index i) const
  {
    if constexpr(IsShared)
      return load_acquire(m_starts[block(i)]);
    else
      return m_starts[block(i)];
  }

  static std::size_t block(Index i) { return static_cast<std::uint32_t>(i) / block_size; }
  static std::size_t position(Index i) { return static_cast<std::uint32_t>(i) % block_size; }

  Lazy_array<Index> m_starts; // of a block's slots; 0 if it has none
  std::size_t m_number_of_slots = block_size;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLOT_TABLE_H
