// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_CERTIFY_H
#define CGAL_FLIP_GEODESICS_CERTIFY_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/mistakes.h>
#include <CGAL/Flip_geodesics/reports.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

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

/// \ingroup PkgFlipGeodesicsProving
/// The verdict on one curve; if it is bent, where.
struct Curve_certificate
{
  Verdict verdict = Verdict::PROVEN;  ///< what is said of the curve
  Segment_index segment = null_index; ///< the bent segment, or the one that arrives at the bent joint
  Side side = Side::LEFT;             ///< the side of the bent joint

  /// Is the curve locally shortest, `PROVEN` or `PROBABLE`?
  bool is_locally_shortest() const { return Flip_geodesics::is_confirmed(verdict); }
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
  using Edges = decltype(edge_straightness(std::declval<const Triangulation&>()));

public:
  /// Measures curves of a network, which must outlive the meter.
  explicit Straightness_meter(const Network& network)
    : m_network(network)
    , m_edges(edge_straightness(network.triangulation()))
  {
  }

  /// Measures one curve. Linear in the crossed input edges and in the degrees of the vertices it passes.
  Straightness operator()(Curve_index curve)
  {
    Straightness result;
    m_segments.clear();
    m_network.for_each_segment(curve, [&](Segment_index s) { note(s, m_edges(m_network.halfedge(s)), result); });
    for_each_joint([&](const Measured_joint& joint) { result.note_angle(measured_angle(joint).value); });
    return result;
  }

  /// Measures one curve, and certifies it as `certify()` does, which see, but whatever the coordinates or lengths of
  /// the mesh are. It is not measured from a segment on whose word is not one of a strip.
  Curve_certificate certify(Curve_index curve, Straightness& straightness, Decision_statistics& statistics)
  {
    Curve_certificate result;
    const std::size_t unproven = statistics.unproven_zeros;
    m_segments.clear();
    bool are_strips = true;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      if(!are_strips)
        return;
      const Edge edge = m_edges.certified(m_network.halfedge(s), result.is_locally_shortest(), statistics);
      are_strips = edge.has_strip;
      if(are_strips)
        note(s, edge, straightness);
      if(result.is_locally_shortest() && !(edge.has_strip && edge.is_straight))
        result = {Verdict::BENT_SEGMENT, s, Side::LEFT};
    });
    // The angle of a joint is that between its segments' words, which are known to be true then.
    if(are_strips)
      for_each_joint([&](const Measured_joint& joint) {
        const auto angle = measured_angle(joint);
        straightness.note_angle(angle.value);
        if(result.is_locally_shortest() && std::isfinite(angle.value) &&
           m_edges.is_below_straight(joint.from, joint.to, angle, statistics))
          result = {Verdict::BENT_JOINT, joint.joint.incoming, joint.joint.side};
      });
    if(result.is_locally_shortest() && statistics.unproven_zeros > unproven)
      result.verdict = Verdict::PROBABLE;
    return result;
  }

  /// The angle at a side of a joint, in radians; infinite if the side is blocked, fixed or holds the border.
  double angle(const Joint& joint) const
  {
    const auto [a, b] = m_network.ends(joint);
    return measured_angle({joint, {a.halfedge, {}, false}, {b.halfedge, {}, false}}).value;
  }

  /*!
   * Lays out the faces in the wedge at a side of a joint afresh, so that the triangulation's angles agree with the
   * input's again; drift can have spoiled them in needles.
   * \return is every corner of the faces between 0 and \f$\pi\f$? If not, the flips were wrong already.
   */
  bool refresh_wedge(const Joint& joint, Triangulation& triangulation)
  {
    const auto [a, b] = m_network.ends(joint);
    return Edges::refresh_wedge(triangulation, a.halfedge, b.halfedge);
  }

private:
  using Edge = typename Edges::Measured_edge;
  using Edge_end = decltype(Edge::tail);

  struct Measured_joint
  {
    Joint joint;
    Edge_end from, to; // the wedge at its side leads clockwise from one to the other
  };

  void note(Segment_index s, const Edge& edge, Straightness& straightness)
  {
    straightness.note_bend(edge.bend);
    m_segments.emplace_back(s, edge);
  }

  template <class Function>
  void for_each_joint(const Function& function) const
  {
    for(std::size_t i = 0; i < m_segments.size(); ++i) {
      const auto& [x, edge_x] = m_segments[i];
      const auto& [y, edge_y] = m_segments[(i + 1) % m_segments.size()];
      if(m_network.next(x) != y)
        continue;
      function({{x, Side::LEFT}, edge_x.head, edge_y.tail});
      function({{x, Side::RIGHT}, edge_y.tail, edge_x.head});
    }
  }

  auto measured_angle(const Measured_joint& joint) const
  {
    using Angle = decltype(m_edges.clockwise(joint.from, joint.to));
    const auto [a, b] = m_network.ends(joint.joint);
    if(m_network.is_head_fixed(joint.joint.incoming) || m_network.next_clockwise(a) != b)
      return Angle{std::numeric_limits<double>::infinity(), 0};
    return m_network.is_turning_back(joint.joint) ? Angle{0, 0} : m_edges.clockwise(joint.from, joint.to);
  }

  const Network& m_network;
  Edges m_edges;
  std::vector<std::pair<Segment_index, Edge>> m_segments; // of the curve that is measured
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

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * Proves from the input alone that the curves of a network are locally shortest, whatever traits computed them. Each
 * segment's word of crossed input edges unfolds to a strip that contains the straight line between its ends. Each side
 * of a joint that is not blocked has an angle of at least \f$\pi\f$. The comparisons are those of exact real numbers,
 * filtered by error bounds.
 *
 * A curve that has contracted is proven. If a coordinate or length of the mesh is not a double, no curve is certified:
 * the verdict is `Verdict::UNDECIDED`.
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
      curve = {Verdict::UNDECIDED, null_index, Side::LEFT};
  return result;
}

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_CERTIFY_H
