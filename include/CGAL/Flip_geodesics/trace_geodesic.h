// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H
#define CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Geodesic_tracer.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_types.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/surface/input_face_geometry.h>
#include <CGAL/Flip_geodesics/internal/triangulation/located_place.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTracing
/// What `trace_geodesic()` returns.
template <class OutputIterator, class TriangleMesh>
struct Trace_result
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;         ///< of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor; ///< of the mesh

  OutputIterator out;                                         ///< the end of the output
  double length = 0;                                          ///< the length of the geodesic
  Trace_end end = Trace_end::LENGTH;                          ///< why it ends
  std::size_t edges = 0;                                      ///< how many edges it crosses
  std::size_t vertices = 0;                                   ///< how many vertices it passes straight on
  std::pair<face_descriptor, std::array<double, 3>> location; ///< its end, a `Face_location`
  std::pair<halfedge_descriptor, double> direction;           ///< in which it would go on from its end
  Decision_statistics statistics;                             ///< how decisions were taken that doubles left open
};

namespace internal {

template <class T, class = void>
constexpr bool is_vector_in_space = false;
template <class T>
constexpr bool
    is_vector_in_space<T, std::void_t<decltype(std::declval<T>().x(), std::declval<T>().y(), std::declval<T>().z())>> =
        true;

template <class T, class = void>
constexpr bool is_face_location = false;
template <class T>
constexpr bool
    is_face_location<T, std::void_t<decltype(std::declval<T>().first), decltype(std::declval<T>().second[0])>> = true;

/* Starts of rays by what users give: a vector in space, or a halfedge and an angle. */
template <class Triangulation, class TriangleMesh>
class Given_direction
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Vector = std::array<double, 3>;

public:
  explicit Given_direction(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  template <class Limits, class Visitor>
  Trace trace(const Surface_location& source, const std::pair<Halfedge, double>& direction, const Limits& limits,
              const Visitor& visitor) const
  {
    return Geodesic_tracer<Triangulation>(m_triangulation)
        .trace(source, m_triangulation.input().index(direction.first), direction.second, limits, visitor);
  }

  template <class Direction, class Limits, class Visitor>
  std::enable_if_t<is_vector_in_space<Direction>, Trace> trace(const Surface_location& source,
                                                               const Direction& direction, const Limits& limits,
                                                               const Visitor& visitor) const
  {
    static_assert(Has_points<typename Triangulation::Metric>::value,
                  "the metric has no points in space: give the direction as a halfedge and an angle");
    check_location(m_triangulation.input(), source);
    return Geodesic_tracer<Triangulation>(m_triangulation)
        .trace(source,
               in_face(source.halfedge, {{CGAL::to_double(direction.x()), CGAL::to_double(direction.y()),
                                          CGAL::to_double(direction.z())}}),
               limits, visitor);
  }

private:
  // A vector's part in the plane of the face of h, along h and along the side from its tail to the third corner.
  std::array<double, 2> in_face(Input_halfedge_index h, const Vector& v) const
  {
    const auto& input = m_triangulation.input();
    if(input.is_border(h))
      return {0, 0};
    input_face_geometry(m_triangulation, h); // throws for corners that are no points
    const Vector a = side(h), c = side(input.next(input.next(h))), b = {{-c[0], -c[1], -c[2]}};
    const Vector normal = unit_of(cross(unit_of(a), unit_of(b))), direction = unit_of(v);
    if(normal == Vector{{0, 0, 0}})
      throw Degenerate_face_error("a direction is told in the face of halfedge " + std::to_string(h.idx()) +
                                      ", which has no area",
                                  {static_cast<std::size_t>(h.idx())});
    return {dot(cross(direction, b), normal), dot(cross(a, direction), normal)};
  }

  Vector side(Input_halfedge_index h) const
  {
    const auto& input = m_triangulation.input();
    const auto p = m_triangulation.metric().point(input, input.uncontracted_tail(h)),
               q = m_triangulation.metric().point(input, input.uncontracted_head(h));
    return {{CGAL::to_double(q.x()) - CGAL::to_double(p.x()), CGAL::to_double(q.y()) - CGAL::to_double(p.y()),
             CGAL::to_double(q.z()) - CGAL::to_double(p.z())}};
  }

  // Over a power of two, so that the largest coordinate is between 1 and 2: no digit is lost.
  static Vector unit_of(const Vector& v)
  {
    const double size = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if(!(size > 0) || !std::isfinite(size))
      return v;
    const int exponent = std::ilogb(size);
    return {{std::scalbn(v[0], -exponent), std::scalbn(v[1], -exponent), std::scalbn(v[2], -exponent)}};
  }

  static double dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  static Vector cross(const Vector& u, const Vector& v)
  {
    const auto difference = [&](int i, int k) { // of products, accurately [Kahan]
      const double product = u[k] * v[i];
      return std::fma(u[i], v[k], -product) - std::fma(u[k], v[i], -product);
    };
    return {{difference(1, 2), difference(2, 0), difference(0, 1)}};
  }

  const Triangulation& m_triangulation;
};

/* Which edges end a geodesic, by the map of the named parameters. */
template <class Triangulation, class TriangleMesh, class Map>
struct Is_constrained
{
  const Triangulation* triangulation;
  const TriangleMesh* mesh;
  Map map;

  bool operator()(Input_halfedge_index h) const { return get(map, edge(triangulation->input().halfedge(h), *mesh)); }
};

template <class Triangulation, class TriangleMesh, class NamedParameters>
auto make_trace_limits(const Triangulation& triangulation, const TriangleMesh& mesh, double length,
                       At_vertices at_vertices, const NamedParameters& np)
{
  const std::size_t most = number_of_iterations(np, Trace_limits<>().most_crossings);
  if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>) {
    const auto map = parameters::get_parameter(np, internal_np::edge_is_constrained);
    using Map = std::decay_t<decltype(map)>;
    using Test = Is_constrained<Triangulation, TriangleMesh, Map>;
    return Trace_limits<Test>{length, at_vertices, most, Test{&triangulation, &mesh, map}};
  } else {
    return Trace_limits<>{length, at_vertices, most, {}};
  }
}

/* A place on the mesh. A Face_location is not put on an edge or vertex that is near: so can be traced on from each end. */
template <class Triangulation, class TriangleMesh, class Place>
Surface_location trace_start(const Triangulation& triangulation, const TriangleMesh& mesh, const Place& place)
{
  Surface_location result = located_place(triangulation, mesh, place);
  if constexpr(is_face_location<Place>)
    for(std::size_t i = 0; i < 3; ++i) {
      const double weight = CGAL::to_double(place.second[i]);
      result.weights[i] = weight < least_weight ? 0 : weight;
    }
  return result;
}

/* A location in a face as users know it. */
template <class Triangulation, class TriangleMesh>
auto face_location_of(const Triangulation& triangulation, const TriangleMesh& mesh, Surface_location location)
{
  const auto f = graph_face(triangulation.input().halfedge(location.halfedge), mesh);
  const Input_halfedge_index first = triangulation.input().index(graph_halfedge(f, mesh));
  while(location.halfedge != first)
    location = rotated(triangulation.input(), location);
  return std::make_pair(f, location.weights);
}

/* Points of a curve in the form that the output takes, with directions from each to the next. */
template <class Form, class Triangulation, class TriangleMesh, class OutputIterator>
OutputIterator write_points(const Triangulation& triangulation, const TriangleMesh& mesh,
                            const std::vector<Surface_point>& points, OutputIterator out)
{
  std::vector<Form> forms;
  const Form_converter<Triangulation, Form> convert(triangulation, mesh);
  for(const Surface_point& p : points)
    forms.push_back(convert(p));
  if constexpr(std::is_same<Form, typename Curve_forms<Triangulation>::All>::value &&
               Has_points<typename Triangulation::Metric>::value)
    for(std::size_t i = 0; i + 1 < forms.size(); ++i) {
      set_tangent(forms[i], forms[i].point, forms[i + 1].point);
      set_tangent(forms[i + 1], forms[i].point, forms[i + 1].point);
    }
  return std::move(forms.begin(), forms.end(), out);
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTracing
 *
 * Traces a straightest geodesic [PS98] from a place in a direction: the exponential map. It is straight over faces and
 * edges; at a vertex it goes on with the same angle on its left as on its right, or ends there. Which edges it crosses,
 * and that it runs into a vertex, is decided exactly. The direction is taken as it is rounded in its first face, and
 * again after each vertex about which the angles are not exactly \f$2\pi\f$.
 *
 * \param mesh a triangle mesh
 * \param source a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space, as for
 *        `geodesic_path_through()`
 * \param direction either a `std::pair` of a halfedge and an angle from there, in radians, counterclockwise on the
 *        surface: a side of a face that has the source; at a vertex the angle goes over all faces about it. Or a vector
 *        in space, which is projected to the plane of the face of a `Face_location`; it may leave that face at once
 * \param length how long it is to be, at most; its unit is that of the coordinates
 * \param out receives the points of the geodesic in order, as `geodesic_path()` writes them: its start, the edges and
 *        vertices that it crosses, its end
 * \param at_vertices whether it passes vertices
 * \param np named parameters: `vertex_point_map` or `metric` as for `geodesic_path()`;
 *        `edge_is_constrained_map`, a model of `ReadablePropertyMap` with the mesh's edges as keys and `bool` as
 *        values: it ends at edges that have `true`, by default none; `number_of_iterations`, how many edges and vertices it
 *        crosses at most, a million by default
 * \return a `Trace_result`. From its `location` in its `direction` it can be traced on
 * \throws Vertex_out_of_range_error, Invalid_location_error for a source that is not on the mesh
 * \throws Invalid_parameter_error for a length or a direction that is not finite, a negative length, a vector without
 *         length in the plane of its face, another halfedge, or a negative number of iterations
 * \throws Degenerate_face_error if it meets a face with a side of length zero, or starts into a face without area
 * \throws Invalid_coordinate_error, Invalid_mesh_error
 *
 * Complexity: linear in the edges that it crosses, where doubles suffice to decide. For many geodesics on one mesh
 * there is `Geodesic_tracer`; meshes other than `Surface_mesh` are indexed, \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class Source, class Direction, class OutputIterator, class... NamedParameters>
Trace_result<OutputIterator, TriangleMesh> trace_geodesic(const TriangleMesh& mesh, const Source& source,
                                                          const Direction& direction, double length, OutputIterator out,
                                                          At_vertices at_vertices, const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::edge_is_constrained_t, internal_np::number_of_iterations_t>(np...);
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Types = internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Triangulation = typename Types::Triangulation;
  using Form = internal::Curve_form<Triangulation, OutputIterator>;
  constexpr bool is_vector = internal::is_vector_in_space<Direction>;
  static_assert(is_vector || std::is_convertible<Direction, std::pair<Halfedge, double>>::value,
                "a direction is a pair of a halfedge and an angle, or a vector in space");
  static_assert(!is_vector || !internal::is_mesh_vertex<TriangleMesh, Source>,
                "a vector in space is told in a face: give a Face_location at the vertex, or a halfedge and an angle");
  const Triangulation triangulation = internal::make_triangulation(mesh, options);
  const Surface_location place = internal::trace_start(triangulation, mesh, source);
  std::vector<Surface_point> points;
  const Trace trace =
      internal::Given_direction<Triangulation, TriangleMesh>(triangulation)
          .trace(place, direction, internal::make_trace_limits(triangulation, mesh, length, at_vertices, options),
                 [&points](const Surface_point& p) { points.push_back(p); });
  return {internal::write_points<Form>(triangulation, mesh, points, out),
          trace.length,
          trace.end,
          trace.edges,
          trace.vertices,
          internal::face_location_of(triangulation, mesh, trace.location),
          {triangulation.input().halfedge(trace.halfedge), trace.angle},
          trace.statistics};
}

/// \ingroup PkgFlipGeodesicsTracing
/// The same, straight on at vertices.
template <class TriangleMesh, class Source, class Direction, class OutputIterator, class... NamedParameters>
Trace_result<OutputIterator, TriangleMesh> trace_geodesic(const TriangleMesh& mesh, const Source& source,
                                                          const Direction& direction, double length, OutputIterator out,
                                                          const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::edge_is_constrained_t, internal_np::number_of_iterations_t>(np...);
  return Flip_geodesics::trace_geodesic(mesh, source, direction, length, out, At_vertices::GO_STRAIGHT, options);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H
