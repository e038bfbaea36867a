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
#include <CGAL/Flip_geodesics/internal/surface/Word_ends.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Face_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
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

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A direction in the face of a halfedge: these times the vectors from the tail of the halfedge to its head, and to the
 * third corner. Each is 0, or between 1e-100 and 1e100 without its sign. */
using Face_direction = std::array<double, 2>;

/*
 * On which side of a ray does the corner lie behind the last halfedge that it crosses: the sign of the exact number that
 * the start, the direction and the input define. POSITIVE is on the left.
 *
 * A ray that has passed a corner and runs into another one is the line through these two. So numbers do not grow with
 * what it has crossed before.
 *
 * Numbers of 50 digits, with a bound of their error, are carried on from one question to the next, so that many along
 * one ray are linear in its length; what they do not decide goes through the stages of `Exact_sign`.
 */
class Exact_ray_side
{
  using Ring = Ball_ring<50>;
  using Arithmetic = Chain_arithmetic<Ring>;
  using Kind = Unfolding_step::Kind;

  struct State
  {
    Unfolding_chain direction, corner; // the corner's, up to where the ray has been asked for
    Arithmetic::Complex value;         // of the direction
    Arithmetic::Gate gate;
    std::size_t number_of_gates = 0; // that the chain has passed
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
      start(triangulation, faces(m_place.halfedge), crossed[m_first_gate], arithmetic);
    State& state = *m_state;
    for(; state.number_of_gates + 1 < crossed.size(); ++state.number_of_gates) {
      state.corner.steps.push_back(step(triangulation, faces, crossed, state.number_of_gates));
      arithmetic.apply(state.corner, state.corner.steps.back(), state.gate);
    }
    const Unfolding_step last = step(triangulation, faces, crossed, crossed.size() - 1);
    Arithmetic::Gate gate = state.gate;
    arithmetic.apply(state.corner, last, gate);
    const Uncertain<Sign> quick = ring.sign(ring.imaginary_part(ring.multiply(state.value, gate.right)));
    if(quick.is_certain()) {
      ++statistics.by_precision;
      return quick.make_certain();
    }
    Unfolding_chain corner = state.corner;
    corner.steps.push_back(last);
    return Exact_sign(statistics, sign_work_limit(triangulation))({state.direction, corner});
  }

  /* The ray runs into a corner that it is going to pass. If it has passed one before, it is the line from there. */
  template <class Triangulation, class ExactFaces>
  void reach_corner(const Triangulation& triangulation, const ExactFaces& faces,
                    const std::vector<Input_halfedge_index>& crossed)
  {
    if(m_passed == null_index)
      return;
    const Exact_face& face = faces(m_passed);
    Unfolding_chain direction;
    m_place = {m_passed, {{1, 0, 0}}};
    if(m_gates_before == crossed.size()) // along the edge to the third corner of the face
      direction.right = Side_combination(face, {Integer(0), Integer(0), Integer(-1)});
    else
      direction = corner_of_first_face(triangulation, face, crossed[m_gates_before]);
    direction.steps.push_back({Kind::START_INSIDE, &face});
    for(std::size_t i = m_gates_before; i < crossed.size(); ++i)
      direction.steps.push_back(step(triangulation, faces, crossed, i));
    direction.is_conjugate = true;
    m_direction = direction;
    m_first_gate = m_gates_before;
    m_state.reset();
  }

  /* The ray leaves the tail of h in the face of h, and has passed so many gates before. */
  void leave_corner(Input_halfedge_index h, std::size_t gates)
  {
    m_passed = h;
    m_gates_before = gates;
  }

private:
  // Over a gate, up to the next one, or to the corner behind the last one.
  template <class Triangulation, class ExactFaces>
  static Unfolding_step step(const Triangulation& triangulation, const ExactFaces& faces,
                             const std::vector<Input_halfedge_index>& crossed, std::size_t i)
  {
    const Input_halfedge_index entered = twin_index(crossed[i]);
    const bool is_leaving_right = i + 1 < crossed.size() && crossed[i + 1] == triangulation.input().next(entered);
    return {is_leaving_right ? Kind::NEW_LEFT : Kind::NEW_RIGHT, &faces(entered)};
  }

  template <class Triangulation>
  void start(const Triangulation& triangulation, const Exact_face& face, Input_halfedge_index crossed,
             const Arithmetic& arithmetic)
  {
    m_state = State();
    State& state = *m_state;
    state.direction = m_direction ? *m_direction : direction_in_first_face(face);
    state.value = arithmetic.value(state.direction);
    state.corner = corner_of_first_face(triangulation, face, crossed);
    state.corner.steps.push_back({Kind::START_INSIDE, &face});
    state.gate = arithmetic.first_gate();
    arithmetic.apply(state.corner, state.corner.steps.back(), state.gate);
    state.number_of_gates = m_first_gate;
  }

  Unfolding_chain direction_in_first_face(const Exact_face& face) const
  {
    const std::array<Integer, 2> d = to_integers(m_face_direction);
    Unfolding_chain result;
    result.right = Side_combination(face, {d[0], Integer(0), Integer(-d[1])});
    result.steps.push_back({Kind::START_INSIDE, &face});
    result.is_conjugate = true;
    return result;
  }

  // The ends of the first gate, as seen from the place; without a step.
  template <class Triangulation>
  Unfolding_chain corner_of_first_face(const Triangulation& triangulation, const Exact_face& face,
                                       Input_halfedge_index crossed) const
  {
    const std::array<Integer, 3> w = integer_weights(m_place.weights);
    const auto corner = [&](int i) { // from the place, times the sum of the weights
      std::array<Integer, 3> sides = {0, 0, 0};
      sides[(i + 2) % 3] = w[(i + 2) % 3];
      sides[i] = -w[(i + 1) % 3];
      return Side_combination(face, sides);
    };
    const Input_halfedge_index h = m_place.halfedge;
    const int side = crossed == h ? 0 : (crossed == triangulation.input().next(h) ? 1 : 2);
    std::array<Integer, 3> to_right = {0, 0, 0};
    to_right[side] = -(w[0] + w[1] + w[2]);
    Unfolding_chain result;
    result.right = corner(side);
    result.left = corner((side + 1) % 3);
    result.to_right = Side_combination(face, to_right);
    return result;
  }

  Surface_location m_place; // where the ray starts, or the last corner but one that it has passed
  Face_direction m_face_direction;
  std::optional<Unfolding_chain> m_direction; // none before it has passed two corners
  std::size_t m_first_gate = 0;               // from m_place on
  std::optional<State> m_state;               // none before the first question

  Input_halfedge_index m_passed = null_index; // where it leaves the last corner that it has passed
  std::size_t m_gates_before = 0;
};

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

/* Where a ray starts: a place told from a halfedge of its first face, and a direction in that face. Or a vertex of the
 * border, and an angle from that halfedge out of the surface. */
struct Ray_start
{
  Surface_location place;
  Face_direction direction;
  bool is_outward = false;
  double angle = 0;
};

/* Turns angles and vectors in space into directions in faces. These are rounded; what follows from them is exact. */
template <class Triangulation>
class Direction_finder
{
public:
  explicit Direction_finder(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /*
   * By an angle counterclockwise from a side of a face that has the location; at a vertex over all faces about it.
   *
   * \throws Invalid_parameter_error if it is no such halfedge
   */
  Ray_start by_angle(const Surface_location& location, Input_halfedge_index h, double angle) const
  {
    check_location(input(), location);
    if(!h.is_valid() || h.idx() >= input().number_of_halfedges())
      throw Invalid_parameter_error("a direction is told from a halfedge that the mesh does not have");
    if(!std::isfinite(angle))
      throw Invalid_parameter_error("the angle of a direction is no finite number");
    const Surface_location at = canonical_location(input(), location);
    if(kind(at) == Location_kind::VERTEX)
      return at_vertex_of_face(h, input().tail(at.halfedge), angle);
    if(!is_side_of(h, at.halfedge) && !(kind(at) == Location_kind::EDGE && is_side_of(h, twin_index(at.halfedge))))
      throw Invalid_parameter_error("a direction is told from halfedge " + std::to_string(h.idx()) +
                                    ", which is no side of a face of the location");
    return told_well(at, h, angle);
  }

  /* By a direction in the face of the location's halfedge, which is taken as it is unless it leaves the face at once at
   * a vertex. */
  Ray_start by_direction(const Surface_location& location, const Face_direction& direction) const
  {
    check_location(input(), location);
    if(!std::isfinite(direction[0]) || !std::isfinite(direction[1]) || (direction[0] == 0 && direction[1] == 0))
      throw Invalid_parameter_error("a direction has no length in its face, or is not finite");
    if(input().is_border(location.halfedge))
      throw Invalid_parameter_error("a direction is told in the face of a halfedge on the border");
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

  /* On from a vertex, at an angle counterclockwise from a halfedge that starts there. */
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

  /* On from a vertex, at an angle from a side of a face that has it. */
  Ray_start at_vertex_of_face(Input_halfedge_index h, Vertex_index v, double angle) const
  {
    if(input().tail(h) == v)
      return at_vertex(h, angle);
    Input_halfedge_index side = h;
    while(input().tail(side) != v) { // the next side is turned by the outer angle between them
      side = input().next(side);
      if(side == h || input().is_border(h))
        throw Invalid_parameter_error("a direction is told from halfedge " + std::to_string(h.idx()) +
                                      ", which is no side of a face of the location");
      angle -= boost::math::constants::pi<double>() - corner(side);
    }
    return at_vertex(side, angle);
  }

  /* The sum of the angles about the tail of a halfedge; infinite on the border. */
  double total_angle(Input_halfedge_index h) const
  {
    const Vertex_fan fan = fan_of(h);
    return fan.has_border() ? std::numeric_limits<double>::infinity() : fan.total();
  }

private:
  const auto& input() const { return m_triangulation.input(); }

  // With the corners as they are in the frames of directions.
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

  // From the tail of h: its head, on the real axis, and the third corner of its face.
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
      throw Degenerate_face_error("a direction is told in the face of halfedge " + std::to_string(h.idx()) +
                                      ", which has no area",
                                  {static_cast<std::size_t>(h.idx())});
    const double up = y == 0 ? 0 : y / third.imag();
    return normalized({(x - up * third.real()) / length, up});
  }

  /*
   * An angle from a side, told from another one if that one's corner is far less acute or obtuse: a direction in two
   * sides that are nearly parallel would lose its digits.
   */
  Ray_start told_well(const Surface_location& at, Input_halfedge_index h, double angle) const
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
      if(before * length(side) < least) { // twice the area is this times the sine of the corner
        least = before * length(side);
        best = side;
        best_angle = angle;
      }
    }
    const Face_direction direction = in_face(best, std::cos(best_angle), std::sin(best_angle));
    // An angle along the border is along it, though rounding leads out of the surface, or into it a little.
    const double off = std::abs(std::sin(angle_at_edge));
    if(kind(at) == Location_kind::EDGE && input().is_border(twin_index(at.halfedge)) &&
       off <= (away_from_side(at.halfedge, best, direction) < 0 ? off_border : into_border))
      return {at, {std::copysign(1, std::cos(angle_at_edge)), 0}, false, 0};
    return {{best, weights_in_face(input(), at, best)}, direction, false, 0};
  }

  // How the weight opposite to a side of a face changes in a direction that is told from any side; its sign is exact.
  double away_from_side(Input_halfedge_index side, Input_halfedge_index told_from, const Face_direction& d) const
  {
    if(side == told_from)
      return d[1];
    return input().next(side) == told_from ? d[0] : -d[0] - d[1];
  }

  double length(Input_halfedge_index h) const { return m_triangulation.metric().length(input(), h); }

  // In the corner at the tail of h, whose sides are met by rounding as well.
  Face_direction inside_corner(Input_halfedge_index h, double angle, double whole) const
  {
    if(angle <= 0)
      return {1, 0};
    if(angle >= whole)
      return {0, 1};
    const Face_direction d = in_face(h, std::cos(angle), std::sin(angle));
    return normalized({(std::max)(d[0], 0.0), (std::max)(d[1], 0.0)});
  }

  // Over a power of two, so that the larger number is between 1 and 2, without numbers whose products could underflow.
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_RAY_H
