// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_METRIC_PLANAR_SINE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_METRIC_PLANAR_SINE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/input/Indexed_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The sign of the sine of a wedge whose input faces lie unfolded in one plane of space, by exact predicates of points.
 * It is the common case of exact ties: the flat parts of technical models.
 *
 * PointOf maps an input vertex to a point with double coordinates. Words with an end elsewhere are left to others, since
 * the coordinates of such a point are no doubles.
 */
template <class Mesh, class PointOf>
class Planar_sine
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point_2 = Kernel::Point_2;
  using Point_3 = Kernel::Point_3;

public:
  Planar_sine(const Mesh& mesh, PointOf point_of)
    : m_mesh(mesh)
    , m_point_of(point_of)
  {
  }

  /*
   * The wedge leads from the direction of word a clockwise over `steps` input corners to that of word b. Returns false,
   * and no sign, if its faces do not lie in one plane.
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
    for(Index i = 0; i < steps; ++i) {
      const bool is_start = i == 0 && a.along != null_index;
      if(!is_start && !is_flat_across(h))
        return false;
      h = m_mesh.next(twin_index(h));
    }
    const Point_3 node = m_point_of(m_mesh.tail(reference(a))), end_a = m_point_of(head(a)),
                  end_b = m_point_of(head(b));
    for(int axis = 0; axis < 3; ++axis) {
      const Orientation face =
          orientation_along(axis, corner(some_face, 0), corner(some_face, 1), corner(some_face, 2));
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

  Point_3 corner(Input_halfedge_index h, int i) const
  {
    for(; i > 0; --i)
      h = m_mesh.next(h);
    return m_point_of(m_mesh.tail(h));
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
    const Point_3 p = m_point_of(m_mesh.tail(h)), q = m_point_of(m_mesh.tail(twin_index(h)));
    const Point_3 r = m_point_of(apex(h)), s = m_point_of(apex(twin_index(h)));
    return coplanar(p, q, r, s) && !collinear(p, q, r) && coplanar_orientation(p, q, r, s) == NEGATIVE;
  }

  static Orientation orientation_along(int axis, const Point_3& p, const Point_3& q, const Point_3& r)
  {
    const auto project = [axis](const Point_3& x) { return Point_2(x[(axis + 1) % 3], x[(axis + 2) % 3]); };
    return orientation(project(p), project(q), project(r));
  }

  const Mesh& m_mesh;
  PointOf m_point_of;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_METRIC_PLANAR_SINE_H
