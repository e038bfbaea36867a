// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_BETWEEN_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_BETWEEN_H

#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/Edge_sequence_ends.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Strip.h>

#include <boost/math/constants/constants.hpp>

#include <complex>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/*
 * Computes the angle clockwise from halfedge a to halfedge b around an inserted point inside an input face. Directions
 * are relative to one halfedge of the face; the number of times that they pass it follows from edge to edge, in corners
 * below pi.
 */
template <class Triangulation>
Wedge_rotation wedge_rotation_inside_face(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const auto strip = [&](Halfedge_index h) {
    return Strip<Triangulation>(triangulation, triangulation.edge_sequence(h));
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

/* Returns the edge sequences of the wedge clockwise from one halfedge of a vertex to another. */
template <class Triangulation>
Wedge_edge_sequences wedge_sequences(const Triangulation& triangulation, Halfedge_index from, Halfedge_index to)
{
  Wedge_edge_sequences result = {triangulation.edge_sequence(from), triangulation.edge_sequence(to), 0};
  result.steps = triangulation.input_edges_in_wedge(from, to) + (result.from.along != null_index ? 1 : 0);
  return result;
}

/* Recomputes the wedge clockwise from halfedge a to halfedge b of one vertex from the input. a == b means the full
 * turn. */
template <class Triangulation>
Wedge_rotation wedge_rotation(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  if(vertex_kind(triangulation, triangulation.tail(a)) == Location_kind::FACE)
    return wedge_rotation_inside_face(triangulation, a, b);
  return wedge_rotation(triangulation, wedge_sequences(triangulation, a, b));
}

template <class Triangulation>
Wedge_angle wedge_angle(const Triangulation& triangulation, Halfedge_index a, Halfedge_index b)
{
  return wedge_rotation(triangulation, a, b).angle;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_WEDGE_BETWEEN_H
