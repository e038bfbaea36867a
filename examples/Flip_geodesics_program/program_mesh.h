// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_MESH_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_MESH_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <optional>

// The mesh of the program, its metric, and how the library numbers its elements.
namespace program {

using CGAL::Flip_geodesics::Index;
using CGAL::Flip_geodesics::Input_halfedge_index;
using CGAL::Flip_geodesics::Vertex_index;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

/// The index of an element of the mesh: it has the same number.
inline Vertex_index index_of(Mesh::Vertex_index v) { return Vertex_index(static_cast<Index>(v)); }
inline Input_halfedge_index index_of(Mesh::Halfedge_index h) { return Input_halfedge_index(static_cast<Index>(h)); }

/// The element of the mesh with an index.
inline Mesh::Vertex_index mesh_vertex(Vertex_index v)
{
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(v.idx()));
}
inline Mesh::Halfedge_index mesh_halfedge(Input_halfedge_index h)
{
  return Mesh::Halfedge_index(static_cast<Mesh::size_type>(h.idx()));
}

/// The positions of the corners of a flattened mesh in the plane, at the targets of halfedges.
using Texture_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
inline Texture_map texture_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:texture").first;
}

/// The diagonal of the box about all vertices.
inline double size_of(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

using Mesh_metric =
    CGAL::Flip_geodesics::Embedded_metric<Mesh, Mesh::Property_map<Mesh::Vertex_index, program::Point_3>>;

/// The metric of the mesh, or one with longer edges; one type for both, so that the engine is compiled once for each
/// arithmetic.
using Program_metric = CGAL::Flip_geodesics::Mollified_metric<Mesh_metric>;

/// The same of weighted lengths.
using Weighted_program_metric =
    CGAL::Flip_geodesics::Mollified_metric<CGAL::Flip_geodesics::Weighted_metric<Mesh_metric>>;

/// A metric with longer edges. \param margin of the triangle inequality, relative to the mean edge length; none for the
/// metric as it is
template <class Metric>
CGAL::Flip_geodesics::Mollified_metric<Metric> mollified_metric(const Mesh& mesh, const Metric& metric,
                                                                std::optional<double> margin)
{
  using Mollified_metric = CGAL::Flip_geodesics::Mollified_metric<Metric>;
  //! [Mollified metric]
  return margin ? Mollified_metric(mesh, metric, *margin) : Mollified_metric(metric);
  //! [Mollified metric]
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_MESH_H
