// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_QUEUE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_QUEUE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A priority queue of which all that is due up to some key is taken at once, in no order but one that depends on nothing
 * but the calls. What is due soon is looked through each time, what is due later only when there is nothing else.
 */
class Round_queue
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  struct Entry
  {
    double key;
    Index id;
    std::uint32_t tag; // whatever goes with it
  };

  bool empty() const { return m_soon.empty() && m_later.empty(); }

  /* The smallest key; infinity if there is none. */
  double least() const { return m_soon.empty() ? m_least_later : m_least_soon; }

  void push(const Entry& e)
  {
    (e.key < m_horizon ? m_soon : m_later).push_back(e);
    double& least = e.key < m_horizon ? m_least_soon : m_least_later;
    least = (std::min)(least, e.key);
  }

  /* Makes room for some more. */
  void reserve(std::size_t number)
  {
    for(std::vector<Entry>* entries : {&m_soon, &m_later})
      if(entries->capacity() - entries->size() < number)
        entries->reserve((std::max)(2 * entries->capacity(), entries->size() + number));
  }

  /* Prepares for `take(last)`; returns how many that will take at most. If it throws, nothing has changed.
   * \param step about how much greater `last` will be the next time */
  std::size_t look_ahead(double last, double step)
  {
    constexpr double steps = 16; // between two looks at what is due later
    if(m_least_later <= last || m_soon.empty()) {
      m_soon.reserve(m_soon.size() + m_later.size());
      m_horizon = last + steps * step;
      if(m_least_later <= m_horizon)
        remove(m_later, m_least_later, m_horizon, [this](const Entry& e) {
          m_soon.push_back(e);
          m_least_soon = (std::min)(m_least_soon, e.key);
        });
    }
    return m_soon.size();
  }

  /* Calls `function(entry)` for all whose keys are at most `last`, and takes them out. It must not push anything.
   * \pre look_ahead(last) was called since the last push */
  template <class Function>
  void take(double last, const Function& function)
  {
    remove(m_soon, m_least_soon, last, function);
  }

private:
  // Takes out of a list the entries whose keys are at most `last`.
  template <class Function>
  static void remove(std::vector<Entry>& entries, double& least, double last, const Function& function)
  {
    least = infinity;
    auto to = entries.begin();
    for(const Entry& e : entries)
      if(e.key <= last) {
        function(e);
      } else {
        least = (std::min)(least, e.key);
        *to++ = e;
      }
    entries.erase(to, entries.end());
  }

  std::vector<Entry> m_soon, m_later; // with keys up to the horizon, and greater ones
  double m_horizon = 0, m_least_soon = infinity, m_least_later = infinity;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_ROUND_QUEUE_H
