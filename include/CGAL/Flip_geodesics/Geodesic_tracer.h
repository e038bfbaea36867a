// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_TRACER_H
#define CGAL_FLIP_GEODESICS_GEODESIC_TRACER_H

#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/Surface_location.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/Exact_face.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/tangents/Direction_finder.h>
#include <CGAL/Flip_geodesics/internal/tangents/Ray.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_input_faces.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Exact_sign.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Unfolding_chain.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsTracing
/// Why a straightest geodesic ends.
enum class Trace_end {
  LENGTH,           ///< it has the length that was asked for
  VERTEX,           ///< it runs into a vertex, exactly, and was to stop there
  BORDER,           ///< it meets the border, on an edge or at a vertex, or would leave the surface at its start there
  CONSTRAINED_EDGE, ///< it meets an edge that it may not cross, or a vertex of one
  CROSSING_LIMIT    ///< it has crossed as many edges as it may
};

/// The name of a reason, as the enumerator is spelled.
inline const char* to_string(Trace_end end)
{
  switch(end) {
  case Trace_end::LENGTH:
    return "LENGTH";
  case Trace_end::VERTEX:
    return "VERTEX";
  case Trace_end::BORDER:
    return "BORDER";
  case Trace_end::CONSTRAINED_EDGE:
    return "CONSTRAINED_EDGE";
  case Trace_end::CROSSING_LIMIT:
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

namespace internal {

/* The edges that end no geodesic. */
struct No_edge_is_constrained
{
  bool operator()(Input_halfedge_index) const { return false; }
};

} // namespace internal

/// \ingroup PkgFlipGeodesicsTracing
/// How far a straightest geodesic goes, and which edges it may not cross.
template <class IsConstrained = internal::No_edge_is_constrained>
struct Trace_limits
{
  double length;                                      ///< at most this long, a finite number
  At_vertices at_vertices = At_vertices::GO_STRAIGHT; ///< what it does at vertices
  std::size_t most_crossings = 1000000;               ///< how many edges and vertices it may pass
  IsConstrained is_constrained = IsConstrained();     ///< tells of an `Input_halfedge_index` whether its edge ends it
};

/// \ingroup PkgFlipGeodesicsTracing
/// A straightest geodesic that has been traced: how long it is, and where and how it ends.
struct Trace
{
  double length = 0;                 ///< its length, at most that asked for
  Trace_end end = Trace_end::LENGTH; ///< why it ends
  std::size_t edges = 0;             ///< how many edges it crosses
  std::size_t vertices = 0;          ///< how many vertices it passes straight on
  Surface_location location;         ///< its end
  Input_halfedge_index halfedge;     ///< what its direction at the end is told from, see `Geodesic_tracer::trace()`
  double angle = 0;                  ///< from there on to its direction, counterclockwise, in radians
  Decision_statistics statistics;    ///< how decisions were taken that doubles left open
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

  Trace operator()(Ray_start start)
  {
    m_visitor(surface_point(m_triangulation, start.place));
    if(start.is_outward) {
      end_at_corner(start.place.halfedge, start.angle);
      m_trace.end = Trace_end::BORDER;
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
      return end_on_gate(ray, length, is_border ? Trace_end::BORDER : Trace_end::CONSTRAINED_EDGE);
    if(m_trace.edges + m_trace.vertices >= m_limits.most_crossings)
      return end_on_gate(ray, length, Trace_end::CROSSING_LIMIT);
    if(!ray.starts_on_gate())
      m_visitor(surface_point_on_edge(m_triangulation, h, ray.place_on_gate()));
    return false;
  }

  bool end_inside(const Ray& ray, bool is_at_gate)
  {
    m_trace.location = ray.location_at(m_limits.length - m_trace.length, is_at_gate);
    return finish(ray, m_limits.length, Trace_end::LENGTH);
  }

  bool end_on_gate(const Ray& ray, double length, Trace_end end)
  {
    const double place = (std::min)((std::max)(ray.place_on_gate(), least_weight), largest_below_one);
    m_trace.location = {ray.gate(), {{1 - place, place, 0}}};
    return finish(ray, length, end);
  }

  bool finish(const Ray& ray, double length, Trace_end end)
  {
    m_visitor(surface_point(m_triangulation, m_trace.location));
    m_trace.length = length;
    m_trace.end = end;
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
    m_trace.end = is_border                 ? Trace_end::BORDER
                  : is_long                 ? Trace_end::LENGTH
                  : has_constrained_edge(h) ? Trace_end::CONSTRAINED_EDGE
                                            : (is_last ? Trace_end::CROSSING_LIMIT : Trace_end::VERTEX);
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
  Trace m_trace;
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
  template <class IsConstrained, class Visitor = internal::No_visitor_of_points>
  Trace trace(const Surface_location& location, Input_halfedge_index halfedge, double angle,
              const Trace_limits<IsConstrained>& limits, Visitor visitor = Visitor()) const
  {
    return walk(internal::Direction_finder<Triangulation>(m_triangulation).by_angle(location, halfedge, angle), limits,
                visitor);
  }

  /*!
   * The same by a direction in the face of `location.halfedge`, in coordinates along two of its sides: `direction[0]`
   * times the vector from the tail of the halfedge to its head, and `direction[1]` times that to the third corner. It is
   * not rounded, unless the location is a vertex and it points out of the face, or one number is 1e100 times the other.
   */
  template <class IsConstrained, class Visitor = internal::No_visitor_of_points>
  Trace trace(const Surface_location& location, const std::array<double, 2>& direction,
              const Trace_limits<IsConstrained>& limits, Visitor visitor = Visitor()) const
  {
    return walk(internal::Direction_finder<Triangulation>(m_triangulation).by_direction(location, direction), limits,
                visitor);
  }

private:
  template <class IsConstrained, class Visitor>
  Trace walk(const internal::Ray_start& start, const Trace_limits<IsConstrained>& limits, Visitor& visitor) const
  {
    if(!(limits.length >= 0 && std::isfinite(limits.length)))
      throw Invalid_parameter_error("the length of a geodesic to be traced is negative or no finite number");
    return internal::Trace_walk<Triangulation, Trace_limits<IsConstrained>, Visitor>(m_triangulation, m_exact_faces,
                                                                                     limits, visitor)(start);
  }

  const Triangulation& m_triangulation;
  internal::Exact_input_faces<Triangulation> m_exact_faces;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_TRACER_H
