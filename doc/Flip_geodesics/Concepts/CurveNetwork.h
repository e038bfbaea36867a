// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `CurveNetwork` describes read access to a network of curves along the edges of an intrinsic
 * triangulation: the curves, their segments, and the order of the segments around each vertex. This concept is required
 * by certification, the measurement of curves, extraction, subdivision, cutting, flattening, direction fields,
 * `edges_near_curves()` and `write_network()`.
 *
 * A curve is a chain of segments; the end points of segments are called nodes. Each segment has its own `Segment_index`
 * and lies on a halfedge of the triangulation. Two consecutive segments of a curve form a joint, which has a left and a
 * right side. An object of type `Joint` identifies one side of a joint: it stores the side and the segment that arrives
 * at the joint. Segments on the same edge are ordered from left to right, even if they belong to different curves. This
 * order and the cyclic order of the halfedges around a vertex define a cyclic order of all segment ends at the vertex.
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

  /// Returns the triangulation whose edges carry the curves. A model may return a non-`const` reference.
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

  /// Returns whether a segment lies on the edge of halfedge `h`.
  bool is_occupied(Halfedge_index h) const;

  /// Returns the segments on edge `e`, from left to right as seen along the first halfedge of `e`.
  std::vector<Segment_index> bundle(Edge_index e) const;

  /// @}
  /// \name Joints
  /// \pre `next(joint.incoming)` is not `null_index`
  /// @{

  /// Returns the two segment ends that meet at a joint, in such an order that the wedge on `joint.side` extends
  /// clockwise from the first end to the second.
  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const;

  /// Returns the next segment end clockwise around the same vertex. The result is the given end if there is no other
  /// end at the vertex. If the border of the surface or an edge held only by other networks comes first, the result is
  /// a null end, for which `Segment_end::is_none()` returns `true`.
  Segment_end next_clockwise(const Segment_end& end) const;

  /// Returns whether the curve turns back at a joint: the two ends at the joint are adjacent on one edge, and no face
  /// lies between them on `joint.side`. The wedge on this side has angle zero. A wedge that extends around the whole
  /// vertex also begins and ends at the same edge, but has a positive angle; for such a wedge, the result is `false`.
  bool is_turning_back(const Joint& joint) const;

  /// @}
};
