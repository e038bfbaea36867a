// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/numbers/Orientation_of_places.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/check_triangle.h>
#include <CGAL/Flip_geodesics/internal/tangents/Exact_ray_side.h>
#include <CGAL/Flip_geodesics/internal/triangulation/nearest_weights.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Face_strip.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * A straight ray over input faces, from a place in one of them. It passes gates, which are edges. On which side of it
 * the corner of the next face lies is the sign of the exact number that the place's weights, the direction and the
 * input define.
 *
 * The faces are unfolded into the plane of the first one, with the place at the origin and its halfedge along the
 * positive real axis.
 */
template <class Triangulation>
class Ray
{
  using Layout = Layout_in_double<Triangulation>;

public:
  using Vector = std::complex<double>;

  /* \pre the weights are those of a location, and the direction is not zero
   * \throws Degenerate_face_error, Invalid_coordinate_error, Invalid_mesh_error */
  Ray(const Triangulation& triangulation, const Exact_input_faces<Triangulation>& exact_faces,
      const Surface_location& place, const Face_direction& direction, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_exact_faces(exact_faces)
    , m_place(place)
    , m_direction(direction)
    , m_statistics(statistics)
    , m_exact_side(place, direction)
    , m_faces(first_face(triangulation, place))
  {
    lay_out_direction();
    for(int i = 0; i < 3; ++i)
      m_sides[i] = side_of_first_corner(i);
  }

  /*
   * Goes up to the side through which the ray leaves the first face; false if there is none, since it leaves it at a
   * corner, or at once.
   */
  bool leave_first_face()
  {
    for(int i = 0; i < 3; ++i)
      if(m_sides[i] == NEGATIVE && m_sides[(i + 1) % 3] == POSITIVE) {
        leave_over(i);
        return true;
      }
    return false;
  }

  /* Goes up to the corner that the ray runs into in the first face; false if there is none. */
  bool reach_first_corner()
  {
    for(int i = 0; i < 3; ++i) // but not one in the place of the start, which is not ahead
      if(m_sides[i] == ZERO && (std::conj(m_unit) * m_faces.corners()[i].position).real() > 0) {
        m_apex = i;
        return true;
      }
    return false;
  }

  /* Passes the gate, and goes up to the next one; false if the ray runs into the corner opposite to the gate.
   * \pre there is a face behind it */
  bool pass_gate()
  {
    m_entry_distance = distance_of_gate();
    m_entry_sine = starts_on_gate() ? 1 : sine_at_gate();
    m_entry = {place_on_gate(), 1 - place_on_gate(), 0};
    enter_face(twin_index(m_crossed.back()));
    const Sign sign = side_of_apex();
    if(sign == ZERO)
      return false;
    leave_over(sign == POSITIVE ? 1 : 2);
    return true;
  }

  /*
   * Passes the corner that the ray runs into, as if that lay on its left: around it over the faces on the right of the
   * ray. Goes up to the next gate; false if it runs into another corner.
   *
   * \pre the angles about the corner are 2 pi, exactly, and the faces about it have areas
   */
  bool pass_corner()
  {
    m_exact_side.reach_corner(m_triangulation, m_exact_faces, m_crossed);
    m_entry_distance = distance_of_corner();
    Sign sign = NEGATIVE;
    for(int side = (m_apex + 2) % 3; sign == NEGATIVE; side = 2) {
      leave_over(side);
      m_entry_sine = sine_at_gate();
      m_entry = {1, 0, 0};
      enter_face(twin_index(m_crossed.back()));
      sign = side_of_apex();
    }
    m_exact_side.leave_corner(halfedge(), m_crossed.size());
    if(sign == ZERO)
      return false;
    leave_over(1);
    return true;
  }

  /* The halfedge that is crossed at the gate, as a side of the face before it. */
  Input_halfedge_index gate() const { return m_crossed.back(); }

  /* Is it the edge that the ray starts on? */
  bool starts_on_gate() const
  {
    const Input_halfedge_index h = m_place.halfedge, g = m_crossed.front();
    return m_crossed.size() == 1 && m_place.weights[g == h ? 2 : (g == m_triangulation.input().next(h) ? 0 : 1)] == 0;
  }

  /* How far the gate is, in the direction of the ray. */
  double distance_of_gate() const
  {
    if(starts_on_gate())
      return 0;
    const Vector to_left = -m_faces.gate();
    const double whole = cross(m_unit, to_left);
    return whole > 0 ? (std::max)(cross(m_faces.right().position, to_left) / whole, 0.0) : 0.0;
  }

  /* Where the ray passes the gate, from 0 at its right end to 1 at its left end. */
  double place_on_gate() const
  {
    if(starts_on_gate()) {
      const int tail = m_faces.number_of(gate());
      return m_place.weights[(tail + 1) % 3] / m_sum;
    }
    const double right = (std::max)(-cross(m_unit, m_faces.right().position), 0.0);
    const double left = (std::max)(cross(m_unit, m_faces.left().position), 0.0);
    return right + left > 0 ? right / (right + left) : 0.5;
  }

  /* The corner that the ray runs into, by the halfedge of the last face that starts there; and how far it is. */
  Input_halfedge_index corner() const { return m_faces.side(m_apex); }
  double distance_of_corner() const { return magnitude(m_faces.corners()[m_apex].position); }

  /*
   * Where the ray is at a distance, in the last face that it has entered. Between the places where it enters it and leaves
   * it, or runs into a corner; those are inaccurate where it grazes a side. Or nearest to where it is in the plane; that
   * is inaccurate in a face that is nearly without area.
   */
  Surface_location location_at(double distance, bool is_at_gate) const
  {
    const Face_vectors& sides = m_faces.sides();
    const double area = cross(sides[0], sides[1]);
    const double longest = (std::max)({std::norm(sides[0]), std::norm(sides[1]), std::norm(sides[2])});
    const double grazing = (std::min)(m_entry_sine, is_at_gate ? sine_at_gate() : 1.0);
    std::array<double, 3> weights =
        area > grazing * longest ? nearest_to(distance * m_unit) : between_ends(distance, is_at_gate);
    for(double& weight : weights)
      weight = weight > least_weight ? weight : 0;
    return {halfedge(), weights};
  }

  /* The last face, by the halfedge over which it was entered, or that of the place; and the angle from there on to the
   * ray, counterclockwise. */
  Input_halfedge_index halfedge() const { return m_faces.halfedge(); }
  double angle() const { return std::arg(product(m_unit, std::conj(m_faces.sides()[0]))); }

  /* The angle from corner() on to the ray's way back, counterclockwise. */
  double angle_at_corner() const { return std::arg(product(-m_unit, std::conj(m_faces.sides()[m_apex]))); }

private:
  using Faces = Face_strip<Layout>;

  // The sine of the angle between the ray and the gate.
  double sine_at_gate() const { return std::abs(cross(m_unit, m_faces.gate())) / magnitude(m_faces.gate()); }

  std::array<double, 3> nearest_to(const Vector& p) const
  {
    std::array<Place_in_space, 3> corners;
    for(std::size_t i = 0; i < 3; ++i) {
      const Vector corner = m_faces.corners()[i].position - p;
      corners[i] = {{corner.real(), corner.imag(), 0}};
    }
    return nearest_weights(corners).weights;
  }

  std::array<double, 3> between_ends(double distance, bool is_at_gate) const
  {
    const double whole = (is_at_gate ? distance_of_gate() : distance_of_corner()) - m_entry_distance;
    const double part = whole > 0 ? (std::min)((std::max)((distance - m_entry_distance) / whole, 0.0), 1.0) : 0.0;
    std::array<double, 3> result = {0, 0, 0};
    if(is_at_gate) {
      const int right = m_faces.number_of(gate());
      const double place = place_on_gate();
      result[right] = 1 - place;
      result[(right + 1) % 3] = place;
    } else
      result[m_apex] = 1;
    for(int i = 0; i < 3; ++i)
      result[i] = (1 - part) * m_entry[i] + part * result[i];
    return result;
  }

  static Faces first_face(const Triangulation& triangulation, const Surface_location& place)
  {
    const auto& input = triangulation.input();
    check_triangle(input, place.halfedge);
    const Layout layout(triangulation);
    const Face_vectors sides = layout.sides(place.halfedge, triangulation.metric().length(input, place.halfedge));
    return Faces(layout, place.halfedge, sides, Layout::corners(sides, place.weights));
  }

  void lay_out_direction()
  {
    const std::array<double, 3>& w = m_place.weights;
    m_sum = w[0] + w[1] + w[2];
    for(int i = 0; i < 3; ++i)
      m_entry[i] = w[i] / m_sum;
    const Face_vectors& sides = m_faces.sides();
    const Vector direction = m_direction[0] * sides[0] - m_direction[1] * sides[2];
    const double size = std::abs(m_direction[0]) * magnitude(sides[0]) + std::abs(m_direction[1]) * magnitude(sides[2]);
    m_unit = direction / magnitude(direction);
    m_unit_error = face_ratio_error * (1 + size / magnitude(direction));
  }

  // Enters a face over the gate.
  void enter_face(Input_halfedge_index entered)
  {
    check_triangle(m_triangulation.input(), entered);
    m_faces.enter(entered);
    m_apex = 2;
  }

  // The gate is a side of the last face now.
  void leave_over(int i)
  {
    m_faces.leave_over(i);
    m_crossed.push_back(m_faces.side(i));
  }

  /*
   * The side of a corner of the first face: weights and direction say it alone. Areas in the face are determinants of
   * barycentric coordinates.
   */
  Sign side_of_first_corner(int i) const
  {
    const std::array<double, 3>& w = m_place.weights;
    const auto [a, b] = m_direction;
    Exact_sum<12> sum; // of direction and corner, the coordinates of which are those of a corner times the sum, less w
    sum.add_product(-a, i == 2 ? -w[0] : w[2]);
    sum.add_product(b, i == 1 ? -w[0] : w[1]);
    if(i == 1)
      sum.add_product(-b, w[2]);
    if(i == 2)
      sum.add_product(a, w[1]);
    return sum.sign();
  }

  Sign side_of_apex()
  {
    const auto& apex = m_faces.corners()[2];
    const double sine = cross(m_unit, apex.position), distance = magnitude(apex.position);
    const double bound = apex.error + (m_unit_error + product_sum_error) * distance;
    if(std::abs(sine) > bound)
      return sine > 0 ? POSITIVE : NEGATIVE;
    return m_exact_side(m_triangulation, m_exact_faces, m_crossed, m_statistics);
  }

  const Triangulation& m_triangulation;
  const Exact_input_faces<Triangulation>& m_exact_faces;
  Surface_location m_place;
  Face_direction m_direction;
  Decision_statistics& m_statistics;
  Exact_ray_side m_exact_side;
  std::array<Sign, 3> m_sides = {}; // of the ray, of the first corners
  double m_sum = 0, m_unit_error = 0;
  Vector m_unit = 0;

  Faces m_faces;
  std::array<double, 3> m_entry = {};            // the weights of the place where the last face is entered
  double m_entry_distance = 0, m_entry_sine = 1; // and of the angle between ray and side there
  int m_apex = 2;                                // the corner that the ray runs into
  std::vector<Input_halfedge_index> m_crossed;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H
