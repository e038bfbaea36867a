// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_STRAIGHT_STRIP_H
#define CGAL_FLIP_GEODESICS_INTERNAL_STRAIGHT_STRIP_H

#include <CGAL/Flip_geodesics/internal/Exact_wedge.h>
#include <CGAL/Flip_geodesics/internal/Strip.h>
#include <CGAL/Flip_geodesics/internal/Wedge_comparison.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Does the straight line from the tail to the head of a word run through the inside of its strip, exactly? Each crossed
 * edge must have one end strictly on either side.
 */
template <class Triangulation>
class Straight_strip
{
public:
  Straight_strip(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
  {
  }

  bool operator()(const Crossing_word& word) const
  {
    if(word.crossed.empty())
      return true;
    switch(in_double(Strip<Triangulation>(m_triangulation, word))) {
    case POSITIVE:
      ++m_statistics.by_strip;
      return true;
    case NEGATIVE:
      ++m_statistics.by_strip;
      return false;
    case ZERO:
      break;
    }
    return exactly(word);
  }

private:
  // POSITIVE if every gate is passed between its ends, NEGATIVE if one is not, ZERO if the error hides it.
  static Sign in_double(const Strip<Triangulation>& strip)
  {
    const std::complex<double> end = strip.end();
    Sign result = strip.relative_error() < 1 ? POSITIVE : ZERO;
    for(const auto& gate : strip.gates()) {
      const double left = std::imag(std::conj(end) * gate.left), right = -std::imag(std::conj(end) * gate.right);
      const double left_error = std::abs(end) * (gate.left_error + 2 * strip.relative_error() * std::abs(gate.left));
      const double right_error = std::abs(end) * (gate.right_error + 2 * strip.relative_error() * std::abs(gate.right));
      if(left < -left_error || right < -right_error)
        return NEGATIVE;
      if(!(left > left_error && right > right_error))
        result = ZERO;
    }
    return result;
  }

  bool exactly(const Crossing_word& word) const
  {
    const std::vector<Integer> squares = squared_areas(word);
    const Uncertain<bool> quick = in_ring(Ball_ring<50>(), word);
    if(quick.is_certain()) {
      ++m_statistics.by_precision;
      return quick.make_certain();
    }
    const Root_base base(squares);
    if(base.generators().size() <= most_exact_roots) {
      ++m_statistics.by_roots;
      return in_ring(Multiquadratic_ring(base), word).make_certain();
    }
    ++m_statistics.by_precision;
    const Uncertain<bool> slow = in_ring(Ball_ring<290>(), word);
    return slow.is_certain() && slow.make_certain(); // what cannot be proven straight is not
  }

  template <class Ring>
  Uncertain<bool> in_ring(const Ring& ring, const Crossing_word& word) const
  {
    const Exact_unfolding<Triangulation, Ring> unfolding(m_triangulation, ring);
    const auto strip = unfolding.strip(word);
    Uncertain<bool> result = true;
    for(const auto& gate : strip.gates) {
      const Uncertain<Sign> left = ring.sign(unfolding.cross(strip.end, gate.left));
      const Uncertain<Sign> right = ring.sign(unfolding.cross(gate.right, strip.end));
      result = result & (left == POSITIVE) & (right == POSITIVE);
      if(certainly_not(result))
        return false;
    }
    return result;
  }

  std::vector<Integer> squared_areas(const Crossing_word& word) const
  {
    std::vector<Integer> result = {m_triangulation.exact_input_face(word.crossed.front()).doubled_area_squared};
    for(Index h : word.crossed)
      result.push_back(m_triangulation.exact_input_face(Triangulation::twin(h)).doubled_area_squared);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_STRAIGHT_STRIP_H
