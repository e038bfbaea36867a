// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Meshes whose coordinates are not doubles.

#ifndef FLIP_GEODESICS_TEST_KERNELS_EXACT_COORDINATES_H
#define FLIP_GEODESICS_TEST_KERNELS_EXACT_COORDINATES_H

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace Flip_geodesics_test {

using Lattice_point = std::array<int, 3>;

/* Triangles with corners in a lattice. */
struct Lattice_surface
{
  std::vector<Lattice_point> points;
  std::vector<std::array<std::size_t, 3>> faces;
};

/* A flat grid of squares, each divided along the same diagonal. */
inline Lattice_surface lattice_grid(int cells)
{
  Lattice_surface result;
  for(int j = 0; j <= cells; ++j)
    for(int i = 0; i <= cells; ++i)
      result.points.push_back({i, j, 1});
  const auto n = static_cast<std::size_t>(cells) + 1;
  for(std::size_t j = 0; j + 1 < n; ++j)
    for(std::size_t i = 0; i + 1 < n; ++i) {
      const std::size_t a = i + j * n, b = a + 1, c = b + n, d = a + n;
      result.faces.push_back({a, b, c});
      result.faces.push_back({a, c, d});
    }
  return result;
}

/* The surface of a box of cubes. */
inline Lattice_surface lattice_box(const Lattice_point& size)
{
  Lattice_surface result;
  std::map<Lattice_point, std::size_t> numbers;
  const auto number = [&](const Lattice_point& p) {
    const auto [position, is_new] = numbers.emplace(p, result.points.size());
    if(is_new)
      result.points.push_back(p);
    return position->second;
  };
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const bool is_upper : {false, true}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for(int i = 0; i < size[u]; ++i)
        for(int j = 0; j < size[v]; ++j) {
          std::array<std::size_t, 4> corners;
          for(std::size_t k = 0; k < 4; ++k) {
            Lattice_point p;
            p[axis] = is_upper ? size[axis] : 0;
            p[u] = i + (k == 1 || k == 2 ? 1 : 0);
            p[v] = j + (k >= 2 ? 1 : 0);
            corners[is_upper ? k : 3 - k] = number(p);
          }
          result.faces.push_back({corners[0], corners[1], corners[2]});
          result.faces.push_back({corners[0], corners[2], corners[3]});
        }
    }
  return result;
}

/* The surface as a mesh whose points are `place(p)` of the points of the lattice. */
template <class Kernel, class Place>
CGAL::Surface_mesh<typename Kernel::Point_3> mesh_of(const Lattice_surface& surface, const Place& place)
{
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Mesh mesh;
  std::vector<typename Mesh::Vertex_index> v;
  for(const Lattice_point& p : surface.points)
    v.push_back(mesh.add_vertex(place(p)));
  for(const auto& f : surface.faces)
    mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
  return mesh;
}

/* With cells of 1/3 by 1/7 by 1/11. */
template <class Kernel>
typename Kernel::Point_3 in_odd_cells(const Lattice_point& p)
{
  using FT = typename Kernel::FT;
  return {FT(FT(p[0]) / FT(3)), FT(FT(p[1]) / FT(7)), FT(FT(p[2]) / FT(11))};
}

/* Rotated by the matrix of the quaternion (a, b, c, d), over its norm, and moved away from the origin. */
template <class Kernel>
typename Kernel::Point_3 rotated(const Lattice_point& p, const std::array<int, 4>& quaternion)
{
  using FT = typename Kernel::FT;
  const auto [a, b, c, d] = quaternion;
  const std::array<std::array<int, 3>, 3> m = {
      {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)}},
       {{2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)}},
       {{2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}}};
  const FT norm(a * a + b * b + c * c + d * d);
  std::array<FT, 3> q;
  for(std::size_t i = 0; i < 3; ++i)
    q[i] = FT(m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2]) / norm + FT(1000) / FT(7);
  return {q[0], q[1], q[2]};
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_KERNELS_EXACT_COORDINATES_H
