// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `FlipOutStopPredicate` describes a predicate that can end a shortening early. `shorten()` evaluates the
 * predicate from a single thread.
 *
 * For each step, `shorten()` computes the lengths after the step, and evaluates the predicate with them. If the
 * predicate rejects the step, the step is not taken. A predicate can therefore keep lengths from falling below a limit,
 * even if the next step would contract a curve to a point.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Never_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Length_ratio_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Curve_length_ratio_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Angle_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Iteration_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Time_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Memory_stop_predicate}
 * \cgalHasModels{CGAL::Flip_geodesics::Any_stop_predicate<Predicates...>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::shorten()`
 */
class FlipOutStopPredicate
{
public:
  /// Returns `Stop_decision::CONTINUE` to accept the step, and otherwise the reason for rejecting it. If the result is
  /// `Stop_decision::CURVE_LENGTH_LIMIT`, the curve of the step is not shortened further, but other curves are. Any
  /// other reason ends the shortening of all curves.
  Stop_decision operator()(const Shortening_step& step) const;

  /// (Optional) Returns a predicate of the same type in its initial state; for example, the result for a
  /// `Time_stop_predicate` has a new timer. `geodesic_paths()` calls this member once for each path, and
  /// `geodesics_through()` and `geodesic_path_through()` call it once for each leg. The returned predicate is evaluated
  /// for this path or leg. If this member is missing, the same predicate is evaluated for all paths or legs.
  FlipOutStopPredicate restarted() const;
};
