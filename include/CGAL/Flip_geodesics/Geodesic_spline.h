// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H
#define CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// What the control points of a spline are the control points of.
enum class Spline_kind {
  BEZIER,                ///< one B&eacute;zier curve, of a degree one less than their number
  CUBIC_B_SPLINE,        ///< a uniform cubic B-spline that starts and ends at the first and last point
  CLOSED_CUBIC_B_SPLINE, ///< a closed uniform cubic B-spline, of at least three points
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * A chain of geodesic B&eacute;zier curves on the surface, made by de Casteljau's algorithm with geodesics for straight
 * lines [SC20, section 6.2; Morera, Velho, Carvalho, Computing Geodesic Curves on Triangular Meshes, 2008]. In the
 * plane the points where pieces meet are exactly those of the B&eacute;zier curve, up to rounding errors.
 *
 * Each leg of a control polygon is a geodesic by itself, in a triangulation that is put back for the next one. Legs may
 * therefore cross, pass over control points and over one another, and the control polygon may cross itself. A leg of
 * the next level is shortened from a path that leads from the middle of one leg over the control point to the middle of
 * the next: the curve stays in the homotopy class of the polygon. `add_curve_along()` makes the pieces of the finished
 * curve a curve of a network, and so edges of a triangulation.
 *
 * The invariant: each leg is a geodesic that starts where the one before ends; the triangulation is as it was.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Geodesic_spline
{
public:
  /*!
   * The spline with these control points, joined by shortest edge paths that are pulled straight.
   *
   * \param triangulation that of the input, without flips and curves; it has to live as long as the spline is refined
   * \param control_points at least two; a closed spline has at least three, and does not repeat the first. Points in a
   *        row may be in one place: the leg between them has length zero
   * \throws Invalid_curve_error for fewer points
   * \throws Occupied_triangulation_error if there are curves
   * \throws Invalid_location_error, Insertion_error, Disconnected_endpoints_error, and as `refine()`
   */
  Geodesic_spline(Triangulation& triangulation, const std::vector<Surface_location>& control_points, Spline_kind kind)
    : m_straightener(triangulation)
    , m_measure(triangulation)
  {
    const bool is_closed = kind == Spline_kind::CLOSED_CUBIC_B_SPLINE;
    if(control_points.size() < (is_closed ? 3u : 2u))
      throw Invalid_curve_error("a spline needs at least two control points, a closed one three");
    for(std::size_t i = 0; i + (is_closed ? 0 : 1) < control_points.size(); ++i)
      m_legs.push_back({m_straightener.shortest(control_points[i], control_points[(i + 1) % control_points.size()])});
    start(kind);
  }

  /*!
   * The spline with a control polygon whose legs are geodesics already, such as those of a `Curve_editor`: so the curve
   * stays in the polygon's class when control points are dragged.
   *
   * \param triangulation as above
   * \param legs each from where the one before ends, each two places in a row in one face; of a closed spline, the last
   *        ends where the first starts
   * \throws Invalid_curve_error for fewer than one leg, of a closed spline three, for legs of one place, and for
   *         places in a row in no common face
   * \throws Invalid_location_error, Insertion_error, and as `refine()`
   */
  Geodesic_spline(Triangulation& triangulation, const std::vector<std::vector<Surface_location>>& legs,
                  Spline_kind kind)
    : m_straightener(triangulation)
    , m_measure(triangulation)
  {
    if(legs.size() < (kind == Spline_kind::CLOSED_CUBIC_B_SPLINE ? 3u : 1u))
      throw Invalid_curve_error("a spline needs at least one leg, a closed one three");
    for(const std::vector<Surface_location>& leg : legs)
      m_legs.push_back({internal::canonical_polyline(triangulation.input(), leg, false)});
    start(kind);
  }

  /*!
   * Divides every piece at its middle, and so doubles their number.
   * \throws Insertion_error if the curve is divided more finely than numbers can tell
   * \throws Crossing_curves_error, Ambiguous_order_error if two legs in a row, taken together, cross themselves
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
   * Refines until a round changes the length of the control polygon by less than the `tolerance`-th part of it, at most
   * `most_rounds` times. The polygon becomes shorter by about a quarter as much with each round, so that the rest is a
   * third of the last change.
   * \return the number of rounds
   * \throws as `refine()`
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
   * Joins the points where pieces meet, which lie on the curve, by geodesics along their control polygons.
   * \return a polyline per piece, from where it starts to where it ends: where it crosses edges
   * \throws as `refine()`
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

  /// The length of the control polygons of all pieces.
  double polygon_length() const
  {
    double sum = 0;
    for(const Leg& leg : m_legs)
      sum += m_measure.length(leg.path);
    return sum;
  }

  /// What `finish()` has done, with the flips of all before. Its initial length is that of the first control polygon,
  /// its verdict that of all geodesics together.
  const Shortening_report& report() const { return m_report; }
  /// The length of the finished curve. \pre `finish()` has been called, as for the next two
  double length() const { return finished().length; }
  /// Whether the geodesics that the finished curve consists of are such.
  Shortening_status status() const { return finished().status; }
  /// The verdict on all of them together.
  Verdict verdict() const { return finished().verdict; }

private:
  const Curve_report& finished() const
  {
    CGAL_precondition(!m_report.curves.empty());
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

  // The geodesic from the start of a to the end of b, which starts where a ends.
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

  // From the legs of the control polygon.
  void start(Spline_kind kind)
  {
    if(kind == Spline_kind::BEZIER)
      m_legs.back().ends_piece = true;
    else
      make_cubic(kind == Spline_kind::CLOSED_CUBIC_B_SPLINE);
    m_control_length = polygon_length();
  }

  // Legs are divided into thirds, and the lines that cut the corners off at their middles [Farin].
  void make_cubic(bool is_closed)
  {
    const std::size_t n = m_legs.size();
    std::vector<Leg> first(n), middle(n), last(n);
    for(std::size_t i = 0; i < n; ++i) {
      auto [third, rest] = divided(m_legs[i], 1.0 / 3);
      first[i] = std::move(third);
      std::tie(middle[i], last[i]) = divided(rest, 0.5);
    }
    std::vector<Leg> before(n), after(n); // what leads to and from the middle third of each leg
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H
