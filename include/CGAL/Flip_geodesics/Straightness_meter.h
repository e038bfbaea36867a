// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_STRAIGHTNESS_METER_H
#define CGAL_FLIP_GEODESICS_STRAIGHTNESS_METER_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/flip_out/Curve_measurement.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>
#include <CGAL/Flip_geodesics/internal/unfolding/refresh_face.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {

/// \ingroup PkgFlipGeodesicsProving
/// How straight a curve is, measured from the input alone.
struct Straightness
{
  /// The largest angle, in radians, by which a segment leaves the strip of input faces that it is to cross.
  double largest_bend = 0;
  /// The smallest angle, in radians, at a side of a joint that is not blocked; infinite where there is none.
  double smallest_angle = std::numeric_limits<double>::infinity();

  /// The angle, in radians, by which a straight angle may be missed, 1e-8: far above the error of the measurement.
  static constexpr double tolerance() { return internal::reported_bend; }
  /// The angle, in radians, from which on a side of a joint counts as straight: \f$\pi\f$ less `tolerance()`.
  static constexpr double straight_angle() { return boost::math::constants::pi<double>() - tolerance(); }

  /// Takes the bend of a segment into account.
  void note_bend(double bend) { largest_bend = (std::max)(largest_bend, bend); }
  /// Takes the angle at a side of a joint into account.
  void note_angle(double angle) { smallest_angle = (std::min)(smallest_angle, angle); }

  /// Is the curve locally shortest up to `tolerance()`?
  bool is_locally_shortest() const { return largest_bend <= tolerance() && smallest_angle >= straight_angle(); }
};

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * Measures curves of a network afresh from the input: each segment's word of crossed input edges is unfolded from the
 * input's coordinates, and the angles at the joints are summed over input faces. Nothing that the flips computed enters
 * but integers, and so no error of theirs. The unfolding is in double, its own error some units in the last place per
 * face [SC20, section 5.1 has the idea of checking; the strips are this package's].
 *
 * Invalid after the triangulation has changed.
 *
 * \tparam Network a model of `CurveNetwork`, whose triangulation is one of `IntrinsicTriangulationOfMesh`
 */
template <class Network>
class Straightness_meter
{
  using Triangulation = typename Network::Triangulation;

public:
  /// Measures curves of a network, which must outlive the meter.
  explicit Straightness_meter(const Network& network)
    : m_network(network)
    , m_measurement(network)
  {
  }

  /// Measures one curve. Linear in the crossed input edges and in the degrees of the vertices it passes.
  Straightness operator()(Curve_index curve)
  {
    Straightness result;
    m_measurement(
        curve, [](Segment_index, const Crossing_word&) { return true; },
        [&](Segment_index, const Crossing_word&, const auto& strip) { result.note_bend(strip.bend()); },
        [&](const Joint&, const internal::Wedge_angle& angle) { result.note_angle(angle.value); });
    return result;
  }

  /// The angle at a side of a joint, in radians; infinite if the side is blocked, fixed or holds the border.
  double angle(const Joint& joint) const { return m_measurement.angle(joint).value; }

  /*!
   * Lays out the faces in the wedge at a side of a joint afresh, so that the triangulation's angles agree with the
   * input's again; drift can have spoiled them in needles.
   * \return is every corner of the faces between 0 and \f$\pi\f$? If not, the flips were wrong already.
   */
  bool refresh_wedge(const Joint& joint, Triangulation& triangulation)
  {
    const auto [a, b] = m_network.ends(joint);
    return internal::refresh_wedge(triangulation, a.halfedge, b.halfedge) !=
           internal::Refreshed_wedge::UP_TO_WRONG_FACE;
  }

private:
  const Network& m_network;
  internal::Curve_measurement<Network> m_measurement;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_STRAIGHTNESS_METER_H
