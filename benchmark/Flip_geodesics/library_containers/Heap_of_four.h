// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_HEAP_OF_FOUR_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_HEAP_OF_FOUR_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

inline std::uint64_t ordered_bits(double number)
{
  std::uint64_t bits;
  number += 0.0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

/* A binary heap, by the functions of the standard library. */
template <class Entry>
class Heap_of_four
{
  struct Is_later
  {
    bool operator()(const Entry& a, const Entry& b) const { return Entry::is_before(b, a) != 0; }
  };

public:
  bool empty() const { return m_entries.empty(); }
  void clear() { m_entries.clear(); }
  const Entry& top() { return m_entries.front(); }

  void push(const Entry& entry)
  {
    m_entries.push_back(entry);
    std::push_heap(m_entries.begin(), m_entries.end(), Is_later());
  }

  void pop()
  {
    std::pop_heap(m_entries.begin(), m_entries.end(), Is_later());
    m_entries.pop_back();
  }

private:
  std::vector<Entry> m_entries;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_HEAP_OF_FOUR_H
