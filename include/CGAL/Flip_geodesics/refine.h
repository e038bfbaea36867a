// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REFINE_H
#define CGAL_FLIP_GEODESICS_REFINE_H

#include <CGAL/Flip_geodesics/Edge_path_network.h>
#include <CGAL/Flip_geodesics/delaunay.h>
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
  bool is_complete() const { return missed == 0; }
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

template <class Triangulation, class Splitter>
Refinement_report refine(Triangulation& triangulation, Splitter& splitter, const Refinement_options& options)
{
  constexpr double degree = boost::math::constants::degree<double>();
  CGAL_precondition_msg(options.smallest_angle >= 0 && options.smallest_angle <= 30, "no more than 30 degrees");
  CGAL_precondition_msg(options.longest_edge > 0, "edges have a length");
  const double angle = options.smallest_angle * degree;
  Refinement_report report;
  report.flips = flip_to_delaunay(triangulation).flips;
  Delaunay_refiner<Triangulation, Splitter> refiner(triangulation, splitter,
                                                    {angle, options.longest_edge, options.maximum_insertions});
  refiner.run();
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
 * \return what was reached, measured on the result
 * \throws what is thrown when faces are first touched
 *
 * Complexity: about linear in the flips and insertions, with a logarithm for the queue, and in the crossings of the
 * faces that are refined.
 */
template <class Triangulation>
Refinement_report refine(Edge_path_network<Triangulation>& network,
                         const Refinement_options& options = Refinement_options())
{
  return internal::refine(network.triangulation(), network, options);
}

/// \ingroup PkgFlipGeodesicsDelaunay
/// The same for a triangulation without curves. \pre no network lives in it
template <class Triangulation>
Refinement_report refine(Triangulation& triangulation, const Refinement_options& options = Refinement_options())
{
  internal::Triangulation_splitter<Triangulation> splitter = {triangulation};
  return internal::refine(triangulation, splitter, options);
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_REFINE_H
