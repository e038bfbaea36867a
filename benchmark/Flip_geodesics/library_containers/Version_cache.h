// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERSION_CACHE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERSION_CACHE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <cstddef>
#include <iterator>
#include <list>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A list of the standard library, the newest first, and a hash table of it. */
template <class Value>
class Version_cache
{
  struct Entry
  {
    Index version;
    Value value;
    std::size_t bytes;
  };
  using Entries = std::list<Entry>;

public:
  Value* find(Index version)
  {
    const auto known = m_known.find(version);
    if(known == m_known.end())
      return nullptr;
    m_entries.splice(m_entries.begin(), m_entries, known->second);
    return &known->second->value;
  }

  bool contains(Index version) const { return m_known.count(version) != 0; }

  Value& insert(Index version, Value&& value, std::size_t bytes)
  {
    m_entries.push_front({version, std::move(value), bytes});
    m_known[version] = m_entries.begin();
    m_bytes += sizeof(Entry) + bytes;
    return m_entries.front().value;
  }

  template <class Recycle>
  void forget(Index version, const Recycle& recycle)
  {
    const auto known = m_known.find(version);
    if(known != m_known.end())
      drop(known->second, recycle);
  }

  template <class Recycle>
  void shrink(std::size_t most_bytes, const Recycle& recycle)
  {
    while(m_bytes > most_bytes && !m_entries.empty())
      drop(std::prev(m_entries.end()), recycle);
  }

  std::size_t memory() const { return m_bytes; }

private:
  template <class Recycle>
  void drop(typename Entries::iterator entry, const Recycle& recycle)
  {
    m_bytes -= sizeof(Entry) + entry->bytes;
    recycle(std::move(entry->value));
    m_known.erase(entry->version);
    m_entries.erase(entry);
  }

  Entries m_entries;
  std::unordered_map<Index, typename Entries::iterator> m_known;
  std::size_t m_bytes = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERSION_CACHE_H
