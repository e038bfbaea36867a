// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_OPTIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_OPTIONS_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <type_traits>

// What the named parameters of the one-call functions are, as far as their declarations need it.

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The metric's type: as it is given, or of the points that are given, or of the mesh's own. */
template <class TriangleMesh, class NamedParameters, bool HAS_METRIC, bool HAS_POINTS>
struct Metric_of
{
  using type = Given<NamedParameters, Metric_parameter>;
};

template <class TriangleMesh, class NamedParameters>
struct Metric_of<TriangleMesh, NamedParameters, false, true>
{
  using type = Embedded_metric<TriangleMesh, Given<NamedParameters, internal_np::vertex_point_t>>;
};

template <class TriangleMesh, class NamedParameters>
struct Metric_of<TriangleMesh, NamedParameters, false, false>
{
  static_assert(graph_has_property<TriangleMesh, boost::vertex_point_t>::value,
                "the mesh has no points of its own: give vertex_point_map() or metric()");
  using type =
      Embedded_metric<TriangleMesh, typename property_map_selector<TriangleMesh, boost::vertex_point_t>::const_type>;
};

struct No_graph
{
  struct vertex_descriptor
  {
  };
};

/* The vertices of what a function is given first. */
template <class TriangleMesh>
struct Vertex_of
{
  static_assert(Has_faces<TriangleMesh>::value,
                "the first argument is no mesh; the order is mesh, ends or curves, output, named parameters");
  using Graph = std::conditional_t<Has_faces<TriangleMesh>::value, boost::graph_traits<TriangleMesh>, No_graph>;
  using type = typename Graph::vertex_descriptor;
};

template <class TriangleMesh>
using Vertex_in = typename Vertex_of<TriangleMesh>::type;

template <class TriangleMesh, class T>
constexpr bool is_mesh_vertex = std::is_convertible<T, Vertex_in<TriangleMesh>>::value;

/* The metric of a mesh with these named parameters, and the form in which an output takes points. */
template <class TriangleMesh, class NamedParameters>
using Metric_by_name = typename Metric_of<TriangleMesh, NamedParameters, is_given<NamedParameters, Metric_parameter>,
                                          is_given<NamedParameters, internal_np::vertex_point_t>>::type;
template <class TriangleMesh, class NamedParameters, class Output, template <class> class Container = Itself>
using Form_by_name = typename Curve_form_of<Curve_forms_of<TriangleMesh, Metric_by_name<TriangleMesh, NamedParameters>>,
                                            Output, Container>::type;

/* The named parameter number_of_iterations, a whole number, which may be given with a sign. */
template <class NamedParameters>
std::size_t number_of_iterations(const NamedParameters& np, std::size_t standard)
{
  const auto number =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::number_of_iterations), standard);
  using Number = std::decay_t<decltype(number)>;
  static_assert(std::is_integral<Number>::value, "number_of_iterations() is a whole number");
  if constexpr(std::is_signed<Number>::value)
    if(number < 0)
      throw Invalid_parameter_error("number_of_iterations is " + std::to_string(number) + ", and not at least 0");
  return static_cast<std::size_t>(number);
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_OPTIONS_H
