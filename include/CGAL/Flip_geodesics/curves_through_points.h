// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H
#define CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Leg_drawer.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/internal/flip_out/curve_computations_impl.h>
#include <CGAL/Flip_geodesics/internal/flip_out/located_points.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/intrinsic_edge_path.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// Specifies the type of a spline.
enum class Spline_kind {
  BEZIER,                ///< a single B&eacute;zier curve, whose degree is one less than the number of control points
  CUBIC_B_SPLINE,        ///< a uniform cubic B-spline from the first control point to the last
  CLOSED_CUBIC_B_SPLINE, ///< a closed uniform cubic B-spline of at least three control points
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Computes a chain of geodesic B&eacute;zier curves on the surface \cgalCite{MCV08}, \cgalCite{SC20,section 6.2}, by de
 * Casteljau's algorithm with geodesics instead of straight lines. Each curve is subdivided into pieces. On a planar,
 * convex mesh, the points at which consecutive pieces meet lie on the B&eacute;zier curve up to rounding errors.
 *
 * Each *leg* of a control polygon is a geodesic between two consecutive control points. The legs are computed
 * independently of one another, and the triangulation is restored after each. Legs can therefore pass through control
 * points, overlap, and cross one another, so the control polygon can cross itself.
 *
 * De Casteljau's algorithm repeatedly replaces a polygon by the polygon of the midpoints of its legs. Each new leg is
 * obtained by shortening the path that follows the old legs from one midpoint to the next. The spline therefore stays
 * in the homotopy class of the control polygon.
 *
 * `add_curve_along()` turns the pieces of the finished curve into a curve of a network, and thus into edges of a
 * triangulation.
 *
 * The triangulation is unchanged after each call of a member function.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Geodesic_spline
{
public:
  /*!
   * Constructs a spline from control points. Consecutive points are connected by shortest edge paths, which are
   * shortened to geodesics.
   *
   * \param triangulation a triangulation of the input without flips and curves; it must outlive the spline
   * \param control_points a range of at least two points of the surface, of any type that `surface_location()` accepts.
   *        A closed spline requires at least three points; a repetition of the first point at the end would count as a
   *        further point. Consecutive points may coincide; the leg between two coincident points has length zero
   * \param kind the type of the spline
   * \throws Invalid_curve_error if there are fewer than two points, or fewer than three for a closed spline
   * \throws Occupied_triangulation_error if a network has curves in the triangulation
   * \throws Vertex_out_of_range_error if a vertex is given that does not belong to the mesh or is isolated
   * \throws Invalid_location_error if a location is not a point of the surface
   * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
   * \throws Disconnected_endpoints_error if no edge path connects two consecutive points
   * \throws Crossing_curves_error as `refine()` does
   * \throws Ambiguous_order_error as `refine()` does
   */
  template <class PointRange = std::vector<Surface_location>,
            std::enable_if_t<!internal::is_range<internal::Range_value<PointRange>>, int> = 0>
  Geodesic_spline(Triangulation& triangulation, const PointRange& control_points, Spline_kind kind)
    : Geodesic_spline(internal::located_places(triangulation, control_points), triangulation, kind)
  {
  }

  /*!
   * Constructs a spline from a control polygon whose legs are geodesics, such as those of a `Curve_editor`. If a spline
   * is constructed from the legs of an editor after each move, every such spline is in the homotopy class of the moved
   * control polygon.
   *
   * \param triangulation a triangulation of the input without flips and curves; it must outlive the spline
   * \param legs the legs. Each leg must start at the end of the previous leg, and the last leg of a closed spline must
   *        end at the start of the first leg. Any two consecutive locations of a leg must lie in a common face
   * \param kind the type of the spline
   * \throws Invalid_curve_error if no leg is given, if fewer than three legs are given for a closed spline, if a leg
   *         has fewer than two locations, or if two consecutive locations do not lie in a common face
   * \throws Invalid_location_error if a location is not a point of the surface
   * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
   * \throws Crossing_curves_error as `refine()` does
   * \throws Ambiguous_order_error as `refine()` does
   */
  Geodesic_spline(Triangulation& triangulation, const std::vector<std::vector<Surface_location>>& legs,
                  Spline_kind kind)
    : m_straightener(triangulation)
    , m_measure(triangulation)
  {
    if(legs.size() < (kind == Spline_kind::CLOSED_CUBIC_B_SPLINE ? 3u : 1u))
      throw Invalid_curve_error(
          "a spline requires at least one leg of its control polygon, and a closed spline at least three");
    for(const std::vector<Surface_location>& leg : legs)
      m_legs.push_back({internal::canonical_polyline(triangulation.input(), leg, false)});
    start(kind);
  }

  /*!
   * Subdivides every piece at its midpoint, which doubles the number of pieces.
   * \throws Insertion_error if the subdivision is too fine for the number type
   * \throws Crossing_curves_error if the path formed by two consecutive legs crosses itself
   * \throws Ambiguous_order_error if the search for an order of the overlapping parts of two consecutive legs is
   *         aborted
   */
  void refine()
  {
    std::vector<Leg> result;
    for(std::size_t begin = 0; begin < m_legs.size();) {
      std::size_t end = begin + 1;
      while(!m_legs[end - 1].ends_piece)
        ++end;
      divide_piece(
          {m_legs.begin() + static_cast<std::ptrdiff_t>(begin), m_legs.begin() + static_cast<std::ptrdiff_t>(end)},
          result);
      begin = end;
    }
    m_legs.swap(result);
  }

  /*!
   * Calls `refine()` repeatedly, at most `most_rounds` times. The function returns after the first call that changes
   * the total length of the control polygons of the pieces by at most `tolerance` times the new length. The change in
   * each round is about a quarter of the change in the previous round, so all further rounds would change the length by
   * about a third of the last change.
   * \return the number of rounds
   * \throws Insertion_error as `refine()` does
   * \throws Crossing_curves_error as `refine()` does
   * \throws Ambiguous_order_error as `refine()` does
   */
  int refine(double tolerance, int most_rounds)
  {
    double before = polygon_length();
    for(int round = 1; round <= most_rounds; ++round) {
      refine();
      const double now = polygon_length();
      if(std::abs(before - now) <= tolerance * now)
        return round;
      before = now;
    }
    return most_rounds;
  }

  /*!
   * Computes a geodesic between the ends of each piece, in the homotopy class of the control polygon of the piece. The
   * control polygons are kept, so `refine()` and `finish()` can be called again.
   * \return one polyline per piece: the start of the geodesic, the points at which the geodesic crosses edges, and its
   *         end
   * \throws Insertion_error as `refine()` does
   * \throws Crossing_curves_error as `refine()` does
   * \throws Ambiguous_order_error as `refine()` does
   */
  std::vector<std::vector<Surface_location>> finish()
  {
    m_straightener.clear_report();
    std::vector<std::vector<Surface_location>> pieces;
    internal::Surface_polyline piece;
    double finished_length = 0;
    for(const Leg& leg : m_legs) {
      append(leg.path, piece);
      if(!leg.ends_piece)
        continue;
      pieces.push_back(m_straightener.straightened(piece));
      finished_length += m_measure.length(pieces.back());
      piece.clear();
    }
    m_report = m_straightener.report();
    m_report.curves.front().initial_length = m_control_length;
    m_report.curves.front().length = finished_length;
    if(finished_length == 0)
      m_report.curves.front().status = Shortening_status::CONTRACTED;
    return pieces;
  }

  /// Returns the total length of the control polygons of all pieces.
  double polygon_length() const
  {
    double sum = 0;
    for(const Leg& leg : m_legs)
      sum += m_measure.length(leg.path);
    return sum;
  }

  /// Returns the report on `finish()`. The numbers of flips include the flips of the construction and of all previous
  /// calls of member functions. The initial length is the total length of the control polygons of the pieces before the
  /// first call of `refine()`. The verdict is the verdict on all geodesics together.
  const Shortening_report& report() const { return m_report; }
  /// Returns the length of the finished curve. \throws Invalid_parameter_error if `finish()` has not been called
  double length() const { return finished().length; }
  /// Returns the status of all geodesics of the finished curve together. \throws Invalid_parameter_error if `finish()`
  /// has not been called
  Shortening_status status() const { return finished().status; }
  /// Returns the verdict on all geodesics of the finished curve together. \throws Invalid_parameter_error if
  /// `finish()` has not been called
  Verdict verdict() const { return finished().verdict; }

private:
  Geodesic_spline(const std::vector<Surface_location>& control_points, Triangulation& triangulation, Spline_kind kind)
    : m_straightener(triangulation)
    , m_measure(triangulation)
  {
    const bool is_closed = kind == Spline_kind::CLOSED_CUBIC_B_SPLINE;
    if(control_points.size() < (is_closed ? 3u : 2u))
      throw Invalid_curve_error("a spline requires at least two control points, and a closed spline at least three");
    for(std::size_t i = 0; i + (is_closed ? 0 : 1) < control_points.size(); ++i)
      m_legs.push_back({m_straightener.shortest(control_points[i], control_points[(i + 1) % control_points.size()])});
    start(kind);
  }

  const Curve_report& finished() const
  {
    if(m_report.curves.empty())
      throw Invalid_parameter_error("a spline is queried before it has been finished; call finish() first");
    return m_report.curves.front();
  }

  struct Leg
  {
    internal::Surface_polyline path;
    bool ends_piece = false;
  };

  static void append(const internal::Surface_polyline& path, internal::Surface_polyline& to)
  {
    to.insert(to.end(), path.begin() + (to.empty() ? 0 : 1), path.end());
  }

  std::pair<Leg, Leg> divided(const Leg& leg, double t) const
  {
    auto [first, second] = m_measure.divided(leg.path, t * m_measure.length(leg.path));
    return {Leg{std::move(first)}, Leg{std::move(second)}};
  }

  // Returns the geodesic from the start of a to the end of b, which starts at the end of a.
  Leg joined(const Leg& a, const Leg& b)
  {
    internal::Surface_polyline path = a.path;
    append(b.path, path);
    return {m_straightener.straightened(path)};
  }

  // De Casteljau: the outer halves of each level are the legs of the two halves.
  void divide_piece(std::vector<Leg> legs, std::vector<Leg>& result)
  {
    std::vector<Leg> rest; // of the second half, the last first
    while(!legs.empty()) {
      std::vector<Leg> next;
      Leg half;
      for(std::size_t i = 0; i < legs.size(); ++i) {
        auto [first, second] = divided(legs[i], 0.5);
        if(i == 0)
          result.push_back(std::move(first));
        else
          next.push_back(joined(half, first));
        half = std::move(second);
      }
      rest.push_back(std::move(half));
      legs.swap(next);
    }
    result.back().ends_piece = true;
    result.insert(result.end(), rest.rbegin(), rest.rend());
    result.back().ends_piece = true;
  }

  // Constructs the pieces from the legs of the control polygon.
  void start(Spline_kind kind)
  {
    if(kind == Spline_kind::BEZIER)
      m_legs.back().ends_piece = true;
    else
      make_cubic(kind == Spline_kind::CLOSED_CUBIC_B_SPLINE);
    m_control_length = polygon_length();
  }

  // Legs are divided into thirds, and the lines that cut the corners off at their midpoints [F02].
  void make_cubic(bool is_closed)
  {
    const std::size_t n = m_legs.size();
    std::vector<Leg> first(n), middle(n), last(n);
    for(std::size_t i = 0; i < n; ++i) {
      auto [third, rest] = divided(m_legs[i], 1.0 / 3);
      first[i] = std::move(third);
      std::tie(middle[i], last[i]) = divided(rest, 0.5);
    }
    std::vector<Leg> before(n), after(n); // the legs to and from the middle third of each leg
    before[0] = first[0];
    after[n - 1] = last[n - 1];
    for(std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i)
      std::tie(after[i], before[(i + 1) % n]) = divided(joined(last[i], first[(i + 1) % n]), 0.5);
    m_legs.clear();
    for(std::size_t i = 0; i < n; ++i) {
      m_legs.insert(m_legs.end(), {before[i], middle[i], after[i]});
      m_legs.back().ends_piece = true;
    }
  }

  internal::Path_straightener<Triangulation> m_straightener;
  internal::Polyline_measure<Triangulation> m_measure;
  std::vector<Leg> m_legs;
  double m_control_length = 0;
  Shortening_report m_report;
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds a curve that connects consecutive points of the surface. The points become vertices, at which the curve is
 * fixed.
 *
 * An open curve through two points is added as a shortest edge path, and a closed one as two such paths. A curve
 * through more points consists of *legs*, which connect consecutive points. Each leg is first shortened as if the other
 * points did not exist. The leg therefore passes every other point on the same side as a geodesic without obstacles
 * does. Afterwards, the edges that the legs cross are flipped.
 *
 * A leg that would cross a curve of the network remains an edge path; `order_overlapping_curves()` detects whether this
 * path crosses the curve.
 *
 * The initial length of the curve is the total length of the edge paths between consecutive points.
 *
 * \param network the network
 * \param locations a range of at least two points of the surface, of any type that `surface_location()` accepts; a
 *        location that coincides with the previous one is skipped. A closed curve need not repeat the first location
 * \param np the named parameter `is_closed`, a `bool`: whether the curve is closed; `false` by default
 * \return the index of the curve
 * \throws Invalid_curve_error if fewer than two points are given, or all points coincide
 * \throws Crossing_curves_error if legs cross each other between vertices; `elements()` returns the ends of the
 *         crossed edge. In this case no curve is added, but points may have become vertices, and edges may have been
 *         flipped
 * \throws Disconnected_endpoints_error if no edge path connects two consecutive points
 * \throws Vertex_out_of_range_error if a vertex is given that does not belong to the mesh or is isolated
 * \throws Invalid_location_error as `Edge_path_network::insert()` does
 * \throws Insertion_error as `Edge_path_network::insert()` does
 * \throws Occupied_triangulation_error as `Edge_path_network::insert()` does
 * \throws Degenerate_face_error as `shorten()` does
 * \throws Invalid_coordinate_error as `shorten()` does
 */
template <class Network, class LocationRange, class... NamedParameters>
Curve_index add_curve_through(Network& network, const LocationRange& locations, const NamedParameters&... np)
{
  const bool is_closed = internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...));
  auto& triangulation = network.triangulation();
  std::vector<Vertex_index> way_points;
  for(const Surface_location& location : internal::located_places(triangulation, locations))
    way_points.push_back(network.insert(location));
  const bool are_several = way_points.size() > 1;
  way_points.erase(std::unique(way_points.begin(), way_points.end()), way_points.end());
  while(is_closed && way_points.size() > 1 && way_points.front() == way_points.back())
    way_points.pop_back();
  if(way_points.size() < 2)
    throw Invalid_curve_error(are_several ? "all points of a curve coincide; the curve would be a single point"
                                          : "a curve requires at least two points");
  std::vector<std::vector<Halfedge_index>> paths;
  internal::Drawn_chain chain;
  double length = 0;
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < way_points.size(); ++i) {
    paths.push_back(
        shortest_intrinsic_edge_path(triangulation, way_points[i], way_points[(i + 1) % way_points.size()]));
    for(Halfedge_index h : paths.back())
      length += triangulation.length(h);
    chain.halfedges.insert(chain.halfedges.end(), paths.back().begin(), paths.back().end());
    chain.nodes.push_back(chain.halfedges.size() - 1);
  }
  if(way_points.size() > 2)
    chain = internal::Leg_drawer<Network>(network)(paths);
  const Curve_index curve = internal::add_chain(network, chain, is_closed);
  network.set_initial_length(curve, length);
  return curve;
}

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Adds a curve along given legs, which should be geodesics on the surface, such as the pieces of a `Geodesic_spline`,
 * or the legs of a `Curve_editor` or of `geodesics_through()`.
 *
 * The ends of the legs become vertices, at which the curve is fixed. The legs become edges of the triangulation; for
 * this purpose, the edges that the legs cross are flipped. A leg that is not a geodesic is replaced by a geodesic in
 * its homotopy class. A leg that would cross a curve of the network is replaced by an edge path near the leg;
 * `order_overlapping_curves()` detects whether this path crosses the curve.
 *
 * \param network the network
 * \param legs the legs. Each leg must start at the end of the previous leg. Any two consecutive points of a leg must
 *        lie in a common face of the input
 * \param np the named parameter `is_closed`, a `bool`: whether the curve is closed, that is, whether the last leg ends
 *        at the start of the first leg; `false` by default
 * \return the index of the curve
 * \pre in the faces through which the legs pass, no edge of the triangulation crosses an input edge
 * \throws Invalid_curve_error if a leg has fewer than two points, if two consecutive points do not lie in a common
 *         face, or if all legs are points
 * \throws Crossing_curves_error if legs cross each other between vertices; `elements()` returns the ends of the
 *         crossed edge. In this case no curve is added, but points may have become vertices, and edges may have been
 *         flipped
 * \throws Ambiguous_order_error if the search for the order of overlapping segments is aborted
 * \throws Invalid_location_error as `Edge_path_network::insert()` does
 * \throws Insertion_error as `Edge_path_network::insert()` does
 * \throws Occupied_triangulation_error as `Edge_path_network::insert()` does
 * \throws Degenerate_face_error as `shorten()` does
 * \throws Invalid_coordinate_error as `shorten()` does
 * \sa `draw_polyline()`, which preserves a polyline that is not a geodesic
 */
template <class Network, class... NamedParameters>
Curve_index add_curve_along(Network& network, const std::vector<std::vector<Surface_location>>& legs,
                            const NamedParameters&... np)
{
  const bool is_closed = internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...));
  auto& triangulation = network.triangulation();
  std::vector<internal::Surface_polyline> polylines;
  std::vector<Vertex_index> starts, ends; // before any path is found, since an insertion can split its edges
  for(const std::vector<Surface_location>& leg : legs) {
    polylines.push_back(internal::canonical_polyline(triangulation.input(), leg, false));
    starts.push_back(network.insert(leg.front()));
    ends.push_back(network.insert(leg.back()));
  }
  const internal::Path_straightener<typename Network::Triangulation> straightener(triangulation);
  std::vector<std::vector<Halfedge_index>> paths;
  for(std::size_t i = 0; i < legs.size(); ++i)
    paths.push_back(straightener.snapped(polylines[i], starts[i], ends[i]));
  return internal::add_chain(network, internal::Leg_drawer<Network>(network)(paths), is_closed);
}

/// \ingroup PkgFlipGeodesicsBuilders
/// Contains geodesics between consecutive points, each of them computed independently of the others.
struct Free_legs
{
  std::vector<std::vector<Surface_location>> legs; ///< the points of each leg: its ends and its crossings with edges
  Shortening_report report;                        ///< the report on all legs together, as one curve

  double length() const { return report.length(); }            ///< returns the total length of the legs
  Shortening_status status() const { return report.status(); } ///< returns the status of all legs together
  Verdict verdict() const { return report.verdict(); }         ///< returns the verdict on all legs together
};

namespace internal {

template <class Triangulation, class StopPredicate, class Visitor>
Free_legs geodesics_through(Triangulation& triangulation, const std::vector<Surface_location>& points,
                            const StopPredicate& stop, Visitor&& visitor)
{
  if(points.size() < 2)
    throw Invalid_curve_error("a path requires at least two points");
  Path_straightener<Triangulation> straightener(triangulation);
  Free_legs result;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& stop_on_leg = restarted(stop);
    const auto tighten = [&](Edge_path_network<Triangulation>& network) {
      return shorten(network, stop_on_leg, visitor);
    };
    result.legs.push_back(straightener.shortest(points[i], points[i + 1], tighten));
  }
  result.report = straightener.report();
  if(std::all_of(result.legs.begin(), result.legs.end(), is_point))
    result.report.curves.front() = report_of_point(triangulation);
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Computes geodesics, called *legs*, between consecutive points. Each leg is obtained by shortening a shortest edge
 * path.
 *
 * The triangulation is restored after each leg, so legs do not block one another. Unlike the legs of
 * `add_curve_through()`, they can cross one another; in this case, no triangulation has all legs as edges.
 *
 * A leg between two coincident points consists of that point twice. If all points coincide, the curve is a point, and
 * its status is `Shortening_status::CONTRACTED`.
 *
 * \param triangulation a triangulation of the input without flips and curves, which is unchanged afterwards
 * \param points a range of at least two points of the surface, of any type that `surface_location()` accepts
 * \param np the named parameters `stop_predicate` and `visitor` of `shorten()`, which are applied to each leg. If the
 *        predicate has a member `restarted()`, the result of that member is used for each leg
 * \return the legs, and a report
 * \throws Invalid_curve_error if fewer than two points are given
 * \throws Occupied_triangulation_error if a network has curves in the triangulation
 * \throws Disconnected_endpoints_error if no edge path connects two consecutive points
 * \throws Vertex_out_of_range_error if a vertex is given that does not belong to the mesh or is isolated
 * \throws Invalid_location_error as `Intrinsic_triangulation::insert()` does
 * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
 * \throws Degenerate_face_error as `shorten()` does
 * \throws Invalid_coordinate_error as `shorten()` does
 */
template <class Triangulation, class PointRange = std::vector<Surface_location>, class... NamedParameters>
Free_legs geodesics_through(Triangulation& triangulation, const PointRange& points, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal::Stop_parameter, internal_np::visitor_t>(np...);
  auto visitor = internal::make_visitor(options);
  return internal::geodesics_through(triangulation, internal::located_places(triangulation, points),
                                     internal::stop_predicate_of(options), visitor.get());
}

namespace internal {

/* Computes a geodesic through the points that `locate(triangulation)` returns, as called by `points_on_surface()`. */
template <class Form, class Triangulation, class TriangleMesh, class Locate, class NamedParameters>
Computed_output<Form> path_through_points(Triangulation& triangulation, const TriangleMesh& mesh, const Locate& locate,
                                          Located_points& given, const NamedParameters& np)
{
  const std::vector<Surface_location> points = points_on_surface(triangulation, locate, given);
  auto visitor = make_visitor(np);
  Free_legs path = geodesics_through(triangulation, points, stop_predicate_of(np), visitor.get());
  note_contraction(triangulation, path.report);
  path.report.curves.front().point_distances = given.distances;
  return {polyline_forms<Form>(triangulation, mesh, path.legs), std::move(path.report)};
}

/* Implements the computation of a geodesic through points; not inline, like `compute_path()`. */
template <class Form, class TriangleMesh, class NamedParameters>
Computed_output<Form> compute_path_through(const TriangleMesh& mesh,
                                           const Locate_points<TriangleMesh, NamedParameters>& locate,
                                           const NamedParameters& np)
{
  using Triangulation = typename Curve_types<TriangleMesh, NamedParameters>::Triangulation;
  Located_points given;
  return compute_on_surface(Mesh_surfaces(mesh, np), [&](Triangulation& triangulation) {
    return path_through_points<Form>(triangulation, mesh, locate, given, np);
  });
}

template <class TriangleMesh, class Locate, class OutputIterator, class NamedParameters>
Geodesic_result<OutputIterator> geodesic_through_located(const TriangleMesh& mesh, const Locate& locate,
                                                         OutputIterator out, const NamedParameters& np)
{
  using Form = Form_by_name<TriangleMesh, NamedParameters, OutputIterator>;
  return write_computed<Geodesic_result<OutputIterator>>(
      compute_path_through<Form, TriangleMesh, NamedParameters>(mesh, locate, np), out);
}

/* Implements `geodesic_path()` for ends that are not vertices; declared in its header. */
template <class TriangleMesh>
struct Path_between_points
{
  template <class Source, class Target, class OutputIterator, class NamedParameters>
  static Geodesic_result<OutputIterator> compute(const TriangleMesh& mesh, const Source& source, const Target& target,
                                                 OutputIterator out, const NamedParameters& np)
  {
    const auto locate = [&](const auto& triangulation) {
      return located_ends(triangulation, mesh, source, target, np);
    };
    return geodesic_through_located(mesh, locate, out, np);
  }
};

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a path through points anywhere on the surface. Between consecutive points, the path is a geodesic, that is,
 * a locally shortest path.
 *
 * The path leads from the first point to the last, and can have a corner at each point in between. It can cross itself.
 * A point that coincides with the previous one has no effect. If all points coincide, the path consists of a single
 * point.
 *
 * \param mesh a triangle mesh
 * \param locations a range of points, which are vertices of the mesh, `CGAL::Polygon_mesh_processing::Face_location`s,
 *        `Surface_location`s, or points in space. The documentation of `surface_location()` describes how points are
 *        snapped, and which point of the mesh represents a point in space
 * \param out an output iterator that receives the points of the path, in the form described at `geodesic_path()`
 * \param np an optional sequence of named parameters: those of `geodesic_path()`, and `greatest_point_distance`, the
 *        greatest distance from the surface at which a point in space is accepted. The stop predicate is applied
 *        separately to each part of the path between two consecutive points
 * \return the past-the-end output iterator, and a report with exactly one curve, for which
 *         `Curve_report::point_distances` is set
 * \throws Invalid_location_error if a location is not a point of the surface
 * \throws Distant_point_error if a point in space is too far from the surface
 * \throws Vertex_out_of_range_error as `geodesic_path()` does
 * \throws Invalid_curve_error if fewer than two points are given
 * \throws Disconnected_endpoints_error as `add_curve_through()` does
 * \throws Insertion_error as `add_curve_through()` does
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 */
template <class TriangleMesh, class LocationRange, class OutputIterator, class... NamedParameters>
Geodesic_result<OutputIterator> geodesic_path_through(const TriangleMesh& mesh, const LocationRange& locations,
                                                      OutputIterator out, const NamedParameters&... np)
{
  const auto& options = internal::curve_options<internal::Point_distance_parameter>(np...);
  const auto locate = [&](const auto& triangulation) {
    return internal::located(triangulation, mesh, locations, options);
  };
  return internal::geodesic_through_located(mesh, locate, out, options);
}

/*!
 * \ingroup PkgFlipGeodesicsFunctions
 *
 * Computes a geodesic spline \cgalCite{SC20,section 6.2}. The result consists of geodesics between the points at which
 * the pieces of a `Geodesic_spline` meet; these points lie on the spline. The control polygon and the spline can cross
 * themselves.
 *
 * \param mesh a triangle mesh
 * \param control_points a range of at least two points, as for `geodesic_path_through()`. A repeated point has a
 *        greater weight and attracts the curve
 * \param kind the type of the spline, a `Spline_kind`
 * \param out an output iterator that receives the points of the curve, in the form described at `geodesic_path()`
 * \param np an optional sequence of named parameters among those listed below, `vertex_point_map`, `metric` and
 *        `geom_traits` as for `geodesic_path()`, and `greatest_point_distance` as for `geodesic_path_through()`
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of rounds, in each of which every piece is subdivided at its midpoint}
 *     \cgalParamType{an integer from 0 to 30}
 *     \cgalParamDefault{5}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the past-the-end output iterator, and a report with exactly one curve
 * \throws Invalid_curve_error if fewer than two points are given, or fewer than three for a closed spline
 * \throws Invalid_parameter_error if the number of iterations is out of range
 * \throws Invalid_location_error if a location is not a point of the surface
 * \throws Distant_point_error if a point in space is too far from the surface
 * \throws Insertion_error as `Geodesic_spline` does
 * \throws Disconnected_endpoints_error as `Geodesic_spline` does
 * \throws Crossing_curves_error as `Geodesic_spline` does
 * \throws Ambiguous_order_error as `Geodesic_spline` does
 * \throws Vertex_out_of_range_error as `geodesic_path()` does
 * \throws Degenerate_face_error as `geodesic_path()` does
 * \throws Invalid_coordinate_error as `geodesic_path()` does
 * \throws Invalid_mesh_error as `geodesic_path()` does
 */
template <class TriangleMesh, class LocationRange, class Kind, class OutputIterator, class... NamedParameters>
Geodesic_result<OutputIterator> geodesic_spline(const TriangleMesh& mesh, const LocationRange& control_points,
                                                Kind kind, OutputIterator out, const NamedParameters&... np)
{
  const auto& options =
      internal::surface_options<internal_np::number_of_iterations_t, internal::Point_distance_parameter>(np...);
  static_assert(std::is_same<Kind, Spline_kind>::value, "a Spline_kind is expected here; the order of the arguments is "
                                                        "mesh, control points, kind, output, named parameters");
  using Types = internal::Curve_types<TriangleMesh, internal::Joined<NamedParameters...>>;
  using Form = internal::Curve_form<typename Types::Triangulation, OutputIterator>;
  const auto rounds =
      parameters::choose_parameter(parameters::get_parameter(options, internal_np::number_of_iterations), 5);
  static_assert(std::is_integral<std::remove_const_t<decltype(rounds)>>::value,
                "number_of_iterations() must be an integer");
  if(rounds < 0 || static_cast<std::uintmax_t>(rounds) > 30)
    throw Invalid_parameter_error("number_of_iterations is " + std::to_string(rounds) +
                                  ", but must be between 0 and 30 for a spline");
  const auto locate = [&](const auto& triangulation) {
    return internal::located(triangulation, mesh, control_points, options);
  };
  internal::Located_points given;
  const auto compute = [&](typename Types::Triangulation& triangulation) {
    const std::vector<Surface_location> points = internal::points_on_surface(triangulation, locate, given);
    Geodesic_spline<typename Types::Triangulation> spline(triangulation, points, kind);
    for(int i = 0; i < static_cast<int>(rounds); ++i)
      spline.refine();
    internal::Computed_output<Form> result = {internal::polyline_forms<Form>(triangulation, mesh, spline.finish()),
                                              spline.report()};
    internal::note_contraction(triangulation, result.report);
    result.report.curves.front().point_distances = given.distances;
    return result;
  };
  return internal::write_computed<Geodesic_result<OutputIterator>>(
      internal::compute_on_surface(internal::Mesh_surfaces(mesh, options), compute), out);
}

#ifdef CGAL_FLIP_GEODESICS_COMPILED
namespace internal {

#define CGAL_FLIP_GEODESICS_INSTANCES(Mesh, Form)                                                                      \
  CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_INSTANCE Computed_output<Form> compute_path_through(                       \
      const Mesh&, const Locate_points<Mesh, parameters::Default_named_parameters>&,                                   \
      const parameters::Default_named_parameters&);
CGAL_FLIP_GEODESICS_FOR_COMPILED_FORMS(CGAL_FLIP_GEODESICS_INSTANCES)
#undef CGAL_FLIP_GEODESICS_INSTANCES

} // namespace internal
#endif

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CURVES_THROUGH_POINTS_H
