// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SEARCH_LABELS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SEARCH_LABELS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Slot_table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What a search knows of the vertices that it has reached: the distance, through which halfedge the path arrives, and
 * whether the vertex is settled. Only vertices that were once reached take memory, with their neighbors in a cache
 * line, which holds the labels of four, in the order in which they were first written.
 *
 * A label knows in which search it was written, so that a new search forgets all labels in constant time.
 *
 * \tparam Halfedge `Input_halfedge_index` or `Halfedge_index`
 */
template <class Halfedge>
class Search_labels
{
public:
  /* What is known of one vertex. */
  struct Label
  {
    double distance;
    Index arrival;       // the halfedge through which the path arrives
    std::uint32_t stamp; // twice the number of the search, and one more if the vertex is settled

    /* `null_index` at the source. */
    Halfedge incoming() const { return Halfedge(arrival); }
  };

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
    m_stamp += 2;
    if(m_stamp == 0) // all numbers have been used
      *this = Search_labels(m_size);
  }

  /* The label of a vertex, which says something if the vertex is reached. */
  const Label& operator[](Vertex_index v) const { return m_blocks[index(v)].labels[position(v)]; }

  bool is_settled(const Label& label) const { return label.stamp == m_stamp + 1; }
  /* \pre the vertex is not settled */
  bool is_reached(const Label& label) const { return label.stamp == m_stamp; }

  /* Labels a vertex, which is not settled then. */
  void reach(Vertex_index v, double distance, Halfedge incoming)
  {
    if(!m_slots.has_slot(block(v)))
      m_blocks[static_cast<std::size_t>(m_slots.add(block(v)))] = Block();
    m_blocks[index(v)].labels[position(v)] = {distance, incoming.idx(), m_stamp};
  }

  /* \pre `v` is reached */
  void settle(Vertex_index v) { m_blocks[index(v)].labels[position(v)].stamp = m_stamp + 1; }

private:
  static constexpr std::uint32_t block_size = 4;

  struct alignas(64) Block
  {
    std::array<Label, block_size> labels;
  };
  static_assert(sizeof(Block) == 64, "a block fills a cache line");
  static_assert(std::is_trivially_default_constructible<Block>::value, "to make blocks must not write them");

  static Index block(Vertex_index v) { return static_cast<Index>(static_cast<std::uint32_t>(v.idx()) / block_size); }
  static std::size_t position(Vertex_index v) { return static_cast<std::uint32_t>(v.idx()) % block_size; }

  std::size_t index(Vertex_index v) const { return static_cast<std::size_t>(m_slots[block(v)]); }

  std::size_t m_size;
  // Of blocks; the first is of no search.
  Slot_table<1> m_slots;
  std::unique_ptr<Block[]> m_blocks;
  std::uint32_t m_stamp = 2;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SEARCH_LABELS_H
