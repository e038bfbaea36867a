// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Double_double.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Face_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

/* A direction in the face of a halfedge: the coefficients of the vectors from the tail of the halfedge to its head and
 * to the third corner. Each is 0, or has an absolute value between 1e-100 and 1e100. */
using Face_direction = std::array<double, 2>;

/*
 * Computes the side of a ray on which the corner behind the last crossed halfedge lies: the sign of the exact number
 * defined by the start, the direction and the input. POSITIVE is the left side.
 *
 * A ray that has passed a corner and runs into another one is the line through these two corners. Numbers therefore do
 * not grow with the edges crossed before.
 *
 * Numbers of 50 digits with an error bound are carried on from one query to the next, so that many queries along one
 * ray take linear time in its length; undecided signs pass through the stages of `Exact_sign`.
 */
class Exact_ray_side
{
  using Ring = Ball_ring<50>;
  using Arithmetic = Chain_arithmetic<Ring>;

  struct State
  {
    Unfolding_chain direction, corner; // of the corner up to the last query
    Arithmetic::Complex value;         // of the direction
    Arithmetic::Portal portal;
    std::size_t number_of_portals = 0; // passed by the chain
  };

public:
  Exact_ray_side(const Surface_location& place, const Face_direction& direction)
    : m_place(place)
    , m_face_direction(direction)
  {
  }

  template <class Triangulation, class ExactFaces>
  Sign operator()(const Triangulation& triangulation, const ExactFaces& faces,
                  const std::vector<Input_halfedge_index>& crossed, Decision_statistics& statistics)
  {
    const Ring ring;
    const Arithmetic arithmetic(ring);
    if(!m_state)
      start(triangulation, faces(m_place.halfedge), crossed[m_first_portal], arithmetic);
    State& state = *m_state;
    for(; state.number_of_portals + 1 < crossed.size(); ++state.number_of_portals) {
      state.corner.steps.push_back(step_across(triangulation.input(), faces, crossed, state.number_of_portals));
      arithmetic.apply(state.corner, state.corner.steps.back(), state.portal);
    }
    const Unfolding_step last = step_across(triangulation.input(), faces, crossed, crossed.size() - 1);
    Arithmetic::Portal portal = state.portal;
    arithmetic.apply(state.corner, last, portal);
    const Uncertain<Sign> quick = ring.sign_of_sine(ring.multiply(state.value, portal.right));
    if(quick.is_certain()) {
      ++statistics.by_precision;
      return quick.make_certain();
    }
    Unfolding_chain corner = state.corner;
    corner.steps.push_back(last);
    return Exact_sign(statistics, sign_work_limit(triangulation))({state.direction, corner});
  }

  /* Must be called when the ray runs into a corner that it will pass. If it has passed one before, it becomes the line
   * from there. */
  template <class Triangulation, class ExactFaces>
  void reach_corner(const Triangulation& triangulation, const ExactFaces& faces,
                    const std::vector<Input_halfedge_index>& crossed)
  {
    if(m_passed == null_index)
      return;
    const Exact_face& face = faces(m_passed);
    m_place = {m_passed, {{1, 0, 0}}};
    const bool is_along_edge = m_portals_before == crossed.size(); // to the third corner of the face
    Unfolding_chain direction = is_along_edge ? chain_in_face(face, {0, 0, -1})
                                              : corner_of_first_face(triangulation, face, crossed[m_portals_before]);
    for(std::size_t i = m_portals_before; i < crossed.size(); ++i)
      direction.steps.push_back(step_across(triangulation.input(), faces, crossed, i));
    direction.is_conjugate = true;
    m_direction = direction;
    m_first_portal = m_portals_before;
    m_state.reset();
  }

  /* Must be called when the ray leaves the tail of h in the face of h, after passing `portals` portals. */
  void leave_corner(Input_halfedge_index h, std::size_t portals)
  {
    m_passed = h;
    m_portals_before = portals;
  }

private:
  template <class Triangulation>
  void start(const Triangulation& triangulation, const Exact_face& face, Input_halfedge_index crossed,
             const Arithmetic& arithmetic)
  {
    m_state = State();
    State& state = *m_state;
    state.direction = m_direction ? *m_direction : direction_in_first_face(face);
    state.value = arithmetic.value(state.direction);
    state.corner = corner_of_first_face(triangulation, face, crossed);
    state.portal = arithmetic.first_portal();
    arithmetic.apply(state.corner, state.corner.steps.back(), state.portal);
    state.number_of_portals = m_first_portal;
  }

  Unfolding_chain direction_in_first_face(const Exact_face& face) const
  {
    const std::array<Integer, 2> d = to_integers(m_face_direction);
    Unfolding_chain result = chain_in_face(face, {d[0], Integer(0), Integer(-d[1])});
    result.is_conjugate = true;
    return result;
  }

  // The ends of the first portal, relative to the start.
  template <class Triangulation>
  Unfolding_chain corner_of_first_face(const Triangulation& triangulation, const Exact_face& face,
                                       Input_halfedge_index crossed) const
  {
    return chain_to_side(face, integer_weights(m_place.weights),
                         side_number(triangulation.input(), m_place.halfedge, crossed));
  }

  Surface_location m_place; // the start of the ray, or the last corner but one that it has passed
  Face_direction m_face_direction;
  std::optional<Unfolding_chain> m_direction; // none until it has passed two corners
  std::size_t m_first_portal = 0;             // after m_place
  std::optional<State> m_state;               // none before the first query

  Input_halfedge_index m_passed = null_index; // where it leaves the last corner that it has passed
  std::size_t m_portals_before = 0;
};

/*
 * A straight ray over input faces, from a point in one of them. It passes portals, which are edges. The side of the ray
 * on which the corner of the next face lies is the sign of the exact number defined by the weights of the start, the
 * direction and the input.
 *
 * The faces are unfolded into the plane of the first one, with the start at the origin and its halfedge along the
 * positive real axis.
 */
template <class Triangulation>
class Ray
{
  using Layout = Layout_in_double<Triangulation>;

public:
  using Vector = std::complex<double>;

  /* \pre the weights are those of a surface point, and the direction is not zero
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
   * Advances to the side through which the ray leaves the first face; returns false if there is none, since the ray
   * leaves the face at a corner, or immediately.
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

  /* Advances to the corner into which the ray runs in the first face; returns false if there is none. */
  bool reach_first_corner()
  {
    for(int i = 0; i < 3; ++i) // except one that coincides with the start, which is not ahead
      if(m_sides[i] == ZERO && (std::conj(m_unit) * m_faces.corners()[i].position).real() > 0) {
        m_apex = i;
        return true;
      }
    return false;
  }

  /* Passes the portal and advances to the next one; returns false if the ray runs into the corner opposite to the
   * portal. \pre there is a face behind it */
  bool pass_portal()
  {
    m_entry_distance = distance_of_portal();
    m_entry_sine = starts_on_portal() ? 1 : sine_at_portal();
    m_entry = {place_on_portal(), 1 - place_on_portal(), 0};
    enter_face(twin_index(m_crossed.back()));
    const Sign sign = side_of_apex();
    if(sign == ZERO)
      return false;
    leave_over(sign == POSITIVE ? 1 : 2);
    return true;
  }

  /*
   * Passes the corner into which the ray runs as if it lay on its left: around it over the faces on the right of the
   * ray. Advances to the next portal; returns false if the ray runs into another corner.
   *
   * \pre the angles around the corner sum up to exactly 2 pi, and the faces around it are not degenerate
   */
  bool pass_corner()
  {
    m_exact_side.reach_corner(m_triangulation, m_exact_faces, m_crossed);
    m_entry_distance = distance_of_corner();
    Sign sign = NEGATIVE;
    for(int side = (m_apex + 2) % 3; sign == NEGATIVE; side = 2) {
      leave_over(side);
      m_entry_sine = sine_at_portal();
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

  /* Returns the halfedge that is crossed at the portal, as a side of the face before it. */
  Input_halfedge_index portal() const { return m_crossed.back(); }

  /* Returns whether it is the edge on which the ray starts. */
  bool starts_on_portal() const
  {
    const Input_halfedge_index h = m_place.halfedge, g = m_crossed.front();
    return m_crossed.size() == 1 && m_place.weights[g == h ? 2 : (g == m_triangulation.input().next(h) ? 0 : 1)] == 0;
  }

  /* Returns the distance of the portal along the ray. */
  double distance_of_portal() const
  {
    if(starts_on_portal())
      return 0;
    const Vector to_left = -m_faces.portal();
    const double whole = cross(m_unit, to_left);
    return whole > 0 ? (std::max)(cross(m_faces.right().position, to_left) / whole, 0.0) : 0.0;
  }

  /* Returns the position at which the ray passes the portal, from 0 at its right end to 1 at its left end. */
  double place_on_portal() const
  {
    if(starts_on_portal()) {
      const int tail = m_faces.number_of(portal());
      return m_place.weights[(tail + 1) % 3] / m_sum;
    }
    const double right = (std::max)(-cross(m_unit, m_faces.right().position), 0.0);
    const double left = (std::max)(cross(m_unit, m_faces.left().position), 0.0);
    return right + left > 0 ? right / (right + left) : 0.5;
  }

  /* Returns the corner into which the ray runs, by the halfedge of the last face that starts there; below, its
   * distance. */
  Input_halfedge_index corner() const { return m_faces.side(m_apex); }
  double distance_of_corner() const { return magnitude(m_faces.corners()[m_apex].position); }

  /*
   * Returns the point of the ray at a distance, in the last face that it has entered. It is interpolated between the
   * points at which the ray enters the face and leaves it or runs into a corner, which is inaccurate if the ray grazes
   * a side; or it is the point nearest to that in the plane, which is inaccurate in an almost degenerate face.
   */
  Surface_location location_at(double distance, bool is_at_portal) const
  {
    const Face_vectors& sides = m_faces.sides();
    const double area = cross(sides[0], sides[1]);
    const double longest = (std::max)({std::norm(sides[0]), std::norm(sides[1]), std::norm(sides[2])});
    const double grazing = (std::min)(m_entry_sine, is_at_portal ? sine_at_portal() : 1.0);
    std::array<double, 3> weights =
        area > grazing * longest ? nearest_to(distance * m_unit) : between_ends(distance, is_at_portal);
    for(double& weight : weights)
      weight = weight > least_weight ? weight : 0;
    return {halfedge(), weights};
  }

  /* Returns the last face, by the halfedge across which it was entered, or that of the start; below, the angle from
   * there counterclockwise to the ray. */
  Input_halfedge_index halfedge() const { return m_faces.halfedge(); }
  double angle() const { return std::arg(product(m_unit, std::conj(m_faces.sides()[0]))); }

  /* Returns the angle from corner() counterclockwise to the reverse ray. */
  double angle_at_corner() const { return std::arg(product(-m_unit, std::conj(m_faces.sides()[m_apex]))); }

private:
  using Faces = Face_strip<Layout>;

  // The sine of the angle between the ray and the portal.
  double sine_at_portal() const { return std::abs(cross(m_unit, m_faces.portal())) / magnitude(m_faces.portal()); }

  std::array<double, 3> nearest_to(const Vector& p) const
  {
    std::array<Place_in_space, 3> corners;
    for(std::size_t i = 0; i < 3; ++i) {
      const Vector corner = m_faces.corners()[i].position - p;
      corners[i] = {{corner.real(), corner.imag(), 0}};
    }
    return nearest_weights(corners).weights;
  }

  std::array<double, 3> between_ends(double distance, bool is_at_portal) const
  {
    const double whole = (is_at_portal ? distance_of_portal() : distance_of_corner()) - m_entry_distance;
    const double part = whole > 0 ? (std::min)((std::max)((distance - m_entry_distance) / whole, 0.0), 1.0) : 0.0;
    std::array<double, 3> result = {0, 0, 0};
    if(is_at_portal) {
      const int right = m_faces.number_of(portal());
      const double place = place_on_portal();
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

  // Enters a face across the portal.
  void enter_face(Input_halfedge_index entered)
  {
    check_triangle(m_triangulation.input(), entered);
    m_faces.enter(entered);
    m_apex = 2;
  }

  // Makes a side of the last face the portal.
  void leave_over(int i)
  {
    m_faces.leave_over(i);
    m_crossed.push_back(m_faces.side(i));
  }

  /*
   * The side of a corner of the first face, which depends on weights and direction only. Areas in the face are
   * determinants of barycentric coordinates.
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
  std::array<Sign, 3> m_sides = {}; // of the ray, for the first corners
  double m_sum = 0, m_unit_error = 0;
  Vector m_unit = 0;

  Faces m_faces;
  std::array<double, 3> m_entry = {};            // the weights of the point at which the last face was entered
  double m_entry_distance = 0, m_entry_sine = 1; // and of the angle between ray and side there
  int m_apex = 2;                                // the corner into which the ray runs
  std::vector<Input_halfedge_index> m_crossed;
};

/* The start of a ray: a surface point relative to a halfedge of its first face, and a direction in that face.
 * Alternatively a vertex of the border, and an angle from that halfedge out of the surface. */
struct Ray_start
{
  Surface_location place;
  Face_direction direction;
  bool is_outward = false;
  double angle = 0;
};

/* Converts angles and vectors in space into directions in faces. These are rounded; everything derived from them is
 * exact. */
template <class Triangulation>
class Direction_finder
{
public:
  explicit Direction_finder(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*
   * Returns a ray by its angle counterclockwise from a side of a face that contains the point; at a vertex over all
   * faces around it.
   *
   * \throws Invalid_parameter_error if it is not such a halfedge
   */
  Ray_start by_angle(const Surface_location& location, Input_halfedge_index h, double angle) const
  {
    check_location(input(), location);
    check_reference(input(), h);
    if(!std::isfinite(angle))
      throw Invalid_parameter_error("the angle of a direction is not a finite number");
    const Surface_location at = canonical_location(input(), location);
    if(kind(at) == Location_kind::VERTEX)
      return at_vertex_of_face(h, input().tail(at.halfedge), angle);
    if(!is_side_of(h, at.halfedge) && !(kind(at) == Location_kind::EDGE && is_side_of(h, twin_index(at.halfedge))))
      throw_no_side(h);
    return by_well_conditioned_side(at, h, angle);
  }

  /* Returns a ray by a direction in the face of the point's halfedge, which is used unchanged unless it leaves the face
   * immediately at a vertex. */
  Ray_start by_direction(const Surface_location& location, const Face_direction& direction) const
  {
    check_location(input(), location);
    if(!std::isfinite(direction[0]) || !std::isfinite(direction[1]) || (direction[0] == 0 && direction[1] == 0))
      throw Invalid_parameter_error("a direction has length zero in its face, or is not finite");
    if(input().is_border(location.halfedge))
      throw_naming<Invalid_parameter_error>("a direction refers to the face of halfedge ", location.halfedge,
                                            ", but this border halfedge has no face");
    Ray_start start = {location, normalized(direction), false, 0};
    if(kind(location) != Location_kind::VERTEX)
      return start;
    while(start.place.weights[0] == 0)
      start = {rotated(input(), start.place),
               normalized({start.direction[1], -start.direction[0] - start.direction[1]}), false, 0};
    if(start.direction[0] >= 0 && start.direction[1] >= 0)
      return start;
    const auto [length, third] = corners(start.place.halfedge);
    return at_vertex(start.place.halfedge, std::arg(start.direction[0] * length + start.direction[1] * third));
  }

  /* Returns a ray from a vertex, at an angle counterclockwise from a halfedge that starts there. */
  Ray_start at_vertex(Input_halfedge_index h, double angle) const
  {
    const Vertex_fan fan = fan_of(h);
    const double total = fan.total();
    double position = fan.angle_of(h, input().tail(h)) + angle;
    if(!fan.has_border())
      position -= total * std::floor(position / total);
    const double allowed = direction_rounding * total;
    if(!(position >= -allowed && position <= total + allowed))
      return {{fan.halfedges().front().halfedge, {{1, 0, 0}}}, {0, 0}, true, position};
    const Vertex_fan::Turn turn = fan.turn_at(position);
    return {{turn.halfedge, {{1, 0, 0}}}, inside_corner(turn.halfedge, turn.angle, turn.corner), false, 0};
  }

  /* Returns a ray from a vertex, at an angle from a side of a face that contains it. */
  Ray_start at_vertex_of_face(Input_halfedge_index h, Vertex_index v, double angle) const
  {
    if(input().tail(h) == v)
      return at_vertex(h, angle);
    Input_halfedge_index side = h;
    while(input().tail(side) != v) { // the next side is rotated by the outer angle between them
      side = input().next(side);
      if(side == h || input().is_border(h))
        throw_no_side(h);
      angle -= boost::math::constants::pi<double>() - corner(side);
    }
    return at_vertex(side, angle);
  }

  /* Returns the sum of the angles around the tail of a halfedge; infinite on the border. */
  double total_angle(Input_halfedge_index h) const
  {
    const Vertex_fan fan = fan_of(h);
    return fan.has_border() ? std::numeric_limits<double>::infinity() : fan.total();
  }

private:
  const auto& input() const { return m_triangulation.input(); }

  // With the corners used in the frames of directions.
  Vertex_fan fan_of(Input_halfedge_index h) const
  {
    Vertex_fan fan;
    fan.collect_umbrella(input(), h, [this](Input_halfedge_index g) { return corner(g); });
    return fan;
  }

  bool is_side_of(Input_halfedge_index h, Input_halfedge_index face) const
  {
    return !input().is_border(face) && internal::is_side_of(input(), h, face);
  }

  // Relative to the tail of h: its head, on the real axis, and the third corner of its face.
  std::pair<double, std::complex<double>> corners(Input_halfedge_index h) const
  {
    const auto face = input_face_geometry(m_triangulation, h);
    return {face[0].x, {-face[2].x, -face[2].y}};
  }

  double corner(Input_halfedge_index h) const { return std::arg(corners(h).second); }

  Face_direction in_face(Input_halfedge_index h, double x, double y) const
  {
    const auto [length, third] = corners(h);
    if(y != 0 && !(third.imag() > 0))
      throw_naming<Degenerate_face_error>("a direction is given in a degenerate face, that of halfedge ", h);
    const double up = y == 0 ? 0 : y / third.imag();
    return normalized({(x - up * third.real()) / length, up});
  }

  /*
   * An angle from a side, expressed relative to another side if the corner there is far less acute or obtuse: a
   * direction expressed in two nearly parallel sides would lose its digits.
   */
  Ray_start by_well_conditioned_side(const Surface_location& at, Input_halfedge_index h, double angle) const
  {
    constexpr double far_less = 1.0 / 16;
    Input_halfedge_index best = h, side = h;
    double best_angle = angle, least = far_less * length(h) * length(input().next(input().next(h)));
    double angle_at_edge = angle;
    for(int i = 0; i < 2; ++i) {
      const double before = length(side);
      side = input().next(side);
      angle -= boost::math::constants::pi<double>() - corner(side);
      angle_at_edge = side == at.halfedge ? angle : angle_at_edge;
      if(before * length(side) < least) { // twice the area divided by the sine of the corner
        least = before * length(side);
        best = side;
        best_angle = angle;
      }
    }
    const Face_direction direction = in_face(best, std::cos(best_angle), std::sin(best_angle));
    // An angle along the border counts as exactly along it, even if rounding errors lead slightly out of the surface or
    // into it.
    const double off = std::abs(std::sin(angle_at_edge));
    if(kind(at) == Location_kind::EDGE && input().is_border(twin_index(at.halfedge)) &&
       off <= (away_from_side(at.halfedge, best, direction) < 0 ? off_border : into_border))
      return {at, {std::copysign(1, std::cos(angle_at_edge)), 0}, false, 0};
    return {{best, weights_in_face(input(), at, best)}, direction, false, 0};
  }

  // The change of the weight opposite to a side of a face in a direction expressed relative to any side; its sign is
  // exact.
  double away_from_side(Input_halfedge_index side, Input_halfedge_index reference, const Face_direction& d) const
  {
    if(side == reference)
      return d[1];
    return input().next(side) == reference ? d[0] : -d[0] - d[1];
  }

  double length(Input_halfedge_index h) const { return m_triangulation.metric().length(input(), h); }

  // In the corner at the tail of h, whose sides can be reached by rounding as well.
  Face_direction inside_corner(Input_halfedge_index h, double angle, double whole) const
  {
    if(angle <= 0)
      return {1, 0};
    if(angle >= whole)
      return {0, 1};
    const Face_direction d = in_face(h, std::cos(angle), std::sin(angle));
    return normalized({(std::max)(d[0], 0.0), (std::max)(d[1], 0.0)});
  }

  // Divided by a power of two, so that the larger number is between 1 and 2, without small numbers whose products could
  // underflow.
  static Face_direction normalized(const Face_direction& d)
  {
    const int exponent = std::ilogb((std::max)(std::abs(d[0]), std::abs(d[1])));
    const auto number = [exponent](double x) {
      const double scaled = std::scalbn(x, -exponent);
      return std::abs(scaled) < least_weight ? 0 : scaled;
    };
    return {number(d[0]), number(d[1])};
  }

  const Triangulation& m_triangulation;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H
