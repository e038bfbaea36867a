// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * An intrinsic triangulation that knows how it lies on the mesh that it comes from: which input edges each edge crosses
 * and in which order, and where vertices are that were inserted. Certificates, measuring, extraction, subdivision,
 * searches, drawing, splines, refinement, `logarithmic_map()` and saving ask for it. So does `shorten()` if
 * `Traits::Has_drift` is `CGAL::Tag_true`.
 *
 * The words of crossed edges are exact. An edge runs straight through the faces that its word names. So it is known
 * from the word and the input alone, whatever the numbers of the triangulation do.
 *
 * `shorten()` and `certify()` measure edges of a model `t` by the object that `edge_straightness(t)` returns, which is
 * found in the namespaces of the model's type. `Intrinsic_triangulation.h` declares that function for all models.
 *
 * The mesh may have non-manifold vertices, in which several umbrellas of faces meet. Curves and trees lead through them
 * from one umbrella to another. Directions in different umbrellas have no angles between them.
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
  /// `bool is_insertion() const`, `bool is_on_edge() const` and `Index gap() const`. If it is a flip, `h` is the flipped
  /// halfedge. If it is an insertion, inserted vertex number `number`, counted from 0, was put on the edge of `h` or,
  /// unless `is_on_edge()`, into its face, in the input face at gap `gap()` of the crossing word that `h` had then.
  /// Otherwise the face of `h` was laid out afresh.
  typedef unspecified_type Flip_record;

  /// @}
  /// \name The input
  /// @{

  /// The mesh, as it was when the triangulation was made. Before the first flip or insertion, vertices and halfedges
  /// of the triangulation have the numbers that they have there.
  const CGAL::Flip_geodesics::Numbered_mesh<Triangle_mesh>& input() const;

  /// Where the lengths of the input's edges come from.
  const Metric& metric() const;

  /// @}
  /// \name Correspondence
  /// @{

  /// How many input edges an edge crosses; -1 if it lies along an input edge, or on a part of one.
  Index crossings(Edge_index e) const;

  /// The input edges that a halfedge crosses, from its tail to its head.
  Edge_sequence edge_sequence(Halfedge_index h) const;

  /// How many input edges start strictly inside the wedge from halfedge `from` clockwise to halfedge `to` of one
  /// vertex; `from == to` means all the way round. At an inserted vertex on an input edge, that edge starts twice.
  /// \pre no border in between
  Index input_edges_in_wedge(Halfedge_index from, Halfedge_index to) const;

  /// A number that changes whenever the edge does, 0 for an edge of the input that was never flipped.
  Index version(Edge_index e) const;

  /// An entry of the log, `i` below `log_position()`.
  Flip_record flip_record(Log_position i) const;

  /// @}
  /// \name Points as vertices
  /// @{

  /// Was the vertex inserted? Inserted vertices have the numbers after those of the input.
  bool is_inserted(Vertex_index v) const;

  /// Where a vertex is on the input, told in one way only, as `Intrinsic_triangulation::location()`.
  Surface_location location(Vertex_index v) const;

  /// Makes a point a vertex, unless it is one. It splits the face or the edge that holds it; new edges come after the
  /// others. Where an edge is split, calls `on_split` with an object that has two members: `first`, a halfedge that is
  /// shorter now, and `second`, which leads on from the new vertex to the old head of `first`. The log grows.
  /// \return the vertex
  /// \throws Invalid_location_error, Insertion_error; nothing is changed then
  template <class OnSplit>
  Vertex_index insert(const Surface_location& location, const OnSplit& on_split);

  /// Splits the edge of `h` at a point that lies on it by definition, in the input face at a gap of its word.
  /// \throws as `insert()`
  template <class OnSplit>
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap, const OnSplit& on_split);

  /// Splits the face on the left of `h` at a point inside it, in the input face at a gap of the word of `h`.
  /// \throws as `insert()`
  Vertex_index split_face(Halfedge_index h, const Surface_location& location, std::size_t gap);

  /// Replaces the geometry of the face on the left of `h`, from `h` on, by a more accurate one. The log grows.
  void set_face_geometry(Halfedge_index h, const Traits::Face_geometry& geometry);

  /// @}
};
