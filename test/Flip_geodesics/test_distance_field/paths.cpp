// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Gradients, and paths that follow them.

#include "test_distance_field/asked_surface.h"

using namespace Flip_geodesics_test;

// Away from the source also on edges, and beside them, whichever side the place is told from.
BOOST_AUTO_TEST_CASE(gradients_in_the_plane)
{
  std::mt19937 random(29);
  const Asked_surface s(flat_grid(5, 5, Diagonal_rule::RANDOM));
  const auto& input = s.triangulation.input();
  const auto turned = [](const std::array<double, 3>& w) { return std::array<double, 3>{w[1], w[2], w[0]}; };
  const auto check = [&](const Field& field, const Location& at, const Point& nearest) {
    const auto g = field.gradient_in_space(at), away = s.at(at) - nearest;
    if(away.squared_length() > 1e-4)
      BOOST_TEST(std::sqrt((g - away / std::sqrt(away.squared_length())).squared_length()) < 1e-5);
  };
  for(int round = 0; round < 20; ++round) {
    const Location source = s.random_location(random);
    Field field(s.triangulation, s.mesh), line(s.triangulation, s.mesh);
    field.add_source(source);
    field.compute();
    const Location end{source.halfedge, {{1, 2, 3}}};
    const CGAL::Segment_3<CGAL::Simple_cartesian<double>> segment(s.at(source), s.at(end));
    line.add_curve(std::vector<Location>{source, end});
    line.compute();
    for(int i = 0; i < 100; ++i) {
      Location at = s.random_location(random);
      at.weights[2] = i % 3 == 0 ? 0 : (i % 3 == 1 ? 1e-9 : at.weights[2]);
      at.weights[1] += 1; // no vertex
      if(input.is_border(FG::internal::twin_index(at.halfedge)) && i % 3 < 2)
        continue;
      check(field, at, s.at(source));
      const auto direction = segment.to_vector();
      const double t = (s.at(at) - segment.source()) * direction / direction.squared_length();
      if(std::abs(t) > 1e-2 && std::abs(t - 1) > 1e-2)
        check(line, at, segment.source() + direction * (std::min)((std::max)(t, 0.0), 1.0));
    }
    // At sources, also as a point of one, and at vertices there is none.
    const Location corner{source.halfedge, {{0, 1, 0}}};
    for(const Location& at : {source, Location{input.next(source.halfedge), turned(source.weights)}, corner}) {
      BOOST_TEST(field.gradient(at)[0] == 0);
      BOOST_TEST(field.gradient(at)[1] == 0);
    }
    const double sum = source.weights[0] + source.weights[1] + source.weights[2];
    for(const double part : {0.0, 0.3, 0.5, 0.77, 1.0}) {
      Location at = end;
      for(std::size_t k = 0; k < 3; ++k)
        at.weights[k] = part * at.weights[k] / 6 + (1 - part) * source.weights[k] / sum;
      BOOST_TEST(line.gradient(at)[0] == 0);
      BOOST_TEST(line.gradient(at)[1] == 0);
    }
  }
}

// The direction of each point on the way is that in which the path goes on, as for all curves.
BOOST_AUTO_TEST_CASE(paths_as_curve_points)
{
  const Asked_surface s(bumpy_sphere(6, 0.3, 4));
  Field field(s.triangulation, s.mesh);
  field.add_source(3_v);
  field.compute();
  for(int v : {3, 50, 100}) {
    std::vector<FG::Curve_point<Mesh, Point>> points;
    field.path(s.vertex(v), std::back_inserter(points));
    BOOST_REQUIRE(points.size() >= 2u);
    for(std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t from = i + 1 < points.size() ? i : i - 1;
      const auto step = points[from + 1].point - points[from].point;
      const double length = std::sqrt(step.squared_length());
      BOOST_TEST(std::sqrt((points[i].tangent * length - step).squared_length()) <= 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(paths_that_pass_vertices_are_not_lost)
{
  // All places are those of a lattice, so that rays pass vertices exactly, or within rounding.
  for(const Mesh_soup& soup :
      {genus_3_plate(2), box(4, 3, 2, 2), grid_with_hole(9, 9, 3, 6, 2, 5), cylinder(12, 6, 1, 2)})
  {
    const Asked_surface s(soup);
    const FG::Index n = s.triangulation.number_of_halfedges();
    for(FG::Index source : {0, n / 3, n / 2}) {
      FG::Input_halfedge_index h(source);
      h = s.triangulation.input().is_border(h) ? FG::internal::twin_index(h) : h;
      Field field(s.triangulation, s.mesh);
      field.add_source(Location{h, {{1, 1, 0}}});
      field.compute();
      for(FG::Index i = 0; i < n; ++i)
        if(const FG::Input_halfedge_index to(i); !s.triangulation.input().is_border(to))
          for(const auto& weights : {std::array<double, 3>{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}})
            check_path(s, field, Location{to, weights}, 1);
    }
  }
}

// Two fans that share a vertex only: beyond the border all directions are open.
BOOST_AUTO_TEST_CASE(paths_pass_a_vertex_of_two_fans)
{
  const Asked_surface s(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {-2, -1, 0}},
                                  {{0, 1, 2}, {0, 3, 4}, {0, 4, 5}, {4, 3, 6}}});
  for(int source : {1, 2, 3, 4, 5, 6}) {
    Field field(s.triangulation, s.mesh);
    field.add_source(Vertex_index(source));
    field.compute();
    const Point p = s.at(s.vertex(source));
    for(FG::Index i = 0; i < s.triangulation.number_of_halfedges(); ++i) {
      const Location at{FG::Input_halfedge_index(i), {{1, 2, 4}}};
      if(s.triangulation.input().is_border(at.halfedge))
        continue;
      const Point q = s.at(at), o(0, 0, 0);
      const bool is_same_fan = (source <= 2) == (q.y() > 0);
      check_close(field.distance(at),
                  is_same_fan ? distance_in_space(p, q) : distance_in_space(p, o) + distance_in_space(o, q), 1,
                  "two fans");
    }
  }
}
