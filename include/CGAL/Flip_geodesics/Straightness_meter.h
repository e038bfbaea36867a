// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_STRAIGHTNESS_METER_H
#define CGAL_FLIP_GEODESICS_STRAIGHTNESS_METER_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/strips/Strip.h>
#include <CGAL/Flip_geodesics/internal/strips/Wedge_angle.h>
#include <CGAL/Flip_geodesics/internal/strips/refresh_face.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

  /// The angle, in radians, by which a straight angle may be missed: far above the error of the measurement.
  static constexpr double tolerance() { return 1e-8; }
  /// The angle, in radians, from which on a side of a joint counts as straight: \f$\pi\f$ less `tolerance()`.
  static constexpr double straight_angle() { return boost::math::constants::pi<double>() - tolerance(); }

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
  using Strip = internal::Strip<Triangulation>;

public:
  /// Measures curves of a network, which must outlive the meter.
  explicit Straightness_meter(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  /// Measures one curve. Linear in the crossed input edges and in the degrees of the vertices it passes.
  Straightness operator()(Curve_index curve)
  {
    Straightness result;
    m_segments.clear();
    m_network.for_each_segment(curve, [&](Segment_index s) {
      const Crossing_word word = m_triangulation.crossing_word(m_network.halfedge(s));
      const Strip strip(m_triangulation, word);
      result.largest_bend = (std::max)(result.largest_bend, strip.bend());
      m_segments.push_back({s, word.along != null_index, strip.reference(), strip.arrival_reference(),
                            internal::angle_from_reference(strip.end()),
                            internal::angle_from_reference(strip.arrival())});
    });
    for(std::size_t i = 0; i < m_segments.size(); ++i) {
      const Measured_segment &x = m_segments[i], &y = m_segments[(i + 1) % m_segments.size()];
      if(m_network.next(x.segment) == y.segment)
        result.smallest_angle = (std::min)({result.smallest_angle, angle_left(x, y), angle_right(x, y)});
    }
    return result;
  }

  /// The angle at a side of a joint, in radians; infinite if the side is blocked, fixed or holds the border.
  double angle(const Joint& joint) const
  {
    return angle_if_free(
        joint, [&](Halfedge_index a, Halfedge_index b) { return internal::wedge_angle(m_triangulation, a, b).value; });
  }

  /*!
   * Lays out the faces in the wedge at a side of a joint afresh, so that the triangulation's angles agree with the
   * input's again; drift can have spoiled them in needles.
   * \return is every corner of the faces between 0 and \f$\pi\f$? If not, the flips were wrong already.
   */
  bool refresh_wedge(const Joint& joint, Triangulation& triangulation)
  {
    const auto [a, b] = m_network.ends(joint);
    Halfedge_index h = a.halfedge;
    do {
      const Halfedge_index t = Triangulation::twin(h);
      if(m_triangulation.is_border(t))
        return true;
      if(!internal::refresh_face(triangulation, t))
        return false;
      h = m_triangulation.next(t);
    } while(h != b.halfedge);
    return true;
  }

private:
  struct Measured_segment
  {
    Segment_index segment;
    bool is_along;
    Input_halfedge_index at_tail, at_head; // the references of both directions
    double angle_at_tail, angle_at_head;

    bool has_both_ends() const { return at_tail != null_index && at_head != null_index; }
  };

  template <class Function>
  double angle_if_free(const Joint& joint, const Function& angle_clockwise) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if(m_network.is_head_fixed(joint.incoming))
      return infinity;
    const auto [a, b] = m_network.ends(joint);
    if(m_network.next_clockwise(a) != b)
      return infinity;
    return m_network.is_turning_back(joint) ? 0 : angle_clockwise(a.halfedge, b.halfedge);
  }

  // The angle from the head of x clockwise to the tail of y, as wedge_angle() has it, from what has been measured.
  double angle_left(const Measured_segment& x, const Measured_segment& y) const
  {
    if(!x.has_both_ends() || !y.has_both_ends()) // beside an inserted vertex
      return angle({x.segment, Side::LEFT});
    return angle_if_free({x.segment, Side::LEFT}, [&](Halfedge_index a, Halfedge_index b) {
      return x.angle_at_head - y.angle_at_tail + input_corners(a, b, x.at_head, x.is_along);
    });
  }

  double angle_right(const Measured_segment& x, const Measured_segment& y) const
  {
    if(!x.has_both_ends() || !y.has_both_ends())
      return angle({x.segment, Side::RIGHT});
    return angle_if_free({x.segment, Side::RIGHT}, [&](Halfedge_index a, Halfedge_index b) {
      return y.angle_at_tail - x.angle_at_head + input_corners(a, b, y.at_tail, y.is_along);
    });
  }

  // The input corners between the references of halfedges a and b, clockwise; that of a is given.
  double input_corners(Halfedge_index a, Halfedge_index b, Input_halfedge_index reference, bool is_along) const
  {
    const Index steps = m_triangulation.input_edges_in_wedge(a, b) + (is_along ? 1 : 0);
    return internal::sum_of_input_corners(m_triangulation, reference, steps).value();
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
  std::vector<Measured_segment> m_segments;
};

} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_STRAIGHTNESS_METER_H
