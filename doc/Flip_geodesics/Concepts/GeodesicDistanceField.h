// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * The concept `GeodesicDistanceField` describes a distance field on a mesh. A distance field is a function object that
 * returns the distance from a surface point to the nearest of several sources, and the number of this source.
 * `isolines()` and `voronoi_boundaries()` require a model of this concept. Any function object that can be called as
 * described below is a model, for example a lambda expression that evaluates a formula for the distance. The type
 * `Answer` need not be a member of the model.
 *
 * The field must be continuous across edges and vertices wherever it is finite. It should also be 1-Lipschitz: up to
 * rounding errors, the values at two points should differ by at most the length of any path on the surface between
 * these points. If the values differ by more, `isolines()` and `voronoi_boundaries()` still work, but the bounds stated
 * in their documentation need not hold.
 *
 * The value at a source, called its offset, need not be zero. It may even be negative, in contrast to the offsets of
 * `Geodesic_distance_field`.
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
  /// The type of the value at a surface point: a class with the members `double distance` and `std::size_t source`. If
  /// no source reaches the point, `distance` is infinite and `source` is not read.
  typedef unspecified_type Answer;

  /// Returns the value at a point in a face. The barycentric weights refer, in this order, to the source and the target
  /// of `halfedge(face, mesh)` and to the third vertex of the face. The weights are nonnegative, and their sum is one
  /// up to rounding errors. For a point on an edge, the weight of the opposite vertex is exactly zero.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const;

  /// (Optional) Returns `true` only if the nearest source is the same for all points of the face that have a finite
  /// distance. If the result is `true`, `voronoi_boundaries()` does not search the face for regions that contain none
  /// of its vertices. If this member is missing, all faces are searched for such regions.
  bool has_one_source(face_descriptor face) const;
};
