// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_VORONOI_BOUNDARIES_H
#define CGAL_FLIP_GEODESICS_VORONOI_BOUNDARIES_H

#include <CGAL/Flip_geodesics/Located_polyline.h>
#include <CGAL/Flip_geodesics/internal/distances/Voronoi_tracer.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

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
  static constexpr std::size_t none = internal::no_source;

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

#endif // CGAL_FLIP_GEODESICS_VORONOI_BOUNDARIES_H
