// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H

#include <CGAL/Flip_geodesics/Mollified_metric.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/surface/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/surface/check_vertex.h>
#include <CGAL/Flip_geodesics/internal/triangulation/umbrellas.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* A* over the edges of a triangulation as it is now. Unlike `Shortest_edge_path`, it copies the faces that it visits. */
template <class Triangulation>
class Intrinsic_edge_search
{
  using Point = typename Metric_point<typename Triangulation::Metric>::type;
  static constexpr bool has_points = !std::is_void<Point>::value;

public:
  Intrinsic_edge_search(const Triangulation& triangulation, Vertex_index target)
    : m_triangulation(triangulation)
    , m_target(target)
    , m_labels(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  std::vector<Halfedge_index> operator()(Vertex_index source)
  {
    m_labels[source].arriving_plus_one = no_edge;
    m_queue.push({lower_bound(source), source});
    while(!m_queue.empty()) {
      const Vertex_index v = m_queue.top().second;
      m_queue.pop();
      if(m_labels[v].is_settled)
        continue;
      m_labels[v].is_settled = true;
      if(v == m_target)
        return path(source);
      relax_spokes(v);
    }
    return {};
  }

private:
  static constexpr Index no_edge = -1;

  struct Label
  {
    double distance;
    Index arriving_plus_one; // halfedge; 0 if not reached
    bool is_settled;
  };

  using Entry = std::pair<double, Vertex_index>;

  void relax_spokes(Vertex_index v)
  {
    const Halfedge_index start = m_triangulation.outgoing(v);
    if(start == null_index)
      return;
    Halfedge_index h = start, first = start;
    do {
      relax(v, h);
      first = h;
      h = m_triangulation.counterclockwise(h);
    } while(h != null_index && h != start);
    if(h == start)
      return;
    for(h = m_triangulation.clockwise(start); h != null_index; h = m_triangulation.clockwise(h))
      relax(v, h);
    for_each_spoke_of_other_umbrellas(m_triangulation, first, [&](Halfedge_index g) { relax(v, g); });
  }

  void relax(Vertex_index v, Halfedge_index h)
  {
    const Vertex_index w = m_triangulation.head(h);
    const double distance = m_labels[v].distance + m_triangulation.length(h);
    Label& label = m_labels[w];
    if(label.is_settled || (label.arriving_plus_one != 0 && label.distance <= distance))
      return;
    label.distance = distance;
    label.arriving_plus_one = h.idx() + 1;
    m_queue.push({distance + lower_bound(w), w});
  }

  double lower_bound(Vertex_index v) const
  {
    if constexpr(has_points) {
      const Point p = point(v), q = point(m_target);
      const double x = CGAL::to_double(q.x() - p.x()), y = CGAL::to_double(q.y() - p.y()),
                   z = CGAL::to_double(q.z() - p.z());
      return std::sqrt(internal::unfused(x * x) + internal::unfused(y * y) + internal::unfused(z * z));
    } else {
      return static_cast<void>(v), 0;
    }
  }

  auto point(Vertex_index v) const
  {
    return point_in_space(m_triangulation, surface_point_at_vertex(m_triangulation, v));
  }

  std::vector<Halfedge_index> path(Vertex_index source) const
  {
    std::vector<Halfedge_index> result;
    for(Vertex_index v = m_target; v != source; v = m_triangulation.tail(result.back()))
      result.push_back(Halfedge_index(m_labels[v].arriving_plus_one - 1));
    std::reverse(result.begin(), result.end());
    return result;
  }

  const Triangulation& m_triangulation;
  Vertex_index m_target;
  Indexed_by<Vertex_index, Lazy_array<Label>> m_labels;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * The halfedges of a shortest path along edges of the triangulation as it is now, between any two of its vertices; none
 * if they are equal. It serves where `Shortest_edge_path`, which knows the input's edges only, does not: from and to
 * inserted vertices, and in flipped triangulations.
 *
 * Of equally long paths, the same one is found each time. \f$O(k \log k)\f$ for the \f$k\f$ vertices visited.
 *
 * \throws Vertex_out_of_range_error
 * \throws Disconnected_endpoints_error
 * \throws Degenerate_face_error, Invalid_coordinate_error for a face that the search meets
 */
template <class Triangulation>
std::vector<Halfedge_index> shortest_intrinsic_edge_path(const Triangulation& triangulation, Vertex_index source,
                                                         Vertex_index target)
{
  for(Vertex_index v : {source, target})
    internal::check_vertex(v, triangulation.number_of_vertices());
  if(source == target)
    return {};
  std::vector<Halfedge_index> path = internal::Intrinsic_edge_search<Triangulation>(triangulation, target)(source);
  if(path.empty())
    throw Disconnected_endpoints_error(
        "no path of edges joins vertex " + std::to_string(source.idx()) + " and vertex " + std::to_string(target.idx()),
        {static_cast<std::size_t>(source.idx()), static_cast<std::size_t>(target.idx())});
  return path;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H
