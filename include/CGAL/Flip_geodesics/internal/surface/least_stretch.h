// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LEAST_STRETCH_H
#define CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LEAST_STRETCH_H

#include <CGAL/Flip_geodesics/internal/numbers/Plane_triangle.h>
#include <CGAL/Flip_geodesics/internal/numbers/tolerances.h>
#include <CGAL/Flip_geodesics/internal/surface/face_lengths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Flip_geodesics {
namespace internal {

/* Lengths in units of a power of two, so that the largest is at least 1 and less than 2. \return its exponent */
inline int scale_to_one(std::array<double, 3>& lengths)
{
  const int exponent = std::ilogb((std::max)({lengths[0], lengths[1], lengths[2]}));
  for(double& length : lengths)
    length = std::scalbn(length, -exponent);
  return exponent;
}

/*
 * By what factor segments in a triangle are at least longer than in another one, whose points correspond linearly. Never
 * too large: what rounding can do is taken off. The sides of the other one, `before`, can be wrong by some units in the
 * last place, or zero; those of the first, `after`, are what they are. Zero if one of these cannot be used, or they make
 * no triangle with an area.
 *
 * Sides alone do not tell: where two of three are stretched less than the third, heights can become shorter by any factor.
 *
 * The linear map back, from `after` to `before`, stretches by its larger singular value at most. The sum of the squares of
 * both follows from the cotangents of `after` [Pinkall, Polthier, Computing discrete minimal surfaces and their
 * conjugates], and their product is that of the areas.
 */
inline double least_stretch(std::array<double, 3> before, std::array<double, 3> after)
{
  if(!std::all_of(after.begin(), after.end(), is_usable_length) ||
     !std::all_of(before.begin(), before.end(), is_zero_or_usable_length))
    return 0;
  if(before == std::array<double, 3>{{0, 0, 0}})
    return std::numeric_limits<double>::infinity();
  const int exponent = scale_to_one(after) - scale_to_one(before);
  const Plane_triangle shape(after);
  double sum = 0; // of squares of singular values, times twice the area
  for(int i = 0; i < 3; ++i)
    sum += shape.cotangents[i] * before[(i + 1) % 3] * before[(i + 1) % 3]; // of the side opposite to the corner
  const double area_before = Plane_triangle(before).area;
  const double most_squares = sum / (2 * shape.area) + area_product_error / (shape.area * shape.area);
  const double least_square_of_product = (area_before * area_before - area_product_error) / (shape.area * shape.area);
  const double difference = most_squares * most_squares - 4 * (std::max)(least_square_of_product, 0.0);
  const double most = 0.5 * (most_squares + std::sqrt((std::max)(difference, 0.0)));
  return most > 0 ? (1 - stretch_rounding) * std::scalbn(1 / std::sqrt(most), exponent) : 0; // NaN without an area
}

/* The least of all faces of a mesh, between two metrics; infinite if there are none. Linear in the mesh. */
template <class Before, class After, class Input_mesh>
double least_stretch_of_faces(const Before& before, const After& after, const Input_mesh& mesh)
{
  const auto lengths = [&mesh](const auto& metric, Input_halfedge_index h) {
    const Input_halfedge_index hn = mesh.next(h);
    return std::array<double, 3>{{metric.weight(mesh, h), metric.weight(mesh, hn), metric.weight(mesh, mesh.next(hn))}};
  };
  double least = std::numeric_limits<double>::infinity();
  for(Input_halfedge_index h : descriptors<Input_halfedge_index>(mesh.number_of_halfedges()))
    if(!mesh.is_border(h) && h < mesh.next(h) && h < mesh.next(mesh.next(h)))
      least = (std::min)(least, least_stretch(lengths(before, h), lengths(after, h)));
  return least;
}

} // namespace internal
} // namespace Flip_geodesics
} // namespace CGAL

#endif // CGAL_FLIP_GEODESICS_INTERNAL_SURFACE_LEAST_STRETCH_H
