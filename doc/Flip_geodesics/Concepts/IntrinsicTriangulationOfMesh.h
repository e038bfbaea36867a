// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicTriangulationOfMesh` refines `IntrinsicTriangulation`. It adds the correspondence with the mesh
 * from which the triangulation was constructed: the sequence of input edges that each edge crosses, and the positions
 * of inserted vertices.
 *
 * Section \ref Flip_geodesicsAsked lists the algorithms that require this concept. If `Traits::Has_drift` is
 * `CGAL::Tag_true`, it is also required by `shorten()`, `Geodesic_tree` and `flip_to_delaunay()`.
 *
 * Edge sequences must be exact. An edge is straight in the unfolded faces along its edge sequence. The edge sequence
 * and the input therefore determine the edge, regardless of the rounding errors in the geometry that the triangulation
 * stores.
 *
 * `shorten()` and `certify()` measure the edges of a model `t` with the object that `edge_straightness(t)` returns. The
 * header `Intrinsic_triangulation.h` declares this function for all models. Programs that use a model of their own must
 * include this header before the headers of the algorithms, unless argument-dependent lookup finds the function.
 *
 * The mesh may have non-manifold vertices, at which several umbrellas of faces meet. Curves and trees can pass through
 * such a vertex from one umbrella to another. The angle between directions in different umbrellas is undefined.
 *
 * \cgalRefines{IntrinsicTriangulation}
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Intrinsic_triangulation<TriangleMesh\,Traits\,Metric>}
 * \cgalHasModelsEnd
 *
 * \sa `CurveNetwork`
 */
class IntrinsicTriangulationOfMesh
{
public:
  /// \name Types
  /// @{

  /// The type of the mesh, a model of `FaceListGraph` and `HalfedgeListGraph`.
  typedef unspecified_type Triangle_mesh;

  /// A model of `IntrinsicMetric` for meshes of this type.
  typedef unspecified_type Metric;

  /// An entry of the log, with the members `Halfedge_index h`, `Index number`, `bool is_flip() const`,
  /// `bool is_insertion() const`, `bool is_on_edge() const` and `Index gap() const`. For a flip, `h` is the flipped
  /// halfedge.
  ///
  /// For an insertion, `number` is the number of earlier insertions. If `is_on_edge()` returns `true`, the vertex was
  /// inserted on the edge of `h`; otherwise, it was inserted into the face of `h`. `gap()` is the number of input edges
  /// that `h`, as it was before the insertion, crosses before it reaches the input face that contains the vertex. The
  /// number is 0 if `h` starts in this face.
  ///
  /// An entry that is neither a flip nor an insertion records that the face of `h` was recomputed from the input.
  typedef unspecified_type Flip_record;

  /// @}
  /// \name The input
  /// @{

  /// Returns the numbered mesh, which flips and insertions do not change. Before the first flip or insertion, vertices
  /// and halfedges of the triangulation have the same numbers as in this mesh.
  const CGAL::Flip_geodesics::Numbered_mesh<Triangle_mesh>& input() const;

  /// Returns the metric, which defines the lengths of the input edges.
  const Metric& metric() const;

  /// @}
  /// \name Correspondence
  /// @{

  /// Returns the number of input edges that edge `e` crosses, or -1 if `e` is an input edge or a part of one.
  Index crossings(Edge_index e) const;

  /// Returns the input edges that a halfedge crosses, from its tail to its head. Algorithms that accept models of
  /// `IntrinsicTriangulation` treat a class with this member as a model of `IntrinsicTriangulationOfMesh`: they
  /// measure finished curves, and their reports take into account whether the metric is rounded.
  Edge_sequence edge_sequence(Halfedge_index h) const;

  /// Returns the number of input edges that start at the common tail of `from` and `to` and lie strictly inside the
  /// wedge clockwise from `from` to `to`. If `from == to`, the wedge extends once around the vertex. If the common tail
  /// was inserted on an input edge, the two parts of this edge count as two edges. \pre the wedge does not contain the
  /// border
  Index input_edges_in_wedge(Halfedge_index from, Halfedge_index to) const;

  /// Returns a number that changes whenever the edge changes, and that is 0 for an unchanged input edge.
  Index version(Edge_index e) const;

  /// Returns entry `i` of the log, counted from 0. \pre `i` is less than `log_position()`
  Flip_record flip_record(Log_position i) const;

  /// @}
  /// \name Points as vertices
  /// @{

  /// Returns whether vertex `v` was inserted. The numbers of inserted vertices follow those of the input vertices.
  bool is_inserted(Vertex_index v) const;

  /// Returns the position of a vertex on the input, in the canonical form that `Intrinsic_triangulation::location()`
  /// defines.
  Surface_location location(Vertex_index v) const;

  /// Inserts a point as a vertex, unless a vertex already lies at this point. The face or edge that contains the point
  /// is split; new edges are numbered after the existing edges, and the log grows.
  ///
  /// If an edge is split, the function calls `on_split(s)`, where `s` has two halfedges as members: `s.first` has
  /// become shorter, and `s.second` leads from the new vertex to the old head of `s.first`.
  /// \return the new or existing vertex at the point
  /// \throws Invalid_location_error if the location is not valid; in this case nothing changes
  /// \throws Insertion_error if the point cannot be inserted; in this case nothing changes
  template <class OnSplit>
  Vertex_index insert(const Surface_location& location, const OnSplit& on_split);

  /// Splits the edge of `h` at a point, and returns the new vertex. The point is assumed to lie on the edge even if
  /// rounding errors have moved it off the edge. The function calls `on_split` as `insert()` does. `gap` is the number
  /// of input edges that `h` crosses before it enters the input face that contains the point.
  /// \throws Invalid_location_error if the location is not valid; in this case nothing changes
  /// \throws Insertion_error if the point cannot be inserted; in this case nothing changes
  template <class OnSplit>
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap, const OnSplit& on_split);

  /// Splits the face on the left of `h` at a point inside the face, and returns the new vertex. `gap` is the number of
  /// input edges that `h` crosses before it enters the input face that contains the point.
  /// \throws Invalid_location_error if the location is not valid; in this case nothing changes
  /// \throws Insertion_error if the point cannot be inserted; in this case nothing changes
  Vertex_index split_face(Halfedge_index h, const Surface_location& location, std::size_t gap);

  /// Replaces the geometry of the face on the left of `h` by the more accurate `geometry`, whose first element is the
  /// geometry of `h`. The log grows.
  void set_face_geometry(Halfedge_index h, const Traits::Face_geometry& geometry);

  /// @}
};
