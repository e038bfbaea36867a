// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * A network of curves with what `shorten()` asks of it besides: what stands in the wedges of joints, and how a joint is
 * moved.
 *
 * A model never gives the index of a segment a second time, since indices wait in a queue while segments come and go.
 * It holds an edge of the triangulation, once, if and only if a segment lies there.
 *
 * The angle in a wedge does not change while its joint lives, since `shorten()` flips no occupied edge. But other ends
 * can come into the wedge, or leave it. Therefore `shorten()` queues each free wedge once, by its angle, and when its
 * turn comes asks again whether its two ends are still adjacent. It relies on `replace_joint()` to name all wedges that
 * may have become free.
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

  /// What `wedge()` returns: a class with the members `state`, a `Wedge_state`, and `turn`, a `Triangulation::Turn`,
  /// which is read if `state` is `Wedge_state::FREE` and then is the angle of the wedge.
  typedef unspecified_type Wedge;

  /// What `bundle_place()` returns; copyable.
  typedef unspecified_type Bundle_place;

  /// @}
  /// \name Curves
  /// @{

  /// The triangulation; `shorten()` flips its edges.
  Triangulation& triangulation() const;

  /// @}
  /// \name Segments
  /// @{

  /// Is there a segment with this index now, rather than in the past?
  bool is_alive(Segment_index segment) const;

  /// @}
  /// \name Joints
  /// \pre `next(joint.incoming)` is a segment
  /// @{

  /// What stands in the wedge of a joint. `Wedge_state::FREE` if and only if the joint is not fixed, and two conditions
  /// are met by its ends. The second is `next_clockwise()` of the first; so neither a border nor an edge that another
  /// network holds lies in between. And the angle from the first to the second is below \f$\pi\f$. No corner need be
  /// looked at beyond that angle.
  Wedge wedge(const Joint& joint) const;

  /// @}
  /// \name Moves
  /// @{

  /// Takes away the two segments of a joint and puts segments along `arc` into their place in the curve.
  ///
  /// `arc` is a chain of halfedges from the far node of the first end to the far node of the second. It has the wedge
  /// on its right, and is given in this direction for both sides. Each new segment comes to lie outermost on its edge
  /// on the side of the wedge. An empty arc is given if and only if the joint turns back. A closed curve of these two
  /// segments and an empty arc has contracted.
  ///
  /// Appends to `affected` both sides of each joint of which a new segment is a part, or which is new because an empty
  /// arc has joined its two segments. It also appends each joint whose two ends have become adjacent about a vertex
  /// because ends between them have gone. It may name more; wedges that are not free are dropped. It may leave out a
  /// side of which it is known that the angle is at least \f$\pi\f$. One is the wedge's side between two new segments.
  /// The other is the other side where the arc begins or ends, if the angle was so large before, since it has grown.
  ///
  /// \return the first new segment in the direction of the curve, `null_index` if there is none
  /// \pre the two segments differ, no edge in the wedge is held, and the arc bounds its faces; no angle on its right is
  ///      below \f$\pi\f$
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected);

  /// Replaces the one segment of a closed curve by two, along the other edges of the face on the left of `h`, which is
  /// the segment's halfedge or its twin. They come to lie outermost on their edges on the side of that face.
  /// \return the new segment that arrives at the old node
  /// \pre no segment lies on the two edges
  Segment_index perturb_loop(Segment_index segment, Halfedge_index h);

  /// Where the segment of a closed curve of one segment lies: what is needed to put it back.
  Bundle_place bundle_place(Segment_index segment) const;

  /// Replaces whatever a closed curve is now by the one segment that it was when `place` was taken.
  /// \return that segment, with a new index
  /// \pre all flips since then have been taken back, and no other curve has changed
  Segment_index restore_loop(Curve_index curve, const Bundle_place& place);

  /// @}
};
