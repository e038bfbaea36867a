// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_PRECISE_UNFOLDED_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_PRECISE_UNFOLDED_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/numbers/Precise_number.h>
#include <CGAL/Flip_geodesics/internal/surface/Block_array.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Precise_face.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The faces of `Unfolded_faces`, under the same numbers, in double-double arithmetic: lengths and directions of sides
 * err by at most `Number_rounding<Precise_number>::unit`. What kind of vertex a search passes does not need it.
 */
template <class Triangulation>
class Precise_unfolded_faces
{
  using Faces = Unfolded_faces<Triangulation>;

public:
  using Number = Precise_number;
  using Vector = Precise_vector;
  using Direction = typename Faces::Direction;

  /* A halfedge, and the angle at its tail in the face on its left. */
  struct Side
  {
    Number length, cosine, sine;
    Input_halfedge_index halfedge;
    Vertex_index tail;
    bool is_known = false;
  };

  Precise_unfolded_faces(const Triangulation& triangulation, Faces& faces)
    : m_triangulation(triangulation)
    , m_faces(faces)
  {
  }

  /* The number of h as a side. \pre h is not on the border
   * \throws Degenerate_face_error also for a face whose numbers have no bound; otherwise as `Unfolded_faces` */
  Index number(Input_halfedge_index h)
  {
    const Index side = m_faces.number(h);
    if(m_sides.size() < m_faces.size())
      m_sides.resize(m_faces.size(), Side());
    if(!(*this)[side].is_known)
      for(const Index s : {next(side), previous(side), side})
        lay_out(s);
    return side;
  }

  /* \pre its face has been laid out, which `number()` does */
  const Side& operator[](Index side) const { return m_sides[static_cast<std::size_t>(side)]; }
  static Index next(Index side) { return Faces::next(side); }
  static Index previous(Index side) { return Faces::previous(side); }
  std::size_t size() const { return m_sides.size(); }

  Vector apex(Index side) const
  {
    const Side& s = (*this)[side];
    return (*this)[previous(side)].length * Vector(s.cosine, s.sine);
  }

  Number length(Input_halfedge_index h)
  {
    return (*this)[number(m_triangulation.input().is_border(h) ? twin_index(h) : h)].length;
  }

  bool is_passable(Vertex_index v) { return m_faces.is_passable(v); }
  bool is_flat(Vertex_index v) { return m_faces.is_flat(v); }
  double nearest_edge(Vertex_index v) { return m_faces.nearest_edge(v); }
  double angle_between(const Direction& a, const Direction& b, double tolerance)
  {
    return m_faces.angle_between(a, b, tolerance);
  }

private:
  // The direction of the next halfedge turns by the outer angle at the head; the inner one is that at the next tail.
  void lay_out(Index number)
  {
    const auto& before = m_faces[previous(number)];
    const auto& here = m_faces[number];
    const Precise_halfedge side = precise_input_halfedge(m_triangulation, here.halfedge);
    const Precise_halfedge turn = precise_input_halfedge(m_triangulation, before.halfedge);
    if(!(side.error <= Number_rounding<Number>::unit && turn.error <= Number_rounding<Number>::unit))
      throw Degenerate_face_error("the sides of a face are too long or too short for a bound of their errors", {});
    m_sides[static_cast<std::size_t>(number)] = {
        Number(side.length), -Number(turn.next.x), Number(turn.next.y), here.halfedge, here.tail, true};
  }

  const Triangulation& m_triangulation;
  Faces& m_faces;
  Block_array<Side> m_sides;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_PRECISE_UNFOLDED_FACES_H
