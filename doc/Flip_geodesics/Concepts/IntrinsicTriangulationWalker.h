// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicTriangulationWalker` describes a handle to a halfedge of an `IntrinsicTriangulation`. Most
 * of its members return information about the halfedge, or walkers at neighboring halfedges.
 *
 * \sa `IntrinsicTriangulation`
 */
class IntrinsicTriangulationWalker
{
public:
  /// The position of an edge in memory. The type must be default constructible and copyable.
  typedef unspecified_type Place;

  /// Returns the halfedge.
  Halfedge_index index() const;
  /// Returns the position of the edge.
  Place place() const;
  /// Returns whether the walker has reached the border and therefore has no halfedge.
  bool is_none() const;

  /// Returns the vertex at which the halfedge starts.
  Vertex_index tail() const;
  /// Returns a walker at the opposite halfedge.
  IntrinsicTriangulationWalker twin() const;
  /// Returns a walker at the previous halfedge around the face on the left. \pre the halfedge is not on the border
  IntrinsicTriangulationWalker previous() const;
  /// Returns a walker at the next halfedge clockwise around the tail, or, if the border comes first, a walker without a
  /// halfedge.
  IntrinsicTriangulationWalker clockwise() const;
  /// Returns a walker at the next halfedge counterclockwise around the tail, or, if the border comes first, a walker
  /// without a halfedge.
  IntrinsicTriangulationWalker counterclockwise() const;

  /// Returns the length of the edge.
  double length() const;
  /// Prefetches the face on the left. The library calls this function for faces that it will read soon.
  void prefetch_face() const;
  /// Adds to `turn` the corner on the right of the halfedge at its tail, and returns `clockwise()`. If the result has
  /// no halfedge, `turn` is unchanged.
  IntrinsicTriangulationWalker extend_turn_clockwise(Turn& turn) const;

  /// Returns a number that identifies the edge, and that never changes. The library uses this number as an index into
  /// arrays of edge data. A model can return the number of the edge, or number the edges in the order in which walkers
  /// first visit them; the latter keeps the arrays short.
  std::size_t edge_place() const;
  /// Returns whether the edge is held.
  bool is_held() const;
  /// Adds a hold to the edge.
  void hold() const;
  /// Releases a hold on the edge.
  void release() const;
};
