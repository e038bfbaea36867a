// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CLASS_PATHS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CLASS_PATHS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/internal/topology/Covering_surface.h>
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

namespace CGAL::Flip_geodesics::internal {

/* Windows by the halfedge on which they lie. */
class Windows_by_halfedge
{
public:
  Windows_by_halfedge() = default;
  explicit Windows_by_halfedge(std::vector<Ray_window> windows)
    : m_windows(std::move(windows))
  {
    std::stable_sort(m_windows.begin(), m_windows.end(),
                     [](const Ray_window& a, const Ray_window& b) { return a.halfedge < b.halfedge; });
  }

  template <class Function>
  void for_each(Input_halfedge_index h, const Function& function) const
  {
    auto w = std::lower_bound(m_windows.begin(), m_windows.end(), h,
                              [](const Ray_window& a, Input_halfedge_index b) { return a.halfedge < b; });
    for(; w != m_windows.end() && w->halfedge == h; ++w)
      function(*w);
  }

private:
  std::vector<Ray_window> m_windows;
};

/* Returns the window as seen from the other end of an edge of some length. */
inline Ray_window reversed_window(Ray_window w, double length)
{
  w.x = length - w.x;
  const double from = length - w.to;
  w.to = length - w.from;
  w.from = from;
  return w;
}

/* Returns a lower bound on the joint length of paths through two windows, seen from one end of an edge, that meet on
 * it. */
inline double least_sum(const Ray_window& w, const Ray_window& other)
{
  const double from = (std::max)(w.from, other.from), to = (std::min)(w.to, other.to);
  if(!(from <= to))
    return std::numeric_limits<double>::infinity();
  const Cone cone = {w.x, w.y, w.sigma}, other_cone = {other.x, other.y, other.sigma};
  const double sum = cone.least_sum(other_cone, from, to);
  return sum - (w.radius + other.radius + 2 * Ray_window::evaluation_error * sum);
}

/*
 * Lower bounds on the distances from a vertex, for paths to a goal that are not longer than a bound. They come from a
 * lower-bound propagation, or from windows if that fails, as it does at needle-shaped faces. Bounds within 1% would be
 * useless there anyway: paths along a needle that wind around it different numbers of times are almost equally long,
 * and far more classes than necessary would be searched.
 */
template <class Triangulation>
class Distance_bounds
{
public:
  Distance_bounds(const Triangulation& triangulation, Vertex_index source, Vertex_index goal, double bound)
    : m_triangulation(triangulation)
    , m_source(source)
    , m_place(triangulation.metric().place(triangulation.input(), source))
    , m_goal(triangulation.metric().place(triangulation.input(), goal))
    , m_bound(bound)
    , m_faces(triangulation)
    , m_sweep(triangulation, m_faces, source, {triangulation, goal}, free_updates)
  {
  }

  /* Computes the bounds; returns whether they are valid, unless it is interrupted. */
  bool sweep(Interruption& interruption)
  {
    m_sweep.run(m_bound, &interruption);
    return m_sweep.is_useful();
  }

  /* Computes the bounds by at most `most_windows` windows, or as many as the limit of a search for one path; not a
   * second time. */
  void propagate_windows(std::size_t most_windows, Interruption& interruption)
  {
    if(are_by_windows())
      return;
    const Window_limit usual;
    m_windows = std::make_unique<Window_search<Triangulation>>(m_triangulation, m_faces, m_source);
    m_windows->keep_border_windows();
    const auto n = static_cast<std::size_t>(m_triangulation.number_of_vertices());
    if(!run_to_the_end(*m_windows, m_bound, (std::min)(most_windows, usual(n)), &interruption))
      return;
    m_unknown_from = m_windows->lower_bound();
    m_windows_on_border = Windows_by_halfedge(m_windows->border_windows());
    m_windows_inside = Windows_by_halfedge(m_windows->windows());
  }

  bool are_by_windows() const { return m_windows != nullptr; }
  std::size_t number_of_windows() const { return m_windows == nullptr ? 0 : m_windows->number_of_windows(); }

  /* Returns the bound at a vertex, which is at least the Euclidean distance. Paths to a vertex that was not reached are
   * too long to continue to the goal. */
  double at_vertex(Vertex_index v) const
  {
    const auto& metric = m_triangulation.metric();
    const auto place = metric.place(m_triangulation.input(), v);
    const double most = m_bound - metric.distance_lower_bound(place, m_goal);
    const double least =
        m_windows == nullptr ? m_sweep.distance_lower_bound(v) : (std::min)(m_windows->least_start(v), m_unknown_from);
    return (std::max)((std::min)(least, most), metric.distance_lower_bound(place, m_place));
  }

  /*
   * Returns a lower bound for the paths across the edge of a border halfedge h: from the source over faces on the other
   * side, and on from the edge of another surface below h, where bounds from the goal are known in the same way.
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
    if(are_by_windows())
      return (std::min)(least, between_ends(h, surface.below(h), length, other));
    const Edge_cones* const cones = m_sweep.cones(t);
    if(cones == nullptr)
      return least;
    const Edge_cones from = cones->mirrored(length);
    double across = other.through(surface.below(h), length, from.first, 0, (std::min)(from.split, length));
    if(from.split < length)
      across = (std::min)(across, other.through(surface.below(h), length, from.second, from.split, length));
    return (std::min)(least, across - m_sweep.total_error());
  }

  /* See the function of the propagation. */
  double through(Input_halfedge_index h, double length, const Cone& cone, double from, double to) const
  {
    return m_sweep.through(h, length, cone, from, to);
  }

  double unknown_from() const { return m_unknown_from; }
  const Windows_by_halfedge& windows_inside() const { return m_windows_inside; }

private:
  static constexpr int free_updates = 400; // many, since few cones at needles require them

  // The bound for paths that meet on the edge of h between its ends. Paths to the goal on either side count: those on
  // one side may have been dropped in favor of shorter ones on the other. Paths that run along the edge pass an end.
  template <class Other>
  double between_ends(Input_halfedge_index h, Input_halfedge_index below, double length,
                      const Distance_bounds<Other>& other) const
  {
    double least = (std::min)(m_unknown_from, other.unknown_from());
    m_windows_on_border.for_each(h, [&](const Ray_window& w) {
      other.windows_inside().for_each(below,
                                      [&](const Ray_window& on) { least = (std::min)(least, least_sum(w, on)); });
      other.windows_inside().for_each(twin_index(below), [&](const Ray_window& back) {
        least = (std::min)(least, least_sum(w, reversed_window(back, length)));
      });
    });
    return least;
  }

  const Triangulation& m_triangulation;
  Vertex_index m_source;
  typename Triangulation::Metric::Place m_place, m_goal;
  double m_bound;
  Unfolded_faces<Triangulation> m_faces;
  Cone_sweep<Triangulation> m_sweep;
  std::unique_ptr<Window_search<Triangulation>> m_windows; // null if the bounds of the propagation are valid
  double m_unknown_from = 0;                               // lower bound for the paths that the windows have not found
  Windows_by_halfedge m_windows_on_border, m_windows_inside;
};

/*
 * The shortest paths from one vertex to another in several homotopy classes: shortest paths to the target's lifts in
 * the universal cover, a part of which is constructed.
 *
 * Paths that leave the part cross its frontier. Two lower-bound propagations bound their lengths from below, up to the
 * frontier and on to the target. The part is enlarged at the frontier until this bound exceeds the lengths of the
 * requested paths: edge paths that are shortened in the part bound these from above.
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

  /* A path, its class, and its course in the cover. */
  struct Path
  {
    Index lift;
    Shortest_path_report report;
    std::vector<Place> places;
  };

  /* A class without a path among the shortest ones. */
  struct Left_out
  {
    Index lift;
    double length, lower_bound; // infinite if no path was searched for
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

  /* Finds the paths of `number` classes, if the part of the cover requires no more lifts than `most_lifts` and the
   * searches in it no more windows than in proportion. If it is interrupted, there are no paths, and the bound is 0. */
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
  /* Returns the paths by length. */
  const std::vector<Path>& paths() const { return m_paths; }
  const std::vector<Left_out>& left_out() const { return m_left_out; }
  /* Returns a lower bound on the lengths of paths in classes that were not found. */
  double frontier_bound() const { return m_frontier_bound; }

  /* Returns the halfedge of the mesh below a halfedge of the cover. */
  Input_halfedge_index below(Input_halfedge_index h) const { return m_surface->below(h); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  // Few parts require more than a hundred windows per lift in total; a lift takes about as much time as ten windows.
  static constexpr std::size_t least_windows = 1000000, windows_per_lift = 200;
  static constexpr std::size_t most_windows = (std::numeric_limits<std::size_t>::max)() / 2;

  /* A geodesic of a class, which may be obstructed by the frontier of the part in which it was found. */
  struct Geodesic
  {
    double length = infinity;
    bool is_held = true;
    bool is_shortest = false;                   // of its part
    std::size_t part = 0, part_of_shortest = 0; // in which it was found, counted from 1
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

  // Constructs the part that has been searched and finds the paths if it suffices; otherwise continues the search.
  // Returns whether that was the last part, also if it is interrupted.
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

  // By lower-bound propagation if possible, which usually fails in all parts or in none.
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

  // The limit for each search: the same as without other classes.
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

  // Of all classes whose paths may be among the requested ones, those with the least bounds first.
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

  // Returns whether a lift of the target is the start of all paths, in which case the path of its class is a point.
  bool is_source(Index lift) const { return m_surface->vertex(lift) == m_surface->vertex(0); }

  // Shortens an edge path to a lift of the target, unless that has been done and more of the cover cannot help.
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
                                   parameters::visitor(Interrupting_visitor(m_interruption)));
    if(edge_path.empty())
      return;
    {
      Network network(covering);
      network.add_curve(edge_path);
      shorten(network, Never_stop_predicate(), Interrupting_visitor(m_interruption));
      note_geodesic(geodesic, network);
    }
    covering.rollback();
  }

  // Finds the shortest path of the part if its length is at most `longest`, unless that has been done; the geodesic may
  // be much longer.
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

  // Returns the length of the longest among the paths of `number` classes, or of all classes found if there are fewer.
  double length_of_class(std::size_t number) const
  {
    std::vector<double> lengths;
    for(const auto& [lift, geodesic] : m_geodesics)
      lengths.push_back(geodesic.length);
    const auto last = lengths.begin() + static_cast<std::ptrdiff_t>((std::min)(number, lengths.size()) - 1);
    std::nth_element(lengths.begin(), last, lengths.end());
    return *last * (1 + class_bound_rounding);
  }

  // Finds where paths that may be shorter than the longest of the found ones leave the part.
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
                   internal::add_shortest_path(network, edge_paths, nullptr, m_surface->vertex(0),
                                               m_surface->vertex(lift), window_limit(covering),
                                               Interrupting_visitor(m_interruption)),
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

  // Returns whether a path is obstructed by the frontier.
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
  std::size_t m_part = 0; // the number of parts constructed so far
  std::unique_ptr<Surface> m_surface;
  std::unique_ptr<Distance_bounds<Triangulation>> m_to_target;
  std::map<Index, Geodesic> m_geodesics;                        // by lift of the target
  Indexed_by<Vertex_index, std::vector<char>> m_is_on_frontier; // of the cover
  double m_frontier_bound = 0;
  std::vector<Path> m_paths;
  std::vector<Left_out> m_left_out;
};

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_CLASS_PATHS_H
