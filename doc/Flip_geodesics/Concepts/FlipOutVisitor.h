// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * An observer of a shortening, for progress, interruption and animation. `shorten()` calls its members from one
 * thread; an exception that one of them throws passes through `shorten()`, and leaves valid curves, none longer than
 * before.
 *
 * `flip_to_delaunay()`, `refine()` and `Geodesic_tree::grow()` take a visitor as well, and call the first two members;
 * `refine()` takes a `RefinementVisitor`. `Geodesic_distance_field::compute()`, `Logarithmic_map`,
 * `geodesic_distance_matrix()`, `make_shortest()` and `shortest_paths_by_class()` call only the first one. `geodesic_distances()` and
 * `logarithmic_map()` do so too, unless they grow a tree. Each of these functions has a status for a computation that
 * is stopped; nothing is confirmed then, no output is written, and objects remain usable.
 *
 * Other long computations call only `go_further()`, too, at regular intervals. Each returns what the following table
 * says if it is stopped, and is not asked again; a caller can also ask the visitor.
 *
 * | computation | result if it is stopped |
 * |---|---|
 * | `Shortest_edge_path`, `shortest_halfedges_through()`, `shortest_loop()` | no halfedges |
 * | the search for the edge path of `geodesic_path()`, `geodesic_paths()`, `add_shortest_path()` | no path, and the status `Shortening_status::STOPPED_BY_VISITOR` |
 * | `Landmark_distances`, `Geodesic_landmarks`, `geodesic_landmarks()` | `is_complete()` returns `false`; all bounds are zero |
 * | `Loop_basis` | `is_complete()` returns `false`; there are no loops |
 * | `handle_and_tunnel_loops()`, `add_cut_graph()` | no loops, no curves |
 * | `isolines()`, `voronoi_boundaries()` | no output |
 *
 * `shorten_cut_graph()` and `geodesic_loop_basis()` consist of several shortenings. None of these takes a step once one
 * of them has been stopped.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Default_shortening_visitor}
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
  /// Called before each step. If it returns `false`, then the shortening ends, and the curves that could still be
  /// shortened have the status `Shortening_status::STOPPED_BY_VISITOR`. `geodesic_paths()` calls it before each pair of
  /// vertices as well, and searches, distance fields and computations of loops, landmarks and isolines call it at
  /// regular intervals, about once for a thousand steps of a microsecond or less.
  bool go_further();

  /// Called after the edge of halfedge `h` was flipped, before the step moves its curve. There is no call for flips
  /// that are taken back with a step that is not taken; compare `triangulation.log_position()` to see it.
  template <class Triangulation>
  void on_flip(const Triangulation& triangulation, Halfedge_index h);

  /// Called after a step, when a curve has become shorter. The unit that shortens a loop of one segment is one step.
  template <class Network>
  void after_flip_out(const Network& network, Curve_index curve);
};
