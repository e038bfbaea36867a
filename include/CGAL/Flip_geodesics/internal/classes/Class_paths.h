// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_CLASSES_CLASS_PATHS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_CLASSES_CLASS_PATHS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/classes/Covering_metric.h>
#include <CGAL/Flip_geodesics/internal/classes/Covering_search.h>
#include <CGAL/Flip_geodesics/internal/classes/Covering_surface.h>
#include <CGAL/Flip_geodesics/internal/windows/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/windows/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Lower bounds of distances from a vertex, of paths to a goal that are not longer than a bound. */
template <class Triangulation>
class Distance_bounds
{
public:
  Distance_bounds(const Triangulation& triangulation, Vertex_index source, Vertex_index goal, double bound)
    : m_triangulation(triangulation)
    , m_source(triangulation.metric().place(triangulation.input(), source))
    , m_goal(triangulation.metric().place(triangulation.input(), goal))
    , m_faces(triangulation)
    , m_sweep(triangulation, m_faces, source, goal)
  {
    m_sweep.run(bound);
  }

  /* A way to a vertex that the sweep has nothing to say of is too long to go on from there, and as long as in space. */
  double at_vertex(Vertex_index v) const
  {
    const auto& metric = m_triangulation.metric();
    const auto place = metric.place(m_triangulation.input(), v);
    const double most = m_sweep.bound() - metric.distance_lower_bound(place, m_goal);
    return (std::max)((std::min)(m_sweep.distance_lower_bound(v), most), metric.distance_lower_bound(place, m_source));
  }

  /* The least bound of all places on an edge: one end or the other is as near as half of the edge. */
  double on_edge(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation.input();
    const double length = m_triangulation.metric().length(input, h);
    return 0.5 * (at_vertex(input.tail(h)) + at_vertex(input.tail(twin_index(h))) - length);
  }

private:
  const Triangulation& m_triangulation;
  typename Triangulation::Metric::Place m_source, m_goal;
  Unfolded_faces<Triangulation> m_faces;
  Cone_sweep<Triangulation> m_sweep;
};

/*
 * The shortest paths from one vertex to another in several homotopy classes: shortest paths to the target's lifts in the
 * universal covering, of which a part is laid out.
 *
 * What leaves the part crosses its frontier. How long such a way is at least, up to there and on to the target, two
 * sweeps tell. The part is enlarged until that is more than the paths that are looked for can have.
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
  Class_paths(const Triangulation& triangulation, const Triangle_mesh& mesh, Vertex_index source, Vertex_index target)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_source(source)
    , m_target(target)
    , m_search(triangulation, source, target)
  {
  }

  /* Finds the paths of `number` classes, if the covering's part needs no more lifts than `most_lifts`. */
  void run(std::size_t number, std::size_t most_lifts)
  {
    m_search.run_to_targets(number, most_lifts);
    if(m_search.targets().empty())
      return;
    const double longest = m_search.distance(m_search.targets().back());
    double reach = longest * first_margin;
    while(!try_part(number, longest, reach, most_lifts))
      reach *= (std::min)((std::max)(longest / m_frontier_bound, least_growth), most_growth);
  }

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
  static constexpr double first_margin = 1.1, least_growth = 1.05, most_growth = 1.5;
  // Of a bound, for the rounding of sums.
  static constexpr double rounding = 0x1p-40;

  // Lays out what ways pass that are not longer than `reach` along edges; is that enough for all paths up to `longest`?
  bool try_part(std::size_t number, double longest, double reach, std::size_t most_lifts)
  {
    m_search.run(reach, most_lifts);
    m_surface = std::make_unique<Surface>(m_mesh, m_triangulation.input(), m_search);
    Covering covering(*m_surface, typename Covering::Metric(m_triangulation.metric()), m_triangulation.traits());
    const double bound = longest * (1 + 2 * rounding) + 2 * longest_edge(covering);
    const Distance_bounds<Covering> bounds(covering, m_surface->vertex(0),
                                           m_surface->vertex(m_search.targets().front()), bound);
    find_frontier(covering, bounds, bound);
    if(m_frontier_bound < longest && !m_search.is_exhausted() && m_search.number_of_lifts() <= most_lifts)
      return false;
    find_paths(covering, bounds, number);
    return true;
  }

  // What is left open along an edge is less.
  static double longest_edge(const Covering& covering)
  {
    double result = 0;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(covering.input().number_of_halfedges()))
      if(covering.input().is_border(h))
        result = (std::max)(result, covering.metric().length(covering.input(), h));
    return result;
  }

  void find_frontier(const Covering& covering, const Distance_bounds<Covering>& bounds, double bound)
  {
    m_is_on_frontier.assign(static_cast<std::size_t>(covering.number_of_vertices()), 0);
    const Distance_bounds<Triangulation> to_target(m_triangulation, m_target, m_source, bound);
    m_frontier_bound = m_search.is_exhausted() ? infinity : bound;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_surface->number_of_halfedges())) {
      if(!m_surface->is_frontier(h))
        continue;
      m_is_on_frontier[m_surface->tail(h)] = 1;
      const double least = bounds.on_edge(h) + to_target.on_edge(m_surface->below(h));
      m_frontier_bound = (std::min)(m_frontier_bound, least * (1 - rounding));
    }
    m_frontier_bound = (std::max)(m_frontier_bound, 0.0);
  }

  void find_paths(Covering& covering, const Distance_bounds<Covering>& bounds, std::size_t number)
  {
    Shortest_edge_path<Covering> edge_paths(covering);
    for(Index lift : m_search.targets()) {
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

  void find_path(Covering& covering, Shortest_edge_path<Covering>& edge_paths, Index lift, std::size_t number)
  {
    {
      Network network(covering);
      Path path = {lift, add_shortest_path(network, edge_paths, m_surface->vertex(0), m_surface->vertex(lift)), {}};
      path.report.lower_bound = (std::min)(path.report.lower_bound, m_frontier_bound);
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
  Covering_search<Triangulation> m_search;
  std::unique_ptr<Surface> m_surface;
  Indexed_by<Vertex_index, std::vector<char>> m_is_on_frontier; // of the covering
  double m_frontier_bound = 0;
  std::vector<Path> m_paths;
  std::vector<Left_out> m_left_out;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CLASSES_CLASS_PATHS_H
