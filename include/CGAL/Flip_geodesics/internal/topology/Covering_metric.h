// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_METRIC_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_METRIC_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Mollified_metric.h>
#include <CGAL/Flip_geodesics/Numbered_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/imported_number.h>
#include <CGAL/Flip_geodesics/internal/topology/Covering_surface.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The metric of a covering surface: that of what lies below. A model of IntrinsicMetric. */
template <class TriangleMesh, class Metric>
class Covering_metric
{
public:
  using Mesh = Numbered_mesh<Covering_surface<TriangleMesh>>;
  using Kernel = typename Metric::Kernel;
  using Point_3 = typename Metric_point<Metric>::type;
  using Place = typename Metric::Place;

  explicit Covering_metric(const Metric& metric)
    : m_metric(metric)
    , m_flat_edges(std::make_shared<Flat_edges>())
  {
  }

  decltype(auto) point(const Mesh& mesh, Vertex_index v) const
  {
    return m_metric.point(below(mesh), mesh.surface().below(v));
  }

  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.length(below(mesh), mesh.surface().below(h));
  }
  double weight(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.weight(below(mesh), mesh.surface().below(h));
  }
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return m_metric.weight(below(mesh), mesh.surface().below(h), tail, head);
  }

  Place place(const Mesh& mesh, Vertex_index v) const { return m_metric.place(below(mesh), mesh.surface().below(v)); }
  double distance_lower_bound(const Place& p, const Place& q) const { return m_metric.distance_lower_bound(p, q); }

  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return m_metric.face_geometry(below(mesh), mesh.surface().below(h), traits);
  }

  bool is_rounded(const Mesh& mesh) const { return is_rounded_metric(m_metric, below(mesh)); }

  Exact_face exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_metric.exact_face(below(mesh), mesh.surface().below(h));
  }

  /* What is known of flat edges is kept for those below. */
  bool sine_in_plane(const Mesh& mesh, const Crossing_word& a, const Crossing_word& b, Index steps, Flat_edges&,
                     Sign& sine) const
  {
    if(m_flat_edges->size() == 0)
      *m_flat_edges = Flat_edges(static_cast<std::size_t>(below(mesh).number_of_halfedges() / 2));
    sine = ZERO;
    return m_metric.sine_in_plane(below(mesh), below(mesh, a), below(mesh, b), steps, *m_flat_edges, sine);
  }

private:
  static const Numbered_mesh<TriangleMesh>& below(const Mesh& mesh) { return mesh.surface().below(); }

  static Crossing_word below(const Mesh& mesh, Crossing_word word)
  {
    const auto project = [&mesh](auto& element) {
      if(element != null_index)
        element = mesh.surface().below(element);
    };
    project(word.along);
    project(word.face);
    project(word.tail);
    project(word.head);
    for(Input_halfedge_index& h : word.crossed)
      project(h);
    return word;
  }

  Metric m_metric;
  std::shared_ptr<Flat_edges> m_flat_edges;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TOPOLOGY_COVERING_METRIC_H
