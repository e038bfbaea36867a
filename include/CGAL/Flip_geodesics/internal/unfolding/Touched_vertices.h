// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_TOUCHED_VERTICES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_TOUCHED_VERTICES_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * What keeps a word's line from being a path that is locally shortest: an end of the crossed edge of that number, which
 * is on the wrong side; or a vertex on the line, whose angles lack so much to 2 pi, rounded.
 */
struct Strip_obstacle
{
  Vertex_index vertex = null_index;
  std::size_t gate = 0;
  double missing_angle = 0;
};

/*
 * The vertices at distance zero from the inside of a straight segment, as there are where faces without area lie along
 * it. They are found by going straight across such faces, from each part of an edge that has been reached. The segment passes a touched vertex with an angle of pi on its own side; it is locally shortest there if the
 * angle on the other side is at least pi as well, that is, if the angles at the vertex sum up to at least 2 pi.
 */
template <class Triangulation>
class Touched_vertices
{
public:
  /* For a segment of the given length between two vertices. */
  Touched_vertices(const Triangulation& triangulation, Vertex_index tail, Vertex_index head, double length,
                   Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_faces(triangulation)
    , m_tail(tail)
    , m_head(head)
    , m_length(length)
    , m_statistics(statistics)
  {
  }

  /* Adds an end of a crossed edge that lies on the segment. */
  void add_vertex(Vertex_index v) { m_vertices.push_back(v); }

  /* Adds an input edge on the line of the segment, from one to another distance from the segment's tail. */
  void add_edge(Input_halfedge_index h, double from, double to)
  {
    add_part({h, from, to}, {{0, m_tail}, {m_length, m_head}});
    for(; m_next < m_parts.size(); ++m_next) {
      const Part part = m_parts[m_next];
      const Edge& e = part.edge;
      add_beyond(e, part.reached);
      add_beyond({twin_index(e.halfedge), e.to, e.from}, part.reached);
    }
  }

  /* The first that is not is the obstacle. */
  bool are_passed_straight(Strip_obstacle& obstacle) const
  {
    for(Vertex_index v : m_vertices) {
      double excess = 0;
      if(!has_full_angle(v, excess)) {
        obstacle.vertex = v;
        obstacle.missing_angle = (std::max)(-excess, 0.0);
        return false;
      }
    }
    return true;
  }

private:
  struct Edge
  {
    Input_halfedge_index halfedge;
    double from, to;
  };

  // Of the segment's line, between places of vertices.
  struct Interval
  {
    struct End
    {
      double at;
      Vertex_index vertex;
    };
    End low, high;
  };

  struct Part
  {
    Edge edge;
    Interval reached;
  };

  Interval interval_of(const Edge& e) const
  {
    const auto& input = m_triangulation.input();
    const typename Interval::End tail = {e.from, input.tail(e.halfedge)},
                                 head = {e.to, input.tail(twin_index(e.halfedge))};
    return e.from < e.to ? Interval{tail, head} : Interval{head, tail};
  }

  // What of an interval lies on an edge, unless it is no more than a vertex.
  void add_part(const Edge& e, const Interval& reached)
  {
    const Interval whole = interval_of(e);
    const Interval part = {whole.low.at > reached.low.at ? whole.low : reached.low,
                           whole.high.at < reached.high.at ? whole.high : reached.high};
    if(part.low.vertex != part.high.vertex && part.low.at < part.high.at + tolerance() && !is_known(e, part))
      m_parts.push_back({e, part});
  }

  // The face on the left of an edge, if it has no area, and what of its other sides lies across.
  void add_beyond(const Edge& e, const Interval& reached)
  {
    const auto& input = m_triangulation.input();
    if(input.is_border(e.halfedge) || !has_no_area(e.halfedge))
      return;
    const Input_halfedge_index hn = input.next(e.halfedge), hp = input.next(hn);
    const Vertex_index apex = input.tail(hp);
    const Exact_face& face = m_faces(e.halfedge);
    const double share = -static_cast<double>(face.dot_previous) / static_cast<double>(face.squared_length);
    const double at_apex = e.from + share * (e.to - e.from);
    if(at_apex > reached.low.at - tolerance() && at_apex < reached.high.at + tolerance() && apex != m_tail &&
       apex != m_head)
      m_vertices.push_back(apex);
    add_part({twin_index(hn), at_apex, e.to}, reached);
    add_part({twin_index(hp), e.from, at_apex}, reached);
  }

  // In doubt two places are one.
  double tolerance() const { return touched_vertex_tolerance * m_length; }

  bool is_known(const Edge& e, const Interval& part) const
  {
    return std::any_of(m_parts.begin(), m_parts.end(), [&](const Part& known) {
      return are_of_one_edge(known.edge.halfedge, e.halfedge) && known.reached.low.at <= part.low.at + tolerance() &&
             known.reached.high.at >= part.high.at - tolerance();
    });
  }

  bool has_no_area(Input_halfedge_index h) const
  {
    const auto face = input_face_geometry(m_triangulation, h);
    if(face[1].y > flat_layout_error * std::abs(face[1].x))
      return false;
    return m_faces(h).doubled_area_squared == 0;
  }

  // Do the angles at an input vertex sum up to 2 pi or more, or is it on the border? Tells what they are in excess of it.
  bool has_full_angle(Vertex_index v, double& excess) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index first = input.outgoing(v);
    const Index count = number_of_corners_clockwise(input, first, first);
    if(count < 0)
      return true;
    double sum = 0;
    for_each_corner_clockwise(input, first, count,
                              [&](Input_halfedge_index t) { sum += input_corner(m_triangulation, t); });
    excess = sum - 2 * boost::math::constants::pi<double>();
    if(std::abs(excess) > (count + 4) * input_corner_error)
      return excess > 0;
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    return Exact_sign(m_statistics, sign_work_limit(m_triangulation))({unfolding.corners(first, count)}) != NEGATIVE;
  }

  const Triangulation& m_triangulation;
  Exact_input_faces<Triangulation> m_faces;
  Vertex_index m_tail, m_head;
  double m_length;
  Decision_statistics& m_statistics;
  std::vector<Vertex_index> m_vertices;
  std::vector<Part> m_parts;
  std::size_t m_next = 0; // of the parts beyond which nothing has been looked at
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_TOUCHED_VERTICES_H
