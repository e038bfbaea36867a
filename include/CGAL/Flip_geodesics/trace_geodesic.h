// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H
#define CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Integer.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/tangents/Ray.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Metric_surface.h>
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
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTracing
/// States why a straightest geodesic ends.
enum class Trace_status {
  LENGTH,           ///< the geodesic has the requested length
  VERTEX,           ///< the geodesic reaches a vertex exactly and is required to stop there
  BORDER,           ///< the geodesic meets the border, or would leave the surface at its start
  CONSTRAINED_EDGE, ///< the geodesic meets an edge that must not be crossed, or a vertex of such an edge
  CROSSING_LIMIT    ///< the geodesic has passed through the maximal number of edges and vertices
};

/// \ingroup PkgFlipGeodesicsTracing
/// Returns the name of a status, spelled like the enumerator.
inline const char* to_string(Trace_status end)
{
  return internal::name_of(end, {"LENGTH", "VERTEX", "BORDER", "CONSTRAINED_EDGE", "CROSSING_LIMIT"});
}

/// \ingroup PkgFlipGeodesicsTracing
/// Specifies the behavior of a straightest geodesic that reaches a vertex exactly.
enum class At_vertices {
  GO_STRAIGHT, ///< the geodesic continues with the same angle on its left as on its right \cgalCite{PS98}
  STOP         ///< the geodesic ends at the vertex
};

} // namespace Flip_geodesics

namespace parameters {

/// \ingroup PkgFlipGeodesicsParameters
/// Sets the behavior of `trace_geodesic()` at vertices.
/// \param rule by default `At_vertices::GO_STRAIGHT`
inline auto at_vertices(Flip_geodesics::At_vertices rule)
{
  return Named_function_parameters<Flip_geodesics::At_vertices, Flip_geodesics::internal::At_vertices_parameter>(rule);
}

} // namespace parameters

namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTracing
/// Describes a straightest geodesic that has been traced: its length, and where and why it ends.
struct Trace_report
{
  double length = 0;                          ///< the length of the geodesic, at most the requested one
  Trace_status status = Trace_status::LENGTH; ///< why the geodesic ends
  std::size_t edges = 0;                      ///< the number of crossed edges
  std::size_t vertices = 0;                   ///< the number of vertices passed straight through
  Surface_location location;                  ///< the end of the geodesic
  Input_halfedge_index halfedge;              ///< the halfedge from which the direction at the end is measured
  double angle = 0;               ///< the counterclockwise angle from this halfedge to the direction, in radians
  Decision_statistics statistics; ///< the filter failures, and how they were resolved
};

namespace internal {

/* Limits the length of a straightest geodesic and the edges that it may cross. */
template <class IsConstrained>
struct Trace_limits
{
  double length;
  At_vertices at_vertices;
  std::size_t most_crossings;
  const IsConstrained& is_constrained;
};

/* Traces one straightest geodesic, writes its points, and records its report. */
template <class Triangulation, class Limits, class OutputIterator>
class Trace_walk
{
public:
  Trace_walk(const Triangulation& triangulation, const Exact_input_faces<Triangulation>& exact_faces,
             const Limits& limits, OutputIterator out)
    : m_triangulation(triangulation)
    , m_exact_faces(exact_faces)
    , m_directions(triangulation)
    , m_limits(limits)
    , m_out(out)
  {
  }

  Trace_report operator()(Ray_start start)
  {
    *m_out++ = surface_point(m_triangulation, start.place);
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

  // Continues up to an end, or to a vertex at which it restarts.
  bool go_straight(Ray_start& start)
  {
    Ray ray(m_triangulation, m_exact_faces, start.place, start.direction, m_trace.statistics);
    bool is_at_portal = ray.leave_first_face();
    CGAL_assertion_code(const bool is_inside =) is_at_portal || ray.reach_first_corner();
    CGAL_assertion(is_inside);
    for(;;) {
      while(is_at_portal) {
        if(ends_at_portal(ray))
          return false;
        ++m_trace.edges;
        is_at_portal = ray.pass_portal();
      }
      if(ends_at_corner(ray))
        return false;
      ++m_trace.vertices;
      *m_out++ = surface_point(m_triangulation, {ray.corner(), {{1, 0, 0}}});
      if(!is_flat(ray.corner())) {
        m_trace.length += ray.distance_of_corner();
        start = m_directions.at_vertex(ray.corner(), straight_on(ray));
        return true;
      }
      is_at_portal = ray.pass_corner();
    }
  }

  bool ends_at_portal(const Ray& ray)
  {
    const double length = m_trace.length + ray.distance_of_portal();
    if(length >= m_limits.length)
      return end_inside(ray, true);
    const Input_halfedge_index h = ray.portal();
    const bool is_border = m_triangulation.input().is_border(twin_index(h));
    if(is_border || m_limits.is_constrained(h))
      return end_on_portal(ray, length, is_border ? Trace_status::BORDER : Trace_status::CONSTRAINED_EDGE);
    if(m_trace.edges + m_trace.vertices >= m_limits.most_crossings)
      return end_on_portal(ray, length, Trace_status::CROSSING_LIMIT);
    if(!ray.starts_on_portal())
      *m_out++ = surface_point_on_edge(m_triangulation, h, ray.place_on_portal());
    return false;
  }

  bool end_inside(const Ray& ray, bool is_at_portal)
  {
    m_trace.location = ray.location_at(m_limits.length - m_trace.length, is_at_portal);
    return finish(ray, m_limits.length, Trace_status::LENGTH);
  }

  bool end_on_portal(const Ray& ray, double length, Trace_status end)
  {
    const double place = (std::min)((std::max)(ray.place_on_portal(), least_weight), largest_below_one);
    m_trace.location = {ray.portal(), {{1 - place, place, 0}}};
    return finish(ray, length, end);
  }

  bool finish(const Ray& ray, double length, Trace_status end)
  {
    *m_out++ = surface_point(m_triangulation, m_trace.location);
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

  // Returns the angle from corner() that bisects the total angle as seen from the ray.
  double straight_on(const Ray& ray) const
  {
    const double total = m_directions.total_angle(ray.corner());
    return ray.angle_at_corner() + (std::isfinite(total) ? total / 2 : boost::math::constants::pi<double>());
  }

  // Returns whether the angles around the tail of h sum to exactly 2 pi and all faces have an area. A ray then
  // continues as in a plane.
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
    *m_out++ = surface_point(m_triangulation, m_trace.location);
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
  OutputIterator m_out;
  Trace_report m_trace;
};

/* Returns the start of a ray in a direction given by an angle or by coordinates in a face. */
template <class Finder>
Ray_start start_of(const Finder& finder, const Surface_location& source, const Surface_direction& direction)
{
  return finder.by_angle(source, direction.halfedge, direction.angle);
}

template <class Finder>
Ray_start start_of(const Finder& finder, const Surface_location& source, const std::array<double, 2>& direction)
{
  return finder.by_direction(source, direction);
}

/* Returns whether an edge ends a geodesic, by the map of the named parameters. */
template <class Triangulation, class Map>
struct Is_constrained
{
  const Triangulation& triangulation;
  Map map;

  bool operator()(Input_halfedge_index h) const
  {
    const auto& input = triangulation.input();
    return get(map, edge(input.halfedge(h), input.uncontracted().mesh()));
  }
};

template <class Triangulation, class Direction, class OutputIterator, class NamedParameters>
Trace_report traced_geodesic(const Triangulation& triangulation, const Exact_input_faces<Triangulation>& exact_faces,
                             const Surface_location& source, const Direction& direction, double length,
                             OutputIterator out, const NamedParameters& np)
{
  if(!(length >= 0 && std::isfinite(length)))
    throw Invalid_parameter_error("the length of a geodesic must be finite and not negative");
  const Direction_finder<Triangulation> finder(triangulation);
  const auto walk = [&](const auto& is_constrained) {
    const Trace_limits<std::decay_t<decltype(is_constrained)>> limits = {
        length,
        parameters::choose_parameter(parameters::get_parameter(np, at_vertices_parameter), At_vertices::GO_STRAIGHT),
        number_of_iterations(np, 1000000), is_constrained};
    return Trace_walk(triangulation, exact_faces, limits, out)(start_of(finder, source, direction));
  };
  if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>) {
    const auto map = parameters::get_parameter(np, internal_np::edge_is_constrained);
    return walk(Is_constrained<Triangulation, std::decay_t<decltype(map)>>{triangulation, map});
  } else {
    return walk([](Input_halfedge_index) { return false; });
  }
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTracing
 *
 * Traces straightest geodesics on the input mesh of a triangulation \cgalCite{PS98}, that is, evaluates the exponential
 * map. Such geodesics are straight across faces and edges, and have equal angles on both sides at each vertex through
 * which they pass. The corresponding free function is `trace_geodesic()`.
 *
 * Which edges are crossed, and whether a vertex is reached, is decided exactly, up to the work limit of the traits:
 * each decision is the sign of a real number that is defined by the weights of the start, the direction, and the input
 * coordinates or lengths.
 *
 * A direction given as an angle is rounded once, to a vector in the face. At a vertex whose angles sum to exactly
 * \f$2\pi\f$, the geodesic continues as in a plane, without rounding. Examples are vertices inside planar regions and
 * on the edges between two planar regions. At other vertices, and at vertices of a degenerate face, the bisecting angle
 * is rounded, and so is the outgoing direction.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`; flips made in it do not affect the result
 */
template <class Triangulation>
class Geodesic_tracer
{
public:
  /// Constructs a tracer for a triangulation, which must outlive the tracer.
  explicit Geodesic_tracer(const Triangulation& triangulation)
    : m_triangulation(triangulation)
    , m_exact_faces(triangulation)
  {
  }

  /*!
   * Traces a geodesic from a point in a given direction.
   *
   * \param source the start, a point of any type that `surface_location()` accepts. A `Face_location` is not moved to a
   *        nearby edge or vertex, so tracing can continue from the end of any geodesic
   * \param direction a `Surface_direction`. If the start is a vertex, a full turn is the sum of the angles around the
   *        vertex. If the start is a `Surface_location`, the direction can also be a `std::array<double, 2>`, which
   *        represents a vector in the face of the halfedge of the location. The two entries are the coefficients of the
   *        vectors from the tail of this halfedge to its head and to the third corner of the face. The coefficients are
   *        not rounded, except if the start is a vertex and the vector points out of the face, or if one coefficient is
   *        more than about 1e100 times the other
   * \param length the maximal length, in the unit of the coordinates
   * \param out an output iterator that receives a `Surface_point` for the start, each crossed edge, each vertex, and
   *        the end; `CGAL::Emptyset_iterator()` if these points are not needed
   * \param np an optional sequence of the named parameters `edge_is_constrained_map`, `number_of_iterations` and
   *        `at_vertices` of `trace_geodesic()`
   * \return a report with the end of the geodesic
   * \throws Invalid_location_error if `source` is not a point of the surface
   * \throws Invalid_parameter_error if the angle is not finite; if its halfedge neither is a side of a face that
   *        contains the source nor starts at the source; if the two coefficients are zero or not finite, or belong to a
   *        border halfedge; if the length is negative or not finite; or if the number of iterations is negative
   * \throws Degenerate_face_error if a face has a degenerate edge or violates the triangle inequality, or the direction
   *         lies in a degenerate face
   * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
   * \throws Invalid_mesh_error if a face is not a triangle
   *
   * Complexity: linear in the number of crossed edges plus the sum of the degrees of the vertices through which the
   * geodesic passes, if the floating-point filter suffices.
   */
  template <class Source = Surface_location, class Direction = Surface_direction, class OutputIterator,
            class... NamedParameters>
  Trace_report trace(const Source& source, const Direction& direction, double length, OutputIterator out,
                     const NamedParameters&... np) const
  {
    const auto& options = internal::options_of<internal_np::edge_is_constrained_t, internal_np::number_of_iterations_t,
                                               internal::At_vertices_parameter>(np...);
    constexpr bool is_direction = std::is_convertible<Direction, Surface_direction>::value ||
                                  std::is_convertible<Direction, std::array<double, 2>>::value;
    static_assert(is_direction, "the direction must be a Surface_direction or an array of two coordinates in the face");
    const auto& mesh = m_triangulation.input().uncontracted().mesh();
    if constexpr(is_direction) // avoids another error message
      return internal::traced_geodesic(m_triangulation, m_exact_faces,
                                       internal::trace_start(m_triangulation, mesh, source), direction, length, out,
                                       options);
    else
      return Trace_report();
  }

private:
  const Triangulation& m_triangulation;
  internal::Exact_input_faces<Triangulation> m_exact_faces;
};

/// \ingroup PkgFlipGeodesicsTracing
/// Contains the result of `trace_geodesic()`.
template <class OutputIterator, class TriangleMesh>
struct Trace_result
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< the face type
  /// The halfedge type of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  OutputIterator out;                                         ///< the past-the-end iterator of the output
  Trace_report report;                                        ///< the report on the geodesic
  std::pair<face_descriptor, std::array<double, 3>> location; ///< the end of the geodesic, a `Face_location`
  std::pair<halfedge_descriptor, double> direction;           ///< the direction in which the geodesic would continue

  double length() const { return report.length; }       ///< returns the length of the geodesic
  Trace_status status() const { return report.status; } ///< returns why the geodesic ends
};

namespace internal {

template <class T, class = void>
constexpr bool is_vector_in_space = false;
template <class T>
constexpr bool
    is_vector_in_space<T, std::void_t<decltype(std::declval<T>().x(), std::declval<T>().y(), std::declval<T>().z())>> =
        true;

/* Converts a direction given by the user, a vector in space or a halfedge and an angle, to one that is traced. */
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

  Surface_direction operator()(const Surface_location&, const std::pair<Halfedge, double>& direction) const
  {
    return {m_triangulation.input().index(direction.first), direction.second};
  }

  template <class Direction>
  std::enable_if_t<is_vector_in_space<Direction>, std::array<double, 2>> operator()(const Surface_location& source,
                                                                                    const Direction& direction) const
  {
    static_assert(Has_points<typename Triangulation::Metric>::value,
                  "the metric has no points in space: pass the direction as a halfedge and an angle");
    check_location(m_triangulation.input(), source);
    return in_face(source.halfedge,
                   {{CGAL::to_double(direction.x()), CGAL::to_double(direction.y()), CGAL::to_double(direction.z())}});
  }

private:
  // Returns the projection of a vector to the plane of the face of h, in coordinates along h and along the side from
  // its tail to the third corner.
  std::array<double, 2> in_face(Input_halfedge_index h, const Vector& v) const
  {
    const auto& input = m_triangulation.input();
    if(input.is_border(h))
      return {0, 0};
    input_face_geometry(m_triangulation, h); // throws for corners with invalid coordinates
    const Vector a = side(h), c = side(input.next(input.next(h))), b = {{-c[0], -c[1], -c[2]}};
    const Vector normal = unit_of(cross(unit_of(a), unit_of(b))), direction = unit_of(v);
    if(normal == Vector{{0, 0, 0}})
      throw_naming<Degenerate_face_error>("a direction is given in a degenerate face, that of halfedge ", h);
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

  // Divides by a power of two, so that the largest coordinate is between 1 and 2 and all digits are kept.
  static Vector unit_of(const Vector& v)
  {
    const double size = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if(!(size > 0) || !std::isfinite(size))
      return v;
    const int exponent = std::ilogb(size);
    return {{std::scalbn(v[0], -exponent), std::scalbn(v[1], -exponent), std::scalbn(v[2], -exponent)}};
  }

  static Vector cross(const Vector& u, const Vector& v)
  {
    const auto difference = [&](int i, int k) { // of products, accurately [JLM13]
      const double product = u[k] * v[i];
      return std::fma(u[i], v[k], -product) - std::fma(u[k], v[i], -product);
    };
    return {{difference(1, 2), difference(2, 0), difference(0, 1)}};
  }

  const Triangulation& m_triangulation;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsTracing
 *
 * Traces a straightest geodesic \cgalCite{PS98} from a surface point in a given direction, that is, evaluates the
 * exponential map.
 *
 * The geodesic is straight across faces and edges. At a vertex, the geodesic continues with the same angle on its left
 * as on its right, or ends, according to the named parameter `at_vertices`. Which edges are crossed, and whether a
 * vertex is reached, is decided exactly, up to the work limit of the traits. The direction is rounded in the first
 * face. It is rounded again after each vertex whose angles do not sum to exactly \f$2\pi\f$, and after each vertex of a
 * degenerate face.
 *
 * \param mesh a triangle mesh
 * \param source a vertex, a `CGAL::Polygon_mesh_processing::Face_location` or a point in space, as for
 *        `geodesic_path_through()`
 * \param direction a `std::pair` of a halfedge and an angle, or a vector in space. The angle is measured from the
 *        halfedge, in radians and counterclockwise on the surface. The halfedge must be a side of a face that contains
 *        the source or, if the source is a vertex, start at the source. At a vertex, a full turn is the sum of the
 *        angles around the vertex. A vector is projected onto the plane of the face of the source; if the source lies
 *        on the boundary of this face, the projected vector can lead out of the face. A vector is not accepted if the
 *        source is given as a vertex
 * \param length the maximal length, in the unit of the coordinates
 * \param out an output iterator that receives the points of the geodesic in order: its start, the crossed edges and
 *        vertices, and its end, in the form described at `geodesic_path()`
 * \param np an optional sequence of named parameters among those listed below, and `vertex_point_map` or `metric` as
 *        for `geodesic_path()`, and `geom_traits`, of which only the work limit is used
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that returns `true` for the edges at which the geodesic must end}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the edges of the mesh as keys and `bool` as values}
 *     \cgalParamDefault{no edge is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the maximal number of edges and vertices through which the geodesic passes}
 *     \cgalParamType{an integer}
 *     \cgalParamDefault{1000000}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{at_vertices}
 *     \cgalParamDescription{the behavior at vertices}
 *     \cgalParamType{`At_vertices`}
 *     \cgalParamDefault{`At_vertices::GO_STRAIGHT`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a `Trace_result`, whose `location` and `direction` can be used to continue the geodesic
 * \throws Vertex_out_of_range_error if the source is given as a vertex that does not belong to the mesh
 * \throws Invalid_location_error if the source does not lie on the mesh
 * \throws Invalid_parameter_error if the length or the direction is not finite; if the length or the number of
 *         iterations is negative; if the vector has no component in the plane of the face; or if the halfedge does not
 *         satisfy the condition stated above
 * \throws Degenerate_face_error if a face has a degenerate edge or violates the triangle inequality, or the direction
 *         at the start points into a degenerate face
 * \throws Invalid_coordinate_error if a coordinate or an edge length is not finite or out of range
 * \throws Invalid_mesh_error if a face is not a triangle
 *
 * Complexity: linear in the number of crossed edges plus the sum of the degrees of the vertices through which the
 * geodesic passes, if the floating-point filter suffices. A mesh other than a `Surface_mesh` is indexed first, in
 * \cgalBigO{n \log n} time for \f$n\f$ faces.
 *
 * \sa `Geodesic_tracer`, for many geodesics on one mesh
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
                "the direction must be a pair of a halfedge and an angle, or a vector in space");
  static_assert(!is_vector || !internal::is_mesh_vertex<TriangleMesh, Source>,
                "a vector in space requires a face: pass the source as a Face_location, or give the direction as a "
                "halfedge and an angle");
  const Surface surface = internal::make_surface(mesh, options);
  const Surface_location place = internal::trace_start(surface, mesh, source);
  std::vector<Surface_point> points;
  const Trace_report trace =
      internal::traced_geodesic(surface, internal::Exact_input_faces<Surface>(surface), place,
                                internal::Given_direction<Surface, TriangleMesh>(surface)(place, direction), length,
                                std::back_inserter(points), options);
  return {internal::write_points<Form>(surface, mesh, points, out),
          trace,
          internal::face_location_of(surface, mesh, trace.location),
          {surface.input().halfedge(trace.halfedge), trace.angle}};
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_TRACE_GEODESIC_H
