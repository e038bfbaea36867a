// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `FlipOutVisitor` describes an observer of a shortening. A visitor can report progress, stop the
 * shortening, or record an animation. `shorten()` calls the members of the visitor from a single thread. If a member
 * throws an exception, `shorten()` passes the exception on to its caller; the curves are then valid, and none of them
 * is longer than before the call.
 *
 * `flip_to_delaunay()`, `refine()` and `Geodesic_tree::grow()` also take a visitor, and call `go_further()` and
 * `on_flip()`; the visitor of `refine()` must be a model of `RefinementVisitor`. Of the required members,
 * `Geodesic_distance_field::compute()`, `Logarithmic_map`, `geodesic_distance_matrix()`, `make_shortest()` and
 * `shortest_paths_by_class()` call only `go_further()`. `geodesic_distances()` and `logarithmic_map()` call
 * `go_further()` and, if they grow a tree, `on_flip()`.
 *
 * If the visitor stops one of these functions, the report of the function states this, and all objects remain valid. A
 * stopped function does not write output, except for `geodesic_loop_basis()`.
 *
 * The computations in the following table call only `go_further()`, at regular intervals. After `go_further()` has
 * returned `false`, they do not call it again, and return the following results:
 *
 * | computation | result if it is stopped |
 * |---|---|
 * | the search for a path with `Shortest_edge_path`, `shortest_halfedges_through()`, `shortest_loop()` | no halfedges |
 * | the search for the edge path in `geodesic_path()`, `geodesic_paths()`, `add_shortest_path()` | no path, and the status `Shortening_status::STOPPED_BY_VISITOR` |
 * | `Landmark_distances`, `Geodesic_landmarks`, `geodesic_landmarks()` | `is_complete()` returns `false`; all bounds are zero |
 * | `Loop_basis` | `is_complete()` returns `false`; the basis is empty |
 * | `handle_and_tunnel_loops()` | no loops |
 * | `add_cut_graph()` | no curves |
 * | `isolines()`, `voronoi_boundaries()` | no output |
 *
 * `shorten_cut_graph()` and `geodesic_loop_basis()` shorten curves several times. After the visitor has stopped one of
 * these shortenings, the remaining shortenings do not take any steps; `geodesic_loop_basis()` then writes the loops
 * without shortening them further.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Default_shortening_visitor}
 * \cgalHasModels{CGAL::Flip_geodesics::Time_stop_predicate}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::shorten()`
 * \sa `CGAL::Flip_geodesics::shortest_paths_by_class()`
 * \sa `CGAL::Flip_geodesics::Geodesic_distance_field`
 * \sa `CGAL::Flip_geodesics::Shortest_edge_path`
 * \sa `CGAL::Flip_geodesics::Loop_basis`
 */
class FlipOutVisitor
{
public:
  /// Returns whether the computation should continue. `shorten()` calls this member before each step. If the result is
  /// `false`, the shortening ends, and the curves that could still be shortened have the status
  /// `Shortening_status::STOPPED_BY_VISITOR`. `geodesic_paths()` also calls this member before it processes each pair
  /// of end points. Searches, distance fields, and the computations of loops, landmarks and isolines call this member
  /// about once per thousand of their own steps, which is usually at least once per millisecond.
  bool go_further();

  /// (Optional) Is called by `geodesic_distance_matrix()` before each call of `go_further()`. The argument is the
  /// fraction of rows that are complete, a number from 0 to 1.
  void on_progress(double fraction);

  /// Is called after the edge of halfedge `h` has been flipped. During a shortening, the edges in the wedge of a joint
  /// are flipped before the joint is moved. This member is not called when the flips of a rejected step are rolled
  /// back; a visitor can detect a rollback only by `triangulation.log_position()`.
  template <class Triangulation>
  void on_flip(const Triangulation& triangulation, Halfedge_index h);

  /// Is called after a step has shortened a curve. The compound step that shortens a loop of one segment
  /// (\ref Flip_geodesicsUnit) counts as one step.
  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve);
};
