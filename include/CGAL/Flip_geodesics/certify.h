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

namespace CGAL::Flip_geodesics {

/// \ingroup PkgFlipGeodesicsProving
/// Contains two measures of the straightness of a curve, computed from the input and the edge sequences of the curve.
struct Straightness
{
  /// The largest bend of a segment, in radians; 0 if no segment is bent. To define the bend of a segment, consider the
  /// unfolded strip of input faces and the straight line between the ends of the segment. The bend is the largest angle
  /// by which a vertex of the strip lies on the wrong side of this line, as seen from its nearer end.
  double largest_bend = 0;
  /// The smallest angle, in radians, at an unblocked side of a joint, or infinity if no such side exists.
  double smallest_angle = std::numeric_limits<double>::infinity();

  /// Returns the tolerance, 1e-8 radians. A segment counts as straight if its bend is at most the tolerance, and a side
  /// of a joint if its angle is at least \f$\pi\f$ minus the tolerance.
  static constexpr double tolerance() { return internal::reported_bend; }
  /// Returns the smallest angle, in radians, at which a side of a joint counts as straight: \f$\pi\f$ minus
  /// `tolerance()`.
  static constexpr double straight_angle() { return boost::math::constants::pi<double>() - tolerance(); }

  /// Updates `largest_bend` with the bend of a segment.
  void note_bend(double bend) { largest_bend = (std::max)(largest_bend, bend); }
  /// Updates `smallest_angle` with the angle at a side of a joint.
  void note_angle(double angle) { smallest_angle = (std::min)(smallest_angle, angle); }

  /// Returns whether the curve is locally shortest up to `tolerance()`.
  bool is_locally_shortest() const { return largest_bend <= tolerance() && smallest_angle >= straight_angle(); }
};

/// \ingroup PkgFlipGeodesicsProving
/// Contains the verdict on one curve and, if the curve is bent, the position of a bend.
struct Curve_certificate
{
  /// Constructs a certificate.
  explicit Curve_certificate(Verdict verdict, Segment_index segment = null_index, Side side = Side::LEFT)
    : segment(segment)
    , side(side)
    , m_verdict(verdict)
  {
  }

  Segment_index segment; ///< the bent segment, or the segment that arrives at the bent joint; null if nothing is bent
  Side side;             ///< the side of the bent joint on which the angle is below \f$\pi\f$

  /// Returns the verdict on the curve.
  Verdict verdict() const { return m_verdict; }

  /// Returns whether the curve is locally shortest, that is, whether the verdict is `PROVEN` or `PROBABLE`.
  bool is_locally_shortest() const { return is_confirmed(m_verdict); }

private:
  Verdict m_verdict;
};

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * Measures the straightness of the curves of a network on the input mesh.
 *
 * The input faces that a segment crosses are unfolded, and the angles at the joints are summed over input faces. Of the
 * triangulation, only the edge sequences of the segments are used, which consist of integers. Rounding errors of the
 * flips therefore do not affect the measurement. The unfolding is computed in double. The idea of such a check is due
 * to \cgalCite{SC20,section 5.1}.
 *
 * An object of this class becomes invalid when the edges of the triangulation change.
 *
 * \tparam Network a model of `CurveNetwork`, whose triangulation is a model of `IntrinsicTriangulationOfMesh`
 */
template <class Network>
class Straightness_meter
{
  using Triangulation = typename Network::Triangulation;
  using Edges = decltype(edge_straightness(std::declval<const Triangulation&>()));

public:
  /// Constructs an object that measures the curves of a network; the network must outlive the object.
  explicit Straightness_meter(const Network& network)
    : m_network(network)
    , m_edges(edge_straightness(network.triangulation()))
  {
  }

  /// Measures one curve.
  ///
  /// Complexity: linear in the number of crossed input edges plus the sum of the degrees of the vertices through which
  /// the curve passes.
  Straightness operator()(Curve_index curve)
  {
    Straightness result;
    m_segments.clear();
    m_network.for_each_segment(curve, [&](Segment_index s) { note(s, m_edges(m_network.halfedge(s)), result); });
    for_each_joint([&](const Measured_joint& joint) { result.note_angle(measured_angle(joint).value); });
    return result;
  }

  /// Measures one curve and certifies it as the free function `certify()` does, except that the certificate refers to
  /// the rounded mesh if coordinates or lengths of the mesh are rounded. The results are added to `straightness` and
  /// `statistics`. The measurement ends at the first segment whose edge sequence does not describe a strip of faces.
  Curve_certificate certify(Curve_index curve, Straightness& straightness, Decision_statistics& statistics)
  {
    Curve_certificate result(Verdict::PROVEN);
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
        result = Curve_certificate(Verdict::BENT_SEGMENT, s);
    });
    // The angle at a joint is that between the edge sequences of its segments, which all describe strips here.
    if(are_strips)
      for_each_joint([&](const Measured_joint& joint) {
        const auto angle = measured_angle(joint);
        straightness.note_angle(angle.value);
        if(result.is_locally_shortest() && std::isfinite(angle.value) &&
           m_edges.is_below_straight(joint.from, joint.to, angle, statistics))
          result = Curve_certificate(Verdict::BENT_JOINT, joint.joint.incoming, joint.joint.side);
      });
    if(result.is_locally_shortest() && statistics.unproven_zeros > unproven)
      return Curve_certificate(Verdict::PROBABLE);
    return result;
  }

  /// Returns the angle at a side of a joint, in radians, or infinity if the side is blocked by another segment, the
  /// border or a fixed node.
  double angle(const Joint& joint) const
  {
    const auto [a, b] = m_network.ends(joint);
    return measured_angle({joint, {a.halfedge, {}, false}, {b.halfedge, {}, false}}).value;
  }

  /*!
   * Recomputes, from the input, the faces in the wedge at a side of a joint. Rounding errors of flips can make the
   * angles of these faces inaccurate.
   * \return whether all faces could be recomputed; if not, rounding errors have caused incorrect flips
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
    Edge_end from, to; // the wedge extends clockwise from `from` to `to`
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
  std::vector<std::pair<Segment_index, Edge>> m_segments; // of the measured curve
};

/// \ingroup PkgFlipGeodesicsProving
/// Contains the verdicts on all curves of a network, and the statistics of the predicates.
struct Network_certificate
{
  std::vector<Curve_certificate> curves; ///< one certificate per curve, indexed by `Curve_index`
  Decision_statistics statistics;        ///< the filter failures, and how they were resolved

  /// Returns the verdict on the claim that every curve is locally shortest. If a curve is bent, the result is the
  /// verdict on the first bent curve. Otherwise, it is the worst verdict on a curve, where `UNDECIDED` is worse than
  /// `PROBABLE`, and `PROBABLE` is worse than `PROVEN`. If there are no curves, the verdict is `UNDECIDED`.
  Verdict verdict() const { return internal::verdict_of_curves(curves, &Curve_certificate::verdict); }

  /// Returns whether all curves are locally shortest, that is, whether all verdicts are `PROVEN` or `PROBABLE`.
  bool is_locally_shortest() const { return curves.empty() || is_confirmed(verdict()); }
};

/*!
 * \ingroup PkgFlipGeodesicsProving
 *
 * Determines by exact predicates whether the curves of a network are locally shortest on the input mesh. Of the traits
 * with which the curves were computed, only the work limit affects the result.
 *
 * A curve is locally shortest if it satisfies three conditions. First, the input faces that each segment crosses unfold
 * to a strip that contains the straight line between the ends of the segment. Second, this line does not touch, between
 * its ends, an interior vertex of the surface whose angles sum to less than \f$2\pi\f$. Third, each unblocked side of a
 * joint has an angle of at least \f$\pi\f$. The function compares exact real numbers, after a floating-point filter
 * with error bounds. The verdict on a contracted curve is `PROVEN`. If coordinates or lengths of the mesh must be
 * rounded (`Embedded_metric::is_rounded()`), no curve is certified, and all verdicts are `UNDECIDED`.
 *
 * \param network a model of `CurveNetwork`, whose triangulation is a model of `IntrinsicTriangulationOfMesh`
 * \return one certificate per curve
 *
 * Complexity: if the floating-point filter suffices, linear in the number of crossed input edges plus the sum of the
 * degrees of the vertices through which curves pass. If the number type of the mesh can represent numbers that must be
 * rounded, the function also takes time linear in the size of the mesh.
 *
 * \sa `certify_curve()`
 */
template <class Network>
Network_certificate certify(const Network& network)
{
  Network_certificate result;
  Straightness straightness;
  Straightness_meter<Network> meter(network);
  for(Curve_index c : internal::descriptors<Curve_index>(network.number_of_curves()))
    result.curves.push_back(meter.certify(c, straightness, result.statistics));
  if(internal::is_input_rounded(network.triangulation())) // the measured mesh differs from the input in this case
    for(Curve_certificate& curve : result.curves)
      curve = Curve_certificate(Verdict::UNDECIDED);
  return result;
}

} // namespace CGAL::Flip_geodesics

#endif // CGAL_FLIP_GEODESICS_CERTIFY_H
