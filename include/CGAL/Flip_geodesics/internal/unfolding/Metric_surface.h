// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_METRIC_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_METRIC_SURFACE_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/metrics.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL::Flip_geodesics {
namespace internal {

/*
 * A mesh with a metric and without any edges but its own: the model that rays, distances and tangent vectors require of
 * their template parameter for the triangulation. It has neither flips nor crossings, so calls of the modules
 * above do not compile.
 */
template <class TriangleMesh, class Metric_>
class Metric_surface
{
public:
  using Triangle_mesh = TriangleMesh;
  using Input_mesh = Numbered_mesh<TriangleMesh>;
  using Metric = Metric_;

  /* The only arithmetic parameter of a triangulation's traits: the work limit for signs. */
  struct Traits
  {
    using Has_drift = Tag_false;
    std::uint64_t sign_work_limit() const { return work_limit; }

    std::uint64_t work_limit;
  };

  /* The mesh must outlive the surface. \throws Input_mismatch_error if the metric detects that it was made for another
   * mesh */
  Metric_surface(const TriangleMesh& mesh, const Metric& metric, std::uint64_t sign_work_limit = default_sign_work)
    : m_input(mesh)
    , m_metric(metric)
    , m_traits{sign_work_limit}
  {
    check_input(m_metric, m_input);
  }

  const Input_mesh& input() const { return m_input; }
  const Metric& metric() const { return m_metric; }
  const Traits& traits() const { return m_traits; }
  Index number_of_vertices() const { return m_input.number_of_vertices(); }
  Index number_of_halfedges() const { return m_input.number_of_halfedges(); }
  Vertex_index index(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v) const { return m_input.index(v); }

  static bool is_inserted(Vertex_index) { return false; }

  /* \pre `v` is not isolated */
  Surface_location location(Vertex_index v) const
  {
    return canonical_location(m_input, {m_input.outgoing(v), {{1, 0, 0}}});
  }

private:
  Input_mesh m_input;
  Metric m_metric;
  Traits m_traits;
};

/* Returns the metric given by name, or that of the given points or of the mesh's own points. */
template <class TriangleMesh, class NamedParameters>
auto make_metric(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Metric_parameter>) {
    return parameters::get_parameter(np, metric_parameter);
  } else if constexpr(is_given<NamedParameters, internal_np::vertex_point_t>) {
    using Points = Given<NamedParameters, internal_np::vertex_point_t>;
    return Embedded_metric<TriangleMesh, Points>(parameters::get_parameter(np, internal_np::vertex_point));
  } else {
    static_assert(graph_has_property<TriangleMesh, boost::vertex_point_t>::value,
                  "the mesh has no vertex point property: pass vertex_point_map() or metric()");
    using Points = typename property_map_selector<TriangleMesh, boost::vertex_point_t>::const_type;
    return Embedded_metric<TriangleMesh, Points>(get_const_property_map(CGAL::vertex_point, mesh));
  }
}

template <class TriangleMesh, class NamedParameters>
using Metric_by_name =
    decltype(make_metric(std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>()));

struct No_graph
{
  struct vertex_descriptor
  {
  };
};

/* The vertex type of a function's first argument. */
template <class TriangleMesh>
struct Vertex_of
{
  static_assert(has_faces<TriangleMesh>, "the first argument must be a mesh; the order of the arguments is mesh, ends "
                                         "or curves, output, named parameters");
  using Graph = std::conditional_t<has_faces<TriangleMesh>, boost::graph_traits<TriangleMesh>, No_graph>;
  using type = typename Graph::vertex_descriptor;
};

} // namespace internal

// Documented in geodesic_path.h.
template <class TriangleMesh>
using Mesh_vertex = typename internal::Vertex_of<TriangleMesh>::type;

namespace internal {

template <class TriangleMesh, class T>
constexpr bool is_mesh_vertex = std::is_convertible<T, Mesh_vertex<TriangleMesh>>::value;

/* The value type of the output's points. */
template <class TriangleMesh, class NamedParameters, class Output, template <class> class Container = Itself>
using Form_by_name = typename Curve_form_of<Curve_forms_of<TriangleMesh, Metric_by_name<TriangleMesh, NamedParameters>>,
                                            Output, Container>::type;

/* The surface specified by named parameters. */
template <class TriangleMesh, class NamedParameters>
using Surface_by_name = Metric_surface<TriangleMesh, Metric_by_name<TriangleMesh, NamedParameters>>;

/* Takes the place of a kernel here and has the default limit. */
struct No_sign_work_limit
{
  using Has_drift = Tag_true;
};

template <class TriangleMesh, class NamedParameters>
Surface_by_name<TriangleMesh, NamedParameters> make_surface(const TriangleMesh& mesh, const NamedParameters& np)
{
  std::uint64_t work_limit = default_sign_work;
  if constexpr(is_given<NamedParameters, internal_np::geom_traits_t>) {
    const auto traits = parameters::get_parameter(np, internal_np::geom_traits);
    using Given = std::decay_t<decltype(traits)>;
    using Traits =
        typename Traits_given<Given, Metric_by_name<TriangleMesh, NamedParameters>, No_sign_work_limit>::type;
    if constexpr(!Traits::Has_drift::value)
      work_limit = traits.sign_work_limit();
  }
  return {mesh, make_metric(mesh, np), work_limit};
}

} // namespace internal
} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_METRIC_SURFACE_H
