// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLOT_TABLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLOT_TABLE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Flip_geodesics::internal {

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

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_SLOT_TABLE_H
