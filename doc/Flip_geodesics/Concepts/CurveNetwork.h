// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `CurveNetwork` describes read access to a network of curves along the edges of an intrinsic
 * triangulation: the curves, their segments, and the order of the segments around each vertex. The algorithms that
 * require this concept are listed in Section \ref Flip_geodesicsAsked.
 *
 * A curve is a chain of segments; the end points of segments are called nodes. Each segment has its own `Segment_index`
 * and lies on a halfedge of the triangulation. Two consecutive segments of a curve form a joint, which has a left and a
 * right side. An object of type `Joint` identifies one side of a joint: it stores the side and the segment that arrives
 * at the joint. All segments on an edge are ordered from left to right, even if they belong to different curves. This
 * order, together with the cyclic order of the halfedges around a vertex, defines a cyclic order of all segment ends at
 * the vertex.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Edge_path_network<Triangulation>}
 * \cgalHasModelsEnd
 *
 * \sa `EdgePathGraph`
 */
class CurveNetwork
{
public:
  /// \name Types
  /// @{

  /// The triangulation: a model of `IntrinsicTriangulation`.
  typedef unspecified_type Triangulation;

  /// @}
  /// \name Curves
  /// @{

  /// Returns the triangulation that contains the curves. A model may return a non-`const` reference.
  const Triangulation& triangulation() const;

  /// Returns the number of curves, including those that have contracted to a point. Curves are numbered from 0, and a
  /// curve keeps its number when it contracts.
  Index number_of_curves() const;

  /// Returns whether the curve is a closed loop.
  bool is_closed(Curve_index curve) const;

  /// Returns whether the curve has contracted to a point and therefore has no segments.
  bool is_contracted(Curve_index curve) const;

  /// Returns the current length of a curve, or 0 if it has contracted.
  double length(Curve_index curve) const;

  /// Returns the initial length of a curve, to which stop predicates refer.
  double initial_length(Curve_index curve) const;

  /// Calls `function(s)` for each segment of a curve, in order.
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const;

  /// @}
  /// \name Segments
  /// @{

  /// Returns a number that is greater than the indices of all present and former segments.
  Index end_of_segment_ids() const;

  /// Returns the halfedge on which a segment lies, in the direction of the curve.
  Halfedge_index halfedge(Segment_index segment) const;

  /// Returns the curve that contains a segment.
  Curve_index curve(Segment_index segment) const;

  /// Returns the next segment of the curve, or `null_index` at the end of a path. In a loop of one segment, the result
  /// is the segment itself.
  Segment_index next(Segment_index segment) const;

  /// Returns whether the node at the head of a segment is fixed, that is, must not be moved. The end of a path is
  /// always fixed.
  bool is_head_fixed(Segment_index segment) const;

  /// Returns whether a segment of this network lies on the edge of halfedge `h`.
  bool is_occupied(Halfedge_index h) const;

  /// Returns the segments on edge `e`, from left to right as seen along the first halfedge of `e`.
  std::vector<Segment_index> bundle(Edge_index e) const;

  /// @}
  /// \name Joints
  /// @{

  /// Returns the two segment ends that meet at a joint. The wedge on the side `joint.side` extends clockwise from the
  /// first end to the second. \pre `next(joint.incoming)` is not `null_index`
  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const;

  /// Returns the next segment end of this network clockwise around the vertex of `end`. If the border of the surface,
  /// or an edge that only other networks hold, comes first, the result is a null end, for which
  /// `Segment_end::is_none()` returns `true`. Otherwise, if `end` is the only end at the vertex, the result is `end`.
  Segment_end next_clockwise(const Segment_end& end) const;

  /// Returns whether the curve turns back at a joint, with an empty wedge of angle zero on the side `joint.side`. The
  /// two ends at the joint then lie next to each other on one halfedge. The wedge on the other side of such a joint
  /// extends around the whole vertex; for this side, the result is `false`.
  /// \pre `next(joint.incoming)` is not `null_index`
  bool is_turning_back(const Joint& joint) const;

  /// @}
};
