// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CLASS_PATHS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CLASS_PATHS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Interrupting_visitor.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Covering_metric.h>
#include <CGAL/Flip_geodesics/internal/topology/Covering_search.h>
#include <CGAL/Flip_geodesics/internal/topology/Covering_surface.h>
#include <CGAL/Flip_geodesics/internal/topology/Distance_bounds.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * The shortest paths from one vertex to another in several homotopy classes: shortest paths to the target's lifts in the
 * universal covering, of which a part is laid out.
 *
 * What leaves the part crosses its frontier. How long such a way is at least, up to there and on to the target, two
 * sweeps tell. The part is enlarged there, until that is more than the paths that are looked for can have: edge paths
 * that are pulled tight in the part say how long these are at most.
 */
template <class Triangulation>
class Class_paths
{
  using Triangle_mesh = typename Triangulation::Triangle_mesh;
  using Surface = Covering_surface<Triangle_mesh>;
  using Covering = Intrinsic_triangulation<Surface, typename Triangulation::Traits,
                                           Covering_metric<Triangle_mesh, typename Triangulation::Metric>>;
  using Network = Edge_path_network<Covering>;

public:
  using Place = typename Curve_forms<Covering>::All;

  /* A path, in which class it is, and where it runs in the covering. */
  struct Path
  {
    Index lift;
    Shortest_path_report report;
    std::vector<Place> places;
  };

  /* A class that has no path among the shortest ones. */
  struct Left_out
  {
    Index lift;
    double length, lower_bound; // infinite if no path was looked for
  };

  /* \throws as `Covering_search` */
  Class_paths(const Triangulation& triangulation, const Triangle_mesh& mesh, Vertex_index source, Vertex_index target,
              Interruption& interruption)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_source(source)
    , m_target(target)
    , m_interruption(interruption)
    , m_search(triangulation, source, target, interruption)
  {
  }

  /* Finds the paths of `number` classes, if the covering's part needs no more lifts than `most_lifts`, and the searches
   * in its parts no more windows than in proportion. If it is interrupted, there are no paths, and the bound is 0. */
  void run(std::size_t number, std::size_t most_lifts)
  {
    find_all(number, most_lifts);
    if(!is_interrupted())
      return;
    m_paths.clear();
    m_left_out.clear();
    m_frontier_bound = 0;
  }

  bool is_interrupted() const { return m_interruption.has_occurred(); }

  const Covering_search<Triangulation>& search() const { return m_search; }
  /* By length. */
  const std::vector<Path>& paths() const { return m_paths; }
  const std::vector<Left_out>& left_out() const { return m_left_out; }
  /* No path is shorter that is of no class found. */
  double frontier_bound() const { return m_frontier_bound; }

  /* What lies below a halfedge of the covering. */
  Input_halfedge_index below(Input_halfedge_index h) const { return m_surface->below(h); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // Few parts need more than a hundred windows for each lift in all; a lift takes about as much time as ten windows.
  static constexpr std::size_t least_windows = 1000000, windows_per_lift = 200;
  static constexpr std::size_t most_windows = (std::numeric_limits<std::size_t>::max)() / 2;

  /* A geodesic of a class, which may be held by where the covering's part ended when it was found. */
  struct Geodesic
  {
    double length = infinity;
    bool is_held = true;
    bool is_shortest = false;                   // of a part
    std::size_t part = 0, part_of_shortest = 0; // in which it was found, from 1 on
  };

  void find_all(std::size_t number, std::size_t most_lifts)
  {
    m_windows_left = (std::min)(most_lifts, most_windows / windows_per_lift) * windows_per_lift + least_windows;
    m_search.run_to_targets(number, most_lifts);
    if(m_search.targets().empty() || is_interrupted())
      return;
    while(!try_part(number, most_lifts)) {
    }
  }

  // Lays out what has been searched, and finds the paths if that is enough; goes on with the search otherwise. Returns
  // whether that was the last part, also if it is interrupted.
  bool try_part(std::size_t number, std::size_t most_lifts)
  {
    if(m_interruption.begin_part())
      return true;
    ++m_part;
    m_surface = std::make_unique<Surface>(m_mesh, m_triangulation.input(), m_search);
    Covering covering(*m_surface, typename Covering::Metric(m_triangulation.metric()), m_triangulation.traits());
    mark_frontier();
    Shortest_edge_path<Covering> edge_paths(covering);
    for(std::size_t i = 0; i < (std::min)(number, m_search.targets().size()); ++i)
      find_geodesic(covering, edge_paths, m_search.targets()[i]);
    if(is_interrupted())
      return true;
    const double bound = length_of_class(number) * (1 + class_search_margin);
    Distance_bounds<Covering> bounds(covering, m_surface->vertex(0), m_surface->vertex(m_search.targets().front()),
                                     bound);
    find_bounds(bounds);
    find_short_geodesics(covering, edge_paths, bounds, number);
    const double longest = length_of_class(number);
    if(m_to_target == nullptr) {
      m_to_target = std::make_unique<Distance_bounds<Triangulation>>(m_triangulation, m_target, m_source, bound);
      find_bounds(*m_to_target);
    }
    if(bounds.are_by_windows() != m_to_target->are_by_windows()) {
      find_bounds(bounds);
      find_bounds(*m_to_target);
    }
    if(is_interrupted())
      return true;
    const std::vector<Open_lift> open = find_frontier(bounds, bound, longest);
    if(is_interrupted())
      return true;
    if(!open.empty() && m_search.number_of_lifts() <= most_lifts && m_windows_left > 0) {
      m_search.run_from(
          open, [&](Vertex_index v) { return m_to_target->at_vertex(v); }, longest, most_lifts);
      return false;
    }
    m_search.shorten_paths();
    find_paths(covering, bounds, number);
    return true;
  }

  // By a sweep if that does; sweeps fail in all parts or in none, mostly.
  template <class Bounds>
  void find_bounds(Bounds& bounds)
  {
    if(is_interrupted() || (!m_do_sweeps_fail && bounds.sweep(m_interruption)))
      return;
    m_do_sweeps_fail = true;
    bounds.propagate_windows(m_windows_left, m_interruption);
    count_windows(bounds.number_of_windows());
  }

  void count_windows(std::size_t number) { m_windows_left -= (std::min)(m_windows_left, number); }

  // What one of the searches may use: no more than without other classes.
  Window_limit window_limit(const Covering& covering) const
  {
    return Window_limit(
        (std::min)(Window_limit()(static_cast<std::size_t>(covering.number_of_vertices())), m_windows_left));
  }

  void mark_frontier()
  {
    m_is_on_frontier.assign(static_cast<std::size_t>(m_surface->number_of_vertices()), 0);
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_surface->number_of_halfedges()))
      if(m_surface->is_frontier(h))
        m_is_on_frontier[m_surface->tail(h)] = 1;
  }

  // Of all classes whose paths may be among those looked for, the ones with the least bounds first.
  void find_short_geodesics(Covering& covering, Shortest_edge_path<Covering>& edge_paths,
                            const Distance_bounds<Covering>& bounds, std::size_t number)
  {
    std::vector<std::pair<double, Index>> targets;
    for(Index lift : m_search.targets())
      targets.emplace_back(bounds.at_vertex(m_surface->vertex(lift)), lift);
    std::sort(targets.begin(), targets.end());
    for(const auto& [bound, lift] : targets) {
      const double longest = length_of_class(number);
      if(!(bound < longest))
        return;
      find_geodesic(covering, edge_paths, lift);
      if(is_interrupted())
        return;
      if(bound < (1 - class_large_gap) * m_geodesics[lift].length && m_windows_left > 0)
        find_shortest(covering, edge_paths, lift, longest);
    }
  }

  // Is a lift of the target the start of all paths? Then the path of its class is a point.
  bool is_source(Index lift) const { return m_surface->vertex(lift) == m_surface->vertex(0); }

  // Pulls an edge path to a lift of the target tight, unless that has been done, and more of the covering is no help.
  void find_geodesic(Covering& covering, Shortest_edge_path<Covering>& edge_paths, Index lift)
  {
    Geodesic& geodesic = m_geodesics[lift];
    if(!geodesic.is_held || geodesic.part == m_part)
      return;
    if(is_source(lift)) {
      geodesic = {0, false, true, m_part, m_part};
      return;
    }
    if(m_interruption.begin_part())
      return;
    const std::vector<Halfedge_index> edge_path =
        shortest_halfedges_through(edge_paths, std::vector<Vertex_index>{m_surface->vertex(0), m_surface->vertex(lift)},
                                   false, Interrupting_visitor(m_interruption));
    if(edge_path.empty())
      return;
    {
      Network network(covering);
      network.add_curve(edge_path, false);
      shorten(network, Never_stop_predicate(), Interrupting_visitor(m_interruption));
      note_geodesic(geodesic, network);
    }
    covering.rollback();
  }

  // Finds the shortest path of the part if it is at most so long, unless that has been done; the geodesic may be far
  // longer.
  void find_shortest(Covering& covering, Shortest_edge_path<Covering>& edge_paths, Index lift, double longest)
  {
    Geodesic& geodesic = m_geodesics[lift];
    if(geodesic.is_shortest && (!geodesic.is_held || geodesic.part_of_shortest == m_part))
      return;
    {
      Network network(covering);
      count_windows(internal::add_shortest_path(network, edge_paths, nullptr, m_surface->vertex(0),
                                                m_surface->vertex(lift), window_limit(covering),
                                                Interrupting_visitor(m_interruption), longest)
                        .windows);
      if(is_interrupted())
        return;
      note_geodesic(geodesic, network);
      geodesic.is_shortest = true;
      geodesic.part_of_shortest = m_part;
    }
    covering.rollback();
  }

  void note_geodesic(Geodesic& geodesic, const Network& network) const
  {
    geodesic.length = (std::min)(geodesic.length, network.length(Curve_index(0)));
    geodesic.is_held = touches_frontier(network);
    geodesic.part = m_part;
  }

  // The longest of the paths of so many classes is no longer, or of all classes found if they are fewer.
  double length_of_class(std::size_t number) const
  {
    std::vector<double> lengths;
    for(const auto& [lift, geodesic] : m_geodesics)
      lengths.push_back(geodesic.length);
    const auto last = lengths.begin() + static_cast<std::ptrdiff_t>((std::min)(number, lengths.size()) - 1);
    std::nth_element(lengths.begin(), last, lengths.end());
    return *last * (1 + class_bound_rounding);
  }

  // Where ways leave the part that may be shorter than the longest of the paths.
  std::vector<Open_lift> find_frontier(const Distance_bounds<Covering>& bounds, double bound, double longest)
  {
    std::vector<Open_lift> open;
    m_frontier_bound = m_search.is_exhausted() ? infinity : bound;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_surface->number_of_halfedges())) {
      if(!m_surface->is_frontier(h))
        continue;
      if(m_interruption.count_step())
        break;
      const double least = (std::max)(bounds.beyond(*m_surface, h, *m_to_target) * (1 - class_bound_rounding), 0.0);
      m_frontier_bound = (std::min)(m_frontier_bound, least);
      if(least < longest)
        for(Input_halfedge_index g : {h, twin_index(h)})
          open.push_back({m_surface->lift(g), bounds.at_vertex(m_surface->tail(g)), least});
    }
    return open;
  }

  void find_paths(Covering& covering, const Distance_bounds<Covering>& bounds, std::size_t number)
  {
    Shortest_edge_path<Covering> edge_paths(covering);
    for(Index lift : m_search.targets()) {
      if(m_interruption.begin_part())
        return;
      const double bound = bounds.at_vertex(m_surface->vertex(lift));
      if(m_paths.size() == number && !(bound < m_paths.back().report.length))
        m_left_out.push_back({lift, infinity, (std::min)(bound, m_frontier_bound)});
      else
        find_path(covering, edge_paths, lift, number);
    }
    std::stable_sort(m_left_out.begin(), m_left_out.end(), [](const Left_out& a, const Left_out& b) {
      return (std::min)(a.length, a.lower_bound) < (std::min)(b.length, b.lower_bound);
    });
  }

  // The path of the class that is a point, as its two ends.
  static Path point_path(const Covering& covering, const Surface& surface, Index lift)
  {
    Shortening_report shortening;
    shortening.curves.push_back(report_of_point(covering));
    const Form_converter<Covering, Place> convert(covering, surface);
    return {lift, report_of_no_length(shortening),
            std::vector<Place>(2, convert(surface_point_at_vertex(covering, surface.vertex(lift))))};
  }

  void find_path(Covering& covering, Shortest_edge_path<Covering>& edge_paths, Index lift, std::size_t number)
  {
    if(is_source(lift))
      return keep(point_path(covering, *m_surface, lift), number);
    {
      Network network(covering);
      Path path = {lift,
                   add_shortest_path(network, edge_paths, m_surface->vertex(0), m_surface->vertex(lift),
                                     window_limit(covering), Interrupting_visitor(m_interruption)),
                   {}};
      if(is_interrupted())
        return;
      count_windows(path.report.windows);
      path.report.lower_bound = (std::min)(path.report.lower_bound, m_frontier_bound);
      if(path.report.is_confirmed())
        path.report.verdict = verdict_of(path.report);
      if(touches_frontier(network)) {
        m_left_out.push_back({lift, infinity, path.report.lower_bound});
      } else {
        Curve_extractor<Network>(network).curve_points(Curve_index(0), *m_surface, std::back_inserter(path.places));
        keep(std::move(path), number);
      }
    }
    covering.rollback();
  }

  // Is a path held by where the covering's part ends?
  bool touches_frontier(const Network& network) const
  {
    bool result = false;
    network.for_each_segment(Curve_index(0), [&](Segment_index s) {
      result = result || m_is_on_frontier[network.triangulation().tail(network.halfedge(s))] != 0;
    });
    return result;
  }

  void keep(Path&& path, std::size_t number)
  {
    const auto place = std::upper_bound(m_paths.begin(), m_paths.end(), path.report.length,
                                        [](double length, const Path& other) { return length < other.report.length; });
    m_paths.insert(place, std::move(path));
    if(m_paths.size() <= number)
      return;
    const Path& last = m_paths.back();
    m_left_out.push_back({last.lift, last.report.length, last.report.lower_bound});
    m_paths.pop_back();
  }

  const Triangulation& m_triangulation;
  const Triangle_mesh& m_mesh;
  Vertex_index m_source, m_target;
  Interruption& m_interruption;
  Covering_search<Triangulation> m_search;
  std::size_t m_windows_left = 0;
  bool m_do_sweeps_fail = false;
  std::size_t m_part = 0; // how many parts have been laid out
  std::unique_ptr<Surface> m_surface;
  std::unique_ptr<Distance_bounds<Triangulation>> m_to_target;
  std::map<Index, Geodesic> m_geodesics;                        // by lift of the target
  Indexed_by<Vertex_index, std::vector<char>> m_is_on_frontier; // of the covering
  double m_frontier_bound = 0;
  std::vector<Path> m_paths;
  std::vector<Left_out> m_left_out;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CLASS_PATHS_H
