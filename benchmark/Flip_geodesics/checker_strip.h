// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_STRIP_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_STRIP_H

#include "checker_mesh.h"
#include "checker_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace polyline_checker {

/// A vector of the plane, multiplied as a complex number.
template <class NT>
struct Vector_2
{
  NT x, y;

  Vector_2 operator+(const Vector_2& v) const { return {x + v.x, y + v.y}; }
  Vector_2 operator-(const Vector_2& v) const { return {x - v.x, y - v.y}; }
  Vector_2 operator-() const { return {-x, -y}; }
  Vector_2 operator*(const Vector_2& v) const { return {x * v.x - y * v.y, x * v.y + y * v.x}; }
  Vector_2 operator*(const NT& s) const { return {x * s, y * s}; }
};

template <class NT>
NT dot(const Vector_2<NT>& u, const Vector_2<NT>& v)
{
  return u.x * v.x + u.y * v.y;
}

template <class NT>
NT cross(const Vector_2<NT>& u, const Vector_2<NT>& v)
{
  return u.x * v.y - u.y * v.x;
}

template <class NT>
NT length(const Vector_2<NT>& v)
{
  using std::sqrt;
  return sqrt(dot(v, v));
}

/// The angle by which `v` is turned counterclockwise from `u`, in (-pi, pi].
template <class NT>
long double angle_between(const Vector_2<NT>& u, const Vector_2<NT>& v)
{
  using std::atan2;
  return static_cast<long double>(NT(atan2(cross(u, v), dot(u, v))));
}

// Differences first: a difference of two coordinates is relatively exact however far the mesh is from the origin.
template <class NT>
std::array<NT, 3> difference(const Mesh::Point& p, const Mesh::Point& q)
{
  return {NT(q[0]) - NT(p[0]), NT(q[1]) - NT(p[1]), NT(q[2]) - NT(p[2])};
}

template <class NT>
NT dot(const std::array<NT, 3>& u, const std::array<NT, 3>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <class NT>
NT length(const std::array<NT, 3>& v)
{
  using std::sqrt;
  return sqrt(dot(v, v));
}

template <class NT>
NT edge_length(const Mesh& mesh, Index c)
{
  return length(difference<NT>(mesh.point(mesh.vertex(c)), mesh.point(mesh.vertex(Mesh::next(c)))));
}

/*
 * A corner of a face laid into the plane, the face on its upper side: the dot product and the length of the cross
 * product of the vectors to the next and to the previous vertex. That is |u||v| (cos + i sin) of the corner's angle,
 * with an error of a few units in the last place of |u||v|, whatever the shape of the face: also a degenerate face
 * has an angle, 0 or pi.
 */
template <class NT>
struct Corner
{
  Vector_2<NT> turn;
  NT squared_next, squared_previous;

  Corner(const Mesh& mesh, Index c)
  {
    const Mesh::Point& p = mesh.point(mesh.vertex(c));
    const std::array<NT, 3> u = difference<NT>(p, mesh.point(mesh.vertex(Mesh::next(c))));
    const std::array<NT, 3> v = difference<NT>(p, mesh.point(mesh.vertex(Mesh::previous(c))));
    const std::array<NT, 3> normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    turn = {dot(u, v), length(normal)};
    squared_next = dot(u, u);
    squared_previous = dot(v, v);
  }

  /// From the vector to the next vertex to that to the previous one, counterclockwise.
  Vector_2<NT> previous_from_next(const Vector_2<NT>& v) const { return v * turn * (NT(1) / squared_next); }

  /// The inverse.
  Vector_2<NT> next_from_previous(const Vector_2<NT>& v) const
  {
    return v * Vector_2<NT>{turn.x, -turn.y} * (NT(1) / squared_previous);
  }

  long double angle() const { return angle_between(Vector_2<NT>{NT(1), NT(0)}, turn); }
};

/*
 * A strip of faces from the place `source` to the place `target`: the halfedges crossed, each with the face that is
 * left on its left, so that it runs from the right to the left of the traveller. Without crossing both places lie in
 * one face, or on an edge of it.
 *
 *          left                        crossed[0]: right -> left
 *         /  ^ \                       source: in the face of crossed[0], not on its edge
 *   source   |   target                target: in the face of the last one's twin, not on its edge
 *         \  | /
 *          right
 */
struct Strip
{
  Place source, target;
  std::vector<Index> crossed;

  Strip reversed(const Mesh& mesh) const
  {
    Strip result{target, source, {}};
    for(auto c = crossed.rbegin(); c != crossed.rend(); ++c)
      result.crossed.push_back(mesh.twin(*c));
    return result;
  }
};

/// The coordinates of places inside faces and on edges are rounded: the places may be as far off as this fraction of
/// the longest edge of their face.
constexpr long double place_rounding = 4e-15L;

/// How far a place in the face of h may be off.
inline long double uncertainty(const Mesh& mesh, Index h, const Place& place)
{
  if(place.is_vertex())
    return 0;
  return place_rounding * (std::max)({edge_length<long double>(mesh, h), edge_length<long double>(mesh, Mesh::next(h)),
                                      edge_length<long double>(mesh, Mesh::previous(h))});
}

/// The vector between two places in the face of h, which points along the positive x axis.
template <class NT>
Vector_2<NT> vector_in_face(const Mesh& mesh, Index h, const Place& from, const Place& to)
{
  const Vector_2<NT> edge{edge_length<NT>(mesh, h), NT(0)};
  const auto change = [&](Index v) { return NT(weight<NT>(to, v) - weight<NT>(from, v)); };
  return edge * change(mesh.vertex(Mesh::next(h))) +
         Corner<NT>(mesh, h).previous_from_next(edge) * change(mesh.vertex(Mesh::previous(h)));
}

/*
 * A strip in the plane. The source is the origin, the first crossed edge points along the positive x axis.
 *
 * The vector of a crossed edge is a product of corners and carries a relative error only; a new vertex is put at the
 * end of the shorter edge that leads to it. So vertices near the source keep a small error, and whoever wants those
 * near the target unfolds the reversed strip.
 */
template <class NT>
class Unfolded_strip
{
public:
  struct Portal
  {
    Vector_2<NT> right, left;
    Vector_2<NT> edge; // from right to left, more accurate than the difference of the two
  };

  /// \pre the strip crosses an edge
  Unfolded_strip(const Mesh& mesh, const Strip& strip)
  {
    const Index first = strip.crossed.front();
    m_portals.reserve(strip.crossed.size());
    m_portals.push_back(first_portal(mesh, first, strip.source));
    for(std::size_t i = 0; i + 1 < strip.crossed.size(); ++i)
      add_portal(mesh, strip.crossed[i], strip.crossed[i + 1]);
    m_target = target_beyond(mesh, strip.crossed.back(), strip.target);
    m_uncertainty =
        uncertainty(mesh, first, strip.source) + uncertainty(mesh, mesh.twin(strip.crossed.back()), strip.target);
  }

  const std::vector<Portal>& portals() const { return m_portals; }
  const Vector_2<NT>& target() const { return m_target; }

  /// How far the line to the target may be off, since its ends are rounded.
  long double uncertainty_of_line() const { return m_uncertainty; }

  /// The angle at the source from the line to the first crossed edge's right end, or from the edge itself if the source
  /// is no vertex, to the line to the target, counterclockwise.
  long double direction(bool is_vertex) const
  {
    return angle_between(is_vertex ? m_portals.front().right : m_portals.front().edge, m_target);
  }

private:
  // The two other sides of the face on the left of `crossed`, which is `edge`, as vectors to its apex.
  struct To_apex
  {
    Vector_2<NT> from_tail, from_head;

    To_apex(const Mesh& mesh, Index crossed, const Vector_2<NT>& edge)
      : from_tail(Corner<NT>(mesh, crossed).previous_from_next(edge))
      , from_head(Corner<NT>(mesh, Mesh::next(crossed)).next_from_previous(-edge))
    {
    }
  };

  static Portal first_portal(const Mesh& mesh, Index crossed, const Place& source)
  {
    const Vector_2<NT> edge{edge_length<NT>(mesh, crossed), NT(0)};
    const To_apex to_apex(mesh, crossed, edge);
    const NT at_right = weight<NT>(source, mesh.vertex(crossed)),
             at_left = weight<NT>(source, mesh.vertex(Mesh::next(crossed))),
             at_apex = weight<NT>(source, mesh.vertex(Mesh::previous(crossed)));
    return {-(edge * at_left + to_apex.from_tail * at_apex), edge * at_right - to_apex.from_head * at_apex, edge};
  }

  // The gate through which the face beyond the last one is left.
  void add_portal(const Mesh& mesh, Index crossed, Index next)
  {
    const Portal portal = m_portals.back();
    const Index at_left = mesh.twin(crossed);
    const To_apex to_apex(mesh, at_left, -portal.edge);
    const Vector_2<NT>&from_left = to_apex.from_tail, &from_right = to_apex.from_head;
    const Vector_2<NT> apex = from_nearer(portal, from_right, from_left);
    if(next == Mesh::next(at_left))
      m_portals.push_back({portal.right, apex, from_right});
    else
      m_portals.push_back({apex, portal.left, -from_left});
  }

  Vector_2<NT> target_beyond(const Mesh& mesh, Index crossed, const Place& target) const
  {
    const Portal& portal = m_portals.back();
    const Index at_left = mesh.twin(crossed);
    const To_apex to_apex(mesh, at_left, -portal.edge);
    const NT w_left = weight<NT>(target, mesh.vertex(at_left)),
             w_right = weight<NT>(target, mesh.vertex(Mesh::next(at_left))),
             w_apex = weight<NT>(target, mesh.vertex(Mesh::previous(at_left)));
    return from_nearer(portal, to_apex.from_head * w_apex + portal.edge * w_left,
                       to_apex.from_tail * w_apex - portal.edge * w_right);
  }

  // A point by its vectors from the ends of a gate.
  static Vector_2<NT> from_nearer(const Portal& portal, const Vector_2<NT>& from_right, const Vector_2<NT>& from_left)
  {
    const bool right_is_nearer = dot(from_right, from_right) < dot(from_left, from_left);
    return right_is_nearer ? portal.right + from_right : portal.left + from_left;
  }

  std::vector<Portal> m_portals;
  Vector_2<NT> m_target;
  long double m_uncertainty = 0;
};

/*
 * The largest angle by which an end of a crossed edge lies on the wrong side of the line from source to target, seen
 * from the source, over those ends that are nearer to the source than to the target. 0: the line stays in the strip
 * as far as these ends can tell. An end that is beyond the line by no more than its own uncertainty is not.
 */
template <class NT>
long double bend_seen_from_source(const Unfolded_strip<NT>& strip)
{
  const Vector_2<NT>& line = strip.target();
  const NT slack = NT(strip.uncertainty_of_line()) * length(line);
  long double bend = 0;
  const auto look_at = [&](const Vector_2<NT>& p, const NT& side) {
    const Vector_2<NT> rest = line - p;
    const bool is_nearer = dot(p, p) <= dot(rest, rest) * NT(1.000001L); // one in the middle counts for both ends
    if(is_nearer && side * cross(line, p) + slack < 0)
      bend = (std::max)(bend, std::fabs(angle_between(line, p)));
  };
  for(const auto& portal : strip.portals()) {
    look_at(portal.left, NT(1));
    look_at(portal.right, NT(-1));
  }
  return bend;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_STRIP_H
