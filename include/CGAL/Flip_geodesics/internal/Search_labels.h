// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SEARCH_LABELS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SEARCH_LABELS_H

#include <CGAL/Flip_geodesics/internal/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/Lazy_array.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What a search knows of the vertices that it has reached: the distance, through which halfedge the path arrives, and
 * whether the vertex is settled. Only vertices that were once reached take memory, with their neighbors in a cache
 * line, which holds the labels of five: a table of blocks, and the blocks in the order in which they were first
 * written. A `Lazy_array` alone takes whole pages of memory, and where a mesh is numbered without order, nearly all of
 * them.
 *
 * A block knows in which search it was last written, so that a new search forgets all labels in constant time.
 */
class Search_labels
{
  static constexpr std::size_t block_size = 5;
  static constexpr std::uint32_t settled_bit = std::uint32_t(1) << 31;

  struct Block
  {
    std::array<double, block_size> distances;
    std::array<std::uint32_t, block_size> arrivals; // 0 if not reached, else the halfedge + 2, and the settled bit
    std::uint32_t search;
  };
  static_assert(sizeof(Block) == 64, "a block fills a cache line");

public:
  explicit Search_labels(std::size_t size)
    : m_size(size)
    , m_table(size / block_size + 1)
    , m_blocks(m_table.size() + 1)
  {
  }

  /* Forgets all labels. */
  void clear()
  {
    if(++m_search == 0) // all numbers have been used
      *this = Search_labels(m_size);
  }

  bool is_reached(Index v) const { return arrival(v) != 0; }
  bool is_settled(Index v) const { return (arrival(v) & settled_bit) != 0; }

  /* Any number if `v` is not reached. */
  double distance(Index v) const { return block(v).distances[slot(v)]; }

  /* The halfedge through which the path arrives, `null_index` at the source. \pre `v` is reached */
  Index incoming(Index v) const { return static_cast<Index>(block(v).arrivals[slot(v)] & ~settled_bit) - 2; }

  /* Labels a vertex, which is not settled then. */
  void reach(Index v, double distance, Index incoming)
  {
    Block& written = writable_block(v);
    written.distances[slot(v)] = distance;
    written.arrivals[slot(v)] = static_cast<std::uint32_t>(incoming + 2);
  }

  /* \pre `v` is reached */
  void settle(Index v) { m_blocks[m_table[place(v)]].arrivals[slot(v)] |= settled_bit; }

private:
  static std::size_t place(Index v) { return static_cast<std::uint32_t>(v) / block_size; }
  static std::size_t slot(Index v) { return static_cast<std::uint32_t>(v) % block_size; }

  const Block& block(Index v) const { return m_blocks[m_table[place(v)]]; }

  std::uint32_t arrival(Index v) const
  {
    const Block& b = block(v);
    return b.search == m_search ? b.arrivals[slot(v)] : 0;
  }

  Block& writable_block(Index v)
  {
    std::uint32_t& number = m_table[place(v)];
    if(number == 0)
      number = ++m_number_of_blocks;
    Block& result = m_blocks[number];
    if(result.search != m_search) {
      result.search = m_search;
      result.arrivals.fill(0);
    }
    return result;
  }

  std::size_t m_size;
  Lazy_array<std::uint32_t> m_table; // 0 if never written: that block stays zero, of no search
  Lazy_array<Block> m_blocks;
  std::uint32_t m_number_of_blocks = 0;
  std::uint32_t m_search = 1;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SEARCH_LABELS_H
