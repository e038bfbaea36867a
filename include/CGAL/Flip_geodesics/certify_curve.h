// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFY_CURVE_H
#define CGAL_FLIP_GEODESICS_CERTIFY_CURVE_H

#include <CGAL/Flip_geodesics/Curve_point.h>
#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Edge_sequences_of_places.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Indexed_mesh.h>
#include <CGAL/Flip_geodesics/internal/surface/checks.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Point_insertion.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Wedge_comparison.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// The type of a point of a curve that was not computed by this package. Such a point is a vertex, a
/// `CGAL::Polygon_mesh_processing::Face_location`, or a halfedge with a position on it, which is 0 at the source and 1
/// at the target.
template <class TriangleMesh>
using Given_place =
    std::variant<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                 std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>,
                 std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>>;

namespace internal {

template <class Triangulation>
class Given_curve_certifier;

} // namespace internal

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the verdict on a curve that is given by its points, and the position and angle of the largest bend.
template <class TriangleMesh>
struct Given_curve_certificate
{
  /// The vertex type of the mesh.
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// The largest bend of the curve, rounded, in radians; 0 if the curve is not bent. The joints at the ends of a
  /// segment that is bent by more than `Straightness::tolerance()` are not examined.
  ///
  /// The bend at a joint is \f$\pi\f$ minus the angle on the side `side`. For the bend of a segment, consider the
  /// shortest path that connects the ends of the segment and crosses the same edges as the segment. The bend is the
  /// largest angle by which this path turns at an end of one of these edges. If a straight segment touches a vertex
  /// whose angles sum to less than \f$2\pi\f$, the bend of the segment is \f$2\pi\f$ minus this sum.
  double bend = 0;
  vertex_descriptor vertex = boost::graph_traits<TriangleMesh>::null_vertex(); ///< the vertex at the bend
  /// The index of the point at the bend in the range of points passed to `certify_curve()`, counted from 0; it is not
  /// the index of a vertex. At a bent joint, this point is `vertex`; in a bent segment, it represents a crossed edge of
  /// which `vertex` is an end.
  std::size_t number = 0;
  Side side = Side::LEFT; ///< the side of a bent joint; in a segment, the side on which `vertex` lies
  /// The positions at which segments cross edges. The vector has one entry for each given point; the entries of ends
  /// and of vertices through which the curve passes are 0. The vector is empty if the curve is bent.
  ///
  /// A position is 0 at the source of the given halfedge and 1 at its target. If a crossed edge is given by a location,
  /// the position refers to the halfedge of the edge in the face of the location. Positions are computed in double.
  std::vector<double> places;
  Decision_statistics statistics; ///< the filter failures, and how they were resolved

  /// Returns the verdict; if the curve is bent, it states whether the largest bend is that of a segment or a joint. If
  /// coordinates or lengths of the mesh had to be rounded, the verdict is `UNDECIDED`, and the data members refer to
  /// the rounded mesh.
  Verdict verdict() const { return m_verdict; }

  /// Returns whether the curve is locally shortest, that is, whether the verdict is `PROVEN` or `PROBABLE`.
  bool is_locally_shortest() const { return is_confirmed(m_verdict); }

private:
  template <class Triangulation>
  friend class internal::Given_curve_certifier;

  Verdict m_verdict = Verdict::PROVEN;
};

namespace internal {

template <class Triangulation>
class Given_curve
{
  using Mesh = typename Triangulation::Triangle_mesh;
  using Graph = boost::graph_traits<Mesh>;
  using Vertex = typename Graph::vertex_descriptor;
  using Crossing = std::pair<typename Graph::halfedge_descriptor, double>;
  using Point_of_face = std::pair<typename Graph::face_descriptor, std::array<double, 3>>;

public:
  Given_curve(const Triangulation& triangulation, const Mesh& mesh)
    : m_triangulation(triangulation)
    , m_mesh(mesh)
    , m_places(triangulation)
    , m_sequences(m_places)
  {
  }

  template <class Place>
  void read(const std::vector<Place>& places, bool is_closed)
  {
    std::vector<Given_place<Mesh>> given;
    for(const Place& place : places)
      given.push_back(as_given(place));
    if(given.size() < (is_closed ? 1u : 2u))
      throw Invalid_curve_error(is_closed ? "a closed curve has no points" : "a curve requires at least two points");
    for(std::size_t i = 0; i < given.size(); ++i) {
      const bool is_end = !is_closed && (i == 0 || i + 1 == given.size());
      const Crossing* crossing = std::get_if<Crossing>(&given[i]);
      const Surface_location at = crossing != nullptr && !is_end
                                      ? Surface_location{halfedge(crossing->first, i), {{1, 1, 0}}}
                                      : location(given[i], i);
      if(is_closed && i == 0 && kind(at) != Location_kind::VERTEX)
        throw Invalid_curve_error(
            "a closed curve does not start at a vertex; let it start at a vertex through which it passes", {0});
      if(is_end || kind(at) == Location_kind::VERTEX)
        arrive(m_places.add(at), i, i > 0 && i + 1 == given.size() && !is_closed);
      else if(kind(at) == Location_kind::EDGE)
        m_sequences.cross(side_of_edge(at), i);
      else
        throw_naming<Invalid_curve_error>("point ", Element{i}, " lies inside a face, but is not an end of the curve");
    }
    if(is_closed)
      m_sequences.arrive(m_first, given.size());
  }

  const Places_on_input<Triangulation>& places() const { return m_places; }
  const std::vector<Segment_of_places>& segments() const { return m_sequences.segments(); }

private:
  template <class Place>
  Given_place<Mesh> as_given(const Place& place) const
  {
    if constexpr(std::is_convertible<Place, Given_place<Mesh>>::value)
      return place;
    else if constexpr(std::is_convertible<const Place*, const Curve_place<Mesh>*>::value)
      return place.location;
    else
      return face_location_of(m_triangulation, m_mesh, located_place(m_triangulation, place));
  }

  // Returns the side on whose edge a location lies, in its face.
  Input_halfedge_index side_of_edge(Surface_location location) const
  {
    while(location.weights[2] != 0)
      location = rotated(m_triangulation.input(), location);
    return location.halfedge;
  }

  void arrive(Vertex_index v, std::size_t number, bool is_last)
  {
    if(number == 0)
      m_first = v;
    is_last ? m_sequences.arrive(v, number) : m_sequences.pass(v, number);
  }

  Input_halfedge_index halfedge(typename Graph::halfedge_descriptor given, std::size_t number) const
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index h =
        given == Graph::null_halfedge() ? Input_halfedge_index() : Input_halfedge_index(input.index(given));
    if(!h.is_valid())
      throw_naming<Invalid_curve_error>("point ", Element{number}, " of the curve is not on a halfedge of the mesh");
    return h;
  }

  Surface_location location(const Given_place<Mesh>& given, std::size_t number) const
  {
    const auto& input = m_triangulation.input();
    if(const auto* crossing = std::get_if<Crossing>(&given))
      return {halfedge(crossing->first, number), {{1 - crossing->second, crossing->second, 0}}};
    if(const auto* point = std::get_if<Point_of_face>(&given)) {
      if(!is_face(point->first, m_mesh))
        throw_naming<Invalid_location_error>("point ", Element{number},
                                             " of the curve has a face that does not belong to the mesh");
      return {input.index(graph_halfedge(point->first, m_mesh)), point->second};
    }
    const Vertex_index v = m_triangulation.index(std::get<Vertex>(given));
    check_vertex(v, input.number_of_vertices(), number);
    if(input.outgoing(v) == null_index)
      throw_naming<Vertex_out_of_range_error>("a curve passes through vertex ", v,
                                              ", which does not belong to any face");
    return {input.outgoing(v), {{1, 0, 0}}};
  }

  const Triangulation& m_triangulation;
  const Mesh& m_mesh;
  Places_on_input<Triangulation> m_places;
  Edge_sequences_of_places<Triangulation> m_sequences;
  Vertex_index m_first = null_index;
};

template <class Triangulation>
class Given_curve_certifier
{
  using Places = Places_on_input<Triangulation>;
  using Mesh = typename Triangulation::Triangle_mesh;

public:
  Given_curve_certifier(const Triangulation& triangulation, const Given_curve<Triangulation>& curve)
    : m_triangulation(triangulation)
    , m_curve(curve)
  {
  }

  Given_curve_certificate<Mesh> operator()(std::size_t number_of_places, bool is_closed)
  {
    const std::vector<Segment_of_places>& segments = m_curve.segments();
    std::vector<char> is_nearly_straight;
    for(const Segment_of_places& segment : segments)
      is_nearly_straight.push_back(bend_of_segment(segment) <= reported_bend ? 1 : 0);
    // The angle at a joint is that between the straight lines of its edge sequences.
    for(std::size_t i = is_closed ? 0 : 1; i < segments.size(); ++i) {
      const std::size_t before = i == 0 ? segments.size() - 1 : i - 1;
      if(is_nearly_straight[before] != 0 && is_nearly_straight[i] != 0)
        look_at_joint(segments[before].sequence, segments[i]);
    }
    if(m_result.m_verdict == Verdict::PROVEN && m_result.statistics.unproven_zeros > 0)
      m_result.m_verdict = Verdict::PROBABLE;
    if(m_result.is_locally_shortest())
      tell_places(number_of_places);
    if(is_input_rounded(m_triangulation))
      m_result.m_verdict = Verdict::UNDECIDED;
    return m_result;
  }

private:
  // Returns the bend of a segment, and records it.
  double bend_of_segment(const Segment_of_places& segment)
  {
    Strip_obstacle obstacle;
    if(Straight_strip<Places>(m_curve.places(), m_result.statistics)(segment.sequence, &obstacle))
      return 0;
    const auto& crossed = segment.sequence.crossed;
    Portal_turn turn;
    if(obstacle.missing_angle > 0 || crossed.empty()) {
      turn.angle = obstacle.missing_angle;
      while(turn.portal < crossed.size() && !has_end(crossed[turn.portal], obstacle.vertex))
        ++turn.portal;
    } else {
      turn = largest_turn(m_curve.places(), Strip<Places>(m_curve.places(), segment.sequence));
      if(turn.angle == 0) // rounded
        turn.portal = obstacle.portal;
      else
        obstacle.vertex = tail(turn.side == LEFT_END ? twin_index(crossed[turn.portal]) : crossed[turn.portal]);
    }
    const bool is_crossed = turn.portal < crossed.size();
    const bool is_on_left = is_crossed && tail(crossed[turn.portal]) != obstacle.vertex;
    note(Verdict::BENT_SEGMENT, turn.angle, obstacle.vertex, segment.start + (is_crossed ? 1 + turn.portal : 0),
         is_on_left ? Side::LEFT : Side::RIGHT);
    return turn.angle;
  }

  void look_at_joint(const Edge_sequence& before, const Segment_of_places& segment)
  {
    const Edge_sequence back = before.reversed();
    const Seen_edge_sequence in = {back, true, tail_angle(Strip<Places>(m_curve.places(), back))},
                             out = {segment.sequence, true,
                                    tail_angle(Strip<Places>(m_curve.places(), segment.sequence))};
    look_at_side(in, out, segment, Side::LEFT);
    look_at_side(out, in, segment, Side::RIGHT);
  }

  // Considers the angle on one side of the tail of a segment, clockwise.
  void look_at_side(const Seen_edge_sequence& from, const Seen_edge_sequence& to, const Segment_of_places& segment,
                    Side side)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    const Compared_angle angle = compared_angle_clockwise(m_curve.places(), m_result.statistics, from, to);
    if(angle.with_straight == SMALLER)
      note(Verdict::BENT_JOINT, (std::max)(pi - angle.value, 0.0), segment.sequence.tail, segment.start, side);
  }

  // Records the first bend, and each larger one.
  void note(Verdict verdict, double bend, Vertex_index v, std::size_t number, Side side)
  {
    if(!m_result.is_locally_shortest() && bend <= m_result.bend)
      return;
    m_result.m_verdict = verdict;
    m_result.bend = bend;
    m_result.vertex = m_triangulation.input().vertex(v);
    m_result.number = number;
    m_result.side = side;
  }

  void tell_places(std::size_t number_of_places)
  {
    m_result.places.assign(number_of_places, 0);
    for(const Segment_of_places& segment : m_curve.segments()) {
      const Strip<Places> strip(m_curve.places(), segment.sequence);
      for(std::size_t i = 0; i < strip.portals().size(); ++i) {
        const double place = strip.crossing(i);
        m_result.places[segment.start + 1 + i] = segment.is_as_given[i] ? place : 1 - place;
      }
    }
  }

  Vertex_index tail(Input_halfedge_index h) const { return m_triangulation.input().tail(h); }
  bool has_end(Input_halfedge_index h, Vertex_index v) const { return tail(h) == v || tail(twin_index(h)) == v; }

  const Triangulation& m_triangulation;
  const Given_curve<Triangulation>& m_curve;
  Given_curve_certificate<Mesh> m_result;
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Determines by exact predicates whether a given curve is locally shortest, regardless of how the curve was computed.
 *
 * The vertices through which the curve passes divide the curve into segments. The curve is locally shortest if it
 * satisfies three conditions. First, each segment is a straight line across its crossed edges. Second, this line does
 * not touch, between its ends, an interior vertex of the surface whose angles sum to less than \f$2\pi\f$. Third, at
 * each vertex through which the curve passes, the angle on each side that does not contain the border is at least
 * \f$\pi\f$.
 *
 * Since a segment is determined by its end points and its edge sequence, the function ignores the given positions on
 * crossed edges and returns the correct positions.
 *
 * An end inside a face or on an edge is exactly the point whose barycentric coordinates are the given weights divided
 * by their sum. If an end is given by a position t on a halfedge, the weights are t and the rounded value of 1 - t.
 * Ends are not moved to nearby edges or vertices. The angles at the ends of an open curve can be arbitrary.
 *
 * \param mesh a triangle mesh
 * \param curve a range of points on the mesh: vertices, `CGAL::Polygon_mesh_processing::Face_location`s,
 *        `Surface_location`s, `Curve_point`s or `Given_place`s. The first and the last point of an open curve are its
 *        ends. Every other point is a vertex through which the curve passes, or represents an edge that the curve
 *        crosses: by a location with exactly one weight of zero, or by a position on either halfedge of the edge. A
 *        segment that crosses no edges lies on the edge, or in the face, that contains both ends of the segment
 * \param np an optional sequence of named parameters. With `is_closed(true)`, the curve continues from the last point
 *        to the first; the first point must then be a vertex, and must not be repeated at the end. By default, the
 *        curve is open. The parameters `vertex_point_map` or `metric`, and `geom_traits`, are those of
 *        `geodesic_path()`
 * \return the certificate of the curve
 * \throws Invalid_curve_error if there are too few points, two consecutive points are equal or have no common face, a
 *         point other than an end lies inside a face, a crossed edge is on the border, a halfedge does not belong to
 *         the mesh, or a closed curve does not start at a vertex. `elements()` returns the index of the invalid point
 *         in `curve`, if there is one
 * \throws Invalid_location_error if the face of a location does not belong to the mesh, or if a weight of an end is
 *         negative, NaN, too small or too large
 * \throws Vertex_out_of_range_error if a vertex does not belong to the mesh or is isolated
 * \throws Degenerate_face_error if a face along the curve has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 *
 * Complexity: if the floating-point filter suffices, linear in the number of crossed edges plus the sum of the degrees
 * of the vertices through which the curve passes. Meshes other than `Surface_mesh` are indexed first, which takes
 * \cgalBigO{n \log n} time, where \f$n\f$ is the size of the mesh.
 *
 * \sa `certify()`
 */
template <class TriangleMesh, class PlaceRange, class... NamedParameters>
Given_curve_certificate<TriangleMesh> certify_curve(const TriangleMesh& mesh, const PlaceRange& curve,
                                                    const NamedParameters&... np)
{
  const auto& options = internal::surface_options<internal::Closed_parameter>(np...);
  const bool is_closed = internal::is_closed_of(options);
  using Triangulation =
      typename internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>::Triangulation;
  using Place = std::decay_t<decltype(*std::begin(curve))>;
  static_assert(std::is_convertible<Place, Given_place<TriangleMesh>>::value ||
                    internal::is_place<Triangulation, TriangleMesh, Place>,
                "the curve must be a range of points on the mesh: vertices, Face_location, Surface_location, "
                "Curve_point or Given_place");
  const Triangulation triangulation = internal::make_triangulation(mesh, options);
  const std::vector<Place> places(std::begin(curve), std::end(curve));
  internal::Given_curve<Triangulation> given(triangulation, mesh);
  given.read(places, is_closed);
  return internal::Given_curve_certifier<Triangulation>(triangulation, given)(places.size(), is_closed);
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CERTIFY_CURVE_H
