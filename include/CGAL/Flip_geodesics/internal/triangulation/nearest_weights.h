// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NEAREST_WEIGHTS_H
#define CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NEAREST_WEIGHTS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

using Place_in_space = std::array<double, 3>;

inline double dot(const Place_in_space& u, const Place_in_space& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

inline Place_in_space cross(const Place_in_space& u, const Place_in_space& v)
{
  return {{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
}

inline Place_in_space difference(const Place_in_space& u, const Place_in_space& v)
{
  return {{u[0] - v[0], u[1] - v[1], u[2] - v[2]}};
}

/* The barycentric coordinates of a point of a triangle, and how far it is from the origin. */
struct Nearest_weights
{
  std::array<double, 3> weights = {{1, 0, 0}};
  double distance = std::numeric_limits<double>::infinity();
};

using Triangle_places = std::array<Place_in_space, 3>;

inline double distance_of(const Triangle_places& corners, const std::array<double, 3>& weights)
{
  Place_in_space p = {{0, 0, 0}};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      p[k] += weights[i] * corners[i][k];
  return std::sqrt(dot(p, p));
}

/* The point of side i, from corner i to the next, that is nearest to the origin. */
inline std::array<double, 3> nearest_on_side(const Triangle_places& corners, std::size_t i)
{
  const std::size_t j = (i + 1) % 3;
  const Place_in_space d = difference(corners[j], corners[i]);
  const double squared_length = dot(d, d);
  const double t = squared_length > 0 ? -dot(corners[i], d) / squared_length : 0;
  std::array<double, 3> weights = {{0, 0, 0}};
  weights[j] = (std::min)((std::max)(t, 0.0), 1.0);
  weights[i] = 1 - weights[j];
  return weights;
}

/* The foot of the perpendicular from the origin, by the areas that it cuts off; not finite without an area. */
inline std::array<double, 3> foot_of_perpendicular(const Triangle_places& corners)
{
  const Place_in_space u = difference(corners[1], corners[0]), v = difference(corners[2], corners[0]);
  const Place_in_space normal = cross(u, v), &from = corners[0]; // to the origin it is minus that
  const double squared = dot(normal, normal);
  const double at_1 = dot(cross(v, from), normal) / squared, at_2 = dot(cross(from, u), normal) / squared;
  return {{1 - at_1 - at_2, at_1, at_2}};
}

/*
 * The point of a triangle that is nearest to the origin: the foot of the perpendicular if that lies inside, or a point
 * of a side; the nearest of these, so that in needles, where the first is inaccurate, another one is taken. Computed at
 * the triangle's own scale, so that no square is too small or too large.
 */
inline Nearest_weights nearest_weights(Triangle_places corners)
{
  double scale = 0;
  for(const Place_in_space& p : corners)
    scale = (std::max)({scale, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if(scale == 0)
    return {{{1, 0, 0}}, 0};
  for(Place_in_space& p : corners)
    for(double& x : p)
      x /= scale;
  Nearest_weights result;
  const auto consider = [&](const std::array<double, 3>& weights) {
    const double distance = scale * distance_of(corners, weights);
    if(distance < result.distance) {
      result.distance = distance;
      result.weights = weights;
    }
  };
  for(std::size_t i = 0; i < 3; ++i)
    consider(nearest_on_side(corners, i));
  const std::array<double, 3> foot = foot_of_perpendicular(corners);
  if(*std::min_element(foot.begin(), foot.end()) > 0) // never without an area
    consider(foot);
  return result;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_TRIANGULATION_NEAREST_WEIGHTS_H
