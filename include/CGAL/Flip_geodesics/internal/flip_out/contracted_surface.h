// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CONTRACTED_SURFACE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CONTRACTED_SURFACE_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Intrinsic_triangulation.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/Zero_edge_contractor.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Flip_geodesics::internal {

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

/* Returns the traits given as a named parameter, or default ones, also if a kernel is given. */
template <class Traits, class NamedParameters>
Traits make_traits(const NamedParameters& np)
{
  const auto given = parameters::choose_parameter(parameters::get_parameter(np, internal_np::geom_traits), Traits());
  if constexpr(std::is_same<std::remove_const_t<decltype(given)>, Traits>::value)
    return given;
  else
    return Traits();
}

template <class TriangleMesh, class NamedParameters>
auto make_triangulation(const TriangleMesh& mesh, const NamedParameters& np)
{
  using Types = Curve_types<TriangleMesh, NamedParameters>;
  return typename Types::Triangulation(mesh, make_metric(mesh, np), make_traits<typename Types::Traits>(np));
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
  Triangulation& get(std::optional<Triangulation>& surface, Zero_length_edges zero_length_edges) const
  {
    if(!surface)
      surface.emplace(m_mesh, make_metric(m_mesh, m_np), make_traits<typename Triangulation::Traits>(m_np),
                      zero_length_edges);
    return *surface;
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  std::optional<Triangulation> m_as_is, m_contracted;
};

/* Returns the error for a pair of end points that become disconnected when degenerate edges are contracted, made from
 * the error thrown before the contraction. */
inline Degenerate_face_error contracted_in_vain(const Degenerate_face_error& error)
{
  if(error.remedy() != Degeneracy_remedy::CONTRACT)
    return error;
  return {
      error.problem() +
          "; after the contraction of such edges and of degenerate faces, no surface connects the ends of the curve",
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

[[noreturn]] inline void throw_no_surface_left(Vertex_index v)
{
  throw_naming<Degenerate_face_error>("no surface remains at vertex ", v,
                                      " after the contraction of degenerate edges and folded faces");
}

/* Returns a halfedge of the mesh from one vertex to another, the first clockwise, or null_index. */
template <class Input_mesh>
Input_halfedge_index uncontracted_halfedge_between(const Input_mesh& contracted, Vertex_index v, Vertex_index w)
{
  const Input_mesh& input = contracted.uncontracted();
  const Input_halfedge_index start = input.outgoing(v);
  Input_halfedge_index h = start;
  do {
    if(h == null_index || input.tail(twin_index(h)) == w)
      return h;
    h = input.next(twin_index(h)); // along the border, too
  } while(h != start);
  return null_index;
}

/*
 * Adds the halfedge that corresponds to a halfedge of the mesh, if any, to a chain. Returns whether the chain is
 * connected.
 */
template <class Input_mesh>
bool add_contracted_halfedge(const Input_mesh& contracted, Input_halfedge_index h, std::vector<Halfedge_index>& chain)
{
  const Input_halfedge_index left = contracted.contracted_halfedge(h);
  if(left == Contraction::is_point)
    return true;
  if(left == Contraction::is_fold)
    return add_contracted_halfedge(contracted, contracted.fold(h).first, chain) &&
           add_contracted_halfedge(contracted, contracted.fold(h).second, chain);
  if(left == Contraction::is_hair ||
     (!chain.empty() && contracted.tail(left) != contracted.tail(twin_index(as_input(chain.back())))))
    return false;
  chain.push_back(as_intrinsic(left));
  return true;
}

/* Returns the halfedges that remain of a curve of edges. */
template <class Input_mesh>
std::vector<Halfedge_index> contracted_halfedges_through(const Input_mesh& contracted,
                                                         std::vector<Vertex_index> vertices, bool is_closed)
{
  if(is_closed)
    vertices.push_back(vertices.front());
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    if(vertices[i] == vertices[i + 1])
      continue;
    const Input_halfedge_index h = uncontracted_halfedge_between(contracted, vertices[i], vertices[i + 1]);
    if(h == null_index)
      throw_naming<Invalid_curve_error>("a curve is not connected: no edge connects vertex ", vertices[i],
                                        " and vertex ", vertices[i + 1]);
    if(!add_contracted_halfedge(contracted, h, result))
      throw_no_surface_left(vertices[i]);
  }
  if(is_closed && !result.empty() &&
     contracted.tail(as_input(result.front())) != contracted.tail(twin_index(as_input(result.back()))))
    throw_no_surface_left(vertices.front());
  return result;
}

/* Returns the location of a vertex of the mesh. */
template <class Input_mesh>
Surface_location contracted_vertex_location(const Input_mesh& contracted, Vertex_index v)
{
  const Input_halfedge_index h = contracted.outgoing(contracted.contracted_vertex(v));
  if(h == null_index)
    throw_no_surface_left(v);
  return {h, {{1, 0, 0}}};
}

/* Returns the location of a point on an edge, given the weights of the two ends of a halfedge of the mesh. */
template <class Input_mesh>
Surface_location contracted_edge_location(const Input_mesh& contracted, Input_halfedge_index h, double at_tail,
                                          double at_head)
{
  const Input_halfedge_index left = contracted.contracted_halfedge(h);
  const Vertex_index v = contracted.uncontracted().tail(h);
  if(left == Contraction::is_point)
    return contracted_vertex_location(contracted, v);
  if(left == Contraction::is_hair)
    throw_no_surface_left(v);
  if(left != Contraction::is_fold)
    return {left, {{at_tail, at_head, 0}}};
  const Contraction::Fold& fold = contracted.fold(h);
  const double way = at_head / (at_tail + at_head); // from the tail
  if(way < fold.share)
    return contracted_edge_location(contracted, fold.first, fold.share - way, way);
  return contracted_edge_location(contracted, fold.second, 1 - way, way - fold.share);
}

/* Returns whether the face of h is one of two folded faces with h between them. */
template <class Input_mesh>
bool is_folded_along(const Input_mesh& contracted, Input_halfedge_index h)
{
  return contracted.contracted_halfedge(h) == Contraction::is_fold &&
         contracted.fold(h).first == twin_index(contracted.uncontracted().previous(h));
}

/*
 * Returns whether a shortest path on a mesh need not be one on the contracted surface: a path along edges that have
 * vanished except for their ends, because only degenerate faces connected these, or through a point at which umbrellas
 * met that have separate vertices there now. Linear in the mesh if it is contracted.
 */
template <class Input_mesh>
bool has_lost_paths(const Input_mesh& contracted)
{
  if(!contracted.is_contracted())
    return false;
  const auto all = descriptors<Input_halfedge_index>(contracted.uncontracted().number_of_halfedges());
  return contracted.has_split_point() || std::any_of(all.begin(), all.end(), [&](Input_halfedge_index h) {
           return contracted.contracted_halfedge(h) == Contraction::is_hair;
         });
}

/*
 * Returns the report of a curve that is a point on the surface of a triangulation. This is proven unless coordinates or
 * lengths of the mesh had to be rounded.
 */
template <class Triangulation>
Curve_report report_of_point(const Triangulation& triangulation)
{
  Curve_report report;
  report.status = Shortening_status::CONTRACTED;
  if(!is_input_rounded(triangulation))
    report.verdict = Verdict::PROVEN;
  return report;
}

/*
 * Returns the vertex of a triangulation that corresponds to vertex `v` of its mesh: `v` itself unless degenerate edges
 * were contracted, see `Zero_length_edges`. Constant time.
 *
 * \param v an index in `vertices(mesh)`
 * \throws Vertex_out_of_range_error
 */
template <class Triangulation>
Vertex_index vertex_on_surface(const Triangulation& triangulation, Vertex_index v)
{
  check_vertex(v, triangulation.input().number_of_vertices());
  return triangulation.input().contracted_vertex(v);
}

/*
 * Returns the chain of halfedges of a triangulation along edges of its mesh. If degenerate edges were contracted, it
 * may run back and forth along an edge, and it is empty for a curve whose vertices all coincide. Otherwise, it is that
 * of `halfedges_through()`.
 *
 * \param vertices a range of indices in `vertices(mesh)`, as for `halfedges_through()`
 * \throws Degenerate_face_error if the curve leaves the remaining surface along degenerate faces
 * \throws as `halfedges_through()`
 *
 * Complexity: linear in the degrees of the vertices.
 */
template <class Triangulation, class VertexRange>
std::vector<Halfedge_index> halfedges_on_surface(const Triangulation& triangulation, const VertexRange& vertices,
                                                 bool is_closed)
{
  if(!triangulation.input().is_contracted())
    return halfedges_through(triangulation, vertices, parameters::is_closed(is_closed));
  return contracted_halfedges_through(triangulation.input(), {vertices.begin(), vertices.end()}, is_closed);
}

/*
 * Returns the location of a point of the mesh on the surface of a triangulation: the same location unless degenerate
 * edges were contracted. Constant time, except for the degree of a vertex.
 *
 * \param location with a halfedge of the mesh
 * \throws Invalid_location_error
 * \throws Degenerate_face_error if the point lies on degenerate faces where no surface remains
 */
template <class Triangulation>
Surface_location location_on_surface(const Triangulation& triangulation, const Surface_location& location)
{
  const auto& contracted = triangulation.input();
  if(!contracted.is_contracted())
    return location;
  const auto& input = contracted.uncontracted();
  Surface_location at = canonical_location(input, location);
  if(kind(at) == Location_kind::VERTEX)
    return contracted_vertex_location(contracted, input.tail(at.halfedge));
  if(kind(at) == Location_kind::EDGE)
    return contracted_edge_location(contracted, at.halfedge, at.weights[0], at.weights[1]);
  for(int i = 0; i < 3; ++i, at = rotated(input, at))
    if(contracted.contracted_halfedge(at.halfedge) == Contraction::is_point) // the tail and the head coincide
      return contracted_edge_location(contracted, input.next(at.halfedge), at.weights[0] + at.weights[1],
                                      at.weights[2]);
  for(int i = 0; i < 3; ++i, at = rotated(input, at))
    if(is_folded_along(contracted, at.halfedge)) {
      const double share = contracted.fold(at.halfedge).share;
      return contracted_edge_location(contracted, at.halfedge, at.weights[0] + (1 - share) * at.weights[2],
                                      at.weights[1] + share * at.weights[2]);
    }
  at.halfedge = contracted.contracted_halfedge(at.halfedge);
  return at;
}

/*
 * Returns the locations of points of the mesh on the surface of a triangulation, as `location_on_surface()` does. On a
 * contracted surface, each point has a unique location.
 */
template <class Triangulation>
std::vector<Surface_location> points_on_surface(const Triangulation& triangulation,
                                                const std::vector<Surface_location>& locations)
{
  if(!triangulation.input().is_contracted())
    return locations;
  std::vector<Surface_location> result;
  for(const Surface_location& location : locations)
    result.push_back(canonical_location(triangulation.input(), location_on_surface(triangulation, location)));
  return result;
}

/*
 * Returns whether curves could be shortened further on the surface that `Zero_length_edges::CONTRACT` produces:
 * degenerate faces block a curve, and degenerate edges, or vertices that such faces fold onto one point, can be
 * contracted. Linear in the mesh if faces block a curve, otherwise in the curves.
 *
 * \param report the report of `shorten()` on curves in this triangulation
 */
template <class Triangulation>
bool are_curves_folded(const Triangulation& triangulation, const Shortening_report& report)
{
  const auto is_hindered = [](const Curve_report& curve) {
    return curve.status == Shortening_status::DEGENERATE_FACES || curve.status == Shortening_status::PRECISION_LIMIT;
  };
  if(triangulation.input().is_contracted() || std::none_of(report.curves.begin(), report.curves.end(), is_hindered))
    return false;
  return contracted(triangulation.input(),
                    Contracted_metric<typename Triangulation::Metric>{triangulation.metric(), triangulation.input()})
      .is_contracted();
}

/*
 * Returns whether a surface that was not contracted has degenerate edges, or vertices that degenerate faces fold onto
 * one point, unless it would fall apart there. Linear in the mesh.
 */
template <class Triangulation>
bool is_contraction_of_use(const Triangulation& triangulation)
{
  const auto& input = triangulation.input();
  if(input.is_contracted())
    return false;
  try {
    const auto left =
        contracted(input, Contracted_metric<typename Triangulation::Metric>{triangulation.metric(), input});
    return left.is_contracted() && !left.has_split_point();
  } catch(const Degenerate_face_error&) {
    return false;
  }
}

/* Records for all curves whether degenerate edges were contracted for them, or throws if they must be. */
template <class Triangulation>
void note_contraction(const Triangulation& triangulation, Shortening_report& report)
{
  if(are_curves_folded(triangulation, report))
    throw Degenerate_face_error(
        "a curve is blocked by vertices that coincide because of degenerate faces; repair the mesh", {});
  for(Curve_report& curve : report.curves)
    curve.are_zero_edges_contracted = triangulation.input().is_contracted();
}

} // namespace CGAL::Flip_geodesics::internal

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CONTRACTED_SURFACE_H
