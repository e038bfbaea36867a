// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SOURCE_PART_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SOURCE_PART_H

#include <CGAL/Flip_geodesics/internal/distances/Face_sides.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* The weights of a point of a face, at the tail of a halfedge, its head and the third vertex; they sum to one. */
using Face_weights = std::array<double, 3>;

inline Face_weights rotated(const Face_weights& weights) { return {{weights[1], weights[2], weights[0]}}; }

/* Weights of any sum. \pre they are not all 0 */
inline Face_weights normalized(Face_weights weights)
{
  const double largest = (std::max)({weights[0], weights[1], weights[2]});
  const double sum = weights[0] / largest + weights[1] / largest + weights[2] / largest;
  for(double& weight : weights)
    weight = weight / largest / sum;
  return weights;
}

/* A point of a face in the frame of a side, from whose tail on its weights count. */
inline std::complex<double> position(const Face_side& side, const Face_weights& weights)
{
  return {weights[1] * side.length + weights[2] * side.x, weights[2] * side.y};
}

/* A part of a source in a face: a straight line between two points, which may be one. */
struct Source_part
{
  Input_halfedge_index halfedge; // a side of the face, from which the weights count
  std::array<Face_weights, 2> ends;
  double offset;
  std::size_t source;

  bool is_point() const { return ends[0] == ends[1]; }

  /* How far along the line, from 0 to 1, its point nearest to another in the face is. */
  double nearest(const Face_side& side, const Face_weights& weights) const
  {
    const auto first = position(side, ends[0]), along = position(side, ends[1]) - first;
    const double square = std::norm(along);
    if(!(square > 0))
      return 0;
    const double t = ((position(side, weights) - first) * std::conj(along)).real() / square;
    return (std::min)((std::max)(t, 0.0), 1.0);
  }

  Face_weights at(double t) const
  {
    Face_weights result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = t == 0 ? ends[0][i] : (t == 1 ? ends[1][i] : (1 - t) * ends[0][i] + t * ends[1][i]);
    return result;
  }

  double distance(const Face_side& side, const Face_weights& weights) const
  {
    return offset + std::abs(position(side, weights) - position(side, at(nearest(side, weights))));
  }

  /* The window of its rays that leave the face through a side, in the frame of that side; empty if there are none.
   * Of a line those perpendicular to it. */
  static Window window(const Face_side& side, const Face_weights& first, const Face_weights& last, double offset)
  {
    const std::complex<double> p = position(side, first), line = position(side, last) - p;
    Window w = {0, side.length, p.real(), p.imag(), offset, null_index, 0, false, Window_state::WAITING};
    if(line == std::complex<double>(0)) {
      w.to = w.y > 0 ? w.to : 0;
      return w;
    }
    const double length = std::abs(line);
    const std::complex<double> direction = line / length;
    const double down = std::abs(direction.real()); // the normal that leads below is (n, -down)
    if(!(down > perpendicular))
      return {0, 0, 0, 0, 0, null_index, 0, true, Window_state::WAITING};
    const double n = direction.real() > 0 ? direction.imag() : -direction.imag();
    const double a = p.real() + p.imag() * direction.imag() / direction.real(), b = a + length / direction.real();
    w.from = (std::max)((std::min)(a, b), 0.0);
    w.to = (std::min)((std::max)(a, b), side.length);
    w.is_far = true;
    w.sigma = offset - p.real() * n + p.imag() * down;
    w.x = -n;
    w.y = down;
    return w;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_SOURCE_PART_H
