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
#include <CGAL/Flip_geodesics/internal/windows/Edge_cones.h>
#include <CGAL/Flip_geodesics/internal/windows/Unfolded_faces.h>
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
    , m_sweep(triangulation, m_faces, source, {triangulation, goal}, free_updates)
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

  /*
   * The least bound of ways over the edge of a border halfedge h: from the source over faces on the other side, and on
   * from the edge of another surface over which h lies, where bounds from the goal are known.
   */
  template <class Surface, class Other>
  double beyond(const Surface& surface, Input_halfedge_index h, const Distance_bounds<Other>& other) const
  {
    const auto beyond_end = [&](Input_halfedge_index g) {
      return at_vertex(surface.tail(g)) + other.at_vertex(surface.below().tail(surface.below(g)));
    };
    const Input_halfedge_index t = twin_index(h);
    const double length = m_triangulation.metric().length(m_triangulation.input(), h);
    const double at_ends[] = {beyond_end(h), beyond_end(t)}, least = (std::min)(at_ends[0], at_ends[1]);
    if(!m_sweep.is_useful())
      return 0.5 * (at_ends[0] + at_ends[1]) - length; // both bounds change by no more than a step is long
    const Edge_cones* const cones = m_sweep.cones(t);
    if(cones == nullptr)
      return least;
    const Edge_cones from = cones->mirrored(length);
    double across = other.through(surface.below(h), length, from.first, 0, (std::min)(from.split, length));
    if(from.split < length)
      across = (std::min)(across, other.through(surface.below(h), length, from.second, from.split, length));
    return (std::min)(least, across - m_sweep.total_error());
  }

  /* As that of the sweep. */
  double through(Input_halfedge_index h, double length, const Cone& cone, double from, double to) const
  {
    return m_sweep.through(h, length, cone, from, to);
  }

private:
  // Many, since few cones on needles need them, and a sweep that fails there costs far more of the covering.
  static constexpr int free_updates = 400;

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
    while(!try_part(number, most_lifts)) {
    }
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
  // Of what is swept, so that bounds beyond the longest path tell something.
  static constexpr double margin = 1 + 0x1p-5;
  // Of a length above its lower bound, that is worth a search for a shorter path.
  static constexpr double large_gap = 0x1p-4;
  // Of a bound, for the rounding of sums.
  static constexpr double rounding = 0x1p-40;

  /* A geodesic of a class, which may be held by where the covering's part ended when it was found. */
  struct Geodesic
  {
    double length = infinity;
    bool is_held = true;
    bool is_shortest = false;                   // of a part
    std::size_t part = 0, part_of_shortest = 0; // in which it was found, from 1 on
  };

  // Lays out what has been searched, and finds the paths if that is enough; goes on with the search otherwise.
  bool try_part(std::size_t number, std::size_t most_lifts)
  {
    ++m_part;
    m_surface = std::make_unique<Surface>(m_mesh, m_triangulation.input(), m_search);
    Covering covering(*m_surface, typename Covering::Metric(m_triangulation.metric()), m_triangulation.traits());
    mark_frontier();
    Shortest_edge_path<Covering> edge_paths(covering);
    for(std::size_t i = 0; i < (std::min)(number, m_search.targets().size()); ++i)
      find_geodesic(covering, edge_paths, m_search.targets()[i]);
    const double bound = length_of_class(number) * margin;
    const Distance_bounds<Covering> bounds(covering, m_surface->vertex(0),
                                           m_surface->vertex(m_search.targets().front()), bound);
    find_short_geodesics(covering, edge_paths, bounds, number);
    const double longest = length_of_class(number);
    if(m_to_target == nullptr)
      m_to_target = std::make_unique<Distance_bounds<Triangulation>>(m_triangulation, m_target, m_source, bound);
    const std::vector<Open_lift> open = find_frontier(bounds, bound, longest);
    if(!open.empty() && m_search.number_of_lifts() <= most_lifts) {
      m_search.run_from(
          open, [&](Vertex_index v) { return m_to_target->at_vertex(v); }, longest, most_lifts);
      return false;
    }
    m_search.shorten_paths();
    find_paths(covering, bounds, number);
    return true;
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
      if(!(bound < length_of_class(number)))
        return;
      find_geodesic(covering, edge_paths, lift);
      if(bound < (1 - large_gap) * m_geodesics[lift].length)
        find_shortest(covering, edge_paths, lift);
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
    {
      Network network(covering);
      const std::vector<Vertex_index> ends = {m_surface->vertex(0), m_surface->vertex(lift)};
      network.add_curve(shortest_halfedges_through(edge_paths, ends), false);
      shorten(network);
      note_geodesic(geodesic, network);
    }
    covering.rollback();
  }

  // Finds the shortest path of the part, where one that was pulled tight may be far from it, unless that has been done.
  void find_shortest(Covering& covering, Shortest_edge_path<Covering>& edge_paths, Index lift)
  {
    Geodesic& geodesic = m_geodesics[lift];
    if(geodesic.is_shortest && (!geodesic.is_held || geodesic.part_of_shortest == m_part))
      return;
    {
      Network network(covering);
      add_shortest_path(network, edge_paths, m_surface->vertex(0), m_surface->vertex(lift));
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
    return *last * (1 + rounding);
  }

  // Where ways leave the part that may be shorter than the longest of the paths.
  std::vector<Open_lift> find_frontier(const Distance_bounds<Covering>& bounds, double bound, double longest)
  {
    std::vector<Open_lift> open;
    m_frontier_bound = m_search.is_exhausted() ? infinity : bound;
    for(Input_halfedge_index h : descriptors<Input_halfedge_index>(m_surface->number_of_halfedges())) {
      if(!m_surface->is_frontier(h))
        continue;
      const double least = (std::max)(bounds.beyond(*m_surface, h, *m_to_target) * (1 - rounding), 0.0);
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
      Path path = {lift, add_shortest_path(network, edge_paths, m_surface->vertex(0), m_surface->vertex(lift)), {}};
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
  Covering_search<Triangulation> m_search;
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_CLASSES_CLASS_PATHS_H
