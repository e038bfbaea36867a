// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WEDGE_QUEUE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WEDGE_QUEUE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A wedge that was free when it was queued: its joint, told by both segments, since the one that arrives can get
 * another to follow it. The smallest angle comes first, then the older segment, then the left side. In 16 bytes, so
 * that the siblings of the heap share a cache line.
 */
class Queued_wedge
{
public:
  /* A key that rounding has made negative counts as 0. */
  Queued_wedge(double key, const Joint& joint, Segment_index outgoing)
    : m_key(ordered_bits((std::max)(key, 0.0)))
    , m_segment_and_side(2 * static_cast<std::uint32_t>(joint.incoming.idx()) + (joint.side == Side::LEFT ? 0 : 1))
    , m_outgoing(outgoing)
  {
  }

  double key() const
  {
    double key;
    std::memcpy(&key, &m_key, sizeof key);
    return key;
  }

  Joint joint() const
  {
    return {Segment_index(static_cast<Index>(m_segment_and_side / 2)),
            m_segment_and_side % 2 == 0 ? Side::LEFT : Side::RIGHT};
  }

  Segment_index outgoing() const { return m_outgoing; }

  // Without branches: on symmetric meshes many keys are equal.
  static std::size_t is_before(const Queued_wedge& a, const Queued_wedge& b)
  {
    const std::size_t is_older = static_cast<std::size_t>(a.m_segment_and_side < b.m_segment_and_side);
    return static_cast<std::size_t>(a.m_key < b.m_key) | (static_cast<std::size_t>(a.m_key == b.m_key) & is_older);
  }

private:
  std::uint64_t m_key; // the bits of the number
  std::uint32_t m_segment_and_side;
  Segment_index m_outgoing;
};

using Wedge_queue = Heap_of_four<Queued_wedge>;

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_WEDGE_QUEUE_H
