// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_DISTANCE_BOUNDS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_DISTANCE_BOUNDS_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/distances/Cone_sweep.h>
#include <CGAL/Flip_geodesics/internal/distances/Edge_cones.h>
#include <CGAL/Flip_geodesics/internal/distances/Ray_window.h>
#include <CGAL/Flip_geodesics/internal/distances/Unfolded_faces.h>
#include <CGAL/Flip_geodesics/internal/distances/Window_search.h>
#include <CGAL/Flip_geodesics/internal/surface/Interruption.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Windows by the halfedge that they lie on. */
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

/* The same window, seen from the other end of an edge of some length. */
inline Ray_window reversed_window(Ray_window w, double length)
{
  w.x = length - w.x;
  const double from = length - w.to;
  w.to = length - w.from;
  w.from = from;
  return w;
}

/* No two paths through windows, seen from one end of an edge, that meet on it are shorter together. */
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
 * Lower bounds of distances from a vertex, of paths to a goal that are not longer than a bound. They come from a sweep,
 * or from windows if that fails, as it does on needles. Bounds within 1 % are of no use there anyway: paths along a needle
 * that differ in how often they wind around it are about as long, and far more classes than are needed would be searched.
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
    , m_sweep(triangulation, m_faces, source, {triangulation, goal}, free_updates, most_updates_per_side)
  {
  }

  /* Computes the bounds; returns whether they hold, unless it is interrupted. */
  bool sweep(Interruption& interruption)
  {
    m_sweep.run(m_bound, &interruption);
    return m_sweep.is_useful();
  }

  /* Computes them by so many windows at most, or as many as the limit of a search for one path; not a second time. */
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

  /* A path to a vertex that was not reached is too long to go on from there, and as long as in space. */
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
   * The least bound of ways over the edge of a border halfedge h: from the source over faces on the other side, and on
   * from the edge of another surface over which h lies, where bounds from the goal are known, in the same way.
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

  /* As that of the sweep. */
  double through(Input_halfedge_index h, double length, const Cone& cone, double from, double to) const
  {
    return m_sweep.through(h, length, cone, from, to);
  }

  double unknown_from() const { return m_unknown_from; }
  const Windows_by_halfedge& windows_inside() const { return m_windows_inside; }

private:
  // Many, since few cones on needles need them; more than so many on average cost as much as windows.
  static constexpr int free_updates = 400;
  static constexpr std::size_t most_updates_per_side = 26;

  // What meets on the edge of h between its ends. Paths to the goal on either side count: those on the one side may be
  // dropped for shorter ones on the other. Paths that run along the edge pass an end.
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
  std::unique_ptr<Window_search<Triangulation>> m_windows; // null if the sweep's bounds hold
  double m_unknown_from = 0;                               // no path that the windows have not found is shorter
  Windows_by_halfedge m_windows_on_border, m_windows_inside;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_DISTANCE_BOUNDS_H
