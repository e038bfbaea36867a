// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_METRIC_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_METRIC_ARCHETYPE_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <boost/multiprecision/cpp_int.hpp>

namespace Flip_geodesics_test {

using Exact_square = boost::multiprecision::cpp_rational;

/* A metric of points in double to which exact squared lengths are added. */
template <class Metric>
class Metric_with_squares : public Metric
{
public:
  using Metric::Metric;

  Exact_square squared_length(const typename Metric::Mesh& mesh, CGAL::Flip_geodesics::Input_halfedge_index h) const
  {
    const auto p = this->point(mesh, mesh.tail(h)), q = this->point(mesh, mesh.tail(mesh.twin(h)));
    const auto square = [](double from, double to) {
      const Exact_square difference = Exact_square(to) - Exact_square(from);
      return Exact_square(difference * difference);
    };
    return square(p.x(), q.x()) + square(p.y(), q.y()) + square(p.z(), q.z());
  }
};

/*
 * A model of `IntrinsicMetric` that has only the members listed on its page, with exact squared lengths in place of
 * faces. It holds another model, which has points, and forwards to it.
 */
template <class Metric>
class Metric_archetype
{
  using Vertex_index = CGAL::Flip_geodesics::Vertex_index;
  using Halfedge_index = CGAL::Flip_geodesics::Input_halfedge_index;

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

  Exact_square squared_length(const Mesh& mesh, Halfedge_index h) const { return m_metric.squared_length(mesh, h); }

private:
  Metric m_metric;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_METRIC_ARCHETYPE_H
