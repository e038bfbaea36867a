// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_HEAP_OF_FOUR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_HEAP_OF_FOUR_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* Returns the bits of a nonnegative number as an integer, which preserves the order. */
inline std::uint64_t ordered_bits(double number)
{
  std::uint64_t bits;
  number += 0.0; // turns a negative zero into a positive one
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

/*
 * A priority queue with the smallest entry first: a heap with four children per node, which is half as deep as a binary
 * one and whose siblings share one or two cache lines. The smallest sibling is found without branches, half of which
 * would be mispredicted.
 *
 * A removed entry leaves a hole at the top, which the next push fills: the new entry usually follows from the removed
 * one and is due soon, so that it stays near the top. Without a push, the last entry fills the hole, which first moves
 * all the way down, since that entry belongs near a leaf.
 *
 * \tparam Entry has a static member `is_before(a, b)`, a total order: 1 or 0
 */
template <class Entry>
class Heap_of_four
{
  static constexpr std::size_t arity = 4;

public:
  bool empty() const { return m_entries.size() == (m_has_hole ? 1 : 0); }
  void clear()
  {
    m_entries.clear();
    m_has_hole = false;
  }

  /* Returns the smallest entry. \pre not empty */
  const Entry& top()
  {
    fill_hole();
    return m_entries.front();
  }

  void push(const Entry& entry)
  {
    if(m_has_hole) {
      m_has_hole = false;
      sift_down(entry);
      return;
    }
    m_entries.push_back(entry);
    sift_up(m_entries.size() - 1, entry);
  }

  /* Removes the smallest entry. \pre not empty */
  void pop()
  {
    fill_hole();
    m_has_hole = true;
  }

private:
  void sift_up(std::size_t hole, const Entry& entry)
  {
    Entry* const entries = m_entries.data();
    while(hole > 0) {
      const std::size_t parent = (hole - 1) / arity;
      if(Entry::is_before(entry, entries[parent]) == 0)
        break;
      entries[hole] = entries[parent];
      hole = parent;
    }
    entries[hole] = entry;
  }

  // Puts an entry into the hole at the top, or below it after moving smaller ones up.
  void sift_down(const Entry& entry)
  {
    Entry* const entries = m_entries.data();
    const std::size_t size = m_entries.size();
    std::size_t hole = 0;
    for(std::size_t child = 1; child < size; child = arity * hole + 1) {
      const std::size_t smallest = smallest_sibling(child);
      if(Entry::is_before(entries[smallest], entry) == 0)
        break;
      entries[hole] = entries[smallest];
      hole = smallest;
    }
    entries[hole] = entry;
  }

  void fill_hole()
  {
    if(!m_has_hole)
      return;
    m_has_hole = false;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(m_entries.empty())
      return;
    Entry* const entries = m_entries.data();
    const std::size_t size = m_entries.size();
    std::size_t hole = 0;
    for(std::size_t child = 1; child < size; child = arity * hole + 1) {
      const std::size_t smallest = smallest_sibling(child);
      entries[hole] = entries[smallest];
      hole = smallest;
    }
    sift_up(hole, last);
  }

  // Of the children of a node, the first of which is `child`.
  std::size_t smallest_sibling(std::size_t child) const
  {
    const Entry* const entries = m_entries.data();
    const std::size_t size = m_entries.size();
    if(child + arity <= size) {
      const std::size_t a = child + Entry::is_before(entries[child + 1], entries[child]);
      const std::size_t b = child + 2 + Entry::is_before(entries[child + 3], entries[child + 2]);
      return a ^ ((a ^ b) & (0 - Entry::is_before(entries[b], entries[a])));
    }
    std::size_t smallest = child;
    for(std::size_t i = child + 1; i < size; ++i)
      smallest += (i - smallest) * Entry::is_before(entries[i], entries[smallest]);
    return smallest;
  }

  std::vector<Entry> m_entries;
  bool m_has_hole = false; // at the top
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_HEAP_OF_FOUR_H
