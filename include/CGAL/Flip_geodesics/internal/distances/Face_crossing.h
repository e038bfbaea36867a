// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FACE_CROSSING_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FACE_CROSSING_H

#include <CGAL/Flip_geodesics/internal/distances/Face_sides.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* A window that is carried over a face, in the frame of the side by which it enters. */
struct Crossing_window
{
  Window window;
  double crossing; // where the ray to the vertex opposite crosses the side
};

/* All that cross a face from one side together. */
struct Face_crossing
{
  Crossing_window *first, *last;
  Input_halfedge_index halfedge, next, previous; // the side by which they enter, and those that follow it
  Vertex_index apex;                             // the vertex opposite
  bool is_shorter;                               // is the way there shorter than others?
  const Crossing_window* nearest;                // has the shortest; null if none has one
  double distance;                               // of the vertex by it

  /* Nothing crosses it. */
  void clear()
  {
    first = last = nullptr;
    is_shorter = false;
  }

  /* Turns them into the frame of the side, and finds the nearest. */
  template <class Sides>
  void begin(Input_halfedge_index h, const Sides& sides)
  {
    const Face_side& f = sides.known(h);
    halfedge = h;
    next = f.next;
    previous = sides.known(next).next;
    apex = sides.known(previous).tail;
    nearest = nullptr;
    distance = std::numeric_limits<double>::infinity();
    for(Crossing_window* i = first; i != last; ++i) {
      Window& w = i->window;
      if(!is_first_side(halfedge))
        w.mirror(f.length);
      const double c = i->crossing = w.crossing(f.x, f.y);
      if(!(c > w.from - beside_window * f.length && c < w.to + beside_window * f.length))
        continue;
      const double through = w.bent_distance(f.x, f.y, c);
      // If the ray misses its window, it reaches the apex only if the bent path is as long as the straight line.
      if(!(c >= w.from && c <= w.to) && through - w.distance(f.x, f.y) > equal_paths * through)
        continue;
      if(through < distance) {
        distance = through;
        nearest = i;
      }
    }
    is_shorter = nearest != nullptr;
  }

  /* Calls `function` with what arrives at the side at the tail, in the frame of its twin.. */
  template <class Function>
  void arrive_left(const Face_side& f, double length, const Function& function) const
  {
    const double best = nearest == nullptr ? 0 : nearest->crossing, limit = best + beside_window * f.length;
    for(const Crossing_window* i = first; i != last; ++i) {
      const Window& w = i->window;
      const double c = i->crossing;
      if(!(c > w.from) || (is_split(*i) && c > limit))
        continue;
      // Of a window the part before the ray to the apex, which crosses at c.
      Window child = turned(w, f.cosine, f.sine, (std::min)(c, w.to), c < w.to + w.error(f.length), length);
      if(!(child.y > 0))
        continue;
      child.mirror(length);
      function(child);
    }
  }

  /* The same at the side at the head: mirror images. */
  template <class Function>
  void arrive_right(const Face_side& f, const Face_side& fn, const Function& function) const
  {
    const double best = nearest == nullptr ? 0 : nearest->crossing, limit = best - beside_window * f.length;
    for(const Crossing_window* i = first; i != last; ++i) {
      const double c = i->crossing;
      if(!(c < i->window.to) || (is_split(*i) && c < limit))
        continue;
      Window w = i->window;
      w.mirror(f.length);
      Window child = turned(w, fn.cosine, fn.sine, (std::min)(f.length - c, w.to),
                            f.length - c < w.to + w.error(f.length), fn.length);
      if(child.y > 0)
        function(child);
    }
  }

private:
  // Does the ray to the apex part it? If it is not the best there, it is of no use beyond the best one's ray [CH90].
  static bool is_split(const Crossing_window& i) { return i.crossing > i.window.from && i.crossing < i.window.to; }

  // The part of a window up to `to` in the frame of a side that starts at the same vertex, at an angle above.
  static Window turned(const Window& w, double cosine, double sine, double to, bool is_to_end, double length)
  {
    Window result = w;
    result.x = w.x * cosine - w.y * sine;
    result.y = w.y * cosine + w.x * sine;
    const double weight = w.weight();
    const auto hit = [&](double b) {
      const double fall = result.y - weight * b * sine;
      return fall > 0 ? (std::min)((std::max)(b * w.y / fall, 0.0), length) : length;
    };
    result.from = hit(w.from);
    result.to = is_to_end ? length : hit(to);
    return result;
  }
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_FACE_CROSSING_H
