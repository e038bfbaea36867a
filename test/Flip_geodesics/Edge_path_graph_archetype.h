// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_EDGE_PATH_GRAPH_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_EDGE_PATH_GRAPH_ARCHETYPE_H

#include "Topological_signature.h"

#include <CGAL/Flip_geodesics/Edge_path_network.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/// What the instrumented models throw when the engine breaks a rule.
struct Broken_invariant : std::logic_error
{
  using std::logic_error::logic_error;
};

inline void require(bool condition, const char* rule)
{
  if(!condition)
    throw Broken_invariant(rule);
}

/// A triangulation that refuses to flip an edge on which a curve lies.
template <class Triangulation>
class Guarded_triangulation : public Triangulation
{
public:
  using Triangulation::Triangulation;

  void flip(CGAL::Flip_geodesics::Halfedge_index h)
  {
    require(this->holds(Triangulation::edge(h)) == 0, "an edge under a curve is flipped");
    require(this->is_flippable(h), "an edge is flipped that cannot be");
    Triangulation::flip(h);
  }
};

// ---------------------------------------------------------------- the rules that hold at any time

/// Segments and stacks name each other, chains are continuous, dead segments are nowhere.
template <class Network>
void check_links(const Network& network, const Curve_system& system)
{
  std::vector<int> listed(system.segments.size(), 0), chained(system.segments.size(), 0);
  for(int e = 0; e < static_cast<int>(system.bundles.size()); ++e)
    for(int s : system.bundles[e]) {
      require(system.segments[s].halfedge / 2 == e && system.segments[s].halfedge >= 0, "a stack lists a stranger");
      ++listed[s];
    }
  for(int c = 0; c < network.number_of_curves(); ++c) {
    const CGAL::Flip_geodesics::Curve_index curve(c);
    const int first_segment = network.first_segment(curve).idx();
    int last = -1, steps = 0;
    for(int s = first_segment; s != -1;) {
      require(++steps <= static_cast<int>(system.segments.size()), "a chain does not end");
      const Curve_system::Segment& segment = system.segments[s];
      require(segment.curve == c && segment.halfedge >= 0, "a chain holds a stranger");
      require(last == -1 || segment.previous == last, "a chain's backward link is wrong");
      require(last == -1 || system.tail[system.segments[last].halfedge ^ 1] == system.tail[segment.halfedge],
              "a chain is not continuous");
      ++chained[s];
      last = s;
      s = segment.next == first_segment ? -1 : segment.next;
    }
    require(last == network.last_segment(curve).idx(), "a chain's last segment is wrong");
    if(last == -1)
      continue;
    const Curve_system::Segment &first = system.segments[first_segment], &end = system.segments[last];
    require(network.is_closed(curve) ? end.next == first_segment : end.next == -1, "a chain ends wrongly");
    require(network.is_closed(curve) ? first.previous == last : first.previous == -1, "a chain starts wrongly");
    require(!network.is_closed(curve) || system.tail[end.halfedge ^ 1] == system.tail[first.halfedge],
            "a loop is not closed");
  }
  for(std::size_t s = 0; s < listed.size(); ++s) {
    const int expected = system.segments[s].halfedge >= 0 ? 1 : 0;
    require(listed[s] == expected && chained[s] == expected, "a segment is not exactly once in a stack and a chain");
  }
}

/// Around each vertex joints nest like brackets, with all ends of curves and the border in one region.
inline void check_matching(const Curve_system& system)
{
  for(const std::vector<int>& star : system.stars()) {
    std::vector<std::pair<int, int>> ends, mates; // halfedge, segment; {-1, -1} for none, and for the border itself
    for(int h : star)
      for(int s : system.bundle_along(h)) {
        const Curve_system::Segment& x = system.segments[s];
        const int other = h == x.halfedge ? x.previous : x.next;
        const bool is_fixed = other < 0 || (h == x.halfedge ? system.segments[other].is_head_fixed : x.is_head_fixed);
        ends.emplace_back(h, s);
        mates.push_back(is_fixed ? std::make_pair(-1, -1)
                                 : std::make_pair(h == x.halfedge ? system.segments[other].halfedge ^ 1
                                                                  : system.segments[other].halfedge,
                                                  other));
      }
    if(system.clockwise(star.back()) == -1) {
      ends.emplace_back(-1, -1);
      mates.emplace_back(-1, -1);
    }
    const auto single = std::find(mates.begin(), mates.end(), std::make_pair(-1, -1));
    const std::size_t start = single == mates.end() ? 0 : static_cast<std::size_t>(single - mates.begin());
    std::vector<std::pair<int, int>> open;
    for(std::size_t i = 0; i < ends.size(); ++i) {
      const std::size_t k = (start + i) % ends.size();
      if(mates[k].second == -1)
        require(open.empty(), "an end of a curve, or the border, is enclosed by a joint");
      else if(!open.empty() && open.back() == mates[k])
        open.pop_back();
      else
        open.push_back(ends[k]);
    }
    require(open.empty(), "two joints cross");
  }
}

// ---------------------------------------------------------------- the rule that holds at the end

/// The angle at the tail of `h` in the face on its right, by atan2. \pre there is one
template <class Triangulation>
double corner_right_of(const Triangulation& triangulation, CGAL::Flip_geodesics::Halfedge_index h)
{
  const auto& in = triangulation.geometry(Triangulation::twin(h));
  const auto& out = triangulation.geometry(triangulation.next(Triangulation::twin(h)));
  const double x = -(in.x * out.x + in.y * out.y);
  const double y = (std::max)(out.y * in.x - out.x * in.y, 0.0); // a corner of pi is not one of -pi
  return std::atan2(y, x);
}

/// A side of a joint in which no other end lies.
struct Free_side
{
  int incoming, outgoing;
  CGAL::Flip_geodesics::Side side;
  double angle;

  bool is_of_same_joint(const Free_side& other) const
  {
    return incoming == other.incoming && outgoing == other.outgoing && side == other.side;
  }
};

/*
 * The sides of joints in which no other end lies: over all pairs of ends, with no use of the network's own ways to look
 * around a vertex.
 */
template <class Network>
std::vector<Free_side> free_sides(const Network& network)
{
  using CGAL::Flip_geodesics::Side;
  const auto& triangulation = network.triangulation();
  const Curve_system system(network);
  std::vector<Free_side> result;
  for(const std::vector<int>& star : system.stars()) {
    struct End
    {
      int halfedge, segment;
      std::size_t outgoing_halfedge;
    };
    std::vector<End> ends;
    std::vector<double> angle_before = {0}; // of spoke i, from spoke 0
    for(std::size_t i = 0; i < star.size(); ++i) {
      for(int s : system.bundle_along(star[i]))
        ends.push_back({star[i], s, i});
      if(system.clockwise(star[i]) != -1)
        angle_before.push_back(angle_before.back() +
                               corner_right_of(triangulation, CGAL::Flip_geodesics::Halfedge_index(star[i])));
    }
    const bool has_border = system.clockwise(star.back()) == -1;
    const double whole = angle_before.back();
    for(std::size_t i = 0; i < ends.size(); ++i)
      for(std::size_t k = 0; k < ends.size(); ++k) {
        const Curve_system::Segment &a = system.segments[ends[i].segment], &b = system.segments[ends[k].segment];
        const bool is_left = ends[i].halfedge == (a.halfedge ^ 1) && a.next == ends[k].segment && !a.is_head_fixed &&
                             ends[k].halfedge == b.halfedge;
        const bool is_right = ends[i].halfedge == a.halfedge && a.previous == ends[k].segment && !b.is_head_fixed &&
                              ends[k].halfedge == (b.halfedge ^ 1);
        if(!is_left && !is_right)
          continue;
        const bool is_next = (i + 1) % ends.size() == k, is_past_border = k <= i && has_border;
        if(!is_next || is_past_border)
          continue;
        double angle = angle_before[ends[k].outgoing_halfedge] - angle_before[ends[i].outgoing_halfedge];
        if(k <= i)
          angle += whole;
        if(is_left)
          result.push_back({ends[i].segment, ends[k].segment, Side::LEFT, angle});
        if(is_right)
          result.push_back({ends[k].segment, ends[i].segment, Side::RIGHT, angle});
      }
  }
  return result;
}

/// The smallest angle of the free sides of some curves; infinite if there is none.
template <class Network>
double smallest_free_angle(const Network& network, const std::set<CGAL::Flip_geodesics::Curve_index>& curves)
{
  double smallest = HUGE_VAL;
  for(const Free_side& free : free_sides(network))
    if(curves.count(network.curve(CGAL::Flip_geodesics::Segment_index(free.incoming))) != 0)
      smallest = (std::min)(smallest, free.angle);
  return smallest;
}

// ---------------------------------------------------------------- the archetype

/// What the engine did to a network, to see that the tests reach everything.
struct Operation_counts
{
  long moves = 0, cancellations = 0, perturbations = 0, restorations = 0, contractions = 0, stacked_moves = 0,
       full_stars = 0, own_edge_moves = 0;

  Operation_counts& operator+=(const Operation_counts& other)
  {
    moves += other.moves;
    cancellations += other.cancellations;
    perturbations += other.perturbations;
    restorations += other.restorations;
    contractions += other.contractions;
    stacked_moves += other.stacked_moves;
    full_stars += other.full_stars;
    own_edge_moves += other.own_edge_moves;
    return *this;
  }
};

/*
 * A model of `EdgePathGraph` that has nothing but what the concept asks for. It forwards to an `Edge_path_network`,
 * and after each operation that moves a curve it checks all that must hold then: links, non-crossing matchings, the
 * isotopy class of the whole network, and that each joint that can be shortened since then has been named.
 */
template <class Network_>
class Edge_path_graph_archetype
{
  using Index = CGAL::Flip_geodesics::Index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Segment_index = CGAL::Flip_geodesics::Segment_index;
  using Curve_index = CGAL::Flip_geodesics::Curve_index;
  using Joint = CGAL::Flip_geodesics::Joint;
  using Side = CGAL::Flip_geodesics::Side;
  using Segment_end = CGAL::Flip_geodesics::Segment_end;

public:
  using Triangulation = typename Network_::Triangulation;
  using Wedge = typename Network_::Wedge;
  using Bundle_place = typename Network_::Bundle_place;

  explicit Edge_path_graph_archetype(Network_& network)
    : m_network(network)
    , m_initial(network)
    , m_has_fixed_nodes(has_fixed_nodes(m_initial))
    , m_expected(m_initial, {}, m_has_fixed_nodes)
  {
    check_links(network, m_initial);
    check_matching(m_initial);
  }

  Edge_path_graph_archetype(const Edge_path_graph_archetype&) = delete;
  Edge_path_graph_archetype& operator=(const Edge_path_graph_archetype&) = delete;

  Triangulation& triangulation() const { return m_network.triangulation(); }
  Index number_of_curves() const { return m_network.number_of_curves(); }
  double length(Curve_index curve) const { return m_network.length(curve); }
  double initial_length(Curve_index curve) const { return m_network.initial_length(curve); }
  bool is_contracted(Curve_index curve) const { return m_network.is_contracted(curve); }
  bool is_closed(Curve_index curve) const { return m_network.is_closed(curve); }
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const
  {
    m_network.for_each_segment(curve, function);
  }

  Index end_of_segment_ids() const { return m_network.end_of_segment_ids(); }
  bool is_alive(Segment_index s) const { return m_network.is_alive(s); }
  Halfedge_index halfedge(Segment_index s) const { return m_network.halfedge(s); }
  Curve_index curve(Segment_index s) const { return m_network.curve(s); }
  Segment_index next(Segment_index s) const { return m_network.next(s); }
  bool is_head_fixed(Segment_index s) const { return m_network.is_head_fixed(s); }
  bool is_occupied(Halfedge_index h) const { return m_network.is_occupied(h); }
  std::vector<Segment_index> bundle(CGAL::Flip_geodesics::Edge_index e) const { return m_network.bundle(e); }

  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const { return m_network.ends(joint); }
  Segment_end next_clockwise(const Segment_end& end) const { return m_network.next_clockwise(end); }
  Wedge wedge(const Joint& joint) const
  {
    if(m_network.next(joint.incoming) == CGAL::Flip_geodesics::null_index)
      throw std::logic_error("there is no joint at the end of a curve");
    return m_network.wedge(joint);
  }
  bool is_turning_back(const Joint& joint) const { return m_network.is_turning_back(joint); }

  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    const Curve_index curve = m_network.curve(joint.incoming);
    count(joint, arc);
    const std::vector<Free_side> before = free_sides(m_network);
    const Segment_index first = m_network.replace_joint(joint, arc, affected);
    check(curve);
    check_names(before, affected);
    return first;
  }

  Segment_index perturb_loop(Segment_index s, Halfedge_index h)
  {
    const Curve_index curve = m_network.curve(s);
    ++m_counts.perturbations;
    const Segment_index arriving = m_network.perturb_loop(s, h);
    check(curve);
    return arriving;
  }

  Bundle_place bundle_place(Segment_index s) const { return m_network.bundle_place(s); }

  Segment_index restore_loop(Curve_index curve, const Bundle_place& place)
  {
    ++m_counts.restorations;
    if(m_contracted.erase(curve.idx()) != 0)
      m_expected = Topological_signature(m_initial, m_contracted, m_has_fixed_nodes);
    const Segment_index s = m_network.restore_loop(curve, place);
    check(curve);
    return s;
  }

  const Operation_counts& counts() const { return m_counts; }

private:
  static bool has_fixed_nodes(const Curve_system& system)
  {
    return std::any_of(system.segments.begin(), system.segments.end(), [](const Curve_system::Segment& s) {
      return s.halfedge >= 0 && s.next >= 0 && s.is_head_fixed;
    });
  }

  void count(const Joint& joint, const std::vector<Halfedge_index>& arc)
  {
    const auto [a, b] = m_network.ends(joint);
    ++(arc.empty() ? m_counts.cancellations : m_counts.moves);
    m_counts.full_stars += !arc.empty() && a.halfedge == b.halfedge ? 1 : 0;
    m_counts.own_edge_moves += a.halfedge == Triangulation::twin(b.halfedge) ? 1 : 0;
    const std::size_t at_a = m_network.bundle(Triangulation::edge(a.halfedge)).size();
    const std::size_t at_b = m_network.bundle(Triangulation::edge(b.halfedge)).size();
    m_counts.stacked_moves += at_a + at_b > 2 ? 1 : 0;
  }

  void check(Curve_index curve)
  {
    const Curve_system system(m_network);
    check_links(m_network, system);
    check_matching(system);
    require(m_network.is_valid(), "is_valid() says no");
    if(m_network.is_contracted(curve) && m_contracted.insert(curve.idx()).second) {
      ++m_counts.contractions;
      require(m_has_fixed_nodes || m_expected.has_disk_inside(curve.idx()),
              "a curve has contracted that does not bound a disk");
      m_expected = Topological_signature(m_initial, m_contracted, m_has_fixed_nodes);
    }
    require(Topological_signature(system, m_contracted, m_has_fixed_nodes) == m_expected,
            "the isotopy class has changed");
  }

  void check_names(const std::vector<Free_side>& before, const std::vector<Joint>& named) const
  {
    for(const Free_side& free : free_sides(m_network)) {
      const bool is_old = std::any_of(before.begin(), before.end(),
                                      [&](const Free_side& other) { return free.is_of_same_joint(other); });
      const bool is_named = std::any_of(named.begin(), named.end(), [&](const Joint& joint) {
        return joint.incoming.idx() == free.incoming && joint.side == free.side;
      });
      require(is_old || is_named || free.angle > straight - 1e-8, "a joint that can be shortened has not been named");
    }
  }

  static constexpr double straight = 3.141592653589793;

  Network_& m_network;
  Curve_system m_initial;
  bool m_has_fixed_nodes;
  Topological_signature m_expected;
  std::set<int> m_contracted;
  Operation_counts m_counts;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_EDGE_PATH_GRAPH_ARCHETYPE_H
