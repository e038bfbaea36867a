// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_VERTEX_QUEUE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_VERTEX_QUEUE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A queue of vertices by priority, the smallest first, and of equal priorities the smallest vertex: a total order, so
 * that what comes out does not depend on the shape of the heap. Priorities are kept as integers, which compare without
 * branches.
 */
class Vertex_queue
{
public:
  bool empty() const { return m_heap.empty(); }
  void clear() { m_heap.clear(); }

  /* \pre priority >= 0 */
  void push(double priority, Vertex_index vertex)
  {
    CGAL_precondition(priority >= 0);
    m_heap.push({ordered_bits(priority), vertex});
  }

  /* The priority of the first vertex. \pre not empty */
  double priority()
  {
    double result;
    std::memcpy(&result, &m_heap.top().key, sizeof result);
    return result;
  }

  /* Removes the first vertex. */
  Vertex_index pop()
  {
    const Vertex_index result = m_heap.top().vertex;
    m_heap.pop();
    return result;
  }

private:
  struct Entry
  {
    std::uint64_t key;
    Vertex_index vertex;

    // The branch is foretold, since equal keys are rare, and the other comparison is none.
    static std::size_t is_before(const Entry& a, const Entry& b)
    {
      if(a.key == b.key)
        return a.vertex < b.vertex ? 1 : 0;
      return static_cast<std::size_t>(a.key < b.key);
    }
  };

  Heap_of_four<Entry> m_heap;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_VERTEX_QUEUE_H
