// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERSION_CACHE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERSION_CACHE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Values that were computed for the edges that flips created, by the version of the edge: one more than the position of
 * its flip in the log. The least recently used values are dropped when all take too much memory, so that the same calls
 * drop the same values. A value is stored with the number of bytes that it owns besides its own size.
 *
 * As `std::list` and `std::unordered_map`, which are as fast for what they hold. But their nodes would take most of the
 * memory, so that the same limit would hold fewer values, and long histories would be derived again and again.
 */
template <class Value>
class Version_cache
{
  struct Entry
  {
    Value value;
    std::size_t bytes;
    Index version, newer, older;
  };

public:
  /* The value of a version, null if there is none. Valid until it is dropped or erased. */
  Value* find(Index version)
  {
    if(slot(version) == null_index)
      return nullptr;
    const Index i = m_slots[position(version)];
    if(i != m_newest) {
      unlink(i);
      link_newest(i);
    }
    return &entry(i).value;
  }

  bool contains(Index version) const { return slot(version) != null_index; }

  /* \pre it has no value */
  Value& insert(Index version, Value&& value, std::size_t bytes)
  {
    if(m_slots.size() <= position(version))
      m_slots.resize(position(version) + 1, null_index);
    const Index i = free_entry();
    entry(i).value = std::move(value);
    entry(i).bytes = bytes;
    entry(i).version = version;
    m_slots[position(version)] = i;
    m_bytes += sizeof(Entry) + bytes;
    link_newest(i);
    return entry(i).value;
  }

  /* Forgets the last version. What it held goes to `recycle`. \pre no later one is known */
  template <class Recycle>
  void forget(Index version, const Recycle& recycle)
  {
    if(m_slots.size() <= position(version))
      return;
    if(m_slots.back() != null_index)
      drop(m_slots.back(), recycle);
    m_slots.pop_back();
  }

  /* Drops the values that have not been asked for longest until all take at most so many bytes. */
  template <class Recycle>
  void shrink(std::size_t most_bytes, const Recycle& recycle)
  {
    while(m_bytes > most_bytes && m_oldest != null_index)
      drop(m_oldest, recycle);
  }

  std::size_t memory() const { return m_bytes + m_slots.memory(); }

private:
  static std::size_t position(Index version) { return static_cast<std::size_t>(version) - 1; }

  Index slot(Index version) const
  {
    return position(version) < m_slots.size() ? m_slots[position(version)] : null_index;
  }

  Entry& entry(Index i) { return m_entries[static_cast<std::size_t>(i)]; }

  Index free_entry()
  {
    if(m_free == null_index) {
      m_entries.push_back(Entry());
      return static_cast<Index>(m_entries.size()) - 1;
    }
    return std::exchange(m_free, entry(m_free).older);
  }

  template <class Recycle>
  void drop(Index i, const Recycle& recycle)
  {
    unlink(i);
    Entry& dropped = entry(i);
    m_slots[position(dropped.version)] = null_index;
    m_bytes -= sizeof(Entry) + dropped.bytes;
    recycle(std::move(dropped.value));
    dropped.value = Value();
    dropped.older = std::exchange(m_free, i);
  }

  void link_newest(Index i)
  {
    entry(i).newer = null_index;
    entry(i).older = m_newest;
    (m_newest == null_index ? m_oldest : entry(m_newest).newer) = i;
    m_newest = i;
  }

  void unlink(Index i)
  {
    const Entry& e = entry(i);
    (e.newer == null_index ? m_newest : entry(e.newer).older) = e.older;
    (e.older == null_index ? m_oldest : entry(e.older).newer) = e.newer;
  }

  Block_array<Index> m_slots;   // by position in the log: which entry is the version's
  Block_array<Entry> m_entries; // whose values stay where they are
  Index m_newest = null_index, m_oldest = null_index;
  Index m_free = null_index; // the first entry without a value; the others follow as older ones
  std::size_t m_bytes = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERSION_CACHE_H
