// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_COMPARED_WEDGES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_COMPARED_WEDGES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A side of an edge, as it is between two flips of the edge. */
struct Side_version
{
  Halfedge_index halfedge;
  Index version;

  bool operator==(const Side_version& other) const { return halfedge == other.halfedge && version == other.version; }
};

/*
 * Results of expensive comparisons of wedges with pi. A straight angle prevents flips and is therefore compared again
 * whenever the flips around it are attempted: a hundred times at an extruded developable region. The angle between two
 * edges is constant as long as both exist.
 *
 * In this hash table each wedge has one possible entry, where it replaces any other one, so that the size is bounded
 * and no search is needed. Versions are reused after flips were rolled back; from then on all wedges count as new,
 * except those between edges of the input.
 */
class Compared_wedges
{
public:
  /* Returns the result for the wedge clockwise from one edge to another, or null if it is unknown. */
  const Comparison_result* find(const Side_version& from, const Side_version& to) const
  {
    if(m_entries.empty())
      return nullptr;
    const Entry& entry = m_entries[place(from, to)];
    return entry.epoch == epoch(from, to) && entry.from == from && entry.to == to ? &entry.result : nullptr;
  }

  void insert(const Side_version& from, const Side_version& to, Comparison_result result)
  {
    if(4 * m_size >= m_entries.size() && m_entries.size() < most_entries)
      grow();
    put({from, to, epoch(from, to), result});
  }

  /* Must be called after flips were rolled back. */
  void forget_flips() { ++m_epoch; }

private:
  // The epoch is 0 for a free entry, and 1 for a wedge between edges of the input.
  struct Entry
  {
    Side_version from, to;
    std::uint32_t epoch = 0;
    Comparison_result result = EQUAL;
  };

  static constexpr std::size_t few_entries = 64, most_entries = std::size_t(1) << 14; // powers of two

  std::uint32_t epoch(const Side_version& from, const Side_version& to) const
  {
    return from.version == 0 && to.version == 0 ? 1 : m_epoch;
  }

  std::size_t place(const Side_version& from, const Side_version& to) const
  {
    std::uint64_t hash = 0;
    for(Index i : {from.halfedge.idx(), from.version, to.halfedge.idx(), to.version})
      hash = (hash ^ static_cast<std::uint32_t>(i)) * 0x9e3779b97f4a7c15u; // [Fibonacci hashing]
    return static_cast<std::size_t>(hash >> 40) & (m_entries.size() - 1);
  }

  void put(const Entry& entry)
  {
    Entry& place_of_entry = m_entries[place(entry.from, entry.to)];
    m_size += place_of_entry.epoch == 0 ? 1 : 0;
    place_of_entry = entry;
  }

  void grow()
  {
    std::vector<Entry> larger(m_entries.empty() ? few_entries : 4 * m_entries.size());
    larger.swap(m_entries);
    m_size = 0;
    for(const Entry& entry : larger)
      if(entry.epoch == 1 || entry.epoch == m_epoch)
        put(entry);
  }

  std::vector<Entry> m_entries;
  std::size_t m_size = 0; // the number of entries in use
  std::uint32_t m_epoch = 2;
};

/*
 * The results that a triangulation keeps of predicates after filter failures. The const members can be called by
 * several threads simultaneously.
 */
class Remembered_decisions
{
public:
  Decision_statistics statistics() const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    return m_statistics;
  }

  void add(const Decision_statistics& statistics) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    m_statistics += statistics;
  }

  /*
   * Returns the comparison of the wedge clockwise from one edge to another with pi, computed by `compare(statistics)`
   * if unknown. No lock is held during that computation.
   */
  template <class Compare>
  Comparison_result compare(const Side_version& from, const Side_version& to, const Compare& compare) const
  {
    {
      const std::lock_guard<Short_lock> guard(m_lock);
      if(const Comparison_result* known = m_compared_wedges.find(from, to)) {
        ++m_statistics.by_memory;
        return *known;
      }
    }
    Decision_statistics statistics;
    const Comparison_result result = compare(statistics);
    const std::lock_guard<Short_lock> guard(m_lock);
    m_compared_wedges.insert(from, to, result);
    m_statistics += statistics;
    return result;
  }

  /* Returns the results for flat edges of an input. */
  Flat_edges& flat_edges(std::size_t number_of_input_edges) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    if(m_flat_edges.size() == 0)
      m_flat_edges = Flat_edges(number_of_input_edges);
    return m_flat_edges;
  }

  /* Must be called after flips were rolled back. */
  void forget_flips() { m_compared_wedges.forget_flips(); }

private:
  mutable Compared_wedges m_compared_wedges;
  mutable Flat_edges m_flat_edges;
  mutable Decision_statistics m_statistics;
  mutable Short_lock m_lock;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_COMPARED_WEDGES_H
