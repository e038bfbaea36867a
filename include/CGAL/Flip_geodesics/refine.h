// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REFINE_H
#define CGAL_FLIP_GEODESICS_REFINE_H

#include <CGAL/Flip_geodesics/Surface_point.h>
#include <CGAL/Flip_geodesics/delaunay.h>
#include <CGAL/Flip_geodesics/exceptions.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/triangulation/Delaunay_refiner.h>
#include <CGAL/Flip_geodesics/internal/triangulation/outgoing_halfedges.h>
#include <CGAL/Flip_geodesics/named_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsDelaunay
/// Specifies the bounds and limits of `refine()`.
struct Refinement_options
{
  /// the lower bound for the angles of all faces, in degrees, from 0 (no bound) to 30; with a bound above 30 degrees,
  /// the process would rarely terminate
  double smallest_angle = 25;
  /// the upper bound for the lengths of all edges, at least 1e-70, in the unit of the mesh
  double longest_edge = std::numeric_limits<double>::infinity();
  std::size_t maximum_insertions = 1000000; ///< the maximal number of new vertices, including
                                            ///< those that split edges
};

/// \ingroup PkgFlipGeodesicsDelaunay
/// States how a refinement ended.
enum class Refinement_status {
  BOUNDS_REACHED,       ///< all faces are within the bounds, or are exempt
  BOUNDS_NOT_REACHABLE, ///< each face that violates a bound and is not exempt was refused or given up; see `refine()`
  VERTEX_LIMIT,         ///< `Refinement_options::maximum_insertions` vertices were inserted, and did not suffice
  STOPPED_BY_VISITOR    ///< the visitor ended the refinement; the triangulation need not be Delaunay
};

/// \ingroup PkgFlipGeodesicsDelaunay
/// Reports the steps and the result of `refine()`.
struct Refinement_report
{
  Refinement_status status = Refinement_status::BOUNDS_REACHED; ///< how the process ended
  std::size_t insertions = 0;                                   ///< the number of vertices inserted inside faces
  std::size_t splits = 0;                                       ///< the number of splits of edges under curves or on
                                                                ///< the border
  std::size_t flips = 0;                                        ///< the number of flips, including those that were
                                                                ///< undone
  std::size_t refused = 0;        ///< the number of faces that were refused; see `refine()`
  double smallest_angle = 0;      ///< the smallest angle of all faces, in degrees
  double smallest_free_angle = 0; ///< the smallest angle of the faces not counted in `exempt`, in degrees
  std::size_t exempt = 0;         ///< the number of exempt faces whose smallest angle is below the bound
  std::size_t missed = 0;         ///< the number of faces that violate a bound and are not exempt
  std::size_t given_up = 0;       ///< the number of faces counted in `missed` that were given up
  /// Returns whether the bounds have been reached.
  bool is_complete() const { return status == Refinement_status::BOUNDS_REACHED; }
};

namespace internal {

template <class Triangulation, class Refiner>
void measure_faces(const Triangulation& triangulation, Refiner& refiner, double angle_bound, Refinement_report& report)
{
  constexpr double degree = boost::math::constants::degree<double>();
  report.smallest_angle = report.smallest_free_angle = 180;
  for(Halfedge_index h : internal::descriptors<Halfedge_index>(triangulation.number_of_halfedges())) {
    if(triangulation.is_border(h) || least_in_face(triangulation, h) != h)
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

/* Checks whether the bounds are in the range in which a refinement can terminate. \throws Invalid_parameter_error if
 * they are not */
inline void check_options(const Refinement_options& options)
{
  if(!(options.smallest_angle >= 0 && options.smallest_angle <= 30))
    throw Invalid_parameter_error("the smallest angle of a refinement is " + written(options.smallest_angle) +
                                  " degrees, but must be between 0 and 30");
  if(!(options.longest_edge >= least_length))
    throw Invalid_parameter_error("the longest edge allowed in a refinement is " + written(options.longest_edge) +
                                  ", but must be at least 1e-70");
}

/* \param on_split as for `Intrinsic_triangulation::insert()` */
template <class Triangulation, class OnSplit, class Visitor>
Refinement_report refine(Triangulation& triangulation, const OnSplit& on_split, const Refinement_options& options,
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
  using Refiner = Delaunay_refiner<Triangulation, OnSplit, Visitor>;
  Refiner refiner(triangulation, on_split, {angle, options.longest_edge, options.maximum_insertions}, visitor);
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
 * Refines a triangulation until no angle is too small and no edge is too long.
 *
 * The function first flips edges until all edges that carry no curve are locally Delaunay. It then inserts vertices at
 * the circumcenters of *bad* faces, that is, faces that violate a bound and are not exempt. The worst face is processed
 * first, and each insertion is followed by flips \cgalCite{SSC19,section 4.3}. The edges of curves and of the border
 * are constrained: if such an edge lies between a face and its circumcenter, or is too close to the circumcenter, no
 * vertex is inserted at the circumcenter; the edge is split at a new vertex instead. Apart from rounding errors, curves
 * therefore remain geodesics of unchanged length, and the surface does not change.
 *
 * \attention Since the positions of inserted vertices on curves are rounded, also with exact kernels, `certify()`
 * usually finds a bend of the size of a rounding error at such a vertex. Call `certify()` before the refinement. After
 * it, `Straightness_meter` determines whether the curves are straight up to a tolerance.
 *
 * Bad faces are skipped in two cases. A face is *refused* if the precision is too low to represent the point at which a
 * vertex must be inserted. Faces are *given up* if `Refinement_options::maximum_insertions` is far too small, as on a
 * tube whose length is a million times its thickness. An estimate of the required number of vertices detects this case
 * early. The faces that would require the most vertices are then given up, as well as all bad faces with equally short
 * or shorter sides. The other faces are improved.
 *
 * Faces with edges that are too long are never given up. They are processed before all other faces, the one with the
 * longest edge first. The vertices are therefore distributed evenly over the surface even if the limit on insertions
 * ends the process. An upper bound \f$L\f$ on the lengths of edges requires about \f$A/L^2\f$ vertices on a surface
 * of area \f$A\f$.
 *
 * Two kinds of faces are *exempt* from the bound on angles. In a face of the first kind, the smallest angle is part of
 * an angle of less than 60 degrees between two constrained edges, or lies at a vertex whose angles sum to less than 60
 * degrees. Insertions change neither the angle between the two edges nor the sum at the vertex. In a face of the second
 * kind, the shortest side connects two constrained edges that meet at an angle of less than 60 degrees, and the
 * distances of its ends from the common vertex of the two edges differ by less than 20 %. An insertion at this side
 * would cause another insertion closer to the common vertex, and so on without end \cgalCite{S02}.
 *
 * \param network an `Edge_path_network`. Its triangulation is refined, and must be a model of
 *        `IntrinsicTriangulationOfMesh`
 * \param options the bounds and limits. In practice, the process terminates even without a limit on insertions if the
 *        bound on angles is at most about 25 degrees
 * \param np an optional sequence of named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{a visitor. Its `go_further()` is called before each edge that the initial flips examine,
 *       and later before each bad face; its `on_flip()` is called after each flip, and its `on_insertion()` after each
 *       insertion of a vertex}
 *     \cgalParamType{a model of `RefinementVisitor`, which is copied unless it is passed by `std::ref()`}
 *     \cgalParamDefault{no visitor}
 *     \cgalParamExtra{If the visitor ends the process or throws an exception, the triangulation and its curves are
 *       valid, and the lengths of the curves are unchanged.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return a report on the refined triangulation
 * \throws Invalid_parameter_error if the options are out of range
 * \throws Occupied_triangulation_error if another network has curves in the triangulation; in this case the
 *         triangulation is unchanged
 * \throws Invalid_mesh_error if a face that has not been accessed before is not a triangle
 * \throws Degenerate_face_error if such a face has a degenerate edge or violates the triangle inequality
 * \throws Invalid_coordinate_error if such a face has a coordinate or length that is not finite or is out of range
 *
 * Complexity: up to a logarithmic factor for the priority queue, about linear in the number of flips plus the number of
 * insertions plus the number of input edges that cross the refined faces. The time of an insertion into an input face
 * does not depend on the number of earlier insertions into this face.
 */
template <class Network, class... NamedParameters, std::enable_if_t<internal::has_curves<Network>, int> = 0>
Refinement_report refine(Network& network, const Refinement_options& options = Refinement_options(),
                         const NamedParameters&... np)
{
  if(network.triangulation().number_of_holds() != internal::edges_under_curves(network).size())
    throw Occupied_triangulation_error("the triangulation cannot be refined, since a network other than the given one "
                                       "has curves in it");
  auto visitor = internal::make_visitor(internal::options_of<internal_np::visitor_t>(np...));
  return internal::refine(network.triangulation(), internal::Internals<Network>::divide_bundles(network), options,
                          visitor.get());
}

/// \ingroup PkgFlipGeodesicsDelaunay
/// Refines a triangulation without curves until no angle is too small and no edge is too long. The options, named
/// parameters and exceptions are those of `refine()` for a network.
/// \throws Occupied_triangulation_error if a network has curves in the triangulation
template <class Triangulation, class... NamedParameters,
          std::enable_if_t<!internal::has_curves<Triangulation>, int> = 0>
Refinement_report refine(Triangulation& triangulation, const Refinement_options& options = Refinement_options(),
                         const NamedParameters&... np)
{
  if(triangulation.number_of_holds() > 0)
    throw Occupied_triangulation_error(
        "a triangulation that has curves cannot be refined without their network; pass the network to refine()");
  auto visitor = internal::make_visitor(internal::options_of<internal_np::visitor_t>(np...));
  return internal::refine(
      triangulation, [](const auto&) {}, options, visitor.get());
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_REFINE_H
