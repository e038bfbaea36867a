// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H
#define CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H

#include <CGAL/Flip_geodesics/Mollified_metric.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/extract.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Triangulation_edge_policy.h>
#include <CGAL/Flip_geodesics/internal/numbers/ieee_arithmetic.h>
#include <CGAL/Flip_geodesics/internal/surface/check_vertex.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

/* A* over the edges of a triangulation as it is now, by distances in space if the metric has points. */
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

/* A shortest path along edges as they are now; none if none joins the vertices, or they are equal. */
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
 * The halfedges of a shortest path along edges of the triangulation as it is now, between any two of its vertices; none
 * if they are equal. It serves where `Shortest_edge_path`, which knows the input's edges only, does not: from and to
 * inserted vertices, and in flipped triangulations.
 *
 * Of equally long paths, the same one is found each time. \f$O(k \log k)\f$ for the \f$k\f$ vertices visited.
 *
 * \throws Vertex_out_of_range_error
 * \throws Disconnected_endpoints_error
 * \throws Degenerate_face_error, Invalid_coordinate_error for a face that the search meets
 */
template <class Triangulation>
std::vector<Halfedge_index> shortest_intrinsic_edge_path(const Triangulation& triangulation, Vertex_index source,
                                                         Vertex_index target)
{
  for(Vertex_index v : {source, target})
    internal::check_vertex(v, triangulation.number_of_vertices());
  std::vector<Halfedge_index> path = internal::intrinsic_edge_path(triangulation, source, target);
  if(path.empty() && source != target)
    throw Disconnected_endpoints_error(
        "no path of edges joins vertex " + std::to_string(source.idx()) + " and vertex " + std::to_string(target.idx()),
        {static_cast<std::size_t>(source.idx()), static_cast<std::size_t>(target.idx())});
  return path;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTRINSIC_EDGE_PATH_H
