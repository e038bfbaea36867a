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
 * ring may scale a strip by a positive integer at each face instead of dividing, `Ring::rescale()`.
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
    const Sides first = sides(result.reference);
    Complex right = {m_ring.rescale(m_ring.integer(1), first.squared_length), m_ring.integer(0)};
    const Complex side = times({m_ring.integer(1), m_ring.integer(0)}, first.next);
    Complex left = add(right, side), gate = negate(side);
    for(std::size_t i = 0;; ++i) {
      result.gates.push_back({right, left});
      const Index entered = Triangulation::twin(word.crossed[i]);
      const Sides f = sides(entered);
      right = rescale(right, f.squared_length);
      left = rescale(left, f.squared_length);
      const Complex to_apex = times(gate, f.next);
      const Complex apex = add(right, to_apex);
      if(i + 1 == word.crossed.size()) {
        result.end = apex;
        return result;
      }
      const bool is_leaving_right = word.crossed[i + 1] == input.next(entered);
      gate = negate(is_leaving_right ? to_apex : times(gate, f.previous));
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

  /* The sine of the angle from u to v, up to a positive factor. */
  Number cross(const Complex& u, const Complex& v) const
  {
    return m_ring.add(m_ring.multiply(u.re, v.im), m_ring.negate(m_ring.multiply(u.im, v.re)));
  }

private:
  const Exact_face& face(Index h) const { return m_triangulation.exact_input_face(h); }

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
