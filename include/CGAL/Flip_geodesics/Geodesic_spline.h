// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H
#define CGAL_FLIP_GEODESICS_GEODESIC_SPLINE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Path_straightener.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/reports.h>
#include <CGAL/Flip_geodesics/surface_points.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsBuilders
/// Specifies the type of a spline.
enum class Spline_kind {
  BEZIER,                ///< a single B&eacute;zier curve, whose degree is one less than the number of control points
  CUBIC_B_SPLINE,        ///< a uniform cubic B-spline that starts and ends at the first and last point
  CLOSED_CUBIC_B_SPLINE, ///< a closed uniform cubic B-spline of at least three points
};

/*!
 * \ingroup PkgFlipGeodesicsBuilders
 *
 * Computes a chain of geodesic B&eacute;zier curves on the surface, by de Casteljau's algorithm with geodesics instead
 * of straight lines [SC20, section 6.2; Morera, Velho, Carvalho, Computing Geodesic Curves on Triangular Meshes, 2008].
 * In the plane, the points where pieces meet are exactly those of the B&eacute;zier curve, up to rounding errors.
 *
 * Each geodesic segment of a control polygon is shortened independently, in a triangulation that is restored for the
 * next one. Segments may therefore cross, pass over control points and over one another, and the control polygon may
 * cross itself. A segment of the next level is shortened from a path that leads from the midpoint of one segment over
 * the control point to the midpoint of the next, so the curve stays in the homotopy class of the polygon.
 * `add_curve_along()` turns the pieces of the finished curve into a curve of a network, and thus into edges of a
 * triangulation.
 *
 * The invariant is that each segment is a geodesic that starts at the end of the previous one, and that the
 * triangulation is unchanged.
 *
 * \tparam Triangulation a model of `IntrinsicTriangulationOfMesh`
 */
template <class Triangulation>
class Geodesic_spline
{
public:
  /*!
   * Constructs a spline from control points, which are connected by shortest edge paths that are then shortened.
   *
   * \param triangulation a triangulation of the input without flips and curves; it must not be destroyed while the
   *        spline is refined
   * \param control_points a range of at least two points of the surface, of any type that `surface_location()` takes; a
   *        closed spline has at least three and does not repeat the first. Consecutive points may coincide,
   *        so that the segment between them has length zero
   * \param kind the type of the spline
   * \throws Invalid_curve_error if fewer points are given
   * \throws Occupied_triangulation_error if a network has curves in the triangulation
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
   * Constructs a spline from a control polygon whose segments are already geodesics, such as those of a `Curve_editor`.
   * The curve thus stays in the homotopy class of the polygon while control points are dragged.
   *
   * \param triangulation a triangulation of the input without flips and curves; it must not be destroyed while the
   *        spline is refined
   * \param legs the segments, each starting at the end of the previous one, with two consecutive locations in one face;
   *        the last segment of a closed spline ends where the first starts
   * \param kind the type of the spline
   * \throws Invalid_curve_error if no segment is given, or fewer than three for a closed spline, if a segment has fewer
   *         than two locations, or if no face contains two consecutive locations
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
      throw Invalid_curve_error("a spline needs at least one leg, a closed one three");
    for(const std::vector<Surface_location>& leg : legs)
      m_legs.push_back({internal::canonical_polyline(triangulation.input(), leg, false)});
    start(kind);
  }

  /*!
   * Subdivides every piece at its midpoint, which doubles the number of pieces.
   * \throws Insertion_error if the curve is subdivided more finely than numbers can represent
   * \throws Crossing_curves_error if two consecutive segments, taken together, cross themselves
   * \throws Ambiguous_order_error if the search for an order of the overlapping parts of two consecutive segments is
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
   * Subdivides the pieces until a round changes the length of the control polygon by less than `tolerance` times that
   * length, at most `most_rounds` times. Each round shortens the polygon by about a quarter of the previous change, so
   * the remaining change is about a third of the last one.
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
   * Connects the points where pieces meet, which lie on the curve, by geodesics along their control polygons.
   * \return one polyline per piece, from its start to its end, which consists of the crossings of edges
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

  /// Returns the length of the control polygons of all pieces.
  double polygon_length() const
  {
    double sum = 0;
    for(const Leg& leg : m_legs)
      sum += m_measure.length(leg.path);
    return sum;
  }

  /// Returns the report on `finish()`, which includes the flips of all previous calls. Its initial length is that of
  /// the first control polygon, and its verdict is that of all geodesics together.
  const Shortening_report& report() const { return m_report; }
  /// Returns the length of the finished curve. \pre `finish()` has been called
  double length() const { return finished().length; }
  /// Returns whether the segments of the finished curve are geodesics. \pre `finish()` has been called
  Shortening_status status() const { return finished().status; }
  /// Returns the verdict on all segments of the finished curve together. \pre `finish()` has been called
  Verdict verdict() const { return finished().verdict; }

private:
  Geodesic_spline(const std::vector<Surface_location>& control_points, Triangulation& triangulation, Spline_kind kind)
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

  // Returns the geodesic from the start of a to the end of b, which starts at the end of a.
  Leg joined(const Leg& a, const Leg& b)
  {
    internal::Surface_polyline path = a.path;
    append(b.path, path);
    return {m_straightener.straightened(path)};
  }

  // De Casteljau: the outer halves of each level are the segments of the two halves.
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

  // Constructs the pieces from the segments of the control polygon.
  void start(Spline_kind kind)
  {
    if(kind == Spline_kind::BEZIER)
      m_legs.back().ends_piece = true;
    else
      make_cubic(kind == Spline_kind::CLOSED_CUBIC_B_SPLINE);
    m_control_length = polygon_length();
  }

  // Segments are divided into thirds, and the lines that cut the corners off at their midpoints [Farin].
  void make_cubic(bool is_closed)
  {
    const std::size_t n = m_legs.size();
    std::vector<Leg> first(n), middle(n), last(n);
    for(std::size_t i = 0; i < n; ++i) {
      auto [third, rest] = divided(m_legs[i], 1.0 / 3);
      first[i] = std::move(third);
      std::tie(middle[i], last[i]) = divided(rest, 0.5);
    }
    std::vector<Leg> before(n), after(n); // what leads to and from the middle third of each segment
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
