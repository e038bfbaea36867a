// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/internal/Ball_ring.h>
#include <CGAL/Flip_geodesics/internal/Exact_wedge.h>
#include <CGAL/Flip_geodesics/internal/Multiquadratic.h>
#include <CGAL/Flip_geodesics/internal/Wedge_angle.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* Arithmetic with r independent roots costs 2^r integers a number; with more, zeros are not proven. */
constexpr std::size_t most_exact_roots = 12;

/*
 * Compares the angle clockwise from halfedge a to halfedge b of one vertex with pi: the sign of the exact real number
 * that the input defines. In stages: strips in double; points in one plane; arithmetic in the field of all roots.
 */
template <class Triangulation>
class Wedge_comparison
{
public:
  Wedge_comparison(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
  {
  }

  Comparison_result operator()(Index a, Index b) const
  {
    const double pi = boost::math::constants::pi<double>();
    const Wedge_angle angle = wedge_angle(m_triangulation, a, b);
    if(std::abs(angle.value - pi) > angle.error) {
      ++m_statistics.by_strip;
      return angle.value < pi ? SMALLER : LARGER;
    }
    return compare_exactly(a, b);
  }

private:
  // Near pi: the sine's sign is that of pi - angle.
  Comparison_result compare_exactly(Index a, Index b) const
  {
    const Crossing_word word_a = m_triangulation.crossing_word(a), word_b = m_triangulation.crossing_word(b);
    const Index steps = m_triangulation.input_edges_in_wedge(a, b) + (word_a.along != null_index ? 1 : 0);
    Sign sine;
    if(m_triangulation.metric().sine_in_plane(m_triangulation.input(), word_a, word_b, steps, sine)) {
      ++m_statistics.by_plane;
      m_statistics.zeros_by_plane += sine == ZERO ? 1 : 0;
    } else {
      sine = sine_by_roots(word_a, word_b, steps);
    }
    return sine == POSITIVE ? SMALLER : (sine == ZERO ? EQUAL : LARGER);
  }

  // Precision finds the sign of what is not zero; exact arithmetic proves what is, and is the faster with few roots.
  Sign sine_by_roots(const Crossing_word& word_a, const Crossing_word& word_b, Index steps) const
  {
    constexpr std::size_t few = 1;
    const std::vector<Integer> squares = radicands(word_a, word_b, steps);
    if(squares.size() > few) {
      const Uncertain<Sign> sign = sine_in(Ball_ring<50>(), word_a, word_b, steps);
      if(sign.is_certain()) {
        ++m_statistics.by_precision;
        return sign.make_certain();
      }
    }
    const Root_base base(squares);
    m_statistics.most_roots = (std::max)(m_statistics.most_roots, base.generators().size());
    if(base.generators().size() > most_exact_roots)
      return sine_by_precision(word_a, word_b, steps);
    ++m_statistics.by_roots;
    const Multiquadratic_ring ring(base);
    const Sign sign = sine_in(ring, word_a, word_b, steps);
    m_statistics.zeros_by_roots += sign == ZERO ? 1 : 0;
    return sign;
  }

  // Too many roots for a proof that a number is zero: 290 digits without a sign are taken for one, and counted.
  Sign sine_by_precision(const Crossing_word& word_a, const Crossing_word& word_b, Index steps) const
  {
    const Uncertain<Sign> sign = sine_in(Ball_ring<290>(), word_a, word_b, steps);
    ++m_statistics.by_precision;
    m_statistics.unproven_zeros += sign.is_certain() ? 0 : 1;
    return sign.is_certain() ? sign.make_certain() : ZERO;
  }

  template <class Ring>
  auto sine_in(const Ring& ring, const Crossing_word& word_a, const Crossing_word& word_b, Index steps) const
  {
    const Exact_unfolding<Triangulation, Ring> unfolding(m_triangulation, ring);
    return ring.sign(unfolding.turn(unfolding.strip(word_a), unfolding.strip(word_b), steps).im);
  }

  // The squared areas of all faces that the strips and the fan between them touch.
  std::vector<Integer> radicands(const Crossing_word& word_a, const Crossing_word& word_b, Index steps) const
  {
    const auto& input = m_triangulation.input();
    std::vector<Integer> result;
    const auto add = [&](Index h) { result.push_back(m_triangulation.exact_input_face(h).doubled_area_squared); };
    for(const Crossing_word* word : {&word_a, &word_b}) {
      if(!word->crossed.empty())
        add(word->crossed.front());
      for(Index h : word->crossed)
        add(Triangulation::twin(h));
    }
    Index h = word_a.along != null_index ? word_a.along : input.next(input.next(word_a.crossed.front()));
    for(Index i = 0; i < steps; ++i) {
      add(Triangulation::twin(h));
      h = input.next(Triangulation::twin(h));
    }
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H
