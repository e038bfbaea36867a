// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * A network of curves along the edges of an intrinsic triangulation, to be read: which curves there are, what segments
 * they have, and in which order these lie about a vertex. Nothing is said of how they come there or move. It is what
 * certificates, measuring, extraction, subdivision, cutting, flattening, direction fields, `edges_near_curves()` and
 * `write_network()` ask for.
 *
 * A curve is a chain of segments, each with a `Segment_index` of its own and on a halfedge of the triangulation. Two
 * consecutive segments of a curve form a joint, which has two sides; a `Joint` is the segment that arrives and a side.
 * Where segments of several curves, or one curve several times, lie on one edge, they have an order from left to
 * right. Together with the cyclic order of halfedges about a vertex this gives a cyclic order of all ends of segments
 * at the vertex.
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

  /// The triangulation whose edges the curves run along. It may be handed out without `const`.
  const Triangulation& triangulation() const;

  /// The number of curves; they are numbered from 0, and keep their numbers when they contract.
  Index number_of_curves() const;

  /// Is the curve a loop without ends?
  bool is_closed(Curve_index curve) const;

  /// Has the curve shrunk to a point, so that it has no segment?
  bool is_contracted(Curve_index curve) const;

  /// The length of a curve now, 0 if it has contracted.
  double length(Curve_index curve) const;

  /// The length that a curve had at first, to which stop predicates refer.
  double initial_length(Curve_index curve) const;

  /// Calls `function(s)` for each segment of a curve, in order.
  template <class Function>
  void for_each_segment(Curve_index curve, Function function) const;

  /// @}
  /// \name Segments
  /// @{

  /// A number above those of all segments that there are or have been.
  Index end_of_segment_ids() const;

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

  /// The segments on an edge, from left to right as seen along its first halfedge.
  std::vector<Segment_index> bundle(Edge_index e) const;

  /// @}
  /// \name Joints
  /// \pre `next(joint.incoming)` is a segment
  /// @{

  /// The two ends of segments that meet in a joint, ordered so that the wedge on the joint's side lies clockwise from
  /// the first to the second.
  std::pair<Segment_end, Segment_end> ends(const Joint& joint) const;

  /// The next end of a segment clockwise about the same vertex, maybe after a whole turn the end itself. It is
  /// `Segment_end::is_none()` if the border of the surface, or an edge that only other networks hold, comes first.
  Segment_end next_clockwise(const Segment_end& end) const;

  /// Do the two ends lie side by side on one edge, with no face between them on the joint's side? The wedge of such a
  /// joint has the angle zero. The one that goes all the way round the vertex has the same edge on both sides, too, but
  /// not that angle.
  bool is_turning_back(const Joint& joint) const;

  /// @}
};
