// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_TYPES_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_TYPES_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/Zero_edge_contractor.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <optional>

// The types to which the named parameters of the free functions evaluate.

namespace CGAL {
namespace Flip_geodesics {

template <class Triangulation>
class Edge_path_network;

namespace internal {

/* The types that result from the named parameters. */
template <class TriangleMesh, class NamedParameters>
struct Curve_types
{
  using Vertex = typename Vertex_of<TriangleMesh>::type;
  using Metric = Metric_by_name<TriangleMesh, NamedParameters>;
  using Traits =
      typename Traits_given<typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                                         Default_traits<Metric>>::type,
                            Metric, Default_traits<Metric>>::type;
  using Triangulation = Intrinsic_triangulation<TriangleMesh, Traits, Metric>;
  using Network = Edge_path_network<Triangulation>;
};

template <class TriangleMesh, class NamedParameters>
auto make_triangulation(const TriangleMesh& mesh, const NamedParameters& np,
                        Zero_length_edges zero_length_edges = Zero_length_edges::REFUSE)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  const auto given =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits), typename Types::Traits());
  if constexpr(std::is_same<std::remove_const_t<decltype(given)>, typename Types::Traits>::value)
    return typename Types::Triangulation(mesh, make_metric(mesh, np), given, zero_length_edges);
  else // a kernel
    return typename Types::Triangulation(mesh, make_metric(mesh, np), typename Types::Traits(), zero_length_edges);
}

/* Triangulations of a mesh as given and of the surface in which its degenerate edges are contracted. Each is
 * constructed on first use. */
template <class TriangleMesh, class NamedParameters>
class Mesh_surfaces
{
public:
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;

  Mesh_surfaces(const TriangleMesh& mesh, const NamedParameters& np)
    : m_mesh(mesh)
    , m_np(np)
  {
  }

  Triangulation& as_is() { return get(m_as_is, Zero_length_edges::REFUSE); }
  Triangulation& contracted() { return get(m_contracted, Zero_length_edges::CONTRACT); }

private:
  // Constructs a triangulation in place.
  struct Surface
  {
    Surface(const TriangleMesh& mesh, const NamedParameters& np, Zero_length_edges zero_length_edges)
      : triangulation(make_triangulation(mesh, np, zero_length_edges))
    {
    }

    Triangulation triangulation;
  };

  Triangulation& get(std::optional<Surface>& surface, Zero_length_edges zero_length_edges) const
  {
    if(!surface)
      surface.emplace(m_mesh, m_np, zero_length_edges);
    return surface->triangulation;
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  std::optional<Surface> m_as_is, m_contracted;
};

/* Returns the error for a pair of end points that become disconnected when degenerate edges are contracted, made from
 * the error thrown before the contraction. */
inline Degenerate_face_error contracted_in_vain(const Degenerate_face_error& error)
{
  if(error.remedy() != Degeneracy_remedy::CONTRACT)
    return error;
  return {error.problem() + "; once such edges are contracted, no surface joins the ends of the curve, since "
                            "degenerate faces are removed",
          error.elements(), Degeneracy_remedy::MOLLIFY};
}

/*
 * Decides for a computation whether degenerate edges must be contracted; all functions that take a mesh decide here.
 * Returns `compute(triangulation)` for the mesh as given or, if that encounters a degenerate edge, for the contracted
 * surface.
 *
 * Comparing the ends of all edges beforehand would take linear time, whereas constructing the triangulation of a
 * `Surface_mesh` takes constant time and computing a path takes time for the vertices visited by its search.
 *
 * \throws Degenerate_face_error the first one if the contraction does not help
 */
template <class Surfaces, class Compute>
auto compute_on_surface(Surfaces&& surfaces, const Compute& compute)
{
  try {
    return compute(surfaces.as_is());
  } catch(const Degenerate_face_error& error) {
    auto& contracted = surfaces.contracted();
    if(!contracted.input().is_contracted())
      throw;
    try {
      return compute(contracted);
    } catch(const Disconnected_endpoints_error&) { // joined by degenerate faces or a single point only
      throw contracted_in_vain(error);
    }
  }
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_TYPES_H
