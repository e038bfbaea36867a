// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `EdgePathGraph` refines `CurveNetwork`. It adds the requirements of `shorten()`: the state of the wedge
 * on each side of a joint, and the operations that move a joint.
 *
 * `shorten()` keeps the free wedges in a queue, ordered by their angles. A model must not reuse the index of a removed
 * segment while a shortening is in progress, since the queue can still contain this index. `replace_joint()` must
 * report every wedge that may have become free. It need not report wedges that are no longer free, since `shorten()`
 * examines each wedge again when it is taken from the queue.
 *
 * A model must place exactly one hold on each edge of the triangulation on which its segments lie, and no holds on
 * other edges.
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
  /// @{

  /// Returns the state and the angle of the wedge of a joint. Let `e` be `ends(joint)`. The state is
  /// `Wedge_state::FREE` if and only if the node of the joint is not fixed, `next_clockwise(e.first)` is `e.second`,
  /// and the angle of the wedge is less than \f$\pi\f$. The second condition implies that neither the border nor an
  /// edge held by another network lies inside the wedge. A model need not examine further corners once the angle has
  /// reached \f$\pi\f$. \pre `next(joint.incoming)` is not `null_index`
  Wedge wedge(const Joint& joint) const;

  /// @}
  /// \name Moves
  /// @{

  /// Replaces the two segments of a joint by segments along `arc`.
  ///
  /// Let `e` be `ends(joint)`. `arc` is a chain of halfedges from the far node of the segment with end `e.first` to the
  /// far node of the segment with end `e.second`. The far node of a segment is the node at its other end. The wedge
  /// lies on the right of the arc; if `joint.side` is the right side, the arc therefore leads against the direction of
  /// the curve. Each new segment becomes the outermost segment of its edge on the side of the wedge.
  ///
  /// The arc is empty if and only if `is_turning_back(joint)` is `true`. In this case, a curve that consists of only
  /// these two segments contracts to a point.
  ///
  /// The function appends to `affected` both sides of each new joint, except as stated below. A joint is new if it
  /// contains a new segment, or if its two segments have become consecutive because the arc is empty. The function also
  /// appends every other `Joint` (side of a joint) whose wedge has become free because the segment ends inside it were
  /// removed. A model may append further sides, since `shorten()` ignores wedges that are not free.
  ///
  /// A model may omit a side if the angle on this side is known to be at least \f$\pi\f$. At the joints between two new
  /// segments, this is known for the side opposite to `joint.side`. At the joints at the two ends of the arc, it is
  /// known for the side opposite to `joint.side` if the angle on this side was at least \f$\pi\f$ before the move,
  /// since the move enlarges this angle.
  ///
  /// \return the first new segment in the direction of the curve, or `null_index` if the arc is empty
  /// \pre The joint consists of two different segments, and no edge inside the wedge is held. The arc bounds the faces
  ///      of the wedge; at each inner vertex of the arc, the angle on the right is at least \f$\pi\f$.
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected);

  /// Replaces the only segment of a closed curve by two segments along the other two edges of the face on the left of
  /// `h`. The halfedge `h` must be the halfedge of the segment or its twin.
  /// \return the new segment that arrives at the node of the former segment
  /// \pre No segments lie on the other two edges of the face.
  Segment_index perturb_loop(Segment_index segment, Halfedge_index h);

  /// Returns the position that `segment`, the only segment of a closed curve, has among the segments on its edge. The
  /// result can be passed to `restore_loop()`.
  Bundle_place bundle_place(Segment_index segment) const;

  /// Replaces the segments of a closed curve by a single segment. The new segment has the position that the only
  /// segment of the curve had when `bundle_place()` returned `place`.
  /// \return the new segment, which has a new index
  /// \pre All flips since that call of `bundle_place()` have been rolled back, and no other curve has changed since
  /// that call.
  Segment_index restore_loop(Curve_index curve, const Bundle_place& place);

  /// @}
};
