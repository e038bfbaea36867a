// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_SLEEVE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_SLEEVE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Funnel.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Input_faces.h>

#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * An input edge that a path crosses, as a side of the face that is left, with its tail on the right; and the shape of the
 * face beyond. The shape is computed when a sleeve is first unfolded across the edge, and kept, so that unfolding the
 * edge again takes one complex product.
 */
struct Sleeve_edge
{
  /* \param h the halfedge; its face beyond is not laid out yet */
  Sleeve_edge(Input_halfedge_index h)
    : crossed(h)
  {
  }
  explicit operator Input_halfedge_index() const { return crossed; }

  Input_halfedge_index crossed;
  Input_halfedge_index right_side = null_index; // of the face beyond, as seen from the edge; null until it is laid out
  Plane_vector corner = 0;                      // the third corner of the face beyond, if the edge leads from 1 to 0
};

/*
 * The sleeve of a path: the faces of the input that it passes, unfolded into the plane in doubles, with the crossed edges
 * as portals; and the shortest path within the sleeve.
 */
template <class Triangulation>
class Sleeve
{
public:
  using Bend = Funnel::Bend;

  Sleeve(const Triangulation& triangulation, Refused_faces refused)
    : m_triangulation(triangulation)
    , m_faces(triangulation, refused)
  {
  }

  Input_faces<Triangulation>& faces() { return m_faces; }
  const Input_faces<Triangulation>& faces() const { return m_faces; }

  /* The crossed edges, in order. After a change, the sleeve has to be unfolded again. */
  std::vector<Sleeve_edge>& edges() { return m_edges; }
  const std::vector<Sleeve_edge>& edges() const { return m_edges; }

  /* Unfolds the faces with the right end of the first crossed edge at the origin, and the edge on the positive real
   * axis. \pre edges are crossed, and two vertices, in the first and the last face, are not at any of them */
  void unfold(Vertex_index tail, Vertex_index head)
  {
    for(Sleeve_edge& edge : m_edges)
      if(edge.right_side == null_index)
        lay_out_face_beyond(edge);
    const Input_halfedge_index first = m_edges.front().crossed;
    const double length = m_faces.length(first);
    m_tail_place = length * place_in_face(tail, first, m_triangulation.is_inserted(tail) ? 0 : m_faces.corner(first));
    const Plane_vector place = place_in_face(head, twin_index(m_edges.back().crossed), m_edges.back().corner);
    unfold_portals(length, place);
  }

  /* Pulls the string from tail to head within the unfolded sleeve. Returns where it bends. */
  const std::vector<Bend>& pull()
  {
    m_funnel.pull(m_portals, m_tail_place, m_head_place);
    return m_funnel.bends();
  }

  /* The crossed edges in the plane, and the places of the tail and the head. */
  const std::vector<Portal>& portals() const { return m_portals; }
  const Plane_vector& tail_place() const { return m_tail_place; }
  const Plane_vector& head_place() const { return m_head_place; }

  /* The bends of the string that was pulled last. */
  const std::vector<Bend>& bends() const { return m_funnel.bends(); }

  /* The vertex of a bend. */
  Vertex_index vertex(const Bend& bend) const
  {
    const Input_halfedge_index h = m_edges[bend.first].crossed;
    return bend.side == RIGHT_END ? m_faces.tail(h) : m_faces.head(h);
  }

  /* The direction of the line between two places at the first one, in the face before portal `first`. */
  Corner_direction direction_at_tail(std::size_t first, const Plane_vector& from, const Plane_vector& to) const
  {
    return {m_faces.previous(m_edges[first].crossed),
            rotation(Funnel::end(m_portals, first, RIGHT_END) - from, to - from)};
  }

  /* Its direction backward at the second one, in the face behind portal `last`. */
  Corner_direction direction_at_head(std::size_t last, const Plane_vector& from, const Plane_vector& to) const
  {
    return {m_faces.previous(twin_index(m_edges[last].crossed)),
            rotation(Funnel::end(m_portals, last, LEFT_END) - to, from - to)};
  }

  /* The direction from a vertex to a point in a face that has both: no direction if the vertex is inserted. */
  Corner_direction direction_in_face(Vertex_index v, Vertex_index to, Input_halfedge_index face) const
  {
    if(m_triangulation.is_inserted(v))
      return {};
    const Input_halfedge_index outgoing = anchor(m_triangulation, v, face);
    const auto w = vertex_weights(m_triangulation, to, outgoing);
    return {outgoing, rotation(1, w[1] + w[2] * m_faces.corner(outgoing))};
  }

private:
  void lay_out_face_beyond(Sleeve_edge& edge) const
  {
    const Input_halfedge_index entered = twin_index(edge.crossed);
    edge.corner = m_faces.corner(entered);
    edge.right_side = m_faces.next(entered);
  }

  // The place of a vertex in the face of h, where h leads from 0 to 1; an input vertex is at the given third corner.
  Plane_vector place_in_face(Vertex_index v, Input_halfedge_index h, const Plane_vector& corner) const
  {
    if(!m_triangulation.is_inserted(v))
      return corner;
    const auto w = vertex_weights(m_triangulation, v, h);
    return (w[1] + w[2] * m_faces.corner(h)) / (w[0] + w[1] + w[2]);
  }

  // The first crossed edge has a length, and the head a place in the last face, as seen from the last edge. From portal
  // to portal there is one product to wait for, and no branch, since sides follow no pattern that a processor could guess.
  void unfold_portals(double length, const Plane_vector& head_in_last_face)
  {
    static constexpr double is_side[2][2] = {{1, 0}, {0, 1}};
    m_portals.resize(m_edges.size());
    m_portals.front() = {length, LEFT_END};
    double left_x = length, left_y = 0, across_x = -length, across_y = 0; // from there to the right end
    const std::size_t last = m_edges.size() - 1;
    for(std::size_t i = 0; i < last; ++i) {
      const double x = m_edges[i].corner.real(), y = m_edges[i].corner.imag();
      const double apex_x = unfused(across_x * x) - unfused(across_y * y);
      const double apex_y = unfused(across_x * y) + unfused(across_y * x);
      const bool is_right = m_edges[i + 1].crossed != m_edges[i].right_side;
      m_portals[i + 1] = {{left_x + apex_x, left_y + apex_y}, is_right ? RIGHT_END : LEFT_END};
      const double on_right = is_side[is_right][1], on_left = is_side[is_right][0];
      left_x += unfused(on_left * apex_x);
      left_y += unfused(on_left * apex_y);
      const double turn_x = on_left + unfused((on_right - on_left) * x), turn_y = (on_right - on_left) * y;
      const double next_x = unfused(across_x * turn_x) - unfused(across_y * turn_y);
      across_y = unfused(across_x * turn_y) + unfused(across_y * turn_x);
      across_x = next_x;
    }
    m_head_place = Plane_vector(left_x, left_y) + product({across_x, across_y}, head_in_last_face);
  }

  // From one vector counterclockwise to another, which lies there but for rounding errors.
  static Plane_vector rotation(const Plane_vector& from, const Plane_vector& to)
  {
    const Plane_vector result = product(std::conj(from), to);
    return result.imag() > 0 ? result / magnitude(result) : 1;
  }

  const Triangulation& m_triangulation;
  Input_faces<Triangulation> m_faces;
  std::vector<Sleeve_edge> m_edges;
  std::vector<Portal> m_portals;
  Plane_vector m_tail_place, m_head_place;
  Funnel m_funnel;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_SLEEVE_H
