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

/* Of which input edges it is known whether the faces beside them lie unfolded in one plane. Several threads may ask at
 * once, and may compute the same then. */
class Flat_edges
{
public:
  /* With room for what is known of so many edges; with none, nothing is kept. */
  explicit Flat_edges(std::size_t number_of_edges = 0)
    : m_states(number_of_edges)
  {
  }

  std::size_t size() const { return m_states.size(); }

  /* The answer for the edge of h, from `compute()` if it is asked for the first time. */
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
