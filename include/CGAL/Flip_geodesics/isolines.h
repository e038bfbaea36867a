// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_ISOLINES_H
#define CGAL_FLIP_GEODESICS_ISOLINES_H

#include <CGAL/Flip_geodesics/Located_polyline.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/distances/Isoline_tracer.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

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

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_ISOLINES_H
