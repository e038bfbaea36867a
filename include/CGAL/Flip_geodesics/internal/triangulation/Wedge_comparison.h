// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_COMPARISON_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_COMPARISON_H

#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/planar_sine.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/triangulation/wedge_between.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/enum.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/*
 * Compares angles with pi by the sign of the exact real number that the input defines. The stages are: strips in
 * doubles, unless a filter of the same precision has failed; points in one plane or on developable regions with
 * parallel rulings; edges as double-double vectors; arithmetic in the field of all square roots. For long edge
 * sequences, vectors precede points.
 */
template <class Triangulation>
class Wedge_comparison
{
public:
  /* The wedge clockwise from one halfedge of a vertex to another; the full turn if they are the same. */
  struct Wedge
  {
    Halfedge_index from, to;
  };

  /* If a filter has failed, the remaining angles, or their sum, are known to be strictly between 0 and 2 pi unless a
   * face is degenerate. */
  Wedge_comparison(const Triangulation& triangulation, Decision_statistics& statistics, bool is_filtered = false)
    : m_triangulation(triangulation)
    , m_statistics(statistics)
    , m_is_filtered(is_filtered)
  {
  }

  Comparison_result operator()(Halfedge_index from, Halfedge_index to) const
  {
    if(!m_is_filtered) {
      const Comparison_result quick = by_strips({{from, to}});
      if(quick != EQUAL)
        return quick;
    }
    const bool are_long = m_is_filtered && have_long_sequences(from, to);
    if(are_long) {
      const Comparison_result quick = by_vectors({{from, to}});
      if(quick != EQUAL)
        return quick;
    }
    const Wedge_edge_sequences sequences = wedge_sequences(m_triangulation, from, to);
    Sign sine;
    if(is_in_plane(sequences, sine))
      return comparison(sine);
    const Comparison_result quick = are_long ? EQUAL : by_vectors({{from, to}});
    return quick != EQUAL ? quick : comparison(exact_sine({sequences}));
  }

  /* Compares for edge sequences that need not be edges of the triangulation; not around a point inside a face. */
  Comparison_result operator()(const Wedge_edge_sequences& sequences) const
  {
    const Comparison_result quick = counted(wedge_angle(m_triangulation, sequences).compare_with_straight());
    if(quick != EQUAL)
      return quick;
    Sign sine;
    return comparison(is_in_plane(sequences, sine) ? sine : exact_sine({sequences}));
  }

  /* Compares the sum of two angles, each at most pi, after a filter failure. */
  Comparison_result compare_sum(const Wedge& a, const Wedge& b) const
  {
    const Comparison_result quick = by_vectors({a, b});
    if(quick != EQUAL)
      return quick;
    return comparison(
        exact_sine({wedge_sequences(m_triangulation, a.from, a.to), wedge_sequences(m_triangulation, b.from, b.to)}));
  }

private:
  // Compares the sum of the angles; EQUAL if the errors hide the sign.
  Comparison_result by_vectors(const std::vector<Wedge>& wedges) const
  {
    Precise_angle_sum<Triangulation> sum;
    for(const Wedge& wedge : wedges)
      sum.add(Precise_wedge<Triangulation>(m_triangulation, wedge.from, wedge.to));
    if(m_is_filtered && !sum.has_bound())
      return by_strips(wedges);
    return counted(sum.compare_with_straight());
  }

  Comparison_result by_strips(const std::vector<Wedge>& wedges) const
  {
    Wedge_angle sum = {0, 0};
    for(const Wedge& wedge : wedges) {
      const Wedge_angle angle = wedge_angle(m_triangulation, wedge.from, wedge.to);
      sum = {sum.value + angle.value, sum.error + angle.error};
    }
    return counted(sum.compare_with_straight());
  }

  Comparison_result counted(Comparison_result by_strip) const
  {
    m_statistics.by_strip += by_strip != EQUAL ? 1 : 0;
    return by_strip;
  }

  // For angles between 0 and 2 pi, the sine has the sign of pi - angle.
  static Comparison_result comparison(Sign sine)
  {
    return sine == POSITIVE ? SMALLER : (sine == ZERO ? EQUAL : LARGER);
  }

  // Returns whether examining the edge sequences of two edges takes longer than deriving their vectors.
  bool have_long_sequences(Halfedge_index from, Halfedge_index to) const
  {
    constexpr Index many_letters = 16;
    if constexpr(Internals<Triangulation>::has_precise_numbers)
      return m_triangulation.crossings(edge_of(from)) + m_triangulation.crossings(edge_of(to)) > many_letters;
    else
      return false;
  }

  bool is_in_plane(const Wedge_edge_sequences& sequences, Sign& sine) const
  {
    const auto by_metric = [&](Flat_edges& flat_edges) {
      return sine_in_plane(m_triangulation.metric(), m_triangulation.input(), sequences.from, sequences.to,
                           sequences.steps, flat_edges, sine);
    };
    bool result;
    if constexpr(Internals<Triangulation>::has_precise_numbers) {
      result = by_metric(Internals<Triangulation>::flat_edges(m_triangulation));
    } else {
      Flat_edges none;
      result = by_metric(none);
    }
    m_statistics.by_plane += result ? 1 : 0;
    m_statistics.zeros_by_plane += result && sine == ZERO ? 1 : 0;
    return result;
  }

  Sign exact_sine(const std::vector<Wedge_edge_sequences>& wedges) const
  {
    const Unfolding_chains<Triangulation> unfolding(m_triangulation);
    std::vector<Unfolding_chain> chains;
    chains.reserve(3 * wedges.size());
    bool is_opposite = false;
    for(const Wedge_edge_sequences& w : wedges) {
      chains.push_back(unfolding.head(w.from, false));
      chains.push_back(unfolding.head(w.to, true));
      if(!m_triangulation.is_inserted(w.from.tail))
        chains.push_back(unfolding.corners(tail_anchor(m_triangulation, w.from), w.steps));
      else // at a point of an edge, corners are straight angles
        is_opposite = is_opposite != (w.steps % 2 != 0);
    }
    const Sign sine = Exact_sign(m_statistics, sign_work_limit(m_triangulation))(chains);
    return is_opposite ? CGAL::opposite(sine) : sine;
  }

  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
  bool m_is_filtered;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_COMPARISON_H
