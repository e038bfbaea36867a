// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `EdgePathGraph` refines `CurveNetwork` by the additional requirements of `shorten()`: the state of the
 * wedges of joints, and the operations that move a joint.
 *
 * A model must never reuse the index of a removed segment, since the queue of `shorten()` can still contain this index.
 * A model must place exactly one hold on each edge of the triangulation on which at least one of its segments lies, and
 * none on other edges.
 *
 * The angle of a wedge is constant as long as its joint exists, since `shorten()` does not flip occupied edges. The
 * queue, which orders free wedges by their angles, is therefore never reordered. Since segments can enter or leave a
 * wedge, however, `shorten()` verifies that the two ends of the joint are still adjacent before it processes a queued
 * wedge, and relies on `replace_joint()` to report every wedge that can have become free.
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

  /// The result of `wedge()`: a class with the members `state`, a `Wedge_state`, and `turn`, a `Triangulation::Turn`.
  /// If `state` is `Wedge_state::FREE`, then `turn` is the angle of the wedge; otherwise `turn` is not read.
  typedef unspecified_type Wedge;

  /// The result of `bundle_place()`; copyable.
  typedef unspecified_type Bundle_place;

  /// @}
  /// \name Curves
  /// @{

  /// Returns the triangulation, whose edges `shorten()` flips.
  Triangulation& triangulation() const;

  /// @}
  /// \name Segments
  /// @{

  /// Returns whether a segment with this index exists now. Indices of removed segments are allowed.
  bool is_alive(Segment_index segment) const;

  /// @}
  /// \name Joints
  /// \pre `next(joint.incoming)` is a segment
  /// @{

  /// Returns the state and the angle of the wedge of a joint. The state is `Wedge_state::FREE` if and only if the joint
  /// is not fixed, the second of its ends is `next_clockwise()` of the first, and the angle between the two ends is
  /// less than \f$\pi\f$. The second condition implies that neither a border nor an edge held by another network lies
  /// between the ends. A model need not examine further corners once the angle has reached \f$\pi\f$.
  Wedge wedge(const Joint& joint) const;

  /// @}
  /// \name Moves
  /// @{

  /// Replaces the two segments of a joint by segments along `arc`.
  ///
  /// `arc` is a chain of halfedges. It leads from the other node of the segment whose end is `ends(joint).first` to the
  /// other node of the segment whose end is `ends(joint).second`. The wedge lies on the right of the arc; for the right
  /// side of a joint, the arc therefore leads against the direction of the curve. Each new segment becomes the
  /// outermost one on its edge, on the side of the wedge. The arc is empty if and only if `is_turning_back(joint)`. In
  /// this case, a closed curve that consists of only these two segments contracts to a point.
  ///
  /// The function appends to `affected` both sides of each new joint. A joint is new if it contains a new segment, or
  /// if its two segments have become consecutive because the arc is empty. The function also appends each joint whose
  /// two ends have become adjacent around a vertex because the ends between them were removed. A model may append
  /// further joints, since `shorten()` ignores wedges that are not free. A model may omit a side whose angle is known
  /// to be at least \f$\pi\f$. Two kinds of sides are known to have such an angle: at a joint between two new segments,
  /// the side of the wedge; and at a joint at either end of the arc, the side opposite to the wedge, if its angle was
  /// at least \f$\pi\f$ before the move, since the move enlarges this angle.
  ///
  /// \return the first new segment in the direction of the curve, or `null_index` if the arc is empty
  /// \pre The two segments differ, no edge inside the wedge is held, the arc bounds the faces of the wedge, and at each
  ///      inner vertex of the arc, the angle on the right of the arc is at least \f$\pi\f$.
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected);

  /// Replaces the only segment of a closed curve by two segments along the other two edges of the face on the left of
  /// `h`, where `h` is the halfedge of the segment or the twin of that halfedge.
  /// \return the new segment that arrives at the old node
  /// \pre No segments lie on these two edges.
  Segment_index perturb_loop(Segment_index segment, Halfedge_index h);

  /// Returns the position of the only segment of a closed curve among the segments of its edge, in the form that
  /// `restore_loop()` requires.
  Bundle_place bundle_place(Segment_index segment) const;

  /// Replaces the present segments of a closed curve by a single segment, at the position that the only segment of the
  /// curve had when `bundle_place()` returned `place`.
  /// \return the new segment, which has a new index
  /// \pre All flips since that call of `bundle_place()` have been rolled back, and no other curve has changed since.
  Segment_index restore_loop(Curve_index curve, const Bundle_place& place);

  /// @}
};
