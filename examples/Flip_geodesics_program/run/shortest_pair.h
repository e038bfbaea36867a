// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SHORTEST_PAIR_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SHORTEST_PAIR_H

#include "run/curve_engine.h"
#include "run/progress.h"

#include <CGAL/Flip_geodesics/shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace program {

/// A search of edge paths that notes how long it took, and what it found.
template <class Search>
class Noted_search
{
public:
  explicit Noted_search(Search& search)
    : m_search(search)
  {
  }

  template <class... Visitor>
  auto operator()(Vertex_index source, Vertex_index target, Visitor&&... visitor)
  {
    const Stopwatch stopwatch;
    const auto path = m_search(source, target, visitor...);
    m_seconds += stopwatch.seconds();
    m_segments = path.size();
    return path;
  }

  double seconds() const { return m_seconds; }
  std::size_t segments() const { return m_segments; }

private:
  Search& m_search;
  double m_seconds = 0;
  std::size_t m_segments = 0;
};

/// How many windows fit in so many bytes, and no more than a search makes on meshes without needles.
inline CGAL::Flip_geodesics::Window_limit window_limit(std::size_t number_of_vertices, std::size_t memory_limit)
{
  constexpr std::size_t bytes_per_window = 64;
  const std::size_t usual = CGAL::Flip_geodesics::Window_limit()(number_of_vertices);
  return CGAL::Flip_geodesics::Window_limit((std::min)(usual, memory_limit / bytes_per_window));
}

/// Adds the shortest of all paths between two vertices to an empty network. \param landmarks null if there are none
template <class Network, class Search, class Visitor>
CGAL::Flip_geodesics::Shortest_path_report add_shortest_pair(Network& network, Search& search,
                                                             const CGAL::Flip_geodesics::Geodesic_landmarks* landmarks,
                                                             const std::vector<Vertex_index>& ends,
                                                             std::size_t memory_limit, Visitor& visitor)
{
  namespace FG = CGAL::Flip_geodesics;
  const FG::Window_limit limit =
      window_limit(static_cast<std::size_t>(network.triangulation().number_of_vertices()), memory_limit);
  return landmarks == nullptr
             ? FG::add_shortest_path(network, search, ends[0], ends[1], CGAL::parameters::search_limit(limit),
                                     CGAL::parameters::visitor(std::ref(visitor)))
             : FG::add_shortest_path(network, search, ends[0], ends[1], CGAL::parameters::search_limit(limit),
                                     CGAL::parameters::landmarks(*landmarks),
                                     CGAL::parameters::visitor(std::ref(visitor)));
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SHORTEST_PAIR_H
