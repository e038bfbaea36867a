// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `GeodesicDistanceField` describes a distance field: a function object that returns, for each surface
 * point of a mesh, the distance to the nearest of several sources and the number of that source. `isolines()` and
 * `voronoi_boundaries()` require a model of this concept. Any function object that can be called as described below is
 * a model, for example a lambda expression that evaluates a formula for the distance; the type `Answer` need not be a
 * member.
 *
 * In the region in which the field is finite, it must be continuous across edges and vertices, and should be
 * 1-Lipschitz: the values at two points should differ by at most the length of any path on the surface between them, up
 * to rounding errors. If the values differ by more, `isolines()` and `voronoi_boundaries()` still work, but the bounds
 * stated in their documentation need not hold. Sources may have offsets, that is, nonzero values at the sources
 * themselves. In contrast to the offsets of `Geodesic_distance_field`, these values may be negative.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Flip_geodesics::Interpolated_distances<TriangleMesh\,VertexDistanceMap>}
 * \cgalHasModels{CGAL::Flip_geodesics::Geodesic_distance_field<Triangulation>}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Flip_geodesics::isolines()`, `CGAL::Flip_geodesics::voronoi_boundaries()`
 */
class GeodesicDistanceField
{
public:
  /// The value at a surface point: a class with the members `distance`, a `double`, and `source`, a `std::size_t`. If
  /// no source reaches the point, `distance` is infinite and `source` is not read.
  typedef unspecified_type Answer;

  /// Returns the value at a point in a face. The barycentric weights refer to the source and the target of
  /// `halfedge(face, mesh)` and to the third vertex of the face. The weights are nonnegative, and their sum is one up
  /// to rounding errors. For a point on an edge, the weight of the opposite vertex is exactly zero.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const;

  /// (Optional) Returns `true` only if all points of a face that have a finite distance have the same nearest source.
  /// `voronoi_boundaries()` does not search a face for boundaries if the result is `true`. If this member is missing,
  /// all faces are searched.
  bool has_one_source(face_descriptor face) const;
};
