// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERTEX_DIRECTIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERTEX_DIRECTIONS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <complex>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The directions at a vertex as angles in radians, counterclockwise from an input halfedge and measured on the input,
 * independently of the results of flips. On the border the angles start at the border. At a non-manifold vertex they
 * are those of one umbrella.
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
      m_fan = umbrella_of(triangulation, start);
  }

  /* For the umbrella of an input halfedge that starts at the vertex. */
  Vertex_directions(const Triangulation& triangulation, Input_halfedge_index in_umbrella)
    : m_triangulation(triangulation)
    , m_vertex(triangulation.input().tail(in_umbrella))
    , m_fan(umbrella_of(triangulation, in_umbrella))
  {
  }

  /* Returns the sum of the input angles at the vertex. */
  double total() const { return m_fan.total(); }
  bool has_border() const { return m_fan.has_border(); }

  /* Returns whether an input halfedge belongs to the umbrella. */
  bool has(Input_halfedge_index h) const { return m_fan.has(h); }

  /* Returns the angle at which an input halfedge starts at the vertex.
   * \throws Invalid_mesh_error if it belongs to another umbrella */
  double of_input(Input_halfedge_index h) const { return m_fan.angle_of(h, m_vertex); }

  /* Returns the angle of a strip that starts at the vertex. */
  double operator()(const Strip<Triangulation>& strip) const
  {
    if(!m_is_inside_face)
      return of_input(strip.reference()) + angle_from_reference(strip.end());
    const double angle = std::arg(strip.end());
    return angle < 0 ? angle + total() : angle;
  }

  /* Returns the angle of a halfedge of the triangulation that starts at the vertex. */
  double operator()(Halfedge_index h) const
  {
    return (*this)(Strip<Triangulation>(m_triangulation, m_triangulation.edge_sequence(h)));
  }

  /* Returns the angle counterclockwise from one direction to another; infinite if the border intervenes. */
  double counterclockwise(double from, double to) const { return m_fan.counterclockwise(from, to); }

private:
  // An inserted point is flat, with one reference direction inside a face and two along an edge.
  void start_at(const Surface_location& location)
  {
    const Input_halfedge_index h = location.halfedge;
    m_is_inside_face = kind(location) == Location_kind::FACE;
    m_fan.set_flat(h, !m_is_inside_face && m_triangulation.input().is_border(twin_index(h)));
  }

  const Triangulation& m_triangulation;
  Vertex_index m_vertex;
  Vertex_fan m_fan;
  bool m_is_inside_face = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_VERTEX_DIRECTIONS_H
