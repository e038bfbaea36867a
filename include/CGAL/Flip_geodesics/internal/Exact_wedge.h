// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_EXACT_WEDGE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_EXACT_WEDGE_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/internal/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/Multiquadratic.h>

#include <algorithm>
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
 * strip is scaled by a positive integer at each face instead of being divided.
 */
template <class Triangulation, class Ring>
class Exact_unfolding
{
public:
  using Number = typename Ring::Number;
  using Complex = Ring_complex<Ring>;

  struct Gate
  {
    Complex right, left; // each up to a positive factor
  };

  struct Exact_strip
  {
    Index reference; // the input halfedge along the positive real axis
    Complex end;
    std::vector<Gate> gates;
  };

  Exact_unfolding(const Triangulation& triangulation, const Ring& ring)
    : m_triangulation(triangulation)
    , m_ring(ring)
  {
  }

  Exact_strip strip(const Crossing_word& word) const
  {
    if(word.along != null_index)
      return {word.along, {m_ring.integer(1), m_ring.integer(0)}, {}};
    const auto& input = m_triangulation.input();
    Exact_strip result;
    result.reference = input.next(input.next(word.crossed.front()));
    const Exact_face first = face(result.reference);
    Complex right = {m_ring.integer(first.squared_length), m_ring.integer(0)};
    const Complex side = next_side({m_ring.integer(1), m_ring.integer(0)}, first);
    Complex left = add(right, side), gate = negate(side);
    for(std::size_t i = 0;; ++i) {
      result.gates.push_back({right, left});
      const Index entered = Triangulation::twin(word.crossed[i]);
      const Exact_face f = face(entered);
      right = scale(right, f.squared_length);
      left = scale(left, f.squared_length);
      const Complex to_apex = next_side(gate, f);
      const Complex apex = add(right, to_apex);
      if(i + 1 == word.crossed.size()) {
        result.end = apex;
        return result;
      }
      const bool is_leaving_right = word.crossed[i + 1] == input.next(entered);
      gate = negate(is_leaving_right ? to_apex : previous_side(gate, f));
      (is_leaving_right ? left : right) = apex;
    }
  }

  /* The turn from the direction of b counterclockwise to that of a, over the given number of input corners. */
  Complex turn(const Exact_strip& a, const Exact_strip& b, Index steps) const
  {
    Complex result = multiply(a.end, conjugate(b.end));
    Index h = a.reference;
    for(Index i = 0; i < steps; ++i) {
      const Index t = Triangulation::twin(h);
      const Exact_face f = face(t);
      // From next(t) to -t: -conj(dot + i root) up to a positive factor.
      result = times_face(result, -f.dot_next, f.doubled_area_squared, 1);
      h = m_triangulation.input().next(t);
    }
    return result;
  }

  /* The sine of the angle from u to v, up to a positive factor. */
  Number cross(const Complex& u, const Complex& v) const
  {
    return m_ring.add(m_ring.multiply(u.re, v.im), m_ring.negate(m_ring.multiply(u.im, v.re)));
  }

private:
  Exact_face face(Index h) const { return m_triangulation.metric().exact_face(m_triangulation.input(), h); }

  // h * (dot +- i root)
  Complex times_face(const Complex& h, const Integer& dot, const Integer& squared_root, int sign) const
  {
    Number re_root = m_ring.times_root(h.re, squared_root), im_root = m_ring.times_root(h.im, squared_root);
    (sign > 0 ? im_root : re_root) = m_ring.negate(sign > 0 ? im_root : re_root);
    return {m_ring.add(m_ring.scale(h.re, dot), im_root), m_ring.add(m_ring.scale(h.im, dot), re_root)};
  }

  Complex next_side(const Complex& h, const Exact_face& f) const
  {
    return times_face(h, f.dot_next, f.doubled_area_squared, 1);
  }

  Complex previous_side(const Complex& h, const Exact_face& f) const
  {
    return times_face(h, f.dot_previous, f.doubled_area_squared, -1);
  }

  Complex add(const Complex& a, const Complex& b) const { return {m_ring.add(a.re, b.re), m_ring.add(a.im, b.im)}; }
  Complex negate(const Complex& a) const { return {m_ring.negate(a.re), m_ring.negate(a.im)}; }
  Complex conjugate(const Complex& a) const { return {a.re, m_ring.negate(a.im)}; }
  Complex scale(const Complex& a, const Integer& n) const { return {m_ring.scale(a.re, n), m_ring.scale(a.im, n)}; }
  Complex multiply(const Complex& a, const Complex& b) const
  {
    return {m_ring.add(m_ring.multiply(a.re, b.re), m_ring.negate(m_ring.multiply(a.im, b.im))),
            m_ring.add(m_ring.multiply(a.re, b.im), m_ring.multiply(a.im, b.re))};
  }

  const Triangulation& m_triangulation;
  const Ring& m_ring;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_EXACT_WEDGE_H
