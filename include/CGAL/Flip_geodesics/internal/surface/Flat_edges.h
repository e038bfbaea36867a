// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FLAT_EDGES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FLAT_EDGES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/surface/shared_memory.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Records for input edges whether the faces beside them, unfolded, lie in one plane. Several threads may query at once
 * and may then perform the same computation. */
class Flat_edges
{
public:
  /* With space for the results of `number_of_edges` edges; with none, nothing is stored. */
  explicit Flat_edges(std::size_t number_of_edges = 0)
    : m_states(number_of_edges)
  {
  }

  std::size_t size() const { return m_states.size(); }

  /* Returns the result for the edge of h, which is that of `compute()` in the first query. */
  template <class Compute>
  bool operator()(Input_halfedge_index h, const Compute& compute)
  {
    if(m_states.size() == 0)
      return compute();
    std::uint8_t& known = m_states[static_cast<std::size_t>(h.idx() / 2)];
    std::uint8_t state = load_relaxed(known);
    if(state == unknown) {
      state = compute() ? flat : bent;
      store_relaxed(known, state);
    }
    return state == flat;
  }

private:
  static constexpr std::uint8_t unknown = 0, flat = 1, bent = 2;

  Lazy_array<std::uint8_t> m_states;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_FLAT_EDGES_H
