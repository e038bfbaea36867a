// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `FlipOutStopPredicate` describes a predicate that can end a shortening early. `shorten()` keeps a
 * reference to it and calls it from one thread.
 *
 * The predicate is evaluated after the outcome of a step has been computed, but before the curve changes. Lengths
 * therefore never fall below the limit of a predicate, not even in a step in which a curve contracts to a point. If the
 * predicate rejects a step, the flips of the step are rolled back.
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
  /// Returns `Stop_decision::CONTINUE` to accept the step, and otherwise the reason for rejecting it.
  /// `Stop_decision::CURVE_LENGTH_LIMIT` keeps the curve of the step unchanged from now on, while other curves continue
  /// to be shortened. All other values except `Stop_decision::CONTINUE` end the shortening.
  Stop_decision operator()(const Shortening_step& step) const;

  /// (Optional) Returns a predicate of the same type in its initial state; for example, a restarted
  /// `Time_stop_predicate` starts its timer again. `geodesic_paths()`, `geodesics_through()` and
  /// `geodesic_path_through()` shorten several curves, one after the other or in several threads. They call this member
  /// before they shorten a curve, and evaluate the returned predicate for this curve. If this member is missing, the
  /// same predicate is evaluated for all curves.
  FlipOutStopPredicate restarted() const;
};
