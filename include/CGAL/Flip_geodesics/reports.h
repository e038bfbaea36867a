// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_REPORTS_H
#define CGAL_FLIP_GEODESICS_REPORTS_H

#include <CGAL/Flip_geodesics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Flip_geodesics {

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * States the certainty of what a function claims about its result, for example that a curve is locally shortest.
 * Section \ref Flip_geodesicsVerdicts lists the claims of the functions, and Section \ref Flip_geodesicsAssumptions the
 * assumptions under which verdicts hold.
 */
enum class Verdict {
  PROVEN, ///< the claim holds exactly
  /// no bend was found, but a sign was assumed to be zero without proof because the work limit was reached; see
  /// `Decision_statistics::unproven_zeros`
  PROBABLE,
  /// the claim is false: a segment is not straight in its strip of input faces, has an edge sequence that does not
  /// describe a strip, or touches a vertex with a total angle below \f$2\pi\f$
  BENT_SEGMENT,
  BENT_JOINT, ///< the claim is false: an unblocked side of a joint has an angle below \f$\pi\f$
  /// it is not known whether the claim holds, for one of these reasons: the predicates of the traits are inexact and
  /// `certify()` was not called; a search was not completed; a lower bound is too far below the length; coordinates or
  /// lengths of the mesh were rounded (see `Embedded_metric::is_rounded()`)
  UNDECIDED,
  /// the path is a `PROVEN` geodesic, and no path is shorter by more than the fraction
  /// `Shortest_path_report::rounding_tolerance()` of the length
  WITHIN_ROUNDING,
  WITHIN_TOLERANCE, ///< no path is shorter by more than the fraction `Shortest_path_report::tolerance()`
                    ///< of the length
};

/// \ingroup PkgFlipGeodesicsProving
/// Returns the name of a verdict, spelled like the enumerator.
inline const char* to_string(Verdict verdict)
{
  return internal::name_of(verdict, {"PROVEN", "PROBABLE", "BENT_SEGMENT", "BENT_JOINT", "UNDECIDED", "WITHIN_ROUNDING",
                                     "WITHIN_TOLERANCE"});
}

/// \ingroup PkgFlipGeodesicsProving
/// Returns whether a verdict confirms the claim, that is, whether it is `PROVEN`, `PROBABLE`, `WITHIN_ROUNDING` or
/// `WITHIN_TOLERANCE`.
inline bool is_confirmed(Verdict verdict)
{
  return verdict != Verdict::BENT_SEGMENT && verdict != Verdict::BENT_JOINT && verdict != Verdict::UNDECIDED;
}

namespace internal {

/* Returns the verdict on distances that are correct up to the tolerance of shortest paths, or that may be wrong. */
inline Verdict verdict_of_distances(bool are_right)
{
  return are_right ? Verdict::WITHIN_TOLERANCE : Verdict::UNDECIDED;
}

/* Returns the verdict on all curves of a range: that of the first one for which the claim is false, or else the
 * worst. */
template <class Curves, class VerdictOf>
Verdict verdict_of_curves(const Curves& curves, const VerdictOf& verdict_of)
{
  Verdict result = curves.empty() ? Verdict::UNDECIDED : Verdict::PROVEN;
  for(const auto& curve : curves) {
    const Verdict verdict = std::invoke(verdict_of, curve);
    if(verdict == Verdict::BENT_SEGMENT || verdict == Verdict::BENT_JOINT)
      return verdict;
    result = (std::max)(result, verdict);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgFlipGeodesicsTraits
/// Counts the filter failures of predicates, by the method that resolved them.
struct Decision_statistics
{
  std::size_t by_memory = 0;      ///< by the cached result for an angle between the same two edges; such failures are
                                  ///< not counted in the other members
  std::size_t by_strip = 0;       ///< by unfolded strips in double, or vectors in double-double arithmetic
  std::size_t by_plane = 0;       ///< by predicates on points, if faces are coplanar or bend only along parallel edges
  std::size_t by_precision = 0;   ///< in multiprecision arithmetic with 50 digits and an error bound
  std::size_t by_roots = 0;       ///< by exact arithmetic with the square roots of the faces' squared areas
  std::size_t zeros_by_plane = 0; ///< the number of signs counted in `by_plane` that were zero
  std::size_t zeros_by_roots = 0; ///< the number of signs counted in `by_roots` that were zero
  /// The number of signs that were assumed to be zero without proof, because 50 digits did not suffice and the work
  /// limit was reached; see `Certified_intrinsic_triangulation_traits::sign_work_limit()`.
  std::size_t unproven_zeros = 0;
  /// The largest number of square roots in an expression whose sign was computed by exact arithmetic. Roots that are
  /// rational multiples of one another count once.
  std::size_t most_roots = 0;

  /// Adds the counts of other statistics, and keeps the larger value of `most_roots`.
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
/// States how the shortening of a curve ended.
enum class Shortening_status {
  LOCALLY_SHORTEST,   ///< the curve is locally shortest; if predicates are inexact or coordinates were rounded, up to
                      ///< `Straightness::tolerance()`
  CONTRACTED,         ///< the curve has contracted to a point
  LENGTH_LIMIT,       ///< a further step would have made the curve, or the network, shorter than allowed
  ANGLE_LIMIT,        ///< each angle that a step could widen has reached the limit
  ITERATION_LIMIT,    ///< the allowed number of steps, or the allowed time, has been used up
  MEMORY_LIMIT,       ///< a further step would have made the records of flips larger than allowed
  STOPPED_BY_VISITOR, ///< `go_further()` of the visitor returned `false`
  /// the precision of the traits, or of rounded coordinates, did not suffice to decide whether the curve is locally
  /// shortest
  PRECISION_LIMIT,
  /// each angle is at least \f$\pi\f$, but the curve runs along degenerate faces and is bent if its angles are measured
  /// on the other side of these faces
  DEGENERATE_FACES
};

/// \ingroup PkgFlipGeodesicsShortening
/// Returns the name of a status, spelled like the enumerator.
inline const char* to_string(Shortening_status status)
{
  return internal::name_of(status, {"LOCALLY_SHORTEST", "CONTRACTED", "LENGTH_LIMIT", "ANGLE_LIMIT", "ITERATION_LIMIT",
                                    "MEMORY_LIMIT", "STOPPED_BY_VISITOR", "PRECISION_LIMIT", "DEGENERATE_FACES"});
}

/// \ingroup PkgFlipGeodesicsShortening
/// Reports the shortening of one curve.
struct Curve_report
{
  Shortening_status status = Shortening_status::LOCALLY_SHORTEST; ///< how the shortening ended
  double initial_length = 0; ///< the initial length of the curve, before any straightening
  double length = 0;         ///< the current length of the curve, 0 if it has contracted
  /// The smallest angle, in radians, at an unblocked side of a joint; infinite if no such side exists.
  double smallest_angle = std::numeric_limits<double>::infinity();
  std::size_t flips = 0; ///< the number of edge flips for this curve, including those of steps that were rolled back
  /// The verdict on the claim that the curve is locally shortest. It is `UNDECIDED` if coordinates or lengths of the
  /// mesh had to be rounded. It is also `UNDECIDED` if `Has_drift` of the traits is `CGAL::Tag_true`, unless the given
  /// ends of the curve coincide; call `certify()` to obtain a verdict in this case.
  Verdict verdict = Verdict::UNDECIDED;
  /// Whether degenerate edges and folded faces were contracted; see \ref Flip_geodesicsDegenerate. Only
  /// functions that take a mesh, such as `geodesic_path()`, set this member.
  bool are_zero_edges_contracted = false;
  /// The distance of each given point from the surface, measured in space; 0 for points given as vertices or locations.
  /// Only free functions that accept points in space set this member; it is empty for a path between two vertices.
  std::vector<double> point_distances;
};

/// \ingroup PkgFlipGeodesicsShortening
/// Reports the shortening of a network.
struct Shortening_report
{
  std::vector<Curve_report> curves; ///< one report per curve of the network
  /// The number of edge flips, including those of steps that were rolled back and those by which a straightened path
  /// was inserted.
  std::size_t flips = 0;
  /// The number of steps \cgalCite{SC20,Algorithm 1}; a compound step for a loop of one segment counts as one. The
  /// initial straightening of a path is not counted, so the number is 0 if the straightened path is already a geodesic.
  std::size_t flip_outs = 0;

  /// Returns whether every curve of the network is locally shortest or has contracted to a point.
  bool is_complete() const
  {
    for(const Curve_report& curve : curves)
      if(curve.status != Shortening_status::LOCALLY_SHORTEST && curve.status != Shortening_status::CONTRACTED)
        return false;
    return true;
  }

  /// Returns the total length of all curves.
  double length() const
  {
    double sum = 0;
    for(const Curve_report& curve : curves)
      sum += curve.length;
    return sum;
  }

  /// Returns the status of the first curve that is neither locally shortest nor a point. If there is no such curve, the
  /// result is `CONTRACTED` if there are curves and all of them are points, and `LOCALLY_SHORTEST` otherwise.
  Shortening_status status() const
  {
    bool has_curve = curves.empty();
    for(const Curve_report& curve : curves)
      if(curve.status == Shortening_status::LOCALLY_SHORTEST)
        has_curve = true;
      else if(curve.status != Shortening_status::CONTRACTED)
        return curve.status;
    return has_curve ? Shortening_status::LOCALLY_SHORTEST : Shortening_status::CONTRACTED;
  }

  /// Returns the verdict on the claim that all curves are locally shortest. If the claim is false for some curve, the
  /// result is the verdict on the first such curve. Otherwise, it is the worst verdict on a curve, where `UNDECIDED` is
  /// worse than `PROBABLE`, and `PROBABLE` is worse than `PROVEN`. The verdict of a report without curves is
  /// `UNDECIDED`.
  Verdict verdict() const { return internal::verdict_of_curves(curves, &Curve_report::verdict); }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the result of a function that computes one curve.
template <class OutputIterator>
struct Geodesic_result
{
  OutputIterator out;       ///< the past-the-end iterator of the output
  Shortening_report report; ///< the report, which has exactly one curve

  double length() const { return report.length(); }            ///< returns the length of the curve
  Shortening_status status() const { return report.status(); } ///< returns how the shortening ended
  Verdict verdict() const { return report.verdict(); }         ///< returns the verdict on the curve
};

/// \ingroup PkgFlipGeodesicsFunctions
/// Contains the result of a function that computes several curves.
template <class OutputIterator>
struct Geodesics_result
{
  OutputIterator out;       ///< the past-the-end iterator of the output
  Shortening_report report; ///< the report, with one entry per curve

  double length() const { return report.length(); }            ///< returns the total length of the curves
  Shortening_status status() const { return report.status(); } ///< returns `Shortening_report::status()`
  Verdict verdict() const { return report.verdict(); }         ///< returns `Shortening_report::verdict()`

  std::size_t number_of_curves() const { return report.curves.size(); } ///< returns the number of curves
  /// Returns the length of curve `i`.
  double length(std::size_t i) const { return report.curves.at(i).length; }
  /// Returns the status of curve `i`.
  Shortening_status status(std::size_t i) const { return report.curves.at(i).status; }
  /// Returns the verdict on curve `i`.
  Verdict verdict(std::size_t i) const { return report.curves.at(i).verdict; }
};

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_REPORTS_H
