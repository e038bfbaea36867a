// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_WAVE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_WAVE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Edge_cones.h>
#include <CGAL/Flip_geodesics/internal/distances/Heap_of_four.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* What a `Cone_sweep` has brought to a halfedge: its cones, and what they were fitted to. */
struct Cone_wave
{
  Edge_cones cones;
  double at_tail = 0, at_split = 0, at_head = 0;
  double apex_distance = std::numeric_limits<double>::infinity(); // of the opposite corner, when it was last looked at
  std::array<std::int32_t, 2> seen = {0, 0};                      // which version of what comes over the other sides
  std::int32_t version = 0, number_of_updates = 0;
  bool is_set = false, is_waiting = false;
  bool is_borrowed = false; // from the other halfedge, and lower than need be

  /* In the queue: nearer to the less, since it is at that end that what comes over the edge goes on first. */
  std::uint64_t key() const
  {
    const double less = (std::min)(at_tail, at_head), more = (std::max)(at_tail, at_head);
    return ordered_bits((std::max)(0.75 * less + 0.25 * more, 0.0));
  }
};

/* What a sweep knows of a vertex. */
struct Swept_vertex
{
  double distance = 0, to_goal = 0;
  bool is_reached = false, is_waiting = false, has_bound = false;
};

/* A wave that is to be carried on, or a vertex from which waves are to start. */
struct Queued_wave
{
  std::uint64_t key;
  Index id; // of a side, or -1 less that of a vertex

  static std::size_t is_before(const Queued_wave& a, const Queued_wave& b)
  {
    return a.key == b.key ? static_cast<std::size_t>(a.id < b.id) : static_cast<std::size_t>(a.key < b.key);
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_CONE_WAVE_H
