// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `FlipOutStopPredicate` describes a predicate that ends a shortening early. `shorten()` keeps a reference
 * to it and calls it from one thread.
 *
 * The predicate is evaluated when the outcome of a step is known and before the curve changes. A limit on the length is
 * therefore never exceeded, not even by a step in which a curve collapses. If the predicate rejects the step, its flips
 * are rolled back.
 *
 * A predicate with state, such as `Time_stop_predicate` with its start time, may have a const member function
 * `restarted()` that returns a predicate of the same type in its initial state. The functions that shorten several
 * curves separately, possibly in several threads, then evaluate a restarted copy for each curve. These are
 * `geodesic_paths()`, `geodesics_through()` and `geodesic_path_through()`. Without this member, they use one predicate
 * for all curves.
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
  /// Returns whether the step is taken, and otherwise the reason for rejecting it. `Stop_decision::CURVE_LENGTH_LIMIT`
  /// keeps the curve of the step unchanged from now on, while other curves continue to be shortened. All other values
  /// except `Stop_decision::CONTINUE` end the shortening.
  Stop_decision operator()(const Shortening_step& step) const;
};
