// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_FACE_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_FACE_STRIP_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* The vectors of the sides of a face, starting with some halfedge. */
using Face_vectors = std::array<Plane_vector, 3>;

/* Returns a face whose first side lies on the positive real axis, rotated and scaled so that this side is a given
 * vector. */
template <class Face_geometry>
Face_vectors turned_along(const Face_geometry& face, const Plane_vector& along)
{
  const Plane_vector turn = along / face[0].x;
  return {along, product(turn, {face[1].x, face[1].y}), product(turn, {face[2].x, face[2].y})};
}

/* A corner of an unfolded face. */
template <class Vector>
struct Unfolded_corner
{
  Vector position;
  double error; // a bound
};

/*
 * Unfolds input faces in doubles. The error of a position is normwise, a few units in the last place per face, whatever
 * the shapes of the faces.
 *
 * A layout has a type for the sides of a face, with `opposite(side)` for the reverse direction, and one for its
 * corners. It computes the sides of a face from the first one, and the third corner of a face from the ends of its
 * first side.
 */
template <class Triangulation>
class Layout_in_double
{
public:
  using Side = Plane_vector;
  using Sides = Face_vectors;

  using Corner = Unfolded_corner<Plane_vector>;

  explicit Layout_in_double(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Input_halfedge_index next(Input_halfedge_index h) const { return m_triangulation.input().next(h); }
  static Side opposite(const Side& side) { return -side; }

  /* Returns the sides of the face of h, given the first one. \pre the face is a triangle */
  Sides sides(Input_halfedge_index h, const Side& along) const
  {
    return turned_along(known_input_face_geometry(m_triangulation, h), along);
  }

  /* Returns the corners of a face relative to a point in it, which is given by the weights of the corners. */
  static std::array<Corner, 3> corners(const Sides& sides, const std::array<double, 3>& weights)
  {
    const double sum = weights[0] + weights[1] + weights[2];
    std::array<Corner, 3> result;
    for(std::size_t i = 0; i < 3; ++i) { // from the corner's two sides
      const std::size_t before = (i + 2) % 3;
      const double b = weights[(i + 1) % 3] / sum, c = weights[before] / sum;
      result[i] = {unfused(c * sides[before]) - unfused(b * sides[i]),
                   face_ratio_error * (b * magnitude(sides[i]) + c * magnitude(sides[before]))};
    }
    return result;
  }

  /* Returns the third corner of the n-th face that is entered, computed from the nearer end of the first side. */
  static Corner apex(const Sides& sides, const Corner& right, const Corner& left, std::size_t n)
  {
    const double to_right = magnitude(sides[1]), to_left = magnitude(sides[2]), error = turn_error(n);
    const bool is_near_right = to_right < to_left;
    const Plane_vector position = is_near_right ? right.position + sides[1] : left.position - sides[2];
    return {position, (is_near_right ? right.error + error * to_right : left.error + error * to_left) +
                          face_ratio_error * magnitude(position)};
  }

  /* Returns a bound on the relative errors of the sides of the n-th face that is entered. */
  static double turn_error(std::size_t n) { return static_cast<double>(n + 1) * face_ratio_error; }

private:
  const Triangulation& m_triangulation;
};

/*
 * Unfolds input faces into a plane, one after the other, each across a side of the previous one: its portal (`portal`).
 *
 *                     apex                  Face entered across `portal`: its corners are the left end of the portal,
 *                    /    \                 the right end and the apex; its sides lead from the left end to the
 *              side 2      side 1           right one, to the apex, and back.
 *                  /        \
 *               left -------- right
 *                    portal
 *
 * The sides are products of the corners of the faces, never differences of positions, which would magnify errors at
 * short portals. The layout determines how numbers are computed and how their errors are bounded.
 */
template <class Layout>
class Face_strip
{
public:
  using Corner = typename Layout::Corner;
  using Side = typename Layout::Side;
  using Sides = typename Layout::Sides;
  using Corners = std::array<Corner, 3>;

  /* Starts in the face of h, whose corners are the tails of h, next(h) and previous(h). `leave_over()` sets the portal.
   * */
  Face_strip(const Layout& layout, Input_halfedge_index h, const Sides& sides, const Corners& corners)
    : m_layout(layout)
    , m_halfedge(h)
    , m_sides(sides)
    , m_corners(corners)
  {
  }

  /* Returns the last face, given by the halfedge across which it was entered. */
  Input_halfedge_index halfedge() const { return m_halfedge; }
  const Sides& sides() const { return m_sides; }
  const Corners& corners() const { return m_corners; }

  /* Returns a side of the last face as a halfedge; below, the number of a halfedge among the sides. */
  Input_halfedge_index side(int i) const
  {
    const Input_halfedge_index second = i == 0 ? m_halfedge : m_layout.next(m_halfedge);
    return i == 2 ? m_layout.next(second) : second;
  }
  int number_of(Input_halfedge_index h) const { return h == m_halfedge ? 0 : (h == m_layout.next(m_halfedge) ? 1 : 2); }

  /* Returns the side across which the last face is left, from its left end to its right one. */
  const Side& portal() const { return m_portal; }
  const Corner& right() const { return m_right; }
  const Corner& left() const { return m_left; }

  /* Makes a side of the last face the portal. */
  void leave_over(int i)
  {
    m_right = m_corners[i];
    m_left = m_corners[i == 2 ? 0 : i + 1];
    m_portal = m_layout.opposite(m_sides[i]);
  }

  /* Enters the face of h, the halfedge of the portal in that face. */
  void enter(Input_halfedge_index h)
  {
    const Sides sides = m_layout.sides(h, m_portal);
    set_face(h, sides, m_layout.apex(sides, m_right, m_left, ++m_entered));
  }

  /* Crosses edges, each given as a halfedge of the face before it, and enters the face behind the last one. Calls
   * visit(crossed, right, left) for each with the ends of the portal. \pre there is one, and the first is the portal */
  template <class Visit>
  void cross(const std::vector<Input_halfedge_index>& crossed, const Visit& visit)
  {
    for(std::size_t i = 0;; ++i) { // each face has one new corner; the others do not move
      visit(crossed[i], m_right, m_left);
      const Input_halfedge_index entered = twin_index(crossed[i]);
      const Sides sides = m_layout.sides(entered, m_portal);
      const Corner apex = m_layout.apex(sides, m_right, m_left, ++m_entered);
      if(i + 1 == crossed.size())
        return set_face(entered, sides, apex);
      const bool is_leaving_right = crossed[i + 1] == m_layout.next(entered);
      m_portal = m_layout.opposite(is_leaving_right ? sides[1] : sides[2]);
      (is_leaving_right ? m_left : m_right) = apex;
    }
  }

private:
  void set_face(Input_halfedge_index h, const Sides& sides, const Corner& apex)
  {
    m_halfedge = h;
    m_sides = sides;
    m_corners = {m_left, m_right, apex};
  }

  Layout m_layout;
  Input_halfedge_index m_halfedge;
  Sides m_sides;
  Corners m_corners;
  Side m_portal = {};
  Corner m_right = {}, m_left = {};
  std::size_t m_entered = 0; // the number of faces that have been entered
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_FACE_STRIP_H
