// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_MEASUREMENT_H
#define CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_MEASUREMENT_H

#include <CGAL/Flip_geodesics/Crossing_word.h>
#include <CGAL/Flip_geodesics/Joint.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Wedge_angle.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Curves of a network afresh from the input: unfolds each segment's strip once, in double, and has the angles of its
 * joints from what both strips say. Nothing that the flips computed enters but integers.
 */
template <class Network>
class Curve_measurement
{
  using Triangulation = typename Network::Triangulation;

public:
  explicit Curve_measurement(const Network& network)
    : m_network(network)
    , m_triangulation(network.triangulation())
  {
  }

  /* Calls `on_segment(segment, word, strip)` for each segment, then `on_joint(joint, angle)` for each side of a joint;
   * and nothing more as soon as `is_strip(segment, word)` says that a word cannot be unfolded. */
  template <class IsStrip, class OnSegment, class OnJoint>
  void operator()(Curve_index curve, const IsStrip& is_strip, const OnSegment& on_segment, const OnJoint& on_joint)
  {
    m_segments.clear();
    bool are_strips = true;
    m_network.for_each_segment(curve, [&](Segment_index s) {
      const Crossing_word word = m_triangulation.crossing_word(m_network.halfedge(s));
      are_strips = are_strips && is_strip(s, word);
      if(!are_strips)
        return;
      const Strip<Triangulation> strip(m_triangulation, word);
      on_segment(s, word, strip);
      m_segments.push_back({s, word.along != null_index, strip.reference(), strip.arrival_reference(),
                            angle_from_reference(strip.end()), angle_from_reference(strip.arrival()),
                            strip.relative_error(), strip.arrival_error()});
    });
    for(std::size_t i = 0; i < m_segments.size() && are_strips; ++i) {
      const Measured_segment &x = m_segments[i], &y = m_segments[(i + 1) % m_segments.size()];
      if(m_network.next(x.segment) != y.segment)
        continue;
      on_joint(Joint{x.segment, Side::LEFT}, angle_left(x, y));
      on_joint(Joint{x.segment, Side::RIGHT}, angle_right(x, y));
    }
  }

  /* The angle at a side of a joint; infinite if the side is blocked, fixed or holds the border. */
  Wedge_angle angle(const Joint& joint) const
  {
    return angle_if_free(joint, [&](Halfedge_index a, Halfedge_index b) { return wedge_angle(m_triangulation, a, b); });
  }

private:
  struct Measured_segment
  {
    Segment_index segment;
    bool is_along;
    Input_halfedge_index at_tail, at_head; // the references of both directions
    double angle_at_tail, angle_at_head;
    double error_at_tail, error_at_head;

    bool has_both_ends() const { return at_tail != null_index && at_head != null_index; }
  };

  template <class Function>
  Wedge_angle angle_if_free(const Joint& joint, const Function& angle_clockwise) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if(m_network.is_head_fixed(joint.incoming))
      return {infinity, 0};
    const auto [a, b] = m_network.ends(joint);
    if(m_network.next_clockwise(a) != b)
      return {infinity, 0};
    return m_network.is_turning_back(joint) ? Wedge_angle{0, 0} : angle_clockwise(a.halfedge, b.halfedge);
  }

  // The angle from the head of x clockwise to the tail of y, as wedge_angle() has it, from what has been measured.
  Wedge_angle angle_left(const Measured_segment& x, const Measured_segment& y) const
  {
    if(!x.has_both_ends() || !y.has_both_ends()) // beside an inserted vertex
      return angle({x.segment, Side::LEFT});
    return angle_if_free({x.segment, Side::LEFT}, [&](Halfedge_index a, Halfedge_index b) {
      return with_corners(x.angle_at_head - y.angle_at_tail, x, y, a, b, x.at_head, x.is_along);
    });
  }

  Wedge_angle angle_right(const Measured_segment& x, const Measured_segment& y) const
  {
    if(!x.has_both_ends() || !y.has_both_ends())
      return angle({x.segment, Side::RIGHT});
    return angle_if_free({x.segment, Side::RIGHT}, [&](Halfedge_index a, Halfedge_index b) {
      return with_corners(y.angle_at_tail - x.angle_at_head, x, y, a, b, y.at_tail, y.is_along);
    });
  }

  // Adds the input corners between the references of halfedges a and b, clockwise; that of a is given.
  Wedge_angle with_corners(double angle, const Measured_segment& x, const Measured_segment& y, Halfedge_index a,
                           Halfedge_index b, Input_halfedge_index reference, bool is_along) const
  {
    const Index steps = m_triangulation.input_edges_in_wedge(a, b) + (is_along ? 1 : 0);
    return {angle + sum_of_input_corners(m_triangulation, reference, steps).value(),
            error_of_wedge_angle(x.error_at_head, y.error_at_tail, steps)};
  }

  const Network& m_network;
  const Triangulation& m_triangulation;
  std::vector<Measured_segment> m_segments;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_FLIP_OUT_CURVE_MEASUREMENT_H
