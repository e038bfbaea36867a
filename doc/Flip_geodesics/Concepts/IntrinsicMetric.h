// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The lengths of a mesh's edges and the shapes of its faces, from wherever they come. A model is copyable, and cheaply
 * so: a triangulation keeps a copy.
 *
 * The argument `mesh` of its members is the mesh as `Intrinsic_triangulation::input()` gives it, numbered by
 * consecutive integers.
 *
 * Curves of a metric are certified if it has the optional member `squared_length()`, or is one of the models below. A
 * class that derives from one of these is a metric of its own, and is certified only if it has `squared_length()`.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Embedded_metric<TriangleMesh\,VertexPointMap>}
 * \cgalHasModels{CGAL::Flip_geodesics::Edge_length_metric<TriangleMesh\,EdgeLengthMap>}
 * \cgalHasModels{CGAL::Flip_geodesics::Mollified_metric<Metric>}
 * \cgalHasModels{CGAL::Flip_geodesics::Weighted_metric<Metric>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::Intrinsic_triangulation`
 */
class IntrinsicMetric
{
public:
  /// `CGAL::Flip_geodesics::Numbered_mesh` of the mesh's type, that of `Intrinsic_triangulation::input()`.
  typedef unspecified_type Mesh;

  /// A \cgal kernel. The measurement of finished curves lays faces out by
  /// `Intrinsic_triangulation_traits<Kernel, double>`.
  typedef unspecified_type Kernel;

  /// The length of the edge of a halfedge, rounded; positive, and the same for both halfedges of the edge.
  /// \throws Degenerate_face_error, Invalid_coordinate_error if there is no usable length
  double length(const Mesh& mesh, Input_halfedge_index h) const;

  /// The same without a check, for a search of edge paths that only passes by: zero where the edge has no length, and
  /// whatever there is where it has no usable one.
  double weight(const Mesh& mesh, Input_halfedge_index h) const;

  /// What a lower bound needs to know of a vertex, such as the coordinates of its point; default constructible, and
  /// copied freely. An empty class says that the only bound is zero. A `std::array<double, 3>` is taken for the
  /// coordinates of a point: from these, `add_straightened_path()` lays faces out to find its path.
  typedef unspecified_type Place;

  /// `weight(mesh, h)`, but for rounding errors, where the places of the halfedge's two ends are at hand: searches for
  /// edge paths call it most often.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const;

  /// The place of vertex `v`.
  Place place(const Mesh& mesh, Vertex_index v) const;

  /// A lower bound of the length of all paths on the surface between two vertices, across faces as well as along edges.
  /// Bounds and verdicts of shortest paths rest on it. It is 0 from a vertex to itself. From the two ends of an edge to
  /// one vertex it differs by no more than the edge's weight.
  double distance_lower_bound(const Place& p, const Place& q) const;

  /// Optional. The type of points, if vertices have points in space; points are written as this, see
  /// `point_in_space()`. It has `x()`, `y()` and `z()`, and is constructed from three of them. A metric without this
  /// type, or with `void`, has no points, and functions that write points cannot be used.
  typedef unspecified_type Point_3;

  /// Optional, required with `Point_3`. The point of vertex `v`.
  Point_3 point(const Mesh& mesh, Vertex_index v) const;

  /// Optional. The exact squared length of the edge of a halfedge, the same for both halfedges of the edge. Its type is an
  /// exact number type with rational values: `Gmpq`, `mpq_class`, `Exact_rational`, `cpp_rational`, `Lazy_exact_nt` of
  /// one of these, or an integer of any size. `length()` is its root, rounded. With this member, faces are laid out and
  /// all decisions taken from exact squared lengths, `Certified_intrinsic_triangulation_traits` is the default, and
  /// certificates refer to the exact metric. Three of them make a face if they satisfy the triangle inequality, of which
  /// equality is allowed.
  unspecified_type squared_length(const Mesh& mesh, Input_halfedge_index h) const;

  /// The geometry of the face on the left of `h`, from `h` on, made by one of the functors of `traits`. Not called for a
  /// metric that has `squared_length()`, which need not have this member.
  /// \throws Degenerate_face_error, Invalid_coordinate_error if the face has no usable shape
  /// \pre `h` is not on the border
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const;

  /// Optional. Returns whether numbers that define the metric, such as coordinates or lengths, are rounded to double by
  /// it. Then no curve is certified and no distance confirmed, since decisions refer to the rounded numbers. A metric
  /// without this member is defined by the doubles that `length()` returns.
  bool is_rounded(const Mesh& mesh) const;
};
