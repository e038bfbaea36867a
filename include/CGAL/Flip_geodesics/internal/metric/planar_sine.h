// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_METRIC_PLANAR_SINE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_METRIC_PLANAR_SINE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/exact/Orientation_of_places.h>
#include <CGAL/Flip_geodesics/internal/exact/Right_angle.h>
#include <CGAL/Flip_geodesics/internal/input/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/metric/Flat_edges.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The sign of the sine of a wedge whose input faces lie unfolded in one plane of space, by exact predicates of points;
 * or in two, in each of which the wedge has a right angle. These are the common cases of exact ties: the flat parts of
 * technical models, and their walls.
 *
 * PlaceOf maps an input vertex to three double coordinates. Words with an end elsewhere are left to others, since
 * the coordinates of such a point are no doubles.
 */
template <class Mesh, class PlaceOf>
class Planar_sine
{
  using Place = std::array<double, 3>;

public:
  Planar_sine(const Mesh& mesh, PlaceOf place_of, Flat_edges& flat_edges)
    : m_mesh(mesh)
    , m_place_of(place_of)
    , m_flat_edges(flat_edges)
  {
  }

  /*
   * The wedge leads from the direction of word a clockwise over `steps` input corners to that of word b, and is below
   * 2 pi. Returns false, and no sign, if its faces do not lie so.
   */
  bool operator()(const Crossing_word& a, const Crossing_word& b, Index steps, Sign& sine) const
  {
    const Vertex_index ends(m_mesh.number_of_vertices());
    if(a.tail >= ends || a.head >= ends || b.head >= ends)
      return false;
    Input_halfedge_index h = reference(a);
    const Input_halfedge_index some_face = a.along != null_index ? twin_index(h) : h;
    if(!is_flat(a) || !is_flat(b))
      return false;
    Input_halfedge_index crease = null_index;
    for(Index i = 0; i < steps; ++i) {
      const bool is_start = i == 0 && a.along != null_index;
      if(!is_start && !is_flat_across(h)) {
        if(crease != null_index)
          return false;
        crease = h;
      }
      h = m_mesh.next(twin_index(h));
    }
    const Place node = m_place_of(m_mesh.tail(reference(a))), end_a = m_place_of(head(a)), end_b = m_place_of(head(b));
    if(crease != null_index) {
      const Place end = m_place_of(m_mesh.tail(twin_index(crease)));
      sine = ZERO;
      return is_right_angle(node, end_a, end) && is_right_angle(node, end, end_b);
    }
    for(int axis = 0; axis < 3; ++axis) {
      const Sign face = orientation_along(axis, corner(some_face, 0), corner(some_face, 1), corner(some_face, 2));
      if(face == ZERO)
        continue;
      sine = face * orientation_along(axis, node, end_b, end_a);
      return true;
    }
    return false;
  }

private:
  Input_halfedge_index reference(const Crossing_word& word) const
  {
    return word.along != null_index ? word.along : m_mesh.next(m_mesh.next(word.crossed.front()));
  }

  Vertex_index head(const Crossing_word& word) const
  {
    return word.along != null_index ? m_mesh.tail(twin_index(word.along)) : apex(twin_index(word.crossed.back()));
  }

  Vertex_index apex(Input_halfedge_index h) const { return m_mesh.tail(m_mesh.next(m_mesh.next(h))); }

  Place corner(Input_halfedge_index h, int i) const
  {
    for(; i > 0; --i)
      h = m_mesh.next(h);
    return m_place_of(m_mesh.tail(h));
  }

  bool is_flat(const Crossing_word& word) const
  {
    for(Input_halfedge_index h : word.crossed)
      if(!is_flat_across(h))
        return false;
    return true;
  }

  bool is_flat_across(Input_halfedge_index h) const
  {
    return m_flat_edges(h, [&] { return lies_in_one_plane(h); });
  }

  // Do the faces on both sides of an edge, unfolded?
  bool lies_in_one_plane(Input_halfedge_index h) const
  {
    const Place p = m_place_of(m_mesh.tail(h)), q = m_place_of(m_mesh.tail(twin_index(h)));
    const Place r = m_place_of(apex(h)), s = m_place_of(apex(twin_index(h)));
    return Orientation_of_places<3>()({p, q, r, s}) == ZERO && is_unfolded(p, q, r, s);
  }

  // Are r and s, which lie in one plane with p and q, on different sides of the line through these two?
  static bool is_unfolded(const Place& p, const Place& q, const Place& r, const Place& s)
  {
    for(int axis = 0; axis < 3; ++axis) {
      const Sign of_r = orientation_along(axis, p, q, r);
      if(of_r != ZERO)
        return orientation_along(axis, p, q, s) == -of_r;
    }
    return false;
  }

  static Sign orientation_along(int axis, const Place& p, const Place& q, const Place& r)
  {
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    return Orientation_of_places<2>()({{{p[x], p[y]}, {q[x], q[y]}, {r[x], r[y]}}});
  }

  const Mesh& m_mesh;
  PlaceOf m_place_of;
  Flat_edges& m_flat_edges;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_METRIC_PLANAR_SINE_H
