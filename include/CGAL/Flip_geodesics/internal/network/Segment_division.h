// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_DIVISION_H
#define CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_DIVISION_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/network/Segment_store.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <cmath>
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

  /*
   * Divides segment s and those beside it; returns the first half of s. The point is rounded to a location in one of
   * the input faces that the edge crosses, and lies on the edge by definition from then on.
   *
   * An edge that was divided before and was straightened since can have the old point beside it, off by rounding: it is
   * the apex of a sliver that holds no vertex. There the segments are moved over the sliver, which is flipped away.
   *
   *       x                        x
   *    /     .                  /  |  .
   *   a ----- b      ==>       a   |   b
   *    .     /                  .  |  /
   *       d                        d
   */
  Segment_index divide(Segment_index s, double t)
  {
    for(int i = 0; i < most_slivers; ++i) {
      const Sliver sliver = sliver_beside(m_segments.halfedge(s));
      if(sliver.halfedge == null_index)
        break;
      const bool is_along = sliver.halfedge == m_segments.halfedge(s);
      const double at = is_along ? sliver.place : 1 - sliver.place; // of its apex, along s
      const Segment_index first = move_to_apex(sliver.halfedge, s);
      if(std::abs(t - at) <= on_divided_line)
        return first;
      s = t < at ? first : m_segments.next(first);
      t = t < at ? t / at : (t - at) / (1 - at);
    }
    const Halfedge_index h = m_segments.halfedge(s);
    const Crossing_word word = m_triangulation.crossing_word(h);
    Location_finder<Triangulation> finder(m_triangulation);
    finder.look_along(word, t);
    Segment_index half = null_index;
    m_triangulation.split_edge(h, word.along != null_index ? finder.result() : finder.result_inside(), finder.gap(),
                               [&](const auto& halves) { half = this->divide_stack(halves, s); });
    return half;
  }

private:
  static constexpr int most_slivers = 64;

  // A face on the left of a halfedge whose apex is next to the halfedge, that part of the way along it.
  struct Sliver
  {
    Halfedge_index halfedge = null_index;
    double place = 0;
  };

  // As Segment_store::divide_stack(); \throws Occupied_triangulation_error if another network holds the edge
  template <class Edge_halves>
  Segment_index divide_stack(const Edge_halves& halves, Segment_index watched = null_index)
  {
    const Index own_holds = m_segments.leftmost(m_triangulation.walker(halves.first)).idx() != 0 ? 1 : 0;
    if(m_triangulation.holds(Triangulation::edge(halves.first)) > own_holds)
      throw Occupied_triangulation_error("a curve of another network lies on the edge that is to be split");
    return m_segments.divide_stack(halves.first, {{halves.first, halves.second}}, watched);
  }

  Sliver sliver_beside(Halfedge_index h) const
  {
    for(Halfedge_index side : {h, Triangulation::twin(h)}) {
      if(m_triangulation.is_border(side))
        continue;
      const Halfedge_index to_apex = Triangulation::twin(m_triangulation.previous(side));
      const double place = m_triangulation.length(to_apex) / m_triangulation.length(side);
      if(place < 1 - on_divided_line && wedge_angle(m_triangulation, to_apex, side).value * place <= on_divided_line)
        return {side, place};
    }
    return {};
  }

  // Moves the segments on the edge of h over the apex on its left.
  Segment_index move_to_apex(Halfedge_index h, Segment_index watched)
  {
    const Segment_index result = m_segments.divide_stack(
        h, {{Triangulation::twin(m_triangulation.previous(h)), Triangulation::twin(m_triangulation.next(h))}}, watched);
    if(m_triangulation.is_flippable(h))
      m_triangulation.flip(h);
    return result;
  }

  Triangulation& m_triangulation;
  Segment_store<Triangulation>& m_segments;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_NETWORK_SEGMENT_DIVISION_H
