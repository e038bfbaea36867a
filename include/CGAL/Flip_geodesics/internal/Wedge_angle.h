// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_ANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_ANGLE_H

#include <CGAL/Flip_geodesics/Intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/internal/Strip.h>

#include <CGAL/assertions.h>

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
};

/* The input corner at the head of input halfedge h. */
template <class Triangulation>
double input_corner(const Triangulation& triangulation, Index h)
{
  using Double_traits = Intrinsic_triangulation_traits<typename Triangulation::Metric::Kernel>;
  const auto face = triangulation.metric().face_geometry(triangulation.input(), h, Double_traits());
  return std::atan2(face[1].y, -face[1].x); // the layout puts h on the positive real axis
}

/* The angle of an edge from its reference halfedge: between 0 and pi, up to rounding, which can turn pi into -pi. */
inline double angle_from_reference(const std::complex<double>& end)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const double angle = std::arg(end);
  return angle < -pi / 2 ? angle + 2 * pi : angle;
}

/*
 * The angle clockwise from halfedge a to halfedge b about an inserted point inside an input face: the directions are
 * told from one halfedge of the face, and how often they pass it is seen from edge to edge, in corners below pi.
 */
template <class Triangulation>
Wedge_angle wedge_angle_inside_face(const Triangulation& triangulation, Index a, Index b)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const auto strip = [&](Index h) { return Strip<Triangulation>(triangulation, triangulation.crossing_word(h)); };
  const Strip<Triangulation> from = strip(a);
  double sum = 0, error = from.relative_error(), direction = std::arg(from.end());
  Index h = a;
  do {
    h = triangulation.clockwise(h);
    const Strip<Triangulation> to = strip(h);
    const double next_direction = std::arg(to.end()), corner = direction - next_direction;
    sum += corner < -pi / 2 ? corner + 2 * pi : (corner > 3 * pi / 2 ? corner - 2 * pi : corner);
    error += 16 * std::numeric_limits<double>::epsilon();
    direction = next_direction;
    if(h == b)
      error += to.relative_error();
  } while(h != b);
  return {sum, 1.6 * error};
}

/*
 * The angle clockwise from halfedge a to halfedge b of one vertex, afresh from the input: the input corners between
 * their reference halfedges, corrected by their strips at both ends. a == b means all the way round.
 */
template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, Index a, Index b)
{
  constexpr double corner_error = 100 * std::numeric_limits<double>::epsilon();
  const Location_kind kind = vertex_kind(triangulation, triangulation.tail(a));
  if(kind == Location_kind::FACE)
    return wedge_angle_inside_face(triangulation, a, b);
  const Crossing_word word_a = triangulation.crossing_word(a), word_b = triangulation.crossing_word(b);
  const Strip<Triangulation> from(triangulation, word_a), to(triangulation, word_b);
  const Index steps = triangulation.input_edges_in_wedge(a, b) + (word_a.along != null_index ? 1 : 0);
  double sum = angle_from_reference(from.end()) - angle_from_reference(to.end());
  Index h = from.reference();
  for(Index i = 0; i < steps; ++i) {
    const bool is_on_edge = kind == Location_kind::EDGE;
    sum += is_on_edge ? boost::math::constants::pi<double>() : input_corner(triangulation, Triangulation::twin(h));
    h = next_spoke(triangulation, word_a.tail, h);
  }
  CGAL_assertion(h == to.reference());
  const double strip_error = 1.6 * (from.relative_error() + to.relative_error()); // of the arc sine as well
  return {sum, strip_error + static_cast<double>(steps + 4) * corner_error};
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WEDGE_ANGLE_H
