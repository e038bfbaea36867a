// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFY_H
#define CGAL_FLIP_GEODESICS_CERTIFY_H

#include <CGAL/Flip_geodesics/Certificate_verdict.h>
#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/Straightness_meter.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_measurement.h>
#include <CGAL/Flip_geodesics/internal/surface/imported_number.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_comparison.h>

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsProving
/// The verdict on one curve; if it is bent, where.
struct Curve_certificate
{
  Certificate_verdict verdict = Certificate_verdict::PROVEN; ///< what is said of the curve
  Segment_index segment = null_index; ///< the bent segment, or the one that arrives at the bent joint
  Side side = Side::LEFT;             ///< the side of the bent joint

  /// Is the curve locally shortest, `PROVEN` or `PROBABLE`?
  bool is_locally_shortest() const { return Flip_geodesics::is_locally_shortest(verdict); }
};

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

namespace internal {

template <class Network>
class Certifier
{
  using Triangulation = typename Network::Triangulation;

public:
  Certifier(const Network& network, Decision_statistics& statistics)
    : m_network(network)
    , m_triangulation(network.triangulation())
    , m_statistics(statistics)
    , m_measurement(network)
    , m_is_rounded(is_input_rounded(network.triangulation()))
  {
  }

  /* Measures the curve, too: what doubles with a bound of their error tell is not decided again. */
  Curve_certificate operator()(Curve_index curve, Straightness& straightness)
  {
    Curve_certificate result;
    const std::size_t unproven = m_statistics.unproven_zeros;
    const Straight_strip<Triangulation> is_straight(m_triangulation, m_statistics);
    const auto is_strip = [&](Segment_index s, const Crossing_word& word) {
      const bool is_one = is_straight.is_strip(m_network.halfedge(s), word);
      if(result.is_locally_shortest() && !is_one)
        result = {Certificate_verdict::BENT_SEGMENT, s, Side::LEFT};
      return is_one;
    };
    const auto on_segment = [&](Segment_index s, const Crossing_word& word, const auto& strip) {
      straightness.note_bend(strip.bend());
      if(result.is_locally_shortest() && !is_straight(word, strip))
        result = {Certificate_verdict::BENT_SEGMENT, s, Side::LEFT};
    };
    // The angle of a joint is that between its segments' words, which are known to be true then.
    const auto on_joint = [&](const Joint& joint, const Wedge_angle& angle) {
      straightness.note_angle(angle.value);
      if(result.is_locally_shortest() && is_bent(joint, angle))
        result = {Certificate_verdict::BENT_JOINT, joint.incoming, joint.side};
    };
    m_measurement(curve, is_strip, on_segment, on_joint);
    if(result.is_locally_shortest() && m_statistics.unproven_zeros > unproven)
      result.verdict = Certificate_verdict::PROBABLE;
    return m_is_rounded ? Curve_certificate{Certificate_verdict::NOT_CERTIFIED, null_index, Side::LEFT} : result;
  }

private:
  // Below pi, with nothing in the way?
  bool is_bent(const Joint& joint, const Wedge_angle& angle) const
  {
    const Comparison_result quick = angle.compare_with_straight();
    if(quick != EQUAL) {
      m_statistics.by_strip += std::isfinite(angle.value) ? 1 : 0;
      return quick == SMALLER;
    }
    const auto [a, b] = m_network.ends(joint);
    return Wedge_comparison<Triangulation>(m_triangulation, m_statistics)(a.halfedge, b.halfedge) == SMALLER;
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
  Curve_measurement<Network> m_measurement;
  bool m_is_rounded; // the input; then it is not the mesh that is measured
};

} // namespace internal

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
  internal::Certifier<Network> certifier(network, result.statistics);
  for(Curve_index c : internal::descriptors<Curve_index>(network.number_of_curves()))
    result.curves.push_back(certifier(c, straightness));
  return result;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CERTIFY_H
