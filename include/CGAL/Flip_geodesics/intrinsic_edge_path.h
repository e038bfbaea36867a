// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/distances/Label_setting_search.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Flip_geodesics {
namespace internal {

/* A search along the current edges of a triangulation. */
using Triangulation_edge_search = Label_setting_search<Search_labels<Halfedge_index>>;

/*
 * The policy of such a search, which ends at a vertex. Unlike searches over the input, it copies the faces that it
 * visits. Derived classes hide the members that differ.
 */
template <class Triangulation>
class Triangulation_edge_policy : public Edge_policy
{
public:
  Triangulation_edge_policy(const Triangulation& triangulation, Vertex_index target)
    : m_triangulation(triangulation)
    , m_target(target)
  {
  }

  bool settle(Vertex_index v) const { return v != m_target; }

  /* The order is counterclockwise up to the border, if any, then clockwise, and then in the other umbrellas. */
  template <class Function>
  void for_each_halfedge(const Origin& origin, const Function& function) const
  {
    const Halfedge_index start = m_triangulation.outgoing(origin.vertex);
    if(start == null_index)
      return;
    Halfedge_index h = start, first = start;
    do {
      function(h);
      first = h;
      h = m_triangulation.counterclockwise(h);
    } while(h != null_index && h != start);
    if(h == start)
      return;
    for(h = m_triangulation.clockwise(start); h != null_index; h = m_triangulation.clockwise(h))
      function(h);
    for_each_outgoing_halfedge_of_other_umbrellas(m_triangulation, first, function);
  }

  Vertex_index head(Halfedge_index h) const { return m_triangulation.head(h); }

  /* \throws Degenerate_face_error, Invalid_coordinate_error */
  Step step(const Origin& origin, Halfedge_index h, Vertex_index) const
  {
    return {origin.distance + m_triangulation.length(h)};
  }

protected:
  const Triangulation& triangulation() const { return m_triangulation; }
  Vertex_index target() const { return m_target; }

private:
  const Triangulation& m_triangulation;
  Vertex_index m_target;
};

/* Returns the halfedges of the shortest path by a policy from a vertex to its target, or none if no path exists. */
template <class Triangulation, class Policy>
std::vector<Halfedge_index> path_along_edges(const Triangulation& triangulation, Vertex_index source,
                                             Vertex_index target, const Policy& policy,
                                             Triangulation_edge_search& search)
{
  search.clear();
  search.add_source(source);
  if(search.run(policy))
    return {}; // the target has not been settled
  return search.path<Halfedge_index>(target, [&](Halfedge_index h) { return triangulation.tail(h); });
}

/* A* over the current edges of a triangulation, guided by distances in space if the metric has points. */
template <class Triangulation>
class Intrinsic_edge_policy : public Triangulation_edge_policy<Triangulation>
{
  using Base = Triangulation_edge_policy<Triangulation>;
  using Point = typename Metric_point<typename Triangulation::Metric>::type;
  static constexpr bool has_points = !std::is_void<Point>::value;

public:
  Intrinsic_edge_policy(const Triangulation& triangulation, Vertex_index source, Vertex_index target)
    : Base(triangulation, target)
    , m_is_bounded(has_points && std::isfinite(lower_bound(source)))
  {
  }

  double key(Vertex_index w, const typename Base::Step& step) const
  {
    return step.distance + (m_is_bounded ? lower_bound(w) : 0);
  }

private:
  double lower_bound(Vertex_index v) const
  {
    if constexpr(has_points) {
      const Point p = point(v), q = point(this->target());
      const double x = CGAL::to_double(q.x() - p.x()), y = CGAL::to_double(q.y() - p.y()),
                   z = CGAL::to_double(q.z() - p.z());
      return std::sqrt(internal::unfused(x * x) + internal::unfused(y * y) + internal::unfused(z * z));
    } else {
      return static_cast<void>(v), 0;
    }
  }

  auto point(Vertex_index v) const
  {
    return point_in_space(this->triangulation(), surface_point_at_vertex(this->triangulation(), v));
  }

  bool m_is_bounded;
};

/* Returns a shortest path along current edges; empty if the vertices are equal or not connected. */
template <class Triangulation>
std::vector<Halfedge_index> intrinsic_edge_path(const Triangulation& triangulation, Vertex_index source,
                                                Vertex_index target)
{
  if(source == target)
    return {};
  const Intrinsic_edge_policy<Triangulation> policy(triangulation, source, target);
  Triangulation_edge_search search(static_cast<std::size_t>(triangulation.number_of_vertices()));
  return path_along_edges(triangulation, source, target, policy, search);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Returns the halfedges of a shortest path from `source` to `target` along the current edges of a triangulation. The
 * result is empty if the vertices are equal.
 *
 * In contrast to `Shortest_edge_path`, which searches the edges of the input, the function also handles flipped edges
 * and inserted vertices. If there are several shortest paths, the same one is returned in each call.
 *
 * \throws Vertex_out_of_range_error if `source` or `target` is not a vertex of the triangulation
 * \throws Disconnected_endpoints_error if no edge path connects the vertices
 * \throws Degenerate_face_error if a face that the search visits has a degenerate edge or violates the triangle
 *         inequality
 * \throws Invalid_coordinate_error if a face that the search visits has an invalid coordinate or length
 *
 * Complexity: \cgalBigO{k \log k} for the \f$k\f$ vertices that the search visits.
 */
template <class Triangulation>
std::vector<Halfedge_index> shortest_intrinsic_edge_path(const Triangulation& triangulation, Vertex_index source,
                                                         Vertex_index target)
{
  internal::check_vertex(source, triangulation.number_of_vertices(), "the source");
  internal::check_vertex(target, triangulation.number_of_vertices(), "the target");
  std::vector<Halfedge_index> path = internal::intrinsic_edge_path(triangulation, source, target);
  if(path.empty() && source != target)
    internal::throw_disconnected(source, target);
  return path;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H
