// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_SHORTENING_RECORDER_H
#define CGAL_FLIP_GEODESICS_PROGRAM_SHORTENING_RECORDER_H

#include "run/progress.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace program {

/*!
 * Records a shortening: after each step, which edges were flipped by the flip log, where they run now, and how the
 * curve has changed.
 *
 * The invariant: `m_edges` has, for each edge that was flipped or that a curve ran along, the polyline that it has at
 * position `m_position` of the flip log; and `m_strands` the curves at that time.
 */
template <class Network>
class Shortening_recorder
{
  using Curve_index = CGAL::Flip_geodesics::Curve_index;
  using Edge_index = CGAL::Flip_geodesics::Edge_index;
  using Halfedge_index = CGAL::Flip_geodesics::Halfedge_index;
  using Triangulation = typename Network::Triangulation;
  using Strand = std::vector<std::uint32_t>;

public:
  /// \param most_points when the polylines have so many points together, the steps that follow are merged into one
  Shortening_recorder(const Network& network, std::size_t most_points)
    : m_network(network)
    , m_most_points(most_points)
  {
    if(network.triangulation().log_position() > 0)
      add_changed_edges();
    m_position = network.triangulation().log_position();
    for(Curve_index c : network.curves())
      m_strands.push_back(strand(c));
    m_record.curves = m_strands;
  }

  /// After a step that has moved a curve.
  void add_step(Curve_index curve)
  {
    if(m_number_of_points > m_most_points) {
      m_record.has_all_steps = false;
      return;
    }
    add_changes(curve, flipped_edges());
  }

  /// After the last step; the recorder is empty then.
  Shortening_record finish()
  {
    for(Curve_index c : m_network.curves())
      add_changes(c, flipped_edges()); // the first has all of them
    return std::move(m_record);
  }

private:
  // The polyline of an edge that is known, or that has not been flipped so far.
  std::uint32_t polyline(Edge_index e)
  {
    const auto found = m_edges.find(e);
    return found != m_edges.end() ? found->second : add_input_edge(e);
  }

  static Halfedge_index first_side(Edge_index e) { return Halfedge_index(2 * e.idx()); }

  // The input's vertices at the edge with this number, which may have been flipped.
  std::array<Vertex_index, 2> ends_on_input(Edge_index e) const
  {
    const auto& input = m_network.triangulation().input();
    const Input_halfedge_index h(2 * e.idx()), t(2 * e.idx() + 1);
    return {input.tail(h), input.tail(t)};
  }

  void note_input_edge(std::uint32_t id, const std::array<Vertex_index, 2>& ends)
  {
    m_record.input_edges.push_back(
        {id, {static_cast<std::uint32_t>(ends[0].idx()), static_cast<std::uint32_t>(ends[1].idx())}});
  }

  std::uint32_t add_input_edge(Edge_index e)
  {
    const Triangulation& triangulation = m_network.triangulation();
    const std::array<Vertex_index, 2> ends = ends_on_input(e);
    const auto& metric = triangulation.metric();
    const std::uint32_t id =
        add_polyline(e, {metric.point(triangulation.input(), ends[0]), metric.point(triangulation.input(), ends[1])});
    note_input_edge(id, ends);
    m_record.edges.push_back(id);
    return id;
  }

  // Edges that are not the input's even before the first step: flipped before, or at inserted points.
  void add_changed_edges()
  {
    const Triangulation& triangulation = m_network.triangulation();
    const Edge_index end_of_input(triangulation.input().number_of_halfedges() / 2);
    for(Index i = 0; i < triangulation.number_of_edges(); ++i) {
      const Edge_index e(i);
      if(e < end_of_input && triangulation.version(e) == 0)
        continue;
      if(e < end_of_input)
        note_input_edge(Shortening_record::none, ends_on_input(e));
      m_record.edges.push_back(add_polyline(e, points_of(e)));
    }
  }

  std::vector<Point_3> points_of(Edge_index e) const
  {
    namespace FG = CGAL::Flip_geodesics;
    const Triangulation& triangulation = m_network.triangulation();
    std::vector<FG::Surface_point> on_surface;
    FG::edge_surface_points(triangulation, first_side(e), std::back_inserter(on_surface));
    std::vector<Point_3> points;
    for(const FG::Surface_point& p : on_surface)
      points.push_back(FG::point_in_space(triangulation, p));
    return points;
  }

  std::uint32_t add_polyline(Edge_index e, std::vector<Point_3> points)
  {
    const std::uint32_t id = static_cast<std::uint32_t>(m_record.polylines.size());
    m_number_of_points += points.size();
    m_record.polylines.push_back(std::move(points));
    m_edges[e] = id;
    return id;
  }

  // Brings `m_edges` up to date with the flip log.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> flipped_edges()
  {
    namespace FG = CGAL::Flip_geodesics;
    const Triangulation& triangulation = m_network.triangulation();
    std::set<Edge_index> edges;
    for(; m_position < triangulation.log_position(); ++m_position)
      if(triangulation.flip_record(m_position).hp != FG::null_index)
        edges.insert(triangulation.edge(triangulation.flip_record(m_position).h));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> flipped;
    for(Edge_index e : edges) {
      const std::uint32_t before = polyline(e);
      flipped.push_back({before, add_polyline(e, points_of(e))});
    }
    return flipped;
  }

  Strand strand(Curve_index curve)
  {
    Strand result;
    m_network.for_each_segment(curve, [&](CGAL::Flip_geodesics::Segment_index s) {
      const Halfedge_index h = m_network.halfedge(s);
      const Edge_index e = Triangulation::edge(h);
      result.push_back(2 * polyline(e) + (h == first_side(e) ? 0 : 1));
    });
    return result;
  }

  void add_changes(Curve_index curve, std::vector<std::pair<std::uint32_t, std::uint32_t>> flipped)
  {
    Strand now = strand(curve);
    Strand& before = m_strands[curve.idx()];
    if(flipped.empty() && now == before)
      return;
    const auto front = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
    const auto end = std::mismatch(std::make_reverse_iterator(before.end()), std::make_reverse_iterator(front.first),
                                   std::make_reverse_iterator(now.end()), std::make_reverse_iterator(front.second));
    Recorded_step step;
    step.flipped = std::move(flipped);
    step.curve = static_cast<std::uint32_t>(curve.idx());
    step.kept_in_front = static_cast<std::uint32_t>(front.second - now.begin());
    step.kept_at_end = static_cast<std::uint32_t>(end.second - std::make_reverse_iterator(now.end()));
    step.inserted.assign(front.second, end.second.base());
    m_record.steps.push_back(std::move(step));
    before = std::move(now);
  }

  const Network& m_network;
  std::size_t m_most_points, m_number_of_points = 0;
  std::size_t m_position = 0;
  std::unordered_map<Edge_index, std::uint32_t> m_edges;
  std::vector<Strand> m_strands;
  Shortening_record m_record;
};

/// Passes flips on to the progress, and steps to a recorder if there is one.
template <class Network>
class Recording_visitor : public Progress_visitor
{
public:
  Recording_visitor(Progress& progress, std::optional<Shortening_recorder<Network>>& recorder)
    : Progress_visitor(progress)
    , m_recorder(recorder)
  {
  }

  void after_flip_out(const Network&, CGAL::Flip_geodesics::Curve_index curve)
  {
    if(m_recorder)
      m_recorder->add_step(curve);
  }

private:
  std::optional<Shortening_recorder<Network>>& m_recorder;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_SHORTENING_RECORDER_H
