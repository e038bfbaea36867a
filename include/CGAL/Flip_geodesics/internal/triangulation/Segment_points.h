// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SEGMENT_POINTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SEGMENT_POINTS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Face_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The vertices by which refinement has split edges that were constrained at first, the *segments*. */
template <class Triangulation>
class Segment_points
{
public:
  /* On a segment: its ends, and how far they are. */
  struct Point
  {
    std::array<Vertex_index, 2> ends;
    std::array<double, 2> distances;
  };

  explicit Segment_points(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  void add(Vertex_index v, const Point& point) { m_points[v] = point; }

  /* What a vertex will be that is to split the edge of h, as far from its tail as `length`. */
  Point point(Halfedge_index h, double length) const
  {
    const std::array<Vertex_index, 2> at = {m_triangulation.tail(h), m_triangulation.head(h)};
    const std::array<double, 2> halves = {length, m_triangulation.length(h) - length};
    Point result;
    for(int i = 0; i < 2; ++i) {
      result.ends[i] = at[i];
      result.distances[i] = halves[i];
      const auto found = m_points.find(at[i]);
      if(found == m_points.end())
        continue;
      const Point& old = found->second;
      const int beyond = end_beyond(old, at[1 - i]);
      result.ends[i] = old.ends[beyond];
      result.distances[i] += old.distances[beyond];
    }
    return result;
  }

  /* Does h lead from one segment to another that shares an end with it, at equal distances from there? */
  bool spans_small_angle(Halfedge_index h) const
  {
    const auto p = m_points.find(m_triangulation.tail(h)), q = m_points.find(m_triangulation.head(h));
    if(p == m_points.end() || q == m_points.end() || is_constrained_edge(m_triangulation, h))
      return false;
    for(int i = 0; i < 2; ++i)
      for(int j = 0; j < 2; ++j) {
        const double a = p->second.distances[i], b = q->second.distances[j];
        if(p->second.ends[i] == q->second.ends[j] && std::abs(a - b) < 0.2 * (std::min)(a, b))
          return true;
      }
    return false;
  }

private:
  // The end of the point's segment that does not lie towards vertex v, another vertex of the segment.
  int end_beyond(const Point& point, Vertex_index v) const
  {
    const auto found = m_points.find(v);
    if(found == m_points.end())
      return point.ends[0] == v ? 1 : 0;
    const int same = found->second.ends[0] == point.ends[0] ? 0 : 1;
    return found->second.distances[same] > point.distances[0] ? 0 : 1;
  }

  const Triangulation& m_triangulation;
  std::unordered_map<Vertex_index, Point> m_points;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_SEGMENT_POINTS_H
