// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/internal/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/internal/Wedge_angle.h>

#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

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
      sine = exact_sine({words});
    return comparison(sine);
  }

  /* The sum of two angles, each at most pi. */
  Comparison_result compare_sum(const Wedge& a, const Wedge& b) const
  {
    const Wedge_angle at_a = wedge_angle(m_triangulation, a.from, a.to);
    const Wedge_angle at_b = wedge_angle(m_triangulation, b.from, b.to);
    const Comparison_result quick = quickly({at_a.value + at_b.value, at_a.error + at_b.error});
    return quick != EQUAL ? quick : comparison(exact_sine({words_of(a), words_of(b)}));
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

  Sign exact_sine(const std::vector<Wedge_words>& wedges) const
  {
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    std::vector<Unfolding_chain> chains;
    bool is_opposite = false;
    for(const Wedge_words& w : wedges) {
      chains.push_back(unfolding.head(w.from, false));
      chains.push_back(unfolding.head(w.to, true));
      if(!m_triangulation.is_inserted(w.from.tail))
        chains.push_back(unfolding.corners(tail_anchor(m_triangulation, w.from), w.steps));
      else // at a point of an edge, corners are straight angles
        is_opposite = is_opposite != (w.steps % 2 != 0);
    }
    const Sign sine = Exact_sign(m_statistics)(chains);
    return is_opposite ? CGAL::opposite(sine) : sine;
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_COMPARISON_H
