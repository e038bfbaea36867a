// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFY_H
#define CGAL_FLIP_GEODESICS_CERTIFY_H

#include <CGAL/Flip_geodesics/Certificate_verdict.h>
#include <CGAL/Flip_geodesics/Decision_statistics.h>
#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/internal/surface/imported_number.h>

#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsProving
/// The verdicts on all curves of a network, and how the comparisons were decided.
struct Network_certificate
{
  std::vector<Curve_certificate> curves; ///< one per curve of the network, by its index
  Decision_statistics statistics;        ///< how the comparisons were decided

  /// Are all curves locally shortest, `PROVEN` or `PROBABLE`?
  bool is_locally_shortest() const
  {
    for(const Curve_certificate& curve : curves)
      if(!curve.is_locally_shortest())
        return false;
    return true;
  }
};

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * Proves from the input alone that the curves of a network are locally shortest, whatever traits computed them. Each
 * segment's word of crossed input edges unfolds to a strip that contains the straight line between its ends. Each side
 * of a joint that is not blocked has an angle of at least \f$\pi\f$. The comparisons are those of exact real numbers,
 * filtered by error bounds.
 *
 * A curve that has contracted is proven. If a coordinate or length of the mesh is not a double, no curve is certified:
 * the verdict is `Certificate_verdict::NOT_CERTIFIED`.
 *
 * Linear in the crossed input edges, where doubles suffice; linear in the mesh as well if its numbers can be others
 * than doubles.
 *
 * \param network a model of `CurveNetwork`, whose triangulation is one of `IntrinsicTriangulationOfMesh`
 */
template <class Network>
Network_certificate certify(const Network& network)
{
  Network_certificate result;
  Straightness straightness;
  Straightness_meter<Network> meter(network);
  for(Curve_index c : internal::descriptors<Curve_index>(network.number_of_curves()))
    result.curves.push_back(meter.certify(c, straightness, result.statistics));
  if(internal::is_input_rounded(network.triangulation())) // then it is not the mesh that is measured
    for(Curve_certificate& curve : result.curves)
      curve = {Certificate_verdict::NOT_CERTIFIED, null_index, Side::LEFT};
  return result;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CERTIFY_H
