// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REFINE_H
#define CGAL_FLIP_GEODESICS_REFINE_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/Shortening_visitor.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/Delaunay_refiner.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDelaunay
/// What `refine()` is to reach, and how far it may go.
struct Refinement_options
{
  double smallest_angle = 25; ///< in degrees, of every face; 0 is no bound. At most 30, above which few inputs end
  double longest_edge = std::numeric_limits<double>::infinity(); ///< of every edge, in the units of the mesh
  std::size_t maximum_insertions = 1000000;                      ///< of vertices, those that split edges included
};

/// \ingroup PkgFlipGeodesicsDelaunay
/// What `refine()` did, and what it reached.
struct Refinement_report
{
  std::size_t insertions = 0;     ///< of vertices inside faces
  std::size_t splits = 0;         ///< of edges under curves or on the border
  std::size_t flips = 0;          ///< flips, those taken back included
  std::size_t refused = 0;        ///< faces left as they are, since numbers are too coarse for a point to be inserted
  double smallest_angle = 0;      ///< of all faces, in degrees
  double smallest_free_angle = 0; ///< of the faces that are not exempt, see `refine()`
  std::size_t exempt = 0;         ///< faces whose smallest angle is below the bound, but where there is no other way
  std::size_t missed = 0;         ///< faces that violate a bound and are not exempt
  bool is_stopped = false;        ///< did the visitor end it? Then the triangulation may not even be Delaunay
  bool is_complete() const { return missed == 0 && !is_stopped; }
};

namespace internal {

/* Puts points into a triangulation without curves. */
template <class Triangulation>
struct Triangulation_splitter
{
  Index insert(const Surface_location& location) { return triangulation.insert(location); }
  Index split_edge(Index h, const Surface_location& location, std::size_t gap)
  {
    return triangulation.split_edge(h, location, gap, [](const Edge_halves&) {});
  }

  Triangulation& triangulation;
};

template <class Triangulation, class Refiner>
void measure_faces(const Triangulation& triangulation, const Refiner& refiner, double angle_bound,
                   Refinement_report& report)
{
  constexpr double degree = boost::math::constants::degree<double>();
  report.smallest_angle = report.smallest_free_angle = 180;
  for(Index h = 0; h < triangulation.number_of_halfedges(); ++h) {
    if(triangulation.is_border(h) || Face_shape<Triangulation>::first_halfedge(triangulation, h) != h)
      continue;
    const double angle = Face_shape<Triangulation>(triangulation, h).smallest_angle();
    report.smallest_angle = (std::min)(report.smallest_angle, angle / degree);
    report.missed += refiner.badness(h) > 0 ? 1 : 0;
    if(angle < angle_bound && refiner.is_exempt(h))
      ++report.exempt;
    else
      report.smallest_free_angle = (std::min)(report.smallest_free_angle, angle / degree);
  }
}

template <class Triangulation, class Splitter, class Visitor>
Refinement_report refine(Triangulation& triangulation, Splitter& splitter, const Refinement_options& options,
                         Visitor& visitor)
{
  constexpr double degree = boost::math::constants::degree<double>();
  CGAL_precondition_msg(options.smallest_angle >= 0 && options.smallest_angle <= 30, "no more than 30 degrees");
  CGAL_precondition_msg(options.longest_edge > 0, "edges have a length");
  const double angle = options.smallest_angle * degree;
  Refinement_report report;
  const Delaunay_report flipped =
      flip_to_delaunay(triangulation, default_maximum_of_flips(triangulation.number_of_edges()), visitor);
  report.flips = flipped.flips;
  Delaunay_refiner<Triangulation, Splitter, Visitor> refiner(
      triangulation, splitter, {angle, options.longest_edge, options.maximum_insertions}, visitor);
  report.is_stopped = flipped.is_stopped || !refiner.run();
  report.insertions = refiner.counts().insertions;
  report.splits = refiner.counts().splits;
  report.refused = refiner.counts().refused;
  report.flips += refiner.counts().flips;
  measure_faces(triangulation, refiner, angle, report);
  return report;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * Refines a triangulation until no angle is too small and no edge too long: flips it to Delaunay, and then inserts
 * vertices at the circumcentres of bad faces, worst first, each followed by flips [SSC19, section 4.3]. Curves and the
 * border are constrained: where they are in the way, they are split at vertices on them, and so stay geodesics, with
 * the same length. The surface does not change.
 *
 * A face is exempt from the bound on angles if its smallest angle lies between two constrained edges that meet under
 * less than 60 degrees, or about a vertex whose angles sum to less: no insertion could make that angle larger. So it is
 * if its shortest side joins two constrained edges at equal distances from such a vertex, for an insertion there would
 * call for another one closer to it, without end [Shewchuk 2002].
 *
 * \param network an `Edge_path_network`, whose triangulation is refined
 * \param options the bounds; up to about 25 degrees the process ends by itself in practice
 * \param visitor a model of `FlipOutVisitor`: `go_further()` is asked before each flip to Delaunay and then before each
 *        bad face, and `on_flip()` called after each flip. Ended by it, or by an exception that it throws, the
 *        triangulation and its curves are valid, and the curves as long as before.
 * \return what was reached, measured on the result
 * \throws what is thrown when faces are first touched
 *
 * Complexity: about linear in the flips and insertions, with a logarithm for the queue, and in the crossings of the
 * faces that are refined.
 */
template <class Triangulation, class Visitor = Default_shortening_visitor>
Refinement_report refine(Edge_path_network<Triangulation>& network,
                         const Refinement_options& options = Refinement_options(), Visitor&& visitor = Visitor())
{
  return internal::refine(network.triangulation(), network, options, visitor);
}

/// \ingroup PkgFlipGeodesicsDelaunay
/// The same for a triangulation without curves. \throws Occupied_triangulation_error if a network in it has some
template <class Triangulation, class Visitor = Default_shortening_visitor>
Refinement_report refine(Triangulation& triangulation, const Refinement_options& options = Refinement_options(),
                         Visitor&& visitor = Visitor())
{
  if(triangulation.has_curves())
    throw Occupied_triangulation_error("a triangulation that has curves is refined by way of their network");
  internal::Triangulation_splitter<Triangulation> splitter = {triangulation};
  return internal::refine(triangulation, splitter, options, visitor);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_REFINE_H
