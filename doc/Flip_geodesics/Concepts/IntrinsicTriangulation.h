// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * An intrinsic triangulation: vertices joined by straight edges in a surface, which can be flipped. It is what
 * `Edge_path_network`, `shorten()`, `Shortener`, `order_overlapping_curves()`, `halfedges_through()`,
 * `flip_to_delaunay()`, `is_delaunay()`, `edges_near_curves()`, `Geodesic_tree`, `intrinsic_faces()`, `Operators` and
 * what is solved by them ask for. \ref Flip_geodesicsAsked has the whole table.
 *
 * Its descriptors are the classes `Vertex_index`, `Halfedge_index` and `Edge_index`, numbered from 0. An edge with
 * number `e` has the halfedges `2e` and `2e+1`. A triangulation is a \f$\Delta\f$-complex: there may be loops, several
 * edges between two vertices, and faces that are glued to themselves. Faces are triangles, and lie on the left of their
 * halfedges; a border halfedge has none. The surface is oriented and a manifold.
 *
 * Where `Traits::Has_drift` is `CGAL::Tag_true`, finished curves and trees are measured from the input, and faces laid
 * out afresh; `shorten()`, `Geodesic_tree` and `flip_to_delaunay()` then ask for `IntrinsicTriangulationOfMesh`.
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

  /// A model of `IntrinsicTriangulationTraits`. The algorithms use its types `Turn` and `Has_drift`, and its functor
  /// `Turn_key`.
  typedef unspecified_type Traits;

  /// `Traits::Turn`.
  typedef unspecified_type Turn;

  /// A halfedge, held by where the triangulation keeps it: for walks of many steps. Copyable, assignable, compared by
  /// `==` and `!=`. The members of a walker are below.
  typedef unspecified_type Walker;

  /// A position in the log of flips, an integer.
  typedef unspecified_type Log_position;

  /// @}
  /// \name Elements
  /// @{

  /// The number of vertices.
  Index number_of_vertices() const;
  /// The number of halfedges, twice that of edges.
  Index number_of_halfedges() const;
  /// The number of edges.
  Index number_of_edges() const;

  /// The other side of the edge.
  static Halfedge_index twin(Halfedge_index h);
  /// The edge of a halfedge.
  static Edge_index edge(Halfedge_index h);
  /// The next halfedge of the face. \pre `h` is not on the border
  Halfedge_index next(Halfedge_index h) const;
  /// The previous halfedge of the face. \pre `h` is not on the border
  Halfedge_index previous(Halfedge_index h) const;
  /// The vertex at which `h` starts.
  Vertex_index tail(Halfedge_index h) const;
  /// The vertex at which `h` ends.
  Vertex_index head(Halfedge_index h) const;
  /// Has `h` no face on its left?
  bool is_border(Halfedge_index h) const;
  /// The next halfedge clockwise about the tail, `null_index` where the border intervenes.
  Halfedge_index clockwise(Halfedge_index h) const;
  /// The next halfedge counterclockwise about the tail, `null_index` where the border intervenes.
  Halfedge_index counterclockwise(Halfedge_index h) const;
  /// A halfedge that starts at `v`, `null_index` at an isolated vertex.
  Halfedge_index outgoing(Vertex_index v) const;
  /// Says that the face on the left of `h` will be read soon. It may do nothing.
  void prefetch_face(Halfedge_index h) const;

  /// @}
  /// \name Geometry
  /// @{

  /// The traits.
  const Traits& traits() const;
  /// The length of the edge of `h`, rounded.
  double length(Halfedge_index h) const;
  /// Adds to a turn the corner on the right of `h` at its tail, and returns `clockwise(h)`; where that is `null_index`,
  /// nothing is added.
  Halfedge_index extend_turn_clockwise(Turn& turn, Halfedge_index h) const;
  /// Is the turn, which leads clockwise from `from` to `to` about a vertex, at least \f$\pi\f$?
  bool is_straight(const Turn& turn, Halfedge_index from, Halfedge_index to) const;
  /// Is the edge of `h` on the border, or are the angles opposite to it together at most \f$\pi\f$?
  bool is_locally_delaunay(Halfedge_index h) const;

  /// @}
  /// \name Flips
  /// @{

  /// Can the edge of `h` be flipped: not on the border, not held, in a convex quad, and the only edge at neither of its
  /// ends?
  bool is_flippable(Halfedge_index h) const;
  /// Flips the edge of `h`. With the faces `(h, hn, hp)` and `(t, tn, tp)` on its two sides, the new faces are
  /// `(h, hp, tn)` and `(t, tp, hn)`. \pre `is_flippable(h)`
  void flip(Halfedge_index h);
  /// The end of the log: it grows with each flip.
  Log_position log_position() const;
  /// Takes flips back, the last first, until the log ends at `position`; bit for bit.
  void rollback(Log_position position);
  /// The bytes that the records of flips take, for `Memory_stop_predicate`.
  std::size_t memory_of_records() const;

  /// @}
  /// \name Held edges
  /// Each network holds the edges on which it has segments, once each. What flips edges, as `shorten()` of another network
  /// and `flip_to_delaunay()`, leaves edges alone that are held.
  /// @{

  /// The number of holds on an edge, 0 at first.
  Index holds(Edge_index e) const;
  /// Adds a hold.
  void hold(Edge_index e);
  /// Takes a hold back. \pre `holds(e) > 0`
  void release(Edge_index e);
  /// The number of holds on all edges together.
  std::size_t number_of_holds() const;
  /// An upper bound of `Walker::edge_place()` for all edges at which a walker has stood.
  std::size_t number_of_edge_places() const;

  /// @}
  /// \name Walkers
  /// @{

  /// A walker that stands at `h`.
  Walker walker(Halfedge_index h) const;
  /// The same, given the place of a walker at either side of the edge.
  Walker walker(Walker::Place place, Halfedge_index h) const;
  /// Is the angle at the head of `h`, in the two faces of its edge, at least \f$\pi\f$? \pre both faces exist
  bool is_reflex_at_head(const Walker& h) const;

  /// @}
};

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * What stands at a halfedge of an `IntrinsicTriangulation`, and goes from there to others. All but the last members do
 * what those of the triangulation do.
 *
 * \sa `IntrinsicTriangulation`
 */
class IntrinsicTriangulationWalker
{
public:
  /// What an edge's place is kept in; default constructible, copyable.
  typedef unspecified_type Place;

  /// The halfedge.
  Halfedge_index index() const;
  /// Its place.
  Place place() const;
  /// Does it stand nowhere, since the border intervened?
  bool is_none() const;

  /// The vertex at which the halfedge starts.
  Vertex_index tail() const;
  /// At the other side of the edge.
  IntrinsicTriangulationWalker twin() const;
  /// At the previous halfedge of the face. \pre there is one
  IntrinsicTriangulationWalker previous() const;
  /// At the next halfedge clockwise about the tail, or nowhere.
  IntrinsicTriangulationWalker clockwise() const;
  /// At the next halfedge counterclockwise about the tail, or nowhere.
  IntrinsicTriangulationWalker counterclockwise() const;

  /// The length of the edge.
  double length() const;
  /// As for the triangulation.
  void prefetch_face() const;
  /// Adds the corner on the right at the tail, and goes clockwise; where that leads nowhere, nothing is added.
  IntrinsicTriangulationWalker extend_turn_clockwise(Turn& turn) const;

  /// A number of the edge, that of no other edge, which never changes: an index of arrays by edges. It is the number of
  /// the edge, or one that is small for edges that were touched early, so that such arrays are short.
  std::size_t edge_place() const;
  /// Has the edge holds?
  bool is_held() const;
  /// Adds a hold to the edge.
  void hold() const;
  /// Takes a hold of the edge back.
  void release() const;
};
