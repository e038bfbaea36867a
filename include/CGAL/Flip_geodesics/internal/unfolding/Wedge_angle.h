// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WEDGE_ANGLE_H
#define CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WEDGE_ANGLE_H

#include <CGAL/Flip_geodesics/internal/numbers/Funnel.h>
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

  /* EQUAL if the error hides which it is. */
  Comparison_result compare_with_straight() const
  {
    const double pi = boost::math::constants::pi<double>();
    if(!(std::abs(value - pi) > error))
      return EQUAL;
    return value < pi ? SMALLER : LARGER;
  }
};

/* The angle of an edge from its reference halfedge: between 0 and pi, up to rounding, which can turn pi into -pi. */
inline double angle_from_reference(const std::complex<double>& end)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const double angle = std::arg(end);
  return angle < -pi / 2 ? angle + 2 * pi : angle;
}

/* An angle, and the rotation by it, of any length: by what IEEE 754 tells the last bit of. */
struct Wedge_rotation
{
  Wedge_angle angle;
  std::complex<double> rotation;
};

/*
 * The angle clockwise from halfedge a to halfedge b about an inserted point inside an input face: the directions are
 * told from one halfedge of the face, and how often they pass it is seen from edge to edge, in corners below pi.
 */
template <class Triangulation>
Wedge_rotation wedge_rotation_inside_face(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const auto strip = [&](Halfedge_index h) {
    return Strip<Triangulation>(triangulation, triangulation.crossing_word(h));
  };
  const Strip<Triangulation> from = strip(a);
  double sum = 0, error = from.relative_error(), direction = std::arg(from.end());
  std::complex<double> end;
  Halfedge_index h = a;
  do {
    h = triangulation.clockwise(h);
    const Strip<Triangulation> to = strip(h);
    const double next_direction = std::arg(to.end()), corner = direction - next_direction;
    sum += corner < -pi / 2 ? corner + 2 * pi : (corner > 3 * pi / 2 ? corner - 2 * pi : corner);
    error += measured_angle_error;
    direction = next_direction;
    if(h == b) {
      error += to.relative_error();
      end = to.end();
    }
  } while(h != b);
  return {{sum, 1.6 * error}, product(from.end(), std::conj(end))};
}

/* Two edges of one vertex by their words, and how many input corners lie between their references, clockwise. */
struct Wedge_words
{
  Crossing_word from, to;
  Index steps;
};

/* The words of the wedge clockwise from one halfedge of a vertex to another. */
template <class Triangulation>
Wedge_words wedge_words(const Triangulation& triangulation, Halfedge_index from, Halfedge_index to)
{
  Wedge_words result = {triangulation.crossing_word(from), triangulation.crossing_word(to), 0};
  result.steps = triangulation.input_edges_in_wedge(from, to) + (result.from.along != null_index ? 1 : 0);
  return result;
}

/* From those of the strips at both ends, relative to their lengths, and of so many corners in between. */
inline double error_of_wedge_angle(double from, double to, Index steps)
{
  return 1.6 * (from + to) + static_cast<double>(steps + 4) * input_corner_error; // of the arc sine as well
}

/* The wedge between two words, afresh from the input: the input corners between their reference halfedges, corrected by
 * their strips at both ends. \pre not about a point inside a face */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, const Wedge_words& words)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const Strip<Triangulation> from(triangulation, words.from), to(triangulation, words.to);
  const bool is_on_edge = triangulation.is_inserted(words.from.tail);
  Angle_sum corners;
  if(!is_on_edge)
    corners = sum_of_input_corners(triangulation, from.reference(), words.steps);
  const double between = is_on_edge ? words.steps * pi : corners.value();
  const std::complex<double> half_turns = is_on_edge && words.steps % 2 != 0 ? -1 : 1;
  const double sum = angle_from_reference(from.end()) - angle_from_reference(to.end()) + between;
  return {{sum, error_of_wedge_angle(from.relative_error(), to.relative_error(), words.steps)},
          product(product(from.end(), std::conj(to.end())), half_turns * corners.rotation())};
}

template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, const Wedge_words& words)
{
  return wedge_rotation(triangulation, words).angle;
}

/* The wedge clockwise from halfedge a to halfedge b of one vertex, afresh. a == b means all the way round. */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  if(vertex_kind(triangulation, triangulation.tail(a)) == Location_kind::FACE)
    return wedge_rotation_inside_face(triangulation, a, b);
  return wedge_rotation(triangulation, wedge_words(triangulation, a, b));
}

template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  return wedge_rotation(triangulation, a, b).angle;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_UNFOLDING_WEDGE_ANGLE_H
