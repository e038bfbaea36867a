// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_STRIP_H
#define CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_STRIP_H

#include "checker_mesh.h"

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
 * with an error of a few units in the last place of |u||v|, whatever the shape of the face: also a face without area
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
 * A strip of faces from the vertex `source` to the vertex `target`: the halfedges crossed, each with the face that is
 * left on its left, so that it runs from the right to the left of the traveller. Without crossing it is one edge.
 *
 *          left                        crossed[0]: right -> left
 *         /  ^ \                       source: opposite of crossed[0] in the first face
 *   source   |   target                target: opposite of the last one's twin in the last face
 *         \  | /
 *          right
 */
struct Strip
{
  Index source, target;
  std::vector<Index> crossed;

  Strip reversed(const Mesh& mesh) const
  {
    Strip result{target, source, {}};
    for(auto c = crossed.rbegin(); c != crossed.rend(); ++c)
      result.crossed.push_back(mesh.twin(*c));
    return result;
  }
};

/*
 * A strip in the plane. The source is the origin, the edge from there to the right end of the first crossed edge points
 * along the positive x axis.
 *
 * The vector of a crossed edge is a product of corners and carries a relative error only; a new vertex is put at the
 * end of the shorter edge that leads to it. So vertices near the source keep a small error, and whoever wants those
 * near the target unfolds the reversed strip.
 */
template <class NT>
class Unfolded_strip
{
public:
  struct Gate
  {
    Vector_2<NT> right, left;
    Vector_2<NT> edge; // from right to left, more accurate than the difference of the two
  };

  /// \pre the strip crosses an edge
  Unfolded_strip(const Mesh& mesh, const Strip& strip)
  {
    const Index first = strip.crossed.front();
    m_gates.reserve(strip.crossed.size());
    m_gates.push_back(first_gate(mesh, first));
    for(std::size_t i = 0; i < strip.crossed.size(); ++i)
      add_face(mesh, strip.crossed[i], i + 1 < strip.crossed.size() ? strip.crossed[i + 1] : null_index);
  }

  const std::vector<Gate>& gates() const { return m_gates; }
  const Vector_2<NT>& target() const { return m_target; }

  /// The angle at the source from the first face's right edge to the line to the target, counterclockwise.
  long double direction() const { return angle_between(Vector_2<NT>{NT(1), NT(0)}, m_target); }

private:
  static Gate first_gate(const Mesh& mesh, Index crossed)
  {
    const Index corner = Mesh::previous(crossed);
    const Vector_2<NT> right{edge_length<NT>(mesh, corner), NT(0)};
    const Vector_2<NT> left = Corner<NT>(mesh, corner).previous_from_next(right);
    return {right, left, Corner<NT>(mesh, crossed).next_from_previous(-right)};
  }

  // The face beyond `crossed`; `next` is the edge through which it is left, null_index if it is the last.
  void add_face(const Mesh& mesh, Index crossed, Index next)
  {
    const Gate gate = m_gates.back();
    const Index at_left = mesh.twin(crossed);
    const Index at_right = Mesh::next(at_left);
    const Vector_2<NT> from_right = Corner<NT>(mesh, at_right).next_from_previous(gate.edge);
    const Vector_2<NT> from_left = Corner<NT>(mesh, at_left).previous_from_next(-gate.edge);
    const bool right_is_nearer = dot(from_right, from_right) < dot(from_left, from_left);
    const Vector_2<NT> apex = right_is_nearer ? gate.right + from_right : gate.left + from_left;
    if(next == null_index)
      m_target = apex;
    else if(next == at_right)
      m_gates.push_back({gate.right, apex, from_right});
    else
      m_gates.push_back({apex, gate.left, -from_left});
  }

  std::vector<Gate> m_gates;
  Vector_2<NT> m_target;
};

/*
 * The largest angle by which an end of a crossed edge lies on the wrong side of the line from source to target, seen
 * from the source, over those ends that are nearer to the source than to the target. 0: the line stays in the strip
 * as far as these ends can tell.
 */
template <class NT>
long double bend_seen_from_source(const Unfolded_strip<NT>& strip)
{
  const Vector_2<NT>& line = strip.target();
  long double bend = 0;
  const auto look_at = [&](const Vector_2<NT>& p, const NT& side) {
    const Vector_2<NT> rest = line - p;
    const bool is_nearer = dot(p, p) <= dot(rest, rest) * NT(1.000001L); // one in the middle counts for both ends
    if(is_nearer && side * cross(line, p) < 0)
      bend = (std::max)(bend, std::fabs(angle_between(line, p)));
  };
  for(const auto& gate : strip.gates()) {
    look_at(gate.left, NT(1));
    look_at(gate.right, NT(-1));
  }
  return bend;
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_BENCHMARK_CHECKER_STRIP_H
