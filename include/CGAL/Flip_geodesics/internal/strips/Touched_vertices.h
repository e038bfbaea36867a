// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRIPS_TOUCHED_VERTICES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRIPS_TOUCHED_VERTICES_H

#include <CGAL/Flip_geodesics/internal/exact/Exact_input_faces.h>
#include <CGAL/Flip_geodesics/internal/exact/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/exact/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/internal/input/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/strips/Wedge_angle.h>

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
 * it. The segment passes a touched vertex with an angle of pi on its own side; it is locally shortest there if the
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
    m_edges.push_back({h, from, to});
    for(; m_next < m_edges.size(); ++m_next) {
      const Edge e = m_edges[m_next];
      add_beyond(e);
      add_beyond({twin_index(e.halfedge), e.to, e.from});
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

  // The face on the left of an edge, if it has no area, and its other sides.
  void add_beyond(const Edge& e)
  {
    const auto& input = m_triangulation.input();
    if(is_outside((std::max)(e.from, e.to), (std::min)(e.from, e.to)) || input.is_border(e.halfedge) ||
       !has_no_area(e.halfedge))
      return;
    const Input_halfedge_index hn = input.next(e.halfedge), hp = input.next(hn);
    const Vertex_index apex = input.tail(hp);
    const Exact_face& face = m_faces(e.halfedge);
    const double share = -static_cast<double>(face.dot_previous) / static_cast<double>(face.squared_length);
    const double at_apex = e.from + share * (e.to - e.from);
    if(!is_outside(at_apex, at_apex) && apex != m_tail && apex != m_head)
      m_vertices.push_back(apex);
    for(const Edge& side : {Edge{twin_index(hn), at_apex, e.to}, Edge{twin_index(hp), e.from, at_apex}})
      if(!is_known(side.halfedge))
        m_edges.push_back(side);
  }

  // Beyond an end of the segment; in doubt not.
  bool is_outside(double largest, double smallest) const
  {
    const double tolerance = 1e-9 * m_length;
    return largest < -tolerance || smallest > m_length + tolerance;
  }

  bool is_known(Input_halfedge_index h) const
  {
    const auto has_edge = [h](const Edge& e) { return are_of_one_edge(e.halfedge, h); };
    return std::any_of(m_edges.begin(), m_edges.end(), has_edge);
  }

  bool has_no_area(Input_halfedge_index h) const
  {
    constexpr double error = 64 * std::numeric_limits<double>::epsilon(); // of a layout, generously
    const auto face = input_face_geometry(m_triangulation, h);
    if(face[1].y > error * std::abs(face[1].x))
      return false;
    return m_faces(h).doubled_area_squared == 0;
  }

  // Do the angles at an input vertex sum up to 2 pi or more, or is it on the border? Tells what they are in excess of it.
  bool has_full_angle(Vertex_index v, double& excess) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index first = input.outgoing(v);
    double sum = 0;
    Index count = 0;
    for(Input_halfedge_index h = first; count == 0 || h != first; ++count) {
      const Input_halfedge_index t = twin_index(h);
      if(input.is_border(t))
        return true;
      sum += input_corner(m_triangulation, t);
      h = input.next(t);
    }
    excess = sum - 2 * boost::math::constants::pi<double>();
    if(std::abs(excess) > (count + 4) * input_corner_error)
      return excess > 0;
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    return Exact_sign(m_statistics)({unfolding.corners(first, count)}) != NEGATIVE;
  }

  const Triangulation& m_triangulation;
  Exact_input_faces<Triangulation> m_faces;
  Vertex_index m_tail, m_head;
  double m_length;
  Decision_statistics& m_statistics;
  std::vector<Vertex_index> m_vertices;
  std::vector<Edge> m_edges;
  std::size_t m_next = 0; // of the edges whose sides have not been looked at
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRIPS_TOUCHED_VERTICES_H
