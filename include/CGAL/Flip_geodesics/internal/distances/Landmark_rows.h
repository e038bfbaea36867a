// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * For each vertex a row of values, one for each of some functions, none of which differs in two vertices by more than
 * their distance and an error of its own: so these differences are lower bounds of the distance.
 *
 * A value is a whole number of units, rounded down, in two bytes. A difference is lowered by one unit for that, and by
 * another for the error of these divisions, which is far less.
 */
class Landmark_rows
{
public:
  Landmark_rows() = default;

  /* \param largest value that matters; larger ones count as this */
  Landmark_rows(std::size_t number_of_vertices, std::size_t number_of_functions, double largest)
    : m_unit(largest > 0 ? largest / largest_number : 1)
    , m_losses(number_of_functions, 2)
    , m_numbers(number_of_vertices * number_of_functions, std::uint16_t(unknown))
  {
  }

  std::size_t number_of_functions() const { return m_losses.size(); }

  /* By how much the values of a function may be wrong, together in two vertices. */
  void set_error(std::size_t i, double error)
  {
    m_losses[i] = 2 + static_cast<int>((std::min)(std::ceil(error / m_unit), largest_number));
  }

  /* Those that are not set, or are infinite, say nothing. */
  void set(Vertex_index v, std::size_t i, double value)
  {
    const double number = (std::min)((std::max)(value / m_unit, 0.0), largest_number);
    m_numbers[static_cast<std::size_t>(v.idx()) * m_losses.size() + i] = static_cast<std::uint16_t>(number);
  }

  /* No path between the vertices is shorter. */
  double distance_lower_bound(Vertex_index v, Vertex_index w) const
  {
    const std::uint16_t *const a = row(v), *const b = row(w);
    int largest = 0;
    for(std::size_t i = 0; i < m_losses.size(); ++i)
      if(a[i] != unknown && b[i] != unknown)
        largest = (std::max)(largest, std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i])) - m_losses[i]);
    return m_unit * largest;
  }

private:
  static constexpr int unknown = 65535;
  static constexpr double largest_number = unknown - 1;

  const std::uint16_t* row(Vertex_index v) const
  {
    return m_numbers.data() + static_cast<std::size_t>(v.idx()) * m_losses.size();
  }

  double m_unit = 1;
  std::vector<int> m_losses; // of each function, in units
  std::vector<std::uint16_t> m_numbers;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H
