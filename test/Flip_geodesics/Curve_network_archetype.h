// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_CURVE_NETWORK_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_CURVE_NETWORK_ARCHETYPE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <utility>
#include <vector>

namespace Flip_geodesics_test {

/*
 * A model of `CurveNetwork` that has nothing but what its page asks for: a network seen through a window, which cannot
 * be changed, and neither can its triangulation.
 */
template <class Network>
class Curve_network_archetype
{
  using Index = CGAL::Flip_geodesics::Index;
  using Curve_index = CGAL::Flip_geodesics::Curve_index;
  using Segment_index = CGAL::Flip_geodesics::Segment_index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Edge_index = CGAL::Flip_geodesics::Edge_index;
  using Joint = CGAL::Flip_geodesics::Joint;
  using Segment_end = CGAL::Flip_geodesics::Segment_end;

public:
  using Triangulation = typename Network::Triangulation;

  explicit Curve_network_archetype(const Network& network)
    : m_network(network)
  {
  }

  Curve_network_archetype(const Curve_network_archetype&) = delete;
  Curve_network_archetype& operator=(const Curve_network_archetype&) = delete;

  const Triangulation& triangulation() const { return m_network.triangulation(); }

  Index number_of_curves() const { return m_network.number_of_curves(); }
  bool is_closed(Curve_index curve) const { return m_network.is_closed(curve); }
  bool is_contracted(Curve_index curve) const { return m_network.is_contracted(curve); }
  double length(Curve_index curve) const { return m_network.length(curve); }
  double initial_length(Curve_index curve) const { return m_network.initial_length(curve); }
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const
  {
    m_network.for_each_segment(curve, function);
  }

  Index end_of_segment_ids() const { return m_network.end_of_segment_ids(); }
  Halfedge_index halfedge(Segment_index s) const { return m_network.halfedge(s); }
  Curve_index curve(Segment_index s) const { return m_network.curve(s); }
  Segment_index next(Segment_index s) const { return m_network.next(s); }
  bool is_head_fixed(Segment_index s) const { return m_network.is_head_fixed(s); }
  bool is_occupied(Halfedge_index h) const { return m_network.is_occupied(h); }
  std::vector<Segment_index> bundle(Edge_index e) const { return m_network.bundle(e); }

  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const { return m_network.ends(joint); }
  Segment_end next_clockwise(const Segment_end& end) const { return m_network.next_clockwise(end); }
  bool is_turning_back(const Joint& joint) const { return m_network.is_turning_back(joint); }

private:
  const Network& m_network;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_CURVE_NETWORK_ARCHETYPE_H
