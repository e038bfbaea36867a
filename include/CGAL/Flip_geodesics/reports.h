// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REPORTS_H
#define CGAL_FLIP_GEODESICS_REPORTS_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * How certain the claim of a function is. A function for geodesics claims that a curve is locally shortest, one for
 * shortest paths that no path between the same ends is shorter, one for homotopy classes that no path of the class is
 * shorter, one for distances that no path is shorter than the distance. The section \ref Flip_geodesicsVerdicts
 * states the assumptions.
 */
enum class Verdict {
  PROVEN,       ///< the claim holds exactly
  PROBABLE,     ///< no bend was found, but an angle was taken for \f$\pi\f$ without a proof, since the limit of work
                ///< was reached, see `Decision_statistics::unproven_zeros`
  BENT_SEGMENT, ///< the claim is false: a segment does not run straight through its strip of input faces, or its edge
                ///< sequence is not such a strip; or it touches a vertex with a total angle below \f$2\pi\f$
  BENT_JOINT,   ///< the claim is false: a side of a joint that is not blocked has an angle below \f$\pi\f$
  UNDECIDED,    ///< it is not known whether the claim holds: the decisions of the traits are rounded and `certify()`
                ///< was not called, a search was not completed, or coordinates or lengths of the mesh
                ///< were rounded, see `Embedded_metric::is_rounded()`
  WITHIN_ROUNDING,  ///< the claim holds for every path that is shorter by more than
                    ///< `Shortest_path_report::rounding_tolerance()` of the length, and the path is a `PROVEN` geodesic
  WITHIN_TOLERANCE, ///< the claim holds up to `Shortest_path_report::tolerance()` of the length
};

/// \ingroup PkgFlipGeodesicsProving
/// Returns the name of a verdict, as the enumerator is spelled.
inline const char* to_string(Verdict verdict)
{
  switch(verdict) {
  case Verdict::PROVEN:
    return "PROVEN";
  case Verdict::PROBABLE:
    return "PROBABLE";
  case Verdict::BENT_SEGMENT:
    return "BENT_SEGMENT";
  case Verdict::BENT_JOINT:
    return "BENT_JOINT";
  case Verdict::UNDECIDED:
    return "UNDECIDED";
  case Verdict::WITHIN_ROUNDING:
    return "WITHIN_ROUNDING";
  case Verdict::WITHIN_TOLERANCE:
    return "WITHIN_TOLERANCE";
  }
  return "";
}

/// \ingroup PkgFlipGeodesicsProving
/// Returns whether a verdict confirms the claim: `PROVEN`, `PROBABLE`, `WITHIN_ROUNDING` or `WITHIN_TOLERANCE`.
inline bool is_confirmed(Verdict verdict)
{
  return verdict != Verdict::BENT_SEGMENT && verdict != Verdict::BENT_JOINT && verdict != Verdict::UNDECIDED;
}

namespace internal {

/* The verdict on distances that are right up to the tolerance of shortest paths, or may be wrong. */
inline Verdict verdict_of_distances(bool are_right)
{
  return are_right ? Verdict::WITHIN_TOLERANCE : Verdict::UNDECIDED;
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsTraits
/// How the decisions that the filter left open were taken.
struct Decision_statistics
{
  std::size_t by_memory = 0;      ///< as before: of an angle between the same two edges; counted nowhere else
  std::size_t by_strip = 0;       ///< by vectors of doubles, or of pairs of doubles, with an error bound
  std::size_t by_plane = 0;       ///< by points: all faces lie in one plane, or bend along parallel edges only
  std::size_t by_precision = 0;   ///< by numbers of 50 digits with an error bound
  std::size_t by_roots = 0;       ///< by exact arithmetic with the roots of the faces' areas
  std::size_t zeros_by_plane = 0; ///< of `by_plane`: exactly straight
  std::size_t zeros_by_roots = 0; ///< of `by_roots`: exactly straight
  /// Taken for exactly straight without a proof: 50 digits do not tell, and the limit of work was met, see
  /// `Certified_intrinsic_triangulation_traits::sign_work_limit()`.
  std::size_t unproven_zeros = 0;
  /// The largest number of roots in one sign of which no two are rational multiples of each other.
  std::size_t most_roots = 0;

  /// Adds further decisions.
  Decision_statistics& operator+=(const Decision_statistics& other)
  {
    by_memory += other.by_memory;
    by_strip += other.by_strip;
    by_plane += other.by_plane;
    by_precision += other.by_precision;
    by_roots += other.by_roots;
    zeros_by_plane += other.zeros_by_plane;
    zeros_by_roots += other.zeros_by_roots;
    unproven_zeros += other.unproven_zeros;
    most_roots = (std::max)(most_roots, other.most_roots);
    return *this;
  }
};

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
  DEGENERATE_FACES    ///< each angle is \f$\pi\f$ at least, but faces without area lie along the curve, and seen from
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
  case Shortening_status::DEGENERATE_FACES:
    return "DEGENERATE_FACES";
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
  /// Is the curve locally shortest, as `certify()` decides it from the input? `UNDECIDED` with traits of which
  /// `Has_drift` is `CGAL::Tag_true`, and if coordinates or lengths of the mesh are not doubles.
  Verdict verdict = Verdict::UNDECIDED;
  /// Did it meet an edge of length zero, or folded faces, so that such edges were contracted? Set by the one-call
  /// functions.
  bool are_zero_edges_contracted = false;
  /// How far the points that were given are from the surface, in space and in their order; 0 for those that are given as
  /// vertices or locations. Set by functions that take points; empty if all are vertices by their type.
  std::vector<double> point_distances;
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

/// \ingroup PkgFlipGeodesicsFunctions
/// What is known of a path that was to be shortest.
struct Shortest_path_report
{
  Shortening_report shortening; ///< of the one path

  double first_length = 0; ///< the length of the edge path that was searched first, once it was pulled tight
  double length = 0;       ///< the length of the result
  double lower_bound =
      0; ///< no path is shorter: a bound for the mesh with its coordinates as doubles, rounding included
  std::size_t windows = 0;              ///< what the search cost
  Verdict verdict = Verdict::UNDECIDED; ///< is no path shorter?
  /// Are there other paths as short, up to 2^-42 of the length, which is about 2e-13? Those that a confirmed one ties with
  /// are all found.
  bool has_tie = false;

  /// Is the path a geodesic?
  Shortening_status status() const { return shortening.curves.front().status; }

  /// Is the path confirmed to be a shortest one? If not, it may still be.
  bool is_confirmed() const { return Flip_geodesics::is_confirmed(verdict); }

  /// By how much the path may be longer than a shortest one.
  double gap() const { return (std::max)(length - lower_bound, 0.0); }

  /// The part of its length by which a path may be longer than a shortest one if it is `WITHIN_TOLERANCE`: 1e-10.
  static constexpr double tolerance() { return internal::confirmed_gap; }

  /// The part of its length by which a path may be longer than a shortest one if it is `WITHIN_ROUNDING`: 1e-12.
  static constexpr double rounding_tolerance() { return internal::proven_gap; }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// What `shortest_path()` returns: where its output ends, and what is known of the path.
template <class OutputIterator>
struct Shortest_path_result
{
  OutputIterator out;          ///< the end of the output
  Shortest_path_report report; ///< what is known of the path

  double length() const { return report.length; }              ///< the length of the path
  Shortening_status status() const { return report.status(); } ///< whether the path is a geodesic
  Verdict verdict() const { return report.verdict; }           ///< whether no path is shorter
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_REPORTS_H
