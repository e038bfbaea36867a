// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SEARCH_SEARCH_LABELS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SEARCH_SEARCH_LABELS_H

#include <CGAL/Flip_geodesics/internal/base/Slot_table.h>
#include <CGAL/Flip_geodesics/internal/input/Indexed_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What a search knows of the vertices that it has reached: the distance, through which halfedge the path arrives, and
 * whether the vertex is settled. Only vertices that were once reached take memory, with their neighbors in a cache
 * line, which holds the labels of five, in the order in which they were first written.
 *
 * A block knows in which search it was last written, so that a new search forgets all labels in constant time.
 */
class Search_labels
{
  static constexpr std::size_t block_size = 5;
  static constexpr std::uint32_t settled_bit = std::uint32_t(1) << 31;

  struct alignas(64) Block
  {
    std::array<double, block_size> distances;
    std::array<std::uint32_t, block_size> arrivals; // 0 if not reached, else the halfedge + 2, and the settled bit
    std::uint32_t search;
  };
  static_assert(sizeof(Block) == 64, "a block fills a cache line");

public:
  explicit Search_labels(std::size_t size)
    : m_size(size)
    , m_slots(size / block_size + 1)
    , m_blocks(new Block[m_slots.largest_number_of_slots()]) // not written before they are used
  {
    m_blocks[0] = Block();
  }

  /* Forgets all labels. */
  void clear()
  {
    if(++m_search == 0) // all numbers have been used
      *this = Search_labels(m_size);
  }

  bool is_reached(Vertex_index v) const { return arrival(v) != 0; }
  bool is_settled(Vertex_index v) const { return (arrival(v) & settled_bit) != 0; }

  /* Any number if `v` is not reached. */
  double distance(Vertex_index v) const { return block(v).distances[slot(v)]; }

  /* The halfedge through which the path arrives, `null_index` at the source. \pre `v` is reached */
  Input_halfedge_index incoming(Vertex_index v) const
  {
    return Input_halfedge_index(static_cast<Index>(block(v).arrivals[slot(v)] & ~settled_bit) - 2);
  }

  /* Labels a vertex, which is not settled then. */
  void reach(Vertex_index v, double distance, Input_halfedge_index incoming)
  {
    Block& written = writable_block(v);
    written.distances[slot(v)] = distance;
    written.arrivals[slot(v)] = static_cast<std::uint32_t>(incoming.idx() + 2);
  }

  /* \pre `v` is reached */
  void settle(Vertex_index v) { m_blocks[index(v)].arrivals[slot(v)] |= settled_bit; }

private:
  static Index place(Vertex_index v) { return static_cast<Index>(static_cast<std::uint32_t>(v.idx()) / block_size); }
  static std::size_t slot(Vertex_index v) { return static_cast<std::uint32_t>(v.idx()) % block_size; }

  std::size_t index(Vertex_index v) const { return static_cast<std::size_t>(m_slots[place(v)]); }
  const Block& block(Vertex_index v) const { return m_blocks[index(v)]; }

  std::uint32_t arrival(Vertex_index v) const
  {
    const Block& b = block(v);
    return b.search == m_search ? b.arrivals[slot(v)] : 0;
  }

  Block& writable_block(Vertex_index v)
  {
    std::size_t i = index(v);
    if(i == 0) {
      i = static_cast<std::size_t>(m_slots.add(place(v)));
      m_blocks[i] = Block();
    }
    Block& result = m_blocks[i];
    if(result.search != m_search) {
      result.search = m_search;
      result.arrivals.fill(0);
    }
    return result;
  }

  std::size_t m_size;
  // Of blocks; the first is of no search.
  Slot_table<1> m_slots;
  std::unique_ptr<Block[]> m_blocks;
  std::uint32_t m_search = 1;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SEARCH_SEARCH_LABELS_H
