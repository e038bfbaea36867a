// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_EXAMPLES_SHORTENING_RECORDER_H
#define CGAL_FLIP_GEODESICS_EXAMPLES_SHORTENING_RECORDER_H

#include "progress.h"
#include "scene.h"

#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/extract.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace program {

/*!
 * Records a shortening: after each step, which edges the flip log says were flipped, where they run now, and how the
 * curve has changed.
 *
 * The invariant: `m_edges` has, for each edge that was flipped or that a curve ran along, the polyline that it has at
 * position `m_position` of the flip log; and `m_strands` the curves at that time.
 */
template <class Network>
class Shortening_recorder
{
  using Index = CGAL::Flip_geodesics::Index;
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
    for(Index c = 0; c < network.number_of_curves(); ++c)
      m_strands.push_back(strand(c));
    m_record.curves = m_strands;
  }

  /// After a step that has moved a curve.
  void add_step(Index curve)
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
    for(Index c = 0; c < m_network.number_of_curves(); ++c)
      add_changes(c, flipped_edges()); // the first has all of them
    return std::move(m_record);
  }

private:
  // The polyline of an edge that is known, or that has not been flipped so far.
  std::uint32_t polyline(Index e)
  {
    const auto found = m_edges.find(e);
    return found != m_edges.end() ? found->second : add_input_edge(e);
  }

  std::uint32_t add_input_edge(Index e)
  {
    const auto& triangulation = m_network.triangulation();
    const Index a = triangulation.input().tail(2 * e), b = triangulation.input().tail(2 * e + 1);
    const auto& metric = triangulation.metric();
    const std::uint32_t id =
        add_polyline(e, {metric.point(triangulation.input(), a), metric.point(triangulation.input(), b)});
    m_record.input_edges.push_back({id, {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}});
    m_record.edges.push_back(id);
    return id;
  }

  // Edges that are not the input's even before the first step: flipped before, or at inserted points.
  void add_changed_edges()
  {
    const auto& triangulation = m_network.triangulation();
    const Index input_edges = triangulation.input().number_of_halfedges() / 2;
    for(Index e = 0; e < triangulation.number_of_edges(); ++e) {
      if(e < input_edges && triangulation.version(e) == 0)
        continue;
      if(e < input_edges) {
        const std::uint32_t a = static_cast<std::uint32_t>(triangulation.input().tail(2 * e));
        const std::uint32_t b = static_cast<std::uint32_t>(triangulation.input().tail(2 * e + 1));
        m_record.input_edges.push_back({Shortening_record::none, {a, b}});
      }
      m_record.edges.push_back(add_polyline(e, points_of(e)));
    }
  }

  std::vector<Point_3> points_of(Index e) const
  {
    namespace FG = CGAL::Flip_geodesics;
    const auto& triangulation = m_network.triangulation();
    std::vector<FG::Surface_point> on_surface;
    FG::edge_surface_points(triangulation, 2 * e, std::back_inserter(on_surface));
    std::vector<Point_3> points;
    for(const FG::Surface_point& p : on_surface)
      points.push_back(FG::point_in_space(triangulation, p));
    return points;
  }

  std::uint32_t add_polyline(Index e, std::vector<Point_3> points)
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
    const auto& triangulation = m_network.triangulation();
    std::set<Index> edges;
    for(; m_position < triangulation.log_position(); ++m_position)
      if(triangulation.flip_record(m_position).hp != FG::null_index)
        edges.insert(triangulation.edge(triangulation.flip_record(m_position).h));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> flipped;
    for(Index e : edges) {
      const std::uint32_t before = polyline(e);
      flipped.push_back({before, add_polyline(e, points_of(e))});
    }
    return flipped;
  }

  Strand strand(Index curve)
  {
    Strand result;
    m_network.for_each_segment(curve, [&](Index s) {
      const Index h = m_network.halfedge(s);
      result.push_back(2 * polyline(h >> 1) + static_cast<std::uint32_t>(h & 1));
    });
    return result;
  }

  void add_changes(Index curve, std::vector<std::pair<std::uint32_t, std::uint32_t>> flipped)
  {
    Strand now = strand(curve);
    Strand& before = m_strands[curve];
    if(flipped.empty() && now == before)
      return;
    const auto front = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
    const auto end = std::mismatch(std::make_reverse_iterator(before.end()), std::make_reverse_iterator(front.first),
                                   std::make_reverse_iterator(now.end()), std::make_reverse_iterator(front.second));
    Recorded_step step;
    step.flipped = std::move(flipped);
    step.curve = static_cast<std::uint32_t>(curve);
    step.kept_in_front = static_cast<std::uint32_t>(front.second - now.begin());
    step.kept_at_end = static_cast<std::uint32_t>(end.second - std::make_reverse_iterator(now.end()));
    step.inserted.assign(front.second, end.second.base());
    m_record.steps.push_back(std::move(step));
    before = std::move(now);
  }

  const Network& m_network;
  std::size_t m_most_points, m_number_of_points = 0;
  std::size_t m_position = 0;
  std::unordered_map<Index, std::uint32_t> m_edges;
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

  void after_flip_out(const Network&, Index curve)
  {
    if(m_recorder)
      m_recorder->add_step(curve);
  }

private:
  std::optional<Shortening_recorder<Network>>& m_recorder;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_EXAMPLES_SHORTENING_RECORDER_H
