// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_MESHES_OF_EVERY_KIND_H
#define FLIP_GEODESICS_MESHES_OF_EVERY_KIND_H

#include "../../test/Flip_geodesics/generated_meshes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/*
 * Meshes of 1000 to 300 000 faces: planes and hills with ties and without, solids, surfaces of revolution, knots and
 * sponges; turned, far from the origin, tiny and huge; with needles, spikes, holes, vertices of a high degree, vertices
 * in one place, and degenerate faces.
 */
namespace meshes_of_every_kind {

using namespace Flip_geodesics_test;

/// A mesh that is made when it is needed.
struct Named_mesh
{
  std::string name;
  std::function<Mesh_soup()> make;
};

/// A tube about a knot on a torus, that winds round it 2 and 3 times.
inline Mesh_soup knot(int n, int m)
{
  Mesh_soup soup;
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i) {
      const double t = 2 * pi * i / n, s = 2 * pi * j / m, r = 2 + std::cos(3 * t);
      const double across = 0.3 * std::cos(s), up = 0.3 * std::sin(s);
      soup.points.push_back({(r + across) * std::cos(2 * t), (r + across) * std::sin(2 * t), std::sin(3 * t) + up});
    }
  Flip_geodesics_test::internal::add_cells(soup, n, m, Diagonal_rule::RISING,
                                           [=](int i, int j) { return i % n + n * (j % m); });
  return soup;
}

/// A cube with holes through each third of its faces, and so on.
inline Mesh_soup sponge(int levels)
{
  int n = 1;
  for(int i = 0; i < levels; ++i)
    n *= 3;
  return voxel_surface(n, n, n, [](int i, int j, int k) {
    for(; i + j + k > 0; i /= 3, j /= 3, k /= 3)
      if((i % 3 == 1) + (j % 3 == 1) + (k % 3 == 1) > 1)
        return false;
    return true;
  });
}

/// A plate with `n * n` holes.
inline Mesh_soup plate_with_holes(int n)
{
  return voxel_surface(2 * n + 1, 2 * n + 1, 1, [](int i, int j, int) { return i % 2 == 0 || j % 2 == 0; });
}

inline Mesh_soup terrain(int n, double height, unsigned seed, bool has_ties)
{
  Random_numbers random(seed);
  return grid(n, n, Diagonal_rule::RANDOM,
              [&](int, int) { return has_ties ? height * random.below(4) : height * random.uniform(0, 1); });
}

inline Mesh_soup spikes(int n)
{
  return grid(n, n, Diagonal_rule::ALTERNATING, [](int i, int j) { return (i * 5 + j * 3) % 7 == 0 ? 1000 : 0; });
}

/// Moves some vertices: to a neighbor, two to a third, to the middle of an edge, or beyond one.
inline Mesh_soup spoilt(Mesh_soup soup, int how, unsigned seed)
{
  Random_numbers random(seed);
  for(int i = 0; i < 12; ++i) {
    const Corners t = soup.triangles[static_cast<std::size_t>(random.below(static_cast<int>(soup.triangles.size())))];
    const Coordinates b = soup.points[static_cast<std::size_t>(t[1])], c = soup.points[static_cast<std::size_t>(t[2])];
    Coordinates& a = soup.points[static_cast<std::size_t>(t[0])];
    if(how == 1)
      soup.points[static_cast<std::size_t>(t[2])] = b;
    for(int k = 0; k < 3; ++k)
      a[k] = how < 2 ? b[k] : (how == 2 ? (b[k] + c[k]) / 2 : 2 * b[k] - c[k]);
  }
  return soup;
}

inline std::vector<Named_mesh> surfaces()
{
  return {{"cube", [] { return cube(16); }},
          {"plate", [] { return genus_3_plate(3); }},
          {"octahedron", [] { return octahedron(20); }},
          {"prism", [] { return cylinder(7, 120, 1, 30); }},
          {"cone", [] { return cone(48, 24, 1, 2); }},
          {"torus", [] { return torus(60, 30, 3, 1); }},
          {"bumpy sphere", [] { return bumpy_sphere(20, 0.2, 3); }},
          {"sphere", [] { return sphere(20); }},
          {"saddle", [] { return saddle_disk(24, 20, 9); }},
          {"lantern", [] { return lantern(24, 40); }},
          {"polyhedron", [] { return random_convex_polyhedron(600, 4); }},
          {"jittered grid", [] { return jittered_grid(40, 40, Diagonal_rule::RANDOM, 0.2, 6); }},
          {"terrain", [] { return terrain(40, 3, 7, false); }},
          {"steps", [] { return terrain(40, 1, 8, true); }},
          {"grid with hole", [] { return grid_with_hole(40, 40, 10, 30, 15, 20); }},
          {"spikes", [] { return spikes(36); }},
          {"knot", [] { return knot(180, 12); }},
          {"sponge", [] { return sponge(2); }}};
}

inline void add_moved(std::vector<Named_mesh>& result)
{
  const std::vector<std::pair<std::string, std::function<Coordinates(const Coordinates&)>>> moves = {
      {"", [](const Coordinates& p) { return p; }},
      {"turned ",
       [](const Coordinates& p) {
         return Coordinates{0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2], -0.8 * p[0] + 0.6 * p[1],
                            0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2]};
       }},
      {"third of a ",
       [](const Coordinates& p) {
         return Coordinates{p[0] / 3, p[1] / 3, p[2] / 3};
       }},
      {"tiny ",
       [](const Coordinates& p) {
         return Coordinates{p[0] * 1e-30, p[1] * 1e-30, p[2] * 1e-30};
       }},
      {"huge ",
       [](const Coordinates& p) {
         return Coordinates{p[0] * 1e30, p[1] * 1e30, p[2] * 1e30};
       }},
      {"far ", [](const Coordinates& p) {
         return Coordinates{p[0] + 1e6, p[1] - 1e6, p[2] + 1e6};
       }}};
  for(const auto& [how, move] : moves)
    for(const Named_mesh& surface : surfaces())
      result.push_back({how + surface.name, [=, move = move] { return mapped(surface.make(), move); }});
}

inline void add_spoilt(std::vector<Named_mesh>& result)
{
  const std::vector<std::string> names = {" with vertices in one place", " with three vertices in one place",
                                          " with degenerate faces", " with folded faces"};
  for(int how = 0; how < 4; ++how)
    for(const Named_mesh& surface : surfaces())
      result.push_back({surface.name + names[static_cast<std::size_t>(how)],
                        [=] { return spoilt(surface.make(), how, static_cast<unsigned>(how) + 1); }});
}

/// 203 of them.
inline std::vector<Named_mesh> meshes()
{
  std::vector<Named_mesh> result;
  add_moved(result);
  add_spoilt(result);
  for(double aspect : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9})
    result.push_back({"needles of " + std::to_string(aspect), [=] { return needle_strip(30, 30, aspect); }});
  for(unsigned seed : {1, 2, 3})
    result.push_back({"rough terrain " + std::to_string(seed), [=] { return terrain(100, 10, seed, seed == 2); }});
  const std::vector<Named_mesh> others = {{"high cone", [] { return cone(64, 32, 1, 1e6); }},
                                          {"cone of 20 000 sides", [] { return cone(20000, 2, 1, 1); }},
                                          {"disk of 5000 sides", [] { return cone(5000, 3, 1, 0); }},
                                          {"high lantern", [] { return lantern(6, 1000); }},
                                          {"lantern of many sides", [] { return lantern(200, 40); }},
                                          {"large sponge", [] { return sponge(3); }},
                                          {"plate with 100 holes", [] { return plate_with_holes(10); }},
                                          {"plate with 2500 holes", [] { return plate_with_holes(50); }},
                                          {"long knot", [] { return knot(2000, 24); }},
                                          {"large cube", [] { return cube(150); }},
                                          {"large torus", [] { return torus(500, 300, 3, 1); }},
                                          {"large sphere", [] { return bumpy_sphere(180, 0.1, 2); }},
                                          {"large grid", [] { return flat_grid(380, 380, Diagonal_rule::RANDOM); }},
                                          {"large terrain", [] { return terrain(380, 2, 5, false); }}};
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

} // namespace meshes_of_every_kind

#endif // FLIP_GEODESICS_MESHES_OF_EVERY_KIND_H
