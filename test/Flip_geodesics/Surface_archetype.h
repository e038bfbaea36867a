// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_SURFACE_ARCHETYPE_H
#define FLIP_GEODESICS_TEST_SURFACE_ARCHETYPE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>

namespace Flip_geodesics_test {

/*
 * What the modules below `triangulation` may ask of the triangulation that is a parameter of their templates: the mesh,
 * its metric, and the limit of work for signs. It has neither edges that can be flipped nor what they cross, so that a hidden call of the module
 * above does not compile.
 */
template <class TriangleMesh>
class Surface_archetype
{
  using Index = CGAL::Flip_geodesics::Index;
  using Vertex_index = CGAL::Flip_geodesics::Vertex_index;

public:
  using Triangle_mesh = TriangleMesh;
  using Input_mesh = CGAL::Flip_geodesics::Numbered_mesh<TriangleMesh>;
  using Metric = CGAL::Flip_geodesics::Embedded_metric<
      TriangleMesh, typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>;

  struct Traits
  {
    using Has_drift = CGAL::Tag_false;
    std::uint64_t sign_work_limit() const { return CGAL::Flip_geodesics::internal::default_sign_work; }
  };

  explicit Surface_archetype(const TriangleMesh& mesh)
    : m_input(mesh)
    , m_metric(get(CGAL::vertex_point, mesh))
  {
  }

  const Input_mesh& input() const { return m_input; }
  const Metric& metric() const { return m_metric; }
  const Traits& traits() const { return m_traits; }
  Index number_of_vertices() const { return m_input.number_of_vertices(); }
  Index number_of_halfedges() const { return m_input.number_of_halfedges(); }
  Vertex_index index(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v) const { return m_input.index(v); }

private:
  Input_mesh m_input;
  Metric m_metric;
  Traits m_traits;
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_SURFACE_ARCHETYPE_H
