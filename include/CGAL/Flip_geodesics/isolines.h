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
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsIsolines
/// The type of points that a mesh has of its own.
template <class TriangleMesh>
using Mesh_point =
    typename boost::property_traits<typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type;

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * A polyline on a surface: each two points in a row are in one face, or on its border. A closed one repeats its first
 * point at the end.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Located_polyline
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< of the mesh
  /// A `CGAL::Polygon_mesh_processing::Face_location`: a face and barycentric coordinates, which belong to the source,
  /// target and third vertex of `halfedge(face, mesh)`.
  using Face_location = std::pair<face_descriptor, std::array<double, 3>>;

  bool is_closed = false;               ///< does it end where it began?
  std::vector<Face_location> locations; ///< of the points; one on an edge of the mesh in one of the two faces, always
                                        ///< the same one
  std::vector<Point> points;            ///< in space

  /// The length of the polyline, in space.
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
 * A part of an isoline: a curve at one distance from the sources. What is nearer to them lies on its left, as seen from
 * the side from which the faces of the mesh are counterclockwise.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Isoline : Located_polyline<TriangleMesh, Point>
{
  double level = 0; ///< the distance
};

namespace internal {

/* Throws Invalid_parameter_error for a level that is not finite. */
inline std::vector<double> sorted_levels(const std::vector<double>& levels)
{
  for(std::size_t i = 0; i < levels.size(); ++i)
    if(!std::isfinite(levels[i])) {
      std::ostringstream number;
      number << levels[i];
      throw Invalid_parameter_error(
          "level " + std::to_string(i) + " is " + number.str() + ", which is not a finite number", {i});
    }
  std::vector<double> result = levels;
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Computes the isolines of a distance field, which are the curves at given distances from its sources, or offset curves
 * of them.
 *
 * An isoline is the boundary of the points that are nearer than its level. It ends on the border of the mesh or is
 * closed, and isolines never cross. Its vertices are on the true curve, but for roundings; between them it is nowhere
 * farther than the tolerance from it, and the distance differs there from the level by the tolerance at most. What is
 * nearer than the level less the tolerance is on its left, what is farther than the level and the tolerance is on its
 * right: so no component is lost that reaches that deep or that high. Those that do not may be.
 *
 * Faces are divided where a level may be, until their parts are as small as the tolerance. The bounds follow from
 * distances being 1-Lipschitz. Of the curve's points on the sides of the parts, an isoline keeps those on edges of the
 * mesh, which are computed once, and inside faces only as many as the tolerance requires: their number grows like the
 * inverse square root of the tolerance. All points are kept where parts of one isoline come within three tolerances of
 * one another, at sharp bends, and where levels are too close for chords of two of them to keep apart. A level
 * that is the distance of a vertex, or of a whole area, is no special case: what is at the level is counted to the
 * farther side. Where the field becomes infinite inside the surface, as one does that is limited, what is beyond is
 * farther. A face that has infinite distances at all three vertices is taken to have no others.
 *
 * \param mesh a triangle mesh; its distances are those of its points in space
 * \param field a model of `GeodesicDistanceField`
 * \param levels a range of numbers; for one that is not larger than the least distance there are no isolines
 * \param out receives an `Isoline<TriangleMesh, Point>` for each component, `Point` being the points' type; in the
 *        order of the levels
 * \param tolerance a distance on the surface, a number
 * \param np named parameters: `vertex_point_map`, a model of `ReadablePropertyMap` with the mesh's vertices as keys and
 *        points as values; by default the mesh's own points, `get(CGAL::vertex_point, mesh)`; and `visitor`, a model of
 *        `FlipOutVisitor`, of which only `go_further()` is called, before each level and once for about a thousand
 *        values of the field. If it returns `false`, then the computation ends, and nothing is written
 * \return the end of the output
 * \throws Invalid_parameter_error if a level is not finite, the tolerance is not a positive number or less than 1e-14 of
 *         a side of a face, or the field is not a number somewhere
 * \throws Invalid_mesh_error if a face is no triangle
 * \throws Invalid_coordinate_error if a coordinate is no finite number
 *
 * Complexity: the field is evaluated once per vertex, and about twenty times for each piece of isoline as long as the
 * tolerance. An isoline has a point for each edge that it crosses, and \f$O(\ell / \sqrt{r t})\f$ more for a length
 * \f$\ell\f$, a radius of curvature \f$r\f$ and a tolerance \f$t\f$. A mesh other than a `Surface_mesh` is numbered, in \f$O(n \log n)\f$.
 */
template <class TriangleMesh, class Field, class LevelRange, class OutputIterator, class Tolerance,
          class... NamedParameters>
OutputIterator isolines(const TriangleMesh& mesh, const Field& field, const LevelRange& levels, OutputIterator out,
                        const Tolerance& tolerance, const NamedParameters&... np)
{
  const auto& options = internal::options_of<internal_np::vertex_point_t, internal_np::visitor_t>(np...);
  static_assert(internal::are_in_order<TriangleMesh, Field, Tolerance>());
  static_assert(internal::is_range_of<LevelRange, double>, "the levels are not a range of numbers");
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
 * A distance field made of distances at vertices, such as `geodesic_distances()` writes, one property map per source:
 * linear in each face for each source, and the least of these.
 *
 * Distances on a surface are not linear in faces, so this is as good as the faces are small, and best far from the
 * sources. In faces with obtuse angles its slope may be larger than one. Then the bounds of `isolines()` need not hold.
 * What a sign at vertices shows is still found, and curves are closed or end on the border.
 *
 * \cgalModels{GeodesicDistanceField}
 *
 * \tparam TriangleMesh a model of `FaceGraph`
 * \tparam VertexDistanceMap a model of `ReadablePropertyMap` with the mesh's vertices as keys and numbers as values
 */
template <class TriangleMesh, class VertexDistanceMap>
class Interpolated_distances
{
public:
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor; ///< of the mesh

  /// What is known of a place.
  struct Answer
  {
    double distance = std::numeric_limits<double>::infinity(); ///< from the nearest source
    std::size_t source = 0;                                    ///< its position among the maps
  };

  /// Interpolates between the distances of vertices.
  /// \param mesh must outlive the field
  /// \param distances of the vertices, from each of the sources
  Interpolated_distances(const TriangleMesh& mesh, std::vector<VertexDistanceMap> distances)
    : m_mesh(&mesh)
    , m_distances(std::move(distances))
  {
  }

  /// The distance from the nearest source, and which one it is; of two that are equally near the first.
  Answer operator()(face_descriptor face, const std::array<double, 3>& weights) const
  {
    Answer result;
    for(std::size_t i = 0; i < m_distances.size(); ++i) {
      const double distance = interpolated(m_distances[i], face, weights);
      if(!(result.distance <= distance)) // not a number is passed on
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
      if(weights[i] != 0) // zero times infinity is not a number
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
 * A boundary between two regions of a Voronoi diagram: a curve between two junctions or ends on the border of the mesh,
 * or a closed one without any.
 */
template <class TriangleMesh, class Point = Mesh_point<TriangleMesh>>
struct Voronoi_boundary : Located_polyline<TriangleMesh, Point>
{
  /// The number of what does not exist: the source where no distance is finite, the junction at an end on the border.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// The nearest sources on its left and on its right, as seen from the side from which the faces of the mesh are
  /// counterclockwise.
  std::array<std::size_t, 2> sources = {{none, none}};

  /// The junctions at its first and at its last point, counted from 0 over all boundaries. Boundaries that end at the
  /// same junction have the same point there, to the bit.
  std::array<std::size_t, 2> junctions = {{none, none}};
};

/*!
 * \ingroup PkgFlipGeodesicsIsolines
 *
 * Computes the boundaries of the Voronoi diagram of a distance field's sources, by which of them is the nearest.
 *
 * Boundaries end at junctions, where three regions meet, or on the border of the mesh, or are closed. Where more than
 * three regions meet there are several junctions within the tolerance. The vertices of a boundary are on the true one,
 * but for roundings; between them it is nowhere farther than the tolerance from it. A junction, and vertices beside it,
 * may be off by some hundredths of the tolerance. As with `isolines()`, the number of vertices inside faces grows like
 * the inverse square root of the tolerance.
 *
 * Faces are divided where the nearest source changes until their parts are as small as the tolerance. Faces in which
 * the field knows one source to be the nearest everywhere, by `GeodesicDistanceField::has_one_source()`, are not
 * divided further. So the boundaries of one source take no time. Apart from that, a field does not return the distance
 * of the second source, so no bound excludes that a region reaches between places with one nearest source. Therefore
 * all other faces are divided until parts have no side longer than the square root of tolerance times size. The size is
 * the square root of the area. The surroundings of sources with distance zero are divided as finely as the tolerance.
 * So a region, or a finger of one, is found unless it is narrower than that square root and free of such sources.
 *
 * What no source reaches is a region, too, with source `Voronoi_boundary::none`.
 *
 * \param mesh a triangle mesh; its distances are those of its points in space
 * \param field a model of `GeodesicDistanceField`
 * \param out receives a `Voronoi_boundary<TriangleMesh, Point>` for each, `Point` being the points' type
 * \param tolerance a distance on the surface, a number
 * \param np named parameters: `vertex_point_map` and `visitor`, as for `isolines()`
 * \return the end of the output
 * \throws Invalid_parameter_error if the tolerance is not a positive number or less than 1e-14 of a side of a face, or
 *         the field is not a number somewhere
 * \throws Invalid_mesh_error if a face is no triangle
 * \throws Invalid_coordinate_error if a coordinate is no finite number
 *
 * Complexity: the field is evaluated about fifty times for each piece of boundary as long as the tolerance. It is
 * evaluated a few times for each piece of a curve as long as the size, and once per vertex.
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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_ISOLINES_H
