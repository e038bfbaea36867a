// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H
#define CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/graph_functions.h>
#include <CGAL/Flip_geodesics/internal/tangents/Ray.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/math/constants/constants.hpp>

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
/// Why a straightest geodesic ends.
enum class Trace_status {
  LENGTH,           ///< it has the length that was asked for
  VERTEX,           ///< it runs into a vertex, exactly, and was to stop there
  BORDER,           ///< it meets the border, on an edge or at a vertex, or would leave the surface at its start there
  CONSTRAINED_EDGE, ///< it meets an edge that it may not cross, or a vertex of one
  CROSSING_LIMIT    ///< it has crossed as many edges as it may
};

/// The name of a reason, as the enumerator is spelled.
inline const char* to_string(Trace_status end)
{
  switch(end) {
  case Trace_status::LENGTH:
    return "LENGTH";
  case Trace_status::VERTEX:
    return "VERTEX";
  case Trace_status::BORDER:
    return "BORDER";
  case Trace_status::CONSTRAINED_EDGE:
    return "CONSTRAINED_EDGE";
  case Trace_status::CROSSING_LIMIT:
    return "CROSSING_LIMIT";
  }
  return "";
}

/// \ingroup PkgFlipGeodesicsTracing
/// What a straightest geodesic does at a vertex that it runs into, exactly.
enum class At_vertices {
  GO_STRAIGHT, ///< it goes on with the same angle on its left as on its right [PS98]
  STOP         ///< it ends there
};

} // namespace Flip_geodesics

namespace parameters {

/// \ingroup PkgFlipGeodesicsParameters
/// What `trace_geodesic()` does at vertices.
/// \param rule by default `At_vertices::GO_STRAIGHT`
inline auto at_vertices(Flip_geodesics::At_vertices rule)
{
  return Named_function_parameters<Flip_geodesics::At_vertices, Flip_geodesics::internal::At_vertices_parameter>(rule);
}

} // namespace parameters

namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTracing
/// Lets straightest geodesics cross all edges.
struct No_edge_is_constrained
{
  /// Returns `false`.
  bool operator()(Input_halfedge_index) const { return false; }
};

/// \ingroup PkgFlipGeodesicsTracing
/// How far a straightest geodesic goes, and which edges it may not cross.
template <class IsConstrained = No_edge_is_constrained>
struct Trace_limits
{
  double length;                                      ///< at most this long, a finite number
  At_vertices at_vertices = At_vertices::GO_STRAIGHT; ///< what it does at vertices
  std::size_t most_crossings = 1000000;               ///< how many edges and vertices it may pass
  IsConstrained is_constrained = IsConstrained();     ///< tells of an `Input_halfedge_index` whether its edge ends it
};

/// \ingroup PkgFlipGeodesicsTracing
/// A straightest geodesic that has been traced: how long it is, and where and how it ends.
struct Trace_report
{
  double length = 0;                          ///< its length, at most that asked for
  Trace_status status = Trace_status::LENGTH; ///< why it ends
  std::size_t edges = 0;                      ///< how many edges it crosses
  std::size_t vertices = 0;                   ///< how many vertices it passes straight on
  Surface_location location;                  ///< its end
  Input_halfedge_index halfedge;  ///< what its direction at the end is told from, see `Geodesic_tracer::trace()`
  double angle = 0;               ///< from there on to its direction, counterclockwise, in radians
  Decision_statistics statistics; ///< how decisions were taken that doubles left open
};

namespace internal {

/* One straightest geodesic, and what is told of it on its way. */
template <class Triangulation, class Limits, class Visitor>
class Trace_walk
{
public:
  Trace_walk(const Triangulation& triangulation, const Exact_input_faces<Triangulation>& exact_faces,
             const Limits& limits, Visitor& visitor)
    : m_triangulation(triangulation)
    , m_exact_faces(exact_faces)
    , m_directions(triangulation)
    , m_limits(limits)
    , m_visitor(visitor)
  {
  }

  Trace_report operator()(Ray_start start)
  {
    m_visitor(surface_point(m_triangulation, start.place));
    if(start.is_outward) {
      end_at_corner(start.place.halfedge, start.angle);
      m_trace.status = Trace_status::BORDER;
      return m_trace;
    }
    while(go_straight(start)) {
    }
    return m_trace;
  }

private:
  using Ray = internal::Ray<Triangulation>;

  // Up to an end, or a vertex at which it goes on from a new start.
  bool go_straight(Ray_start& start)
  {
    Ray ray(m_triangulation, m_exact_faces, start.place, start.direction, m_trace.statistics);
    bool is_at_gate = ray.leave_first_face();
    CGAL_assertion_code(const bool is_inside =) is_at_gate || ray.reach_first_corner();
    CGAL_assertion(is_inside);
    for(;;) {
      while(is_at_gate) {
        if(ends_at_gate(ray))
          return false;
        ++m_trace.edges;
        is_at_gate = ray.pass_gate();
      }
      if(ends_at_corner(ray))
        return false;
      ++m_trace.vertices;
      m_visitor(surface_point(m_triangulation, {ray.corner(), {{1, 0, 0}}}));
      if(!is_flat(ray.corner())) {
        m_trace.length += ray.distance_of_corner();
        start = m_directions.at_vertex(ray.corner(), straight_on(ray));
        return true;
      }
      is_at_gate = ray.pass_corner();
    }
  }

  bool ends_at_gate(const Ray& ray)
  {
    const double length = m_trace.length + ray.distance_of_gate();
    if(length >= m_limits.length)
      return end_inside(ray, true);
    const Input_halfedge_index h = ray.gate();
    const bool is_border = m_triangulation.input().is_border(twin_index(h));
    if(is_border || m_limits.is_constrained(h))
      return end_on_gate(ray, length, is_border ? Trace_status::BORDER : Trace_status::CONSTRAINED_EDGE);
    if(m_trace.edges + m_trace.vertices >= m_limits.most_crossings)
      return end_on_gate(ray, length, Trace_status::CROSSING_LIMIT);
    if(!ray.starts_on_gate())
      m_visitor(surface_point_on_edge(m_triangulation, h, ray.place_on_gate()));
    return false;
  }

  bool end_inside(const Ray& ray, bool is_at_gate)
  {
    m_trace.location = ray.location_at(m_limits.length - m_trace.length, is_at_gate);
    return finish(ray, m_limits.length, Trace_status::LENGTH);
  }

  bool end_on_gate(const Ray& ray, double length, Trace_status end)
  {
    const double place = (std::min)((std::max)(ray.place_on_gate(), least_weight), largest_below_one);
    m_trace.location = {ray.gate(), {{1 - place, place, 0}}};
    return finish(ray, length, end);
  }

  bool finish(const Ray& ray, double length, Trace_status end)
  {
    m_visitor(surface_point(m_triangulation, m_trace.location));
    m_trace.length = length;
    m_trace.status = end;
    m_trace.halfedge = ray.halfedge();
    m_trace.angle = ray.angle();
    return true;
  }

  bool ends_at_corner(const Ray& ray)
  {
    const double length = m_trace.length + ray.distance_of_corner();
    if(length > m_limits.length)
      return end_inside(ray, false);
    const Input_halfedge_index h = ray.corner();
    const bool is_border = !std::isfinite(m_directions.total_angle(h)), is_long = length == m_limits.length,
               is_last = m_trace.edges + m_trace.vertices >= m_limits.most_crossings;
    if(!is_border && !is_long && !has_constrained_edge(h) && !is_last && m_limits.at_vertices != At_vertices::STOP)
      return false;
    m_trace.length = length;
    end_at_corner(h, straight_on(ray));
    m_trace.status = is_border                 ? Trace_status::BORDER
                     : is_long                 ? Trace_status::LENGTH
                     : has_constrained_edge(h) ? Trace_status::CONSTRAINED_EDGE
                                               : (is_last ? Trace_status::CROSSING_LIMIT : Trace_status::VERTEX);
    return true;
  }

  // With the same angle on both sides, from corner().
  double straight_on(const Ray& ray) const
  {
    const double total = m_directions.total_angle(ray.corner());
    return ray.angle_at_corner() + (std::isfinite(total) ? total / 2 : boost::math::constants::pi<double>());
  }

  // Are the angles about the tail of h exactly 2 pi, of faces with areas? Then a ray goes on as in a plane.
  bool is_flat(Input_halfedge_index first)
  {
    if(!(std::abs(m_directions.total_angle(first) - boost::math::constants::two_pi<double>()) < near_full_turn))
      return false;
    Unfolding_chain turn;
    Input_halfedge_index h = first;
    do {
      const Input_halfedge_index back = m_triangulation.input().previous(h);
      const Exact_face& face = m_exact_faces(back); // its corner at the head of that
      if(face.doubled_area_squared == 0)
        return false;
      turn.steps.push_back({Unfolding_step::Kind::CORNER, &face});
      h = twin_index(back);
    } while(h != first);
    return Exact_sign(m_trace.statistics, sign_work_limit(m_triangulation))({turn}) == ZERO;
  }

  void end_at_corner(Input_halfedge_index h, double angle)
  {
    m_trace.location = {h, {{1, 0, 0}}};
    m_trace.halfedge = h;
    m_trace.angle = angle;
    m_visitor(surface_point(m_triangulation, m_trace.location));
  }

  bool has_constrained_edge(Input_halfedge_index first) const
  {
    Input_halfedge_index h = first;
    do {
      if(m_limits.is_constrained(h))
        return true;
      h = m_triangulation.input().next(twin_index(h));
    } while(h != first);
    return false;
  }

  const Triangulation& m_triangulation;
  const Exact_input_faces<Triangulation>& m_exact_faces;
  Direction_finder<Triangulation> m_directions;
  const Limits& m_limits;
  Visitor& m_visitor;
  Trace_report m_trace;
};

struct No_visitor_of_points
{
  void operator()(const Surface_point&) const {}
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTracing
 *
 * Traces straightest geodesics on the input of a triangulation [PS98]: straight over faces and edges, and at a vertex
 * with the same angle on both sides. It is the exponential map of the surface. `trace_geodesic()` does it in one call.
 *
 * Which edges are crossed, and that a vertex is run into, is decided exactly: by the signs of the real numbers that
 * the place's weights, the direction and the input's coordinates define, taken as the doubles that they round to. A
 * direction that is given as an angle is rounded once, to a vector in the face. Where the angles about a vertex are
 * \f$2\pi\f$, exactly, the geodesic goes on as in a plane, and nothing is rounded: so it is inside of flat parts, and
 * on edges along which these are folded. At other vertices, and those with a face without area, half of all angles is
 * rounded, and the direction on is.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; its flips do not matter
 */
template <class Triangulation>
class Geodesic_tracer
{
public:
  /// The tracer refers to the triangulation, and keeps what it has computed of faces.
  explicit Geodesic_tracer(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_exact_faces(triangulation)
  {
  }

  /*!
   * Traces a geodesic from a location.
   *
   * \param location where it starts
   * \param halfedge what its direction is told from: a side of a face that has the location, or a halfedge that
   *        starts there
   * \param angle from `halfedge` on to the direction, in radians, counterclockwise in the surface; at a vertex over all
   *        faces about it, so that a whole turn is the sum of their angles
   * \param limits a `Trace_limits`
   * \param visitor called with a `Surface_point` for the start, each edge that is crossed, each vertex, and the end
   * \throws Invalid_location_error for a location that is none
   * \throws Invalid_parameter_error if the direction is no finite number, `halfedge` is another, or the length is negative
   *         or not finite
   * \throws Degenerate_face_error for a face with a side of length zero, or a direction told in a face without area
   * \throws Invalid_coordinate_error if a coordinate is no finite number
   * \throws Invalid_mesh_error if a face is no triangle
   *
   * Complexity: linear in the edges that are crossed, where doubles suffice to decide.
   */
  template <class IsConstrained, class Visitor>
  Trace_report trace(const Surface_location& location, Input_halfedge_index halfedge, double angle,
                     const Trace_limits<IsConstrained>& limits, Visitor visitor) const
  {
    return walk(internal::Direction_finder<Triangulation>(m_triangulation).by_angle(location, halfedge, angle), limits,
                visitor);
  }

  /// Traces a geodesic from a location, by an angle, without a visitor.
  template <class IsConstrained>
  Trace_report trace(const Surface_location& location, Input_halfedge_index halfedge, double angle,
                     const Trace_limits<IsConstrained>& limits) const
  {
    return trace(location, halfedge, angle, limits, internal::No_visitor_of_points());
  }

  /*!
   * The same by a direction in the face of `location.halfedge`, in coordinates along two of its sides: `direction[0]`
   * times the vector from the tail of the halfedge to its head, and `direction[1]` times that to the third corner. It is
   * not rounded, unless the location is a vertex and it points out of the face, or one number is 1e100 times the other.
   */
  template <class IsConstrained, class Visitor>
  Trace_report trace(const Surface_location& location, const std::array<double, 2>& direction,
                     const Trace_limits<IsConstrained>& limits, Visitor visitor) const
  {
    return walk(internal::Direction_finder<Triangulation>(m_triangulation).by_direction(location, direction), limits,
                visitor);
  }

  /// Traces a geodesic from a location, by coordinates of its direction, without a visitor.
  template <class IsConstrained>
  Trace_report trace(const Surface_location& location, const std::array<double, 2>& direction,
                     const Trace_limits<IsConstrained>& limits) const
  {
    return trace(location, direction, limits, internal::No_visitor_of_points());
  }

private:
  template <class IsConstrained, class Visitor>
  Trace_report walk(const internal::Ray_start& start, const Trace_limits<IsConstrained>& limits, Visitor& visitor) const
  {
    if(!(limits.length >= 0 && std::isfinite(limits.length)))
      throw Invalid_parameter_error("the length of a geodesic to be traced is negative or no finite number");
    return internal::Trace_walk<Triangulation, Trace_limits<IsConstrained>, Visitor>(m_triangulation, m_exact_faces,
                                                                                     limits, visitor)(start);
  }

  const Triangulation& m_triangulation;
  internal::Exact_input_faces<Triangulation> m_exact_faces;
};

/// \ingroup PkgFlipGeodesicsTracing
/// What `trace_geodesic()` returns.
template <class OutputIterator, class TriangleMesh>
struct Trace_result
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;         ///< of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor; ///< of the mesh

  OutputIterator out;                                         ///< the end of the output
  Trace_report report;                                        ///< what became of the geodesic
  std::pair<face_descriptor, std::array<double, 3>> location; ///< its end, a `Face_location`
  std::pair<halfedge_descriptor, double> direction;           ///< in which it would go on from its end

  double length() const { return report.length; }       ///< the length of the geodesic
  Trace_status status() const { return report.status; } ///< why it ends
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
  Trace_report trace(const Surface_location& source, const std::pair<Halfedge, double>& direction, const Limits& limits,
                     const Visitor& visitor) const
  {
    return Geodesic_tracer<Triangulation>(m_triangulation)
        .trace(source, m_triangulation.input().index(direction.first), direction.second, limits, visitor);
  }

  template <class Direction, class Limits, class Visitor>
  std::enable_if_t<is_vector_in_space<Direction>, Trace_report> trace(const Surface_location& source,
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
                       const NamedParameters& np)
{
  const At_vertices at_vertices =
      parameters::choose_parameter(parameters::get_parameter(np, at_vertices_parameter), At_vertices::GO_STRAIGHT);
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
  if constexpr(std::is_convertible<const Place*, const Curve_place<TriangleMesh>*>::value) {
    return trace_start(triangulation, mesh, place.location);
  } else {
    Surface_location result = located_place(triangulation, mesh, place);
    if constexpr(is_face_location<Place>)
      for(std::size_t i = 0; i < 3; ++i) {
        const double weight = CGAL::to_double(place.second[i]);
        result.weights[i] = weight < least_weight ? 0 : weight;
      }
    return result;
  }
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
 * \param np named parameters: `vertex_point_map` or `metric` as for `geodesic_path()`;
 *        `edge_is_constrained_map`, a model of `ReadablePropertyMap` with the mesh's edges as keys and `bool` as
 *        values: it ends at edges that have `true`, by default none; `number_of_iterations`, how many edges and vertices it
 *        crosses at most, a million by default; `at_vertices`, an `At_vertices`, whether it passes vertices, which it
 *        does by default
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
                                                          const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::edge_is_constrained_t, internal_np::number_of_iterations_t,
                                internal::At_vertices_parameter>(np...);
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Surface = internal::Surface_by_name<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Form = internal::Curve_form<Surface, OutputIterator>;
  constexpr bool is_vector = internal::is_vector_in_space<Direction>;
  static_assert(is_vector || std::is_convertible<Direction, std::pair<Halfedge, double>>::value,
                "a direction is a pair of a halfedge and an angle, or a vector in space");
  static_assert(!is_vector || !internal::is_mesh_vertex<TriangleMesh, Source>,
                "a vector in space is told in a face: give a Face_location at the vertex, or a halfedge and an angle");
  const Surface surface = internal::make_surface(mesh, options);
  const Surface_location place = internal::trace_start(surface, mesh, source);
  std::vector<Surface_point> points;
  const Trace_report trace =
      internal::Given_direction<Surface, TriangleMesh>(surface)
          .trace(place, direction, internal::make_trace_limits(surface, mesh, length, options),
                 [&points](const Surface_point& p) { points.push_back(p); });
  return {internal::write_points<Form>(surface, mesh, points, out),
          trace,
          internal::face_location_of(surface, mesh, trace.location),
          {surface.input().halfedge(trace.halfedge), trace.angle}};
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H
