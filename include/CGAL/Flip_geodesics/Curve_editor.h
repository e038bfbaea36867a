// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CURVE_EDITOR_H
#define CGAL_FLIP_GEODESICS_CURVE_EDITOR_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Leg_mover.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/internal/triangulation/spokes.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/shortest_edge_path.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// What a move of a `Curve_editor` did.
struct Move_report
{
  std::size_t legs = 0;              ///< the legs that were pulled tight, one or two
  std::size_t legs_by_flips = 0;     ///< those of them for which edges were flipped, as words did not suffice
  Verdict verdict = Verdict::PROVEN; ///< what is said of them; the worst
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * A curve through points of the surface that can be moved: its ends, way points, control points. Each leg, from one
 * point to the next, is a geodesic by itself, as with `geodesics_through()`; so legs may cross. When a point moves,
 * each leg at it goes on in its homotopy class: it is the geodesic that the leg, and the way of the move behind it, are
 * pulled tight to. The other legs stay, bit for bit, and `undo()` takes moves back.
 *
 * A leg is kept as the sequence of edges that it crosses. So a move takes time for the legs at the point, however many
 * there have been: about as much as reading them off, times the rows of vertices that they sweep. The leg is unfolded
 * and pulled taut like a string, and proven a geodesic in the manner of `certify()`, whatever the traits. Only where that
 * fails, edges are flipped, as by `shorten()`, and flipped back.
 *
 * A leg depends on its ends and on the edges that it crosses, bit for bit. It does not depend on the moves that led to
 * it. Where a class has one geodesic, as on surfaces whose vertices have \f$2\pi\f$ or more, it does not depend on
 * moves at all but through the class. On others a class can have several geodesics, and a leg stays with the one it is
 * pulled to.
 *
 * The invariant: each leg starts where the one before ends, and is a geodesic if `verdict()` says so; the triangulation
 * is as it was.
 *
 * \tparam Triangulation_ a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation_>
class Curve_editor
{
  using Leg = internal::Geodesic_leg;
  using Way = std::vector<internal::Way_step>;

public:
  using Triangulation = Triangulation_; ///< the template parameter

  /*!
   * A curve whose legs are short paths of edges, pulled tight.
   *
   * \param triangulation that of the input, without flips and curves; it has to outlive the editor, and is as it was
   *        after each call
   * \param points at least two, no two in a row in one place; a closed curve does not repeat the first
   * \param is_closed does a leg lead from the last point to the first?
   * \throws Invalid_curve_error for fewer points, or two in a row in one place
   * \throws Invalid_location_error, Disconnected_endpoints_error, Occupied_triangulation_error
   * \throws as `Intrinsic_triangulation::insert()`, `shorten()`
   */
  Curve_editor(Triangulation& triangulation, const std::vector<Surface_location>& points, bool is_closed = false)
    : m_triangulation(triangulation)
    , m_search(triangulation, Search_method::LOOK_BACK)
    , m_mover(triangulation)
    , m_is_closed(is_closed)
  {
    CGAL_precondition(triangulation.log_position() == 0);
    internal::check_has_no_curves(m_triangulation, "a curve cannot be edited");
    if(points.size() < 2)
      throw Invalid_curve_error("a curve to be edited needs two points");
    for(const Surface_location& p : points)
      m_points.push_back(placed(p));
    for(std::size_t i = 0; i < number_of_legs(); ++i) {
      const Surface_location &p = m_points[i], &q = m_points[(i + 1) % m_points.size()];
      Leg leg;
      leg.points = {p};
      m_legs.push_back(m_mover.moved(leg, false, way(p, q), q));
    }
  }

  /// \name What there is
  /// @{

  /// The number of points.
  std::size_t number_of_points() const { return m_points.size(); }
  /// Point `i`, as canonical location: see `Intrinsic_triangulation::location()`.
  const Surface_location& point(std::size_t i) const { return m_points[i]; }
  /// Does a leg lead from the last point to the first?
  bool is_closed() const { return m_is_closed; }
  /// The number of legs; leg `i` leads from point `i` to the next one.
  std::size_t number_of_legs() const { return m_points.size() - (m_is_closed ? 0 : 1); }
  /// The points of a leg: its ends, and where it crosses edges and passes vertices. Each two in a row lie in one face.
  /// Where a leg runs along a face without area, a crossing can be told at another place of its edge, so that points go
  /// to and fro; length and verdict are those of the leg all the same.
  const std::vector<Surface_location>& leg(std::size_t i) const { return m_legs[i].points; }
  /// The points of all legs, one after the other.
  std::vector<std::vector<Surface_location>> legs() const
  {
    std::vector<std::vector<Surface_location>> result;
    for(const Leg& leg : m_legs)
      result.push_back(leg.points);
    return result;
  }
  /// The length of a leg.
  double length(std::size_t i) const { return m_legs[i].length; }
  /// The length of the curve.
  double length() const
  {
    double sum = 0;
    for(const Leg& leg : m_legs)
      sum += leg.length;
    return sum;
  }
  /// What is said of a leg, by the exact numbers of the input. A leg that is no geodesic is one that needs flips and
  /// crosses itself, or one that the traits were not exact enough for.
  /// Nothing is certified if coordinates or lengths of the mesh are not doubles.
  Verdict verdict(std::size_t i) const { return verdict(m_legs[i]); }
  /// The verdict on the curve: the worst one of its legs.
  Verdict verdict() const
  {
    Verdict worst = Verdict::PROVEN;
    for(const Leg& leg : m_legs)
      worst = (std::max)(worst, verdict(leg));
    return worst;
  }
  /// How the comparisons of all certificates were decided.
  const Decision_statistics& statistics() const { return m_mover.statistics(); }

  /// @}
  /// \name Moves
  /// @{

  /*!
   * Moves a point. Where both places lie in one face, the way there is a straight line. Else it is a short path of
   * edges between vertices of their faces. So the points of a pen give the class of the pen's way, if they lie closer
   * than what it goes round.
   *
   * If anything is thrown, nothing has changed.
   *
   * \throws Invalid_curve_error if the point comes to lie where the one before or after it does
   * \throws Invalid_location_error, Disconnected_endpoints_error, Occupied_triangulation_error
   * \throws Crossing_curves_error, Ambiguous_order_error where a leg needs flips, and its path crosses itself
   * \throws as `Intrinsic_triangulation::insert()`, `shorten()`
   * \pre `i < number_of_points()`
   */
  Move_report move(std::size_t i, const Surface_location& to)
  {
    CGAL_precondition(i < number_of_points());
    const Surface_location place = placed(to);
    return move(i, place, [&] { return way(m_points[i], place); });
  }

  /*!
   * Moves a point along a way, which says in which class its legs go on.
   * \param way `point(i)`, and on from there, each two in a row in one face; the last is where it goes
   * \throws Invalid_curve_error also for a way that starts elsewhere, or has two places in a row in no common face; the
   *         element is the number of the place on the way
   * \throws as `move()`
   * \pre `i < number_of_points()`
   */
  Move_report move_along(std::size_t i, const std::vector<Surface_location>& way)
  {
    CGAL_precondition(i < number_of_points());
    std::vector<Surface_location> places;
    for(const Surface_location& p : way)
      places.push_back(placed(p));
    if(places.empty() || !is_same(places.front(), m_points[i]))
      throw Invalid_curve_error("the way of a point starts where the point is not", {0});
    return move(i, places.back(), [&] { return steps(places); });
  }

  /// The number of moves that `undo()` can take back.
  std::size_t number_of_moves() const { return m_moves.size(); }

  /// Takes the last move back, bit for bit, in the time that it takes to hand over the legs. Returns false if there is
  /// none.
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

  /// Forgets all moves, and so frees the memory of the legs as they were before each.
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
    if(way.empty()) // one place
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
    m_moves.push_back(std::move(move)); // what can fail is done
    m_points[i] = to;
    for(auto& [l, leg] : m_moves.back().legs)
      std::swap(m_legs[l], leg);
    return report;
  }

  Verdict verdict(const Leg& leg) const
  {
    return internal::is_input_rounded(m_triangulation) ? Verdict::UNDECIDED : leg.verdict;
  }

  // Canonical, and a vertex by the same halfedge always.
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

  // Straight, or else along edges between the nearest vertices.
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
        throw Invalid_curve_error("place " + std::to_string(k + 1) + " of a way lies in no face with the one before",
                                  {k + 1});
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CURVE_EDITOR_H
