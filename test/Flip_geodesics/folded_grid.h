// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_FLIP_GEODESICS_TEST_FOLDED_GRID_H
#define CGAL_FLIP_GEODESICS_TEST_FOLDED_GRID_H

#include "polyline_checker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

// Plane grids that are folded, rolled up, moved and scaled, and straight lines on them, for the tests of the checker.
namespace polyline_checker {

using Lift = std::function<Mesh::Point(long double, long double)>; // from the plane into space

/*
 * Squares of side 1 with one diagonal each, `width` times `height`, put into space by `lift`, which is isometric on
 * each square, up to a factor. With `is_rolled_up` the right border is the left one.
 */
struct Grid
{
  int width, height;
  Lift lift;
  bool is_rolled_up = false;

  int columns() const { return is_rolled_up ? width : width + 1; }
  Index vertex(int x, int y) const { return Index(y * columns() + (is_rolled_up ? x % width : x)); }

  Mesh mesh() const
  {
    std::vector<Mesh::Point> points;
    for(int y = 0; y <= height; ++y)
      for(int x = 0; x < columns(); ++x)
        points.push_back(lift(x, y));
    std::vector<Mesh::Face> faces;
    for(int y = 0; y < height; ++y)
      for(int x = 0; x < width; ++x) {
        faces.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
        faces.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
      }
    return Mesh(points, faces);
  }
};

inline Polyline_point vertex_point(const Grid& grid, int x, int y)
{
  return {grid.vertex(x, y), grid.vertex(x, y), 0, grid.lift(x, y)};
}

// The point (1 - t) (ax, ay) + t (bx, by), written from the nearer end.
inline Polyline_point edge_point(const Grid& grid, int ax, int ay, int bx, int by, double t)
{
  if(t > 0.5)
    return edge_point(grid, bx, by, ax, ay, 1 - t);
  const Mesh::Point p = grid.lift(ax, ay), q = grid.lift(bx, by);
  Polyline_point point{grid.vertex(ax, ay), grid.vertex(bx, by), t, {}};
  for(int i = 0; i < 3; ++i)
    point.position[i] = p[i] + t * (q[i] - p[i]);
  return point;
}

// The straight line between two grid points, 0 <= slope <= 1, without a grid point in between: the grid edges that it
// crosses, in order.
inline Polyline straight_line(const Grid& grid, int sx, int sy, int tx, int ty)
{
  const long double slope = (long double)(ty - sy) / (tx - sx);
  std::vector<std::pair<long double, Polyline_point>> crossings; // with x, along the line
  const auto add = [&](long double x, int ax, int ay, int bx, int by, long double t) {
    if(x > sx + 1e-9L && x < tx - 1e-9L) // not the edges of the two ends
      crossings.emplace_back(x, edge_point(grid, ax, ay, bx, by, double(t)));
  };
  for(int i = sx; i < tx; ++i) {
    const long double y = sy + slope * (i - sx);
    const int row = int(std::floor(y));
    add(i, i, row, i, row + 1, y - row); // vertical edge
    for(int j = row; j <= row + 1; ++j) {
      const long double x = slope > 0 ? sx + (j - sy) / slope : sx - 1;
      if(x > i && x < i + 1)
        add(x, i, j, i + 1, j, x - i);                                 // horizontal edge
      const long double t = (sy + slope * (i - sx) - j) / (1 - slope); // diagonal edge
      if(t > 0 && t < 1)
        add(i + t, i, j, i + 1, j + 1, t);
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
  Polyline line{0, {vertex_point(grid, sx, sy)}};
  for(const auto& crossing : crossings)
    line.points.push_back(crossing.second);
  line.points.push_back(vertex_point(grid, tx, ty));
  return line;
}

inline Polyline joined(Polyline line, const Polyline& rest)
{
  line.points.insert(line.points.end(), rest.points.begin() + 1, rest.points.end());
  return line;
}

inline Lift plane(double scale = 1, double x0 = 0, double y0 = 0)
{
  return [=](long double x, long double y) { return Mesh::Point{double(x0 + scale * x), double(y0 + scale * y), x0}; };
}

inline Lift folded_at(int crease)
{
  return [=](long double x, long double y) {
    return x <= crease ? Mesh::Point{double(x), double(y), 0}
                       : Mesh::Point{double(crease), double(y), double(x - crease)};
  };
}

// A prism with `sides` sides of width 1: the cylinder as a mesh has it.
inline Lift rolled_up(int sides)
{
  return [=](long double x, long double y) {
    const long double radius = 0.5L / std::sin(pi / sides), angle = 2 * pi * std::fmod(x, (long double)sides) / sides;
    return Mesh::Point{double(radius * std::cos(angle)), double(radius * std::sin(angle)), double(y)};
  };
}

} // namespace polyline_checker

#endif // CGAL_FLIP_GEODESICS_TEST_FOLDED_GRID_H
