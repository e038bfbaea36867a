// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WRITTEN_RECORDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WRITTEN_RECORDS_H

#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/surface/Slot_table.h>

#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A record for each element of a sequence, of which few are written: these lie side by side, in the order in which they
 * were first written, and stay in place. All others are one record, which is as it was made.
 */
template <class Key, class Record>
class Written_records
{
public:
  explicit Written_records(std::size_t number_of_elements)
    : m_slots(number_of_elements)
  {
    m_records.push_back(Record());
  }

  const Record& operator[](Key key) const { return m_records[static_cast<std::size_t>(m_slots[key.idx()])]; }

  /* The element's own record, to be changed. */
  Record& write(Key key)
  {
    if(!m_slots.has_slot(key.idx())) {
      m_slots.add(key.idx());
      m_records.push_back(Record());
      return m_records.back();
    }
    return m_records[static_cast<std::size_t>(m_slots[key.idx()])];
  }

private:
  Slot_table<1> m_slots;
  Block_array<Record> m_records; // by slots
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WRITTEN_RECORDS_H
