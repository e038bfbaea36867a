// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_GENERATED_MESHES_H
#define FLIP_GEODESICS_TEST_GENERATED_MESHES_H

#include "mesh_soup.h"

#include <CGAL/assertions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

/*
 * Meshes on which the geodesics, or enough about them, are known in closed form. Each generator gives a `Mesh_soup`,
 * that `to_mesh<Mesh>()` turns into any mesh type, vertex `i` being point `i`. Curves along the edges of these meshes,
 * and the lengths to expect, are in generated_curves.h and closed_forms.h.
 */
namespace Flip_geodesics_test {

// ---------------------------------------------------------------- grids

/// Which diagonal splits cell `(i, j)` of a grid: the one from `(i, j)` to `(i+1, j+1)` is RISING.
enum class Diagonal_rule { RISING, FALLING, ALTERNATING, RANDOM };

namespace internal {

// `n * m` cells with corners `vertex(i, j)`, counterclockwise if the first coordinate turns left into the second.
template <class VertexOfCell>
void add_cells(Mesh_soup& soup, int n, int m, Diagonal_rule rule, const VertexOfCell& vertex)
{
  Random_numbers random(1);
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i) {
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      const bool is_rising = rule == Diagonal_rule::RISING ||
                             (rule == Diagonal_rule::ALTERNATING && (i + j) % 2 == 0) ||
                             (rule == Diagonal_rule::RANDOM && random.below(2) == 0);
      soup.triangles.push_back(is_rising ? Corners{a, b, c} : Corners{a, b, d});
      soup.triangles.push_back(is_rising ? Corners{a, c, d} : Corners{b, c, d});
    }
}

} // namespace internal

/// The vertex `(i, j)` of a grid that is `n` cells wide.
inline int grid_vertex(int n, int i, int j) { return i + j * (n + 1); }

/// `n * m` cells over the unit squares, point `(i, j)` at height `z(i, j)`. A disk; with any `z` that depends on `i`
/// only it is developable, so that geodesics are straight in the plane it rolls out to.
template <class HeightFunction>
Mesh_soup grid(int n, int m, Diagonal_rule rule, const HeightFunction& z)
{
  Mesh_soup soup;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i <= n; ++i)
      soup.points.push_back({double(i), double(j), double(z(i, j))});
  internal::add_cells(soup, n, m, rule, [n](int i, int j) { return grid_vertex(n, i, j); });
  return soup;
}

/// The plane: the only geodesic between two points is the segment. Full of ties: collinear points, angles of exactly
/// pi.
inline Mesh_soup flat_grid(int n, int m, Diagonal_rule rule)
{
  return grid(n, m, rule, [](int, int) { return 0; });
}

/// The plane without ties: interior points moved by up to `amplitude < 1/4` in x and y. Geodesics are segments.
inline Mesh_soup jittered_grid(int n, int m, Diagonal_rule rule, double amplitude, unsigned seed)
{
  CGAL_precondition(amplitude >= 0 && amplitude < 0.25); // the bound at which a triangle can turn over
  Random_numbers random(seed);
  return mapped(flat_grid(n, m, rule), [&, n, m](const Coordinates& p) {
    const bool is_interior = p[0] > 0 && p[0] < n && p[1] > 0 && p[1] < m;
    const double dx = random.uniform(-amplitude, amplitude), dy = random.uniform(-amplitude, amplitude);
    return is_interior ? Coordinates{p[0] + dx, p[1] + dy, 0} : p;
  });
}

/// A flat grid without the cells `[i0, i1) x [j0, j1)`, which lie in its interior: an annulus. Shortest paths bend at
/// the hole's four corners only. Points inside the hole are missing: find the others with `index_of()`.
inline Mesh_soup grid_with_hole(int n, int m, int i0, int i1, int j0, int j1)
{
  CGAL_precondition(0 < i0 && i0 < i1 && i1 < n && 0 < j0 && j0 < j1 && j1 < m);
  const Mesh_soup full = flat_grid(n, m, Diagonal_rule::RISING);
  Mesh_soup soup{full.points, {}};
  for(std::size_t t = 0; t < full.triangles.size(); ++t) {
    const int cell = static_cast<int>(t / 2), i = cell % n, j = cell / n;
    if(i < i0 || i >= i1 || j < j0 || j >= j1)
      soup.triangles.push_back(full.triangles[t]);
  }
  return without_isolated_vertices(soup);
}

/// A flat grid of cells `aspect` wide and 1 high: needles whose angles are about `aspect`. Geodesics are segments.
inline Mesh_soup needle_strip(int n, int m, double aspect)
{
  return mapped(flat_grid(n, m, Diagonal_rule::RISING), [=](const Coordinates& p) {
    return Coordinates{p[0] * aspect, p[1], 0};
  });
}

/// One triangle with sides 3, 4, 5; each vertex and edge is on the border.
inline Mesh_soup single_triangle() { return {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}; }

// ---------------------------------------------------------------- polyhedra and blocks

/// The regular tetrahedron of edge `n * sqrt(8)` and integer coordinates, each face split into `n * n` triangles;
/// points 0 to 3 are its vertices, of angle pi. See `tetrahedron_distance()`; primitive closed geodesics have the
/// length `2 * edge * sqrt(p*p + p*q + q*q)` for coprime `p, q`; the shortest, `(1, 0)`, is `tetrahedron_loop()`.
inline Mesh_soup tetrahedron(int n = 1)
{
  const Mesh_soup unit = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  return subdivided(scaled(unit, n), n);
}

/// The octahedron with vertices at distance `n` on the axes (+x, -x, +y, -y, +z, -z), each face split into `n * n`
/// triangles. Vertices have angle 4 pi / 3. The hexagons parallel to a face are geodesics of length `3 n sqrt(2)`.
inline Mesh_soup octahedron(int n = 1)
{
  Mesh_soup unit = {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for(int x = 0; x < 2; ++x)
    for(int y = 0; y < 2; ++y)
      for(int z = 0; z < 2; ++z)
        unit.triangles.push_back((x + y + z) % 2 == 0 ? Corners{x, 2 + y, 4 + z} : Corners{x, 4 + z, 2 + y});
  return subdivided(scaled(unit, n), n);
}

/// The surface of the unit cells `(i, j, k)` of an `nx * ny * nz` block for which `is_filled(i, j, k)`.
template <class Predicate>
Mesh_soup voxel_surface(int nx, int ny, int nz, const Predicate& is_filled)
{
  const auto is_inside = [&](const std::array<int, 3>& c) {
    return c[0] >= 0 && c[0] < nx && c[1] >= 0 && c[1] < ny && c[2] >= 0 && c[2] < nz && is_filled(c[0], c[1], c[2]);
  };
  Mesh_soup soup;
  std::map<std::array<int, 3>, int> indices;
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto [position, is_new] = indices.emplace(c, static_cast<int>(soup.points.size()));
    if(is_new)
      soup.points.push_back({double(c[0]), double(c[1]), double(c[2])});
    return position->second;
  };
  const auto add_side = [&](const std::array<int, 3>& cell, int axis, bool is_upper) {
    std::array<int, 3> neighbor = cell, base = cell;
    neighbor[axis] += is_upper ? 1 : -1;
    base[axis] += is_upper ? 1 : 0;
    if(is_inside(neighbor))
      return;
    const auto corner = [&](int i, int j) {
      std::array<int, 3> c = base;
      c[(axis + 1) % 3] += is_upper ? i : j;
      c[(axis + 2) % 3] += is_upper ? j : i;
      return vertex(c);
    };
    internal::add_cells(soup, 1, 1, Diagonal_rule::RISING, corner);
  };
  for(int k = 0; k < nz; ++k)
    for(int j = 0; j < ny; ++j)
      for(int i = 0; i < nx; ++i)
        if(is_inside({i, j, k}))
          for(int axis = 0; axis < 3; ++axis)
            for(bool is_upper : {false, true})
              add_side({i, j, k}, axis, is_upper);
  return soup;
}

/// The box `[0,a] x [0,b] x [0,c]` with `n * n` cells on each side; see `box_distance()`. Corners have angle 3 pi / 2,
/// all other vertices 2 pi.
inline Mesh_soup box(double a, double b, double c, int n)
{
  const auto place = [=](const Coordinates& p) { return Coordinates{p[0] * a / n, p[1] * b / n, p[2] * c / n}; };
  return mapped(voxel_surface(n, n, n, [](int, int, int) { return true; }), place);
}

/// The cube `[0,n]^3` with integer vertices.
inline Mesh_soup cube(int n) { return box(n, n, n, n); }

/// A plate `[0,7n] x [0,3n] x [0,n]` with three square holes `[(2k+1)n, (2k+2)n] x [n,2n]`: genus 3, integer vertices,
/// each unit edge of the plate split into `n`. See `genus_3_loops()`.
inline Mesh_soup genus_3_plate(int n = 1)
{
  const auto is_filled = [](int i, int j, int) { return j != 1 || i % 2 == 0; };
  return subdivided(scaled(voxel_surface(7, 3, 1, is_filled), n), n);
}

// ---------------------------------------------------------------- surfaces of revolution

/// The sides of a prism over a regular `n`-gon of circumradius `radius`, in `m` rings of height `height / m`; vertex
/// `i + n * k` is the `i`-th on ring `k`. Unfolds to a strip of circumference `n * polygon_side(n, radius)`, exactly,
/// whatever `n`. Rings are geodesics, their angles being pi up to the rounding of the coordinates. If `is_closed`, two
/// fans are added, with the centres `n * (m + 1)` below and `n * (m + 1) + 1` above; then rings 0 and `m` contract.
inline Mesh_soup cylinder(int n, int m, double radius, double height, bool is_closed = false)
{
  CGAL_precondition(n >= 3 && m >= 1);
  Mesh_soup soup;
  for(int k = 0; k <= m; ++k)
    for(int i = 0; i < n; ++i)
      soup.points.push_back({radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), height * k / m});
  internal::add_cells(soup, n, m, Diagonal_rule::RISING, [n](int i, int k) { return i % n + n * k; });
  if(!is_closed)
    return soup;
  const int bottom = n * (m + 1), top = bottom + 1;
  soup.points.insert(soup.points.end(), {{0, 0, 0}, {0, 0, height}});
  for(int i = 0; i < n; ++i) {
    soup.triangles.push_back({bottom, (i + 1) % n, i});
    soup.triangles.push_back({top, i + n * m, (i + 1) % n + n * m});
  }
  return soup;
}

/// A cylinder [Schwarz's lantern] of n times m zigzags and height 4 about the unit circle: for large m, needles about
/// it.
inline Mesh_soup lantern(int n, int m)
{
  Mesh_soup soup;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i < n; ++i) {
      const double angle = 2 * pi * (i + 0.5 * (j % 2)) / n;
      soup.points.push_back({std::cos(angle), std::sin(angle), 4.0 * j / m});
    }
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n, above = (j + 1) * n;
      const int c = above + (j % 2 == 0 ? i : (i + 1) % n), d = above + (j % 2 == 0 ? (i + n - 1) % n : i);
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

/// The side of a regular `n`-gon.
inline double polygon_side(int n, double circumradius) { return 2 * circumradius * std::sin(pi / n); }

/// The vertex `i` (modulo `k`) on ring `r` of a disk of `k` sectors; ring 0 is the apex, vertex 0.
inline int disk_vertex(int k, int r, int i) { return r == 0 ? 0 : 1 + (r - 1) * k + i % k; }

/// Flat sectors around the origin, one between each two consecutive points of `rim`, in `m` rings of equal width.
inline Mesh_soup disk_of_sectors(const std::vector<Coordinates>& rim, int m)
{
  const int k = static_cast<int>(rim.size());
  Mesh_soup soup;
  soup.points.push_back({0, 0, 0});
  for(int r = 1; r <= m; ++r)
    for(const Coordinates& p : rim)
      soup.points.push_back({p[0] * r / m, p[1] * r / m, p[2] * r / m});
  for(int i = 0; i < k; ++i)
    soup.triangles.push_back({0, disk_vertex(k, 1, i), disk_vertex(k, 1, i + 1)});
  internal::add_cells(soup, m - 1, k, Diagonal_rule::RISING, [k](int r, int i) { return disk_vertex(k, r + 1, i); });
  return soup;
}

/// A cone over a regular `n`-gon with its apex, vertex 0, at the origin, pointing up: each side of the cone is flat.
inline Mesh_soup cone(int n, int m, double radius, double height)
{
  std::vector<Coordinates> rim;
  for(int i = 0; i < n; ++i)
    rim.push_back({radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), -height});
  return disk_of_sectors(rim, m);
}

/// The angle at the apex of `cone(n, m, radius, height)`.
inline double cone_angle(int n, double radius, double height)
{
  return 2 * n * std::asin(polygon_side(n, radius) / 2 / std::hypot(radius, height));
}

/// A disk of `n` equal sectors of `total_angle < 2 pi` in all; ring `r` is at distance `r` from the apex. Straight
/// lines in the sector it unfolds to are geodesics, see `cone_distance()`; no geodesic loop goes around the apex.
inline Mesh_soup cone_disk(int n, int m, double total_angle)
{
  const double radius = std::sin(total_angle / 2 / n) / std::sin(pi / n);
  CGAL_precondition(radius < 1);
  return cone(n, m, m * radius, m * std::sqrt((1 - radius) * (1 + radius)));
}

/// The smallest disk on which a loop (`ring(6, 1)`, contractible) made another implementation run forever.
inline Mesh_soup thirteen_vertex_cone_disk() { return cone_disk(6, 2, pi); }

/// A disk of `k` (even) equal sectors of `total_angle` in all, between 2 pi and `k * pi`; ring `r` is at distance `r`
/// from the apex, where rim points go up and down in turn. Geodesics pass through the apex if they leave pi or more on
/// both sides, see `cone_distance()`.
inline Mesh_soup saddle_disk(int k, int m, double total_angle)
{
  const double square = (1 + std::cos(total_angle / k)) / (1 + std::cos(2 * pi / k));
  CGAL_precondition(k >= 4 && k % 2 == 0 && square <= 1);
  const double radius = m * std::sqrt(square), height = m * std::sqrt(1 - square);
  std::vector<Coordinates> rim;
  for(int i = 0; i < k; ++i)
    rim.push_back(
        {radius * std::cos(2 * pi * i / k), radius * std::sin(2 * pi * i / k), i % 2 == 0 ? height : -height});
  return disk_of_sectors(rim, m);
}

/// A torus of `n * m` cells; vertex `i + n * j`, with `i` along the great circle. With the lengths of
/// `Flat_torus_metric` it is flat, and its closed geodesics are those of `torus_loop()`.
inline Mesh_soup torus(int n, int m, double great_radius, double small_radius)
{
  CGAL_precondition(n >= 3 && m >= 3);
  Mesh_soup soup;
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i) {
      const double theta = 2 * pi * i / n, phi = 2 * pi * j / m;
      const double distance = great_radius + small_radius * std::cos(phi);
      soup.points.push_back({distance * std::cos(theta), distance * std::sin(theta), small_radius * std::sin(phi)});
    }
  internal::add_cells(soup, n, m, Diagonal_rule::RISING, [=](int i, int j) { return i % n + n * (j % m); });
  return soup;
}

// ---------------------------------------------------------------- convex and random surfaces

/// The unit sphere, `8 * n * n` triangles. Strictly convex: every loop contracts.
inline Mesh_soup sphere(int n) { return mapped(octahedron(n), normalized); }

/// A sphere whose points are moved along their rays to a random radius between `1 - amplitude` and `1 + amplitude`.
inline Mesh_soup bumpy_sphere(int n, double amplitude, unsigned seed)
{
  Random_numbers random(seed);
  return mapped(sphere(n), [&](const Coordinates& p) {
    const double radius = 1 + random.uniform(-amplitude, amplitude);
    return Coordinates{p[0] * radius, p[1] * radius, p[2] * radius};
  });
}

namespace internal {

inline bool sees(const Mesh_soup& soup, const Coordinates& viewer, const Corners& t)
{
  std::array<Coordinates, 3> d;
  for(int i = 0; i < 3; ++i)
    for(int x = 0; x < 3; ++x)
      d[i][x] = soup.points[t[i]][x] - viewer[x];
  const double determinant = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                             d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                             d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  return determinant < 0;
}

// Adds point `v` to the convex hull of the points before it: what it sees is replaced by a fan.
inline void extend_hull(Mesh_soup& soup, int v)
{
  std::vector<Corners> kept;
  std::set<std::pair<int, int>> open_edges;
  for(const Corners& t : soup.triangles) {
    if(!sees(soup, soup.points[v], t)) {
      kept.push_back(t);
      continue;
    }
    for(int i = 0; i < 3; ++i)
      if(open_edges.erase({t[(i + 1) % 3], t[i]}) == 0)
        open_edges.insert({t[i], t[(i + 1) % 3]});
  }
  for(const auto& [tail, head] : open_edges)
    kept.push_back({tail, head, v});
  soup.triangles = kept;
}

} // namespace internal

/// The convex hull of `n` random points of the unit sphere, all of them its vertices. Strictly convex: every loop
/// contracts.
inline Mesh_soup random_convex_polyhedron(int n, unsigned seed)
{
  CGAL_precondition(n >= 4);
  Random_numbers random(seed);
  Mesh_soup soup;
  while(static_cast<int>(soup.points.size()) < n) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const double square = x * x + y * y + z * z;
    if(square > 0.01 && square < 1)
      soup.points.push_back(normalized({x, y, z}));
  }
  const bool is_seen = internal::sees(soup, soup.points[3], {0, 1, 2});
  soup.triangles = is_seen ? std::vector<Corners>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}
                           : std::vector<Corners>{{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
  for(int v = 4; v < n; ++v)
    internal::extend_hull(soup, v);
  return soup;
}

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_GENERATED_MESHES_H
