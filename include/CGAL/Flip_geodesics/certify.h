// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFY_H
#define CGAL_FLIP_GEODESICS_CERTIFY_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/strips/Straight_strip.h>
#include <CGAL/Flip_geodesics/internal/strips/Wedge_comparison.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsProving
/// What a certificate says of a curve.
enum class Certificate_verdict {
  PROVEN,       ///< the curve is locally shortest, exactly
  PROBABLE,     ///< as `PROVEN`, but for angles that were taken for \f$\pi\f$ with a probability of error below
                ///< \f$2^{-100}\f$ each, see `Decision_statistics::unproven_zeros`
  BENT_SEGMENT, ///< a segment does not run straight through its strip of input faces, or its word is no such strip; or
                ///< it touches a vertex, as happens along faces without area, whose angles sum up to less than
                ///< \f$2\pi\f$
  BENT_JOINT    ///< a side of a joint that is not blocked has an angle below \f$\pi\f$
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
  }
  return "";
}

/// \ingroup PkgFlipGeodesicsProving
/// The verdict on one curve; if it is bent, where.
struct Curve_certificate
{
  Certificate_verdict verdict = Certificate_verdict::PROVEN; ///< what is said of the curve
  Segment_index segment = null_index; ///< the bent segment, or the one that arrives at the bent joint
  Side side = Side::LEFT;             ///< the side of the bent joint

  /// Is the curve locally shortest, `PROVEN` or `PROBABLE`?
  bool is_locally_shortest() const
  {
    return verdict == Certificate_verdict::PROVEN || verdict == Certificate_verdict::PROBABLE;
  }
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
  {
  }

  Curve_certificate operator()(Curve_index curve)
  {
    Curve_certificate result;
    const std::size_t unproven = m_statistics.unproven_zeros;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      if(result.is_locally_shortest() && !is_straight(s))
        result = {Certificate_verdict::BENT_SEGMENT, s, Side::LEFT};
    });
    // The angle of a joint is that between its segments' words, which are known to be true now.
    m_network.for_each_segment(curve, [&](Segment_index s) {
      for(Side side : {Side::LEFT, Side::RIGHT})
        if(result.is_locally_shortest() && is_bent({s, side}))
          result = {Certificate_verdict::BENT_JOINT, s, side};
    });
    if(result.is_locally_shortest() && m_statistics.unproven_zeros > unproven)
      result.verdict = Certificate_verdict::PROBABLE;
    return result;
  }

private:
  bool is_straight(Segment_index s)
  {
    return Straight_strip<Triangulation>(m_triangulation, m_statistics)(m_network.halfedge(s));
  }

  // Below pi, with nothing in the way?
  bool is_bent(const Joint& joint) const
  {
    if(m_network.is_head_fixed(joint.incoming))
      return false;
    const auto [a, b] = m_network.ends(joint);
    if(m_network.next_clockwise(a) != b)
      return false;
    if(m_network.is_turning_back(joint))
      return true;
    return Wedge_comparison<Triangulation>(m_triangulation, m_statistics)(a.halfedge, b.halfedge) == SMALLER;
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
  Decision_statistics& m_statistics;
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
 * A curve that has contracted is proven. Linear in the crossed input edges, where doubles suffice.
 *
 * \param network a model of `CurveNetwork`, whose triangulation is one of `IntrinsicTriangulationOfMesh`
 */
template <class Network>
Network_certificate certify(const Network& network)
{
  Network_certificate result;
  internal::Certifier<Network> certifier(network, result.statistics);
  for(Curve_index c : internal::descriptors<Curve_index>(network.number_of_curves()))
    result.curves.push_back(certifier(c));
  return result;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CERTIFY_H
