// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicTriangulation` describes a triangulation of a surface. The edges of the triangulation are
 * straight on the surface, and can be flipped. Section \ref Flip_geodesicsAsked lists the algorithms that require this
 * concept.
 *
 * The elements are identified by the classes `Vertex_index`, `Halfedge_index` and `Edge_index`, and are numbered from
 * 0. The edge with number `e` has the halfedges `2e` and `2e+1`. A triangulation is a \f$\Delta\f$-complex: edges from
 * a vertex to itself, several edges between two vertices, and faces that are glued to themselves are allowed. Every
 * face is a triangle and lies on the left of its halfedges; a border halfedge has no face. The surface is oriented. It
 * is manifold, except that a model of `IntrinsicTriangulationOfMesh` may have non-manifold vertices.
 *
 * If `Traits::Has_drift` is `CGAL::Tag_true`, the library measures finished curves and trees on the input mesh, and
 * recomputes inaccurate faces from the input mesh. In this case, `shorten()`, `Geodesic_tree` and `flip_to_delaunay()`
 * require `IntrinsicTriangulationOfMesh`.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Intrinsic_triangulation<TriangleMesh\,Traits\,Metric>}
 * \cgalHasModelsEnd
 *
 * \sa `IntrinsicTriangulationOfMesh`
 * \sa `EdgePathGraph`
 */
class IntrinsicTriangulation
{
public:
  /// \name Types
  /// @{

  /// A model of `IntrinsicTriangulationTraits`. Algorithms that require only `IntrinsicTriangulation` use, of these
  /// traits, only the types `Turn` and `Has_drift` and the functor `Turn_key`.
  typedef unspecified_type Traits;

  /// The type `Traits::Turn`.
  typedef unspecified_type Turn;

  /// A model of `IntrinsicTriangulationWalker`: a handle that stores the position of a halfedge in memory, so that
  /// walks of many steps are fast. The type must be copyable, assignable, and comparable by `==` and `!=`.
  typedef unspecified_type Walker;

  /// An integer type for positions in the log of flips.
  typedef unspecified_type Log_position;

  /// @}
  /// \name Elements
  /// @{

  /// Returns the number of vertices.
  Index number_of_vertices() const;
  /// Returns the number of halfedges, which is twice the number of edges.
  Index number_of_halfedges() const;
  /// Returns the number of edges.
  Index number_of_edges() const;

  /// Returns the opposite halfedge.
  static Halfedge_index twin(Halfedge_index h);
  /// Returns the edge of a halfedge.
  static Edge_index edge(Halfedge_index h);
  /// Returns the next halfedge around the face on the left of `h`. \pre `h` is not on the border
  Halfedge_index next(Halfedge_index h) const;
  /// Returns the previous halfedge around the face on the left of `h`. \pre `h` is not on the border
  Halfedge_index previous(Halfedge_index h) const;
  /// Returns the vertex at which `h` starts.
  Vertex_index tail(Halfedge_index h) const;
  /// Returns the vertex at which `h` ends.
  Vertex_index head(Halfedge_index h) const;
  /// Returns whether `h` has no face on its left.
  bool is_border(Halfedge_index h) const;
  /// Returns the next halfedge clockwise around the tail of `h`, or `null_index` if the border comes first.
  Halfedge_index clockwise(Halfedge_index h) const;
  /// Returns the next halfedge counterclockwise around the tail of `h`, or `null_index` if the border comes first.
  Halfedge_index counterclockwise(Halfedge_index h) const;
  /// Returns a halfedge that starts at `v`, or `null_index` for an isolated vertex.
  Halfedge_index outgoing(Vertex_index v) const;
  /// Prefetches the face on the left of `h`. The library calls this function for faces that it will read soon. A model
  /// may leave the function empty.
  void prefetch_face(Halfedge_index h) const;

  /// @}
  /// \name Geometry
  /// @{

  /// Returns the traits.
  const Traits& traits() const;
  /// Returns the length of the edge of `h`, rounded.
  double length(Halfedge_index h) const;
  /// Adds to `turn` the corner on the right of `h` at the tail of `h`, and returns `clockwise(h)`. If the result is
  /// `null_index`, `turn` is unchanged.
  Halfedge_index extend_turn_clockwise(Turn& turn, Halfedge_index h) const;
  /// Returns whether `turn`, the angle clockwise around a vertex from `from` to `to`, is at least \f$\pi\f$. If `to`
  /// equals `from`, `turn` is the total angle at the vertex.
  /// \pre `turn` consists of at least one corner; without its last corner, its angle is at most \f$\pi\f$
  bool is_straight(const Turn& turn, Halfedge_index from, Halfedge_index to) const;
  /// Returns whether the edge of `h` is locally Delaunay, that is, whether it is on the border or the two angles
  /// opposite to it add up to at most \f$\pi\f$.
  bool is_locally_delaunay(Halfedge_index h) const;

  /// @}
  /// \name Flips
  /// @{

  /// Returns whether the edge of `h` can be flipped. An edge can be flipped if it is neither on the border nor held, if
  /// it is the diagonal of a strictly convex quadrilateral, and if each of its end vertices has another edge.
  bool is_flippable(Halfedge_index h) const;
  /// Flips the edge of `h`. If `(h, hn, hp)` and `(t, tn, tp)` are the faces on its two sides, the new faces are
  /// `(h, hp, tn)` and `(t, tp, hn)`. \pre `is_flippable(h)`
  void flip(Halfedge_index h);
  /// Returns the position of the end of the log. The log grows with each flip.
  Log_position log_position() const;
  /// Rolls back flips in reverse order until the log ends at `position`. This restores the former connectivity and
  /// geometry bitwise. The halfedges that `outgoing()` returns may differ from the former ones.
  void rollback(Log_position position);
  /// Returns the size of the records of flips, in bytes. `Memory_stop_predicate` compares this size with its limit.
  std::size_t memory_of_records() const;

  /// @}
  /// \name Held edges
  /// Each network places exactly one hold on every edge on which it has segments. Held edges are not flipped, neither
  /// by `shorten()` nor by `flip_to_delaunay()`.
  /// @{

  /// Returns the number of holds on an edge, initially 0.
  Index holds(Edge_index e) const;
  /// Adds a hold.
  void hold(Edge_index e);
  /// Releases a hold. \pre `holds(e) > 0`
  void release(Edge_index e);
  /// Returns the total number of holds on all edges.
  std::size_t number_of_holds() const;
  /// Returns a number that is greater than `Walker::edge_place()` for every edge that a walker has visited.
  std::size_t number_of_edge_places() const;

  /// @}
  /// \name Walkers
  /// @{

  /// Returns a walker at `h`.
  Walker walker(Halfedge_index h) const;
  /// Returns a walker at `h`, given the `place()` of a walker at `h` or at the twin of `h`.
  Walker walker(Walker::Place place, Halfedge_index h) const;
  /// Returns whether the two faces of the edge of `h` together have an angle of at least \f$\pi\f$ at the head of `h`.
  /// \pre both faces exist
  bool is_reflex_at_head(const Walker& h) const;

  /// @}
};
