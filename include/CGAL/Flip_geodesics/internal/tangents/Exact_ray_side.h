// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_EXACT_RAY_SIDE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_EXACT_RAY_SIDE_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/numbers/Ball_ring.h>
#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <optional>
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

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TANGENTS_EXACT_RAY_SIDE_H
