// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTENING_REPORT_H
#define CGAL_FLIP_GEODESICS_SHORTENING_REPORT_H

#include <CGAL/Flip_geodesics/Certificate_verdict.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsShortening
/// How a curve came out of a shortening.
enum class Shortening_status {
  LOCALLY_SHORTEST,   ///< no side of a joint that is not blocked has an angle below \f$\pi\f$
  CONTRACTED,         ///< the curve has shrunk to a point
  LENGTH_LIMIT,       ///< a further step would have made the curve, or the network, shorter than allowed
  ANGLE_LIMIT,        ///< all angles that could be widened had reached the limit
  ITERATION_LIMIT,    ///< the allowed number of steps, or the time, was used up
  MEMORY_LIMIT,       ///< a further step would have made the records of flips larger than allowed
  STOPPED_BY_VISITOR, ///< the visitor's `go_further()` said no
  PRECISION_LIMIT,    ///< the traits' arithmetic, or coordinates rounded to double, could not tell whether the curve is
                      ///< locally shortest
  FLAT_FACES          ///< each angle is \f$\pi\f$ at least, but faces without area lie along the curve, and seen from
                      ///< beyond them it is bent
};

/// The name of a status, as the enumerator is spelled.
inline const char* to_string(Shortening_status status)
{
  switch(status) {
  case Shortening_status::LOCALLY_SHORTEST:
    return "LOCALLY_SHORTEST";
  case Shortening_status::CONTRACTED:
    return "CONTRACTED";
  case Shortening_status::LENGTH_LIMIT:
    return "LENGTH_LIMIT";
  case Shortening_status::ANGLE_LIMIT:
    return "ANGLE_LIMIT";
  case Shortening_status::ITERATION_LIMIT:
    return "ITERATION_LIMIT";
  case Shortening_status::MEMORY_LIMIT:
    return "MEMORY_LIMIT";
  case Shortening_status::STOPPED_BY_VISITOR:
    return "STOPPED_BY_VISITOR";
  case Shortening_status::PRECISION_LIMIT:
    return "PRECISION_LIMIT";
  case Shortening_status::FLAT_FACES:
    return "FLAT_FACES";
  }
  return "";
}

/// \ingroup PkgFlipGeodesicsShortening
/// What happened to one curve.
struct Curve_report
{
  Shortening_status status = Shortening_status::LOCALLY_SHORTEST; ///< how the shortening ended for it
  double initial_length = 0; ///< the length that it had at first, before anything was straightened
  double length = 0;         ///< the length that it has now, 0 if it has contracted
  /// The smallest angle, in radians, at a side of a joint that is not blocked; infinite where there is none.
  double smallest_angle = std::numeric_limits<double>::infinity();
  std::size_t flips = 0; ///< edge flips for this curve, those of steps that were taken back included
  /// Is it proven from the input to be locally shortest, as `certify()` does it? `NOT_CERTIFIED` with traits of which
  /// `Has_drift` is `CGAL::Tag_true`, and if coordinates or lengths of the mesh are not doubles.
  Certificate_verdict verdict = Certificate_verdict::NOT_CERTIFIED;
  /// Did it meet an edge of length zero, or folded faces, so that such edges were contracted? Set by the one-call
  /// functions.
  bool are_zero_edges_contracted = false;
};

/// \ingroup PkgFlipGeodesicsShortening
/// What a shortening did.
struct Shortening_report
{
  std::vector<Curve_report> curves; ///< one per curve of the network
  /// Edge flips, those of steps that were taken back included, and those by which a straightened path was inserted.
  std::size_t flips = 0;
  /// The steps that were taken [SC20, Algorithm 1]; the unit for a loop of one segment counts as one. It is 0 where a
  /// path was straightened beforehand, as functions do that get no stop predicate and no visitor, and needed no step.
  std::size_t flip_outs = 0;

  /// Is every curve of the network locally shortest, or contracted to a point, which is as short as can be?
  bool is_complete() const
  {
    for(const Curve_report& curve : curves)
      if(curve.status != Shortening_status::LOCALLY_SHORTEST && curve.status != Shortening_status::CONTRACTED)
        return false;
    return true;
  }
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTENING_REPORT_H
