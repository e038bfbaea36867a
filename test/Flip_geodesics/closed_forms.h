// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_CLOSED_FORMS_H
#define FLIP_GEODESICS_TEST_CLOSED_FORMS_H

#include "generated_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

/*
 * Distances on the generated meshes in closed form.
 */
namespace Flip_geodesics_test {

/// The length of the shortest path on the side of an open cylinder (of a prism) between vertices `i + n * k` and
/// `j + n * l`.
inline double cylinder_distance(int n, int m, double radius, double height, int u, int v)
{
  const int turn = std::abs(u % n - v % n);
  return std::hypot((std::min)(turn, n - turn) * polygon_side(n, radius), height * (u / n - v / n) / m);
}

/// The length of the geodesic between points at distances `r` and `s` from the apex of a cone or saddle disk that
/// passes the apex on the side where it leaves `angle`: straight, or through the apex if the angle is pi or more.
inline double cone_distance(double r, double s, double angle)
{
  return angle >= pi ? r + s : std::sqrt((r - s) * (r - s) + 4 * r * s * std::pow(std::sin(angle / 2), 2));
}

/// The distance of two points on `tetrahedron(n)`. The surface is a flat torus modulo a point reflection, so that it is
/// the least distance in the plane over all images, `+-q` moved by twice the lattice of the edges.
inline double tetrahedron_distance(int n, const Coordinates& p, const Coordinates& q)
{
  const auto unfolded = [n](const Coordinates& x) { // coordinates along the edges from vertex 0 to 1 and to 2
    const std::array<double, 4> w = {(n + x[0] + x[1] + x[2]) / (4 * n), (n + x[0] - x[1] - x[2]) / (4 * n),
                                     (n - x[0] + x[1] - x[2]) / (4 * n), (n - x[0] - x[1] + x[2]) / (4 * n)};
    const std::array<std::array<double, 2>, 4> by_face = {
        {{w[1] + w[3], w[2] + w[3]}, {-w[3], w[2] + w[3]}, {w[1] + w[3], -w[3]}, {w[1], w[2]}}};
    return by_face[std::min_element(w.begin(), w.end()) - w.begin()]; // the face opposite that vertex
  };
  const std::array<double, 2> a = unfolded(p), b = unfolded(q);
  double least = -1;
  for(int sign : {-1, 1})
    for(int i = -2; i <= 2; ++i)
      for(int j = -2; j <= 2; ++j) {
        const double x = a[0] - sign * b[0] + 2 * i, y = a[1] - sign * b[1] + 2 * j;
        const double square = x * x + x * y + y * y;
        least = least < 0 ? square : (std::min)(least, square);
      }
  return n * std::sqrt(8 * least);
}

namespace internal {

// A side of a box, as a parallelogram in space and where it comes to lie in the plane when the box rolls over its
// edges.
struct Rolled_side
{
  // The side beyond the edge at parameter 0 or 1 of the axis `d`.
  Rolled_side rolled(int d, bool is_upper) const
  {
    Rolled_side next = *this;
    const double ratio = distance(normal, {0, 0, 0}) / distance(axes[d], {0, 0, 0});
    for(int x = 0; x < 3; ++x) {
      next.corner[x] += is_upper ? axes[d][x] : 0;
      next.axes[d][x] = -normal[x];
      next.normal[x] = is_upper ? axes[d][x] : -axes[d][x];
    }
    for(int x = 0; x < 2; ++x) {
      next.flat_corner[x] += is_upper ? flat_axes[d][x] : 0;
      next.flat_axes[d][x] *= is_upper ? ratio : -ratio;
    }
    return next;
  }

  // The place in the plane of a point `p`, if it lies on this side.
  bool place(const Coordinates& p, std::array<double, 2>& result) const
  {
    result = flat_corner;
    const double size = distance(axes[0], {0, 0, 0}) + distance(axes[1], {0, 0, 0});
    Coordinates rest = {p[0] - corner[0], p[1] - corner[1], p[2] - corner[2]};
    for(int d = 0; d < 2; ++d) {
      double dot = 0, square = 0;
      for(int x = 0; x < 3; ++x) {
        dot += axes[d][x] * (p[x] - corner[x]);
        square += axes[d][x] * axes[d][x];
      }
      for(int x = 0; x < 3; ++x)
        rest[x] -= axes[d][x] * dot / square;
      for(int x = 0; x < 2; ++x)
        result[x] += flat_axes[d][x] * dot / square;
    }
    return distance(rest, {0, 0, 0}) < 1e-12 * size;
  }

  Coordinates corner;
  std::array<Coordinates, 2> axes;
  Coordinates normal; // outward, as long as the box is deep
  std::array<double, 2> flat_corner;
  std::array<std::array<double, 2>, 2> flat_axes;
};

using Flat_segment = std::array<std::array<double, 2>, 2>;

inline bool do_intersect(const Flat_segment& s, const Flat_segment& t)
{
  const auto cross = [](const Flat_segment& u, const Flat_segment& v) {
    return (u[1][0] - u[0][0]) * (v[1][1] - v[0][1]) - (u[1][1] - u[0][1]) * (v[1][0] - v[0][0]);
  };
  const double determinant = cross(s, t), tolerance = 1e-12;
  const double a = cross({s[0], t[0]}, t) / determinant, b = cross({s[0], t[0]}, s) / determinant;
  const auto is_inside = [=](double x) { return x > -tolerance && x < 1 + tolerance; }; // false if not a number
  return is_inside(a) && is_inside(b);
}

// The least length of a straight line from the origin of the plane to `q` over the `crossed` edges and further ones.
inline double least_rolled_distance(const Rolled_side& side, const std::array<double, 2>& source, const Coordinates& q,
                                    std::vector<Flat_segment>& crossed)
{
  double least = 1e300;
  std::array<double, 2> target;
  if(side.place(q, target) && std::all_of(crossed.begin(), crossed.end(), [&](const Flat_segment& edge) {
       return do_intersect({source, target}, edge);
     }))
    least = std::hypot(target[0] - source[0], target[1] - source[1]);
  if(crossed.size() == 5) // a shortest path meets each side once
    return least;
  for(int d = 0; d < 2; ++d)
    for(bool is_upper : {false, true}) {
      const Rolled_side next = side.rolled(d, is_upper);
      const std::array<double, 2>&start = next.flat_corner, &along = next.flat_axes[1 - d];
      crossed.push_back({start, {start[0] + along[0], start[1] + along[1]}});
      least = (std::min)(least, least_rolled_distance(next, source, q, crossed));
      crossed.pop_back();
    }
  return least;
}

} // namespace internal

/// The distance of two points on the surface of the box `[0,a] x [0,b] x [0,c]`: the least length of a straight line
/// over all ways of rolling the box over its edges, in which it stays on the box's trace.
inline double box_distance(double a, double b, double c, const Coordinates& p, const Coordinates& q)
{
  const std::array<double, 3> size = {a, b, c};
  double least = 1e300;
  for(int axis = 0; axis < 3; ++axis)
    for(bool is_upper : {false, true}) {
      internal::Rolled_side side = {{0, 0, 0}, {}, {0, 0, 0}, {0, 0}, {}};
      for(int d = 0; d < 2; ++d) {
        side.axes[d][(axis + d + 1) % 3] = size[(axis + d + 1) % 3];
        side.flat_axes[d][d] = size[(axis + d + 1) % 3];
      }
      side.corner[axis] = is_upper ? size[axis] : 0;
      side.normal[axis] = is_upper ? size[axis] : -size[axis];
      std::array<double, 2> source;
      std::vector<internal::Flat_segment> crossed;
      if(side.place(p, source))
        least = (std::min)(least, internal::least_rolled_distance(side, source, q, crossed));
    }
  return least;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_CLOSED_FORMS_H
