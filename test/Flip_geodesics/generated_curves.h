// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef FLIP_GEODESICS_TEST_GENERATED_CURVES_H
#define FLIP_GEODESICS_TEST_GENERATED_CURVES_H

#include "generated_meshes.h"

#include <CGAL/Flip_geodesics/Descriptors.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

/*
 * Curves along the edges of the generated meshes, and metrics given by edge lengths. The lengths to which they tighten
 * are here where they are short formulas, and in closed_forms.h.
 */
namespace Flip_geodesics_test {

/// Consecutive vertices share an edge; in a loop, so do the last and the first, which is not repeated at the end.
using Vertex_sequence = std::vector<CGAL::Flip_geodesics::Vertex_index>;

// ---------------------------------------------------------------- from indices to meshes and back

/// The halfedges along a vertex sequence of a mesh without double edges.
/// \throws std::invalid_argument where two consecutive vertices share no edge
template <class Mesh>
std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> halfedges_along(const Mesh& mesh,
                                                                                     const Vertex_sequence& sequence,
                                                                                     bool is_closed)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  const std::vector<Vertex> all(vertices(mesh).begin(), vertices(mesh).end());
  std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> result;
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < sequence.size(); ++i) {
    const auto [h, exists] =
        halfedge(all.at(sequence[i].idx()), all.at(sequence[(i + 1) % sequence.size()].idx()), mesh);
    if(!exists)
      throw std::invalid_argument("the vertex sequence does not follow edges");
    result.push_back(h);
  }
  return result;
}

/// Lengths for the edges of a mesh, `length(i, j)` for the edge between vertices `i` and `j`; a property map of them is
/// `boost::make_assoc_property_map(lengths)`.
template <class Mesh, class LengthFunction>
std::map<typename boost::graph_traits<Mesh>::edge_descriptor, double> edge_lengths(const Mesh& mesh,
                                                                                   const LengthFunction& length)
{
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, int> indices;
  for(auto v : vertices(mesh))
    indices.emplace(v, static_cast<int>(indices.size()));
  std::map<typename boost::graph_traits<Mesh>::edge_descriptor, double> lengths;
  for(auto e : edges(mesh))
    lengths[e] = length(indices.at(source(e, mesh)), indices.at(target(e, mesh)));
  return lengths;
}

inline double distance(const Coordinates& p, const Coordinates& q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

/// The length of a vertex sequence in space.
inline double length(const Mesh_soup& soup, const Vertex_sequence& sequence, bool is_closed)
{
  double sum = 0;
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < sequence.size(); ++i)
    sum += distance(soup.points[sequence[i].idx()], soup.points[sequence[(i + 1) % sequence.size()].idx()]);
  return sum;
}

/// The first point with exactly these coordinates, or -1. Linear time.
inline int index_of(const Mesh_soup& soup, const Coordinates& p)
{
  const auto position = std::find(soup.points.begin(), soup.points.end(), p);
  return position == soup.points.end() ? -1 : static_cast<int>(position - soup.points.begin());
}

/// The vertices on a polyline, at its corners and at the integer points between, as far as the mesh has vertices there.
/// \pre the corners have integer coordinates \throws std::invalid_argument if a corner is no vertex
inline Vertex_sequence vertices_on_polyline(const Mesh_soup& soup, const std::vector<std::array<int, 3>>& corners,
                                            bool is_closed)
{
  std::map<Coordinates, CGAL::Flip_geodesics::Vertex_index> indices;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    indices.emplace(soup.points[v], static_cast<int>(v));
  Vertex_sequence result;
  const auto add = [&](const std::array<int, 3>& c, bool is_corner) {
    const auto position = indices.find({double(c[0]), double(c[1]), double(c[2])});
    if(position != indices.end())
      result.push_back(position->second);
    else if(is_corner)
      throw std::invalid_argument("a corner of the polyline is no vertex of the mesh");
  };
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < corners.size(); ++i) {
    const std::array<int, 3>&p = corners[i], &q = corners[(i + 1) % corners.size()];
    const std::array<int, 3> d = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const int steps = std::gcd(std::gcd(d[0], d[1]), d[2]);
    for(int s = 0; s < steps; ++s)
      add({p[0] + d[0] / steps * s, p[1] + d[1] / steps * s, p[2] + d[2] / steps * s}, s == 0);
  }
  if(!is_closed)
    add(corners.back(), true);
  return result;
}

// ---------------------------------------------------------------- curves made of curves

inline Vertex_sequence reversed(Vertex_sequence sequence)
{
  std::reverse(sequence.begin(), sequence.end());
  return sequence;
}

/// There and back again, A-B-A, as an open path from A to A; it contracts, unless B is fixed.
inline Vertex_sequence out_and_back(const Vertex_sequence& path)
{
  Vertex_sequence result = path;
  result.insert(result.end(), path.rbegin() + 1, path.rend());
  return result;
}

/// The path, then `times` times back and forth over the same edges; it tightens to the geodesic of `path`.
inline Vertex_sequence walked_repeatedly(const Vertex_sequence& path, int times)
{
  Vertex_sequence result = path;
  for(int i = 0; i < times; ++i) {
    result.insert(result.end(), path.rbegin() + 1, path.rend());
    result.insert(result.end(), path.begin() + 1, path.end());
  }
  return result;
}

/// A homotopic curve that is longer: every `period`-th edge is replaced by the other two edges of the triangle on its
/// left, if there is one. No strand crosses one that it did not cross before.
inline Vertex_sequence with_detours(const Mesh_soup& soup, const Vertex_sequence& curve, bool is_closed, int period = 1)
{
  using CGAL::Flip_geodesics::Vertex_index;
  std::map<std::pair<Vertex_index, Vertex_index>, Vertex_index> opposite;
  for(const Corners& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      opposite[{Vertex_index(t[i]), Vertex_index(t[(i + 1) % 3])}] = Vertex_index(t[(i + 2) % 3]);
  Vertex_sequence result;
  for(std::size_t i = 0; i < curve.size(); ++i) {
    result.push_back(curve[i]);
    if((!is_closed && i + 1 == curve.size()) || i % period != 0)
      continue;
    const auto position = opposite.find({curve[i], curve[(i + 1) % curve.size()]});
    if(position != opposite.end())
      result.push_back(position->second);
  }
  return result;
}

// ---------------------------------------------------------------- curves on grids

/// The vertices of a grid `n` cells wide along a polyline with the corners `(i, j)`, of horizontal and vertical parts.
inline Vertex_sequence vertex_path_on_grid(int n, const std::vector<std::array<int, 2>>& corners)
{
  const auto sign = [](int x) { return (x > 0) - (x < 0); };
  std::array<int, 2> p = corners.front();
  Vertex_sequence result;
  result.emplace_back(grid_vertex(n, p[0], p[1]));
  for(const std::array<int, 2>& corner : corners) {
    CGAL_precondition(corner[0] == p[0] || corner[1] == p[1]);
    while(p != corner) {
      p = {p[0] + sign(corner[0] - p[0]), p[1] + sign(corner[1] - p[1])};
      result.emplace_back(grid_vertex(n, p[0], p[1]));
    }
  }
  return result;
}

/// Two paths from left to right over row `j` of a grid, the first coming from above and the second from below. They
/// share the row's edges, and the order on them follows from the ends: the first is on the left.
inline std::array<Vertex_sequence, 2> overlapping_paths(int n, int j)
{
  return {vertex_path_on_grid(n, {{0, j + 1}, {1, j + 1}, {1, j}, {n - 1, j}, {n - 1, j + 1}, {n, j + 1}}),
          vertex_path_on_grid(n, {{0, j - 1}, {1, j - 1}, {1, j}, {n - 1, j}, {n - 1, j - 1}, {n, j - 1}})};
}

/// Two paths that share row `j`, the first going from above to below and the second from below to above: they cross.
inline std::array<Vertex_sequence, 2> overlapping_crossing_paths(int n, int j)
{
  return {vertex_path_on_grid(n, {{0, j + 1}, {1, j + 1}, {1, j}, {n - 1, j}, {n - 1, j - 1}, {n, j - 1}}),
          vertex_path_on_grid(n, {{0, j - 1}, {1, j - 1}, {1, j}, {n - 1, j}, {n - 1, j + 1}, {n, j + 1}})};
}

/// Row `j` and column `i` of an `n * m` grid, which cross at the vertex `(i, j)` and share no edge.
inline std::array<Vertex_sequence, 2> crossing_paths(int n, int m, int i, int j)
{
  return {vertex_path_on_grid(n, {{0, j}, {n, j}}), vertex_path_on_grid(n, {{i, 0}, {i, m}})};
}

// ---------------------------------------------------------------- curves on other surfaces

/// The loop along ring `k` of `cylinder(n, ...)`: a geodesic, unless it is the rim of a closed end.
inline Vertex_sequence cylinder_ring(int n, int k)
{
  Vertex_sequence result;
  for(int i = 0; i < n; ++i)
    result.emplace_back(i + n * k);
  return result;
}

/// A staircase from vertex `i` of ring 0 to vertex `i + steps` of ring `m` of `cylinder(n, m, ...)`, where `steps > n`
/// winds about it more than once. It tightens to `hypot(height, steps * polygon_side(n, radius))`.
inline Vertex_sequence cylinder_helix(int n, int m, int i, int steps)
{
  Vertex_sequence result;
  result.emplace_back(i % n);
  for(int k = 0; k < m; ++k) {
    for(int s = steps * k / m; s < steps * (k + 1) / m; ++s)
      result.emplace_back((i + s + 1) % n + n * k);
    result.emplace_back((i + steps * (k + 1) / m) % n + n * (k + 1));
  }
  return result;
}

/// The loop along ring `r >= 1` of a cone or saddle disk of `k` sectors. It contracts, whatever the angle at the apex:
/// by Gauss and Bonnet a geodesic loop that bounds a disk encloses a curvature of 2 pi or more.
inline Vertex_sequence disk_ring(int k, int r)
{
  Vertex_sequence result;
  for(int i = 0; i < k; ++i)
    result.emplace_back(disk_vertex(k, r, i));
  return result;
}

/// From `(r, i)` to `(r, i + steps)` along ring `r` of a disk of `k` sectors; see `cone_distance()`.
inline Vertex_sequence disk_arc(int k, int r, int i, int steps)
{
  Vertex_sequence result;
  for(int s = 0; s <= steps; ++s)
    result.emplace_back(disk_vertex(k, r, i + s));
  return result;
}

/// The loop through the midpoints of four edges of `tetrahedron(n)`, `n` even, that separates vertices 0 and 1 from 2
/// and 3: a geodesic of twice the edge length, `2 n sqrt(8)`.
inline Vertex_sequence tetrahedron_loop(int n)
{
  CGAL_precondition(n % 2 == 0);
  return vertices_on_polyline(tetrahedron(n), {{0, n, 0}, {0, 0, n}, {0, -n, 0}, {0, 0, -n}}, true);
}

/// A homology basis of `genus_3_plate(n)`: loops 0, 1, 2 run around the rim of a hole, loops 3, 4, 5 through a hole and
/// around the bar beside it; loop `k` meets loop `k + 3` in one vertex. Each is a geodesic, the shortest of its class,
/// of length `4 n`, with angles of exactly pi on one side.
inline std::vector<Vertex_sequence> genus_3_loops(int n)
{
  const Mesh_soup soup = genus_3_plate(n);
  std::vector<Vertex_sequence> loops;
  for(int k = 0; k < 3; ++k) {
    const int x = (2 * k + 1) * n;
    loops.push_back(vertices_on_polyline(soup, {{x, n, n}, {x + n, n, n}, {x + n, 2 * n, n}, {x, 2 * n, n}}, true));
  }
  for(int k = 0; k < 3; ++k) {
    const int x = (2 * k + 1) * n;
    loops.push_back(vertices_on_polyline(soup, {{x, n, n}, {x, 0, n}, {x, 0, 0}, {x, n, 0}}, true));
  }
  return loops;
}

/// The lengths that make `torus(n, m, ...)` flat, with the sides `a` (along `i`) and `b`.
struct Flat_torus_metric
{
  double operator()(int u, int v) const
  {
    const auto step = [](int from, int to, int size) {
      return std::min((to - from + size) % size, (from - to + size) % size);
    };
    return std::hypot(a * step(u % n, v % n, n) / n, b * step(u / n, v / n, m) / m);
  }

  int n, m;
  double a, b;
};

/// A staircase on `torus(n, m, ...)` that closes after `p` turns along `i` and `q` along `j`, with `p` and `q` coprime
/// (other classes cross themselves). In the flat metric it tightens to the length `sqrt((p a)^2 + (q b)^2)`. Strands
/// that overlap have an order, as they round parallel lines in the same way.
inline Vertex_sequence torus_loop(int n, int m, int p, int q)
{
  CGAL_precondition(std::gcd(p, q) == 1);
  const int right = std::abs(p) * n, up = std::abs(q) * m;
  const auto vertex = [&](int i, int j) { return (p < 0 ? right - i : i) % n + n * ((q < 0 ? up - j : j) % m); };
  Vertex_sequence result;
  for(int i = 0, j = 0; i < (std::max)(right, 1); ++i) {
    if(right > 0)
      result.emplace_back(vertex(i, j));
    for(const int end = right == 0 ? up : up * (i + 1) / right; j < end; ++j)
      result.emplace_back(right == 0 ? vertex(0, j) : vertex(i + 1, j));
  }
  return result;
}

// ---------------------------------------------------------------- random metrics

/// Lengths in [1, 2) for the edges of any mesh, by the indices of their ends only. They satisfy the triangle
/// inequality, strictly. With `levels > 0` they are multiples of `1 / levels`, so that equal lengths and angles abound.
struct Random_metric
{
  double operator()(int u, int v) const
  {
    std::seed_seq seeds = {seed, static_cast<unsigned>((std::min)(u, v)), static_cast<unsigned>((std::max)(u, v))};
    std::mt19937 engine(seeds);
    const double fraction = engine() / 4294967296.0;
    return 1 + (levels > 0 ? std::floor(fraction * levels) / levels : fraction);
  }

  unsigned seed;
  int levels = 0;
};

/// Lengths with which no triangle at vertices 0 and 1 exists: their edge has length 3, all others 1.
struct Impossible_metric
{
  double operator()(int u, int v) const { return u + v == 1 ? 3 : 1; }
};

} // namespace Flip_geodesics_test

#endif // FLIP_GEODESICS_TEST_GENERATED_CURVES_H
