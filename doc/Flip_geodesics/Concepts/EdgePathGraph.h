// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `EdgePathGraph` refines `CurveNetwork`. It adds the requirements of `shorten()`: the state of the wedge
 * on each side of a joint, and the operations that move a joint.
 *
 * A model must never reuse the index of a removed segment, since the queue of `shorten()` can still contain this index.
 * A model must place exactly one hold on each edge of the triangulation on which one or more of the segments lie, and
 * no holds on other edges.
 *
 * The angle of a wedge is constant as long as its joint exists, since `shorten()` does not flip occupied edges. The
 * queue, which orders free wedges by their angles, is therefore never reordered. However, segments can enter or leave a
 * wedge. Before `shorten()` processes a queued wedge, it therefore verifies that the two ends of the joint are still
 * adjacent. Conversely, `replace_joint()` must report every wedge that can have become free.
 *
 * \cgalRefines{CurveNetwork}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Edge_path_network<Triangulation>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::shorten()`
 */
class EdgePathGraph
{
public:
  /// \name Types
  /// @{

  /// The type of the result of `wedge()`: a class with the members `Wedge_state state` and `Triangulation::Turn turn`.
  /// If `state` is `Wedge_state::FREE`, then `turn` is the angle of the wedge; otherwise `turn` is not read.
  typedef unspecified_type Wedge;

  /// The type of the result of `bundle_place()`, which must be copyable.
  typedef unspecified_type Bundle_place;

  /// @}
  /// \name Curves
  /// @{

  /// Returns the triangulation, whose edges `shorten()` flips.
  Triangulation& triangulation() const;

  /// @}
  /// \name Segments
  /// @{

  /// Returns whether a segment with this index currently exists. The argument may be the index of a removed segment.
  bool is_alive(Segment_index segment) const;

  /// @}
  /// \name Joints
  /// \pre `next(joint.incoming)` is not `null_index`
  /// @{

  /// Returns the state and the angle of the wedge of a joint. Let `e` be `ends(joint)`. The state is
  /// `Wedge_state::FREE` if and only if the joint is not fixed, `next_clockwise(e.first)` is `e.second`, and the angle
  /// between the two ends is less than \f$\pi\f$. The second condition implies that neither a border nor an edge held
  /// by another network lies between the ends. A model need not examine further corners once the angle has reached
  /// \f$\pi\f$.
  Wedge wedge(const Joint& joint) const;

  /// @}
  /// \name Moves
  /// @{

  /// Replaces the two segments of a joint by segments along `arc`.
  ///
  /// Let `e` be `ends(joint)`. `arc` is a chain of halfedges from the far node of the segment with end `e.first` to the
  /// far node of the segment with end `e.second`. The far node of a segment is the node opposite to the joint. The
  /// wedge lies on the right of the arc; if `joint.side` is the right side, the arc therefore leads against the
  /// direction of the curve. Each new segment becomes the outermost segment of its edge on the side of the wedge.
  ///
  /// The arc is empty if and only if `is_turning_back(joint)` is `true`. In this case, a closed curve that consists of
  /// only these two segments contracts to a point.
  ///
  /// The function appends to `affected` both sides of each new joint. A joint is new if it contains a new segment, or
  /// if its two segments have become consecutive because the arc is empty. The function also appends each joint whose
  /// two ends have become adjacent around a vertex because the ends between them were removed. A model may append
  /// further joints, since `shorten()` ignores wedges that are not free.
  ///
  /// A model may omit a side if its angle is known to be at least \f$\pi\f$. This is known for the side of the wedge at
  /// each joint between two new segments. At the joints at both ends of the arc, it is known for the side opposite to
  /// the wedge if the angle of this side was at least \f$\pi\f$ before the move, since the move enlarges this angle.
  ///
  /// \return the first new segment in the direction of the curve, or `null_index` if the arc is empty
  /// \pre The two segments differ, and no edge inside the wedge is held. The arc bounds the faces of the wedge; at each
  ///      inner vertex of the arc, the angle on the right is at least \f$\pi\f$.
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected);

  /// Replaces the only segment of a closed curve by two segments along the other two edges of the face on the left of
  /// `h`. The halfedge `h` must be the halfedge of the segment or its twin.
  /// \return the new segment that arrives at the old node
  /// \pre No segments lie on the other two edges of the face.
  Segment_index perturb_loop(Segment_index segment, Halfedge_index h);

  /// Returns the position of the only segment of a closed curve among the segments of its edge, in the form that
  /// `restore_loop()` requires.
  Bundle_place bundle_place(Segment_index segment) const;

  /// Replaces the segments of a closed curve by a single segment. The new segment has the position that the only
  /// segment of the curve had when `bundle_place()` returned `place`.
  /// \return the new segment, which has a new index
  /// \pre All flips since that call of `bundle_place()` have been rolled back, and no other curve has changed since
  /// that call.
  Segment_index restore_loop(Curve_index curve, const Bundle_place& place);

  /// @}
};
