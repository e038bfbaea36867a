// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REFINE_H
#define CGAL_FLIP_GEODESICS_REFINE_H

#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>
#include <CGAL/Flip_geodesics/stop_predicates.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDelaunay
/// What `refine()` is to reach, and how far it may go.
struct Refinement_options
{
  double smallest_angle = 25; ///< in degrees, of every face; 0 is no bound. At most 30, above which few inputs end
  double longest_edge = std::numeric_limits<double>::infinity(); ///< of every edge, at least 1e-70, in the mesh's units
  std::size_t maximum_insertions = 1000000;                      ///< of vertices, those that split edges included
};

/// \ingroup PkgFlipGeodesicsDelaunay
/// How a refinement has ended.
enum class Refinement_status {
  BOUNDS_REACHED,       ///< all faces are within the bounds, or exempt
  BOUNDS_NOT_REACHABLE, ///< all faces that violate a bound are refused or given up, see `Refinement_report`
  VERTEX_LIMIT,         ///< `Refinement_options::maximum_insertions` vertices were inserted
  STOPPED_BY_VISITOR    ///< the triangulation may not even be Delaunay
};

/// \ingroup PkgFlipGeodesicsDelaunay
/// What `refine()` did, and what it reached.
struct Refinement_report
{
  Refinement_status status = Refinement_status::BOUNDS_REACHED; ///< how it has ended
  std::size_t insertions = 0;                                   ///< of vertices inside faces
  std::size_t splits = 0;                                       ///< of edges under curves or on the border
  std::size_t flips = 0;                                        ///< flips, those taken back included
  std::size_t refused = 0;        ///< faces left as they are, since numbers are too coarse for a point to be inserted
  double smallest_angle = 0;      ///< of all faces, in degrees
  double smallest_free_angle = 0; ///< of the faces that are not exempt, see `refine()`
  std::size_t exempt = 0;         ///< faces whose smallest angle is below the bound, but where there is no other way
  std::size_t missed = 0;         ///< faces that violate a bound and are not exempt
  std::size_t given_up = 0;       ///< those among them that are too thin to be mended by the vertices allowed
  /// Are the bounds reached?
  bool is_complete() const { return status == Refinement_status::BOUNDS_REACHED; }
};

namespace internal {

/* Puts points into a triangulation without curves. */
template <class Triangulation>
struct Triangulation_splitter
{
  Vertex_index insert(const Surface_location& location, Known_piece& close_by)
  {
    return Internals<Triangulation>::insert(
        triangulation, location, [](const auto&) {}, close_by);
  }
  Vertex_index split_edge(Halfedge_index h, const Surface_location& location, std::size_t gap)
  {
    return triangulation.split_edge(h, location, gap, [](const auto&) {});
  }

  Triangulation& triangulation;
};

template <class Triangulation, class Refiner>
void measure_faces(const Triangulation& triangulation, Refiner& refiner, double angle_bound, Refinement_report& report)
{
  constexpr double degree = boost::math::constants::degree<double>();
  report.smallest_angle = report.smallest_free_angle = 180;
  for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges())) {
    if(triangulation.is_border(h) || Face_shape<Triangulation>::first_halfedge(triangulation, h) != h)
      continue;
    const double angle = Face_shape<Triangulation>(triangulation, h).smallest_angle();
    report.smallest_angle = (std::min)(report.smallest_angle, angle / degree);
    const bool is_missed = refiner.badness(h) > 0;
    report.missed += is_missed ? 1 : 0;
    report.given_up += is_missed && refiner.is_given_up(h) ? 1 : 0;
    if(angle < angle_bound && refiner.is_exempt(h))
      ++report.exempt;
    else
      report.smallest_free_angle = (std::min)(report.smallest_free_angle, angle / degree);
  }
}

template <class End>
Refinement_status refinement_status(End end, std::size_t missed)
{
  if(end == End::VISITOR)
    return Refinement_status::STOPPED_BY_VISITOR;
  if(missed == 0)
    return Refinement_status::BOUNDS_REACHED;
  return end == End::LIMIT ? Refinement_status::VERTEX_LIMIT : Refinement_status::BOUNDS_NOT_REACHABLE;
}

/* Beyond these bounds a refinement goes on to its limit, whatever the mesh. \throws Invalid_parameter_error */
inline void check_options(const Refinement_options& options)
{
  if(!(options.smallest_angle >= 0 && options.smallest_angle <= 30))
    throw Invalid_parameter_error("the smallest angle of a refinement is to be " +
                                  std::to_string(options.smallest_angle) + " degrees, which is not between 0 and 30");
  if(!(options.longest_edge >= least_length)) {
    std::ostringstream number;
    number << options.longest_edge;
    throw Invalid_parameter_error("the longest edge of a refinement is to be " + number.str() +
                                  " long, which is no number of at least 1e-70: no edge is shorter");
  }
}

template <class Triangulation, class Splitter, class Visitor>
Refinement_report refine(Triangulation& triangulation, Splitter& splitter, const Refinement_options& options,
                         Visitor& visitor)
{
  constexpr double degree = boost::math::constants::degree<double>();
  check_options(options);
  const double angle = options.smallest_angle * degree;
  Refinement_report report;
  const Delaunay_report flipped =
      flip_to_delaunay(triangulation, descriptors<Edge_index>(triangulation.number_of_edges()),
                       default_maximum_of_flips(triangulation.number_of_edges()), visitor);
  report.flips = flipped.flips;
  using Refiner = Delaunay_refiner<Triangulation, Splitter, Visitor>;
  Refiner refiner(triangulation, splitter, {angle, options.longest_edge, options.maximum_insertions}, visitor);
  const typename Refiner::End end = flipped.is_stopped ? Refiner::End::VISITOR : refiner.run();
  report.splits = refiner.counts().splits;
  report.insertions = refiner.number_of_new_vertices() - report.splits;
  report.refused = refiner.counts().refused;
  report.flips += refiner.flips();
  measure_faces(triangulation, refiner, angle, report);
  report.status = refinement_status(end, report.missed);
  return report;
}

} // namespace internal

/*!
 * \ingroup PkgFlipGeodesicsDelaunay
 *
 * Refines a triangulation until no angle is too small and no edge too long. It flips the triangulation to Delaunay.
 * Then it inserts vertices at the circumcentres of bad faces, worst first, each followed by flips [SSC19, section 4.3].
 * Curves and the border are constrained: where they are in the way, they are split at vertices on them, and so stay
 * geodesics, with the same length. The surface does not change. The places of vertices on curves are rounded, so that
 * `certify()` finds them bent there, by a rounding: ask it before.
 *
 * Faces that cannot be mended are left. They are *refused* where numbers are too coarse for a point. They are *given
 * up* where `Refinement_options::maximum_insertions` vertices are too few by far, as on a tube a million times as long
 * as thick. The latter is foreseen: a face of area A with shortest side s takes about A/s^2 vertices where all are as
 * thin, and far fewer elsewhere. It can be that the sum over all bad faces is 16 times what is allowed, and twice in a
 * row does not fall by a tenth while as many faces are treated. Then the worst of them are given up, and with them all
 * that have as short a side. The others are mended until these sums do not fall either.
 *
 * Edges that are too long are not given up. They are divided, longest first, until none is left or the limit is reached:
 * edges of length L take about A/L^2 vertices on a surface of area A. So a bound that no edge meets spreads the vertices
 * that are allowed.
 *
 * Some faces are exempt from the bound on angles. In one kind the smallest angle lies between two constrained edges
 * that meet under less than 60 degrees, or about a vertex whose angles sum to less. No insertion could make that angle
 * larger. In the other the shortest side joins two constrained edges at equal distances from such a vertex. An
 * insertion there would call for another one closer to it, without end [Shewchuk 2002].
 *
 * \param network an `Edge_path_network`, whose triangulation is refined, a model of `IntrinsicTriangulationOfMesh`
 * \param options the bounds; up to about 25 degrees the process ends by itself in practice
 * \param np named parameters: `visitor`, a model of `RefinementVisitor`, which is copied unless it is given by
 *        `std::ref()`: `go_further()` is called before each flip to Delaunay and then before each bad face, `on_flip()`
 *        after each flip and `on_insertion()` after each vertex. If it ends the process, or throws an exception, the
 *        triangulation and its curves are valid, and the curves as long as before
 * \return what was reached, measured on the result
 * \throws Invalid_parameter_error for bounds that make no sense; what is thrown when faces are first touched
 * \throws Occupied_triangulation_error if another network has curves in the triangulation; nothing is changed then
 *
 * Complexity: about linear in the flips and insertions, with a logarithm for the queue, and in the crossings of the
 * faces that are refined: how many points an input face has got does not slow further ones down.
 */
template <class Network, class... NamedParameters,
          std::enable_if_t<internal::Is_curve_network<Network>::value, int> = 0>
Refinement_report refine(Network& network, const Refinement_options& options = Refinement_options(),
                         const NamedParameters&... np)
{
  if(network.triangulation().number_of_holds() != internal::edges_under_curves(network).size())
    throw Occupied_triangulation_error("a triangulation in which several networks have curves cannot be refined");
  auto splitter = internal::Internals<Network>::splitter(network);
  auto visitor = internal::make_visitor(internal::options_of<internal_np::visitor_t>(np...));
  return internal::refine(network.triangulation(), splitter, options, visitor.get());
}

/// \ingroup PkgFlipGeodesicsDelaunay
/// The same for a triangulation without curves. \throws Occupied_triangulation_error if a network in it has some
template <class Triangulation, class... NamedParameters,
          std::enable_if_t<!internal::Is_curve_network<Triangulation>::value, int> = 0>
Refinement_report refine(Triangulation& triangulation, const Refinement_options& options = Refinement_options(),
                         const NamedParameters&... np)
{
  if(triangulation.number_of_holds() > 0)
    throw Occupied_triangulation_error("a triangulation that has curves is refined by way of their network");
  internal::Triangulation_splitter<Triangulation> splitter = {triangulation};
  auto visitor = internal::make_visitor(internal::options_of<internal_np::visitor_t>(np...));
  return internal::refine(triangulation, splitter, options, visitor.get());
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_REFINE_H
