// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_RAY_WINDOW_H
#define CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_RAY_WINDOW_H

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A part of an edge through which straight rays pass, in the frame that `Window_search` draws. */
struct Ray_window
{
  Input_halfedge_index halfedge;
  Index parent; // the window before, null_index if there is none
  Vertex_index root;
  double from, to, x, y, sigma, radius, margin;

  static constexpr double evaluation_error = 0x1p-50; // of the length of a path, from a root's and a point's

  static double norm(double x, double y) { return std::sqrt(x * x + y * y); }

  /* No path through the window to a place on its edge is shorter. */
  double least(double place) const
  {
    const double value = sigma + norm(place - x, y);
    return value - (radius + evaluation_error * value);
  }
};

/* The length of a path: not more than it is, as computed, and not less than that of one that there is. */
struct Path_length
{
  double least, computed, most;
  double error; // of the least one, since the last root
};

/* How a path arrives at a vertex: along a halfedge to it, or through a window; and the length since the last root. */
struct Path_arrival
{
  Index window = null_index;
  Input_halfedge_index along = null_index;
  double leg = 0;
};

/* What a search knows of a vertex. */
struct Reached_vertex
{
  Path_length length; // each the smallest of all paths
  Path_arrival arrival;
  double promised; // from which length the rays have to start at most that start here, for what they replace
  double started;  // from which they have started
  bool is_reached = false, has_started = false, has_tie = false;
};

/* A window whose rays are to go on, or a vertex from which rays are to start. */
struct Queued_rays
{
  double priority, least;
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

#endif // CGAL_FLIP_GEODESICS_INTERNAL_WINDOWS_RAY_WINDOW_H
