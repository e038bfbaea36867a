// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_COMPARISON_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_COMPARISON_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/containers.h>
#include <CGAL/Flip_geodesics/internal/surface/planar_sine.h>
#include <CGAL/Flip_geodesics/internal/triangulation/refresh_face.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/enum.h>

#include <boost/functional/hash.hpp>
#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace CGAL::Flip_geodesics {
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
    const Comparison_result quick = counted(wedge_rotation(m_triangulation, sequences).angle.compare_with_straight());
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

/* At the head of an edge sequence, for its reverse direction. */
template <class Triangulation>
Edge_sequence_angle head_angle(const Triangulation& triangulation, const Strip<Triangulation>& strip,
                               const Edge_sequence& sequence)
{
  if(strip.arrival_reference() == null_index)
    return tail_angle(Strip<Triangulation>(triangulation, sequence.reversed()));
  return {strip.arrival_reference(), angle_from_reference(strip.arrival()), strip.arrival_error()};
}

/* A straight line as seen from one of its ends. */
struct Seen_edge_sequence
{
  const Edge_sequence& sequence;
  bool is_from_tail;
  Edge_sequence_angle angle;

  Edge_sequence seen() const { return is_from_tail ? sequence : sequence.reversed(); }
};

/* Returns the exact position of one straight line relative to another in one corner: CLOCKWISE, COUNTERCLOCKWISE, or
 * COLLINEAR if they have the same direction. In a degenerate face that is a half plane, they can be opposite. */
template <class Triangulation>
Orientation order_in_one_corner(const Triangulation& triangulation, Decision_statistics& statistics,
                                const Seen_edge_sequence& from, const Seen_edge_sequence& to)
{
  constexpr double half_pi = boost::math::constants::half_pi<double>();
  const double turn = from.angle.angle - to.angle.angle, error = 1.6 * (from.angle.error + to.angle.error);
  if(std::abs(turn) > error && std::abs(turn) < half_pi)
    return turn > 0 ? CLOCKWISE : COUNTERCLOCKWISE;
  const Unfolding_chains<Triangulation> unfolding(triangulation);
  const Edge_sequence first = from.seen(), second = to.seen();
  const Sign sine = Exact_sign(statistics, sign_work_limit(triangulation))(
      {unfolding.head(first, false), unfolding.head(second, true)});
  if(sine == ZERO && std::abs(turn) < half_pi)
    return COLLINEAR;
  return sine == POSITIVE || (sine == ZERO && turn > 0) ? CLOCKWISE : COUNTERCLOCKWISE;
}

/* The exact comparison of an angle with pi, and the angle, rounded. */
struct Compared_angle
{
  Comparison_result with_straight;
  double value;
};

/* Computes the angle clockwise from one straight line to another around a vertex of the input; LARGER if the border is
 * in between, 0 if the lines have the same direction. */
template <class Triangulation>
Compared_angle compared_angle_clockwise(const Triangulation& triangulation, Decision_statistics& statistics,
                                        const Seen_edge_sequence& from, const Seen_edge_sequence& to)
{
  const auto& input = triangulation.input();
  const Input_halfedge_index first = from.angle.reference, last = to.angle.reference;
  const Orientation order = first == last ? order_in_one_corner(triangulation, statistics, from, to) : COUNTERCLOCKWISE;
  if(order == COLLINEAR)
    return {SMALLER, 0};
  const Index steps = order == CLOCKWISE ? 0 : number_of_corners_clockwise(input, first, last);
  if(steps < 0)
    return {LARGER, std::numeric_limits<double>::infinity()};
  for_each_corner_clockwise(input, first, steps, [&](Input_halfedge_index t) { check_triangle(input, t); });
  const Wedge_angle angle = wedge_angle(triangulation, from.angle, to.angle, steps);
  const Comparison_result quick = angle.compare_with_straight();
  if(quick == EQUAL)
    return {
        Wedge_comparison<Triangulation>(triangulation, statistics)(Wedge_edge_sequences{from.seen(), to.seen(), steps}),
        angle.value};
  ++statistics.by_strip;
  return {quick, angle.value};
}

template <class Triangulation>
Comparison_result compare_clockwise(const Triangulation& triangulation, Decision_statistics& statistics,
                                    const Seen_edge_sequence& from, const Seen_edge_sequence& to)
{
  return compared_angle_clockwise(triangulation, statistics, from, to).with_straight;
}

/*
 * Measures edges of a triangulation, and the wedges between them, from the input: of the results of flips, only
 * integers are used. The straightness of curves, chains of halfedges and paths of a tree is that of their edges and
 * joints.
 */
template <class Triangulation>
class Edge_straightness
{
public:
  using Measured_edge = internal::Measured_edge;

  explicit Edge_straightness(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  Measured_edge operator()(Halfedge_index h) const
  {
    const Edge_sequence sequence = m_triangulation.edge_sequence(h);
    return measured(h, sequence, Strip<Triangulation>(m_triangulation, sequence));
  }

  /* Measures the edge of h and, if requested, determines whether it is straight. An edge sequence that is not that of a
   * strip between the ends of h is not measured. */
  Measured_edge certified(Halfedge_index h, bool is_asked, Decision_statistics& statistics) const
  {
    const Edge_sequence sequence = m_triangulation.edge_sequence(h);
    const Straight_strip<Triangulation> is_straight(m_triangulation, statistics);
    Measured_edge result;
    result.has_strip = is_strip(h, sequence);
    if(!result.has_strip)
      return result;
    const Strip<Triangulation> strip(m_triangulation, sequence);
    result = measured(h, sequence, strip);
    result.is_straight = !is_asked || is_straight(sequence, strip);
    return result;
  }

  /* Returns whether the given edge sequence of h is that of a strip from its tail to its head. */
  bool is_strip(Halfedge_index h, const Edge_sequence& sequence) const
  {
    Decision_statistics none;
    return sequence.tail == m_triangulation.tail(h) && sequence.head == m_triangulation.head(h) &&
           Straight_strip<Triangulation>(m_triangulation, none).is_strip(sequence);
  }

  /* Returns the angle clockwise from one halfedge of a vertex to another. */
  Wedge_angle clockwise(const Edge_end& from, const Edge_end& to) const
  {
    if(from.direction.reference == null_index || to.direction.reference == null_index)
      return wedge_angle(m_triangulation, from.halfedge, to.halfedge);
    const Index steps = m_triangulation.input_edges_in_wedge(from.halfedge, to.halfedge) + (from.is_along ? 1 : 0);
    return wedge_angle(m_triangulation, from.direction, to.direction, steps);
  }

  /* Returns whether such an angle is below pi, exactly. */
  bool is_below_straight(const Edge_end& from, const Edge_end& to, const Wedge_angle& angle,
                         Decision_statistics& statistics) const
  {
    const Comparison_result quick = angle.compare_with_straight();
    if(quick == EQUAL)
      return Wedge_comparison<Triangulation>(m_triangulation, statistics)(from.halfedge, to.halfedge) == SMALLER;
    ++statistics.by_strip;
    return quick == SMALLER;
  }

  /* See the free function of the same name. */
  static bool refresh_wedge(Triangulation& triangulation, Halfedge_index from, Halfedge_index to)
  {
    return internal::refresh_wedge(triangulation, from, to);
  }

private:
  static Measured_edge measured(Halfedge_index h, const Edge_sequence& sequence, const Strip<Triangulation>& strip)
  {
    const bool is_along = sequence.along != null_index;
    Measured_edge result = {{h, {}, is_along}, {Triangulation::twin(h), {}, is_along}, strip.bend()};
    if(strip.arrival_reference() != null_index) {
      result.tail.direction = tail_angle(strip);
      result.head.direction = {strip.arrival_reference(), angle_from_reference(strip.arrival()), strip.arrival_error()};
    }
    return result;
  }

  const Triangulation& m_triangulation;
};

/* A side of an edge, as it is between two flips of the edge. */
struct Side_version
{
  Halfedge_index halfedge;
  Index version; // 0 for an edge of the input
};

/*
 * Results of expensive comparisons of wedges with pi. A straight angle prevents flips and is therefore compared again
 * whenever the flips around it are attempted: a hundred times at an extruded developable region. The angle between two
 * edges is constant as long as both exist. Versions are reused after flips were rolled back; only wedges between edges
 * of the input are known from then on.
 */
class Compared_wedges
{
  using Wedge = std::array<Index, 4>;
  using Results = std::unordered_map<Wedge, Comparison_result, boost::hash<Wedge>>;

public:
  /* Returns the result for the wedge clockwise from one edge to another, or null if it is unknown. */
  const Comparison_result* find(const Side_version& from, const Side_version& to) const
  {
    const Results& results = is_of_input(from, to) ? m_of_input : m_of_flips;
    const auto found = results.find(wedge(from, to));
    return found == results.end() ? nullptr : &found->second;
  }

  void insert(const Side_version& from, const Side_version& to, Comparison_result result)
  {
    Results& results = is_of_input(from, to) ? m_of_input : m_of_flips;
    if(results.size() == most_results)
      results.clear();
    results.insert_or_assign(wedge(from, to), result);
  }

  /* Must be called after flips were rolled back. */
  void forget_flips()
  {
    if(!m_of_flips.empty()) // since clearing takes time even then
      m_of_flips.clear();
  }

private:
  static constexpr std::size_t most_results = std::size_t(1) << 13; // some 500 kB

  static bool is_of_input(const Side_version& from, const Side_version& to)
  {
    return from.version == 0 && to.version == 0;
  }

  static Wedge wedge(const Side_version& from, const Side_version& to)
  {
    return {from.halfedge.idx(), from.version, to.halfedge.idx(), to.version};
  }

  Results m_of_input, m_of_flips;
};

/*
 * The results that a triangulation keeps of predicates after filter failures. The const members can be called by
 * several threads simultaneously.
 */
class Remembered_decisions
{
public:
  Decision_statistics statistics() const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    return m_statistics;
  }

  void add(const Decision_statistics& statistics) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    m_statistics += statistics;
  }

  /*
   * Returns the comparison of the wedge clockwise from one edge to another with pi, computed by `compare(statistics)`
   * if unknown. No lock is held during that computation.
   */
  template <class Compare>
  Comparison_result compare(const Side_version& from, const Side_version& to, const Compare& compare) const
  {
    {
      const std::lock_guard<Short_lock> guard(m_lock);
      if(const Comparison_result* known = m_compared_wedges.find(from, to)) {
        ++m_statistics.by_memory;
        return *known;
      }
    }
    Decision_statistics statistics;
    const Comparison_result result = compare(statistics);
    const std::lock_guard<Short_lock> guard(m_lock);
    m_compared_wedges.insert(from, to, result);
    m_statistics += statistics;
    return result;
  }

  /* Returns the results for flat edges of an input. */
  Flat_edges& flat_edges(std::size_t number_of_input_edges) const
  {
    const std::lock_guard<Short_lock> guard(m_lock);
    if(m_flat_edges.size() == 0)
      m_flat_edges = Flat_edges(number_of_input_edges);
    return m_flat_edges;
  }

  /* Must be called after flips were rolled back. */
  void forget_flips() { m_compared_wedges.forget_flips(); }

private:
  mutable Compared_wedges m_compared_wedges;
  mutable Flat_edges m_flat_edges;
  mutable Decision_statistics m_statistics;
  mutable Short_lock m_lock;
};

} // namespace internal

/* Returns the object that measures the edges of a triangulation. Functions that shorten curves find this overload by
 * argument-dependent lookup and do not depend on exact arithmetic. */
template <class Triangulation>
internal::Edge_straightness<Triangulation> edge_straightness(const Triangulation& triangulation)
{
  return internal::Edge_straightness<Triangulation>(triangulation);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_COMPARISON_H
