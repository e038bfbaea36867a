// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_PLAIN_NETWORK_H
#define FLIP_GEODESICS_TEST_PLAIN_NETWORK_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/*
 * A network of curves as one would write it down: a table of segments, and for each edge the list of those on it. Made
 * from the page of the concept `EdgePathGraph`; `replace_joint()` names all joints there are. It is slow, and shares no
 * code with `Edge_path_network`.
 */
template <class Triangulation_>
class Plain_network
{
  using Index = CGAL::Flip_geodesics::Index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Edge_index = CGAL::Flip_geodesics::Edge_index;
  using Segment_index = CGAL::Flip_geodesics::Segment_index;
  using Curve_index = CGAL::Flip_geodesics::Curve_index;
  using Joint = CGAL::Flip_geodesics::Joint;
  using Side = CGAL::Flip_geodesics::Side;
  using Segment_end = CGAL::Flip_geodesics::Segment_end;
  using Wedge_state = CGAL::Flip_geodesics::Wedge_state;
  using Turn = typename Triangulation_::Turn;
  using Segments = std::vector<Segment_index>;

  struct Segment
  {
    Halfedge_index halfedge;
    Curve_index curve;
    bool is_head_fixed;
    bool is_alive;
  };

  struct Curve
  {
    Segments segments; // in order
    bool is_closed;
    double initial_length;
  };

public:
  using Triangulation = Triangulation_;

  struct Wedge
  {
    Wedge_state state;
    Turn turn;
  };

  struct Bundle_place
  {
    Halfedge_index halfedge;
    std::size_t position;
    bool is_head_fixed;
  };

  /* The curves of a network in another triangulation of the same mesh. */
  template <class Network>
  Plain_network(Triangulation& triangulation, const Network& other)
    : m_triangulation(triangulation)
  {
    const Segment dead = {CGAL::Flip_geodesics::null_index, CGAL::Flip_geodesics::null_index, false, false};
    m_segments.assign(static_cast<std::size_t>(other.end_of_segment_ids()), dead);
    for(Curve_index c(0); c.idx() < other.number_of_curves(); ++c) {
      m_curves.push_back({{}, other.is_closed(c), other.initial_length(c)});
      other.for_each_segment(c, [&](Segment_index s) {
        m_segments[index(s)] = {other.halfedge(s), c, other.is_head_fixed(s), true};
        m_curves.back().segments.push_back(s);
        const Edge_index e = Triangulation::edge(other.halfedge(s));
        if(bundle(e).empty())
          m_triangulation.hold(e);
        m_bundles[e.idx()] = other.bundle(e);
      });
    }
  }

  Plain_network(const Plain_network&) = delete;
  Plain_network& operator=(const Plain_network&) = delete;
  ~Plain_network()
  {
    for(const Curve& c : m_curves)
      for(Segment_index s : c.segments)
        take_away(s);
  }

  Triangulation& triangulation() const { return m_triangulation; }
  Index number_of_curves() const { return static_cast<Index>(m_curves.size()); }
  bool is_closed(Curve_index c) const { return of(c).is_closed; }
  bool is_contracted(Curve_index c) const { return of(c).segments.empty(); }
  double initial_length(Curve_index c) const { return of(c).initial_length; }
  double length(Curve_index c) const
  {
    double result = 0;
    for_each_segment(c, [&](Segment_index s) { result += m_triangulation.length(halfedge(s)); });
    return result;
  }
  template <class Function>
  void for_each_segment(Curve_index c, Function function) const
  {
    for(Segment_index s : of(c).segments)
      function(s);
  }

  Index end_of_segment_ids() const { return static_cast<Index>(m_segments.size()); }
  bool is_alive(Segment_index s) const { return of(s).is_alive; }
  Halfedge_index halfedge(Segment_index s) const { return of(s).halfedge; }
  Curve_index curve(Segment_index s) const { return of(s).curve; }
  bool is_head_fixed(Segment_index s) const { return of(s).is_head_fixed; }
  Segment_index next(Segment_index s) const
  {
    const Curve& c = of(curve(s));
    const auto after = std::next(std::find(c.segments.begin(), c.segments.end(), s));
    if(after != c.segments.end())
      return *after;
    return c.is_closed ? c.segments.front() : Segment_index(CGAL::Flip_geodesics::null_index);
  }
  bool is_occupied(Halfedge_index h) const { return !bundle(Triangulation::edge(h)).empty(); }
  Segments bundle(Edge_index e) const
  {
    const auto found = m_bundles.find(e.idx());
    return found == m_bundles.end() ? Segments() : found->second;
  }

  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const
  {
    const Segment_index in = joint.incoming, out = next(in);
    const Segment_end back = {Triangulation::twin(halfedge(in)), in}, ahead = {halfedge(out), out};
    return joint.side == Side::LEFT ? std::pair(back, ahead) : std::pair(ahead, back);
  }

  Segment_end next_clockwise(const Segment_end& end) const
  {
    const Segment_end beside = right_of(end);
    if(!beside.is_none())
      return beside;
    for(Halfedge_index h = m_triangulation.clockwise(end.halfedge); h.is_valid(); h = m_triangulation.clockwise(h)) {
      if(is_occupied(h))
        return {h, from_left(h).front()};
      if(m_triangulation.holds(Triangulation::edge(h)) > 0)
        break;
    }
    return {};
  }

  bool is_turning_back(const Joint& joint) const
  {
    const auto [first, second] = ends(joint);
    return right_of(first) == second;
  }

  Wedge wedge(const Joint& joint) const
  {
    if(is_head_fixed(joint.incoming))
      return {Wedge_state::FIXED, Turn()};
    const auto [first, second] = ends(joint);
    const Segment_end beside = right_of(first);
    if(!beside.is_none())
      return {beside == second ? Wedge_state::FREE : Wedge_state::BLOCKED, Turn()};
    Wedge result = {Wedge_state::BORDER, Turn()};
    for(Halfedge_index h = first.halfedge;;) {
      h = m_triangulation.extend_turn_clockwise(result.turn, h);
      if(!h.is_valid())
        return result;
      if(m_triangulation.is_straight(result.turn, first.halfedge, h))
        result.state = Wedge_state::STRAIGHT;
      else if(is_occupied(h))
        result.state = Segment_end{h, from_left(h).front()} == second ? Wedge_state::FREE : Wedge_state::BLOCKED;
      else if(m_triangulation.holds(Triangulation::edge(h)) > 0)
        result.state = Wedge_state::BLOCKED;
      else
        continue;
      return result;
    }
  }

  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected)
  {
    const Segment_index in = joint.incoming, out = next(in);
    const Curve_index c = curve(in);
    const bool is_fixed_after = is_head_fixed(out);
    Segments& segments = m_curves[index(c)].segments;
    if(std::find(segments.begin(), segments.end(), out) < std::find(segments.begin(), segments.end(), in))
      std::rotate(segments.begin(), std::next(segments.begin()), segments.end()); // the joint closes the curve
    const auto place = std::find(segments.begin(), segments.end(), in) - segments.begin();
    take_away(in);
    take_away(out);
    segments.erase(segments.begin() + place, segments.begin() + place + 2);
    Segments added;
    for(const Halfedge_index h : arc) {
      const Halfedge_index along = joint.side == Side::LEFT ? h : Triangulation::twin(h);
      added.push_back(add(c, along, along == h ? bundle(Triangulation::edge(h)).size() : 0));
    }
    if(joint.side == Side::RIGHT)
      std::reverse(added.begin(), added.end());
    segments.insert(segments.begin() + place, added.begin(), added.end());
    if(!added.empty())
      m_segments[index(added.back())].is_head_fixed = is_fixed_after;
    else if(place > 0 || (is_closed(c) && !segments.empty()))
      m_segments[index(place > 0 ? segments[static_cast<std::size_t>(place) - 1] : segments.back())].is_head_fixed |=
          is_fixed_after;
    name_joints(affected);
    return added.empty() ? Segment_index(CGAL::Flip_geodesics::null_index) : added.front();
  }

  Segment_index perturb_loop(Segment_index s, Halfedge_index h)
  {
    const Curve_index c = curve(s);
    const bool is_forward = halfedge(s) == h, is_fixed = is_head_fixed(s);
    const Halfedge_index hn = m_triangulation.next(h), hp = m_triangulation.previous(h);
    take_away(s);
    const Segment_index first = add(c, is_forward ? Triangulation::twin(hp) : hn, 0);
    const Segment_index second = add(c, is_forward ? Triangulation::twin(hn) : hp, 0);
    m_segments[index(second)].is_head_fixed = is_fixed;
    m_curves[index(c)].segments = {first, second};
    return second;
  }

  Bundle_place bundle_place(Segment_index s) const
  {
    const Segments seen = from_left(halfedge(s));
    return {halfedge(s), static_cast<std::size_t>(std::find(seen.begin(), seen.end(), s) - seen.begin()),
            is_head_fixed(s)};
  }

  Segment_index restore_loop(Curve_index c, const Bundle_place& place)
  {
    Segments& segments = m_curves[index(c)].segments;
    for(Segment_index s : segments)
      take_away(s);
    segments = {add(c, place.halfedge, place.position)};
    m_segments[index(segments.front())].is_head_fixed = place.is_head_fixed;
    return segments.front();
  }

private:
  template <class Descriptor>
  static std::size_t index(Descriptor d)
  {
    return static_cast<std::size_t>(d.idx());
  }

  const Segment& of(Segment_index s) const { return m_segments[index(s)]; }
  const Curve& of(Curve_index c) const { return m_curves[index(c)]; }
  static bool is_first(Halfedge_index h) { return h.idx() % 2 == 0; }

  // The segments on an edge from left to right along h.
  Segments from_left(Halfedge_index h) const
  {
    Segments result = bundle(Triangulation::edge(h));
    if(!is_first(h))
      std::reverse(result.begin(), result.end());
    return result;
  }

  // The end beside another one on the same edge, clockwise.
  Segment_end right_of(const Segment_end& end) const
  {
    const Segments seen = from_left(end.halfedge);
    const auto right = std::next(std::find(seen.begin(), seen.end(), end.segment));
    return right == seen.end() ? Segment_end() : Segment_end{end.halfedge, *right};
  }

  // Along h, with so many segments on its left.
  Segment_index add(Curve_index c, Halfedge_index h, std::size_t position)
  {
    const Segment_index s(static_cast<Index>(m_segments.size()));
    m_segments.push_back({h, c, false, true});
    Segments& on_edge = m_bundles[Triangulation::edge(h).idx()];
    if(on_edge.empty())
      m_triangulation.hold(Triangulation::edge(h));
    const std::size_t from_front = is_first(h) ? position : on_edge.size() - position;
    on_edge.insert(on_edge.begin() + static_cast<std::ptrdiff_t>(from_front), s);
    return s;
  }

  void take_away(Segment_index s)
  {
    const Edge_index e = Triangulation::edge(halfedge(s));
    Segments& on_edge = m_bundles[e.idx()];
    on_edge.erase(std::find(on_edge.begin(), on_edge.end(), s));
    if(on_edge.empty())
      m_triangulation.release(e);
    m_segments[index(s)].is_alive = false;
  }

  void name_joints(std::vector<Joint>& joints) const
  {
    for(Index i = 0; i < end_of_segment_ids(); ++i)
      if(is_alive(Segment_index(i)) && next(Segment_index(i)).is_valid())
        for(const Side side : {Side::LEFT, Side::RIGHT})
          joints.push_back({Segment_index(i), side});
  }

  Triangulation& m_triangulation;
  std::vector<Segment> m_segments;
  std::vector<Curve> m_curves;
  std::map<Index, Segments> m_bundles; // from left to right along an edge's first halfedge
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_PLAIN_NETWORK_H
