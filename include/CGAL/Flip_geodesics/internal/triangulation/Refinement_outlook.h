// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFINEMENT_OUTLOOK_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFINEMENT_OUTLOOK_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Foresees whether the vertices that refinement may insert suffice to mend the thin faces in its queue.
 *
 * A face of area A with shortest side s takes about A / s^2 vertices where faces cannot grow away from that side: on a
 * tube as thin as s, or between curves as close. Elsewhere they can, a few vertices do, and the *need*, the sum of
 * A / s^2 over the bad faces, falls by half or more in a generation, in which as many faces are treated as there were
 * at its start. So where the need is many times what is allowed, and has not fallen for two generations, the bounds are
 * out of reach.
 */
class Refinement_outlook
{
public:
  /* What a face adds to the need. */
  static double need(const std::array<double, 3>& lengths, double sine_of_smallest_angle)
  {
    const double shortest = (std::min)({lengths[0], lengths[1], lengths[2]});
    const double longest = (std::max)({lengths[0], lengths[1], lengths[2]});
    const double middle = lengths[0] + lengths[1] + lengths[2] - shortest - longest;
    return 0.5 * sine_of_smallest_angle * (longest / shortest) * (middle / shortest);
  }

  /* A face enters the queue. */
  void add(double need)
  {
    m_need += need;
    ++m_size;
  }

  /* A face leaves the queue. */
  void remove(double need)
  {
    m_need -= need;
    --m_size;
    if(m_left_of_generation > 0)
      --m_left_of_generation;
  }

  /* Are the bounds out of reach with so many more vertices? To be asked before each face. */
  bool is_hopeless(std::size_t allowed)
  {
    if(m_left_of_generation > 0)
      return false;
    const bool is_stagnant = m_need > most_kept * m_need_before && m_need > certainty * static_cast<double>(allowed);
    m_stagnant_generations = is_stagnant ? m_stagnant_generations + 1 : 0;
    m_need_before = m_need;
    m_left_of_generation = m_size;
    return m_stagnant_generations >= 2;
  }

  /* Of a face in the queue. */
  double mean_need() const { return m_need / static_cast<double>((std::max)(m_size, std::size_t(1))); }

private:
  static constexpr double most_kept = 0.9; // of the need, over a generation, if there is hope
  static constexpr double certainty = 16;  // how many times the need must be what is allowed, since it is an estimate

  double m_need = 0;
  double m_need_before = std::numeric_limits<double>::infinity();
  std::size_t m_size = 0, m_left_of_generation = 0;
  int m_stagnant_generations = 0;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_REFINEMENT_OUTLOOK_H
