// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * For each vertex a row of values, one for each of some functions, none of which differs in two vertices by more than
 * their distance and an error of its own: so these differences are lower bounds of the distance.
 *
 * A value is a whole number of units, rounded down, in two bytes. A difference is lowered by one unit for that, and by
 * another for the error of these divisions, which is far less. So is the error of distances along edges, as sums of
 * fewer than 2^31 lengths that are rounded by a part of 2^-53 each: 2^-6 units at most in two vertices.
 */
class Landmark_rows
{
public:
  Landmark_rows() = default;

  /* \param largest value that matters; larger ones count as this */
  Landmark_rows(std::size_t number_of_vertices, std::size_t number_of_functions, double largest)
    : m_unit(largest > 0 ? largest / largest_number : 1)
    , m_losses(number_of_functions, rounding_loss)
    , m_numbers(number_of_vertices * number_of_functions, unknown)
  {
  }

  std::size_t number_of_functions() const { return m_losses.size(); }

  /* By how much the values of a function may be wrong, together in two vertices. */
  void set_error(std::size_t i, double error)
  {
    m_losses[i] = static_cast<std::uint16_t>((std::min)(rounding_loss + std::ceil(error / m_unit), largest_number));
  }

  /* Those that are not set, or are infinite, say nothing. */
  void set(Vertex_index v, std::size_t i, double value)
  {
    const double number = (std::min)((std::max)(value / m_unit, 0.0), largest_number);
    m_numbers[static_cast<std::size_t>(v.idx()) * m_losses.size() + i] = static_cast<std::uint16_t>(number);
  }

  /* No path between the vertices is shorter. Of vertices of two components it is any number. */
  double distance_lower_bound(Vertex_index v, Vertex_index w) const
  {
    const std::uint16_t *const a = row(v), *const b = row(w), *const losses = m_losses.data();
    const std::size_t n = m_losses.size(), end_of_blocks = n - n % block_size;
    std::array<std::uint16_t, block_size> largest = {}; // of each place in a block
    for(std::size_t start = 0; start < end_of_blocks; start += block_size)
      for(std::size_t i = 0; i < block_size; ++i)
        largest[i] = (std::max)(largest[i], bound(a[start + i], b[start + i], losses[start + i]));
    for(std::size_t i = end_of_blocks; i < n; ++i)
      largest[0] = (std::max)(largest[0], bound(a[i], b[i], losses[i]));
    std::uint16_t result = 0;
    for(std::size_t i = 0; i < block_size; ++i)
      result = (std::max)(result, largest[i]);
    return m_unit * result;
  }

private:
  static constexpr std::uint16_t all_bits = 65535, unknown = all_bits;
  static constexpr double largest_number = unknown - 1;
  static constexpr std::uint16_t rounding_loss = 2;
  static constexpr std::size_t block_size = 8; // numbers in a vector register

  // Of a distance, in units. Arithmetic in 16 bits without branches is compiled into vector instructions.
  static std::uint16_t bound(std::uint16_t a, std::uint16_t b, std::uint16_t loss)
  {
    const std::uint16_t high = (std::max)(a, b), low = (std::min)(a, b);
    const std::uint16_t difference = static_cast<std::uint16_t>(high - low);
    const std::uint16_t lowered = static_cast<std::uint16_t>((std::max)(difference, loss) - loss);
    return static_cast<std::uint16_t>(lowered & (high == unknown ? 0 : all_bits));
  }

  const std::uint16_t* row(Vertex_index v) const
  {
    return m_numbers.data() + static_cast<std::size_t>(v.idx()) * m_losses.size();
  }

  double m_unit = 1;
  std::vector<std::uint16_t> m_losses; // of each function, in units
  std::vector<std::uint16_t> m_numbers;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_LANDMARK_ROWS_H
