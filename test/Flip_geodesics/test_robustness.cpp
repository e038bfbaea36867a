// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE robustness

#include "Curve_setting.h"
#include "descriptors.h"
#include "generated_curves.h"
#include "generated_meshes.h"
#include "random_curves.h"
#include "test_scale.h"

#include <CGAL/Flip_geodesics/extract.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace FG = CGAL::Flip_geodesics;
using FG::Halfedge_index;
using FG::Vertex_index;
using FG::internal::descriptors;
using namespace Flip_geodesics_test;

namespace {

// Coordinates that are multiples of 1/64 below 64: they can be moved by 2^26 and stay exact.
Mesh_soup rounded(const Mesh_soup& soup)
{
  return mapped(soup, [](const Coordinates& p) {
    return Coordinates{std::round(p[0] * 64) / 64, std::round(p[1] * 64) / 64, std::round(p[2] * 64) / 64};
  });
}

std::vector<Mesh_soup> exact_soups()
{
  return {cube(4),
          genus_3_plate(2),
          octahedron(4),
          rounded(scaled(bumpy_sphere(4, 0.3, 1), 20)),
          rounded(scaled(torus(9, 7, 3, 1), 10)),
          rounded(scaled(jittered_grid(8, 8, Diagonal_rule::RANDOM, 0.2, 2), 4)),
          flat_grid(6, 6, Diagonal_rule::ALTERNATING)};
}

// Everything that a run over a mesh gives, to be compared bit for bit.
struct Run
{
  Halfedge_sequence flips, halfedges;
  std::vector<double> lengths;
  std::vector<std::string> states;

  bool operator==(const Run& other) const
  {
    return flips == other.flips && halfedges == other.halfedges && lengths == other.lengths && states == other.states;
  }
};

// Paths and loops between random vertices; lengths are divided by `unit`.
Run run(const Mesh_soup& soup, double unit)
{
  Run result;
  Curve_setting setting(soup);
  Random_numbers random(1);
  const int n = setting.triangulation.number_of_vertices();
  for(int i = 0; i < 100 * scale; ++i) {
    const int u = random.below(n), v = (u + 1 + random.below(n - 1)) % n;
    if(i % 2 == 0)
      setting.add_path(Vertex_index(u), Vertex_index(v));
    const Halfedge_sequence walk = random_walk(setting.triangulation, 15, true, random);
    if(i % 2 == 1 && !walk.empty()) {
      setting.network.add_curve(walk, CGAL::parameters::is_closed(true));
      if(!order_at_random(setting.network, walk, 5, random))
        setting.network.clear();
    }
    const FG::Shortening_report report = setting.pull();
    for(const FG::Curve_report& curve : report.curves) {
      result.lengths.insert(result.lengths.end(), {curve.initial_length / unit, curve.length / unit});
      result.states.push_back(FG::to_string(curve.status));
    }
    for(FG::Curve_index c : descriptors<FG::Curve_index>(setting.network.number_of_curves()))
      for(Halfedge_index h : setting.network.halfedges(c))
        result.halfedges.push_back(h);
    const Halfedge_sequence flips = setting.flips();
    result.flips.insert(result.flips.end(), flips.begin(), flips.end());
    setting.network.clear();
    setting.triangulation.rollback();
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(two_runs_give_the_same_bits)
{
  std::size_t flips = 0;
  for(const Mesh_soup& soup : exact_soups()) {
    const Run first = run(soup, 1);
    flips += first.flips.size();
    BOOST_TEST((run(soup, 1) == first));
  }
  std::cout << flips << " flips repeated\n";
  BOOST_TEST(flips > 500u);
}

// What a triangulation was used for before leaves no trace in later results.
BOOST_AUTO_TEST_CASE(earlier_queries_do_not_matter)
{
  for(const Mesh_soup& soup : exact_soups()) {
    Curve_setting used(soup);
    Random_numbers random(5);
    const int n = used.triangulation.number_of_vertices();
    for(int i = 0; i < 20; ++i) {
      const Vertex_index u(random.below(n)), v((u.idx() + 1 + random.below(n - 1)) % n);
      const FG::Curve_report later = used.pulled_path(u, v);
      Curve_setting fresh(soup);
      const FG::Curve_report first = fresh.pulled_path(u, v);
      BOOST_TEST(later.length == first.length);
      BOOST_TEST(later.smallest_angle == first.smallest_angle);
    }
  }
}

BOOST_AUTO_TEST_CASE(translations_change_no_bit)
{
  for(const Mesh_soup& soup : exact_soups()) {
    const double size = 32, d = size * 0x1p20;
    const Run here = run(soup, 1);
    BOOST_TEST((run(translated(soup, d, 0, 0), 1) == here));
    BOOST_TEST((run(translated(soup, -d, d, d), 1) == here));
  }
}

BOOST_AUTO_TEST_CASE(scaling_by_powers_of_two_changes_exponents_only)
{
  for(const Mesh_soup& soup : exact_soups()) {
    const Run here = run(soup, 1);
    for(double factor : {0x1p60, 0x1p-60, 0x1p1})
      BOOST_TEST((run(scaled(soup, factor), factor) == here));
  }
}

// A grid far away, where squares of coordinates lose all digits, and grids of extreme size.
BOOST_AUTO_TEST_CASE(grids_far_away_and_of_any_size)
{
  const Mesh_soup grid = jittered_grid(12, 12, Diagonal_rule::RANDOM, 0.2, 3);
  const std::vector<Mesh_soup> soups = {translated(grid, 1e6, 1e6, 1e6), scaled(grid, 1e-12), scaled(grid, 1e20),
                                        translated(scaled(grid, 1e-3), 1e3, -1e3, 0)};
  for(const Mesh_soup& soup : soups) {
    Curve_setting setting(soup);
    Random_numbers random(4);
    for(int i = 0; i < 50 * scale; ++i) {
      const int n = static_cast<int>(soup.points.size()), u = random.below(n), v = (u + 1 + random.below(n - 1)) % n;
      const FG::Curve_report report = setting.pulled_path(Vertex_index(u), Vertex_index(v));
      const double expected = distance(soup.points[u], soup.points[v]);
      BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
      BOOST_TEST(std::abs(report.length - expected) < 1e-12 * expected);
    }
  }
}

BOOST_AUTO_TEST_CASE(needles)
{
  for(double aspect : {1e3, 1e6, 1e-6}) {
    const Mesh_soup soup = needle_strip(6, 6, aspect);
    Curve_setting setting(soup);
    Random_numbers random(6);
    for(int i = 0; i < 50 * scale; ++i) {
      const int n = static_cast<int>(soup.points.size()), u = random.below(n), v = (u + 1 + random.below(n - 1)) % n;
      const FG::Curve_report report = setting.pulled_path(Vertex_index(u), Vertex_index(v));
      const double expected = distance(soup.points[u], soup.points[v]);
      BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
      BOOST_TEST(std::abs(report.length - expected) < 1e-9 * expected, aspect << ": " << u << " to " << v);
    }
  }
}

// ---------------------------------------------------------------- bugs seen elsewhere

BOOST_AUTO_TEST_CASE(out_and_back_contracts)
{
  const Mesh_soup soup = bumpy_sphere(4, 0.2, 7);
  Curve_setting setting(soup);
  Vertex_sequence path = {0_v};
  for(Halfedge_index h : Curve_setting::Search(setting.triangulation)(0_v, 50_v))
    path.push_back(setting.triangulation.head(h));
  setting.add(out_and_back(path), false);
  BOOST_TEST(setting.network.is_valid());
  const FG::Shortening_report report = setting.pull();
  BOOST_TEST(FG::to_string(report.curves[0].status) == "CONTRACTED");
  BOOST_TEST(report.curves[0].length == 0);
}

BOOST_AUTO_TEST_CASE(out_and_back_to_a_fixed_point_stays)
{
  const Mesh_soup soup = bumpy_sphere(4, 0.2, 7);
  Curve_setting setting(soup);
  setting.add_path_through({0_v, 50_v, 0_v});
  setting.network.fix_nodes_at(50_v);
  const FG::Shortening_report report = setting.pull();
  BOOST_TEST(FG::to_string(report.curves[0].status) == "LOCALLY_SHORTEST");
  BOOST_TEST(report.curves[0].length > 0);
  BOOST_TEST(report.curves[0].length == 2 * setting.pulled_path(0_v, 50_v).length, boost::test_tools::tolerance(1e-2));
}

BOOST_AUTO_TEST_CASE(sources_on_a_border)
{
  const int n = 8;
  const Mesh_soup soup = jittered_grid(n, n, Diagonal_rule::RANDOM, 0.2, 8);
  Curve_setting setting(soup);
  for(int u = 0; u <= n; ++u)
    for(int v : {grid_vertex(n, u, n), grid_vertex(n, 0, (u + 1) % n), grid_vertex(n, n, u)}) {
      if(u == v)
        continue;
      const FG::Curve_report report = setting.pulled_path(Vertex_index(u), Vertex_index(v));
      BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
      BOOST_TEST(report.length == distance(soup.points[u], soup.points[v]), boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(paths_bend_at_the_corners_of_a_hole)
{
  const Mesh_soup soup = grid_with_hole(6, 6, 2, 4, 2, 4);
  Curve_setting setting(soup);
  const int u = index_of(soup, {1, 3, 0}), v = index_of(soup, {5, 3, 0});
  const FG::Curve_report report = setting.pulled_path(Vertex_index(u), Vertex_index(v));
  BOOST_TEST(FG::to_string(report.status) == "LOCALLY_SHORTEST");
  BOOST_TEST(report.length == 2 + 2 * std::sqrt(2.0), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(isolated_vertices_are_no_obstacle)
{
  const Mesh_soup plain = bumpy_sphere(3, 0.2, 9), soup = with_isolated_vertices(plain, 3, 2);
  Curve_setting setting(soup), expected(plain);
  for(int i = 1; i < 30; ++i) {
    const Vertex_index shifted(i + 3), target(i);
    BOOST_TEST(setting.pulled_path(3_v, shifted).length == expected.pulled_path(0_v, target).length);
  }
}

BOOST_AUTO_TEST_CASE(endpoints_that_cannot_be_joined)
{
  const Mesh_soup soup = with_isolated_vertices(disjoint_union(octahedron(1), octahedron(1)), 0, 1);
  Curve_setting setting(soup);
  BOOST_CHECK_THROW(setting.add_path(0_v, 7_v), FG::Disconnected_endpoints_error);
  BOOST_CHECK_THROW(setting.add_path(0_v, 12_v), FG::Disconnected_endpoints_error);
  BOOST_CHECK_THROW(setting.add_path(12_v, 0_v), FG::Disconnected_endpoints_error);
  const auto names_it = [](const FG::Error& error) {
    return error.what() == std::string("vertex 13 is not one of the 13 vertices") && error.elements().front() == 13;
  };
  BOOST_CHECK_EXCEPTION(setting.add_path(0_v, 13_v), FG::Vertex_out_of_range_error, names_it);
  const auto names_none = [](const FG::Error& error) {
    return error.what() == std::string("the source is not one of the 13 vertices") && error.elements().empty();
  };
  BOOST_CHECK_EXCEPTION(setting.add_path(FG::null_index, 0_v), FG::Vertex_out_of_range_error, names_none);
  BOOST_CHECK_THROW(setting.add_path(3_v, 3_v), FG::Invalid_curve_error);
  BOOST_TEST(setting.network.number_of_curves() == 0);
}

BOOST_AUTO_TEST_CASE(sequences_that_are_no_curves)
{
  Curve_setting setting(octahedron(1));
  BOOST_CHECK_THROW(setting.add({0_v, 1_v}, false), FG::Invalid_curve_error); // opposite vertices
  BOOST_CHECK_THROW(setting.add({0_v}, false), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(setting.add({0_v, 2_v, 9_v}, false), FG::Vertex_out_of_range_error);
  BOOST_CHECK_THROW(setting.network.add_curve(Halfedge_sequence()), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(setting.network.add_curve(Halfedge_sequence{0_h, 0_h}), FG::Invalid_curve_error);
  BOOST_CHECK_THROW(setting.network.add_curve(Halfedge_sequence{0_h}, CGAL::parameters::is_closed(true)),
                    FG::Invalid_curve_error);
  BOOST_CHECK_THROW(setting.network.add_curve(Halfedge_sequence{1000_h}), FG::Invalid_curve_error);
  const auto chain = FG::halfedges_through(setting.triangulation, Vertex_sequence{0_v, 2_v, 1_v});
  BOOST_CHECK_THROW(setting.network.add_curve(chain, CGAL::parameters::is_closed(true)),
                    FG::Invalid_curve_error); // its ends are apart
  BOOST_TEST(setting.network.number_of_curves() == 0);
  BOOST_TEST(setting.network.is_valid());
}

// A fixed node is neither bent nor straight, whatever its angles; the ends of a curve are nodes that stay fixed.
BOOST_AUTO_TEST_CASE(nodes_that_are_fixed_and_freed)
{
  Curve_setting setting(octahedron(1));
  const FG::Curve_index curve = setting.add({0_v, 2_v, 1_v}, false);
  std::vector<FG::Segment_index> segments;
  setting.network.for_each_segment(curve, [&](FG::Segment_index s) { segments.push_back(s); });
  BOOST_REQUIRE(segments.size() == 2u);
  const auto state = [&](FG::Side side) { return setting.network.wedge({segments.front(), side}).state; };
  for(FG::Side side : {FG::Side::LEFT, FG::Side::RIGHT})
    BOOST_TEST((state(side) != FG::Wedge_state::FIXED));
  setting.network.fix_nodes_at(2_v);
  setting.network.fix_nodes_at(1_v);
  for(FG::Side side : {FG::Side::LEFT, FG::Side::RIGHT})
    BOOST_TEST((state(side) == FG::Wedge_state::FIXED));
  setting.network.free_nodes(curve);
  BOOST_TEST(!setting.network.is_head_fixed(segments.front()));
  BOOST_TEST(setting.network.is_head_fixed(segments.back()));
}

// An error in the middle leaves the network and the triangulation as valid as they were.
BOOST_AUTO_TEST_CASE(a_bad_face_in_the_way)
{
  Mesh_soup soup = jittered_grid(8, 8, Diagonal_rule::RISING, 0.2, 10);
  const int bad = grid_vertex(8, 4, 4);
  Vertex_sequence around = vertex_path_on_grid(8, {{0, 4}, {2, 4}, {2, 8}, {6, 8}, {6, 4}, {8, 4}});
  soup.points[bad][2] = std::nan("");
  Curve_setting setting(soup);
  setting.add(around, false);
  BOOST_CHECK_THROW(setting.pull(), FG::Invalid_coordinate_error);
  BOOST_TEST(setting.triangulation.is_valid());
  BOOST_TEST(setting.network.length(0_c) <= setting.network.initial_length(0_c));
  setting.network.clear();
  setting.triangulation.rollback();
  for(FG::Edge_index e : descriptors<FG::Edge_index>(setting.triangulation.number_of_edges()))
    BOOST_TEST(setting.triangulation.holds(e) == 0);
}

BOOST_AUTO_TEST_CASE(a_curve_along_a_bad_face_is_not_added)
{
  Mesh_soup soup = flat_grid(2, 2, Diagonal_rule::RISING);
  soup.points[4][2] = std::nan("");
  Curve_setting setting(soup);
  // Each edge is at a bad face, or on the border.
  for(Halfedge_index h : descriptors<Halfedge_index>(setting.triangulation.number_of_halfedges()))
    try {
      setting.network.add_curve(Halfedge_sequence{h});
      setting.network.clear();
    } catch(const FG::Invalid_coordinate_error&) {
      BOOST_TEST(setting.network.number_of_curves() == 0);
      BOOST_TEST(!setting.network.is_occupied(h));
    }
}

// ---------------------------------------------------------------- bad input

namespace {

template <class T>
void touch_everything(const T& t)
{
  for(Halfedge_index h : descriptors<Halfedge_index>(t.number_of_halfedges()))
    t.is_border(h);
}

void touch_with_point(const Surface::Point& p)
{
  Surface mesh = to_mesh<Surface>(octahedron(1));
  mesh.point(*mesh.vertices().begin()) = p;
  touch_everything(Curve_setting::Triangulation(mesh));
}

void touch_with_length(double length)
{
  const Surface mesh = to_mesh<Surface>(octahedron(1));
  std::map<Surface::Edge_index, double> lengths;
  for(Surface::Edge_index e : edges(mesh))
    lengths[e] = 1;
  lengths[*edges(mesh).begin()] = length;
  touch_everything(Length_triangulation(mesh, Length_metric(mesh, Length_map(lengths))));
}

} // namespace

BOOST_AUTO_TEST_CASE(bad_input_is_reported_by_type)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  BOOST_CHECK_NO_THROW(touch_with_point(Surface::Point(2, 0, 0)));
  BOOST_CHECK_THROW(touch_with_point(Surface::Point(nan, 0, 0)), FG::Invalid_coordinate_error);
  BOOST_CHECK_THROW(touch_with_point(Surface::Point(0, inf, 0)), FG::Invalid_coordinate_error);
  BOOST_CHECK_THROW(touch_with_point(Surface::Point(0, 0, 1e200)), FG::Invalid_coordinate_error);
  BOOST_CHECK_THROW(touch_with_point(Surface::Point(0, 1, 0)), FG::Degenerate_face_error); // on a neighbor

  BOOST_CHECK_NO_THROW(touch_with_length(1.5));
  BOOST_CHECK_NO_THROW(touch_with_length(2)); // a flat triangle is one
  BOOST_CHECK_THROW(touch_with_length(2.001), FG::Degenerate_face_error);
  BOOST_CHECK_THROW(touch_with_length(0), FG::Degenerate_face_error);
  BOOST_CHECK_THROW(touch_with_length(-1), FG::Invalid_coordinate_error);
  BOOST_CHECK_THROW(touch_with_length(nan), FG::Invalid_coordinate_error);
  BOOST_CHECK_THROW(touch_with_length(inf), FG::Invalid_coordinate_error);
}

// A search tells of an edge of no usable length where it meets it, on the way or beside it.
BOOST_AUTO_TEST_CASE(edges_of_infinite_length_are_no_detour)
{
  Surface mesh = to_mesh<Surface>(octahedron(1));
  mesh.point(Surface::Vertex_index(0)) = Surface::Point(0, 0, 1e200);
  const Curve_setting::Triangulation triangulation(mesh);
  FG::Shortest_edge_path<Curve_setting::Triangulation> search(triangulation);
  BOOST_CHECK_THROW(FG::shortest_halfedges_through(search, Vertex_sequence{2_v, 4_v}), FG::Invalid_coordinate_error);
}

BOOST_AUTO_TEST_CASE(errors_name_the_place)
{
  try {
    touch_with_length(3);
    BOOST_ERROR("no exception");
  } catch(const FG::Degenerate_face_error& e) {
    BOOST_TEST(e.elements().size() == 3u);
    BOOST_TEST(std::string(e.what()).find("triangle inequality") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(faces_that_are_no_triangles_are_reported)
{
  Surface mesh;
  std::vector<Surface::Vertex_index> square;
  for(const Coordinates& p : {Coordinates{0, 0, 0}, Coordinates{1, 0, 0}, Coordinates{1, 1, 0}, Coordinates{0, 1, 0}})
    square.push_back(mesh.add_vertex(Surface::Point(p[0], p[1], p[2])));
  mesh.add_face(square);
  BOOST_CHECK_THROW(touch_everything(Curve_setting::Triangulation(mesh)), FG::Invalid_mesh_error);
}

// Nothing is thrown for what is not touched.
BOOST_AUTO_TEST_CASE(bad_faces_far_away_do_not_matter)
{
  Surface mesh = to_mesh<Surface>(disjoint_union(octahedron(1), octahedron(1)));
  mesh.point(Surface::Vertex_index(8)) = Surface::Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const Curve_setting::Triangulation t(mesh);
  BOOST_CHECK_NO_THROW(t.is_flippable(t.outgoing(0_v)));
  BOOST_CHECK_THROW(t.length(t.outgoing(8_v)), FG::Invalid_coordinate_error);
}
