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
 * Compares angles with pi: the sign of the exact real number that the input defines. In stages: strips in double;
 * points in one plane; arithmetic in the field of all roots.
 */
template <class Triangulation>
class Wedge_comparison
{
public:
  /* The wedge clockwise from one halfedge of a vertex to another; all the way round if they are the same. */
  struct Wedge
  {
    Index from, to;
  };

  Wedge_comparison(const Triangulation& triangulation, Decision_statistics& statistics)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
  {
  }

  Comparison_result operator()(Index from, Index to) const
  {
    const Comparison_result quick = quickly(wedge_angle(m_triangulation, from, to));
    if(quick != EQUAL)
      return quick;
    const Wedge_words words = words_of({from, to});
    Sign sine;
    if(m_triangulation.metric().sine_in_plane(m_triangulation.input(), words.from, words.to, words.steps, sine))
      count_plane(sine);
    else
      sine = sine_by_roots({words});
    return comparison(sine);
  }

  /* The sum of two angles, each at most pi. */
  Comparison_result compare_sum(const Wedge& a, const Wedge& b) const
  {
    const Wedge_angle at_a = wedge_angle(m_triangulation, a.from, a.to);
    const Wedge_angle at_b = wedge_angle(m_triangulation, b.from, b.to);
    const Comparison_result quick = quickly({at_a.value + at_b.value, at_a.error + at_b.error});
    return quick != EQUAL ? quick : comparison(sine_by_roots({words_of(a), words_of(b)}));
  }

private:
  struct Wedge_words
  {
    Crossing_word from, to;
    Index steps; // input corners between their reference halfedges
  };

  // EQUAL if the error hides the sign.
  Comparison_result quickly(const Wedge_angle& angle) const
  {
    const double pi = boost::math::constants::pi<double>();
    if(!(std::abs(angle.value - pi) > angle.error))
      return EQUAL;
    ++m_statistics.by_strip;
    return angle.value < pi ? SMALLER : LARGER;
  }

  // Near pi: the sine's sign is that of pi - angle.
  static Comparison_result comparison(Sign sine)
  {
    return sine == POSITIVE ? SMALLER : (sine == ZERO ? EQUAL : LARGER);
  }

  void count_plane(Sign sine) const
  {
    ++m_statistics.by_plane;
    m_statistics.zeros_by_plane += sine == ZERO ? 1 : 0;
  }

  Wedge_words words_of(const Wedge& wedge) const
  {
    Wedge_words result = {m_triangulation.crossing_word(wedge.from), m_triangulation.crossing_word(wedge.to), 0};
    result.steps =
        m_triangulation.input_edges_in_wedge(wedge.from, wedge.to) + (result.from.along != null_index ? 1 : 0);
    return result;
  }

  // Precision finds the sign of what is not zero; exact arithmetic proves what is, and is the faster with few roots.
  Sign sine_by_roots(const std::vector<Wedge_words>& wedges) const
  {
    constexpr std::size_t few = 1;
    const std::vector<Integer> squares = radicands(wedges);
    if(squares.size() > few) {
      const Uncertain<Sign> sign = sine_in(Ball_ring<50>(), wedges);
      if(sign.is_certain()) {
        ++m_statistics.by_precision;
        return sign.make_certain();
      }
    }
    const Root_base base(squares);
    m_statistics.most_roots = (std::max)(m_statistics.most_roots, base.generators().size());
    if(base.generators().size() > most_exact_roots)
      return sine_by_precision(wedges);
    ++m_statistics.by_roots;
    const Multiquadratic_ring ring(base);
    const Sign sign = sine_in(ring, wedges);
    m_statistics.zeros_by_roots += sign == ZERO ? 1 : 0;
    return sign;
  }

  // Too many roots for a proof that a number is zero: 290 digits without a sign are taken for one, and counted.
  Sign sine_by_precision(const std::vector<Wedge_words>& wedges) const
  {
    const Uncertain<Sign> sign = sine_in(Ball_ring<290>(), wedges);
    ++m_statistics.by_precision;
    m_statistics.unproven_zeros += sign.is_certain() ? 0 : 1;
    return sign.is_certain() ? sign.make_certain() : ZERO;
  }

  // Of the sum of all wedges.
  template <class Ring>
  auto sine_in(const Ring& ring, const std::vector<Wedge_words>& wedges) const
  {
    const Exact_unfolding<Triangulation, Ring> unfolding(m_triangulation, ring);
    Ring_complex<Ring> turn = {ring.integer(1), ring.integer(0)};
    for(const Wedge_words& w : wedges) {
      const auto next = unfolding.turn(unfolding.strip(w.from), unfolding.strip(w.to), w.steps);
      turn = &w == &wedges.front() ? next : unfolding.multiply(turn, next);
    }
    return ring.sign(turn.im);
  }

  // The squared areas of all faces that the strips and the fans between them touch.
  std::vector<Integer> radicands(const std::vector<Wedge_words>& wedges) const
  {
    std::vector<Integer> result;
    for(const Wedge_words& w : wedges)
      add_radicands(w, result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void add_radicands(const Wedge_words& wedge, std::vector<Integer>& result) const
  {
    const auto& input = m_triangulation.input();
    const auto add = [&](Index h) { result.push_back(m_triangulation.exact_input_face(h).doubled_area_squared); };
    for(const Crossing_word* word : {&wedge.from, &wedge.to}) {
      if(word->along == null_index)
        add(word->first_face());
      for(Index h : word->crossed)
        add(Triangulation::twin(h));
    }
    Index h = tail_anchor(m_triangulation, wedge.from);
    for(Index i = 0; i < wedge.steps && !m_triangulation.is_inserted(wedge.from.tail); ++i) {
      add(Triangulation::twin(h));
      h = input.next(Triangulation::twin(h));
    }
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H
