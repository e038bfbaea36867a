// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_WINDOW_LIMIT_H
#define CGAL_FLIP_GEODESICS_WINDOW_LIMIT_H

#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// How many windows a search for shortest paths may make, of some 60 bytes each, and along how many edges rays may start
/// from vertices; beyond either the search is given up.
class Window_limit
{
public:
  /// For \f$n\f$ vertices \f$10^6 + 500 n + 2 n^{3/2}\f$: several times the number for meshes whose faces are not needles. On smooth
  /// ones all distances from a vertex take up to about \f$0.7 n^{3/2}\f$.
  Window_limit() = default;

  /// At most about so many.
  explicit Window_limit(std::size_t windows)
    : m_windows(windows)
  {
  }

  /// The limit for a mesh with a number of vertices.
  std::size_t operator()(std::size_t number_of_vertices) const
  {
    const double n = static_cast<double>(number_of_vertices);
    return m_windows.value_or(static_cast<std::size_t>(1000000 + 500 * n + 2 * n * std::sqrt(n)));
  }

private:
  std::optional<std::size_t> m_windows;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_WINDOW_LIMIT_H
