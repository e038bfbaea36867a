// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_RAYS_EXACT_RAY_SIDE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_RAYS_EXACT_RAY_SIDE_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/internal/exact/Ball_ring.h>
#include <CGAL/Flip_geodesics/internal/exact/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/exact/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/exact/Unfolding_chain.h>

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
  template <class Triangulation, class ExactFaces>
  Sign operator()(const Triangulation& triangulation, const ExactFaces& faces, const Surface_location& place,
                  const Face_direction& direction, const std::vector<Input_halfedge_index>& crossed,
                  Decision_statistics& statistics)
  {
    const Ring ring;
    const Arithmetic arithmetic(ring);
    if(!m_state)
      start(triangulation, faces(place.halfedge), place, direction, crossed.front(), arithmetic);
    State& state = *m_state;
    const auto step = [&](std::size_t i, bool is_leaving_right) {
      return Unfolding_step{is_leaving_right ? Kind::NEW_LEFT : Kind::NEW_RIGHT, &faces(twin_index(crossed[i]))};
    };
    for(; state.number_of_gates + 1 < crossed.size(); ++state.number_of_gates) {
      const std::size_t i = state.number_of_gates;
      state.corner.steps.push_back(step(i, crossed[i + 1] == triangulation.input().next(twin_index(crossed[i]))));
      arithmetic.apply(state.corner, state.corner.steps.back(), state.gate);
    }
    const Unfolding_step last = step(crossed.size() - 1, false);
    Arithmetic::Gate gate = state.gate;
    arithmetic.apply(state.corner, last, gate);
    const Uncertain<Sign> quick = ring.sign(arithmetic.multiply(state.value, gate.right).im);
    if(quick.is_certain()) {
      ++statistics.by_precision;
      return quick.make_certain();
    }
    Unfolding_chain corner = state.corner;
    corner.steps.push_back(last);
    return Exact_sign(statistics)({state.direction, corner});
  }

private:
  template <class Triangulation>
  void start(const Triangulation& triangulation, const Exact_face& face, const Surface_location& place,
             const Face_direction& direction, Input_halfedge_index crossed, const Arithmetic& arithmetic)
  {
    const std::array<Integer, 3> w = integer_weights(place.weights);
    const std::array<Integer, 2> d = to_integers(direction);
    m_state = State();
    State& state = *m_state;
    state.direction.right = Side_combination(face, {d[0], Integer(0), Integer(-d[1])});
    state.direction.steps.push_back({Kind::START_INSIDE, &face});
    state.direction.is_conjugate = true;
    state.value = arithmetic.value(state.direction);
    const auto corner = [&](int i) { // from the place, times the sum of the weights
      std::array<Integer, 3> sides = {0, 0, 0};
      sides[(i + 2) % 3] = w[(i + 2) % 3];
      sides[i] = -w[(i + 1) % 3];
      return Side_combination(face, sides);
    };
    const int side = crossed == place.halfedge ? 0 : (crossed == triangulation.input().next(place.halfedge) ? 1 : 2);
    std::array<Integer, 3> to_right = {0, 0, 0};
    to_right[side] = -(w[0] + w[1] + w[2]);
    state.corner.right = corner(side);
    state.corner.left = corner((side + 1) % 3);
    state.corner.to_right = Side_combination(face, to_right);
    state.corner.steps.push_back({Kind::START_INSIDE, &face});
    state.gate = arithmetic.first_gate();
    arithmetic.apply(state.corner, state.corner.steps.back(), state.gate);
  }

  std::optional<State> m_state; // none before the first question
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_RAYS_EXACT_RAY_SIDE_H
