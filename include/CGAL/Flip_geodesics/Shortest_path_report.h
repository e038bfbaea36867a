// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_SHORTEST_PATH_REPORT_H
#define CGAL_FLIP_GEODESICS_SHORTEST_PATH_REPORT_H

#include <CGAL/Flip_geodesics/Shortening_report.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsFunctions
/// Is a path globally shortest?
enum class Shortest_path_verdict {
  UNCONFIRMED, ///< there may be a shorter one, or coordinates or lengths of the mesh are not doubles
  CONFIRMED,   ///< none is shorter by more than `Shortest_path_report::tolerance()`
  /// The same with `Shortest_path_report::proof_tolerance()`, and the path is `Certificate_verdict::PROVEN`.
  PROVEN_SHORTEST
};

/// \ingroup PkgFlipGeodesicsFunctions
/// The name of a verdict, as it is written here.
inline const char* to_string(Shortest_path_verdict verdict)
{
  switch(verdict) {
  case Shortest_path_verdict::CONFIRMED:
    return "CONFIRMED";
  case Shortest_path_verdict::PROVEN_SHORTEST:
    return "PROVEN_SHORTEST";
  default:
    return "UNCONFIRMED";
  }
}

/// \ingroup PkgFlipGeodesicsFunctions
/// What is known of a path that was to be shortest.
struct Shortest_path_report
{
  Shortening_report shortening; ///< of the one path

  double first_length = 0; ///< the length of the edge path that was searched first, once it was pulled tight
  double length = 0;       ///< the length of the result
  double lower_bound =
      0; ///< no path is shorter: a bound for the mesh with its coordinates as doubles, rounding included
  std::size_t windows = 0;                                            ///< what the search cost
  Shortest_path_verdict verdict = Shortest_path_verdict::UNCONFIRMED; ///< is the path globally shortest?
  /// Are there other paths as short, up to 2^-42 of the length, which is about 2e-13? Those that a confirmed one ties with
  /// are all found.
  bool has_tie = false;

  /// Is the path a geodesic?
  Shortening_status status() const { return shortening.curves.front().status; }

  /// Is the path globally shortest? If not, it may still be.
  bool is_confirmed() const { return verdict != Shortest_path_verdict::UNCONFIRMED; }

  /// By how much the path may be longer than a shortest one.
  double gap() const { return (std::max)(length - lower_bound, 0.0); }

  /// By what part of its length a path may be longer than a shortest one and is confirmed: 1e-10.
  static constexpr double tolerance() { return internal::confirmed_gap; }

  /// By what part of its length a path may be longer than a shortest one and is proven to be one: 1e-12.
  static constexpr double proof_tolerance() { return internal::proven_gap; }
};

/// \ingroup PkgFlipGeodesicsFunctions
/// What `shortest_path()` returns: where its output ends, and what is known of the path.
template <class OutputIterator>
struct Shortest_path_result
{
  OutputIterator out;          ///< the end of the output
  Shortest_path_report report; ///< what is known of the path

  double length() const { return report.length; }                  ///< the length of the path
  Shortening_status status() const { return report.status(); }     ///< whether the path is a geodesic
  Shortest_path_verdict verdict() const { return report.verdict; } ///< whether it is shown to be a shortest one
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_SHORTEST_PATH_REPORT_H
