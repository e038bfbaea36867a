// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H

#include "program_mesh.h"

#include <CGAL/Flip_geodesics/derived_metrics.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <optional>

namespace program {

/*!
 * The mesh's own metric, or that with edges made longer: one class for both, so that the engine is compiled once for
 * each arithmetic.
 */
class Program_metric
{
  using Embedded =
      CGAL::Flip_geodesics::Embedded_metric<program::Mesh,
                                            program::Mesh::Property_map<program::Mesh::Vertex_index, program::Point_3>>;
  using Mollified = CGAL::Flip_geodesics::Mollified_metric<Embedded>;
  using Word = CGAL::Flip_geodesics::Edge_sequence;

public:
  using Mesh = Embedded::Mesh;
  using Point_3 = Embedded::Point_3;
  using Kernel = Embedded::Kernel;
  using Place = Embedded::Place;

  /// \param margin of the triangle inequality, relative to the mean edge length; none for the mesh's own metric
  Program_metric(const program::Mesh& mesh, std::optional<double> margin)
    : m_embedded(mesh.points())
  {
    //! [Mollified metric]
    if(margin)
      m_mollified.emplace(mesh, m_embedded, *margin);
    //! [Mollified metric]
    m_added = added_length();
  }

  /// The length that was added to every edge.
  double added_length() const { return m_mollified ? m_mollified->added_length() : 0; }

  decltype(auto) point(const Mesh& mesh, Vertex_index v) const { return m_embedded.point(mesh, v); }
  Place place(const Mesh& mesh, Vertex_index v) const { return m_embedded.place(mesh, v); }
  double distance_lower_bound(const Place& p, const Place& q) const { return m_embedded.distance_lower_bound(p, q); }

  double length(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_mollified ? m_mollified->length(mesh, h) : m_embedded.length(mesh, h);
  }

  // A length and zero is the same length, to the bit.
  double weight(const Mesh& mesh, Input_halfedge_index h) const { return m_embedded.weight(mesh, h) + m_added; }
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const
  {
    return m_embedded.weight(mesh, h, tail, head) + m_added;
  }

  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const
  {
    return m_mollified ? m_mollified->face_geometry(mesh, h, traits) : m_embedded.face_geometry(mesh, h, traits);
  }

  auto exact_face(const Mesh& mesh, Input_halfedge_index h) const
  {
    return m_mollified ? m_mollified->exact_face(mesh, h) : m_embedded.exact_face(mesh, h);
  }

  template <class FlatEdges>
  bool sine_in_plane(const Mesh& mesh, const Word& a, const Word& b, Index steps, FlatEdges& flat_edges,
                     CGAL::Sign& sine) const
  {
    return !m_mollified && m_embedded.sine_in_plane(mesh, a, b, steps, flat_edges, sine);
  }

private:
  Embedded m_embedded;
  std::optional<Mollified> m_mollified;
  double m_added = 0;
};

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H
