// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * A predicate that ends a shortening early. `shorten()` keeps a reference to it and calls it from one thread.
 *
 * It is asked when the outcome of a step is known and before the curve is changed. So a limit on the length is never
 * overrun, not even by a step in which a curve collapses. If it objects, the flips of the step are taken back.
 *
 * A predicate that remembers something, as `Time_stop_predicate` does the time, may have a const member function
 * `restarted()`, which returns one of the same type that has forgotten it. Three functions pull several curves tight,
 * one after the other or in several threads: `geodesic_paths()`, `geodesics_through()` and `geodesic_path_through()`.
 * They then ask another predicate for each curve, made when its turn comes.
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
  /// Is the step to be taken, and if not, why? `Stop_decision::CURVE_LENGTH_LIMIT` leaves the step's curve as it is
  /// from now on, while the others go on; any other answer than `Stop_decision::CONTINUE` ends the shortening.
  Stop_decision operator()(const Shortening_step& step) const;
};
