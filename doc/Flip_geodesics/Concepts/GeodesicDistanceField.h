// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
 * \ingroup PkgFlipGeodesicsConcepts
 * \cgalConcept
 *
 * A distance field on a mesh that can be asked anywhere: how far the nearest of some sources is, and which one it is. It
 * is what `isolines()` and `voronoi_boundaries()` ask for. A function object will do, so a lambda of closed forms does.
 *
 * The field is continuous over edges and vertices where it is finite, and 1-Lipschitz: two distances differ by no more
 * than the length of a path on the surface between their places. Offsets of the sources are allowed, and may be
 * negative. Rounding errors are no harm. Where a field has larger slopes nothing breaks, but bounds that are drawn from
 * this need not hold.
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
  /// What is known of a place: a class with a member `distance`, a `double`, and a member `source`, a `std::size_t`.
  /// `distance` is infinity where no source reaches, and `source` is not looked at then.
  typedef unspecified_type Answer;

  /// The answer for a place in a face: the barycentric weights belong to the source, the target and the third vertex of
  /// `halfedge(face, mesh)`, are not negative and sum to one, but for roundings. The weight of the opposite vertex is
  /// exactly zero on an edge.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const;

  /// Optional. Returns true only if all places of a face with a finite distance have the same nearest source.
  /// `voronoi_boundaries()` does not search such faces for boundaries.
  bool has_one_source(face_descriptor face) const;
};
