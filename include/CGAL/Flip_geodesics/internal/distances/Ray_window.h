// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_RAY_WINDOW_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_RAY_WINDOW_H

#include <CGAL/Flip_geodesics/Descriptors.h>
#include <CGAL/Flip_geodesics/internal/numbers/Precise_number.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A part of an edge through which straight rays pass, in the frame that `Window_search` draws. */
template <class Number>
struct Basic_ray_window
{
  Input_halfedge_index halfedge;
  Index parent; // the window before, null_index if there is none
  Vertex_index root;
  Number from, to, x, y, sigma, radius, margin;

  // Of the length of a path, from a root's and a point's.
  static constexpr double evaluation_error = 8 * Number_rounding<Number>::unit;

  static Number norm(const Number& x, const Number& y)
  {
    using std::sqrt;
    return sqrt(x * x + y * y);
  }

  /* No path through the window to a place on its edge is shorter. */
  Number least(const Number& place) const
  {
    const Number value = sigma + norm(place - x, y);
    return value - (radius + evaluation_error * value);
  }
};

using Ray_window = Basic_ray_window<double>;

/* The length of a path: not more than it is, as computed, and not less than that of one that there is. */
template <class Number>
struct Path_length
{
  Number least, computed, most;
  Number error; // of the least one, since the last root
};

/* How a path arrives at a vertex: along a halfedge to it, or through a window; and the length since the last root. */
struct Path_arrival
{
  Index window = null_index;
  Input_halfedge_index along = null_index;
  double leg = 0;
};

/* What a search knows of a vertex. */
template <class Number>
struct Reached_vertex
{
  Path_length<Number> length; // each the smallest of all paths
  Path_arrival arrival;
  Number promised; // from which length the rays have to start at most that start here, for what they replace
  Number started;  // from which they have started
  bool is_source = false, is_reached = false, has_started = false, has_tie = false;
};

/* A window whose rays are to go on, or a vertex from which rays are to start. */
template <class Number>
struct Queued_rays
{
  double priority;
  Number least;
  Index id; // of a window or a vertex
  bool is_vertex;

  static std::size_t is_before(const Queued_rays& a, const Queued_rays& b)
  {
    if(a.priority != b.priority)
      return static_cast<std::size_t>(a.priority < b.priority);
    return static_cast<std::size_t>(a.is_vertex != b.is_vertex ? a.is_vertex : a.id < b.id);
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_RAY_WINDOW_H
