// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_IMPL_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_IMPL_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/flip_out/compiled.h>
#include <CGAL/Flip_geodesics/internal/flip_out/compiled_instances.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations.h>
#include <CGAL/Flip_geodesics/internal/flip_out/path_computations.h>
#include <CGAL/Flip_geodesics/shorten.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

template <class TriangleMesh>
struct compiled::Definitions
{
};

/* Shortens with the stop predicate and the visitor of the named parameters, if given. */
template <class Network, class NamedParameters>
Shortening_report shorten_by_parameters(Network& network, const NamedParameters& np)
{
  auto visitor = make_visitor(np);
  return shorten(network, stop_predicate_of(np), visitor.get());
}

/* Returns the indices of vertices of the mesh, before edges are contracted. */
template <class Triangulation, class Vertex>
std::vector<Vertex_index> mesh_indices(const Triangulation& triangulation, const std::vector<Vertex>& vertices)
{
  std::vector<Vertex_index> result;
  for(const Vertex& v : vertices)
    result.push_back(triangulation.input().uncontracted().index(v));
  return result;
}

/* Adds a curve through vertices of the mesh. Returns false if all vertices coincide, so that no curve results. */
template <class Network>
bool add_vertex_curve(Network& network, const std::vector<Vertex_index>& vertices, bool is_closed)
{
  const std::vector<Halfedge_index> halfedges = halfedges_on_surface(network.triangulation(), vertices, is_closed);
  if(halfedges.empty())
    return false;
  network.add_curve(halfedges, is_closed);
  return true;
}

/* Adds a curve for each range of vertices, closed if its last vertex is its first. Returns whether each curve
 * exists. */
template <class Network, class Vertex>
std::vector<bool> add_vertex_curves(Network& network, const std::vector<std::vector<Vertex>>& curves)
{
  std::vector<bool> result;
  for(const std::vector<Vertex>& curve : curves) {
    std::vector<Vertex_index> vertices = mesh_indices(network.triangulation(), curve);
    const bool is_closed = vertices.size() > 2 && vertices.front() == vertices.back();
    if(is_closed)
      vertices.pop_back();
    result.push_back(add_vertex_curve(network, vertices, is_closed));
  }
  return result;
}

/* Computes the result of `geodesic_path()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_path(const TriangleMesh& mesh, Vertex_in<TriangleMesh> source,
                                   Vertex_in<TriangleMesh> target, const NamedParameters& np)
{
  using Search = Shortest_edge_path<typename Curve_types<TriangleMesh, NamedParameters>::Triangulation>;
  const auto search_over = [](const auto& triangulation) { return Search(triangulation, Search_method::LOOK_BACK); };
  return compute_on_surface(
      Mesh_surfaces(mesh, np),
      Path_computation<Form, TriangleMesh, NamedParameters, decltype(stop_predicate_of(np)), decltype(search_over)>{
          mesh, source, target, np, stop_predicate_of(np), search_over});
}

/* Computes the result of `geodesic_loop()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_loop(const TriangleMesh& mesh, const Vertices_of<TriangleMesh>& vertices,
                                   const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](typename Types::Triangulation& triangulation) {
    typename Types::Network network(triangulation);
    std::vector<Vertex_index> loop = mesh_indices(triangulation, vertices);
    if(loop.size() > 1 && loop.front() == loop.back())
      loop.pop_back();
    Computed_output<Form> result;
    if(add_vertex_curve(network, loop, true)) {
      order_overlapping_curves(network);
      result.report = shorten_by_parameters(network, np);
      result.values = curve_forms<Form>(network, mesh, Curve_index(0));
    } else {
      result.report.curves.push_back(report_of_point(triangulation));
    }
    note_contraction(triangulation, result.report);
    return result;
  });
}

/* Computes the result of `geodesic_network()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<std::vector<Form>> compute_network(const TriangleMesh& mesh,
                                                   const std::vector<Vertices_of<TriangleMesh>>& curves,
                                                   const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](typename Types::Triangulation& triangulation) {
    typename Types::Network network(triangulation);
    const std::vector<bool> has_length = add_vertex_curves(network, curves);
    order_overlapping_curves(network);
    Computed_output<std::vector<Form>> result;
    result.report = shorten_by_parameters(network, np);
    auto& reports = result.report.curves;
    for(std::size_t i = 0, c = 0; i < has_length.size(); ++i) {
      result.values.emplace_back();
      if(has_length[i])
        result.values.back() = curve_forms<Form>(network, mesh, Curve_index(static_cast<Index>(c++)));
      else
        reports.insert(reports.begin() + static_cast<std::ptrdiff_t>(i), report_of_point(triangulation));
    }
    note_contraction(triangulation, result.report);
    return result;
  });
}

} // namespace internal

#ifdef CGAL_FLIP_GEODESICS_COMPILED
namespace internal {

#define CGAL_FLIP_GEODESICS_INSTANCES(Mesh, Form)                                                                      \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<Form> compute_path(                                              \
      const Mesh&, Vertex_in<Mesh>, Vertex_in<Mesh>, const parameters::Default_named_parameters&);                     \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<Form> compute_loop(const Mesh&, const Vertices_of<Mesh>&,        \
                                                                         const parameters::Default_named_parameters&); \
  CGAL_FLIP_GEODESICS_CURVES_INSTANCE Computed_output<std::vector<Form>> compute_network(                              \
      const Mesh&, const std::vector<Vertices_of<Mesh>>&, const parameters::Default_named_parameters&);
CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(CGAL_FLIP_GEODESICS_INSTANCES)
#undef CGAL_FLIP_GEODESICS_INSTANCES

} // namespace internal
#endif

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_COMPUTATIONS_IMPL_H
