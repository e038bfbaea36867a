// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE geodesic_tree

#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_geodesic_tree/trees.h"

#include <CGAL/Flip_geodesics/Geodesic_tree.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace tree_test;

BOOST_AUTO_TEST_CASE(plane)
{
  constexpr int n = 12, m = 9;
  for(const Mesh_soup& soup : {flat_grid(n, m, Diagonal_rule::RISING), flat_grid(n, m, Diagonal_rule::RANDOM),
                               jittered_grid(n, m, Diagonal_rule::RANDOM, 0.24, 3), needle_strip(n, m, 1e-4)})
  {
    const Vertex_index inner(grid_vertex(n, 5, 4)), corner(grid_vertex(n, 0, 0)), on_side(grid_vertex(n, n, 3));
    for(Vertex_index source : {inner, corner, on_side}) {
      Double_tree_setting setting(soup);
      check_tree(setting, setting.tree.grow(source));
      const Coordinates& s = soup.points[source.idx()];
      const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree);
      // Any vertex fixes the rotation; the others must agree.
      const auto plane_angle_of = [&](Vertex_index v) {
        return plane_angle(soup.points[v.idx()][0] - s[0], soup.points[v.idx()][1] - s[1]);
      };
      const Vertex_index other = source == 0_v ? 1_v : 0_v;
      const double turn = plane_angle_of(other) - map[other].angle;
      for(Vertex_index v : setting.vertices()) {
        if(v == source)
          continue;
        const FG::Polar_coordinates& p = map[v];
        BOOST_TEST(is_close(p.radius, distance(s, soup.points[v.idx()]), n));
        BOOST_TEST(is_same_angle(p.angle + turn, plane_angle_of(v), 2 * pi));
        BOOST_TEST(p.angle >= 0);
        BOOST_TEST(p.angle <= map.total_angle() + tolerance);
      }
      BOOST_TEST(map[source].radius == 0);
      BOOST_TEST(std::isnan(map[source].angle));
      BOOST_TEST(map.is_on_border() == (source != inner));
      if(!map.is_on_border())
        BOOST_TEST(is_close(map.total_angle(), 2 * pi));
    }
  }
}

// Paths to one vertex on either side of a needle have one length but for rounding: none may be waited for for ever.
BOOST_AUTO_TEST_CASE(jittered_needles)
{
  constexpr int n = 40;
  for(double aspect : {1e-4, 1e-6}) {
    const auto squeezed = [aspect](const Coordinates& p) { return Coordinates{p[0], p[1] * aspect, 0}; };
    const Mesh_soup soup = mapped(jittered_grid(n, n, Diagonal_rule::RANDOM, 0.15, 11), squeezed);
    for(Vertex_index source : {0_v, Vertex_index(grid_vertex(n, 20, 20)), Vertex_index(grid_vertex(n, 31, 7))}) {
      Double_tree_setting setting(soup);
      const FG::Geodesic_tree_report report = setting.tree.grow(source);
      BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
      BOOST_TEST(setting.tree.is_valid());
      for(Vertex_index v : setting.vertices())
        BOOST_TEST(is_close(setting.tree.distance(v), distance(soup.points[source.idx()], soup.points[v.idx()]), n));
    }
  }
}

// The zero direction is that of an edge of the caller's choice, and the map in the plane is an isometry there.
BOOST_AUTO_TEST_CASE(plane_coordinates)
{
  constexpr int n = 8;
  const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RISING, 0.2, 5);
  Double_tree_setting setting(soup);
  const Vertex_index source(grid_vertex(n, 4, 4)), right(grid_vertex(n, 5, 4));
  const FG::Input_halfedge_index zero = direction(setting, source, right);
  setting.tree.grow(source);
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree, zero);
  const Coordinates &s = soup.points[source.idx()], &r = soup.points[right.idx()];
  const double length = distance(s, r), c = (r[0] - s[0]) / length, d = (r[1] - s[1]) / length;
  for(Vertex_index v : setting.vertices()) {
    const double x = soup.points[v.idx()][0] - s[0], y = soup.points[v.idx()][1] - s[1];
    BOOST_TEST(is_close(map.in_plane(v)[0], c * x + d * y, n));
    BOOST_TEST(is_close(map.in_plane(v)[1], c * y - d * x, n));
  }
}

// From any edge at an inner vertex on; on the border, and at an inserted vertex, from where they start anyway.
BOOST_AUTO_TEST_CASE(angles_start_where_it_is_told)
{
  constexpr int n = 6;
  Double_tree_setting setting(jittered_grid(n, n, Diagonal_rule::RISING, 0.2, 5));
  const auto& input = setting.triangulation.input();
  const Vertex_index inserted = setting.triangulation.insert({FG::Input_halfedge_index(0), {{1, 2, 0}}});
  for(Vertex_index source : {Vertex_index(grid_vertex(n, 3, 3)), Vertex_index(grid_vertex(n, n, 2)), inserted}) {
    setting.tree.grow(source);
    const FG::Vertex_logarithmic_map usual = FG::logarithmic_map(setting.tree);
    const bool is_inner = source == Vertex_index(grid_vertex(n, 3, 3));
    for(FG::Input_halfedge_index h : FG::internal::descriptors<FG::Input_halfedge_index>(input.number_of_halfedges())) {
      if(input.tail(h) != source && source != inserted)
        continue;
      const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree, h);
      for(Vertex_index v : setting.vertices()) {
        const FG::Polar_coordinates &p = map[v], &q = usual[v];
        if(v == source)
          continue;
        BOOST_TEST((is_inner || p.angle == q.angle));
        BOOST_TEST((p.angle >= 0 && p.angle < map.total_angle() + tolerance));
        if(map.is_on_border()) {
          BOOST_TEST(is_close(map.in_plane(v)[0], p.radius * std::cos(p.angle), n));
          BOOST_TEST(is_close(map.in_plane(v)[1], p.radius * std::sin(p.angle), n));
        }
      }
    }
    BOOST_TEST((is_inner || source == inserted || usual.is_on_border()));
  }
}

// The map of a cylinder unrolls it: each vertex comes to lie over one of the places that it has in the unrolled plane.
BOOST_AUTO_TEST_CASE(cylinder_unrolls)
{
  constexpr int n = 9, m = 7;
  constexpr double radius = 1.25, height = 8;
  const double side = polygon_side(n, radius);
  Double_tree_setting setting(cylinder(n, m, radius, height));
  const Vertex_index source(4 + n * 3), right(source.idx() + 1);
  const FG::Input_halfedge_index zero = direction(setting, source, right);
  check_tree(setting, setting.tree.grow(source));
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree, zero);
  int minimal = 0;
  for(Vertex_index v : setting.vertices()) {
    const auto [x, y] = map.in_plane(v);
    const double turns = (x / side - (v.idx() % n - source.idx() % n)) / n;
    BOOST_TEST(is_close(turns, std::round(turns)), "vertex " << v.idx());
    BOOST_TEST(is_close(y, height * (v.idx() / n - source.idx() / n) / m, height));
    const double shortest = cylinder_distance(n, m, radius, height, source.idx(), v.idx());
    BOOST_TEST(map[v].radius >= shortest * (1 - tolerance));
    minimal += is_close(map[v].radius, shortest, height) ? 1 : 0;
  }
  BOOST_TEST(minimal >= setting.size() * 9 / 10);
}

BOOST_AUTO_TEST_CASE(cone_from_the_apex_and_from_elsewhere)
{
  constexpr int n = 10, m = 6;
  constexpr double total = 4.5;
  Double_tree_setting setting(cone_disk(n, m, total));
  check_tree(setting, setting.tree.grow(0_v));
  const FG::Vertex_logarithmic_map from_apex = FG::logarithmic_map(setting.tree);
  BOOST_TEST(is_close(from_apex.total_angle(), total));
  const double first = from_apex[FG::Vertex_index(disk_vertex(n, 1, 0))].angle;
  for(int r = 1; r <= m; ++r)
    for(int i = 0; i < n; ++i) {
      const FG::Polar_coordinates& p = from_apex[FG::Vertex_index(disk_vertex(n, r, i))];
      BOOST_TEST(is_close(p.radius, r, m));
      BOOST_TEST(is_same_angle(p.angle - first, i * total / n, total));
    }

  setting.triangulation.rollback();
  const Vertex_index source(disk_vertex(n, 4, 0));
  check_tree(setting, setting.tree.grow(source));
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree);
  const double to_apex = map[0_v].angle;
  for(int r = 1; r <= m; ++r)
    for(int i = 1; i < n; ++i) {
      // Beside the apex on one side or the other, a triangle with it and the source.
      const FG::Polar_coordinates& p = map[FG::Vertex_index(disk_vertex(n, r, i))];
      const bool is_on_left = is_close(p.radius, cone_distance(4, r, i * total / n), m);
      const double around = is_on_left ? i * total / n : (n - i) * total / n;
      BOOST_TEST(is_close(p.radius, cone_distance(4, r, around), m));
      if(around < pi) {
        const double at_source = std::atan2(r * std::sin(around), 4 - r * std::cos(around));
        BOOST_TEST((is_same_angle(p.angle, to_apex + at_source, map.total_angle()) ||
                    is_same_angle(p.angle, to_apex - at_source, map.total_angle())));
      }
    }
}

// Behind a saddle all paths pass it, and start in its direction.
BOOST_AUTO_TEST_CASE(shadow_of_a_saddle)
{
  constexpr int k = 12, m = 5;
  constexpr double total = 9;
  Double_tree_setting setting(saddle_disk(k, m, total));
  const Vertex_index source(disk_vertex(k, 3, 0));
  check_tree(setting, setting.tree.grow(source));
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree);
  int in_shadow = 0;
  for(int r = 1; r <= m; ++r)
    for(int i = 1; i < k; ++i) {
      const FG::Polar_coordinates& p = map[FG::Vertex_index(disk_vertex(k, r, i))];
      const double around = (std::min)(i, k - i) * total / k;
      BOOST_TEST(is_close(p.radius, cone_distance(3, r, around), m));
      if(around < pi)
        continue;
      ++in_shadow;
      BOOST_TEST(is_same_angle(p.angle, map[0_v].angle, map.total_angle()));
    }
  BOOST_TEST(in_shadow > 0);
}

BOOST_AUTO_TEST_CASE(curved_meshes)
{
  for(const Mesh_soup& soup : {sphere(8), bumpy_sphere(8, 0.3, 1), torus(24, 12, 3, 1), genus_3_plate(2), cube(4),
                               tetrahedron(5), random_convex_polyhedron(60, 2), grid_with_hole(9, 9, 3, 6, 3, 6)})
  {
    for(Vertex_index source : {0_v, 7_v, 40_v}) {
      Double_tree_setting setting(soup);
      check_tree(setting, setting.tree.grow(source));
      for(Vertex_index v : setting.vertices())
        BOOST_TEST(setting.tree.is_reached(v));
    }
  }
}

// Decided exactly, ties and all.
BOOST_AUTO_TEST_CASE(certified)
{
  for(const Mesh_soup& soup : {cube(3), tetrahedron(4), flat_grid(6, 6, Diagonal_rule::RANDOM)}) {
    Tree_setting<Certified_setting> setting(soup);
    const FG::Geodesic_tree_report report = setting.tree.grow(5_v);
    check_tree(setting, report);
    BOOST_TEST(std::isinf(report.smallest_angle));
  }
}

BOOST_AUTO_TEST_CASE(on_tetrahedron_never_too_short)
{
  constexpr int n = 6;
  const Mesh_soup soup = tetrahedron(n);
  Double_tree_setting setting(soup);
  setting.tree.grow(10_v);
  int minimal = 0;
  for(Vertex_index v : setting.vertices()) {
    const double shortest = tetrahedron_distance(n, soup.points[10], soup.points[v.idx()]);
    BOOST_TEST(setting.tree.distance(v) >= shortest - tolerance * n);
    minimal += is_close(setting.tree.distance(v), shortest, n) ? 1 : 0;
  }
  BOOST_TEST(minimal >= setting.size() * 8 / 10);
}

BOOST_AUTO_TEST_CASE(within_a_distance)
{
  const Mesh_soup soup = jittered_grid(40, 40, Diagonal_rule::RANDOM, 0.2, 2);
  Double_tree_setting setting(soup);
  const Vertex_index source(grid_vertex(40, 20, 20));
  for(const double wrong : {-1.0, std::nan("")})
    BOOST_CHECK_THROW(setting.tree.grow(source, CGAL::parameters::max_distance(wrong)), FG::Invalid_parameter_error);
  const FG::Geodesic_tree_report report = setting.tree.grow(source, CGAL::parameters::max_distance(5));
  check_tree(setting, report);
  for(Vertex_index v : setting.vertices())
    BOOST_TEST(setting.tree.is_reached(v) == (distance(soup.points[v.idx()], soup.points[source.idx()]) <= 5));
  BOOST_TEST(report.flips < 1000u); // of about 4800 edges; nothing far away is touched
}

BOOST_AUTO_TEST_CASE(at_the_distance_exactly)
{
  Double_tree_setting setting(flat_grid(6, 6, Diagonal_rule::RISING));
  setting.tree.grow(Vertex_index(grid_vertex(6, 3, 3)), CGAL::parameters::max_distance(2));
  for(int v : {grid_vertex(6, 1, 3), grid_vertex(6, 5, 3), grid_vertex(6, 3, 1), grid_vertex(6, 3, 5)})
    BOOST_TEST(setting.tree.is_reached(Vertex_index(v)));
}

BOOST_AUTO_TEST_CASE(other_components_are_not_reached)
{
  Double_tree_setting setting(with_isolated_vertices(disjoint_union(sphere(3), sphere(3)), 1, 1));
  check_tree(setting, setting.tree.grow(5_v));
  const FG::Vertex_logarithmic_map map = FG::logarithmic_map(setting.tree);
  const Vertex_index last(setting.size() - 1), other(setting.size() / 2 + 5);
  for(Vertex_index v : {0_v, last, other}) {
    BOOST_TEST(!setting.tree.is_reached(v));
    BOOST_TEST(setting.tree.path(v).empty());
    BOOST_TEST(std::isinf(map[v].radius));
    BOOST_TEST(std::isnan(map[v].angle));
  }
  // From an isolated vertex there is nowhere to go.
  setting.triangulation.rollback();
  setting.tree.grow(0_v);
  BOOST_TEST(setting.tree.is_reached(0_v));
  BOOST_TEST(!setting.tree.is_reached(5_v));
  BOOST_TEST(std::isinf(FG::logarithmic_map(setting.tree)[5_v].radius));
}

// A tree grown anew, in a flipped triangulation or in one rolled back, is a tree; rolled back it is the same.
BOOST_AUTO_TEST_CASE(grown_again)
{
  Double_tree_setting setting(bumpy_sphere(6, 0.2, 4));
  setting.tree.grow(3_v);
  std::vector<double> distances;
  for(Vertex_index v : setting.vertices())
    distances.push_back(setting.tree.distance(v));
  const std::vector<Halfedge_index> flips = setting.flips();
  check_tree(setting, setting.tree.grow(17_v));
  setting.triangulation.rollback();
  check_tree(setting, setting.tree.grow(3_v));
  for(Vertex_index v : setting.vertices())
    BOOST_TEST(setting.tree.distance(v) == distances[v.idx()]);
  BOOST_TEST(setting.flips() == flips);
}

BOOST_AUTO_TEST_CASE(bad_sources_and_degenerate_faces)
{
  Double_tree_setting setting(sphere(3));
  BOOST_CHECK_THROW(setting.tree.grow(FG::null_index), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(setting.tree.grow(Vertex_index(setting.size())), FG::Vertex_out_of_range_error);

  Mesh_soup soup = flat_grid(4, 4, Diagonal_rule::RISING);
  soup.points[grid_vertex(4, 2, 2)] = soup.points[grid_vertex(4, 2, 3)];
  Double_tree_setting degenerate(soup);
  BOOST_CHECK_THROW(degenerate.tree.grow(0_v), FG::Degenerate_face_error);
  BOOST_TEST(degenerate.triangulation.is_valid());
  soup.points[grid_vertex(4, 2, 2)][0] = std::numeric_limits<double>::quiet_NaN();
  Double_tree_setting invalid(soup);
  BOOST_CHECK_THROW(invalid.tree.grow(0_v), FG::Invalid_coordinate_error);
}

BOOST_AUTO_TEST_CASE(interrupted)
{
  Double_tree_setting setting(bumpy_sphere(8, 0.2, 4));
  Impatient visitor;
  const auto report = setting.tree.grow(0_v, CGAL::parameters::visitor(std::ref(visitor)));
  BOOST_TEST(FG::to_string(report.status) == "STOPPED_BY_VISITOR");
  BOOST_TEST(static_cast<std::size_t>(visitor.flips) == report.flips);
  BOOST_TEST(visitor.steps == 101);
  BOOST_TEST(setting.tree.is_valid());
  BOOST_TEST(report.smallest_angle >= FG::Straightness::straight_angle());
}

// Needles so thin that rounded lengths do not tell which of two paths is shorter: exchanging them for one another must
// come to an end.
BOOST_AUTO_TEST_CASE(needles_end)
{
  for(double aspect : {1e4, 1e6, 1e8})
    for(const Mesh_soup& flat :
        {flat_grid(20, 20, Diagonal_rule::RANDOM), jittered_grid(20, 20, Diagonal_rule::RANDOM, 0.2, 1)})
    {
      const Mesh_soup soup = mapped(flat, [=](const Coordinates& p) { return Coordinates{aspect * p[0], p[1], 0}; });
      Double_tree_setting setting(soup);
      setting.tree.grow(0_v);
      for(Vertex_index v : setting.vertices()) {
        BOOST_TEST(setting.tree.is_reached(v));
        BOOST_TEST(setting.tree.distance(v) >= distance(soup.points[0], soup.points[v.idx()]) * (1 - tolerance));
      }
      BOOST_TEST(setting.tree.is_valid());
    }
}

// Flips behind a tree's back: it is not valid where a path is no longer there, or not as long as it says.
BOOST_AUTO_TEST_CASE(trees_whose_edges_were_flipped_are_not_valid)
{
  Double_tree_setting setting(bumpy_sphere(3, 0.2, 1));
  auto& t = setting.triangulation;
  const auto& tree = setting.tree;
  setting.tree.grow(0_v);
  const auto start = t.log_position();
  Random_numbers random(1);
  int of_other_lengths = 0;
  for(int i = 0; i < 1000; ++i) {
    const Vertex_index v(1 + random.below(setting.size() - 1));
    const Halfedge_index last = tree.incoming(v);
    const auto flip = [&](Halfedge_index h) {
      const bool is_in_tree = tree.incoming(t.head(h)) == h || tree.incoming(t.tail(h)) == t.twin(h);
      if(t.is_flippable(h) && (!is_in_tree || t.edge(h) == t.edge(last)))
        t.flip(h);
    };
    for(int k = 0; k < 8; ++k) { // four turn it once around, between other vertices if its quad has changed
      flip(last);
      const bool is_there = t.head(last) == v;
      const bool is_right = is_close(tree.distance(t.tail(last)) + t.length(last), tree.distance(v));
      BOOST_TEST(((is_there && is_right) || !tree.is_valid()));
      of_other_lengths += is_there && !is_right ? 1 : 0;
      for(int j = 0; j < 6; ++j)
        if(const Halfedge_index h = j % 2 == 0 ? last : t.twin(last); random.below(2) == 0)
          flip(random.below(2) == 0 ? t.next(h) : t.previous(h));
    }
    t.rollback(start);
    BOOST_TEST(tree.is_valid());
  }
  BOOST_TEST(of_other_lengths > 0);
}

// Inserted vertices are sources and ends of paths like others; in the plane the map shows every point in its place.
BOOST_AUTO_TEST_CASE(inserted_vertices)
{
  constexpr int n = 8;
  const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 5);
  const Surface mesh = to_mesh<Surface>(soup);
  const Double_triangulation<Surface> plain(mesh);
  FG::Input_halfedge_index inner = 70_input_h, border = 0_input_h;
  while(plain.input().is_border(inner) || plain.input().is_border(FG::internal::twin_index(inner)))
    ++inner;
  while(!plain.input().is_border(FG::internal::twin_index(border)))
    ++border;
  const std::array<double, 3> inside = {{0.5, 0.3, 0.2}}, on_edge = {{0.6, 0.4, 0}};
  const std::vector<FG::Surface_location> sources = {{inner, inside}, {inner, on_edge}, {border, on_edge}};
  for(const FG::Surface_location& location : sources) {
    Double_tree_setting direct(soup), inserted(soup);
    direct.tree.grow(location);
    inserted.tree.grow(inserted.triangulation.insert(location));
    BOOST_TEST((direct.tree.source() == inserted.tree.source()));
    for(Vertex_index v : FG::internal::descriptors<Vertex_index>(direct.triangulation.number_of_vertices()))
      BOOST_TEST(direct.tree.distance(v) == inserted.tree.distance(v));
    Double_tree_setting setting(soup);
    Random_numbers random(2);
    setting.tree.grow(0_v); // before there were more vertices
    const Vertex_index source = setting.triangulation.insert(location);
    for(int i = 0; i < 20; ++i) {
      const FG::Input_halfedge_index h(random.below(setting.triangulation.input().number_of_halfedges()));
      if(!setting.triangulation.input().is_border(h))
        setting.triangulation.insert({h, {{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)}}});
    }
    const auto place = [&](Vertex_index v) {
      Coordinates p = {0, 0, 0};
      const FG::Surface_location l = setting.triangulation.location(v);
      FG::Input_halfedge_index h = l.halfedge;
      for(int i = 0; i < 3; ++i, h = setting.triangulation.input().next(h))
        for(int k = 0; k < 3 && l.weights[i] > 0; ++k)
          p[k] += l.weights[i] / (l.weights[0] + l.weights[1] + l.weights[2]) *
                  soup.points[setting.triangulation.input().tail(h).idx()][k];
      return p;
    };
    auto& tree = setting.tree;
    BOOST_TEST(FG::to_string(tree.grow(source).status) == "LOCALLY_SHORTEST");
    BOOST_TEST(tree.is_valid());
    const FG::Vertex_logarithmic_map map = FG::logarithmic_map(tree);
    const Coordinates s = place(source), other = place(3_v);
    BOOST_TEST(map.is_on_border() == (location.halfedge == border));
    const double turn = plane_angle(other[0] - s[0], other[1] - s[1]) - map[3_v].angle;
    for(Vertex_index v : setting.vertices()) {
      if(v == source)
        continue;
      const Coordinates p = place(v);
      BOOST_TEST(is_close(map[v].radius, distance(s, p), n));
      BOOST_TEST(is_same_angle(map[v].angle + turn, plane_angle(p[0] - s[0], p[1] - s[1]), 2 * pi));
    }
  }
}
