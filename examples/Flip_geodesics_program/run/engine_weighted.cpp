// SPDX-License-Identifier: LGPL-3.0-or-later

#include "run/curve_runner.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>

std::unique_ptr<program::Curve_engine> program::make_weighted_engine(const Mesh& mesh,
                                                                     const Weighted_program_metric& metric,
                                                                     const Run_options& options, Progress& progress)
{
  using Traits = CGAL::Flip_geodesics::Certified_intrinsic_triangulation_traits<Kernel>;
  return std::make_unique<Curve_runner<Traits, Weighted_program_metric>>(mesh, metric, options, progress);
}
