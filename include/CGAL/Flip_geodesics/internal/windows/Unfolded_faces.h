// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_UNFOLDED_FACES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_UNFOLDED_FACES_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/base/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/input/input_face_geometry.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <complex>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The shapes of the input faces, for rays that are unfolded from face to face, and the vertices that shortest paths may
 * pass; each is computed when it is first asked for.
 *
 * Lengths and directions of sides are given, and no coordinates of corners: differences of coordinates would lose the
 * direction of a side that is short beside the others.
 */
template <class Triangulation>
class Unfolded_faces
{
public:
  using Vector = std::complex<double>;

  /* A halfedge, and the angle at its tail in the face on its left. */
  struct Side
  {
    double length, cosine, sine;
  };

  explicit Unfolded_faces(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_sides(static_cast<std::size_t>(triangulation.number_of_halfedges()))
    , m_is_passable(static_cast<std::size_t>(triangulation.number_of_vertices()))
  {
  }

  /* \pre h is not on the border \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error */
  const Side& side(Input_halfedge_index h)
  {
    if(m_sides[h].length == 0)
      lay_out(h);
    return m_sides[h];
  }

  /* The corner opposite to h, where h runs from 0 to its length on the real axis. */
  Vector apex(Input_halfedge_index h)
  {
    const Side& s = side(h);
    return side(previous(h)).length * Vector(s.cosine, s.sine);
  }

  /*
   * May a shortest path pass the vertex? Only on the border and where the angles add up to more than 2 pi; where they
   * nearly do, it counts as if they did.
   */
  bool is_passable(Vertex_index v)
  {
    char& known = m_is_passable[v];
    if(known == 0)
      known = is_convex(v) ? 2 : 1;
    return known == 1;
  }

private:
  Input_halfedge_index previous(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation.input();
    return input.next(input.next(h));
  }

  void lay_out(Input_halfedge_index h)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    const auto vectors = input_face_geometry(m_triangulation, h);
    const Vector a(vectors[0].x, vectors[0].y), b(vectors[1].x, vectors[1].y), c(vectors[2].x, vectors[2].y);
    const double la = a.real(), lb = std::sqrt(std::norm(b)), lc = std::sqrt(std::norm(c));
    m_sides[h] = {la, -c.real() / lc, b.imag() / lc};
    m_sides[hn] = {lb, -b.real() / lb, b.imag() / lb};
    // The sine of a small angle would not survive a product of the vectors.
    m_sides[hp] = {lc, -(b.real() * c.real() + b.imag() * c.imag()) / (lb * lc), la * b.imag() / (lb * lc)};
  }

  bool is_convex(Vertex_index v)
  {
    constexpr double tolerance = 1e-9; // towards vertices that are passed
    const auto& input = m_triangulation.input();
    const Input_halfedge_index first = input.outgoing(v);
    double total = 0;
    Input_halfedge_index h = first;
    do {
      if(input.is_border(h))
        return false;
      const Side& s = side(h);
      total += std::atan2(s.sine, s.cosine);
      h = twin_index(previous(h));
    } while(h != first);
    return total < boost::math::constants::two_pi<double>() - tolerance;
  }

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Side>> m_sides;
  Indexed_by<Vertex_index, Lazy_array<char>> m_is_passable;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_UNFOLDED_FACES_H
