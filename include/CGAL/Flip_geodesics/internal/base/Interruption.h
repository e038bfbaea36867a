// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_BASE_INTERRUPTION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_BASE_INTERRUPTION_H

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Asks a visitor at regular intervals whether a search is to continue. Once it is interrupted, it remains so. */
class Interruption
{
public:
  /* \param visitor must outlive it; only `go_further()` is called */
  template <class Visitor>
  explicit Interruption(Visitor& visitor)
    : m_go_further([&visitor] { return static_cast<bool>(visitor.go_further()); })
  {
  }

  bool has_occurred() const { return m_has_occurred; }

  /* Counts a step that is about to be taken; returns whether it is not to be. */
  bool count_step() { return ++m_steps % interval == 0 ? begin_part() : m_has_occurred; }

  /* Calls the visitor before a part of a computation that takes far longer than a step; returns whether the part is not
   * to be computed. */
  bool begin_part()
  {
    m_has_occurred = m_has_occurred || !m_go_further();
    return m_has_occurred;
  }

private:
  // Steps of a search take a microsecond at most on average, and a visitor may read a clock.
  static constexpr std::size_t interval = 1024;

  std::function<bool()> m_go_further;
  std::size_t m_steps = 0;
  bool m_has_occurred = false;
};

/* Counts a step of a search which may be one that cannot be interrupted. */
inline bool is_interrupted(Interruption* interruption) { return interruption != nullptr && interruption->count_step(); }

/* Begins a part of a computation which may be one that cannot be interrupted. */
inline bool is_interrupted_before_part(Interruption* interruption)
{
  return interruption != nullptr && interruption->begin_part();
}

/* Has a computation been interrupted, if it can be? */
inline bool has_been_interrupted(const Interruption* interruption)
{
  return interruption != nullptr && interruption->has_occurred();
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_BASE_INTERRUPTION_H
