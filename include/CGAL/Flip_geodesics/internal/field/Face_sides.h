// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FIELD_FACE_SIDES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FIELD_FACE_SIDES_H

#include <CGAL/Flip_geodesics/internal/base/Lazy_array.h>
#include <CGAL/Flip_geodesics/internal/input/input_face_geometry.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A face in the frame of one of its sides, halfedge h: it starts at the origin and runs along the x-axis, the face is
 * above. What a window needs to cross it, in one cache line.
 */
struct Face_side
{
  double length;
  double x, y;         // of the vertex opposite
  double cosine, sine; // of the angle at the tail
  Input_halfedge_index next;
  Vertex_index tail;
};

/* The sides of the faces of the input, computed when a face is first asked for. */
template <class Triangulation>
class Face_sides
{
public:
  explicit Face_sides(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_sides(static_cast<std::size_t>(triangulation.number_of_halfedges()))
  {
  }

  /* \pre h is not on the border. \throws as the metric, Invalid_mesh_error */
  const Face_side& operator()(Input_halfedge_index h)
  {
    if(m_sides[h].length == 0)
      compute(h);
    return m_sides[h];
  }

  /* The same of a face that has been asked for. */
  const Face_side& known(Input_halfedge_index h) const { return m_sides[h]; }

  /* Of any face, as a copy. */
  Face_side copy(Input_halfedge_index h) const { return m_sides[h].length == 0 ? computed(h)[0] : m_sides[h]; }

  /* Was there a face so flat that rays can have been lost in it? */
  bool has_flat_face() const { return m_has_flat_face; }

private:
  // Those of a face, from h on.
  std::array<Face_side, 3> computed(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation.input();
    const auto v = input_face_geometry(m_triangulation, h);
    const Input_halfedge_index hn = input.next(h), hp = input.next(hn);
    const double length = v[0].x, next = std::hypot(v[1].x, v[1].y), previous = std::hypot(v[2].x, v[2].y);
    const double height = v[1].y, x = length + v[1].x, area = length * height;
    const double xn = -length * v[1].x / next, xp = -(v[1].x * v[2].x + v[1].y * v[2].y) / previous;
    return {{{length, x, height, x / previous, height / previous, hn, input.tail(h)},
             {next, xn, area / next, xn / length, area / (next * length), hp, input.tail(hn)},
             {previous, xp, area / previous, xp / next, area / (previous * next), h, input.tail(hp)}}};
  }

  void compute(Input_halfedge_index h)
  {
    constexpr double flat = 1e-10;
    for(const Face_side& side : computed(h)) {
      m_sides[h] = side;
      m_has_flat_face = m_has_flat_face || !(side.y > flat * (side.length + std::abs(side.x)));
      h = side.next;
    }
  }

  const Triangulation& m_triangulation;
  Indexed_by<Input_halfedge_index, Lazy_array<Face_side>> m_sides;
  bool m_has_flat_face = false;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FIELD_FACE_SIDES_H
