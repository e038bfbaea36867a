// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_STRAIGHTNESS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_STRAIGHTNESS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/triangulation/wedge_between.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/enum.h>

#include <cmath>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Measures edges of a triangulation, and the wedges between them, from the input: of the results of flips, only
 * integers are used. The straightness of curves, chains of halfedges and paths of a tree is that of their edges and
 * joints.
 */
template <class Triangulation>
class Edge_straightness
{
public:
  using Measured_edge = internal::Measured_edge;

  explicit Edge_straightness(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Measured_edge operator()(Halfedge_index h) const
  {
    const Edge_sequence sequence = m_triangulation.edge_sequence(h);
    return measured(h, sequence, Strip<Triangulation>(m_triangulation, sequence));
  }

  /* Measures the edge of h and, if requested, determines whether it is straight. An edge sequence that is not that of a
   * strip between the ends of h is not measured. */
  Measured_edge certified(Halfedge_index h, bool is_asked, Decision_statistics& statistics) const
  {
    const Edge_sequence sequence = m_triangulation.edge_sequence(h);
    const Straight_strip<Triangulation> is_straight(m_triangulation, statistics);
    Measured_edge result;
    result.has_strip = is_strip(h, sequence);
    if(!result.has_strip)
      return result;
    const Strip<Triangulation> strip(m_triangulation, sequence);
    result = measured(h, sequence, strip);
    result.is_straight = !is_asked || is_straight(sequence, strip);
    return result;
  }

  /* Returns whether the given edge sequence of h is that of a strip from its tail to its head. */
  bool is_strip(Halfedge_index h, const Edge_sequence& sequence) const
  {
    Decision_statistics none;
    return sequence.tail == m_triangulation.tail(h) && sequence.head == m_triangulation.head(h) &&
           Straight_strip<Triangulation>(m_triangulation, none).is_strip(sequence);
  }

  /* Returns the angle clockwise from one halfedge of a vertex to another. */
  Wedge_angle clockwise(const Edge_end& from, const Edge_end& to) const
  {
    if(from.direction.reference == null_index || to.direction.reference == null_index)
      return wedge_angle(m_triangulation, from.halfedge, to.halfedge);
    const Index steps = m_triangulation.input_edges_in_wedge(from.halfedge, to.halfedge) + (from.is_along ? 1 : 0);
    return wedge_angle(m_triangulation, from.direction, to.direction, steps);
  }

  /* Returns whether such an angle is below pi, exactly. */
  bool is_below_straight(const Edge_end& from, const Edge_end& to, const Wedge_angle& angle,
                         Decision_statistics& statistics) const
  {
    const Comparison_result quick = angle.compare_with_straight();
    if(quick == EQUAL)
      return Wedge_comparison<Triangulation>(m_triangulation, statistics)(from.halfedge, to.halfedge) == SMALLER;
    ++statistics.by_strip;
    return quick == SMALLER;
  }

  /* See the free function of the same name. */
  static bool refresh_wedge(Triangulation& triangulation, Halfedge_index from, Halfedge_index to)
  {
    return internal::refresh_wedge(triangulation, from, to);
  }

private:
  static Measured_edge measured(Halfedge_index h, const Edge_sequence& sequence, const Strip<Triangulation>& strip)
  {
    const bool is_along = sequence.along != null_index;
    Measured_edge result = {{h, {}, is_along}, {Triangulation::twin(h), {}, is_along}, strip.bend()};
    if(strip.arrival_reference() != null_index) {
      result.tail.direction = tail_angle(strip);
      result.head.direction = {strip.arrival_reference(), angle_from_reference(strip.arrival()), strip.arrival_error()};
    }
    return result;
  }

  const Triangulation& m_triangulation;
};

} // namespace internal

/* Returns the object that measures the edges of a triangulation. Functions that shorten curves find this overload by
 * argument-dependent lookup and do not depend on exact arithmetic. */
template <class Triangulation>
internal::Edge_straightness<Triangulation> edge_straightness(const Triangulation& triangulation)
{
  return internal::Edge_straightness<Triangulation>(triangulation);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_EDGE_STRAIGHTNESS_H
