// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `IntrinsicMetric` describes the lengths of the edges of a mesh and the shapes of its faces. A model must
 * be cheap to copy, since a triangulation keeps a copy.
 *
 * The argument `mesh` of the members is a mesh whose vertices and halfedges are numbered by consecutive integers, such
 * as the one that `Intrinsic_triangulation::input()` returns.
 *
 * Curves can be certified with respect to a metric only if the metric has the optional member `squared_length()` or is
 * one of the models below. For this purpose, a class that is derived from one of these models does not count as one of
 * them, and therefore requires `squared_length()`.
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
  /// The type of the numbered mesh that `Intrinsic_triangulation::input()` returns:
  /// `CGAL::Flip_geodesics::Numbered_mesh<TriangleMesh>`, where `TriangleMesh` is the type of the original mesh.
  typedef unspecified_type Mesh;

  /// A \cgal kernel. Finished curves are measured with `Intrinsic_triangulation_traits<Kernel, double>`.
  typedef unspecified_type Kernel;

  /// Returns the length of the edge of a halfedge, rounded. The result must be positive, and equal for both halfedges
  /// of the edge.
  /// \throws Degenerate_face_error if the edge has length zero
  /// \throws Invalid_coordinate_error if the length is not finite or not in [1e-70, 1e70]
  double length(const Mesh& mesh, Input_halfedge_index h) const;

  /// Returns the length of the edge of a halfedge without checking the length; searches for edge paths call this
  /// member. The result is zero for a zero-length edge, and arbitrary if `length()` throws `Invalid_coordinate_error`.
  double weight(const Mesh& mesh, Input_halfedge_index h) const;

  /// The type of the data of a vertex, such as the coordinates of its point. Lower bounds on distances are computed
  /// from these data. The type must be default constructible and cheap to copy. A metric without lower bounds uses a
  /// class without data members, and its `distance_lower_bound()` returns 0. If the type is `std::array<double, 3>`,
  /// the library interprets the data as the coordinates of a point, and unfolds faces from these coordinates, for
  /// example in `add_straightened_path()`.
  typedef unspecified_type Place;

  /// Returns `weight(mesh, h)` up to rounding errors, given the data of the two ends of the halfedge. This overload
  /// should be fast, since searches for edge paths call it for most of the edges that they visit.
  double weight(const Mesh& mesh, Input_halfedge_index h, const Place& tail, const Place& head) const;

  /// Returns the data of vertex `v`.
  Place place(const Mesh& mesh, Vertex_index v) const;

  /// Returns a lower bound on the lengths of all paths on the surface, including paths across faces, between two
  /// vertices with the data `p` and `q`. Verdicts on shortest paths are correct only if this bound is correct. The
  /// bound from a vertex to itself must be 0. For every edge and every vertex, the bounds from the two ends of the edge
  /// to the vertex must differ by at most the weight of the edge.
  double distance_lower_bound(const Place& p, const Place& q) const;

  /// (Optional) The type of the points of vertices in space; see `point_in_space()`. The type must have the members
  /// `x()`, `y()` and `z()` and must be constructible from three coordinates. If `Point_3` is missing or `void`, the
  /// metric does not have points, and functions that write points cannot be used.
  typedef unspecified_type Point_3;

  /// (Optional) Returns the point of vertex `v`; required if `Point_3` is present and not `void`.
  Point_3 point(const Mesh& mesh, Vertex_index v) const;

  /// (Optional) Returns the exact squared length of the edge of a halfedge. The result must be equal for both halfedges
  /// of the edge. The return type must be an exact number type with rational values: `Gmpq`, `mpq_class`,
  /// `Exact_rational`, `cpp_rational`, `Lazy_exact_nt` of one of these, or an integer type such as `Gmpz` or `cpp_int`.
  /// `length()` must return the square root of this number, rounded. The three lengths of a face must satisfy the
  /// triangle inequality; equality is allowed.
  ///
  /// If this member exists, the default traits are `Certified_intrinsic_triangulation_traits`. The predicates of these
  /// traits, and all certificates, then refer to the exact squared lengths. Traits whose `Construct_face_from_lengths`
  /// does not have the overload for exact squared lengths receive rounded lengths.
  unspecified_type squared_length(const Mesh& mesh, Input_halfedge_index h) const;

  /// Returns the geometry of the face on the left of `h`, constructed by one of the functors of `traits`. The first
  /// element of the result is the geometry of `h`. If the metric has the member `squared_length()`, this member is not
  /// required and not called.
  /// \throws Degenerate_face_error if an edge of the face has length zero, or if the lengths of the edges violate the
  /// triangle inequality
  /// \throws Invalid_coordinate_error if a coordinate or length is not finite, or if a length is not in [1e-70, 1e70]
  /// \pre `h` is not on the border
  template <class Traits>
  typename Traits::Face_geometry face_geometry(const Mesh& mesh, Input_halfedge_index h, const Traits& traits) const;

  /// (Optional) Returns whether the metric rounds the numbers that define it, such as coordinates or lengths, to
  /// double. If the result is `true`, curves are not certified and distances are not confirmed, since predicates refer
  /// to the rounded numbers. If this member is missing and `length()` returns a `double`, the numbers of the metric are
  /// assumed not to be rounded.
  bool is_rounded(const Mesh& mesh) const;

  /// (Optional) Throws an exception if the metric detects, for example from the number of edges, that it was made for a
  /// mesh other than `mesh`. Triangulations and functions that take a metric call this member first.
  /// \throws Input_mismatch_error if the metric was made for another mesh
  void check_input(const Mesh& mesh) const;
};
