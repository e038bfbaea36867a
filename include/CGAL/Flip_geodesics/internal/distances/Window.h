// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Is a window still to be carried over the face that it enters, was it the last time that some of its edge were, or
 * before? */
enum class Window_state : std::uint8_t { DONE, WAITING, CROSSING };

/*
 * A part of an edge, and rays that cross it, in a frame whose x-axis is the edge: those from the point (x, -y), or those
 * parallel to (-x, y), if they come from a segment. So a source is (x : -y : 1) or (x : -y : 0) in homogeneous
 * coordinates, and most formulas are the same for both.
 *
 *          from    to
 *     0 -----======----- length
 *             .  .
 *              . .
 *               ..
 *             (x, -y)
 */
struct Window
{
  double from, to, x, y;
  double sigma;      // how long the paths were before the source; if rays are parallel, up to the origin
  Index root;        // the vertex that is the source; or, from their number on, a part of a source in a face
  std::uint8_t side; // which halfedge of the edge has the face that is entered
  bool is_far;       // are the rays parallel?
  Window_state state;

  double weight() const { return is_far ? 0 : 1; }

  /* The length of the path to a point above the edge, or on it. */
  double distance(double b, double height = 0) const
  {
    if(is_far)
      return sigma - x * b + y * height;
    const double dx = b - x, dy = height + y;
    return sigma + std::sqrt(dx * dx + dy * dy);
  }

  /* Returns the length of the path to a point above the edge whose ray crosses the edge at `crossing`. If that lies
   * outside of the window, the path bends at the nearer end: it is the shortest path through the window. */
  double bent_distance(double b, double height, double crossing) const
  {
    const double at = (std::min)((std::max)(crossing, from), to);
    return at == crossing ? distance(b, height) : distance(at) + std::hypot(b - at, height);
  }

  /* The least distance of all its points. */
  double least_distance() const
  {
    return is_far ? (std::min)(distance(from), distance(to)) : distance((std::min)((std::max)(x, from), to));
  }

  /* How fast the distance grows along the edge. */
  double slope(double b) const
  {
    if(is_far)
      return -x;
    const double dx = b - x;
    return dx / std::sqrt(dx * dx + y * y);
  }

  /* Where the ray to a point above the edge crosses the edge. */
  double crossing(double b, double height) const { return (x * height + b * y) / (y + weight() * height); }

  /* Bounds by how much the source moves, relative to the size of the frame, when a window is carried over a face. */
  static constexpr double step_error = window_step_error;

  /* The same through several faces. */
  static constexpr double place_error = window_place_error;

  /* The bound in the frame of an edge of a given length. */
  double error(double length) const { return place_error * (length + weight() * (std::abs(x) + y)); }

  /* Takes off the part that is nearer to the start of the edge, along the edge, if that is so far itself. */
  void trim(double to_start)
  {
    const double more = to_start * (1 + equal_paths) - sigma; // towards more windows
    if(!(distance(from) - sigma > from + more))
      return;
    if(distance(to) - sigma > to + more) {
      from = to;
      return;
    }
    const double b = is_far ? -more / (1 + x) : (x * x + y * y - more * more) / (2 * (x + more));
    from = (std::min)((std::max)(from, b), to);
  }

  /* Goes over to the frame of the opposite direction. */
  void mirror(double length)
  {
    const double end = length - from;
    from = length - to;
    to = end;
    if(is_far)
      sigma -= x * length;
    x = weight() * length - x;
  }
};

static_assert(sizeof(Window) == 48, "a window takes more memory than it should");

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_WINDOW_H
