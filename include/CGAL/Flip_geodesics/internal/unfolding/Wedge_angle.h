// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WEDGE_ANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WEDGE_ANGLE_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/plane_vectors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <complex>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* An angle, in radians, and a bound of its error. */
struct Wedge_angle
{
  double value;
  double error;

  /* EQUAL if the error hides the result. */
  Comparison_result compare_with_straight() const
  {
    const double pi = boost::math::constants::pi<double>();
    if(!(std::abs(value - pi) > error))
      return EQUAL;
    return value < pi ? SMALLER : LARGER;
  }
};

/* Returns the angle of an edge from its reference halfedge: between 0 and pi, up to rounding, which can turn pi into
 * -pi. */
inline double angle_from_reference(const std::complex<double>& end)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const double angle = std::arg(end);
  return angle < -pi / 2 ? angle + 2 * pi : angle;
}

/* An angle and a complex number of any length that rotates by it, computed only by operations that IEEE 754 rounds
 * correctly. */
struct Wedge_rotation
{
  Wedge_angle angle;
  std::complex<double> rotation;
};

/* Two straight lines from one vertex, given by their edge sequences, and the number of input corners clockwise between
 * their references. */
struct Wedge_edge_sequences
{
  Edge_sequence from, to;
  Index steps;
};

/* Bounds the error from those of the strips at both ends, relative to their lengths, and `steps` corners in between. */
inline double error_of_wedge_angle(double from, double to, Index steps)
{
  return 1.6 * (from + to) + static_cast<double>(steps + 4) * input_corner_error; // including the arc sine
}

/* The angle counterclockwise from a halfedge of the input to the straight line of an edge sequence that starts at the
 * same vertex, and a bound of its error. Only at vertices of the input. */
struct Edge_sequence_angle
{
  Input_halfedge_index reference = null_index;
  double angle = 0;
  double error = 0;
};

/* The direction of a halfedge at its tail, computed from the input. A reference does not exist if an end of its edge is
 * an inserted vertex. */
struct Edge_end
{
  Halfedge_index halfedge = null_index;
  Edge_sequence_angle direction;
  bool is_along = false; // whether it is an edge of the input
};

/* The measured straightness of an edge. */
struct Measured_edge
{
  Edge_end tail, head;                       // the latter of the reverse direction
  double bend = 0;                           // the angle by which the edge leaves its strip of input faces
  bool has_strip = true, is_straight = true; // the latter exact; true if not examined
};

/* At the tail of an edge sequence. */
template <class Triangulation>
Edge_sequence_angle tail_angle(const Strip<Triangulation>& strip)
{
  return {strip.reference(), angle_from_reference(strip.end()), strip.relative_error()};
}

/* Returns the angle clockwise from one straight line to another, with a number of input corners between their
 * references. */
template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, const Edge_sequence_angle& from,
                        const Edge_sequence_angle& to, Index steps)
{
  return {from.angle - to.angle + sum_of_input_corners(triangulation, from.reference, steps).value(),
          error_of_wedge_angle(from.error, to.error, steps)};
}

/* Computes the wedge between two edge sequences from the input: the input corners between their reference halfedges,
 * corrected by their strips at both ends. \pre not around a point inside a face */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, const Wedge_edge_sequences& sequences)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const Strip<Triangulation> from(triangulation, sequences.from), to(triangulation, sequences.to);
  const bool is_on_edge = triangulation.is_inserted(sequences.from.tail);
  Angle_sum corners;
  if(!is_on_edge)
    corners = sum_of_input_corners(triangulation, from.reference(), sequences.steps);
  const double between = is_on_edge ? sequences.steps * pi : corners.value();
  const std::complex<double> half_turns = is_on_edge && sequences.steps % 2 != 0 ? -1 : 1;
  const double sum = angle_from_reference(from.end()) - angle_from_reference(to.end()) + between;
  return {{sum, error_of_wedge_angle(from.relative_error(), to.relative_error(), sequences.steps)},
          product(product(from.end(), std::conj(to.end())), half_turns * corners.rotation())};
}

template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, const Wedge_edge_sequences& sequences)
{
  return wedge_rotation(triangulation, sequences).angle;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WEDGE_ANGLE_H
