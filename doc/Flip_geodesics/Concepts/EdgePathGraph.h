// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * A network of curves along the edges of an intrinsic triangulation, with what `shorten()` asks of it: which joints
 * there are, what stands in their wedges, and how a joint is moved.
 *
 * A curve is a chain of segments, each with a `Segment_index` of its own and on a halfedge of the triangulation. A
 * model never gives the index of a segment a second time, since indices wait in a queue while segments come and go. Two
 * consecutive segments of a curve form a joint, which has two sides; a `Joint` is the segment that arrives and a side.
 * Where segments of several curves, or one curve several times, lie on one edge, they have an order from left to
 * right. Together with the cyclic order of halfedges about a vertex this gives a cyclic order of all ends of segments
 * at the vertex.
 *
 * The angle in a wedge does not change while its joint lives, since `shorten()` flips no occupied edge; whether other
 * ends stand in the wedge does change. Therefore `shorten()` queues each free wedge once, by its angle, and when its
 * turn comes asks again whether its two ends are still adjacent. It relies on `replace_joint()` to name all wedges that
 * may have become free.
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

  /// The triangulation: a model of `IntrinsicTriangulation`.
  typedef unspecified_type Triangulation;

  /// What `wedge()` returns: a class with the members `state`, a `Wedge_state`, and `turn`, a `Triangulation::Turn`,
  /// which is read if `state` is `Wedge_state::FREE` and then is the angle of the wedge.
  typedef unspecified_type Wedge;

  /// What `stack_place()` returns; copyable.
  typedef unspecified_type Stack_place;

  /// @}
  /// \name Curves
  /// @{

  /// The triangulation whose edges the curves run along; `shorten()` flips its edges.
  Triangulation& triangulation() const;

  /// The number of curves; they are numbered from 0, and keep their numbers when they contract.
  Index number_of_curves() const;

  /// The length of a curve now, 0 if it has contracted.
  double length(Curve_index curve) const;

  /// The length that a curve had at first, to which stop predicates refer.
  double initial_length(Curve_index curve) const;

  /// Has the curve shrunk to a point, so that it has no segment?
  bool is_contracted(Curve_index curve) const;

  /// Calls `function(s)` for each segment of a curve, in order.
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const;

  /// @}
  /// \name Segments
  /// @{

  /// Is there a segment with this index now, rather than in the past?
  bool is_alive(Segment_index segment) const;

  /// The halfedge of a segment, in the direction of its curve.
  Halfedge_index halfedge(Segment_index segment) const;

  /// The curve that a segment belongs to.
  Curve_index curve(Segment_index segment) const;

  /// The next segment of the curve; `null_index` at the end of a path, the segment itself in a loop of one segment.
  Segment_index next(Segment_index segment) const;

  /// May the node at the head of a segment not be moved? So it is at the end of a path.
  bool is_head_fixed(Segment_index segment) const;

  /// Does a segment lie on the edge of halfedge `h`?
  bool is_occupied(Halfedge_index h) const;

  /// @}
  /// \name Joints
  /// \pre `next(joint.incoming)` is a segment
  /// @{

  /// The two ends of segments that meet in a joint, ordered so that the wedge on the joint's side lies clockwise from
  /// the first to the second.
  std::pair<Strand_end, Strand_end> ends(const Joint& joint) const;

  /// The next end of a segment clockwise about the same vertex, maybe after a whole turn the end itself;
  /// `Strand_end::is_none()` if the border of the surface comes first.
  Strand_end next_clockwise(const Strand_end& end) const;

  /// What stands in the wedge of a joint. `Wedge_state::FREE` if and only if the joint is not fixed, the second of its
  /// ends is the next one clockwise after the first, without a border in between, and the angle from the first to the
  /// second is below \f$\pi\f$. No corner need be looked at beyond that angle.
  Wedge wedge(const Joint& joint) const;

  /// Do the two ends lie side by side on one edge, with no face between them on the joint's side? The wedge of such a
  /// joint has the angle zero, unlike the one with the same edge on both sides that goes all the way round the vertex.
  bool is_turning_back(const Joint& joint) const;

  /// @}
  /// \name Moves
  /// @{

  /// Takes away the two segments of a joint and puts segments along `arc` into their place in the curve.
  ///
  /// `arc` is a chain of halfedges from the far node of the first end to the far node of the second, with the wedge on
  /// its right; it is given in this direction for both sides. Each new segment comes to lie outermost on its edge on
  /// the side of the wedge. An empty arc is given if and only if the joint turns back. A closed curve of these two
  /// segments and an empty arc has contracted.
  ///
  /// Appends to `affected` both sides of each joint of which a new segment is a part, or which is new because an empty
  /// arc has joined its two segments; and each joint whose two ends have become adjacent about a vertex because ends
  /// between them have gone. It may name more; wedges that are not free are dropped. It may leave out a side of which
  /// it is known that the angle is at least \f$\pi\f$: the wedge's side between two new segments, and the other side
  /// where the arc begins or ends, if the angle was so large before, since it has grown.
  ///
  /// \return the first new segment in the direction of the curve, `null_index` if there is none
  /// \pre the two segments differ, no end stands in the wedge, and the arc bounds its faces; no angle on its right is
  ///      below \f$\pi\f$
  Segment_index replace_joint(const Joint& joint, const std::vector<Halfedge_index>& arc, std::vector<Joint>& affected);

  /// Replaces the one segment of a closed curve by two, along the other edges of the face on the left of `h`, which is
  /// the segment's halfedge or its twin. They come to lie outermost on their edges on the side of that face.
  /// \return the new segment that arrives at the old node
  /// \pre no segment lies on the two edges
  Segment_index perturb_loop(Segment_index segment, Halfedge_index h);

  /// Where the segment of a closed curve of one segment lies: what is needed to put it back.
  Stack_place stack_place(Segment_index segment) const;

  /// Replaces whatever a closed curve is now by the one segment that it was when `place` was taken.
  /// \return that segment, with a new index
  /// \pre all flips since then have been taken back, and no other curve has changed
  Segment_index restore_loop(Curve_index curve, const Stack_place& place);

  /// @}
};
