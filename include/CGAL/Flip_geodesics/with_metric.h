// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_WITH_METRIC_H
#define CGAL_FLIP_GEODESICS_WITH_METRIC_H

#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Flip_geodesics {

namespace internal {

enum Metric_parameter { metric_parameter };

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsMetrics
 *
 * A named parameter of the functions that take a mesh: the metric that they are to use instead of the mesh's own, an
 * `Edge_length_metric` for instance. Others can follow it, as in `with_metric(metric).geom_traits(traits)`.
 *
 * \param metric a model of `IntrinsicMetric` for the mesh; it is copied
 */
template <class Metric>
Named_function_parameters<Metric, internal::Metric_parameter> with_metric(const Metric& metric)
{
  static_assert(internal::is_metric<Metric>, "with_metric() takes a model of IntrinsicMetric: of a property map of "
                                             "lengths, Edge_length_metric makes one");
  return Named_function_parameters<Metric, internal::Metric_parameter>(metric);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_WITH_METRIC_H
