// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_BENCHMARK_ITERATIVE_RELAXATION_H
#define FLIP_GEODESICS_BENCHMARK_ITERATIVE_RELAXATION_H

#include "unfolded_path.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

namespace opponents {

/*!
 * Straightens an edge path by iterative relaxation [MVC05]: in sweeps along the path, each point moves to where the
 * straight line between its neighbors crosses its edge in the two unfolded faces there, and a point at a vertex moves
 * off it on a side with an angle below \f$\pi\f$, until all angles are straight within a tolerance, which is 0.005 in
 * the paper.
 */
template <class Mesh>
class Iterative_relaxation
{
  using Path = Portal_path<Mesh>;
  using Point = std::complex<double>;

public:
  /// \return the number of sweeps, or `most_sweeps` if it did not end
  std::size_t operator()(Path& path, double tolerance = 0.005, std::size_t most_sweeps = 20000)
  {
    for(std::size_t sweep = 1; sweep < most_sweeps; ++sweep)
      if(relax_all(path) < tolerance)
        return sweep;
    return most_sweeps;
  }

private:
  // Points that approach a vertex would never reach it, and never be led round it.
  static double snapped(double t)
  {
    constexpr double at_vertex = 1e-6;
    return t < at_vertex ? 0 : (t > 1 - at_vertex ? 1 : t);
  }

  // Returns the largest angle by which a point was off before it moved.
  double relax_all(Path& path)
  {
    double error = 0;
    for(std::size_t i = 0; i < path.portals.size();) {
      if(!path.portals[i].is_at_vertex()) {
        error = (std::max)(error, relax_on_edge(path, i));
        ++i;
        continue;
      }
      const bool is_on_right = path.portals[i].is_at_tail();
      const auto v = path.geometry().tail(path.outgoing_halfedge(i, is_on_right));
      std::size_t last = i;
      while(last + 1 < path.portals.size() && path.portals[last + 1].is_at_vertex() &&
            path.portals[last + 1].is_at_tail() == is_on_right &&
            path.geometry().tail(path.outgoing_halfedge(last + 1, is_on_right)) == v)
        ++last;
      bool is_on_other_side = false;
      error = (std::max)(error, relax_at_vertex(path, i, last, is_on_right, is_on_other_side));
      i = is_on_other_side ? i : last + 1;
      if(is_on_other_side)
        path.simplify();
    }
    return error;
  }

  // The points before and after gate i, where the gate's halfedge is the vector (length, 0); before is above it.
  Point before(const Path& path, std::size_t i) const
  {
    const auto& g = path.geometry();
    const auto h = path.portals[i].crossed;
    const Point apex = g.apex(h);
    if(i == 0)
      return apex;
    const auto& portal = path.portals[i - 1]; // its twin is next(h) or previous(h)
    const bool is_next = g.twin(portal.crossed) == g.next(h);
    const Point other = is_next ? Point(g.length(h)) : Point(0);
    return is_next ? apex + portal.t * (other - apex) : other + portal.t * (apex - other);
  }

  Point after(const Path& path, std::size_t i) const
  {
    const auto& g = path.geometry();
    const auto t = g.twin(path.portals[i].crossed);
    const double length = g.length(t);
    const Point apex = length - g.apex(t); // turned by pi
    if(i + 1 == path.portals.size())
      return apex;
    const auto& portal = path.portals[i + 1]; // next(t), from the right end to the apex, or previous(t)
    const bool is_next = portal.crossed == g.next(t);
    return is_next ? portal.t * apex : apex + portal.t * (length - apex);
  }

  double relax_on_edge(Path& path, std::size_t i) const
  {
    const Point p = before(path, i), q = after(path, i);
    const double length = path.geometry().length(path.portals[i].crossed), x = path.portals[i].t * length;
    const double bend = std::abs(std::arg((q - x) * std::conj(x - p)));
    const double height = p.imag() - q.imag();
    if(height > 0)
      path.portals[i].t = (p.real() + (q.real() - p.real()) * p.imag() / height) / length;
    path.portals[i].t = snapped(path.portals[i].t);
    return bend;
  }

  double relax_at_vertex(Path& path, std::size_t first, std::size_t last, bool is_on_right,
                         bool& is_on_other_side) const
  {
    const auto& g = path.geometry();
    const Point v = is_on_right ? Point(0) : Point(g.length(path.portals[first].crossed));
    const Point w = is_on_right ? Point(0) : Point(g.length(path.portals[last].crossed));
    const Point to_before = before(path, first) - v, to_after = after(path, last) - w;
    const double sign = is_on_right ? 1 : -1; // towards the other end of the gates
    const double angle_before = std::abs(std::arg(sign * to_before)), angle_after = std::abs(std::arg(sign * to_after));
    double inside = angle_before + angle_after;
    for(std::size_t i = first; i < last; ++i)
      inside += corner_between(path, i, is_on_right);
    const double outside = g.total_angle(path.outgoing_halfedge(first, is_on_right)) - inside;
    if(inside < pi) {
      place_on_line(path.portals, first, last, std::abs(to_before), angle_before, std::abs(to_after), inside, path,
                    is_on_right);
      return pi - inside;
    }
    if(!(outside < pi))
      return 0;
    auto portals = path.other_side(first, last, is_on_right);
    const std::size_t count = portals.size();
    path.replace(first, last, portals);
    is_on_other_side = true;
    // The first corner on the other side is what is left of the face's.
    const double start = corner_before(path, first, !is_on_right) - angle_before;
    place_on_line(path.portals, first, first + count - 1, std::abs(to_before), start, std::abs(to_after), outside, path,
                  !is_on_right);
    return pi - outside;
  }

  // The corner, at their common vertex, between gates i and i + 1.
  static double corner_between(const Path& path, std::size_t i, bool is_on_right)
  {
    const auto& g = path.geometry();
    return is_on_right ? g.corner(path.outgoing_halfedge(i + 1, true)) : g.corner(path.outgoing_halfedge(i, false));
  }

  // The corner of the face that is left through gate i, at the vertex.
  static double corner_before(const Path& path, std::size_t i, bool is_on_right)
  {
    const auto& g = path.geometry();
    const auto s = path.outgoing_halfedge(i, is_on_right);
    return is_on_right ? g.corner(s) : g.corner(g.clockwise(s));
  }

  // Points where the line from radius r0 at angle 0 to radius r1 at angle `angle` crosses the spokes, or a line
  // parallel to it that is so close to the vertex that it crosses all of them.
  static void place_on_line(typename Path::Portals& portals, std::size_t first, std::size_t last, double r0,
                            double start, double r1, double angle, const Path& path, bool is_on_right)
  {
    double alpha = start, scale = 1;
    for(std::size_t i = first; i <= last; ++i) {
      const double whole = r0 * std::sin(alpha) + r1 * std::sin(angle - alpha);
      const double radius = whole > 0 ? r0 * r1 * std::sin(angle) / whole : 0;
      portals[i].t = radius / path.geometry().length(portals[i].crossed);
      scale = (std::min)(scale, 1 / portals[i].t);
      if(i < last)
        alpha += corner_between(path, i, is_on_right);
    }
    for(std::size_t i = first; i <= last; ++i)
      portals[i].t = is_on_right ? scale * portals[i].t : 1 - scale * portals[i].t;
  }
};

} // namespace opponents

#endif // FLIP_GEODESICS_BENCHMARK_ITERATIVE_RELAXATION_H
