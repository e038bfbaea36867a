// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H
#define CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H

#include "program_mesh.h"

#include <CGAL/Flip_geodesics/metrics.h>

#include <optional>

namespace program {

using Mesh_metric =
    CGAL::Flip_geodesics::Embedded_metric<Mesh, Mesh::Property_map<Mesh::Vertex_index, program::Point_3>>;

/// The metric of the mesh, or one with longer edges; one type for both, so that the engine is compiled once for each
/// arithmetic.
using Program_metric = CGAL::Flip_geodesics::Mollified_metric<Mesh_metric>;

/// \param margin of the triangle inequality, relative to the mean edge length; none for the metric of the mesh
inline Program_metric program_metric(const Mesh& mesh, std::optional<double> margin)
{
  const Mesh_metric metric(mesh.points());
  //! [Mollified metric]
  return margin ? Program_metric(mesh, metric, *margin) : Program_metric(metric);
  //! [Mollified metric]
}

} // namespace program

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H
