// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_VERTEX_QUEUE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_VERTEX_QUEUE_H

#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A queue of vertices by priority, the smallest first, and of equal priorities the smallest vertex: a total order, so
 * that what comes out does not depend on the shape of the heap.
 *
 * The heap has four children per node: half as deep as a binary one, and siblings share a cache line or two. Priorities
 * are kept as the integers that their bits are, which for numbers that are not negative have the same order and compare
 * without branches. The way down always goes to a leaf, since the last entry, which fills the hole, belongs near one.
 */
class Vertex_queue
{
  static constexpr std::size_t arity = 4;

public:
  bool empty() const { return m_entries.empty(); }
  void clear() { m_entries.clear(); }

  /* \pre priority >= 0 */
  void push(double priority, Index vertex)
  {
    CGAL_precondition(priority >= 0);
    Entry entry = {0, vertex};
    priority += 0.0; // no negative zero
    std::memcpy(&entry.key, &priority, sizeof priority);
    m_entries.push_back(entry);
    sift_up(m_entries.size() - 1, entry);
  }

  /* Removes the first vertex. */
  Index pop()
  {
    const Index result = m_entries.front().vertex;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!m_entries.empty())
      sift_up(hole_at_leaf(), last);
    return result;
  }

private:
  struct Entry
  {
    std::uint64_t key;
    Index vertex;
  };

  // 1 if so, else 0. The branch is foretold, since equal keys are rare, and the other comparison is none.
  static std::size_t is_before(const Entry& a, const Entry& b)
  {
    if(a.key == b.key)
      return a.vertex < b.vertex ? 1 : 0;
    return static_cast<std::size_t>(a.key < b.key);
  }

  void sift_up(std::size_t hole, const Entry& entry)
  {
    Entry* const entries = m_entries.data();
    while(hole > 0) {
      const std::size_t parent = (hole - 1) / arity;
      if(is_before(entry, entries[parent]) == 0)
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
      const std::size_t a = child + is_before(entries[child + 1], entries[child]);
      const std::size_t b = child + 2 + is_before(entries[child + 3], entries[child + 2]);
      const std::size_t smallest = a ^ ((a ^ b) & (0 - is_before(entries[b], entries[a])));
      entries[hole] = entries[smallest];
      hole = smallest;
    }
    if(child < size) {
      std::size_t smallest = child;
      for(std::size_t i = child + 1; i < size; ++i)
        smallest += (i - smallest) * is_before(entries[i], entries[smallest]);
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_VERTEX_QUEUE_H
