// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_WEDGE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/Word_ends.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A complex number over a ring with square roots of integers. */
template <class Ring>
struct Ring_complex
{
  typename Ring::Number re, im;
};

/*
 * Exact unfolding of crossing words, over any ring that knows the roots of the faces' squared areas. Directions only: a
 * ring may scale a strip by a positive integer at each face instead of dividing, `Ring::rescale()`.
 */
template <class Triangulation, class Ring>
class Exact_unfolding
{
public:
  using Number = typename Ring::Number;
  using Complex = Ring_complex<Ring>;

  /// The corners of the face that is left through a gate; all up to one positive factor.
  struct Gate
  {
    Complex right, left, behind;
  };

  struct Exact_strip
  {
    Index reference; // the input halfedge along the positive real axis
    Index tail;      // the vertex at the origin
    Complex end;
    std::vector<Gate> gates;
    Gate last; // the last face: its corners on the last gate, and the third one
  };

  Exact_unfolding(const Triangulation& triangulation, const Ring& ring)
    : m_triangulation(triangulation)
    , m_ring(ring)
  {
  }

  Exact_strip strip(const Crossing_word& word) const
  {
    Exact_strip result;
    result.reference = tail_anchor(m_triangulation, word);
    result.tail = word.tail;
    if(word.along != null_index)
      result.end = {m_ring.integer(1), m_ring.integer(0)};
    else if(word.crossed.empty())
      result.end = inside_face(word, result.reference);
    else
      unfold(word, result);
    return result;
  }

  /* The turn from the direction of b counterclockwise to that of a, over the given number of input corners. */
  Complex turn(const Exact_strip& a, const Exact_strip& b, Index steps) const
  {
    Complex result = multiply(a.end, conjugate(b.end));
    if(m_triangulation.is_inserted(a.tail)) // at a point of an edge, corners are straight angles
      return steps % 2 == 0 ? result : negate(result);
    Index h = a.reference;
    for(Index i = 0; i < steps; ++i) {
      const Index t = Triangulation::twin(h);
      const Exact_face& f = face(t);
      // From next(t) to -t: -conj(dot + i root) up to a positive factor.
      result = times(result, m_ring.side(-f.dot_next, f.doubled_area_squared, 1, f.squared_length));
      h = m_triangulation.input().next(t);
    }
    return result;
  }

  Complex multiply(const Complex& a, const Complex& b) const
  {
    return {m_ring.add(m_ring.multiply(a.re, b.re), m_ring.negate(m_ring.multiply(a.im, b.im))),
            m_ring.add(m_ring.multiply(a.re, b.im), m_ring.multiply(a.im, b.re))};
  }

  /* A point with weights in a face with three corners, up to a positive factor. */
  Complex point(const std::array<Complex, 3>& corners, const std::array<double, 3>& weights) const
  {
    const std::array<Integer, 3> w = integer_weights(weights);
    return add(add(times(corners[0], w[0]), times(corners[1], w[1])), times(corners[2], w[2]));
  }

  /* The sine of the angle from u to v, up to a positive factor. */
  Number cross(const Complex& u, const Complex& v) const
  {
    return m_ring.add(m_ring.multiply(u.re, v.im), m_ring.negate(m_ring.multiply(u.im, v.re)));
  }

private:
  const Exact_face& face(Index h) const { return m_triangulation.exact_input_face(h); }

  std::array<Integer, 3> weights(Index v, Index h) const
  {
    return integer_weights(vertex_weights(m_triangulation, v, h));
  }

  // The sides of a face, with h along the real axis.
  std::array<Complex, 3> laid_out(Index h) const
  {
    const Sides f = sides(h);
    const Complex unit = {m_ring.integer(1), m_ring.integer(0)};
    return {rescale(unit, f.squared_length), times(unit, f.next), times(unit, f.previous)};
  }

  // The vector between two points of one face.
  Complex inside_face(const Crossing_word& word, Index h) const
  {
    const auto v = laid_out(h);
    const auto from = weights(word.tail, h), to = weights(word.head, h);
    const Integer from_sum = from[0] + from[1] + from[2], to_sum = to[0] + to[1] + to[2];
    return add(times(v[0], to[1] * from_sum - from[1] * to_sum), times(v[2], from[2] * to_sum - to[2] * from_sum));
  }

  // From the tail of the word: the corners of its first face, and then gate by gate.
  void unfold(const Crossing_word& word, Exact_strip& result) const
  {
    const auto& input = m_triangulation.input();
    const auto v = laid_out(result.reference);
    const auto w = weights(word.tail, result.reference);
    std::array<Complex, 3> corners; // times the sum of the weights
    for(int i = 0; i < 3; ++i)
      corners[i] = add(times(v[(i + 2) % 3], w[(i + 2) % 3]), negate(times(v[i], w[(i + 1) % 3])));
    const Index first = word.crossed.front();
    const int side = first == result.reference ? 0 : (first == input.next(result.reference) ? 1 : 2);
    Complex right = corners[side], left = corners[(side + 1) % 3], behind = corners[(side + 2) % 3];
    Complex gate = times(negate(v[side]), w[0] + w[1] + w[2]);
    for(std::size_t i = 0;; ++i) {
      result.gates.push_back({right, left, behind});
      const Index entered = Triangulation::twin(word.crossed[i]);
      const Sides f = sides(entered);
      right = rescale(right, f.squared_length);
      left = rescale(left, f.squared_length);
      const Complex to_apex = times(gate, f.next);
      const Complex apex = add(right, to_apex);
      if(i + 1 == word.crossed.size()) {
        result.last = {right, left, apex};
        result.end = m_triangulation.is_inserted(word.head)
                         ? point({left, right, apex}, vertex_weights(m_triangulation, word.head, entered))
                         : apex;
        return;
      }
      const bool is_leaving_right = word.crossed[i + 1] == input.next(entered);
      gate = negate(is_leaving_right ? to_apex : times(gate, f.previous));
      behind = is_leaving_right ? left : right;
      (is_leaving_right ? left : right) = apex;
    }
  }

  // The other two sides of a face relative to the first, as factors.
  struct Sides
  {
    Integer squared_length;
    typename Ring::Side next, previous;
  };

  Sides sides(Index h) const
  {
    const Exact_face& f = face(h);
    return {f.squared_length, m_ring.side(f.dot_next, f.doubled_area_squared, 1, f.squared_length),
            m_ring.side(f.dot_previous, f.doubled_area_squared, -1, f.squared_length)};
  }

  Complex times(const Complex& h, const typename Ring::Side& side) const
  {
    return {m_ring.add(m_ring.times_dot(h.re, side), m_ring.negate(m_ring.times_root(h.im, side))),
            m_ring.add(m_ring.times_dot(h.im, side), m_ring.times_root(h.re, side))};
  }

  Complex times(const Complex& a, const Integer& n) const
  {
    return {m_ring.times_integer(a.re, n), m_ring.times_integer(a.im, n)};
  }

  Complex add(const Complex& a, const Complex& b) const { return {m_ring.add(a.re, b.re), m_ring.add(a.im, b.im)}; }
  Complex negate(const Complex& a) const { return {m_ring.negate(a.re), m_ring.negate(a.im)}; }
  Complex conjugate(const Complex& a) const { return {a.re, m_ring.negate(a.im)}; }
  Complex rescale(const Complex& a, const Integer& n) const
  {
    return {m_ring.rescale(a.re, n), m_ring.rescale(a.im, n)};
  }

  const Triangulation& m_triangulation;
  const Ring& m_ring;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_WEDGE_H
