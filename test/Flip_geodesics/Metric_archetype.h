// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_METRIC_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_METRIC_ARCHETYPE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <CGAL/enum.h>

namespace Flip_geodesics_test {

/*
 * A model of `IntrinsicMetric` that has nothing but what its page asks for. It holds another model, which has points,
 * and forwards to it.
 */
template <class Metric>
class Metric_archetype
{
  using Index = CGAL::Flip_geodesics::Index;
  using Vertex_index = CGAL::Flip_geodesics::Vertex_index;
  using Halfedge_index = CGAL::Flip_geodesics::Input_halfedge_index;
  using Word = CGAL::Flip_geodesics::Edge_sequence;

public:
  using Mesh = typename Metric::Mesh;
  using Kernel = typename Metric::Kernel;
  using Point_3 = typename Metric::Point_3;

  class Place
  {
  public:
    Place() = default;

  private:
    friend class Metric_archetype;
    explicit Place(const typename Metric::Place& place)
      : m_place(place)
    {
    }

    typename Metric::Place m_place;
  };

  template <class Argument>
  explicit Metric_archetype(const Argument& argument)
    : m_metric(argument)
  {
  }

  double length(const Mesh& mesh, Halfedge_index h) const { return m_metric.length(mesh, h); }
  double weight(const Mesh& mesh, Halfedge_index h) const { return m_metric.weight(mesh, h); }
  double weight(const Mesh& mesh, Halfedge_index h, const Place& tail, const Place& head) const
  {
    return m_metric.weight(mesh, h, tail.m_place, head.m_place);
  }

  Place place(const Mesh& mesh, Vertex_index v) const { return Place(m_metric.place(mesh, v)); }
  double distance_lower_bound(const Place& p, const Place& q) const
  {
    return m_metric.distance_lower_bound(p.m_place, q.m_place);
  }

  Point_3 point(const Mesh& mesh, Vertex_index v) const { return m_metric.point(mesh, v); }

  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Halfedge_index h, const Traits& traits) const
  {
    return m_metric.face_geometry(mesh, h, traits);
  }
  auto exact_face(const Mesh& mesh, Halfedge_index h) const { return m_metric.exact_face(mesh, h); }
  template <class FlatEdges>
  bool sine_in_plane(const Mesh& mesh, const Word& a, const Word& b, Index steps, FlatEdges& flat_edges,
                     CGAL::Sign& sine) const
  {
    return m_metric.sine_in_plane(mesh, a, b, steps, flat_edges, sine);
  }

private:
  Metric m_metric;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_METRIC_ARCHETYPE_H
