// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_H

/*
 * Linking to CGAL::Flip_geodesics_compiled defines CGAL_FLIP_GEODESICS_COMPILED. Headers then declare the computations
 * behind their free functions without defining them, which saves more than half of the compilation time. The library
 * contains the most common instances; a source that needs others defines CGAL_FLIP_GEODESICS_HEADER_ONLY.
 */
#if defined(CGAL_FLIP_GEODESICS_COMPILED) && !defined(CGAL_FLIP_GEODESICS_HEADER_ONLY)
#define CGAL_FLIP_GEODESICS_DECLARATIONS_ONLY
#endif

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

class Epick;

namespace Flip_geodesics::internal {
namespace compiled {

template <class TriangleMesh>
constexpr bool is_known_mesh = false;
template <class K>
constexpr bool is_known_mesh<Surface_mesh<Point_3<K>>> =
    std::is_same<K, Simple_cartesian<double>>::value || std::is_same<K, Epick>::value;

/* Complete if any included header has the definitions. */
template <class TriangleMesh>
struct Definitions;

template <class TriangleMesh, class = void>
constexpr bool are_defined = false;
template <class TriangleMesh>
constexpr bool are_defined<TriangleMesh, std::void_t<decltype(sizeof(Definitions<TriangleMesh>))>> = true;

/* Reports a missing definition or instance when compiling, not only when linking. */
template <class TriangleMesh, class NamedParameters>
constexpr void check_instance()
{
  constexpr bool is_in_library =
      is_known_mesh<TriangleMesh> && std::is_same<NamedParameters, parameters::Default_named_parameters>::value;
  static_assert(is_in_library || are_defined<TriangleMesh>,
                "the compiled library has no instance for this mesh, or none with named parameters: define "
                "CGAL_FLIP_GEODESICS_HEADER_ONLY before the first header of the package is included");
}

} // namespace compiled

/* The values that a computation produces for an output iterator, and its report. */
template <class Value, class Report = Shortening_report>
struct Computed_output
{
  std::vector<Value> values;
  Report report;
};

/* Writes the final values of a computation: an attempt that was repeated on the contracted surface has not written
 * anything. Returns a `Result`, which consists of the end of the output and the report. */
template <class Result, class Computed, class OutputIterator>
Result write_computed(Computed&& computed, OutputIterator out)
{
  if constexpr(!takes<OutputIterator, typename decltype(computed.values)::value_type>)
    return Result{out, std::move(computed.report)}; // no further message follows that of `Curve_form_of`
  else
    return Result{std::move(computed.values.begin(), computed.values.end(), out), std::move(computed.report)};
}

/* A copy of a range of vertices of the mesh. */
template <class TriangleMesh>
using Vertices_of = std::vector<Mesh_vertex<TriangleMesh>>;

template <class TriangleMesh, class VertexRange>
Vertices_of<TriangleMesh> vertices_of_mesh(const TriangleMesh&, const VertexRange& vertices)
{
  static_assert(is_range_of<VertexRange, Mesh_vertex<TriangleMesh>>,
                "the curve must be a range of vertices of the mesh");
  Vertices_of<TriangleMesh> result;
  for(const auto& v : vertices)
    result.push_back(v);
  return result;
}

/*
 * The computations behind the functions of `geodesic_path.h`, which write the output afterwards. They are not inline
 * and depend only on the value type of the output, so the compiled library can contain instances.
 */

/* Computes the result of `geodesic_path()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_path(const TriangleMesh& mesh, Mesh_vertex<TriangleMesh> source,
                                   Mesh_vertex<TriangleMesh> target, const NamedParameters& np);

/* Computes the result of `geodesic_loop()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_loop(const TriangleMesh& mesh, const Vertices_of<TriangleMesh>& vertices,
                                   const NamedParameters& np);

/* Computes the result of `geodesic_network()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<std::vector<Form>> compute_network(const TriangleMesh& mesh,
                                                   const std::vector<Vertices_of<TriangleMesh>>& curves,
                                                   const NamedParameters& np);

} // namespace Flip_geodesics::internal
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_H
