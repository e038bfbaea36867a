// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_VERTEX_OPENINGS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_VERTEX_OPENINGS_H

#include <CGAL/Flip_geodesics/internal/distances/Face_sides.h>
#include <CGAL/Flip_geodesics/internal/distances/Window.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/unfolding/Vertex_fan.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* How the shortest path known arrives at a vertex. */
struct Vertex_record
{
  double distance;
  Window window;                // through which it arrives, in the frame of `through`
  Input_halfedge_index through; // the side by which it enters its last face; null if it crosses no edge
  Input_halfedge_index along;   // the halfedge along which it arrives, or null
  Index root;                   // the vertex, or the part of a source, that it comes from
  bool is_reached, is_source;
  std::size_t source; // its number if it is one
};

/* What goes on from a vertex: a path along a halfedge, and a window on the side opposite, in the frame of that. */
struct Vertex_opening
{
  Input_halfedge_index along;
  Input_halfedge_index opposite; // null if there is no window
  Vertex_index head;             // of `along`
  double distance;               // its length
  Window window;
};

/*
 * Finds where paths go on from a vertex: vertices are sources themselves, for the directions in which shortest paths can
 * go on from them, at an angle of at least pi from where they came, on both sides. All the faces at the vertex have to be
 * known to `Face_sides`. The angles of its `Vertex_fan` begin where the path to the vertex comes from.
 */
template <class Triangulation>
class Vertex_openings
{
  using Vector = std::complex<double>;
  using Sides = Face_sides<Triangulation>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  explicit Vertex_openings(const Triangulation& triangulation)
    : m_triangulation(triangulation)
  {
  }

  /* Paths along the edges of a vertex, and windows on the edges opposite, at most two a halfedge that starts there. */
  const std::vector<Vertex_opening>& operator()(const Sides& sides, Vertex_index v, const Vertex_record& record)
  {
    m_openings.clear();
    double angle = 0;
    const Input_halfedge_index start = first_halfedge(sides, v, record, angle);
    const bool is_free = record.through == null_index && record.along == null_index;
    m_fan.collect(m_triangulation.input(), start, angle, [&](Input_halfedge_index h) { return corner(sides, h); });
    const double bend = is_free ? -infinity : boost::math::constants::pi<double>() - slack(sides);
    const double most = m_fan.has_border() ? infinity : m_fan.total() - bend;
    for(const Outgoing_halfedge& o : m_fan.halfedges())
      open(sides, v, record, o, bend, most);
    if(m_fan.has_border())
      open_clockwise(sides, v, record, start, angle, -bend);
    return m_openings;
  }

  /* A halfedge that starts at v, and its angle counterclockwise from where the path to v comes. */
  Input_halfedge_index first_halfedge(const Sides& sides, Vertex_index v, const Vertex_record& record,
                                      double& angle) const
  {
    if(record.along != null_index)
      return twin_index(record.along);
    if(record.through == null_index)
      return m_triangulation.input().outgoing(v);
    const Face_side& f = sides.known(record.through);
    const Window& w = record.window;
    const Vector apex(f.x, f.y), back = Vector(w.x, -w.y) - w.weight() * apex;
    angle = -std::arg(back * std::conj(-apex));
    return sides.known(f.next).next;
  }

private:
  using Outgoing_halfedge = Vertex_fan::Outgoing_halfedge;

  static double corner(const Sides& sides, Input_halfedge_index h)
  {
    const Face_side& f = sides.known(h);
    return std::atan2(f.sine, f.cosine);
  }

  /*
   * Returns by how much less than pi the angle of a path at the vertex may be. The window of a ray that passes the
   * vertex closer than the rounding errors of positions on its longest edge can be lost. Such a ray turns by at most
   * that error relative to the lengths of the path before and after the vertex; windows from the vertex take its place.
   * Their distances are the lengths of existing paths, so that more windows never make a distance too short.
   */
  double slack(const Sides& sides) const
  {
    double shortest = infinity, longest = 0;
    for(const Outgoing_halfedge& o : m_fan.halfedges()) {
      const Input_halfedge_index h = o.halfedge;
      const double length = sides.known(m_triangulation.input().is_border(h) ? twin_index(h) : h).length;
      shortest = (std::min)(shortest, length);
      longest = (std::max)(longest, length);
    }
    return (std::max)(angle_sum_rounding, 2 * Window::place_error * (longest / shortest));
  }

  // Clockwise from a halfedge up to the last one of the fan, over the border, beyond which all directions are open.
  void open_clockwise(const Sides& sides, Vertex_index v, const Vertex_record& record, Input_halfedge_index start,
                      double angle, double most)
  {
    const auto& input = m_triangulation.input();
    const Input_halfedge_index end = m_fan.halfedges().back().halfedge;
    for(Input_halfedge_index h = start;;) {
      angle = input.is_border(twin_index(h)) ? -beyond_all_angles : angle;
      h = clockwise_of(input, h);
      if(h == end)
        return;
      const double whole = input.is_border(h) ? 0 : corner(sides, h);
      angle -= whole;
      open(sides, v, record, {h, angle, whole}, -infinity, most);
    }
  }

  // A path along the edge at which a face starts, and a window on the edge opposite, for angles in [least, most].
  void open(const Sides& sides, Vertex_index v, const Vertex_record& record, const Outgoing_halfedge& o, double least,
            double most)
  {
    const Input_halfedge_index h = o.halfedge;
    const bool is_border = m_triangulation.input().is_border(h);
    const double distance = record.distance + sides.known(is_border ? twin_index(h) : h).length;
    m_openings.push_back({h, null_index, m_triangulation.input().tail(twin_index(h)), distance, Window()});
    if(is_border || o.angle > most || o.angle + o.corner < least)
      return;
    const Input_halfedge_index opposite = sides.known(h).next;
    const Face_side& f = sides.known(opposite);
    const bool is_thin = f.y < thin_face * f.length; // where a ray meets the side says nothing of its direction then
    const double first = o.angle < least && !is_thin ? hit(f, least - o.angle) : 0;
    const double last = o.angle + o.corner > most && !is_thin ? hit(f, most - o.angle) : f.length;
    if(!(first < last))
      return;
    m_openings.back().opposite = opposite;
    m_openings.back().window = {first, last, f.x, f.y, record.distance, v.idx(), 0, false, Window_state::WAITING};
  }

  // Where a ray from the vertex opposite meets a side, at an angle from the line to the tail.
  static double hit(const Face_side& f, double angle)
  {
    const Vector ray = Vector(-f.x, -f.y) * std::polar(1.0, angle);
    if(!(ray.imag() < 0))
      return ray.real() < 0 ? 0 : f.length;
    return (std::min)((std::max)(f.x - f.y * (ray.real() / ray.imag()), 0.0), f.length);
  }

  const Triangulation& m_triangulation;
  Vertex_fan m_fan;
  std::vector<Vertex_opening> m_openings;
};

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_DISTANCES_VERTEX_OPENINGS_H
