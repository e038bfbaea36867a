// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_ISOLINES_H
#define CGAL_FLIP_GEODESICS_ISOLINES_H

#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Isoline_tracer.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsIsolines
/// The type of the points that a mesh stores for its vertices.
template <class TriangleMesh>
using Mesh_point =
    typename boost::property_traits<typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type;

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Stores a polyline on a surface. Two consecutive points lie in one face or on its boundary, and a closed polyline
 * repeats its first point at the end.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Located_polyline
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< the face type of the mesh
  /// A `CGAL::Polygon_mesh_processing::Face_location`: a face and barycentric coordinates, which belong to the source,
  /// target and third vertex of `halfedge(face, mesh)`.
  using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

  bool is_closed = false; ///< whether the polyline ends where it begins
  /// the locations of the points; points on the same edge of the mesh are located in the same face
  std::vector<Face_location> locations;
  std::vector<Point> points; ///< the points in space

  /// Returns the length of the polyline in space.
  double length() const
  {
    double sum = 0;
    for(std::size_t i = 1; i < points.size(); ++i)
      sum += std::hypot(CGAL::to_double(points[i].x() - points[i - 1].x()),
                        CGAL::to_double(points[i].y() - points[i - 1].y()),
                        CGAL::to_double(points[i].z() - points[i - 1].z()));
    return sum;
  }
};

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Stores a component of an isoline, that is, of the curve at a given distance from the sources. Points nearer to the
 * sources lie on the left of the isoline, as seen from the side from which the faces of the mesh are oriented
 * counterclockwise.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Isoline : Located_polyline<TriangleMesh, Point>
{
  double level = 0; ///< the distance from the sources
};

namespace internal {

/* Returns the sorted levels; throws Invalid_parameter_error for a level that is not finite. */
inline std::vector<double> sorted_levels(const std::vector<double>& levels)
{
  for(std::size_t i = 0; i < levels.size(); ++i)
    if(!std::isfinite(levels[i]))
      throw_naming<Invalid_parameter_error>("level ", Element{i}, " is ", levels[i], ", but must be finite");
  std::vector<double> result = levels;
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Computes the isolines of a distance field, also known as offset curves: the curves at given distances from its
 * sources.
 *
 * The isoline at a level is the boundary of the set of points whose distance from the sources is less than this level.
 * Each of its components is closed or ends on the border of the mesh, and isolines never cross. The following bounds
 * hold for the tolerance \f$t\f$:
 * - The vertices of an isoline lie on the true curve up to rounding errors. Between the vertices, the isoline is
 *   nowhere farther than \f$t\f$ from the true curve, and the distances of its points from the sources differ from the
 *   level by at most \f$t\f$.
 * - Points whose distance is less than the level minus \f$t\f$ lie on the left of the isoline, and points whose
 *   distance exceeds the level plus \f$t\f$ on the right. A part of the region on either side can be missed only if the
 *   distance differs from the level by at most \f$t\f$ everywhere in this part.
 *
 * Faces that can contain points at a level are divided until their parts are as small as the tolerance. The bounds hold
 * because distances are 1-Lipschitz. An isoline has a vertex at each point at which it crosses an edge of the mesh.
 * Inside faces, the number of vertices grows like the inverse square root of the tolerance.
 *
 * A level may equal the distance at a vertex, or the constant distance in a whole region; points whose distance equals
 * the level count as farther. If the field was computed up to a limit, points with infinite distance count as farther
 * as well. A face whose three vertices have infinite distances is assumed to contain no point with a finite distance.
 *
 * \param mesh a triangle mesh; distances on it are those of the surface that its points in space define
 * \param field a model of `GeodesicDistanceField`
 * \param levels a range of numbers; a level that is not larger than the smallest distance has no isolines
 * \param out an output iterator that receives an `Isoline<TriangleMesh, Point>` for each component, in the order of the
 *        levels, where `Point` is the value type of the vertex point map
 * \param tolerance a distance on the surface, in the unit of the coordinates
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `mesh`}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the vertices of the mesh as keys and points as values}
 *     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor whose `go_further()` is called before each level and about once per thousand
 *       evaluations of the field. If it returns `false`, the computation ends and nothing is written}
 *     \cgalParamType{a model of `FlipOutVisitor`}
 *     \cgalParamDefault{no visitor}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return the past-the-end output iterator
 * \throws Invalid_parameter_error if a level is not finite; if the tolerance is not positive, not finite, less than
 *         1e-14 of a side of a face, or so small that 32-bit indices cannot number the parts of faces; if the field
 *         returns NaN; or if the field is a `Geodesic_distance_field` that has not been computed, or that has the
 *         extent `VERTICES_ONLY` and must be evaluated inside a face
 * \throws Invalid_mesh_error if a face is not a triangle
 * \throws Invalid_coordinate_error if a coordinate is not finite or is too large
 *
 * Complexity: the field is evaluated once per vertex, and about twenty times for each piece of length \f$t\f$ of an
 * isoline. Inside faces, a piece of length \f$\ell\f$ with a radius of curvature \f$r\f$ has
 * \cgalBigO{\ell / \sqrt{r t}} vertices. A mesh other than a `Surface_mesh` is indexed first, in \cgalBigO{n \log n}
 * time, where \f$n\f$ is the number of faces.
 *
 * \sa `voronoi_boundaries()`
 */
template <class TriangleMesh, class Field, class LevelRange, class OutputIterator, class Tolerance,
          class... NamedParameters>
OutputIterator isolines(const TriangleMesh& mesh, const Field& field, const LevelRange& levels, OutputIterator out,
                        const Tolerance& tolerance, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal_np::vertex_point_t, internal_np::visitor_t>(np...);
  static_assert(internal::are_in_order<TriangleMesh, Field, Tolerance>());
  static_assert(internal::is_range_of<LevelRange, double>, "the levels must be a range of numbers");
  const std::vector<double> wanted(std::begin(levels), std::end(levels));
  const std::vector<double> sorted = internal::sorted_levels(wanted);
  internal::check_tolerance(tolerance);
  if(wanted.empty())
    return out;
  using Curve = Isoline<TriangleMesh, internal::Point_of<TriangleMesh, internal::Joined<NamedParameters...>>>;
  return internal::write_curves<Curve>(
      options, out, [&](std::vector<Curve>& result, internal::Interruption& interruption) {
        auto surface = internal::make_refined_surface(mesh, field, options, tolerance, interruption);
        internal::Isoline_tracer<decltype(surface)> tracer(surface, sorted, tolerance);
        for(double level : wanted) {
          internal::throw_if_interrupted_before_part(&interruption);
          const auto at = std::lower_bound(sorted.begin(), sorted.end(), level) - sorted.begin();
          tracer.trace(static_cast<std::size_t>(at), [&](const internal::Followed_curve& curve) {
            result.emplace_back();
            result.back().level = level;
            internal::write_samples(surface, curve, result.back());
          });
        }
      });
}

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Represents a distance field that is interpolated between distances at vertices, such as those that
 * `geodesic_distances()` computes. The field has one property map per source. Each map is interpolated linearly in each
 * face, and the field is the minimum of these functions.
 *
 * Since distances on a surface are not linear in faces, the accuracy depends on the size of the faces, and is best far
 * from the sources. The slope of the field can exceed 1, so the bounds stated at `isolines()` need not hold. Isolines
 * are still found wherever the distances at the two ends of an edge lie on different sides of the level, and they are
 * closed or end on the border.
 *
 * \cgalModels{GeodesicDistanceField}
 *
 * \tparam TriangleMesh a model of `FaceGraph`
 * \tparam VertexDistanceMap a model of `ReadablePropertyMap` with the vertices of the mesh as keys and numbers as
 *         values
 */
template <class TriangleMesh, class VertexDistanceMap>
class Interpolated_distances
{
public:
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< the face type of the mesh

  /// Contains the result of a query.
  struct Answer
  {
    double distance = std::numeric_limits<double>::infinity(); ///< the distance from the nearest source
    std::size_t source = 0;                                    ///< the index of the distance map of that source
  };

  /// Constructs the field that interpolates between the distances of vertices.
  /// \param mesh the mesh, which must outlive the field
  /// \param distances one map for each source, with the distances of the vertices from this source
  Interpolated_distances(const TriangleMesh& mesh, std::vector<VertexDistanceMap> distances)
    : m_mesh(&mesh)
    , m_distances(std::move(distances))
  {
  }

  /// Returns the distance of the point with the given barycentric weights from the nearest source, and the index of
  /// this source; ties are broken in favor of the first source.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const
  {
    Answer result;
    for(std::size_t i = 0; i < m_distances.size(); ++i) {
      const double distance = interpolated(m_distances[i], face, weights);
      if(distance < result.distance || std::isnan(distance)) // NaN is passed on
        result = {distance, i};
    }
    return result;
  }

private:
  double interpolated(const VertexDistanceMap& distances, face_descriptor face,
                      const std::array<double, 3>& weights) const
  {
    double sum = 0;
    std::size_t i = 0;
    for(const auto h : halfedges_around_face(halfedge(face, *m_mesh), *m_mesh)) {
      if(weights[i] != 0) // zero times infinity is NaN
        sum += weights[i] * get(distances, source(h, *m_mesh));
      ++i;
    }
    return sum;
  }

  const TriangleMesh* m_mesh;
  std::vector<VertexDistanceMap> m_distances;
};

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Stores a boundary between two regions of a Voronoi diagram. A boundary is a closed curve, or a curve each of whose
 * ends is a junction of three regions or lies on the border of the mesh.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Voronoi_boundary : Located_polyline<TriangleMesh, Point>
{
  /// Indicates that no source or junction exists: points with infinite distance have no nearest source, and closed
  /// boundaries and ends on the border have no junctions.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// The nearest sources on the left and on the right of the boundary, as seen from the side from which the faces of
  /// the mesh are oriented counterclockwise.
  std::array<std::size_t, 2> sources = {{none, none}};

  /// The junctions at the first and the last point, numbered from 0 over all boundaries. Boundaries that end at the
  /// same junction have bitwise identical points there.
  std::array<std::size_t, 2> junctions = {{none, none}};
};

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Computes the boundaries between the regions of the Voronoi diagram of the sources of a distance field.
 *
 * A boundary is closed, or ends at junctions of three regions or on the border of the mesh. A point at which more than
 * three regions meet is represented by several junctions, which are no farther apart than the tolerance. Except near
 * junctions, the vertices of a boundary lie on the true boundary up to rounding errors. Junctions and the vertices next
 * to them can deviate from their true positions by a few hundredths of the tolerance. Between its vertices, a boundary
 * is nowhere farther than the tolerance from the true boundary. As with `isolines()`, the number of vertices inside
 * faces grows like the inverse square root of the tolerance. Points that no source reaches form a region with the
 * source `Voronoi_boundary::none`.
 *
 * Faces in which the nearest source changes are divided until their parts are as small as the tolerance. A face is not
 * divided if the field guarantees a single nearest source in the face, by `GeodesicDistanceField::has_one_source()`; a
 * field with one source is therefore processed quickly.
 *
 * In all other faces, a region can be missed if it lies between sample points that have the same nearest source, since
 * a field does not return the distance of the second nearest source. These faces are therefore divided until no side of
 * a part is longer than \f$\sqrt{t s}\f$. Here, \f$t\f$ is the tolerance, and \f$s\f$ is the square root of the area of
 * the surface. A region, or a part of one, that is narrower than \f$\sqrt{t s}\f$ can be missed. Around sources with
 * the offset 0, faces are divided until their parts are as small as the tolerance, so that only parts of regions that
 * are narrower than \f$t\f$ can be missed there.
 *
 * \param mesh a triangle mesh; distances on it are those of the surface that its points in space define
 * \param field a model of `GeodesicDistanceField`
 * \param out an output iterator that receives a `Voronoi_boundary<TriangleMesh, Point>` for each boundary, where
 *        `Point` is the value type of the vertex point map
 * \param tolerance a distance on the surface, in the unit of the coordinates
 * \param np the named parameters `vertex_point_map` and `visitor`, as for `isolines()`
 * \return the past-the-end output iterator
 * \throws Invalid_parameter_error as `isolines()` does, except for levels
 * \throws Invalid_mesh_error if a face is not a triangle
 * \throws Invalid_coordinate_error if a coordinate is not finite or is too large
 *
 * Complexity: the field is evaluated once per vertex, and about fifty times for each piece of length \f$t\f$ of a
 * boundary. The number of all other evaluations is at most a small multiple of \f$s / t\f$.
 *
 * \sa `isolines()`
 */
template <class TriangleMesh, class Field, class OutputIterator, class Tolerance, class... NamedParameters>
OutputIterator voronoi_boundaries(const TriangleMesh& mesh, const Field& field, OutputIterator out,
                                  const Tolerance& tolerance, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal_np::vertex_point_t, internal_np::visitor_t>(np...);
  static_assert(internal::are_in_order<TriangleMesh, Field, Tolerance>());
  internal::check_tolerance(tolerance);
  using Curve = Voronoi_boundary<TriangleMesh, internal::Point_of<TriangleMesh, internal::Joined<NamedParameters...>>>;
  return internal::write_curves<Curve>(
      options, out, [&](std::vector<Curve>& result, internal::Interruption& interruption) {
        auto surface = internal::make_refined_surface(mesh, field, options, tolerance, interruption);
        internal::Voronoi_tracer<decltype(surface)> tracer(surface, tolerance);
        internal::throw_if_interrupted_before_part(&interruption);
        tracer.trace([&](const internal::Followed_curve& curve, const std::array<std::size_t, 2>& sources,
                         const std::array<std::size_t, 2>& junctions) {
          result.emplace_back();
          result.back().sources = sources;
          result.back().junctions = junctions;
          internal::write_samples(surface, curve, result.back());
        });
      });
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_ISOLINES_H
