// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVE_EDITOR_H
#define CGAL_FLIP_GEODESICS_CURVE_EDITOR_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Leg_mover.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// Reports the effect of a move of a `Curve_editor`.
struct Move_report
{
  /// The number of recomputed legs: 1 or 2, or 0 if the path of `Curve_editor::move_along()` is a single point.
  std::size_t legs = 0;
  std::size_t legs_by_flips = 0;     ///< the number of recomputed legs that required edge flips
  Verdict verdict = Verdict::PROVEN; ///< the worst verdict on the recomputed legs
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Represents a chain of geodesics through points that can be moved one at a time: a path with its end points and
 * waypoints, or the control polygon of a spline.
 *
 * Each *leg*, the geodesic from one point to the next, is shortened independently, as by `geodesics_through()`, so legs
 * can cross each other. When a point is moved, each leg at this point is deformed continuously: the new leg is obtained
 * by shortening the concatenation of the old leg and the path of the move. All other legs remain bitwise identical.
 *
 * The running time of a move depends on the legs at the moved point, on the path of the move and, if this path is not
 * given, on the search for it. It does not depend on previous moves. A leg is unfolded along its edge sequence,
 * shortened with a funnel algorithm, and certified as by `certify()`, regardless of the traits. If the leg cannot be
 * certified, edges are flipped as by `shorten()`, and the flips are rolled back afterwards.
 *
 * The end points and the edge sequence of a leg determine the leg bitwise, regardless of the moves that led to it. If
 * each homotopy class contains only one geodesic, the leg depends only on its end points and on the homotopy class to
 * which the moves lead. This is the case on surfaces whose interior vertices have angle sums of at least \f$2\pi\f$. On
 * other surfaces, a class can contain several geodesics, and the moves determine which of them is obtained.
 *
 * The triangulation is unchanged after each call of a member function.
 *
 * \tparam Triangulation_ a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation_>
class Curve_editor
{
  using Leg = internal::Geodesic_leg;
  using Way = std::vector<internal::Way_step>;

public:
  using Triangulation = Triangulation_; ///< the type of the triangulation

  /*!
   * Constructs a curve. If two consecutive points lie in a common face, the initial path of their leg is a straight
   * line. Otherwise, the leg is obtained by shortening a nearly shortest edge path.
   *
   * \param triangulation a triangulation that has no curves and whose log of flips is empty; it must outlive the editor
   * \param points a range of at least two points of the surface, of any type that `surface_location()` accepts.
   *        Consecutive points must not coincide. For a closed curve, the first point must not be repeated at the end
   * \param np the named parameter `is_closed`, a `bool`: whether a leg connects the last point to the first; `false` by
   *        default
   * \throws Invalid_curve_error if there are fewer than two points, or two consecutive points coincide
   * \throws Invalid_location_error if a location is not a point of the surface
   * \throws Disconnected_endpoints_error if no edge path connects two consecutive points
   * \throws Occupied_triangulation_error if a network has curves in the triangulation
   * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
   * \throws Degenerate_face_error as `shorten()` does
   * \throws Invalid_coordinate_error as `shorten()` does
   */
  template <class PointRange = std::vector<Surface_location>, class... NamedParameters>
  Curve_editor(Triangulation& triangulation, const PointRange& points, const NamedParameters&... np)
    : m_triangulation(triangulation)
    , m_search(triangulation, parameters::search_method(Search_method::LOOK_BACK))
    , m_mover(triangulation)
    , m_is_closed(internal::is_closed_of(internal::options_of<internal::Closed_parameter>(np...)))
  {
    CGAL_precondition(triangulation.log_position() == 0);
    internal::check_has_no_curves(m_triangulation, "a curve cannot be edited");
    for(const Surface_location& p : internal::located_places(triangulation, points))
      m_points.push_back(placed(p));
    if(m_points.size() < 2)
      throw Invalid_curve_error("a curve to be edited requires at least two points");
    for(std::size_t i = 0; i < number_of_legs(); ++i) {
      const Surface_location &p = m_points[i], &q = m_points[(i + 1) % m_points.size()];
      Leg leg;
      leg.points = {p};
      m_legs.push_back(m_mover.moved(leg, false, way(p, q), q));
    }
  }

  /// \name Access
  /// @{

  /// Returns the number of points.
  std::size_t number_of_points() const { return m_points.size(); }
  /// Returns point `i` as a canonical location; see `Intrinsic_triangulation::location()`.
  const Surface_location& point(std::size_t i) const { return m_points[i]; }
  /// Returns whether a leg connects the last point to the first.
  bool is_closed() const { return m_is_closed; }
  /// Returns the number of legs; leg `i` leads from point `i` to the next one.
  std::size_t number_of_legs() const { return m_points.size() - (m_is_closed ? 0 : 1); }
  /// Returns the points of a leg: its ends, its crossings with edges, and the vertices through which it passes. Any two
  /// consecutive points lie in a common face. If a leg runs along a degenerate face, the positions of its crossings
  /// with the edges of this face can be ambiguous, and the sequence of points can go back and forth along the face. The
  /// length of the leg and the verdict on it do not depend on these positions.
  const std::vector<Surface_location>& leg(std::size_t i) const { return m_legs[i].points; }
  /// Returns the points of all legs, one leg after the other.
  std::vector<std::vector<Surface_location>> legs() const
  {
    std::vector<std::vector<Surface_location>> result;
    for(const Leg& leg : m_legs)
      result.push_back(leg.points);
    return result;
  }
  /// Returns the length of a leg.
  double length(std::size_t i) const { return m_legs[i].length; }
  /// Returns the length of the curve.
  double length() const
  {
    double sum = 0;
    for(const Leg& leg : m_legs)
      sum += leg.length;
    return sum;
  }
  /// Returns the verdict on a leg. The verdict is obtained by exact arithmetic from the coordinates or edge lengths of
  /// the input. If coordinates or lengths of the mesh had to be rounded, the verdict is `UNDECIDED`.
  Verdict verdict(std::size_t i) const { return verdict(m_legs[i]); }
  /// Returns the verdict on the curve, which is the worst verdict on its legs.
  Verdict verdict() const
  {
    Verdict worst = Verdict::PROVEN;
    for(const Leg& leg : m_legs)
      worst = (std::max)(worst, verdict(leg));
    return worst;
  }
  /// Returns how many filter failures of predicates have occurred since the construction, and how they were resolved.
  const Decision_statistics& statistics() const { return m_mover.statistics(); }

  /// @}
  /// \name Moves
  /// @{

  /*!
   * Moves a point.
   *
   * If the old and the new position of the point lie in a common face, the path of the move is a straight line.
   * Otherwise, the path follows a nearly shortest edge path between vertices of the faces that contain the two
   * positions.
   *
   * Dragging a point is a sequence of moves. The positions of the point determine the homotopy class of the path of the
   * drag if the distances between consecutive positions are smaller than the widths of the handles and holes near this
   * path.
   *
   * If an exception is thrown, the curve is unchanged.
   *
   * \param i the index of the point
   * \param to the new position
   * \return a report on the recomputed legs
   * \pre `i < number_of_points()`
   * \throws Invalid_curve_error if the new position coincides with the previous or the next point
   * \throws Invalid_location_error if `to` is not a point of the surface
   * \throws Disconnected_endpoints_error if no edge path connects the old and the new position
   * \throws Occupied_triangulation_error if a network has curves in the triangulation
   * \throws Crossing_curves_error if a leg requires flips, and its path crosses itself
   * \throws Ambiguous_order_error if a leg requires flips, and the search for the order of its overlapping segments is
   *         aborted
   * \throws Insertion_error as `Intrinsic_triangulation::insert()` does
   * \throws Degenerate_face_error as `shorten()` does
   * \throws Invalid_coordinate_error as `shorten()` does
   */
  template <class Point = Surface_location>
  Move_report move(std::size_t i, const Point& to)
  {
    CGAL_precondition(i < number_of_points());
    const Surface_location place = placed(internal::located_place(m_triangulation, to));
    return move(i, place, [&] { return way(m_points[i], place); });
  }

  /*!
   * Moves a point along a given path, which determines the homotopy classes of the legs at this point.
   * \param i the index of the point
   * \param way a range of points of any type that `surface_location()` accepts. The first point must be `point(i)`, and
   *        the last point is the new position. Any two consecutive points must lie in a common face
   * \return a report on the recomputed legs
   * \pre `i < number_of_points()`
   * \throws Invalid_curve_error if the path does not start at `point(i)`, if two consecutive points do not lie in a
   *         common face, or as `move()` does. If there is no common face, `elements()` returns the index of the second
   *         of the two points in the path
   * \throws Invalid_location_error as `move()` does
   * \throws Occupied_triangulation_error as `move()` does
   * \throws Crossing_curves_error as `move()` does
   * \throws Ambiguous_order_error as `move()` does
   * \throws Insertion_error as `move()` does
   * \throws Degenerate_face_error as `move()` does
   * \throws Invalid_coordinate_error as `move()` does
   */
  template <class PointRange = std::vector<Surface_location>>
  Move_report move_along(std::size_t i, const PointRange& way)
  {
    CGAL_precondition(i < number_of_points());
    std::vector<Surface_location> places;
    for(const Surface_location& p : internal::located_places(m_triangulation, way))
      places.push_back(placed(p));
    if(places.empty() || !is_same(places.front(), m_points[i]))
      throw Invalid_curve_error("the path along which a point is moved does not start at this point", {0});
    return move(i, places.back(), [&] { return steps(places); });
  }

  /// Returns the number of moves that `undo()` can undo.
  std::size_t number_of_moves() const { return m_moves.size(); }

  /// Undoes the last move. The previous legs are restored bitwise and are not recomputed. Returns whether there was a
  /// move to undo.
  bool undo()
  {
    if(m_moves.empty())
      return false;
    Move& move = m_moves.back();
    m_points[move.point] = move.from;
    for(auto& [i, leg] : move.legs)
      m_legs[i] = std::move(leg);
    m_moves.pop_back();
    return true;
  }

  /// Discards the history of moves, which frees the memory of the previous legs.
  void forget_moves() { m_moves.clear(); }

  /// @}

private:
  struct Move
  {
    std::size_t point;
    Surface_location from;
    std::vector<std::pair<std::size_t, Leg>> legs; // by number
  };

  template <class MakeWay>
  Move_report move(std::size_t i, const Surface_location& to, const MakeWay& make_way)
  {
    internal::check_has_no_curves(m_triangulation, "a curve cannot be edited");
    const std::size_t n = m_points.size();
    const bool has_next = m_is_closed || i + 1 < n, has_previous = m_is_closed || i > 0;
    const Way way = make_way();
    Move_report report;
    if(way.empty()) // the positions coincide
      return report;
    Move move = {i, m_points[i], {}};
    for(bool is_start : {false, true}) // the legs that end and start here
      if(is_start ? has_next : has_previous) {
        const std::size_t l = is_start ? i : (i + n - 1) % n;
        move.legs.push_back({l, m_mover.moved(m_legs[l], is_start, way, to)});
        const Leg& leg = move.legs.back().second;
        ++report.legs;
        report.legs_by_flips += leg.is_by_flips ? 1 : 0;
        report.verdict = (std::max)(report.verdict, verdict(leg));
      }
    m_moves.push_back(std::move(move)); // nothing can fail from here on
    m_points[i] = to;
    for(auto& [l, leg] : m_moves.back().legs)
      std::swap(m_legs[l], leg);
    return report;
  }

  Verdict verdict(const Leg& leg) const
  {
    return internal::is_input_rounded(m_triangulation) ? Verdict::UNDECIDED : leg.verdict;
  }

  // Returns the canonical location, with the same halfedge for a vertex every time.
  Surface_location placed(const Surface_location& location) const
  {
    const auto& input = m_triangulation.input();
    Surface_location result = internal::canonical_location(input, location);
    if(kind(result) == Location_kind::VERTEX)
      result.halfedge = input.outgoing(input.tail(result.halfedge));
    return result;
  }

  static bool is_same(const Surface_location& p, const Surface_location& q)
  {
    return p.halfedge == q.halfedge && p.weights == q.weights;
  }

  // Returns a straight line, or else a path along edges between the nearest vertices.
  Way way(const Surface_location& from, const Surface_location& to)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index face = internal::common_face(input, from, to);
    if(face != null_index)
      return {{from, face}};
    const Vertex_index v = internal::nearest_vertex(input, from), w = internal::nearest_vertex(input, to);
    Way result;
    if(kind(from) != Location_kind::VERTEX)
      result.push_back({from, from.halfedge});
    if(v != w)
      for(Halfedge_index h : m_search(v, w)) {
        const Input_halfedge_index edge = internal::as_input(h);
        result.push_back({m_triangulation.location(input.tail(edge)), internal::face_along(input, edge)});
      }
    if(kind(to) != Location_kind::VERTEX)
      result.push_back({m_triangulation.location(w), to.halfedge});
    return result;
  }

  Way steps(const std::vector<Surface_location>& places) const
  {
    Way result;
    for(std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Input_halfedge_index face = internal::common_face(m_triangulation.input(), places[k], places[k + 1]);
      if(face == null_index)
        internal::throw_naming<Invalid_curve_error>("point ", internal::Element{k + 1},
                                                    " of a path and the previous point do not lie in a common face");
      result.push_back({places[k], face});
    }
    return result;
  }

  Triangulation& m_triangulation;
  Shortest_edge_path<Triangulation> m_search;
  internal::Leg_mover<Triangulation> m_mover;
  std::vector<Surface_location> m_points;
  std::vector<Leg> m_legs;
  std::vector<Move> m_moves;
  bool m_is_closed;
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CURVE_EDITOR_H
