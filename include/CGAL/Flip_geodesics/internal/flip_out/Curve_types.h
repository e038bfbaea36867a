// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_TYPES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_TYPES_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_options.h>
#include <CGAL/Flip_geodesics/internal/surface/Default_traits.h>
#include <CGAL/Flip_geodesics/internal/surface/make_visitor.h>
#include <CGAL/Flip_geodesics/metrics.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

// The types that the named parameters of the one-call functions stand for, in one place.

namespace CGAL {
namespace Flip_geodesics {

template <class Triangulation>
class Edge_path_network;

namespace internal {

/* The types behind the named parameters. */
template <class TriangleMesh, class NamedParameters>
struct Curve_types
{
  using Vertex = typename Vertex_of<TriangleMesh>::type;
  using Metric = Metric_by_name<TriangleMesh, NamedParameters>;
  using Traits = typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                              Default_traits<Metric>>::type;
  using Triangulation = Intrinsic_triangulation<TriangleMesh, Traits, Metric>;
  using Network = Edge_path_network<Triangulation>;
};

template <class TriangleMesh, class NamedParameters>
auto make_metric(const TriangleMesh& mesh, const NamedParameters& np)
{
  using Metric = typename Curve_types<TriangleMesh, NamedParameters>::Metric;
  if constexpr(is_given<NamedParameters, Metric_parameter>)
    return parameters::get_parameter(np, metric_parameter);
  else if constexpr(is_given<NamedParameters, internal_np::vertex_point_t>)
    return Metric(parameters::get_parameter(np, internal_np::vertex_point));
  else
    return Metric(get_const_property_map(CGAL::vertex_point, mesh));
}

template <class TriangleMesh, class NamedParameters>
auto make_triangulation(const TriangleMesh& mesh, const NamedParameters& np,
                        Zero_length_edges zero_length_edges = Zero_length_edges::REFUSE)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  const auto traits =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits), typename Types::Traits());
  return typename Types::Triangulation(mesh, make_metric(mesh, np), traits, zero_length_edges);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_TYPES_H
