// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFICATE_VERDICT_H
#define CGAL_FLIP_GEODESICS_CERTIFICATE_VERDICT_H

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsProving
/// What a certificate says of a curve.
enum class Certificate_verdict {
  PROVEN,   ///< the curve is locally shortest, exactly
  PROBABLE, ///< no bend was found, but an angle was taken for \f$\pi\f$ without a proof, since the limit of work was
            ///< met, see `Decision_statistics::unproven_zeros`
  BENT_SEGMENT, ///< a segment does not run straight through its strip of input faces, or its word is no such strip; or
                ///< it touches a vertex, as happens along faces without area, whose angles sum up to less than
                ///< \f$2\pi\f$
  BENT_JOINT,   ///< a side of a joint that is not blocked has an angle below \f$\pi\f$
  NOT_CERTIFIED ///< there is no certificate: the traits' decisions are rounded, and `certify()` was not called; or
                ///< coordinates or lengths of the mesh are not doubles and were rounded, see
                ///< `Embedded_metric::is_rounded()`
};

/// The name of a verdict, as the enumerator is spelled.
inline const char* to_string(Certificate_verdict verdict)
{
  switch(verdict) {
  case Certificate_verdict::PROVEN:
    return "PROVEN";
  case Certificate_verdict::PROBABLE:
    return "PROBABLE";
  case Certificate_verdict::BENT_SEGMENT:
    return "BENT_SEGMENT";
  case Certificate_verdict::BENT_JOINT:
    return "BENT_JOINT";
  case Certificate_verdict::NOT_CERTIFIED:
    return "NOT_CERTIFIED";
  }
  return "";
}

/// \ingroup PkgFlipGeodesicsProving
/// Does a verdict say that a curve is locally shortest, `PROVEN` or `PROBABLE`?
inline bool is_locally_shortest(Certificate_verdict verdict)
{
  return verdict == Certificate_verdict::PROVEN || verdict == Certificate_verdict::PROBABLE;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CERTIFICATE_VERDICT_H
