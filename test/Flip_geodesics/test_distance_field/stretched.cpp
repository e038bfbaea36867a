// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances on faces with sides of very different lengths.

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

namespace {

// Faces around a vertex on the border, 1. The edges from 1 to vertices 0 and 2 have length 1, those between them are
// long. The angles of the faces are 90, 57.3 and 90 degrees, so that the shortest path from 0 to 2 bends at 1.
Mesh_soup fan_of_long_edges(double length)
{
  const double x = std::sin(1.0), y = std::cos(1.0);
  return {{{0, -1, 0}, {0, 0, 0}, {x, y, 0}, {-length, 0, 0}, {-length * y, length * x, 0}},
          {{0, 1, 3}, {3, 1, 4}, {4, 1, 2}}};
}

// A saddle: all around a vertex, two edges of length 1 among long ones, up and down in turn.
Mesh_soup saddle_of_long_edges(double length)
{
  Mesh_soup soup = {{{0, 0, 0}}, {}};
  constexpr int number = 8;
  for(int i = 0; i < number; ++i) {
    const double angle = 2 * pi * i / number, r = i % 4 == 0 ? 1 : length;
    soup.points.push_back({r * std::cos(angle), r * std::sin(angle), i % 2 == 0 ? r : -r});
    soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % number});
  }
  return soup;
}

// A strip of cells of length `ratio` and width 1, whose vertices have different heights, in proportion.
Mesh_soup stretched_terrain(double ratio)
{
  return mapped(grid(2, 4, Diagonal_rule::RISING, [&](int i, int j) { return (7 * i + 5 * j * j) % 4; }),
                [&](const Coordinates& p) {
                  return Coordinates{ratio * p[0], p[1], 1e-3 * ratio * p[2]};
                });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_path_bends_at_a_vertex_however_long_its_edges_are)
{
  for(const double length : {1e2, 1e5, 1e7, 1e9})
    for(const double scale : {1e-60, 1.0, 1e60}) {
      const Asked_surface s(mapped(fan_of_long_edges(length), [&](const Coordinates& p) {
        return Coordinates{scale * p[0], scale * p[1], scale * p[2]};
      }));
      for(const auto& [source, target] : {std::pair{0, 2}, {2, 0}}) {
        Field field(s.triangulation, s.mesh);
        field.add_source(Vertex_index(source));
        BOOST_TEST(!field.compute().has_flat_face);
        BOOST_TEST(std::abs(field.distance(Vertex_index(target)) - 2 * scale) <= 1e-15 * scale, length);
      }
    }
}

BOOST_AUTO_TEST_CASE(distances_on_stretched_faces_are_lengths_of_shortest_paths)
{
  for(const double ratio : {1e3, 1e5, 1e6, 1e7, 1e9})
    for(const Mesh_soup& soup : {stretched_terrain(ratio), saddle_of_long_edges(ratio)}) {
      const Asked_surface s(soup);
      for(Vertex_index v : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
        Field field(s.triangulation, s.mesh);
        field.add_source(v);
        BOOST_TEST(!field.compute().has_flat_face);
        for(Vertex_index w : descriptors<Vertex_index>(s.triangulation.number_of_vertices())) {
          if(w == v)
            continue;
          std::vector<Point> points;
          const auto path =
              FG::shortest_path(s.mesh, Mesh::Vertex_index(static_cast<unsigned>(v.idx())),
                                Mesh::Vertex_index(static_cast<unsigned>(w.idx())), std::back_inserter(points));
          BOOST_TEST(path.report.is_confirmed());
          BOOST_TEST(std::abs(field.distance(w) - path.length()) <= 1e-12 * path.length(), ratio << ": " << v << w);
        }
      }
    }
}

// What is asked of a place agrees with what a window brings to a vertex there.
BOOST_AUTO_TEST_CASE(a_path_beside_a_window_bends_at_its_end)
{
  const FG::internal::Window w = {0.25, 0.5, 0.25, 1, 3, 0, 0, false, FG::internal::Window_state::WAITING};
  BOOST_TEST(w.bent_distance(0.25, 1, w.crossing(0.25, 1)) == 5);
  const double beside = w.crossing(0, 1);
  BOOST_TEST(beside < w.from);
  BOOST_TEST(std::abs(w.bent_distance(0, 1, beside) - (4 + std::hypot(0.25, 1.0))) < 1e-15);
}

// The shortest path from vertex 21 to vertex 8 is straight where it passes vertex 17, up to an angle of 1e-8: neither
// the window beside the vertex nor the windows from the vertex may be lost.
BOOST_AUTO_TEST_CASE(paths_that_pass_a_vertex_within_rounding_are_not_lost)
{
  constexpr double length = 1e8;
  const std::vector<double> heights = {0.5, 0,   1,   1,   1.5, 0.5, 0.5, 0.5, 0.5, 1, 1.5, 0.5,
                                       0,   0.5, 1.5, 1.5, 1,   0,   1.5, 0,   0.5, 0, 0.5, 0.5};
  Mesh_soup soup = mapped(grid(3, 5, Diagonal_rule::FALLING, [&](int i, int j) { return heights[4 * j + i]; }),
                          [&](const Coordinates& p) {
                            return Coordinates{length * p[0], p[1], length * p[2]};
                          });
  soup.triangles = {{0, 1, 5},    {0, 5, 4},    {1, 2, 5},    {2, 6, 5},    {2, 3, 7},    {2, 7, 6},
                    {4, 5, 8},    {5, 9, 8},    {5, 6, 10},   {5, 10, 9},   {6, 7, 11},   {6, 11, 10},
                    {8, 9, 12},   {9, 13, 12},  {9, 10, 14},  {9, 14, 13},  {10, 11, 14}, {11, 15, 14},
                    {12, 13, 17}, {12, 17, 16}, {13, 14, 17}, {14, 18, 17}, {14, 15, 18}, {15, 19, 18},
                    {16, 17, 20}, {17, 21, 20}, {17, 18, 21}, {18, 22, 21}, {18, 19, 23}, {18, 23, 22}};
  const Asked_surface s(soup);
  Field field(s.triangulation, s.mesh);
  field.add_source(21_v);
  BOOST_TEST(!field.compute().has_flat_face);
  std::vector<Point> points;
  const auto path =
      FG::shortest_path(s.mesh, Mesh::Vertex_index(21), Mesh::Vertex_index(8), std::back_inserter(points));
  BOOST_TEST(path.report.is_confirmed());
  BOOST_TEST(std::abs(field.distance(8_v) - path.length()) <= 1e-12 * path.length());
}

BOOST_AUTO_TEST_CASE(distances_that_long_edges_make_inaccurate_are_reported)
{
  for(const double ratio : {1.0, 1e9}) {
    const Asked_surface s(saddle_of_long_edges(ratio));
    Field field(s.triangulation, s.mesh);
    field.add_source(1_v);
    BOOST_TEST(field.compute().has_inaccurate_distance == (ratio > 1));
  }
}

// Of a short side and a long one: differences of coordinates along the long one would hide the angle.
BOOST_AUTO_TEST_CASE(angles_between_a_short_side_and_a_long_one_are_accurate)
{
  for(const double length : {1e3, 1e6, 1e9}) {
    const Asked_surface s(Mesh_soup{{{0, 0, 0}, {length, 0, 0}, {0.6, 0.8, 0}}, {{0, 1, 2}}});
    FG::internal::Face_sides<Triangulation> sides(s.triangulation);
    for(auto h : descriptors<FG::Input_halfedge_index>(6))
      if(!s.triangulation.input().is_border(h) && s.triangulation.input().tail(h) == 0_v)
        BOOST_TEST(std::abs(sides(h).cosine - 0.6) < 1e-15);
  }
}
