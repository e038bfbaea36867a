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

#endif // CGAL_FLIP_GEODESICS_PROGRAM_PROGRAM_METRIC_H
