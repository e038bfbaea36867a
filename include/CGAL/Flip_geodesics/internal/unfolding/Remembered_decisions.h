// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_REMEMBERED_DECISIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_REMEMBERED_DECISIONS_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/internal/surface/Flat_edges.h>
#include <CGAL/Flip_geodesics/internal/surface/shared_memory.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Compared_wedges.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <mutex>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What a triangulation keeps of the decisions that its traits left open. Members that are const can be called by several
 * threads at once.
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
   * How the wedge clockwise from one edge to another compares with pi, by `compare(statistics)` if it is not known.
   * Nothing is locked while that is computed.
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

  /* What is known of flat edges of an input. */
  Flat_edges& flat_edges(std::size_t number_of_input_edges) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    if(m_flat_edges.size() == 0)
      m_flat_edges = Flat_edges(number_of_input_edges);
    return m_flat_edges;
  }

  /* Flips were taken back. */
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_REMEMBERED_DECISIONS_H
