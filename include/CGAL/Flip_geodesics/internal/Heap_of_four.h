// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_HEAP_OF_FOUR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_HEAP_OF_FOUR_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The bits of a number as an integer: of the same order for numbers that are not negative. */
inline std::uint64_t ordered_bits(double number)
{
  std::uint64_t bits;
  number += 0.0; // no negative zero
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

/*
 * A priority queue, the smallest entry first: a heap with four children per node, half as deep as a binary one, and
 * siblings share a cache line or two. The way down always goes to a leaf, since the last entry, which fills the hole,
 * belongs near one; it is taken without branches, of which half would be foretold wrongly.
 *
 * \tparam Entry has a static member `is_before(a, b)`, a total order: 1 or 0
 */
template <class Entry>
class Heap_of_four
{
  static constexpr std::size_t arity = 4;

public:
  bool empty() const { return m_entries.empty(); }
  void clear() { m_entries.clear(); }

  /* The smallest entry. \pre not empty */
  const Entry& top() const { return m_entries.front(); }

  void push(const Entry& entry)
  {
    m_entries.push_back(entry);
    sift_up(m_entries.size() - 1, entry);
  }

  /* Removes the smallest entry. \pre not empty */
  void pop()
  {
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!m_entries.empty())
      sift_up(hole_at_leaf(), last);
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

  // Moves the smallest child up all the way down, and returns where nobody is left.
  std::size_t hole_at_leaf()
  {
    Entry* const entries = m_entries.data();
    const std::size_t size = m_entries.size();
    std::size_t hole = 0, child = 1;
    for(; child + arity <= size; child = arity * hole + 1) {
      const std::size_t a = child + Entry::is_before(entries[child + 1], entries[child]);
      const std::size_t b = child + 2 + Entry::is_before(entries[child + 3], entries[child + 2]);
      const std::size_t smallest = a ^ ((a ^ b) & (0 - Entry::is_before(entries[b], entries[a])));
      entries[hole] = entries[smallest];
      hole = smallest;
    }
    if(child < size) {
      std::size_t smallest = child;
      for(std::size_t i = child + 1; i < size; ++i)
        smallest += (i - smallest) * Entry::is_before(entries[i], entries[smallest]);
      entries[hole] = entries[smallest];
      hole = smallest;
    }
    return hole;
  }

  std::vector<Entry> m_entries;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_HEAP_OF_FOUR_H
