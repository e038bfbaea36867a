// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Contracted_surface

#include "Mesh_archetype.h"
#include "closed_forms.h"
#include "descriptors.h"
#include "generated_meshes.h"
#include "test_contracted_surface/zero_edges.h"

#include <CGAL/Flip_geodesics/Certified_intrinsic_triangulation_traits.h>
#include <CGAL/Flip_geodesics/certify.h>
#include <CGAL/Flip_geodesics/curves_through_points.h>
#include <CGAL/Flip_geodesics/geodesic_path.h>
#include <CGAL/Flip_geodesics/geodesic_paths.h>
#include <CGAL/Flip_geodesics/internal/flip_out/contracted_surface.h>
#include <CGAL/Flip_geodesics/shortest_path.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace Flip_geodesics_test;

BOOST_AUTO_TEST_CASE(what_is_left_is_the_mesh_as_it_was)
{
  const Mesh_soup cube_soup = cube(3);
  for(unsigned seed = 1; seed < 20; ++seed) {
    const Mesh mesh = to_mesh<Mesh>(split_at_random(cube_soup, 20 * static_cast<int>(seed), seed));
    const Triangulation triangulation = contracted(mesh);
    const auto& input = triangulation.input();
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      BOOST_CHECK(input.is_contracted());
      BOOST_CHECK(!input.has_split_point());
      BOOST_CHECK_EQUAL(input.number_of_halfedges(), 3 * static_cast<FG::Index>(cube_soup.triangles.size()));
      std::multiset<std::multiset<Coordinates>> before, after;
      for(const Corners& t : cube_soup.triangles)
        before.insert({cube_soup.points[t[0]], cube_soup.points[t[1]], cube_soup.points[t[2]]});
      for(FG::Input_halfedge_index h(0); h.idx() < input.number_of_halfedges(); ++h) {
        const FG::Input_halfedge_index hn = input.next(h), hp = input.next(hn);
        BOOST_REQUIRE_EQUAL(input.next(hp), h);
        BOOST_CHECK_EQUAL(input.tail(hn), input.tail(FG::internal::twin_index(h)));
        BOOST_CHECK_EQUAL(input.tail(h), input.index(mesh.source(input.halfedge(h))));
        if(h < hn && h < hp)
          after.insert({triangulation.metric().place(input, input.tail(h)),
                        triangulation.metric().place(input, input.tail(hn)),
                        triangulation.metric().place(input, input.tail(hp))});
      }
      BOOST_CHECK(before == after);
    }
  }
}

BOOST_AUTO_TEST_CASE(shortest_paths_on_a_cube_have_the_length_of_the_cube)
{
  const int n = 4;
  for(unsigned seed = 0; seed < 12; ++seed) {
    const Mesh_soup soup = split_at_random(cube(n), 80, seed);
    const Mesh mesh = to_mesh<Mesh>(soup);
    Random_numbers random(seed);
    for(int i = 0; i < 6; ++i) {
      const int last = static_cast<int>(soup.points.size()) - 1;
      const int s = random.below(last + 1), t = random.below(last + 1);
      if(soup.points[s] == soup.points[t])
        continue;
      std::vector<Point> points;
      const FG::Shortest_path_report report =
          FG::shortest_path(mesh, vertex(s), vertex(t), std::back_inserter(points), exactly).report;
      BOOST_TEST_CONTEXT("seed " << seed << " from " << s << " to " << t)
      {
        const double expected = box_distance(n, n, n, soup.points[s], soup.points[t]);
        BOOST_CHECK_CLOSE_FRACTION(report.length, expected, 1e-12);
        BOOST_CHECK_CLOSE_FRACTION(length(points), expected, 1e-12);
        BOOST_CHECK(points.front() == mesh.point(vertex(s)));
        BOOST_CHECK(points.back() == mesh.point(vertex(t)));
        if(report.shortening.curves.front().are_zero_edges_contracted)
          BOOST_CHECK(report.is_confirmed());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(curves_are_proven_on_the_surface_that_is_left)
{
  const Mesh mesh = to_mesh<Mesh>(split_at_random(bumpy_sphere(4, 0.1, 3), 60, 5));
  Triangulation triangulation = contracted(mesh);
  FG::Shortest_edge_path<Triangulation> search(triangulation);
  for(int t = 1; t < static_cast<int>(mesh.number_of_vertices()); t += 7) {
    const Vertex_sequence ends = {triangulation.index(vertex(0)), triangulation.index(vertex(t))};
    if(ends[0] == ends[1])
      continue;
    Network network(triangulation);
    network.add_curve(FG::shortest_halfedges_through(search, ends));
    BOOST_CHECK(FG::shorten(network).is_complete());
    BOOST_CHECK(FG::certify(network).curves.front().verdict() == FG::Verdict::PROVEN);
    for(const FG::Surface_point& p : FG::Curve_extractor<Network>(network).surface_points(0_c))
      if(!p.is_vertex()) // told by an edge of the mesh itself
        BOOST_CHECK(mesh.halfedge(vertex(p.a.idx()), vertex(p.b.idx())) != Mesh::null_halfedge());
    network.clear();
    triangulation.rollback();
  }
}

BOOST_AUTO_TEST_CASE(polylines_are_as_long_as_their_curves)
{
  for(unsigned seed = 0; seed < 6; ++seed) {
    const Mesh_soup soup = split_at_random(bumpy_sphere(3, 0.1, seed), 60, seed);
    const Mesh mesh = to_mesh<Mesh>(soup);
    Random_numbers random(seed);
    std::vector<Vertex> through;
    for(int i = 0; i < 4; ++i)
      through.push_back(vertex(random.below(static_cast<int>(soup.points.size()))));
    std::vector<Point> path, spline;
    const auto report = FG::geodesic_path_through(mesh, through, std::back_inserter(path), exactly).report.curves[0];
    BOOST_CHECK_CLOSE_FRACTION(length(path), report.length, 1e-12);
    const auto of_spline =
        FG::geodesic_spline(mesh, through, FG::Spline_kind::BEZIER, std::back_inserter(spline), exactly)
            .report.curves[0];
    BOOST_CHECK_CLOSE_FRACTION(length(spline), of_spline.length, 1e-9);
    BOOST_CHECK_LT(of_spline.length, report.length);
  }
}

BOOST_AUTO_TEST_CASE(a_path_that_meets_no_such_edge_is_as_it_was)
{
  Mesh_soup soup = flat_grid(12, 4, Diagonal_rule::RISING);
  const int s = grid_vertex(12, 0, 0), t = grid_vertex(12, 4, 3);
  const auto path = [&](const Mesh_soup& given, int from, int to, std::vector<Point>& points) {
    return FG::geodesic_path(to_mesh<Mesh>(given), vertex(from), vertex(to), std::back_inserter(points))
        .report.curves.front();
  };
  std::vector<Point> before, after, over;
  path(soup, s, t, before);
  const int v = grid_vertex(12, 10, 2);
  split_vertex(soup, v, grid_vertex(12, 11, 2), grid_vertex(12, 9, 2));
  BOOST_CHECK(!path(soup, s, t, after).are_zero_edges_contracted);
  BOOST_CHECK(before == after);
  const FG::Curve_report report = path(soup, grid_vertex(12, 8, 2), grid_vertex(12, 12, 2), over);
  BOOST_CHECK(report.are_zero_edges_contracted);
  BOOST_CHECK_EQUAL(report.length, 4);
}

BOOST_AUTO_TEST_CASE(curves_in_one_place_have_no_length)
{
  Mesh_soup soup = cube(4);
  const int v = 40;
  const auto next = ring(soup, v);
  const int c = next.begin()->first;
  const int w = split_vertex(soup, v, c, next.at(next.at(c)));
  const int x = split_vertex(soup, w, c, v);
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<Point> points;
  const auto is_point = [](const FG::Curve_report& report) {
    return report.status == FG::Shortening_status::CONTRACTED && report.length == 0 && report.are_zero_edges_contracted;
  };
  BOOST_CHECK(is_point(
      FG::geodesic_path(mesh, vertex(v), vertex(x), std::back_inserter(points), exactly).report.curves.front()));
  BOOST_CHECK((points == std::vector<Point>{mesh.point(vertex(v)), mesh.point(vertex(v))}));

  points.clear();
  const auto shortest = FG::shortest_path(mesh, vertex(v), vertex(x), std::back_inserter(points), exactly).report;
  BOOST_CHECK(is_point(shortest.shortening.curves.front()));
  BOOST_CHECK(shortest.is_confirmed());
  BOOST_CHECK_EQUAL(shortest.length, 0);

  points.clear();
  std::pair<Mesh::Face_index, std::array<double, 3>> inside = {Mesh::null_face(), {{0.25, 0.25, 0.5}}};
  for(const auto f : mesh.faces()) { // of two vertices in one place and another one
    std::set<Point> corners;
    for(const Vertex u : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.insert(mesh.point(u));
    if(corners.size() == 2)
      inside.first = f;
  }
  const auto of_place = FG::shortest_path(mesh, inside, inside, std::back_inserter(points), exactly).report;
  BOOST_CHECK(is_point(of_place.shortening.curves.front()));
  BOOST_CHECK_EQUAL(points.size(), 2);

  points.clear();
  const std::vector<Vertex> loop = {vertex(v), vertex(w), vertex(x)};
  BOOST_CHECK(is_point(FG::geodesic_loop(mesh, loop, std::back_inserter(points), exactly).report.curves.front()));
  BOOST_CHECK(points.empty());
  std::vector<Vertex> around; // pulled over the vertices in one place, which are flat together
  for(int a = c; around.empty() || a != c; a = ring(cube(4), v).at(a))
    around.push_back(vertex(a));
  BOOST_CHECK(is_point(FG::geodesic_loop(mesh, around, std::back_inserter(points), exactly).report.curves.front()));
  BOOST_CHECK(points.empty());

  const auto through = FG::geodesic_path_through(mesh, loop, std::back_inserter(points), exactly).report;
  BOOST_CHECK(is_point(through.curves.front()));
  BOOST_CHECK_EQUAL(points.size(), 2);
}

// On a line all faces are without area. A loop there is a point, whichever of its edges comes first.
BOOST_AUTO_TEST_CASE(loops_on_a_line_are_points)
{
  Mesh mesh;
  for(int i = 0; i < 4; ++i)
    mesh.add_vertex(Point(i, 0, 0));
  for(const auto& [a, b, c] : {std::array<int, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    mesh.add_face(vertex(a), vertex(b), vertex(c));
  std::vector<Point> points;
  for(int a = 0; a < 4; ++a)
    for(int b = 0; b < 4; ++b) {
      if(a == b)
        continue;
      const auto result =
          FG::geodesic_loop(mesh, std::vector<Vertex>{vertex(a), vertex(b)}, std::back_inserter(points));
      BOOST_CHECK(result.status() == FG::Shortening_status::CONTRACTED);
      BOOST_CHECK(result.verdict() == FG::Verdict::PROVEN);
      BOOST_CHECK_EQUAL(result.length(), 0);
      BOOST_CHECK(points.empty());
    }
}

// To contract edges has been tried there: that is no advice.
BOOST_AUTO_TEST_CASE(meshes_on_a_line_are_told_truly)
{
  Mesh_soup soup = flat_grid(3, 3, Diagonal_rule::RISING);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    soup.points[i] = {static_cast<double>((i / 4 * 7 + i % 4 * 3) % 5), 0, 0};
  const Mesh mesh = to_mesh<Mesh>(soup);
  const auto s = *vertices(mesh).begin(), t = *std::next(vertices(mesh).begin(), 11);
  const auto is_true = [](const FG::Degenerate_face_error& error) {
    const std::string what = error.what();
    return what.find("has length zero") != std::string::npos &&
           what.find("no surface connects the ends") != std::string::npos &&
           error.remedy() == FG::Degeneracy_remedy::MOLLIFY && what.find(error.problem() + "; ") == 0 &&
           what.find("contract such edges") == std::string::npos && error.elements().size() == 2;
  };
  std::vector<Mesh::Point> points;
  BOOST_CHECK_EXCEPTION(FG::geodesic_path(mesh, s, t, std::back_inserter(points)), FG::Degenerate_face_error, is_true);
  BOOST_CHECK_EXCEPTION(FG::shortest_path(mesh, s, t, std::back_inserter(points)), FG::Degenerate_face_error, is_true);
  std::vector<FG::Geodesic_path_result<Mesh::Point>> paths;
  const std::vector<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>> pairs = {{s, t}};
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths));
  BOOST_REQUIRE_EQUAL(paths.size(), 1u);
  BOOST_CHECK_EXCEPTION(std::rethrow_exception(paths.front().error), FG::Degenerate_face_error, is_true);
}

BOOST_AUTO_TEST_CASE(networks_keep_their_curves_in_order)
{
  Mesh_soup soup = flat_grid(8, 8, Diagonal_rule::RISING);
  const int v = grid_vertex(8, 4, 4);
  const int w = split_vertex(soup, v, grid_vertex(8, 5, 4), grid_vertex(8, 3, 4));
  const Mesh mesh = to_mesh<Mesh>(soup);
  const std::vector<std::vector<Vertex>> curves = {
      {vertex(v), vertex(w)},
      {vertex(grid_vertex(8, 4, 3)), vertex(v), vertex(w), vertex(grid_vertex(8, 4, 5))},
      {vertex(grid_vertex(8, 0, 0)), vertex(grid_vertex(8, 1, 0))}};
  std::vector<std::vector<Point>> points;
  const FG::Shortening_report report = FG::geodesic_network(mesh, curves, std::back_inserter(points), exactly).report;
  BOOST_REQUIRE_EQUAL(report.curves.size(), 3);
  BOOST_REQUIRE_EQUAL(points.size(), 3);
  BOOST_CHECK(report.curves[0].status == FG::Shortening_status::CONTRACTED);
  BOOST_CHECK(points[0].empty());
  BOOST_CHECK_EQUAL(report.curves[1].length, 2);
  BOOST_CHECK_EQUAL(length(points[1]), 2);
  BOOST_CHECK_EQUAL(report.curves[2].length, 1);
}

BOOST_AUTO_TEST_CASE(many_paths_are_those_by_themselves)
{
  const Mesh_soup soup = split_at_random(cube(4), 25, 2);
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for(int i = 1; i < 60; ++i)
    pairs.emplace_back(vertex(0), vertex(2 * i));
  std::vector<FG::Geodesic_path_result<Point>> paths;
  FG::geodesic_paths(mesh, pairs, std::back_inserter(paths));
  std::size_t met = 0;
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<Point> points;
    const auto report =
        FG::geodesic_path(mesh, pairs[i].first, pairs[i].second, std::back_inserter(points)).report.curves.front();
    BOOST_CHECK(!paths[i].error);
    BOOST_CHECK(paths[i].points == points);
    BOOST_CHECK_EQUAL(paths[i].report.curves[0].are_zero_edges_contracted, report.are_zero_edges_contracted);
    met += report.are_zero_edges_contracted ? 1 : 0;
  }
  BOOST_CHECK_GT(met, 0);
  BOOST_CHECK_LT(met, pairs.size());
}

BOOST_AUTO_TEST_CASE(points_lie_on_faces_without_area_and_edges_without_length)
{
  Mesh_soup soup = flat_grid(8, 8, Diagonal_rule::RISING);
  const int v = grid_vertex(8, 4, 4), c = grid_vertex(8, 5, 4), d = grid_vertex(8, 3, 4);
  const int w = split_vertex(soup, v, c, d);
  const Mesh mesh = to_mesh<Mesh>(soup);
  const auto halfedge = [&](int a, int b) {
    return FG::Input_halfedge_index(static_cast<FG::Index>(mesh.halfedge(vertex(a), vertex(b))));
  };
  const auto path_length = [&](const FG::Surface_location& p, const FG::Surface_location& q) {
    std::vector<Point> points;
    const auto report =
        FG::geodesic_path_through(mesh, std::vector<FG::Surface_location>{p, q}, std::back_inserter(points), exactly)
            .report.curves.front();
    BOOST_CHECK(report.are_zero_edges_contracted);
    BOOST_CHECK_SMALL(report.length - length(points), 1e-12);
    return report.length;
  };
  const FG::Surface_location below = {halfedge(grid_vertex(8, 4, 2), grid_vertex(8, 5, 2)), {{1, 0, 0}}};
  const FG::Surface_location in_needle = {halfedge(v, c), {{0.25, 0.5, 0.25}}}; // at (4.5, 4)
  const FG::Surface_location on_zero_edge = {halfedge(v, w), {{0.5, 0.5, 0}}};
  const FG::Surface_location on_needle_edge = {halfedge(w, d), {{0.5, 0.5, 0}}};
  BOOST_CHECK_CLOSE_FRACTION(path_length(below, in_needle), std::hypot(0.5, 2.0), 1e-12);
  BOOST_CHECK_CLOSE_FRACTION(path_length(below, on_zero_edge), 2, 1e-12);
  BOOST_CHECK_CLOSE_FRACTION(path_length(on_needle_edge, in_needle), 1, 1e-12);

  std::vector<Point> points;
  const FG::Geodesic_result<std::back_insert_iterator<std::vector<Point>>> spline =
      FG::geodesic_spline(mesh, std::vector<FG::Surface_location>{below, in_needle, on_needle_edge},
                          FG::Spline_kind::BEZIER, std::back_inserter(points), exactly);
  BOOST_CHECK(spline.report.curves.front().are_zero_edges_contracted);
  BOOST_CHECK(points.front() == Point(4, 2, 0));
  BOOST_CHECK_SMALL((points.back() - Point(3.5, 4, 0)).squared_length(), 1e-24);
}

BOOST_AUTO_TEST_CASE(a_hole_of_length_zero_is_a_vertex)
{
  const int n = 12, m = 3;
  const double radius = 3, height = 2, side = std::hypot(radius, height);
  const Mesh mesh = to_mesh<Mesh>(cone_with_hole(n, m, radius, height));
  int met = 0;
  for(int i = 1; i <= n / 2; ++i) {
    std::vector<Point> points;
    const FG::Shortest_path_report report =
        FG::shortest_path(mesh, vertex(n * m), vertex(n * 2 + i), std::back_inserter(points), exactly).report;
    const double angle = cone_angle(n, radius, height) * i / n;
    BOOST_CHECK_CLOSE_FRACTION(report.length, cone_distance(side, side * 2 / m, angle), 1e-12);
    if(report.shortening.curves.front().are_zero_edges_contracted)
      BOOST_CHECK(report.is_confirmed());
    met += report.shortening.curves.front().are_zero_edges_contracted ? 1 : 0;
  }
  BOOST_CHECK_GT(met, 0);
}

BOOST_AUTO_TEST_CASE(sheets_that_meet_in_a_point_are_apart)
{
  const int n = 6, m = 2;
  Mesh_soup soup = cone_with_hole(n, m, 1, 1);
  const int count = static_cast<int>(soup.points.size());
  const Mesh_soup lower = soup;
  for(int v = n; v < count; ++v) // a second cone, upside down, on the same ring of vertices
    soup.points.push_back({lower.points[v][0], lower.points[v][1], -lower.points[v][2]});
  const auto mirrored = [&](int v) { return v < n ? v : v + count - n; };
  for(const Corners& t : lower.triangles)
    soup.triangles.push_back({mirrored(t[1]), mirrored(t[0]), mirrored(t[2])});
  const Mesh mesh = to_mesh<Mesh>(soup);
  BOOST_CHECK(contracted(mesh).input().has_split_point());

  std::vector<Point> points;
  for(int first : {n, count}) { // within each cone
    const auto report =
        FG::geodesic_path(mesh, vertex(first), vertex(first + 3), std::back_inserter(points), exactly).report;
    BOOST_CHECK(report.is_complete());
    BOOST_CHECK(!FG::shortest_path(mesh, vertex(first), vertex(first + 3), std::back_inserter(points), exactly)
                     .report.is_confirmed());
  }
  BOOST_CHECK_THROW(FG::geodesic_path(mesh, vertex(n), vertex(count), std::back_inserter(points), exactly),
                    FG::Degenerate_face_error);
}

BOOST_AUTO_TEST_CASE(without_being_asked_a_triangulation_refuses)
{
  Mesh_soup soup = flat_grid(4, 4, Diagonal_rule::RISING);
  const FG::Vertex_index v(grid_vertex(4, 2, 2));
  const FG::Vertex_index w(split_vertex(soup, v.idx(), grid_vertex(4, 3, 2), grid_vertex(4, 1, 2)));
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Triangulation strict(mesh, Metric(mesh.points()));
  const Vertex_sequence chain = {v, w};
  BOOST_CHECK_THROW(FG::internal::halfedges_on_surface(strict, chain, false), FG::Degenerate_face_error);
  const Triangulation left = contracted(mesh);
  BOOST_CHECK(FG::internal::halfedges_on_surface(left, chain, false).empty());
  BOOST_CHECK_EQUAL(FG::internal::vertex_on_surface(left, w), v);
  BOOST_CHECK_THROW(FG::internal::vertex_on_surface(left, FG::Vertex_index(w.idx() + 1)),
                    FG::Vertex_out_of_range_error);
  const Vertex_sequence apart = {v, FG::Vertex_index(grid_vertex(4, 0, 0))};
  BOOST_CHECK_THROW(FG::internal::halfedges_on_surface(left, apart, false), FG::Invalid_curve_error);

  const Mesh regular = to_mesh<Mesh>(flat_grid(4, 4, Diagonal_rule::RISING));
  BOOST_CHECK(!contracted(regular).input().is_contracted());
}

BOOST_AUTO_TEST_CASE(other_meshes_are_contracted_alike)
{
  const Mesh_soup soup = split_at_random(cube(3), 60, 7);
  const Mesh_archetype mesh(soup);
  const FG::internal::Indexed_mesh<Mesh_archetype> plain(mesh);
  const auto length_of = [&](FG::Input_halfedge_index h) {
    return distance(soup.points[plain.tail(h).idx()], soup.points[plain.tail(FG::internal::twin_index(h)).idx()]);
  };
  const auto left = FG::internal::contracted(plain, Lengths_alone{length_of});
  BOOST_CHECK_EQUAL(left.number_of_halfedges(), 3 * static_cast<FG::Index>(cube(3).triangles.size()));
  for(FG::Input_halfedge_index h(0); h.idx() < left.number_of_halfedges(); ++h) {
    BOOST_REQUIRE_EQUAL(left.next(left.next(left.next(h))), h);
    BOOST_CHECK_EQUAL(left.index(left.halfedge(h)), h);
    BOOST_CHECK(soup.points[left.tail(h).idx()] == soup.points[left.uncontracted_tail(h).idx()]);
  }
}

// Lengths that no points have: the two sides of a needle, which should be one, differ.
BOOST_AUTO_TEST_CASE(sides_of_a_needle_are_of_one_length)
{
  const Mesh_archetype mesh(Mesh_soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const FG::internal::Indexed_mesh<Mesh_archetype> plain(mesh);
  for(double first : {1, 2, 3}) {
    const auto contracted = [&] {
      // Of the edge from 0 to 1, of that from 1 to 2, of that from 2 to 0.
      FG::internal::contracted(plain, Lengths_alone{[&](FG::Input_halfedge_index h) {
                                 const FG::Index sum =
                                     plain.tail(h).idx() + plain.tail(FG::internal::twin_index(h)).idx();
                                 return sum == 1 ? 0 : (sum == 3 ? first : 2);
                               }});
    };
    if(first == 2)
      BOOST_CHECK_NO_THROW(contracted());
    else
      BOOST_CHECK_THROW(contracted(), FG::Degenerate_face_error);
  }
}

// Vertices moved into others, also on the border: what becomes of a halfedge leads from where it did to where it did.
BOOST_AUTO_TEST_CASE(halfedges_that_are_left_lead_where_they_did)
{
  Random_numbers random(8);
  int contracted_meshes = 0;
  for(int i = 0; i < 40; ++i) {
    Mesh_soup soup = flat_grid(4, 4, Diagonal_rule::RANDOM);
    for(int k = 0; k < 3; ++k) {
      const Corners& t = soup.triangles[random.below(static_cast<int>(soup.triangles.size()))];
      soup.points[t[0]] = Coordinates(soup.points[t[1]]);
    }
    const Mesh mesh = to_mesh<Mesh>(soup);
    const FG::internal::Indexed_mesh<Mesh> input(mesh);
    const auto twin = [](FG::Input_halfedge_index h) { return FG::internal::twin_index(h); };
    const auto at = [&](FG::Vertex_index v) { return soup.points[v.idx()]; };
    const auto left = FG::internal::contracted(input, Lengths_alone{[&](FG::Input_halfedge_index h) {
                                                 return distance(at(input.tail(h)), at(input.tail(twin(h))));
                                               }});
    contracted_meshes += left.is_contracted() ? 1 : 0;
    for(FG::Input_halfedge_index h(0); h.idx() < input.number_of_halfedges(); ++h) {
      const FG::Input_halfedge_index g = left.contracted_halfedge(h);
      BOOST_CHECK_EQUAL(left.index(input.halfedge(h)), g.is_valid() ? g : FG::Input_halfedge_index(FG::null_index));
      if(!g.is_valid()) {
        BOOST_CHECK(g != FG::internal::Contraction::is_point || at(input.tail(h)) == at(input.tail(twin(h))));
        continue;
      }
      BOOST_CHECK(at(left.uncontracted_tail(g)) == at(input.tail(h)));
      BOOST_CHECK(at(left.uncontracted_head(g)) == at(input.tail(twin(h))));
      BOOST_CHECK_EQUAL(left.contracted_halfedge(twin(h)), twin(g));
    }
    for(FG::Input_halfedge_index g(0); g.idx() < left.number_of_halfedges(); ++g) {
      BOOST_CHECK(!left.is_border(g) || !left.is_border(twin(g)));
      // As in any mesh, the halfedge of a vertex on the border leads along it.
      BOOST_CHECK(!left.is_border(twin(g)) || left.is_border(twin(left.outgoing(left.tail(g)))));
      BOOST_CHECK_EQUAL(left.tail(left.outgoing(left.tail(g))), left.tail(g));
    }
  }
  BOOST_CHECK_EQUAL(contracted_meshes, 40);
}

// A needle that hangs on nothing: no surface is left of it.
BOOST_AUTO_TEST_CASE(a_needle_by_itself_leaves_no_surface)
{
  const int n = 2;
  Mesh_soup soup = flat_grid(n, n, Diagonal_rule::RISING);
  const int first = static_cast<int>(soup.points.size());
  for(const Coordinates& p : {Coordinates{5, 0, 0}, Coordinates{6, 0, 0}, Coordinates{6, 0, 0}})
    soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  const Mesh mesh = to_mesh<Mesh>(soup);
  const Triangulation left = contracted(mesh);
  BOOST_CHECK_EQUAL(left.number_of_halfedges(), static_cast<FG::Index>(mesh.number_of_halfedges()) - 6);
  for(int i : {1, 2}) {
    const Vertex_sequence ends = {FG::Vertex_index(first), FG::Vertex_index(first + i)};
    BOOST_CHECK_THROW(FG::internal::halfedges_on_surface(left, ends, false), FG::Degenerate_face_error);
  }
  // Nor are its two ends in one place a place of the surface.
  const Mesh::Vertex_index v(static_cast<unsigned>(first + 1)), w(static_cast<unsigned>(first + 2));
  std::vector<FG::Curve_point<Mesh, Mesh::Point>> points;
  BOOST_CHECK_THROW(FG::geodesic_path(mesh, v, w, std::back_inserter(points)), FG::Degenerate_face_error);
  BOOST_CHECK_THROW(FG::shortest_path(mesh, v, w, std::back_inserter(points)), FG::Degenerate_face_error);
}
