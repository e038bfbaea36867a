// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_DIVISION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_DIVISION_H

#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>

#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Inserts points into the triangulation of a network, and divides the segments on edges that are split. */
template <class Triangulation>
class Segment_division
{
public:
  Segment_division(Triangulation& triangulation, Segment_store<Triangulation>& segments)
    : m_triangulation(triangulation)
    , m_segments(segments)
  {
  }

  Vertex_index insert(const Surface_location& location, Known_piece* close_by)
  {
    return m_triangulation.insert(
        location, [this](const auto& halves) { this->divide_stack(halves); }, close_by);
  }

  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return m_triangulation.split_edge(h, location, gap, [this](const auto& halves) { this->divide_stack(halves); });
  }

private:
  // As Segment_store::divide_stack(); \throws Occupied_triangulation_error if another network holds the edge
  template <class Edge_halves>
  void divide_stack(const Edge_halves& halves)
  {
    const Index own_holds = m_segments.leftmost(m_triangulation.walker(halves.first)).idx() != 0 ? 1 : 0;
    if(m_triangulation.holds(Triangulation::edge(halves.first)) > own_holds)
      throw Occupied_triangulation_error("a curve of another network lies on the edge that is to be split");
    m_segments.divide_stack(halves.first, {{halves.first, halves.second}});
  }

  Triangulation& m_triangulation;
  Segment_store<Triangulation>& m_segments;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_DIVISION_H
