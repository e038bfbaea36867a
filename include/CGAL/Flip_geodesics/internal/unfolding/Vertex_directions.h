// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VERTEX_DIRECTIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VERTEX_DIRECTIONS_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The directions at a vertex as angles, in radians, counterclockwise from an input halfedge, measured from the input:
 * what flips computed does not enter. On the border the angles start at the border. At a non-manifold vertex they are
 * those of one umbrella.
 */
template <class Triangulation>
class Vertex_directions
{
public:
  Vertex_directions(const Triangulation& triangulation, Vertex_index vertex)
    : m_triangulation(triangulation)
    , m_vertex(vertex)
  {
    if(triangulation.is_inserted(vertex))
      start_at(triangulation.location(vertex));
    else if(const Input_halfedge_index start = triangulation.input().outgoing(vertex); start != null_index)
      start_at_umbrella(start);
  }

  /* In the umbrella of an input halfedge that starts at the vertex. */
  Vertex_directions(const Triangulation& triangulation, Input_halfedge_index in_umbrella)
    : m_triangulation(triangulation)
    , m_vertex(triangulation.input().tail(in_umbrella))
  {
    start_at_umbrella(in_umbrella);
  }

  /* The sum of the input angles at the vertex. */
  double total() const { return m_total; }
  bool has_border() const { return m_has_border; }

  /* Is an input halfedge one of the umbrella? */
  bool has(Input_halfedge_index h) const { return std::find(m_spokes.begin(), m_spokes.end(), h) != m_spokes.end(); }

  /* The angle at which an input halfedge starts at the vertex.
   * \throws Invalid_mesh_error if it is one of another umbrella */
  double of_input(Input_halfedge_index h) const
  {
    const auto found = std::find(m_spokes.begin(), m_spokes.end(), h);
    if(found == m_spokes.end())
      throw Invalid_mesh_error("sheets of the surface meet in vertex " + std::to_string(m_vertex.idx()) +
                                   " only, so that directions there have no angles between them",
                               {static_cast<std::size_t>(m_vertex.idx())});
    return m_angles[static_cast<std::size_t>(found - m_spokes.begin())];
  }

  /* The angle of a strip that starts at the vertex. */
  double operator()(const Strip<Triangulation>& strip) const
  {
    if(!m_is_inside_face)
      return of_input(strip.reference()) + angle_from_reference(strip.end());
    const double angle = std::arg(strip.end());
    return angle < 0 ? angle + m_total : angle;
  }

  /* The angle of a halfedge of the triangulation that starts at the vertex. */
  double operator()(Halfedge_index h) const
  {
    return (*this)(Strip<Triangulation>(m_triangulation, m_triangulation.crossing_word(h)));
  }

  /* The smaller of the angles between two directions on their two sides; a side that holds the border is infinite. */
  double smaller_wedge(double a, double b) const
  {
    const double wedge = a < b ? b - a : a - b;
    return m_has_border ? wedge : (std::min)(wedge, m_total - wedge);
  }

  /* The angle counterclockwise from one direction to another; infinite if the border intervenes. */
  double counterclockwise(double from, double to) const
  {
    if(from <= to)
      return to - from;
    return m_has_border ? std::numeric_limits<double>::infinity() : to - from + m_total;
  }

private:
  // An inserted point: flat, with one direction of reference inside a face, and two along an edge.
  void start_at(const Surface_location& location)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    const Input_halfedge_index h = location.halfedge;
    m_is_inside_face = kind(location) == Location_kind::FACE;
    m_has_border = !m_is_inside_face && m_triangulation.input().is_border(twin_index(h));
    m_spokes = {h, twin_index(h)};
    m_angles = {0, pi};
    m_total = m_has_border ? pi : 2 * pi;
  }

  void start_at_umbrella(Input_halfedge_index start)
  {
    const auto& input = m_triangulation.input();
    Input_halfedge_index first = start;
    do { // clockwise up to the border, if there is one
      const Input_halfedge_index t = twin_index(first);
      m_has_border = input.is_border(t);
      first = m_has_border ? first : input.next(t);
    } while(!m_has_border && first != start);

    Input_halfedge_index h = first;
    do {
      m_spokes.push_back(h);
      m_angles.push_back(m_total);
      if(input.is_border(h))
        break;
      const Input_halfedge_index before = input.next(input.next(h));
      m_total += input_corner(m_triangulation, before);
      h = twin_index(before);
    } while(h != first);
  }

  const Triangulation& m_triangulation;
  Vertex_index m_vertex;
  std::vector<Input_halfedge_index> m_spokes;
  std::vector<double> m_angles;
  double m_total = 0;
  bool m_has_border = false, m_is_inside_face = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_VERTEX_DIRECTIONS_H
