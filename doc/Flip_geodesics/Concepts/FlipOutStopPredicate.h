// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `FlipOutStopPredicate` describes a predicate that can end a shortening early. `shorten()` evaluates the
 * predicate from a single thread.
 *
 * Before a step takes effect, `shorten()` computes the outcome of the step and evaluates the predicate. If the
 * predicate rejects the step, `shorten()` rolls the step back. A predicate can therefore keep lengths from falling
 * below a limit, even if the next step would contract a curve to a point.
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
  /// `Stop_decision::CURVE_LENGTH_LIMIT`, the curve of the step no longer changes, but other curves are still
  /// shortened. Any other reason ends the shortening of all curves.
  Stop_decision operator()(const Shortening_step& step) const;

  /// (Optional) Returns a predicate of the same type in its initial state; for example, `Time_stop_predicate` restarts
  /// its timer. The functions `geodesic_paths()`, `geodesics_through()` and `geodesic_path_through()` shorten several
  /// curves. Before they shorten a curve, they call this member; during the shortening of this curve, they evaluate the
  /// returned predicate. If this member is missing, these functions evaluate the same predicate for all curves.
  FlipOutStopPredicate restarted() const;
};
